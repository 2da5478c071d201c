//! Numbers in every scalar and order, against test vectors and generated maps.

use super::*;

#[test]
fn exact_orbits_are_those_of_the_vectors() {
    let mut seen = 0;
    for system in ALL {
        let vectors = vectors(system);
        let states = vectors["states"].as_array().expect("a list").len();
        for orbit in vectors["orbits"].as_array().expect("a list") {
            let iterates = orbit["iterates"].as_array().expect("a list");
            let (eps, start, steps) = (exact(&orbit["eps"]), point(&orbit["x0"]), iterates.len().to_string());
            let more = parameters(&orbit["params"]);
            let arguments =
                with(&[system, "--eps", &eps, "--at", &start, "--steps", &steps, "--scalar", "exact"], &more);
            let (names, rows) = table(&answer(&arguments));
            assert_eq!(names[..2], ["n", "t"]);
            assert_eq!(rows.len(), iterates.len() + 1);
            for (row, expected) in rows.iter().zip(std::iter::once(&orbit["x0"]).chain(iterates)) {
                assert_eq!(row[2..2 + states].join(","), point(expected), "{system}");
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
                |map: &EulerTop<$scalar>, x, eps| map.integrals(x, eps).iter().copied().collect::<Vec<_>>()
            );
        };
    }
    every_system!(f64);
    every_system!(f32);
}

#[test]
fn any_field_has_its_orbit_and_a_field_beyond_the_budget_is_eliminated() {
    let sum = "(a + b + c + d + e)";
    let equations: Vec<String> =
        ["a", "b", "c", "d", "e"].iter().map(|v| format!("{v}dot = {sum}*({v}*2 + k) - {v}^2;")).collect();
    let field = equations.join(" ");
    let at = "1/5,-1/7,1/9,-1/3,1/8";
    let arguments = |scalar| {
        [
            "--field", &field, "--param", "k=1/3", "--eps", "1/50", "--at", at, "--steps", "3", "--scalar",
            scalar,
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
    assert_eq!(answer(&["lv", "--eps", "1/2", "--at", "1,2", "--steps", "0"]), "n,t,x,y\n0,0.0,1.0,2.0\n");
}

#[test]
fn an_integral_without_a_value_is_an_empty_cell_and_null() {
    // H = y/x of E3 is undefined at the initial point, which is a fixed point of the map.
    for scalar in ["exact", "f64", "f32"] {
        let arguments = ["e3", "--eps", "1/10", "--at", "0,1,0", "--steps", "1", "--scalar", scalar];
        let (names, rows) = table(&answer(&arguments));
        assert_eq!(names[5..], ["H", "K"]);
        assert_eq!(rows.len(), 2);
        assert!(rows.iter().all(|row| row[5].is_empty() && !row[6].is_empty()), "{rows:?}");
        let object = answer(&with(&arguments, &["--json".to_owned()]));
        let object: Value = serde_json::from_str(&object).expect("JSON");
        assert_eq!(object["rows"].as_array().map(Vec::len), Some(2));
        assert!(object["rows"].as_array().expect("rows").iter().all(|row| row[5].is_null()), "{object}");
    }
}

#[test]
fn fused_steps_have_digits_of_their_own() {
    let asked =
        |more: &[&'static str]| [&["e6", "--eps", "0.05", "--at", "1,2,3", "--steps", "300"], more].concat();
    let last = |more: &[&'static str]| table(&answer(&asked(more))).1.pop().expect("a row");
    assert_ne!(last(&["--fused"]), last(&[]));
    assert_eq!(last(&["--fused", "--every", "7", "--transient", "6"])[2..], last(&["--fused"])[2..]);
    let head =
        |more: &[&'static str]| -> Value { serde_json::from_str(&answer(&asked(more))).expect("JSON") };
    let fused = head(&["--fused", "--json"]);
    assert_eq!((&fused["fused"], &fused["runs_as"]), (&json!(true), &json!("machine code")));
    assert!(head(&["--json"]).get("fused").is_none());
    for more in [["--method", "rk4"], ["--scalar", "exact"]] {
        let output = kahan(&asked(&[&more[..], &["--fused"]].concat()));
        assert_eq!(output.status.code(), Some(2), "{more:?}");
        assert!(text(&output.stderr).contains("leave --method and --scalar exact out"), "{more:?}");
    }
}
