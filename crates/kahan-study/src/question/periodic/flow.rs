//! Finds limit cycles of the flow by Newton's method. The unknowns are ε, the points of a cycle of
//! the map, and along a branch a parameter. The search starts where an orbit nearly returns to an
//! earlier point.

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::{Complex, DMatrix};
use kahan_core::{Step, Stopped, Workspace};
use kahan_dynamics::periodic::{
    Branch, BranchPoint, BranchPointKind, Differentiable, Extrapolated, FlowCycle, NoPeriodicPoint,
    OnLevelSet, Parametric, PeriodicPoint, close_returns, flow_branch, flow_cycle,
};
use kahan_runtime::ParametricAt;
use serde_json::{Value, json};

use crate::count::WorkCount;
use crate::error::StudyError;
use crate::range::Axis;

use super::{Family, Periodic};

/// The largest number of values stored along a cycle. A Newton step with this number of values
/// takes a second.
const MOST_NUMBERS: usize = 4_000_000;

/// Returns the number of values that are stored for each point of a cycle in n variables.
fn numbers_per_point(n: usize) -> usize {
    n * (n + 4)
}

/// Period and parameter of a limit cycle, extrapolated from cycles with N, 2N, 4N, … points.
#[derive(Clone, Copy, Debug)]
pub struct FlowFound {
    /// The period.
    pub period: Extrapolated,
    /// The parameter that varies along a branch.
    pub parameter: Extrapolated,
}

impl FlowFound {
    /// Extrapolates from cycles of N, 2N, 4N, … steps. Errors are series in ε with these `powers`.
    fn of(mut points: Vec<BranchPoint>, powers: &[i32]) -> (Self, BranchPoint) {
        let limit = |of: &dyn Fn(&BranchPoint) -> f64| {
            Extrapolated::of(&points.iter().map(of).collect::<Vec<_>>(), powers)
        };
        let found = FlowFound {
            period: limit(&|point| period(&point.cycle, point.eps)),
            parameter: limit(&|point| point.parameter),
        };
        let finest = &points[points.len() - 1].cycle.multipliers;
        let is_pair = |one: &Complex<f64>| one.im != 0.0;
        let are_alike = |point: &BranchPoint| {
            let own = &point.cycle.multipliers;
            own.len() == finest.len() && own.iter().map(is_pair).eq(finest.iter().map(is_pair))
        };
        let multiplier = |k: usize| {
            let [re, im]: [&dyn Fn(&BranchPoint) -> f64; 2] =
                [&|point| point.cycle.multipliers[k].re, &|point| point.cycle.multipliers[k].im];
            Complex::new(limit(re).value, limit(im).value)
        };
        let multipliers = match points.iter().all(are_alike) {
            true => (0..finest.len()).map(multiplier).collect(),
            false => finest.clone(),
        };
        let mut first = points.swap_remove(0);
        first.cycle.multipliers = multipliers;
        (found, first)
    }
}

/// Describes a cycle of N points in JSON. If `found` is `None`, the period is 2εN, without an
/// error.
pub(super) fn object(found: Option<&FlowFound>, cycle: &PeriodicPoint, eps: f64) -> Value {
    let of_map = period(cycle, eps);
    json!({
        "steps": cycle.points.len(),
        "eps": eps,
        "period_of_map": of_map,
        "period": found.map_or(of_map, |found| found.period.value),
        "error": found.map(|found| found.period.error),
        "multipliers": cycle.multipliers.iter().map(|one| [one.re, one.im]).collect::<Vec<_>>(),
    })
}

/// Returns the period 2εN of the map's cycle of N points.
fn period(cycle: &PeriodicPoint, eps: f64) -> f64 {
    2.0 * eps * cycle.points.len() as f64
}

/// The map of a field, with its derivatives, in the original variables.
struct FlowAt<'a> {
    family: &'a Family,
    at: ParametricAt,
    values: Vec<f64>,
}

impl FlowAt<'_> {
    fn all(&self, x: &[f64]) -> Vec<f64> {
        self.family.study.embed(x, &self.values)
    }
}

impl Step for FlowAt<'_> {
    type Scalar = f64;
    type State = Vec<f64>;

    fn dimension(&self) -> usize {
        self.family.study.coordinates().len()
    }

    fn eps(&self) -> &f64 {
        Step::eps(&self.at)
    }

    fn advance(&self, x: &mut [f64], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        if self.family.study.lifted().is_none() {
            return self.at.advance(x, steps, workspace);
        }
        for _ in 0..steps {
            let mut all = self.all(x);
            self.at.advance(&mut all, 1, workspace)?;
            x.copy_from_slice(&all[..x.len()]);
        }
        Ok(())
    }

    fn part(&self, eps: &f64, x: &mut [f64], workspace: &mut Workspace) -> Result<(), Stopped> {
        let mut all = self.all(x);
        self.at.part(eps, &mut all, workspace)?;
        x.copy_from_slice(&all[..x.len()]);
        Ok(())
    }
}

