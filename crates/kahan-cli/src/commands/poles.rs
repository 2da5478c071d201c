//! The command `kahan poles`, which follows the curves or surfaces that a map contracts or sends to
//! infinity.

use clap::Args;
use kahan_draw::answer::poles;
use kahan_study::{Poles as Question, PolesFound, Study};

use super::command_line::QuestionCommand;
use crate::printing::layout::{paragraphs, table};
use crate::printing::{Answer, ProgressDisplay, UsageError, joined};
use crate::reading::{Source, StepLength, seconds, whole};

/// Tests whether the singularities of a map are confined: follows them, step by step.
///
/// The curves (surfaces in three variables) to follow are the factors of the map's common
/// denominator and of its Jacobian determinant, and the line (plane) at infinity if the map blows
/// it down. A curve is blown down if its image has a lower dimension, so that its points can no
/// longer be told apart. The singularity is confined after k steps if the image after k steps is a
/// curve (surface) again; if k is 1, nothing is lost. Each curve is moved by delta and followed
/// modulo two primes. Parameters and eps are generic unless --param and --eps give them. A
/// polynomial that would fill a page is given by its number of terms; JSON has it in full.
///
/// Confinement alone proves nothing: the map of Henon and Heiles has confined singularities, and
/// its degrees grow exponentially. The degrees of the iterates are therefore printed below, as
/// measured and as the patterns imply them. A lack of confinement proves nothing either: maps that
/// can be made linear need not be confined.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan poles weierstrass
  kahan poles lv --eps 1
  kahan poles e9 --param xi=-1 --steps 6 --json
  kahan poles --field 'xdot = y; ydot = 6*x^2 - a;'")]
#[command(mut_arg("eps", |eps| eps.help("Half the time step (dt = 2 eps); a symbol if not given")))]
pub(crate) struct Poles {
    #[command(flatten)]
    source: Source,

    #[command(flatten)]
    step: StepLength,

    /// The number of steps for which each curve is followed.
    #[arg(long, value_name = "K", default_value = "12", allow_hyphen_values = true, value_parser = whole(1, LONGEST))]
    steps: usize,

    /// The time limit, in seconds; curves not finished by then are undecided.
    #[arg(long, value_name = "S", default_value = "60", allow_hyphen_values = true, value_parser = seconds)]
    seconds: f64,

    /// Print one JSON object: system, patterns, bound, complete, degrees, growth, entropy and more.
    #[arg(long)]
    json: bool,
}

const LONGEST: usize = 100;

impl QuestionCommand for Poles {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let eps = self.step.half()?;
        Ok((self.source.study()?, Question { eps, steps: self.steps, seconds: self.seconds }))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let (study, asked) = self.read_question()?;
        let found = asked.ask(&study, &ProgressDisplay::stages())?;
        Ok(Answer::of(&found, self.json, text))
    }
}

fn text(answer: &PolesFound) -> String {
    let PolesFound { system: name, found, growth: verdict, seconds } = answer;
    let is_undecided = found.patterns.iter().any(|pattern| pattern.confined.is_none());
    let notes = [
        (!found.is_complete, "the Jacobian determinant is too long to factor, so curves may be missing"),
        (is_undecided, "more --seconds or fewer --steps may decide the undecided ones"),
    ];
    let mut degrees = vec![
        format!("degrees of the iterates of {name}"),
        format!("growth    {}: {}", verdict.growth, verdict.evidence),
        format!("measured  {}", joined(&found.degrees, " ")),
    ];
    degrees.extend(found.implied_degrees.iter().map(|implied| format!("implied   {}", joined(implied, " "))));
    degrees.extend(notes.iter().filter(|(holds, _)| *holds).map(|(_, note)| format!("note: {note}")));
    degrees.push(format!("seconds   {:.2}", seconds.unwrap_or_default()));
    let dimensions = vec!["dimensions of the images, step by step; ' is at infinity".to_owned()];
    paragraphs([table(&poles(answer).rows, 1), dimensions, degrees])
}
