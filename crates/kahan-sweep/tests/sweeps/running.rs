//! Tests sweeps that are killed, interrupted, started by launchers, and merged.

use std::fs;
use std::process::Command;
use std::time::Duration;

use super::{PLAN, done, folder, parts, sweep, text, undisturbed};

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
fn a_killed_sweep_goes_on_and_ends_with_the_same_bytes() {
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
    // Creates the files that killed processes leave.
    fs::create_dir_all(folder.path().join("r/part-000000000003.under-way")).expect("a folder");
    for name in [".probe-1", ".results-1", "part-000000000003.under-way/rows-1.parquet"] {
        fs::write(folder.path().join("r").join(name), "by halves").expect("a file");
    }
    done(folder.path(), &["--out", "r"]);
    assert!(fs::read(folder.path().join("r/results.parquet")).expect("results") == expected);
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

    // Flips one bit of the first part, at various positions, most of them in the footer.
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
    // A part is stored under the name of another part.
    fs::copy(second, first).expect("a part");
    assert!(said(&["--out", "r", "--merge"], 1).contains("another part under this name"));
    done(folder.path(), &["--out", "r"]);
    assert!(fs::read(folder.path().join("r/results.parquet")).expect("results") == expected);

    fs::write(folder.path().join("plan.toml"), PLAN.replace("steps = 50", "steps = 51")).expect("a plan");
    assert!(said(&["--out", "r", "--merge"], 1).contains("belongs to another plan"));
    assert!(said(&["--out", "r"], 1).contains("belongs to another plan"));
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
