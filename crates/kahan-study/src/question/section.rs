//! Crossings of orbits with a plane, or with another level set of a function.

mod orbits;
mod plane;
mod section_orbit;
mod side_by_side;

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_core::observe::Direction;
use kahan_discover::Watch;
use kahan_runtime::End;
use serde::de::Error;
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value, json};

use crate::axes;
use crate::error::StudyError;
use crate::numbers::exact;
use crate::rows::{Column, MOST_CELLS, Rows, StoredColumn, Table, Values, free_name};
use crate::study::Study;

use super::orbit::columns;
use super::over::{AxisOver, Cells, Over};
use super::{Question, usual_order};

use orbits::Orbits;
pub use plane::Plane;

/// A request for the crossings of one or many orbits with a section, in doubles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// ε, half the time step; ignored if ε is an axis.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// The first point, with a coordinate for each variable; ignored if there are `starts`.
    #[serde(with = "exact", default)]
    pub at: Vec<Rational>,
    /// The most steps of an orbit after the transient; by default 10 000 for each crossing.
    #[serde(default)]
    pub steps: Option<u64>,
    /// The formula that vanishes on the section, in the variables, the integrals claimed without a
    /// condition, the parameters and `eps`.
    pub plane: String,
    /// Whether rising, falling or all sign changes of the formula are crossings.
    #[serde(default, serialize_with = "name_of", deserialize_with = "of_name")]
    pub direction: Direction,
    /// The most crossings of an orbit; `None` for all.
    #[serde(default, alias = "points")]
    pub crossings: Option<u64>,
    /// The number of steps that are made first, and whose crossings are not shown.
    #[serde(default)]
    pub transient: u64,
    /// The order of the method. The errors of crossing times have the same order in ε.
    #[serde(default = "usual_order")]
    pub order: u32,
    /// Whether each step is projected, so that a lift's relations such as sin_x = sin(x) hold.
    #[serde(default)]
    pub reembed: bool,
    /// The first points of many orbits.
    #[serde(default, with = "exact", skip_serializing_if = "Vec::is_empty")]
    pub starts: Vec<Vec<Rational>>,
    /// Parameters, or `eps`, with a value for each first point.
    #[serde(default, with = "axes", skip_serializing_if = "Vec::is_empty")]
    pub params: Vec<AxisOver>,
    /// The axes, combined in all ways with each other and with the first points.
    #[serde(default, with = "axes", skip_serializing_if = "Vec::is_empty")]
    pub over: Vec<AxisOver>,
    /// Whether, along the last axis, each orbit starts at the last point of the previous orbit.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub carry: bool,
}

pub(super) fn name_of<S: Serializer>(direction: &Direction, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(direction.name())
}

pub(super) fn of_name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Direction, D::Error> {
    let name = String::deserialize(deserializer)?;
    let known = Direction::ALL.into_iter().find(|direction| direction.name() == name);
    known.ok_or_else(|| D::Error::unknown_variant(&name, &["rising", "falling", "both"]))
}

/// The crossings of some orbits.
#[derive(Clone, Debug)]
pub struct SectionFound {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The orbits, in the order of the rows.
    pub orbits: Vec<Crossed>,
    /// A row for each crossing: the number of the last step before it, its time, and the variables.
    /// For many orbits, the index of the first point and the varying values come first.
    pub rows: Table,
}

/// An orbit whose crossings were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossed {
    /// The index of the first point in the list.
    pub start: u64,
    /// The values on the axes that vary, in the order of the columns.
    pub values: Vec<f64>,
    /// The number of steps.
    pub steps: u64,
    /// The reason why the orbit ended. After all requested crossings, this is `Stopped`.
    pub end: End,
    /// A sentence that says why a step of a lifted field failed; `None` if no step failed.
    pub why: Option<String>,
    /// The number of crossings.
    pub crossings: u64,
    /// The number of sign changes at poles or jumps, which are not crossings.
    pub jumps: u64,
}

