//! Items numbered in the order in which they came, no two alike, each found by its value.
//!
//! Plans and polynomials are looked up in every expansion of the macro, which is compiled without
//! optimisation: there the tables of the standard library, which are many small functions, take
//! several times as long as the few plain loops here. Besides, the last items can be forgotten.

use std::rc::Rc;

use crate::poly::Polynomial;

use super::Operation;

/// What is found by its value.
pub(super) trait Keyed: PartialEq {
    /// A number that equal items have in common and others mostly do not.
    fn key(&self) -> u32;
}

/// No item.
const NONE: u32 = u32::MAX;

/// Distinct items in their order.
#[derive(Clone, Debug)]
pub(super) struct Numbered<T> {
    items: Vec<T>,
    keys: Vec<u32>,
    /// For each item the one before it in its bucket.
    before: Vec<u32>,
    /// The last item of each bucket; a power of two of buckets.
    last: Vec<u32>,
}

impl<T> Default for Numbered<T> {
    fn default() -> Self {
        Numbered { items: Vec::new(), keys: Vec::new(), before: Vec::new(), last: vec![NONE; 16] }
    }
}

impl<T: Keyed> Numbered<T> {
    /// All of them.
    pub(super) fn items(&self) -> &[T] {
        &self.items
    }

    /// The number of an item.
    pub(super) fn find(&self, item: &T) -> Option<usize> {
        self.with_key(item.key(), item)
    }

    fn with_key(&self, key: u32, item: &T) -> Option<usize> {
        let (items, keys, before): (&[T], &[u32], &[u32]) = (&self.items, &self.keys, &self.before);
        let mut at = self.last[self.bucket(key)];
        while at != NONE {
            let number = at as usize;
            if keys[number] == key && items[number] == *item {
                return Some(number);
            }
            at = before[number];
        }
        None
    }

    /// The number of an item, which is added if it is not there.
    pub(super) fn number(&mut self, item: T) -> usize {
        let key = item.key();
        if let Some(known) = self.with_key(key, &item) {
            return known;
        }
        let number = self.items.len();
        self.items.push(item);
        self.keys.push(key);
        self.before.push(NONE);
        if number < self.last.len() {
            self.put_in_bucket(number);
        } else {
            self.last = vec![NONE; 4 * self.last.len()];
            for number in 0..=number {
                self.put_in_bucket(number);
            }
        }
        number
    }

    /// Forgets all but the first `length`.
    pub(super) fn truncate(&mut self, length: usize) {
        // The last item is the last of its bucket, too.
        for number in (length..self.items.len()).rev() {
            let bucket = self.bucket(self.keys[number]);
            self.last[bucket] = self.before[number];
        }
        self.items.truncate(length);
        self.keys.truncate(length);
        self.before.truncate(length);
    }

    fn put_in_bucket(&mut self, number: usize) {
        let bucket = self.bucket(self.keys[number]);
        self.before[number] = self.last[bucket];
        self.last[bucket] = u32::try_from(number).expect("plans have a budget of terms");
    }

    fn bucket(&self, key: u32) -> usize {
        key as usize & (self.last.len() - 1)
    }
}

/// A key from two others; the high bits, which depend on all, come down.
fn mixed(a: u32, b: u32) -> u32 {
    let mixed = (a.rotate_left(5) ^ b).wrapping_mul(0x9E37_79B9);
    mixed ^ mixed >> 15
}

impl Keyed for Operation {
    fn key(&self) -> u32 {
        let (kind, a, b, c) = match *self {
            Operation::Input(variable) => (0, usize::from(variable.0), 0, 0),
            Operation::Constant(ref value) => return mixed(1, value.key()),
            Operation::Add(a, b) => (2, a.0, b.0, 0),
            Operation::Subtract(a, b) => (3, a.0, b.0, 0),
            Operation::Multiply(a, b) => (4, a.0, b.0, 0),
            Operation::Divide(a, b) => (5, a.0, b.0, 0),
            Operation::Negate(a) => (6, a.0, 0, 0),
            Operation::MultiplyAdd(a, b, c) => (7, a.0, b.0, c.0),
            Operation::MultiplySubtract(a, b, c) => (8, a.0, b.0, c.0),
            Operation::SubtractProduct(a, b, c) => (9, a.0, b.0, c.0),
            Operation::Prepared(index) => (10, index, 0, 0),
        };
        mixed(mixed(kind, a as u32), mixed(b as u32, c as u32))
    }
}

impl Keyed for Rc<Polynomial> {
    fn key(&self) -> u32 {
        let mut key = 0;
        for (monomial, coefficient) in self.terms() {
            for power in monomial.powers() {
                key = mixed(key, u32::from(power.0.0) ^ power.1 << 16);
            }
            key = mixed(key, coefficient.key());
        }
        key
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Node;

    #[test]
    fn items_keep_their_numbers_and_the_last_ones_are_forgotten() {
        let mut operations: Numbered<Operation> = Numbered::default();
        let product = |n: usize| Operation::Multiply(Node(n / 7), Node(n));
        for n in 0..100 {
            assert_eq!(operations.number(product(n)), n);
        }
        assert_eq!(operations.number(product(42)), 42);
        operations.truncate(50);
        assert_eq!(operations.items().len(), 50);
        for n in 0..100 {
            assert_eq!(operations.find(&product(n)), (n < 50).then_some(n));
        }
        assert_eq!(operations.number(product(70)), 50);
        assert_eq!(operations.find(&product(70)), Some(50));
    }
}
