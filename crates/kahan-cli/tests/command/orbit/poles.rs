//! Orbits that meet a pole.

use super::*;

/// For E6 at ε = 1, det A = 0 at (1/2, 0, 1/2).
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
    // For E1, x̃ = x/(1 + 2εx), so 1/x changes by 2ε = −1/2: 3/2, 1, 1/2, and x = 2 is a pole.
    let output = kahan(&["e1", "--eps", "-1/4", "--at", "2/3,1,1", "--steps", "9", "--scalar", "exact"]);
    assert_eq!(output.status.code(), Some(1));
    let (_, rows) = table(&text(&output.stdout));
    assert_eq!(rows.iter().map(|row| row[2].as_str()).collect::<Vec<_>>(), ["2/3", "1", "2"]);
    assert!(text(&output.stderr).contains("at n = 2 det A = 0"), "{}", text(&output.stderr));
}

#[test]
fn a_projective_orbit_goes_on_through_infinity() {
    // For E1 at ε = 1/2, 1/x grows by 1 in each step, so x is −1, ∞, 1, 1/2.
    let start = ["e1", "--eps", "1/2", "--at", "-1,2/3,5/7", "--steps", "3", "--projective"];
    for (scalar, back) in [("exact", ["1", "1/2"]), ("f64", ["1.0", "0.5"]), ("dd", ["1.0", "0.5"])] {
        let output = kahan(&[&start[..], &["--scalar", scalar]].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        let (_, rows) = table(&text(&output.stdout));
        assert_eq!(rows.len(), 4);
        assert_eq!(rows[1][2..5], ["inf"; 3]);
        assert!(rows[1][5..].iter().all(String::is_empty), "{:?}", rows[1]);
        assert_eq!([&rows[2][2], &rows[3][2]], back, "{scalar}");
        let output = kahan(&[&start[..], &["--scalar", scalar, "--json"]].concat());
        let object: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(
            object["rows"][1].as_array().expect("a row")[2..5],
            [Value::Null, Value::Null, Value::Null]
        );
        assert_eq!(object["stopped"], Value::Null);
    }
}

#[test]
fn away_from_poles_a_projective_orbit_has_the_rows_of_the_orbit() {
    for scalar in ["exact", "f64", "f32", "dd"] {
        let start = ["lv", "--eps", "1/10", "--at", "1/2,5/3", "--steps", "5", "--scalar", scalar];
        let rows = |more: &[&str]| text(&kahan(&[&start[..], more].concat()).stdout);
        assert_eq!(rows(&["--projective"]), rows(&[]), "{scalar}");
    }
}

#[test]
fn a_projective_orbit_says_why_it_ends() {
    let field = "xdot = y*z; ydot = z*x; zdot = x*y;";
    let output = kahan(&["--field", field, "--eps", "1/2", "--at", "2,2,2", "--steps", "5", "--projective"]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(table(&text(&output.stdout)).1.len(), 2);
    let complaint = text(&output.stderr);
    assert!(complaint.contains("ends at n = 1: ") && complaint.contains("different points"), "{complaint}");
    let refused = kahan(&["lv", "--eps", "1", "--at", "1,2", "--steps", "1", "--order", "4", "--projective"]);
    assert_eq!(refused.status.code(), Some(2));
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
    // At ε = 1/2, the map of this linear field multiplies the point by (1 + ε)/(1 − ε) = 3.
    let arguments =
        ["--field", "xdot = x;", "--eps", "1/2", "--at", "1e30", "--steps", "100", "--scalar", "f32"];
    let output = kahan(&arguments);
    assert_eq!(output.status.code(), Some(1));
    let (_, rows) = table(&text(&output.stdout));
    assert!(rows.len() > 10 && rows.len() < 30, "{} rows", rows.len());
    assert!(rows.iter().all(|row| row[2].parse::<f32>().is_ok_and(f32::is_finite)));
    let complaint = text(&output.stderr);
    let last = rows.len() - 1;
    for part in ["range of f32", &format!("n = {last}"), &format!("step {}", last + 1), "--scalar exact"] {
        assert!(complaint.contains(part), "{part}: {complaint}");
    }
    assert_eq!(
        kahan(&with(&arguments[..8], &["--scalar".to_owned(), "exact".to_owned()])).status.code(),
        Some(0)
    );
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
