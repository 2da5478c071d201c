//! The commands. Each turns its arguments into an [`Answer`] or a [`UsageError`].

mod command_line;
mod image_options;

use clap::Subcommand;
use kahan_study::Question;

use crate::printing::{Answer, UsageError};
use command_line::{CommandLine, QuestionCommand};

/// Declares the commands, each in a module of its name. Generates the modules, `COMMAND_GROUPS`,
/// the enum `Command`, and `CommandLine::asking`, which turns a question into a command line.
macro_rules! commands {
    (|$whole:ident| $($heading:literal: $(
        $(#[$attribute:meta])* $module:ident::$command:ident
            $(asking $question:ident $(by $($shown:ident)::+)?)? $(with $argument:expr)?
    ),*;)*) => {
        $($(pub(crate) mod $module;)*)*

        pub(crate) const COMMAND_GROUPS: &[(&str, &[&str])] = &[$(($heading, &[$(stringify!($module)),*])),*];

        #[derive(Debug, Subcommand)]
        pub(crate) enum Command {
            $($($(#[$attribute])* $command($module::$command),)*)*
        }

        impl Command {
            pub(crate) fn run(&self, $whole: fn() -> clap::Command) -> Result<Answer, UsageError> {
                match self {
                    $($(Self::$command(command) => command.run($($argument)?),)*)*
                }
            }
        }

        impl CommandLine {
            fn asking(system: &[String], question: &Question) -> Self {
                match question {
                    $($($(
                        Question::$question(asked) => {
                            $(let asked = &$($shown)::+(asked);)?
                            $module::$command::options(asked, CommandLine::new(stringify!($module), system))
                        }
                    )?)*)*
                }
            }
        }
    };
}

commands! { |whole|
    "A field": list::List, show::Show asking Show, eval::Eval asking Evaluate, lift::Lift;
    "Orbits": orbit::Orbit asking Orbit, dynamics::Dynamics asking Observe, section::Section asking Section,
        periodic::Periodic asking Periodic, chart::Chart asking Over,
        picture::Picture asking Diagram by picture::request::PictureRequest::of_diagram, sweep::Sweep;
    "What is preserved": discover::Discover asking Discover, scan::Scan asking Scan,
        poles::Poles asking Poles, heights::Heights asking Heights;
    "Accuracy": trade::Trade asking Trade, extremes::Extremes;
    "Pages": page::Page;
    "The paper": verify::Verify asking Verify, atlas::Atlas;
    "The shell": completions::Completions with whole();
}
