//! Proves at exact points over ℚ(√3) that E6 and E4 are one system in two coordinate systems.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use kahan_core::Constant;
use kahan_core::num_traits::{One, Zero};
use kahan_core::prelude::*;
use kahan_systems::{E4, E6};

use crate::solutions::exact_orbits::{Point, Rational, cases, rational};

#[derive(Clone, Debug, PartialEq)]
struct RootThree {
    a: Rational,
    b: Rational,
}

fn plain(a: Rational) -> RootThree {
    RootThree { a, b: Rational::zero() }
}

impl Add for RootThree {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { a: self.a + other.a, b: self.b + other.b }
    }
}

impl Neg for RootThree {
    type Output = Self;

    fn neg(self) -> Self {
        Self { a: -self.a, b: -self.b }
    }
}

impl Sub for RootThree {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { a: self.a - other.a, b: self.b - other.b }
    }
}

impl Mul for RootThree {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let a = &self.a * &other.a + rational("3") * &self.b * &other.b;
        Self { a, b: self.a * other.b + self.b * other.a }
    }
}

impl Div for RootThree {
    type Output = Self;

    // 1/(a + b√3) = (a − b√3)/(a² − 3b²)
    fn div(self, other: Self) -> Self {
        let norm = &other.a * &other.a - rational("3") * &other.b * &other.b;
        let product = self * Self { a: other.a, b: -other.b };
        Self { a: product.a / &norm, b: product.b / norm }
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt),*) => {$(
        impl $trait for RootThree {
            fn $method(&mut self, other: Self) {
                *self = self.clone() $operator other;
            }
        }
    )*};
}

assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl Zero for RootThree {
    fn zero() -> Self {
        plain(Rational::zero())
    }

    fn is_zero(&self) -> bool {
        self.a.is_zero() && self.b.is_zero()
    }
}

impl One for RootThree {
    fn one() -> Self {
        plain(Rational::one())
    }
}

impl Scalar for RootThree {
    fn constant(c: &Constant<'_>) -> Self {
        plain(c.to_ratio())
    }
}

/// Maps (x, y, z) of E6 to (X, Y, Z) of E4 with (X − Y, X + Y, Z) = (√3 y, √3 (x − z), x + z).
fn to_e4(point: &Point<RootThree>) -> Point<RootThree> {
    let [x, y, z] = point.clone().into();
    let half_root = RootThree { a: Rational::zero(), b: rational("1/2") };
    let difference = half_root.clone() * y;
    let sum = half_root * (x.clone() - z.clone());
    vector![sum.clone() + difference.clone(), sum - difference, x + z]
}

#[test]
fn e6_is_e4_with_reversed_time_after_a_swap_and_a_scaling() {
    for case in cases("e6") {
        let point = case.start.map(plain);
        let left = to_e4(&E6.step(&point, plain(case.eps.clone())));
        assert_eq!(left, E4.step(&to_e4(&point), plain(-case.eps)));
        assert_eq!(to_e4(&E6.field(&point)), -E4.field(&to_e4(&point)));
    }
}
