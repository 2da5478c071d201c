//! The points of an orbit, with the integrals at them: a table that may be longer than memory.
//!
//! In: a study, ε, a first point, how many steps, which of the points become rows, numbers and a
//! method. Out: rows in blocks, or an answer that has all of them. [`points`] makes rows of
//! whatever moves; [`maps`] and [`methods`] are what moves.

mod chain;
mod maps;
mod methods;
mod paces;
mod points;

use std::fmt;
use std::ops::{ControlFlow, Range};

use kahan_algebra::arithmetic::{Exact, Float32, Float64};
use kahan_algebra::rational::Rational;
use kahan_core::Composition;
use kahan_discover::Watch;
use kahan_runtime::End;
use kahan_runtime::interpreted::UnsupportedDimension;
use serde::{Deserialize, Serialize, Serializer};

use crate::error::{Spelling, StudyError};
use crate::named::{Names, by_name};
use crate::numbers::{DoubleDouble, Number, ScalarKind, exact};
use crate::rates::Rates;
use crate::rows::{Column, Ending, MOST_CELLS, Rows, Table, Values, free_name};
use crate::study::Study;

use super::{Observable, one, usual_order};

pub use chain::{Chain, ChainHead};
use maps::Moving;
pub use paces::Paces;
use points::{Course, Halt, Points, ended};

/// Asks for the points of an orbit: rows of n, the time t = 2εn, the variables, the integrals that
/// are claimed without `when`, or `when` what holds for this orbit. A claim is about Kahan's map;
/// compositions of it and other methods follow the flow, whose integrals are the claims at ε = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Orbit {
    /// ε, half the time step; a negative one steps back.
    #[serde(with = "exact")]
    pub eps: Rational,
    /// The first point, a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The steps to the first row; those of [`steps`](Self::steps) come after them.
    #[serde(default)]
    pub transient: u64,
    /// The number of steps.
    pub steps: u64,
    /// The steps from row to row; the first row is the first point behind the transient.
    #[serde(default = "one")]
    pub every: u64,
    /// The numbers to compute with.
    #[serde(default)]
    pub scalar: ScalarKind,
    /// The order of the method: 2 is Kahan's map; 4, 6 and 8 compose steps of it, in floats.
    #[serde(default = "usual_order")]
    pub order: u32,
    /// What a step is.
    #[serde(default)]
    pub method: Method,
    /// Whether the orbit goes on at poles, through points at infinity.
    #[serde(default)]
    pub projective: bool,
    /// Whether each step of a lifted field is projected symmetrically onto the relations between
    /// its variables, in doubles.
    #[serde(default)]
    pub reembed: bool,
}

/// What a step of an orbit is; each takes the time 2ε.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// A step of Kahan's map, or of a composition of it.
    #[default]
    Kahan,
    /// Euler's explicit method, of order 1.
    Euler,
    /// The classical method of Runge and Kutta, of order 4.
    Rk4,
    /// The flow itself.
    Flow,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Kahan, Self::Euler, Self::Rk4, Self::Flow];

    /// Its name in questions.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Kahan => "kahan",
            Self::Euler => "euler",
            Self::Rk4 => "rk4",
            Self::Flow => "flow",
        }
    }

    /// What it is.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Kahan => "Kahan's map",
            Self::Euler => "Euler's explicit method",
            Self::Rk4 => "The classical method of Runge and Kutta",
            Self::Flow => "The solution itself, by Taylor series",
        }
    }
}

/// Why there is no such orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoOrbit {
    /// A composition of this order in exact numbers.
    Irrational(u32),
    /// A composition that goes through poles.
    ProjectiveOrder,
    /// A method that goes through poles.
    ProjectiveMethod,
    /// A method with an order.
    OwnOrder(Method),
    /// The flow in exact numbers.
    ExactFlow,
    /// Symmetric projection of what is not lifted, or in other numbers or steps.
    Reembed,
    /// Something is observed of projected steps, by this name, that is of the map itself.
    OfTheMap(&'static str),
    /// More variables than a projective orbit can have.
    Projective(UnsupportedDimension),
    /// More variables than the flow can have.
    Flow(UnsupportedDimension),
}

