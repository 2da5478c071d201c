//! Tests `kahan show --plan`: operation counts, the formula of a step, and notes on elimination.

use crate::running::{answer, kahan, object, text};

/// A field whose map and elimination are too long for a straight-line program.
const DENSE: &str = "
    adot = (a+b+c+d+e+f+g+h)^2 + a*b; bdot = (a-b+2*c+d-e+f+g+h)^2 + b*c; cdot = (a+b-c+d+3*e+f-g+h)^2 + c*d;
    ddot = (a+2*b+c-d+e+f+g-h)^2 + d*e; edot = (3*a+b+c+d-e+f+g+h)^2 + e*f; fdot = (a+b+c-2*d+e-f+g+h)^2 + f*g;
    gdot = (a-b+c+d+e+5*f-g+h)^2 + g*h; hdot = (a+b+7*c+d-e+f+g-h)^2 + h*a;";

fn rows(page: &str) -> Vec<&str> {
    page.lines().skip_while(|line| !line.starts_with("object")).take_while(|line| !line.is_empty()).collect()
}

#[test]
fn every_object_of_e3_has_a_row() {
    let page = answer(&["show", "e3", "--plan"]);
    let rows = rows(&page);
    let names = [
        "field f",
        "f'(x)",
        "Q(x,x')",
        "polarised field",
        "prepared constants (",
        "step ",
        "general constants (",
        "general step ",
        "det A",
        "(N, D)  ",
        "(N, D) reduced",
        "integrals",
        "density",
        "bracket P",
        "bracket Q",
    ];
    assert_eq!(rows.len(), names.len() + 1, "{page}");
    let width = rows[0].chars().count();
    for (row, name) in rows[1..].iter().zip(names) {
        assert!(row.starts_with(name), "{row}");
        assert_eq!(row.chars().count(), width, "numbers stand to the right: {row}");
    }
    assert!(page.lines().all(|line| line.chars().count() <= 100), "{page}");
    assert!(page.contains("x~ = x - ") || page.contains("x~ = x + "), "{page}");
    assert!(page.contains("In this run the map was derived in "), "{page}");
}

#[test]
fn the_object_says_what_the_table_says() {
    let plan = object(&["show", "e3", "--plan", "--json"]);
    let page = answer(&["show", "e3", "--plan"]);
    assert_eq!(plan["system"], "e3");
    let objects = plan["objects"].as_array().expect("a list");
    let rows = rows(&page);
    assert_eq!(objects.len() + 1, rows.len());
    for (object, row) in objects.iter().zip(&rows[1..]) {
        let keys =
            ["additions", "multiplications", "multiply_adds", "divisions", "operations", "chain_cycles"];
        let numbers: Vec<String> = keys.iter().map(|key| object[key].to_string()).collect();
        let cells: Vec<&str> = row.split_whitespace().rev().take(6).collect();
        let shown: Vec<&str> = cells.into_iter().rev().collect();
        assert_eq!(shown, numbers, "{row}");
        let [a, m, f, d, all] = [0, 1, 2, 3, 4].map(|index| object[keys[index]].as_u64().expect("a count"));
        assert_eq!(a + m + 2 * f + d, all, "{object}");
    }
    let lines = |key: &str| -> Vec<String> {
        let lines = plan["step"][key].as_array().expect("a list");
        lines.iter().map(|line| line.as_str().expect("a line").to_owned()).collect()
    };
    for line in [lines("constants"), lines("kernel"), lines("next")].concat() {
        assert!(page.lines().any(|shown| shown == format!("  {line}")), "{line}");
    }
    let reciprocals = lines("reciprocals");
    assert_eq!(reciprocals.len(), 3);
    for reciprocal in &reciprocals {
        let is_quotient = |line: &String| {
            ["1/", "-1/", "2/", "-2/"].iter().any(|two| line.starts_with(&format!("{reciprocal} = {two}")))
        };
        assert!(lines("kernel").iter().any(is_quotient));
    }
    assert!(plan["derive_ms"].as_f64().is_some_and(|ms| ms > 0.0));
    assert!(plan["plan_ms"].as_f64().is_some_and(|ms| ms > 0.0));
}

#[test]
fn a_plan_says_how_far_it_holds() {
    let clebsch =
        "adot = 3*y*z; bdot = -5*z*x; cdot = 2*x*y; xdot = y*c - z*b; ydot = z*a - x*c; zdot = x*b - y*a;";
    for (field, holds_to) in [("xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;", 1000), (clebsch, 10)] {
        let plan = object(&["show", "--field", field, "--plan", "--json"]);
        assert_eq!(plan["step"]["holds_to"], holds_to);
        let page = answer(&["show", "--field", field, "--plan"]);
        assert!(page.contains(&format!("Up to |eps f'| = {holds_to} ")), "{page}");
        assert!(page.lines().all(|line| line.chars().count() <= 100), "{page}");
    }
}

#[test]
fn a_parameter_that_is_put_in_makes_a_smaller_plan() {
    let operations = |arguments: &[&str]| {
        let plan = object(&[&["show", "--plan", "--json"], arguments].concat());
        let objects = plan["objects"].as_array().expect("a list").clone();
        let step = objects.into_iter().find(|object| object["object"] == "step").expect("a step");
        step["operations"].as_u64().expect("a count")
    };
    assert_eq!(operations(&["e9", "--param", "xi=1"]), operations(&["e3"]));
    assert!(operations(&["e9", "--param", "xi=1"]) < operations(&["e9"]));
    let field = "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;";
    assert_eq!(operations(&["--field", field]), operations(&["e3"]));
}

#[test]
fn a_step_that_eliminates_says_so() {
    let page = answer(&["show", "--field", DENSE, "--plan"]);
    let words = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("by elimination along the couplings"), "{page}");
    let rows = rows(&page);
    let step = rows.iter().find(|row| row.starts_with("step")).expect("a row");
    assert_eq!(step.split_whitespace().skip(1).collect::<Vec<_>>(), ["-"; 6]);
    assert!(page.lines().all(|line| line.chars().count() <= 100), "{page}");
    let plan = object(&["show", "--field", DENSE, "--plan", "--json"]);
    assert!(plan["step"].is_null());
    let objects = plan["objects"].as_array().expect("a list");
    let step = objects.iter().find(|object| object["object"] == "step").expect("a step");
    assert!(step["operations"].is_null());
}

#[test]
fn a_plan_is_text_or_json() {
    for other in ["--latex", "--macro"] {
        let output = kahan(&["show", "e3", "--plan", other]);
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains("--plan"), "{}", text(&output.stderr));
    }
    assert!(answer(&["show", "--help"]).contains("kahan show e3 --plan"));
}
