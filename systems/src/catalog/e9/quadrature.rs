//! Fixed points of E9, and its trajectories with ξ ≠ 0 and x, y > 0, with the time as an integral.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::{Real, integrate};

/// Returns the radius √(2K₉) = √(x² + y² + z²) of the sphere that contains the trajectory.
pub fn sphere_radius<T: Real>(point: &SVector<T, 3>) -> T {
    let [x, y, z] = (*point).into();
    (x.square() + y.square() + z.square()).sqrt()
}

/// Returns the fixed points (0, 0, ±r) of E9 on the sphere of radius r. For ξ < 0, also returns the
/// four fixed points (±a√(−ξ), ±a, 0) with a²(1 − ξ) = r². For ξ = 0 every point (0, y, z) is
/// fixed, but only (0, 0, ±r) are returned.
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

/// A trajectory of E9 for x > 0 and y > 0, by a quadrature (Hone and Petrera, Section 6.3 with
/// erratum A8). With c = H₉ = y x^(−ξ) and r² = 2K₉ = x² + y² + z², the equations are
///
///   dt = ∓dx/(x √(r² − x² − c²x^{2ξ})), y = c x^ξ, z = ±√(r² − x² − c²x^{2ξ}).
///
/// For ξ > 0 the trajectory joins the fixed points (0, 0, ∓r), with one turning point z = 0 at the
/// largest x. For ξ < 0 the trajectory is closed and has two turning points. The symmetries x → −x
/// and y → −y give the trajectories in the other quadrants.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadrature<T> {
    /// The parameter ξ of the system.
    pub xi: T,
    /// The radius r of the sphere.
    pub radius: T,
    /// The value c of the integral H₉ = y x^(−ξ).
    pub c: T,
    /// The largest x on the trajectory, where z = 0.
    pub largest: T,
    /// For ξ < 0, the smallest x on the trajectory, where z = 0.
    pub smallest: Option<T>,
}

impl<T: Real> Quadrature<T> {
    /// Returns the trajectory through `point`. Fails at fixed points, and unless x > 0, y > 0 and
    /// ξ ≠ 0.
    pub fn through(xi: &T, point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, _] = (*point).into();
        require(x.is_positive() && y.is_positive(), "x > 0 and y > 0")?;
        require(!xi.is_zero(), "xi != 0")?;
        let radius = sphere_radius(point);
        let c = y * x.power_real(&-*xi);
        let turning = TurningFunction { xi, radius: &radius, c: &c };
        if xi.is_positive() {
            // For x > 0, z² decreases as x grows, and has a zero between the point's x and the
            // radius.
            let largest = turning.zero(x, radius);
            return Ok(Self { xi: *xi, largest, smallest: None, radius, c });
        }
        // The sum x² + c²x^{2ξ} is least at the x_m with x_m^{2−2ξ} = −ξc². One zero of z² lies
        // between x_m and the radius r. The other lies between x_m and the x with c²x^{2ξ} = r².
        let base = (-*xi) * c.square();
        let middle = base.power_real(&(T::half() / (T::one() - *xi)));
        require(turning.height_square(&middle).is_positive(), "not a fixed point")?;
        let least = (radius / c).power_real(&(T::one() / *xi));
        let smallest = turning.zero(middle, least);
        let largest = turning.zero(middle, radius);
        Ok(Self { xi: *xi, largest, smallest: Some(smallest), radius, c })
    }

    /// Returns the point with this x and with z ≥ 0, or NaN beyond a turning point.
    pub fn point(&self, x: &T) -> SVector<T, 3> {
        let turning = TurningFunction { xi: &self.xi, radius: &self.radius, c: &self.c };
        let y = self.c * x.power_real(&self.xi);
        vector![*x, y, turning.height_square(x).sqrt()]
    }

    /// Returns the time from the turning point with the largest x to this x, for z > 0. The result
    /// is NaN beyond a turning point, and becomes infinite as x → 0 for ξ > 0.
    ///
    /// Near a fixed point for ξ < 0, z² is small on the whole trajectory. The relative error is
    /// then about the rounding error of r² divided by z².
    pub fn time_from_largest(&self, x: &T) -> T {
        self.time_from(&self.largest, x, -T::one())
    }

    /// Returns the period of a closed trajectory, or `None` for ξ > 0.
    pub fn period(&self) -> Option<T> {
        let smallest = self.smallest.as_ref()?;
        // `time_from` removes the singularity at one turning point only, so the integral is split.
        let middle = (self.largest * *smallest).sqrt();
        let from_smallest = self.time_from(smallest, &middle, T::one());
        Some(T::from_int(2) * (self.time_from_largest(&middle) + from_smallest))
    }

    /// Returns |∫ dx/(xz)| between the turning point x* and x. The substitution x = x* e^(σs²),
    /// where σ = ±1 is `sigma`, removes the singularity at x*, where z = 0.
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

/// The function z² = r² − x² − c²x^{2ξ} of x, where r is the radius.
struct TurningFunction<'a, T> {
    xi: &'a T,
    radius: &'a T,
    c: &'a T,
}

impl<T: Real> TurningFunction<'_, T> {
    fn height_square(&self, x: &T) -> T {
        let y = *self.c * x.power_real(self.xi);
        self.radius.square() - x.square() - y.square()
    }

    /// Finds the zero of z² between two points by Newton's method and bisection. The function must
    /// be nonnegative at `inside` and nonpositive at `outside`.
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
