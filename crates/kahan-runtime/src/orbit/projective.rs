//! Orbits through poles, over a scalar chosen at compile time.
//!
//! In: a map of at most [`LARGEST_DIMENSION`](crate::interpreted::LARGEST_DIMENSION) variables, ε,
//! and a first point. Out: points, including those at infinity.

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, KahanMap, Projective, ProjectivePoint, SingularStep, ThroughPoles};

use crate::Map;
use crate::interpreted::{LARGEST_DIMENSION, Padded, UnsupportedDimension, round};

/// An orbit through poles with its current point; begun by [`Map::projective_orbit`].
pub trait ProjectiveOrbit<T> {
    /// Makes one step. If no next point exists, returns an error, with the reason if known.
    fn advance(&mut self) -> Result<(), Option<SingularStep>>;

    /// Returns the point's coordinates, or the direction if the point is at infinity.
    fn coordinates(&self) -> &[T];

    /// Returns whether the point is at infinity.
    fn is_infinite(&self) -> bool;

    /// Returns the integrals claimed without `when`, at a finite point. In an exact scalar, an
    /// integral that divides by zero is `None`.
    fn integrals(&self) -> Vec<Option<T>>;
}

/// A scalar for orbits through poles of a run-time map: `f32`, `f64`, [`Dd`] and `BigRational`.
pub trait ProjectiveScalar: ThroughPoles {
    /// Begins the orbit of a map at its first point.
    #[doc(hidden)]
    fn begin(map: Padded<Self>, eps: &Rational, start: &[Rational]) -> Box<dyn ProjectiveOrbit<Self>>;
}

/// Implements [`ProjectiveScalar`] in this crate, so that callers do not compile its code again.
macro_rules! compile_for {
    ($($scalar:ty),*) => {$(
        impl ProjectiveScalar for $scalar {
            fn begin(map: Padded<Self>, eps: &Rational, start: &[Rational]) -> Box<dyn ProjectiveOrbit<Self>> {
                ProjectivePosition::begin(map, eps, start)
            }
        }
    )*};
}

compile_for!(f32, f64, Dd, BigRational);

impl Map {
    /// Begins an orbit that passes through poles, from `start` and at ε, half the time step. Each
    /// number is rounded once; missing coordinates of `start` are 0.
    ///
    /// # Errors
    /// [`UnsupportedDimension`] if the field has more than [`LARGEST_DIMENSION`] variables.
    pub fn projective_orbit<T: ProjectiveScalar>(
        &self,
        eps: &Rational,
        start: &[Rational],
    ) -> Result<Box<dyn ProjectiveOrbit<T>>, UnsupportedDimension> {
        Ok(T::begin(self.as_padded_kahan_map()?, eps, start))
    }
}

struct ProjectivePosition<T: ThroughPoles> {
    map: Padded<T>,
    eps: T,
    orbit: Projective<Padded<T>, T, LARGEST_DIMENSION>,
    point: ProjectivePoint<T, LARGEST_DIMENSION>,
}

impl<T: ThroughPoles> ProjectivePosition<T> {
    fn begin(map: Padded<T>, eps: &Rational, start: &[Rational]) -> Box<dyn ProjectiveOrbit<T>> {
        let start: SVector<T, LARGEST_DIMENSION> =
            SVector::from_fn(|i, _| start.get(i).map_or_else(T::zero, round));
        let eps: T = round(eps);
        let mut orbit = map.orbit(start.clone(), eps.clone()).projective();
        // The first item of the iterator is the first point itself.
        orbit.next();
        Box::new(ProjectivePosition { map, eps, orbit, point: start.into() })
    }
}

impl<T: ThroughPoles> ProjectiveOrbit<T> for ProjectivePosition<T> {
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
