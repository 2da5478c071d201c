//! The modulus of elliptic functions with its complement, and elliptic integrals of the first kind.

use super::Real;
use super::gamma::not_a_number;

/// A modulus k with 0 ≤ k ≤ 1 and its complement k′ = √(1 − k²), both with full relative precision.
#[derive(Clone, Debug, PartialEq)]
pub struct Modulus<T> {
    /// The modulus k in sn(u, k), not its square.
    pub k: T,
    /// The complement k′ = √(1 − k²).
    pub complement: T,
}

impl<T: Real> Modulus<T> {
    /// Makes a modulus from k, where 0 ≤ k ≤ 1. For other k the complement is NaN.
    pub fn new(k: T) -> Self {
        let complement = ((T::one() - k) * (T::one() + k)).sqrt();
        Self { k, complement }
    }

    /// Makes a modulus from k² and 1 − k². Each must be computed without cancellation.
    pub fn from_squares(square: &T, complement_square: &T) -> Self {
        Self { k: square.sqrt(), complement: complement_square.sqrt() }
    }

    /// Returns the modulus in which k and k′ are exchanged.
    pub fn complementary(&self) -> Self {
        Self { k: self.complement, complement: self.k }
    }

    /// Returns the complete integral K(k) = F(π/2, k) = π/(2 agm(1, k′)), a quarter of sn's period,
    /// or NaN for k = 1. In `f64` the error is at most 4 ulp, even near k = 1.
    ///
    /// ```
    /// use kahan_systems::special::Modulus;
    ///
    /// assert_eq!(Modulus::new(0.0).quarter_period(), core::f64::consts::FRAC_PI_2);
    /// ```
    pub fn quarter_period(&self) -> T {
        if !self.complement.is_positive() {
            return not_a_number();
        }
        T::pi() * T::half() / arithmetic_geometric_mean(T::one(), self.complement)
    }

    /// Returns the nome q = exp(−π K(k′)/K(k)), for 0 ≤ k < 1. Near k = 0 the relative error grows
    /// like ln(1/q).
    pub fn nome(&self) -> T {
        if self.k.is_zero() {
            return T::zero();
        }
        let complementary = self.complementary();
        (-(T::pi() * complementary.quarter_period() / self.quarter_period())).exp()
    }

    /// Returns the incomplete integral F(φ, k) = ∫₀^φ dθ/√(1 − k² sin²θ) for any real φ. For k = 1,
    /// φ must lie between −π/2 and π/2. In `f64` the error is at most 6 ulp for |φ| ≤ π/2 and 8 ulp
    /// for |φ| ≤ 50, even near k = 1.
    fn incomplete(&self, phi: &T) -> T {
        let half_turns = (*phi / T::pi() + T::half()).floor();
        let (sine, cosine) = phi.sin_cos();
        let (sine, cosine) = if cosine.is_negative() { (-sine, -cosine) } else { (sine, cosine) };
        let whole = if half_turns.is_zero() {
            T::zero()
        } else {
            T::from_int(2) * half_turns * self.quarter_period()
        };
        whole + self.incomplete_of_point(&sine, &cosine)
    }

    /// Returns the u in (−2K, 2K] that has these values of sn u and cn u. Near ±K, sn u alone does
    /// not determine u precisely.
    pub fn inverse(&self, sn: &T, cn: &T) -> T {
        if cn.is_negative() {
            let rest = self.incomplete_of_point(&sn.abs(), &-*cn);
            let value = T::from_int(2) * self.quarter_period() - rest;
            return if sn.is_negative() { -value } else { value };
        }
        self.incomplete_of_point(sn, cn)
    }

    /// Returns F(φ, k), given the sine and the nonnegative cosine of φ.
    fn incomplete_of_point(&self, sine: &T, cosine: &T) -> T {
        // This is 1 − k² sin²φ as a sum of nonnegative numbers.
        let delta = cosine.square() + (self.complement * *sine).square();
        *sine * carlson_rf(cosine.square(), delta, T::one())
    }
}

/// Returns the incomplete elliptic integral F(φ, k) of the first kind, for a modulus 0 ≤ k < 1.
///
/// ```
/// use kahan_systems::special::elliptic_f;
///
/// assert_eq!(elliptic_f(&0.7, &0.0), 0.7);
/// ```
pub fn elliptic_f<T: Real>(phi: &T, k: &T) -> T {
    Modulus::new(*k).incomplete(phi)
}

/// Returns the complete elliptic integral K(k) of the first kind, for a modulus 0 ≤ k < 1.
pub fn elliptic_k<T: Real>(k: &T) -> T {
    Modulus::new(*k).quarter_period()
}

/// Returns the arithmetic-geometric mean of a and b, which must be positive.
fn arithmetic_geometric_mean<T: Real>(mut a: T, mut b: T) -> T {
    // Each pass squares the relative difference of a and b.
    for _ in 0..64 {
        let done = ((a - b) / a).square() < T::epsilon();
        let mean = (a + b) * T::half();
        if done {
            return mean;
        }
        b = (a * b).sqrt();
        a = mean;
    }
    a
}

/// Returns Carlson's integral R_F(x, y, z) = ½∫₀^∞ dt/√((t+x)(t+y)(t+z)), by the duplication
/// theorem. The arguments must be nonnegative, and at most one may be zero.
fn carlson_rf<T: Real>(mut x: T, mut y: T, mut z: T) -> T {
    let third = T::from_ratio(1, 3);
    let quarter = T::from_ratio(1, 4);
    // Below `bound`, the neglected terms of degree 8 in `spreads` are smaller than rounding errors.
    let bound = T::epsilon().sqrt().sqrt().sqrt() * quarter;
    loop {
        let mean = (x + y + z) * third;
        let spreads = [x, y, z].map(|v| T::one() - v / mean);
        if !spreads.iter().any(|spread| spread.abs() > bound) {
            return rf_series(spreads) / mean.sqrt();
        }
        let [rx, ry, rz] = [x, y, z].map(|v| v.sqrt());
        let lambda = rx * ry + ry * rz + rz * rx;
        [x, y, z] = [x, y, z].map(|v| (v + lambda) * quarter);
    }
}

/// Returns √μ·R_F, expanded to degree 7 in the relative differences X, Y, Z of the arguments from
/// their mean μ. Here X + Y + Z = 0, E₂ = XY + YZ + ZX and E₃ = XYZ.
fn rf_series<T: Real>([dx, dy, dz]: [T; 3]) -> T {
    let e2 = dx * dy - dz.square();
    let e3 = dx * dy * dz;
    let c = |p, q| T::from_ratio(p, q);
    T::one() - c(1, 10) * e2 + c(1, 14) * e3 + c(1, 24) * e2.square()
        - c(3, 44) * e2 * e3
        - c(5, 208) * e2.power(3)
        + c(3, 104) * e3.square()
        + c(1, 16) * e2.square() * e3
}
