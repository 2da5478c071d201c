//! The cheapest setting that follows a trajectory.
//!
//! In: the laws of four orders, the roundings of every kind of number. Out: of all that serve the one with the least price.

use nalgebra::SVector;

use crate::{Composition, Lift};

use super::pilot::{Ladder, Span};
use super::rounding::{Roundings, of_double};
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
/// Roundings that were measured at the very ε are taken times this: the times between the pilots' points are not looked at.
const WALKED: f64 = 1.25;
/// Where roundings are expected to take this part of the tolerance, those of the choice are measured,
const FELT: f64 = 0.25;
/// if that takes no more steps of the map in double-double, and so often at most.
const MOST_WIDE: u64 = 1 << 15;
const WIDE_TRIALS: usize = 8;
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
    let roundings = Roundings::of(map, x0, shortest.composition, span.time, shortest.finest());
    let corrections = [1.0; 2];
    let mut trial = Trial { scene: *scene, span, roundings, corrections, power: power.max(1.0) };
    let is_cheap = |setting: Setting| setting.precision != Precision::DoubleDouble;
    let first = trial.cheapest(map, &ladders, scene.tolerance);
    if !first.is_some_and(is_cheap) && scene.tolerance > Precision::Double.unit() {
        // Before one pays ten times as much: finer steps round less where the state carries its error.
        trial.correct(map, x0, &ladders, scene.tolerance);
    }
    let mut wide_trials = 0;
    for _ in 0..TRIALS {
        let Some(choice) = trial.cheapest(map, &ladders, scene.tolerance) else { break };
        let mut chosen =
            ladders.iter_mut().flatten().filter(|ladder| ladder.composition == choice.composition);
        match chosen.next() {
            Some(ladder) if !trial.bears_out(map, x0, ladder, &choice, scene.tolerance) => {
                ladder.stretch *= STRETCH;
            }
            Some(ladder)
                if wide_trials < WIDE_TRIALS
                    && trial.rounds_more(map, x0, ladder, &choice, scene.tolerance) =>
            {
                wide_trials += 1;
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
    scene: Scene,
    span: Span,
    /// Roundings at the steps of the shortest ladder.
    roundings: Roundings,
    /// What those of `f64`, plain and compensated, are times what is expected from there, where they decide.
    corrections: [f64; 2],
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
        let correction = match precision {
            Precision::Double => self.corrections[usize::from(compensated)],
            _ => 1.0,
        };
        let further = self.span.beyond.powf(self.power.max(WALKING_PHASE));
        SAFETY * further * correction * self.roundings.expected(precision, compensated, stages)
    }

    /// Measures the roundings of `f64` at the steps that leave them half of the tolerance.
    fn correct<M, const N: usize>(&mut self, map: &M, x0: &SVector<f64, N>, ladders: &Ladders, tolerance: f64)
    where
        M: Lift<f64, N>,
    {
        let further = LAW * self.span.beyond.powf(self.power);
        let steps = |ladder: &Ladder| ladder.steps(0.5 * tolerance / further).ceil();
        let stages = |ladder: &Ladder| steps(ladder) * ladder.composition.stages() as f64;
        let shortest = settled(ladders).min_by(|a, b| stages(a).total_cmp(&stages(b)));
        let Some(ladder) = shortest.filter(|ladder| stages(ladder) <= MOST_WIDE as f64) else { return };
        let eps = 0.5 * self.span.time / steps(ladder);
        let measured = of_double(map, x0, ladder.composition, eps, steps(ladder) as u64);
        for (compensated, measured) in [false, true].into_iter().zip(measured) {
            let expected = self.roundings.expected(Precision::Double, compensated, stages(ladder));
            self.corrections[usize::from(compensated)] = WALKED / SAFETY * measured / expected;
        }
    }

    /// Whether an orbit in `f64` of this very ε is measured to round more than was expected, which is then corrected.
    fn rounds_more<M, const N: usize>(
        &mut self,
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
        let stages = steps * ladder.composition.stages() as f64;
        let expected = self.roundings(ladder, setting.precision, setting.compensated, steps);
        if setting.precision != Precision::Double || expected < FELT * tolerance || stages > MOST_WIDE as f64
        {
            return false;
        }
        let measured = of_double(map, x0, ladder.composition, setting.eps, steps as u64);
        let mode = usize::from(setting.compensated);
        let further = self.span.beyond.powf(self.power.max(WALKING_PHASE));
        if further * measured[mode] <= expected {
            return false;
        }
        self.corrections[mode] *= WALKED * further * measured[mode] / expected;
        true
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
        let scene = &self.scene;
        let mut setting = Setting::over(map, scene, precision, ladder.composition, compensated, all);
        let steps = setting.steps as f64 / self.span.beyond;
        let error = further * ladder.error(steps) + self.roundings(ladder, precision, compensated, steps);
        // The ε that is taken may be the larger one by a last digit.
        setting.error = error.min(tolerance);
        (setting.eps > 0.0 && setting.eps.is_finite()).then_some(setting)
    }
}
