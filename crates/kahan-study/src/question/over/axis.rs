//! The axes of a question: names with their values.

use kahan_algebra::rational::Rational;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::axes::NamedValues;
use crate::draw::{Sobol, Uniform};
use crate::numbers::ScalarKind;
use crate::numbers::exact::{self, ExactJson};
use crate::range::{Axis, Range};

/// An axis: its name and its values. The name is that of a variable or parameter, or `eps`. For
/// orbits it can also be `order` or `scalar`.
///
/// In JSON an axis is an entry of an object: a [`Range`] `"x": "0:1:/9"`, a list `"x": [0, "1/2"]`,
/// one value `"x": 1`, or draws `"x": {"draw": "sobol", "low": 0, "high": 1}`.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisOver {
    /// The name of the axis.
    pub name: String,
    /// The values.
    pub through: AxisValues,
}

/// The values of an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisValues {
    /// Equally spaced values.
    Range(Range),
    /// Listed values.
    List(Vec<Rational>),
    /// Listed scalars.
    Scalars(Vec<ScalarKind>),
    /// Random or quasi-random values. The question sets the number of values; all drawn axes vary
    /// together.
    Drawn {
        /// The source of the draws.
        source: Source,
        /// The lower bound, included.
        low: Rational,
        /// The upper bound, excluded.
        high: Rational,
    },
}

/// A source of draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Source {
    /// Sobol's sequence, which fills the box of the drawn axes evenly.
    Sobol,
    /// Random numbers from the seed of the question.
    Uniform,
}

impl From<Axis> for AxisOver {
    fn from(Axis { name, range }: Axis) -> Self {
        AxisOver { name, through: AxisValues::Range(range) }
    }
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct DrawnValues {
    draw: Source,
    #[serde(with = "exact")]
    low: Rational,
    #[serde(with = "exact")]
    high: Rational,
}

impl NamedValues for AxisOver {
    fn name(&self) -> &str {
        &self.name
    }

    fn to_json(&self) -> Value {
        match &self.through {
            AxisValues::Range(range) => json!(range),
            AxisValues::List(values) => values.to_json(),
            AxisValues::Scalars(scalars) => json!(scalars),
            AxisValues::Drawn { source, low, high } => {
                json!(DrawnValues { draw: *source, low: low.clone(), high: high.clone() })
            }
        }
    }

    fn of_json(name: &str, value: Value) -> Result<Self, String> {
        let wrong = |why: serde_json::Error| why.to_string();
        let list = |value| if let Value::Array(list) = value { list } else { vec![value] };
        let through = match value {
            value if name == "scalar" => {
                AxisValues::Scalars(serde_json::from_value(Value::Array(list(value))).map_err(wrong)?)
            }
            Value::String(text) if text.contains(':') => {
                AxisValues::Range(Range::of_table(&text).map_err(|why| why.to_string())?)
            }
            Value::Object(_) => {
                let drawn = serde_json::from_value(value).map_err(wrong);
                let DrawnValues { draw, low, high } =
                    drawn.map_err(|why| format!("{why}; a range is a text, as \"0:1:11\""))?;
                AxisValues::Drawn { source: draw, low, high }
            }
            value => AxisValues::List(Vec::of_json(&Value::Array(list(value)))?),
        };
        Ok(AxisOver { name: name.to_owned(), through })
    }
}

/// A function that returns the draw 0 ≤ u < 1 with a given index.
type Draw = dyn Fn(u64) -> f64 + Sync;

pub(super) enum Values<'a> {
    List(&'a [Rational]),
    /// The scalars `f64` and `f32`, stored as the numbers 64 and 32.
    Scalars(Vec<Rational>),
    Spaced {
        first: Rational,
        step: Rational,
        count: u64,
    },
    Drawn {
        draw: Box<Draw>,
        low: f64,
        high: f64,
    },
}

impl<'a> Values<'a> {
    /// Builds the values of the axis at index `place`; a drawn axis gets `draws` values.
    pub(super) fn of(axes: &'a [AxisOver], place: usize, draws: u64, seed: u64) -> Result<Self, String> {
        let is_sobol =
            |axis: &&AxisOver| matches!(axis.through, AxisValues::Drawn { source: Source::Sobol, .. });
        match &axes[place].through {
            AxisValues::List(values) if values.is_empty() => {
                Err("there are no values; give at least one".into())
            }
            AxisValues::List(values) => Ok(Values::List(values)),
            AxisValues::Scalars(scalars) => {
                let bits = |scalar: &ScalarKind| match scalar {
                    ScalarKind::F64 => Ok(Rational::from(64)),
                    ScalarKind::F32 => Ok(Rational::from(32)),
                    other => Err(format!("{} is none of f64, f32", other.name())),
                };
                scalars.iter().map(bits).collect::<Result<_, _>>().map(Values::Scalars)
            }
            AxisValues::Range(range) => {
                Ok(Values::Spaced { first: range.value(0), step: range.step(), count: range.count() as u64 })
            }
            AxisValues::Drawn { source, low, high } => {
                let draw: Box<Draw> = match source {
                    Source::Uniform => {
                        let uniform = Uniform::new(seed, place);
                        Box::new(move |index| uniform.at(index))
                    }
                    Source::Sobol => {
                        let sobol = Sobol::dimension(axes[..place].iter().filter(is_sobol).count(), draws)?;
                        Box::new(move |index| sobol.at(index))
                    }
                };
                let [first, last] = [low, high].map(Rational::to_f64);
                if low >= high || !(first.is_finite() && last.is_finite()) {
                    return Err("low is below high, both within the range of doubles".into());
                }
                Ok(Values::Drawn { draw, low: first, high: last })
            }
        }
    }

    pub(super) fn count(&self) -> Option<u64> {
        match self {
            Values::List(values) => Some(values.len() as u64),
            Values::Scalars(values) => Some(values.len() as u64),
            Values::Spaced { count, .. } => Some(*count),
            Values::Drawn { .. } => None,
        }
    }

    /// Returns the value at an index; a drawn value is a double, converted exactly.
    pub(super) fn exactly(&self, index: u64) -> Rational {
        match self {
            Values::List(values) => values[index as usize].clone(),
            Values::Scalars(values) => values[index as usize].clone(),
            Values::Spaced { first, step, .. } => first + &(step * &Rational::from(index as i64)),
            Values::Drawn { .. } => {
                Rational::from_f64(self.double(index)).expect("it is between two doubles")
            }
        }
    }

    pub(super) fn double(&self, index: u64) -> f64 {
        match self {
            Values::List(values) => values[index as usize].to_f64(),
            Values::Scalars(_) | Values::Spaced { .. } => self.exactly(index).to_f64(),
            Values::Drawn { draw, low, high } => low + (high - low) * draw(index),
        }
    }
}
