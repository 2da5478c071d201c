//! What a question over axes goes through: names, and for each its values.
//!
//! In: JSON, or values. Out: the value that has an index, exactly and in doubles. What a name
//! stands for in a field, its neighbour `cells` knows.

use kahan_algebra::rational::Rational;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::draw::{Draw, Sobol, Uniform};
use crate::numbers::exact;
use crate::range::{Axis, Range};

/// A name with the values that it goes through: a variable, whose first value it is, a parameter,
/// `eps`, and of orbits the `order` of the method and the `bits` of the floats.
#[derive(Clone, Debug, PartialEq)]
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
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    name: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    range: Option<Range>,
    #[serde(default, skip_serializing_if = "Option::is_none", with = "exact::optional_list")]
    values: Option<Vec<Rational>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    draw: Option<Source>,
    #[serde(default, skip_serializing_if = "Option::is_none", with = "exact::optional")]
    low: Option<Rational>,
    #[serde(default, skip_serializing_if = "Option::is_none", with = "exact::optional")]
    high: Option<Rational>,
}

impl Serialize for Varied {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let name = self.name.clone();
        let mut written = Written { name, range: None, values: None, draw: None, low: None, high: None };
        match self.through.clone() {
            Through::Range(range) => written.range = Some(range),
            Through::List(values) => written.values = Some(values),
            Through::Drawn { source, low, high } => {
                (written.draw, written.low, written.high) = (Some(source), Some(low), Some(high));
            }
        }
        written.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Varied {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Written { name, range, values, draw, low, high } = Written::deserialize(deserializer)?;
        let through = match (range, values, draw, low, high) {
            (Some(range), None, None, None, None) => Through::Range(range),
            (None, Some(values), None, None, None) => Through::List(values),
            (None, None, Some(source), Some(low), Some(high)) => Through::Drawn { source, low, high },
            _ => {
                return Err(D::Error::custom(format!(
                    "the axis `{name}` has either a `range`, as \"0:1:/9\", or a list of `values`, or `draw`, `low` and `high`"
                )));
            }
        };
        Ok(Varied { name, through })
    }
}

/// The values of an axis, found by their indices.
pub(super) enum Values<'a> {
    List(&'a [Rational]),
    Spaced { first: Rational, step: Rational, count: u64 },
    Drawn { from: Draw, low: f64, high: f64 },
}

impl<'a> Values<'a> {
    /// Those of the axis at a place among others, by the seed of their question.
    pub(super) fn of(axes: &'a [Varied], place: usize, seed: u64) -> Result<Self, String> {
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
                let from = match source {
                    Source::Uniform => Draw::Uniform(Uniform::new(seed, place)),
                    Source::Sobol => {
                        let dimension = axes[..place].iter().filter(is_sobol).count();
                        Draw::Sobol(Sobol::dimension(dimension)?)
                    }
                };
                let [first, last] = [low, high].map(Rational::to_f64);
                if low >= high || !(first.is_finite() && last.is_finite()) {
                    return Err("low is below high, both within the range of doubles".into());
                }
                Ok(Values::Drawn { from, low: first, high: last })
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
            Values::Drawn { from, low, high } => low + (high - low) * from.at(index),
        }
    }
}
