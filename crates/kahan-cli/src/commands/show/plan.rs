//! Prints the plan of the generated code: the cost of each function, and the step as a program.

use kahan_algebra::elimination::MOST_EXPANDED;
use kahan_algebra::kahan::TERM_BUDGET;
use kahan_algebra::plan::{Input, LARGEST_SIZE, Node, Operation, Plan};
use kahan_algebra::poly::Variable;
use kahan_study::{FunctionCost, Listing, ShownPlans};

use crate::printing::page::{Page, paragraph};

const NAMES: usize = 23;
const COLUMNS: [(&str, usize); 6] =
    [("add", 5), ("mul", 6), ("fma", 6), ("div", 5), ("all", 6), ("chain", 7)];

pub(super) fn text(planned: &ShownPlans) -> String {
    let mut page = Page::default();
    page.line(&format!("{}: the plans of the generated code", planned.system));
    page.line("");
    let titles = COLUMNS.map(|(title, _)| title.to_owned());
    page.line(&row("object", &titles));
    for costs in &planned.objects {
        let label = label(planned, &costs.object);
        if label.chars().count() < NAMES {
            page.line(&row(&label, &cells(costs)));
        } else {
            page.line(&label);
            page.line(&row("", &cells(costs)));
        }
    }
    page.line("");
    for note in notes() {
        page.prose(&note);
    }
    let [derived, written] = [planned.derive_ms, planned.plan_ms].map(Option::unwrap_or_default);
    page.prose(&format!(
        "In this run the map was derived in {derived:.2} ms and the step was planned in {written:.2} ms."
    ));
    if planned.derived.system.field.dimension() > MOST_EXPANDED {
        page.line("");
        page.prose(
            "Systems of more than eight variables have no closed form here: det A and (N, D) are computed on the numeric matrix.",
        );
    } else if planned.derived.map.is_none() {
        page.line("");
        page.prose(&format!(
            "N and D are beyond the budget ({TERM_BUDGET} terms, and the work that derives them), so det A and (N, D) are \
             computed on the numeric matrix."
        ));
    }
    match &planned.step {
        Some(step) => step_section(&mut page, "step", step),
        None => page.section("step", paragraph(ALONG_COUPLINGS)),
    }
    if let Some(general) = &planned.general_step {
        page.line("");
        page.prose(GENERAL_STEP_NOTE);
        step_section(&mut page, "general step", general);
    }
    page.text
}

fn label(planned: &ShownPlans, name: &str) -> String {
    let step = planned.derived.step();
    let counted = match name {
        "prepared constants" => step,
        "general constants" => step.and_then(|step| step.general.as_deref()),
        _ => None,
    };
    counted.map_or_else(|| name.to_owned(), |step| format!("{name} ({})", step.constants.outputs.len()))
}

const GENERAL_STEP_NOTE: &str = "This step is divided by the time step, which shortens the way from a state to the next. Floats take \
    it where eps is from 2^-64 to 2^64 in size (f32: 2^-16 to 2^16). All else takes the general step, which divides by no eps: \
    exact and wider numbers, the lanes of ensembles, Jacobians, and floats at any other eps.";

fn step_section(page: &mut Page, name: &str, step: &Listing) {
    if step.constants.is_empty() {
        page.section(&format!("constants of the {name}"), ["none"]);
    } else {
        page.section(&format!("constants of the {name}, computed once"), &step.constants);
    }
    page.section(&format!("kernel of the {name}, for each state"), &step.kernel);
    let next = if name == "step" { "next state" } else { "next state of the general step" };
    page.section(next, &step.next);
    page.section(&format!("how far the {name} holds"), domain(step.holds_to));
}

/// Explains that a plan is about as accurate as Gaussian elimination up to |ε f′| = `holds_to`.
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

const ALONG_COUPLINGS: &str = "x~ = x + 2 eps A(x,eps)^-1 f(x), by elimination along the couplings of the variables, in an order found \
    beforehand; where a pivot is small, with pivoting. What it does depends on the numbers that it meets, so nothing is counted here. \
    det A = 0 counts as a pole, and the Jacobian is A(x,eps)^-1 A(x~,-eps).";

fn notes() -> Vec<String> {
    let [a, b] = [Node(0), Node(1)];
    let cycles = [
        Operation::Add(a, b),
        Operation::Multiply(a, b),
        Operation::MultiplyAdd(a, b, a),
        Operation::Divide(a, b),
    ]
    .map(|operation| {
        let operations = vec![
            Operation::Input(Input::Variable(Variable(0))),
            Operation::Input(Input::Variable(Variable(1))),
            operation,
        ];
        Plan { operations, outputs: vec![Node(2)] }.cost().critical_path
    });
    let [add, multiply, fused, divide] = cycles;
    vec![
        "all: operations where there is no multiply-add (fma), which then counts twice.".to_owned(),
        format!(
            "chain: cycles from the inputs to the last result; add {add}, mul {multiply}, fma {fused}, div {divide}."
        ),
        "step: from a state to the next, the constants being prepared.".to_owned(),
    ]
}

fn cells(costs: &FunctionCost) -> [String; 6] {
    let FunctionCost {
        additions, multiplications, multiply_adds, divisions, operations, chain_cycles, ..
    } = *costs;
    let chain_cycles = chain_cycles.map(|cycles| cycles as usize);
    [additions, multiplications, multiply_adds, divisions, operations, chain_cycles]
        .map(|count| count.map_or_else(|| "-".to_owned(), |count| count.to_string()))
}

fn row(name: &str, cells: &[String; 6]) -> String {
    let mut line = format!("{name:<NAMES$}");
    for (cell, (_, width)) in cells.iter().zip(COLUMNS) {
        line.push_str(&format!("{cell:>width$}"));
    }
    line
}
