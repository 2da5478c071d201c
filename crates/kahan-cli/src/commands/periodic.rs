//! The command `kahan periodic`: cycles of the map, their stability, and their branches.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValue;
use kahan_core::nalgebra::Complex;
use kahan_draw::document::Rows;
use kahan_draw::picture::{PictureOptions, branch};
use kahan_dynamics::periodic::{BranchChange, BranchPoint, Extrapolated, PeriodicPoint};
use kahan_study::{
    CycleFound, FlowFound, FreeUnknown, HeldIntegrals, Periodic as Question, Study, StudyError,
    characteristic_polynomial,
};

use super::command_line::QuestionCommand;
use super::image_options::{ImageOptions, OutFile, usual};
use crate::printing::layout::{paragraphs, table, with_headings};
use crate::printing::{Answer, ProgressDisplay, UsageError, csv, joined};
use crate::reading::{Start, one_of, over, whole};

/// Finds a periodic point near a given point: its stability, and how it changes with a parameter.
///
/// Newton's method with the exact Jacobian solves for all points of the cycle at once. If cycles
/// come in families, as those of integrable maps do, it converges to a nearby one. Multipliers are
/// the eigenvalues of the derivative of the map over one period; `family` counts the directions in
/// which neighbouring points have the same period. If the points are fractions with few digits, the
/// cycle is proved exactly, and the exact characteristic polynomial of that derivative decides its
/// stability.
///
/// Cycles of period 1 are the steady states of the field. They do not depend on eps, which may be
/// left out; the eigenvalues of the derivative f' are shown as well. Linear integrals of the field,
/// such as the total of a closed population, keep their values at the initial point, and
/// multipliers are those within their common level set; with --hold none, nothing is kept.
///
/// --over follows the cycle along a range of eps or of a parameter, also around folds. The table
/// has a row at each value (again after a fold), and a row at each change, where multipliers cross
/// the unit circle. --out writes all points of these cycles as CSV, or draws the branch. The exit
/// status is 1 if no cycle is found.
///
/// --free eps finds a limit cycle of the flow: a cycle of K steps for which eps is unknown as well.
/// Period, multipliers and changes are extrapolated from K, 2K and 4K steps, for a lifted field
/// also 8K. The search starts at --at, and at points of its orbit, after --transient steps, that
/// nearly return after about the time 2*eps*K, or without --period after any time.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan periodic lv --eps 1/10 --at 0.9,1.1
  kahan periodic --field 'sdot = -2*s*i; idot = 2*s*i - i; rdot = i;' --at 0.9,0.1,0
  kahan periodic --field 'xdot = a - x^2;' --eps 0.1 --at 1 --over a=1:-1:41 --out a.svg
  kahan periodic --field 'xdot=-y-z; ydot=x+y/5; zdot=1/5+x*z-4*z;' --free eps --eps 0.01 --at 1,2,0")]
// `--eps` is optional, because --over may give ε.
#[command(mut_group("step", |step| step.required(false)))]
pub(crate) struct Periodic {
    #[command(flatten)]
    start: Start,

    /// A multiple of the period in steps; the smallest period is found. With --free eps: the number
    /// K of steps of a cycle.
    #[arg(long, value_name = "K", default_value = "1", allow_hyphen_values = true, value_parser = whole(1, MOST_STEPS))]
    period: usize,

    /// The unknown besides the points: eps, for a limit cycle of the flow.
    #[arg(long, value_name = "WHAT", value_parser = one_of(&[FreeUnknown::Eps], |_| PossibleValue::new("eps").help("half the time step")), hide_possible_values = true)]
    free: Option<FreeUnknown>,

    /// With --free: make N steps before looking for a point where the orbit nearly returns.
    #[arg(long, value_name = "N", default_value = "0", requires = "free", value_parser = whole(0, u64::MAX))]
    transient: u64,

    /// The parameter or eps that changes: NAME=FROM:TO:COUNT, or :+STEP.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    over: Option<String>,

    /// The integrals that keep their values at the initial point.
    #[arg(long, value_name = "WHICH", default_value = "linear", value_parser = one_of(&HeldIntegrals::ALL, |one| one.name().into()))]
    hold: HeldIntegrals,

    /// Write the branch to this file: a table, F.csv, or a picture of the first variable, F.svg,
    /// F.png or F.pdf.
    #[arg(long, value_name = "F", requires = "over")]
    out: Option<PathBuf>,

    #[command(flatten)]
    look: ImageOptions,

