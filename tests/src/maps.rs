//! Generated maps behind traits, over any scalar and in any dimension.
//!
//! Tests over [`Steps`] and [`Map`] are compiled once instead of once for each system. The order of
//! the maps is that of `subject::paper`, `subject::further` and `subject::random`.

use kahan_core::prelude::*;
use kahan_core::{Constant, ExtendScalars, KahanAt, Orbit, SingularStep};
use kahan_systems::entry::Entry;
use kahan_systems::with_catalog;

use crate::exact::Q;

/// A matrix by rows.
pub type Rows<T> = Vec<Vec<T>>;

/// The steps of a map.
pub trait Steps<T> {
    /// Returns the next point x̃, finite or not.
    fn step(&self, x: &[T], eps: T) -> Vec<T>;
    /// Returns the next point x̃, or the reason why it is undefined.
    fn try_step(&self, x: &[T], eps: T) -> Result<Vec<T>, SingularStep>;
}

/// A field with the matrices, determinants and other quantities of Kahan's method.
pub trait Map<T>: Steps<T> {
    /// Returns the field f(x).
    fn field(&self, x: &[T]) -> Vec<T>;
    /// Returns the Jacobian matrix f′(x) of the field.
    fn field_jacobian(&self, x: &[T]) -> Rows<T>;
    /// Returns Q(x,y), the symmetric bilinear form of the field's quadratic part.
    fn bilinear(&self, x: &[T], y: &[T]) -> Vec<T>;
    /// Returns the polarised field, which is symmetric in x and y and equals f(x) for y = x.
    fn polarized(&self, x: &[T], y: &[T]) -> Vec<T>;
    /// Returns the matrix A(x,ε) of the equation A(x,ε)x̃ = b(x,ε).
    fn matrix(&self, x: &[T], eps: T) -> Rows<T>;
    /// Returns the right-hand side b(x,ε) of the equation A(x,ε)x̃ = b(x,ε).
    fn rhs(&self, x: &[T], eps: T) -> Vec<T>;
    /// Returns the image under the inverse map.
    fn step_back(&self, x: &[T], eps: T) -> Vec<T>;
    /// Returns the Jacobian matrix ∂x̃/∂x of the map.
    fn jacobian(&self, x: &[T], eps: T) -> Rows<T>;
    /// Returns the determinant of the matrix A(x,ε).
    fn det_matrix(&self, x: &[T], eps: T) -> T;
    /// Returns the determinant of ∂x̃/∂x.
    fn det_jacobian(&self, x: &[T], eps: T) -> T;
    /// Returns the numerators adj(A)·b and the denominator det A of the next point.
    fn rational_map(&self, x: &[T], eps: T) -> (Vec<T>, T);
    /// Returns (∂x̃/∂x)·v for a tangent vector v and the next point x̃ = `next`; `None` at a pole.
    fn push_forward(&self, x: &[T], next: &[T], v: &[T], eps: T) -> Option<Vec<T>>;
    /// Returns the map prepared at ε.
    fn at(&self, eps: T) -> Box<dyn Prepared<T>>;
    /// Returns the orbit x₀, x₁, … that starts at x.
    fn orbit(&self, x: &[T], eps: T) -> Box<dyn Points<T>>;
}

/// A map prepared at an ε.
pub trait Prepared<T> {
    /// Returns the next point x̃, finite or not.
    fn step(&self, x: &[T]) -> Vec<T>;
    /// Returns the next point x̃, or the reason why it is undefined.
    fn try_step(&self, x: &[T]) -> Result<Vec<T>, SingularStep>;
    /// Returns the Jacobian matrix ∂x̃/∂x of the map.
    fn jacobian(&self, x: &[T]) -> Rows<T>;
    /// Returns the orbit x₀, x₁, … that starts at x.
    fn orbit(&self, x: &[T]) -> Box<dyn Points<T>>;
}

/// The points of an orbit.
pub trait Points<T> {
    /// Returns the next point; `None` after the final point.
    fn next_point(&mut self) -> Option<Vec<T>>;
    /// Returns whether a pole ended the orbit.
    fn has_stopped(&self) -> bool;
}

/// Returns at most `most` points of an orbit.
pub fn points<T>(orbit: &mut dyn Points<T>, most: usize) -> Vec<Vec<T>> {
    std::iter::from_fn(|| orbit.next_point()).take(most).collect()
}

struct OfDimension<M, const N: usize>(M);

pub(crate) fn point<T: Scalar, const N: usize>(x: &[T]) -> SVector<T, N> {
    assert_eq!(x.len(), N, "a point of another dimension");
    SVector::from_fn(|i, _| x[i].clone())
}

