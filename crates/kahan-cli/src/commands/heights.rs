//! The command `kahan heights`, the Diophantine test along one exact orbit.

use std::iter;
use std::path::PathBuf;

use clap::Args;
use kahan_draw::document::Rows;
use kahan_runtime::heights::{DiophantineTest, Growth, Stop};
use kahan_study::{Heights as Question, HeightsFound, NoStep, Study, fifteen_digits};

use super::command_line::QuestionCommand;
use super::eval::unreduced_note;
use crate::printing::layout::{paragraphs, table, with_headings};
use crate::printing::{Answer, OutputStream, ProgressDisplay, UsageError, csv};
use crate::reading::{Start, seconds, whole};

/// Follows an exact orbit and measures how its heights grow.
///
/// Heights grow slowly if the map is integrable, exponentially if it is not.
///
/// The logarithmic height of p/q in lowest terms is the natural logarithm log max(|p|, |q|). It is
/// printed for every variable at every step. The finite differences of the heights determine the
/// growth: bounded, logarithmic, linear, quadratic, exponential or undecided. The entropy is
/// log(h_n/h_{n-1}) at the last step for the largest variable, and 0 unless the growth is
/// exponential. Parameters are inserted after the map is reduced to lowest terms.
///
/// The fractions of an exact orbit become long, so --digits and --seconds limit them. If a limit
/// ends the orbit, the results so far are printed with a note, and the exit status is 0. At a pole
/// of the map (det A = 0) the results so far are printed, the pole is reported, and the exit status
/// is 1.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan heights lv --eps 9/14 --at 1/2,5/3 --steps 17
  kahan heights e4 --eps 1/2 --at 7/3,11/13,23/47 --steps 60 --out e4.csv
  kahan heights e7 --param xi=19/17 --eps 1/2 --at 3/7,11/13,23/47 --steps 400 --json
  kahan heights --field 'xdot = y; ydot = 6*x^2 - a;' --param a=0.5 --eps 1/3 --at 0,1 --steps 30")]
pub(crate) struct Heights {
    #[command(flatten)]
    start: Start,

    /// The number of steps.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(0, u64::MAX))]
    steps: u64,

    /// The largest number of decimal digits of a numerator or denominator.
    #[arg(long, value_name = "D", default_value = "1000000", allow_hyphen_values = true, value_parser = whole(1, u64::MAX))]
    digits: u64,

    /// The time limit, in seconds. A step that would probably exceed it is not begun.
    #[arg(long, value_name = "S", default_value = "60", allow_hyphen_values = true, value_parser = seconds)]
    seconds: f64,

    /// Print one JSON object: steps, log_heights, growth, entropy, seconds, stopped (null, digits,
    /// seconds or pole).
    #[arg(long)]
    json: bool,

    /// Also write all heights to this file, a row per step; it appears when complete.
    #[arg(long, value_name = "F.csv")]
    out: Option<PathBuf>,
}

impl QuestionCommand for Heights {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let (study, at, eps) = self.start.study()?;
        let Heights { steps, digits, seconds, .. } = *self;
        Ok((study, Question { eps, at, steps, digits, seconds }))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let (study, asked) = self.read_question()?;
        let sink = self.out.as_deref().map(OutputStream::table).transpose()?;
        let found = asked.ask(&study, &ProgressDisplay::of("steps"))?;
        if let Some(sink) = sink {
            let all = (0..found.survey.heights.len()).collect();
            sink.put(csv(&rows(&found, all, |name| format!("h_{name}"))))?;
        }
        Ok(Answer::of(&found, self.json, |found| text(found, &asked)).with_complaint(complaint(&found)))
    }
}

/// Returns rows with the step, the heights, and the number of digits of the longest fraction.
fn rows(found: &HeightsFound, steps: Vec<usize>, name: fn(&String) -> String) -> Rows {
    let row = |step: usize| {
        let heights = &found.survey.heights[step];
        let logarithms = heights.logarithms.iter().map(|h| fifteen_digits(*h).to_string());
        [vec![heights.step.to_string()], logarithms.collect(), vec![heights.longest().to_string()]].concat()
    };
    let names = found.variables.iter().map(name);
    let headings = [vec!["n".to_owned()], names.collect(), vec!["digits".to_owned()]].concat();
    with_headings(headings, steps.into_iter().map(row))
}

fn text(found: &HeightsFound, asked: &Question) -> String {
    let all = found.survey.heights.len();
    let shown = shown_rows(all);
    let is_cut = shown.len() < all;
    let mut steps = table(&rows(found, shown, |name| format!("h({name})")), 1);
    steps.extend(is_cut.then(|| "(--json and --out have every step)".to_owned()));
    let DiophantineTest { growth, entropy, .. } = &found.survey;
    let entropy = match growth {
        Growth::Exponential => format!("entropy   {entropy:.6} = log {:.4}", libm::exp(*entropy)),
        _ => "entropy   0".to_owned(),
    };
    let seconds = format!("seconds   {:.3}", found.seconds.unwrap_or_default());
    let mut measured = vec![format!("growth    {growth}"), entropy, seconds];
    measured.extend(note(found, asked));
    paragraphs([steps, measured])
}

fn note(found: &HeightsFound, asked: &Question) -> Option<String> {
    let (bound, option) = match found.survey.stopped? {
        Stop::Pole => return None,
        Stop::Digits => {
            let digits = asked.digits;
            (format!("the next point would have more than --digits {digits} decimal digits"), "--digits")
        }
        Stop::Seconds => {
            (format!("the next step would end later than --seconds {}", asked.seconds), "--seconds")
        }
    };
    let (done, wanted) = (found.steps(), asked.steps);
    Some(format!("note      stopped after {done} of {wanted} steps: {bound}; increase {option} to continue"))
}

fn complaint(found: &HeightsFound) -> Option<String> {
    let (pole, step, name) = (found.pole?, found.steps(), &found.system);
    Some(match pole {
        NoStep::Unreduced => unreduced_note(name, &format!("step {step} of the orbit")),
        _ => format!(
            "the orbit ends at step {step} in a pole of the map of {name}: det A = 0 there, and the next point has no value"
        ),
    })
}

/// Chooses the rows to print. In a long table, the gaps between them grow.
fn shown_rows(count: usize) -> Vec<usize> {
    const ALL: usize = 26;
    if count <= ALL {
        return (0..count).collect();
    }
    let decades = iter::successors(Some(10), |row: &usize| Some(row + 10_usize.pow(row.ilog10())));
    (0..10).chain(decades.take_while(|row| *row < count - 1)).chain([count - 1]).collect()
}
