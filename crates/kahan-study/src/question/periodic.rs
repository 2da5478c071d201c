//! A cycle of the map near a point, how stable it is, and where it goes when something changes.

use kahan_algebra::modified_integrals::linear_integrals;
use kahan_algebra::poly::{Monomial, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_core::nalgebra::{Complex, DMatrix};
use kahan_discover::Watch;
use kahan_dynamics::periodic::{
    Branch, BranchPoint, Change, Differentiable, Leaf, Mark, OnLeaf, PeriodicPoint, branch, periodic_point,
};

use kahan_runtime::{Map, MapAt, ParametricAt, RationalCycle};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Value, json};

use crate::axes;
use crate::count::Count;
use crate::error::StudyError;
use crate::numbers::exact::{self, Exactly};
use crate::range::Axis;
use crate::study::Study;

use super::one;

mod flow;

pub use flow::FlowFound;

/// The most unknowns of Newton's method: where it finds no cycle, sixty decompositions take some
/// five seconds.
const MOST_UNKNOWNS: usize = 250;

/// Asks for a cycle near a point, and for its branch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Periodic {
    /// ε, half the time step; the first value of `over` where that is of ε. Steady states are the
    /// same for each ε: where the period is 1, it is chosen by the field's rates if it is not
    /// given.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// A point near the cycle, a coordinate for each variable; none for that of the text.
    #[serde(with = "exact", default)]
    pub at: Vec<Rational>,
    /// A multiple of the period. Of a cycle of the flow, the number of steps, about those at `eps`;
    /// 1 for as many as the orbit takes there.
    #[serde(default = "one")]
    pub period: usize,
    /// The unknown besides the points: with ε, a cycle of the flow is looked for, whose period is
    /// not known.
    #[serde(default)]
    pub free: Option<Free>,
    /// The steps before an orbit is looked at that comes back close to itself, where ε is free.
    #[serde(default)]
    pub transient: u64,
    /// The parameter that changes along the branch, or `eps`.
    #[serde(default, with = "axes")]
    pub over: Option<Axis>,
    /// Which integrals keep their values at `at`.
    #[serde(default)]
    pub hold: Hold,
}

/// Which integrals keep their values while a cycle is looked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Hold {
    /// Linear ones with constant coefficients.
    #[default]
    Linear,
    /// None.
    None,
}

impl Hold {
    /// All choices.
    pub const ALL: [Self; 2] = [Self::Linear, Self::None];

    /// Returns the name in questions: `linear` or `none`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Hold::Linear => "linear",
            Hold::None => "none",
        }
    }
}

/// An unknown besides the points of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Free {
    /// Half the time step.
    Eps,
}

/// A cycle, and what becomes of it.
#[derive(Clone, Debug)]
pub struct CycleFound {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The cycle, in doubles. Its multipliers are those along the level of what is held, and of a
    /// cycle of the flow extrapolated.
    pub cycle: PeriodicPoint,
    /// The linear integrals that are held, with their values, as equations.
    pub held: Vec<String>,
    /// ε at the cycle.
    pub eps: f64,
    /// The period, where it is one of the flow.
    pub flow: Option<FlowFound>,
    /// The cycle over ℚ, where its points are fractions of a few digits and nothing changes.
    pub exact: Option<RationalCycle>,
    /// What changes along the branch, and the branch.
    pub branch: Option<(String, Branch)>,
    /// For each point of a branch of the flow the extrapolated numbers; `None` without such a point
    /// at finer steps.
    pub rows: Vec<Option<FlowFound>>,
}

