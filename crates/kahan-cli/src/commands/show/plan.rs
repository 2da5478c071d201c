//! `kahan show --plan`: what each generated function costs, and the step in straight lines.

use std::time::{Duration, Instant};

use kahan_algebra::derive;
use kahan_algebra::derived::{Derived, StepListing};
use kahan_algebra::kahan::TERM_BUDGET;
use kahan_algebra::plan::{Cost, LARGEST_SIZE, Node, Operation, Plan, StepPlan};
use kahan_algebra::poly::Variable;
use kahan_algebra::system::System;
use serde_json::{Value, json};

use crate::printing::page::{Page, paragraph};

/// The width of the column of names.
const NAMES: usize = 23;
/// The widths of the columns of numbers, with what stands above them.
const COLUMNS: [(&str, usize); 6] =
    [("add", 5), ("mul", 6), ("fma", 6), ("div", 5), ("all", 6), ("chain", 7)];

/// The plans of a system, and how long it took to make them.
pub(super) struct PlanSheet {
    name: String,
    derived: Derived,
    /// Each function of the generated code with what it costs; `None` where it eliminates in a
    /// loop.
    functions: Vec<(String, Option<Cost>)>,
    step: Option<StepListing>,
    /// The step that serves every scalar, where the step is divided by the time step.
    general: Option<StepListing>,
    derive_time: Duration,
    plan_time: Duration,
}

impl PlanSheet {
    /// Derives the map and plans the code of a system.
    pub(super) fn of(name: String, system: &System) -> Self {
        let start = Instant::now();
        let derived = derive(system);
        let derive_time = start.elapsed();
        let start = Instant::now();
        let listing = |step: &StepPlan| StepListing::of(step, &system.field.symbols);
        let step = derived.step().map(listing);
        let plan_time = start.elapsed();
        let inverse = derived.step().filter(|step| step.has_inverse_step);
        let general = inverse.map(|step| listing(step.for_any_step()));
        let cost = |(name, plan): (String, Option<Plan>)| (name, plan.as_ref().map(Plan::cost));
        let functions = derived.functions().into_iter().map(cost).collect();
        PlanSheet { name, derived, functions, step, general, derive_time, plan_time }
    }

    pub(super) fn json(&self) -> Value {
        let objects = self.functions.iter().map(|(name, cost)| {
            json!({
                "object": name,
                "additions": cost.map(|cost| cost.additions),
                "multiplications": cost.map(|cost| cost.multiplications),
                "multiply_adds": cost.map(|cost| cost.fused),
                "divisions": cost.map(|cost| cost.divisions),
                "operations": cost.map(|cost| cost.operations()),
                "chain_cycles": cost.map(|cost| cost.critical_path),
            })
        });
        let listing = |step: &StepListing| {
            json!({
                "constants": step.constants,
                "kernel": step.kernel,
                "reciprocals": step.reciprocals,
                "next": step.next,
                "holds_to": step.holds_to,
            })
        };
        json!({
            "system": self.name,
            "objects": objects.collect::<Vec<_>>(),
            "step": self.step.as_ref().map(listing),
            "general_step": self.general.as_ref().map(listing),
            "derive_ms": milliseconds(self.derive_time),
            "plan_ms": milliseconds(self.plan_time),
        })
    }

    pub(super) fn text(&self) -> String {
        let mut page = Page::default();
        page.line(&format!("{}: the plans of the generated code", self.name));
        page.line("");
        let titles = COLUMNS.map(|(title, _)| title.to_owned());
        page.line(&row("object", &titles));
        for (name, cost) in &self.functions {
            let label = self.label(name);
            // A long name stands above its numbers.
            if label.chars().count() < NAMES {
                page.line(&row(&label, &cells(*cost)));
            } else {
                page.line(&label);
                page.line(&row("", &cells(*cost)));
            }
        }
        page.line("");
        for note in notes() {
            page.prose(&note);
        }
        page.prose(&format!(
            "In this run the map was derived in {:.2} ms and the step was planned in {:.2} ms.",
            milliseconds(self.derive_time),
            milliseconds(self.plan_time)
        ));
        if self.derived.couplings.is_some() {
            page.line("");
            page.prose(
                "Systems of more than eight variables have no closed form here: det A and (N, D) are computed on the numeric matrix.",
            );
        } else if self.derived.map.is_none() {
            page.line("");
            page.prose(&format!(
                "N and D are beyond the budget ({TERM_BUDGET} terms, and the work that derives them), so det A and (N, D) are \
                 computed on the numeric matrix."
            ));
        }
        match &self.step {
            Some(step) => self.step_sections(&mut page, step),
            None if self.derived.couplings.is_some() => page.section("step", paragraph(ALONG_COUPLINGS)),
            None => page.section("step", paragraph(ELIMINATION)),
        }
        page.text
    }

