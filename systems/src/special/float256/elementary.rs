//! Elementary functions of [`Float256`], correctly rounded by `dashu-float`, and special functions.

use std::sync::OnceLock;

use dashu_float::{ConstCache, Repr};
use kahan_core::num_rational::BigRational;
use kahan_core::num_traits::{One, Zero};

use super::{BITS, CACHE, CONTEXT, Float256, Outcome};
use crate::special::{Real, bernoulli, gamma};

impl Float256 {
    fn apply(&self, function: impl FnOnce(&Repr<2>, Option<&mut ConstCache>) -> Outcome) -> Self {
        let Some(repr) = self.repr() else { return Self::UNDEFINED };
        CACHE.with_borrow_mut(|cache| Self::from_outcome(function(&repr, Some(cache))))
    }

    fn apply_pair(
        &self,
        function: impl FnOnce(&Repr<2>, Option<&mut ConstCache>) -> (Outcome, Outcome),
    ) -> (Self, Self) {
        let Some(repr) = self.repr() else { return (Self::UNDEFINED, Self::UNDEFINED) };
        let (first, second) = CACHE.with_borrow_mut(|cache| function(&repr, Some(cache)));
        (Self::from_outcome(first), Self::from_outcome(second))
    }
}

macro_rules! by_the_library {
    ($($function:ident)*) => { $(
        fn $function(&self) -> Self {
            self.apply(|x, cache| CONTEXT.$function(x, cache))
        }
    )* };
}

impl Real for Float256 {
    const DIGITS: usize = 76;

    fn epsilon() -> Self {
        Self::from_repr(Repr::new(1.into(), 1 - BITS as isize))
    }

    fn from_int(n: i64) -> Self {
        n.into()
    }

    fn from_rational(q: &BigRational) -> Self {
        Self::from_rational(q)
    }

    fn pi() -> Self {
        CACHE.with_borrow_mut(|cache| Self::from_repr(CONTEXT.pi::<2>(Some(cache)).value().into_repr()))
    }

    fn abs(&self) -> Self {
        if *self < Self::zero() { -*self } else { *self }
    }

    fn sqrt(&self) -> Self {
        self.apply(|x, _| CONTEXT.sqrt(x))
    }

    by_the_library! { exp exp_m1 ln ln_1p tanh atanh }

    fn sin_cos(&self) -> (Self, Self) {
        self.apply_pair(|x, cache| CONTEXT.sin_cos(x, cache))
    }

    fn atan2(&self, x: &Self) -> Self {
        if self.is_zero() && x.is_zero() {
            return Self::zero();
        }
        let Some(abscissa) = x.repr() else { return Self::UNDEFINED };
        self.apply(|y, cache| CONTEXT.atan2(y, &abscissa, cache))
    }

    fn sinh_cosh(&self) -> (Self, Self) {
        self.apply_pair(|x, cache| CONTEXT.sinh_cosh(x, cache))
    }

    fn floor(&self) -> Self {
        let Some(repr) = self.repr() else { return Self::UNDEFINED };
        if repr.exponent() >= 0 {
            return *self;
        }
        // The right shift rounds negative integers towards minus infinity, as `floor` must.
        Self::from_repr(Repr::new(repr.significand() >> repr.exponent().unsigned_abs(), 0))
    }

    fn gamma(&self) -> Self {
        gamma::by_stirling(self)
    }

    fn digamma(&self) -> Self {
        gamma::digamma_by_stirling(self)
    }

    fn bernoulli() -> &'static [Self] {
        static NUMBERS: OnceLock<Vec<Float256>> = OnceLock::new();
        NUMBERS.get_or_init(|| bernoulli::even_numbers().iter().map(Self::from_rational).collect())
    }

    fn power_real(&self, y: &Self) -> Self {
        let Some(exponent) = y.repr() else { return Self::UNDEFINED };
        if !self.is_positive() {
            return if y.is_zero() { Self::one() } else { Self::UNDEFINED };
        }
        self.apply(|x, cache| CONTEXT.powf(x, &exponent, cache))
    }
}
