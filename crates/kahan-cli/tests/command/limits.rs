//! Tests that the table of limits in the language reference agrees with the command.

use kahan_runtime::MOST_DIGITS_OF_CYCLES;

use crate::running::refusal;

const REFERENCE: &str = include_str!("../../../../kahan-core/docs/language.md");

fn table() -> Vec<(&'static str, u64)> {
    let (_, section) = REFERENCE
        .split_once("\nThe commands that answer questions about a field have limits, too.\n")
        .expect("the table");
    let rows = section.lines().skip_while(|line| !line.starts_with("|---")).skip(1);
    let rows = rows.take_while(|line| line.starts_with('|')).map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [what, limit] = cells[..] else { panic!("two cells: {row}") };
        (what, limit.replace(' ', "").parse().expect("a number"))
    });
    rows.collect()
}

fn ring(variables: usize) -> String {
    (0..variables).map(|k| format!("x{k}dot = x{};", (k + 1) % variables)).collect()
}

#[test]
fn every_limit_of_a_question_is_that_of_its_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let (rows, out) = (path("rows.csv"), path("out.svg"));
    std::fs::write(&rows, "a,b,sali\n0,0,1\n1,1,2\n").expect("a file");
    let (large, nine, four, ones) = (ring(501), ring(9), ring(4), ["1"; 9].join(","));
    let products: Vec<String> =
        (0..9000).map(|k| format!("{}*x{}*x{}", k % 7 + 2, k / 87, k % 200)).collect();
    let dense = format!("x0dot = {}; {}", products.join(" + "), &ring(200)["x0dot = x1;".len()..]);
    let chain = ["--field", "for i in periodic { x[i]dot = x[i+1]; }"];
    let scanned = ["--field", "xdot = a*y + b; ydot = c*x + b*y^2;"];
    let charted =
        ["chart", "--field", "xdot = a*y; ydot = -b*x;", "--eps", "0.1", "--at", "1,1", "--out", &out];
    let pictured = ["picture", "e6", "--eps", "1/20", "--at", "1,2,3", "--out", &out];
    let lv = |command| [command, "lv", "--eps", "0.1", "--at", "0.6,1"];
    let beyond_doubles = ["--steps", "9007199254740993"];
    let calls: [(&str, Vec<&str>); 22] = [
        ("variables of a chain that", [&["show"], &chain[..], &["--sites", "201"]].concat()),
        (
            "numbers of the state of a chain",
            [&["orbit"], &chain[..], &["--sites", "1e9", "--start", "1", "--eps", "0.1", "--steps", "1"]]
                .concat(),
        ),
        ("variables of a field whose matrices", vec!["show", "--field", &large]),
        ("tokens of an expansion", vec!["show", "--field", &dense, "--expand"]),
        (
            "variables of an orbit through poles",
            vec!["orbit", "--field", &nine, "--eps", "0.1", "--at", &ones, "--steps", "2", "--projective"],
        ),
        ("steps of an orbit that", [&lv("dynamics")[..], &beyond_doubles].concat()),
        ("period that", [&lv("periodic")[..], &["--period", "201"]].concat()),
        (
            "numbers of a cycle",
            vec!["periodic", "--field", &four, "--eps", "0.1", "--at", "1,1,1,1", "--period", "200"],
        ),
        (
            "steps of a cycle of the flow",
            [&lv("periodic")[..], &["--free", "eps", "--period", "1000001"]].concat(),
        ),
        (
            "numbers of a cycle of the flow",
            [&lv("periodic")[..], &["--free", "eps", "--period", "900000"]].concat(),
        ),
        (
            "orbits of `orbit --over`",
            [
                &["orbit", "--field", "xdot = a*y; ydot = -b*x;", "--eps", "0.1", "--at", "1,1"][..],
                &["--steps", "1", "--over", "a=0:1:2000", "--over", "b=0:1:2000"],
            ]
            .concat(),
        ),
        ("values of a range", vec!["scan", "e7", "--param", "xi=0:1:100001"]),
        ("cells of a grid", [&charted[..], &["--over", "a=0:1:5000", "--over", "b=0:1:5000"]].concat()),
        (
            "steps of each orbit of a chart",
            [&charted[..], &["--over", "a=0:1:5", "--steps", "1e15"]].concat(),
        ),
        (
            "cells of a chart of the rows",
            vec!["chart", "--from", &rows, "--over", "a=0:1:/10000", "--over", "b=0:1:/10000", "--out", &out],
        ),
        ("first points of a picture", [&pictured[..], &["--steps", "9", "--starts", "100001"]].concat()),
        ("points of a picture", [&pictured[..], &["--steps", "1e8"]].concat()),
        ("points of a picture that", [&pictured[..], &["--steps", "1e6", "--lines"]].concat()),
        (
            "points of a grid that",
            [
                &["scan"],
                &scanned[..],
                &["--param", "a=0:1:101", "--param", "b=0:1:101", "--param", "c=0:1:101"],
            ]
            .concat(),
        ),
        ("variables of a field that `discover`", vec!["discover", "--field", &large]),
        ("monomials of a relation", vec!["discover", "lv", "--degree", "90"]),
        ("steps that `poles`", vec!["poles", "lv", "--steps", "101"]),
    ];
    let mut rows = table();
    let mut limit = |what: &str| {
        let place = rows.iter().position(|row| row.0 == what);
        let place = place.or_else(|| rows.iter().position(|row| row.0.starts_with(what)));
        rows.remove(place.unwrap_or_else(|| panic!("no row `{what}`"))).1
    };
    for (what, call) in calls {
        let (limit, said) = (limit(what), refusal(&call));
        let numbers = said.split(|c: char| !c.is_ascii_digit());
        let has_it = numbers.filter_map(|number| number.parse().ok()).any(|number: u64| number == limit);
        assert!(has_it, "{what}: {limit}: {said}");
    }
    assert_eq!(limit("digits of a coordinate"), MOST_DIGITS_OF_CYCLES);
    assert_eq!(rows, [], "these rows have no test");
}
