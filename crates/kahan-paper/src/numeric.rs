//! Evaluates formulas in 256-bit arithmetic, for identities beyond rational functions.

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::rational::Rational;
use kahan_core::Pivot;
use kahan_core::nalgebra::SVector;

use kahan_systems::special::{Float256, Modulus, Real, elliptic_f, elliptic_k, jacobi, theta};
use kahan_systems::{e7, e8};

use super::evaluate::{Calculus, EvaluationError};

/// Floating-point arithmetic with 256 bits.
pub(super) struct Arithmetic256;

impl Arithmetic for Arithmetic256 {
    type Value = Float256;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Float256> {
        Some(Real::from_rational(&value.to_big()))
    }

    fn add(&self, a: &Float256, b: &Float256) -> Float256 {
        *a + *b
    }

    fn subtract(&self, a: &Float256, b: &Float256) -> Float256 {
        *a - *b
    }

    fn multiply(&self, a: &Float256, b: &Float256) -> Float256 {
        *a * *b
    }

    fn negate(&self, a: &Float256) -> Float256 {
        -*a
    }

    fn divide(&self, a: &Float256, b: &Float256) -> Option<Float256> {
        (!self.is_zero(b)).then(|| *a / *b)
    }

    fn is_zero(&self, a: &Float256) -> bool {
        *a == Float256::from(0)
    }

    fn is_better_pivot(&self, a: &Float256, than: &Float256) -> bool {
        a.abs() > than.abs()
    }
}

impl Calculus for Arithmetic256 {
    fn function(&self, name: &str, arguments: &[Float256]) -> Result<Float256, EvaluationError> {
        let value = match (name, arguments) {
            ("pi", []) => Float256::pi(),
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
            ("coth", [u]) => Float256::from(1) / u.tanh(),
            ("sech", [u]) => Float256::from(1) / u.cosh(),
            ("atanh", [u]) => u.atanh(),
            ("atan2", [y, x]) => y.atan2(x),
            ("gamma", [u]) => u.gamma(),
            ("digamma", [u]) => u.digamma(),
            // The second integrals `K7` of dE7 and `K8` of dE8 are sums of series.
            ("K7", [x, y, z, eps, xi]) => {
                e7::integral_k(xi, &point([x, y, z]), eps).map_err(|_| EvaluationError::Undefined)?
            }
            ("K8", [x, y, z, eps]) => {
                e8::integral_k(&point([x, y, z]), eps).map_err(|_| EvaluationError::Undefined)?
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
            _ => return Err(EvaluationError::Unknown(name.to_owned())),
        };
        if value.is_finite_number() { Ok(value) } else { Err(EvaluationError::Undefined) }
    }

    fn power(&self, base: &Float256, exponent: &Float256) -> Result<Float256, EvaluationError> {
        let value = base.power_real(exponent);
        if value.is_finite_number() { Ok(value) } else { Err(EvaluationError::Undefined) }
    }
}

fn point(coordinates: [&Float256; 3]) -> SVector<Float256, 3> {
    SVector::from(coordinates.map(Clone::clone))
}
