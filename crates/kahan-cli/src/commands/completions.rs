//! The command `kahan completions`, which prints scripts that complete words in a shell.

use clap::builder::PossibleValuesParser;
use clap::{Args, Command};
use clap_complete::{Shell, generate};
use kahan_study::{Catalog, Systems};

use crate::printing::{Answer, UsageError, joined};

/// Prints a completion script for a shell: commands, options and systems.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  source <(kahan completions bash)                  in ~/.bashrc
  source <(kahan completions zsh)                   in ~/.zshrc, after compinit
  kahan completions fish > ~/.config/fish/completions/kahan.fish")]
pub(crate) struct Completions {
    /// The shell that completes the words.
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    pub(crate) fn run(&self, command: Command) -> Result<Answer, UsageError> {
        let mut command = with_system_names(command);
        let mut script = Vec::new();
        generate(self.shell, &mut command, "kahan", &mut script);
        let script = String::from_utf8(script).expect("names and words are texts");
        let script = if self.shell == Shell::Fish { script + &fish_systems(&command) } else { script };
        Ok(Answer::verbatim(script))
    }
}

fn systems() -> impl Iterator<Item = &'static str> {
    Systems.names().into_iter().map(|[name, _]| name)
}

/// Adds the names of systems as values of SYSTEM, for completion only. For a wrong name, the
/// command's own error message is better than that of clap.
fn with_system_names(command: Command) -> Command {
    let names = || PossibleValuesParser::new(systems().chain(["general"]));
    let subcommands: Vec<String> = command.get_subcommands().map(|one| one.get_name().to_owned()).collect();
    subcommands.iter().fold(command, |command, name| {
        command.mut_subcommand(name, |subcommand| {
            subcommand.mut_args(|argument| match argument.get_id().as_str() {
                "system" | "about" => argument.value_parser(names()),
                _ => argument,
            })
        })
    })
}

/// Returns completions of systems for fish, because clap's generator omits positional arguments.
fn fish_systems(command: &Command) -> String {
    let takes_system = |one: &&Command| one.get_positionals().any(|argument| argument.get_id() == "system");
    let taking = joined(command.get_subcommands().filter(takes_system).map(Command::get_name), " ");
    let systems = joined(systems(), " ");
    format!("complete -c kahan -n \"__fish_seen_subcommand_from {taking}\" -a \"{systems}\"\n")
}
