//! The cheapest setting that follows a trajectory.
//!
//! In: the laws of four orders, the roundings of every kind of number. Out: of all that serve the one with the least price.

use nalgebra::SVector;

use crate::{Composition, Lift};

use super::pilot::{Ladder, Span};
use super::rounding::Roundings;
use super::{NoSetting, Precision, Scene, Setting};

/// Estimates are taken times this: Richardson's is good to a few percent where the law holds, a random walk's end is within a factor
/// of 2 of what is typical 19 times in 20.
pub(super) const SAFETY: f64 = 2.0;
/// Beyond the pilots' time roundings grow at least like this power: the phase of a periodic motion whose frequency walks.
const WALKING_PHASE: f64 = 1.5;
/// Errors that grow faster than this at the pilots' end are not continued.
const STEEPEST: f64 = 2.5;
/// The most steps: as many as `f64` counts.
pub(super) const MOST_STEPS: f64 = 9e15;

/// The orders' choices; the other compositions need more stages for the same error.
const ORDERS: [Composition; 4] =
    [Composition::KAHAN, Composition::SUZUKI_4, Composition::KAHAN_LI_6, Composition::KAHAN_LI_8];

pub(super) fn choose<M, const N: usize>(
    scene: &Scene,
    map: &M,
    x0: &SVector<f64, N>,
) -> Result<Setting, NoSetting>
where
    M: Lift<f64, N>,
{
    let span = Span::of(map, x0, scene.horizon);
    let ladders = ORDERS.map(|composition| Ladder::climb(map, x0, composition, span));
    let settled = || ladders.iter().filter_map(|ladder| ladder.as_ref().ok());
    let stages = |ladder: &Ladder| ladder.finest() * ladder.composition.stages() as u64;
    let Some(shortest) = settled().min_by_key(|ladder| stages(ladder)) else {
        let agreed = ladders.iter().filter_map(|ladder| ladder.as_ref().err());
        return Err(NoSetting::Lost { time: agreed.fold(0.0, |latest, time| latest.max(*time)) });
    };
    let power = settled().map(|ladder| ladder.power).fold(0.0, f64::max);
    if span.beyond > 1.0 && power > STEEPEST {
        return Err(NoSetting::Unpredictable { time: span.time, power });
    }
    let roundings = Roundings::of(map, x0, shortest, span.time);
    for l in settled() {
        std::eprintln!("{:?} finest {} power {} errors {:?}", l.composition, l.finest(), l.power, &l);
    }
    std::eprintln!("{roundings:?} shortest {:?}", shortest.composition);
    let trial = Trial { scene, span, roundings, power: power.max(1.0) };

    let (mut best, mut least_error): (Option<Setting>, f64) = (None, f64::INFINITY);
    for ladder in settled() {
        for (precision, compensated) in kinds() {
            least_error = least_error.min(trial.least_error(ladder, precision, compensated));
            let Some(setting) = trial.setting(map, ladder, precision, compensated) else { continue };
            let is_better = |known: &Setting| (setting.cost, setting.error) < (known.cost, known.error);
            if best.as_ref().is_none_or(is_better) {
                best = Some(setting);
            }
        }
    }
    best.ok_or(NoSetting::OutOfReach { best: least_error })
}

/// Every kind of number; compensation makes no sense where no rounding is ever seen.
pub(super) fn kinds() -> impl Iterator<Item = (Precision, bool)> {
    let modes = Precision::ALL.into_iter().flat_map(|precision| [(precision, false), (precision, true)]);
    modes.filter(|kind| *kind != (Precision::DoubleDouble, true))
}

/// What is known of a scene.
#[derive(Debug)]
struct Trial<'a> {
    scene: &'a Scene,
    span: Span,
    roundings: Roundings,
    /// The power of time with which errors grow.
    power: f64,
}

impl Trial<'_> {
    /// What roundings come to at the horizon, from the steps over the pilots' time.
    fn roundings(&self, ladder: &Ladder, precision: Precision, compensated: bool, steps: f64) -> f64 {
        let stages = steps * ladder.composition.stages() as f64;
        let further = self.span.beyond.powf(self.power.max(WALKING_PHASE));
        SAFETY * further * self.roundings.expected(precision, compensated, stages)
    }

    /// The least tolerance that this kind meets with as many steps as the pilots of its order took.
    fn least_error(&self, ladder: &Ladder, precision: Precision, compensated: bool) -> f64 {
        2.0 * self.roundings(ladder, precision, compensated, ladder.finest() as f64)
    }

    /// The coarsest ε that does.
    fn setting<M, const N: usize>(
        &self,
        map: &M,
        ladder: &Ladder,
        precision: Precision,
        compensated: bool,
    ) -> Option<Setting>
    where
        M: Lift<f64, N>,
    {
        let further = SAFETY * self.span.beyond.powf(self.power);
        let mut steps = ladder.steps(self.scene.tolerance / further);
        // What the roundings leave of the tolerance; more steps round more often, so this settles from below.
        for _ in 0..4 {
            let left = self.scene.tolerance - self.roundings(ladder, precision, compensated, steps);
            // NaN, where there is no number of steps, is not above 0 either.
            if !(left > 0.0) {
                return None;
            }
            steps = ladder.steps(left / further);
        }
        let all = (steps * self.span.beyond).ceil();
        if !(all < MOST_STEPS) {
            return None;
        }
        let horizon = self.scene.horizon;
        let mut setting = Setting::over(map, horizon, precision, ladder.composition, compensated, all);
        let steps = setting.steps as f64 / self.span.beyond;
        let error = further * ladder.error(steps) + self.roundings(ladder, precision, compensated, steps);
        // A short ε may be the larger one by a last digit.
        setting.error = error.min(self.scene.tolerance);
        (setting.eps > 0.0).then_some(setting)
    }
}