impl Section {
    /// Asks for rising crossings of one orbit.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>, steps: u64, plane: impl Into<String>) -> Self {
        Section {
            eps: Some(eps),
            at,
            steps: Some(steps),
            plane: plane.into(),
            direction: Direction::default(),
            crossings: None,
            transient: 0,
            order: usual_order(),
            reembed: false,
            starts: Vec::new(),
            params: Vec::new(),
            over: Vec::new(),
            carry: false,
        }
    }

    /// Returns whether the question is about many orbits.
    #[must_use]
    pub fn is_of_many(&self) -> bool {
        !self.starts.is_empty() || !self.over.is_empty()
    }

    /// Returns all crossings in memory.
    ///
    /// # Errors
    /// The errors of [`find`](Self::find), or more than [`MOST_CELLS`] cells.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<SectionFound, StudyError> {
        let mut rows = Table { columns: self.columns(study)?, values: Vec::new() };
        let mut few = LimitedRows { rows: &mut rows, cells: 0 };
        let orbits = self.find(study, &mut few, watch)?;
        if few.cells > MOST_CELLS {
            return Err(StudyError::TooLong { cells: few.cells });
        }
        let (system, variables) = (study.name().to_owned(), study.shown().to_vec());
        Ok(SectionFound { system, variables, orbits, rows })
    }

    /// Returns the columns of the table. Fails for axes that are unknown or not allowed.
    pub fn columns(&self, study: &Study) -> Result<Vec<Column>, StudyError> {
        Ok(self.columns_of(study, &Cells::with_starts(&self.as_over(), self.params.len(), study)?))
    }

    /// Returns an [`Over`] with a cell for each orbit. The axes of `params` follow the other axes.
    fn as_over(&self) -> Over {
        let axes = self.over.iter().chain(&self.params).cloned().collect();
        Over { starts: self.starts.clone(), ..Over::new(Question::Section(self.clone()), axes) }
    }

    fn columns_of(&self, study: &Study, cells: &Cells<'_>) -> Vec<Column> {
        let (shown, varying) = (study.shown(), cells.names());
        let column = |name: String, meaning: &str| Column { name, meaning: meaning.to_owned() };
        let start = column(free_name(&[shown, &varying].concat(), "start"), "number of the first point");
        let front = self.is_of_many().then_some(start).into_iter();
        let front = front.chain(varying.iter().map(|name| column(free_name(shown, name), "what varies")));
        let mut own = columns(&[shown, &varying].concat(), &[]);
        own.truncate(2 + shown.len());
        front.chain(own).collect()
    }

    /// Passes the crossings of each orbit to a consumer, one orbit after another. Costs the steps
    /// of the orbits, and some additional steps for each crossing. Memory does not grow with the
    /// number of crossings.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, a mistake in the formula `plane`, a field that is undefined at
    /// its parameters, or axes that the question does not allow.
    pub fn find(
        &self,
        study: &Study,
        rows: &mut dyn Rows,
        watch: &dyn Watch,
    ) -> Result<Vec<Crossed>, StudyError> {
        let over = self.as_over();
        let cells = Cells::with_starts(&over, self.params.len(), study)?;
        Ok(Orbits::of(self, study, &cells)?.find(rows, watch))
    }

    fn most_steps(&self) -> Result<u64, StudyError> {
        /// The number of steps for each crossing, if the question gives no number of steps.
        const STEPS_PER_CROSSING: u64 = 10_000;

        let by_crossings = || self.crossings.map(|crossings| crossings.saturating_mul(STEPS_PER_CROSSING));
        self.steps.or_else(by_crossings).ok_or(StudyError::MissingSteps)
    }
}

/// A consumer that collects rows until the table has `MOST_CELLS` cells.
struct LimitedRows<'a> {
    rows: &'a mut Table,
    cells: u64,
}

impl Rows for LimitedRows<'_> {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        self.cells += (columns.len() * values.first().map_or(0, Values::count)) as u64;
        if self.cells > MOST_CELLS {
            return ControlFlow::Break(());
        }
        if self.rows.values.is_empty() {
            self.rows.columns.clear();
        }
        self.rows.block(columns, values)
    }
}

impl SectionFound {
    /// Returns the only orbit, or the first of several.
    ///
    /// # Panics
    /// If there is no orbit.
    #[must_use]
    pub fn orbit(&self) -> &Crossed {
        &self.orbits[0]
    }

    /// Returns the number of crossings.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows.count()
    }

    fn numbers(&self, column: usize) -> &[f64] {
        match self.rows.values.get(column) {
            Some(StoredColumn::F64(values)) => values,
            _ => &[],
        }
    }

    fn front(&self) -> usize {
        self.rows.columns.len() - 2 - self.variables.len()
    }

    /// Returns the number of steps before each crossing.
    #[must_use]
    pub fn steps(&self) -> &[i64] {
        match self.rows.values.get(self.front()) {
            Some(StoredColumn::Integer(values)) => values,
            _ => &[],
        }
    }

    /// Returns the times of crossings.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        self.numbers(self.front() + 1)
    }

    /// Returns the variables at a crossing.
    #[must_use]
    pub fn point(&self, row: usize) -> Vec<f64> {
        let first = self.front() + 2;
        (first..first + self.variables.len()).map(|column| self.numbers(column)[row]).collect()
    }
}

/// Writes lists of times and points for one orbit, and a table for several orbits.
impl Serialize for SectionFound {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("system", &self.system)?;
        object.serialize_entry("variables", &self.variables)?;
        if let ([one], 0) = (&self.orbits[..], self.front()) {
            let points: Vec<Vec<f64>> = (0..self.count()).map(|row| self.point(row)).collect();
            object.serialize_entry("steps", &one.steps)?;
            object.serialize_entry("ended", one.end.name())?;
            object.serialize_entry("ended_step", &one.steps)?;
            object.serialize_entry("times", self.times())?;
            object.serialize_entry("points", &points)?;
            object.serialize_entry("jumps", &one.jumps)?;
            return object.end();
        }
        let names: Vec<&str> = self.rows.columns.iter().map(|column| &*column.name).collect();
        let ends = |one: &Crossed| {
            let mut end = Map::from_iter([(names[0].to_owned(), json!(one.start))]);
            end.extend(
                names[1..].iter().zip(&one.values).map(|(name, value)| ((*name).to_owned(), json!(value))),
            );
            let own = json!({
                "ended": one.end.name(), "ended_step": one.steps, "crossings": one.crossings, "jumps": one.jumps,
            });
            end.extend(
                own.as_object().into_iter().flatten().map(|(name, value)| (name.clone(), value.clone())),
            );
            Value::Object(end)
        };
        object.serialize_entry("orbits", &self.orbits.iter().map(ends).collect::<Vec<_>>())?;
        object.serialize_entry("columns", &names)?;
        object.serialize_entry("rows", &self.rows)?;
        object.end()
    }
}
