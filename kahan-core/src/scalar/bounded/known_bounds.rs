//! Magnitudes and errors of computed values, and the backward error of a row of a linear system.
//!
//! The backward error of a row of A·x̃ = b is |A·x̃ − b|/(|A|·|x̃| + |b|). An upper bound follows
//! from the residual A·x̃ − b, the right-hand side, and the magnitudes of the row's products.

use super::{Bounded, InputLimit, Magnitude, Number};

/// The magnitude of a computed value, and a bound of the value's error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KnownBounds<G> {
    pub(crate) size: G,
    /// An upper bound of the difference between the computed and the exact value.
    pub(crate) error: G,
    pub(crate) largest_input: InputLimit,
}

impl<V: Number> Bounded<V> {
    pub(crate) fn known(&self) -> KnownBounds<V::Magnitude> {
        KnownBounds { size: self.value().size(), error: self.error(), largest_input: self.largest_input() }
    }
}

impl<G: Magnitude> KnownBounds<G> {
    /// Returns a lower bound of the exact value's magnitude. The bound is 0 if the error is large.
    pub(crate) fn at_least(&self) -> G {
        if G::of(64.0) * self.error <= self.size { G::of(62.0 / 64.0) * self.size } else { G::zero() }
    }
}

/// Returns an upper bound of the backward error of a row. `products` is a lower bound of |A|·|x̃|
/// in this row, and `largest` is the largest input. The result is infinite if the error is NaN or
/// an input is too large.
pub(crate) fn backward_error<G: Magnitude>(
    residual: KnownBounds<G>,
    products: G,
    right: KnownBounds<G>,
    largest: G,
) -> f64 {
    let (error, size) = (residual.size + residual.error, products + right.at_least());
    if error.is_zero() && size.is_zero() {
        return 0.0;
    }
    let limit = residual.largest_input.and(right.largest_input);
    let error: f64 = (error / size).into();
    // Comparisons with NaN are false, and a NaN becomes infinite.
    if limit.allows(largest) && error >= 0.0 { error } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::{KnownBounds, backward_error};
    use crate::scalar::bounded::InputLimit;

    fn known(size: f64, error: f64) -> KnownBounds<f64> {
        KnownBounds { size, error, largest_input: InputLimit::below(10) }
    }

    #[test]
    fn a_backward_error_is_that_of_the_worst_residual_beside_the_least_right_hand_side() {
        let expected = 4.0 / (2.0 + 6.0 * 62.0 / 64.0);
        assert_eq!(backward_error(known(3.0, 1.0), 2.0, known(6.0, 0.0), 1.0), expected);
        assert_eq!(backward_error(known(3.0, 1.0), 2.0, known(6.0, 0.1), 1.0), 2.0);
        assert_eq!(backward_error(known(0.0, 0.0), 0.0, known(0.0, 0.0), 1.0), 0.0);
    }

    #[test]
    fn nothing_is_known_where_a_premise_is_broken() {
        let fine = known(1.0, 0.0);
        assert_eq!(backward_error(fine, 1.0, fine, 1023.0), 1.0 / (1.0 + 62.0 / 64.0));
        assert_eq!(backward_error(fine, 1.0, fine, 1024.0), f64::INFINITY);
        let refused = KnownBounds { largest_input: InputLimit::NONE, ..fine };
        assert_eq!(backward_error(refused, 1.0, fine, 0.0), f64::INFINITY);
        assert_eq!(backward_error(fine, 1.0, refused, 0.0), f64::INFINITY);
        let any = KnownBounds { largest_input: InputLimit::ANY, ..fine };
        assert!(backward_error(any, 1.0, any, 1e300).is_finite());
        for not_a_number in [known(f64::NAN, 0.0), known(1.0, f64::NAN)] {
            assert_eq!(backward_error(not_a_number, 1.0, fine, 1.0), f64::INFINITY);
        }
        assert_eq!(backward_error(fine, f64::NAN, fine, 1.0), f64::INFINITY);
        assert_eq!(backward_error(fine, 1.0, fine, f64::NAN), f64::INFINITY);
        assert_eq!(backward_error(known(1.0, 0.0), 0.0, known(0.0, 0.0), 1.0), f64::INFINITY);
    }
}
