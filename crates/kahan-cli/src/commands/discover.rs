//! The command `kahan discover`, which searches for what a map preserves.

use std::iter;
use std::path::PathBuf;

use clap::Args;
use kahan_algebra::render::{Formulas, Notation, Text, folded, lines as breakable, macro_block};
use kahan_discover::report::HamiltonianReport;
use kahan_draw::answer::{evaluation, numbers, states_and_images};
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use kahan_study::{ClaimShown, Discover as Question, Discovered, Study};

use super::command_line::QuestionCommand;
use crate::printing::layout::{labelled, matrix, paragraphs, screen_width};
use crate::printing::page::{Page, aligned};
use crate::printing::{Answer, OutputStream, ProgressDisplay, UsageError};
use crate::reading::{Source, StepLength, seconds, whole};

/// Finds what the map of a field preserves, from its equations alone: integrals, invariant
/// densities and Poisson brackets, drifts, structure, growth.
///
/// --eps and --param fix values; all other symbols are generic. Integrals, densities, brackets and
/// drifts are printed last, as claims in the language of `kahan!`. A drift is a function whose next
/// value follows from its value. Each claim is proved; `when` repeats the fixed values. An integral
/// whose formula would fill pages is given by a Hirota-Kimura basis: monomials with one linear
/// relation along every orbit, whose coefficients are integrals. If integrals may be missing, the
/// search continues to higher degrees until the time is up, and a sentence says why it ended.
/// Claims that the field already has are ignored.
///
/// The JSON object has the members hilbert, independent_integrals, degrees, growth, growth_proved,
/// entropy, linear_integrals, integrals, densities, brackets, drifts, bases, hamiltonian and more.
/// `hilbert` gives the number of monomials of degree at most 1, 2, ... that are independent on an
/// orbit. `growth_proved` is true if exponential growth of the degrees is proved; a map of the
/// plane then has no integral. `found` has kind, name and expression of every integral, density,
/// bracket, drift and Hamiltonian.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan discover --field 'xdot = y; ydot = 6*x^2 - a;'
  kahan discover e6
  kahan discover lv --eps 1
  kahan discover e9 --param xi=-1 --json
  kahan discover lagrange --macro --out lagrange.rs
  kahan discover euler --latex
  kahan discover henon-heiles --degree 7
  kahan discover --field 'for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }' --sites 5")]
pub(crate) struct Discover {
    #[command(flatten)]
    search: Search,

    /// Write the field and the findings in LaTeX.
    #[arg(long, conflicts_with_all = ["as_macro", "json"])]
    latex: bool,

    /// Print a `kahan!` block for Rust that has the findings as its claims.
    #[arg(long = "macro", conflicts_with = "json")]
    as_macro: bool,

    /// Write the answer to this file, which appears when it is complete.
    #[arg(long, value_name = "F")]
    out: Option<PathBuf>,
}

/// A field, and the bounds of a search.
#[derive(Args, Debug)]
#[command(mut_arg("eps", |eps| eps.help("Half the time step (dt = 2 eps); a symbol if not given. `scan` takes a range, too")))]
pub(crate) struct Search {
    #[command(flatten)]
    pub(crate) source: Source,

    #[command(flatten)]
    pub(crate) step: StepLength,

    /// The largest degree of the relations on orbits that are searched.
    ///
    /// The default depends on the number of variables: the degree of about 200 monomials, for
    /// `scan` of about 80. Without this option, `discover` continues to higher degrees while
    /// integrals may be missing and time is left.
    #[arg(long, value_name = "D", allow_hyphen_values = true, value_parser = whole(1, u32::MAX))]
    pub(crate) degree: Option<u32>,

    /// The time limit of the search, in seconds.
    ///
    /// Each stage gets a share of it: orbits and their relations up to two fifths. Stages that are
    /// not finished by then are left out, and the answer says so. `discover` uses all of the time
    /// only if integrals may be missing. With --degree it ends earlier, and the answer is the same
    /// on every machine.
    #[arg(long, value_name = "S", default_value = "60", allow_hyphen_values = true, value_parser = seconds)]
    pub(crate) seconds: f64,

    /// Print one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

impl QuestionCommand for Discover {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let Search { source, step, degree, seconds, .. } = &self.search;
        let eps = step.half()?;
        Ok((source.study()?, Question { eps, degree: *degree, seconds: *seconds }))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let sink = self.out.as_deref().map(|path| OutputStream::file(path, "--out")).transpose()?;
        let (study, asked) = self.read_question()?;
        let found = asked.ask(&study, &ProgressDisplay::stages())?;
        let answer = if self.latex {
            Answer::verbatim(latex(&found))
        } else if self.as_macro {
            let block = folded(&macro_block(&found.claimed()), SOURCE_WIDTH);
            Answer::verbatim(comments(&found, SOURCE_WIDTH) + &block)
        } else {
            Answer::of(&found, self.search.json, text)
        };
        let Some(sink) = sink else { return Ok(answer) };
        sink.put(&answer.text)?;
        Ok(Answer { text: String::new(), ..answer })
    }
}

