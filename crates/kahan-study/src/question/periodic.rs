//! Cycles of the map near a point, their stability, and their branches over a parameter or ε.

use kahan_algebra::modified_integrals::linear_integrals;
use kahan_algebra::poly::{Monomial, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_core::nalgebra::{Complex, DMatrix};
use kahan_discover::Watch;
use kahan_dynamics::periodic::{
    Branch, BranchChange, BranchPoint, BranchPointKind, Differentiable, LevelSet, OnLevelSet, PeriodicPoint,
    branch, periodic_point,
};

use kahan_runtime::{Map, MapAt, ParametricAt, RationalCycle};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Value, json};

use crate::axes;
use crate::count::WorkCount;
use crate::error::StudyError;
use crate::numbers::exact::{self, ExactJson};
use crate::range::Axis;
use crate::study::Study;

use super::one;

mod flow;

pub use flow::FlowFound;

/// The largest number of unknowns for Newton's method. A failed search with this number of unknowns
/// takes five seconds.
const MOST_UNKNOWNS: usize = 250;

/// A request for a cycle near a point, and for its branch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Periodic {
    /// ε, half the time step. The default is the first value of the axis `eps`. Without this axis,
    /// a power of two is chosen for steady states.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// A point near the cycle; if empty, the initial point in the field's text.
    #[serde(with = "exact", default)]
    pub at: Vec<Rational>,
    /// The number of steps after which the cycle closes. If ε is unknown, the search finds ε for
    /// this number of steps, and 1 lets the search choose the number.
    #[serde(default = "one")]
    pub period: usize,
    /// A further unknown besides the points of the cycle. If this is ε, the search finds limit
    /// cycles of the flow.
    #[serde(default)]
    pub free: Option<FreeUnknown>,
    /// The number of steps that are made before the search, if ε is unknown.
    #[serde(default)]
    pub transient: u64,
    /// The axis of the branch: a parameter, or `eps`.
    #[serde(default, with = "axes")]
    pub over: Option<Axis>,
    /// During the search, these integrals keep the values that they have at the point `at`.
    #[serde(default)]
    pub hold: HeldIntegrals,
}

/// The integrals whose values are fixed during the search for a cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HeldIntegrals {
    /// Linear integrals with constant coefficients.
    #[default]
    Linear,
    /// No integral is held.
    None,
}

impl HeldIntegrals {
    /// All choices.
    pub const ALL: [Self; 2] = [Self::Linear, Self::None];

    /// Returns the name as users write it in a question: `linear` or `none`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            HeldIntegrals::Linear => "linear",
            HeldIntegrals::None => "none",
        }
    }
}

/// An unknown besides the points of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FreeUnknown {
    /// Half the time step.
    Eps,
}

/// A cycle, and its branch.
#[derive(Clone, Debug)]
pub struct CycleFound {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The cycle in doubles. Its multipliers are for perturbations that keep the integrals `held`.
    pub cycle: PeriodicPoint,
    /// The linear integrals with fixed values, written as equations.
    pub held: Vec<String>,
    /// The value of ε.
    pub eps: f64,
    /// The period of a limit cycle of the flow; otherwise `None`.
    pub flow: Option<FlowFound>,
    /// The cycle over ℚ, if its points are fractions of a few digits and no branch is requested.
    pub exact: Option<RationalCycle>,
    /// The name of the axis, and the branch.
    pub branch: Option<(String, Branch)>,
    /// Period and parameter at each point of a branch of limit cycles, extrapolated if possible.
    pub rows: Vec<Option<FlowFound>>,
}

