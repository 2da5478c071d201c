//! The command `kahan`: proofs, formulas, orbits, searches, tables, pictures and pages.
//!
//! `reading` parses arguments, `commands` asks the libraries, and `printing` writes the answers.
//! The exit status is 0 for success, 1 for a failed check or a pole, and 2 for wrong input or a
//! failed write. `kahan sweep` returns the status of `kahan-sweep`, and a signal may give 130 or
//! 143.

// Each module uses only modules that are declared before it, as `tests/tests/layers.rs` checks.

mod printing;

mod reading;

mod commands;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, ArgMatches, CommandFactory, FromArgMatches, Parser};

use commands::{COMMAND_GROUPS, Command};
use printing::{Answer, UsageError, finish, joined, warn};
use reading::{ONE_WORD, Source};

/// Kahan's method for quadratic differential equations: orbits, proofs and searches.
///
/// Kahan's method turns a quadratic vector field x' = f(x) into a birational map x ↦ x~, which
/// approximates the flow over the time step 2 eps. This command shows the formulas of such maps,
/// follows orbits, finds what the maps preserve, and proves what is claimed of them. Numbers are
/// read exactly: 3/7, -2, 0.25, 1e-3. `eps` is half the time step.
#[derive(Debug, Parser)]
#[command(name = "kahan", version, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

const BEGINNING: &str = "\
Kahan's method turns a quadratic differential equation into a rational map, a time step of 2 eps.

  kahan orbit    --field 'xdot = v; vdot = -x - x^2;' --eps 0.05 --at 0.3,0 --steps 1000
  kahan discover --field 'xdot = v; vdot = -x - x^2;'               # what the map preserves, proved
  kahan picture  --field 'xdot = v; vdot = -x - x^2;' --eps 0.15 --at 0.3,0 --steps 500 --out o.svg
  kahan page     --field 'xdot = v; vdot = -x - x^2;' --out spring  # everything on one page
  kahan list                                       # named fields, for `kahan show e6`
  kahan verify                                     # proves every formula of a paper

Put in your own equations. `kahan --help` lists the commands, `kahan COMMAND --help` their options.
";

const EXAMPLES: &str = "\
Examples:
  kahan verify                            prove every formula of the paper
  kahan show e6                           the formulas of E6
  kahan eval e1 --eps 1/2 --at -2,1,1/3   all formulas at a point
  kahan orbit e6 --eps 0.1 --at 1,2,3 --steps 100
  kahan discover --field 'xdot = y; ydot = 6*x^2 - a;'

`kahan COMMAND --help` lists options and examples.
`kahan help COMMAND` explains them.";

/// Runs the command. The first argument is the name of the program.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    ExitCode::from(status(arguments))
}

/// Runs the command like [`run`], and returns the exit status as a number, for other languages.
pub fn status(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let named = arguments.get(1).and_then(|name| command().find_subcommand(name).cloned());
    let matches = command().try_get_matches_from(arguments);
    let notes = matches.as_ref().ok().and_then(notes).unwrap_or_default();
    let read = matches.and_then(|matches| Cli::from_arg_matches(&matches));
    let result = match read {
        Ok(cli) => {
            cli.command.map_or_else(|| Ok(Answer::verbatim(BEGINNING.to_owned())), |asked| asked.run(command))
        }
        Err(error) => usage(&error, named.as_ref().map_or("", |named| named.get_name())),
    };
    // If the degree is refused, notes are printed, too: a misspelled name may have raised it.
    let concerns = result.as_ref().map_or_else(|refusal| refusal.message().contains("has degree"), |_| true);
    let status = finish(result);
    notes.iter().filter(|_| concerns).for_each(|note| warn(note));
    status
}

/// Returns notes on how the field was read; `None` for commands without a field.
fn notes(matches: &ArgMatches) -> Option<Vec<String>> {
    let (_, matches) = matches.subcommand()?;
    let takes_field = matches.try_contains_id("field").is_ok() && matches.try_contains_id("sites").is_ok();
    let source = takes_field.then(|| Source::from_arg_matches(matches).ok()).flatten()?;
    let ranges = matches.try_get_many::<String>("over").ok().flatten();
    Some(source.notes(&ranges.into_iter().flatten().cloned().collect::<Vec<_>>()))
}

/// Lists the commands by groups, each with its description up to the first colon.
fn grouped(command: &clap::Command) -> String {
    let line = |name: &&str| {
        let about = command.find_subcommand(name)?.get_about()?.to_string();
        Some(format!("  {name:<11}  {}\n", about.split(':').next()?))
    };
    let group = |(heading, names): &(&str, &[&str])| {
        format!("{heading}:\n{}", names.iter().filter_map(line).collect::<String>())
    };
    COMMAND_GROUPS.iter().map(group).collect()
}

/// Builds the parser. `--help` prints a short text, and `kahan help COMMAND` a complete one.
fn command() -> clap::Command {
    let cli = Cli::command();
    let groups = grouped(&cli);
    let template = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{groups}\nOptions:\n{{options}}{{after-help}}"
    );
    let on_a_screen = |one: clap::Command| {
        let help = Arg::new("help").short('h').long("help").help("Print help").action(ArgAction::HelpShort);
        one.disable_help_flag(true).arg(help)
    };
    let found = |one: clap::Command| on_a_screen(one).mut_arg("help", |help| help.hide(true));
    let names = COMMAND_GROUPS.iter().flat_map(|(_, names)| *names);
    names.fold(on_a_screen(cli.help_template(template)), |command, name| {
        command.mut_subcommand(name, |one| {
            let examples = one.get_after_help().map(ToString::to_string).unwrap_or_default();
            let more = format!("{examples}\n`kahan help {name}` explains more.");
            found(one).after_help(more).after_long_help(examples)
        })
    })
}

/// Turns help and version into answers, and clap's errors into refusals of one paragraph.
fn usage(error: &clap::Error, command: &str) -> Result<Answer, UsageError> {
    let text = error.render().to_string();
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        return Ok(Answer::verbatim(text));
    }
    let is_end = |line: &str| line.starts_with("Usage:") || line.starts_with("For more");
    let lines = text.lines().map(str::trim).take_while(|line| !is_end(line));
    let said = lines.filter(|line| !line.is_empty() && !line.starts_with("tip: to pass"));
    let said = joined(said, " ").replace(" tip: ", "; ");
    let said = said.trim_start_matches("error: ");
    let meant = suggestion(error).map_or_else(String::new, |meant| format!("; {meant}"));
    let call = joined(["kahan", command, "--help"].iter().filter(|word| !word.is_empty()), " ");
    Err(UsageError::new(format!("{said}{meant}; `{call}` shows examples")))
}

fn suggestion(error: &clap::Error) -> Option<&'static str> {
    let Some(ContextValue::String(argument)) = error.get(ContextKind::InvalidArg) else { return None };
    let is_number = argument.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit() || c == '.');
    match (error.kind(), &**argument) {
        (ErrorKind::UnknownArgument, "--h" | "--step") => Some("--dt is the time step, and --eps half of it"),
        (ErrorKind::UnknownArgument, "--reembed") => Some(
            "it projects the steps of an orbit in f64: orbit, dynamics, section, chart and picture take it",
        ),
        (ErrorKind::UnknownArgument, "--fused") => Some(
            "it fuses multiply-adds in the steps of an orbit: orbit, dynamics, section and chart take it",
        ),
        (ErrorKind::UnknownArgument, _) if is_number => Some(ONE_WORD),
        _ => None,
    }
}
