//! What an evaluation or an orbit begins with, read and checked.

use kahan_algebra::interpret::Point;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_runtime::{Field, MapAt};
use kahan_study::{Axis, StudyError};

use super::points::point;
use super::source::Start;
use crate::printing::Refusal;

/// A system with a point, parameters and ε, exactly.
#[derive(Debug)]
pub(crate) struct Request {
    /// The system's name in answers.
    pub(crate) name: String,
    pub(crate) system: System,
    pub(crate) point: Point<Rational>,
}

impl Start {
    /// The system with its claims proved, and the numbers; parameters and ε that are gone through
    /// need no value besides.
    pub(crate) fn request_over(&self, axes: &[Axis]) -> Result<Request, Refusal> {
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
        let state = point(self.at.as_deref().unwrap_or_default(), &symbols.states)?;
        let of_axis = axes.iter().find(|axis| axis.name == "eps").map(|axis| axis.range.value(0));
        let point = Point {
            state,
            parameters: source.parameter_values(&system, &name)?,
            eps: self.half_step()?.or(of_axis).ok_or(StudyError::MissingStep)?,
        };
        Ok(Request { name, system, point })
    }
}

impl Request {
    /// The map at ε, and the first point, in floats.
    pub(crate) fn in_floats(&self) -> Result<(MapAt<f64>, Vec<f64>), Refusal> {
        let field = Field::of(&self.system);
        let values = field.parameters().iter().zip(&self.point.parameters);
        let map = field.with(values).map_err(|_| self.undefined_field())?;
        let numbers = self.point.state.iter().chain([&self.point.eps]).map(Rational::to_f64);
        let mut start: Vec<f64> = numbers.collect();
        if !start.iter().all(|number| number.is_finite()) {
            return Err(Refusal::new("--at and --eps must be in the range of f64"));
        }
        let eps = start.pop().expect("eps stands last");
        Ok((map.at(eps), start))
    }

    /// The field divides by zero at the parameters.
    pub(crate) fn undefined_field(&self) -> Refusal {
        let names = self.system.field.symbols.parameters.iter().cloned();
        let parameters = names.zip(self.point.parameters.iter().cloned()).collect();
        StudyError::UndefinedField { system: self.name.clone(), parameters }.into()
    }
}
