//! The cheapest setting that follows a trajectory.
//!
//! The solution ([`Flow`]) is computed in `f64`, and a second one from a nearby start shows how
//! rounding errors grow. If these errors matter, or the tolerance is below 10⁻¹², the solution is
//! computed in [`Dd`]. The measured error of a setting must be within the tolerance over the whole
//! time. An orbit ten times as accurate as requested checks the solution.

use kahan_core::nalgebra::SVector;

use crate::flow::{Flow, NoFlow, SeriesScalar};
use kahan_core::{Dd, ExtendScalars, PreparedStep, QuadraticField};

use super::search::{ALTERNATIVES_TO_DOUBLE, OF_DOUBLE, REFERENCE_ACCURACY_FACTOR, Search, Trials, Verdict};
use super::{NoSetting, Scene, Scheme, Setting};

/// The largest amount of work of a choice, including all trials, in steps of the map.
const MOST_WORK: f64 = 1e6;
/// The tolerance below which the computation begins in `Dd`.
const DOUBLE_DOUBLE_TOLERANCE: f64 = 1e-12;
/// A bound on the rounding errors of a flow in `f64`, before the flow amplifies them.
const FLOW_ROUNDING_ERROR: f64 = 1000.0 * f64::EPSILON;
/// The relative distance of two starts whose solutions are compared.
const NEARBY_START_DISTANCE: f64 = 1.0 / (1_u64 << 36) as f64;
const SHARE: f64 = 0.4;
/// A trial stops at this relative error, or at four times the tolerance if that is larger.
const MIN_STOPPING_ERROR: f64 = 0.1;

pub(super) fn choose<M, const N: usize>(
    scene: &Scene,
    map: &M,
    x0: &SVector<f64, N>,
) -> Result<Setting, NoSetting>
where
    M: ExtendScalars<f64, N>,
{
    let mut budget = Budget { left: MOST_WORK };
    let start = *x0;
    if scene.tolerance >= DOUBLE_DOUBLE_TOLERANCE
        && let Some(flow) = budget.verified_flow(scene, map, start)
    {
        let choice = TrajectoryChoice { scene, map, x0, flow: &flow, others: &OF_DOUBLE };
        match choice.choose(&mut budget) {
            Err(TrajectoryFailure { is_rough: true, .. }) => {}
            answer => return answer.map_err(|refusal| refusal.why),
        }
    }
    let wide = map.extend_scalars::<Dd>(|parameter| Dd::from(*parameter));
    let flow = budget.flow(scene, &wide, start.map(Dd::from))?;
    let choice = TrajectoryChoice { scene, map, x0, flow: &flow, others: &ALTERNATIVES_TO_DOUBLE };
    choice.choose(&mut budget).map_err(|refusal| refusal.why)
}

struct Budget {
    left: f64,
}

impl Budget {
    fn flow<T, F, const N: usize>(
        &mut self,
        scene: &Scene,
        field: &F,
        start: SVector<T, N>,
    ) -> Result<Flow<T>, NoSetting>
    where
        T: SeriesScalar,
        F: QuadraticField<T, N>,
    {
        // The work of a piece in steps of the map: a piece takes TERMS²/4 bilinear forms, each of
        // which costs about a third of a step.
        let piece = (T::TERMS * T::TERMS) as f64 / 12.0;
        let most = (SHARE * self.left / piece) as usize;
        let flow = Flow::through(field, start, scene.horizon, 0.0, &mut |pieces| {
            self.left -= piece;
            pieces < most
        });
        flow.map_err(|why| match why {
            NoFlow::Escapes { time } => NoSetting::Lost { time },
            NoFlow::Stopped { reached } => NoSetting::TooLong { time: reached },
        })
    }

    /// Computes the solution in `f64`. Returns `None` if amplified rounding errors exceed the
    /// tolerance. A second solution from a nearby start measures the amplification.
    fn verified_flow<F, const N: usize>(
        &mut self,
        scene: &Scene,
        field: &F,
        start: SVector<f64, N>,
    ) -> Option<Flow<f64>>
    where
        F: QuadraticField<f64, N>,
    {
        let flow = self.flow(scene, field, start).ok()?;
        // Different factors for the coordinates imitate independent rounding errors.
        let factor = |i: usize| {
            if i.is_multiple_of(2) { 1.0 + NEARBY_START_DISTANCE } else { 1.0 - 0.75 * NEARBY_START_DISTANCE }
        };
        let beside = self.flow(scene, field, SVector::from_fn(|i, _| factor(i) * start[i])).ok()?;
        let distance = |t: f64| {
            let x: Vec<Dd> = beside.at(t.into()).into_iter().map(Dd::from).collect();
            flow.distance(t.into(), &x)
        };
        let growth = flow.breaks().map(distance).fold(0.0, f64::max) / NEARBY_START_DISTANCE;
        (FLOW_ROUNDING_ERROR * growth <= scene.tolerance).then_some(flow)
    }
}

