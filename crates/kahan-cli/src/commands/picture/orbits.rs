//! Orbits of doubles, followed while time is left.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use kahan_algebra::rational::Rational;
use kahan_core::observe::Visit;
use kahan_runtime::{Ended, Field, Follow, MapAt};

use super::Subject;
use crate::printing::{Prompt, Refusal};

/// Progress, and the time that is left.
pub(super) struct Pace {
    progress: Prompt,
    end: Instant,
}

impl Pace {
    pub(super) fn new(steps: u64, seconds: f64) -> Self {
        // A time beyond all clocks is no bound, and a century is none either.
        let allowed = Duration::try_from_secs_f64(seconds.min(3e9)).unwrap_or_default();
        Pace { progress: Prompt::new(steps, "steps"), end: Instant::now() + allowed }
    }

    pub(super) fn is_over(&self) -> bool {
        Instant::now() >= self.end
    }

    pub(super) fn finish(&self) {
        self.progress.finish();
    }

    /// Shows the points that follow so many steps of a transient; how many there are before the
    /// orbit ends, or the time.
    pub(super) fn follow(
        &self,
        map: &MapAt<f64>,
        start: &[f64],
        (transient, steps): (u64, u64),
        mut visit: impl FnMut(u64, &[f64]),
    ) -> u64 {
        let mut x = start.to_vec();
        let watch = |steps| {
            self.progress.advance(steps);
            if self.is_over() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let is_through = map.follow(&mut x, transient, watch).map(|followed| followed.ended);
        if is_through != Ok(Ended::Complete) || !x.iter().all(|x| x.is_finite()) {
            return 0;
        }
        let visit = Visit::by(|step, x: &[f64]| visit(transient + step, x));
        let shown = map.observe(&mut x, steps, visit, watch);
        shown.map_or(0, |shown| shown.steps + 1)
    }
}

impl Subject<'_> {
    /// The map at values of the parameters and ε; `None` where the field divides by zero, or a
    /// number is beyond doubles.
    pub(super) fn map(&self, field: &Field, parameters: &[Rational], eps: &Rational) -> Option<MapAt<f64>> {
        let map = field.with(field.parameters().iter().zip(parameters)).ok()?;
        Some(map.at(eps.to_f64())).filter(|map| map.eps().is_finite())
    }

    /// The refusal where there is no such map.
    pub(super) fn no_map(&self) -> Refusal {
        Refusal::new(format!(
            "the field of {} divides by zero at these values, or one of them is beyond doubles; choose other values",
            self.name
        ))
    }
}

/// What to say of orbits that end early, or that there was no time for.
pub(super) fn notes(orbits: usize, ended: usize, is_cut: bool) -> Vec<String> {
    let mut notes = Vec::new();
    if is_cut {
        notes.push(
            "time ran out, and the picture shows what there was; a larger --seconds goes further".to_owned(),
        );
    } else if ended > 0 {
        notes.push(format!("{ended} of {orbits} orbits end early, at a pole or beyond the range of doubles"));
    }
    notes
}
