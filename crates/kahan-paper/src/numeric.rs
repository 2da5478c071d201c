//! Formulas in 256-bit arithmetic, for identities beyond rational functions.

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::rational::Rational;
use kahan_core::Pivot;
use kahan_core::nalgebra::SVector;

use kahan_systems::special::{Modulus, Precise, Real, elliptic_f, elliptic_k, jacobi, theta};
use kahan_systems::{e7, e8};

use super::evaluate::{Calculus, Trouble};

/// 256-bit floating point, 77 decimal digits.
pub(super) struct Decimals;

impl Arithmetic for Decimals {
    type Value = Precise;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Precise> {
        Some(Real::from_rational(&value.to_big()))
    }

    fn add(&self, a: &Precise, b: &Precise) -> Precise {
        *a + *b
    }

    fn subtract(&self, a: &Precise, b: &Precise) -> Precise {
        *a - *b
    }

    fn multiply(&self, a: &Precise, b: &Precise) -> Precise {
        *a * *b
    }

    fn negate(&self, a: &Precise) -> Precise {
        -*a
    }

    fn divide(&self, a: &Precise, b: &Precise) -> Option<Precise> {
        (!self.is_zero(b)).then(|| *a / *b)
    }

    fn is_zero(&self, a: &Precise) -> bool {
        *a == Precise::from(0)
    }

    fn is_better_pivot(&self, a: &Precise, than: &Precise) -> bool {
        a.abs() > than.abs()
    }
}

impl Calculus for Decimals {
    fn function(&self, name: &str, arguments: &[Precise]) -> Result<Precise, Trouble> {
        let value = match (name, arguments) {
            ("pi", []) => Precise::pi(),
            ("abs", [u]) => u.abs(),
            ("sqrt", [u]) => u.sqrt(),
            ("exp", [u]) => u.exp(),
            ("log", [u]) => u.ln(),
            ("sin", [u]) => u.sin(),
            ("cos", [u]) => u.cos(),
            ("tan", [u]) => u.sin() / u.cos(),
            ("sinh", [u]) => u.sinh(),
            ("cosh", [u]) => u.cosh(),
            ("tanh", [u]) => u.tanh(),
            ("coth", [u]) => Precise::from(1) / u.tanh(),
            ("sech", [u]) => Precise::from(1) / u.cosh(),
            ("atanh", [u]) => u.atanh(),
            ("atan2", [y, x]) => y.atan2(x),
            ("gamma", [u]) => u.gamma(),
            ("digamma", [u]) => u.digamma(),
            // The second integrals of dE7 and dE8, which are series.
            ("K7", [x, y, z, eps, xi]) => {
                e7::integral_k(xi, &point([x, y, z]), eps).map_err(|_| Trouble::Undefined)?
            }
            ("K8", [x, y, z, eps]) => {
                e8::integral_k(&point([x, y, z]), eps).map_err(|_| Trouble::Undefined)?
            }
            ("K", [k]) => elliptic_k(k),
            ("F", [phi, k]) => elliptic_f(phi, k),
            ("nome", [k]) => Modulus::new(*k).nome(),
            ("sn", [u, k]) => jacobi(u, &Modulus::new(*k)).sn,
            ("cn", [u, k]) => jacobi(u, &Modulus::new(*k)).cn,
            ("dn", [u, k]) => jacobi(u, &Modulus::new(*k)).dn,
            ("theta1", [z, q]) => theta(z, q).one,
            ("theta2", [z, q]) => theta(z, q).two,
            ("theta3", [z, q]) => theta(z, q).three,
            ("theta4", [z, q]) => theta(z, q).four,
            _ => return Err(Trouble::Unknown(name.to_owned())),
        };
        if value.is_finite_number() { Ok(value) } else { Err(Trouble::Undefined) }
    }

    fn power(&self, base: &Precise, exponent: &Precise) -> Result<Precise, Trouble> {
        let value = base.power_real(exponent);
        if value.is_finite_number() { Ok(value) } else { Err(Trouble::Undefined) }
    }
}

fn point(coordinates: [&Precise; 3]) -> SVector<Precise, 3> {
    SVector::from(coordinates.map(Clone::clone))
}
