//! The command `kahan extremes`, which compares steps in floats with exact steps.

use clap::Args;
use kahan_judge::{BrokenPromises, Cell, CellKey, Extremes as Question, Judged, usual_subjects};
use kahan_study::{Study, Systems};

use crate::printing::layout::{labelled, paragraphs, table, with_headings};
use crate::printing::{Answer, ProgressDisplay, UsageError, joined};
use crate::reading::{Source, whole};

/// Tests steps with extreme inputs against exact arithmetic.
///
/// The exact step starts from the same floats as the tested step. It evaluates the reduced map, or
/// solves A x' = b in ball arithmetic of growing precision if the map has too many terms. Every
/// field runs in its own number of variables, up to eight, like its compiled code.
///
/// The points are random, drawn by --seed in four equal groups: near poles, near removable poles,
/// of mixed magnitudes, and ordinary. A few further points have subnormal, infinite or NaN inputs,
/// and a few have large steps, with |eps f'| from 1 to 1000; for these, elimination with partial
/// pivoting (lu) is tested as well. In f64, eps ranges over 1e-300 to 1e300 and x over 1e-150 to
/// 1e150, in f32 over the corresponding part of its range. Poles are located by bisection in exact
/// arithmetic; the points have relative distances 2^-k from them, down to the nearest float.
/// Parameters without a value are drawn for each trial: most are of ordinary size, some of mixed
/// magnitudes, and some below the normal range.
///
/// `step` is the fast tier, in dd the accurate one. Its result is silently wrong if it is finite
/// and off by more than 1e-3 of the exact result's largest component. `try_step` is the stable
/// tier. It is silently wrong if it returns Ok with a result that is off by more than 64 u of that
/// component (u = 2^-24 for f32, 2^-53 for f64, 2^-102 for dd), is not finite, or is at a pole. A
/// trial is flagged if `try_step` returns an error. In f64 and f32 this is unjustified if the
/// condition number of the step in (x, eps) is below 1e12 (f32: 1e4) and every component of the
/// exact result is a normal float; in dd every flag is justified.
///
/// A trial is a single step, for which the number of bits of eps is of no importance. It is
/// important in long runs: see `kahan help trade`.
///
/// The exit status is 1 if the stable tier is silently wrong or flagged without justification.
#[derive(Args, Debug)]
#[command(after_help = "\
Without a SYSTEM, it tests the systems of the paper and the Volterra lattice with three sites
(volterra). All run in an interpreter, whose results agree bit for bit with compiled code.

Examples:
  kahan extremes
  kahan extremes volterra --seed 7 --json
  kahan extremes --field 'xdot = x*y; ydot = mu - x^2;'
  kahan extremes --trials 10000000 --random-fields 50")]
pub(crate) struct Extremes {
    #[command(flatten)]
    source: Source,

    /// The number of trials per number type; special inputs add 3/32 of it.
    #[arg(long, value_name = "N", default_value = "40000", allow_hyphen_values = true, value_parser = whole(1, u64::MAX))]
    trials: u64,

    /// Also test N random fields of two to six variables, drawn by --seed.
    ///
    /// Some are sparse, with constant and linear terms, parameters, and divisors that contain
    /// parameters; some are dense. They are interpreted, and listed below the table. They share the
    /// trials with the systems.
    #[arg(long, value_name = "N", default_value = "0", allow_hyphen_values = true, value_parser = whole(0, usize::MAX))]
    random_fields: usize,

    /// Also test N random fields with extreme coefficients, of one to eight variables.
    ///
    /// Their numbers lie anywhere from 2^-1070 to 2^1020, coefficients nearly cancel, and
    /// parameters and their differences are divisors. Parameters are drawn from the whole range of
    /// the number type. Each field has trials of its own.
    #[arg(long, value_name = "N", default_value = "0", allow_hyphen_values = true, value_parser = whole(0, usize::MAX))]
    odd_fields: usize,

    /// The number of trials per number type of each of the --odd-fields; every twentieth field has
    /// ten times as many.
    #[arg(long, value_name = "N", default_value = "300", allow_hyphen_values = true, value_parser = whole(1, u64::MAX))]
    odd_trials: u64,

    /// The seed of the random points; equal seeds draw equal points, on any number of threads.
    #[arg(long, value_name = "S", default_value = "1", allow_hyphen_values = true, value_parser = whole(0, u64::MAX))]
    seed: u64,

