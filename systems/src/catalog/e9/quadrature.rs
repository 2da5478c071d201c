//! The trajectories of E9 for any ξ, as time by a quadrature; the sphere that they lie on and its
//! fixed points.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::{Real, integrate};

/// The radius √(2K₉) = √(x² + y² + z²) of the sphere that a trajectory of E9 stays on, for every ξ.
pub fn sphere_radius<T: Real>(point: &SVector<T, 3>) -> T {
    let [x, y, z] = (*point).into();
    (x.square() + y.square() + z.square()).sqrt()
}

/// The fixed points of E9 with this ξ on the sphere of this radius: (0, 0, ±r), and for ξ < 0 also
/// the four points (±a√(−ξ), ±a, 0) with a² (1 − ξ) = r². (For ξ = 0 every (0, y, z) is fixed; only
/// the first two are listed.)
pub fn fixed_points<T: Real>(xi: &T, radius: &T) -> Vec<SVector<T, 3>> {
    let zero = T::zero;
    let mut points = vec![vector![zero(), zero(), *radius], vector![zero(), zero(), -*radius]];
    if xi.is_negative() {
        let y = *radius / (T::one() - *xi).sqrt();
        let x = (-*xi).sqrt() * y;
        for (x, y) in [(x, y), (x, -y), (-x, y), (-x, -y)] {
            points.push(vector![x, y, zero()]);
        }
    }
    points
}

/// A trajectory of E9 in the quarter x > 0, y > 0 by its quadrature (section 6.3 with erratum A8):
/// with c = H₉ = y x^(−ξ) and r² = 2K₉ = x² + y² + z²,
///
/// dt = ∓dx/(x √(r² − x² − c²x^{2ξ})), y = c x^ξ, z = ±√(r² − x² − c²x^{2ξ}).
///
/// x → −x and y → −y are symmetries. For ξ > 0 the trajectory joins the fixed points (0, 0, ∓r) and
/// has one turning point z = 0, the largest x; for ξ < 0 it is closed and has two.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadrature<T> {
    /// ξ, the parameter of the system.
    pub xi: T,
    /// r, the radius of the sphere.
    pub radius: T,
    /// c, the value of H₉ = y x^(−ξ).
    pub c: T,
    /// The largest x, at which z = 0.
    pub largest: T,
    /// The smallest x, at which z = 0, for ξ < 0.
    pub smallest: Option<T>,
}

impl<T: Real> Quadrature<T> {
    /// The trajectory of E9 with this ξ through this point.
    ///
    /// # Errors
    /// Unless x > 0, y > 0 and ξ ≠ 0, and for ξ < 0 the point is not the fixed point.
    pub fn through(xi: &T, point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, _] = (*point).into();
        require(x.is_positive() && y.is_positive(), "x > 0 and y > 0")?;
        require(!xi.is_zero(), "xi != 0")?;
        let radius = sphere_radius(point);
        let c = y * x.power_real(&-*xi);
        let turning = Turning { xi, radius: &radius, c: &c };
        if xi.is_positive() {
            // z² falls in x from x > 0 on: the point itself is on the left, r on the right of its
            // zero.
            let largest = turning.zero(x, radius);
            return Ok(Self { xi: *xi, largest, smallest: None, radius, c });
        }
        // The middle, where x² + c²x^{2ξ} is least: x^{2−2ξ} = −ξc²; both zeros lie beyond, at most
        // r away and at least where c²x^{2ξ} = r².
        let base = (-*xi) * c.square();
        let middle = base.power_real(&(T::half() / (T::one() - *xi)));
        require(turning.height_square(&middle).is_positive(), "not a fixed point")?;
        let least = (radius / c).power_real(&(T::one() / *xi));
        let smallest = turning.zero(middle, least);
        let largest = turning.zero(middle, radius);
        Ok(Self { xi: *xi, largest, smallest: Some(smallest), radius, c })
    }

    /// The point of the trajectory with this x, on the side z ≥ 0; not a number where x is beyond a
    /// turning point.
    pub fn point(&self, x: &T) -> SVector<T, 3> {
        let turning = Turning { xi: &self.xi, radius: &self.radius, c: &self.c };
        let y = self.c * x.power_real(&self.xi);
        vector![*x, y, turning.height_square(x).sqrt()]
    }

    /// The time from the turning point of the largest x to this x, on the side z > 0 where x falls;
    /// not a number for x beyond a turning point, infinite in the limit x → 0 for ξ > 0.
    ///
    /// With x = x_max e^(−s²) the integrand is analytic, and z² a difference of exponentials less
    /// one that loses no digits near the turning point. Beside a fixed point at ξ < 0, where z² is
    /// small throughout, the relative error is about that of the rounding of r² divided by z².
    pub fn time_from_largest(&self, x: &T) -> T {
        self.time_from(&self.largest, x, -T::one())
    }

    /// The period of a closed trajectory; none for ξ > 0.
    pub fn period(&self) -> Option<T> {
        let smallest = self.smallest.as_ref()?;
        // Each half by its own turning point, so that neither integrand meets the other's
        // singularity.
        let middle = (self.largest * *smallest).sqrt();
        let from_smallest = self.time_from(smallest, &middle, T::one());
        Some(T::from_int(2) * (self.time_from_largest(&middle) + from_smallest))
    }

    /// ∫ dx/(xz) from a turning point x* to x = x* e^(σS²), as ∫₀^S 2s ds/z with
    /// z² = −x*²(e^{2σs²} − 1) − c²x*^{2ξ}(e^{2ξσs²} − 1).
    fn time_from(&self, turning: &T, x: &T, sigma: T) -> T {
        let two = T::from_int(2);
        let end = (sigma * (*x / *turning).ln()).sqrt();
        let square = turning.square();
        let other = (self.c * turning.power_real(&self.xi)).square();
        integrate(&T::zero(), &end, |s| {
            let exponent = two * sigma * s.square();
            let height_square = -(square * exponent.exp_m1()) - other * (self.xi * exponent).exp_m1();
            two * *s / height_square.sqrt()
        })
        .value
    }
}

/// z² = r² − x² − c²x^{2ξ} as a function of x.
struct Turning<'a, T> {
    xi: &'a T,
    radius: &'a T,
    c: &'a T,
}

impl<T: Real> Turning<'_, T> {
    fn height_square(&self, x: &T) -> T {
        let y = *self.c * x.power_real(self.xi);
        self.radius.square() - x.square() - y.square()
    }

    /// The zero of z² between a point where it is not negative and one where it is not positive, by
    /// Newton's method kept inside by bisection.
    fn zero(&self, inside: T, outside: T) -> T {
        let (mut inside, mut outside) = (inside, outside);
        let mut x = (inside + outside) * T::half();
        for _ in 0..400 {
            let value = self.height_square(&x);
            if value.is_negative() {
                outside = x;
            } else {
                inside = x;
            }
            let y = *self.c * x.power_real(self.xi);
            let slope = -(T::from_int(2) * (x + *self.xi * y.square() / x));
            let newton = x - value / slope;
            let between = (newton > inside && newton < outside) || (newton < inside && newton > outside);
            let next = if between { newton } else { (inside + outside) * T::half() };
            let done = (next - x).abs() <= T::epsilon() * x.abs();
            x = next;
            if done {
                break;
            }
        }
        x
    }
}
