//! Where orbits cross a plane, or the level of any function.

mod abreast;
mod course;
mod orbits;
mod plane;

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
use crate::rows::{Column, Kept, MOST_CELLS, Rows, Table, Values, free_name};
use crate::study::Study;

use super::orbit::columns;
use super::over::{Cells, Over, Varied};
use super::{Question, usual_order};

use orbits::Orbits;
pub use plane::Plane;

/// Asks where orbits cross a section, in doubles: the orbit of one point, or of many points and
/// values of parameters, each with crossings of its own.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// ε, half the time step; not looked at where it goes through values.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// The first point, a coordinate for each variable; not looked at where there are `starts`.
    #[serde(with = "exact", default)]
    pub at: Vec<Rational>,
    /// The most steps of an orbit behind the transient; where only crossings are counted, ten
    /// thousand for each.
    #[serde(default)]
    pub steps: Option<u64>,
    /// What vanishes on the section: a formula of the variables, the integrals that are claimed
    /// without `when`, the parameters and `eps`.
    pub plane: String,
    /// Which sign changes count.
    #[serde(default, serialize_with = "name_of", deserialize_with = "of_name")]
    pub direction: Direction,
    /// The most crossings of an orbit; all where none are counted.
    #[serde(default, alias = "points")]
    pub crossings: Option<u64>,
    /// The first steps of an orbit, which are not looked at.
    #[serde(default)]
    pub transient: u64,
    /// The order of the method; a crossing is on its step with a part of ε, so its time has an
    /// error of that order, too.
    #[serde(default = "usual_order")]
    pub order: u32,
    /// Whether each step of a lifted field is projected symmetrically onto the relations between
    /// its variables.
    #[serde(default)]
    pub reembed: bool,
    /// First points of many orbits.
    #[serde(default, with = "exact", skip_serializing_if = "Vec::is_empty")]
    pub starts: Vec<Vec<Rational>>,
    /// Parameters, or `eps`, with a value for each of the first points.
    #[serde(default, with = "axes", skip_serializing_if = "Vec::is_empty")]
    pub params: Vec<Varied>,
    /// What goes through values, all multiplied with each other and with the first points.
    #[serde(default, with = "axes", skip_serializing_if = "Vec::is_empty")]
    pub over: Vec<Varied>,
    /// Whether an orbit begins at the last point of that at the value before, of the last axis.
    /// Only the first one begins at its first point.
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
    /// A row a crossing: of many orbits the number of the first point and what varies; the step n
    /// that the crossing comes after, its time, the variables.
    pub rows: Table,
}

/// An orbit whose crossings were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossed {
    /// The number of its first point, among those that are listed.
    pub start: u64,
    /// The values of what varies, in the order of the columns.
    pub values: Vec<f64>,
    /// The steps that were made.
    pub steps: u64,
    /// How the orbit ended; it is stopped where it has so many crossings as were asked for.
    pub end: End,
    /// Why, where the end is one of the lift.
    pub why: Option<String>,
    /// The number of its crossings.
    pub crossings: u64,
    /// How often the formula changes its sign in the directions that count, but has no zero: at a
    /// pole of the formula or of the map, or where the formula jumps.
    pub jumps: u64,
}

impl Section {
    /// Rising crossings of one orbit.
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

    /// Whether it is about many orbits, whose rows tell which one they are of.
    #[must_use]
    pub fn is_of_many(&self) -> bool {
        !self.starts.is_empty() || !self.over.is_empty()
    }

    /// All crossings in memory.
    ///
    /// # Errors
    /// Those of [`crossings`](Self::crossings), and more than [`MOST_CELLS`].
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<SectionFound, StudyError> {
        let mut rows = Table { columns: self.columns(study)?, values: Vec::new() };
        let mut few = Few { rows: &mut rows, cells: 0 };
        let orbits = self.find(study, &mut few, watch)?;
        if few.cells > MOST_CELLS {
            return Err(StudyError::TooLong { cells: few.cells });
        }
        let (system, variables) = (study.name().to_owned(), study.shown().to_vec());
        Ok(SectionFound { system, variables, orbits, rows })
    }

    /// The columns of the table.
    ///
    /// # Errors
    /// Axes that the field does not have, or that do not fit.
    pub fn columns(&self, study: &Study) -> Result<Vec<Column>, StudyError> {
        Ok(self.columns_of(study, &Cells::with_starts(&self.as_over(), self.params.len(), study)?))
    }

    /// The orbits as cells of axes, those of `params` last.
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

    /// Hands on the crossings of each orbit, one orbit after the other. Follows orbits of a system
    /// whose claims hold, and refines each crossing on the curve that the step draws as ε grows from
    /// 0. Costs the orbits, and some steps a crossing; memory does not grow with the crossings.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, a plane that is no formula or a number, a field that is not defined at its
    /// parameters, axes that do not fit.
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

    /// The most steps that are looked at.
    fn most_steps(&self) -> Result<u64, StudyError> {
        /// Steps a crossing where only crossings are counted.
        const EACH: u64 = 10_000;

        let by_crossings = || self.crossings.map(|crossings| crossings.saturating_mul(EACH));
        self.steps.or_else(by_crossings).ok_or(StudyError::MissingSteps)
    }
}

/// Takes as many rows as an answer may have.
struct Few<'a> {
    rows: &'a mut Table,
    cells: u64,
}

impl Rows for Few<'_> {
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
    /// Without an orbit.
    #[must_use]
    pub fn orbit(&self) -> &Crossed {
        &self.orbits[0]
    }

    /// Returns the number of crossings.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows.count()
    }

    /// The numbers of a column; none where it has none.
    fn numbers(&self, column: usize) -> &[f64] {
        match self.rows.values.get(column) {
            Some(Kept::F64(values)) => values,
            _ => &[],
        }
    }

    /// The columns in front of n.
    fn front(&self) -> usize {
        self.rows.columns.len() - 2 - self.variables.len()
    }

    /// The steps that crossings come after.
    #[must_use]
    pub fn steps(&self) -> &[i64] {
        match self.rows.values.get(self.front()) {
            Some(Kept::Integer(values)) => values,
            _ => &[],
        }
    }

    /// The times of crossings.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        self.numbers(self.front() + 1)
    }

    /// The variables of a crossing.
    #[must_use]
    pub fn point(&self, row: usize) -> Vec<f64> {
        let first = self.front() + 2;
        (first..first + self.variables.len()).map(|column| self.numbers(column)[row]).collect()
    }
}

/// One orbit as lists of times and points; of many the rows, and how each ended.
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
