//! Tests `--at` with a file, which gives one orbit for each row.

use super::chains::{numpy, numpy_of};
use super::*;
use crate::running;

fn file(folder: &TempDir, text: &str) -> String {
    let path = folder.path().join("starts.csv");
    fs::write(&path, text).expect("a file");
    path_text(&path).to_owned()
}

fn orbits<'a>(at: &'a str, further: &[&'a str]) -> Vec<&'a str> {
    [&["lv", "--eps", "1/7", "--steps", "5", "--at", at], further].concat()
}

#[test]
fn a_file_of_one_row_is_the_point_written_out() {
    let folder = folder();
    for further in [&["--scalar", "exact"][..], &["--scalar", "exact", "--json"], &["--scalar", "dd"], &[]] {
        let written = answer(&orbits("1/3,0.1", further));
        for text in [
            "1/3,0.1\n",
            "y,x\n0.1,1/3\n",
            "\"x\", y\r\n\r\n1/3 , 0.1",
            "# y,x\n0.1,1/3\n",
            "# two starts\n# x y\n1/3,0.1\n# no more\n",
            ",y,x\n0,0.1,1/3\n",
        ] {
            assert_eq!(answer(&orbits(&file(&folder, text), further)), written, "{text:?} {further:?}");
        }
    }
    // The number 0.1 in an array is the nearest float.
    let array = folder.path().join("starts.npy");
    numpy(&array, "(1, 2)", &[0.1, 3.0]);
    let of_array = answer(&orbits(path_text(&array), &["--scalar", "exact"]));
    let tenth = "3602879701896397/36028797018963968";
    assert_eq!(of_array, answer(&orbits(&format!("{tenth},3"), &["--scalar", "exact"])));
    numpy_of(&array, "[('y', '<f8'), ('x', '<f8')]", "(1,)", &[3.0, 0.1]);
    assert_eq!(of_array, answer(&orbits(path_text(&array), &["--scalar", "exact"])));
}

#[test]
fn a_column_that_means_something_else_is_refused() {
    let folder = folder();
    let field = [
        "orbit",
        "--field",
        "xdot = k1*y; ydot = -x;",
        "--param",
        "k1=1",
        "--eps",
        "1/7",
        "--steps",
        "3",
        "--at",
    ];
    for (names, said) in [
        (
            "x,y,k1",
            "has a column `k1`, and a parameter has one value here: leave the column out and give --param k1=V",
        ),
        ("k1,y,x", "has a column `k1`, and a parameter"),
        (
            "x,eps,y",
            "has a column `eps`, and the step has one value here: leave the column out and give --eps V",
        ),
        ("n,y,x", "has a column that cannot be used, `n`: leave out all but x, y"),
        (",y,x", "cannot be used, one without a name (pandas writes none with index=False)"),
    ] {
        let path = file(&folder, &format!("{names}\n1,2,3\n"));
        let refused = running::refusal(&[&field[..], &[&path]].concat()).replace('\n', " ");
        assert!(refused.contains(said), "{refused}");
    }
}

#[test]
fn of_several_rows_each_begins_an_orbit() {
    let folder = folder();
    let starts = ["1/3,1/2", "1,2", "5/7,0.3"];
    let path = file(&folder, &format!("x,y\n{}\n", starts.join("\n")));
    for further in [
        &["--scalar", "exact"][..],
        &["--every", "2"],
        &["--scalar", "f32", "--order", "4"],
        &["--projective", "--scalar", "exact"],
        &["--projective"],
    ] {
        let (names, rows) = table(&answer(&orbits(&path, further)));
        let mut expected = Vec::new();
        for (index, start) in starts.iter().enumerate() {
            let (own_names, own) = table(&answer(&orbits(start, further)));
            assert_eq!(names, [&["start".to_owned()], &own_names[..]].concat());
            expected.extend(own.into_iter().map(|row| [vec![index.to_string()], row].concat()));
        }
        assert_eq!(rows, expected, "{further:?}");
        let object: Value =
            serde_json::from_str(&answer(&orbits(&path, &[further, &["--json"]].concat()))).expect("JSON");
        assert_eq!(object["columns"], json!(names));
        assert_eq!(object["stopped"], json!([null, null, null]));
        let listed = object["rows"].as_array().expect("rows");
        let orbits_and_steps = |cells: &[Value]| [cells[0].to_string(), cells[1].to_string()];
        let firsts: Vec<_> =
            listed.iter().map(|row| orbits_and_steps(row.as_array().expect("a row"))).collect();
        assert_eq!(firsts, rows.iter().map(|row| [row[0].clone(), row[1].clone()]).collect::<Vec<_>>());
    }
}

#[test]
fn an_orbit_that_ends_early_ends_alone() {
    // For E1 at ε = −1/4, the third step from x = 2/3 meets a pole.
    let folder = folder();
    let path = file(&folder, "x,y,z\n1/9,1,1\n2/3,1,1\n1/8,1,1\n2/3,1,1\n");
    let asked = ["e1", "--eps", "-1/4", "--at", &path, "--steps", "4", "--scalar", "exact"];
    let output = kahan(&asked);
    assert_eq!(output.status.code(), Some(1));
    let (_, rows) = table(&text(&output.stdout));
    let length = |orbit: &str| rows.iter().filter(|row| row[0] == orbit).count();
    assert_eq!(["0", "1", "2", "3"].map(length), [5, 3, 5, 3]);
    let told = text(&output.stderr);
    assert!(told.contains("2 of 4 orbits end early, the first of them is orbit 1: "), "{told}");
    assert!(told.contains("at n = 2 det A = 0"), "{told}");
    let object: Value =
        serde_json::from_slice(&kahan(&with(&asked, &["--json".to_owned()])).stdout).expect("JSON");
    let stopped = object["stopped"].as_array().expect("a list");
    assert_eq!(stopped.iter().map(Value::is_null).collect::<Vec<_>>(), [true, false, true, false]);
}

#[test]
fn what_is_no_first_point_is_told() {
    let folder = folder();
    let told = |path: &str, part: &str| {
        let paragraph =
            running::refusal(&["orbit", "lv", "--eps", "1", "--at", path, "--steps", "1"]).replace('\n', " ");
        assert!(paragraph.contains(part) && paragraph.contains("--at"), "{part}: {paragraph}");
    };
    for (content, part) in [
        ("x,z\n1,2\n", "has no column `y`; it has x, z"),
        ("x,y,x\n1,2,3\n", "two columns `x`"),
        ("1,2,3\n", "has 1 x 3 numbers, and first points are rows of 2: x,y"),
        ("x,y\n", "has no rows"),
        ("", "has no rows"),
        ("x,y\n1,2\n1,\n", "has no number for y in row 2"),
        ("x,y\n1,2\n1/0,2\n", "`1/0` of column `x` in line 3 is no number"),
        ("# x y\n1 2\n3 4\n", "commas stand between numbers"),
        ("x,y\n1,2\n1e400,2\n", "x is beyond the range of f64; use --scalar exact"),
    ] {
        told(&file(&folder, content), part);
    }
    told("no.csv", "cannot read the file no.csv");
    let other = folder.path().join("starts.txt");
    fs::write(&other, "1,2\n").expect("a file");
    told(path_text(&other), "ends in .csv or .npy");
    let array = folder.path().join("starts.npy");
    for (shape, values, part) in [
        ("(2,)", &[1.0, 2.0][..], "has 2 numbers, and first points are rows of 2: x,y"),
        ("(1, 1, 2)", &[1.0, 2.0], "has 1 x 1 x 2 numbers"),
        ("(0, 2)", &[], "has no rows"),
        ("(1, 2)", &[1.0, f64::NAN], "has no number for y in row 1"),
    ] {
        numpy(&array, shape, values);
        told(path_text(&array), part);
    }
}

#[test]
fn names_decide_in_every_command() {
    let folder = folder();
    let path = file(&folder, "# z,x,y\n0.3,0.1,1/5\n");
    for asked in [
        &["eval", "e6", "--eps", "1/7"][..],
        &["orbit", "e6", "--eps", "1/7", "--steps", "9"],
        &["dynamics", "e6", "--eps", "1/7", "--steps", "99"],
        &["section", "e6", "--eps", "1/7", "--steps", "99", "--plane", "x - y", "--direction", "both"],
        &["lift", "--field", "xdot = y; ydot = -sin(x) - z; zdot = -z;"],
        &[
            "orbit",
            "--field",
            "xdot = y; ydot = -sin(x) - z; zdot = -z;",
            "--lift",
            "--eps",
            "1/7",
            "--steps",
            "9",
        ],
    ] {
        let at = |at: &str| running::answer(&[asked, &["--at", at]].concat());
        assert_eq!(at(&path), at("0.1,1/5,0.3"), "{asked:?}");
        let wrong = file(&folder, "z,y,w\n1,2,3\n");
        let refused = running::refusal(&[asked, &["--at", &wrong]].concat()).replace('\n', " ");
        assert!(refused.contains("has no column `x`; it has z, y, w"), "{asked:?}: {refused}");
        file(&folder, "# z,x,y\n0.3,0.1,1/5\n");
    }
    let out = folder.path().join("chart.csv");
    let chart =
        ["chart", "e6", "--eps", "1/7", "--over", "x=0:1:3", "--color", "fli", "--out", path_text(&out)];
    let cells = |at: &str| {
        running::answer(&[&chart[..], &["--steps", "9", "--at", at]].concat());
        fs::read_to_string(&out).expect("a table")
    };
    assert_eq!(cells(&path), cells("0.1,1/5,0.3"));
    let wrong = file(&folder, "z,y,w\n1,2,3\n");
    let out = folder.path().join("picture.svg");
    for asked in [
        &["heights", "e6", "--eps", "1/7", "--steps", "3"][..],
        &["periodic", "e6", "--eps", "1/7"],
        &["trade", "e6", "--horizon", "1"],
        &[&chart[..], &["--steps", "9"]].concat(),
        &["picture", "e6", "--eps", "1/7", "--steps", "9", "--out", path_text(&out)],
    ] {
        let refused = running::refusal(&[asked, &["--at", &wrong]].concat()).replace('\n', " ");
        assert!(refused.contains("has no column `x`; it has z, y, w"), "{asked:?}: {refused}");
    }
}

#[test]
fn other_commands_take_a_file_of_one_row_and_pictures_several() {
    let folder = folder();
    let one = file(&folder, "y,x\n2,1/3\n");
    let eval = |at: &str| running::answer(&["eval", "lv", "--eps", "1/7", "--at", at]);
    assert_eq!(eval(&one), eval("1/3,2"));
    let several = file(&folder, "1/3,2\n1,2\n");
    let told = running::refusal(&["eval", "lv", "--eps", "1/7", "--at", &several]).replace('\n', " ");
    assert!(told.contains("has 2 rows, and here one point is asked for"), "{told}");
    let picture = |at: &[&str]| {
        let out = folder.path().join("orbits.svg");
        let starts: Vec<&str> = at.iter().flat_map(|at| ["--at", at]).collect();
        let asked = ["picture", "lv", "--eps", "1/7", "--steps", "9", "--out", path_text(&out)];
        running::answer(&[&asked[..], &starts].concat());
        fs::read_to_string(&out).expect("a picture")
    };
    assert_eq!(picture(&[&several]), picture(&["1/3,2", "1,2"]));
}

/// Each pair of a start and a value on the axes gives the same orbit as a call with only this pair.
#[test]
fn ranges_give_an_orbit_for_each_value_and_start() {
    let folder = folder();
    let path = file(&folder, "x,y\n1/3,1/2\n1/5,2\n");
    let field = ["--field", "xdot = a*x*(1 - y); ydot = y*(x - b);", "--steps", "6", "--every", "3"];
    for further in
        [&[][..], &["--scalar", "exact"], &["--transient", "2", "--order", "4"], &["--method", "rk4"]]
    {
        let with = |more: &[&str]| table(&answer(&[&field[..], further, more].concat()));
        let (names, rows) =
            with(&["--at", &path, "--param", "b=1", "--over", "a=1:2:+1/2", "--over", "eps=1/8:1/4:2"]);
        let mut expected = Vec::new();
        for (index, start) in ["1/3,1/2", "1/5,2"].iter().enumerate() {
            for (a, eps) in ["1", "3/2", "2"].into_iter().flat_map(|a| ["1/8", "1/4"].map(|eps| (a, eps))) {
                let (own_names, own) =
                    with(&["--at", start, "--param", "b=1", "--param", &format!("a={a}"), "--eps", eps]);
                assert_eq!(names, [&["start", "a", "eps"].map(str::to_owned)[..], &own_names].concat());
                let shown = |text: &str| match (further.contains(&"exact"), text) {
                    (true, text) => text.to_owned(),
                    (_, "3/2") => "1.5".to_owned(),
                    (_, "1/8") => "0.125".to_owned(),
                    (_, "1/4") => "0.25".to_owned(),
                    (_, text) => format!("{text}.0"),
                };
                let place = [index.to_string(), shown(a), shown(eps)];
                expected.extend(own.into_iter().map(|row| [&place[..], &row].concat()));
            }
        }
        assert_eq!(rows, expected, "{further:?}");
    }
    let line = [&field[..], &["--at", "1,2", "--param", "a=1", "--param", "b=1", "--eps", "1/8", "--json"]];
    let object = |more: &[&str]| -> Value {
        serde_json::from_str(&answer(&[&line.concat(), more].concat())).expect("JSON")
    };
    let object = object(&["--over", "y=1:3:3"]);
    assert_eq!(object["columns"], json!(["start", "y_", "n", "t", "x", "y"]));
    assert_eq!(object["ended"], json!(["complete", "complete", "complete"]));
    for (more, said) in [
        (&["--over", "c=0:1:2"][..], "--over: "),
        (&["--over", "y=0:1:2", "--over", "y=0:1:2"], "--over: "),
        (&["--over", "a=0:1:2"], "--over already varies a; leave --param a out"),
        (&["--over", "y"], "write NAME=FROM:TO:COUNT"),
    ] {
        let refused = running::refusal(&[&["orbit"], &line.concat()[..], more].concat());
        assert!(refused.contains(said), "{refused}");
    }
}

#[test]
fn a_transient_is_not_printed() {
    let (_, whole) = table(&answer(&["lv", "--eps", "1/7", "--at", "1/3,0.1", "--steps", "9"]));
    let late = ["lv", "--eps", "1/7", "--at", "1/3,0.1", "--steps", "6", "--transient", "3", "--every", "2"];
    let (_, rows) = table(&answer(&late));
    assert_eq!(rows, whole.iter().skip(3).step_by(2).cloned().collect::<Vec<_>>());
}
