//! Numbers in many notations, and huge inputs.

use crate::running::{answer, kahan, object, refusal, text};

#[test]
fn numbers_are_read_as_people_type_them() {
    let at = |eps: &str, at: &str| object(&["eval", "lv", "--eps", eps, "--at", at, "--json"]);
    assert_eq!(at(".1", ".5,5."), at("1/10", "1/2,5"));
    assert_eq!(at("-.1", "+.5,1_000"), at("-0.1", "0.5,1000"));
    let horizon = [
        "trade",
        "e6",
        "--at",
        "1,.5,.25",
        "--horizon",
        ".5",
        "--tolerance",
        ".1",
        "--seconds",
        "20",
        "--json",
    ];
    assert_eq!(object(&horizon)["horizon"], 0.5);
}

#[test]
fn counts_may_have_an_exponent() {
    let orbit = |steps: &str| answer(&["orbit", "e6", "--eps", ".05", "--at", "1,2,3", "--steps", steps]);
    assert_eq!(orbit("1e2").lines().count(), 102);
    assert_eq!(orbit("1e2"), orbit("100"));
    let every = ["orbit", "e6", "--eps", ".05", "--at", "1,2,3", "--steps", "1e3", "--every", "1e2"];
    assert_eq!(answer(&every).lines().count(), 12);
    let heights =
        ["heights", "e6", "--eps", "1/2", "--at", "1,2,3", "--steps", "1e1", "--digits", "1e6", "--json"];
    assert_eq!(object(&heights)["steps"], 10);
    let extremes = ["extremes", "e1", "--trials", "1e2", "--seed", "1e1", "--random-fields", "0", "--json"];
    assert_eq!((&object(&extremes)["trials"], &object(&extremes)["seed"]), (&100.into(), &10.into()));
    assert_eq!(
        object(&["scan", "lv", "--eps", "1:2:+1", "--degree", "4e0", "--json"])["generic"]["hilbert"][3],
        15
    );
}

#[test]
fn what_is_no_count_is_told_so() {
    let orbit = |option: &str, value: &str| {
        let steps: &[&str] = if option == "--steps" { &[] } else { &["--steps", "1"] };
        refusal(&[&["orbit", "e6", "--eps", "1", "--at", "1,2,3", option, value], steps].concat())
    };
    for option in ["--steps", "--every"] {
        for value in ["1.5", "-3", "ten", ""] {
            let said = orbit(option, value);
            assert!(said.contains("whole number") && said.contains("1e3") && said.contains(option), "{said}");
        }
        let said = orbit(option, "1e400");
        assert!(said.contains("too large") && said.contains("9223372036854775807"), "{said}");
    }
    for (option, value) in
        [("--trials", "0"), ("--seed", "-1"), ("--random-fields", "-1"), ("--trials", "1e20")]
    {
        let said = refusal(&["extremes", "e1", option, value]);
        assert!(
            said.contains(option) && (said.contains("whole number") || said.contains("too large")),
            "{said}"
        );
    }
    let said = refusal(&["eval", "lv", "--eps", "1e99999", "--at", "1,1"]);
    assert!(said.contains("4096"), "{said}");
}

const LONGEST: usize = 900;

#[test]
fn huge_arguments_are_quoted_shortened() {
    let word = "x".repeat(100_000);
    let words = "x y, ".repeat(20_000);
    let digits = "9".repeat(100_000);
    for huge in [&word, &words, &digits] {
        let parameter = format!("{huge}=1");
        let value = format!("xi={huge}x");
        let runs: Vec<Vec<&str>> = vec![
            vec![huge],
            vec!["show", huge],
            vec!["verify", "--system", huge],
            vec!["show", "e7", "--param", huge],
            vec!["show", "e7", "--param", &parameter],
            vec!["show", "e7", "--param", &value],
            vec!["show", "--file", huge],
            vec!["show", "e7", huge],
            vec!["show", "--file", "Cargo.toml", "--block", huge],
            vec!["show", "--field", huge],
            vec!["eval", "lv", "--eps", "1e400x", "--at", huge],
            vec!["orbit", "lv", "--eps", "1", "--at", "1,1", "--steps", huge],
            vec!["orbit", "lv", "--eps", "1", "--at", "1,1", "--steps", "1", "--scalar", huge],
            vec!["heights", "lv", "--eps", huge, "--at", "1", "--steps", "1"],
            vec!["trade", "lv", "--at", "1,1", "--horizon", "1", "--seconds", huge],
            vec!["scan", "lv", "--eps", huge],
            vec!["completions", huge],
        ];
        for arguments in &runs {
            let said = refusal(arguments);
            let count = said.chars().count();
            assert!(count < LONGEST, "{:?}: {count} characters: {said}", &arguments[..arguments.len() - 1]);
        }
    }
    let output = kahan(&["orbit", "lv", "--eps", "1e400", "--at", "1,1", "--steps", "1"]);
    let said = text(&output.stderr);
    assert!(said.contains("beyond the range of f64") && said.len() < LONGEST, "{said}");
}

#[test]
fn huge_files_are_quoted_shortened() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("field.txt");
    let file = file.to_str().expect("text");
    let name = "n".repeat(300_000);
    let terms = (0..10_000).map(|k| format!("{k}*x*y")).collect::<Vec<_>>().join(" + ");
    let unknown = (0..10_000).map(|k| format!("q{k}")).collect::<Vec<_>>().join(" + ");
    let fields = [
        format!("xdot = x^3*{name};"),
        format!("{name} = x;"),
        format!("struct {name} {{ a }} xdot = a*"),
        format!("struct S {{ {name} }} xdot = x;"),
        format!("xdot = {name}(x);"),
        format!("xdot = {name}.y;"),
        format!("struct S; xdot = {name};"),
        format!("xdot = {terms} + x^3; ydot = x;"),
        format!("xdot = x^3 + {terms}; ydot = x;"),
        format!("struct S; xdot = {unknown}; ydot = x;"),
        format!("xdot = x; integral {name} = x;"),
        format!("xdot = x; bracket P {{ {{{name}, x}} = 1; }}"),
        format!("xdot = {}x;", "1".repeat(300_000)),
        format!("xdot = x*{}1{};", "(".repeat(100_000), ")".repeat(100_000)),
        format!("{name}dot = 1; integral H = {name};"),
        "\u{1F600}".repeat(100_000),
    ];
    for field in &fields {
        std::fs::write(file, field).expect("a file");
        let said = refusal(&["show", "--file", file]);
        let beginning: String = field.chars().take(40).collect();
        let mistakes = said.matches("error: ").count();
        assert!(mistakes <= 9, "{beginning}…: {mistakes} mistakes");
        // Each mistake is reported with its position, its line and help.
        assert!(
            said.chars().count() < mistakes * 1_300,
            "{beginning}…: {} characters: {said}",
            said.chars().count()
        );
        for line in said.lines().filter(|line| line.contains(" | ")) {
            assert!(line.chars().count() <= 80, "{beginning}…: {line}");
        }
        let lines: Vec<&str> = said.lines().collect();
        for pair in
            lines.windows(2).filter(|pair| pair[1].trim_start().starts_with("| ") && pair[1].contains('^'))
        {
            let place = pair[1].find('^').expect("a caret");
            assert!(
                pair[0].chars().count() > place,
                "the caret stands behind its line: {}\n{}",
                pair[0],
                pair[1]
            );
        }
    }
}
