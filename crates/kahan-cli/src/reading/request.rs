//! What an evaluation or an orbit begins with, read and checked.

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::interpret::Point;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_study::{Axis, StudyError};

use super::points::points;
use super::source::Start;
use crate::numbers::Printable;
use crate::printing::{Refusal, shorten};

/// A system with a point, parameters and ε, exactly.
#[derive(Debug)]
pub(crate) struct Request {
    /// The system's name in answers.
    pub(crate) name: String,
    pub(crate) system: System,
    pub(crate) point: Point<Rational>,
}

impl Start {
    /// The system with its claims proved, and the numbers, with all first points of `--at`, each of
    /// which may take the place of the request's, which is the first of them.
    pub(crate) fn request_and_starts(&self, axes: &[Axis]) -> Result<(Request, Vec<Vec<Rational>>), Refusal> {
        let block = self.source.required_block()?;
        let system = block.system()?;
        let name = block.name(&system);
        let symbols = &system.field.symbols;
        let mut source = self.source.clone();
        for axis in axes.iter().filter(|axis| symbols.parameters.contains(&axis.name)) {
            if !source.has_parameter(&axis.name) {
                source = source.with_parameter(&axis.name, &axis.range.value(0));
            }
        }
        let starts = points(self.at.as_deref().unwrap_or_default(), &symbols.states)?;
        let of_axis = axes.iter().find(|axis| axis.name == "eps").map(|axis| axis.range.value(0));
        let point = Point {
            state: starts[0].clone(),
            parameters: source.parameter_values(&system, &name)?,
            eps: self.half_step()?.or(of_axis).ok_or(StudyError::MissingStep)?,
        };
        Ok((Request { name, system, point }, starts))
    }
}

impl Request {
    /// The field divides by zero at the parameters.
    pub(crate) fn undefined_field(&self) -> Refusal {
        let values = assignments::<Exact>(&self.system.field.symbols.parameters, &self.point.parameters);
        Refusal::new(format!("the field of {} divides by zero at {values}; choose other values", self.name))
    }

    /// A state with the parameters and ε, in words.
    pub(crate) fn place<A: Printable>(&self, state: &[A::Value]) -> String {
        let symbols = &self.system.field.symbols;
        let parts = [
            assignments::<A>(&symbols.states, state),
            assignments::<Exact>(&symbols.parameters, &self.point.parameters),
            assignments::<Exact>(&["eps".to_owned()], std::slice::from_ref(&self.point.eps)),
        ];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
    }
}

/// `x = 1, y = 2`, long numbers cut.
pub(super) fn assignments<A: Printable>(names: &[String], values: &[A::Value]) -> String {
    const DIGITS: usize = 40;
    let parts = names.iter().zip(values).map(|(name, value)| {
        let mut text = String::new();
        A::append(value, &mut text);
        format!("{name} = {}", shorten(&text, DIGITS))
    });
    parts.collect::<Vec<_>>().join(", ")
}
