//! The command `kahan dynamics`, which computes observables of an orbit while the orbit runs.

use clap::Args;
use kahan_algebra::render::lines;
use kahan_draw::answer::{self, convergence, out_of_range};
use kahan_study::{Observable, Observe, Observed, ObservedValue, Study};

use super::command_line::QuestionCommand;
use crate::printing::layout::{paragraphs, screen_width, table};
use crate::printing::{Answer, ProgressDisplay, UsageError};
use crate::reading::{MOST_OBSERVED, Rounding, Start, Stepping, Transient, observable, order, whole};

/// Measures exponents, chaos indicators and drift along an orbit: also rotation, range and escape.
///
/// Tangent vectors are propagated by the exact Jacobian of the map, and the orbit is not stored.
/// Lyapunov exponents are per unit of time; a step takes the time 2 eps. The error of an exponent
/// is its distance from the estimates after the first eighth to the first quarter of the steps. The
/// text shows the digits that are certain by this error, JSON shows all. If 0 lies within the error
/// of the largest exponent, no chaos has been detected so far. The largest exponent has a tangent
/// vector of its own; it agrees with the first entry of the spectrum once both have converged. The
/// sum of all exponents is the mean of log |det J|. A lifted field has the exponents and indicators
/// of its original variables.
///
/// Three indicators distinguish regular orbits from chaotic ones sooner than exponents do. FLI, the
/// fast Lyapunov indicator, is the logarithm of the largest growth of a tangent vector: it grows
/// like log n on regular orbits and like n on chaotic ones. MEGNO, the mean exponential growth
/// factor of nearby orbits, tends to 2 on quasi-periodic orbits and grows on chaotic ones. SALI,
/// the smaller alignment index, is near 0 if two tangent vectors are nearly parallel: it falls to 0
/// exponentially on chaotic orbits; in two variables it falls like a power of time on regular ones.
///
/// The rotation number of a variable is the number of turns per step, modulo 1, in the plane of the
/// variable and its rate, around the midpoint of its range. It has an error estimate. The drift of
/// an integral is relative to its initial value.
///
/// Passed poles are counted only if --observe names them. They are the steps over a pole of the
/// map: the denominator of the reduced map, at the point where the step begins, has a root between
/// 0 and eps, eps included. For a composition, this must hold at one of its stages. If the map has
/// too many terms to be written out, steps with negative det A are counted, and the count is a
/// lower bound.
///
/// Steps are those of `kahan orbit` in f64. If numbers overflow f64, or the orbit escapes, the
/// results cover the steps before, and the exit status is 1.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan dynamics lorenz --param s=10 --param r=28 --param b=8/3 --eps 1e-3 --at 1,1,1 --steps 1e4
  kahan dynamics e3 --eps 0.05 --at 1,2,3 --steps 1e4 --json
  kahan dynamics e6 --eps 0.05 --at 1,2,3 --steps 1e4 --order 4
  kahan dynamics --field 'xdot = y; ydot = 6*x^2 - 2;' --eps 0.01 --at 0,0.1 --steps 9999")]
pub(crate) struct Dynamics {
    #[command(flatten)]
    start: Start,

    /// The number of steps; rotation numbers need about a hundred turns.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1, MOST_OBSERVED))]
    steps: u64,

    #[command(flatten)]
    before: Transient,

    /// The order of the method: 2 is Kahan's map, the others are compositions of it.
    #[arg(long, value_name = "P", default_value = "2", value_parser = order())]
    order: u32,

    /// Make the tangent vectors orthogonal again every M steps.
    #[arg(long, value_name = "M", default_value = "10", allow_hyphen_values = true, value_parser = whole(1, u64::MAX))]
    renormalize: u64,

    /// Compute only the K largest exponents, not all of them.
    #[arg(long, value_name = "K", allow_hyphen_values = true, value_parser = whole(1, usize::MAX))]
    spectrum: Option<usize>,

    /// End the orbit, as escaped, once a variable exceeds R in absolute value.
    ///
    /// Without this option the orbit continues, and `escaped` reports the first step at which a
    /// variable exceeds 1e6.
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = radius)]
    escape: Option<f64>,

    #[command(flatten)]
    stepping: Stepping,

    #[command(flatten)]
    rounding: Rounding,

    /// The observables to compute, in this order, separated by commas.
    ///
    /// The default is all of them except final and passed_poles.
    #[arg(long, value_name = "NAMES", value_delimiter = ',', hide_default_value = true, default_values = Observable::usual().iter().map(|of| of.name()), value_parser = observable(Observable::ALL))]
    observe: Vec<Observable>,

    /// Print one JSON object; missing values are null.
    #[arg(long)]
    json: bool,
}

pub(super) fn radius(text: &str) -> Result<f64, String> {
    let radius = crate::reading::number(text, "--escape").map_err(|_| "not a number".to_owned())?.to_f64();
    if radius > 0.0 { Ok(radius) } else { Err("it is a size, as in 1e6".to_owned()) }
}

impl QuestionCommand for Dynamics {
    type Question = Observe;

    fn read_question(&self) -> Result<(Study, Observe), UsageError> {
        let (study, at, eps) = self.start.study()?;
        let study = study.fusing(self.rounding.fused)?;
        let Dynamics { before, steps, order, renormalize, spectrum, escape, stepping, ref observe, .. } =
            *self;
        let (transient, reembed, observe) = (before.transient, stepping.reembed, observe.clone());
        Ok((
            study,
            Observe { eps, at, transient, steps, order, renormalize, spectrum, escape, reembed, observe },
        ))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let (study, asked) = self.read_question()?;
        let observed = asked.ask(&study, &ProgressDisplay::of("steps"))?;
        Ok(Answer::of(&observed, self.json, text).with_complaint(out_of_range(&observed)))
    }
}

fn text(observed: &Observed) -> String {
    let ended = format!("{}, {}", observed.steps, observed.end.name());
    let mut last = vec![vec!["steps".to_owned(), ended]];
    if let Some(ObservedValue::Step(escaped)) = observed.of(Observable::Escape) {
        let escaped = escaped.map_or("no".to_owned(), |step| format!("at step {step}"));
        last.push(vec!["escaped".to_owned(), escaped]);
    }
    if let Some(ObservedValue::Passed(passed)) = observed.of(Observable::PassedPoles) {
        let at_least = if passed.is_lower_bound { "at least " } else { "" };
        last.push(vec!["passed poles".to_owned(), format!("{at_least}{}", passed.steps)]);
    }
    let tables = answer::observed(observed).into_iter().map(|table| table.rows).chain([last]);
    let tables = tables.map(|rows| table(&rows, 1));
    let words = convergence(observed).map(|words| lines(&words, screen_width()));
    paragraphs(tables.chain(words))
}
