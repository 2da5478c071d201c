//! Exact numbers for tests: rational numbers, vectors, matrices, and seeded random numbers.

use kahan_algebra::prime_field::SplitMix64;
use num_bigint::BigInt;
use num_rational::BigRational;

/// An exact number.
pub type Q = BigRational;
/// A point or a vector.
pub type Vector = Vec<Q>;
/// A matrix by rows.
pub type Matrix = Vec<Vec<Q>>;

/// Returns the fraction p/d.
#[must_use]
pub fn q(p: i64, d: i64) -> Q {
    Q::new(p.into(), d.into())
}

/// Reads `p/q` or `p`. Panics for other text.
#[must_use]
pub fn number(text: &str) -> Q {
    let (p, d) = text.split_once('/').unwrap_or((text, "1"));
    let integer =
        |digits: &str| digits.parse::<BigInt>().unwrap_or_else(|_| panic!("`{text}` is not a number"));
    Q::new(integer(p), integer(d))
}

/// Reads numbers separated by commas, for example `3/7, -2`.
#[must_use]
pub fn numbers(text: &str) -> Vector {
    text.split(',').map(|entry| number(entry.trim())).collect()
}

/// Writes numbers separated by commas, as [`numbers`] reads them.
#[must_use]
pub fn shown(x: &[Q]) -> String {
    x.iter().map(Q::to_string).collect::<Vec<_>>().join(", ")
}

/// Returns the vector a + b.
#[must_use]
pub fn sum(a: &[Q], b: &[Q]) -> Vector {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

/// Returns the vector a − b.
#[must_use]
pub fn difference(a: &[Q], b: &[Q]) -> Vector {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Returns the vector factor · v.
#[must_use]
pub fn scaled(factor: &Q, v: &[Q]) -> Vector {
    v.iter().map(|entry| factor * entry).collect()
}

/// Returns the product of the matrix M and the vector v.
#[must_use]
pub fn product(m: &[Vec<Q>], v: &[Q]) -> Vector {
    m.iter().map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum()).collect()
}

/// Returns the product of the matrices M and N.
#[must_use]
pub fn matrix_product(m: &[Vec<Q>], n: &[Vec<Q>]) -> Matrix {
    let columns = transposed(n);
    m.iter().map(|row| product(&columns, row)).collect()
}

/// Returns the transposed matrix Mᵀ.
#[must_use]
pub fn transposed(m: &[Vec<Q>]) -> Matrix {
    (0..m.len()).map(|j| m.iter().map(|row| row[j].clone()).collect()).collect()
}

/// Returns det M by Laplace's expansion along the first column.
#[must_use]
pub fn determinant(m: &[Vec<Q>]) -> Q {
    let Some(first) = m.first() else { return q(1, 1) };
    let zero = q(0, 1);
    let mut total = zero.clone();
    for i in 0..first.len() {
        if m[i][0] == zero {
            continue;
        }
        let minor: Matrix =
            m.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, row)| row[1..].to_vec()).collect();
        let term = &m[i][0] * determinant(&minor);
        total = if i % 2 == 0 { total + term } else { total - term };
    }
    total
}

/// Returns adj(M)·b by Cramer's rule without the division.
#[must_use]
pub fn adjugate_product(m: &[Vec<Q>], b: &[Q]) -> Vector {
    let replaced = |column: usize| -> Matrix {
        let with_entry = |(row, entry): (&Vec<Q>, &Q)| {
            let mut row = row.clone();
            row[column] = entry.clone();
            row
        };
        m.iter().zip(b).map(with_entry).collect()
    };
    (0..m.len()).map(|column| determinant(&replaced(column))).collect()
}

/// Seeded random fractions p/d with |p| ≤ 9 and 1 ≤ d ≤ 4.
#[derive(Clone, Debug)]
pub struct Rationals {
    random: SplitMix64,
}

impl Rationals {
    /// Starts the sequence of numbers that a seed determines.
    #[must_use]
    pub fn seeded(seed: u64) -> Self {
        Self { random: SplitMix64::new(seed) }
    }

    /// Draws a number.
    pub fn draw(&mut self) -> Q {
        let p = self.random.below(19) as i64 - 9;
        q(p, self.random.below(4) as i64 + 1)
    }

    /// Draws a nonzero number.
    pub fn nonzero(&mut self) -> Q {
        loop {
            let next = self.draw();
            if next != q(0, 1) {
                return next;
            }
        }
    }

    /// Draws a point with `n` coordinates.
    pub fn point(&mut self, n: usize) -> Vector {
        (0..n).map(|_| self.draw()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_determinant_changes_sign_with_two_rows_and_is_multiplicative() {
        let mut rationals = Rationals::seeded(1);
        let a: Matrix = (0..4).map(|_| rationals.point(4)).collect();
        let b: Matrix = (0..4).map(|_| rationals.point(4)).collect();
        let mut swapped = a.clone();
        swapped.swap(1, 3);
        assert_eq!(determinant(&swapped), -determinant(&a));
        assert_eq!(determinant(&matrix_product(&a, &b)), determinant(&a) * determinant(&b));
    }

    #[test]
    fn the_adjugate_inverts_up_to_the_determinant() {
        let mut rationals = Rationals::seeded(2);
        let a: Matrix = (0..4).map(|_| rationals.point(4)).collect();
        let b = rationals.point(4);
        assert_eq!(product(&a, &adjugate_product(&a, &b)), scaled(&determinant(&a), &b));
    }
}
