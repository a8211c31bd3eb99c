/// Returns the prices that minimize the sum over all rows of (`row · prices` - 1)². No price is
/// below 0.
///
/// The algorithm is coordinate descent. It repeatedly changes one price to its best value while it
/// keeps all other prices.
pub(super) fn non_negative<const N: usize>(rows: &[[f64; N]]) -> [f64; N] {
    const ROUNDS: usize = 50_000;
    let mut prices = [0.0; N];
    let mut errors = vec![1.0; rows.len()];
    for item in (0..N).cycle().take(ROUNDS * N) {
        let pairs = rows.iter().zip(&errors);
        let slope: f64 = pairs.map(|(row, error)| row[item] * error).sum();
        let square: f64 = rows.iter().map(|row| row[item] * row[item]).sum();
        if square > 0.0 {
            let best = f64::max(0.0, prices[item] + slope / square);
            for (row, error) in rows.iter().zip(&mut errors) {
                *error -= row[item] * (best - prices[item]);
            }
            prices[item] = best;
        }
    }
    prices
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_exact_prices() {
        // The expected prices are 2, 0.5 and 3. Each row is scaled so that its product with these
        // prices is 1.
        let rows = [[1.0, 2.0, 3.0], [4.0, 1.0, 0.0], [2.0, 2.0, 9.0]];
        let products = [12.0, 8.5, 32.0];
        let rows = [0, 1, 2].map(|row| rows[row].map(|amount| amount / products[row]));
        for (found, price) in non_negative(&rows).into_iter().zip([2.0, 0.5, 3.0]) {
            assert!((found - price).abs() < 1e-3, "{found} {price}");
        }
    }

    #[test]
    fn returns_no_negative_price() {
        // Without the lower limit of 0 for prices, the solution would be [2, -1].
        let found = non_negative(&[[1.0, 1.0], [2.0, 3.0]]);
        assert!(found[0] > 0.0 && found[1] == 0.0, "{found:?}");
    }
}
