//! The section's plot, an SVG.

use anyhow::{Context, Result, anyhow};
use plotters::coord::combinators::IntoLogRange;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::Row;

/// Of the plot, in pixels.
const SIZE: (u32, u32) = (720, 440);
/// White paper is black where a reader wants it so, and black ink is white.
const DARK: &str = "<style>@media (prefers-color-scheme: dark) { \
    [fill=\"#FFFFFF\"] { fill: #0d1117 } \
    text { fill: #e6edf3 } \
    [stroke=\"#000000\"] { stroke: #e6edf3 } \
    }</style>\n";
const FONT: (&str, i32) = ("sans-serif", 15);

const GRAY: RGBColor = RGBColor(128, 128, 128);
const BLUE: RGBColor = RGBColor(31, 119, 180);
const ORANGE: RGBColor = RGBColor(214, 112, 20);

/// One line of the plot.
struct Curve {
    label: &'static str,
    color: RGBColor,
    /// What would be, not what was measured.
    is_dashed: bool,
    /// Spheres, and how many times what there is of one.
    points: Vec<(f64, f64)>,
}

/// Draws growth relative to one sphere, both axes logarithmic: what grows in
/// step with something is a straight line.
pub(super) fn draw(rows: &[Row]) -> Result<String> {
    let curves = curves(rows).context("no spheres were counted")?;
    let mut svg = String::new();
    chart(&mut svg, &curves).map_err(|error| anyhow!("the plot cannot be drawn: {error}"))?;
    let (head, body) = svg.split_once('\n').context("the plot has lines")?;
    Ok(format!("{head}\n{DARK}{body}"))
}

/// The curves; nothing of no rows.
fn curves(rows: &[Row]) -> Option<[Curve; 4]> {
    let one = rows.first()?;
    let curve = |label, color, is_dashed, of: &dyn Fn(&Row) -> f64| Curve {
        label,
        color,
        is_dashed,
        points: rows
            .iter()
            .map(|row| (f64::from(row.spheres), of(row) / of(one)))
            .collect(),
    };
    let eye = |row: &Row| {
        let [eye, ..] = row.instructions;
        eye as f64
    };
    Some([
        curve("in step with the spheres", GRAY, true, &|row| {
            row.spheres.into()
        }),
        curve("in step with those of a line", BLACK, true, &|row| {
            row.per_line
        }),
        curve("the picture", BLUE, false, &|row| row.whole() as f64),
        curve("its eye rays", ORANGE, false, &eye),
    ])
}

fn chart(svg: &mut String, curves: &[Curve]) -> Result<(), Box<dyn std::error::Error>> {
    let area = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let [_, others @ ..] = curves else {
        return Ok(());
    };
    // What is in step with the spheres leaves by the top.
    let (most, highest) = others
        .iter()
        .flat_map(|curve| &curve.points)
        .fold((1.0, 1.0), |(most, highest): (f64, f64), (x, y)| {
            (most.max(*x), highest.max(1.2 * y))
        });
    let logarithmic = |end: f64, base: f64| {
        let powers = std::iter::successors(Some(1.0), |power| Some(power * base));
        let range = (1.0..end).log_scale().base(base);
        range.with_key_points(powers.take_while(|power| *power <= end).collect())
    };
    let mut chart = ChartBuilder::on(&area)
        .margin(16)
        .x_label_area_size(46)
        .y_label_area_size(54)
        .build_cartesian_2d(logarithmic(most, 4.0), logarithmic(highest, 2.0))?;
    chart
        .configure_mesh()
        .x_desc("spheres in view")
        .y_desc("times the instructions of one sphere")
        .x_label_formatter(&f64::to_string)
        .y_label_formatter(&f64::to_string)
        .label_style(FONT)
        .light_line_style(TRANSPARENT)
        .draw()?;
    for Curve {
        label,
        color,
        is_dashed,
        points,
    } in curves
    {
        let inside = inside(points, highest);
        let line = |(x, y)| [(x, y), (x + 31, y)];
        if *is_dashed {
            let style = color.stroke_width(2);
            chart
                .draw_series(DashedLineSeries::new(inside, 7, 5, style))?
                .label(*label)
                .legend(move |start| DashedPathElement::new(line(start), 7, 5, style));
        } else {
            let style = color.stroke_width(3);
            chart
                .draw_series(LineSeries::new(inside, style))?
                .label(*label)
                .legend(move |start| PathElement::new(line(start), style));
        }
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(FONT)
        .legend_area_size(36)
        .margin(12)
        .draw()?;
    area.present()?;
    Ok(())
}

/// The points, but where a line of slope one would leave by the top it ends there.
fn inside(points: &[(f64, f64)], highest: f64) -> Vec<(f64, f64)> {
    let end = (highest, highest);
    points
        .iter()
        .map(|point| if point.1 > highest { end } else { *point })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(spheres: u32, instructions: u64) -> Row {
        Row {
            spheres,
            per_line: f64::from(spheres).sqrt(),
            queries: 1,
            tests: 1,
            instructions: [instructions; 3],
        }
    }

    #[test]
    fn what_is_measured_begins_at_one() -> Result<()> {
        let svg = draw(&[row(1, 100), row(256, 300)])?;
        println!("{svg}");
        let solid: Vec<_> = svg
            .lines()
            .filter(|line| line.contains("stroke-width=\"3\"") && line.contains("points=\"70,"))
            .collect();
        assert_eq!(solid.len(), 2, "the picture and its eye rays: {svg}");
        Ok(())
    }

    #[test]
    fn what_leaves_by_the_top_keeps_its_slope() {
        let points = [(1.0, 1.0), (16.0, 16.0), (256.0, 256.0)];
        let ends = [(1.0, 1.0), (16.0, 16.0), (20.0, 20.0)];
        assert_eq!(inside(&points, 20.0), ends);
    }

    #[test]
    fn of_nothing_there_is_no_plot() {
        assert!(draw(&[]).is_err());
    }
}
