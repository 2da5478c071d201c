//! What a sweep goes through: starts, parameters, ε, the order, the scalar.

use std::fmt;

use kahan_algebra::rational::Rational;

use crate::draw::Draw;

/// What an axis gives a value to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// The first value of the variable with this index.
    Variable(usize),
    /// The parameter with this index.
    Parameter(usize),
    /// ε, half the time step.
    Epsilon,
    /// The order of the method.
    Order,
    /// The bits of the scalar.
    Bits,
}

/// The values of an axis.
#[derive(Clone, Debug)]
pub(crate) enum Values {
    /// One after another, at least one.
    List(Vec<Rational>),
    /// `from`, and so many values a `step` apart.
    Grid { from: Rational, step: Rational, count: u64 },
    /// Between two numbers, at the plan's draws.
    Drawn { source: Box<Draw>, kind: &'static str, low: Rational, high: Rational },
}

/// One axis of a sweep.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// Its name in the plan, and of its column.
    pub(crate) name: String,
    pub(crate) target: Target,
    pub(crate) values: Values,
}

impl Axis {
    /// How many values it has; `None` where the plan's draws say it.
    pub(crate) fn count(&self) -> Option<u64> {
        match &self.values {
            Values::List(values) => Some(values.len() as u64),
            Values::Grid { count, .. } => Some(*count),
            Values::Drawn { .. } => None,
        }
    }

    /// Whether it has more than one value.
    pub(crate) fn varies(&self) -> bool {
        self.count() != Some(1)
    }

    /// The value with this index; a drawn one is a double, exactly.
    pub(crate) fn value(&self, index: u64) -> Rational {
        match &self.values {
            Values::List(values) => values[index as usize].clone(),
            Values::Grid { from, step, .. } => from + &(step * &Rational::from(index as i64)),
            Values::Drawn { .. } => Rational::from_f64(self.double(index)).unwrap_or_default(),
        }
    }

    /// The same, rounded to a double.
    pub(crate) fn double(&self, index: u64) -> f64 {
        match &self.values {
            Values::Drawn { source, low, high, .. } => {
                let (low, high) = (low.to_f64(), high.to_f64());
                low + (high - low) * source.at(index)
            }
            Values::List(values) => values[index as usize].to_f64(),
            Values::Grid { .. } => self.value(index).to_f64(),
        }
    }

    /// What it stands for, with its unit.
    pub(crate) fn meaning(&self) -> &'static str {
        match self.target {
            Target::Variable(_) => "first value of the variable",
            Target::Parameter(_) => "value of the parameter",
            Target::Epsilon => "half the time step, in units of time",
            Target::Order => "order of the method",
            Target::Bits => "bits of the scalar",
        }
    }
}

/// As the plan's hash has it: the same for the same values, however they are written.
impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = ", self.name)?;
        match &self.values {
            Values::List(values) => {
                let values: Vec<String> = values.iter().map(ToString::to_string).collect();
                write!(f, "[{}]", values.join(", "))
            }
            Values::Grid { from, step, count } => write!(f, "{count} values from {from}, {step} apart"),
            Values::Drawn { kind, low, high, .. } => write!(f, "{kind} from {low} to {high}"),
        }
    }
}
