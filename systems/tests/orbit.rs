//! `kahan orbit` from outside: its numbers against known orbits and the generated maps, its files, its manners.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use kahan_core::prelude::*;
use kahan_systems::{E6, E7, E9, EulerTop, LotkaVolterra};
use serde_json::{Value, json};
use tempfile::TempDir;

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kahan"));
    command.arg("orbit").args(arguments);
    command
}

fn kahan(arguments: &[&str]) -> Output {
    command(arguments).output().expect("the command runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Standard output of a run that must succeed and complain of nothing, nor draw a progress bar.
fn answer(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    assert!(output.stderr.is_empty(), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

/// A table's names, and its cells.
fn table(csv: &str) -> (Vec<String>, Vec<Vec<String>>) {
    assert!(csv.ends_with('\n'), "{csv}");
    let mut lines = csv.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let names = lines.next().expect("a line of names");
    let rows: Vec<_> = lines.collect();
    assert!(rows.iter().all(|row| row.len() == names.len()), "{csv}");
    (names, rows)
}

fn folder() -> TempDir {
    tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).expect("a folder")
}

/// The names of everything in a folder.
fn contents(folder: &TempDir) -> Vec<String> {
    let entries = fs::read_dir(folder.path()).expect("the folder can be read");
    let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("UTF-8");
    let mut names: Vec<String> = entries.map(|entry| name(entry.expect("an entry"))).collect();
    names.sort();
    names
}

fn path_text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

const ALL: [&str; 11] = ["euler", "lv", "e1", "e2", "e3", "e4", "e5", "e6", "e7", "e8", "e9"];

/// The independent vectors of a system.
fn vectors(system: &str) -> Value {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../tests/data/{system}.json"));
    serde_json::from_str(&fs::read_to_string(path).expect("the vectors are there")).expect("JSON")
}

/// `p/1` is written `p`.
fn exact(value: &Value) -> String {
    let text = value.as_str().expect("a string");
    text.strip_suffix("/1").unwrap_or(text).to_owned()
}

fn point(values: &Value) -> String {
    values.as_array().expect("a list").iter().map(exact).collect::<Vec<_>>().join(",")
}

/// `--param NAME=V` for each parameter.
fn parameters(values: &Value) -> Vec<String> {
    let values = values.as_object().expect("an object");
    values
        .iter()
        .flat_map(|(name, value)| ["--param".to_owned(), format!("{name}={}", exact(value))])
        .collect()
}

fn with<'a>(arguments: &[&'a str], more: &'a [String]) -> Vec<&'a str> {
    arguments.iter().copied().chain(more.iter().map(String::as_str)).collect()
}

mod numbers {
    use super::*;

    #[test]
    fn exact_orbits_are_those_of_the_vectors() {
        let mut seen = 0;
        for system in ALL {
            let vectors = vectors(system);
            let states = vectors["states"].as_array().expect("a list").len();
            for orbit in vectors["orbits"].as_array().expect("a list") {
                let iterates = orbit["iterates"].as_array().expect("a list");
                let (eps, start, steps) =
                    (exact(&orbit["eps"]), point(&orbit["x0"]), iterates.len().to_string());
                let more = parameters(&orbit["params"]);
                let arguments = with(
                    &[system, "--eps", &eps, "--at", &start, "--steps", &steps, "--scalar", "exact"],
                    &more,
                );
                let (names, rows) = table(&answer(&arguments));
                assert_eq!(names[..2], ["n", "t"]);
                assert_eq!(rows.len(), iterates.len() + 1);
                for (row, expected) in rows.iter().zip(std::iter::once(&orbit["x0"]).chain(iterates)) {
                    assert_eq!(row[2..2 + states].join(","), point(expected), "{system}");
                    // Integrals are conserved exactly.
                    assert_eq!(row[2 + states..], rows[0][2 + states..], "{system}");
                    seen += 1;
                }
            }
        }
        assert!(seen > 90, "{seen} points");
    }

    #[test]
    fn the_time_is_twice_the_half_step_times_n() {
        let (_, rows) =
            table(&answer(&["lv", "--eps", "1/3", "--at", "1,2", "--steps", "4", "--scalar", "exact"]));
        let times: Vec<&str> = rows.iter().map(|row| row[1].as_str()).collect();
        assert_eq!(times, ["0", "2/3", "4/3", "2", "8/3"]);
        let (_, rows) = table(&answer(&["lv", "--eps", "-0.25", "--at", "1,2", "--steps", "2"]));
        assert_eq!(
            rows.iter().map(|row| row[1].parse::<f64>()).collect::<Vec<_>>(),
            [Ok(0.0), Ok(-0.5), Ok(-1.0)]
        );
    }

    /// Rows of `kahan orbit`, and of the generated map in the same scalar: states, then integrals.
    macro_rules! assert_same_bits {
        ($scalar:ty, $name:literal, $map:expr, $at:expr, [$($more:literal),*], $integrals:expr) => {{
            let map = $map;
            let at = $at.map(|value: &str| value.parse::<$scalar>().expect("a number"));
            let start = $at.join(",");
            let (_, rows) = table(&answer(&[
                $name, "--eps", "0.05", "--at", &start, "--steps", "500", "--scalar", stringify!($scalar), $($more),*
            ]));
            assert_eq!(rows.len(), 501);
            let eps: $scalar = 0.05;
            let orbit = map.orbit(SVector::from(at), eps);
            for (row, x) in rows.iter().zip(orbit) {
                let expected: Vec<$scalar> = x.iter().copied().chain($integrals(&map, &x, eps)).collect();
                let printed: Vec<$scalar> = row[2..].iter().map(|cell| cell.parse().expect("a float")).collect();
                assert_eq!(
                    printed.iter().map(|value| value.to_bits()).collect::<Vec<_>>(),
                    expected.iter().map(|value| value.to_bits()).collect::<Vec<_>>(),
                    "{} at n = {}", $name, row[0]
                );
            }
        }};
    }

    #[test]
    fn float_orbits_and_integrals_are_those_of_the_generated_maps_bit_for_bit() {
        macro_rules! every_system {
            ($scalar:ty) => {
                assert_same_bits!($scalar, "e6", E6, ["1", "2", "3"], [], |map: &E6, x, eps| map
                    .integrals(x, eps)
                    .iter()
                    .copied()
                    .collect::<Vec<_>>());
                assert_same_bits!($scalar, "lv", LotkaVolterra, ["0.5", "1.25"], [], |_: &_, _: &_, _| {
                    Vec::new()
                });
                assert_same_bits!(
                    $scalar,
                    "e7",
                    E7::<$scalar> { xi: 1.7 },
                    ["0.4", "0.8", "0.5"],
                    ["--param", "xi=1.7"],
                    |_: &_, _: &_, _| Vec::new()
                );
                assert_same_bits!(
                    $scalar,
                    "e9",
                    E9::<$scalar> { xi: 0.3 },
                    ["0.4", "0.8", "0.5"],
                    ["--param", "xi=0.3"],
                    |_: &_, _: &_, _| Vec::new()
                );
                assert_same_bits!(
                    $scalar,
                    "euler",
                    EulerTop::<$scalar> { a1: 0.5, a2: -0.7, a3: 1.25 },
                    ["0.4", "0.8", "0.5"],
                    ["--param", "a1=0.5", "--param", "a2=-0.7", "--param", "a3=1.25"],
                    |map: &EulerTop<$scalar>, x, eps| map
                        .integrals(x, eps)
                        .iter()
                        .copied()
                        .collect::<Vec<_>>()
                );
            };
        }
        every_system!(f64);
        every_system!(f32);
    }

    #[test]
    fn any_field_has_its_orbit_and_a_field_beyond_the_budget_is_eliminated() {
        let sum = "(a + b + c + d + e)";
        let equations: Vec<String> = ["a", "b", "c", "d", "e"]
            .iter()
            .map(|v| format!("{v}dot = {sum}*({v}*2 + k) - {v}^2;"))
            .collect();
        let field = equations.join(" ");
        let at = "1/5,-1/7,1/9,-1/3,1/8";
        let arguments = |scalar| {
            [
                "--field", &field, "--param", "k=1/3", "--eps", "1/50", "--at", at, "--steps", "3",
                "--scalar", scalar,
            ]
            .map(str::to_owned)
        };
        let rows = |scalar| {
            let arguments = arguments(scalar);
            table(&answer(&arguments.iter().map(String::as_str).collect::<Vec<_>>())).1
        };
        let (floats, exacts) = (rows("f64"), rows("exact"));
        assert_eq!(floats.len(), 4);
        for (float, exact) in floats.iter().zip(&exacts) {
            for (float, exact) in float[2..].iter().zip(&exact[2..]) {
                let exact = kahan_algebra::rational::Rational::parse(exact).expect("exact").to_f64();
                let error = (float.parse::<f64>().expect("a float") - exact).abs();
                assert!(error <= 64.0 * f64::EPSILON, "{float} for {exact}");
            }
        }
    }

    #[test]
    fn a_negative_half_step_leads_back_exactly() {
        let there =
            answer(&["e4", "--eps", "1/2", "--at", "7/3,11/13,23/47", "--steps", "4", "--scalar", "exact"]);
        let last = table(&there).1.pop().expect("rows")[2..5].join(",");
        let back = answer(&["e4", "--eps", "-1/2", "--at", &last, "--steps", "4", "--scalar", "exact"]);
        assert_eq!(table(&back).1.pop().expect("rows")[2..5], ["7/3", "11/13", "23/47"]);
    }

    #[test]
    fn every_k_th_row_is_the_row_of_the_whole_orbit() {
        let arguments = ["e6", "--eps", "0.1", "--at", "1,2,3", "--steps", "20"];
        let (names, all) = table(&answer(&arguments));
        for every in [1, 7, 20, 21] {
            let k = every.to_string();
            let (same_names, some) = table(&answer(&with(&arguments, &["--every".to_owned(), k])));
            assert_eq!(same_names, names);
            assert_eq!(some, all.iter().step_by(every).cloned().collect::<Vec<_>>(), "every {every}");
        }
    }

    #[test]
    fn variables_and_integrals_keep_their_names_and_columns_differ() {
        let field = "ndot = t; tdot = n; integral n_ = n^2 - t^2;";
        let arguments = ["--field", field, "--eps", "1/4", "--at", "1,2", "--steps", "1"];
        let (header, rows) = table(&answer(&arguments));
        assert_eq!(header, ["n__", "t_", "n", "t", "n_"]);
        assert_eq!(rows.len(), 2);
    }

    #[test]
    fn no_steps_are_one_row() {
        assert_eq!(
            answer(&["e6", "--eps", "1/2", "--at", "1,2,3", "--steps", "0", "--scalar", "exact"]),
            "n,t,x,y,z,H,K\n0,0,1,2,3,-28/5,-28/5\n"
        );
        assert_eq!(
            answer(&["lv", "--eps", "1/2", "--at", "1,2", "--steps", "0"]),
            "n,t,x,y\n0,0.0,1.0,2.0\n"
        );
    }

    #[test]
    fn an_integral_without_a_value_is_an_empty_cell_and_null() {
        // H = y/x of E3 at x = 0, where the map stays.
        for scalar in ["exact", "f64", "f32"] {
            let arguments = ["e3", "--eps", "1/10", "--at", "0,1,0", "--steps", "1", "--scalar", scalar];
            let (names, rows) = table(&answer(&arguments));
            assert_eq!(names[5..], ["H", "K"]);
            assert!(rows.iter().all(|row| row[5].is_empty() && !row[6].is_empty()), "{rows:?}");
            let object = answer(&with(&arguments, &["--json".to_owned()]));
            let object: Value = serde_json::from_str(&object).expect("JSON");
            assert!(object["rows"].as_array().expect("rows").iter().all(|row| row[5].is_null()), "{object}");
        }
    }
}

mod objects {
    use super::*;

    #[test]
    fn an_object_has_everything_that_the_table_has() {
        let arguments =
            ["e7", "--param", "xi=2", "--eps", "1/2", "--at", "1,2,1/3", "--steps", "4", "--every", "2"];
        for scalar in ["exact", "f64"] {
            let arguments = with(&arguments, &[]).into_iter().chain(["--scalar", scalar]).collect::<Vec<_>>();
            let (names, rows) = table(&answer(&arguments));
            let json: Vec<&str> = arguments.iter().copied().chain(["--json"]).collect();
            let object_text = answer(&json);
            let object: Value = serde_json::from_str(&object_text).expect("one object");
            assert_eq!(object["system"], "e7");
            assert_eq!(object["variables"], json!(["x", "y", "z"]));
            assert_eq!(
                object["parameters"],
                if scalar == "exact" { json!({"xi": "2"}) } else { json!({"xi": 2.0}) }
            );
            assert_eq!(object["eps"], if scalar == "exact" { json!("1/2") } else { json!(0.5) });
            assert_eq!(object["scalar"], scalar);
            assert_eq!(object["order"], 2);
            assert_eq!((&object["steps"], &object["every"]), (&json!(4), &json!(2)));
            assert_eq!(object["columns"], json!(names));
            assert_eq!(object["stopped"], Value::Null);
            // The text itself: readers of JSON may round.
            let listed: Vec<&str> = object_text.lines().filter(|line| line.starts_with("    [")).collect();
            assert_eq!(object["rows"].as_array().map(Vec::len), Some(rows.len()));
            assert_eq!(listed.len(), rows.len());
            for (listed, row) in listed.iter().zip(&rows) {
                let cells = listed.trim().trim_start_matches('[').trim_end_matches(',').trim_end_matches(']');
                let cells: Vec<&str> = cells.split(',').map(|cell| cell.trim_matches('"')).collect();
                assert_eq!(&cells, row);
            }
        }
    }

    #[test]
    fn with_a_file_the_object_describes_it_and_the_rows_are_there() {
        let folder = folder();
        let file = folder.path().join("e6.csv");
        let arguments = ["e6", "--eps", "0.1", "--at", "1,2,3", "--steps", "3"];
        let more = ["--json", "--out", path_text(&file)].map(str::to_owned);
        let object: Value = serde_json::from_str(&answer(&with(&arguments, &more))).expect("one object");
        assert_eq!(object["out"], path_text(&file));
        assert!(object["rows"].is_null() && object["stopped"].is_null(), "{object}");
        assert_eq!(fs::read_to_string(&file).expect("the file"), answer(&arguments));
    }
}

mod poles {
    use super::*;

    /// E6 at ε = 1: det A = 0 at (1/2, 0, 1/2).
    const AT_A_POLE: [&str; 7] = ["e6", "--eps", "1", "--at", "1/2,0,1/2", "--steps", "5"];

    #[test]
    fn the_rows_before_a_pole_are_kept_and_the_place_is_named() {
        for scalar in ["exact", "f64", "f32"] {
            let arguments: Vec<&str> = AT_A_POLE.into_iter().chain(["--scalar", scalar]).collect();
            let output = kahan(&arguments);
            assert_eq!(output.status.code(), Some(1));
            assert_eq!(table(&text(&output.stdout)).1.len(), 1);
            let complaint = text(&output.stderr);
            assert!(complaint.starts_with("error: ") && complaint.lines().count() == 1, "{complaint}");
            for part in ["det A = 0", "n = 0", "step 1", "eps = 1"] {
                assert!(complaint.contains(part), "{part}: {complaint}");
            }
        }
    }

    #[test]
    fn a_pole_on_the_way_ends_an_orbit_where_the_map_says() {
        // E1: x̃ = x/(1 + 2εx), so 1/x changes by 2ε: at ε = −1/4 it is 3/2, 1, 1/2, and 1 + 2εx = 0 at x = 2.
        let output = kahan(&["e1", "--eps", "-1/4", "--at", "2/3,1,1", "--steps", "9", "--scalar", "exact"]);
        assert_eq!(output.status.code(), Some(1));
        let (_, rows) = table(&text(&output.stdout));
        assert_eq!(rows.iter().map(|row| row[2].as_str()).collect::<Vec<_>>(), ["2/3", "1", "2"]);
        assert!(text(&output.stderr).contains("at n = 2 det A = 0"), "{}", text(&output.stderr));
    }

    #[test]
    fn orbits_stop_exactly_where_eval_has_no_next_point() {
        let mut seen = 0;
        for system in ALL {
            for case in vectors(system)["singular"].as_array().expect("a list") {
                let (eps, at, more) = (exact(&case["eps"]), point(&case["x"]), parameters(&case["params"]));
                let arguments = with(&[system, "--eps", &eps, "--at", &at, "--scalar", "exact"], &more);
                let evaluated = Command::new(env!("CARGO_BIN_EXE_kahan"))
                    .arg("eval")
                    .args(&arguments)
                    .arg("--json")
                    .output()
                    .expect("the command runs");
                let object: Value = serde_json::from_slice(&evaluated.stdout).expect("one object");
                let output = kahan(&with(&arguments, &["--steps".to_owned(), "1".to_owned()]));
                let rows = table(&text(&output.stdout)).1;
                let stops = object["x_next"].is_null();
                assert_eq!(output.status.code(), Some(i32::from(stops)), "{system} at {at}");
                assert_eq!(rows.len(), if stops { 1 } else { 2 }, "{system} at {at}");
                seen += 1;
            }
        }
        assert!(seen >= 11, "{seen} points");
    }

    #[test]
    fn a_float_orbit_that_overflows_ends_with_finite_rows() {
        // The map of the linear field is multiplication by (1 + ε)/(1 − ε) = 3.
        let arguments =
            ["--field", "xdot = x;", "--eps", "1/2", "--at", "1e30", "--steps", "100", "--scalar", "f32"];
        let output = kahan(&arguments);
        assert_eq!(output.status.code(), Some(1));
        let (_, rows) = table(&text(&output.stdout));
        assert!(rows.len() > 10 && rows.len() < 30, "{} rows", rows.len());
        assert!(rows.iter().all(|row| row[2].parse::<f32>().is_ok_and(f32::is_finite)));
        let complaint = text(&output.stderr);
        let last = rows.len() - 1;
        for part in ["range of f32", &format!("n = {last}"), &format!("step {}", last + 1), "--scalar exact"]
        {
            assert!(complaint.contains(part), "{part}: {complaint}");
        }
        assert_eq!(
            kahan(&with(&arguments[..8], &["--scalar".to_owned(), "exact".to_owned()])).status.code(),
            Some(0)
        );
    }

    #[test]
    fn beyond_the_budget_a_pole_is_said_to_be_one_by_convention() {
        let equations: Vec<String> = ["a", "b", "c", "d", "e"]
            .iter()
            .map(|v| format!("{v}dot = (a + b + c + d + e)*({v}*2 + 1);"))
            .collect();
        let field = equations.join(" ");
        let output = kahan(&[
            "--field",
            &field,
            "--eps",
            "1/2",
            "--at",
            "1,0,0,0,0",
            "--steps",
            "2",
            "--scalar",
            "exact",
        ]);
        assert_eq!(output.status.code(), Some(1));
        let complaint = text(&output.stderr);
        assert!(complaint.contains("det A = 0") && complaint.contains("budget"), "{complaint}");
    }

    #[test]
    fn a_file_and_an_object_keep_the_rows_before_a_pole() {
        let folder = folder();
        let file = folder.path().join("rows.csv");
        let output = kahan(&AT_A_POLE.into_iter().chain(["--out", path_text(&file)]).collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(1));
        assert_eq!(table(&fs::read_to_string(&file).expect("the file")).1.len(), 1);
        let output = kahan(&AT_A_POLE.into_iter().chain(["--json"]).collect::<Vec<_>>());
        let object: Value = serde_json::from_slice(&output.stdout).expect("one object");
        let stopped = object["stopped"].as_str().expect("a reason");
        assert!(text(&output.stderr).contains(stopped), "{stopped}");
        assert_eq!(object["rows"].as_array().map(Vec::len), Some(1));
    }
}

mod files {
    use super::*;

    const SHORT: [&str; 7] = ["e6", "--eps", "0.1", "--at", "1,2,3", "--steps", "9"];

    #[test]
    fn a_file_holds_what_would_be_printed_and_replaces_an_older_one() {
        let folder = folder();
        let file = folder.path().join("orbit.csv");
        fs::write(&file, "older").expect("a file");
        let arguments: Vec<&str> = SHORT.into_iter().chain(["--out", path_text(&file)]).collect();
        assert_eq!(answer(&arguments), "");
        assert_eq!(fs::read_to_string(&file).expect("the file"), answer(&SHORT));
        assert_eq!(contents(&folder), ["orbit.csv"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_file_may_be_read_by_whom_new_files_may_be_read_by_and_links_are_followed() {
        use std::os::unix::fs::PermissionsExt;
        let folder = folder();
        let (file, other, link) =
            (folder.path().join("orbit.csv"), folder.path().join("other"), folder.path().join("link"));
        fs::write(&other, "").expect("a file");
        std::os::unix::fs::symlink(&other, &link).expect("a link");
        answer(&SHORT.into_iter().chain(["--out", path_text(&file)]).collect::<Vec<_>>());
        answer(&SHORT.into_iter().chain(["--out", path_text(&link)]).collect::<Vec<_>>());
        let mode = |path: &Path| fs::metadata(path).expect("a file").permissions().mode();
        assert_eq!(mode(&file), mode(&other));
        assert_eq!(fs::read(&file).expect("the file"), fs::read(&other).expect("the file"));
        assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
    }

    #[test]
    fn what_is_refused_leaves_an_older_file_alone() {
        let folder = folder();
        let file = folder.path().join("orbit.csv");
        fs::write(&file, "older").expect("a file");
        let output = kahan(&["e6", "--eps", "0.1", "--at", "1,2", "--steps", "9", "--out", path_text(&file)]);
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(fs::read_to_string(&file).expect("the file"), "older");
        assert_eq!(contents(&folder), ["orbit.csv"]);
    }

    #[cfg(unix)]
    #[test]
    fn places_without_a_file_are_refused() {
        let folder = folder();
        let missing = folder.path().join("no/such/folder/orbit.csv");
        for (place, reason) in
            [(folder.path(), "directory"), (&missing, "does not exist"), (Path::new("/dev/null"), "ordinary")]
        {
            let output = kahan(&SHORT.into_iter().chain(["--out", path_text(place)]).collect::<Vec<_>>());
            let paragraph = text(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{paragraph}");
            assert!(paragraph.contains("--out") && paragraph.contains(reason), "{paragraph}");
        }
    }

    /// A run that is ended with the test.
    struct Endless(Child);

    impl Drop for Endless {
        fn drop(&mut self) {
            // It may have ended already.
            let _ = self.0.kill();
            let _ = self.0.wait();
        }
    }

    #[test]
    fn a_file_that_is_not_finished_never_has_its_name() {
        let folder = folder();
        let file = folder.path().join("orbit.csv");
        let arguments =
            ["lv", "--eps", "0.1", "--at", "1/2,5/3", "--steps", "1000000000000", "--every", "1000000"];
        let child = command(&arguments).args(["--out", path_text(&file)]).stderr(Stdio::null()).spawn();
        let running = Endless(child.expect("the command runs"));
        let is_begun = (0..6000).any(|_| {
            std::thread::sleep(Duration::from_millis(5));
            !contents(&folder).is_empty()
        });
        assert!(is_begun, "nothing is written");
        assert!(!file.exists());
        drop(running);
        assert!(!file.exists());
    }
}

mod manners {
    use super::*;

    fn refusal(arguments: &[&str]) -> String {
        let output = kahan(arguments);
        let paragraph = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {paragraph}");
        assert!(output.stdout.is_empty(), "{arguments:?} printed something");
        assert!(paragraph.starts_with("error: ") && paragraph.trim_end().lines().count() == 1, "{paragraph}");
        paragraph
    }

    #[test]
    fn rows_come_while_they_are_made_and_a_reader_that_goes_away_is_no_error() {
        for json in [false, true] {
            // An orbit of weeks.
            let mut command = command(&["e6", "--eps", "0.1", "--at", "1,2,3", "--steps", "1000000000000"]);
            if json {
                command.arg("--json");
            }
            let mut child =
                command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command runs");
            let mut reader = BufReader::new(child.stdout.take().expect("a pipe"));
            let mut lines = String::new();
            for _ in 0..100 {
                reader.read_line(&mut lines).expect("UTF-8");
            }
            assert!(lines.contains("99") || json, "{lines}");
            drop(reader);
            let mut complaint = String::new();
            child.stderr.take().expect("a pipe").read_to_string(&mut complaint).expect("UTF-8");
            assert_eq!(complaint, "");
            assert_eq!(child.wait().expect("the command ends").code(), Some(0));
        }
    }

    #[test]
    fn bad_input_says_what_to_write_instead() {
        let at = |rest: &[&'static str]| [&["e6", "--eps", "1/2", "--at", "1,2,3"], rest].concat();
        let cases: [(Vec<&str>, &[&str]); 13] = [
            (
                at(&["--steps", "5", "--order", "4", "--scalar", "exact"]),
                &["--order 4", "irrational", "--scalar f64", "--order 2"],
            ),
            (at(&["--steps", "5", "--order", "3"]), &["'3'", "2, 4, 6, 8"]),
            (at(&["--steps", "-5"]), &["'-5'", "whole number, 0 or more"]),
            (at(&["--steps", "1e3"]), &["'1e3'", "whole number, 0 or more"]),
            (at(&["--steps", "5", "--every", "0"]), &["'0'", "whole number, 1 or more"]),
            (at(&[]), &["--steps"]),
            (vec!["e6", "--at", "1,2,3", "--steps", "5"], &["--eps"]),
            (
                vec!["e6", "--eps", "1/2", "--at", "1,2", "--steps", "5"],
                &["3 coordinates x,y,z expected, 2 given"],
            ),
            (vec!["e7", "--eps", "1/2", "--at", "1,2,3", "--steps", "5"], &["--param xi=VALUE"]),
            (vec!["--eps", "1/2", "--at", "1,2,3", "--steps", "5"], &["which system"]),
            (
                vec!["lv", "--eps", "1/2", "--at", "1,1e400", "--steps", "5"],
                &["--at", "y is beyond", "f64", "exact"],
            ),
            (
                vec!["lv", "--eps", "1e39", "--at", "1,1", "--steps", "5", "--scalar", "f32"],
                &["--eps", "f32"],
            ),
            (
                vec!["--field", "xdot = x/a;", "--eps", "1", "--at", "1", "--param", "a=0", "--steps", "1"],
                &["divides by zero at a = 0"],
            ),
        ];
        for (arguments, expected) in &cases {
            let paragraph = refusal(arguments);
            for part in *expected {
                assert!(paragraph.contains(part), "{arguments:?} does not say {part}: {paragraph}");
            }
        }
    }

    #[cfg(unix)]
    #[test]
    fn the_examples_of_the_help_run() {
        let help = answer(&["--help"]);
        let (_, examples) = help.split_once("Examples:\n").expect("the help has examples");
        let folder = folder();
        let mut run = 0;
        for example in examples.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let arguments = example.strip_prefix("kahan ").expect("a command");
            let output = Command::new("sh")
                .args(["-c", &format!("\"$KAHAN\" {arguments}")])
                .env("KAHAN", env!("CARGO_BIN_EXE_kahan"))
                .current_dir(folder.path())
                .output()
                .expect("a shell");
            assert_eq!(output.status.code(), Some(0), "{example}: {}", text(&output.stderr));
            run += 1;
        }
        assert!(run >= 5, "{run} examples");
        assert_eq!(contents(&folder), ["e7.csv"]);
    }
}
