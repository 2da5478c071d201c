//! Calls of the command, as one types them: what a page shows under a figure is what made it.

use std::fmt;

use clap::{Args, Command, FromArgMatches};

use crate::printing::Refusal;

/// A call of one of the commands.
#[derive(Clone, Debug)]
pub(super) struct Line {
    command: &'static str,
    words: Vec<String>,
}

impl Line {
    /// A command with the words that name a system.
    pub(super) fn new(command: &'static str, system: &[String]) -> Self {
        Line { command, words: system.to_vec() }
    }

    /// With one more option.
    pub(super) fn with(mut self, option: &str, value: impl ToString) -> Self {
        self.words.extend([option.to_owned(), value.to_string()]);
        self
    }

    /// With a flag.
    pub(super) fn with_flag(mut self, flag: &str) -> Self {
        self.words.push(flag.to_owned());
        self
    }

    /// What the command makes of these words.
    pub(super) fn read<A: Args + FromArgMatches>(&self) -> Result<A, Refusal> {
        let command = A::augment_args(Command::new(self.command).no_binary_name(true));
        let matches = command.try_get_matches_from(&self.words);
        let read = matches.and_then(|matches| A::from_arg_matches(&matches));
        read.map_err(|error| Refusal::new(error.to_string().trim_start_matches("error: ")))
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "kahan {}", self.command)?;
        for word in &self.words {
            let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-+./:=,".contains(c);
            if !word.is_empty() && word.chars().all(is_plain) {
                write!(f, " {word}")?;
            } else {
                write!(f, " '{}'", word.replace('\'', r"'\''"))?;
            }
        }
        Ok(())
    }
}