impl Periodic {
    /// Fixed points, with nothing that changes.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>) -> Self {
        let hold = Hold::default();
        Periodic { eps: Some(eps), at, period: one(), free: None, transient: 0, over: None, hold }
    }

    /// The first value of what changes.
    fn begin(&self) -> f64 {
        self.over.as_ref().map_or(f64::NAN, |axis| axis.range.value(0).to_f64())
    }

    /// Looks for the cycle of a system whose claims hold, by Newton's method. Costs at each of its
    /// steps the elimination of a dense matrix with a row for each number of the cycle.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, a cycle that is too long, an axis of nothing that the field has, or no cycle there.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<CycleFound, StudyError> {
        study.proved()?;
        let family = Family::of(self, study)?;
        let system = study.name().to_owned();
        if self.free == Some(Free::Eps) {
            let values = self.over.as_ref().map_or(1, |axis| axis.range.count() as u64);
            let count = Count::new("cycles", 3 * values, watch);
            let (cycle, flow, branch) = family.flow_found(self, &count)?;
            let (branch, rows) = branch.unzip();
            return Ok(CycleFound {
                system,
                variables: study.coordinates().to_vec(),
                held: family.equations(),
                eps: cycle.eps,
                cycle: cycle.cycle,
                flow: Some(flow),
                exact: None,
                branch: self.over.as_ref().map(|axis| axis.name.clone()).zip(branch),
                rows: rows.unwrap_or_default(),
            });
        }
        let unknowns = self.period.saturating_mul(family.start.len());
        if unknowns > MOST_UNKNOWNS {
            return Err(StudyError::LongCycle { unknowns, most: MOST_UNKNOWNS });
        }
        let start = family.leaf.coordinates(&family.start);
        let mut cycle = periodic_point(&family.on_leaf(self.begin()), &start, self.period)
            .map_err(|why| StudyError::NoCycle { system: system.clone(), why })?;
        let branch = self.over.as_ref().map(|axis| (axis.name.clone(), family.branch(&cycle, axis, watch)));
        family.unfold(&mut cycle);
        Ok(CycleFound {
            system,
            variables: study.variables().to_vec(),
            flow: None,
            rows: Vec::new(),
            exact: family.exact(&cycle),
            held: family.equations(),
            eps: family.eps_at(self.begin()),
            branch,
            cycle,
        })
    }
}

impl CycleFound {
    /// The points of the branch at the values that were asked for and where something changes, each
    /// with its numbers if it is one of the flow.
    pub fn rows(&self) -> impl Iterator<Item = (&BranchPoint, Option<&FlowFound>)> {
        let points = self.branch.iter().flat_map(|(_, branch)| &branch.points).enumerate();
        let rows = points.map(|(k, point)| (point, self.rows.get(k).and_then(Option::as_ref)));
        rows.filter(|(point, _)| point.mark != Mark::Between)
    }

    /// The eigenvalues of the derivative of the field at a cycle of this answer, where it is a
    /// steady state: λ = (μ − 1)/(ε(μ + 1)) of its multipliers μ.
    #[must_use]
    pub fn eigenvalues(&self, cycle: &PeriodicPoint, eps: f64) -> Option<Vec<Complex<f64>>> {
        let of = |multiplier: &Complex<f64>| (multiplier - 1.0) / (multiplier + 1.0) / eps;
        (cycle.points.len() == 1).then(|| cycle.multipliers.iter().map(of).collect())
    }

    /// A change on the branch in words: of steady states in those of the field.
    #[must_use]
    pub fn said(&self, change: Change) -> String {
        let of_field = match change {
            Change::Fold => "fold, two steady states meet",
            Change::ThroughOne => "an eigenvalue of f' goes through 0",
            Change::ThroughCircle => {
                "Hopf point, a pair of eigenvalues of f' goes through the imaginary axis"
            }
            Change::ThroughMinusOne | Change::Halved | Change::Hopf => return change.to_string(),
        };
        if self.cycle.points.len() == 1 { of_field.to_owned() } else { change.to_string() }
    }
}

/// A linear integral Σ cₖ xₖ that is held at its value.
struct Held {
    /// The pairs (k, cₖ).
    coefficients: Vec<(usize, Rational)>,
    value: Rational,
}

impl Held {
    fn of(coefficients: Vec<(usize, Rational)>, point: &[Rational]) -> Self {
        Held { value: value(&coefficients, point), coefficients }
    }

    /// The integral and its value as an equation whose first coefficient is positive.
    fn equation(&self, study: &Study) -> String {
        let symbols = &study.system().field.symbols;
        let terms = self.coefficients.iter();
        let terms = terms.map(|(k, c)| (Monomial::power(symbols.state(*k), 1), c.clone()));
        let first = self.coefficients.iter().min_by_key(|(k, _)| *k);
        let sign = Rational::from(if first.is_some_and(|(_, c)| c.is_negative()) { -1 } else { 1 });
        let integral = Polynomial::from_terms(terms).scale(&sign);
        format!("{} = {}", Text.polynomial(symbols, &integral), &self.value * &sign)
    }
}

fn value(coefficients: &[(usize, Rational)], point: &[Rational]) -> Rational {
    coefficients.iter().fold(Rational::zero(), |sum, (k, c)| &sum + &(c * &point[*k]))
}

/// The map at each value of what changes.
struct Family {
    study: Study,
    eps: Rational,
    start: Vec<f64>,
    held: Vec<Held>,
    /// The points at which what is held has its values.
    leaf: Leaf,
    /// The index of the parameter that changes; `None` for ε, or for nothing.
    parameter: Option<usize>,
    changes: bool,
}