impl Differentiable for FlowAt<'_> {
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        let all = self.all(x);
        let derivative = self.at.derivative(&all);
        let Some(relations) = self.family.study.relations() else { return derivative };
        let slopes = relations.slopes(&all, &self.values);
        let new = DMatrix::from_row_slice(all.len() - x.len(), x.len(), &slopes);
        let rows = derivative.rows(0, x.len());
        rows.columns(0, x.len()) + rows.columns(x.len(), new.nrows()) * new
    }
}

impl Parametric for FlowAt<'_> {
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        let all = self.all(x);
        let mut rates = self.at.by_parameter(&all);
        rates.truncate(x.len());
        let place = self.family.parameter.filter(|place| self.at.place() == *place);
        let Some((place, _)) = place.zip(self.family.study.relations()) else { return rates };
        // Central differences give the derivatives of a lift's new variables with respect to the
        // parameter.
        let width = 1e-6 * self.values[place].abs().max(1e-3);
        let [below, above] = [-width, width].map(|shift| {
            let mut values = self.values.clone();
            values[place] += shift;
            self.family.study.embed(x, &values)
        });
        let moved = below.iter().zip(&above).map(|(below, above)| (above - below) / (2.0 * width));
        let moved = DMatrix::from_iterator(all.len(), 1, moved);
        let by_moved = self.at.derivative(&all).rows(0, x.len()) * moved;
        rates.iter().zip(&by_moved).map(|(rate, moved)| rate + moved).collect()
    }
}

impl Family {
    /// Returns the map at a value of the varied parameter and an ε, with its derivative with
    /// respect to parameter `by`, or to ε if `by` is `None`. If the watch has cancelled the work, ε
    /// is NaN, which ends every search.
    fn flow_at(
        &self,
        value: f64,
        eps: f64,
        by: Option<usize>,
        count: &WorkCount<'_>,
    ) -> OnLevelSet<'_, FlowAt<'_>> {
        let values = self.values_at(value);
        let eps = if count.tell(0).is_break() { f64::NAN } else { eps };
        let map = self.study.map_at(&values);
        let at = map.map_or_else(|| self.own().at(f64::NAN), |map| map.at(eps));
        let values = values.iter().map(Rational::to_f64).collect();
        OnLevelSet { map: FlowAt { family: self, at: at.by(by), values }, leaf: &self.leaf }
    }

    /// Searches for a limit cycle near the start, and then near close returns of the start's orbit.
    pub(super) fn flow_cycle(
        &self,
        asked: &Periodic,
        begin: f64,
        count: &WorkCount<'_>,
    ) -> Result<FlowCycle, NoPeriodicPoint> {
        /// The largest number of points among which close returns are sought, by default.
        const MOST_POINTS: usize = 256_000;
        /// The largest number of steps from a point to its close return, by default.
        const MOST_STEPS: usize = 20_000;
        /// A close return may differ from the requested number of steps by this fraction.
        const NEAR: f64 = 0.1;
        /// The number of steps between two checks of the watch.
        const AT_ONCE: u64 = 100_000;

        let map = |eps| self.flow_at(begin, eps, None, count);
        let (eps, wanted) = (self.eps.to_f64(), (asked.period > 1).then_some(asked.period));
        let search = |start: &[f64], eps: f64, steps: usize| {
            let found = flow_cycle(map, start, eps, steps)?;
            // `flow_cycle` returns a single round, which may have fewer steps than requested.
            let is_it = found.is_near(wanted.unwrap_or(found.cycle.points.len()), eps);
            if is_it { Ok(found) } else { Err(NoPeriodicPoint::NoReturn) }
        };
        let mut x = self.leaf.coordinates(&self.start);
        let longest = MOST_STEPS.min(MOST_NUMBERS / numbers_per_point(x.len()));
        let mut why = NoPeriodicPoint::NoReturn;
        if let Some(steps) = wanted.filter(|_| asked.transient == 0) {
            match search(&x, eps, steps) {
                Err(NoPeriodicPoint::Family) => return Err(NoPeriodicPoint::Family),
                Err(error) => why = error,
                found => return found,
            }
        }
        let (at, mut workspace) = (map(eps), Workspace::new());
        let mut left = asked.transient;
        while left > 0 && count.tell(0).is_continue() {
            let steps = left.min(AT_ONCE);
            at.advance(&mut x, steps, &mut workspace).map_err(|_| NoPeriodicPoint::NotFinite)?;
            left -= steps;
        }
        let mut orbit = vec![x.clone()];
        let mut points = 4000.max(4 * wanted.unwrap_or(0));
        while points <= MOST_POINTS.max(4 * wanted.unwrap_or(0)) && !count.is_stopped() {
            while orbit.len() < points {
                at.advance(&mut x, 1, &mut workspace).map_err(|_| NoPeriodicPoint::NotFinite)?;
                orbit.push(x.clone());
            }
            if !x.iter().all(|x| x.is_finite()) {
                return Err(NoPeriodicPoint::NotFinite);
            }
            let part = |share: f64| wanted.map(|steps| (steps as f64 * share) as usize);
            let least = part(1.0 - NEAR).unwrap_or(1);
            let most = part(1.0 + NEAR).unwrap_or((points / 3).min(longest));
            for one in close_returns(&orbit, [least, most]) {
                // A return may be two rounds of a cycle. An even number of steps can be halved.
                let steps = wanted.unwrap_or(one.steps.next_multiple_of(2));
                let near = eps * one.steps as f64 / steps as f64;
                match search(&orbit[one.at], near, steps) {
                    Err(error) => why = error,
                    found => return found,
                }
            }
            points *= 4;
        }
        Err(why)
    }

