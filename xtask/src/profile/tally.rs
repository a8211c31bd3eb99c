use std::cmp::Reverse;
use std::collections::HashMap;
use std::fmt::Write;

/// Instructions by name.
#[derive(Default)]
pub(crate) struct Tally(HashMap<String, u64>);

impl Tally {
    pub(crate) fn add(&mut self, name: String, count: u64) {
        *self.0.entry(name).or_default() += count;
    }

    /// A table of those with the most.
    pub(crate) fn top(&self, most: usize, total: u64) -> String {
        let mut entries: Vec<_> = self.0.iter().collect();
        entries.sort_by_key(|(name, count)| (Reverse(**count), *name));
        let mut table = String::new();
        for (name, count) in entries.into_iter().take(most) {
            let percent = 100.0 * *count as f64 / total as f64;
            // Writing to a string cannot fail.
            _ = writeln!(table, "{count:12} {percent:5.1} %  {name}");
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_comes_first() {
        let mut tally = Tally::default();
        for (name, count) in [("a", 1), ("b", 2), ("a", 2), ("c", 1)] {
            tally.add(name.to_owned(), count);
        }
        let table = tally.top(2, 6);
        let names: Vec<_> = table
            .lines()
            .filter_map(|line| line.chars().last())
            .collect();
        assert_eq!(names, ['a', 'b']);
        assert!(table.contains("50.0 %"), "{table}");
    }
}
