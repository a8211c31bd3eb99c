/// Things of which one is current; after the last comes the first.
pub(super) struct Cycle<T> {
    things: Vec<T>,
    current: usize,
}

impl<T> Cycle<T> {
    /// Begins with the first of at least one.
    pub(super) fn new(first: T, others: impl IntoIterator<Item = T>) -> Self {
        let mut things = vec![first];
        things.extend(others);
        Self { things, current: 0 }
    }

    pub(super) fn current(&self) -> &T {
        &self.things[self.current]
    }

    pub(super) fn current_mut(&mut self) -> &mut T {
        &mut self.things[self.current]
    }

    /// Which one is current, counted from 0, and how many there are.
    pub(super) fn place(&self) -> (usize, usize) {
        (self.current, self.things.len())
    }

    pub(super) fn all(&self) -> &[T] {
        &self.things
    }

    pub(super) fn next(&mut self) {
        self.current = (self.current + 1) % self.things.len();
    }

    pub(super) fn previous(&mut self) {
        self.current = self.current.checked_sub(1).unwrap_or(self.things.len() - 1);
    }
}

impl<T: PartialEq> Cycle<T> {
    /// Begins with the one that equals this, if there is one.
    pub(super) fn at(mut self, thing: &T) -> Self {
        let found = self.things.iter().position(|other| other == thing);
        self.current = found.unwrap_or(self.current);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_follows_the_last() {
        let mut cycle = Cycle::new('a', ['b', 'c']).at(&'b');
        assert_eq!(cycle.place(), (1, 3));
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
