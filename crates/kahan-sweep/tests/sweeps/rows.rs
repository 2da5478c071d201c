//! Tests the rows of results, and sweeps that read initial states from files.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

use super::{PLAN, done, folder, sweep, text};

#[test]
fn a_row_is_what_the_library_says_of_its_point() {
    let folder = folder(PLAN);
    done(folder.path(), &["--out", "r"]);
    let file = fs::File::open(folder.path().join("r/results.parquet")).expect("results");
    let reader = SerializedFileReader::new(file).expect("Parquet");
    let rows: Vec<Vec<(String, Field)>> = reader
        .get_row_iter(None)
        .expect("rows")
        .map(|row| {
            row.expect("a row").get_column_iter().map(|(name, field)| (name.clone(), field.clone())).collect()
        })
        .collect();
    assert_eq!(rows.len(), 40 * 2 * 5 * 2 * 2);
    let double = |row: &[(String, Field)], name: &str| match row.iter().find(|(known, _)| known == name) {
        Some((_, Field::Double(value))) => *value,
        other => panic!("{name}: {other:?}"),
    };
    let whole = |row: &[(String, Field)], name: &str| match row.iter().find(|(known, _)| known == name) {
        Some((_, Field::Long(value))) => *value,
        other => panic!("{name}: {other:?}"),
    };
    let field = kahan_runtime::Field::parse(kahan_systems::registry::find("euler").expect("euler").text())
        .expect("a field");
    for (index, row) in rows.iter().enumerate() {
        assert_eq!(whole(row, "index"), index as i64);
        let is_f32 = row.contains(&("scalar".to_owned(), Field::Str("f32".to_owned())));
        if whole(row, "order") != 2 || is_f32 {
            continue;
        }
        let exact = |name: &str| kahan_runtime::Rational::from_f64(double(row, name)).expect("a number");
        let map = field.with([("a1", 1.into()), ("a2", (-3).into()), ("a3", exact("a3"))]).expect("a map");
        let mut x = [double(row, "x"), double(row, "y"), 0.5];
        map.at(double(row, "eps")).advance(&mut x, 50).expect("three variables");
        assert_eq!(whole(row, "ended_step"), 50);
        assert_eq!(x, ["final_x", "final_y", "final_z"].map(|name| double(row, name)));
        assert!(double(row, "drift_H") < 1e-12 && double(row, "least_x") <= x[0]);
        let spectrum = [1, 2, 3].map(|k| double(row, &format!("spectrum_{k}")));
        assert!(spectrum.is_sorted_by(|one, other| one >= other), "{spectrum:?}");
        let sum: f64 = spectrum.iter().sum();
        assert!((sum - double(row, "mean_log_det")).abs() < 1e-9);
    }
}

#[test]
fn exact_tasks_are_swept() {
    let heights = folder(
        "[subject]\nname = \"lv\"\n[question]\nask = \"heights\"\nsteps = 12\n[question.over]\nx = [\"1/2\", \"1/3\"]\ny = \"5/3\"\neps = \"9/14\"\n",
    );
    done(heights.path(), &["--out", "r"]);
    let discover = folder(
        "[subject]\nfield = \"xdot = y; ydot = a*x^2 - 2;\"\n[question]\nask = \"discover\"\nover = { a = \"1:3:+1\", eps = \"1/10\" }\n",
    );
    done(discover.path(), &["--out", "r"]);
    let column = |folder: &Path, name: &str| -> Vec<Field> {
        let file = fs::File::open(folder.join("r/results.parquet")).expect("results");
        let reader = SerializedFileReader::new(file).expect("Parquet");
        let rows = reader.get_row_iter(None).expect("rows");
        rows.map(|row| {
            let row = row.expect("a row");
            row.get_column_iter().find(|(known, _)| *known == name).expect("the column").1.clone()
        })
        .collect()
    };
    assert_eq!(column(heights.path(), "growth"), vec![Field::Str("exponential".to_owned()); 2]);
    assert_eq!(column(discover.path(), "independent_integrals"), vec![Field::Long(1); 3]);
}

fn array(numbers: [f64; 6]) -> Vec<u8> {
    let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }\n";
    let numbers: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    [b"\x93NUMPY\x01\x00", &[header.len() as u8, 0][..], header.as_bytes(), &numbers].concat()
}

const OF_FILE: &str = r#"
starts = "points/F.csv"
[subject]
name = "e6"
[question]
ask = "observe"
steps = 3
observe = ["final"]
[question.over]
eps = [0.125, 0.25]
"#;

