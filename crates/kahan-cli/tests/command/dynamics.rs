//! `kahan dynamics`, `kahan section` and `kahan chart`.

use std::f64::consts::PI;

use serde_json::Value;

use crate::running::{answer, examples_run, kahan, object, refusal, text};

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

const TURN: [&str; 7] =
    ["--field", "xdot = y; ydot = -x; integral R = x^2 + y^2;", "--eps", "0.05", "--at", "2,0", "--json"];

#[test]
fn a_circle_is_known_in_closed_form() {
    let found = object(&[&["dynamics"], &TURN[..], &["--steps", "5000"]].concat());
    let keys: Vec<&str> = found.as_object().expect("an object").keys().map(String::as_str).collect();
    let wanted = "system steps ended ended_step lyapunov lyapunov_error spectrum spectrum_errors mean_log_det fli megno sali \
                  rotation drift extrema escaped";
    assert_eq!(keys, wanted.split(' ').collect::<Vec<_>>());
    // In the plane of x and ẋ, each step rotates clockwise by 2 atan(ε).
    let turns = &found["rotation"]["x"];
    assert!((number(&turns["value"]) + 0.05_f64.atan() / PI).abs() < 1e-13, "{turns}");
    assert!(number(&turns["error"]) < 1e-9);
    // The map preserves lengths, so all exponents vanish up to rounding.
    for exponent in found["spectrum"].as_array().expect("a list").iter().chain([&found["lyapunov"]]) {
        assert!(number(exponent).abs() < 1e-13);
    }
    assert!(number(&found["drift"]["R"]["max"]) < 1e-12);
    assert!((number(&found["extrema"]["x"][1]) - 2.0).abs() < 1e-3);
    assert_eq!((&found["escaped"], &found["steps"]), (&Value::Null, &5000.into()));
}

#[test]
fn linear_fields_have_the_exponents_of_their_multipliers() {
    let (slow, fast, eps) = (-0.5, 0.25, 0.1);
    let field = "xdot = -x/2; ydot = y/4 + x;";
    let found =
        object(&["dynamics", "--field", field, "--eps", "0.1", "--at", "1,1", "--steps", "4000", "--json"]);
    let exact = |rate: f64| ((1.0 + eps * rate) / (1.0 - eps * rate)).ln() / (2.0 * eps);
    let [first, second] = [0, 1].map(|k| number(&found["spectrum"][k]));
    // The initial tangent vectors change each exponent after the time t by O(1/t).
    assert!((first - exact(fast)).abs() < 2e-3 && (second - exact(slow)).abs() < 2e-3, "{first} {second}");
    let sum = exact(fast) + exact(slow);
    assert!((number(&found["mean_log_det"]) - sum).abs() < 1e-12 && (first + second - sum).abs() < 1e-12);
}

