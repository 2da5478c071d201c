//! Tests `kahan discover` and `kahan scan`, whose results are proved again.

use kahan_algebra::check::Checked;
use kahan_algebra::{lexer, read};
use kahan_discover::orbits::hilbert::default_degree;
use kahan_systems::registry::{FURTHER, all, find};
use serde_json::{Value, json};

use crate::running::{answer, refusal};

fn object(arguments: &[&str]) -> Value {
    serde_json::from_str(&answer(&[arguments, &["--json"]].concat())).expect("one JSON object")
}

fn texts(value: &Value) -> Vec<String> {
    let all = value.as_array().expect("a list").iter();
    all.map(|text| text.as_str().expect("a text").to_owned()).collect()
}

fn reading(field: &str, lines: &[String]) -> Checked {
    let reading = read(&lexer::lex(&format!("{field} {}", lines.join(" "))).tokens);
    assert!(reading.diagnostics().is_empty(), "{field} {lines:?}: {:?}", reading.diagnostics());
    reading
}

const WEIERSTRASS: &str = "xdot = y; ydot = 6*x^2 - a;";

#[test]
fn every_key_is_there_and_says_what_was_found() {
    let found = object(&["discover", "--field", WEIERSTRASS]);
    assert_eq!(found["system"], "field");
    assert_eq!(found["variables"], json!(["x", "y"]));
    assert_eq!((&found["parameters"], &found["eps"]), (&json!({ "a": null }), &Value::Null));
    assert_eq!(found["hilbert"], json!([3, 6, 9, 12, 15, 18, 21, 24, 27, 30]));
    assert_eq!(found["monomials"][1], 6);
    assert_eq!(found["independent_integrals"], 1);
    let degrees = found["degrees"].as_array().expect("a list");
    assert_eq!(degrees[..10], json!([1, 2, 3, 5, 7, 11, 15, 20, 25, 32]).as_array().expect("a list")[..]);
    assert_eq!((&found["growth"], &found["entropy"]), (&json!("quadratic"), &json!(0.0)));
    assert_eq!(found["linear_integrals"], json!([]));
    assert_eq!((&found["divergence"], &found["is_even"]), (&json!("0"), &json!(true)));
    assert_eq!(found["hamiltonian"]["K"], json!([["0", "1"], ["-1", "0"]]));
    assert_eq!(found["hamiltonian"]["modified_is_proved"], true);
    assert_eq!(found["survivors"]["independent_integrals"], 0);
    assert_eq!(found["survivors"]["formulas"], json!([]));
    assert_eq!(found["out_of_time"], false);
    assert!(found["seconds"].is_number() && !texts(&found["sentences"]).is_empty());
    let lines = ["integrals", "densities", "brackets", "drifts"].map(|key| texts(&found[key])).concat();
    assert_eq!(reading(WEIERSTRASS, &lines).system().expect("a system").claims.len(), 3);
    assert_eq!(found["bases"], json!([]));
}

#[test]
fn what_is_found_is_told_in_its_parts() {
    for (arguments, kinds) in [
        (&["--field", WEIERSTRASS][..], &["integral", "density", "bracket", "hamiltonian"][..]),
        (&["e6"], &["integral", "integral", "density", "bracket", "bracket"]),
        (&["lv", "--eps", "1"], &["integral", "density", "bracket"]),
        (&["lorenz", "--degree", "2"], &[]),
    ] {
        let object = object(&[&["discover"], arguments].concat());
        let found = object["found"].as_array().expect("a list");
        let of = |key: &str| {
            found.iter().map(|one| one[key].as_str().expect("a text").to_owned()).collect::<Vec<_>>()
        };
        let (kind, name, expression) = (of("kind"), of("name"), of("expression"));
        assert_eq!(kind, kinds, "{arguments:?}");
        let lines = ["integrals", "densities", "brackets", "drifts"].map(|key| texts(&object[key])).concat();
        for (place, line) in lines.iter().enumerate() {
            let (head, expression) = (format!("{} {}", kind[place], name[place]), &expression[place]);
            let is_whole = line.starts_with(&format!("{head} = {expression}"))
                || *line == format!("{head} {{ {expression} }};")
                || line.starts_with(&format!("{head} {{ {expression} }} when"));
            assert!(is_whole, "{line}: {expression}");
        }
        let hamiltonian = found.get(lines.len()).map(|one| &one["expression"]);
        assert_eq!(hamiltonian, object["hamiltonian"].get("H"));
    }
}

