//! A set of distinct items that are numbered in order of insertion.
//!
//! Macro expansion usually runs unoptimised. The simple loops below are then several times faster
//! than the standard hash tables.

use core::hash::{Hash, Hasher};
use core::ops::Deref;

use alloc::vec;
use alloc::vec::Vec;

use rustc_hash::FxHasher;

const END_OF_BUCKET: u32 = u32::MAX;

/// A set of distinct items, numbered in order of insertion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbered<T> {
    items: Vec<T>,
    keys: Vec<u32>,
    /// For each item, the number of the previous item in the same bucket.
    before: Vec<u32>,
    /// The number of the last item in each bucket. The number of buckets is a power of two.
    last: Vec<u32>,
}

impl<T> Default for Numbered<T> {
    fn default() -> Self {
        Numbered { items: Vec::new(), keys: Vec::new(), before: Vec::new(), last: vec![END_OF_BUCKET; 16] }
    }
}

impl<T> Deref for Numbered<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.items
    }
}

impl<T> Numbered<T> {
    /// Returns all items in order of insertion.
    pub fn into_items(self) -> Vec<T> {
        self.items
    }
}

impl<T: Hash + PartialEq> Numbered<T> {
    /// Returns the number of an item; `None` if the set does not contain the item.
    pub fn find(&self, item: &T) -> Option<usize> {
        self.with_key(key(item), item)
    }

    fn with_key(&self, key: u32, item: &T) -> Option<usize> {
        let (items, keys, before): (&[T], &[u32], &[u32]) = (&self.items, &self.keys, &self.before);
        let mut at = self.last[self.bucket(key)];
        while at != END_OF_BUCKET {
            let number = at as usize;
            if keys[number] == key && items[number] == *item {
                return Some(number);
            }
            at = before[number];
        }
        None
    }

    /// Returns the number of an item, and adds the item if it is new.
    pub fn number(&mut self, item: T) -> usize {
        let key = key(&item);
        if let Some(known) = self.with_key(key, &item) {
            return known;
        }
        let number = self.items.len();
        self.items.push(item);
        self.keys.push(key);
        self.before.push(END_OF_BUCKET);
        if number < self.last.len() {
            self.put_in_bucket(number);
        } else {
            self.last = vec![END_OF_BUCKET; 4 * self.last.len()];
            for number in 0..=number {
                self.put_in_bucket(number);
            }
        }
        number
    }

    /// Removes all items after the first `length` ones.
    pub fn truncate(&mut self, length: usize) {
        // The item with the largest number is also the last of its bucket.
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

fn key<T: Hash>(item: &T) -> u32 {
    let mut hasher = FxHasher::default();
    item.hash(&mut hasher);
    hasher.finish() as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_keep_their_numbers_and_the_last_ones_are_forgotten() {
        let mut products = Numbered::default();
        let product = |n: usize| (n / 7, n);
        for n in 0..100 {
            assert_eq!(products.number(product(n)), n);
        }
        assert_eq!(products.number(product(42)), 42);
        products.truncate(50);
        assert_eq!(products.len(), 50);
        for n in 0..100 {
            assert_eq!(products.find(&product(n)), (n < 50).then_some(n));
        }
        assert_eq!(products.number(product(70)), 50);
        assert_eq!(products.find(&product(70)), Some(50));
    }
}
