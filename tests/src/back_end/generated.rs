//! The code that the macro wrote, over exact numbers.
//!
//! It insists that the ways to take a step agree: `step`, `try_step`, `at(ε)`, and a panic of `step` exactly at a pole.

use std::panic::{AssertUnwindSafe, catch_unwind};

use kahan_core::prelude::*;

use super::BackEnd;
use crate::exact::{Matrix, Q, Vector};

/// The claims of a generated type, whose accessors are inherent methods and differ from type to type.
pub trait Claims<const N: usize> {
    /// The accessor `integrals`, empty where there is none.
    fn integral_values(&self, _x: &SVector<Q, N>, _eps: Q) -> Vector {
        Vec::new()
    }

    /// The accessor `density`.
    fn density_value(&self, _x: &SVector<Q, N>, _eps: Q) -> Option<Q> {
        None
    }

    /// The accessor `bracket_NAME`.
    fn bracket_value(&self, _name: &str, _x: &SVector<Q, N>, _eps: Q) -> Option<SMatrix<Q, N, N>> {
        None
    }
}

/// Code that the macro wrote.
#[derive(Clone, Debug)]
pub struct Generated<M, const N: usize> {
    name: String,
    map: M,
}

impl<M, const N: usize> Generated<M, N> {
    /// The map, with a name for messages.
    pub fn new(name: &str, map: M) -> Self {
        Self { name: name.to_owned(), map }
    }
}

fn point<const N: usize>(x: &[Q]) -> SVector<Q, N> {
    assert_eq!(x.len(), N, "a point of another dimension");
    SVector::from_fn(|i, _| x[i].clone())
}

fn entries<const N: usize>(x: &SVector<Q, N>) -> Vector {
    x.iter().cloned().collect()
}

fn rows<const N: usize>(m: &SMatrix<Q, N, N>) -> Matrix {
    (0..N).map(|i| (0..N).map(|j| m[(i, j)].clone()).collect()).collect()
}

/// What a call gives, or `None` where it panics: an exact scalar has no other way to say that there is no value.
fn value_of<R>(call: impl FnOnce() -> R) -> Option<R> {
    catch_unwind(AssertUnwindSafe(call)).ok()
}

impl<M, const N: usize> BackEnd for Generated<M, N>
where
    M: KahanMap<Q, N> + Claims<N> + Clone,
{
    fn label(&self) -> String {
        format!("{}, generated", self.name)
    }

    fn field(&self, x: &[Q]) -> Vector {
        entries(&self.map.field(&point(x)))
    }

    fn field_jacobian(&self, x: &[Q]) -> Matrix {
        rows(&self.map.field_jacobian(&point(x)))
    }

    fn bilinear(&self, x: &[Q], y: &[Q]) -> Vector {
        entries(&self.map.bilinear(&point(x), &point(y)))
    }

    fn polarized(&self, x: &[Q], y: &[Q]) -> Vector {
        entries(&self.map.polarized(&point(x), &point(y)))
    }

    fn matrix(&self, x: &[Q], eps: &Q) -> Matrix {
        rows(&self.map.matrix(&point(x), eps.clone()))
    }

    fn rhs(&self, x: &[Q], eps: &Q) -> Vector {
        entries(&self.map.rhs(&point(x), eps.clone()))
    }

    fn step(&self, x: &[Q], eps: &Q) -> Option<Vector> {
        let x = point(x);
        let Ok(next) = self.map.try_step(&x, eps.clone()) else {
            assert!(
                value_of(|| self.map.step(&x, eps.clone())).is_none(),
                "a step where try_step sees a pole"
            );
            return None;
        };
        assert_eq!(self.map.step(&x, eps.clone()), next, "step differs from try_step");
        assert_eq!(self.map.at(eps.clone()).step(&x), next, "at(eps).step differs from step");
        Some(entries(&next))
    }

    fn jacobian(&self, x: &[Q], eps: &Q) -> Option<Matrix> {
        value_of(|| rows(&self.map.jacobian(&point(x), eps.clone())))
    }

    fn det_matrix(&self, x: &[Q], eps: &Q) -> Q {
        self.map.det_matrix(&point(x), eps.clone())
    }

    fn det_jacobian(&self, x: &[Q], eps: &Q) -> Option<Q> {
        value_of(|| self.map.det_jacobian(&point(x), eps.clone()))
    }

    fn rational_map(&self, x: &[Q], eps: &Q) -> (Vector, Q) {
        let (numerators, denominator) = self.map.rational_map(&point(x), eps.clone());
        (entries(&numerators), denominator)
    }

    fn orbit(&self, x: &[Q], eps: &Q, steps: usize) -> (Vec<Vector>, bool) {
        let mut orbit = self.map.orbit(point(x), eps.clone());
        let points = orbit.by_ref().take(steps + 1).map(|point| entries(&point)).collect();
        (points, orbit.stopped().is_some())
    }

    fn integrals(&self, x: &[Q], eps: &Q) -> Option<Vector> {
        value_of(|| self.map.integral_values(&point(x), eps.clone()))
    }

    fn density(&self, x: &[Q], eps: &Q) -> Option<Q> {
        value_of(|| self.map.density_value(&point(x), eps.clone())).flatten()
    }

    fn bracket(&self, name: &str, x: &[Q], eps: &Q) -> Option<Matrix> {
        value_of(|| self.map.bracket_value(name, &point(x), eps.clone())).flatten().map(|m| rows(&m))
    }
}
