//! Truncated power series in δ modulo a prime, with their derivatives along a curve or surface.
//!
//! Row 0 of a series holds the coefficients at a point of the curve. Each further row holds the
//! derivatives of the coefficients along one tangent vector.

use crate::modular::modulus::Modulus;

/// The series Σ cₖ δᵏ, with the derivatives of every coefficient cₖ along the curve.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) rows: Vec<Vec<u64>>,
}

impl Series {
    pub(crate) fn constant(value: u64, slopes: &[u64], length: usize) -> Self {
        let row = |&first: &u64| {
            let mut row = vec![0; length];
            row[..length.min(1)].fill(first);
            row
        };
        Series { rows: [value].iter().chain(slopes).map(row).collect() }
    }

    pub(crate) fn length(&self) -> usize {
        self.rows[0].len()
    }

    /// Returns the least k for which the coefficient of δᵏ is known and not 0.
    pub(crate) fn order(&self) -> Option<usize> {
        self.rows[0].iter().position(|&coefficient| coefficient != 0)
    }

    pub(crate) fn add(&mut self, modulus: &Modulus, factor: u64, other: &Series) {
        for (row, other) in self.rows.iter_mut().zip(&other.rows) {
            for (a, b) in row.iter_mut().zip(other) {
                *a = modulus.plus(*a, modulus.times(factor, *b));
            }
        }
    }

    pub(crate) fn times(&self, modulus: &Modulus, other: &Series) -> Series {
        let (a, b) = (&self.rows[0], &other.rows[0]);
        let mut rows = vec![product(modulus, a, b)];
        for (da, db) in self.rows.iter().zip(&other.rows).skip(1) {
            let (left, right) = (product(modulus, da, b), product(modulus, a, db));
            rows.push(left.iter().zip(&right).map(|(l, r)| modulus.plus(*l, *r)).collect());
        }
        Series { rows }
    }

    /// Divides by δ^power. Returns `None` if the quotient contains a negative power of δ.
    pub(crate) fn divided(mut self, power: usize) -> Option<Series> {
        for row in &mut self.rows {
            if row.drain(..power).any(|coefficient| coefficient != 0) {
                return None;
            }
        }
        Some(self)
    }

    pub(crate) fn leading(&self) -> Vec<u64> {
        self.rows.iter().map(|row| row[0]).collect()
    }
}

fn product(modulus: &Modulus, a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut product = vec![0; a.len()];
    for (i, &left) in a.iter().enumerate().filter(|(_, left)| **left != 0) {
        for (entry, &right) in product[i..].iter_mut().zip(b) {
            *entry = modulus.plus(*entry, modulus.times(left, right));
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_have_the_coefficients_and_slopes_of_the_product_rule() {
        let modulus = Modulus::mersenne_61();
        let numbers = |values: [u64; 3]| values.map(|value| modulus.integer(value)).to_vec();
        let a = Series { rows: vec![numbers([1, 2, 3]), numbers([0, 1, 4])] };
        let b = Series { rows: vec![numbers([5, 0, 1]), numbers([2, 2, 2])] };
        let both = a.times(&modulus, &b);
        assert_eq!(both.rows, [numbers([5, 10, 16]), numbers([2, 11, 32])]);
        let shifted = Series { rows: vec![numbers([0, 0, 7]), numbers([0, 3, 0])] };
        assert_eq!(shifted.order(), Some(2));
        assert!(shifted.clone().divided(2).is_none());
        assert_eq!(shifted.divided(1).unwrap().leading(), [0, modulus.integer(3)]);
    }
}
