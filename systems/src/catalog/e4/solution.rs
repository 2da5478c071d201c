//! Orbits of the map of E4 by Jacobi's elliptic functions, on two real branches.

use kahan_core::nalgebra::SVector;

use super::normal_form::{NormalForm, Symmetry};
use crate::solution::{Branch, OutOfDomain, alternating, require};
use crate::special::{Jacobi, Modulus, Real, jacobi};

/// An orbit of the map of E4 (Hone and Petrera, Theorem 3, i = 4). With v = 2δn + κ, the modulus k,
/// s = x + y and d = x − y, the point after n steps is
///
/// * on the inner branch, |εz| < 1: s = sn δ dn v/(ε cn δ), d = k sn δ cn v/(ε dn δ), z = k sn δ
///   sn v/ε;
/// * on the outer branch, |εz| > 1 (not in the paper): s = (−1)ⁿ cn v/(ε dn δ sn v), d = (−1)ⁿ dn
///   v/(ε k cn δ sn v), z = 1/(ε k sn δ sn v).
///
/// The map's symmetries, which change signs of x and y or map (x, y, z) to (y, x, −z), give the
/// other orbits. The formula has xy > 0 on the inner branch, and xy < 0 on the outer branch. If xy
/// = 0, k is 1 and the functions are hyperbolic. Orbits that contain a fixed point (0, 0, z) or a
/// point with |εz| = 1 are excluded.
///
/// In `f64` the error is at most 6 ulp of the point's norm, multiplied by the condition number (1 +
/// |v|) max(1, |ε|r), where r is this norm. On the inner branch with xy > 0, the integrals are
///
/// Ĥ = (1 − k²) sn² δ/(2ε²[2 − (1 + k²) sn² δ]), K̂ = (1/ε²)(1/2 − cn² δ dn² δ/(cn² δ + dn² δ)).
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// Half the time step, ε.
    pub eps: T,
    /// The constant δ in v = 2δn + κ, which has the sign of ε, with |δ| below the quarter period.
    pub delta: T,
    /// The constant κ in v = 2δn + κ.
    pub kappa: T,
    /// The modulus k, where 0 ≤ k ≤ 1.
    pub modulus: Modulus<T>,
    /// The symmetry that maps the point of the formula to the point of the orbit.
    pub symmetry: Symmetry,
    /// The branch: inner if |εz| < 1, outer if |εz| > 1.
    pub branch: Branch,
    /// The values of sn, cn and dn at δ, computed algebraically.
    advance: Jacobi<T>,
}

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0. Fails if ε = 0, if x² + y² = 0 (a fixed point)
    /// or if ε²z² = 1 (det A = 0, or the next point is fixed).
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        require(!eps.is_zero(), "eps != 0")?;
        require(!(point[0].is_zero() && point[1].is_zero()), "x^2 + y^2 > 0")?;
        let scaled = *eps * point[2];
        let inner = (T::one() - scaled) * (T::one() + scaled);
        require(!inner.is_zero(), "eps^2 z^2 != 1")?;
        Ok(if inner.is_positive() {
            Self::inner(NormalForm::same_signs(point), eps, &inner)
        } else {
            Self::outer(NormalForm::opposite_signs(point, eps), eps, &-inner)
        })
    }

    fn inner((form, symmetry): (NormalForm<T>, Symmetry), eps: &T, width: &T) -> Self {
        let Squares { sum, difference, wide, narrow } = Squares::of(&form, eps);
        let modulus = modulus(&form, eps, width);
        // With s = x + y and d = x − y, sn²δ = ε²(s² + z²)/(1 + ε²s²), cn²δ = (1 − ε²z²)/(1 + ε²s²)
        // and dn²δ = (1 − ε²z²)/(1 + ε²d²).
        let advance = Jacobi {
            sn: *eps * (wide / sum).sqrt(),
            cn: (*width / sum).sqrt(),
            dn: (*width / difference).sqrt(),
        };
        // With d = x − y, (k sn δ)² = ε²(d² + z²)/(1 + ε²d²), so (sn κ, cn κ) = (z √(1 + ε²d²), d
        // √(1 − ε²z²))/√(d² + z²).
        let kappa = if narrow.is_zero() {
            T::zero()
        } else {
            let size = narrow.sqrt();
            let sn = form.height * difference.sqrt() / size;
            modulus.inverse(&sn, &(form.difference * width.sqrt() / size))
        };
        let delta = modulus.inverse(&advance.sn, &advance.cn);
        Self { eps: *eps, delta, kappa, modulus, symmetry, branch: Branch::Inner, advance }
    }

    fn outer((form, symmetry): (NormalForm<T>, Symmetry), eps: &T, width: &T) -> Self {
        let Squares { sum, difference, wide, narrow } = Squares::of(&form, eps);
        let modulus = modulus(&form, eps, width);
        let over = |top: &T, bottom: T| (*top / bottom).sqrt() / *eps;
        // With s = x + y, d = x − y and q = ε²(d² + z²): sn²δ = (1 + ε²d²)/q, cn²δ = (ε²z² − 1)/q,
        // and dn²δ = (ε²z² − 1)/(ε²(s² + z²)).
        let advance = Jacobi {
            sn: over(&difference, narrow),
            cn: over(width, narrow).abs(),
            dn: over(width, wide).abs(),
        };
        // With s = x + y: sn κ = 1/(ε k sn δ z) = √(s² + z²)/(z √(1 + ε²s²)), cn κ = ε s dn δ sn κ.
        let sn = (wide / sum).sqrt() / form.height;
        let cn = *eps * form.sum * advance.dn * sn;
        let kappa = modulus.inverse(&sn, &cn);
        let delta = modulus.inverse(&advance.sn, &advance.cn);
        Self { eps: *eps, delta, kappa, modulus, symmetry, branch: Branch::Outer, advance }
    }

    /// Returns the point after n steps; n may be negative. The point is not finite at a pole.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let Self { eps, delta, kappa, modulus, symmetry, branch, advance } = self;
        let k = modulus.k;
        let Jacobi { sn, cn, dn } = jacobi(&(T::from_int(2 * n) * *delta + *kappa), modulus);
        let (sum, difference, height) = match branch {
            Branch::Inner => {
                (advance.sn / advance.cn * dn, k * advance.sn / advance.dn * cn, k * advance.sn * sn)
            }
            Branch::Outer => {
                let sign = alternating::<T>(n);
                (
                    sign * cn / (advance.dn * sn),
                    sign * dn / (k * advance.cn * sn),
                    T::one() / (k * advance.sn * sn),
                )
            }
        };
        symmetry.point(sum / *eps, difference / *eps, height / *eps)
    }
}

