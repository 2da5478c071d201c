//! The numbers that steps with bounds work in, and how their operations are compiled.

use super::{Bounded, Number, Pair};

/// A [`Number`] to work in: whether its operations are inlined.
pub(crate) trait Working: Number {
    /// a + b
    fn plus<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Bounded<Self, P>;
    /// a − b
    fn minus<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Bounded<Self, P>;
    /// a·b
    fn times<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Bounded<Self, P>;
    /// a·b + c
    fn product_plus<P: Pair<Self>>(
        a: Bounded<Self, P>,
        b: Bounded<Self, P>,
        c: Bounded<Self, P>,
    ) -> Bounded<Self, P>;
    /// a/b, if b is certainly not zero.
    fn over<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Option<Bounded<Self, P>>;
}

/// The operations of a [`Working`] scalar: for hardware floats inlined, so that a step is one piece
/// of code; for wide numbers, whose rungs are seldom reached, called, so that a step over them
/// stays small.
macro_rules! operations {
    ($inline:meta) => {
        #[$inline]
        fn plus<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Bounded<Self, P> {
            a.sum(b)
        }

        #[$inline]
        fn minus<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Bounded<Self, P> {
            a.difference(b)
        }

        #[$inline]
        fn times<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Bounded<Self, P> {
            a.product(b)
        }

        #[$inline]
        fn product_plus<P: Pair<Self>>(
            a: Bounded<Self, P>,
            b: Bounded<Self, P>,
            c: Bounded<Self, P>,
        ) -> Bounded<Self, P> {
            a.product_plus(b, c)
        }

        #[$inline]
        fn over<P: Pair<Self>>(a: Bounded<Self, P>, b: Bounded<Self, P>) -> Option<Bounded<Self, P>> {
            a.quotient(b)
        }
    };
}

pub(crate) use operations;
