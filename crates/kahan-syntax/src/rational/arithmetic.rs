//! Computes sums, products, quotients and powers of rationals.
//!
//! Small operands stay in machine integers; a result beyond 63 bits becomes a big integer. Sums of
//! small operands follow Knuth (The Art of Computer Programming, 4.5.1).

use std::ops::{Add, Mul, Neg, Sub};

use num_rational::BigRational;
use num_traits::Pow;

use super::{Rational, Repr, gcd};

impl Rational {
    /// Returns the quotient; `None` if `divisor` is 0.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_one() {
            return Some(self.clone());
        }
        Some(self * &divisor.recip()?)
    }

    /// Returns the reciprocal; `None` if the number is 0.
    pub fn recip(&self) -> Option<Self> {
        match &self.0 {
            Repr::Small { num: 0, .. } => None,
            Repr::Small { num, den } if *num > 0 => Some(Self(Repr::Small { num: *den, den: *num })),
            Repr::Small { num, den } => Some(Self(Repr::Small { num: -den, den: -num })),
            Repr::Big(big) => Some(Self::from_normal(big.recip())),
        }
    }

    /// Returns the power, where 0⁰ is 1; `None` for a negative power of 0.
    pub fn pow(&self, exponent: i32) -> Option<Self> {
        let base = if exponent < 0 { self.recip()? } else { self.clone() };
        let exponent = exponent.unsigned_abs();
        if let Repr::Small { num, den } = base.0
            && let (Some(num), Some(den)) = (num.checked_pow(exponent), den.checked_pow(exponent))
        {
            return Some(Self::from_reduced(i128::from(num), i128::from(den)));
        }
        // Powers of coprime numbers are coprime, so the new fraction needs no gcd.
        let (num, den) = (Pow::pow(base.numerator(), exponent), Pow::pow(base.denominator(), exponent));
        Some(Self::from_normal(BigRational::new_raw(num, den)))
    }

    /// Returns the absolute value.
    pub fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// Returns the largest g > 0 for which both numbers divided by g are integers. The gcd of 0 and
    /// b is |b|.
    pub fn gcd(&self, other: &Self) -> Self {
        if let (Repr::Small { num: a, den: b }, Repr::Small { num: c, den: d }) = (&self.0, &other.0) {
            let num = gcd(a.unsigned_abs(), c.unsigned_abs());
            let den = if b == d {
                i128::from(*b)
            } else {
                i128::from(*b) / i128::from(gcd(*b as u64, *d as u64)) * i128::from(*d)
            };
            // The fraction gcd(a, c)/lcm(b, d) is in lowest terms, because a prime factor of b does
            // not divide a, and a prime factor of d does not divide c.
            return Self::from_reduced(i128::from(num), den);
        }
        let num = num_integer::Integer::gcd(&self.numerator(), &other.numerator());
        let den = num_integer::Integer::lcm(&self.denominator(), &other.denominator());
        Self::from_normal(BigRational::new_raw(num, den))
    }
}

fn add_small(a: i64, b: i64, c: i64, d: i64) -> Rational {
    if b == 1 && d == 1 {
        return Rational::from_reduced(i128::from(a) + i128::from(c), 1);
    }
    if (b as u64).is_power_of_two() && (d as u64).is_power_of_two() {
        // Both denominators are powers of two, so the larger one is the common denominator.
        let (den, (a, c)) = (b.max(d), (i128::from(a), i128::from(c)));
        let num = (a << (den / b).trailing_zeros()) + (c << (den / d).trailing_zeros());
        let cancels = num.trailing_zeros().min(den.trailing_zeros());
        return Rational::from_reduced(num >> cancels, i128::from(den >> cancels));
    }
    let common = gcd(b as u64, d as u64) as i64;
    if common == 1 {
        let num = i128::from(a) * i128::from(d) + i128::from(c) * i128::from(b);
        return Rational::from_reduced(num, i128::from(b) * i128::from(d));
    }
    let num = i128::from(a) * i128::from(d / common) + i128::from(c) * i128::from(b / common);
    // A common divisor of `num` and lcm(b, d) divides `common`, which is gcd(b, d).
    let cancels = gcd((num % i128::from(common)).unsigned_abs() as u64, common as u64) as i64;
    Rational::from_reduced(num / i128::from(cancels), i128::from(b / common) * i128::from(d / cancels))
}

fn mul_small(a: i64, b: i64, c: i64, d: i64) -> Rational {
    if a == 0 || c == 0 {
        return Rational::ZERO;
    }
    let (mut a, mut b, mut c, mut d) = (a, b, c, d);
    if d != 1 {
        let common = gcd(d as u64, a.unsigned_abs()) as i64;
        (a, d) = (a / common, d / common);
    }
    if b != 1 {
        let common = gcd(b as u64, c.unsigned_abs()) as i64;
        (c, b) = (c / common, b / common);
    }
    Rational::from_reduced(i128::from(a) * i128::from(c), i128::from(b) * i128::from(d))
}

impl Add for &Rational {
    type Output = Rational;

    fn add(self, other: &Rational) -> Rational {
        match (&self.0, &other.0) {
            (Repr::Small { num: a, den: b }, Repr::Small { num: c, den: d }) => add_small(*a, *b, *c, *d),
            _ => Rational::from_normal(self.to_big() + other.to_big()),
        }
    }
}

impl Sub for &Rational {
    type Output = Rational;

    fn sub(self, other: &Rational) -> Rational {
        match (&self.0, &other.0) {
            (Repr::Small { num: a, den: b }, Repr::Small { num: c, den: d }) => add_small(*a, *b, -*c, *d),
            _ => Rational::from_normal(self.to_big() - other.to_big()),
        }
    }
}

impl Mul for &Rational {
    type Output = Rational;

    fn mul(self, other: &Rational) -> Rational {
        match (&self.0, &other.0) {
            (Repr::Small { num: a, den: b }, Repr::Small { num: c, den: d }) => mul_small(*a, *b, *c, *d),
            _ if self.is_integer() && other.is_integer() => {
                Rational::from(self.numerator() * other.numerator())
            }
            _ => Rational::from_normal(self.to_big() * other.to_big()),
        }
    }
}

impl Neg for &Rational {
    type Output = Rational;

    fn neg(self) -> Rational {
        match &self.0 {
            Repr::Small { num, den } => Rational(Repr::Small { num: -num, den: *den }),
            Repr::Big(big) => Rational::from_normal(-&**big),
        }
    }
}

impl Neg for Rational {
    type Output = Self;

    fn neg(self) -> Self {
        -&self
    }
}

macro_rules! forward_by_value {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Rational {
            type Output = Rational;

            fn $method(self, other: Rational) -> Rational {
                $operator::$method(&self, &other)
            }
        }

        impl $operator<&Rational> for Rational {
            type Output = Rational;

            fn $method(self, other: &Rational) -> Rational {
                $operator::$method(&self, other)
            }
        }
    )*};
}
forward_by_value!(Add add, Sub sub, Mul mul);

impl kahan_program::ExactConstant for Rational {
    fn one() -> Self {
        Rational::one()
    }

    fn is(&self, n: i64) -> bool {
        self.as_i64() == Some(n)
    }

    fn is_negative(&self) -> bool {
        Rational::is_negative(self)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn quotient(&self, divisor: &Self) -> Option<Self> {
        self.checked_div(divisor)
    }
}
