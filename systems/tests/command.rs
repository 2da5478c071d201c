//! The `kahan` command from outside: what it prints, and with which exit status.

use std::io::Read;
use std::process::{Command, Output, Stdio};

use serde_json::{Value, json};

fn kahan(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_kahan")).args(arguments).output().expect("the command runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Standard output of a run that must succeed.
fn answer(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    assert!(output.stderr.is_empty(), "{arguments:?}");
    text(&output.stdout)
}

fn object(arguments: &[&str]) -> Value {
    serde_json::from_str(&answer(arguments)).expect("one JSON object")
}

/// The one paragraph of a refusal.
fn refusal(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    let paragraph = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {paragraph}");
    assert!(output.stdout.is_empty(), "{arguments:?} printed something");
    assert!(paragraph.starts_with("error: ") && paragraph.ends_with('\n'), "{paragraph}");
    assert!(!paragraph.contains("\n\n"), "more than one paragraph: {paragraph}");
    paragraph
}

mod verifying {
    use super::*;

    /// The whole registry is the matter of `tests/paper.rs`; here one system stands for all.
    #[test]
    fn every_claim_of_a_system_has_an_outcome_and_a_place() {
        let report = object(&["verify", "--system", "E6", "--json"]);
        let claims = report["claims"].as_array().expect("a list");
        assert_eq!(report["failed"], 0);
        let ids: Vec<&str> = claims.iter().filter_map(|claim| claim["id"].as_str()).collect();
        for id in ["e6.H", "e6.Q", "table1.e6.P", "table3.e6.P12", "table4.e6.Q31", "change.e6.euler.map"] {
            assert!(ids.contains(&id), "{id} is missing");
        }
        for claim in claims {
            let outcome = claim["outcome"].as_str().expect("a word");
            assert!(
                ["proved", "proved-mod-p", "exact", "numerical", "misprint"].contains(&outcome),
                "{claim}"
            );
            assert_eq!(claim["system"], "e6");
            for key in ["id", "source", "statement", "detail"] {
                assert!(claim[key].as_str().is_some_and(|value| !value.is_empty()), "{key} of {claim}");
            }
        }
    }

    #[test]
    fn the_table_has_a_line_for_every_claim() {
        let claims = object(&["verify", "e2", "--json"])["claims"].as_array().expect("a list").len();
        let table = answer(&["verify", "e2"]);
        assert!(table.starts_with("e2: "), "{table}");
        assert!(
            table.lines().filter(|line| line.starts_with("  ") && line.ends_with(" ms")).count() == claims
        );
        assert!(
            table
                .trim_end()
                .lines()
                .last()
                .is_some_and(|line| line.starts_with(&format!("{claims} claims: ")))
        );
    }

    #[test]
    fn what_is_printed_wrong_is_shown_with_its_counterexample() {
        let table = answer(&["verify", "e3"]);
        assert!(table.contains("misprint: corrected form established"), "{table}");
        assert!(table.contains("-1/200 on the left, 1/40 on the right"), "{table}");
    }

    #[test]
    fn no_claim_of_a_system_survives_every_mutation() {
        let report = object(&["verify", "lv", "--mutate", "--json"]);
        assert_eq!(report["survived"], 0);
        let mutations = report["mutations"].as_array().expect("a list");
        assert!(mutations.len() > 10);
        assert!(mutations.iter().all(|one| one["failed"].is_string() && one["tried"].as_u64() >= Some(1)));
        let text = answer(&["verify", "lv", "--mutate"]);
        assert!(text.contains("0 survived"), "{text}");
    }

    #[test]
    fn one_system_at_a_time() {
        assert!(refusal(&["verify", "e1", "--system", "e2"]).contains("--system"));
        assert!(refusal(&["verify", "--system", "e10"]).contains("`e10`"));
        assert!(refusal(&["verify", "--mutate", "--field", "xdot = x;"]).contains("--mutate"));
        assert!(answer(&["verify", "--system", "general"]).starts_with("general: "));
    }

    #[test]
    fn a_false_claim_fails_with_a_counterexample_and_status_1() {
        let field = "xdot = y; ydot = -x; integral F = x^2 + 2*y^2; integral H = x^2 + y^2;";
        let output = kahan(&["verify", "--field", field, "--json"]);
        assert_eq!(output.status.code(), Some(1));
        let report: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
        assert_eq!(report["failed"], 1);
        assert_eq!(report["claims"][0]["outcome"], "failed");
        assert!(report["claims"][0]["detail"].as_str().is_some_and(|detail| detail.contains("x = ")));
        assert_eq!(report["claims"][1]["outcome"], "proved");
        assert!(text(&output.stderr).contains("field.F"));
    }

    #[test]
    fn a_vacuous_claim_fails() {
        let output = kahan(&["verify", "--field", "xdot = y; ydot = -x; integral C = eps;"]);
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stdout).contains("says nothing"));
    }
}