fn entries<T: Scalar, const N: usize>(x: &SVector<T, N>) -> Vec<T> {
    x.iter().cloned().collect()
}

pub(crate) fn rows<T: Scalar, const N: usize>(m: &SMatrix<T, N, N>) -> Rows<T> {
    (0..N).map(|i| (0..N).map(|j| m[(i, j)].clone()).collect()).collect()
}

impl<T: Pivot, M: KahanMap<T, N>, const N: usize> Steps<T> for OfDimension<M, N> {
    fn step(&self, x: &[T], eps: T) -> Vec<T> {
        entries(&self.0.step(&point(x), eps))
    }

    fn try_step(&self, x: &[T], eps: T) -> Result<Vec<T>, SingularStep> {
        Ok(entries(&self.0.try_step(&point(x), eps)?))
    }
}

impl<T: Pivot, M: ExtendScalars<T, N> + 'static, const N: usize> Map<T> for OfDimension<M, N> {
    fn field(&self, x: &[T]) -> Vec<T> {
        entries(&self.0.field(&point(x)))
    }

    fn field_jacobian(&self, x: &[T]) -> Rows<T> {
        rows(&self.0.field_jacobian(&point(x)))
    }

    fn bilinear(&self, x: &[T], y: &[T]) -> Vec<T> {
        entries(&self.0.bilinear(&point(x), &point(y)))
    }

    fn polarized(&self, x: &[T], y: &[T]) -> Vec<T> {
        entries(&self.0.polarized(&point(x), &point(y)))
    }

    fn matrix(&self, x: &[T], eps: T) -> Rows<T> {
        rows(&self.0.matrix(&point(x), eps))
    }

    fn rhs(&self, x: &[T], eps: T) -> Vec<T> {
        entries(&self.0.rhs(&point(x), eps))
    }

    fn step_back(&self, x: &[T], eps: T) -> Vec<T> {
        entries(&self.0.step_back(&point(x), eps))
    }

    fn jacobian(&self, x: &[T], eps: T) -> Rows<T> {
        rows(&self.0.jacobian(&point(x), eps))
    }

    fn det_matrix(&self, x: &[T], eps: T) -> T {
        self.0.det_matrix(&point(x), eps)
    }

    fn det_jacobian(&self, x: &[T], eps: T) -> T {
        self.0.det_jacobian(&point(x), eps)
    }

    fn rational_map(&self, x: &[T], eps: T) -> (Vec<T>, T) {
        let (numerators, denominator) = self.0.rational_map(&point(x), eps);
        (entries(&numerators), denominator)
    }

    fn push_forward(&self, x: &[T], next: &[T], v: &[T], eps: T) -> Option<Vec<T>> {
        let tangent = self.0.at(eps).tangent();
        tangent.push_forward_to(&point(x), &point(next), &point(v)).map(|carried| entries(&carried))
    }

    fn at(&self, eps: T) -> Box<dyn Prepared<T>> {
        Box::new(self.0.at(eps))
    }

    fn orbit(&self, x: &[T], eps: T) -> Box<dyn Points<T>> {
        Box::new(self.0.orbit(point(x), eps))
    }
}

impl<T: Pivot, M: KahanMap<T, N> + Clone + 'static, const N: usize> Prepared<T> for KahanAt<M, T, N> {
    fn step(&self, x: &[T]) -> Vec<T> {
        entries(&self.step(&point(x)))
    }

    fn try_step(&self, x: &[T]) -> Result<Vec<T>, SingularStep> {
        Ok(entries(&self.try_step(&point(x))?))
    }

    fn jacobian(&self, x: &[T]) -> Rows<T> {
        rows(&self.jacobian(&point(x)))
    }

    fn orbit(&self, x: &[T]) -> Box<dyn Points<T>> {
        Box::new(self.orbit(point(x)))
    }
}

impl<T: Pivot, M: KahanMap<T, N> + Clone, const N: usize> Points<T> for Orbit<KahanAt<M, T, N>> {
    fn next_point(&mut self) -> Option<Vec<T>> {
        self.next().map(|x| entries(&x))
    }

    fn has_stopped(&self) -> bool {
        self.stopped().is_some()
    }
}

fn ratio<T: Scalar>(&(p, d): &(i64, i64)) -> T {
    T::constant(&Constant::ratio(p, d))
}

/// Returns the parameters at which tests run a system.
#[must_use]
pub fn parameters<T: Scalar>(entry: &Entry) -> Vec<T> {
    entry.parameters.iter().map(ratio).collect()
}

