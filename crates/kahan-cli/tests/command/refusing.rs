//! Refusals of wrong input.

use crate::running::refusal;

use kahan_algebra::lexer::lex;
use kahan_algebra::read;
use kahan_algebra::render::report;

#[test]
fn bad_input_says_what_to_write_instead() {
    let at = |rest: &[&'static str]| [&["eval"], rest].concat();
    let cases: [(Vec<&str>, &[&str]); 26] = [
        (at(&["eulr", "--eps", "1", "--at", "1,2,3"]), &["`eulr`", "`euler`", "e9"]),
        (at(&["e1", "--eps", "one", "--at", "1,2,3"]), &["--eps", "`one`", "3/7"]),
        (at(&["e1", "--eps", "1/0", "--at", "1,2,3"]), &["--eps", "divides by zero"]),
        (at(&["e1", "--eps", "1", "--at", "1,two,3"]), &["coordinate y", "`two`"]),
        (at(&["e1", "--eps", "1", "--at", "1,2"]), &["3 coordinates x,y,z expected, 2 given"]),
        (at(&["e7", "--eps", "1", "--at", "1,2,3"]), &["--param xi=VALUE"]),
        (at(&["euler", "--eps", "1", "--at", "1,2,3", "--param", "a2=1"]), &["a1=VALUE", "a3=VALUE"]),
        (at(&["e7", "--eps", "1", "--at", "1,2,3", "--param", "mu=1"]), &["`mu`", "xi"]),
        (at(&["e7", "--eps", "1", "--at", "1,2,3", "--param", "xi"]), &["NAME=VALUE"]),
        (at(&["e7", "--eps", "1", "--at", "1,2,3", "--param", "xi=1", "--param", "xi=1"]), &["twice"]),
        (
            at(&["--field", "xdot = x/a;", "--eps", "1", "--at", "1", "--param", "a=0"]),
            &["divides by zero at a = 0"],
        ),
        (at(&["e1", "--field", "xdot = x;", "--eps", "1", "--at", "1"]), &["one field at a time", "`e1`"]),
        (at(&["--field", "xdot = a;", "--param", "a", "0.4", "--eps", "1", "--at", "1"]), &["--param a=0.4"]),
        (at(&["e7", "--param", "xi", "0.4", "--eps", "1", "--at", "1,2,3"]), &["'0.4'", "--param a=0.4"]),
        (
            at(&["e1", "--eps", "1", "--at", "1", "0.5", "-0.3"]),
            &["'0.5'", "--at 1,0.5,0.3", "`kahan eval --help`"],
        ),
        (at(&["e1", "--eps", "1", "--at", "1", "-0.5"]), &["--at 1,0.5,0.3"]),
        (
            at(&["e1", "--h", "0.05", "--at", "1,2,3"]),
            &["'--h'", "--dt is the time step", "--eps half of it"],
        ),
        (
            at(&["e1", "--dt", "0.05", "--eps", "1", "--at", "1,2,3"]),
            &["'--dt <T>' cannot be used with '--eps <E>'"],
        ),
        (at(&["e1", "--dt", "a", "--at", "1,2,3"]), &["--dt: `a` is not an exact number"]),
        (at(&["--field", "dx = y; ydot = -x;", "--eps", "1", "--at", "1,2"]), &["write `xdot = …`"]),
        (at(&["e1", "--eps", "1"]), &["from which point", "--at x,y,z"]),
        (at(&["--file", "no/such/file", "--eps", "1", "--at", "1"]), &["no/such/file"]),
        (at(&["--eps", "1", "--at", "1"]), &["which system"]),
        (at(&["e1", "--at", "1,2,3"]), &["--eps"]),
        (
            at(&["e1", "--eps", "1", "--at", "1,2,3", "--scalar", "f16"]),
            &["'f16'", "exact, f32, f64, dd]; `kahan"],
        ),
        (vec!["evall"], &["evall", "eval", "`kahan --help`"]),
    ];
    for (arguments, expected) in &cases {
        let paragraph = refusal(arguments);
        for part in *expected {
            assert!(paragraph.contains(part), "{arguments:?} does not say {part}: {paragraph}");
        }
    }
}

#[test]
fn every_mistake_in_a_field_is_reported_with_the_text_of_the_front_end() {
    let field = "xdot = x^3;\nydot = sin(y) + 2x;\nzdot = w*;\n";
    let lexed = lex(field);
    let reading = read(&lexed.tokens);
    let expected: String =
        reading.diagnostics().iter().map(|one| report(one, field, &lexed.ranges, "--field")).collect();
    assert!(reading.diagnostics().len() >= 3, "{expected}");
    for command in ["show", "verify"] {
        assert_eq!(refusal(&[command, "--field", field]), expected);
    }
}

#[test]
fn a_false_claim_is_shown_by_nobody() {
    let paragraph = refusal(&["show", "--field", "xdot = y; ydot = -x; integral H = x^2 + 2*y^2;"]);
    assert!(paragraph.contains("`H` does not hold") && paragraph.contains('^'), "{paragraph}");
}