#[test]
fn an_orbit_that_overflows_is_told_and_kept() {
    let output = kahan(&[
        "dynamics",
        "--field",
        "xdot = x;",
        "--eps",
        "0.5",
        "--at",
        "1",
        "--steps",
        "1000",
        "--json",
    ]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("leaves the range of f64"), "{}", text(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).expect("an object");
    // The orbit 3ⁿ exceeds 10⁶ from n = 13 on.
    assert_eq!(found["escaped"], 13);
    assert_eq!((&found["ended"], &found["ended_step"]), (&"range".into(), &646.into()));
    for exponent in [&found["lyapunov"], &found["spectrum"][0]] {
        assert!((number(exponent) - 3.0_f64.ln()).abs() < 1e-13);
    }
}

#[test]
fn a_name_means_one_thing_whatever_else_is_asked() {
    let lorenz =
        ["dynamics", "lorenz", "--param", "s=10", "--param", "r=28", "--param", "b=8/3", "--eps", "1e-2"];
    for (start, steps) in
        [("1,1,1", "1"), ("-3,4,20", "2"), ("1,-5,9", "3"), ("1,1,1", "40"), ("1,1,1", "4000")]
    {
        let start = format!("--at={start}");
        let asked = [&lorenz[..], &[&start, "--steps", steps, "--json"]].concat();
        let all = object(&asked);
        let spectrum: Vec<f64> = all["spectrum"].as_array().expect("a list").iter().map(number).collect();
        assert!(spectrum.len() == 3 && spectrum.is_sorted_by(|one, other| one >= other), "{spectrum:?}");
        for [name, other] in [["lyapunov", "spectrum"], ["spectrum", "lyapunov"]] {
            let alone = object(&[&asked[..], &["--observe", name]].concat());
            assert_eq!((&alone[name], alone.get(other)), (&all[name], None));
        }
        let last = all["lyapunov"].as_f64().expect("a number");
        assert!(steps != "4000" || (last - spectrum[0]).abs() < 0.1, "{last} {spectrum:?}");
    }
}

#[test]
fn tables_name_what_they_show() {
    let table = answer(&["dynamics", "e6", "--eps", "0.05", "--at", "1,2,3", "--steps", "500"]);
    for part in
        ["Lyapunov exponent", "mean log |det J|", "MEGNO", "turns a step", "greatest drift", "escaped  no"]
    {
        assert!(table.contains(part), "{part}: {table}");
    }
    assert!(table.lines().all(|line| line.chars().count() <= 80));
}

/// For ẋ = x², 1/x falls by 2ε in each step, until it passes through 0.
#[test]
fn steps_over_poles_are_counted_where_they_are_asked_for() {
    let dense = |n: usize| -> String {
        let sum = (0..n).map(|j| format!("{}*x{j}*x{}", j + 1, (j + 1) % n)).collect::<Vec<_>>().join(" + ");
        (0..n).map(|i| format!("x{i}dot = ({sum}) + x{i}*(x0 + {i}*x{}); ", (i + 2) % n)).collect()
    };
    let (beyond, far) = (dense(7), "3,-2,1,4,-1,2,5");
    for (text, at, steps, is_lower_bound) in
        [("xdot = x^2;", "1", "8", false), ("xdot = x^2;", "1", "7", false), (&*beyond, far, "9", true)]
    {
        let asked = [
            "dynamics",
            "--field",
            text,
            "--eps",
            "0.07",
            "--at",
            at,
            "--steps",
            steps,
            "--observe",
            "passed_poles",
        ];
        let found = object(&[&asked[..], &["--json"]].concat());
        let keys: Vec<&str> = found.as_object().expect("an object").keys().map(String::as_str).collect();
        let wanted = ["system", "steps", "ended", "ended_step", "passed_poles", "passed_poles_lower_bound"];
        assert_eq!(keys, wanted);
        assert_eq!(found["passed_poles_lower_bound"], is_lower_bound);
        let (count, printed) = (found["passed_poles"].as_u64().expect("a count"), answer(&asked));
        let bound = if is_lower_bound { "at least " } else { "" };
        assert!(printed.ends_with(&format!("passed poles  {bound}{count}\n")), "{printed}");
        assert_eq!(count > 0, steps != "7", "{printed}");
    }
}

#[test]
fn exponents_have_the_digits_that_are_known() {
    let of_lorenz = ["dynamics", "lorenz", "--param", "s=10", "--param", "b=8/3", "--param"];
    let of_lorenz = [&of_lorenz[..], &["r=28", "--eps", "1e-2", "--at", "1,1,1", "--steps", "4000"]].concat();
    let of_e6 = vec!["dynamics", "e6", "--eps", "0.05", "--at", "1,2,3", "--steps", "4000"];
    for (arguments, is_regular) in [(of_lorenz, false), (of_e6, true)] {
        let table = answer(&arguments);
        let row = table.lines().find(|line| line.starts_with("1 ")).expect("the largest");
        let cells: Vec<&str> = row.split_whitespace().collect();
        let error: f64 = cells[2].parse().expect("a number");
        let places = cells[1].split_once('.').map_or(0, |(_, places)| places.len());
        assert_eq!(places as f64, (-error.log10().floor()).clamp(0.0, 8.0), "{row}");
        assert_eq!(table.contains("shows no chaos so far"), is_regular, "{table}");
    }
}

#[test]
fn sections_are_where_the_formula_vanishes() {
    let found = object(
        &[&["section"], &TURN[..], &["--steps", "500", "--plane", "y - x/2", "--direction", "both"]].concat(),
    );
    let points = found["points"].as_array().expect("a list");
    assert!(points.len() > 10);
    for (k, point) in points.iter().enumerate() {
        let (x, y) = (number(&point[0]), number(&point[1]));
        assert!((y - x / 2.0).abs() < 1e-14, "{point}");
        // Successive crossings are half a turn apart, and have equal radius.
        assert!((x.hypot(y) - 2.0).abs() < 1e-12, "{point}");
        assert_eq!(x > 0.0, k % 2 == 1, "{point}");
    }
    let times = found["times"].as_array().expect("a list");
    let period = number(&times[2]) - number(&times[0]);
    // A full turn takes π/atan(ε) steps of the time 2ε, with ε = 0.05.
    assert!((period - 0.1 * PI / 0.05_f64.atan()).abs() < 1e-4, "{period}");
    let few =
        answer(&["section", "e6", "--eps", "0.05", "--at", "1,2,3", "--plane", "H - 3", "--steps", "9"]);
    assert_eq!(few, "n,t,x,y,z\n");
    let first = [&["section"], &TURN[..6], &["--steps", "500", "--plane", "x - 1", "--points", "2"]].concat();
    assert_eq!(answer(&first).lines().count(), 3);
}

/// Each row begins with the number of its initial point, and with the values on the axes.
#[test]
fn sections_of_many_orbits_are_one_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("starts.csv");
    std::fs::write(&file, "x,y\n1,1/2\n1,3\n2,1/3\n2,1/2\n3/2,1\n").expect("a file");
    let common = ["section", "lv", "--plane", "y - 1", "--crossings", "3", "--transient", "7"];
    let rows = |more: &[&str]| {
        let table = answer(&[&common[..], more].concat());
        table.lines().map(str::to_owned).collect::<Vec<String>>()
    };
    let many = rows(&["--at", file.to_str().expect("a path"), "--over", "eps=0.05:0.1:2"]);
    assert_eq!((many[0].as_str(), many.len()), ("start,eps,n,t,x,y", 31));
    let alone = rows(&["--at", "2,1/3", "--eps", "0.1", "--order", "2"]);
    let third: Vec<String> = alone[1..].iter().map(|row| format!("2,0.1,{row}")).collect();
    assert_eq!(&many[16..19], third);
    let missing = refusal(&["section", "lv", "--eps", "0.1", "--at", "1,2", "--plane", "y - 1"]);
    assert!(missing.contains("--crossings K"), "{missing}");
}

