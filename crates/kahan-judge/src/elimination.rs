//! Solves the equation A·(x̃ − x) = 2εf of a Kahan step for its result x̃ in ball arithmetic.
//!
//! A pivot is an entry whose ball excludes 0. If a column has no pivot and is not known to be 0,
//! the result is unknown. The caller then tries the next of the [`precisions`].

use std::cmp::Ordering;
use std::iter::successors;

use super::ball::Ball;
use super::dyadic::Dyadic;
use super::equation::{AtPoint, Curvature};

pub(crate) fn precisions() -> impl Iterator<Item = u64> {
    const LEAST_BITS: u64 = 128;
    const MOST_BITS: u64 = 4096;
    successors(Some(LEAST_BITS), |bits| Some(2 * bits)).take_while(|bits| *bits <= MOST_BITS)
}

#[derive(Debug)]
pub(crate) enum Eliminated<R> {
    Solved(R),
    /// The determinant of A is zero.
    Singular,
    /// The determinant of A may be zero.
    Unknown,
}

/// The dense matrix A(x,ε), with right-hand sides appended to its rows.
pub(crate) struct Matrix {
    pub(crate) rows: Vec<Vec<Ball>>,
    bits: u64,
}

impl Matrix {
    pub(crate) fn of(equation: &AtPoint, bits: u64, right: impl Fn(usize) -> Vec<Ball>) -> Self {
        let n = equation.x.len();
        let row = |i: usize| {
            let mut row = vec![Ball::exactly(Dyadic::zero()); n];
            for (j, entry) in equation.row(i) {
                row[j] = Ball::exactly(entry).rounded(bits);
            }
            row.extend(right(i));
            row
        };
        Self { rows: (0..n).map(row).collect(), bits }
    }

    pub(crate) fn solve(mut self) -> Eliminated<(Vec<Vec<Ball>>, Ball)> {
        let (n, bits) = (self.rows.len(), self.bits);
        let size = |row: &Vec<Ball>| row[..n].iter().filter_map(|entry| entry.middle().binade()).max();
        let mut sizes: Vec<i64> = self.rows.iter().map(|row| size(row).unwrap_or(0)).collect();
        let mut determinant = Ball::exactly(Dyadic::new(1, 0));
        for k in 0..n {
            // Rows may differ widely in size, so pivots are measured relative to their rows.
            let candidates = (k..n).filter(|&i| self.rows[i][k].is_not_zero());
            let part = |i: &usize| self.rows[*i][k].middle().binade().map(|binade| binade - sizes[*i]);
            let Some(pivot) = candidates.max_by_key(part) else {
                let is_singular = (k..n).all(|i| self.rows[i][k].is_zero());
                return if is_singular { Eliminated::Singular } else { Eliminated::Unknown };
            };
            if pivot != k {
                self.rows.swap(k, pivot);
                sizes.swap(k, pivot);
                determinant = Ball::exactly(Dyadic::zero()).minus(&determinant, bits);
            }
            let (above, below) = self.rows.split_at_mut(k + 1);
            let pivoted = &above[k];
            determinant = determinant.times(&pivoted[k], bits);
            for row in below.iter_mut().filter(|row| !row[k].is_zero()) {
                let multiplier = row[k].over(&pivoted[k], bits);
                for (entry, other) in row[k + 1..].iter_mut().zip(&pivoted[k + 1..]) {
                    if !other.is_zero() {
                        *entry = entry.minus(&multiplier.times(other, bits), bits);
                    }
                }
            }
        }
        let columns = self.rows.first().map_or(0, |row| row.len() - n);
        let mut solutions: Vec<Vec<Ball>> = vec![Vec::new(); n];
        for k in (0..n).rev() {
            solutions[k] = (0..columns)
                .map(|column| {
                    let mut left = self.rows[k][n + column].clone();
                    for (entry, solution) in self.rows[k][..n].iter().zip(&solutions).skip(k + 1) {
                        if !entry.is_zero() {
                            left = left.minus(&entry.times(&solution[column], bits), bits);
                        }
                    }
                    left.over(&self.rows[k][k], bits)
                })
                .collect();
        }
        Eliminated::Solved((solutions, determinant))
    }
}

