//! `kahan show` in every form, `kahan list`, and help.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::running::{answer, object, refusal};

#[test]
fn the_list_names_the_systems_of_the_paper_then_the_others() {
    let list = object(&["list", "--json"]);
    let names: Vec<&str> =
        list["systems"].as_array().expect("a list").iter().filter_map(|one| one["name"].as_str()).collect();
    let paper = ["euler", "lv", "e1", "e2", "e3", "e4", "e5", "e6", "e7", "e8", "e9"];
    let others = ["weierstrass", "volterra", "volterra4", "lagrange", "henon-heiles", "zhukovsky"];
    let last = ["clebsch", "maxwell-bloch", "nahm", "lorenz"];
    assert_eq!(names, [&paper[..], &others[..], &last[..]].concat());
    let families: Vec<&str> =
        list["families"].as_array().expect("a list").iter().filter_map(|one| one["name"].as_str()).collect();
    assert_eq!(families, ["volterra-ring", "volterra-chain", "toda", "species", "kdv"]);
    let table = answer(&["list"]);
    assert!(names.iter().chain(&families).all(|name| table.contains(name)));
    assert!(table.contains("mu,r[i]"), "{table}");
    assert!(refusal(&["show", "kvd", "--sites", "4"]).contains("`kdv`"));
}

#[test]
fn the_factor_that_was_divided_out_is_named() {
    assert_eq!(object(&["show", "e1", "--json"])["removed_factor"], "1 + eps*x");
    assert_eq!(object(&["show", "e3", "--json"])["removed_factor"], "1 + eps*z");
    assert_eq!(object(&["show", "e6", "--json"])["removed_factor"], Value::Null);
    assert!(answer(&["show", "e1"]).contains("1 + eps*x"));
}

fn golden(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../kahan-emit/golden").join(file)
}

#[test]
fn what_the_macro_makes_of_a_block_is_shown_as_it_is() {
    let golden_and_shown = |name: &str| {
        let text = fs::read_to_string(golden(&format!("{name}.expanded.rs"))).expect("a golden file");
        let block = golden(&format!("{name}.kahan"));
        (text, answer(&["show", "--expand", "--file", block.to_str().expect("text")]))
    };
    let (whole, shown) = golden_and_shown("e3");
    assert_eq!(shown, whole);
    for name in ["parameters", "anonymous"] {
        let (part, shown) = golden_and_shown(name);
        let mut lines = shown.lines();
        for line in part.lines() {
            assert!(lines.any(|shown| shown == line), "{name}: `{line}` is missing, or out of order");
        }
    }
    let expanded = answer(&["show", "e3", "--expand"]);
    assert!(expanded.contains("__kahan::KahanMap<T, 3> for E3"), "{expanded}");
    assert_eq!(object(&["show", "e3", "--expand", "--json"])["expansion"], expanded);
    let special = answer(&["show", "e9", "--expand", "--param", "xi=1"]);
    assert!(special.contains("pub struct E9;") && !special.contains("__p_xi"), "{special}");
}

fn commands() -> Vec<String> {
    let help = answer(&["--help"]);
    let listed = help.split("\nOptions:").next().expect("what stands above");
    let names = listed.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    let names: Vec<String> = names.map(str::to_owned).collect();
    assert!(names.len() > 10 && names.iter().any(|name| name == "show"), "{help}");
    names
}

#[test]
fn the_help_of_every_command_fits_a_screen() {
    for command in commands().iter().map(|name| Some(&**name)).chain([None]) {
        let help = answer(&[command.as_slice(), &["--help"]].concat());
        // The list of commands is longer than other help, and must fit a terminal of 80 columns.
        let (lines, width) = if command.is_some() { (40, 100) } else { (50, 80) };
        assert!(help.lines().count() <= lines, "{help}");
        assert!(help.lines().all(|line| line.chars().count() <= width), "{help}");
        assert!(help.contains("Examples:"), "{help}");
    }
    assert!(answer(&["help", "trade"]).contains("to keep the claimed integrals"));
}

