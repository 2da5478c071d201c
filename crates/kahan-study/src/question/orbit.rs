//! The points of an orbit with the integrals at them, as a table that may exceed memory.
//!
//! [`points`] makes rows for any method of stepping; [`maps`] and [`methods`] provide the methods.

mod chain;
mod maps;
mod methods;
mod points;
mod row_schedule;

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
use maps::PointArithmetic;
use points::{EarlyEnd, OrbitPoints, OrbitRows, ended};
pub use row_schedule::RowSchedule;

/// A request for the points of an orbit. A row holds n, the time t = 2εn, variables and integrals.
///
/// Rows of compositions and other methods hold the integrals of the flow: the claims at ε = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Orbit {
    /// ε, half the time step; a negative ε steps backwards.
    #[serde(with = "exact")]
    pub eps: Rational,
    /// The first point, with a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The number of steps before the first row, which [`steps`](Self::steps) does not include.
    #[serde(default)]
    pub transient: u64,
    /// The number of steps.
    pub steps: u64,
    /// The number of steps between rows.
    #[serde(default = "one")]
    pub every: u64,
    /// The scalar of the computation.
    #[serde(default)]
    pub scalar: ScalarKind,
    /// The order of the method: 2 is Kahan's map; 4, 6 and 8 compose steps of it, in floats.
    #[serde(default = "usual_order")]
    pub order: u32,
    /// The method of a step.
    #[serde(default)]
    pub method: Method,
    /// Whether the orbit continues through poles, by points at infinity.
    #[serde(default)]
    pub projective: bool,
    /// Whether steps in doubles are projected, so that relations such as sin_x = sin(x) hold.
    #[serde(default)]
    pub reembed: bool,
}

/// The method of a step of an orbit; each step takes the time 2ε.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Kahan's map, or a composition of it.
    #[default]
    Kahan,
    /// Euler's explicit method, of order 1.
    Euler,
    /// The classical Runge–Kutta method, of order 4.
    Rk4,
    /// The flow itself, by Taylor series.
    Flow,
}

impl Method {
    /// All methods.
    pub const ALL: [Self; 4] = [Self::Kahan, Self::Euler, Self::Rk4, Self::Flow];

    /// Returns the name as users write it in a question: `kahan`, `euler`, `rk4` or `flow`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Kahan => "kahan",
            Self::Euler => "euler",
            Self::Rk4 => "rk4",
            Self::Flow => "flow",
        }
    }

    /// Returns a description of the method, such as `Kahan's map`.
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

/// Options of an orbit that contradict each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoOrbit {
    /// A composition, whose coefficients are irrational, is requested in exact numbers.
    Irrational(u32),
    /// Projective steps are requested for a composition.
    ProjectiveOrder,
    /// Projective steps are requested for a method other than Kahan's map.
    ProjectiveMethod,
    /// An order is requested for a method whose order is fixed.
    OwnOrder(Method),
    /// The flow is requested in exact numbers.
    ExactFlow,
    /// Symmetric projection is requested without a lift, in a scalar other than doubles, for a
    /// method other than Kahan's map, or for a projective orbit.
    Reembed,
    /// Projected steps are requested, but the observable of this name requires unprojected steps.
    OfTheMap(&'static str),
    /// A projective orbit is requested in too many variables.
    Projective(UnsupportedDimension),
    /// The flow is requested in too many variables.
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

/// Metadata of an orbit, known before its first step.
#[derive(Clone, Debug, Serialize)]
pub struct OrbitHead {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The parameters, in the scalar of the computation.
    #[serde(serialize_with = "by_name")]
    pub parameters: Names<Number>,
    /// ε, half the time step, in the scalar of the computation.
    pub eps: Number,
    /// The scalar of the computation.
    pub scalar: ScalarKind,
    /// The method of a step.
    #[serde(skip_serializing_if = "is_kahans")]
    pub method: Method,
    /// The order of Kahan's map or its composition; `None` for other methods.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<u32>,
    /// The number of steps before the first row.
    #[serde(skip_serializing_if = "is_none")]
    pub transient: u64,
    /// The number of steps after the transient.
    pub steps: u64,
    /// The number of steps between rows.
    pub every: u64,
    /// The columns of the rows.
    #[serde(serialize_with = "names")]
    pub columns: Vec<Column>,
    /// Whether float steps run as `machine code` or are `interpreted`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub runs_as: Option<&'static str>,
    /// Whether steps in machine code use fused multiply-adds; see [`Study::fusing`].
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub fused: bool,
    /// Whether the orbit continues through poles.
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
    /// The metadata of the orbit.
    #[serde(flatten)]
    pub head: OrbitHead,
    /// The rows; `head` lists their columns.
    pub rows: Table,
    /// The reason why the orbit ended.
    #[serde(flatten)]
    pub ending: Ending,
}

/// An orbit at its first point, ready to run.
pub struct StartedOrbit<'a> {
    /// The metadata of the orbit.
    pub head: OrbitHead,
    go_on: OrbitContinuation<'a>,
}

