//! Tests for bugs that were fixed.

use crate::running::{BEYOND_THE_BUDGET, answer, kahan, text};

#[test]
fn formulas_wider_than_a_format_allows_are_shown() {
    let factors: Vec<String> = (0..12).map(|i| format!("(a{i} + b{i})")).collect();
    assert!(answer(&["show", "--field", &format!("xdot = x/({});", factors.join("*"))]).len() > 65_536);
}

#[test]
fn a_parameter_that_cancels_is_not_printed_into_the_block() {
    let block =
        answer(&["show", "--field", "struct S { a, b } xdot = b*x + a*y - y*a; ydot = x;", "--macro"]);
    assert!(block.contains("pub struct S { b }"), "{block}");
}

#[test]
fn beyond_the_budget_a_pole_is_said_to_be_one_by_convention() {
    let steps = ["--steps", "2", "--scalar", "exact"];
    for (command, further) in [("eval", &[][..]), ("orbit", &steps)] {
        let at_a_pole = [command, "--field", BEYOND_THE_BUDGET, "--eps", "1/2", "--at", "1,0,0,0,0"];
        let output = kahan(&[&at_a_pole, further].concat());
        assert_eq!(output.status.code(), Some(1), "{command}");
        let complaint = text(&output.stderr);
        assert!(complaint.contains("det A = 0") && complaint.contains("budget"), "{complaint}");
    }
}
