//! `f64` as a [`Real`], with elementary functions and Γ of the crate `libm`.

use std::sync::OnceLock;

use kahan_core::num_rational::BigRational;
use kahan_core::num_traits::ToPrimitive;

use super::{Real, bernoulli, gamma};

macro_rules! by {
    ($($function:ident $path:path;)*) => { $(
        fn $function(&self) -> Self {
            $path(*self)
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

    by! {
        abs f64::abs;
        floor f64::floor;
        sqrt f64::sqrt;
        exp libm::exp;
        exp_m1 libm::expm1;
        ln libm::log;
        ln_1p libm::log1p;
        tanh libm::tanh;
        atanh libm::atanh;
    }

    fn sin_cos(&self) -> (Self, Self) {
        libm::sincos(*self)
    }

    fn atan2(&self, x: &Self) -> Self {
        libm::atan2(*self, *x)
    }

    fn sinh_cosh(&self) -> (Self, Self) {
        (libm::sinh(*self), libm::cosh(*self))
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
        libm::pow(*self, *y)
    }
}
