//! Uses `kahan-paper` to check every formula of Hone and Petrera's paper, and prints the verdicts.
//!
//! The exit status is 1 if a claim fails, and 2 for wrong arguments. `cargo run` in the root
//! folder builds this program, so it has few dependencies.

use std::env::args_os;
use std::io::{IsTerminal, Write, stderr, stdout};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use kahan_paper::{OPEN, Paper, Verdict, Verdicts};
use terminal_size::{Width, terminal_size_of};

const HELP: &str = "\
Proves every formula of the paper and prints what came of it on one screen. The exit status is 1 if
a claim fails.

Usage: kahan-verify [--all]

Options:
      --all   Print every claim with its statement, its place in the paper and its time
  -h, --help  Print help

Examples:
  cargo run --release
  cargo run --release -- --all
";

const USUAL_WIDTH: usize = 100;

fn main() -> ExitCode {
    let arguments: Vec<String> = args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => proved(Verdicts::summary),
        ["--all"] => proved(Verdicts::in_full),
        ["-h" | "--help"] => {
            print(HELP);
            ExitCode::SUCCESS
        }
        _ => {
            eprint!("{}", elsewhere(&arguments));
            ExitCode::from(2)
        }
    }
}

fn proved(text: impl Fn(&Verdicts, usize) -> String) -> ExitCode {
    let begun = Instant::now();
    let paper = Paper::new();
    let claims: Vec<_> = paper.claims().iter().collect();
    let done = AtomicUsize::new(0);
    let is_watched = stderr().is_terminal();
    let verdicts = paper.for_all(&claims, None, |claim| {
        let begun = Instant::now();
        let verdict = paper.verdict(claim);
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        if is_watched {
            eprint!("\r{done} of {} claims", claims.len());
        }
        Verdict { seconds: Some(begun.elapsed().as_secs_f64()), ..verdict }
    });
    if is_watched {
        // Erases the progress line.
        eprint!("\r\x1b[K");
    }
    let verdicts = Verdicts::of(verdicts, OPEN, Some(begun.elapsed().as_secs_f64()));
    let width = terminal_size_of(stdout()).map_or(USUAL_WIDTH, |(Width(width), _)| usize::from(width));
    print(&text(&verdicts, width.clamp(20, USUAL_WIDTH)));
    match verdicts.complaint() {
        None => ExitCode::SUCCESS,
        Some(complaint) => {
            eprintln!("error: {complaint}");
            ExitCode::FAILURE
        }
    }
}

/// Prints a text. A closed pipe is ignored.
fn print(text: &str) {
    let _ = stdout().write_all(text.as_bytes());
}

/// Returns a message that names the `kahan` command to use for these arguments.
fn elsewhere(arguments: &[String]) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./=,:+@%^".contains(c);
    let quoted = arguments.iter().map(|word| {
        let is_plain = !word.is_empty() && word.chars().all(is_plain);
        if is_plain { word.clone() } else { format!("'{}'", word.replace('\'', r"'\''")) }
    });
    // Options without a command are options of `kahan verify`.
    let verify = arguments[0].starts_with('-').then(|| "verify".to_owned());
    let words: Vec<String> = verify.into_iter().chain(quoted).collect();
    let words = words.join(" ");
    format!(
        "error: kahan-verify takes --all alone; the command `kahan` takes the rest:\n\
         \x20   cargo run --release -p kahan-cli -- {words}\n\
         help: `cargo install --path crates/kahan-cli` installs it; then write `kahan {words}`\n"
    )
}
