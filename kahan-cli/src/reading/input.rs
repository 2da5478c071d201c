//! What the commands read: a system of the catalog, a field from the command line or from a file, values of its parameters.
//!
//! Texts become checked systems here; everything that is wrong with them becomes a [`Refusal`].

use std::ops::Range;
use std::path::PathBuf;

use clap::Args;
use kahan_algebra::diagnostics::{Diagnostic, Diagnostics};
use kahan_algebra::lexer::{Lexed, lex};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::report;
use kahan_algebra::system::System;
use kahan_algebra::{check, parse, read};
use kahan_systems::entry::Entry;
use kahan_systems::registry::{all, find};

use crate::printing::Refusal;

use super::file::{chosen, read_file};
use super::rust_file::blocks;
use super::values::given_values;

/// The system that a command is about.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct Source {
    /// A system of the catalog, as `kahan list` names them: euler, lv, e1 to e9, …
    #[arg(value_name = "SYSTEM")]
    system: Option<String>,

    /// A field in the language of `kahan!`; without a header its free names are parameters.
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true)]
    field: Option<String>,

    /// A file with such a field, or a Rust file with calls of `kahan!`; `-` is standard input.
    #[arg(long, value_name = "FILE")]
    file: Option<PathBuf>,

    /// Which block of a Rust file that has several: the name of its struct or of its variable, or
    /// its line.
    #[arg(long, value_name = "NAME", requires = "file", visible_alias = "struct")]
    block: Option<String>,

    /// The value of a parameter; once for each. `show` and `verify` put it in before the map is reduced, `eval` and `orbit`
    /// after; `discover` leaves the others generic, and `scan` takes FROM:TO:STEP in the place of V.
    #[arg(long = "param", value_name = "NAME=V", allow_hyphen_values = true)]
    parameters: Vec<String>,
}

/// A system, a step and a point: what an evaluation or an orbit begins with.
#[derive(Args, Clone, Debug)]
pub(crate) struct Start {
    #[command(flatten)]
    pub(crate) source: Source,

    /// Half the time step: 1/2, -0.25, 1e-3.
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub(crate) eps: String,

    /// The (first) point, its coordinates separated by commas: 1,-2/3,0.5.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) at: String,
}

/// A text with a block in it.
#[derive(Debug)]
pub(crate) struct Block {
    /// The catalog's entry, where it is one.
    pub(crate) entry: Option<&'static Entry>,
    text: String,
    /// Where in the text the block stands.
    body: Range<usize>,
    lexed: Lexed,
    /// What the text is called in reports.
    origin: String,
}

impl Source {
    /// A system by its name.
    pub(crate) fn of_system(name: String) -> Self {
        Source { system: Some(name), ..Source::default() }
    }

    /// The block that was named, unless it is the catalog's as it stands: then the paper's claims are meant.
    pub(crate) fn block_outside_the_paper(&self) -> Result<Option<Block>, Refusal> {
        if self.field.is_none() && self.file.is_none() && self.parameters.is_empty() {
            return Ok(None);
        }
        self.required_block().map(Some)
    }

    /// The command name of the system whose claims are meant; `None` for all.
    pub(crate) fn system_of_the_paper(&self) -> Result<Option<&'static str>, Refusal> {
        match self.system.as_deref() {
            None => Ok(None),
            Some("general") => Ok(Some("general")),
            Some(name) => find(name).map(|entry| Some(entry.command)).ok_or_else(|| unknown_system(name)),
        }
    }

    /// Whether a parameter was given.
    pub(crate) fn has_parameters(&self) -> bool {
        !self.parameters.is_empty()
    }

    /// The values of a system's parameters, in their order; `None` for one not given.
    pub(crate) fn known_parameters(
        &self,
        system: &System,
        name: &str,
    ) -> Result<Vec<Option<Rational>>, Refusal> {
        given_values(&self.parameters, &system.field.symbols.parameters, name)
    }

    /// The block that was named; `None` if none was.
    pub(crate) fn block(&self) -> Result<Option<Block>, Refusal> {
        match (&self.system, &self.field, &self.file) {
            (None, None, None) => Ok(None),
            (Some(name), None, None) => match find(name) {
                Some(entry) => Ok(Some(Block::of_catalog(entry))),
                None => Err(unknown_system(name)),
            },
            (None, Some(text), None) => Ok(Some(Block::new(None, text.clone(), "--field".to_owned()))),
            (None, None, Some(path)) => {
                let (text, origin) = read_file(path)?;
                let body = chosen(&text, &origin, self.block.as_deref())?;
                Ok(Some(Block::within(None, text, body, origin)))
            }
            _ => Err(Refusal::new("one field at a time: give a SYSTEM, or --field, or --file")),
        }
    }

    /// The values of all parameters of a system, in their order.
    pub(crate) fn parameter_values(&self, system: &System, name: &str) -> Result<Vec<Rational>, Refusal> {
        let names = &system.field.symbols.parameters;
        let values = given_values(&self.parameters, names, name)?;
        let missing: Vec<String> = names
            .iter()
            .zip(&values)
            .filter(|(_, value)| value.is_none())
            .map(|(name, _)| format!("--param {name}=VALUE"))
            .collect();
        if !missing.is_empty() {
            return Err(Refusal::new(format!(
                "{name} needs a value for each of its parameters: add {}",
                missing.join(" ")
            )));
        }
        Ok(values.into_iter().flatten().collect())
    }

    /// This source with single values only, and the parameters that are given as ranges: `xi=-2:2:1/12` as `xi` and the rest.
    pub(crate) fn without_ranges(&self) -> (Self, Vec<(&str, &str)>) {
        let mut single = self.clone();
        single.parameters.retain(|given| !given.contains(':'));
        let ranges = self.parameters.iter().filter(|given| given.contains(':'));
        (single, ranges.map(|given| given.split_once('=').unwrap_or((given, ""))).collect())
    }

    /// The parameters that have a value, by name, in their order; the others are generic.
    pub(crate) fn fixed_parameters(
        &self,
        system: &System,
        name: &str,
    ) -> Result<Vec<(String, Rational)>, Refusal> {
        let values = self.known_parameters(system, name)?;
        let names = system.field.symbols.parameters.iter().cloned();
        Ok(names.zip(values).filter_map(|(name, value)| Some((name, value?))).collect())
    }

    /// The system with the given parameters fixed, the others generic.
    pub(crate) fn specialised(&self, system: System, name: &str) -> Result<System, Refusal> {
        let values = given_values(&self.parameters, &system.field.symbols.parameters, name)?;
        let fixed: Vec<(usize, Rational)> =
            values.into_iter().enumerate().filter_map(|(k, value)| Some((k, value?))).collect();
        if fixed.is_empty() {
            return Ok(system);
        }
        system.specialise(&fixed).ok_or_else(|| {
            Refusal::new(format!("at {} the field of {name} divides by zero", self.parameters.join(", ")))
        })
    }

    /// The block that was named, of a command that needs one.
    pub(crate) fn required_block(&self) -> Result<Block, Refusal> {
        self.block()?.ok_or_else(|| {
            Refusal::new(format!(
                "which system? give one of {}, or --field TEXT, or --file FILE",
                names().join(", ")
            ))
        })
    }
}