impl NoOrbit {
    pub(crate) fn tell(self, f: &mut fmt::Formatter<'_>, set: Spelling) -> fmt::Result {
        let [projective, reembed, order] = ["projective", "reembed", "order"].map(|name| set(name, ""));
        match self {
            Self::Irrational(asked) => {
                let (asked, f64, kahan) =
                    (set("order", &asked.to_string()), set("scalar", "f64"), set("order", "2"));
                write!(
                    f,
                    "{asked} is a composition of steps whose coefficients are irrational, so no exact number can take them; use \
                     {f64}, or {kahan}, which is exact"
                )
            }
            Self::ProjectiveOrder => {
                write!(f, "{projective} follows Kahan's map itself, not compositions; leave {order} out")
            }
            Self::ProjectiveMethod => {
                let method = set("method", "");
                write!(f, "{projective} follows Kahan's map itself, not other methods; leave {method} out")
            }
            Self::OwnOrder(method) => {
                let method = set("method", method.name());
                write!(
                    f,
                    "{method} has an order of its own, and order is of compositions of Kahan's map; leave {order} out"
                )
            }
            Self::ExactFlow => {
                let (flow, dd) = (set("method", "flow"), set("scalar", "dd"));
                write!(f, "{flow} is a series, whose sum is no exact number; use {dd}")
            }
            Self::Reembed => write!(
                f,
                "{reembed} projects steps of Kahan's map onto the relations of a lifted field, in scalar f64; lift the field, \
                 and leave projective, method and scalar out"
            ),
            Self::OfTheMap(name) => {
                let of_points = Observable::ALL.iter().filter(|one| one.is_of_points()).map(|one| one.name());
                let of_points: Vec<&str> = of_points.collect();
                let (last, others) = of_points.split_last().expect("there are some");
                let others = others.join(", ");
                write!(
                    f,
                    "{reembed} projects steps onto the relations of a lifted field, and {name} is of the map without that: of \
                     its derivative or its poles; leave {reembed} out, or observe {others} or {last} alone"
                )
            }
            Self::Projective(why) => write!(f, "{projective}: {why}"),
            Self::Flow(why) => write!(f, "{}: {why}", set("method", "flow")),
        }
    }
}

/// What is known of an orbit before its first step.
#[derive(Clone, Debug, Serialize)]
pub struct OrbitHead {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The parameters, in the scalar.
    #[serde(serialize_with = "by_name")]
    pub parameters: Names<Number>,
    /// ε, half the time step, in the scalar.
    pub eps: Number,
    /// The numbers that it is computed with.
    pub scalar: ScalarKind,
    /// What a step is.
    #[serde(skip_serializing_if = "is_kahans")]
    pub method: Method,
    /// The order of Kahan's map or its composition; other methods have their own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<u32>,
    /// The steps to the first row.
    #[serde(skip_serializing_if = "is_none")]
    pub transient: u64,
    /// The number of steps behind them.
    pub steps: u64,
    /// The steps from row to row.
    pub every: u64,
    /// The columns of the rows.
    #[serde(serialize_with = "names")]
    pub columns: Vec<Column>,
    /// How steps of floats are made: `machine code` or `interpreted`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub runs_as: Option<&'static str>,
    /// Whether it goes through poles.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub projective: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands on a reference")]
fn is_kahans(method: &Method) -> bool {
    *method == Method::Kahan
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands on a reference")]
fn is_none(transient: &u64) -> bool {
    *transient == 0
}

fn names<S: Serializer>(columns: &[Column], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(columns.iter().map(|column| &column.name))
}

/// An orbit in memory.
#[derive(Clone, Debug, Serialize)]
pub struct Orbited {
    /// What was known before.
    #[serde(flatten)]
    pub head: OrbitHead,
    /// The rows, a column a column of the head.
    pub rows: Table,
    /// How it ended.
    #[serde(flatten)]
    pub ending: Ending,
}

/// An orbit at its first point.
pub struct Begun<'a> {
    /// What is known of it.
    pub head: OrbitHead,
    go_on: GoOn<'a>,
}

type GoOn<'a> = Box<dyn FnOnce(&[Column], Range<u64>, &mut dyn Rows, &dyn Watch) -> Ending + 'a>;

impl Begun<'_> {
    /// Hands on rows by their numbers: row k is the point after `transient` and k times `every`
    /// steps. Costs the
    /// steps to the last of them, from the first point on; integrals are computed in rows only.
    pub fn rows(self, range: Range<u64>, rows: &mut dyn Rows, watch: &dyn Watch) -> Ending {
        (self.go_on)(&self.head.columns, range, rows, watch)
    }

    /// Keeps all rows in memory.
    #[must_use]
    pub fn in_memory(self, watch: &dyn Watch) -> Orbited {
        let (head, mut rows) = (self.head.clone(), Table::default());
        let ending = self.rows(0..u64::MAX, &mut rows, watch);
        Orbited { head, rows, ending }
    }
}