#[test]
fn printed_lines_go_into_a_block_as_they_stand() {
    for (name, integrals) in [("e1", 2), ("e6", 2), ("euler", 2), ("volterra", 2), ("volterra4", 3)] {
        let page = answer(&["discover", name]);
        // The last paragraph consists of claims.
        let (_, claims) = page.trim_end().rsplit_once("\n\n").expect("a summary before the claims");
        let lines: Vec<String> = claims.lines().map(str::to_owned).collect();
        let block = find(name).expect("a system of the catalog").text();
        let equations: Vec<&str> = block.lines().filter(|line| line.contains("dot = ")).collect();
        assert_eq!(
            reading(&equations.join(" "), &lines).system().expect("a system").claims.len(),
            lines.len()
        );
        let own = reading(block, &[]).system().expect("a system").claims.len();
        let (densities, new): (Vec<String>, Vec<String>) =
            lines.iter().cloned().partition(|line| line.starts_with("density "));
        assert_eq!(reading(block, &new).system().expect("a system").claims.len(), own + new.len());
        assert_eq!(densities.len(), 1, "{page}");
        assert_eq!(lines.iter().filter(|line| line.starts_with("integral ")).count(), integrals, "{page}");
    }
}

#[test]
fn every_sentence_of_the_report_is_printed() {
    let page = answer(&["discover", "lv", "--eps", "1"]);
    let sentences = texts(&object(&["discover", "lv", "--eps", "1"])["sentences"]);
    assert!(sentences.len() >= 5 && sentences.iter().all(|sentence| page.contains(sentence)), "{page}");
}

#[test]
fn the_numbers_stand_before_the_claims() {
    let page = answer(&["discover", "e9", "--param", "xi=1"]);
    let line = |key: &str| {
        let found = page.lines().find_map(|line| line.strip_prefix(key));
        found.unwrap_or_else(|| panic!("no {key} in {page}")).trim().to_owned()
    };
    assert_eq!(line("system "), "e9");
    assert_eq!((line("generic "), line("fixed ")), ("eps".to_owned(), "xi = 1".to_owned()));
    assert!(line("degrees of iterates ").starts_with("1, 2, 4, 6, 8, "));
    assert_eq!(line("  on an orbit "), "3, 5, 7, 9, 11, 13, 15, 17, 19");
    assert!(page.contains("which shows 2 independent integrals"), "{page}");
    assert!(page.contains(" when xi = 1;"));
}

#[test]
fn what_is_fixed_is_kept_apart_from_what_is_generic() {
    let found = object(&["discover", "lv", "--eps", "1"]);
    assert_eq!((&found["eps"], &found["independent_integrals"]), (&json!("1"), &json!(1)));
    let integrals = texts(&found["integrals"]);
    assert!(integrals.len() == 1 && integrals[0].ends_with(" when eps = 1;"), "{integrals:?}");
    let zhukovsky = ["discover", "zhukovsky", "--param", "b2=0", "--param", "b3=0", "--degree", "4"];
    let found = object(&zhukovsky);
    assert_eq!((&found["parameters"]["b3"], &found["parameters"]["b1"]), (&json!("0"), &Value::Null));
    assert_eq!(found["hilbert"], json!([4, 8, 12, 16]));
}

/// Integrals whose formulas have 1000 characters or more are not claimed.
#[test]
fn the_further_systems_claim_as_many_integrals_as_are_found() {
    for entry in FURTHER.iter().filter(|entry| entry.command != "lagrange") {
        let claims = reading(entry.text(), &[]).system().expect("a system").claims;
        let claimed = |kind: &str| {
            let generic = claims.iter().filter(|claim| claim.is_unconditional());
            generic.filter(|claim| format!("{:?}", claim.kind).eq_ignore_ascii_case(kind)).count()
        };
        let variables = reading(entry.text(), &[]).system().expect("a system").field.dimension();
        let degree = default_degree(variables).to_string();
        let found = object(&["discover", entry.command, "--degree", &degree]);
        // Integrals without a formula are given as coefficients of relations between monomials.
        let by_bases =
            found["bases"].as_array().into_iter().flatten().map(|basis| texts(&basis["integrals"]).len());
        let integrals = texts(&found["integrals"]);
        let all = integrals.len() + by_bases.sum::<usize>();
        assert_eq!(found["independent_integrals"], all, "{}", entry.command);
        let short = integrals.iter().filter(|text| text.len() < 1000).count();
        assert_eq!(short, claimed("integral"), "{}", entry.command);
        assert_eq!(texts(&found["densities"]).is_empty(), claimed("density") == 0, "{}", entry.command);
    }
}