impl Periodic {
    /// Asks for a fixed point, without a branch.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>) -> Self {
        let hold = HeldIntegrals::default();
        Periodic { eps: Some(eps), at, period: one(), free: None, transient: 0, over: None, hold }
    }

    /// Returns the first value on the axis; NaN without an axis.
    fn begin(&self) -> f64 {
        self.over.as_ref().map_or(f64::NAN, |axis| axis.range.value(0).to_f64())
    }

    /// Searches by Newton's method; the claims of the system must hold. A Newton step solves a
    /// dense linear system with an equation for each coordinate of each point of the cycle.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, a cycle that is too long, an unknown axis, or no cycle found.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<CycleFound, StudyError> {
        study.proved()?;
        let family = Family::of(self, study)?;
        let system = study.name().to_owned();
        if self.free == Some(FreeUnknown::Eps) {
            let values = self.over.as_ref().map_or(1, |axis| axis.range.count() as u64);
            let count = WorkCount::new("cycles", 3 * values, watch);
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
        family.to_all_variables(&mut cycle);
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
    /// Iterates over the points of the branch at requested values and at bifurcations.
    pub fn rows(&self) -> impl Iterator<Item = (&BranchPoint, Option<&FlowFound>)> {
        let points = self.branch.iter().flat_map(|(_, branch)| &branch.points).enumerate();
        let rows = points.map(|(k, point)| (point, self.rows.get(k).and_then(Option::as_ref)));
        rows.filter(|(point, _)| point.mark != BranchPointKind::Between)
    }

    /// Returns the eigenvalues of f′ at a steady state; `None` for other cycles. A multiplier μ of
    /// the map gives the eigenvalue λ = (μ − 1)/(ε(μ + 1)).
    #[must_use]
    pub fn eigenvalues(&self, cycle: &PeriodicPoint, eps: f64) -> Option<Vec<Complex<f64>>> {
        let of = |multiplier: &Complex<f64>| (multiplier - 1.0) / (multiplier + 1.0) / eps;
        (cycle.points.len() == 1).then(|| cycle.multipliers.iter().map(of).collect())
    }

    /// Describes a bifurcation. A bifurcation of steady states is described in terms of the field.
    #[must_use]
    pub fn change_in_words(&self, change: BranchChange) -> String {
        let of_field = match change {
            BranchChange::Fold => "fold, two steady states meet",
            BranchChange::ThroughOne => "an eigenvalue of f' goes through 0",
            BranchChange::ThroughCircle => {
                "Hopf point, a pair of eigenvalues of f' goes through the imaginary axis"
            }
            BranchChange::ThroughMinusOne | BranchChange::Halved | BranchChange::Hopf => {
                return change.to_string();
            }
        };
        if self.cycle.points.len() == 1 { of_field.to_owned() } else { change.to_string() }
    }
}

/// A linear integral Σ cₖ xₖ with a fixed value.
struct HeldIntegral {
    /// The coefficients cₖ that differ from 0, each with its index k.
    coefficients: Vec<(usize, Rational)>,
    value: Rational,
}

impl HeldIntegral {
    fn of(coefficients: Vec<(usize, Rational)>, point: &[Rational]) -> Self {
        HeldIntegral { value: value(&coefficients, point), coefficients }
    }

    /// Writes the integral and its value as an equation with a positive first coefficient.
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

/// The map at each value of the axis.
struct Family {
    study: Study,
    eps: Rational,
    start: Vec<f64>,
    held: Vec<HeldIntegral>,
    /// The level set of the integrals with fixed values.
    leaf: LevelSet,
    /// The index of the varied parameter; `None` for ε, and without an axis.
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
        let eps = given.or_else(|| is_steady.then(|| eps_for(study.map().ok()?, &point))?);
        let eps = eps.ok_or(StudyError::MissingStep)?;
        // Report mistakes in the question before the search.
        let (_, start) = study.in_floats(&point, &eps)?;
        let mut integrals = match asked.hold {
            HeldIntegrals::Linear => integrals(&study, parameter, &start)?,
            HeldIntegrals::None => Vec::new(),
        };
        let floats = |integral: &Vec<(usize, Rational)>| {
            integral.iter().map(|(k, c)| (*k, c.to_f64())).collect::<Vec<_>>()
        };
        // Limit cycles of a lifted field are searched in the original variables.
        let variables = if asked.free.is_some() { study.coordinates().len() } else { start.len() };
        integrals.retain(|integral| integral.iter().all(|(k, _)| *k < variables));
        let floats: Vec<_> = integrals.iter().map(floats).collect();
        let leaf = LevelSet::through(&start[..variables], &floats);
        let held = integrals.into_iter().map(|integral| HeldIntegral::of(integral, &point)).collect();
        Ok(Family { study, eps, start, held, leaf, parameter, changes: axis.is_some() })
    }

    fn eps_at(&self, value: f64) -> f64 {
        match (self.changes, self.parameter) {
            (true, None) => value,
            _ => self.eps.to_f64(),
        }
    }

    fn equations(&self) -> Vec<String> {
        self.held.iter().map(|integral| integral.equation(&self.study)).collect()
    }

