//! Evaluates formulas at a point, in arithmetics such as prime fields and 256-bit floats.

use std::cell::OnceCell;
use std::collections::BTreeMap;

use kahan_algebra::arithmetic::{Arithmetic, determinant};
use kahan_algebra::rational::Rational;

use super::formula::Formula;
use super::model::Model;

/// An arithmetic that also evaluates some transcendental functions.
pub(super) trait Calculus: Arithmetic<Constant = Rational> {
    /// Evaluates a function by its name.
    fn function(&self, name: &str, _: &[Self::Value]) -> Result<Self::Value, EvaluationError> {
        Err(EvaluationError::Unknown(name.to_owned()))
    }

    /// Evaluates base^exponent where the exponent is not an integer literal.
    fn power(&self, _: &Self::Value, _: &Self::Value) -> Result<Self::Value, EvaluationError> {
        Err(EvaluationError::Unknown("^".to_owned()))
    }
}

/// The reason why a formula cannot be evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum EvaluationError {
    /// A division by zero, or an argument outside a function's domain.
    Undefined,
    Unknown(String),
}

pub(super) type Models = BTreeMap<&'static str, Model>;

/// The values of names at a point, and the next and the previous point under the map.
pub(super) struct Environment<V> {
    values: BTreeMap<String, V>,
    next: OnceCell<Result<Vec<V>, EvaluationError>>,
    back: OnceCell<Result<Vec<V>, EvaluationError>>,
}

impl<V: Clone> Environment<V> {
    pub(super) fn new(values: BTreeMap<String, V>) -> Self {
        Environment { values, next: OnceCell::new(), back: OnceCell::new() }
    }

    fn with(&self, changes: impl IntoIterator<Item = (String, V)>) -> Self {
        let mut values = self.values.clone();
        values.extend(changes);
        Environment::new(values)
    }
}

/// The context of an evaluation: an arithmetic, all systems, and the system of the statement.
pub(super) struct Evaluator<'a, A> {
    pub(super) arithmetic: &'a A,
    pub(super) models: &'a Models,
    pub(super) model: &'a Model,
}

