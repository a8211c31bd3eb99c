use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Circle, ContainsPoint};
use embedded_graphics_simulator::{
    BinaryColorTheme, OutputImage, OutputSettings, SimulatorDisplay,
};

use super::Display;
use crate::format::Format;

impl Display {
    /// Returns the picture in the colors of the display. Pixels outside a round display are black.
    /// Each display pixel becomes a square of `scale` by `scale` pixels.
    pub(crate) fn appearance(
        &self,
        mut picture: SimulatorDisplay<Rgb888>,
        scale: u32,
    ) -> OutputImage<Rgb888> {
        self.cut(&mut picture);
        picture.to_rgb_output_image(&self.settings(scale))
    }

    /// Blackens the pixels outside a round display.
    pub(crate) fn cut(&self, display: &mut SimulatorDisplay<Rgb888>) {
        if self.is_round {
            let circle = Circle::new(Point::zero(), self.size.width);
            let outside = display.bounding_box().points();
            let outside = outside.filter(|point| !circle.contains(*point));
            let Ok(()) = display.draw_iter(outside.map(|point| Pixel(point, Rgb888::BLACK)));
        }
    }

    /// Returns the simulator's settings for the display.
    pub(crate) fn settings(&self, scale: u32) -> OutputSettings {
        let theme = match self.format {
            Format::Binary => self.theme,
            _ => BinaryColorTheme::Default,
        };
        OutputSettings {
            scale,
            pixel_spacing: 0,
            theme,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn white_picture(name: &str, scale: u32) -> Result<OutputImage<Rgb888>, String> {
        let display = Display::named(name)?;
        let white = SimulatorDisplay::with_default_color(display.size, Rgb888::WHITE);
        Ok(display.appearance(white, scale))
    }

    fn pixel(image: &OutputImage<Rgb888>, x: u32, y: u32) -> [u8; 3] {
        image.as_image_buffer().get_pixel(x, y).0
    }

    #[test]
    fn masks_the_corners_of_a_round_display() -> Result<(), String> {
        let image = white_picture("gc9a01", 1)?;
        let (black, white) = ([0; 3], [255; 3]);
        assert_eq!([pixel(&image, 0, 0), pixel(&image, 239, 239)], [black; 2]);
        assert_eq!([pixel(&image, 120, 0), pixel(&image, 0, 120)], [white; 2]);
        // The edge of a round display of 240x240 pixels crosses the diagonal at x = y =
        // 120 - 119.5 * sqrt(1/2), about 35.5.
        assert_eq!(
            [pixel(&image, 34, 34), pixel(&image, 36, 36)],
            [black, white]
        );
        Ok(())
    }

    #[test]
    fn applies_the_theme_of_a_one_bit_display() -> Result<(), String> {
        assert_eq!(pixel(&white_picture("ssd1306", 1)?, 5, 5), [0, 210, 255]);
        assert_eq!(
            pixel(&white_picture("epaper", 1)?, 5, 5),
            [0xe2, 0xe0, 0xd8]
        );
        assert_eq!(pixel(&white_picture("ssd0323", 1)?, 5, 5), [255; 3]);
        Ok(())
    }

    #[test]
    fn scales_pixels() -> Result<(), String> {
        let image = white_picture("st7735", 3)?;
        assert_eq!(image.size(), Size::new(480, 384));
        assert_eq!(pixel(&image, 479, 383), [255; 3]);
        Ok(())
    }

    #[test]
    fn plain_display_keeps_the_picture() {
        let display = Display::plain(Size::new(2, 1), Format::Rgb888);
        let color = SimulatorDisplay::with_default_color(display.size, Rgb888::new(1, 2, 3));
        let image = color.to_rgb_output_image(&OutputSettings::default());
        assert_eq!(display.appearance(color, 1), image);
    }
}
