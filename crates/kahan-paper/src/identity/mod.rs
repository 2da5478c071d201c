//! Checks relations between formulas: over ℚ, modulo primes, at exact points, or in 256-bit
//! arithmetic.

mod names;
mod numerical;
mod rational;

use std::collections::BTreeMap;

use kahan_algebra::arithmetic::{Exact, Functions, Modular, SizeArithmetic};
use kahan_algebra::rational::Rational;

use kahan_systems::special::{Float256, Real};

use super::evaluate::{Calculus, Environment, EvaluationError, Evaluator, Models};
use super::formula::{Formula, Relation, has_functions, rationalise};
use super::model::Model;
use super::numeric::Arithmetic256;
use numerical::{agreement, decimal};

/// A formula without a value at this many random points is regarded as undefined.
const MOST_DRAWS: usize = 16;

/// The number of decimals to which both sides must agree.
pub(super) const DECIMALS: u32 = 40;

/// The evidence for a relation between formulas.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Evidence {
    /// Both sides have equal expansions over ℚ, and agree modulo primes.
    NormalForm,
    /// Both sides agree at this number of points modulo primes, with an error probability below
    /// 2⁻¹⁰⁰.
    Modular(u32),
    /// Both sides agree at this number of exact points.
    Exact(u32),
    /// Both sides agree to this number of decimals at random points.
    Numerical(u32),
}

impl Calculus for Functions {}
impl Calculus for Modular {}
impl Calculus for Exact {}
impl Calculus for SizeArithmetic {}

/// A relation between two formulas about one system, with all definitions substituted.
pub(super) struct Identity<'a> {
    pub(super) models: &'a Models,
    pub(super) model: &'a Model,
    pub(super) left: &'a Formula,
    pub(super) relation: Relation,
    pub(super) right: &'a Formula,
    /// One unit in the last decimal place of an approximate number.
    pub(super) digit: Option<&'a Rational>,
    /// The intervals from which numerical tests draw values of names.
    pub(super) domain: &'a [(String, Rational, Rational)],
    pub(super) seed: u64,
}

impl Identity<'_> {
    /// Checks the relation, and returns the evidence or the reason of a failure.
    pub(super) fn establish(&self) -> Result<Evidence, String> {
        let has_functions = has_functions(self.left) || has_functions(self.right);
        // Functions are replaced by variables, but functions may satisfy relations. So a difference
        // of two formulas in these variables does not prove that the sides differ.
        let is_decided_by_names = match self.relation {
            Relation::Equal => true,
            Relation::Different => !has_functions,
            Relation::Approximate => false,
        };
        if is_decided_by_names
            && let (Some(left), Some(right)) = (rationalise(self.left), rationalise(self.right))
        {
            let evidence = self.rational(&left, &right);
            if evidence.is_ok() || !has_functions {
                return evidence;
            }
        }
        self.numerical()
    }

    /// Returns both sides at exact values of the names, and whether the relation holds there.
    pub(super) fn at_point(
        &self,
        point: &BTreeMap<String, Rational>,
    ) -> Result<(String, String, bool), String> {
        if self.relation != Relation::Approximate
            && rationalise(self.left).as_ref() == Some(self.left)
            && rationalise(self.right).as_ref() == Some(self.right)
        {
            let [left, right] =
                self.sides(&Exact, self.left, self.right, point.clone()).map_err(|t| words(&t))?;
            let holds = (left == right) != (self.relation == Relation::Different);
            return Ok((left.to_string(), right.to_string(), holds));
        }
        let frame: BTreeMap<String, Float256> =
            point.iter().map(|(name, value)| (name.clone(), decimal(value))).collect();
        let [left, right] =
            self.sides(&Arithmetic256, self.left, self.right, frame).map_err(|t| words(&t))?;
        let holds = match (self.relation, self.digit) {
            (Relation::Approximate, Some(unit)) => (left - right).abs() < decimal(unit),
            (Relation::Different, _) => agreement(&left, &right) < DECIMALS,
            _ => agreement(&left, &right) >= DECIMALS,
        };
        Ok((left.to_digits(12), right.to_digits(12), holds))
    }

    fn sides<A: Calculus>(
        &self,
        arithmetic: &A,
        left: &Formula,
        right: &Formula,
        values: BTreeMap<String, A::Value>,
    ) -> Result<[A::Value; 2], EvaluationError> {
        let evaluator = Evaluator { arithmetic, models: self.models, model: self.model };
        let frame = Environment::new(values);
        Ok([evaluator.value(left, &frame)?, evaluator.value(right, &frame)?])
    }
}

fn words(trouble: &EvaluationError) -> String {
    match trouble {
        EvaluationError::Undefined => {
            "it divides by zero identically, or leaves a function's domain".to_owned()
        }
        EvaluationError::Unknown(name) => format!("`{name}` has no meaning here"),
    }
}
