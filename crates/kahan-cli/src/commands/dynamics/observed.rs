//! The orbit, twice: once for all that needs no extremes, once for the rotation about their middle.

use std::ops::ControlFlow;

use kahan_core::Composition;
use kahan_core::observe::{
    Drifted, Escape, Exponent, Extremes, Fli, MeanLogDet, Megno, Sali, Spectrum, Turns,
};
use kahan_runtime::{Follow, Followed, IntegralDrift};

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
        let progress = Prompt::new(2 * self.steps, "steps");
        let watch = |steps| {
            progress.advance(steps);
            ControlFlow::Continue(())
        };

        let tangents = (
            Spectrum::new(&at, start.len(), self.every),
            MeanLogDet::new(&at),
            Fli::new(&at),
            Megno::new(&at),
            Sali::new(&at),
        );
        let beyond = Escape::when(|x: &[f64]| !x.iter().all(|x| x.abs() <= self.escape));
        let observers = (tangents, beyond, at.extremes(), IntegralDrift::of(&at));
        let Followed { report, steps, .. } =
            at.observe(&mut start.clone(), self.steps, observers, watch).expect("the start is of the field");
        let ((lyapunov, mean_log_det, fli, megno, sali), escaped, extremes, drift) = report;
        let rotations = at.rotations(steps, &extremes);
        let again =
            at.observe(&mut start.clone(), steps, rotations, watch).expect("the start is of the field");
        progress.finish();
        let [extrema, _] = extremes;
        Ok(Observed {
            steps,
            lyapunov,
            mean_log_det,
            fli,
            megno: megno.mean,
            sali,
            rotation: again.report,
            drift,
            extrema,
            escaped,
        })
    }
}