const SOURCE_WIDTH: usize = 100;

/// Returns the summary, followed by a paragraph with all claims.
fn text(found: &Discovered) -> String {
    let report = &found.report;
    let numbers = numbers(found).rows.into_iter().skip(1);
    let numbers = numbers.flat_map(|row| labelled(&row[0], &row[1], KEY_WIDTH));
    let tensors = report.structure.hamiltonians.iter().map(|found| {
        let rows = matrix(&found.tensor, '[', ']', screen_width());
        iter::once(found.label("K") + " =").chain(rows.iter().map(|row| format!("  {row}"))).collect()
    });
    let modified = modified(found, report.compact());
    let claims = found.readable_claims();
    let claims: Vec<String> = claims.iter().map(|claim| (*claim).to_owned()).collect();
    let groups = [numbers.collect(), report.sentences.clone()].into_iter().chain(tensors).chain(modified);
    let groups = groups.chain(bases(found).map(Vec::from));
    paragraphs(groups.chain(Some(claims).filter(|claims| !claims.is_empty())))
}

/// Returns the modified Hamiltonians, shortened by auxiliary symbols, and the symbols' definitions.
fn modified<'a>(
    found: &Discovered,
    compact: impl Iterator<Item = &'a HamiltonianReport>,
) -> Option<Vec<String>> {
    let mut lines: Vec<String> =
        compact.map(|one| format!("{} = {}", one.label("H~"), one.modified(&Text))).collect();
    let [states, images] = states_and_images(&found.report, &Text);
    let last = lines.last_mut()?;
    *last += &format!(", where {images} is the image of {states}{}", fixed_values_text(found));
    Some(lines)
}

/// Returns a text such as `, when a = 1, eps = 1/2`, or no text if no value is fixed.
fn fixed_values_text(found: &Discovered) -> String {
    let parameters = found.fixed.iter().map(|(name, value)| format!("{name} = {value}"));
    let fixed: Vec<String> = parameters.chain(found.eps.as_ref().map(|eps| format!("eps = {eps}"))).collect();
    if fixed.is_empty() { String::new() } else { format!(", when {}", fixed.join(", ")) }
}

fn bases(found: &Discovered) -> impl Iterator<Item = [String; 2]> {
    let variables = &found.report.variables;
    found.report.bases.iter().enumerate().map(|(number, basis)| {
        let relation = basis.relation(variables, &Text);
        [
            format!("basis {}{}: {relation}", number + 1, fixed_values_text(found)),
            evaluation(basis, &Text, ""),
        ]
    })
}

/// Returns the results that claims cannot express, as comments of the block.
fn comments(found: &Discovered, width: usize) -> String {
    let modified = modified(found, found.report.standalone()).into_iter().flatten();
    let texts = modified.chain(bases(found).flatten());
    let comment = |text: String| -> String {
        let rows = breakable(&text, width.saturating_sub(3));
        rows.iter().map(|row| format!("// {row}\n")).collect()
    };
    texts.map(comment).collect()
}

fn latex(found: &Discovered) -> String {
    let system = found.readable();
    let notation = &Latex;
    let mut page = Page::default();
    page.line(&format!("% {}", found.system));
    let values = Formulas { field: &system.field, map: None, notation }.field();
    let states = system.field.symbols.states.iter().map(|state| format!("\\dot {}", notation.name(state)));
    page.display(&aligned(
        states.zip(&values).map(|(left, right)| breaking::equation(&left, right, PAGE_WIDTH)).collect(),
    ));
    for claim in &system.claims {
        page.claim(&ClaimShown::of(&system, claim, notation));
    }
    for hamiltonian in found.report.compact() {
        page.line(&format!("% modified Hamiltonian{}", fixed_values_text(found)));
        let left = notation.name(&hamiltonian.label("H")).replacen('H', "\\widetilde{H}", 1);
        let equation = breaking::equation(&left, &hamiltonian.modified(notation), PAGE_WIDTH);
        let [states, images] = states_and_images(&found.report, notation);
        let image = format!("&\\text{{where }} {images} \\text{{ is the image of }} {states}");
        page.display(&aligned(vec![equation, image]));
    }
    for (number, basis) in found.report.bases.iter().enumerate() {
        page.line(&format!("% Hirota-Kimura basis {}{}", number + 1, fixed_values_text(found)));
        let relation = basis.relation(&found.report.variables, notation);
        let left = relation.strip_suffix(" = 0").unwrap_or(&relation);
        page.display(&aligned(vec![breaking::equation("0", left, PAGE_WIDTH)]));
        page.line(&evaluation(basis, notation, "$"));
    }
    page.text
}

const KEY_WIDTH: usize = 21;
