//! Tests the widths of lines, on a terminal and elsewhere.

use crate::running::{answer, kahan, text};

const WIDE: &str = "xdot = y*z; ydot = -x*z; zdot = x*y + u; udot = v*w; vdot = -u*w; wdot = 0*u; \
                    integral a_rather_long_name_of_an_integral = w^2;";
/// A number of thirty digits. Points that are computed from it take more than a line.
const LONG: &str = "123456789012345678901234567891/7";

fn tables() -> Vec<(Vec<String>, String)> {
    let mut runs: Vec<Vec<&str>> = vec![vec!["list"], vec!["verify", "general"]];
    for system in ["euler", "lv", "e3", "e7", "volterra4", "lagrange", "zhukovsky"] {
        runs.push(vec!["show", system, "--plan"]);
        runs.push(vec!["extremes", system, "--trials", "64"]);
        runs.push(vec!["discover", system, "--seconds", "0.5"]);
    }
    runs.push(vec!["extremes", "--field", WIDE, "--trials", "32", "--random-fields", "2"]);
    runs.extend(["euler", "lv", "e3", "e8"].map(|system| vec!["verify", system]));
    runs.push(vec!["verify", "lv", "--all"]);
    runs.push(vec!["verify", "--field", WIDE]);
    runs.push(vec!["show", "--field", WIDE, "--plan"]);
    let long = format!("{LONG},2,3,1/2,1/3,1/5");
    for at in ["1,2,3,1/2,1/3,1/5", &long] {
        for scalar in ["exact", "f64", "f32", "dd"] {
            runs.push(vec!["eval", "--field", WIDE, "--eps", "1/2", "--at", at, "--scalar", scalar]);
        }
        runs.push(vec!["heights", "--field", WIDE, "--eps", "1/2", "--at", at, "--steps", "5"]);
    }
    runs.push(vec!["eval", "e6", "--eps", LONG, "--at", "1,2,3"]);
    runs.push(vec!["trade", "e6", "--at", "1,1/2,1/3", "--horizon", "2", "--seconds", "10"]);
    runs.push(vec!["scan", "lv", "--eps", "-2:2:+1/2"]);
    runs.push(vec!["scan", "--field", "xdot = c*x + x^2;", "--param", "c=1:2:+1", "--degree", "40"]);
    let range = format!("0:{0}:+{0}", format!("1/{}", "9".repeat(90)));
    runs.push(vec!["scan", "lv", "--eps", &range]);
    let done = runs.iter().map(|arguments| {
        let output = kahan(arguments);
        let owned = arguments.iter().map(|argument| (*argument).to_owned()).collect();
        assert!(matches!(output.status.code(), Some(0 | 1)), "{arguments:?}: {}", text(&output.stderr));
        (owned, text(&output.stdout))
    });
    done.collect()
}

/// Returns whether a line is a formula, a claim, code or a note. Only terminals wrap such lines.
fn is_formula(line: &str) -> bool {
    let line = line.trim_start();
    let is_named = ["integral ", "density ", "bracket ", "choice", "let orbit", "note ", "random-"];
    is_named.iter().any(|name| line.starts_with(name) && line.contains(' '))
        || [" := ", " = ", "// ", " ~ "].iter().any(|sign| line.contains(sign))
}

#[test]
fn every_line_of_a_table_fits_80_columns_or_is_one_number() {
    for (arguments, page) in tables() {
        for line in page.lines() {
            let cell = line.trim().trim_start_matches(['[', '(']).trim_end_matches([']', ')', ',']).trim();
            let fits = line.chars().count() <= 80 || !cell.contains(' ') || is_sentence(&arguments, line);
            let has_formulas = !["list", "eval", "heights"].contains(&arguments[0].as_str());
            assert!(fits || has_formulas && is_formula(line), "{arguments:?}: {line}");
        }
    }
}

/// Returns whether a line is a sentence below a table. Only terminals wrap such sentences.
fn is_sentence(arguments: &[String], line: &str) -> bool {
    let of_discover = arguments[0] == "discover" && line.ends_with('.');
    of_discover
        || line.contains("seen are the degrees of")
        || line.contains(" claims: ")
        || line.starts_with("note")
}

#[test]
fn the_widest_tables_break_between_columns() {
    let heights =
        answer(&["heights", "--field", WIDE, "--eps", "1/2", "--at", "1,2,3,1/2,1/3,1/5", "--steps", "2"]);
    let headings: Vec<&str> = heights.lines().filter(|line| line.starts_with("n ")).collect();
    assert_eq!(headings.len(), 2, "{heights}");
    let names: Vec<&str> = headings.iter().flat_map(|line| line.split_whitespace()).collect();
    assert_eq!(names, ["n", "h(x)", "h(y)", "h(z)", "h(u)", "n", "h(v)", "h(w)", "digits"]);
    let rows: Vec<&str> = heights.lines().filter(|line| line.starts_with("2 ")).collect();
    assert_eq!(rows.len(), 2);

    let list = answer(&["list"]);
    assert!(
        list.lines()
            .any(|line| line.starts_with("e8 ") && line.ends_with("with a digamma-function integral")),
        "{list}"
    );
}

