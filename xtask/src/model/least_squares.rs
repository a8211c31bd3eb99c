/// The prices, none below 0, for which `amounts · price` is nearest to 1 in
/// every row, in the least squares' sense.
///
/// Coordinate descent: one price after another takes the value that is best
/// while the others stay, until none moves. Slow to converge, but for a few
/// dozen unknowns that is still a blink, and it is short. A ridge, too small
/// to be seen in any prediction, chooses among prices that the rows cannot
/// tell apart.
pub(super) fn non_negative<const N: usize>(rows: &[[f64; N]]) -> [f64; N] {
    const ROUNDS: usize = 5_000;
    const RIDGE: f64 = 1e-7;
    // Columns as large as each other, or the ridge would prefer some.
    let scale: [f64; N] = std::array::from_fn(|i| {
        let square: f64 = rows.iter().map(|row| row[i] * row[i]).sum();
        if square > 0.0 {
            1.0 / square.sqrt()
        } else {
            0.0
        }
    });
    let product = |i: usize, j: usize| {
        let sum: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
        sum * scale[i] * scale[j]
    };
    // The normal equations: gram x = right.
    let gram: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| product(i, j)));
    let right: [f64; N] =
        std::array::from_fn(|i| scale[i] * rows.iter().map(|row| row[i]).sum::<f64>());
    let mut x = [0.0; N];
    for _ in 0..ROUNDS {
        let mut moved = 0.0_f64;
        for i in 0..N {
            let rest: f64 = (0..N).filter(|j| *j != i).map(|j| gram[i][j] * x[j]).sum();
            let best = ((right[i] - rest) / (gram[i][i] + RIDGE)).max(0.0);
            moved = moved.max((best - x[i]).abs());
            x[i] = best;
        }
        if moved < 1e-8 * x.iter().fold(1.0, |a: f64, b| a.max(*b)) {
            break;
        }
    }
    std::array::from_fn(|i| x[i] * scale[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prices_are_found() {
        let prices = [2.0, 0.5, 3.0];
        let amounts = [
            [1.0, 2.0, 3.0],
            [4.0, 1.0, 0.0],
            [2.0, 2.0, 9.0],
            [0.0, 5.0, 1.0],
        ];
        let rows = amounts.map(|row| {
            let sum: f64 = row.iter().zip(prices).map(|(a, p)| a * p).sum();
            row.map(|amount| amount / sum)
        });
        for (found, price) in non_negative(&rows).into_iter().zip(prices) {
            assert!((found - price).abs() < 1e-3, "{found} {price}");
        }
    }

    #[test]
    fn none_is_below_zero() {
        // 2 x - y = 1 would be best.
        let found = non_negative(&[[1.0, 1.0], [2.0, 3.0]]);
        assert!(found.iter().all(|price| *price >= 0.0), "{found:?}");
        let rows = [[1.0, 2.0], [1.0, 3.0]];
        let errors = rows.map(|row| row[0] * found[0] + row[1] * found[1] - 1.0);
        assert!(errors.iter().all(|error| error.abs() < 0.6), "{errors:?}");
    }
}