/// Positive expressions from which all parameters of an orbit are computed.
struct Squares<T> {
    /// The value 1 + ε²s² with s = x + y.
    sum: T,
    /// The value 1 + ε²d² with d = x − y.
    difference: T,
    /// The value s² + z² with s = x + y.
    wide: T,
    /// The value d² + z² with d = x − y.
    narrow: T,
}

impl<T: Real> Squares<T> {
    fn of(form: &NormalForm<T>, eps: &T) -> Self {
        let (s, d, z) = (form.sum.square(), form.difference.square(), form.height.square());
        Self {
            sum: T::one() + eps.square() * s,
            difference: T::one() + eps.square() * d,
            wide: s + z,
            narrow: d + z,
        }
    }
}

/// Returns the modulus k from k² = (d² + z²)(1 + ε²s²)/((s² + z²)(1 + ε²d²)) and 1 − k² = 4|xy| |1
/// − ε²z²|/((s² + z²)(1 + ε²d²)), where s = x + y and d = x − y.
fn modulus<T: Real>(form: &NormalForm<T>, eps: &T, width: &T) -> Modulus<T> {
    let Squares { sum, difference, wide, narrow } = Squares::of(form, eps);
    let divisor = wide * difference;
    Modulus::from_squares(&(narrow * sum / divisor), &(T::from_int(4) * form.product * *width / divisor))
}
