//! Orbits through poles, in a scalar that is chosen at compile time.
//!
//! In: a map of at most [`LARGEST_DIMENSION`](crate::interpreted::LARGEST_DIMENSION) variables, ε,
//! a first point. Out: its points, those at infinity too. What is generic over scalars is compiled
//! here, once for all programs that follow such orbits.

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, KahanMap, Projective, ProjectivePoint, SingularStep, ThroughPoles};

use crate::Map;
use crate::interpreted::{LARGEST_DIMENSION, Padded, UnsupportedDimension, round};

/// An orbit through poles that is at some point; begun by [`Map::projective_orbit`].
pub trait ProjectiveOrbit<T> {
    /// One point on, or why there is none.
    fn advance(&mut self) -> Result<(), Option<SingularStep>>;

    /// The coordinates; at infinity 0 for those that are not infinite.
    fn coordinates(&self) -> &[T];

    /// Whether the point is at infinity.
    fn is_infinite(&self) -> bool;

    /// The integrals that are claimed without `when`, at a point that is not at infinity; `None`
    /// for one that divides by zero there in an exact scalar.
    fn integrals(&self) -> Vec<Option<T>>;
}

/// A scalar over which a map that is read at run time has orbits through poles: `f32`, `f64`,
/// [`Dd`] and `BigRational`.
pub trait ProjectiveScalar: ThroughPoles {
    /// The orbit of a map at its first point.
    #[doc(hidden)]
    fn begin(map: Padded<Self>, eps: &Rational, start: &[Rational]) -> Box<dyn ProjectiveOrbit<Self>>;
}

/// Scalars for which this crate compiles the orbit: a provided method would be compiled where it is
/// called.
macro_rules! compile_for {
    ($($scalar:ty),*) => {$(
        impl ProjectiveScalar for $scalar {
            fn begin(map: Padded<Self>, eps: &Rational, start: &[Rational]) -> Box<dyn ProjectiveOrbit<Self>> {
                At::begin(map, eps, start)
            }
        }
    )*};
}

compile_for!(f32, f64, Dd, BigRational);

impl Map {
    /// The orbit through poles with ε, half the time step, from a first point; each number is
    /// rounded once. Coordinates that the point lacks are 0.
    ///
    /// # Errors
    /// [`UnsupportedDimension`] if the field has more variables than there is a type for.
    pub fn projective_orbit<T: ProjectiveScalar>(
        &self,
        eps: &Rational,
        start: &[Rational],
    ) -> Result<Box<dyn ProjectiveOrbit<T>>, UnsupportedDimension> {
        Ok(T::begin(self.as_padded_kahan_map()?, eps, start))
    }
}

/// An orbit and the point that it is at.
struct At<T: ThroughPoles> {
    map: Padded<T>,
    eps: T,
    orbit: Projective<Padded<T>, T, LARGEST_DIMENSION>,
    point: ProjectivePoint<T, LARGEST_DIMENSION>,
}

impl<T: ThroughPoles> At<T> {
    fn begin(map: Padded<T>, eps: &Rational, start: &[Rational]) -> Box<dyn ProjectiveOrbit<T>> {
        let start: SVector<T, LARGEST_DIMENSION> =
            SVector::from_fn(|i, _| start.get(i).map_or_else(T::zero, round));
        let eps: T = round(eps);
        let mut orbit = map.orbit(start.clone(), eps.clone()).projective();
        // The first item is the first point itself.
        orbit.next();
        Box::new(At { map, eps, orbit, point: start.into() })
    }
}

impl<T: ThroughPoles> ProjectiveOrbit<T> for At<T> {
    fn advance(&mut self) -> Result<(), Option<SingularStep>> {
        self.point = self.orbit.next().ok_or_else(|| self.orbit.stopped().copied())?;
        Ok(())
    }

    fn coordinates(&self) -> &[T] {
        &self.point.coordinates().as_slice()[..self.map.variables().len()]
    }

    fn is_infinite(&self) -> bool {
        self.point.is_infinite()
    }

    fn integrals(&self) -> Vec<Option<T>> {
        self.map.integrals(self.point.coordinates(), &self.eps)
    }
}
