//! The command `kahan trade`, which finds the cheapest setting that meets a tolerance.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValue;
use kahan_core::Composition;
use kahan_draw::answer::{choice, front};
use kahan_draw::picture::{PictureOptions, trade, trade_canvas};
use kahan_dynamics::{Need, Precision};
use kahan_study::Study;
use kahan_study::numbers::ScalarKind;
use kahan_study::reference::Method;
use kahan_study::trade::{Measured, Trade as Question, Traded, need_name};

use super::command_line::{CommandLine, QuestionCommand};
use super::image_options::{ImageOptions, OutFile};
use crate::printing::layout::{paragraphs, table};
use crate::printing::{Answer, ProgressDisplay, UsageError};
use crate::reading::{Block, Source, number, one_of, point, seconds};

/// Measures what accuracy costs: finds the cheapest settings that meet a tolerance.
///
/// All times are measured on this machine. A setting consists of a scalar type (f32; f32 with every
/// step computed in f64; f64; dd with 32 digits), an order (2 is Kahan's map; 4, 6 and 8 are its
/// compositions), whether the state carries its rounding error (compensated), and eps. Its price is
/// in nanoseconds per unit of simulated time. There are two needs:
///
/// trajectory: to follow the flow. The error is the largest distance from the flow's trajectory
/// over the whole horizon, measured at the times of the steps, in the maximum norm, relative to the
/// trajectory's largest coordinate. The last point stands for the horizon. The reference trajectory
/// is a Taylor series with 32 digits. It must agree to a hundredth of the tolerance with a second
/// method: the closed solution, if the catalog has one, or else a composition of order 8. A setting
/// meets the tolerance if its error plus that difference does. The command refuses if the two
/// methods do not agree, or if the solution escapes to infinity within the horizon.
///
/// integrals: to keep the claimed integrals (those without `when`). The error is the largest change
/// over the horizon, relative to the initial value, evaluated with 32 digits at the eps of the
/// orbit. At order 2 these are the map's own integrals. Compositions have none of their own; for
/// them the integrals of the flow (the claims at eps = 0) are measured. The orbit may be far from
/// the trajectory.
///
/// With need trajectory, an orbit ends at the horizon, up to the rounding of eps; with need
/// integrals, at the step nearest to the horizon. In the table, `return` is the distance from the
/// initial point after all steps forward and back.
///
/// Settings are measured from coarse to fine until one meets the tolerance. Settings that are
/// certain to cost more than this one are skipped. The table shows the Pareto front, the settings
/// that no other setting beats in both price and error; --json has all. The exit status is 1 if no
/// setting meets the tolerance.
///
/// With need integrals, every eps has few bits (17, or 8 in f32), so that its powers are exact: use
/// it as printed. This matters at order 2 in runs of about 1e5 steps or more, if the step
/// multiplies eps by itself or by parameters, as that of the Euler top does. If these products are
/// rounded, the conserved quantities drift linearly, compensated or not. At higher orders the
/// stages round their eps in any case.
///
/// The timed code is machine code with the same operations, in the same order, as the code of the
/// macro. Compiled into your program, the macro's code takes 0.9 to 1.5 times as long, and up to
/// twice in f32; f32 is therefore taken to be no cheaper than f64. On processors without machine
/// code, E6 is timed, and its prices are scaled by the counted costs of the two steps.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan trade e6 --at 1,1/2,1/3 --horizon 100
  kahan trade lv --at 1/2,5/3 --horizon 50 --tolerance 1e-10 --out lv.svg
  kahan trade e6 --at 1,1/2,1/3 --horizon 1000 --need integrals --tolerance 1e-12
  kahan trade --field 'xdot = y; ydot = 6*x^2 - a;' --param a=2 --at -1/2,1/5 --horizon 20 --json")]
pub(crate) struct Trade {
    #[command(flatten)]
    source: Source,

    /// The initial point, coordinates separated by commas: 1,-2/3,0.5.
    ///
    /// The option may be left out if the equations give initial values.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    at: Option<String>,

    /// The time span to simulate, as in 100 or 5/2.
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    horizon: String,