    fn on_leaf(&self, value: f64) -> OnLevelSet<'_, ParametricAt> {
        OnLevelSet { map: self.at(value).by(self.parameter), leaf: &self.leaf }
    }

    /// Converts the points of a cycle from coordinates on the level set to all variables.
    fn to_all_variables(&self, cycle: &mut PeriodicPoint) {
        for point in &mut cycle.points {
            *point = self.leaf.point(point);
        }
    }

    fn values_at(&self, value: f64) -> Vec<Rational> {
        let mut parameters = self.own().parameters().to_vec();
        if let Some(place) = self.parameter {
            parameters[place] = Rational::from_f64(value).unwrap_or_default();
        }
        parameters
    }

    /// Returns the map at this value of the axis, with ε = NaN if the field divides by zero.
    fn at(&self, value: f64) -> MapAt<f64> {
        match self.study.map_at(&self.values_at(value)) {
            Some(map) => map.at(self.eps_at(value)),
            None => self.own().at(f64::NAN),
        }
    }

    fn branch(&self, cycle: &PeriodicPoint, axis: &Axis, watch: &dyn Watch) -> Branch {
        let (ends, steps) = (axis.range.ends().map(|end| end.to_f64()), axis.range.count() - 1);
        let count = WorkCount::new("cycles", steps as u64, watch);
        let mut branch = branch(|value| self.on_leaf(value), cycle, ends, steps, |_| count.tell(1));
        self.finish(&mut branch, axis);
        branch
    }

    /// Converts the points to all variables, and sets requested axis values to the nearest doubles.
    fn finish(&self, branch: &mut Branch, axis: &Axis) {
        for point in &mut branch.points {
            self.to_all_variables(&mut point.cycle);
            if let BranchPointKind::Asked(k) = point.mark {
                point.parameter = axis.range.value(k).to_f64();
            }
        }
    }

    fn own(&self) -> &Map {
        self.study.map().expect("the family was made where its field is defined")
    }

    /// Returns the cycle over ℚ, if no branch is requested.
    fn exact(&self, cycle: &PeriodicPoint) -> Option<RationalCycle> {
        if self.changes {
            return None;
        }
        let exact = self.own().rational_cycle(&self.eps, cycle)?;
        let is_held = |held: &HeldIntegral| value(&held.coefficients, &exact.points[0]) == held.value;
        self.held.iter().all(is_held).then(|| exact.on_leaf(self.held.len()))
    }
}

/// Returns the linear integrals that the field has for almost all values of the varied parameter.
/// Each contains a variable, preferably a small one, that occurs in no other integral.
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
    // If there are as many integrals as variables, every point is fixed, and no integral is needed.
    Ok(if found.len() < start.len() { found } else { Vec::new() })
}

/// Returns a power of two for ε at which the entries of ∂x̃/∂x − I are at most about 1.
fn eps_for(map: &Map, point: &[Rational]) -> Option<Rational> {
    /// A number of trials that covers all powers of two among doubles.
    const MAX_TRIALS: usize = 2200;

    let start: Vec<f64> = point.iter().map(Rational::to_f64).collect();
    let change = |eps: f64| {
        let derivative = map.at(eps).derivative(&start);
        let change = &derivative - DMatrix::identity(start.len(), start.len());
        if change.iter().all(|entry| entry.is_finite()) { change.amax() } else { f64::INFINITY }
    };
    let mut eps = 1.0;
    for _ in 0..MAX_TRIALS {
        match change(eps) {
            0.0 => return Some(Rational::one()),
            change if change > 1.0 => eps /= 2.0,
            change if change < 0.25 => eps *= 2.0,
            _ => break,
        }
    }
    Rational::from_f64(eps)
}

/// Returns the characteristic polynomial, in z, of the product of Jacobians along a cycle.
#[must_use]
pub fn characteristic_polynomial(exact: &RationalCycle) -> String {
    let symbols = Symbols { states: vec!["z".to_owned()], parameters: Vec::new() };
    Text.polynomial(&symbols, &exact.polynomial)
}

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
            place["change"] = json!(point.change().map(|change| self.change_in_words(change)));
            if self.flow.is_some() {
                place["eps"] = json!(point.eps);
                place["flow"] = flow::object(found, &point.cycle, point.eps);
            }
            place
        };
        let turn = |(point, found): (&BranchPoint, Option<&FlowFound>)| {
            let mut turn =
                json!({"change": self.change_in_words(point.change()?), "parameter": point.parameter});
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
