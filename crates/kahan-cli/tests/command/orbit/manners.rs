//! Refusals, pipes and help.

use super::*;

fn refusal(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    let paragraph = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {paragraph}");
    assert!(output.stdout.is_empty(), "{arguments:?} printed something");
    assert!(paragraph.starts_with("error: ") && paragraph.trim_end().lines().count() == 1, "{paragraph}");
    paragraph
}

#[test]
fn rows_come_while_they_are_made_and_a_reader_that_goes_away_is_no_error() {
    for json in [false, true] {
        let mut command = command(&["e6", "--eps", "0.1", "--at", "1,2,3", "--steps", "1000000000000"]);
        if json {
            command.arg("--json");
        }
        let mut child =
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command runs");
        let mut reader = BufReader::new(child.stdout.take().expect("a pipe"));
        let mut lines = String::new();
        for _ in 0..100 {
            reader.read_line(&mut lines).expect("UTF-8");
        }
        assert!(lines.contains("99") || json, "{lines}");
        drop(reader);
        let mut complaint = String::new();
        child.stderr.take().expect("a pipe").read_to_string(&mut complaint).expect("UTF-8");
        assert_eq!(complaint, "");
        assert_eq!(child.wait().expect("the command ends").code(), Some(0));
    }
}

#[test]
fn bad_input_says_what_to_write_instead() {
    let at = |rest: &[&'static str]| [&["e6", "--eps", "1/2", "--at", "1,2,3"], rest].concat();
    let cases: [(Vec<&str>, &[&str]); 13] = [
        (
            at(&["--steps", "5", "--order", "4", "--scalar", "exact"]),
            &["--order 4", "irrational", "--scalar f64", "--order 2"],
        ),
        (at(&["--steps", "5", "--order", "3"]), &["'3'", "2, 4, 6, 8"]),
        (at(&["--steps", "-5"]), &["'-5'", "whole number, 0 or more"]),
        (at(&["--steps", "1.5"]), &["'1.5'", "whole number, 0 or more"]),
        (at(&["--steps", "5", "--every", "0"]), &["'0'", "whole number, 1 or more"]),
        (at(&[]), &["--steps"]),
        (vec!["e6", "--at", "1,2,3", "--steps", "5"], &["--eps"]),
        (
            vec!["e6", "--eps", "1/2", "--at", "1,2", "--steps", "5"],
            &["3 coordinates x,y,z expected, 2 given"],
        ),
        (vec!["e7", "--eps", "1/2", "--at", "1,2,3", "--steps", "5"], &["--param xi=VALUE"]),
        (vec!["--eps", "1/2", "--at", "1,2,3", "--steps", "5"], &["which system"]),
        (
            vec!["lv", "--eps", "1/2", "--at", "1,1e400", "--steps", "5"],
            &["--at", "y is beyond", "f64", "exact"],
        ),
        (vec!["lv", "--eps", "1e39", "--at", "1,1", "--steps", "5", "--scalar", "f32"], &["--eps", "f32"]),
        (
            vec!["--field", "xdot = x/a;", "--eps", "1", "--at", "1", "--param", "a=0", "--steps", "1"],
            &["divides by zero at a = 0"],
        ),
    ];
    for (arguments, expected) in &cases {
        let paragraph = refusal(arguments);
        for part in *expected {
            assert!(paragraph.contains(part), "{arguments:?} does not say {part}: {paragraph}");
        }
    }
}

#[cfg(unix)]
#[test]
fn the_examples_of_the_help_run() {
    let folder = folder();
    fs::write(folder.path().join("starts.csv"), "x,y\n1/4,1\n1/2,1\n").expect("a file");
    assert!(examples_run("orbit", folder.path()) >= 5);
    assert_eq!(contents(&folder), ["e7.csv", "starts.csv"]);
}