#[test]
fn what_is_found_is_printed_as_a_block_and_in_latex() {
    let found = object(&["discover", "euler"]);
    let all: usize =
        ["integrals", "densities", "brackets", "drifts"].iter().map(|key| texts(&found[*key]).len()).sum();
    let block = answer(&["discover", "euler", "--macro"]);
    let inside =
        block.trim().strip_prefix("kahan! {").and_then(|rest| rest.strip_suffix('}')).expect("a block");
    assert_eq!(reading(inside, &[]).system().expect("a system").claims.len(), all);
    assert!(block.lines().all(|line| line.chars().count() <= 100), "{block}");
    let latex = answer(&["discover", "euler", "--latex"]);
    assert_eq!(latex.lines().filter(|line| line.starts_with("% ")).count(), 1 + all, "{latex}");
    assert_eq!(latex.matches("\\begin{aligned}").count(), 1 + all);
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("euler.rs");
    let path = file.to_str().expect("a path");
    assert_eq!(answer(&["discover", "euler", "--macro", "--out", path]), "");
    assert_eq!(std::fs::read_to_string(&file).expect("a file"), block);
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 1);
    assert!(refusal(&["discover", "e6", "--out", "/nowhere/at/all"]).contains("cannot write"));
}

/// Kirchhoff's rigid body in a fluid has four integrals. Three of them have no formula: they are
/// coefficients of relations between monomials on an orbit.
#[test]
fn bases_are_printed_in_text_and_in_latex() {
    let kirchhoff =
        "m1dot = (a3 - a1)*m2*m3 + (b3 - b1)*p2*p3; m2dot = (a1 - a3)*m1*m3 + (b1 - b3)*p1*p3; m3dot = 0;
        p1dot = a3*p2*m3 - a1*p3*m2; p2dot = a1*p3*m1 - a3*p1*m3; p3dot = a1*(p1*m2 - p2*m1);";
    let arguments = ["discover", "--field", kirchhoff];
    let values = ["a1=1", "a3=2", "b1=3", "b3=5"].map(|value| ["--param", value]).concat();
    let arguments = [&arguments[..], &values].concat();
    let found = object(&arguments);
    let bases = found["bases"].as_array().expect("a list");
    let in_bases: usize = bases.iter().map(|basis| texts(&basis["integrals"]).len()).sum();
    assert_eq!(found["independent_integrals"], texts(&found["integrals"]).len() + in_bases);
    assert_eq!((&found["bounded_by"], in_bases), (&json!("complete"), 3));
    let terms: Vec<String> = bases.iter().flat_map(|basis| texts(&basis["terms"])).collect();
    assert!(terms.iter().any(|term| term == "m1^2 + m2^2"), "{terms:?}");
    let points: Vec<String> =
        bases.iter().map(|basis| format!("equations at {} consecutive points", basis["points"])).collect();
    for (format, joined, integral) in
        [(None, "*(m1^2 + m2^2)", "c1/c0"), (Some("--latex"), "(m_{1}^{2} + m_{2}^{2})", "$c_{1}/c_{0}$")]
    {
        let page = answer(&[&arguments[..], format.as_slice()].concat());
        assert!(page.contains(joined) && page.contains(integral), "{page}");
        assert!(points.iter().all(|said| page.contains(said)), "{page}");
        let relations =
            page.lines().filter(|line| line.starts_with("basis ") || line.contains("Kimura basis "));
        assert_eq!(relations.count(), bases.len(), "{page}");
    }
}

