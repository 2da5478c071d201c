//! One face for the two back ends, so that one suite tests both: generated code and the run-time interpreter.
//!
//! In: a system with its parameters given, points and ε (half the time step) as exact numbers. Out: every object of the
//! method as plain vectors, and `None` where the map or a claim has no value.
//! [`Generated`] also insists that the ways to take a step agree: `step`, `try_step`, `at(ε)`, and a panic of `step` exactly
//! at a pole.

use std::cell::RefCell;
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::interpret::{Evaluation, Interpreter, Point};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::prelude::*;

use crate::exact::{Matrix, Q, Vector};

/// Everything that a system knows at a point.
pub trait BackEnd {
    /// Which back end this is, for messages.
    fn label(&self) -> String;
    /// f(x)
    fn field(&self, x: &[Q]) -> Vector;
    /// f′(x)
    fn field_jacobian(&self, x: &[Q]) -> Matrix;
    /// Q(x,y)
    fn bilinear(&self, x: &[Q], y: &[Q]) -> Vector;
    /// Q(x,y) + ½B(x+y) + c
    fn polarized(&self, x: &[Q], y: &[Q]) -> Vector;
    /// A(x,ε)
    fn matrix(&self, x: &[Q], eps: &Q) -> Matrix;
    /// b(x,ε)
    fn rhs(&self, x: &[Q], eps: &Q) -> Vector;
    /// x̃; `None` at a pole.
    fn step(&self, x: &[Q], eps: &Q) -> Option<Vector>;
    /// ∂x̃/∂x; `None` at a pole.
    fn jacobian(&self, x: &[Q], eps: &Q) -> Option<Matrix>;
    /// det A(x,ε)
    fn det_matrix(&self, x: &[Q], eps: &Q) -> Q;
    /// det ∂x̃/∂x; `None` at a pole.
    fn det_jacobian(&self, x: &[Q], eps: &Q) -> Option<Q>;
    /// x₀, x₁, … x_steps, or up to the last point before a pole; and whether a pole ended it.
    fn orbit(&self, x: &[Q], eps: &Q, steps: usize) -> (Vec<Vector>, bool);
    /// The unconditional integrals, in order; `None` where one of them has no value.
    fn integrals(&self, x: &[Q], eps: &Q) -> Option<Vector>;
    /// The unconditional density; `None` where it has no value, or none is declared.
    fn density(&self, x: &[Q], eps: &Q) -> Option<Q>;
    /// An unconditional bracket; `None` where it has no value, or none of this name is declared.
    fn bracket(&self, name: &str, x: &[Q], eps: &Q) -> Option<Matrix>;
}

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
            assert!(value_of(|| self.map.step(&x, eps.clone())).is_none(), "a step where try_step sees a pole");
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

/// The interpreter, at parameter values. It evaluates all objects at once, so answers are kept.
#[derive(Debug)]
pub struct Interpreted {
    system: &'static System,
    interpreter: Interpreter<'static>,
    parameters: Vec<Rational>,
    known: RefCell<HashMap<Vec<Rational>, Rc<Evaluation<Rational>>>>,
}

fn inward(x: &[Q]) -> Vec<Rational> {
    x.iter().cloned().map(Rational::from).collect()
}

fn outward(x: &[Rational]) -> Vector {
    x.iter().map(Rational::to_big).collect()
}

fn outward_rows(m: &[Vec<Rational>]) -> Matrix {
    m.iter().map(|row| outward(row)).collect()
}

impl Interpreted {
    /// The system at these parameters.
    #[must_use]
    pub fn new(system: &'static System, parameters: &[Q]) -> Self {
        Self {
            system,
            interpreter: Interpreter::new(system),
            parameters: inward(parameters),
            known: RefCell::default(),
        }
    }

    fn point(&self, x: &[Q], eps: &Q) -> Point<Rational> {
        Point { state: inward(x), parameters: self.parameters.clone(), eps: eps.clone().into() }
    }