#[test]
fn what_no_macro_can_read_is_not_expanded() {
    assert!(refusal(&["show", "--expand", "--field", "xdot = x';"]).contains("a prime"));
    assert!(refusal(&["show", "--expand", "--field", "xdot = x^3;"]).contains("degree 3"));
    assert!(refusal(&["show", "e3", "--expand", "--latex"]).contains("--latex"));
}

#[test]
fn every_system_is_shown_in_every_form() {
    let names = kahan_systems::registry::all().map(|entry| entry.command);
    for name in names {
        for form in ["--latex", "--sympy", "--macro", "--expand", "--json"] {
            assert!(!answer(&["show", name, form]).is_empty());
        }
        assert!(answer(&["show", name]).contains("A(x,eps) = I - eps f'(x)"));
    }
}

#[test]
fn the_macro_block_reads_back_as_the_same_system() {
    for name in ["euler", "lv", "e5", "e8"] {
        let block = answer(&["show", name, "--macro"]);
        let file = std::env::temp_dir().join(format!("kahan-command-test-{}-{name}.rs", std::process::id()));
        std::fs::write(&file, &block).expect("a temporary file");
        let again = answer(&["show", "--file", file.to_str().expect("UTF-8"), "--macro"]);
        std::fs::remove_file(&file).expect("the temporary file");
        assert_eq!(again, block);
    }
}

#[test]
fn the_macro_block_keeps_documentation_attributes_and_the_order_of_parameters() {
    let header = "/// Three waves,\n/// driven.\n#[derive(Default)]\npub(crate) struct Rabinovich {\n    /// The drive.\n    h,\n    /// Damping.\n    #[allow(unused)]\n    nu,\n}";
    let field = format!(
        "{header}\nxdot = h*y - nu*x + y*z; // A comment.\nydot = h*x - nu*y - x*z; zdot = -nu*z + x*y;"
    );
    let kept: String = header.lines().map(|line| format!("    {line}\n")).collect();
    let shown = answer(&["show", "--field", &field, "--macro"]);
    assert!(shown.starts_with(&format!("kahan! {{\n{kept}")), "{shown}");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("r.rs");
    std::fs::write(&file, &shown).expect("a file");
    let file = file.to_str().expect("UTF-8");
    assert_eq!(answer(&["show", "--file", file, "--macro"]), shown);
    let found = answer(&["discover", "--file", file, "--macro", "--seconds", "3"]);
    assert!(found.starts_with(&format!("kahan! {{\n{kept}")), "{found}");
    // If a parameter is fixed, its documentation is removed.
    let fixed = answer(&["show", "--file", file, "--macro", "--param", "nu=0"]);
    assert!(
        fixed.contains("/// The drive.") && !fixed.contains("Damping") && fixed.contains("/// driven."),
        "{fixed}"
    );
    let found = answer(&[
        "discover",
        "--file",
        file,
        "--macro",
        "--param",
        "h=0",
        "--param",
        "nu=0",
        "--seconds",
        "4",
    ]);
    assert!(found.contains(&kept) && found.contains("when h = 0, nu = 0"), "{found}");
    let again = folder.path().join("again.rs");
    std::fs::write(&again, &found).expect("a file");
    assert!(answer(&["verify", "--file", again.to_str().expect("UTF-8")]).contains("proved"), "{found}");
    let long = format!("/// {}", "word ".repeat(40).trim_end());
    let found =
        answer(&["discover", "--field", &format!("{long}\nstruct S;\nxdot = y; ydot = -x;"), "--macro"]);
    assert!(found.contains(&long), "{found}");
}

