//! Complex numbers as a scalar.
//!
//! A new type is necessary, because Rust forbids a foreign trait on a foreign type.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use kahan_core::num_traits::{One, Zero};
use kahan_core::{Constant, Scalar, nalgebra};

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Complex(pub(crate) nalgebra::Complex<f64>);

impl Scalar for Complex {
    fn constant(c: &Constant<'_>) -> Self {
        Self(c.to_f64().into())
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $assigns:ident),*) => {$(
        impl $operator for Complex {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }

        impl $assign for Complex {
            fn $assigns(&mut self, other: Self) {
                self.0.$assigns(other.0);
            }
        }
    )*};
}

operators!(Add add AddAssign add_assign, Sub sub SubAssign sub_assign);
operators!(Mul mul MulAssign mul_assign, Div div DivAssign div_assign);

impl Neg for Complex {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Complex {
    fn zero() -> Self {
        Self(0.0.into())
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl One for Complex {
    fn one() -> Self {
        Self(1.0.into())
    }
}
