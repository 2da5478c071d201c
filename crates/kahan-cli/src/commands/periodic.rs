//! `kahan periodic`: cycles of the map, how stable they are, and where they go when something
//! changes.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValue;
use kahan_core::nalgebra::Complex;
use kahan_draw::document::Rows;
use kahan_draw::picture::{Look, branch};
use kahan_dynamics::periodic::{Branch, Extrapolated};
use kahan_study::{
    CycleFound, Free, Hold, Periodic as Question, Study, StudyError, characteristic_polynomial,
};

use super::line::Asking;
use super::look::{OutFile, SheetOptions, usual};
use crate::printing::layout::{headed, paragraphs, table};
use crate::printing::{Answer, Prompt, Refusal, csv, joined};
use crate::reading::{Start, one_of, over, whole};

/// Finds a periodic point near a first one: its multipliers, and how it changes.
///
/// Newton's method with the exact Jacobian takes all points of the cycle as unknowns; where cycles
/// come in families, as those of integrable maps do, it goes to the nearest. Multipliers are the
/// eigenvalues of the derivative of the map over the period; `family` counts the directions that it
/// leaves as they are. Where the points are fractions of a few digits, the cycle is proved exactly,
/// and its stability is decided by the exact characteristic polynomial of that derivative.
///
/// Cycles of period 1 are the steady states of the field. They are the same for each eps, which
/// need not be given; the eigenvalues of the derivative f' of the field are told, too. Linear
/// integrals of the field, as the total of a closed population, keep their values at the first
/// point, and multipliers are those along their common level; --hold none holds nothing.
///
/// --over follows the cycle along a range of eps or of a parameter, round folds, and tells where
/// multipliers go through the unit circle. The table has about as many rows as the range has
/// values: more round a fold, fewer where points move far, and the last one may lie beyond the
/// range. --out writes it as CSV, or draws it. The exit status is 1 where no cycle is found.
///
/// --free eps looks for a limit cycle of the flow: K steps close up, and eps is found with them. The
/// period and the changes on a branch are extrapolated from K, 2K and 4K steps. The cycle is looked
/// for near --at, and near where its orbit comes back close to itself after --transient steps: after
/// about the time 2*eps*K, or without --period after any.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan periodic lv --eps 1/10 --at 0.9,1.1
  kahan periodic --field 'sdot = -2*s*i; idot = 2*s*i - i; rdot = i;' --at 0.9,0.1,0
  kahan periodic --field 'xdot = a - x^2;' --eps 0.1 --at 1 --over a=1:-1:41 --out a.svg
  kahan periodic --field 'xdot=-y-z; ydot=x+y/5; zdot=1/5+x*z-4*z;' --free eps --eps 0.01 --at 1,2,0")]
// ε may be what changes.
#[command(mut_group("step", |step| step.required(false)))]
pub(crate) struct Periodic {
    #[command(flatten)]
    start: Start,

    /// A multiple of the period; the smallest period is told. With --free eps: the steps of a
    /// cycle.
    #[arg(long, value_name = "K", default_value = "1", allow_hyphen_values = true, value_parser = whole(1, MOST_STEPS))]
    period: usize,

    /// The unknown besides the points: eps, of a cycle of the flow.
    #[arg(long, value_name = "WHAT", value_parser = one_of(&[Free::Eps], |_| PossibleValue::new("eps").help("half the time step")), hide_possible_values = true)]
    free: Option<Free>,

    /// With --free: the steps before an orbit is looked at that comes back close to itself.
    #[arg(long, value_name = "N", default_value = "0", requires = "free", value_parser = whole(0, u64::MAX))]
    transient: u64,

    /// What changes, a parameter or eps: NAME=FROM:TO:COUNT, or :+STEP.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    over: Option<String>,

    /// Which integrals keep their values at the first point.
    #[arg(long, value_name = "WHICH", default_value = "linear", value_parser = one_of(&Hold::ALL, |one| one.name().into()))]
    hold: Hold,

    /// Write the branch to this file: a table, F.csv, or a picture of the first variable, F.svg,
    /// F.png or F.pdf.
    #[arg(long, value_name = "F", requires = "over")]
    out: Option<PathBuf>,

    #[command(flatten)]
    look: SheetOptions,

    /// Print one JSON object.
    ///
    /// Its members: period, points, residual, multipliers, eigenvalues, stability, family, held,
    /// exact, flow, branch.
    #[arg(long)]
    json: bool,
}

/// The longest period that is looked for, and the most steps of a cycle of the flow.
const LONGEST_PERIOD: usize = 200;
const MOST_STEPS: usize = 1_000_000;

impl Asking for Periodic {
    type Question = Question;

    fn asked(&self) -> Result<(Study, Question), Refusal> {
        let axis = self.over.as_deref().map(over).transpose()?;
        let (study, at, eps) = self.start.study_over(axis.as_slice())?;
        if self.free.is_none() && self.period > LONGEST_PERIOD {
            let period = self.period;
            return Err(Refusal::new(format!(
                "--period {period}: a cycle of the map has at most {LONGEST_PERIOD} points; --free eps takes more steps"
            )));
        }
        let (period, free, transient, hold) = (self.period, self.free, self.transient, self.hold);
        Ok((study, Question { eps, at, period, free, transient, over: axis, hold }))
    }