impl<A: Calculus> Evaluator<'_, A> {
    pub(super) fn value(
        &self,
        formula: &Formula,
        frame: &Environment<A::Value>,
    ) -> Result<A::Value, EvaluationError> {
        let arithmetic = self.arithmetic;
        match formula {
            Formula::Number(value) => arithmetic.constant(value).ok_or(EvaluationError::Undefined),
            Formula::Name(name) => match frame.values.get(name) {
                Some(value) => Ok(value.clone()),
                None if name == "detA" || name == "detJ" => self.call(name, &[], frame),
                None => arithmetic.function(name, &[]),
            },
            Formula::Negation(inner) => Ok(arithmetic.negate(&self.value(inner, frame)?)),
            Formula::Sum(terms) => {
                let mut sum: Option<A::Value> = None;
                for (negative, term) in terms {
                    let value = self.value(term, frame)?;
                    sum = Some(match (sum, negative) {
                        (None, false) => value,
                        (None, true) => arithmetic.negate(&value),
                        (Some(sum), false) => arithmetic.add(&sum, &value),
                        (Some(sum), true) => arithmetic.subtract(&sum, &value),
                    });
                }
                sum.map_or_else(|| self.constant(0), Ok)
            }
            Formula::Product(factors) => {
                let mut product = self.constant(1)?;
                for (divides, factor) in factors {
                    let value = self.value(factor, frame)?;
                    product = if *divides {
                        self.quotient(&product, &value)?
                    } else {
                        arithmetic.multiply(&product, &value)
                    };
                }
                Ok(product)
            }
            Formula::Power(base, exponent) => {
                let base = self.value(base, frame)?;
                match exponent.as_number().and_then(|exponent| exponent.as_i64()) {
                    Some(exponent) => self.integer_power(&base, exponent),
                    None => arithmetic.power(&base, &self.value(exponent, frame)?),
                }
            }
            Formula::Call(name, arguments) => self.call(name, arguments, frame),
        }
    }

    fn constant(&self, n: i64) -> Result<A::Value, EvaluationError> {
        self.arithmetic.constant(&Rational::from(n)).ok_or(EvaluationError::Undefined)
    }

    fn quotient(&self, a: &A::Value, b: &A::Value) -> Result<A::Value, EvaluationError> {
        self.arithmetic.divide(a, b).ok_or(EvaluationError::Undefined)
    }

    fn integer_power(&self, base: &A::Value, exponent: i64) -> Result<A::Value, EvaluationError> {
        let mut power = self.constant(1)?;
        for _ in 0..exponent.unsigned_abs() {
            power = self.arithmetic.multiply(&power, base);
        }
        if exponent < 0 { self.quotient(&self.constant(1)?, &power) } else { Ok(power) }
    }

    fn call(
        &self,
        name: &str,
        arguments: &[Formula],
        frame: &Environment<A::Value>,
    ) -> Result<A::Value, EvaluationError> {
        // If the first argument names a system, the call refers to that system.
        if let Some((Formula::Name(system), rest)) = arguments.split_first()
            && is_of_the_map(name)
            && let Some(model) = self.models.get(system.as_str())
        {
            let evaluator = Evaluator { model, ..*self };
            return evaluator.call(name, rest, &Environment::new(frame.values.clone()));
        }
        let unknown = || EvaluationError::Unknown(name.to_owned());
        let states = &self.model.system().field.symbols.states;
        match (name, arguments) {
            ("next" | "back", [inner]) => {
                let moved = if name == "next" { self.next(frame)? } else { self.back(frame)? };
                self.value(inner, &frame.with(states.iter().cloned().zip(moved)))
            }
            ("on", [inner, point @ ..]) if point.len() == states.len() => {
                let point: Vec<A::Value> =
                    point.iter().map(|coordinate| self.value(coordinate, frame)).collect::<Result<_, _>>()?;
                self.value(inner, &frame.with(states.iter().cloned().zip(point)))
            }
            ("at", [inner, replaced @ ..]) if replaced.len() % 2 == 0 => {
                let mut changes = Vec::new();
                for pair in replaced.chunks(2) {
                    let Formula::Name(replaced) = &pair[0] else { return Err(unknown()) };
                    changes.push((replaced.clone(), self.value(&pair[1], frame)?));
                }
                self.value(inner, &frame.with(changes))
            }
            ("sum", [Formula::Name(index), from, to, term]) => {
                let bound =
                    |formula: &Formula| formula.as_number().and_then(|n| n.as_i64()).ok_or_else(unknown);
                let mut sum = self.constant(0)?;
                for j in bound(from)?..=bound(to)? {
                    let term = self.value(term, &frame.with([(index.clone(), self.constant(j)?)]))?;
                    sum = self.arithmetic.add(&sum, &term);
                }
                Ok(sum)
            }
            ("f" | "b", [i]) => {
                let i = self.index(i).ok_or_else(unknown)?;
                Ok(self.entries(name, frame)?.swap_remove(i))
            }
            ("A" | "J" | "Df", [i, j]) => {
                let (i, j) = (self.index(i).ok_or_else(unknown)?, self.index(j).ok_or_else(unknown)?);
                Ok(self.entries(name, frame)?.swap_remove(i * self.model.dimension() + j))
            }
            ("detA" | "detJ", []) => {
                let matrix = self.entries(&name["det".len()..], frame)?;
                determinant(self.arithmetic, &self.model.rows(&matrix)).ok_or(EvaluationError::Undefined)
            }
            _ => {
                let arguments: Vec<A::Value> =
                    arguments.iter().map(|argument| self.value(argument, frame)).collect::<Result<_, _>>()?;
                self.arithmetic.function(name, &arguments)
            }
        }
    }

    fn index(&self, formula: &Formula) -> Option<usize> {
        let index = usize::try_from(formula.as_number()?.as_i64()?).ok()?.checked_sub(1)?;
        (index < self.model.dimension()).then_some(index)
    }

    fn entries(&self, object: &str, frame: &Environment<A::Value>) -> Result<Vec<A::Value>, EvaluationError> {
        self.model.entries(object, self.arithmetic, &self.here(frame)?).ok_or(EvaluationError::Undefined)
    }

    fn here(&self, frame: &Environment<A::Value>) -> Result<Vec<A::Value>, EvaluationError> {
        let value = |name: String| frame.values.get(&name).cloned().ok_or(EvaluationError::Unknown(name));
        self.model.names().into_iter().map(value).collect()
    }

    fn next(&self, frame: &Environment<A::Value>) -> Result<Vec<A::Value>, EvaluationError> {
        let step = || self.model.next(self.arithmetic, &self.here(frame)?).ok_or(EvaluationError::Undefined);
        frame.next.get_or_init(step).clone()
    }

    fn back(&self, frame: &Environment<A::Value>) -> Result<Vec<A::Value>, EvaluationError> {
        let step = || {
            let mut here = self.here(frame)?;
            if let Some(eps) = here.last_mut() {
                *eps = self.arithmetic.negate(eps);
            }
            self.model.next(self.arithmetic, &here).ok_or(EvaluationError::Undefined)
        };
        frame.back.get_or_init(step).clone()
    }
}

/// Returns whether a call with this name depends on the field or the map of a system.
fn is_of_the_map(name: &str) -> bool {
    matches!(name, "next" | "back" | "on" | "f" | "b" | "A" | "J" | "Df" | "detA" | "detJ")
}
