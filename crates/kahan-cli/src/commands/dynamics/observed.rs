//! The orbit, twice: once for all that needs no extremes, once for the rotation about their middle.

use kahan_core::Composition;
use kahan_core::observe::{
    Drift, Drifted, Escape, Exponent, Extrema, Extremes, Fli, MeanLogDet, Megno, Observer, Rotation, Sali,
    Spectrum, Turns,
};
use kahan_runtime::MapAt;

use crate::printing::{Prompt, Refusal};
use crate::reading::Request;

/// What is asked.
pub(super) struct Asked {
    pub(super) steps: u64,
    /// Steps between two orthogonalisations.
    pub(super) every: u64,
    /// The size beyond which the orbit has escaped.
    pub(super) escape: f64,
}

/// What the observers report.
pub(super) struct Observed {
    /// The steps that were made: fewer than asked where numbers leave their range.
    pub(super) steps: u64,
    pub(super) lyapunov: Vec<Exponent>,
    pub(super) mean_log_det: f64,
    pub(super) fli: f64,
    pub(super) megno: f64,
    pub(super) sali: f64,
    /// One a variable.
    pub(super) rotation: Vec<Turns>,
    /// One an integral.
    pub(super) drift: Vec<Drifted>,
    /// One a variable.
    pub(super) extrema: Vec<Option<Extremes<f64>>>,
    pub(super) escaped: Option<u64>,
}

impl Asked {
    /// Follows the orbit that the request begins.
    pub(super) fn of(&self, request: &Request, composition: Composition) -> Result<Observed, Refusal> {
        let (at, start) = request.in_floats()?;
        let at = at.composed(composition);
        let (variables, integrals) = (start.len(), at.map().field().integrals().len());
        let progress = Prompt::new(2 * self.steps, "steps");
        let loops = Loop { at: &at, start: &start, progress: &progress };

        let tangents = (
            Spectrum::new(&at, variables, self.every),
            MeanLogDet::new(&at),
            Fli::new(&at),
            Megno::new(&at),
            Sali::new(&at),
        );
        let beyond = Escape::when(|x: &[f64]| !x.iter().all(|x| x.abs() <= self.escape));
        let extrema: Vec<_> = (0..2 * variables).map(|k| Extrema::of(move |both: &[f64]| both[k])).collect();
        let drift: Vec<_> = (0..integrals).map(|k| Drift::of(move |values: &[f64]| [values[k]])).collect();
        let mut observers = (tangents, beyond);
        let mut of_rates = extrema;
        let (mut of_integrals, mut values) = (drift, vec![0.0; integrals]);
        let steps = loops.run(self.steps, |step, x, both| {
            observers.observe(step, x);
            of_rates.observe(step, both);
            // The state is as long as the field has variables.
            let _ = at.integrals(x, &mut values);
            of_integrals.observe(step, &values);
        });
        let ((lyapunov, mean_log_det, fli, megno, sali), escaped) = observers.report();
        let extremes = of_rates.report();
        let drift = of_integrals.report().into_iter().map(|[drifted]| drifted).collect();

        let mut rotations: Vec<_> = (0..variables)
            .map(|k| {
                let extremes = [extremes[k], extremes[variables + k]];
                let [Some(x), Some(rate)] = extremes else { return None };
                let plane = move |both: &[f64]| [both[k], both[variables + k]];
                Some(Rotation::between(steps, plane, [x, rate]))
            })
            .collect();
        loops.run(steps, |step, _, both| {
            rotations.iter_mut().flatten().for_each(|rotation| rotation.observe(step, both));
        });
        progress.finish();
        let nothing = Turns { value: f64::NAN, error: f64::NAN };
        let rotation = rotations.into_iter().map(|rotation| rotation.map_or(nothing, Observer::report));
        Ok(Observed {
            steps,
            lyapunov,
            mean_log_det,
            fli,
            megno: megno.mean,
            sali,
            rotation: rotation.collect(),
            drift,
            extrema: extremes[..variables].to_vec(),
            escaped,
        })
    }
}

/// The orbit, to be run through.
struct Loop<'a> {
    at: &'a MapAt<f64>,
    start: &'a [f64],
    progress: &'a Prompt,
}

impl Loop<'_> {
    /// Shows the points with their steps, and each with its rate of change behind it, as long as
    /// they are numbers; the steps made.
    fn run(&self, steps: u64, mut show: impl FnMut(u64, &[f64], &[f64])) -> u64 {
        /// Steps between two looks at the bar.
        const AT_ONCE: u64 = 1 << 12;

        let mut x = self.start.to_vec();
        let mut both = [self.start, self.start].concat();
        for step in 0..=steps {
            if !x.iter().all(|x| x.is_finite()) {
                return step - 1;
            }
            let (place, rate) = both.split_at_mut(x.len());
            place.copy_from_slice(&x);
            // Both are as long as the field has variables.
            let _ = self.at.field(&x, rate);
            show(step, &x, &both);
            let _ = self.at.advance(&mut x, 1);
            if step % AT_ONCE == AT_ONCE - 1 {
                self.progress.advance(AT_ONCE);
            }
        }
        steps
    }
}
