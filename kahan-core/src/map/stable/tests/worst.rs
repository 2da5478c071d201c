//! A scalar with worst-case rounding. Each operation has an error of one rounding unit u, in a
//! direction that the test chooses, and optionally an underflow error η. Values are rationals, and
//! therefore the true error is known.

use core::cell::Cell;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use std::boxed::Box;
use std::thread_local;

use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, ToPrimitive, Zero};

use crate::scalar::bounded::{Bounded, Magnitude, Number, Range, UnpackedPair, power_of_two};
use crate::{Constant, Pivot, Scalar};

pub(super) type Q = BigRational;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Worst<const BITS: i32>(&'static Q);

thread_local! {
    /// The errors of the next results, as multiples of the rounding unit u and of the underflow
    /// error η.
    static OFF: Cell<(i64, i64)> = const { Cell::new((0, 0)) };
    static ARE_MAGNITUDES_LOW: Cell<bool> = const { Cell::new(false) };
}

pub(super) fn with_low_magnitudes<V>(run: impl FnOnce() -> V) -> V {
    let before = ARE_MAGNITUDES_LOW.replace(true);
    let result = run();
    ARE_MAGNITUDES_LOW.set(before);
    result
}

/// Calls `run` with an error of `relative`·u + `absolute`·η in every operation.
pub(super) fn off_by<V>((relative, absolute): (i64, i64), run: impl FnOnce() -> V) -> V {
    let before = OFF.replace((relative, absolute));
    let result = run();
    OFF.set(before);
    result
}

pub(super) fn two_to(power: i32) -> Q {
    Q::from_integer(2.into()).pow(power)
}

pub(super) const ETA: i32 = -70;

impl<const BITS: i32> Worst<BITS> {
    pub(super) fn new(value: Q) -> Self {
        Self(Box::leak(Box::new(value)))
    }

    pub(super) fn of_float(value: f64) -> Self {
        Self::new(Q::from_f64(value).expect("a finite number"))
    }

    pub(super) fn exact(&self) -> Q {
        self.0.clone()
    }

    fn rounded(exact: Q) -> Self {
        let (relative, absolute) = OFF.get();
        let relative = Q::from_integer(relative.into()) * two_to(-BITS);
        let absolute = Q::from_integer(absolute.into()) * two_to(ETA);
        Self::new(exact * (Q::one() + relative) + absolute)
    }
}

impl<const BITS: i32> Scalar for Worst<BITS> {
    fn constant(c: &Constant<'_>) -> Self {
        let ratio = c.to_ratio();
        if ratio.is_integer() { Self::new(ratio) } else { Self::rounded(ratio) }
    }

    fn approximate(&self) -> f64 {
        self.0.to_f64().expect("a number of ordinary size")
    }
}

impl<const BITS: i32> Pivot for Worst<BITS> {
    fn magnitude_exceeds(&self, other: &Self) -> bool {
        self.0.abs() > other.0.abs()
    }

    fn is_finite_number(&self) -> bool {
        true
    }
}

/// A magnitude with the rounding unit u = 2^−BITS. The rounding of `f64` is negligible beside u.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) struct Rough<const BITS: i32>(f64);

impl<const BITS: i32> Rough<BITS> {
    fn rounded(exact: f64) -> Self {
        Self(if ARE_MAGNITUDES_LOW.get() { exact * (1.0 - power_of_two(-BITS)) } else { exact })
    }
}

impl<const BITS: i32> Magnitude for Rough<BITS> {
    fn of(value: f64) -> Self {
        Self(value)
    }
}

impl<const BITS: i32> From<Rough<BITS>> for f64 {
    fn from(rough: Rough<BITS>) -> Self {
        rough.0
    }
}

impl<const BITS: i32> Add for Rough<BITS> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::rounded(self.0 + other.0)
    }
}

impl<const BITS: i32> Mul for Rough<BITS> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::rounded(self.0 * other.0)
    }
}