type OrbitContinuation<'a> = Box<dyn FnOnce(&[Column], Range<u64>, &mut dyn Rows, &dyn Watch) -> Ending + 'a>;

impl StartedOrbit<'_> {
    /// Passes the rows in `range` to a consumer. Row k is the point after `transient` + k · `every`
    /// steps.
    pub fn rows(self, range: Range<u64>, rows: &mut dyn Rows, watch: &dyn Watch) -> Ending {
        (self.go_on)(&self.head.columns, range, rows, watch)
    }

    /// Collects all rows in memory.
    #[must_use]
    pub fn in_memory(self, watch: &dyn Watch) -> Orbited {
        let (head, mut rows) = (self.head.clone(), Table::default());
        let ending = self.rows(0..u64::MAX, &mut rows, watch);
        Orbited { head, rows, ending }
    }
}

impl Orbit {
    /// Asks for every step of Kahan's map, in doubles.
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

    fn row_schedule(&self) -> Result<RowSchedule, StudyError> {
        let zero = || StudyError::NotPositive { what: "every", value: Rational::zero() };
        RowSchedule::new(self.transient, self.steps, self.every).ok_or_else(zero)
    }

    /// Returns the number of steps to the last point, including the transient.
    #[must_use]
    pub fn steps_in_all(&self) -> u64 {
        self.transient.saturating_add(self.steps)
    }

    /// Returns whether the steps are those of Kahan's map, to which the claims apply.
    #[must_use]
    pub fn is_of_the_map(&self) -> bool {
        self.method == Method::Kahan && self.order == usual_order() && !self.reembed
    }

    /// Returns a copy of `study`. For Kahan's map, claims whose condition holds at this ε become
    /// unconditional.
    ///
    /// # Errors
    /// The errors of [`Study::at_step`].
    pub fn study(&self, study: &Study) -> Result<Study, StudyError> {
        if self.is_of_the_map() { study.at_step(&self.eps) } else { Ok(study.clone()) }
    }

    /// Prepares the orbit of a system whose claims hold. Pass [`study`](Self::study)'s result to
    /// get all integrals.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of the
    /// scalar, a field that is undefined at its parameters, an unknown order, or options that
    /// exclude each other.
    pub fn begin<'a>(&'a self, study: &'a Study) -> Result<StartedOrbit<'a>, StudyError> {
        match self.scalar {
            ScalarKind::Exact => self.begin_in(&Exact, study),
            ScalarKind::F64 => self.begin_in(&Float64, study),
            ScalarKind::F32 => self.begin_in(&Float32, study),
            ScalarKind::Dd => self.begin_in(&DoubleDouble, study),
        }
    }

    /// Prepares the orbit in doubles. A program that calls only this function contains no code for
    /// other scalars.
    ///
    /// # Errors
    /// The errors of [`begin`](Self::begin).
    pub fn begin_in_doubles<'a>(&'a self, study: &'a Study) -> Result<StartedOrbit<'a>, StudyError> {
        self.begin_in(&Float64, study)
    }

