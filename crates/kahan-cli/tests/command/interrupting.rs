//! SIGINT and SIGTERM end every long call and leave no unfinished file behind.
#![cfg(unix)]

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};

fn started(arguments: &[&str]) -> Child {
    let command = &mut Command::new(env!("CARGO_BIN_EXE_kahan"));
    command.args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the command runs")
}

fn wait_until(mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < Duration::from_secs(60), "nothing happens");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_signal_leaves_no_file_behind() {
    for (signal, status) in [(Signal::INT, 130), (Signal::TERM, 143)] {
        let folder = tempfile::tempdir().expect("a folder");
        let out = folder.path().join("orbit.csv");
        let out = out.to_str().expect("text");
        let mut child = started(&[
            "orbit", "e6", "--eps", "0.05", "--at", "1,2,3", "--steps", "1e15", "--every", "1000", "--out",
            out,
        ]);
        let files = || fs::read_dir(folder.path()).expect("the folder").count();
        wait_until(|| files() == 1);
        let pid = Pid::from_child(&child);
        kill_process(pid, signal).expect("a signal");
        assert_eq!(child.wait().expect("it ends").code(), Some(status));
        assert_eq!(files(), 0, "something is left");
    }
}

#[test]
fn an_older_file_stays_as_it_was() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("h.csv");
    fs::write(&out, "kept\n").expect("a file");
    let mut child = started(&[
        "heights",
        "lv",
        "--eps",
        "9/14",
        "--at",
        "1/2,5/3",
        "--steps",
        "1e3",
        "--digits",
        "1e15",
        "--seconds",
        "1e6",
        "--out",
        out.to_str().expect("text"),
    ]);
    wait_until(|| fs::read_dir(folder.path()).expect("the folder").count() == 2);
    kill_process(Pid::from_child(&child), Signal::TERM).expect("a signal");
    assert_eq!(child.wait().expect("it ends").code(), Some(143));
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 1);
    assert_eq!(fs::read_to_string(&out).expect("the file"), "kept\n");
}

/// A field for which `discover` and `poles` take long.
const HARD: &str = "xdot = y*z + x*w; ydot = x*z - w^2; zdot = x*y + w*y; wdot = x^2 - y*z + z^2;";

/// Returns commands that take minutes or more.
fn long_calls(folder: &Path) -> Vec<Vec<String>> {
    const LINES: [&str; 24] = [
        "orbit lv --eps 0.1 --at 0.6,1 --steps 1e15 --every 1e14",
        "orbit lv --eps 0.1 --at 0.6,1 --steps 1e15 --every 1000 --out OUT/orbit.csv",
        "orbit lv --eps 0.1 --at 0.6,1 --steps 1e15 --every 1e14 --order 8 --scalar dd",
        "orbit lv --eps 0.1 --at 0.6,1 --steps 1e15 --every 1e14 --method flow",
        "orbit lv --eps 0.1 --at 0.6,1 --steps 1e15 --every 1e14 --projective",
        "orbit lv --over eps=0.1:0.2:9 --at 0.6,1 --steps 1e15 --every 1000 --out OUT/orbits.csv",
        "orbit lv --eps 0.1 --at 0.6,1 --transient 1e15 --steps 9",
        "orbit lv --eps 9/14 --at 1/2,5/3 --steps 99 --scalar exact",
        "orbit volterra-chain --sites 1000 --start x=1 --eps 0.01 --steps 1e12 --every 1e12",
        "dynamics e6 --eps 0.05 --at 1,2,3 --steps 1e15",
        "section lv --eps 0.1 --at 0.6,1 --steps 1e15 --plane x+100",
        "periodic SQUARE --eps 0.1 --at 1 --over a=1:-1:100000",
        "periodic lorenz --param s=10 --param b=8/3 --free eps --period 3000 --eps 0.00026 --at 1,2,20 \
         --over r=28:30:100000",
        "chart lv --eps 0.1 --at 0.6,1 --over x=0.1:1:/30 --steps 1e10 --out OUT/chart.svg",
        "picture lv --at 1/2,1 --steps 100 --seconds 1e4 --transient 1e14 --axes x \
         --over eps=1/10:1:+1/400 --out OUT/over.svg",
        "heights lv --eps 9/14 --at 1/2,5/3 --steps 1e3 --digits 1e15 --seconds 1e4",
        "discover HARD --seconds 1e4",
        "scan HARD --eps 1:2:1000 --seconds 1e4",
        "poles HARD --steps 100 --seconds 1e4",
        "trade lorenz --param s=10 --param r=28 --param b=8/3 --at 1,2,3 --horizon 3000 --seconds 1e4",
        "verify --mutate",
        "extremes --trials 1e9",
        "page HARD --seconds 1e4 --out OUT/page",
        "atlas --out OUT/atlas",
    ];
    let out = folder.to_str().expect("text");
    let word = |word: &str| match word {
        "HARD" => vec!["--field".to_owned(), HARD.to_owned()],
        "SQUARE" => vec!["--field".to_owned(), "xdot = a - x^2;".to_owned()],
        _ => vec![word.replace("OUT", out)],
    };
    LINES.iter().map(|line| line.split_whitespace().flat_map(word).collect()).collect()
}

struct Run(Child);

impl Drop for Run {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn every_long_call_ends_by_a_signal() {
    let folder = tempfile::tempdir().expect("a folder");
    let calls = long_calls(folder.path());
    let start = |call: &Vec<String>| Run(started(&call.iter().map(String::as_str).collect::<Vec<_>>()));
    let mut runs: Vec<Run> = calls.iter().map(start).collect();
    std::thread::sleep(Duration::from_secs(2));
    for (call, run) in calls.iter().zip(&mut runs) {
        assert_eq!(run.0.try_wait().expect("its status"), None, "{call:?} ended by itself");
        kill_process(Pid::from_child(&run.0), Signal::INT).expect("a signal");
    }
    for (call, run) in calls.iter().zip(&mut runs) {
        let mut status = None;
        wait_until(|| {
            status = run.0.try_wait().expect("its status");
            status.is_some()
        });
        let status = status.expect("it has ended");
        let is_interrupt = status.code() == Some(130) || status.signal() == Some(Signal::INT.as_raw());
        assert!(is_interrupt, "{call:?}: {status}");
    }
}
