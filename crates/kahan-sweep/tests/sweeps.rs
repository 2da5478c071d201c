//! Sweeps as a user runs them: the same bytes however they are cut, and nothing wrong ever merged.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Duration;

use kahan_sweep::Plan;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

const PLAN: &str = r#"
seed = 3
draws = 40

[subject]
name = "euler"
[subject.params]
a1 = 1
a2 = -3

[question]
ask = "observe"
steps = 50
observe = ["final", "drift", "extrema", "lyapunov", "spectrum", "log_det", "fli", "megno", "sali", "rotation", "escape", "passed_poles"]
[question.over]
x = { draw = "sobol", low = 0.1, high = 1 }
y = { draw = "uniform", low = 0.1, high = 1 }
z = "1/2"
a3 = [1, 2]
eps = "0.01:0.05:5"
order = [2, 4]
scalar = ["f64", "f32"]

[output]
rows_per_part = 97
"#;

fn sweep(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"));
    command.arg("plan.toml").args(arguments).current_dir(folder).output().expect("the command runs")
}

/// Runs a sweep that must succeed; what it says.
fn done(folder: &Path, arguments: &[&str]) -> String {
    let output = sweep(folder, arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// A folder with a plan.
fn folder(plan: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("plan.toml"), plan).expect("the plan");
    folder
}

/// The merged file of an undisturbed run.
fn undisturbed(plan: &str) -> Vec<u8> {
    let folder = folder(plan);
    done(folder.path(), &["--out", "results"]);
    fs::read(folder.path().join("results/results.parquet")).expect("the results")
}

fn parts(results: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(results).expect("the folder").map(|entry| entry.expect("an entry").path());
    let mut parts: Vec<PathBuf> = entries.filter(|path| path.to_string_lossy().contains("part-")).collect();
    parts.sort();
    parts
}

#[test]
fn bytes_do_not_depend_on_shards_threads_and_order() {
    let expected = undisturbed(PLAN);
    for (shards, threads) in [(1, "1"), (3, "2"), (7, "3")] {
        let folder = folder(PLAN);
        for shard in (1..=shards).rev() {
            done(
                folder.path(),
                &["--out", "r", "--shard", &format!("{shard}/{shards}"), "--threads", threads],
            );
        }
        assert!(done(folder.path(), &["--out", "r", "--status"]).contains("17 of 17 parts are done"));
        done(folder.path(), &["--out", "r", "--merge"]);
        assert!(
            fs::read(folder.path().join("r/results.parquet")).expect("results") == expected,
            "{shards} {threads}"
        );
    }
}

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
fn a_killed_sweep_goes_on_and_ends_with_the_same_bytes() {
    // A part takes about as long as the longer waits, so that kills meet the first parts and later
    // ones.
    let plan = PLAN.replace("steps = 50", "steps = 100");
    let expected = undisturbed(&plan);
    let folder = folder(&plan);
    let mut kills = 0;
    for wait in (1..40).map(|k| Duration::from_millis(7 * k)) {
        let mut child = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"))
            .args(["plan.toml", "--out", "r"])
            .current_dir(folder.path())
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .expect("the command runs");
        std::thread::sleep(wait);
        if child.try_wait().expect("a state").is_some() {
            break;
        }
        child.kill().expect("it runs");
        child.wait().expect("it ended");
        kills += 1;
        let merged = sweep(folder.path(), &["--out", "r", "--merge"]);
        assert!(
            merged.status.code() == Some(1)
                || fs::read(folder.path().join("r/results.parquet")).expect("results") == expected
        );
    }
    assert!(kills > 0);
    // What others left who were killed while they looked, wrote a part, or merged.
    fs::create_dir_all(folder.path().join("r/part-000000000003.under-way")).expect("a folder");
    for name in [".probe-1", ".results-1", "part-000000000003.under-way/rows-1.parquet"] {
        fs::write(folder.path().join("r").join(name), "by halves").expect("a file");
    }
    done(folder.path(), &["--out", "r"]);
    assert!(fs::read(folder.path().join("r/results.parquet")).expect("results") == expected);
    // Nothing is left of those that were killed.
    let all =
        fs::read_dir(folder.path().join("r")).expect("the folder").map(|entry| entry.expect("an entry"));
    let names: Vec<String> = all.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    let is_result =
        |name: &String| name == "results.parquet" || name.ends_with(".parquet") && name.starts_with("part-");
    assert!(names.iter().all(is_result), "{names:?}");
}

#[cfg(unix)]
#[test]
fn files_have_the_rights_of_the_users_other_files() {
    use std::os::unix::fs::PermissionsExt;

    let folder = folder(PLAN);
    done(folder.path(), &["--out", "r"]);
    let rights = |name: &str| fs::metadata(folder.path().join(name)).expect(name).permissions().mode();
    for name in ["r/part-000000000000.parquet", "r/results.parquet"] {
        assert_eq!(rights(name), rights("plan.toml"), "{name}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_sweep_says_so_and_keeps_what_is_done() {
    let plan =
        PLAN.replace("steps = 50", "steps = 20000").replace("rows_per_part = 97", "rows_per_part = 800");
    let folder = folder(&plan);
    let child = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"))
        .args(["plan.toml", "--out", "r", "--threads", "2"])
        .current_dir(folder.path())
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("the command runs");
    let under_way = folder.path().join("r/part-000000000000.under-way");
    let noted = || fs::read_dir(&under_way).is_ok_and(|files| files.count() > 0);
    while !noted() {
        std::thread::sleep(Duration::from_millis(5));
    }
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(kill.success());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("the same command goes on"));
    // What was done of the part is noted.
    assert!(noted());
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let folder = folder(PLAN);
    let said = |arguments: &[&str], status: i32| {
        let output = sweep(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", text(&output.stderr));
        text(&output.stderr) + &text(&output.stdout)
    };
    assert!(said(&["--out", "r", "--merge"], 1).contains("17 of 17 parts are missing"));
    assert!(said(&["--out", "r", "--status"], 1).contains("missing: 0-16"));
    done(folder.path(), &["--out", "r"]);
    let expected = fs::read(folder.path().join("r/results.parquet")).expect("results");
    let [first, second] = &parts(&folder.path().join("r"))[..2] else { panic!("two parts") };
    let whole = fs::read(first).expect("a part");

    // A bit that flips anywhere, many of them in the footer, and a file that ends early.
    let footer = (1..60).map(|place| whole.len() - 61 * place);
    for place in [10, whole.len() / 2, whole.len() - 20].into_iter().chain(footer) {
        let mut damaged = whole.clone();
        damaged[place] ^= 4;
        fs::write(first, &damaged).expect("a part");
        let merged = sweep(folder.path(), &["--out", "r", "--merge"]);
        let is_refused =
            merged.status.code() == Some(1) && text(&merged.stderr).contains("part-000000000000");
        assert!(is_refused, "{place}: {}", text(&merged.stderr));
    }
    fs::write(first, &whole[..whole.len() - 100]).expect("a part");
    assert!(said(&["--out", "r", "--status"], 1).contains("damaged"));
    // A part under the name of another.
    fs::copy(second, first).expect("a part");
    assert!(said(&["--out", "r", "--merge"], 1).contains("another part under this name"));
    // The same command mends it.
    done(folder.path(), &["--out", "r"]);
    assert!(fs::read(folder.path().join("r/results.parquet")).expect("results") == expected);

    // Another plan in the same folder.
    fs::write(folder.path().join("plan.toml"), PLAN.replace("steps = 50", "steps = 51")).expect("a plan");
    assert!(said(&["--out", "r", "--merge"], 1).contains("belongs to another plan"));
    assert!(said(&["--out", "r"], 1).contains("belongs to another plan"));
    // The same plan, written otherwise.
    let other = PLAN.replace("\"1/2\"", "0.5").replace("seed = 3", "# The seed.\nseed=3");
    fs::write(folder.path().join("plan.toml"), other).expect("a plan");
    done(folder.path(), &["--out", "r", "--merge"]);
}

#[test]
fn two_processes_on_one_shard_do_no_harm() {
    let expected = undisturbed(PLAN);
    let folder = folder(PLAN);
    let children: Vec<_> = (0..2)
        .map(|_| {
            Command::new(env!("CARGO_BIN_EXE_kahan-sweep"))
                .args(["plan.toml", "--out", "r", "--shard", "1/1"])
                .current_dir(folder.path())
                .stdout(std::process::Stdio::null())
                .spawn()
                .expect("the command runs")
        })
        .collect();
    for mut child in children {
        assert!(child.wait().expect("it ends").success());
    }
    done(folder.path(), &["--out", "r", "--merge"]);
    assert!(fs::read(folder.path().join("r/results.parquet")).expect("results") == expected);
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

/// The hash of a plan tells whose results they are: it does not change with names in the code.
#[test]
fn a_plan_has_one_form_in_its_own_words() {
    let question = |text: &str| {
        let plan = Plan::read(text, "plan.toml").expect("a plan");
        let (_, question) = plan.canonical().split_once("\"question\":").expect("a question");
        question.split_once(",\"output\":").expect("the output").0.to_owned()
    };
    assert_eq!(
        question(PLAN),
        r#"{"ask":"observe","transient":0,"steps":50,"order":2,"renormalize":10,"spectrum":null,"escape":null,"reembed":false,"observe":["final","drift","extrema","lyapunov","spectrum","log_det","fli","megno","sali","rotation","escape","passed_poles"],"over":{"x":{"draw":"sobol","low":"1/10","high":"1"},"y":{"draw":"uniform","low":"1/10","high":"1"},"z":["1/2"],"a3":["1","2"],"eps":"1/100:1/20:5","order":["2","4"],"scalar":["f64","f32"]},"starts":[],"draws":40,"seed":3}"#
    );
    let plan = |question: &str| format!("[subject]\nname = \"lv\"\n[question]\n{question}");
    assert_eq!(
        question(&plan("ask = \"heights\"\nsteps = 12\nover = { x = 1, y = 1, eps = 1 }\n")),
        r#"{"ask":"heights","steps":12,"digits":1000000,"over":{"x":["1"],"y":["1"],"eps":["1"]},"starts":[],"draws":1,"seed":1}"#
    );
    assert_eq!(
        question(&plan("ask = \"discover\"\ndegree = 3\nover = { eps = 1 }\n")),
        r#"{"ask":"discover","degree":3,"over":{"eps":["1"]},"starts":[],"draws":1,"seed":1}"#
    );
}

#[test]
fn every_mistake_of_a_plan_is_told_with_its_line() {
    let folder = folder(
        "seed = -1\ndrows = 3\n[system]\n[subject]\nname = \"e66\"\n[question]\nask = \"observe\"\nover = { x = 1 }\n[output]\nrows = 3",
    );
    let output = sweep(folder.path(), &["--out", "r"]);
    assert_eq!(output.status.code(), Some(2));
    let said = text(&output.stderr);
    for part in [
        "plan.toml:1: seed",
        "plan.toml:2: the plan has no `drows`",
        "plan.toml:3: the plan has no `system`; write [subject]",
        "plan.toml:5: there is no system `e66`",
        "plan.toml:10: rows: unknown field `rows`",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    for (change, part) in [
        (
            (
                "x = { draw = \"sobol\", low = 0.1, high = 1 }",
                "x = { draw = \"halton\", low = 0.1, high = 1 }",
            ),
            "x: unknown variant `halton`",
        ),
        (
            ("x = { draw = \"sobol\", low = 0.1, high = 1 }", "x = { draw = \"sobol\", low = 2, high = 1 }"),
            "low is below high",
        ),
        (("z = \"1/2\"", "z = []"), "no values"),
        (("z = \"1/2\"", "z = 1\nw = 1"), "`w` is neither a variable nor a parameter"),
        (("z = \"1/2\"", "z = \"1/0\""), "z: `1/0` divides by zero"),
        (("z = \"1/2\"\n", ""), "`z` has no first value"),
        (("a2 = -3", "a2 = -3\na3 = 1"), "leave it out of one"),
        (("draws = 40\n", ""), "draws = 1000"),
        (("draws = 40", "draws = 4294967297"), "x: Sobol's sequence has 4294967296 points"),
        (
            ("steps = 50", "steps = 50\nscalar = \"f32\""),
            "`scalar` goes through values: it stands in [question.over]",
        ),
        (("order = [2, 4]", "order = { from = 2, to = 4, step = 2 }"), "a range is a text"),
        (("order = [2, 4]", "order = [2, 3]"), "order: 3 is none of 2, 4, 6, 8"),
        (("\"drift\"", "\"drifts\""), "observe: unknown variant `drifts`"),
        (("rows_per_part = 97", "rows_per_part = 97000000"), "rows_per_part is at most"),
        (("rows_per_part = 97", "columns = []"), "name at least one"),
        (("0.05:5\"", "0.05:5000000000\""), "too many for one file"),
        (("[question]", "[question]\nseconds = 5"), "no clock ends a row"),
        (("steps = 50", "steps = 50\neps = 1\nat = [1]"), "at: 3 coordinates x,y,z expected, 1 given"),
        (("seed = 3", "seed = 3\nseed = 4"), "duplicate key"),
    ] {
        let plan = PLAN.replace(change.0, change.1);
        assert_ne!(plan, PLAN);
        fs::write(folder.path().join("plan.toml"), plan).expect("a plan");
        let output = sweep(folder.path(), &["--out", "r"]);
        assert_eq!(output.status.code(), Some(2), "{change:?}");
        assert!(text(&output.stderr).contains(part), "{part}: {}", text(&output.stderr));
        assert_eq!(text(&output.stderr).matches("plan.toml:").count(), 1, "{}", text(&output.stderr));
    }
    assert!(!folder.path().join("r").exists());
}

#[test]
fn what_stands_in_a_wrong_place_is_not_missing_besides() {
    const STARTS: &str = "start = { file = \"starts.csv\" }";
    for (plan, part) in [
        (
            "[subject]\nname = \"e6\"\n[question]\nASK\nover.eps = 0.1\nover.STARTS\n",
            "plan.toml:7: start: unknown field `file`",
        ),
        (
            "STARTS\n[subject]\nname = \"e6\"\n[question]\nASK\nover.eps = 1\n",
            "plan.toml:1: the plan has no `start`",
        ),
        (
            "[subject]\nname = \"e6\"\nSTARTS\n[question]\nASK\nover.eps = 1\n",
            "plan.toml:3: start: unknown field `start`",
        ),
        (
            "[subject]\nname = \"e6\"\n[question]\nASK\nSTARTS\nover.eps = 1\n",
            "plan.toml:6: start: unknown field `start`",
        ),
        (
            "[subject]\nname = \"e6\"\n[question]\nASK\n[question.over]\neps = 0.1\nx = 1\ny = \"0:1\"\nz = 1\n",
            "plan.toml:9: y: `0:1` is no range",
        ),
    ] {
        let folder = folder(&plan.replace("STARTS", STARTS).replace("ASK", "ask = \"observe\"\nsteps = 9"));
        let output = sweep(folder.path(), &["--out", "r"]);
        assert_eq!(output.status.code(), Some(2));
        let said = text(&output.stderr);
        assert!(said.contains(part), "{part}: {said}");
        assert_eq!(said.matches("plan.toml:").count(), 1, "{said}");
    }
}

/// Two first points as NumPy writes them.
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
    // The plan is found from another folder, and its file beside it.
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
    // The same numbers are the same plan, and others are foreign: 0.001 is no double.
    let foreign = |output: Output| {
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(1) && said.contains("belongs to another plan"), "{said}");
    };
    foreign(written("F.npy", &array([1.0, 2.0, 0.5, 0.5, 0.001, -0.75])));
    foreign(written("F.csv", b"1,2,0.5\n1/2,1/8,-3/4\n"));
    fs::remove_dir_all(here("r")).expect("the results");
    same(written("F.csv", b"1,2,0.5\n1/2,1/8,-3/4\n"));
    same(written("F.npy", &array([1.0, 2.0, 0.5, 0.5, 0.125, -0.75])));
    // A result is a file of points, too: each stands there once for each eps.
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
fn a_dry_run_and_job_descriptions_run_nothing() {
    let folder = folder(PLAN);
    let said = done(folder.path(), &["--dry-run"]);
    assert!(said.contains("points     1600") && said.contains("parts      17"), "{said}");
    let script = done(folder.path(), &["--for", "slurm", "--shards", "5", "--out", "my results"]);
    assert!(script.contains("--array=1-5") && script.contains("--out 'my results'"), "{script}");
    let job = done(folder.path(), &["--for", "kubernetes", "--shards", "5"]);
    assert!(job.contains("completions: 5") && job.contains("completionMode: Indexed"), "{job}");
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 1);
}

#[test]
fn a_launcher_says_which_shard_this_is() {
    let folder = folder(PLAN);
    let launched = |variables: &[(&str, &str)]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"));
        command.args(["plan.toml", "--out", "r"]).current_dir(folder.path());
        command.envs(variables.iter().copied()).output().expect("the command runs")
    };
    let output = launched(&[("OMPI_COMM_WORLD_RANK", "1"), ("OMPI_COMM_WORLD_SIZE", "4")]);
    assert_eq!(output.status.code(), Some(0));
    assert!(text(&output.stderr).contains("task 2 of 4"), "{}", text(&output.stderr));
    let names: Vec<String> =
        parts(&folder.path().join("r")).iter().map(|path| path.to_string_lossy().into_owned()).collect();
    assert!(names.len() == 4 && names[0].ends_with("part-000000000001.parquet"));
    assert_eq!(launched(&[("JOB_COMPLETION_INDEX", "1")]).status.code(), Some(2));
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