    /// The cycle, and its branch.
    fn run(&self) -> Result<Answer, Refusal> {
        let out = self.out.as_deref().map(OutFile::picture_or_table).transpose()?;
        let (study, asked) = self.asked()?;
        let found = match asked.ask(&study, &Prompt::of("cycles")) {
            Err(why @ StudyError::NoCycle { .. }) => {
                return Ok(Answer::text(String::new()).but(Some(why.to_string())));
            }
            Err(why @ StudyError::LongCycle { .. }) => {
                return Err(Refusal::new(format!("--period {}: {why}", self.period)));
            }
            found => found?,
        };
        if let Some(out) = out {
            let picture = branch(&found, &Look::on(self.look.sheet(usual())));
            out.put(&picture.drawing, || csv(&points(&found)))?;
        }
        Ok(Answer::of(&found, self.json, text))
    }
}

/// Behind a verdict that the digits of the multipliers do not show.
const BLURRED: &str = ", as rounding leaves no more digits of the multipliers";

fn text(found: &CycleFound) -> String {
    let cycle = &found.cycle;
    let family = match cycle.family {
        0 => "it stands alone".to_owned(),
        1 => "1 direction leads to neighbours of the same period".to_owned(),
        directions => format!("{directions} directions lead to neighbours of the same period"),
    };
    let steps = cycle.points.len();
    let blurred = if cycle.is_blurred() { BLURRED } else { "" };
    let (period, multipliers) = match &found.flow {
        Some(flow) => (
            format!("{}, in {steps} steps of eps = {:?}", with_error(&flow.period), found.eps),
            &flow.multipliers,
        ),
        None => (steps.to_string(), &cycle.multipliers),
    };
    let mut cycle_lines = vec![
        format!("period       {period}"),
        format!("stability    {}{blurred}", cycle.stability()),
        format!("multipliers  {}", complex_numbers(multipliers)),
    ];
    let eigenvalues = found.eigenvalues(cycle, found.eps);
    cycle_lines.extend(eigenvalues.map(|of| format!("eigenvalues  {} of f'", complex_numbers(&of))));
    cycle_lines
        .extend((!found.held.is_empty()).then(|| format!("held         {}", joined(&found.held, ", "))));
    cycle_lines.extend(found.flow.is_none().then(|| format!("family       {family}")));
    cycle_lines.push(format!("residual     {:.1e}", cycle.residual));
    let points = cycle.points.iter().enumerate().map(|(n, point)| {
        [n.to_string()].into_iter().chain(point.iter().map(|x| format!("{x:?}"))).collect()
    });
    let points = table(&headed([&"n".to_owned()].into_iter().chain(&found.variables), points), 1);
    let exact = found.exact.iter().map(|exact| {
        let points = exact.points.iter().map(|point| format!("({})", joined(point, ", ")));
        let polynomial = characteristic_polynomial(exact);
        vec![
            format!("proved exactly: {}", joined(points, " → ")),
            format!("multipliers are the roots of {polynomial}: {}", exact.stability),
        ]
    });
    let branch = found.branch.iter().flat_map(|(name, branch)| {
        let errors = found.flow.as_ref().and_then(|flow| flow.turns.as_deref());
        let turns = branch.turns.iter().enumerate().map(|(k, turn)| {
            let parameter = match errors {
                Some(errors) => with_error(&errors[k]),
                None => format!("{:.10}", turn.parameter),
            };
            format!("at {name} = {parameter}: {}", found.said(turn.change))
        });
        let cut =
            "the branch ends before the range does: at a pole, where cycles come together, or since it winds";
        let changes = turns.chain(branch.is_cut.then(|| cut.to_owned())).collect();
        [table(&branch_rows(found, name, branch), 1), changes]
    });
    let groups = [cycle_lines, points].into_iter().chain(exact).chain(branch);
    paragraphs(groups.filter(|lines| !lines.is_empty()))
}

/// A number to one digit more than its error has, with that.
fn with_error(found: &Extrapolated) -> String {
    let digits = (1.0 - found.error.log10().floor()).clamp(1.0, 15.0);
    format!("{:.*} ± {:.0e}", digits as usize, found.value, found.error)
}

/// A row a step of the branch.
fn branch_rows(found: &CycleFound, name: &str, branch: &Branch) -> Rows {
    let is_of_flow = found.flow.is_some();
    let rows = branch.points.iter().map(|point| {
        let first = point.cycle.points[0].iter().map(|x| format!("{x:.8}"));
        let period = 2.0 * point.eps * point.cycle.points.len() as f64;
        let tail = [point.cycle.stability().to_string(), complex_numbers(&point.cycle.multipliers)];
        let head = [format!("{:.8}", point.parameter)].into_iter();
        head.chain(is_of_flow.then(|| format!("{period:.8}"))).chain(first).chain(tail).collect()
    });
    let variables = found.variables.iter().map(String::as_str);
    let head = [name].into_iter().chain(is_of_flow.then_some("period"));
    headed(head.chain(variables).chain(["stability", "multipliers"]), rows)
}

/// All points of each cycle of the branch, one behind the other.
fn points(found: &CycleFound) -> Rows {
    let (name, branch) = found.branch.as_ref().expect("a branch is written where there is one");
    let rows = branch.points.iter().flat_map(|point| {
        point.cycle.points.iter().enumerate().map(|(n, x)| {
            let before = [format!("{:?}", point.parameter), n.to_string()];
            let numbers = x.iter().map(|x| format!("{x:?}"));
            before.into_iter().chain(numbers).chain([point.cycle.stability().to_string()]).collect()
        })
    });
    let variables = found.variables.iter().map(String::as_str);
    headed([name, "n"].into_iter().chain(variables).chain(["stability"]), rows)
}

fn complex_numbers(numbers: &[Complex<f64>]) -> String {
    let shown = numbers.iter().map(|one| match one.im {
        0.0 => format!("{:.6}", one.re),
        im => format!("{:.6}{}{:.6}i", one.re, if im < 0.0 { "-" } else { "+" }, im.abs()),
    });
    joined(shown, "  ")
}