mod evaluating {
    use super::*;

    #[test]
    fn every_object_of_e1_has_the_value_of_the_oracle() {
        let values = object(&["eval", "e1", "--eps", "1/2", "--at", "3/7,11/13,23/47", "--json"]);
        let expected = json!({
            "system": "e1",
            "variables": ["x", "y", "z"],
            "parameters": {},
            "eps": "1/2",
            "x": ["3/7", "11/13", "23/47"],
            "field": ["-9/49", "-33/91", "91279/55601"],
            "field_jacobian": [["-6/7", "0", "0"], ["-11/13", "-3/7", "0"], ["23/47", "44/13", "3/7"]],
            "A": [["10/7", "0", "0"], ["11/26", "17/14", "0"], ["-23/94", "-22/13", "11/14"]],
            "b": ["3/7", "11/13", "23/47"],
            "det_A": "935/686",
            "x_next": ["3/10", "77/130", "1740459/873730"],
            "jacobian": [["49/100", "0", "0"], ["-539/1300", "7/10", "0"], ["50669577/96110300", "196/65", "161/110"]],
            "det_jacobian": "55223/110000",
            "integrals": { "H": "77/39", "K": "1441160/1485341" },
            "density": "5059691/1698510",
            "brackets": {
                "P": [["0", "0", "561/1372"], ["0", "0", "2057/2548"], ["-561/1372", "-2057/2548", "0"]],
                // Q/c with c = 1/x^2 = 49/9
                "Q": [["0", "27/343", "-198/637"], ["-27/343", "0", "9321201/72781709"], ["198/637", "-9321201/72781709", "0"]],
            },
        });
        for (key, value) in expected.as_object().expect("an object") {
            assert_eq!(&values[key], value, "{key}");
        }
        let keys =
            |object: &Value| object.as_object().expect("an object").keys().cloned().collect::<Vec<_>>();
        assert_eq!(keys(&values), keys(&expected));
    }

    #[test]
    fn parameters_and_negative_numbers_are_read_exactly() {
        let arguments =
            ["eval", "e7", "--eps", "1/2", "--at", "3/7,11/13,23/47", "--param", "xi=19/17", "--json"];
        let values = object(&arguments);
        assert_eq!(values["parameters"], json!({ "xi": "19/17" }));
        assert_eq!(values["x_next"], json!(["3/10", "21791/38350", "9131905909/4381755950"]));
        assert_eq!(values["density"], "17836/6171");
        let back = object(&[
            "eval",
            "e7",
            "--eps",
            "-1/2",
            "--at",
            "0.3,21791/38350,9131905909/4381755950",
            "--param",
            "xi=19/17",
            "--json",
        ]);
        assert_eq!(back["x_next"], json!(["3/7", "11/13", "23/47"]));
        let negative = object(&["eval", "e4", "--eps", "-1e-1", "--at", "-1,2,3", "--json"]);
        assert_eq!((&negative["eps"], &negative["x"]), (&json!("-1/10"), &json!(["-1", "2", "3"])));
    }

    #[test]
    fn removable_poles_have_the_value_of_the_reduced_map() {
        let e1 = object(&["eval", "e1", "--eps", "1/2", "--at", "-2,1,1/3", "--json"]);
        assert_eq!(
            (&e1["x_next"], &e1["det_jacobian"], &e1["det_A"]),
            (&json!(["2", "-1", "-2/3"]), &json!("-1"), &json!("0"))
        );
        assert_eq!((&e1["integrals"]["K"], &e1["brackets"]["Q"]), (&Value::Null, &Value::Null));
        let e3 = object(&["eval", "e3", "--eps", "1/2", "--at", "3/2,1,-2", "--json"]);
        assert_eq!(
            (&e3["x_next"], &e3["det_jacobian"]),
            (&json!(["24/13", "16/13", "2"]), &json!("4096/2197"))
        );
    }

    #[test]
    fn at_a_pole_the_rest_is_printed_and_the_status_is_1() {
        let point = ["eval", "e1", "--eps", "1/2", "--at", "2,1,1/3", "--json"];
        for scalar in ["exact", "f64", "f32"] {
            let output = kahan(&[&point[..], &["--scalar", scalar]].concat());
            assert_eq!(output.status.code(), Some(1), "{scalar}");
            let values: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
            for key in ["x_next", "jacobian", "det_jacobian"] {
                assert_eq!(values.get(key), Some(&Value::Null), "{key}, {scalar}");
            }
            assert_eq!(values["integrals"]["H"], if scalar == "exact" { json!("1/2") } else { json!(0.5) });
            let complaint = text(&output.stderr);
            assert!(
                complaint.contains("det A = 0") && complaint.contains("x = 2, y = 1, z = 1/3"),
                "{complaint}"
            );
        }
    }