    fn step_sections(&self, page: &mut Page, step: &StepListing) {
        step_section(page, "step", step);
        if let Some(general) = &self.general {
            page.line("");
            page.prose(GENERAL);
            step_section(page, "general step", general);
        }
    }

    /// Constants with their number.
    fn label(&self, name: &str) -> String {
        let step = self.derived.step();
        let counted = match name {
            "prepared constants" => step,
            "general constants" => step.and_then(|step| step.general.as_deref()),
            _ => None,
        };
        counted.map_or_else(|| name.to_owned(), |step| format!("{name} ({})", step.constants.outputs.len()))
    }
}

/// Which step is taken when.
const GENERAL: &str = "This step is divided by the time step, which shortens the way from a state to the next. Floats take \
    it where eps is from 2^-64 to 2^64 in size (f32: 2^-16 to 2^16). All else takes the general step, which divides by no eps: \
    exact and wider numbers, the lanes of ensembles, Jacobians, and floats at any other eps.";

/// A step in three parts.
fn step_section(page: &mut Page, name: &str, step: &StepListing) {
    if step.constants.is_empty() {
        page.section(&format!("constants of the {name}"), vec!["none".to_owned()]);
    } else {
        page.section(&format!("constants of the {name}, computed once"), step.constants.clone());
    }
    page.section(&format!("kernel of the {name}, for each state"), step.kernel.clone());
    page.section(
        if name == "step" { "next state" } else { "next state of the general step" },
        step.next.clone(),
    );
    page.section(&format!("how far the {name} holds"), domain(step.holds_to));
}

/// Up to which size of a step its error is near that of elimination.
fn domain(holds_to: u32) -> Vec<String> {
    let end = if holds_to == LARGEST_SIZE {
        "as far as was looked."
    } else {
        "longer steps lose more; try_step says how much is left."
    };
    paragraph(&format!(
        "Up to |eps f'| = {holds_to} (the largest row sum of eps f'(x)) the median error is at most 30 times that of elimination with \
         pivoting, or 300 u, by measurement at random points in short floats; {end}"
    ))
}

/// The same for systems that are eliminated along their couplings.
const ALONG_COUPLINGS: &str = "x~ = x + 2 eps A(x,eps)^-1 f(x), by elimination along the couplings of the variables, in an order found \
    beforehand; where a pivot is small, with pivoting. What it does depends on the numbers that it meets, so nothing is counted here. \
    det A = 0 counts as a pole, and the Jacobian is A(x,eps)^-1 A(x~,-eps).";

/// Why there are no lines to show.
const ELIMINATION: &str = "x~ = x + 2 eps A(x,eps)^-1 f(x), by elimination with pivoting in a loop: N and D are beyond the budget, \
    and so is the elimination of A in straight lines. What it does depends on the numbers that it meets, so nothing is counted \
    here. det A = 0 counts as a pole, and the Jacobian is A(x,eps)^-1 A(x~,-eps).";

/// What the columns mean.
fn notes() -> Vec<String> {
    let latency = |operation: fn(Node, Node) -> Operation| {
        let inputs = [Operation::Input(Variable(0)), Operation::Input(Variable(1))];
        let operations = inputs.into_iter().chain([operation(Node(0), Node(1))]).collect();
        Plan { operations, outputs: vec![Node(2)] }.cost().critical_path
    };
    let add = latency(Operation::Add);
    let multiply = latency(Operation::Multiply);
    let fused = latency(|a, b| Operation::MultiplyAdd(a, b, a));
    let divide = latency(Operation::Divide);
    vec![
        "all: operations where there is no multiply-add (fma), which then counts twice.".to_owned(),
        format!(
            "chain: cycles from the inputs to the last result; add {add}, mul {multiply}, fma {fused}, div {divide}."
        ),
        "step: from a state to the next, the constants being prepared.".to_owned(),
    ]
}

fn cells(cost: Option<Cost>) -> [String; 6] {
    let Some(cost) = cost else { return std::array::from_fn(|_| "-".to_owned()) };
    let Cost { additions, multiplications, fused, divisions, critical_path } = cost;
    let critical_path = usize::try_from(critical_path).expect("a count of cycles");
    [additions, multiplications, fused, divisions, cost.operations(), critical_path]
        .map(|count| count.to_string())
}

/// A row of the table, the numbers to the right.
fn row(name: &str, cells: &[String; 6]) -> String {
    let mut line = format!("{name:<NAMES$}");
    for (cell, (_, width)) in cells.iter().zip(COLUMNS) {
        line.push_str(&format!("{cell:>width$}"));
    }
    line
}

fn milliseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}
