//! `f64` as a [`Real`]: elementary functions of the standard library, Γ and ψ of other crates.

use std::sync::OnceLock;

use kahan_core::num_rational::BigRational;
use kahan_core::num_traits::ToPrimitive;

use super::{Real, bernoulli, gamma};

macro_rules! by_the_machine {
    ($($function:ident)*) => { $(
        fn $function(&self) -> Self {
            f64::$function(*self)
        }
    )* };
}

impl Real for f64 {
    const DIGITS: usize = 15;

    fn epsilon() -> Self {
        f64::EPSILON
    }

    fn from_int(n: i64) -> Self {
        n as f64
    }

    fn from_rational(q: &BigRational) -> Self {
        q.to_f64().unwrap_or(f64::NAN)
    }

    fn pi() -> Self {
        core::f64::consts::PI
    }

    by_the_machine! { abs sqrt exp exp_m1 ln ln_1p tanh floor }

    fn sin_cos(&self) -> (Self, Self) {
        f64::sin_cos(*self)
    }

    fn atan2(&self, x: &Self) -> Self {
        f64::atan2(*self, *x)
    }

    fn sinh_cosh(&self) -> (Self, Self) {
        (f64::sinh(*self), f64::cosh(*self))
    }

    fn atanh(&self) -> Self {
        libm::atanh(*self)
    }

    fn gamma(&self) -> Self {
        if gamma::is_pole(self) { f64::NAN } else { libm::tgamma(*self) }
    }

    fn digamma(&self) -> Self {
        if gamma::is_pole(self) { f64::NAN } else { special::Gamma::digamma(*self) }
    }

    fn bernoulli() -> &'static [Self] {
        static NUMBERS: OnceLock<Vec<f64>> = OnceLock::new();
        NUMBERS.get_or_init(|| bernoulli::even_numbers().iter().map(Self::from_rational).collect())
    }

    fn power_real(&self, y: &Self) -> Self {
        f64::powf(*self, *y)
    }
}