    /// Print one JSON object.
    ///
    /// The keys: system, systems, trials, seed, seconds, random_fields (name, text), odd_fields
    /// (their number), cells (regime, tier, scalar, trials, max_error_u, flagged,
    /// unjustified_flags, silently_wrong), broken (name, text, silently_wrong, unjustified_flags,
    /// first; only systems with such results), failures.
    #[arg(long)]
    json: bool,
}

impl Extremes {
    pub(crate) fn run(&self) -> Result<Answer, UsageError> {
        let Extremes { trials, random_fields, odd_fields, odd_trials, seed, .. } = *self;
        let asked = Question { trials, random_fields, odd_fields, odd_trials, seed };
        let judged = asked.of(&self.studies()?, &ProgressDisplay::of("trials"));
        let judged = judged.map_err(|why| UsageError::new(why.to_string()))?;
        Ok(Answer::of(&judged, self.json, text).with_complaint(complaint(&judged)))
    }

    fn studies(&self) -> Result<Vec<Study>, UsageError> {
        match (self.source.is_named(), self.source.has_parameters()) {
            (true, _) => Ok(vec![self.source.study()?]),
            (false, true) => Err(UsageError::new(
                "--param: of which system? name one before its parameters, as in e9 --param xi=1/2",
            )),
            (false, false) => usual_subjects().map(|subject| Ok(subject.study(&Systems)?)).collect(),
        }
    }
}

const LABEL_WIDTH: usize = 15;

fn text(judged: &Judged) -> String {
    let headings =
        ["regime", "tier", "scalar", "trials", "largest error", "flagged", "unjustified", "silently wrong"];
    let cells = table(&with_headings(headings, judged.tally.cells.iter().map(row)), 3);
    let mut lines = labelled("systems", &judged.systems.join(", "), LABEL_WIDTH);
    let removable = match judged.removable.as_slice() {
        [] => "none; their trials went to the poles".to_owned(),
        systems => systems.join(", "),
    };
    lines.extend(labelled("removable poles", &removable, LABEL_WIDTH));
    lines.extend(judged.random_fields.iter().map(|(name, equations)| format!("{name}: {equations}")));
    if judged.odd_fields > 0 {
        lines.push(format!(
            "{} random fields with extreme coefficients were tested as well",
            judged.odd_fields
        ));
    }
    for (name, BrokenPromises { text, silently_wrong, unjustified, first }) in &judged.tally.broken {
        lines.push(format!(
            "{name}, {silently_wrong} silently wrong, {unjustified} unjustified flags: {text}"
        ));
        lines.push(format!("  {}", first.text));
    }
    lines.push(format!("seed {}, {:.1} seconds", judged.seed, judged.seconds.unwrap_or_default()));
    paragraphs([cells, lines])
}

fn complaint(judged: &Judged) -> Option<String> {
    let [wrong, flags] = judged.against_the_promise();
    let examples = joined(judged.tally.failures.iter().map(|failure| &failure.text), "; ");
    (wrong + flags > 0).then(|| {
        format!(
            "the stable tier breaks its promise: {wrong} silently wrong, {flags} unjustified flags. The first of each: {examples}"
        )
    })
}

fn row((place, cell): (&CellKey, &Cell)) -> Vec<String> {
    let (regime, tier, scalar) = place;
    let error = match cell.max_error_u {
        None => "-".to_owned(),
        Some(error) if error < 1000.0 => format!("{error:.2} u"),
        Some(error) => format!("{error:.1e} u"),
    };
    let rate = 100.0 * cell.flagged as f64 / cell.trials as f64;
    let without_right = if *tier == "stable" { cell.unjustified.to_string() } else { "-".to_owned() };
    vec![
        regime.name().to_owned(),
        (*tier).to_owned(),
        (*scalar).to_owned(),
        cell.trials.to_string(),
        error,
        format!("{rate:.2} %"),
        without_right,
        silently_wrong(cell),
    ]
}

/// Formats a number of failures. Without failures in n trials, shows the bound 3/n of the failure
/// rate at 95 % confidence.
fn silently_wrong(cell: &Cell) -> String {
    match cell.silently_wrong {
        0 => format!("0, < 3/{} at 95 %", cell.trials),
        wrong => format!("{wrong}, {:.2} %", 100.0 * wrong as f64 / cell.trials as f64),
    }
}
