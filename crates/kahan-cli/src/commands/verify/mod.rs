//! `kahan verify`: every formula of the paper established again, or the claims of a field of one's
//! own.

mod lines;
mod mutate;
mod report;
mod summary;
mod table;

use std::time::Instant;

use clap::Args;
use kahan_algebra::render::claim_text;
use kahan_paper::{Established, Paper, establish_block_claim};

use crate::printing::{Answer, Prompt, Refusal};
use crate::reading::{Block, Source};
use report::{Form, Report, Row, in_one_line};

/// Proves the formulas of the paper, or the claims of a field.
///
/// A SYSTEM alone stands for the paper's formulas that are about it. Rational formulas are expanded
/// over the rational numbers and tested modulo primes; what is not rational is compared in 256-bit
/// arithmetic; what the paper misprints is refuted as printed and established as corrected. With a
/// field of your own, or with --param, the claims of that block are proved. The exit status is 1 if
/// a claim does not hold.
#[derive(Args, Debug, Default)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Verify {
    #[command(flatten)]
    source: Source,

    /// The same as SYSTEM; `general` for what holds for every field.
    #[arg(long = "system", value_name = "SYSTEM", conflicts_with_all = ["system", "field", "file"])]
    of: Option<String>,

    /// Show every claim with its statement, its source and its time.
    #[arg(long, conflicts_with = "mutate")]
    all: bool,

    /// Change one coefficient or sign of every claim: each must then fail. The exit status is 1 if
    /// one survives. Of a field of your own the claims must hold to begin with.
    #[arg(long)]
    mutate: bool,

    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan verify
  kahan verify --all
  kahan verify e6
  kahan verify e6 --json
  kahan verify --system general
  kahan verify --mutate
  kahan verify e9 --param xi=1
  kahan verify --field 'xdot = y; ydot = -x; integral H = x^2 + y^2;'
  kahan verify --file field.txt --mutate";

impl Verify {
    /// One screen, a line a claim, the table, or one object; a complaint if a claim fails.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let start = Instant::now();
        let source = self.of.clone().map_or_else(|| self.source.clone(), Source::of_system);
        if let Some(block) = source.block_outside_the_paper()? {
            if self.mutate {
                // Of a claim that does not hold there is nothing to mutate: it is reported as in
                // every other command.
                let system = block.system()?;
                let name = block.name(&system);
                let system = source.specialised(system, &name)?;
                return Ok(mutate::run_block(&name, &system, self.json));
            }
            let rows = verify_block(&block, &source)?;
            let report = Report { rows, open: &[], elapsed: start.elapsed() };
            return Ok(report.answer(self.form(Form::Lines)));
        }
        let paper = Paper::new();
        let system = source.system_of_the_paper()?;
        let claims: Vec<_> = paper
            .claims()
            .iter()
            .filter(|claim| system.is_none_or(|system| claim.system == system))
            .collect();
        if self.mutate {
            return Ok(mutate::run(&paper, &claims, self.json));
        }
        let progress = Prompt::new(claims.len() as u64, "claims");
        let established = paper.establish_all(&claims, &|| progress.advance(1));
        progress.finish();
        let rows = claims.iter().zip(established).map(|(claim, established)| Row {
            id: claim.id.to_string(),
            system: claim.system.to_owned(),
            source: claim.source(),
            statement: in_one_line(&claim.statement),
            claim: Some(claim),
            established,
        });
        let (open, short) =
            if system.is_none() { (kahan_paper::OPEN, Form::Summary) } else { (&[][..], Form::Lines) };
        let report = Report { rows: rows.collect(), open, elapsed: start.elapsed() };
        Ok(report.answer(self.form(short)))
    }

    /// What was asked for, or else the short form.
    fn form(&self, short: Form) -> Form {
        if self.json {
            Form::Json
        } else if self.all {
            Form::Table
        } else {
            short
        }
    }
}

/// The claims of a block that is not the catalog's, or is specialised.
fn verify_block(block: &Block, source: &Source) -> Result<Vec<Row<'static>>, Refusal> {
    let system = block.unproved_system()?;
    let name = block.name(&system);
    let system = source.specialised(system, &name)?;
    let rows = system.claims.iter().map(|claim| {
        let start = Instant::now();
        let (outcome, detail) = establish_block_claim(&system, claim, block.seed());
        let place = block.entry.and_then(|entry| entry.source(&claim.name.text)).unwrap_or_default();
        Row {
            id: format!("{name}.{}", claim.name.text),
            system: name.clone(),
            source: place.to_owned(),
            statement: in_one_line(&claim_text(&system, claim)),
            claim: None,
            established: Established { outcome, detail, elapsed: start.elapsed() },
        }
    });
    Ok(rows.collect())
}
