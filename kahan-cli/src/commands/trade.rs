//! `kahan trade`: speed against accuracy on one scene, and the cheapest setting that does.

mod paste;
mod picture;
mod table;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_measure::reference::Method;
use kahan_measure::trade::{Need, Scene, Setting, Trade as Measured};
use serde_json::{Value, json};

use crate::printing::{Answer, Broken, Progress, Refusal, Sink};
use crate::reading::{Block, Source, coordinates, number, seconds};
use paste::rust_of;
use picture::picture;

/// Measures what accuracy costs on one scene, on this machine, and names the cheapest setting that serves.
///
/// A setting is a scalar (f32; f32 with every step computed through f64; f64; dd, 32 digits), an order (2 is Kahan's map, 4, 6 and
/// 8 its compositions), whether the state carries its rounding error (compensated), and eps. Its price is nanoseconds per unit of
/// simulated time. Two needs:
///
/// trajectory: to follow the flow. The error is the largest distance from the flow's trajectory
/// over the whole horizon, at the times of the steps and with the last point standing for the
/// horizon, in the maximum norm, relative to the trajectory's largest coordinate. The trajectory is
/// a Taylor series in 32 digits that agrees with a second method (the closed solution, where the
/// catalog has one, else a composition of order 8) to a thousandth of the tolerance; where they do
/// not agree, or the solution escapes to infinity within the horizon, the command refuses.
///
/// integrals: to keep the claimed integrals (those without `when`). The error is the largest change over the horizon relative to the
/// value at the beginning, evaluated in 32 digits at the eps of the orbit: of the map's own integrals at order 2, of the
/// flow's (the claims at eps = 0) for compositions, which have none of their own. The trajectory may be far off then.
///
/// An orbit that follows a trajectory ends at the horizon, but for the rounding of its eps; one that keeps integrals at the step that
/// is nearest to it. In the table, `return` is how far from the first point an orbit comes home that goes all its steps forward
/// and back.
///
/// Settings are measured until the answer is clear: nothing finer than what does, nothing dearer.
/// The table shows the front, which no other setting beats in price and error together; --json has
/// all. To keep integrals every eps has few bits (17, and 8 in f32), so that its powers are exact:
/// keep it as it is printed. It matters in long runs at order 2, from some 1e5 steps on, where the
/// step multiplies eps with itself or with parameters (the Euler top's does): with an eps that
/// makes these products rounded, what the map conserves drifts linearly, compensated or not. At
/// higher orders the stages round theirs anyway. A system of the catalog is timed as compiled; a
/// field given as text is run by an interpreter, and its prices are those of the compiled E6 on
/// this machine, scaled by what the two steps are counted to cost; f32 is taken to be no cheaper
/// than f64 there, as how compilers pack its steps is not foreseen. Where no setting meets the
/// tolerance the exit status is 1.
#[derive(Args, Debug)]
#[command(after_long_help = EXAMPLES)]
pub(crate) struct Trade {
    #[command(flatten)]
    source: Source,

    /// The first point, its coordinates separated by commas: 1,-2/3,0.5.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    at: String,

    /// The time to be simulated: 100, 5/2.
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    horizon: String,

    /// What the orbit is for.
    #[arg(long, value_enum, default_value = "trajectory")]
    need: NeedName,

    /// The largest error that is accepted.
    #[arg(long, value_name = "TOL", default_value = "1e-8", allow_hyphen_values = true)]
    tolerance: String,

    /// The time that it may take, three quarters of it for the reference; what is likely to end later is not begun.
    #[arg(long, value_name = "S", default_value = "10", allow_hyphen_values = true, value_parser = seconds)]
    seconds: f64,

    /// Draw price against error as an SVG picture into this file.
    #[arg(long, value_name = "F.svg")]
    out: Option<PathBuf>,

    /// Print one JSON object: settings, choice, and what stands behind them.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan trade e6 --at 1,1/2,1/3 --horizon 100
  kahan trade lv --at 1/2,5/3 --horizon 50 --tolerance 1e-10 --out lv.svg
  kahan trade e6 --at 1,1/2,1/3 --horizon 1000 --need integrals --tolerance 1e-12
  kahan trade --field 'xdot = y; ydot = 6*x^2 - a;' --param a=2 --at -1/2,1/5 --horizon 20 --json";

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum NeedName {
    /// To follow the flow's trajectory.
    Trajectory,
    /// To keep the integrals.
    Integrals,
}

/// What was measured, and on what.
struct Finding<'a> {
    name: &'a str,
    block: &'a Block,
    system: &'a System,
    parameters: &'a [Rational],
    start: &'a [Rational],
    horizon: f64,
    need: Need,
    tolerance: f64,
    trade: Measured,
}