pub(crate) fn erased<T, M, const N: usize>(map: M) -> Box<dyn Map<T>>
where
    T: Pivot,
    M: ExtendScalars<T, N> + 'static,
{
    Box::new(OfDimension(map))
}

macro_rules! at_its_parameters {
    ($scalar:ty, $module:ident::$type:ident $({ $($parameter:ident),* })?) => {{
        let mut _values = parameters::<$scalar>(&kahan_systems::$module::ENTRY).into_iter();
        kahan_systems::$type { $($($parameter: _values.next().expect("a value for each parameter")),*)? }
    }};
}

macro_rules! maps_of_catalog {
    (
        paper { $($paper:ident::$of_paper:ident $({ $($p:ident),* })? in $n:literal;)* }
        further { $($further:ident::$of_further:ident $({ $($q:ident),* })? in $m:literal;)* }
    ) => {
        /// Returns the systems of the paper.
        #[must_use]
        pub fn paper<T: Pivot>() -> Vec<Box<dyn Map<T>>> {
            vec![$(erased::<T, _, $n>(at_its_parameters!(T, $paper::$of_paper $({ $($p),* })?))),*]
        }

        /// Returns all systems of the catalog at their parameters.
        #[must_use]
        pub fn steps<T: Pivot>() -> Vec<Box<dyn Steps<T>>> {
            vec![
                $(Box::new(OfDimension::<_, $n>(at_its_parameters!(T, $paper::$of_paper $({ $($p),* })?))),)*
                $(Box::new(OfDimension::<_, $m>(at_its_parameters!(T, $further::$of_further $({ $($q),* })?))),)*
            ]
        }
    };
}

with_catalog!(maps_of_catalog);

macro_rules! at_random_parameters {
    ($($name:ident: $n:literal { $($parameter:ident = $p:literal / $d:literal),* },)*) => {
        vec![$(erased::<_, _, $n>(crate::random_systems::$name { $($parameter: ratio(&($p, $d))),* })),*]
    };
}

macro_rules! random_maps {
    (in_floats { $($floats:tt)* } over_rationals { $($rationals:tt)* }) => {
        /// Returns the random fields that are compiled over floats.
        #[must_use]
        pub fn random_in_floats<T: Pivot>() -> Vec<Box<dyn Map<T>>> {
            at_random_parameters!($($floats)*)
        }

        /// Returns all random fields.
        #[must_use]
        pub fn random() -> Vec<Box<dyn Map<Q>>> {
            at_random_parameters!($($floats)* $($rationals)*)
        }
    };
}

crate::with_random_systems!(random_maps);

/// Returns the systems of the paper, and the random fields that are compiled over floats.
#[must_use]
pub fn paper_and_random<T: Pivot>() -> Vec<Box<dyn Map<T>>> {
    paper().into_iter().chain(random_in_floats()).collect()
}

/// Returns an orbit by `step` and by `orbit`, of the map and of the prepared map.
pub fn every_way<T: Copy>(map: &dyn Map<T>, x: &[T], eps: T, steps: usize) -> [Vec<Vec<T>>; 4] {
    let prepared = map.at(eps);
    let by = |step: &dyn Fn(&[T]) -> Vec<T>| {
        let mut x = x.to_vec();
        let points = (0..steps).map(|_| {
            x = step(&x);
            x.clone()
        });
        points.collect()
    };
    let of = |mut orbit: Box<dyn Points<T>>| points(orbit.as_mut(), steps + 1).split_off(1);
    [by(&|x| map.step(x, eps)), by(&|x| prepared.step(x)), of(prepared.orbit(x)), of(map.orbit(x, eps))]
}

/// Calls every method of a map. Returns the number of points of an orbit, at most four.
pub fn call_everything<T: Copy>(map: &dyn Map<T>, x: &[T], eps: T) -> usize {
    let _ = (map.field(x), map.field_jacobian(x), map.bilinear(x, x), map.polarized(x, x));
    let _ = (map.matrix(x, eps), map.rhs(x, eps), map.rational_map(x, eps), map.det_matrix(x, eps));
    let _ = (map.step(x, eps), map.step_back(x, eps), map.try_step(x, eps).is_ok());
    let _ = (map.jacobian(x, eps), map.det_jacobian(x, eps));
    let prepared = map.at(eps);
    let _ = (prepared.step(x), prepared.try_step(x).is_ok(), prepared.jacobian(x));
    points(map.orbit(x, eps).as_mut(), 4).len()
}