#[test]
fn piped_formulas_are_whole() {
    let object = crate::running::object(&["show", "zhukovsky", "--json"]);
    let page = answer(&["show", "zhukovsky"]);
    for (state, image) in ["x", "y", "z"].iter().zip(object["map"].as_array().expect("a map")) {
        let line = format!("  {state}~ = {}", image.as_str().expect("a formula"));
        assert!(line.len() > 200 && page.lines().any(|shown| shown == line), "{line}");
    }
    let claims = crate::running::object(&["verify", "e3", "--json"]);
    let table = answer(&["verify", "e3", "--all"]);
    for claim in claims["claims"].as_array().expect("a list") {
        let (statement, source) =
            (claim["statement"].as_str().expect("text"), claim["source"].as_str().expect("text"));
        let line = format!("    {statement}    // {source}");
        assert!(table.lines().any(|shown| shown == line), "{line}");
    }
}

#[cfg(unix)]
mod on_a_terminal {
    use std::fs::File;
    use std::io::Read;
    use std::process::{Command, Stdio};

    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{Winsize, tcsetwinsize};

    use super::WIDE;

    fn shown(columns: u16, arguments: &[&str]) -> String {
        on_terminal(columns, arguments, |command, screen| command.stdout(screen).stderr(Stdio::piped()))
    }

    /// Returns what a terminal shows; `connect` attaches the command's streams to the terminal.
    fn on_terminal(
        columns: u16,
        arguments: &[&str],
        connect: impl FnOnce(&mut Command, File) -> &mut Command,
    ) -> String {
        let terminal = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).expect("a terminal");
        grantpt(&terminal).expect("a terminal");
        unlockpt(&terminal).expect("a terminal");
        let name = ptsname(&terminal, Vec::new()).expect("its name").into_string().expect("text");
        let size = Winsize { ws_row: 24, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 };
        tcsetwinsize(&terminal, size).expect("its size");
        let screen = File::options().read(true).write(true).open(name).expect("its other side");
        let mut command = Command::new(env!("CARGO_BIN_EXE_kahan"));
        command.args(arguments).stdin(Stdio::null());
        let mut child = connect(&mut command, screen).spawn().expect("the command runs");
        // `command` keeps the terminal open. Without `drop`, reading would not end.
        drop(command);
        let mut read = Vec::new();
        // On Linux, reading from a terminal without a writer ends with an error.
        let _ = File::from(terminal).read_to_end(&mut read);
        assert!(child.wait().expect("it ends").success(), "{arguments:?}");
        String::from_utf8(read).expect("text").replace("\r\n", "\n")
    }

    #[test]
    fn long_formulas_break_at_terms() {
        for columns in [80, 50] {
            for arguments in [
                &["show", "zhukovsky"][..],
                &["show", "--field", WIDE],
                &["verify", "e3", "--all"],
                &["verify", "e9"],
                &["discover", "e6", "--seconds", "5"],
                &["show", "e3", "--plan"],
                &["list"],
            ] {
                let page = shown(columns, arguments);
                for line in page.lines() {
                    let fits = line.chars().count() <= usize::from(columns) || !line.trim().contains(' ');
                    assert!(fits, "{arguments:?} at {columns}: {line}");
                    assert!(!line.trim_end().ends_with(" +") && !line.trim_end().ends_with(" -"), "{line}");
                }
                if arguments[0] == "show" && !arguments.contains(&"--plan") {
                    let words = |page: &str| page.split_whitespace().map(str::len).sum::<usize>();
                    assert_eq!(words(&page), words(&super::answer(arguments)), "something is lost");
                }
            }
        }
    }

    #[test]
    fn findings_appear_while_the_search_goes_on() {
        let arguments = ["discover", "e6", "--seconds", "5"];
        let page =
            on_terminal(80, &arguments, |command, screen| command.stderr(screen).stdout(Stdio::null()));
        let claims = super::answer(&arguments);
        let claims: Vec<&str> = claims.lines().filter(|line| line.starts_with("integral ")).collect();
        assert_eq!(claims.len(), 2);
        for claim in claims {
            assert!(page.contains(&format!(" s: {claim}")), "{claim}: {page}");
        }
    }

    #[test]
    fn rows_break_after_commas_and_elsewhere_not_at_all() {
        let arguments = ["orbit", "e6", "--eps", "0.05", "--at", "1,2,3", "--steps", "20"];
        let piped = super::answer(&arguments);
        assert!(piped.lines().any(|line| line.len() > 80) && piped.lines().count() == 22);
        let page = shown(80, &arguments);
        assert!(page.lines().all(|line| line.len() <= 80), "{page}");
        assert_eq!(page.replace(",\n  ", ","), piped);
    }

    #[test]
    fn text_for_programs_is_left_alone() {
        for arguments in [
            &["show", "zhukovsky", "--json"][..],
            &["show", "zhukovsky", "--latex"],
            &["completions", "bash"],
        ] {
            assert_eq!(shown(50, arguments), super::answer(arguments), "{arguments:?}");
        }
    }
}
