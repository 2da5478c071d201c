//! Where an orbit crosses a plane, or the level of any function.

use std::ops::Range;

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_core::Step;
use kahan_core::observe::{self, Crossing, Direction, Section as Crossings, Sectioned};
use kahan_discover::Watch;
use kahan_runtime::{End, Follow, Followed, MapAt, RuntimePoint};
use serde::de::Error;
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::count::Count;
use crate::error::StudyError;
use crate::formula::{Formula, formula_of};
use crate::numbers::exact;
use crate::rows::{Column, Rows, Values};
use crate::study::Study;

use super::orbit::columns;

/// Asks where the orbit of a point crosses a section, in doubles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// ε, half the time step.
    #[serde(with = "exact")]
    pub eps: Rational,
    /// The first point, a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The most steps of the orbit.
    pub steps: u64,
    /// What vanishes on the section: a formula of the variables, the integrals that are claimed
    /// without `when`, the parameters and `eps`.
    pub plane: String,
    /// Which sign changes count.
    #[serde(default, serialize_with = "name_of", deserialize_with = "of_name")]
    pub direction: Direction,
    /// The most crossings.
    #[serde(default = "usual_points")]
    pub points: usize,
    /// Whether each step of a lifted field is projected symmetrically onto the relations between
    /// its variables.
    #[serde(default)]
    pub reembed: bool,
}

fn name_of<S: Serializer>(direction: &Direction, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(direction.name())
}

fn of_name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Direction, D::Error> {
    let name = String::deserialize(deserializer)?;
    let known = Direction::ALL.into_iter().find(|direction| direction.name() == name);
    known.ok_or_else(|| D::Error::unknown_variant(&name, &["rising", "falling", "both"]))
}

fn usual_points() -> usize {
    100_000
}

/// The crossings of an orbit.
#[derive(Clone, Debug)]
pub struct SectionFound {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The steps that were made.
    pub steps: u64,
    /// How the orbit ended; it is stopped where it has so many crossings as were asked for.
    pub end: End,
    /// Why, where the end is one of the lift.
    pub why: Option<String>,
    /// Where the orbit crosses, in order.
    pub crossings: Vec<Crossing<Vec<f64>, f64>>,
    /// How often the formula changes its sign in the directions that count, but has no zero: at a
    /// pole of the formula or of the map, or where the formula jumps.
    pub jumps: u64,
}

/// A formula of the variables, the integrals that are claimed without `when`, the parameters and
/// `eps`, at these values. `what` it is called in reports.
fn formula_at(
    system: &System,
    parameters: &[Rational],
    eps: &Rational,
    what: &'static str,
    text: &str,
) -> Result<Formula, StudyError> {
    let symbols = &system.field.symbols;
    let parameters = symbols.parameters.iter().cloned().zip(parameters);
    let known = parameters.chain([("eps".to_owned(), eps)]);
    let known: Vec<(String, f64)> = known.map(|(name, value)| (name, value.to_f64())).collect();
    let integrals = system.accessors(ClaimKind::Integral).map(|claim| claim.name.text.as_str());
    let variables: Vec<&str> = symbols.states.iter().map(String::as_str).chain(integrals).collect();
    formula_of(&variables, text, &known).map_err(|why| StudyError::Formula { what, why })
}

impl Study {
    /// A formula of the variables, the integrals that are claimed without `when`, the parameters and
    /// `eps`. `what` it is called in reports.
    ///
    /// # Errors
    /// [`StudyError::Formula`], and values that are missing.
    pub fn formula(&self, eps: &Rational, what: &'static str, text: &str) -> Result<Formula, StudyError> {
        formula_at(self.system(), &self.values()?, eps, what, text)
    }
}

/// A function of the state whose zeros are a section.
#[derive(Clone, Debug)]
pub struct Plane(Formula);

impl Plane {
    /// The formula of a section, at these values of the parameters and this ε.
    ///
    /// # Errors
    /// [`StudyError::Formula`], or [`StudyError::ConstantPlane`] where it is one number everywhere.
    pub fn of(
        system: &System,
        parameters: &[Rational],
        eps: &Rational,
        text: &str,
    ) -> Result<Self, StudyError> {
        let formula = formula_at(system, parameters, eps, "plane", text)?;
        match formula.last_variable() {
            Some(_) => Ok(Plane(formula)),
            None => Err(StudyError::ConstantPlane { text: text.to_owned() }),
        }
    }

    /// The last of the variables, and of the integrals behind them, that it names.
    #[must_use]
    pub fn last_variable(&self) -> Option<usize> {
        self.0.last_variable()
    }

    /// How far a point is from the section, as the formula measures it.
    pub fn height<'a>(&'a self, at: &'a MapAt<f64>) -> impl Fn(&[f64]) -> f64 + 'a {
        let integrals = at.map().field().integrals().len();
        let formula = self.0.clone().function();
        move |x| {
            let mut known: RuntimePoint<f64> = x.iter().copied().collect();
            known.resize(x.len() + integrals, 0.0);
            // The state is as long as the field has variables.
            let _ = at.integrals(x, &mut known[x.len()..]);
            formula(&known)
        }
    }
}

