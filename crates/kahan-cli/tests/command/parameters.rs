//! Values of parameters, and undeclared names.

use serde_json::json;

use crate::running::{answer, kahan, object, refusal, text};

#[test]
fn are_put_in_before_the_map_is_reduced() {
    // E9 at ξ = 1 is E3, in whose map the factor 1 + eps*z cancels.
    let special = object(&["show", "e9", "--param", "xi=1", "--json"]);
    let e3 = object(&["show", "e3", "--json"]);
    for key in ["field", "A", "map"] {
        assert_eq!(special[key], e3[key], "{key}");
    }
    assert_eq!(special["parameters"], json!([]));
}

#[test]
fn turn_their_conditions_into_nothing_and_drop_the_others() {
    let block = answer(&["show", "e9", "--param", "xi=-1", "--macro"]);
    assert!(block.contains("integral H4 = ") && !block.contains("H3") && !block.contains("when"), "{block}");
    assert_eq!(block.matches("density").count(), 1, "{block}");
    let report = object(&["verify", "e9", "--param", "xi=-1", "--json"]);
    assert_eq!(report["failed"], 0);
}

#[test]
fn may_not_make_the_field_divide_by_zero() {
    let paragraph = refusal(&["show", "--field", "xdot = x/(a - 1);", "--param", "a=1"]);
    assert!(paragraph.contains("a = 1") && paragraph.contains("divides by zero"), "{paragraph}");
}

fn said(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stderr)
}

#[test]
fn that_nothing_declares_are_said_once_by_every_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let k = "note: k is taken as a parameter: nothing defines kdot\n";
    for arguments in [
        &["show"][..],
        &["show", "--json"],
        &["show", "--macro"],
        &["verify"],
        &["discover", "--seconds", "1"],
        &["poles", "--seconds", "1", "--json"],
    ] {
        assert_eq!(said(&[arguments, &["--field", "xdot = k*x;"]].concat()), k, "{arguments:?}");
    }
    assert_eq!(
        said(&["show", "--field", "xdot = x^2*y^2 + z;"]),
        "note: y, z are taken as parameters: nothing defines ydot, zdot\n"
    );
    assert_eq!(
        said(&["show", "--field", "xdot = pi*x + E;"]),
        "note: numbers are exact: pi is the parameter `pi` with the value 3.141592653589793\n\
         note: E is taken as a parameter: nothing defines Edot; `const E = 2.718281828459045;` is the number\n"
    );
    let family = ["show", "--sites", "3", "--field", "for i in periodic { x[i]dot = k*x[i]*x[i+1]; }"];
    assert_eq!(said(&family), k);
    assert!(refusal(&["show", "--field", "xdot = t*x;"]).contains("write one more equation, `tdot = 1;`"));
    // A name that has a value or is declared causes no note that it is taken as a parameter.
    let lv = "xdot = a*x*(1 - y); ydot = y*(x - 1);";
    let of_lv = ["--field", lv, "--at", "1,2"];
    for arguments in [
        &["show", "--field", "xdot = k*x;", "--param", "k=2"][..],
        &["show", "--field", "struct S { t } xdot = t*x;"],
        &["show", "--field", "const t = 2; xdot = t*x;"],
        &["show", "e9"],
        &[&["eval", "--eps", "1/9", "--param", "a=1"], &of_lv[..]].concat(),
        &[
            &[
                "picture",
                "--eps",
                "1/9",
                "--over",
                "a=1:2:+1/3",
                "--axes",
                "x",
                "--steps",
                "9",
                "--out",
                &file("a.svg"),
            ],
            &of_lv[..],
        ]
        .concat(),
    ] {
        assert_eq!(said(arguments), "", "{arguments:?}");
    }
    let program = file("lv.rs");
    std::fs::write(&program, "fn f(a: f64) { let field = kahan! { xdot = a*x*y; ydot = x; }; }")
        .expect("a file");
    assert_eq!(said(&["show", "--file", &program]), "");
    let plain = file("t.txt");
    std::fs::write(&plain, "xdot = k*x;").expect("a file");
    assert_eq!(said(&["show", "--file", &plain]), k);
    let wrong = refusal(&["show", "--field", "xdot = k*x^3;"]);
    assert!(wrong.contains("degree 3") && wrong.ends_with(k), "{wrong}");
    assert!(!refusal(&["eval", "--field", "xdot = k*x;", "--eps", "1", "--at", "1"]).contains("note"));
}

#[cfg(unix)]
#[test]
fn that_nothing_declares_are_said_of_standard_input() {
    let run = std::process::Command::new("sh")
        .args(["-c", "echo 'xdot = k*x;' | \"$KAHAN\" show --file - --json"])
        .env("KAHAN", env!("CARGO_BIN_EXE_kahan"))
        .output()
        .expect("a shell");
    assert_eq!(text(&run.stderr), "note: k is taken as a parameter: nothing defines kdot\n");
}
