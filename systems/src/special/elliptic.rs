//! The elliptic modulus with its complement, and the elliptic integrals of the first kind.

use super::Real;
use super::gamma::not_a_number;

/// A modulus k with 0 ≤ k ≤ 1 and its complement k′ = √(1 − k²), both to full relative precision.
///
/// A modulus close to 1 determines k′ badly, so formulas that know both should give both.
#[derive(Clone, Debug, PartialEq)]
pub struct Modulus<T> {
    /// k, the argument of sn(u, k), and not its square.
    pub k: T,
    /// k′ = √(1 − k²).
    pub complement: T,
}

impl<T: Real> Modulus<T> {
    /// From k alone, 0 ≤ k ≤ 1; its complement is not a number elsewhere.
    pub fn new(k: T) -> Self {
        let complement = ((T::one() - k) * (T::one() + k)).sqrt();
        Self { k, complement }
    }

    /// From k² and 1 − k², each computed without cancellation.
    pub fn from_squares(square: &T, complement_square: &T) -> Self {
        Self { k: square.sqrt(), complement: complement_square.sqrt() }
    }

    /// The modulus k′, with the complement k.
    pub fn complementary(&self) -> Self {
        Self { k: self.complement, complement: self.k }
    }

    /// The complete integral K(k) = F(π/2, k), the quarter of the period of sn; not a number at k =
    /// 1.
    ///
    /// K = π/(2 agm(1, k′)). In `f64` at most 4 ulp for every k, also next to k = 1, where formulas
    /// in k² lose their digits.
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

    /// The nome q = exp(−π K(k′)/K(k)), for 0 ≤ k < 1.
    ///
    /// By the two complete integrals; near k = 0 its relative error grows like ln(1/q) units.
    pub fn nome(&self) -> T {
        if self.k.is_zero() {
            return T::zero();
        }
        let complementary = self.complementary();
        (-(T::pi() * complementary.quarter_period() / self.quarter_period())).exp()
    }

    /// The incomplete integral F(φ, k) = ∫₀^φ dθ/√(1 − k² sin²θ), for any real φ (|φ| < π/2 at k =
    /// 1).
    ///
    /// By Carlson's R_F(cos²φ, 1 − k² sin²φ, 1) sin φ, after whole half turns are taken off. In
    /// `f64` at most 6 ulp for |φ| ≤ π/2 and 8 for |φ| ≤ 50, also next to k = 1.
    fn incomplete(&self, phi: &T) -> T {
        let half_turns = (*phi / T::pi() + T::half()).floor();
        let (sine, cosine) = phi.sin_cos();
        // The sine and cosine of φ less the half turns: the cosine is not negative.
        let (sine, cosine) = if cosine.is_negative() { (-sine, -cosine) } else { (sine, cosine) };
        let whole = if half_turns.is_zero() {
            T::zero()
        } else {
            T::from_int(2) * half_turns * self.quarter_period()
        };
        whole + self.incomplete_of_point(&sine, &cosine)
    }

    /// F of the angle of the point (cos φ, sin φ) on the unit circle, in (−2K, 2K]: the inverse of
    /// the pair (sn, cn), which keeps the precision that an angle near ±π/2 would lose.
    pub fn inverse(&self, sn: &T, cn: &T) -> T {
        if cn.is_negative() {
            let rest = self.incomplete_of_point(&sn.abs(), &-*cn);
            let value = T::from_int(2) * self.quarter_period() - rest;
            return if sn.is_negative() { -value } else { value };
        }
        self.incomplete_of_point(sn, cn)
    }

    /// F for a cosine that is not negative.
    fn incomplete_of_point(&self, sine: &T, cosine: &T) -> T {
        // 1 − k² sin²φ = cos²φ + k′² sin²φ, a sum of positive numbers.
        let delta = cosine.square() + (self.complement * *sine).square();
        *sine * carlson_rf(cosine.square(), delta, T::one())
    }
}

/// The incomplete elliptic integral F(φ, k) of the first kind, of the modulus k, 0 ≤ k < 1.
///
/// ```
/// use kahan_systems::special::elliptic_f;
///
/// assert_eq!(elliptic_f(&0.7, &0.0), 0.7);
/// ```
pub fn elliptic_f<T: Real>(phi: &T, k: &T) -> T {
    Modulus::new(*k).incomplete(phi)
}

/// The complete elliptic integral K(k) of the first kind, of the modulus k, 0 ≤ k < 1.
pub fn elliptic_k<T: Real>(k: &T) -> T {
    Modulus::new(*k).quarter_period()
}

/// The common limit of arithmetic and geometric means, for positive a and b.
fn arithmetic_geometric_mean<T: Real>(mut a: T, mut b: T) -> T {
    // Each turn squares the relative difference; once it is below √ε the next mean is exact to
    // rounding.
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

/// Carlson's symmetric integral R_F(x, y, z) = ½∫₀^∞ dt/√((t+x)(t+y)(t+z)), for nonnegative
/// arguments, at most one of them zero.
///
/// The duplication theorem brings the arguments together, where a series of degree 7 in their
/// spread finishes.
fn carlson_rf<T: Real>(mut x: T, mut y: T, mut z: T) -> T {
    let third = T::from_ratio(1, 3);
    let quarter = T::from_ratio(1, 4);
    // The neglected terms are of degree 8 in the spread.
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

/// The expansion of R_F about equal arguments, in E₂ = XY + YZ + ZX and E₃ = XYZ with X + Y + Z =
/// 0: up to degree 7.
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
