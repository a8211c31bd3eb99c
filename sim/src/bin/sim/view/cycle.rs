/// A cyclic list with a current item. The first item follows the last item.
pub(super) struct Cycle<T> {
    items: Vec<T>,
    current: usize,
}

impl<T> Cycle<T> {
    /// Creates a list whose first item is current.
    pub(super) fn new(first: T, others: impl IntoIterator<Item = T>) -> Self {
        let mut items = vec![first];
        items.extend(others);
        Self { items, current: 0 }
    }

    pub(super) fn current(&self) -> &T {
        &self.items[self.current]
    }

    pub(super) fn current_mut(&mut self) -> &mut T {
        &mut self.items[self.current]
    }

    /// Returns the index of the current item and the number of items.
    pub(super) fn position(&self) -> (usize, usize) {
        (self.current, self.items.len())
    }

    pub(super) fn all(&self) -> &[T] {
        &self.items
    }

    pub(super) fn next(&mut self) {
        self.current = (self.current + 1) % self.items.len();
    }

    pub(super) fn previous(&mut self) {
        self.current = self.current.checked_sub(1).unwrap_or(self.items.len() - 1);
    }
}

impl<T: PartialEq> Cycle<T> {
    /// If the list contains `item`, makes it the current item.
    pub(super) fn starting_at(mut self, item: &T) -> Self {
        let found = self.items.iter().position(|other| other == item);
        self.current = found.unwrap_or(self.current);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wraps_around_at_both_ends() {
        let mut cycle = Cycle::new('a', ['b', 'c']).starting_at(&'b');
        assert_eq!(cycle.position(), (1, 3));
        let next = [(); 3].map(|()| {
            cycle.next();
            *cycle.current()
        });
        assert_eq!(next, ['c', 'a', 'b']);
        let previous = [(); 3].map(|()| {
            cycle.previous();
            *cycle.current()
        });
        assert_eq!(previous, ['a', 'c', 'b']);
    }
}