/// A sign change at a pole of the map or of the formula is not a crossing.
#[test]
fn jumps_are_no_crossings() {
    let over_a_pole = ["section", "--field", "xdot = x^2 + 1; ydot = 1;", "--eps", "0.05", "--at", "0.1,0"];
    let over_a_pole = [&over_a_pole[..], &["--steps", "60"]].concat();
    let of_the_formula = ["section", "lv", "--eps", "0.1", "--at", "1/2,5/3", "--steps", "300"];
    let hole = ["section", "--field", "xdot = 1;", "--eps", "0.1", "--at", "-1", "--steps", "60"];
    for (start, plane, direction, expected) in [
        (&over_a_pole[..], "x", "falling", (0, 2)),
        (&over_a_pole[..], "x", "rising", (1, 0)),
        (&over_a_pole[..], "1/x", "both", (0, 3)),
        (&of_the_formula[..], "1/(x-1)", "rising", (0, 9)),
        (&hole[..], "1/x", "rising", (0, 1)),
        (&hole[..], "x^2/x", "rising", (1, 0)),
    ] {
        let asked = [start, &["--plane", plane, "--direction", direction]].concat();
        let found = object(&[&asked[..], &["--json"]].concat());
        let (points, jumps) = (found["points"].as_array().map(Vec::len), &found["jumps"]);
        assert_eq!((points, jumps), (Some(expected.0), &expected.1.into()), "{plane} {direction}");
        let output = kahan(&asked);
        assert_eq!((output.status.code(), text(&output.stdout).lines().count()), (Some(0), 1 + expected.0));
        let note = text(&output.stderr).to_owned();
        match expected.1 {
            0 => assert_eq!(note, ""),
            1 => assert!(note.starts_with("note: 1 jump: "), "{note}"),
            many => assert!(note.starts_with(&format!("note: {many} jumps: ")), "{note}"),
        }
    }
}

#[test]
fn mistakes_are_told() {
    for (plane, part) in [
        ("1 + eps", "one number everywhere"),
        ("w", "there are x, y, R, eps, pi"),
        ("x +", "missing"),
        ("x = 1", "`x - y` for `x = y`"),
    ] {
        let paragraph = refusal(&[&["section"], &TURN[..], &["--steps", "5", "--plane", plane]].concat());
        assert!(paragraph.replace('\n', " ").contains(part), "{plane}: {paragraph}");
    }
    assert!(refusal(&[&["dynamics"], &TURN[..], &["--steps", "0"]].concat()).contains("1 or more"));
    assert!(
        refusal(&[&["dynamics"], &TURN[..], &["--steps", "9", "--escape", "-1"]].concat()).contains("size")
    );
}