    #[test]
    fn floats_are_numbers_near_the_exact_values() {
        let point = ["eval", "lv", "--eps", "1/2", "--at", "1/2,5/3", "--json", "--scalar"];
        for (scalar, tolerance) in [("f64", 4.0 * f64::EPSILON), ("f32", 4.0 * f64::from(f32::EPSILON))] {
            let values = object(&[&point[..], &[scalar]].concat());
            for (value, exact) in [(&values["x_next"][0], 7.0 / 18.0), (&values["x_next"][1], 25.0 / 27.0)] {
                assert!(
                    value.as_f64().is_some_and(|value| (value - exact).abs() <= tolerance),
                    "{scalar}: {value}"
                );
            }
        }
    }

    #[test]
    fn a_field_of_ones_own_takes_its_free_names_as_parameters() {
        let field = "xdot = y; ydot = 6*x^2 - a;";
        let values =
            object(&["eval", "--field", field, "--param", "a=2", "--eps", "1/10", "--at", "0,1", "--json"]);
        assert_eq!(values["system"], "field");
        assert_eq!(values["field"], json!(["1", "-2"]));
        assert_eq!(values["density"], Value::Null);
        assert_eq!((&values["integrals"], &values["brackets"]), (&json!({}), &json!({})));
    }

    #[test]
    fn the_readable_form_shows_the_same_values() {
        let page = answer(&["eval", "e1", "--eps", "1/2", "--at", "-2,1,1/3"]);
        assert!(page.contains("(2, -1, -2/3)") && page.contains("undefined"), "{page}");
    }
}

mod showing {
    use super::*;

    #[test]
    fn the_list_names_the_systems_of_the_paper_then_the_others() {
        let list = object(&["list", "--json"]);
        let names: Vec<&str> = list["systems"]
            .as_array()
            .expect("a list")
            .iter()
            .filter_map(|one| one["name"].as_str())
            .collect();
        let paper = ["euler", "lv", "e1", "e2", "e3", "e4", "e5", "e6", "e7", "e8", "e9"];
        let others =
            ["weierstrass", "volterra", "volterra4", "lagrange", "henon-heiles", "zhukovsky", "lorenz"];
        assert_eq!(names, [&paper[..], &others[..]].concat());
        assert!(names.iter().all(|name| answer(&["list"]).contains(name)));
    }

    #[test]
    fn the_factor_that_was_divided_out_is_named() {
        assert_eq!(object(&["show", "e1", "--json"])["removed_factor"], "1 + eps*x");
        assert_eq!(object(&["show", "e3", "--json"])["removed_factor"], "1 + eps*z");
        assert_eq!(object(&["show", "e6", "--json"])["removed_factor"], Value::Null);
        assert!(answer(&["show", "e1"]).contains("1 + eps*x"));
    }

    #[test]
    fn every_system_is_shown_in_every_form() {
        let names = kahan_systems::registry::all().map(|entry| entry.command);
        for name in names {
            for form in ["--latex", "--macro", "--json"] {
                assert!(!answer(&["show", name, form]).is_empty());
            }
            assert!(answer(&["show", name]).contains("A(x,eps) = I - eps f'(x)"));
        }
    }

    #[test]
    fn the_macro_block_reads_back_as_the_same_system() {
        for name in ["euler", "lv", "e5", "e8"] {
            let block = answer(&["show", name, "--macro"]);
            let file =
                std::env::temp_dir().join(format!("kahan-command-test-{}-{name}.rs", std::process::id()));
            std::fs::write(&file, &block).expect("a temporary file");
            let again = answer(&["show", "--file", file.to_str().expect("UTF-8"), "--macro"]);
            std::fs::remove_file(&file).expect("the temporary file");
            assert_eq!(again, block);
        }
    }