    /// Returns the cycle, its period and parameter extrapolated to ε = 0, and the requested branch.
    pub(super) fn flow_found(
        &self,
        asked: &Periodic,
        count: &WorkCount<'_>,
    ) -> Result<(BranchPoint, FlowFound, Option<FlowBranch>), StudyError> {
        self.can_free_step()?;
        let numbers = asked.period.saturating_mul(numbers_per_point(self.study.coordinates().len()));
        if numbers > MOST_NUMBERS {
            return Err(StudyError::LongCycle { unknowns: numbers, most: MOST_NUMBERS });
        }
        // Errors are series in ε², but for lifted fields series in ε.
        let powers = if self.study.lifted().is_some() { Extrapolated::ALL } else { Extrapolated::EVEN };
        let begin = asked.begin();
        let map = |eps| self.flow_at(begin, eps, None, count);
        let cycles = || {
            let mut cycles = vec![self.flow_cycle(asked, begin, count)?];
            while cycles.len() <= powers.len() {
                cycles.push(cycles[cycles.len() - 1].doubled(map)?);
            }
            Ok(cycles)
        };
        let no_cycle = |why| StudyError::NoCycle { system: self.study.name().to_owned(), why };
        let cycles: Vec<FlowCycle> = cycles().map_err(no_cycle)?;
        let branch = asked.over.as_ref().map(|axis| {
            let branches: Vec<_> = cycles.iter().map(|cycle| self.flow_branch(cycle, axis, count)).collect();
            let (mut branch, found) = extrapolated(branches, powers);
            self.finish(&mut branch, axis);
            (branch, found)
        });
        let point = |FlowCycle { cycle, eps }| BranchPoint {
            parameter: begin,
            eps,
            cycle,
            mark: BranchPointKind::Asked(0),
        };
        let (found, mut first) = FlowFound::of(cycles.into_iter().map(point).collect(), powers);
        self.to_all_variables(&mut first.cycle);
        Ok((first, found, branch))
    }

    fn flow_branch(&self, cycle: &FlowCycle, axis: &Axis, count: &WorkCount<'_>) -> Branch {
        let (ends, steps) = (axis.range.ends().map(|end| end.to_f64()), axis.range.count() - 1);
        let map = |value, eps| [None, self.parameter].map(|by| self.flow_at(value, eps, by, count));
        flow_branch(map, cycle, ends, steps, |point| {
            count.tell(u64::from(matches!(point.mark, BranchPointKind::Asked(_))))
        })
    }

    fn can_free_step(&self) -> Result<(), StudyError> {
        if self.study.time_place().is_some() {
            return Err(StudyError::CycleOfTime { system: self.study.name().to_owned() });
        }
        if self.changes && self.parameter.is_none() { Err(StudyError::FreeStepAlong) } else { Ok(()) }
    }
}

/// A branch of cycles, and for each point the extrapolated period and parameter, if known.
type FlowBranch = (Branch, Vec<Option<FlowFound>>);

fn extrapolated(mut branches: Vec<Branch>, powers: &[i32]) -> FlowBranch {
    let is_like = |mark: BranchPointKind| move |point: &&BranchPoint| point.mark == mark;
    let extrapolate = |(index, point): (usize, &BranchPoint)| {
        // Corresponding points are the k-th points with this `mark` on each branch, for one k.
        let before = branches[0].points[..index].iter().filter(is_like(point.mark)).count();
        let alike =
            branches.iter().map(|one| one.points.iter().filter(is_like(point.mark)).nth(before).cloned());
        let alike: Vec<_> =
            alike.collect::<Option<_>>().filter(|_| point.mark != BranchPointKind::Between)?;
        Some(FlowFound::of(alike, powers))
    };
    let found: Vec<_> = branches[0].points.iter().enumerate().map(extrapolate).collect();
    let mut coarse = branches.swap_remove(0);
    let points = coarse.points.iter_mut().zip(found);
    let found = points.map(|(point, found)| {
        let (found, first) = found?;
        *point = first;
        if let BranchPointKind::Change(_) = point.mark {
            point.parameter = found.parameter.value;
        }
        Some(found)
    });
    let found = found.collect();
    (coarse, found)
}