    /// The purpose of the orbit.
    #[arg(long, value_parser = one_of(&[Need::Trajectory, Need::Integrals], need), default_value = "trajectory")]
    need: Need,

    /// The largest relative error that is accepted.
    #[arg(long, value_name = "TOL", default_value = "1e-8", allow_hyphen_values = true)]
    tolerance: String,

    /// The time limit, in seconds, with the reference; a setting that would probably exceed it is
    /// not begun.
    #[arg(long, value_name = "S", default_value = "10", allow_hyphen_values = true, value_parser = seconds)]
    seconds: f64,

    /// Draw price against error into this file: F.svg, F.png or F.pdf.
    #[arg(long, value_name = "F")]
    out: Option<PathBuf>,

    #[command(flatten)]
    look: ImageOptions,

    /// Print one JSON object: settings, choice, reference and more.
    #[arg(long)]
    json: bool,
}

fn need(need: Need) -> PossibleValue {
    PossibleValue::new(need_name(need)).help(match need {
        Need::Trajectory => "To follow the flow's trajectory",
        Need::Integrals => "To keep the integrals",
    })
}

impl QuestionCommand for Trade {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        self.question_of(&self.source.required_block()?)
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let out = self.out.as_deref().map(OutFile::picture).transpose()?;
        let block = self.source.required_block()?;
        let (study, asked) = self.question_of(&block)?;
        let traded = asked.ask(&study, &ProgressDisplay::stages())?;
        if let Some(out) = out {
            out.put(
                &trade(&traded, &PictureOptions::on(self.look.sheet(trade_canvas()))).drawing,
                String::new,
            )?;
        }
        let written =
            self.out.as_ref().map_or_else(String::new, |out| format!("{} written\n", out.display()));
        let call = self.orbit(&traded, &block);
        let shown = |traded: &Traded| text(traded, call.as_ref()) + &written;
        Ok(Answer::of(&traded, self.json, shown).with_complaint(complaint(&traded)))
    }
}

impl Trade {
    fn question_of(&self, block: &Block) -> Result<(Study, Question), UsageError> {
        let study = self.source.study_of_block(block, self.at.as_deref())?;
        // Claims are proved first, so a false claim is reported before a missing parameter value.
        study.proved()?;
        let asked = Question {
            at: point(self.at.as_deref(), &study)?,
            horizon: number(&self.horizon, "--horizon")?,
            need: self.need,
            tolerance: number(&self.tolerance, "--tolerance")?,
            seconds: self.seconds,
        };
        Ok((study, asked))
    }

    /// Returns the command that makes the chosen orbit; `None` if `kahan orbit` cannot make it.
    fn orbit(&self, traded: &Traded, block: &Block) -> Option<CommandLine> {
        let setting = &traded.choice()?.setting;
        let scheme = setting.scheme();
        let scalar = match scheme.precision {
            Precision::Single => ScalarKind::F32,
            Precision::Double => ScalarKind::F64,
            Precision::DoubleDouble => ScalarKind::Dd,
            Precision::SingleThroughDouble => return None,
        };
        let line = CommandLine::new("orbit", &self.source.arguments(block))
            .with("--eps", format!("{:?}", setting.eps()));
        let line = line.with_some("--at", self.at.as_ref()).with("--steps", setting.steps());
        let line = line.with_some("--scalar", (scalar != ScalarKind::F64).then(|| scalar.name()));
        let order = Some(scheme.order()).filter(|order| *order != 2);
        (!scheme.compensated).then(|| line.with_some("--order", order))
    }
}

/// From this number of steps on, a rounded ε causes a visible linear drift.
const LONG_RUN: u64 = 100_000;

fn size(value: f64) -> String {
    if (1e-2..1e6).contains(&value) { format!("{value:.4}") } else { format!("{value:.3e}") }
}

fn text(traded: &Traded, call: Option<&CommandLine>) -> String {
    let scene = &traded.scene;
    let title =
        format!("{}: need {}, tolerance {:e}", traded.title(), need_name(scene.need()), scene.tolerance());
    let mut lines = Vec::new();
    if let Some([chosen, rust]) = choice(traded) {
        lines.push(format!("choice     {chosen}"));
        let call = call.map(|call| format!("           {call}"));
        lines.extend(call.into_iter().chain(rust.lines().map(|line| format!("           {line}"))));
    }
    lines.extend(out_of_reach(traded));
    lines.extend(notes(traded));
    paragraphs([vec![title], table(&front(traded).rows, 4), lines])
}

