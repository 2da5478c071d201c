//! Questions, which are read from JSON, and their answers.
//!
//! A question in JSON has a name `ask` and further fields, such as
//! `{"ask": "evaluate", "eps": "1/2", "at": [1, 2, 3]}`. Each question here has a file with its
//! fields, its answer and `ask`. The question `trade` is in the module [`crate::trade`].

mod over;

use std::ops::{ControlFlow, Range};
use std::time::Duration;

use kahan_discover::Watch;
use kahan_runtime::End;
use serde::de::{Error as _, value};
use serde::ser::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value, json};

use crate::error::StudyError;
use crate::misread::{Misread, read};
use crate::rows::{Column, Rows, Values};
use crate::study::Study;
use crate::trade::{Trade, Traded};

use over::AtCell;

pub use over::{AxisOver, AxisValues, Over, OverFound, Source};

macro_rules! questions {
    ($(
        $(#[$about:meta])*
        $question:ident, asked as $name:literal, answered by $answer:ident
            $(, in $module:ident)? $(, with $feature:literal)? $(, also $at_cell:ident)?;
    )*) => {
        $(
            $(#[cfg(feature = $feature)])?
            $(mod $module;)?
            $(#[cfg(feature = $feature)])?
            $(pub use $module::*;)?
        )*

        /// A question about a field.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Question {
            $($(#[cfg(feature = $feature)])? $(#[$about])* $question($question),)*
            /// A question asked at each combination of the values of some axes.
            Over(Over),
        }

        /// The answer to a question.
        #[derive(Clone, Debug, Serialize)]
        #[serde(untagged)]
        pub enum Answer {
            $($(#[cfg(feature = $feature)])? $(#[$about])* $question(Box<$answer>),)*
            /// A table with a row for each combination of axis values.
            Over(Box<OverFound>),
        }

        const NAMES: &[&str] = &[$($(#[cfg(feature = $feature)])? $name),*];

        impl Question {
            /// The names of the questions that [`Over`] can ask at each combination of axis values.
            pub const OVER_AXES: &[&str] = &["observe", $($((stringify!($at_cell), $name).1,)?)*];

            /// Returns the name of the question, the value of `ask`.
            #[must_use]
            pub fn name(&self) -> &'static str {
                match self {
                    $($(#[cfg(feature = $feature)])? Self::$question(_) => $name,)*
                    Self::Over(asked) => asked.question.name(),
                }
            }

            /// Returns the question as an `AtCell`, which [`Over`] asks at each combination of axis
            /// values. Fails if an answer to the question does not fit into a row of a table.
            fn at_cell(&self) -> Result<&dyn AtCell, StudyError> {
                match self {
                    $($(Self::$question(asked) => Ok(asked as &dyn $at_cell),)?)*
                    other => Err(StudyError::NoRows(other.name())),
                }
            }

            fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Answer, StudyError> {
                Ok(match self {
                    $(
                        $(#[cfg(feature = $feature)])?
                        Self::$question(asked) => Answer::$question(Box::new(asked.ask(study, watch)?)),
                    )*
                    Self::Over(asked) => Answer::Over(Box::new(asked.ask(study, watch)?)),
                })
            }

            /// Reads the question called `name` from the other fields of the JSON object.
            fn from_fields(name: &str, rest: Map<String, Value>) -> Result<Self, Misread> {
                match name {
                    $(
                        $(#[cfg(feature = $feature)])?
                        $name => read(Value::Object(rest)).map(Self::$question),
                    )*
                    other => Err(Misread::at("ask", value::Error::unknown_variant(other, NAMES).to_string())),
                }
            }

            /// Returns the fields without the name; `None` for [`Over`].
            fn rest(&self) -> Option<Value> {
                match self {
                    $($(#[cfg(feature = $feature)])? Self::$question(asked) => Some(json!(asked)),)*
                    Self::Over(_) => None,
                }
            }
        }
    };
}

questions! {
    /// The formulas of the field.
    Show, asked as "show", answered by ShownField, in show;
    /// The values of the field, the map and the claims at a point.
    Evaluate, asked as "evaluate", answered by Evaluated, in evaluate, also AtCell;
    /// The points of an orbit.
    Orbit, asked as "orbit", answered by Orbited, in orbit;
    /// Observables of an orbit, such as exponents and chaos indicators.
    Observe, asked as "observe", answered by Observed, in observe;
    /// The crossings of orbits with a plane.
    Section, asked as "section", answered by SectionFound, in section;
    /// The values of a variable at late times, for each value of a parameter.
    Diagram, asked as "diagram", answered by DiagramFound, in diagram;
    /// A cycle and, if requested, its continuation in a parameter.
    Periodic, asked as "periodic", answered by CycleFound, in periodic;
    /// The growth of numerators and denominators along an exact orbit.
    Heights, asked as "heights", answered by HeightsFound, in heights, also AtCell;
    /// The images of curves that the map contracts or sends to infinity.
    Poles, asked as "poles", answered by PolesFound, in poles;
    /// The structures that the map preserves.
    Discover, asked as "discover", answered by Discovered, in discover, also AtCell;
    /// Special values of parameters and of ε.
    Scan, asked as "scan", answered by ScanFound, in scan;
    /// The cheapest way to compute an orbit with a required accuracy.
    Trade, asked as "trade", answered by Traded;
    /// A check of claims.
    Verify, asked as "verify", answered by Verified, in verify, with "paper";
}

impl Study {
    /// Answers a question.
    ///
    /// # Errors
    /// [`StudyError`]: the question does not fit the field, or has no answer.
    pub fn ask(&self, question: &Question, watch: &dyn Watch) -> Result<Answer, StudyError> {
        question.ask(self, watch)
    }

    /// Passes the rows in `range`, counted from 0, to a consumer. Returns how the table ended.
    ///
    /// # Errors
    /// [`StudyError::NoRows`] if the answer is not a table, and the errors of the question.
    pub fn rows(
        &self,
        question: &Question,
        range: Range<u64>,
        rows: &mut dyn Rows,
        watch: &dyn Watch,
    ) -> Result<End, StudyError> {
        match question {
            Question::Orbit(asked) => Ok(asked.begin(&asked.study(self)?)?.rows(range, rows, watch).end),
            Question::Over(asked) => asked.rows(self, range, rows, watch),
            Question::Section(asked) => {
                let mut within = RowRange { range, row: 0, rows };
                let orbits = asked.find(self, &mut within, watch)?;
                Ok(orbits.last().map_or(End::Complete, |last| last.end))
            }
            other => Err(StudyError::NoRows(other.name())),
        }
    }
}

/// A consumer that passes on only the rows in a range.
struct RowRange<'a> {
    range: Range<u64>,
    row: u64,
    rows: &'a mut dyn Rows,
}

impl Rows for RowRange<'_> {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        let count = values.first().map_or(0, Values::count) as u64;
        let own = self.row..self.row + count;
        self.row = own.end;
        if own.start >= self.range.end {
            return ControlFlow::Break(());
        }
        let ends = [self.range.start, self.range.end];
        let [first, last] = ends.map(|end| (end.clamp(own.start, own.end) - own.start) as usize);
        let part: Vec<Values<'_>> = values.iter().map(|values| values.part(first..last)).collect();
        self.rows.block(columns, &part)
    }
}

impl Question {
    /// Reads a question from JSON, or returns the first mistake with its path.
    pub fn read(mut object: Map<String, Value>) -> Result<Self, Misread> {
        let Some(name) = object.remove("ask") else {
            return Err(Misread { path: Vec::new(), why: "missing field `ask`".to_owned() });
        };
        let name = name.as_str().unwrap_or_default();
        // Other questions, such as `Diagram`, may have a field `over` of their own.
        if Self::OVER_AXES.contains(&name) && object.contains_key("over") {
            Over::read(name, object).map(Self::Over)
        } else {
            Self::from_fields(name, object)
        }
    }
}

impl Serialize for Question {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match (self, self.rest()) {
            (Self::Over(asked), _) => asked.serialize(serializer),
            (_, Some(Value::Object(rest))) => {
                let name = ("ask".to_owned(), json!(self.name()));
                std::iter::once(name).chain(rest).collect::<Map<_, _>>().serialize(serializer)
            }
            _ => Err(S::Error::custom("a question is an object")),
        }
    }
}

impl<'de> Deserialize<'de> for Question {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Question::read(Map::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// The default value of several fields, such as `period` and `every`.
fn one<T: From<u8>>() -> T {
    T::from(1)
}

/// The default order of the method: Kahan's map itself.
fn usual_order() -> u32 {
    2
}

/// The default time limit of a question, in seconds.
fn minute() -> f64 {
    60.0
}

/// Returns the seconds since `begun`; `None` without a clock.
fn seconds_since(begun: Option<Duration>, watch: &dyn Watch) -> Option<f64> {
    Some(watch.now()?.saturating_sub(begun?).as_secs_f64())
}
