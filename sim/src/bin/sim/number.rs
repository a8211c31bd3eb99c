//! Numbers for people.

/// With its thousands set apart: `1,234,567`.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<_> = digits.as_bytes().rchunks(3).rev().collect();
    String::from_utf8_lossy(&groups.join(&b',')).into_owned()
}

/// As much of it as an estimate can tell: `3.1 s`, `85 ms`.
pub(crate) fn duration(seconds: f64) -> String {
    if seconds < 0.1 {
        format!("{} ms", two_digits(seconds * 1e3))
    } else {
        format!("{} s", two_digits(seconds))
    }
}

/// With its first two digits at least.
pub(crate) fn two_digits(number: f64) -> String {
    let decimals = match number {
        9.95.. => 0,
        0.995.. => 1,
        _ => 2,
    };
    format!("{number:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_set_apart() {
        let numbers = [0, 999, 1000, 1_234_567].map(grouped);
        assert_eq!(numbers, ["0", "999", "1,000", "1,234,567"]);
    }

    #[test]
    fn durations_are_as_long_as_they_are_sure() {
        let texts = [31.4, 9.96, 3.08, 0.304, 0.0514].map(duration);
        assert_eq!(texts, ["31 s", "10 s", "3.1 s", "0.30 s", "51 ms"]);
    }
}