pub(crate) fn next(equation: &AtPoint, bits: u64) -> Eliminated<Vec<Ball>> {
    let right = |i: usize| vec![Ball::exactly(equation.increment(i)).rounded(bits)];
    match Matrix::of(equation, bits, right).solve() {
        Eliminated::Solved((solutions, _)) => {
            let increments = solutions.into_iter().map(|mut row| row.swap_remove(0));
            let next = equation.x.iter().zip(increments);
            Eliminated::Solved(next.map(|(x, d)| Ball::exactly(x.clone()).plus(&d, bits)).collect())
        }
        Eliminated::Singular => Eliminated::Singular,
        Eliminated::Unknown => Eliminated::Unknown,
    }
}

/// Returns the condition number max_i Σ_v |∂x̃ᵢ/∂v|·|v| / ‖x̃‖∞, where v runs over x and ε.
/// Returns `None` if `bits` bits are too few. One elimination solves for all derivatives:
/// ∂x̃/∂x = A(x,ε)⁻¹·A(x̃,−ε) and ∂x̃/∂ε = A(x,ε)⁻¹(2f(x) + f′(x)(x̃ − x)).
pub(crate) fn condition(equation: &AtPoint, curvature: &[Vec<Curvature>], bits: u64) -> Option<f64> {
    let Eliminated::Solved(next) = next(equation, bits) else { return None };
    let n = next.len();
    let exactly = |value: &Dyadic| Ball::exactly(value.clone()).rounded(bits);
    let moved: Vec<Ball> = next.iter().zip(&equation.x).map(|(y, x)| y.minus(&exactly(x), bits)).collect();
    let right = |i: usize| {
        let row = &equation.rows[i];
        let mut slopes: Vec<Option<Ball>> = vec![None; n];
        let mut by_eps = exactly(&row.field.clone().scaled(1));
        for (j, slope) in &row.slopes {
            let slope = exactly(slope);
            by_eps = by_eps.plus(&slope.times(&moved[*j], bits), bits);
            slopes[*j] = Some(slope);
        }
        for Curvature { first, second, value } in &curvature[i] {
            let change = exactly(value).times(&moved[*second], bits);
            slopes[*first] = slopes[*first].take().map(|slope| slope.plus(&change, bits));
        }
        let eps = exactly(&equation.eps);
        let back = slopes.into_iter().enumerate().map(|(j, slope)| {
            let entry = slope.map_or_else(|| Ball::exactly(Dyadic::zero()), |slope| slope.times(&eps, bits));
            if i == j { exactly(&row.denominator).plus(&entry, bits) } else { entry }
        });
        back.chain([by_eps]).collect()
    };
    let Eliminated::Solved((changes, _)) = Matrix::of(equation, bits, right).solve() else { return None };
    let inputs: Vec<Ball> = equation.x.iter().chain([&equation.eps]).map(exactly).collect();
    let sum = |row: &Vec<Ball>| {
        row.iter().zip(&inputs).fold(Ball::exactly(Dyadic::zero()), |sum, (change, input)| {
            sum.plus(&change.times(input, bits).absolute(), bits)
        })
    };
    let sums: Vec<Ball> = changes.iter().map(sum).collect();
    if next.iter().all(Ball::is_zero) {
        return Some(f64::INFINITY);
    }
    let (most, size) = (largest(sums.iter().map(Ball::most)), largest(next.iter().map(Ball::least)));
    let (least, size_at_most) = (largest(sums.iter().map(Ball::least)), largest(next.iter().map(Ball::most)));
    let (above, below) = (&most * &size_at_most, &least * &size);
    // The condition number counts as known if its two bounds are nearly equal.
    let is_known = !size.is_zero() && (&above - &below).scaled(20).compare(&below) != Ordering::Greater;
    is_known.then(|| most.ratio(&size))
}

pub(crate) fn largest(values: impl Iterator<Item = Dyadic>) -> Dyadic {
    values.fold(
        Dyadic::zero(),
        |largest, value| {
            if value.compare(&largest) == Ordering::Greater { value } else { largest }
        },
    )
}
