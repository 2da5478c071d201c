//! Runs the interpreter of the front end over exact numbers.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::OnceLock;

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::derive;
use kahan_algebra::interpret::{Evaluation, Interpreter, Point};
use kahan_algebra::kahan::RationalMap;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;

use super::BackEnd;
use crate::exact::{Matrix, Q, Vector, adjugate_product, determinant, product, q};
use crate::expression::evaluate;

/// A system that the front end has read, and the formulas derived from it.
#[derive(Debug)]
pub struct Read {
    /// The system's equations and claims.
    pub system: System,
    derived: OnceLock<Derived>,
}

#[derive(Debug)]
struct Derived {
    interpreter: Interpreter,
    plans: OnceLock<kahan_algebra::Derived>,
    map: Option<RationalMap>,
}

impl Read {
    /// Wraps a system. Formulas are derived from it on first use.
    #[must_use]
    pub fn new(system: System) -> Self {
        Self { system, derived: OnceLock::new() }
    }

    fn derived(&'static self) -> &'static Derived {
        self.derived.get_or_init(|| Derived {
            interpreter: Interpreter::new(&self.system),
            plans: OnceLock::new(),
            map: RationalMap::of(&self.system.field),
        })
    }
}

/// A system at given parameter values. The interpreter evaluates it and caches all results.
#[derive(Debug)]
pub struct Interpreted {
    system: &'static System,
    derived: &'static Derived,
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
    /// Makes the interpreter for these parameters.
    #[must_use]
    pub fn new(read: &'static Read, parameters: &[Q]) -> Self {
        Self {
            system: &read.system,
            derived: read.derived(),
            parameters: inward(parameters),
            known: RefCell::default(),
        }
    }

    /// Returns the number of states.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.system.field.dimension()
    }

    fn point(&self, x: &[Q], eps: &Q) -> Point<Rational> {
        Point { state: inward(x), parameters: self.parameters.clone(), eps: eps.clone().into() }
    }

    fn values(&self, x: &[Q], eps: &Q) -> Vector {
        x.iter().cloned().chain(outward(&self.parameters)).chain([eps.clone()]).collect()
    }

    fn at(&self, x: &[Q], eps: &Q) -> Rc<Evaluation<Rational>> {
        let point = self.point(x, eps);
        let key: Vec<Rational> = point.state.iter().chain([&point.eps]).cloned().collect();
        if let Some(known) = self.known.borrow().get(&key) {
            return Rc::clone(known);
        }
        let evaluation = Rc::new(
            self.derived.interpreter.evaluate(&Exact, &point).expect("the parameters suit the field"),
        );
        self.known.borrow_mut().insert(key, Rc::clone(&evaluation));
        evaluation
    }

    /// Returns the value of any claim, even with a condition. Panics if no claim has this name.
    #[must_use]
    pub fn claim(&self, name: &str, x: &[Q], eps: &Q) -> Option<Vector> {
        let claim = self.system.claims.iter().find(|claim| claim.name.text == name);
        let claim = claim.unwrap_or_else(|| panic!("{} has no claim {name}", self.system.name()));
        let values = inward(&self.values(x, eps));
        let results = claim
            .plan
            .evaluate(&Exact, |input| input.variable().map(|Variable(k)| values[usize::from(k)].clone()));
        results.into_iter().map(|value| value.map(|value| value.to_big())).collect()
    }
}

impl BackEnd for Interpreted {
    fn label(&self) -> String {
        format!("{}, interpreted", self.system.name())
    }

    fn field(&self, x: &[Q]) -> Vector {
        outward(&self.at(x, &q(0, 1)).field)
    }

    fn field_jacobian(&self, x: &[Q]) -> Matrix {
        outward_rows(&self.at(x, &q(0, 1)).field_jacobian)
    }

    fn bilinear(&self, x: &[Q], y: &[Q]) -> Vector {
        let point = self.point(x, &q(0, 1));
        outward(&self.derived.interpreter.bilinear(&Exact, &point, &inward(y)).expect("a form has no poles"))
    }

    fn polarized(&self, x: &[Q], y: &[Q]) -> Vector {
        let point = self.point(x, &q(0, 1));
        outward(&self.derived.interpreter.polarized(&Exact, &point, &inward(y)).expect("a form has no poles"))
    }

    fn matrix(&self, x: &[Q], eps: &Q) -> Matrix {
        outward_rows(&self.at(x, eps).matrix)
    }

    fn rhs(&self, x: &[Q], eps: &Q) -> Vector {
        outward(&self.at(x, eps).rhs)
    }

    fn step(&self, x: &[Q], eps: &Q) -> Option<Vector> {
        self.derived.interpreter.next(&Exact, &self.point(x, eps)).map(|next| outward(&next))
    }

    fn jacobian(&self, x: &[Q], eps: &Q) -> Option<Matrix> {
        self.at(x, eps).jacobian.as_deref().map(outward_rows)
    }

    /// Computes (∂x̃/∂x)·v by the macro's formula, or by the Jacobian matrix without that formula.
    fn push_forward(&self, x: &[Q], next: &[Q], v: &[Q], eps: &Q) -> Option<Vector> {
        let plans = self.derived.plans.get_or_init(|| derive(self.system));
        let Some((_, plan)) = plans.tangent_map() else {
            return Some(product(&self.jacobian(x, eps)?, v));
        };
        // Variables are numbered in this order: x, v, parameters, ε, next.
        let states = x.iter().chain(v).cloned().map(Rational::from);
        let constants = self.parameters.iter().cloned().chain([eps.clone().into()]);
        let values: Vec<Rational> =
            states.chain(constants).chain(next.iter().cloned().map(Rational::from)).collect();
        let results =
            plan.evaluate(&Exact, |input| input.variable().map(|Variable(k)| values[usize::from(k)].clone()));
        results.into_iter().map(|value| value.map(|value| value.to_big())).collect()
    }

    fn det_matrix(&self, x: &[Q], eps: &Q) -> Q {
        self.at(x, eps).det_matrix.to_big()
    }

    fn det_jacobian(&self, x: &[Q], eps: &Q) -> Option<Q> {
        self.at(x, eps).det_jacobian.as_ref().map(Rational::to_big)
    }

    /// Evaluates the map's expanded polynomials. Without them, computes adj(A)·b and det A.
    fn rational_map(&self, x: &[Q], eps: &Q) -> (Vector, Q) {
        let Some(map) = &self.derived.map else {
            let matrix = self.matrix(x, eps);
            return (adjugate_product(&matrix, &self.rhs(x, eps)), determinant(&matrix));
        };
        let values = self.values(x, eps);
        let divisor = evaluate(&map.divisor, &values);
        let quotient = |polynomial: &Polynomial| evaluate(polynomial, &values) / &divisor;
        (map.numerators.iter().map(quotient).collect(), quotient(&map.denominator))
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
