//! Formats numbers for output.

/// Formats a number with thousands separators: `1,234,567`.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<_> = digits.as_bytes().rchunks(3).rev().collect();
    String::from_utf8_lossy(&groups.join(&b',')).into_owned()
}

/// Formats seconds with the two significant digits of an estimate: `3.1 s`, `85 ms`.
pub(crate) fn duration(seconds: f64) -> String {
    if seconds < 0.1 {
        format!("{} ms", two_digits(seconds * 1e3))
    } else {
        format!("{} s", two_digits(seconds))
    }
}

/// Formats a duration of a minute or more: `2 minutes`, `3 hours`.
pub(crate) fn long_duration(seconds: f64) -> String {
    match seconds / 60.0 {
        minutes @ ..1.5 => format!("{minutes:.0} minute"),
        minutes @ ..119.5 => format!("{minutes:.0} minutes"),
        minutes => format!("{:.0} hours", minutes / 60.0),
    }
}

/// Formats a number with at least two significant digits.
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
    fn groups_thousands() {
        let numbers = [0, 999, 1000, 1_234_567].map(grouped);
        assert_eq!(numbers, ["0", "999", "1,000", "1,234,567"]);
    }

    #[test]
    fn formats_durations_with_two_digits() {
        let texts = [31.4, 9.96, 3.08, 0.304, 0.0514].map(duration);
        assert_eq!(texts, ["31 s", "10 s", "3.1 s", "0.30 s", "51 ms"]);
    }

    #[test]
    fn formats_long_durations() {
        let texts = [61.0, 100.0, 7100.0, 7200.0].map(long_duration);
        assert_eq!(texts, ["1 minute", "2 minutes", "118 minutes", "2 hours"]);
    }
}