/// The modified Hamiltonian has 6 000 characters. Only the `kahan!` block shows it in full.
#[test]
fn a_long_modified_hamiltonian_is_printed_in_its_compact_form() {
    let chain = "adot = a*(b - c + d - e) + 1; bdot = b*(c - d + e - a) - 2; cdot = c*(d - e + a - b) + 3;
        ddot = d*(e - a + b - c) - 4; edot = e*(a - b + c - d) + 2;";
    let arguments = ["discover", "--field", chain, "--degree", "4"];
    let found = object(&arguments);
    let integrals = texts(&found["integrals"]);
    assert_eq!((&found["independent_integrals"], integrals.len()), (&json!(2), 2));
    assert!(found["hamiltonian"]["modified"].as_str().is_some_and(|text| text.contains("(a~ - a)*(")));
    let page = answer(&arguments);
    assert!(page.contains("H~ = ") && page.contains("(a~, b~, c~, d~, e~) is the image of (a, b, c, d, e)"));
    assert!(page.contains(&integrals[0]) && !page.contains(&integrals[1]));
    let latex = answer(&[&arguments[..], &["--latex"]].concat());
    assert!(latex.contains("\\widetilde{H} &= ") && latex.contains("\\text{ is the image of }"), "{latex}");
    assert_eq!(latex.lines().filter(|line| line.starts_with("% integral ")).count(), 1);
    let block = answer(&[&arguments[..], &["--macro"]].concat());
    assert_eq!(block.lines().filter(|line| line.trim_start().starts_with("integral ")).count(), 2, "{block}");
}

#[test]
#[ignore = "some ten seconds unoptimised"]
fn the_lagrange_top_has_four() {
    let found = object(&["discover", "lagrange", "--seconds", "600"]);
    assert_eq!(found["independent_integrals"], 4);
    assert_eq!(found["hilbert"], json!([6, 18, 38, 66]));
    assert_eq!(texts(&found["integrals"]).len(), 4);
    reading(find("lagrange").expect("in the catalog").text(), &texts(&found["integrals"]));
}

/// Findings must stay factored. Expanded, all integrals and densities have 10 546 characters.
#[test]
#[ignore = "the whole catalog: seconds in a release build, minutes in another"]
fn the_catalog_is_written_in_six_tenths_of_the_characters() {
    let length = |command: &str| -> usize {
        let variables = reading(find(command).expect("in the catalog").text(), &[])
            .system()
            .expect("a system")
            .field
            .dimension();
        let degree = default_degree(variables).to_string();
        let found = object(&["discover", command, "--degree", &degree, "--seconds", "600"]);
        [texts(&found["integrals"]), texts(&found["densities"])].concat().iter().map(String::len).sum()
    };
    let taken: usize = all().map(|entry| length(entry.command)).sum();
    println!("{taken} characters, {:.3} of 10546", taken as f64 / 10546.0);
    assert!(taken * 10 <= 10546 * 6, "{taken}");
}

#[test]
#[ignore = "a minute each where the build is slow"]
fn rigid_bodies_have_four_integrals_in_formulas_and_bases() {
    let clebsch = "m1dot = (w3 - w2)*p2*p3; m2dot = (w1 - w3)*p3*p1; m3dot = (w2 - w1)*p1*p2;
        p1dot = p2*m3 - p3*m2; p2dot = p3*m1 - p1*m3; p3dot = p1*m2 - p2*m1;";
    let kirchhoff = "m1dot = (a3 - a1)*m2*m3 + (b3 - b1)*p2*p3; m2dot = (a1 - a3)*m1*m3 + (b1 - b3)*p1*p3;
        m3dot = 0; p1dot = a3*p2*m3 - a1*p3*m2; p2dot = a1*p3*m1 - a3*p1*m3; p3dot = a1*(p1*m2 - p2*m1);";
    let euler_poinsot = "m1dot = (a3 - a1)*m2*m3 + g*p2; m2dot = (a1 - a3)*m1*m3 - g*p1; m3dot = 0;
        p1dot = a3*p2*m3 - a1*p3*m2; p2dot = a1*p3*m1 - a3*p1*m3; p3dot = a1*(p1*m2 - p2*m1);";
    for field in [clebsch, kirchhoff, euler_poinsot] {
        let found = object(&["discover", "--field", field]);
        let formulas = texts(&found["integrals"]);
        let bases = found["bases"].as_array().expect("a list");
        let in_bases: usize =
            bases.iter().map(|basis| basis["integrals"].as_array().map_or(0, Vec::len)).sum();
        println!("{} formulas, {in_bases} in bases, {} s", formulas.len(), found["seconds"]);
        assert_eq!((formulas.len() + in_bases, &found["out_of_time"]), (4, &json!(false)), "{field}");
        assert!(bases.iter().all(|basis| basis["outcome"] == "proved-mod-p"), "{bases:?}");
        reading(field, &formulas);
    }
}

fn with_integrals(scan: &Value, name: &str, wanted: u64) -> Vec<String> {
    let points = scan["points"].as_array().expect("a list").iter();
    let chosen = points.filter(|point| point["sight"]["independent_integrals"] == wanted);
    chosen.map(|point| point["values"][name].as_str().expect("exact").to_owned()).collect()
}

