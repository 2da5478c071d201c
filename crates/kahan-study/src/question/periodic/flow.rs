//! Cycles of the flow: ε is found with the points, from an orbit that comes back close to itself.

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::{Complex, DMatrix};
use kahan_core::{Step, Stopped, Workspace};
use kahan_dynamics::periodic::{
    Branch, Differentiable, Extrapolated, FlowCycle, NoPeriodicPoint, OnLeaf, Parametric, Turn,
    close_returns, flow_branch, flow_cycle,
};
use kahan_runtime::ParametricAt;
use serde_json::{Value, json};

use crate::count::Count;
use crate::error::StudyError;
use crate::range::Axis;

use super::{Family, Periodic};

/// The most numbers that Newton's method carries along a cycle of N points, those of a cycle of 4N
/// points being the last: some second each round.
const MOST_NUMBERS: usize = 4_000_000;

/// The numbers that are carried along a cycle of a field of n variables, each step.
fn numbers(n: usize) -> usize {
    n * (n + 4)
}

/// A cycle of the flow, besides its points at N steps.
#[derive(Clone, Debug)]
pub struct FlowFound {
    /// The period, of N, 2N and 4N steps.
    pub period: Extrapolated,
    /// The multipliers but for that of the direction of the flow, of N, 2N and 4N steps.
    pub multipliers: Vec<Complex<f64>>,
    /// The changes on the branch, of N, 2N and 4N steps, in the order of its turns; `None` where
    /// the three branches do not change alike.
    pub turns: Option<Vec<Extrapolated>>,
}

impl FlowFound {
    /// Returns an object of JSON.
    pub(super) fn object(&self, eps: f64) -> Value {
        json!({
            "eps": eps,
            "period": self.period.value,
            "error": self.period.error,
            "multipliers": self.multipliers.iter().map(|one| [one.re, one.im]).collect::<Vec<_>>(),
        })
    }
}

