//! `kahan completions`.

use std::process::{Command, Stdio};

use crate::running::{answer, refusal};

fn shell(name: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(name).args(arguments).stdin(Stdio::null()).output().ok()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).expect("text"))
}

#[test]
fn every_shell_gets_the_commands_the_options_and_the_systems() {
    for name in ["bash", "zsh", "fish"] {
        let script = answer(&["completions", name]);
        for word in ["heights", "discover", "henon-heiles", "zhukovsky", "scalar", "digits", "mutate"] {
            assert!(script.contains(word), "{name} is not told of {word}");
        }
    }
    assert!(refusal(&["completions", "csh"]).contains("bash"));
}

#[test]
fn bash_completes_systems_and_options() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = folder.path().join("kahan.bash");
    std::fs::write(&script, answer(&["completions", "bash"])).expect("a file");
    let script = script.to_str().expect("text");
    if shell("bash", &["-n", script]).is_none() {
        return;
    }
    let complete = |words: &[&str]| {
        let last = words.len() - 1;
        let program = format!(
            "source {script}; COMP_WORDS=({}); COMP_CWORD={last}; _kahan kahan '{}' '{}'; echo \"${{COMPREPLY[*]}}\"",
            words.iter().map(|word| format!("'{word}'")).collect::<Vec<_>>().join(" "),
            words[last],
            words[last - 1]
        );
        shell("bash", &["-c", &program]).unwrap_or_default()
    };
    assert_eq!(complete(&["kahan", "show", "hen"]).trim(), "henon-heiles");
    assert_eq!(complete(&["kahan", "verify", "zhu"]).trim(), "zhukovsky");
    assert_eq!(complete(&["kahan", "show", "volterra-r"]).trim(), "volterra-ring");
    assert_eq!(complete(&["kahan", "heights", "lv", "--dig"]).trim(), "--digits");
    assert_eq!(complete(&["kahan", "dis"]).trim(), "discover");
    assert_eq!(complete(&["kahan", "eval", "--scalar", "e"]).trim(), "exact");
    assert_eq!(complete(&["kahan", "dynamics", "--observe", "meg"]).trim(), "megno");
}
