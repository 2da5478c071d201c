//! Tests that claims are found, shown, proved and refuted.

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_discover::report::MOST_READABLE;
use kahan_study::{Answer, Question, Show, StudyError, Subject, Unwatched, Verify};
use serde_json::{Value, json};

use super::{answer, one, question, study};

#[test]
fn what_is_found_can_be_claimed() {
    let asked = question(json!({"ask": "discover", "degree": 2})).expect("a question");
    let Ok(Answer::Discover(found)) = study(Subject::named("e6")).ask(&asked, &Unwatched) else {
        panic!("a report")
    };
    let claimed = found.claimed();
    assert_eq!(claimed.claims.len(), found.claims().count());
}

/// The density of the second flow of Clebsch's system is too long to be shown.
#[test]
fn long_claims_are_not_for_people_to_read() {
    let clebsch = "m1dot = (w3 - w2)*(m2*m3 - w1*p2*p3); m2dot = (w1 - w3)*(m3*m1 - w2*p3*p1); \
        m3dot = (w2 - w1)*(m1*m2 - w3*p1*p2); p1dot = w3*p2*m3 - w2*p3*m2; \
        p2dot = w1*p3*m1 - w3*p1*m3; p3dot = w2*p1*m2 - w1*p2*m1;";
    let asked = question(json!({"ask": "discover"})).expect("a question");
    let Ok(Answer::Discover(found)) = study(Subject::text(clebsch)).ask(&asked, &Unwatched) else {
        panic!("a report")
    };
    let [density] = &found.report.densities[..] else { panic!("a density") };
    assert!(density.text.len() > MOST_READABLE, "{}", density.text.len());
    assert!(found.claims().any(|(text, _)| text == density.text));
    let readable = found.readable();
    assert!(readable.claims.iter().all(|claim| claim.kind != ClaimKind::Density));
    let said = format!("Its formula has {} characters", density.text.len());
    assert!(found.report.sentences.iter().any(|sentence| sentence.contains(&said)));
}

#[test]
fn formulas_come_one_by_one_in_every_notation() {
    let swing = study(Subject::text("struct Swing { lambda } xdot = lambda*y; ydot = -x^2/2;"));
    let shown = |form: &str| answer(&swing, json!({"ask": "show", "as": form}));
    assert_eq!(shown("text")["A"], json!([["1", "-eps*lambda"], ["eps*x", "1"]]));
    assert_eq!(shown("latex")["A"][0][1], "-\\varepsilon \\lambda");
    let sympy = shown("sympy");
    assert_eq!(sympy["field"], json!(["lambda_*y", "-1/2*x**2"]));
    assert_eq!(sympy["bilinear"][1], "-1/2*x*x_prime");
    let moved = "x + 2*eps*(lambda_*y - 1/2*eps*lambda_*x**2)/(1 + eps**2*lambda_*x)";
    assert_eq!(sympy["map"][0], moved);
    let script = sympy["script"].as_str().expect("a script");
    assert!(script.contains(&format!("\nmap = Matrix(sympify([\n    [\"{moved}\"],\n")), "{script}");
    assert!(script.contains("\nparameters = [Symbol(name) for name in [\"lambda_\"]]\n"), "{script}");
    assert_eq!(shown("text").get("script"), None);
    assert_eq!(shown("kahan")["macro"], shown("text")["macro"]);
    assert_eq!(shown("plan")["objects"][0]["object"], "field f");
    assert_eq!(shown("plan")["derive_ms"], Value::Null);

    let claimed = "xdot = lambda*y; ydot = -x/2; integral H = x^2 + 2*lambda*y^2 when lambda = 1;";
    let claimed = study(Subject::text(claimed));
    let claim = |form: &str| answer(&claimed, json!({"ask": "show", "as": form}))["claims"][0].clone();
    assert_eq!(claim("text")["when"], "lambda = 1");
    assert_eq!(claim("text")["equations"], json!([["H", "x^2 + 2*lambda*y^2"]]));
    assert_eq!(claim("sympy")["equations"], json!([["H", "x**2 + 2*lambda_*y**2"]]));
    assert_eq!(claim("latex")["condition"], "\\lambda = 1");
}

#[test]
fn parameters_are_put_in_before_the_map_is_reduced() {
    let shown = |subject: Subject| answer(&study(subject), json!({"ask": "show"}));
    let put_in = shown(Subject::named("e9").with("xi", Rational::from(1)));
    assert_eq!(put_in["parameters"], json!([]));
    assert_eq!(put_in["map"], shown(Subject::named("e3"))["map"]);
    let nowhere = study(Subject::text("xdot = x/(a - b);").with("a", one()).with("b", one()));
    let error = nowhere.ask(&Question::Show(Show::default()), &Unwatched).expect_err("a mistake");
    assert!(error.to_string().contains("divides by zero at a = 1, b = 1"), "{error}");
}

#[test]
fn claims_of_a_field_hold_or_not() {
    let field =
        "xdot = a*y; ydot = -a*x; integral H = x^2 + y^2; integral L = x when a = 0; integral Z = a*x*y;";
    let verdicts = |subject: Subject| answer(&study(subject), json!({"ask": "verify"}));
    let of_field = verdicts(Subject::text(field));
    let outcomes: Vec<&Value> =
        of_field["claims"].as_array().expect("a list").iter().map(|claim| &claim["outcome"]).collect();
    assert_eq!(json!([outcomes, of_field["failed"]]), json!([["proved", "proved", "failed"], 1]));
    assert_eq!(of_field["claims"][0]["id"], "field.H");
    assert_eq!(of_field["claims"][0]["detail"], "by normal forms over Q, and modulo primes");
    let put_in = verdicts(Subject::text(field).with("a", one()));
    assert_eq!(put_in["claims"].as_array().map(Vec::len), Some(2));
    // With a given parameter, the field's own claims are checked instead of the paper's.
    assert_eq!(verdicts(Subject::named("e9").with("xi", one()))["claims"][1]["id"], "e9.H3");
    let of_paper = verdicts(Subject::named("lagrange"));
    assert_eq!([&of_paper["failed"], &of_paper["claims"][0]["system"]], [&json!(0), &json!("lagrange")]);
}

#[test]
fn a_claim_that_is_changed_fails() {
    let mutate = Verify { mutate: true };
    let swing = |claim: &str| study(Subject::text(format!("xdot = y; ydot = -x; {claim}")));
    let mutated = json!(mutate.ask(&swing("integral H = x^2 + y^2;"), &Unwatched).expect("an answer"));
    assert_eq!(mutated["survived"], 0);
    assert_eq!(mutated["mutations"][0]["id"], "field.H");
    assert!(matches!(mutate.ask(&swing("integral H = x;"), &Unwatched), Err(StudyError::Field(_))));
}