impl Block {
    /// A block of the catalog.
    pub(crate) fn of_catalog(entry: &'static Entry) -> Self {
        Block::new(Some(entry), entry.text().to_owned(), entry.command.to_owned())
    }

    /// A text from elsewhere; `origin` is what it is called in reports.
    pub(crate) fn of_text(text: String, origin: String) -> Self {
        Block::new(None, text, origin)
    }

    /// The text itself, or the one call of `kahan!` in it.
    fn new(entry: Option<&'static Entry>, text: String, origin: String) -> Self {
        let body = blocks(&text).into_iter().next().map_or(0..text.len(), |block| block.range);
        Block::within(entry, text, body, origin)
    }

    /// A part of a text.
    fn within(entry: Option<&'static Entry>, text: String, mut body: Range<usize>, origin: String) -> Self {
        // A mark of the byte order, as some editors put it in front.
        body.start += if text[body.clone()].starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let mut lexed = lex(&text[body.clone()]);
        for range in &mut lexed.ranges {
            *range = range.start + body.start..range.end + body.start;
        }
        Block { entry, text, body, lexed, origin }
    }

    /// The system, with its claims proved as the macro does it.
    pub(crate) fn system(&self) -> Result<System, Refusal> {
        let reading = read(&self.lexed.tokens);
        self.accept(reading.system, &reading.diagnostics)
    }

    /// The system, its claims read but not proved.
    pub(crate) fn unproved_system(&self) -> Result<System, Refusal> {
        let mut diagnostics = Diagnostics::default();
        let block = parse::parse(&self.lexed.tokens, &mut diagnostics);
        let system = check::check(block, &mut diagnostics);
        self.accept(system, &diagnostics.finish())
    }

    /// The text of the block, as it was given.
    pub(crate) fn text(&self) -> &str {
        &self.text[self.body.clone()]
    }

    /// The seed of the macro's proof.
    pub(crate) fn seed(&self) -> u64 {
        kahan_algebra::seed(&self.lexed.tokens)
    }

    /// The name of the system in answers: the catalog's, or the header's, or `field`.
    pub(crate) fn name(&self, system: &System) -> String {
        self.entry.map_or_else(|| system.name().to_owned(), |entry| entry.command.to_owned())
    }

    fn accept(&self, system: System, diagnostics: &[Diagnostic]) -> Result<System, Refusal> {
        if diagnostics.is_empty() {
            return Ok(system);
        }
        /// Nobody reads more at once.
        const MOST: usize = 8;
        let shown = diagnostics.iter().take(MOST);
        let reports = shown.map(|one| report(one, &self.text, &self.lexed.ranges, &self.origin));
        let reports: String = reports.collect();
        Err(Refusal::reports(match diagnostics.len().saturating_sub(MOST) {
            0 => reports,
            more => format!("{reports}error: {more} more mistakes are not shown\n"),
        }))
    }
}

fn names() -> Vec<&'static str> {
    all().map(|entry| entry.command).collect()
}

fn unknown_system(name: &str) -> Refusal {
    // Nothing is near to a name that is longer than any.
    let wanted: String = name.chars().take(64).flat_map(char::to_lowercase).collect();
    let distance = |known: &str| strsim::levenshtein(&wanted, &known.to_lowercase());
    let nearest = all()
        .min_by_key(|entry| distance(entry.command).min(distance(entry.type_name)))
        .filter(|entry| distance(entry.command).min(distance(entry.type_name)) <= wanted.chars().count() / 2);
    let hint = nearest.map_or_else(String::new, |entry| format!(" Did you mean `{}`?", entry.command));
    let names = names().join(", ");
    Refusal::new(format!(
        "there is no system `{name}`.{hint} The catalog has {names}; --field TEXT takes a field of your own."
    ))
}