    /// Returns all rows in memory.
    ///
    /// # Errors
    /// The errors of [`begin`](Self::begin), or more than [`MOST_CELLS`] cells.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Orbited, StudyError> {
        let study = self.study(study)?;
        let begun = self.begin(&study)?;
        let cells = self.row_schedule()?.rows().saturating_mul(begun.head.columns.len() as u64);
        if cells > MOST_CELLS { Err(StudyError::TooLong { cells }) } else { Ok(begun.in_memory(watch)) }
    }

    fn begin_in<'a, A: PointArithmetic>(
        &'a self,
        arithmetic: &'a A,
        study: &'a Study,
    ) -> Result<StartedOrbit<'a>, StudyError> {
        study.proved()?;
        let paces = self.row_schedule()?;
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
        // Different exact numbers may round to one float, at which the field may be undefined.
        if !map.field().derived().is_defined_at(arithmetic, &parameters, &eps) {
            return Err(study.undefined_field_at(&self.eps));
        }
        let named = study.parameters().iter().cloned();
        let numbers: Names<Number> = named.zip(parameters.iter().map(A::number)).collect();
        let mut points: Box<dyn OrbitPoints<A> + 'a> = match self.method {
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
            fused: study.fuses() && points.is_code() == Some(true),
            projective: self.projective,
        };
        let all = columns(study.variables(), map.field().integrals());
        let go_on = move |columns: &[Column], range, rows: &mut dyn Rows, watch: &dyn Watch| {
            let course = OrbitRows { arithmetic, columns: &all, eps, paces };
            // If ε is too large for ‖f′‖ along the orbit, a note says so. Exact orbits get no note,
            // because their long steps are deliberate.
            let is_plain = self.method == Method::Kahan
                && self.scalar != ScalarKind::Exact
                && !self.projective
                && self.steps > 0;
            let rates = study.rates(self.eps.to_f64()).filter(|_| is_plain);
            let looks = rates.map(|rates| RateInspection::new(rates, paces.rows()));
            let mut chosen = ColumnSelection { columns, places: study.columns_shown(all.len()), rows, looks };
            let ending = match course.pass_rows(&mut *points, range, &mut chosen, watch) {
                Ok(()) => Ending::plain(End::Complete, self.steps_in_all()),
                Err(EarlyEnd::Stopped(step)) => Ending::plain(End::Stopped(step), step),
                Err(EarlyEnd::Ended(n, why)) => ended(study, self, n, why, &points.point()),
            };
            Ending { note: chosen.looks.and_then(|looks| looks.rates.note()), ..ending }
        };
        Ok(StartedOrbit { head, go_on: Box::new(go_on) })
    }

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

/// A consumer that passes on some columns, and at some rows compares the norm ‖f′(x)‖ with 1/ε.
struct ColumnSelection<'a> {
    columns: &'a [Column],
    places: Vec<usize>,
    rows: &'a mut dyn Rows,
    looks: Option<RateInspection>,
}

struct RateInspection {
    rates: Rates,
    /// The number of rows from one checked row to the next.
    stride: u64,
    /// The number of rows to skip before the next checked row.
    next: u64,
}

impl RateInspection {
    fn new(rates: Rates, rows: u64) -> Self {
        RateInspection { stride: rates.stride(rows), rates, next: 0 }
    }

    fn rows(&mut self, values: &[Values<'_>]) {
        let count = values[0].count() as u64;
        while self.next < count {
            let row = self.next as usize;
            let x: Vec<f64> = values[2..][..self.rates.variables()]
                .iter()
                .map(|column| column.cell(row).to_f64())
                .collect();
            self.rates.inspect(&x);
            self.next += self.stride;
        }
        self.next -= count;
    }
}

impl Rows for ColumnSelection<'_> {
    fn block(&mut self, _: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        if let Some(looks) = &mut self.looks {
            looks.rows(values);
        }
        let values: Vec<Values<'_>> = self.places.iter().map(|&place| values[place]).collect();
        self.rows.block(self.columns, &values)
    }
}

/// Returns the columns n, t, variables, integrals; n and t are renamed if these names are taken.
pub(super) fn columns(variables: &[String], integrals: &[String]) -> Vec<Column> {
    let taken = [variables, integrals].concat();
    let column = |name: &str, meaning: &str| Column { name: name.to_owned(), meaning: meaning.to_owned() };
    let counted = [("n", "steps from the first point"), ("t", "time from the first point")];
    let counted = counted.map(|(name, meaning)| column(&free_name(&taken, name), meaning));
    let variables = variables.iter().map(|name| column(name, "a variable"));
    let integrals = integrals.iter().map(|name| column(name, "an integral"));
    counted.into_iter().chain(variables).chain(integrals).collect()
}