#[test]
fn a_scan_finds_the_special_values_by_itself() {
    for name in ["e7", "e9"] {
        let scan = object(&["scan", name, "--param", "xi=-2:2:+1/12"]);
        assert_eq!(scan["points"].as_array().map(Vec::len), Some(49));
        assert_eq!((&scan["names"], &scan["generic"]["independent_integrals"]), (&json!(["xi"]), &json!(0)));
        assert_eq!(with_integrals(&scan, "xi", 2), ["-1", "0", "1"], "{name}");
        let special = scan["special"].as_array().expect("a list");
        for value in ["-1", "1"] {
            assert!(special.contains(&json!({ "xi": value })), "{special:?}");
        }
        assert!(special.len() < 10 && scan["out_of_time"] == false);
    }
    let scan = object(&["scan", "lv", "--eps", "-2:2:+1/4"]);
    assert_eq!(with_integrals(&scan, "eps", 1), ["-1", "1"]);
    assert_eq!(scan["points"].as_array().map(Vec::len), Some(17));
}

#[test]
fn a_scan_names_its_special_points_in_a_table() {
    let page = answer(&["scan", "e9", "--param", "xi=0:1:+1/2", "--eps", "1/4:1/2:+1/4"]);
    let rows: Vec<Vec<&str>> = page.lines().map(|line| line.split_whitespace().collect()).collect();
    let starts = |row: &[&str]| rows.iter().any(|line| line.starts_with(row));
    assert!(starts(&["xi", "eps", "integrals"]) && starts(&["generic", "generic", "0", "4", "10"]), "{page}");
    for special in [["1", "1/4", "2"], ["1", "1/2", "2"], ["0", "1/4", "2"]] {
        assert!(starts(&special), "{page}");
    }
    assert!(!starts(&["1/2"]) && page.contains("4 are special of 6 points"), "{page}");
    // At a = 0 the field divides by 0.
    let page = answer(&["scan", "--field", "xdot = y/a; ydot = x^2;", "--param", "a=0:1:+1"]);
    assert!(page.lines().any(|line| line.starts_with("0 ") && line.contains("no map")), "{page}");
    let scan = object(&["scan", "e7", "--eps", "1/4:1/2:+1/4", "--param", "xi=1"]);
    assert_eq!((&scan["generic"]["independent_integrals"], &scan["special"]), (&json!(2), &json!([])));
}

#[test]
fn wrong_input_is_explained() {
    let cases: [(&[&str], &str); 15] = [
        (&["discover"], "which system?"),
        (&["discover", "e10"], "there is no system `e10`"),
        (&["discover", "e9", "--param", "zeta=1"], "`zeta` is no parameter of e9"),
        (&["discover", "e9", "--param", "xi=-2:2:1"], "not an exact number"),
        (&["discover", "e6", "--eps", "half"], "--eps: `half` is not an exact number"),
        (&["discover", "e6", "--eps", "0"], "identity"),
        (&["discover", "e6", "--degree", "0"], "1 or more"),
        (&["discover", "lagrange", "--degree", "9"], "ask for at most"),
        (&["discover", "--field", "xdot = y/a; ydot = x;", "--param", "a=0"], "divides by zero"),
        (&["discover", "--field", "xdot = x;", "--eps", "1"], "det A vanishes identically"),
        (&["scan", "e9"], "FROM:TO:+STEP"),
        (&["scan", "e9", "--param", "xi=1:0:1/4"], "for steps of 1/4 write 1:0:+1/4"),
        (&["scan", "e9", "--param", "xi=1:0:+1"], "write one that does, as 1:0:+-1/10"),
        (&["scan", "e9", "--param", "xi=0:1"], "--param xi: `0:1` is no range"),
        (&["scan", "e9", "--param", "xi=0:1:+1", "--param", "xi=1/2"], "given twice"),
    ];
    for (arguments, words) in cases {
        let paragraph = refusal(arguments);
        assert!(paragraph.contains(words), "{arguments:?}: {paragraph}");
    }
}

#[test]
fn a_bound_of_time_is_kept_and_said() {
    let found = object(&["discover", "e6", "--seconds", "0.000001"]);
    assert_eq!((&found["out_of_time"], &found["integrals"]), (&json!(true), &json!([])));
    let page = answer(&["scan", "e7", "--param", "xi=-2:2:+1/12", "--seconds", "0.000001"]);
    assert!(page.contains("time ran out"), "{page}");
}
