//! Tests `kahan lift`, and `--lift` in other commands.

use serde_json::Value;

use crate::painting::painted;
use crate::running::{answer, kahan, refusal, text};

const PENDULUM: &str = "xdot = v; vdot = -sin(x);";
const KEPLER: &str = "x'' = -x/(x^2+y^2)^(3/2), y'' = -y/(x^2+y^2)^(3/2)";
const FITZHUGH_NAGUMO: &str = "v' = v - v^3/3 - w + 1/2, w' = (v + 0.7 - 0.8*w)*0.08";

fn lifted(field: &str, more: &[&str]) -> Value {
    let output = kahan(&[&["lift", "--field", field, "--json"][..], more].concat());
    assert_eq!(output.status.code(), Some(0), "{field}: {}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("one object")
}

fn rows(arguments: &[&str]) -> (String, Vec<Vec<f64>>) {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    let printed = text(&output.stdout);
    let mut lines = printed.lines();
    let heading = lines.next().expect("a heading").to_owned();
    let numbers = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    (heading, lines.map(numbers).collect())
}

fn fates(object: &Value) -> Vec<&str> {
    let relations = object["relations"].as_array().expect("a list");
    relations.iter().map(|relation| relation["along"].as_str().unwrap_or("null")).collect()
}

#[test]
fn mechanical_systems_keep_an_energy() {
    for (field, at, order) in [
        (PENDULUM, "1,0", 2),
        (KEPLER, "1,0,0,1.1", 6),
        ("x' = v, v' = -2*(1-exp(-x))*exp(-x)", "0.3,0", 2),
        ("x' = v, v' = x - x^3", "0.3,0", 3),
    ] {
        let object = lifted(field, &["--at", at]);
        assert!(object["order"].as_u64() <= Some(order), "{field}: {object}");
        assert!(object["energy"].is_string(), "{field}: {object}");
        let (heading, rows) =
            rows(&["orbit", "--lift", "--field", field, "--at", at, "--eps", "0.01", "--steps", "500"]);
        let energy = heading.split(',').position(|name| name == "energy").expect("a column");
        let drift = |row: &Vec<f64>| (row[energy] - rows[0][energy]).abs();
        assert!(rows.iter().map(drift).fold(0.0, f64::max) < 1e-12, "{field}");
    }
}

#[test]
fn an_orbit_is_in_the_original_variables() {
    let orbit = ["orbit", "--lift", "--field", PENDULUM, "--at", "1,0", "--eps", "0.05", "--steps", "20"];
    let (heading, own) = rows(&orbit);
    assert!(heading.starts_with("n,t,x,v,energy"), "{heading}");
    let (heading, all) = rows(&[&orbit[..], &["--all"]].concat());
    assert!(heading.starts_with("n,t,x,v,sin_x,cos_x,energy"), "{heading}");
    assert_eq!((all[0][4], all[0][5]), (1.0_f64.sin(), 1.0_f64.cos()));
    assert!(own.iter().zip(&all).all(|(own, all)| own[..4] == all[..4]));
    let block = answer(&["lift", "--macro", "--field", PENDULUM]);
    let at = format!("1,0,{},{}", all[0][4], all[0][5]);
    let (_, of_block) = rows(&["orbit", "--field", &block, "--at", &at, "--eps", "0.05", "--steps", "20"]);
    assert_eq!(of_block, all);
}

#[test]
fn what_is_printed_as_a_block_is_proved() {
    for field in [
        PENDULUM,
        KEPLER,
        FITZHUGH_NAGUMO,
        "struct Duffing { d } xdot = v; vdot = x - x^3 - d*v + cos(2*t);",
        "s' = -k*s/(K+s)",
        "x' = s/(1 + y^2) - x, y' = s/(1 + x^2) - y",
    ] {
        let output = kahan(&["lift", "--macro", "--field", field]);
        let block = text(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{field}: {}", text(&output.stderr));
        let output = kahan(&["verify", "--field", &block, "--json"]);
        let object: Value = serde_json::from_slice(&output.stdout).expect("one object");
        let claims = object["claims"].as_array().expect("a list");
        assert_eq!(claims.len(), block.matches("integral").count(), "{block}");
        let is_proved = |claim: &Value| claim["outcome"].as_str().is_some_and(|of| of.starts_with("proved"));
        assert!(claims.iter().all(is_proved) && object["failed"] == 0, "{object}");
    }
}

#[test]
fn the_form_of_fitzhugh_and_nagumo_is_one_that_decays() {
    let object = lifted(FITZHUGH_NAGUMO, &["--at", "1,0"]);
    assert_eq!((object["order"].as_u64(), fates(&object)), (Some(1), vec!["decays"]));
    let rate = object["relations"][0]["rate"].as_f64().expect("a rate");
    assert!(rate < -1.0, "{rate}");
}

#[test]
fn relations_are_kept_bounded_or_drift() {
    assert_eq!(fates(&lifted("x' = y, y' = (1 - x^2)*y - x", &["--at", "1,0"])), ["kept"]);
    assert_eq!(fates(&lifted(PENDULUM, &["--at", "1,0"])), ["kept", "bounded", "bounded"]);
    assert_eq!(fates(&lifted(PENDULUM, &[])), ["kept", "null", "null"]);
    assert!(fates(&lifted(KEPLER, &["--at", "1,0,0,1.1"])).contains(&"drifts"));
}

#[test]
fn errors_of_relations_are_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("relations.svg");
    let out = out.to_str().expect("UTF-8");
    answer(&["lift", "--field", PENDULUM, "--at", "1,0", "--out", out]);
    let drawn = std::fs::read_to_string(out).expect("the file");
    assert!(painted(&drawn) > 15 && drawn.contains("sin_x = sin("), "{drawn}");
    let refused = refusal(&["lift", "--field", PENDULUM, "--out", out]);
    assert!(refused.contains("give --at"), "{refused}");
}

#[test]
fn new_variables_are_set_in_latex() {
    let latex = answer(&["lift", "--latex", "--field", "x' = -x + tanh(x) + x^(1/5)"]);
    assert!(latex.contains("\\operatorname{tanh}\\left(x\\right)"), "{latex}");
    let latex = answer(&["lift", "--latex", "--field", "xdot = v; vdot = -x/sqrt(1 + x^2);"]);
    assert!(latex.contains("\\sqrt{x^{2} + 1}") && !latex.contains(" sqrt("), "{latex}");
}

#[test]
fn time_is_the_column_t() {
    let duffing = "xdot = v; vdot = x - x^3 + cos(2*t);";
    let orbit =
        ["orbit", "--lift", "--field", duffing, "--at", "1,0", "--eps", "1/20", "--steps", "9", "--t0", "3"];
    let (heading, rows) = rows(&orbit);
    assert!(heading.starts_with("n,t,x,v,"), "{heading}");
    assert!((rows[9][1] - 3.9).abs() < 1e-12, "{rows:?}");
    let object = lifted(duffing, &["--lift=smallest"]);
    let names: Vec<&str> = object["variables"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    assert_eq!(names[..3], ["x", "v", "t"]);
    assert_eq!(object["order"], 3);
}

#[test]
fn other_commands_take_points_in_the_original_variables() {
    let lifted = ["--lift", "--field", PENDULUM];
    let section = ["section", "--at", "1,0", "--eps", "0.05", "--steps", "300", "--plane", "v"];
    let (heading, crossings) = rows(&[&section[..], &lifted].concat());
    assert_eq!(heading, "n,t,x,v");
    assert!(crossings.len() > 2 && crossings.iter().all(|row| row[3].abs() < 1e-9), "{crossings:?}");
    let dynamics = ["dynamics", "--at", "1,0", "--eps", "0.05", "--steps", "300", "--json"];
    let object: Value = serde_json::from_str(&answer(&[&dynamics[..], &lifted].concat())).unwrap();
    let extrema: Vec<&String> = object["extrema"].as_object().unwrap().keys().collect();
    assert_eq!(extrema, ["x", "v"]);
    let refused = refusal(&[&["orbit", "--at", "1", "--eps", "1", "--steps", "1"][..], &lifted].concat());
    assert!(refused.contains("2 coordinates x,v expected"), "{refused}");
}

#[test]
fn a_parameter_that_is_only_in_a_start_is_kept() {
    let field = "x' = sin(x + K)";
    let start = ["orbit", "--lift", "--all", "--field", field, "--eps", "0.1", "--steps", "1", "--at", "1"];
    let (heading, rows) = rows(&[&start[..], &["--param", "K=1/2"]].concat());
    let sine = heading.split(',').position(|name| name.starts_with("sin")).expect("a column");
    assert!((rows[0][sine] - 1.5_f64.sin()).abs() < 1e-15, "{heading}: {rows:?}");
    assert!(refusal(&start).contains("--param K=VALUE"));
}

#[test]
fn what_cannot_be_lifted_is_refused_with_the_reason() {
    let refused = refusal(&["lift", "--field", "xdot = abs(x);"]);
    assert!(refused.contains("corner") && refused.contains("^^^^^^"), "{refused}");
    let refused = refusal(&["lift", "--field", "xdot = x;", "--lift=energy"]);
    assert!(refused.contains("mechanical"), "{refused}");
    let pole = ["orbit", "--lift", "--field", "x' = 1/x", "--at", "0", "--eps", "0.1", "--steps", "1"];
    assert!(refusal(&pole).contains("has no value there"));
    assert!(
        refusal(&["orbit", "e1", "--all", "--at", "1,1,1", "--eps", "1", "--steps", "1"]).contains("--lift")
    );
}

#[test]
fn functions_that_are_not_lifted_name_the_way_out() {
    for (side, wanted) in [
        ("-|x|", "has a corner"),
        ("-min(x, 1)", "has a corner or a jump"),
        ("if(x > 0, 1, -1)", "no conditions"),
        ("x > 0 ? 1 : -1", "no conditions"),
        ("x(t-1)", "a state at another time"),
        ("erf(x)", "Edot = c*exp(-u^2)*udot"),
        ("gamma(x)", "no algebraic differential equation"),
        ("log2(x)", "1.4426950408889634"),
        ("acos(x)", "pi/2 - asin(u)"),
        ("-e^x", "write `exp(…)`"),
        ("-sin^2(x)", "write `sin(…)^2`"),
        ("sigmoid(x)", "1/(1 + exp(-u))"),
    ] {
        let refused = refusal(&["lift", "--field", &format!("xdot = {side};")]);
        assert!(refused.contains(wanted), "{side}: {refused}");
    }
    let family = "for i in periodic { x[i]dot = v[i]; v[i]dot = -sin(x[i]); }";
    assert!(refusal(&["lift", "--field", family]).contains("a fixed number of variables"));
    let root = lifted("xdot = -x^sqrt(2);", &[]);
    assert_eq!(root["new"][0]["expression"], "x^(sqrt_2)/x");
}

#[test]
fn pi_is_the_number_where_numbers_are_needed() {
    let field = "xdot = v; vdot = -sin(pi*x);";
    let start =
        ["orbit", "--lift", "--all", "--field", field, "--at", "1/6,0", "--eps", "0.1", "--steps", "1"];
    let (heading, rows) = rows(&start);
    let sine = heading.split(',').position(|name| name == "sin_pix").expect("a column");
    assert!((rows[0][sine] - 0.5).abs() < 1e-15, "{rows:?}");
}

#[test]
fn claims_of_lifts_may_name_constants() {
    let claim = "integral H = v^2/2 - k*cos_x - eps^2*k^2*sin_x^2/2;";
    let object = lifted(&format!("const k = 2; xdot = v; vdot = -k*sin(x); {claim}"), &[]);
    assert!(object["field"].as_str().is_some_and(|field| field.contains("const k = 2;")), "{object}");
    let refused =
        refusal(&["lift", "--field", "const F = sin(x); xdot = v; vdot = -F; integral H = v^2 - F;"]);
    assert!(refused.contains("`F` holds a function"), "{refused}");
}

#[test]
fn pictures_draw_integrals_and_formulas() {
    let file = std::env::temp_dir().join(format!("kahan-lifted-axes-{}.svg", std::process::id()));
    let out = file.to_str().expect("a path");
    let picture = |axes| {
        let start =
            ["picture", "--lift", "--field", PENDULUM, "--at", "1,0", "--eps", "0.1", "--steps", "20"];
        [&start[..], &["--out", out, "--axes", axes]].concat()
    };
    for axes in ["t,energy", "x,R1", "t,sin_x", "t,sin_x-sin(x)"] {
        let output = kahan(&picture(axes));
        assert_eq!(output.status.code(), Some(0), "{axes}: {}", text(&output.stderr));
        let drawn = std::fs::read_to_string(&file).expect("a picture");
        assert!(drawn.contains(axes.split_once(',').unwrap().1.split('_').next().unwrap()), "{axes}");
    }
    std::fs::remove_file(&file).expect("a picture");
    assert!(refusal(&picture("x,foo")).contains("no variable or integral"));
}

#[test]
fn what_is_not_quadratic_names_the_call_that_lifts() {
    for field in ["xdot = x^3;", "xdot = sin(x);", "xdot = 1/x;", "xdot = x^n;"] {
        let refused = refusal(&["show", "--field", field]);
        assert!(refused.contains("`kahan lift`") && refused.contains("not-quadratic.md"), "{refused}");
    }
}