/// Lists the schemes (scalar type, order, compensated or not) that cannot reach the tolerance, each
/// with its smallest error.
fn out_of_reach(traded: &Traded) -> Vec<String> {
    let mut lines = Vec::new();
    for &scheme in &traded.stalled {
        let best = best(traded, |measured| measured.setting.scheme() == scheme);
        let Some(best) = best.filter(|best| best.error() > traded.scene.tolerance()) else { continue };
        let reached = match best.error() {
            error if error.is_finite() => format!("{error:.1e} at eps = {:?}", best.setting.eps()),
            _ => "no finite numbers".to_owned(),
        };
        let heading = if lines.is_empty() { "too coarse" } else { "" };
        lines.push(format!("{heading:<10} {scheme}: at best {reached}"));
    }
    lines
}

/// Returns the most accurate of the settings for which `is_among` holds.
fn best(traded: &Traded, is_among: impl Fn(&Measured) -> bool) -> Option<&Measured> {
    let among = traded.settings.iter().filter(|measured| is_among(measured));
    among.min_by(|a, b| a.error().total_cmp(&b.error()))
}

fn notes(traded: &Traded) -> Vec<String> {
    let mut lines = Vec::new();
    let mut note = |text: String| lines.push(format!("note       {text}"));
    if let Some(certificate) = traded.certificate {
        let second = match certificate.method {
            Method::ClosedSolution => "the closed solution".to_owned(),
            Method::Composition { steps } => format!("{steps} steps of order 8 in dd"),
        };
        let scale = size(traded.scale.expect("a reference has a scale"));
        let difference = certificate.difference;
        note(format!(
            "errors are against a Taylor series that differs from {second} by {difference:.1e}; relative to {scale}"
        ));
    }
    if !traded.is_code {
        note("prices are predicted: the field has no machine code here; E6 was timed, and scaled by the plans' costs".into());
    }
    if let Some(choice) = traded.choice() {
        let (scheme, eps, steps) = (choice.setting.scheme(), choice.setting.eps(), choice.setting.steps());
        let keeps = traded.scene.need() == Need::Integrals && scheme.composition == Composition::KAHAN;
        if keeps {
            let flow = choice.flow_integral_drift.expect("the need is to keep integrals");
            note(format!(
                "the map's own integrals are kept at any eps; at this one the flow's vary by {flow:.1e}, and the orbit need not \
                 follow the flow"
            ));
        }
        if keeps && steps >= LONG_RUN && scheme.precision != Precision::DoubleDouble {
            note(format!(
                "keep eps = {eps:?} to the last digit: where the step has powers of eps, one with more bits would have them rounded, and \
                 over {steps} steps what the map conserves would drift linearly, compensated or not"
            ));
        }
    }
    for (scheme, eps) in &traded.skipped {
        note(format!("no time for {scheme} from eps = {eps:?} on; --seconds gives more"));
    }
    lines
}

fn complaint(traded: &Traded) -> Option<String> {
    if traded.choice().is_some() {
        return None;
    }
    let (title, tolerance) = (traded.title(), traded.scene.tolerance());
    if traded.settings.is_empty() {
        return Some(format!(
            "nothing was measured on {title}, there was no time for it; try more --seconds, or a shorter --horizon"
        ));
    }
    let wanted = format!("no setting reaches the tolerance {tolerance:e} on {title}");
    let best = match best(traded, |_| true).filter(|best| best.error().is_finite()) {
        Some(best) => {
            let (setting, error) = (&best.setting, best.error());
            format!("the best is {}, eps = {:?}, with {error:.1e}", setting.scheme(), setting.eps())
        }
        None => "none gives finite numbers".to_owned(),
    };
    let way_out = if traded.skipped.is_empty() {
        "a larger --tolerance or a shorter --horizon"
    } else {
        "more --seconds, a larger --tolerance or a shorter --horizon"
    };
    Some(format!("{wanted}: {best}; try {way_out}"))
}
