//! SIGINT and SIGTERM: no unfinished file stays behind, nor does one appear under its name.
#![cfg(unix)]

use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};

fn started(arguments: &[&str]) -> Child {
    let command = &mut Command::new(env!("CARGO_BIN_EXE_kahan"));
    command.args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the command runs")
}

/// Waits until something is true, half a minute at most.
fn wait_until(mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < Duration::from_secs(30), "nothing happens");
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
        "--max-digits",
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