#[cfg(unix)]
#[test]
fn the_examples_of_the_help_run() {
    let folder = tempfile::tempdir().expect("a folder");
    assert_eq!(examples_run("dynamics", folder.path()), 4);
    assert_eq!(examples_run("section", folder.path()), 4);
    assert_eq!(examples_run("chart", folder.path()), 2);
}

/// Returns the cells of a table: both coordinates, and the colour if there is one.
fn cells(table: &str) -> Vec<[Option<f64>; 3]> {
    let cell = |text: &str| if text.is_empty() { None } else { Some(text.parse().expect("a number")) };
    let row =
        |line: &str| line.split(',').take(3).map(cell).collect::<Vec<_>>().try_into().expect("three cells");
    table.lines().skip(1).map(row).collect()
}

#[test]
fn charts_show_what_each_orbit_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let chart = |over: &[&str], further: &[&str], out: &str| {
        let field = "xdot = y; ydot = r*x; integral E = y^2 - r*x^2;";
        let given = ["--field", field, "--eps", "0.1", "--at", "1,0", "--steps", "100"];
        let over: Vec<&str> = over.iter().flat_map(|range| ["--over", range]).collect();
        answer(&[&["chart"], &given[..], &over, &["--out", out], further].concat());
        std::fs::read_to_string(out).expect("the file")
    };
    let table = chart(&["r=-4:4:/4", "x=0:2:/3"], &["--color", "lyapunov"], &file("r.csv"));
    assert_eq!(table.lines().next(), Some("r,x,lyapunov,ended,ended_step"));
    let rows = cells(&table);
    assert_eq!(rows.len(), 12);
    for [r, x, exponent] in rows {
        let (r, exponent) = (r.expect("r"), exponent.expect("an exponent"));
        assert!(
            x.is_some_and(|x| [1.0 / 3.0, 1.0, 5.0 / 3.0].iter().any(|middle| (x - middle).abs() < 1e-15))
        );
        // For ẋ = y, ẏ = rx, the largest exponent is atanh(ε√r)/ε if r > 0, and 0 if r < 0.
        let rate = if r < 0.0 { 0.0 } else { (0.1 * r.sqrt()).atanh() / 0.1 };
        assert!((exponent - rate).abs() < 0.1, "{r}: {exponent} and {rate}");
    }
    // Values do not depend on the order of the axes or on the number of threads.
    let mirrored = chart(&["x=0:2:/3", "r=-4:4:/4"], &["--color", "lyapunov"], &file("x.csv"));
    let mut turned: Vec<_> = cells(&mirrored).into_iter().map(|[x, r, value]| [r, x, value]).collect();
    let mut rows = cells(&table);
    let order = |a: &[Option<f64>; 3], b: &[Option<f64>; 3]| a.partial_cmp(b).expect("numbers");
    turned.sort_by(order);
    rows.sort_by(order);
    assert_eq!(rows, turned);
    // Because of `--at 1,0`, the chart over r alone has the values of the table's cells at x = 1.
    let column = chart(&["r=-4:4:/4"], &["--color", "lyapunov"], &file("c.csv"));
    let of_one: Vec<String> = rows
        .iter()
        .filter(|[_, x, _]| *x == Some(1.0))
        .map(|[r, _, value]| format!("{:?},{:?},complete,100\n", r.expect("r"), value.expect("an exponent")))
        .collect();
    assert_eq!(column, format!("r,lyapunov,ended,ended_step\n{}", of_one.concat()));
    let curve = chart(&["r=-4:4:/4"], &["--color", "lyapunov"], &file("c.svg"));
    assert!(curve.contains("per unit of t of field over r from -3 to 3, 100 steps each"), "{curve}");
    let points = |class: &str| {
        let shape = curve.split_once(&format!("class=\"{class}\" d=\"")).expect("a shape").1;
        shape.split('"').next().map_or(0, |shape| shape.matches(['M', 'L']).count())
    };
    assert_eq!([points("line"), points("dots")], [4, 4]);
    // Orbits escape if and only if r > 0.
    let escapes =
        cells(&chart(&["r=-4:4:/4", "x=1:2:/2"], &["--color", "escape", "--escape", "1e3"], &file("e.csv")));
    assert!(escapes.iter().all(|[r, _, step]| step.is_some() == r.is_some_and(|r| r > 0.0)), "{escapes:?}");
    // The cells of escaped orbits are empty, and the legend counts them.
    let bound = |out: &str| {
        chart(&["r=-4:4:/4", "x=1:2:/2"], &["--color", "lyapunov", "--escape", "1e3"], &file(out))
    };
    let table = bound("b.csv");
    for (line, [r, _, exponent]) in table.lines().skip(1).zip(cells(&table)) {
        let escapes = r.is_some_and(|r| r > 0.0);
        assert_eq!((exponent.is_none(), line.contains(",escaped,")), (escapes, escapes), "{line}");
    }
    assert!(bound("b.svg").contains("4 cells empty: 4 escaped"));
    // For r > 100, 1 − t²r vanishes for some t between 0 and ε = 1/10, so each step passes a pole.
    let poles = cells(&chart(&["r=0:200:/4", "x=1:2:/2"], &["--color", "passed_poles"], &file("s.csv")));
    let count = |r: &Option<f64>| Some(if *r > Some(100.0) { 100.0 } else { 0.0 });
    assert!(poles.iter().all(|[r, _, found]| *found == count(r)), "{poles:?}");
    let drifts = cells(&chart(&["r=-4:0:/2", "x=1:2:/2"], &["--color", "drift"], &file("d.csv")));
    assert!(drifts.iter().all(|[_, _, drift]| drift.is_some_and(|drift| drift < -12.0)), "{drifts:?}");
    let picture = chart(&["x=-1:1:/8", "y=-1:1:/8"], &["--color", "fli", "--param", "r=1"], &file("p.svg"));
    assert!(
        picture.contains("FLI of field over x from -1 to 1") && picture.contains("data:image/png;base64,")
    );
}

