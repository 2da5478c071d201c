//! Numbers of many digits on the heap, for the last precision level of a step.
//!
//! A step may need more than 17 × 64 bits if its matrix has entries of very different size and
//! nearly singular blocks. Products and quotients take time quadratic in the number of digits.
//! Therefore an elimination starts with few digits.

use std::boxed::Box;

use num_traits::{One, Zero};

use super::{Digits, Size, Wide};
use crate::scalar::operators;
use crate::{Constant, Scalar};

/// The number of digits that the long numbers of an elimination can store.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Capacity {
    Few,
    More,
    Most,
}

impl Capacity {
    pub(crate) const ALL: [Self; 3] = [Self::Few, Self::More, Self::Most];
}

type More = Digits<64, 134>;
type Most = Digits<256, 518>;

#[derive(Clone, Debug, PartialEq)]
enum Number {
    Few(Box<Wide>),
    More(Box<More>),
    Most(Box<Most>),
}

/// Evaluates the same expression for the digits of a long number, whichever capacity it has.
macro_rules! of_any_capacity {
    ($number:expr, |$digits:ident| $value:expr) => {
        match $number {
            Number::Few($digits) => $value,
            Number::More($digits) => $value,
            Number::Most($digits) => $value,
        }
    };
}

/// Applies an operator to two numbers, with the smaller of both capacities.
macro_rules! of_common_capacity {
    ($a:expr, $operator:tt, $b:expr) => {
        match ($a, $b) {
            (Number::Few(a), b) => (*a $operator b.digits()).into(),
            (a, Number::Few(b)) => (a.digits() $operator *b).into(),
            (Number::More(a), b) => (*a $operator b.digits()).into(),
            (a, Number::More(b)) => (a.digits() $operator *b).into(),
            (Number::Most(a), Number::Most(b)) => (*a $operator *b).into(),
        }
    };
}

impl Number {
    fn digits<const D: usize, const M: usize>(&self) -> Digits<D, M> {
        of_any_capacity!(self, |digits| digits.with_digits())
    }
}

macro_rules! capacities {
    ($($capacity:ident: $digits:ty;)*) => { $(
        impl From<$digits> for Number {
            fn from(digits: $digits) -> Self {
                Self::$capacity(Box::new(digits))
            }
        }
    )* };
}

capacities! { Few: Wide; More: More; Most: Most; }

/// A number of at most [`MOST_DIGITS`](Self::MOST_DIGITS) 64-bit digits. A result has the smaller
/// capacity of its operands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LongNumber(Option<Number>);

impl LongNumber {
    pub(crate) const MOST_DIGITS: usize = Most::MOST_DIGITS;

    pub(crate) fn new(number: Wide, capacity: Capacity) -> Self {
        Self::of(match capacity {
            Capacity::Few => number.into(),
            Capacity::More => Number::More(Box::new(number.with_digits())),
            Capacity::Most => Number::Most(Box::new(number.with_digits())),
        })
    }

    fn of(number: Number) -> Self {
        let is_exactly_zero =
            of_any_capacity!(&number, |digits| digits.is_zero() && digits.radius().is_zero());
        Self((!is_exactly_zero).then_some(number))
    }

    /// Returns an upper bound of the exact value's magnitude.
    pub(crate) fn at_most(&self) -> Size {
        let at_most = |number: &Number| of_any_capacity!(number, |digits| digits.size() + digits.radius());
        self.0.as_ref().map_or_else(Size::zero, at_most)
    }

    /// Returns the leading digits, with a radius that covers the other digits.
    pub(crate) fn leading(&self) -> Wide {
        self.0.as_ref().map_or_else(Wide::zero, Number::digits)
    }

    /// Returns whether `rounded` differs from the exact value by at most `relative` times
    /// |`rounded`|.
    pub(crate) fn is_within(&self, relative: f64, rounded: Wide) -> bool {
        let off = self.leading() - rounded;
        off.size() + off.radius() <= rounded.size() * Size::from(relative)
    }

    /// Returns whether more digits are known than any scalar has.
    fn is_known(&self) -> bool {
        self.leading().radius() * Size::from(1e40) <= self.at_most()
    }

    /// Returns whether a larger capacity would not help: all components are known, or a known one
    /// is out of range. Each `bool` says whether its component is in the scalar's range.
    pub(crate) fn are_settled<'a>(components: impl Iterator<Item = (&'a Self, bool)> + Clone) -> bool {
        let mut known = components.clone();
        let mut beyond = components.filter(|(_, is_in_range)| !is_in_range);
        known.all(|(number, _)| number.is_known()) || beyond.any(|(number, _)| number.is_known())
    }

    fn scaled(&self, power: i64) -> Self {
        self.clone().times(Self::of(Most::power_of_two(power).into()))
    }

    fn plus(self, other: Self) -> Self {
        match (self.0, other.0) {
            (None, number) | (number, None) => Self(number),
            (Some(a), Some(b)) => Self::of(of_common_capacity!(a, +, b)),
        }
    }

    fn times(self, other: Self) -> Self {
        match (self.0, other.0) {
            (Some(a), Some(b)) => Self::of(of_common_capacity!(a, *, b)),
            (None, Some(number)) | (Some(number), None)
                if !of_any_capacity!(&number, |digits| digits.is_defined()) =>
            {
                Self(Some(number))
            }
            _ => Self(None),
        }
    }

    fn over(self, other: Self) -> Self {
        let or_zero = |number: Option<Number>| number.unwrap_or_else(|| Most::zero().into());
        Self::of(of_common_capacity!(or_zero(self.0), /, or_zero(other.0)))
    }
}

/// Scales a row of a linear system by a power of two. If all rows are scaled, the largest entry of
/// a column is a good pivot.
pub(crate) fn equilibrate_row<'a>(row: impl Iterator<Item = &'a mut LongNumber>, right: &mut LongNumber) {
    let mut row: std::vec::Vec<_> = row.collect();
    let largest = row.iter().filter(|entry| entry.0.is_some()).map(|entry| entry.at_most());
    let Some(power) = largest.filter(|size| !size.is_unknown()).map(|size| size.exponent).max() else {
        return;
    };
    for entry in row.iter_mut().map(|entry| &mut **entry).chain([right]) {
        *entry = entry.scaled(-power);
    }
}

operators!([] LongNumber: Self::plus, |a: Self, b: Self| a.plus(-b), Self::times, Self::over);

impl core::ops::Neg for LongNumber {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|number| of_any_capacity!(number, |digits| Number::from(-*digits))))
    }
}

impl Zero for LongNumber {
    fn zero() -> Self {
        Self(None)
    }

    fn is_zero(&self) -> bool {
        self.0.as_ref().is_none_or(|number| of_any_capacity!(number, |digits| digits.is_zero()))
    }
}

impl One for LongNumber {
    fn one() -> Self {
        Self::of(Most::one().into())
    }
}

impl Scalar for LongNumber {
    fn constant(c: &Constant<'_>) -> Self {
        Self::of(Number::Most(Box::new(c.to_digits())))
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        if divisor.is_zero() { None } else { Some(self / divisor) }
    }

    fn is_better_pivot(&self, than: &Self) -> bool {
        self.at_most() > than.at_most()
    }

    fn approximate(&self) -> f64 {
        self.leading().to_f64()
    }
}