/// The steps of a field's map between points in the original variables, with derivatives: those of
/// a lifted field begin on its relations, which have no multipliers then.
struct FlowAt<'a> {
    family: &'a Family,
    at: ParametricAt,
    /// The values of all parameters.
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
        // New variables may depend on the parameter, too.
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
    /// The map at a value of what changes and an ε, its derivative being by the parameter that
    /// changes or by ε; without a value once the watch ended the work, so that all searches end.
    fn flow_at(&self, value: f64, eps: f64, by: Option<usize>, count: &Count<'_>) -> OnLeaf<'_, FlowAt<'_>> {
        let values = self.values_at(value);
        let eps = if count.tell(0).is_break() { f64::NAN } else { eps };
        let map = self.study.map_at(&values);
        let at = map.map_or_else(|| self.own().at(f64::NAN), |map| map.at(eps));
        let values = values.iter().map(Rational::to_f64).collect();
        OnLeaf { map: FlowAt { family: self, at: at.by(by), values }, leaf: &self.leaf }
    }

    /// Looks for a cycle of the flow near the start, and near where its orbit comes back.
    pub(super) fn flow_cycle(
        &self,
        asked: &Periodic,
        begin: f64,
        count: &Count<'_>,
    ) -> Result<FlowCycle, NoPeriodicPoint> {
        /// The longest orbit, the longest return of one where no number of steps was asked for, and
        /// how far a cycle's ε, or the steps of a return, may be from those that were looked for.
        const MOST_POINTS: usize = 256_000;
        const MOST_STEPS: usize = 20_000;
        const NEAR: f64 = 0.1;
        /// The steps at once between two looks at the watch.
        const AT_ONCE: u64 = 100_000;

        let map = |eps| self.flow_at(begin, eps, None, count);
        let (eps, wanted) = (self.eps.to_f64(), (asked.period > 1).then_some(asked.period));
        let search = |start: &[f64], eps: f64, steps: usize| {
            let found = flow_cycle(map, start, eps, steps)?;
            let is_it = (found.eps / eps - 1.0).abs() < NEAR && found.cycle.points.len() == steps;
            if is_it { Ok(found) } else { Err(NoPeriodicPoint::NoReturn) }
        };
        let mut x = self.leaf.coordinates(&self.start);
        let longest = MOST_STEPS.min(MOST_NUMBERS / numbers(x.len()));
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
                let steps = wanted.unwrap_or(one.steps);
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

    /// The cycle at N, 2N and 4N steps, with its branch.
    pub(super) fn flow_found(
        &self,
        asked: &Periodic,
        count: &Count<'_>,
    ) -> Result<(FlowCycle, FlowFound, Option<Branch>), StudyError> {
        self.can_free_step()?;
        let numbers = asked.period.saturating_mul(numbers(self.study.coordinates().len()));
        if numbers > MOST_NUMBERS {
            return Err(StudyError::LongCycle { unknowns: numbers, most: MOST_NUMBERS });
        }
        let begin = asked.begin();
        let map = |eps| self.flow_at(begin, eps, None, count);
        let cycles = || {
            let first = self.flow_cycle(asked, begin, count)?;
            let second = first.doubled(map)?;
            let third = second.doubled(map)?;
            Ok([first, second, third])
        };
        let no_cycle = |why| StudyError::NoCycle { system: self.study.name().to_owned(), why };
        let cycles: [FlowCycle; 3] = cycles().map_err(no_cycle)?;
        let multiplier = |k: usize| {
            let all = cycles.each_ref().map(|cycle| cycle.cycle.multipliers[k]);
            let [re, im] =
                [all.map(|one| one.re), all.map(|one| one.im)].map(|all| Extrapolated::of(all).value);
            Complex::new(re, im)
        };
        let mut found = FlowFound {
            period: Extrapolated::of(cycles.each_ref().map(FlowCycle::period)),
            multipliers: (0..cycles[0].cycle.multipliers.len()).map(multiplier).collect(),
            turns: None,
        };
        let branch = asked.over.as_ref().map(|axis| {
            let [mut coarse, middle, fine] =
                cycles.each_ref().map(|cycle| self.flow_branch(cycle, axis, count));
            found.turns = turns([&coarse, &middle, &fine]);
            for (turn, found) in coarse.turns.iter_mut().zip(found.turns.iter().flatten()) {
                turn.parameter = found.value;
            }
            coarse.points.iter_mut().for_each(|point| self.unfold(&mut point.cycle));
            coarse
        });
        let [mut first, ..] = cycles;
        self.unfold(&mut first.cycle);
        Ok((first, found, branch))
    }

    fn flow_branch(&self, cycle: &FlowCycle, axis: &Axis, count: &Count<'_>) -> Branch {
        let (ends, steps) = (axis.range.ends().map(|end| end.to_f64()), axis.range.count() - 1);
        let map = |value, eps| [None, self.parameter].map(|by| self.flow_at(value, eps, by, count));
        flow_branch(map, cycle, ends, steps, |_| count.tell(1))
    }

    fn can_free_step(&self) -> Result<(), StudyError> {
        if self.study.time_place().is_some() {
            return Err(StudyError::CycleOfTime { system: self.study.name().to_owned() });
        }
        if self.changes && self.parameter.is_none() { Err(StudyError::FreeStepAlong) } else { Ok(()) }
    }
}

/// The changes of branches at N, 2N and 4N steps, if they are alike.
fn turns(branches: [&Branch; 3]) -> Option<Vec<Extrapolated>> {
    let [coarse, middle, fine] = branches.map(|branch| &branch.turns);
    let are_alike = |(a, b, c): (&Turn, &Turn, &Turn)| {
        (a.change == b.change && b.change == c.change)
            .then(|| Extrapolated::of([a.parameter, b.parameter, c.parameter]))
    };
    let is_one_each = coarse.len() == middle.len() && middle.len() == fine.len();
    let turns = coarse.iter().zip(middle).zip(fine).map(|((a, b), c)| are_alike((a, b, c)));
    is_one_each.then(|| turns.collect())?
}