#[test]
fn charts_refuse_what_is_no_range() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("m.svg").to_str().expect("text").to_owned();
    for (over, part) in [
        (["x=0:1:/3"; 3].iter().flat_map(|range| ["--over", *range]).collect(), "one range or two"),
        (vec!["--over", "x=0:1:/3", "--over", "x=0:1:/3"], "gone through twice"),
        (vec!["--over", "w=0:1:/3"], "neither a variable nor a parameter"),
        (vec!["--over", "x=0:1:/3", "--over", "w=0:1:/3"], "neither a variable nor a parameter"),
        (vec!["--over", "x=0:1", "--over", "y=0:1:/3"], "--over x: `0:1` is no range"),
        (vec!["--over", "0:1:3"], "write NAME=FROM:TO:COUNT"),
        (vec!["--over", "x=0:1:/3", "--over", "y=0:1:/3", "--color", "drift"], "`kahan discover` prints"),
    ] {
        let given = [
            "chart",
            "--field",
            "xdot = y; ydot = -x;",
            "--eps",
            "0.1",
            "--at",
            "1,0",
            "--steps",
            "9",
            "--out",
            &out,
        ];
        let paragraph = refusal(&[&given[..], &over].concat());
        assert!(paragraph.replace('\n', " ").contains(part), "{over:?}: {paragraph}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("the folder").count(), 0);
}

#[test]
fn what_is_gone_through_has_no_other_value() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("m.svg").to_str().expect("text").to_owned();
    for command in ["chart", "picture", "periodic"] {
        let steps: &[&str] = if command == "periodic" { &[] } else { &["--steps", "9"] };
        let field = "xdot = r - x^2;";
        let given = [&[command, "--field", field, "--at", "1", "--out", &out], steps].concat();
        let over_r = [&given[..], &["--over", "r=1:2:+1/2", "--eps", "1/9"]].concat();
        let over_eps = [&given[..], &["--over", "eps=1/9:1/8:+1/72", "--param", "r=1"]].concat();
        answer(&over_r);
        answer(&over_eps);
        for (arguments, part) in [
            ([&over_r[..], &["--param", "r=7"]].concat(), "--over already varies r; leave --param r out"),
            ([&over_eps[..], &["--eps", "2"]].concat(), "--over already varies eps; leave --eps out"),
        ] {
            let paragraph = refusal(&arguments);
            assert!(paragraph.contains(part), "{arguments:?}: {paragraph}");
        }
    }
}

fn chart_of_rows(rows: &str, arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    std::fs::write(file("rows.csv"), rows).expect("the rows");
    let (from, out) = (file("rows.csv"), file("m.csv"));
    answer(&[&["chart", "--from", &from, "--out", &out], arguments].concat());
    std::fs::read_to_string(out).expect("the file")
}

