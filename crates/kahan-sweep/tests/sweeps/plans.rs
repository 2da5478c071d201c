//! Tests how plans are read, how mistakes are reported, and commands that compute nothing.

use std::fs;

use kahan_sweep::Plan;

use super::{PLAN, done, folder, sweep, text};

/// The hash of a plan identifies its results, so it must not change with names in the code.
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