#[test]
fn rows_of_files_are_first_points_whatever_the_file() {
    let folder = folder(OF_FILE);
    let here = |name: &str| folder.path().join(name);
    fs::create_dir(here("points")).expect("a folder");
    let written = |name: &str, bytes: &[u8]| {
        fs::write(here("points").join(name), bytes).expect("points");
        fs::write(here("plan.toml"), OF_FILE.replace("F.csv", name)).expect("the plan");
        let mut command = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"));
        let run = command.arg(here("plan.toml")).arg("--out").arg(here("r"));
        run.output().expect("the command runs")
    };
    let same = |output: Output| assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    same(written("F.csv", b"z,w,x,y\n1/2,9,1,2\n-0.75,,0.5,1e-3\n"));
    let mut read = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"));
    let read = read.arg("--read").arg(here("r/results.parquet")).args(["--columns", "index,x,y,z,eps"]);
    assert_eq!(
        text(&read.output().expect("the command runs").stdout),
        "index,x,y,z,eps\n0,1.0,2.0,0.5,0.125\n1,1.0,2.0,0.5,0.25\n2,0.5,0.001,-0.75,0.125\n3,0.5,0.001,-0.75,0.25\n"
    );
    // Other initial states belong to another plan. The double 0.001 is not the decimal 1e-3.
    let foreign = |output: Output| {
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(1) && said.contains("belongs to another plan"), "{said}");
    };
    foreign(written("F.npy", &array([1.0, 2.0, 0.5, 0.5, 0.001, -0.75])));
    foreign(written("F.csv", b"1,2,0.5\n1/2,1/8,-3/4\n"));
    fs::remove_dir_all(here("r")).expect("the results");
    same(written("F.csv", b"1,2,0.5\n1/2,1/8,-3/4\n"));
    same(written("F.npy", &array([1.0, 2.0, 0.5, 0.5, 0.125, -0.75])));
    // Results can serve as initial states; each state occurs once for each ε.
    let swept = fs::read(here("r/results.parquet")).expect("results");
    foreign(written("F.parquet", &swept));
    fs::remove_dir_all(here("r")).expect("the results");
    same(written("F.csv", b"1,2,0.5\n1,2,0.5\n1/2,1/8,-3/4\n1/2,1/8,-3/4\n"));
    same(written("F.parquet", &swept));
}

#[test]
fn what_is_wrong_with_a_file_of_first_points_is_told_where_the_plan_names_it() {
    let folder = folder(OF_FILE);
    fs::create_dir(folder.path().join("points")).expect("a folder");
    let said = |plan: &str| {
        fs::write(folder.path().join("plan.toml"), plan).expect("the plan");
        let output = sweep(folder.path(), &["--dry-run"]);
        assert_eq!(output.status.code(), Some(2), "{plan}");
        text(&output.stderr)
    };
    assert!(said(OF_FILE).contains("plan.toml:2: starts: points/F.csv cannot be read: "));
    for (file, part) in [
        ("x,y\n1,2\n", "has no column `z`; it has x, y"),
        ("x,y,z\n1,2,3\n1,,3\n", "has no number for y in row 2"),
        ("x,y,z\n1,2,inf\n", "cannot be read: `inf` of column `z` in line 2 is no number"),
        ("x,y,z\n", "has no rows"),
        ("1,2\n", "first points are rows of 3: x,y,z"),
    ] {
        fs::write(folder.path().join("points/F.csv"), file).expect("a file");
        let said = said(OF_FILE);
        assert!(
            said.starts_with("error: plan.toml:2: starts: points/F.csv ") && said.contains(part),
            "{said}"
        );
    }
    fs::write(folder.path().join("points/F.csv"), "1,2,3\n").expect("a file");
    fs::write(folder.path().join("points/F.parquet"), "1,2,3\n").expect("a file");
    fs::write(folder.path().join("points/F.npy"), array([1.0, 2.0, 3.0, 1.0, 2.0, f64::INFINITY]))
        .expect("a file");
    for (from, to, part) in [
        ("F.csv", "F.txt", "plan.toml:2: starts: points/F.txt is none of F.parquet, F.csv and F.npy"),
        ("F.csv", "F.parquet", "plan.toml:2: starts: points/F.parquet cannot be read"),
        ("F.csv", "F.npy", "plan.toml:2: starts: points/F.npy has no number for z in row 2"),
        ("over]", "over]\ny = 1", "plan.toml:10: `y` is gone through twice"),
        (
            "ask = \"observe\"\nsteps = 3\nobserve = [\"final\"]",
            "ask = \"discover\"",
            "plan.toml:2: starts: \"discover\" has none",
        ),
    ] {
        let said = said(&OF_FILE.replace(from, to));
        assert!(said.contains(part) && said.matches("plan.toml:").count() == 1, "{part}: {said}");
    }
}

#[test]
fn what_is_usual_is_observed_of_a_field_without_integrals() {
    let plan = "[subject]\nfield = \"xdot = x - x^2;\"\n[question]\nask = \"observe\"\nsteps = 9\n\
                over = { x = [0.5, 2], eps = 0.1 }\n";
    let folder = folder(plan);
    done(folder.path(), &["--out", "r"]);
    fs::write(folder.path().join("plan.toml"), plan.replace("steps", "observe = [\"drift\"]\nsteps"))
        .expect("a plan");
    let output = sweep(folder.path(), &["--out", "r"]);
    let said = text(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains("plan.toml:5: observe: drift"), "{said}");
}

#[test]
fn results_are_read_as_text() {
    const ROWS: &str = r#"
[subject]
name = "e6"
[question]
ask = "observe"
steps = 3
order = 2
observe = ["escape"]
[question.over]
x = [1, 2]
y = "0:1/3:2"
z = 0.1
eps = 0.05
"#;
    let folder = folder(ROWS);
    done(folder.path(), &["--out", "results"]);
    let read = |columns: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"));
        let read = command.args(["--read", "results/results.parquet"]).args(columns);
        read.current_dir(folder.path()).output().expect("the command runs")
    };
    let third = 1.0 / 3.0;
    assert_eq!(
        text(&read(&["--columns", "y,x,escaped,x"]).stdout),
        format!(
            "y,x,escaped,x\n0.0,1.0,NaN,1.0\n{third},1.0,NaN,1.0\n0.0,2.0,NaN,2.0\n{third},2.0,NaN,2.0\n"
        )
    );
    assert!(text(&read(&[]).stdout).starts_with("index,x,y,"));
    let unknown = read(&["--columns", "w"]);
    assert!(
        unknown.status.code() == Some(2)
            && text(&unknown.stderr).contains("no column `w`; it has index, x, y")
    );
    assert_eq!(sweep(folder.path(), &["--read", "results/results.parquet"]).status.code(), Some(2));
}