struct TrajectoryChoice<'a, T, M, const N: usize> {
    scene: &'a Scene,
    map: &'a M,
    x0: &'a SVector<f64, N>,
    flow: &'a Flow<T>,
    /// The schemes, besides plain `f64`, that may be chosen.
    others: &'static [Scheme],
}

struct TrajectoryFailure {
    why: NoSetting,
    is_rough: bool,
}

impl<T, M, const N: usize> TrajectoryChoice<'_, T, M, N>
where
    T: SeriesScalar,
    M: ExtendScalars<f64, N>,
{
    fn choose(&self, budget: &mut Budget) -> Result<Setting, TrajectoryFailure> {
        // The first trial is coarse: the motion turns by about 8 radians per step.
        let coarsest = (self.flow.turning() / 8.0).ceil().clamp(1.0, MOST_WORK) as u64;
        let runs = TrialOrbits { choice: self, budget, agreed_until: 0.0, is_short_of_work: false };
        let mut search = Search::counted(runs, self.scene.tolerance);
        let verdict = search.run(coarsest, self.others);
        let TrialOrbits { agreed_until, is_short_of_work, .. } = *search.trials();
        match verdict {
            Verdict::Choice(setting) => Ok(setting),
            Verdict::None { least_error, is_rough } => {
                let why = if least_error < MIN_STOPPING_ERROR {
                    // The factor 2 allows for another ε, where rounding errors may be larger.
                    NoSetting::OutOfReach {
                        best: libm::exp2(libm::log2(2.0 * REFERENCE_ACCURACY_FACTOR * least_error).ceil()),
                    }
                } else if is_short_of_work {
                    NoSetting::TooLong { time: agreed_until }
                } else {
                    NoSetting::Lost { time: agreed_until }
                };
                Err(TrajectoryFailure { why, is_rough: is_rough || !is_short_of_work })
            }
        }
    }
}

/// Orbits of one scene that are compared with the flow, within a limited amount of work.
struct TrialOrbits<'a, T, M, const N: usize> {
    choice: &'a TrajectoryChoice<'a, T, M, N>,
    budget: &'a mut Budget,
    /// The time until which some orbit stayed near the flow.
    agreed_until: f64,
    is_short_of_work: bool,
}

impl<T, M, const N: usize> Trials for TrialOrbits<'_, T, M, N>
where
    T: SeriesScalar,
    M: ExtendScalars<f64, N>,
{
    fn setting(&self, scheme: Scheme, steps: u64) -> Setting {
        self.choice.scene.setting(scheme, steps)
    }

    fn error(&mut self, setting: &Setting, share: f64) -> Option<f64> {
        // The comparison of a point with the flow costs about as much as one step of the map.
        let work_of_step = setting.scheme.composition.stages() as f64 + 1.0;
        if setting.steps as f64 * work_of_step > share * self.budget.left {
            self.is_short_of_work = true;
            return None;
        }
        let TrajectoryChoice { scene, map, x0, flow, .. } = *self.choice;
        let lost = MIN_STOPPING_ERROR.max(4.0 * scene.tolerance);
        let dt = Dd::from(2.0 * setting.eps);
        let mut along = flow.distances::<N>();
        let (mut worst, mut last) = (0.0_f64, 0);
        setting.follow(map, *x0, |n, x| {
            last = n;
            worst = worst.max(along.distance(dt * Dd::from(n as f64), x));
            if n == setting.steps {
                // The last point is compared with the flow at its own time, and also at the
                // horizon.
                worst = worst.max(flow.distance(scene.horizon.into(), x));
            }
            worst <= lost
        });
        self.budget.left -= last as f64 * work_of_step;
        self.agreed_until = self.agreed_until.max(f64::from(dt) * last as f64);
        Some(if worst <= lost { worst } else { f64::INFINITY })
    }

    fn price(&self, scheme: Scheme) -> f64 {
        scheme.cycles(<M::Prepared as PreparedStep<f64, N>>::COST)
    }
}
