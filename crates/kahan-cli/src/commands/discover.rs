//! `kahan discover`: what a field's map preserves, found from its equations alone. What is found is
//! `kahan-discover`'s; this only prints it.

mod discovery;

use std::path::PathBuf;

use clap::Args;
use kahan_algebra::render::{folded, macro_block};
use kahan_study::{Discover as Question, Study};

use super::line::Asking;
use super::search::Search;
use crate::printing::{Answer, Prompt, Refusal, Sink};
use crate::reading::number;

/// Finds what the map of a field preserves, from its equations alone: integrals, invariant
/// densities and Poisson brackets, structure, growth.
///
/// What is given (--eps, --param) is fixed, the rest generic. Integrals, densities and brackets
/// stand last, as lines of the language of `kahan!`, each of them proved; what stands behind `when`
/// is fixed. An integral whose formula would fill pages is given by a Hirota-Kimura basis:
/// monomials with one linear relation along every orbit, whose coefficients are integrals. Where
/// integrals may be missing, the search goes on to higher degrees until the time is up, and a
/// sentence says what ended it. Claims that the field brings along are not looked at.
///
/// The JSON object holds hilbert, independent_integrals, degrees, growth, entropy,
/// linear_integrals, integrals, densities, brackets, bases, hamiltonian and more. `hilbert` says
/// how many monomials of degree at most 1, 2, ... are independent on an orbit; `found` has kind,
/// name and expression of every integral, density, bracket and Hamiltonian.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Discover {
    #[command(flatten)]
    search: Search,

    /// Write the field and what was found in LaTeX.
    #[arg(long, conflicts_with_all = ["as_macro", "json"])]
    latex: bool,

    /// Print the block of `kahan!` with what was found as its claims, ready to compile.
    #[arg(long = "macro", conflicts_with = "json")]
    as_macro: bool,

    /// Write the answer to this file, which appears whole or not at all.
    #[arg(long, value_name = "F")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  kahan discover --field 'xdot = y; ydot = 6*x^2 - a;'
  kahan discover e6
  kahan discover lv --eps 1
  kahan discover e9 --param xi=-1 --json
  kahan discover lagrange --macro --out lagrange.rs
  kahan discover euler --latex
  kahan discover henon-heiles --degree 7
  kahan discover --field 'for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }' --sites 5";

impl Asking for Discover {
    const COMMAND: &str = "discover";
    type Question = Question;

    fn asked(&self) -> Result<(Study, Question), Refusal> {
        let Search { source, eps, degree, seconds, .. } = &self.search;
        let eps = eps.as_deref().map(|eps| number(eps, "--eps")).transpose()?;
        Ok((source.study()?, Question { eps, degree: *degree, seconds: *seconds }))
    }
}

impl Discover {
    /// The report.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let sink = self.out.as_deref().map(|path| Sink::file(path, "--out")).transpose()?;
        let (study, asked) = self.asked()?;
        let found = asked.ask(&study, &Prompt::stages())?;
        let answer = if self.latex {
            Answer::verbatim(discovery::latex(&found)?)
        } else if self.as_macro {
            let block = folded(&macro_block(&found.claimed()?), SOURCE_WIDTH);
            Answer::verbatim(discovery::comments(&found, SOURCE_WIDTH) + &block)
        } else {
            Answer::of(&found, self.search.json, discovery::text)
        };
        let Some(sink) = sink else { return Ok(answer) };
        sink.put(&answer.text)?;
        Ok(Answer { text: String::new(), ..answer })
    }
}

/// The width of lines of Rust.
const SOURCE_WIDTH: usize = 100;
