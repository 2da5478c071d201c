//! What a question over axes goes through: names, and for each its values.
//!
//! In: JSON, or values. Out: the value that has an index, exactly and in doubles. What a name
//! stands for in a field, its neighbour `cells` knows.

use kahan_algebra::rational::Rational;
use serde::{Deserialize, Serialize};

use crate::draw::{Sobol, Uniform};
use crate::numbers::exact;
use crate::range::{Axis, Range};

/// A name with the values that it goes through: a variable, whose first value it is, a parameter,
/// `eps`, and of orbits the `order` of the method and the `bits` of the floats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "Written", try_from = "Written")]
pub struct Varied {
    /// What goes through them.
    pub name: String,
    /// The values.
    pub through: Through,
}

/// The values that something goes through.
#[derive(Clone, Debug, PartialEq)]
pub enum Through {
    /// Equally far from each other.
    Range(Range),
    /// One after the other.
    List(Vec<Rational>),
    /// As many as the question has draws, which go through all drawn axes together.
    Drawn {
        /// From where.
        source: Source,
        /// Above or at this.
        low: Rational,
        /// Below this.
        high: Rational,
    },
}

/// From where numbers are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Source {
    /// Sobol's sequence, a dimension an axis: evenly, all drawn axes together.
    Sobol,
    /// At random, by the seed of the question.
    Uniform,
}

impl From<Axis> for Varied {
    fn from(Axis { name, range }: Axis) -> Self {
        Varied { name, through: Through::Range(range) }
    }
}

/// As it stands in JSON.
#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Written {
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    range: Option<Range>,
    #[serde(skip_serializing_if = "Vec::is_empty", with = "exact")]
    values: Vec<Rational>,
    #[serde(skip_serializing_if = "Option::is_none")]
    draw: Option<Source>,
    #[serde(skip_serializing_if = "Option::is_none", with = "exact")]
    low: Option<Rational>,
    #[serde(skip_serializing_if = "Option::is_none", with = "exact")]
    high: Option<Rational>,
}

impl From<Varied> for Written {
    fn from(Varied { name, through }: Varied) -> Self {
        let mut written = Written { name, ..Written::default() };
        match through {
            Through::Range(range) => written.range = Some(range),
            Through::List(values) => written.values = values,
            Through::Drawn { source, low, high } => {
                (written.draw, written.low, written.high) = (Some(source), Some(low), Some(high));
            }
        }
        written
    }
}

impl TryFrom<Written> for Varied {
    type Error = String;

    fn try_from(Written { name, range, values, draw, low, high }: Written) -> Result<Self, String> {
        let through = match (range, values.is_empty(), draw, low, high) {
            (Some(range), true, None, None, None) => Through::Range(range),
            (None, false, None, None, None) => Through::List(values),
            (None, true, Some(source), Some(low), Some(high)) => Through::Drawn { source, low, high },
            _ => {
                return Err(format!(
                    "the axis `{name}` has either a `range`, as \"0:1:/9\", or a list of `values`, or `draw`, `low` and `high`"
                ));
            }
        };
        Ok(Varied { name, through })
    }
}

/// The number 0 ≤ u < 1 that has an index.
type Draw = dyn Fn(u64) -> f64 + Sync;

/// The values of an axis, found by their indices.
pub(super) enum Values<'a> {
    List(&'a [Rational]),
    Spaced { first: Rational, step: Rational, count: u64 },
    Drawn { draw: Box<Draw>, low: f64, high: f64 },
}

impl<'a> Values<'a> {
    /// Returns the values of the axis at `place`; drawn axes have `draws` values, by the seed.
    pub(super) fn of(axes: &'a [Varied], place: usize, draws: u64, seed: u64) -> Result<Self, String> {
        let is_sobol = |axis: &&Varied| matches!(axis.through, Through::Drawn { source: Source::Sobol, .. });
        match &axes[place].through {
            Through::List(values) if values.is_empty() => {
                Err("there are no values; give at least one".into())
            }
            Through::List(values) => Ok(Values::List(values)),
            Through::Range(range) => {
                Ok(Values::Spaced { first: range.value(0), step: range.step(), count: range.count() as u64 })
            }
            Through::Drawn { source, low, high } => {
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

    /// How many there are; `None` where the draws say it.
    pub(super) fn count(&self) -> Option<u64> {
        match self {
            Values::List(values) => Some(values.len() as u64),
            Values::Spaced { count, .. } => Some(*count),
            Values::Drawn { .. } => None,
        }
    }

    /// The one with this index; a drawn one is a double, exactly.
    pub(super) fn exactly(&self, index: u64) -> Rational {
        match self {
            Values::List(values) => values[index as usize].clone(),
            Values::Spaced { first, step, .. } => first + &(step * &Rational::from(index as i64)),
            Values::Drawn { .. } => {
                Rational::from_f64(self.double(index)).expect("it is between two doubles")
            }
        }
    }

    /// The same, rounded to a double.
    pub(super) fn double(&self, index: u64) -> f64 {
        match self {
            Values::List(values) => values[index as usize].to_f64(),
            Values::Spaced { .. } => self.exactly(index).to_f64(),
            Values::Drawn { draw, low, high } => low + (high - low) * draw(index),
        }
    }
}