/// Takes the first crossings, in memory that grows with them: `most` is what a user allows, and far
/// more than there are as a rule.
struct First {
    found: Vec<Crossing<Vec<f64>, f64>>,
    most: usize,
}

impl observe::Sink<Crossing<Vec<f64>, f64>> for First {
    type Report = Vec<Crossing<Vec<f64>, f64>>;

    fn take(&mut self, crossing: Crossing<Vec<f64>, f64>) {
        self.found.push(crossing);
    }

    fn is_full(&self) -> bool {
        self.found.len() >= self.most
    }

    fn report(self) -> Self::Report {
        self.found
    }
}

impl Section {
    /// Rising crossings, a hundred thousand at most.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>, steps: u64, plane: impl Into<String>) -> Self {
        let (plane, points) = (plane.into(), usual_points());
        Section { eps, at, steps, plane, direction: Direction::default(), points, reembed: false }
    }

    /// Follows the orbit of a system whose claims hold, and refines each crossing on the curve that
    /// the map draws as ε grows from 0. Costs the orbit, and some steps a crossing.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, a plane that is no formula or a number, a field that is not defined at its
    /// parameters.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<SectionFound, StudyError> {
        let system = study.proved()?;
        let plane = Plane::of(system, &study.values()?, &self.eps, &self.plane)?;
        let (at, mut x) = study.in_floats(&self.at, &self.eps)?;
        let first = First { found: Vec::new(), most: self.points };
        let count = Count::new("steps", self.steps, watch);
        study.can_reembed(self.reembed)?;
        let step = study.steps(&at, self.reembed);
        // Few look at sections of fields that are not lifted through this.
        let by: &dyn Step<Scalar = f64> = step.as_ref().map_or(&at, |step| step);
        let crossings = Crossings::new(by, plane.height(&at), self.direction, first);
        let followed = by.observe(&mut x, self.steps, crossings, |steps| count.tell(steps));
        let Followed { report, end } = followed.expect("the start is of the field");
        let end = step.as_ref().map_or(end, |step| step.end(end, &x));
        let why = step.as_ref().filter(|_| end.is_early()).and_then(|step| step.ends(&x));
        let why = why.map(|why| why.in_words(study, end.steps(self.steps)));
        let Sectioned { points: mut crossings, jumps } = report;
        for crossing in &mut crossings {
            crossing.time = study.time_place().map_or(crossing.time, |place| crossing.point[place]);
            crossing.point = study.project(&crossing.point);
        }
        Ok(SectionFound {
            system: study.name().to_owned(),
            variables: study.shown().to_vec(),
            steps: end.steps(self.steps),
            end,
            why,
            crossings,
            jumps,
        })
    }
}

impl SectionFound {
    /// The step before a crossing, its time, the variables.
    #[must_use]
    pub fn columns(&self) -> Vec<Column> {
        columns(&self.variables, &[])
    }

    /// Hands on crossings by their numbers, from 0 on; stopped, the number of the first.
    pub fn rows(&self, range: Range<u64>, rows: &mut dyn Rows) -> End {
        const BLOCK: usize = 1024;

        let columns = self.columns();
        let end = range.end.min(self.crossings.len() as u64) as usize;
        let start = range.start.min(end as u64) as usize;
        for block in self.crossings[start..end].chunks(BLOCK) {
            let steps: Vec<i64> = block.iter().map(|crossing| crossing.step as i64).collect();
            let times = block.iter().map(|crossing| crossing.time).collect();
            let coordinate = |i: usize| block.iter().map(|crossing| crossing.point[i]).collect();
            let numbers: Vec<Vec<f64>> =
                [times].into_iter().chain((0..self.variables.len()).map(coordinate)).collect();
            let values = [Values::Integer(&steps)].into_iter();
            let values: Vec<Values<'_>> =
                values.chain(numbers.iter().map(|list| Values::F64(list))).collect();
            if rows.block(&columns, &values).is_break() {
                return End::Stopped(start as u64);
            }
        }
        End::Complete
    }
}

impl Serialize for SectionFound {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let times: Vec<f64> = self.crossings.iter().map(|crossing| crossing.time).collect();
        let points: Vec<&[f64]> = self.crossings.iter().map(|crossing| &crossing.point[..]).collect();
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("system", &self.system)?;
        object.serialize_entry("variables", &self.variables)?;
        object.serialize_entry("steps", &self.steps)?;
        object.serialize_entry("ended", self.end.name())?;
        object.serialize_entry("ended_step", &self.steps)?;
        object.serialize_entry("times", &times)?;
        object.serialize_entry("points", &points)?;
        object.serialize_entry("jumps", &self.jumps)?;
        object.end()
    }
}