impl Orbit {
    /// Every step of Kahan's map, in doubles.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>, steps: u64) -> Self {
        Orbit {
            eps,
            at,
            transient: 0,
            steps,
            every: one(),
            scalar: ScalarKind::default(),
            order: usual_order(),
            method: Method::default(),
            projective: false,
            reembed: false,
        }
    }

    fn paces(&self) -> Result<Paces, StudyError> {
        let zero = || StudyError::NotPositive { what: "every", value: Rational::zero() };
        Paces::new(self.transient, self.steps, self.every).ok_or_else(zero)
    }

    /// The steps to the last row, the transient among them.
    #[must_use]
    pub fn steps_in_all(&self) -> u64 {
        self.transient.saturating_add(self.steps)
    }

    /// Whether its steps are those of Kahan's map itself, of which claims are made.
    #[must_use]
    pub fn is_of_the_map(&self) -> bool {
        self.method == Method::Kahan && self.order == usual_order() && !self.reembed
    }

    /// The study with the integrals that the orbit keeps without a condition.
    ///
    /// # Errors
    /// Those of [`Study::at_step`].
    pub fn study(&self, study: &Study) -> Result<Study, StudyError> {
        if self.is_of_the_map() { study.at_step(&self.eps) } else { Ok(study.clone()) }
    }

    /// Begins the orbit of a system whose claims hold; of [its own](Self::study), with all
    /// integrals.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of the
    /// scalar, a field that is not defined at its parameters, an order that there is not, methods,
    /// orders and scalars that do not go together.
    pub fn begin<'a>(&'a self, study: &'a Study) -> Result<Begun<'a>, StudyError> {
        match self.scalar {
            ScalarKind::Exact => self.begin_in(&Exact, study),
            ScalarKind::F64 => self.begin_in(&Float64, study),
            ScalarKind::F32 => self.begin_in(&Float32, study),
            ScalarKind::Dd => self.begin_in(&DoubleDouble, study),
        }
    }

    /// Begins the same in doubles, whatever the scalar: a program that calls this alone holds the
    /// code of no other numbers.
    ///
    /// # Errors
    /// Those of [`begin`](Self::begin).
    pub fn begin_in_doubles<'a>(&'a self, study: &'a Study) -> Result<Begun<'a>, StudyError> {
        self.begin_in(&Float64, study)
    }

    /// All rows in memory.
    ///
    /// # Errors
    /// Those of [`begin`](Self::begin), and more than [`MOST_CELLS`].
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Orbited, StudyError> {
        let study = self.study(study)?;
        let begun = self.begin(&study)?;
        let cells = self.paces()?.rows().saturating_mul(begun.head.columns.len() as u64);
        if cells > MOST_CELLS { Err(StudyError::TooLong { cells }) } else { Ok(begun.in_memory(watch)) }
    }

    fn begin_in<'a, A: Moving>(
        &'a self,
        arithmetic: &'a A,
        study: &'a Study,
    ) -> Result<Begun<'a>, StudyError> {
        study.proved()?;
        let paces = self.paces()?;
        let composition = Composition::of_order(self.order).ok_or(StudyError::Order(self.order))?;
        self.check(study).map_err(StudyError::Orbit)?;
        let (start, given) = (study.point(&self.at)?, study.values()?);
        let in_scalar = |what: &'static str, name: &str, value: &Rational| {
            let rounded = A::round(value);
            let beyond = || StudyError::BeyondRange { what, name: name.to_owned(), scalar: self.scalar };
            if A::is_finite(&rounded) { Ok(rounded) } else { Err(beyond()) }
        };
        for (name, value) in study.variables().iter().zip(&start) {
            in_scalar("at", name, value)?;
        }
        let parameters = study.parameters().iter().zip(&given);
        let parameters = parameters.map(|(name, value)| in_scalar("param", name, value));
        let parameters = parameters.collect::<Result<Vec<_>, _>>()?;
        let eps = in_scalar("eps", "eps", &self.eps)?;
        let map = study.map()?;
        // What differs exactly may be one number in the scalar.
        if !map.field().derived().is_defined_at(arithmetic, &parameters, &eps) {
            return Err(study.undefined_field_at(&self.eps));
        }
        let named = study.parameters().iter().cloned();
        let numbers: Names<Number> = named.zip(parameters.iter().map(A::number)).collect();
        let mut points: Box<dyn Points<A> + 'a> = match self.method {
            Method::Kahan if self.projective => maps::projective(map, &self.eps, &start)?,
            Method::Kahan => A::kahan(study, self, composition, &start)?,
            Method::Euler | Method::Rk4 => {
                methods::explicit(arithmetic, map, self.method, parameters, &self.eps, &start)
            }
            Method::Flow => methods::flow(map, &self.eps, &start)?,
        };
        let head = OrbitHead {
            system: study.name().to_owned(),
            variables: study.shown().to_vec(),
            parameters: numbers,
            eps: A::number(&eps),
            scalar: self.scalar,
            method: self.method,
            order: (self.method == Method::Kahan).then_some(self.order),
            transient: self.transient,
            steps: self.steps,
            every: self.every,
            columns: columns(study.shown(), map.field().integrals()),
            runs_as: points.is_code().map(|is_code| if is_code { "machine code" } else { "interpreted" }),
            projective: self.projective,
        };
        let all = columns(study.variables(), map.field().integrals());
        let go_on = move |columns: &[Column], range, rows: &mut dyn Rows, watch: &dyn Watch| {
            let course = Course { arithmetic, columns: &all, eps, paces };
            // Rates grow beyond all bounds near infinity, exact points are asked for in long steps,
            // and other methods are not Kahan's map.
            let is_plain = self.method == Method::Kahan
                && self.scalar != ScalarKind::Exact
                && !self.projective
                && self.steps > 0;
            let rates = study.rates(self.eps.to_f64()).filter(|_| is_plain);
            let looks = rates.map(|rates| Looks::new(rates, paces.rows()));
            let mut chosen = Chosen { columns, places: study.columns_shown(all.len()), rows, looks };
            let ending = match course.hand_on(&mut *points, range, &mut chosen, watch) {
                Ok(()) => Ending::plain(End::Complete, self.steps_in_all()),
                Err(Halt::Stopped(step)) => Ending::plain(End::Stopped(step), step),
                Err(Halt::Ended(n, why)) => ended(study, self, n, why, &points.point()),
            };
            Ending { note: chosen.looks.and_then(|looks| looks.rates.note()), ..ending }
        };
        Ok(Begun { head, go_on: Box::new(go_on) })
    }

    /// Whether method, order and scalar go together.
    fn check(&self, study: &Study) -> Result<(), NoOrbit> {
        let is_kahans = self.method == Method::Kahan;
        let has_relations = study.lift().is_some() && self.scalar == ScalarKind::F64;
        if self.reembed && (self.projective || !is_kahans || !has_relations) {
            Err(NoOrbit::Reembed)
        } else if self.projective && self.order != usual_order() {
            Err(NoOrbit::ProjectiveOrder)
        } else if self.projective && !is_kahans {
            Err(NoOrbit::ProjectiveMethod)
        } else if !is_kahans && self.order != usual_order() {
            Err(NoOrbit::OwnOrder(self.method))
        } else if self.scalar == ScalarKind::Exact && self.order != usual_order() {
            Err(NoOrbit::Irrational(self.order))
        } else if self.scalar == ScalarKind::Exact && self.method == Method::Flow {
            Err(NoOrbit::ExactFlow)
        } else {
            Ok(())
        }
    }
}