    /// Print one JSON object.
    ///
    /// Its members: period, points, residual, multipliers, eigenvalues, stability, family, held,
    /// exact, flow, branch. A branch has `points` (its rows), `turns` (its changes), and `cut`
    /// (whether it ends before the range does).
    #[arg(long)]
    json: bool,
}

const LONGEST_PERIOD: usize = 200;
const MOST_STEPS: usize = 1_000_000;

impl QuestionCommand for Periodic {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let axis = self.over.as_deref().map(over).transpose()?;
        let (study, at, eps) = self.start.study_over(axis.as_slice())?;
        if self.free.is_none() && self.period > LONGEST_PERIOD {
            let period = self.period;
            return Err(UsageError::new(format!(
                "--period {period}: a cycle of the map has at most {LONGEST_PERIOD} points; --free eps takes more steps"
            )));
        }
        let (period, free, transient, hold) = (self.period, self.free, self.transient, self.hold);
        Ok((study, Question { eps, at, period, free, transient, over: axis, hold }))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let out = self.out.as_deref().map(OutFile::picture_or_table).transpose()?;
        let (study, asked) = self.read_question()?;
        let found = match asked.ask(&study, &ProgressDisplay::of("cycles")) {
            Err(why @ StudyError::NoCycle { .. }) => {
                return Ok(Answer::text(String::new()).with_complaint(Some(why.to_string())));
            }
            Err(why @ StudyError::LongCycle { .. }) => {
                return Err(UsageError::new(format!("--period {}: {why}", self.period)));
            }
            found => found?,
        };
        if let Some(out) = out {
            let picture = branch(&found, &PictureOptions::on(self.look.sheet(usual())));
            out.put(&picture.drawing, || csv(&points(&found)))?;
        }
        Ok(Answer::of(&found, self.json, text))
    }
}

const CUT: &str =
    "the branch ends before the range does: at a pole, where cycles come together, or since it winds";
const PLAIN: &str = "finer steps have no such cycle there; take a smaller eps (dt)";
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
    let of_flow = found.flow.as_ref().map(|flow| with_error(&flow.period));
    let mut cycle_lines = vec![format!("period       {}", of_flow.unwrap_or_else(|| steps.to_string()))];
    cycle_lines.extend(found.flow.map(|_| {
        let of_map = 2.0 * found.eps * steps as f64;
        format!("steps        {steps} of eps = {:?}, whose period is 2*eps*{steps} = {of_map:.8}", found.eps)
    }));
    cycle_lines.push(format!("stability    {}{blurred}", cycle.stability()));
    cycle_lines.push(format!("multipliers  {}", complex_numbers(&cycle.multipliers)));
    let eigenvalues = found.eigenvalues(cycle, found.eps);
    cycle_lines.extend(eigenvalues.map(|of| format!("eigenvalues  {} of f'", complex_numbers(&of))));
    cycle_lines
        .extend((!found.held.is_empty()).then(|| format!("held         {}", joined(&found.held, ", "))));
    cycle_lines.extend(found.flow.is_none().then(|| format!("family       {family}")));
    cycle_lines.push(format!("residual     {:.1e}", cycle.residual));
    let points = cycle.points.iter().enumerate().map(|(n, point)| {
        [n.to_string()].into_iter().chain(point.iter().map(|x| format!("{x:?}"))).collect()
    });
    let points = match found.branch {
        Some(_) => Vec::new(),
        None => table(&with_headings([&"n".to_owned()].into_iter().chain(&found.variables), points), 1),
    };
    let exact = found.exact.iter().map(|exact| {
        let points = exact.points.iter().map(|point| format!("({})", joined(point, ", ")));
        let polynomial = characteristic_polynomial(exact);
        vec![
            format!("proved exactly: {}", joined(points, " → ")),
            format!("multipliers are the roots of {polynomial}: {}", exact.stability),
        ]
    });
    let branch = found.branch.iter().flat_map(|(name, branch)| {
        let changes = found.rows().filter_map(|(point, of_flow)| {
            let parameter = match of_flow {
                Some(of_flow) => with_error(&of_flow.parameter),
                None => format!("{:.10}", point.parameter),
            };
            Some(format!("at {name} = {parameter}: {}", found.change_in_words(point.change()?)))
        });
        let is_plain = found.flow.is_some() && found.rows().any(|(_, of_flow)| of_flow.is_none());
        let has_end = found.rows().any(|(point, _)| point.change().is_some_and(BranchChange::is_end));
        let mut lines: Vec<String> = changes.collect();
        lines.extend(
            is_plain.then(|| format!("periods without an error are those of {steps} steps: {PLAIN}")),
        );
        lines.extend((branch.is_cut && !has_end).then(|| CUT.to_owned()));
        [table(&branch_rows(found, name), 1), lines]
    });
    let groups = [cycle_lines, points].into_iter().chain(exact).chain(branch);
    paragraphs(groups.filter(|lines| !lines.is_empty()))
}