impl Family {
    fn of(asked: &Periodic, study: &Study) -> Result<Self, StudyError> {
        let axis = asked.over.as_ref();
        let parameter = axis.map(|axis| study.axis(axis)).transpose()?.flatten();
        let of_axis = axis.filter(|_| parameter.is_none()).map(|axis| axis.range.value(0));
        let study = match (axis, parameter) {
            (Some(axis), Some(place)) if study.given()[place].is_none() => {
                study.with(place, axis.range.value(0))
            }
            _ => study.clone(),
        };
        let own = || study.start().unwrap_or_default();
        let point = study.point(&if asked.at.is_empty() { own() } else { asked.at.clone() })?;
        let given = asked.eps.clone().or(of_axis);
        let is_steady = asked.period == 1 && asked.free.is_none();
        let eps = given.or_else(|| is_steady.then(|| step_for(study.map().ok()?, &point))?);
        let eps = eps.ok_or(StudyError::MissingStep)?;
        // A mistake in what is given is told before the search.
        let (_, start) = study.in_floats(&point, &eps)?;
        let mut integrals = match asked.hold {
            Hold::Linear => integrals(&study, parameter, &start)?,
            Hold::None => Vec::new(),
        };
        let floats = |integral: &Vec<(usize, Rational)>| {
            integral.iter().map(|(k, c)| (*k, c.to_f64())).collect::<Vec<_>>()
        };
        // Cycles of the flow have the original variables of a lifted field.
        let variables = if asked.free.is_some() { study.coordinates().len() } else { start.len() };
        integrals.retain(|integral| integral.iter().all(|(k, _)| *k < variables));
        let floats: Vec<_> = integrals.iter().map(floats).collect();
        let leaf = Leaf::through(&start[..variables], &floats);
        let held = integrals.into_iter().map(|integral| Held::of(integral, &point)).collect();
        Ok(Family { study, eps, start, held, leaf, parameter, changes: axis.is_some() })
    }

    /// ε where what changes has this value.
    fn eps_at(&self, value: f64) -> f64 {
        match (self.changes, self.parameter) {
            (true, None) => value,
            _ => self.eps.to_f64(),
        }
    }

    /// Returns the integrals that are held, as equations.
    fn equations(&self) -> Vec<String> {
        self.held.iter().map(|integral| integral.equation(&self.study)).collect()
    }

    /// The map on the leaf.
    fn on_leaf(&self, value: f64) -> OnLeaf<'_, ParametricAt> {
        OnLeaf { map: self.at(value).by(self.parameter), leaf: &self.leaf }
    }

    /// Puts the points of a cycle on the leaf in the place of their coordinates.
    fn unfold(&self, cycle: &mut PeriodicPoint) {
        for point in &mut cycle.points {
            *point = self.leaf.point(point);
        }
    }

    /// The parameters where what changes has this value.
    fn values_at(&self, value: f64) -> Vec<Rational> {
        let mut parameters = self.own().parameters().to_vec();
        if let Some(place) = self.parameter {
            parameters[place] = Rational::from_f64(value).unwrap_or_default();
        }
        parameters
    }

    /// The map where what changes has this value; where the field divides by zero, that of no
    /// value.
    fn at(&self, value: f64) -> MapAt<f64> {
        match self.study.map_at(&self.values_at(value)) {
            Some(map) => map.at(self.eps_at(value)),
            None => self.own().at(f64::NAN),
        }
    }

    /// The branch that begins with a cycle.
    fn branch(&self, cycle: &PeriodicPoint, axis: &Axis, watch: &dyn Watch) -> Branch {
        let (ends, steps) = (axis.range.ends().map(|end| end.to_f64()), axis.range.count() - 1);
        // A branch that winds has more.
        let count = Count::new("cycles", steps as u64, watch);
        let mut branch = branch(|value| self.on_leaf(value), cycle, ends, steps, |_| count.tell(1));
        self.finish(&mut branch, axis);
        branch
    }

    /// Puts the points of a branch on the leaf, and its rows at the very values of the axis.
    fn finish(&self, branch: &mut Branch, axis: &Axis) {
        for point in &mut branch.points {
            self.unfold(&mut point.cycle);
            if let Mark::Asked(k) = point.mark {
                point.parameter = axis.range.value(k).to_f64();
            }
        }
    }

    /// The map at the values that were given, at which there is one.
    fn own(&self) -> &Map {
        self.study.map().expect("the family was made where its field is defined")
    }

    /// The cycle over ℚ, where nothing changes.
    fn exact(&self, cycle: &PeriodicPoint) -> Option<RationalCycle> {
        if self.changes {
            return None;
        }
        let exact = self.own().rational_cycle(&self.eps, cycle)?;
        let is_held = |held: &Held| value(&held.coefficients, &exact.points[0]) == held.value;
        self.held.iter().all(is_held).then(|| exact.on_leaf(self.held.len()))
    }
}

