//! Runs generated code over exact numbers, and asserts that all ways to take a step agree.

use std::panic::{AssertUnwindSafe, catch_unwind};

use kahan_core::prelude::*;
use kahan_systems::entry::Entry;
use kahan_systems::with_catalog;

use super::BackEnd;
use crate::exact::{Matrix, Q, Vector};
use crate::maps::{Map, erased, point, points, rows};

/// A map whose code the macro wrote.
pub struct Generated {
    name: &'static str,
    map: Box<dyn Map<Q>>,
    claims: Option<Box<dyn Claims>>,
}

trait Claims {
    fn integrals(&self, x: &[Q], eps: Q) -> Vector;
    fn density(&self, x: &[Q], eps: Q) -> Option<Q>;
    fn bracket(&self, name: &str, x: &[Q], eps: Q) -> Option<Matrix>;
}

type Accessor<M, R, const N: usize> = fn(&M, &SVector<Q, N>, Q) -> R;

type Bracket<M, const N: usize> = (&'static str, Accessor<M, Option<SMatrix<Q, N, N>>, N>);

/// A map with functions that return its integrals, density and brackets.
struct Accessors<M, const N: usize> {
    map: M,
    integrals: Accessor<M, Vector, N>,
    density: Accessor<M, Option<Q>, N>,
    brackets: [Bracket<M, N>; 2],
}

impl<M, const N: usize> Claims for Accessors<M, N> {
    fn integrals(&self, x: &[Q], eps: Q) -> Vector {
        (self.integrals)(&self.map, &point(x), eps)
    }

    fn density(&self, x: &[Q], eps: Q) -> Option<Q> {
        (self.density)(&self.map, &point(x), eps)
    }

    fn bracket(&self, name: &str, x: &[Q], eps: Q) -> Option<Matrix> {
        let (_, accessor) = self.brackets.iter().find(|(known, _)| *known == name)?;
        accessor(&self.map, &point(x), eps).map(|bracket| rows(&bracket))
    }
}

/// Accessors for a map without claims. Accessors that the macro writes hide these defaults.
#[allow(non_snake_case)]
trait Unclaimed<const N: usize> {
    fn integrals(&self, _x: &SVector<Q, N>, _eps: Q) -> [Q; 0] {
        []
    }

    fn density(&self, _x: &SVector<Q, N>, _eps: Q) -> Option<Q> {
        None
    }

    fn bracket_P(&self, _x: &SVector<Q, N>, _eps: Q) -> Option<SMatrix<Q, N, N>> {
        None
    }

    fn bracket_Q(&self, _x: &SVector<Q, N>, _eps: Q) -> Option<SMatrix<Q, N, N>> {
        None
    }
}

impl<M: KahanMap<Q, N>, const N: usize> Unclaimed<N> for M {}

macro_rules! generated_catalog {
    ($($group:ident {
        $($module:ident::$type:ident $({ $($parameter:ident),* })? in $n:literal;)*
    })*) => {
        impl Generated {
            /// Makes a catalog system at these parameters. Panics if their number is wrong.
            #[must_use]
            pub fn of_catalog(entry: &Entry, parameters: &[Q]) -> Self {
                let name = entry.type_name;
                $($(
                    if entry.command == kahan_systems::$module::ENTRY.command {
                        let [$($($parameter),*)?] = parameters else {
                            panic!("{name} has another number of parameters")
                        };
                        let map = kahan_systems::$type { $($($parameter: $parameter.clone()),*)? };
                        let claims = Accessors::<_, $n> {
                            map: map.clone(),
                            integrals: |map, x, eps| map.integrals(x, eps).iter().cloned().collect(),
                            density: |map, x, eps| map.density(x, eps).into(),
                            brackets: [
                                ("P", |map, x, eps| map.bracket_P(x, eps).into()),
                                ("Q", |map, x, eps| map.bracket_Q(x, eps).into()),
                            ],
                        };
                        return Self { name, map: erased::<_, _, $n>(map), claims: Some(Box::new(claims)) };
                    }
                )*)*
                unreachable!("the registry has what is in the list")
            }
        }
    };
}

with_catalog!(generated_catalog);

/// Returns the result of a call; `None` if the call panics because a value is undefined.
fn value_of<R>(call: impl FnOnce() -> R) -> Option<R> {
    catch_unwind(AssertUnwindSafe(call)).ok()
}

impl Generated {
    /// Makes a map without claims.
    #[must_use]
    pub fn new(name: &'static str, map: Box<dyn Map<Q>>) -> Self {
        Self { name, map, claims: None }
    }

    fn claimed<R>(&self, value: impl FnOnce(&dyn Claims) -> Option<R>) -> Option<R> {
        let claims = self.claims.as_deref()?;
        value_of(|| value(claims)).flatten()
    }
}

impl BackEnd for Generated {
    fn label(&self) -> String {
        format!("{}, generated", self.name)
    }

    fn field(&self, x: &[Q]) -> Vector {
        self.map.field(x)
    }

    fn field_jacobian(&self, x: &[Q]) -> Matrix {
        self.map.field_jacobian(x)
    }

    fn bilinear(&self, x: &[Q], y: &[Q]) -> Vector {
        self.map.bilinear(x, y)
    }

    fn polarized(&self, x: &[Q], y: &[Q]) -> Vector {
        self.map.polarized(x, y)
    }

    fn matrix(&self, x: &[Q], eps: &Q) -> Matrix {
        self.map.matrix(x, eps.clone())
    }

    fn rhs(&self, x: &[Q], eps: &Q) -> Vector {
        self.map.rhs(x, eps.clone())
    }

    fn step(&self, x: &[Q], eps: &Q) -> Option<Vector> {
        let Ok(next) = self.map.try_step(x, eps.clone()) else {
            assert!(
                value_of(|| self.map.step(x, eps.clone())).is_none(),
                "a step where try_step sees a pole"
            );
            return None;
        };
        assert_eq!(self.map.step(x, eps.clone()), next, "step differs from try_step");
        assert_eq!(self.map.at(eps.clone()).step(x), next, "at(eps).step differs from step");
        Some(next)
    }

    fn jacobian(&self, x: &[Q], eps: &Q) -> Option<Matrix> {
        value_of(|| self.map.jacobian(x, eps.clone()))
    }

    fn push_forward(&self, x: &[Q], next: &[Q], v: &[Q], eps: &Q) -> Option<Vector> {
        self.map.push_forward(x, next, v, eps.clone())
    }

    fn det_matrix(&self, x: &[Q], eps: &Q) -> Q {
        self.map.det_matrix(x, eps.clone())
    }

    fn det_jacobian(&self, x: &[Q], eps: &Q) -> Option<Q> {
        value_of(|| self.map.det_jacobian(x, eps.clone()))
    }

    fn rational_map(&self, x: &[Q], eps: &Q) -> (Vector, Q) {
        self.map.rational_map(x, eps.clone())
    }

    fn orbit(&self, x: &[Q], eps: &Q, steps: usize) -> (Vec<Vector>, bool) {
        let mut orbit = self.map.orbit(x, eps.clone());
        let points = points(orbit.as_mut(), steps + 1);
        (points, orbit.has_stopped())
    }

    fn integrals(&self, x: &[Q], eps: &Q) -> Option<Vector> {
        if self.claims.is_none() {
            return Some(Vector::new());
        }
        self.claimed(|claims| Some(claims.integrals(x, eps.clone())))
    }

    fn density(&self, x: &[Q], eps: &Q) -> Option<Q> {
        self.claimed(|claims| claims.density(x, eps.clone()))
    }

    fn bracket(&self, name: &str, x: &[Q], eps: &Q) -> Option<Matrix> {
        self.claimed(|claims| claims.bracket(name, x, eps.clone()))
    }
}