/// Formats a number with its certain digits and one more, followed by its error.
fn with_error(found: &Extrapolated) -> String {
    let digits = (1.0 - libm::log10(found.error).floor()).clamp(1.0, 15.0);
    format!("{:.*} ± {:.0e}", digits as usize, found.value, found.error)
}

/// Returns a row for each requested value of the branch, and for each bifurcation.
fn branch_rows(found: &CycleFound, name: &str) -> Rows {
    let is_of_flow = found.flow.is_some();
    let rows = found.rows().map(|(point, of_flow)| {
        let steps = point.cycle.points.len();
        let period = match of_flow {
            Some(of_flow) => with_error(&of_flow.period),
            None => format!("{:.8}", 2.0 * point.eps * steps as f64),
        };
        let first = point.cycle.points[0].iter().map(|x| format!("{x:.8}"));
        let change = point.change().map(|change| found.change_in_words(change)).unwrap_or_default();
        let multipliers = complex_numbers(&point.cycle.multipliers);
        let head = [format!("{:.8}", point.parameter)].into_iter();
        let head = head.chain(is_of_flow.then_some([period, steps.to_string()]).into_iter().flatten());
        head.chain(first).chain([point.cycle.stability().to_string(), multipliers, change]).collect()
    });
    let variables = found.variables.iter().map(String::as_str);
    let head = [name].into_iter().chain(is_of_flow.then_some(["period", "steps"]).into_iter().flatten());
    with_headings(head.chain(variables).chain(["stability", "multipliers", "change"]), rows)
}

fn points(found: &CycleFound) -> Rows {
    let (name, _) = found.branch.as_ref().expect("a branch is written where there is one");
    let shown = |x: f64| format!("{x:?}");
    let rows = found.rows().flat_map(|(point, of_flow)| {
        let tail = tail(found, point, of_flow);
        point.cycle.points.iter().enumerate().map(move |(n, x)| {
            let head = [shown(point.parameter), n.to_string()];
            head.into_iter().chain(x.iter().map(|x| shown(*x))).chain(tail.clone()).collect()
        })
    });
    let multipliers = (1..=found.cycle.multipliers.len())
        .flat_map(|k| [format!("multiplier{k}_re"), format!("multiplier{k}_im")]);
    let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
    let of_flow = if found.flow.is_some() { names(&["steps", "eps", "period", "error"]) } else { Vec::new() };
    let head =
        names(&[name.as_str(), "n"]).into_iter().chain(found.variables.clone()).chain(names(&["stability"]));
    let head: Vec<String> = head.chain(multipliers).chain(names(&["change"])).chain(of_flow).collect();
    with_headings(&head, rows)
}

/// Returns the cells of a row of the branch from the column `stability` on.
fn tail(found: &CycleFound, point: &BranchPoint, of_flow: Option<&FlowFound>) -> Vec<String> {
    let shown = |x: f64| format!("{x:?}");
    let PeriodicPoint { points, multipliers, .. } = &point.cycle;
    let mut cells = vec![point.cycle.stability().to_string()];
    cells.extend(multipliers.iter().flat_map(|one| [shown(one.re), shown(one.im)]));
    cells.push(point.change().map(|change| found.change_in_words(change)).unwrap_or_default());
    if found.flow.is_some() {
        let of_map = 2.0 * point.eps * points.len() as f64;
        let period = of_flow.map_or(of_map, |of_flow| of_flow.period.value);
        let error = of_flow.map(|of_flow| shown(of_flow.period.error)).unwrap_or_default();
        cells.extend([points.len().to_string(), shown(point.eps), shown(period), error]);
    }
    cells
}

fn complex_numbers(numbers: &[Complex<f64>]) -> String {
    let shown = numbers.iter().map(|one| match one.im {
        0.0 => format!("{:.6}", one.re),
        im => format!("{:.6}{}{:.6}i", one.re, if im < 0.0 { "-" } else { "+" }, im.abs()),
    });
    joined(shown, "  ")
}