/// Hands on some of the columns.
struct Chosen<'a> {
    columns: &'a [Column],
    places: Vec<usize>,
    rows: &'a mut dyn Rows,
    looks: Option<Looks>,
}

/// The rates of the field at some of the rows.
struct Looks {
    rates: Rates,
    /// Rows from one that is looked at to the next.
    stride: u64,
    /// Rows to the next one.
    next: u64,
}

impl Looks {
    fn new(rates: Rates, rows: u64) -> Self {
        Looks { stride: rates.stride(rows), rates, next: 0 }
    }

    /// Looks at rows that have n, t and the variables.
    fn rows(&mut self, values: &[Values<'_>]) {
        let count = values[0].count() as u64;
        while self.next < count {
            let row = self.next as usize;
            let x: Vec<f64> = values[2..][..self.rates.variables()]
                .iter()
                .map(|column| column.cell(row).to_f64())
                .collect();
            self.rates.look(&x);
            self.next += self.stride;
        }
        self.next -= count;
    }
}

impl Rows for Chosen<'_> {
    fn block(&mut self, _: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        if let Some(looks) = &mut self.looks {
            looks.rows(values);
        }
        let values: Vec<Values<'_>> = self.places.iter().map(|&place| values[place]).collect();
        self.rows.block(self.columns, &values)
    }
}

/// n and t, the variables, the integrals, of which the last two keep their names.
pub(super) fn columns(variables: &[String], integrals: &[String]) -> Vec<Column> {
    let taken = [variables, integrals].concat();
    let column = |name: &str, meaning: &str| Column { name: name.to_owned(), meaning: meaning.to_owned() };
    let counted = [("n", "steps from the first point"), ("t", "time from the first point")];
    let counted = counted.map(|(name, meaning)| column(&free_name(&taken, name), meaning));
    let variables = variables.iter().map(|name| column(name, "a variable"));
    let integrals = integrals.iter().map(|name| column(name, "an integral"));
    counted.into_iter().chain(variables).chain(integrals).collect()
}
