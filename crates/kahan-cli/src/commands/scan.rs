//! The command `kahan scan`, which searches for special values of parameters and of ε.

use clap::Args;
use kahan_discover::scan::{DegreesAndRanks, Proposal};
use kahan_study::{Axis, Scan as Question, ScanFound, Study};

use super::command_line::{CommandLine, QuestionCommand};
use super::discover::Search;
use crate::printing::layout::{paragraphs, table};
use crate::printing::{Answer, ProgressDisplay, UsageError, joined};
use crate::reading::axis;

/// Searches a grid for special values of parameters and of eps.
///
/// At every point of the grid, it computes the degrees of some iterates and the Hilbert function of
/// an orbit, and from it the number of algebraic integrals. Points whose results differ from those
/// of generic values are special, and are printed. A range is FROM:TO:COUNT, COUNT values with both
/// ends; FROM:TO:+STEP, steps from FROM up to TO at most; or FROM:TO:/CELLS, the midpoints of CELLS
/// equal cells. A parameter with a single value is fixed, and one without a value is generic.
///
/// With two ranges or more, it also searches for relations such as c = -a - b or a1*a2 = a5*a6 on
/// which all points of the grid are special. In the remaining time it searches for formulas there.
/// Each is proved, and printed as a claim `when` the relation holds. A relation without such a
/// formula is observed only, not proved.
#[derive(Args, Debug)]
#[command(after_help = "\
The JSON object holds every point: system, names, generic, points, special, relations, out_of_time, seconds.

Examples:
  kahan scan e9 --param xi=-2:2:+1/12
  kahan scan lv --eps -2:2:+1/4
  kahan scan e7 --param xi=-2:2:+1/4 --eps 1/4:2:+1/4 --json
  kahan scan --field 'xdot = y; ydot = c*y + 6*x^2 - a;' --param c=-1:1:+1/5 --param a=1")]
pub(crate) struct Scan {
    #[command(flatten)]
    search: Search,
}

impl QuestionCommand for Scan {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let (source, ranges) = self.search.source.without_ranges();
        let study = source.study()?;
        let of_parameter =
            |&(name, range): &(&str, &str)| axis(name.trim(), range, &format!("--param {}", name.trim()));
        let mut axes = ranges.iter().map(of_parameter).collect::<Result<Vec<Axis>, UsageError>>()?;
        let range = self.search.step.range().map(|range| axis("eps", range, "--eps")).transpose()?;
        let eps = if range.is_some() { None } else { self.search.step.half()? };
        axes.extend(range);
        let Search { degree, seconds, .. } = self.search;
        Ok((study, Question { eps, over: axes, degree, seconds }))
    }

    fn options(asked: &Question, line: CommandLine) -> CommandLine {
        let line = asked.over.iter().fold(line, |line, axis| match axis.name.as_str() {
            "eps" => line.with("--eps", &axis.range),
            name => line.with("--param", format!("{name}={}", axis.range)),
        });
        line.with_changed_options::<Self>(asked)
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let (study, asked) = self.read_question()?;
        let found = asked.ask(&study, &ProgressDisplay::of("points"))?;
        Ok(Answer::of(&found, self.search.json, text))
    }
}

fn relation_lines(found: &Proposal) -> Vec<String> {
    let Proposal { relation, points, claims, .. } = found;
    let integrals = match found.sight.integrals {
        0 => "no integral".to_owned(),
        1 => "1 integral".to_owned(),
        count => format!("{count} integrals"),
    };
    let verdict = if claims.is_empty() { "only seen, nothing is proved" } else { "proved:" };
    let seen = format!(
        "when {relation}: all {points} points of the grid there are special, with {integrals}; {verdict}"
    );
    [vec![seen], claims.clone()].concat()
}

fn text(answer: &ScanFound) -> String {
    let ScanFound { system: name, found, total, seconds } = answer;
    let seconds = seconds.unwrap_or_default();
    let seen = |sight: &Option<DegreesAndRanks>| match sight {
        Some(sight) => {
            vec![sight.integrals.to_string(), joined(&sight.hilbert, " "), joined(&sight.degrees, " ")]
        }
        None => vec!["-".to_owned(), "no map that can be inverted, or every orbit ends at a pole".to_owned()],
    };
    let headings = ["integrals", "Hilbert function", "degrees"].map(str::to_owned);
    let mut rows = vec![[found.names.clone(), headings.to_vec()].concat()];
    let generic = vec!["generic".to_owned(); found.names.len()];
    rows.push([generic, seen(&Some(found.generic.clone()))].concat());
    rows.extend(found.special().map(|point| {
        let values: Vec<String> = point.values.iter().map(ToString::to_string).collect();
        [values, seen(&point.sight)].concat()
    }));
    let special = match rows.len() - 2 {
        0 => "none is".to_owned(),
        1 => "1 is".to_owned(),
        several => format!("{several} are"),
    };
    let looked = found.points.len();
    let mut lines = vec![format!(
        "{name}: {special} special of {looked} points; seen are the degrees of {} iterates and relations of degree {} at most; \
         {seconds:.2} s",
        found.generic.degrees.len().saturating_sub(1),
        found.generic.hilbert.len(),
    )];
    lines.extend(found.out_of_time.then(|| {
        let left = total - looked;
        format!("note: time ran out before {left} of {total} points; increase --seconds to continue")
    }));
    let relations = found.relations.iter().map(relation_lines);
    paragraphs([table(&rows, found.names.len()), lines].into_iter().chain(relations))
}