#[test]
fn the_help_hides_no_option() {
    for (command, options) in [
        ("picture", &["--radius", "--seed", "--transient", "--size", "--theme"][..]),
        ("chart", &["--column", "--where", "--escape", "--theme", "--size"]),
    ] {
        let help = answer(&[command, "--help"]);
        for option in options {
            assert!(help.contains(&format!("{option} <")), "{option}: {help}");
        }
    }
    let options = |text: &str| {
        let lines =
            text.lines().filter_map(|line| line.strip_prefix("      ")).filter(|line| line.starts_with("--"));
        lines.filter_map(|line| line.split([' ', ',']).next().map(str::to_owned)).collect::<Vec<_>>()
    };
    for command in commands() {
        let [short, long] = [[&*command, "--help"], ["help", &*command]].map(|call| options(&answer(&call)));
        assert_eq!(short, long, "{command}");
    }
}

#[test]
fn a_field_beyond_the_budget_keeps_its_determinant() {
    let states = ["a", "b", "c", "d", "e", "f"];
    let all: Vec<String> = states.iter().enumerate().map(|(i, x)| format!("{}*{x}^2", i + 1)).collect();
    let equations = states
        .iter()
        .enumerate()
        .map(|(i, x)| format!("{x}dot = {} + {x}*{} + {i};", all.join(" + "), states[(i + 1) % 6]));
    let field: String = equations.collect();
    let sheet = object(&["show", "--field", &field, "--json"]);
    assert_eq!((&sheet["det_A"], &sheet["map"]), (&Value::Null, &Value::Null));
    let page = answer(&["show", "--field", &field]);
    assert!(page.contains("not expanded") && page.contains("elimination"), "{page}");
    assert!(answer(&["show", "--field", &field, "--latex"]).contains("vmatrix"));
    let point = ["eval", "--field", &field, "--eps", "1/7", "--at", "1,2,3,4,5,6", "--json"];
    assert_eq!(object(&point)["x_next"].as_array().map(Vec::len), Some(6));
}

#[test]
fn help_and_version_are_answers() {
    for command in ["verify", "trade", "show", "eval"] {
        let (long, short) = (answer(&["help", command]), answer(&[command, "-h"]));
        assert!(long.contains("Examples:") && short.contains("Examples:"), "{command}");
        assert!(short.len() < long.len());
        assert_eq!(answer(&[command, "--help"]), short);
    }
    assert!(answer(&["--help"]).contains("Examples:"));
    assert!(answer(&["--version"]).starts_with("kahan "));
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_kahan"))
        .args(["show", "e9", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command runs");
    drop(child.stdout.take());
    let mut complaint = String::new();
    child.stderr.take().expect("a pipe").read_to_string(&mut complaint).expect("UTF-8");
    assert_eq!(complaint, "");
    assert_eq!(child.wait().expect("the command ends").code(), Some(0));
}

/// Every write to the device `/dev/full` fails.
#[cfg(target_os = "linux")]
#[test]
fn a_failed_write_has_the_status_of_an_error() {
    for call in [
        "list",
        "orbit e6 --eps 1/10 --at 1,2,1/3 --steps 5",
        "section e6 --eps 1/10 --at 1,2,1/3 --plane x-y --steps 50",
    ] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("a device");
        let output = Command::new(env!("CARGO_BIN_EXE_kahan")).args(call.split(' ')).stdout(full).output();
        let output = output.expect("the command runs");
        assert_eq!(output.status.code(), Some(2), "{call}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("cannot write"), "{call}");
    }
}

#[test]
fn a_time_step_is_twice_eps() {
    for (command, more) in [
        ("eval", &["--at", "1,2,1/3"][..]),
        ("orbit", &["--at", "1,2,1/3", "--steps", "3", "--scalar", "exact"]),
        ("section", &["--at", "1,2,1/3", "--plane", "x-y", "--steps", "50"]),
        ("dynamics", &["--at", "1,2,1/3", "--steps", "50"]),
        ("periodic", &["--at", "1,2,1/3"]),
    ] {
        let of = |option: &[&str]| answer(&[&[command, "e6"], option, more].concat());
        assert_eq!(of(&["--dt", "0.3"]), of(&["--eps", "3/20"]), "{command}");
    }
}