/// The linear integrals of a field at the values of its parameters, but for the one that changes.
/// They determine variables that are small at `start`, so that the free ones show its size.
fn integrals(
    study: &Study,
    changes: Option<usize>,
    start: &[f64],
) -> Result<Vec<Vec<(usize, Rational)>>, StudyError> {
    let mut values = study.valued();
    if let Some(place) = changes {
        values[place] = None;
    }
    let mut order: Vec<usize> = (0..start.len()).collect();
    order.sort_by(|a, b| start[*b].abs().total_cmp(&start[*a].abs()));
    let found = linear_integrals(&study.at(values).specialised()?.field, &order);
    // A field that is zero moves no variable, and every point is a cycle.
    Ok(if found.len() < start.len() { found } else { Vec::new() })
}

/// A power of two for ε at which a step changes distances near a point by a part of themselves: the
/// rates of the field there are neither fast nor slow for it.
fn step_for(map: &Map, point: &[Rational]) -> Option<Rational> {
    /// Beyond all powers of two of a double.
    const MOST: usize = 2200;

    let start: Vec<f64> = point.iter().map(Rational::to_f64).collect();
    let change = |eps: f64| {
        let derivative = map.at(eps).derivative(&start);
        let change = &derivative - DMatrix::identity(start.len(), start.len());
        if change.iter().all(|entry| entry.is_finite()) { change.amax() } else { f64::INFINITY }
    };
    let mut eps = 1.0;
    for _ in 0..MOST {
        match change(eps) {
            0.0 => return Some(Rational::one()),
            change if change > 1.0 => eps /= 2.0,
            change if change < 0.25 => eps *= 2.0,
            _ => break,
        }
    }
    Rational::from_f64(eps)
}

/// The characteristic polynomial of a cycle's derivative, in z.
#[must_use]
pub fn characteristic_polynomial(exact: &RationalCycle) -> String {
    let symbols = Symbols { states: vec!["z".to_owned()], parameters: Vec::new() };
    Text.polynomial(&symbols, &exact.polynomial)
}

/// A cycle as an object of JSON.
fn object_of(found: &CycleFound, cycle: &PeriodicPoint, eps: f64) -> Value {
    let pairs = |of: &[Complex<f64>]| of.iter().map(|one| [one.re, one.im]).collect::<Vec<_>>();
    let mut object = json!({
        "period": cycle.points.len(),
        "points": cycle.points,
        "residual": cycle.residual,
        "multipliers": pairs(&cycle.multipliers),
        "stability": cycle.stability().to_string(),
        "family": cycle.family,
    });
    if let Some(eigenvalues) = found.eigenvalues(cycle, eps) {
        object["eigenvalues"] = json!(pairs(&eigenvalues));
    }
    object
}

impl Serialize for CycleFound {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let exact = |exact: &RationalCycle| {
            json!({
                "points": exact.points.to_json(),
                "polynomial": characteristic_polynomial(exact),
                "stability": exact.stability.to_string(),
            })
        };
        let place = |(point, found): (&BranchPoint, Option<&FlowFound>)| {
            let mut place = object_of(self, &point.cycle, point.eps);
            place["parameter"] = json!(point.parameter);
            place["change"] = json!(point.change().map(|change| self.said(change)));
            if self.flow.is_some() {
                place["eps"] = json!(point.eps);
                place["flow"] = flow::object(found, &point.cycle, point.eps);
            }
            place
        };
        let turn = |(point, found): (&BranchPoint, Option<&FlowFound>)| {
            let mut turn = json!({"change": self.said(point.change()?), "parameter": point.parameter});
            if self.flow.is_some() {
                turn["error"] = json!(found.map(|found| found.parameter.error));
            }
            Some(turn)
        };
        let mut object = object_of(self, &self.cycle, self.eps);
        object["system"] = json!(self.system);
        object["variables"] = json!(self.variables);
        object["held"] = json!(self.held);
        object["exact"] = self.exact.as_ref().map_or(Value::Null, exact);
        if let Some(flow) = &self.flow {
            object["flow"] = flow::object(Some(flow), &self.cycle, self.eps);
        }
        if let Some((over, branch)) = &self.branch {
            object["branch"] = json!({
                "over": over,
                "points": self.rows().map(place).collect::<Vec<_>>(),
                "turns": self.rows().filter_map(turn).collect::<Vec<_>>(),
                "cut": branch.is_cut,
            });
        }
        object.serialize(serializer)
    }
}