const ROWS: &str =
    "y,p,order,sali,drift_H\n0.3,1,2,1e-2,3\n0.1,1,2,1,\n0.2,1,2,1e-4,5\n0.1,1,4,1e-3,7\n0.1,3,2,1e-6,9\n";

#[test]
fn charts_show_the_rows_of_a_file() {
    let of = |arguments: &[&str]| chart_of_rows(ROWS, arguments);
    assert_eq!(
        of(&["--over", "y", "--over", "p", "--where", "order=2"]),
        "y,p,log_sali\n0.1,1.0,0.0\n0.2,1.0,-4.0\n0.3,1.0,-2.0\n0.1,3.0,-6.0\n0.2,3.0,\n0.3,3.0,\n"
    );
    // If an axis is split into intervals, a cell shows the mean of the values in its interval.
    assert_eq!(
        of(&["--over", "y=0:0.6:/2", "--over", "p", "--column", "order"]),
        "y,p,order\n0.15,1.0,2.6666666666666665\n0.45,1.0,2.0\n0.15,3.0,2.0\n0.45,3.0,\n"
    );
    assert_eq!(
        of(&["--over", "p=4:0:/2", "--where", "y=0.1", "--column", "drift_H"]),
        format!("p,log_drift_H\n3.0,{:?}\n1.0,{:?}\n", 9_f64.log10(), 7_f64.log10())
    );
    assert_eq!(
        of(&["--over", "y", "--where", "p=1", "--where", "order=2"]),
        "y,log_sali\n0.1,0.0\n0.2,-4.0\n0.3,-2.0\n"
    );
    // A chart that is drawn from the table equals the original chart.
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let (table, picture, again) = (file("lv.csv"), file("lv.svg"), file("again.svg"));
    let given =
        ["chart", "lv", "--at", "1,1", "--over", "x=0:2:/9", "--over", "eps=0:1:/9", "--color", "fli"];
    answer(&[&given[..], &["--out", &table]].concat());
    answer(&[&given[..], &["--out", &picture]].concat());
    answer(&["chart", "--from", &table, "--over", "x", "--over", "eps", "--color", "fli", "--out", &again]);
    let image = |file: &str| {
        let picture = std::fs::read_to_string(file).expect("the picture");
        picture.split("base64,").nth(1).expect("an image").split('"').next().map(str::to_owned)
    };
    assert_eq!(image(&picture), image(&again));
}

#[test]
fn charts_of_rows_say_what_is_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
    let (rows, out) = (file("rows.csv"), file("m.svg"));
    std::fs::write(&rows, ROWS).expect("the rows");
    std::fs::write(file("bare.csv"), "1,2\n").expect("the rows");
    std::fs::write(file("plan.toml"), "").expect("the plan");
    let folder_of_parts = folder.path().to_str().expect("text").to_owned();
    let both = ["--over", "y", "--over", "p"];
    for (from, arguments, part) in [
        (&rows, &both[..], "2 rows have y = 1/10 and p = 1"),
        (&rows, &["--over", "y", "--over", "p", "--where", "order=3"], "there is 2, 4"),
        (&rows, &["--over", "y", "--over", "p", "--where", "order"], "not NAME=VALUE"),
        (&rows, &["--over", "y", "--over", "p", "--where", "order=4"], "`y` are not equally spaced"),
        (&rows, &["--over", "y", "--over", "w"], "no column `w`; it has y, p, order, sali, drift_H"),
        (&rows, &["--over", "y", "--over", "p", "--color", "fli"], "no column `fli`"),
        (&rows, &["--over", "y=0:1:/100000", "--over", "p=0:1:/100000"], "too many"),
        (&rows, &["--over", "y"], "3 rows have y = 1/10"),
        (&rows, &["--over", "y", "--over", "p", "--over", "order"], "one range or two"),
        (&rows, &["--over", "y", "--over", "p", "--eps", "1"], "cannot be used with"),
        (&file("bare.csv"), &both, "a line of its columns' names"),
        (&file("plan.toml"), &both, "no result that can be read"),
        (&file("none.csv"), &both, "No such file"),
        (&folder_of_parts, &both, "--merge"),
    ] {
        let paragraph = refusal(&[&["chart", "--from", from, "--out", &out], arguments].concat());
        assert!(paragraph.replace('\n', " ").contains(part), "{arguments:?}: {paragraph}");
    }
    assert!(!std::fs::exists(out).expect("a folder"));
}
