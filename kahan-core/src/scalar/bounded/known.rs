//! What is known of a value, and the backward error of a row that follows.
//!
//! In: the residual of a row of A·x̃ = b, its right-hand side and the sizes of its products, each
//! with a bound on its own error. Out: |A·x̃ − b|/(|A|·|x̃| + |b|), at most.

use super::{Bounded, Limit, Magnitude, Working};

/// What is known of the value of a formula: a number, and how far it may be off.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<G> {
    /// |v̂|
    pub(crate) size: G,
    /// |v̂ − v|, at most.
    pub(crate) error: G,
    /// How large inputs may be, see [`Bounded::largest_input`].
    pub(crate) largest_input: Limit,
}

impl<V: Working> Bounded<V> {
    /// What is known of this.
    pub(crate) fn known(&self) -> Known<V::Magnitude> {
        Known { size: self.value().size(), error: self.error(), largest_input: self.largest_input() }
    }
}

impl<G: Magnitude> Known<G> {
    /// What |v| is at least: a little less than |v̂|, which pays for the roundings of sums of sizes
    /// too; nothing where the error is no small part of it.
    pub(crate) fn at_least(&self) -> G {
        if G::of(64.0) * self.error <= self.size { G::of(62.0 / 64.0) * self.size } else { G::zero() }
    }
}

/// The backward error of a row, at most: the residual beside `products`, which is |A|·|x̃| at least,
/// and the right-hand side. Infinite where nothing is known of it, as where underflow was not
/// allowed for with inputs as large as `largest`.
pub(crate) fn backward_error<G: Magnitude>(
    residual: Known<G>,
    products: G,
    right: Known<G>,
    largest: G,
) -> f64 {
    let (error, size) = (residual.size + residual.error, products + right.at_least());
    if error.is_zero() && size.is_zero() {
        return 0.0;
    }
    let limit = residual.largest_input.and(right.largest_input);
    let error: f64 = (error / size).into();
    // What is not a number compares with none.
    if limit.allows(largest) && error >= 0.0 { error } else { f64::INFINITY }
}