impl Trade {
    /// The front and the choice; a complaint where nothing meets the tolerance.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let block = self.source.required_block()?;
        let system = block.system()?;
        let name = block.name(&system);
        let start = coordinates(&self.at, &system.field.symbols.states)?;
        let parameters = self.source.parameter_values(&system, &name)?;
        let horizon = positive(&self.horizon, "--horizon")?;
        let tolerance = positive(&self.tolerance, "--tolerance")?;
        let sink = self.out.as_deref().map(|path| Sink::file(path, "--out")).transpose()?;
        let need = match self.need {
            NeedName::Trajectory => Need::Trajectory,
            NeedName::Integrals => Need::Integrals,
        };
        let scene = Scene {
            system: &system,
            command: block.entry.map_or("", |entry| entry.command),
            parameters: &parameters,
            start: &start,
            horizon,
            need,
            tolerance,
            seconds: self.seconds,
        };
        // How many there will be depends on what they show.
        let progress = Progress::new(60, "settings");
        let trade = Measured::of(&scene, &mut |_| progress.advance(1));
        progress.finish();
        let trade = trade.map_err(|why| Refusal::new(format!("{name}: {why}")))?;
        let finding = Finding {
            name: &name,
            block: &block,
            system: &system,
            parameters: &parameters,
            start: &start,
            horizon,
            need,
            tolerance,
            trade,
        };
        if let Some(mut sink) = sink {
            let picture = picture(&finding.trade, &finding.title(), need, tolerance);
            sink.write(&picture).and_then(|()| sink.finish()).map_err(|broken| match broken {
                Broken::Failed(reason) => Refusal::new(reason),
                Broken::ReaderGone => Refusal::new("--out: the file cannot be written"),
            })?;
        }
        let answer = if self.json { Answer::json(&finding.object()) } else { Answer::text(finding.text()) };
        Ok(Answer { complaint: finding.complaint(), ..answer })
    }
}

/// A number above 0, as a float.
fn positive(text: &str, what: &str) -> Result<f64, Refusal> {
    let value = number(text, what)?.to_f64();
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Refusal::new(format!(
            "{what}: `{}` is not a number above 0 within the range of f64",
            text.trim()
        )))
    }
}

impl Finding<'_> {
    fn need_name(&self) -> &'static str {
        match self.need {
            Need::Trajectory => "trajectory",
            Need::Integrals => "integrals",
        }
    }

    fn title(&self) -> String {
        let point: Vec<String> = self.start.iter().map(ToString::to_string).collect();
        format!("{} from ({}) over {} units of time", self.name, point.join(", "), self.horizon)
    }

    fn choice(&self) -> Option<&Setting> {
        self.trade.choice.map(|choice| &self.trade.settings[choice])
    }

    /// The setting that comes nearest to the tolerance.
    fn most_accurate(&self) -> Option<&Setting> {
        self.trade.settings.iter().min_by(|a, b| a.error(self.need).total_cmp(&b.error(self.need)))
    }

    fn complaint(&self) -> Option<String> {
        if self.choice().is_some() {
            return None;
        }
        if self.trade.settings.is_empty() {
            return Some(format!(
                "nothing was measured on {}, there was no time for it; try more --seconds, or a shorter --horizon",
                self.title()
            ));
        }
        let wanted = format!("no setting reaches the tolerance {:e} on {}", self.tolerance, self.title());
        let best = match self.most_accurate() {
            Some(best) if best.error(self.need).is_finite() => {
                format!("the best is {}, eps = {:?}, with {:.1e}", best.kind, best.eps, best.error(self.need))
            }
            _ => "none gives finite numbers".to_owned(),
        };
        let way_out = if self.trade.skipped.is_empty() {
            "a larger --tolerance or a shorter --horizon"
        } else {
            "more --seconds, a larger --tolerance or a shorter --horizon"
        };
        Some(format!("{wanted}: {best}; try {way_out}"))
    }

    fn object(&self) -> Value {
        let exact = |values: &[Rational]| values.iter().map(ToString::to_string).collect::<Vec<_>>();
        let names = self.system.field.symbols.parameters.iter().cloned();
        let parameters = names.zip(exact(self.parameters).into_iter().map(Value::from));
        let choice = self.choice().map(|choice| {
            let mut object = setting_object(choice);
            object["rust"] = json!(rust_of(self, choice));
            object
        });
        let skipped = self.trade.skipped.iter().map(|(kind, eps)| {
            json!({
                "scalar": kind.scalar.name(), "order": kind.order, "compensated": kind.compensated, "eps": eps,
            })
        });
        json!({
            "system": self.name,
            "parameters": parameters.collect::<serde_json::Map<_, _>>(),
            "x": exact(self.start),
            "horizon": self.horizon,
            "need": self.need_name(),
            "tolerance": self.tolerance,
            "scale": self.trade.scale,
            "reference": self.trade.certificate.map(|certificate| json!({
                "second_method": match certificate.method {
                    Method::ClosedSolution => "closed solution",
                    Method::Composition { .. } => "composition",
                },
                "difference": certificate.difference,
            })),
            "timing": if self.trade.is_compiled { "measured" } else { "predicted" },
            "settings": self.trade.settings.iter().map(setting_object).collect::<Vec<_>>(),
            "choice": choice,
            "skipped": skipped.collect::<Vec<_>>(),
        })
    }
}

/// What is not finite is `null`.
fn setting_object(setting: &Setting) -> Value {
    json!({
        "scalar": setting.kind.scalar.name(),
        "order": setting.kind.order,
        "compensated": setting.kind.compensated,
        "eps": setting.eps,
        "steps": setting.steps,
        "nanoseconds_per_unit_time": setting.nanoseconds_per_unit_time,
        "trajectory_error": setting.trajectory_error,
        "integral_drift": setting.integral_drift,
        "flow_integral_drift": setting.flow_integral_drift,
        "return_error": setting.return_error,
        "on_front": setting.on_front,
    })
}