    #[test]
    fn a_field_beyond_the_budget_keeps_its_determinant() {
        let states = ["a", "b", "c", "d", "e", "f"];
        let all: Vec<String> = states.iter().enumerate().map(|(i, x)| format!("{}*{x}^2", i + 1)).collect();
        let equations = states
            .iter()
            .enumerate()
            .map(|(i, x)| format!("{x}dot = {} + {x}*{} + {i};", all.join(" + "), states[(i + 1) % 6]));
        let field: String = equations.collect();
        let sheet = object(&["show", "--field", &field, "--json"]);
        assert_eq!((&sheet["det_A"], &sheet["map"]), (&Value::Null, &Value::Null));
        let page = answer(&["show", "--field", &field]);
        assert!(page.contains("not expanded") && page.contains("elimination"), "{page}");
        assert!(answer(&["show", "--field", &field, "--latex"]).contains("vmatrix"));
        let point = ["eval", "--field", &field, "--eps", "1/7", "--at", "1,2,3,4,5,6", "--json"];
        assert_eq!(object(&point)["x_next"].as_array().map(Vec::len), Some(6));
    }

    #[test]
    fn help_and_version_are_answers() {
        for command in ["verify", "list", "show", "eval"] {
            let (long, short) = (answer(&[command, "--help"]), answer(&[command, "-h"]));
            assert!(long.contains("Examples:") && !short.contains("Examples:"), "{command}");
            assert!(short.len() < long.len());
        }
        assert!(answer(&["--help"]).contains("Examples:"));
        assert!(answer(&["--version"]).starts_with("kahan "));
    }

    #[test]
    fn a_reader_that_goes_away_is_no_error() {
        let mut child = Command::new(env!("CARGO_BIN_EXE_kahan"))
            .args(["show", "e9", "--json"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command runs");
        drop(child.stdout.take());
        let mut complaint = String::new();
        child.stderr.take().expect("a pipe").read_to_string(&mut complaint).expect("UTF-8");
        assert_eq!(complaint, "");
        assert_eq!(child.wait().expect("the command ends").code(), Some(0));
    }
}

mod refusing {
    use super::*;
    use kahan_algebra::lexer::lex;
    use kahan_algebra::read;
    use kahan_algebra::render::report;

    #[test]
    fn bad_input_says_what_to_write_instead() {
        let at = |rest: &[&'static str]| [&["eval"], rest].concat();
        let cases: [(Vec<&str>, &[&str]); 17] = [
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
            (at(&["e1", "--field", "xdot = x;", "--eps", "1", "--at", "1"]), &["one field at a time"]),
            (at(&["--file", "no/such/file", "--eps", "1", "--at", "1"]), &["no/such/file"]),
            (at(&["--eps", "1", "--at", "1"]), &["which system"]),
            (at(&["e1", "--at", "1,2,3"]), &["--eps"]),
            (
                at(&["e1", "--eps", "1", "--at", "1,2,3", "--scalar", "f16"]),
                &["'f16'", "exact, f32, f64, dd]; `kahan"],
            ),
            (vec!["evall"], &["evall", "eval"]),
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
            reading.diagnostics.iter().map(|one| report(one, field, &lexed.ranges, "--field")).collect();
        assert!(reading.diagnostics.len() >= 3, "{expected}");
        for command in ["show", "verify"] {
            assert_eq!(refusal(&[command, "--field", field]), expected);
        }
    }

    #[test]
    fn a_false_claim_is_shown_by_nobody() {
        let paragraph = refusal(&["show", "--field", "xdot = y; ydot = -x; integral H = x^2 + 2*y^2;"]);
        assert!(paragraph.contains("`H` does not hold") && paragraph.contains('^'), "{paragraph}");
    }
}

mod parameters_that_are_given {
    use super::*;

    #[test]
    fn are_put_in_before_the_map_is_reduced() {
        // E9 at xi = 1 is E3, whose map loses the factor 1 + eps*z.
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
        assert!(
            block.contains("integral H4 = ") && !block.contains("H3") && !block.contains("when"),
            "{block}"
        );
        assert_eq!(block.matches("density").count(), 1, "{block}");
        let report = object(&["verify", "e9", "--param", "xi=-1", "--json"]);
        assert_eq!(report["failed"], 0);
    }

    #[test]
    fn may_not_make_the_field_divide_by_zero() {
        let paragraph = refusal(&["show", "--field", "xdot = x/(a - 1);", "--param", "a=1"]);
        assert!(paragraph.contains("a=1") && paragraph.contains("divides by zero"), "{paragraph}");
    }
}

mod what_once_went_wrong {
    use super::*;

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
        let equations: Vec<String> = ["a", "b", "c", "d", "e"]
            .iter()
            .map(|v| format!("{v}dot = (a + b + c + d + e)*({v}*2 + 1);"))
            .collect();
        let output = kahan(&["eval", "--field", &equations.join(" "), "--eps", "1/2", "--at", "1,0,0,0,0"]);
        assert_eq!(output.status.code(), Some(1));
        let complaint = text(&output.stderr);
        assert!(complaint.contains("det A = 0") && complaint.contains("budget"), "{complaint}");
    }
}
