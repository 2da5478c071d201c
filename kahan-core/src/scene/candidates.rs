//! The cheapest setting that follows a trajectory.
//!
//! In: the laws of four orders, the roundings of every kind of number. Out: of all that serve the one with the least price.

use nalgebra::SVector;

use crate::{Composition, Lift};

use super::pilot::{Ladder, Span};
use super::rounding::Roundings;
use super::{NoSetting, Precision, Scene, Setting};

/// Roundings are taken times this: a random walk's end is within a factor of 2 of what is typical 19 times in 20.
pub(super) const SAFETY: f64 = 2.0;
/// Errors of the discretisation are taken times this: where the law is seen to hold it still bends by some tens of percent a rung.
const LAW: f64 = 4.0;
/// Beyond the pilots' time roundings grow at least like this power: the phase of a periodic motion whose frequency walks.
const WALKING_PHASE: f64 = 1.5;
/// Errors that grow faster than this at the pilots' end are not continued.
const STEEPEST: f64 = 2.5;
/// An error that was measured at the very ε is taken times this: it is Richardson's of a coarse orbit.
const MEASURED: f64 = 1.5;
/// How many more steps are tried where a trial contradicts a law, and how often.
const STRETCH: f64 = 1.15;
const TRIALS: usize = 40;
/// How much finer roundings are measured where they decide.
const FINER: u64 = 8;
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
    let mut ladders = ORDERS.map(|composition| Ladder::climb(map, x0, composition, span));
    let Some(shortest) = settled(&ladders).min_by_key(|ladder| ladder.stages()) else {
        let agreed = ladders.iter().filter_map(|ladder| ladder.as_ref().err());
        return Err(NoSetting::Lost { time: agreed.fold(0.0, |latest, time| latest.max(*time)) });
    };
    let power = settled(&ladders).map(|ladder| ladder.power).fold(0.0, f64::max);
    if span.beyond > 1.0 && power > STEEPEST {
        return Err(NoSetting::Unpredictable { time: span.time, power });
    }
    let roundings = |finer| Roundings::of(map, x0, shortest, span.time, finer);
    let mut trial =
        Trial { horizon: scene.horizon, span, coarse: roundings(1), fine: None, power: power.max(1.0) };
    let is_cheap = |setting: Setting| setting.precision != Precision::DoubleDouble;
    let first = trial.cheapest(map, &ladders, scene.tolerance);
    if !first.is_some_and(is_cheap) && scene.tolerance > Precision::Double.unit() {
        // Before one pays ten times as much: finer steps round less where the state carries its error.
        trial.fine = Some(roundings(FINER));
    }
    for _ in 0..TRIALS {
        let Some(choice) = trial.cheapest(map, &ladders, scene.tolerance) else { break };
        let mut chosen =
            ladders.iter_mut().flatten().filter(|ladder| ladder.composition == choice.composition);
        match chosen.next() {
            Some(ladder) if !trial.bears_out(map, x0, ladder, &choice, scene.tolerance) => {
                ladder.stretch *= STRETCH;
            }
            _ => return Ok(choice),
        }
    }
    let serves = |tolerance| trial.cheapest(map, &ladders, tolerance).is_some();
    Err(NoSetting::OutOfReach { best: least(serves) })
}

type Ladders = [Result<Ladder, f64>; ORDERS.len()];

fn settled(ladders: &Ladders) -> impl Iterator<Item = &Ladder> {
    ladders.iter().filter_map(|ladder| ladder.as_ref().ok())
}

/// The least power of 2 that serves, up to 1; infinite where none does.
fn least(serves: impl Fn(f64) -> bool) -> f64 {
    let mut powers = (-110..=0).map(|power| f64::from(power).exp2());
    powers.find(|tolerance| serves(*tolerance)).unwrap_or(f64::INFINITY)
}

/// Every kind of number; compensation makes no sense where no rounding is ever seen.
pub(super) fn kinds() -> impl Iterator<Item = (Precision, bool)> {
    let modes = Precision::ALL.into_iter().flat_map(|precision| [(precision, false), (precision, true)]);
    modes.filter(|kind| *kind != (Precision::DoubleDouble, true))
}

/// What is known of a scene.
#[derive(Debug)]
struct Trial {
    horizon: f64,
    span: Span,
    /// Roundings at the steps of the shortest ladder, and where they decide, at finer ones.
    coarse: Roundings,
    fine: Option<Roundings>,
    /// The power of time with which errors grow.
    power: f64,
}

impl Trial {
    fn cheapest<M, const N: usize>(&self, map: &M, ladders: &Ladders, tolerance: f64) -> Option<Setting>
    where
        M: Lift<f64, N>,
    {
        let kinds = settled(ladders).flat_map(|ladder| kinds().map(move |kind| (ladder, kind)));
        let settings = kinds.filter_map(|(ladder, kind)| self.setting(map, ladder, kind, tolerance));
        settings.min_by(|a, b| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error)))
    }

    /// Whether an orbit of this very ε does not err more than its law says: coarse steps can come near a pole of the map where
    /// neither half nor twice as many do.
    fn bears_out<M, const N: usize>(
        &self,
        map: &M,
        x0: &SVector<f64, N>,
        ladder: &Ladder,
        setting: &Setting,
        tolerance: f64,
    ) -> bool
    where
        M: Lift<f64, N>,
    {
        let steps = (setting.steps as f64 / self.span.beyond).ceil();
        let measured = ladder.trial(map, x0, 2.0 * setting.eps * steps, steps as u64);
        measured.is_none_or(|error| MEASURED * self.span.beyond.powf(self.power) * error <= tolerance)
    }

    /// What roundings come to at the horizon, from the steps over the pilots' time.
    fn roundings(&self, ladder: &Ladder, precision: Precision, compensated: bool, steps: f64) -> f64 {
        let stages = steps * ladder.composition.stages() as f64;
        let further = self.span.beyond.powf(self.power.max(WALKING_PHASE));
        let fine = self.fine.filter(|fine| fine.stages <= stages);
        SAFETY * further * fine.unwrap_or(self.coarse).expected(precision, compensated, stages)
    }

    /// The coarsest ε that does.
    fn setting<M, const N: usize>(
        &self,
        map: &M,
        ladder: &Ladder,
        (precision, compensated): (Precision, bool),
        tolerance: f64,
    ) -> Option<Setting>
    where
        M: Lift<f64, N>,
    {
        let further = LAW * self.span.beyond.powf(self.power);
        let mut steps = ladder.steps(tolerance / further);
        // What the roundings leave of the tolerance; more steps round more often, so this settles from below.
        for _ in 0..4 {
            let left = tolerance - self.roundings(ladder, precision, compensated, steps);
            if left.is_nan() || left <= 0.0 {
                return None;
            }
            steps = ladder.steps(left / further);
        }
        let all = (steps * self.span.beyond).ceil();
        if all.is_nan() || all >= MOST_STEPS {
            return None;
        }
        let horizon = self.horizon;
        let mut setting = Setting::over(map, horizon, precision, ladder.composition, compensated, all);
        let steps = setting.steps as f64 / self.span.beyond;
        let error = further * ladder.error(steps) + self.roundings(ladder, precision, compensated, steps);
        // A short ε may be the larger one by a last digit.
        setting.error = error.min(tolerance);
        (setting.eps > 0.0 && setting.eps.is_finite()).then_some(setting)
    }
}