impl<const BITS: i32> Div for Rough<BITS> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::rounded(self.0 / other.0)
    }
}

impl<const BITS: i32> Zero for Rough<BITS> {
    fn zero() -> Self {
        Self(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl<const BITS: i32> Number for Worst<BITS> {
    type Magnitude = Rough<BITS>;
    const UNIT: f64 = power_of_two(-BITS);
    const RANGE: Range = Range::of(ETA, 10 + 20 + ETA, 4, 6);

    fn size(&self) -> Rough<BITS> {
        Rough(self.0.abs().to_f64().expect("a number of ordinary size"))
    }
}

macro_rules! operators {
    ($($operator:ident, $method:ident, $assign:ident, $in_place:ident;)*) => {$(
        impl<const BITS: i32> $operator for Worst<BITS> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self::rounded(self.0.$method(other.0))
            }
        }

        impl<const BITS: i32> $assign for Worst<BITS> {
            fn $in_place(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

operators! {
    Add, add, AddAssign, add_assign;
    Sub, sub, SubAssign, sub_assign;
    Mul, mul, MulAssign, mul_assign;
    Div, div, DivAssign, div_assign;
}

impl<const BITS: i32> Neg for Worst<BITS> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.exact())
    }
}

impl<const BITS: i32> Zero for Worst<BITS> {
    fn zero() -> Self {
        Self::new(Q::zero())
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl<const BITS: i32> One for Worst<BITS> {
    fn one() -> Self {
        Self::new(Q::one())
    }
}

/// A bounded value, together with the exact value of its formula.
#[derive(Clone, Debug)]
pub(super) struct Beside<const BITS: i32> {
    pub(super) bounded: Bounded<Worst<BITS>, UnpackedPair<Worst<BITS>>>,
    pub(super) exact: Q,
}

impl<const BITS: i32> Beside<BITS> {
    pub(super) fn from_input(value: f64) -> Self {
        let exact = Q::from_f64(value).expect("a finite number");
        Self { bounded: Bounded::from_input(Worst::new(exact.clone())), exact }
    }

    pub(super) fn literal(p: i64, q: i64) -> Self {
        let exact = Q::new(p.into(), q.into());
        let constant = if q == 1 { Constant::integer(p) } else { Constant::ratio(p, q) };
        Self { bounded: Scalar::constant(&constant), exact }
    }

    pub(super) fn error(&self) -> Q {
        (self.bounded.value().exact() - &self.exact).abs()
    }

    /// Returns error/bound, which is at most 1 if the bound is valid. Also checks that the
    /// magnitude bounds the value, up to the factor 1.0625.
    pub(super) fn part(&self) -> f64 {
        let magnitude: f64 = self.bounded.magnitude().into();
        assert!(self.exact.abs().to_f64().expect("a number") <= 1.0625 * magnitude, "{self:?}");
        let part = self.error() / Q::from_f64(self.bounded.error().into()).expect("a finite bound");
        part.to_f64().expect("a number")
    }

    pub(super) fn over(&self, other: &Self) -> Option<Self> {
        let bounded = self.bounded.quotient(other.bounded)?;
        Some(Self { bounded, exact: &self.exact / &other.exact })
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Self { bounded: self.bounded + other.bounded, exact: &self.exact + &other.exact }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        Self { bounded: self.bounded - other.bounded, exact: &self.exact - &other.exact }
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        Self { bounded: self.bounded * other.bounded, exact: &self.exact * &other.exact }
    }

    pub(super) fn times_plus(&self, other: &Self, addend: &Self) -> Self {
        let bounded = self.bounded.multiply_add(other.bounded, addend.bounded);
        Self { bounded, exact: &self.exact * &other.exact + &addend.exact }
    }

    pub(super) fn negated(&self) -> Self {
        Self { bounded: -self.bounded, exact: -&self.exact }
    }

    pub(super) fn over_input(&self, eps: &Self) -> Self {
        Self { bounded: self.bounded.over_input(eps.bounded), exact: &self.exact / &eps.exact }
    }
}
