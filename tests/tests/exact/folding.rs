//! Tests that a `const` parameter is substituted before the map is reduced to lowest terms.

use kahan_algebra::plan::{Operation, Plan, StepPlan};
use kahan_tests::expression::read_unproved;

const EQUATIONS: &str = "xdot = -x*z; ydot = -xi*y*z; zdot = x^2 + xi*y^2;";

fn plan(text: &str) -> StepPlan {
    StepPlan::of(&read_unproved(text).field).expect("a field of three variables has a closed form")
}

/// Counts additions, multiplications and divisions. A multiply-add is counted as two operations.
fn counts(plan: &Plan) -> [usize; 3] {
    let mut counts = [0; 3];
    for operation in &plan.operations {
        let [sums, products, quotients] = match operation {
            Operation::Add(..) | Operation::Subtract(..) => [1, 0, 0],
            Operation::Multiply(..) => [0, 1, 0],
            Operation::Divide(..) => [0, 0, 1],
            Operation::MultiplyAdd(..) | Operation::MultiplySubtract(..) | Operation::SubtractProduct(..) => {
                [1, 1, 0]
            }
            Operation::Negate(_) | Operation::Input(_) | Operation::Constant(_) => [0, 0, 0],
            Operation::Call(function, ..) => match *function {},
        };
        counts = [counts[0] + sums, counts[1] + products, counts[2] + quotients];
    }
    counts
}

#[test]
fn e9_with_xi_folded_in_costs_what_e3_costs() {
    let e3 = plan("struct E3; xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;");
    let folded = plan(&format!("struct E9; const xi = 1; {EQUATIONS}"));
    assert_eq!(counts(&folded.kernel.plan), counts(&e3.kernel.plan));
    assert_eq!(counts(&folded.constants), counts(&e3.constants));
}

#[test]
fn e9_with_xi_folded_in_costs_less_than_e9() {
    let total = |plan: &StepPlan| counts(&plan.kernel.plan).iter().sum::<usize>();
    let generic = plan(&format!("struct E9 {{ xi }} {EQUATIONS}"));
    let folded = plan(&format!("struct E9; const xi = 1; {EQUATIONS}"));
    assert!(total(&folded) < total(&generic), "{} against {}", total(&folded), total(&generic));
    assert_eq!(counts(&folded.kernel.plan)[2], 1, "one reciprocal");
}
