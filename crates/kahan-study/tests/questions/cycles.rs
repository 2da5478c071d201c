//! Limit cycles of flows agree with shooting by SciPy's integrator DOP853 at tolerance 1e-13.

use kahan_algebra::rational::Rational;
use kahan_study::{LiftCriterion, StudyError, Subject, Unwatched};
use serde_json::{Value, json};

use super::{answer, question, study};

const ROSSLER: &str = "xdot = -y - z; ydot = x + y/5; zdot = 1/5 + x*z - c*z;";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number: {value}"))
}

fn cycle(field: &Subject, dt: f64, more: Value) -> Value {
    let mut asked = json!({"ask": "periodic", "eps": dt / 2.0, "free": "eps"});
    asked.as_object_mut().expect("an object").extend(more.as_object().expect("an object").clone());
    answer(&study(field.clone()), asked)
}

/// Asserts that the flow's period is `period` within its error estimate, and near the map's period.
fn assert_period(found: &Value, period: f64, most: f64) {
    let flow = &found["flow"];
    let [value, error, of_map] = ["period", "error", "period_of_map"].map(|name| number(&flow[name]));
    assert!((value - period).abs() <= error && error < most * period, "{period}: {flow}");
    assert!((of_map / period - 1.0).abs() < 0.05, "{period}: {flow}");
    assert_eq!(number(&flow["steps"]) * 2.0 * number(&flow["eps"]), of_map);
}

#[test]
fn loops_of_the_roessler_system_are_run_once_at_every_step() {
    for ((c, of), period) in
        [((5, 2), 5.748_991_183_278), ((7, 2), 11.545_218_287_763), ((4, 1), 23.177_001_055_976)]
    {
        let field = Subject::text(ROSSLER).with("c", Rational::new(c, of));
        for (dt, most) in [(0.02, 1e-5), (0.05, 1e-4), (0.1, 2e-2)] {
            let found = cycle(&field, dt, json!({"at": [1, 2, 0], "transient": 4000}));
            assert_period(&found, period, most);
            assert_eq!(found["stability"], "attracting", "{c}/{of} at {dt}");
        }
    }
}

#[test]
fn the_shortest_cycles_of_the_lorenz_system_are_found_by_their_period() {
    // Periods are from Viswanath, "The fractal property of the Lorenz attractor", Physica D 190.
    let field = Subject::named("lorenz").with("s", 10.into()).with("r", 28.into());
    let field = field.with("b", Rational::new(8, 3));
    for period in [1.558_652_210_716, 2.305_907_263_940, 3.023_583_703_434] {
        for (dt, most) in [(0.005_f64, 1e-6), (0.01, 1e-4), (0.02, 1e-3)] {
            let steps = (period / dt).round();
            let found = cycle(&field, period / steps, json!({"at": [1, 2, 20], "period": steps as u64}));
            assert_period(&found, period, most);
        }
    }
}

#[test]
fn errors_of_lifted_cycles_hold() {
    let lifted = |text| Subject::text(text).lifted(LiftCriterion::Automatic);
    let field = lifted("xdot = y; ydot = (1 - x^2)*y - x;");
    for (dt, most) in [(0.02, 1e-6), (0.04, 1e-6), (0.05, 1e-6), (0.06, 1e-6), (0.1, 1e-5)] {
        let found = cycle(&field, dt, json!({"at": [2, 0]}));
        assert_period(&found, 6.663_286_859_323, most);
    }
}

#[test]
fn a_branch_ends_where_two_rounds_come_together() {
    let more = json!({"at": [1, 2, 0], "transient": 4000, "over": {"c": "4:3.8:3"}});
    let found = cycle(&Subject::text(ROSSLER), 0.05, more);
    let branch = &found["branch"];
    let turns = branch["turns"].as_array().expect("turns");
    let last = &turns[turns.len() - 1];
    assert!(last["change"].as_str().is_some_and(|change| change.contains("half the period")), "{turns:?}");
    assert!(turns.iter().all(|turn| turn["change"] != "fold, two cycles meet"), "{turns:?}");
    let off = (number(&last["parameter"]) - 3.837_358_168_4).abs();
    assert!(off < 1e-4 && off <= number(&last["error"]), "{last}");
    let rows = branch["points"].as_array().expect("rows");
    let values: Vec<f64> = rows.iter().map(|row| number(&row["parameter"])).collect();
    assert_eq!((&values[..2], &branch["cut"]), (&[4.0, 3.9][..], &json!(true)), "{values:?}");
    assert!(values.len() == 3 && rows.iter().all(|row| row["flow"]["steps"] == rows[0]["flow"]["steps"]));
}

#[test]
fn what_is_no_cycle_is_said_in_its_words() {
    let field = Subject::text(ROSSLER).with("c", Rational::new(5, 2));
    let asked = json!({"ask": "periodic", "eps": 0.01, "free": "eps", "at": [9, 9, 9], "period": 300});
    let asked = question(asked).expect("a question");
    let error = study(field).ask(&asked, &Unwatched).expect_err("no cycle");
    assert!(matches!(error, StudyError::NoCycle { .. }) && !error.to_string().contains("family"), "{error}");
}

#[test]
fn a_branch_ends_where_the_cycle_shrinks_to_a_steady_state() {
    // The Brusselator with a = 1 has its Hopf point at b = 1 + a².
    let field =
        Subject::text("xdot = 1 + x^2*y - (b + 1)*x; ydot = b*x - x^2*y;").lifted(LiftCriterion::Automatic);
    let more = json!({"at": [1, 2], "transient": 2000, "over": {"b": "2.3:1.8:6"}});
    let found = cycle(&field, 0.1, more);
    let rows = found["branch"]["points"].as_array().expect("rows");
    let values: Vec<f64> = rows.iter().map(|row| number(&row["parameter"])).collect();
    assert_eq!(values[..3], [2.3, 2.2, 2.1], "{values:?}");
    let [turn] = &found["branch"]["turns"].as_array().expect("turns")[..] else { panic!("{values:?}") };
    assert!(turn["change"].as_str().is_some_and(|change| change.contains("Hopf")), "{turn}");
    assert!(
        (number(&turn["parameter"]) - 2.0).abs() <= number(&turn["error"]) && values.len() == 4,
        "{turn}"
    );
    assert!(rows.iter().all(|row| row["flow"]["steps"] == rows[0]["flow"]["steps"]), "{rows:?}");
    assert_eq!(found["branch"]["cut"], json!(true));
}