    fn at(&self, x: &[Q], eps: &Q) -> Rc<Evaluation<Rational>> {
        let point = self.point(x, eps);
        let key: Vec<Rational> = point.state.iter().chain([&point.eps]).cloned().collect();
        if let Some(known) = self.known.borrow().get(&key) {
            return Rc::clone(known);
        }
        let evaluation =
            Rc::new(self.interpreter.evaluate(&Exact, &point).expect("the parameters suit the field"));
        self.known.borrow_mut().insert(key, Rc::clone(&evaluation));
        evaluation
    }

    /// The results of any claim, also of one that is made for special parameters or ε only.
    ///
    /// # Panics
    /// If there is no claim of this name.
    #[must_use]
    pub fn claim(&self, name: &str, x: &[Q], eps: &Q) -> Option<Vector> {
        let claim = self.system.claims.iter().find(|claim| claim.name.text == name);
        let claim = claim.unwrap_or_else(|| panic!("{} has no claim {name}", self.system.name()));
        let values: Vec<Rational> = inward(x)
            .into_iter()
            .chain(self.parameters.iter().cloned())
            .chain([Rational::from(eps.clone())])
            .collect();
        let results = claim.plan.evaluate(&Exact, |variable| values[usize::from(variable.0)].clone());
        results.into_iter().map(|value| value.map(|value| value.to_big())).collect()
    }
}

impl BackEnd for Interpreted {
    fn label(&self) -> String {
        format!("{}, interpreted", self.system.name())
    }

    fn field(&self, x: &[Q]) -> Vector {
        outward(&self.at(x, &crate::exact::q(1, 2)).field)
    }

    fn field_jacobian(&self, x: &[Q]) -> Matrix {
        outward_rows(&self.at(x, &crate::exact::q(1, 2)).field_jacobian)
    }

    fn bilinear(&self, x: &[Q], y: &[Q]) -> Vector {
        let point = self.point(x, &crate::exact::q(1, 2));
        outward(&self.interpreter.bilinear(&Exact, &point, &inward(y)).expect("a form has no poles"))
    }

    fn polarized(&self, x: &[Q], y: &[Q]) -> Vector {
        let point = self.point(x, &crate::exact::q(1, 2));
        outward(&self.interpreter.polarized(&Exact, &point, &inward(y)).expect("a form has no poles"))
    }

    fn matrix(&self, x: &[Q], eps: &Q) -> Matrix {
        outward_rows(&self.at(x, eps).matrix)
    }

    fn rhs(&self, x: &[Q], eps: &Q) -> Vector {
        outward(&self.at(x, eps).rhs)
    }

    fn step(&self, x: &[Q], eps: &Q) -> Option<Vector> {
        self.interpreter.next(&Exact, &self.point(x, eps)).map(|next| outward(&next))
    }

    fn jacobian(&self, x: &[Q], eps: &Q) -> Option<Matrix> {
        self.at(x, eps).jacobian.as_deref().map(outward_rows)
    }

    fn det_matrix(&self, x: &[Q], eps: &Q) -> Q {
        self.at(x, eps).det_matrix.to_big()
    }

    fn det_jacobian(&self, x: &[Q], eps: &Q) -> Option<Q> {
        self.at(x, eps).det_jacobian.as_ref().map(Rational::to_big)
    }

    fn orbit(&self, x: &[Q], eps: &Q, steps: usize) -> (Vec<Vector>, bool) {
        let mut points = vec![x.to_vec()];
        for _ in 0..steps {
            let Some(next) = self.step(&points[points.len() - 1], eps) else { return (points, true) };
            points.push(next);
        }
        (points, false)
    }

    fn integrals(&self, x: &[Q], eps: &Q) -> Option<Vector> {
        let evaluation = self.at(x, eps);
        evaluation.integrals.iter().map(|(_, value)| value.as_ref().map(Rational::to_big)).collect()
    }

    fn density(&self, x: &[Q], eps: &Q) -> Option<Q> {
        self.at(x, eps).density.as_ref()?.as_ref().map(Rational::to_big)
    }

    fn bracket(&self, name: &str, x: &[Q], eps: &Q) -> Option<Matrix> {
        let evaluation = self.at(x, eps);
        let (_, value) = evaluation.brackets.iter().find(|(known, _)| known == name)?;
        value.as_deref().map(outward_rows)
    }
}
