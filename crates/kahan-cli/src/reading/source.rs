//! Arguments that name a system and give values of its parameters.

use std::f64::consts::{E, PI};
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, TypedValueParser};
use kahan_algebra::diagnostics::brief;
use kahan_algebra::rational::Rational;
use kahan_study::{Axis, Catalog, LiftCriterion, Lifting, StudyError, Subject, Systems};

use crate::printing::{UsageError, joined, warn};

use super::MOST_OBSERVED;
use super::block::{Block, read_file, select_block};
use super::values::{named, number, one_of, whole};

/// Advice for a value that the shell has split into several words.
pub(crate) const ONE_WORD: &str = "a value is one word, as in --at 1,0.5,0.3 and --param a=0.4";

/// The system that a command is about.
#[derive(Args, Clone, Debug, Default, PartialEq)]
pub(crate) struct Source {
    /// A system of the catalog, named as `kahan list` shows: euler, lv, e1 to e9, ….
    #[arg(value_name = "SYSTEM")]
    pub(super) system: Option<String>,

    /// The equations as text: 'xdot = a*y; ydot = -x;', or x' = a*y, y' = -x.
    ///
    /// Names that have no equation become parameters. A note lists them, unless a header declares
    /// them. docs/how-to/texts.md lists all notations that are accepted.
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true)]
    field: Option<String>,

    /// Read equations, `kahan!` blocks or arrays from FILE; `-`: standard input.
    ///
    /// Arrays are read from F.npz. They are named c, B and Q, for the field c + B x + Q(x,x).
    #[arg(long, value_name = "FILE")]
    file: Option<PathBuf>,

    /// Choose a block of a Rust file: struct, variable or line.
    #[arg(long, value_name = "NAME", requires = "file", visible_alias = "struct")]
    block: Option<String>,

    /// The number of sites of a chain `for i in … { … }`, x0, x1, ….
    ///
    /// The chain is written out with one variable per site, up to 200 variables. With --start,
    /// `orbit` takes any number of sites.
    #[arg(long, value_name = "N", value_parser = whole(1, usize::MAX))]
    pub(super) sites: Option<usize>,

    /// Set a parameter, as in --param a=1/2; repeat it for each parameter.
    ///
    /// `show` and `verify` insert the value before the map is reduced to lowest terms, `eval` and
    /// `orbit` after that. `discover` treats parameters without a value as symbols. `scan` also
    /// takes a range in place of V.
    #[arg(long = "param", value_name = "NAME=V", allow_hyphen_values = true)]
    pub(super) parameters: Vec<String>,

    /// Rewrite functions, quotients, powers and t as a quadratic field.
    ///
    /// Each of them becomes a new variable with an equation of its own: the field is lifted. Points
    /// are given and shown in the original variables. `kahan lift` shows the new variables and what
    /// happens to the relations between them. WHICH is energy, relations, stable, smallest or
    /// automatic. Without WHICH, a mechanical system gets the lift whose map preserves an energy.
    /// Other fields get a lift whose relations the map preserves exactly, or else one whose
    /// relations have errors that do not grow along the orbit.
    #[arg(long, value_name = "WHICH", num_args = 0..=1, require_equals = true, default_missing_value = "automatic", hide_possible_values = true, value_parser = criterion_parser())]
    pub(super) lift: Option<LiftCriterion>,

    /// With --lift: show the new variables as well.
    #[arg(long)]
    all: bool,

    /// With --lift: the initial time t, 0 if not given.
    #[arg(long, value_name = "T", requires = "lift", allow_hyphen_values = true)]
    t0: Option<String>,
}

fn criterion_parser() -> impl TypedValueParser<Value = LiftCriterion> {
    one_of(&LiftCriterion::ALL, |which| PossibleValue::new(which.name()).help(which.meaning()))
}

/// The length of a step, by one of two options.
#[derive(Args, Clone, Debug, Default)]
#[group(id = "step", multiple = false)]
pub(crate) struct StepLength {
    /// Half the time step (dt = 2 eps): 1/2, -0.25, 1e-3.
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    eps: Option<String>,

    /// The time step dt = 2 eps, instead of --eps.
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    dt: Option<String>,
}

impl StepLength {
    /// Returns ε, half the time step; `None` if no option gives it.
    pub(crate) fn half(&self) -> Result<Option<Rational>, UsageError> {
        let Some((option, text)) = self.given() else { return Ok(None) };
        let value = number(text, option)?;
        Ok(Some(if option == "--dt" { &value * &Rational::new(1, 2) } else { value }))
    }

    /// Returns the text of --eps if it is a range, which some commands allow.
    pub(crate) fn range(&self) -> Option<&str> {
        self.eps.as_deref().filter(|text| text.contains(':'))
    }

    pub(crate) fn given(&self) -> Option<(&'static str, &str)> {
        let eps = self.eps.as_deref().map(|eps| ("--eps", eps));
        eps.or_else(|| self.dt.as_deref().map(|dt| ("--dt", dt)))
    }
}

/// A system, a step and a point: what an evaluation or an orbit begins with.
#[derive(Args, Clone, Debug)]
#[command(mut_group("step", |step| step.required(true)))]
pub(crate) struct Start {
    #[command(flatten)]
    pub(super) source: Source,

    #[command(flatten)]
    pub(super) step: StepLength,

    /// The (initial) point, coordinates separated by commas: 1,-2/3,0.5.
    ///
    /// A file F.csv or F.npy may contain the point as a row. A header `x,y` or `# x,y` names the
    /// variable of each column; a column with another name is refused. `orbit` accepts several
    /// rows. The option may be left out if the equations give initial values, `x(0) = 1` or `init
    /// x=1`.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(super) at: Option<String>,
}

/// The options for the steps of a lifted field.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Stepping {
    /// Project each step of a lifted field onto its relations.
    ///
    /// The projection is symmetric: energies do not drift, and a composition keeps its order. A
    /// step takes as long as 2 to 16 steps of the map, and is computed in f64. The orbit ends at a
    /// step where the projection does not converge.
    #[arg(long)]
    pub(crate) reembed: bool,
}

/// The rounding of products and sums in steps.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Rounding {
    /// Fuse multiply-adds: 3 to 14 % faster, with other last digits.
    ///
    /// Each product and its sum are rounded once. The digits are the same on every processor with
    /// fused operations. Without this option, no operation is fused.
    #[arg(long, conflicts_with = "reembed")]
    pub(crate) fused: bool,
}

/// Steps that are made and not shown.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Transient {
    /// Make N steps before the first point that is shown or observed.
    ///
    /// The first row has step number N and its time. --steps counts only the steps after that.
    /// Without this option N is 0.
    #[arg(long, value_name = "N", default_value = "0", hide_default_value = true, allow_hyphen_values = true, value_parser = whole(0, MOST_OBSERVED))]
    pub(crate) transient: u64,
}

impl Source {
    pub(crate) fn of_system(name: String) -> Self {
        Source { system: Some(name), ..Source::default() }
    }

    /// Returns the arguments that name this source. For standard input, they contain its text.
    pub(crate) fn arguments(&self, block: &Block) -> Vec<String> {
        let is_input = self.is_input();
        let field = self.field.clone().or_else(|| is_input.then(|| block.text().trim().to_owned()));
        let file = self.file.as_ref().filter(|_| !is_input);
        let options = [
            ("--field", field),
            ("--file", file.map(|path| path.to_string_lossy().into_owned())),
            ("--block", file.and(self.block.clone())),
            ("--sites", self.sites.map(|sites| sites.to_string())),
            ("--t0", self.t0.clone()),
        ];
        let options = options.into_iter().filter_map(|(option, value)| Some([option.to_owned(), value?]));
        let parameters = self.parameters.iter().map(|given| ["--param".to_owned(), given.clone()]);
        let lift = self.lift.map(|which| match which {
            LiftCriterion::Automatic => "--lift".to_owned(),
            which => format!("--lift={}", which.name()),
        });
        let all = self.all.then(|| "--all".to_owned());
        let options = options.chain(parameters).flatten().chain(lift).chain(all);
        self.system.iter().cloned().chain(options).collect()
    }

    /// Clears `all`, and returns whether it was set. In `kahan verify`, --all has another meaning.
    pub(crate) fn without_all(mut self) -> (Self, bool) {
        let all = std::mem::take(&mut self.all);
        (self, all)
    }

    pub(crate) fn lifted(mut self) -> Self {
        self.lift.get_or_insert_default();
        self
    }

    /// Returns the lift that --lift selects. An automatic choice depends on the initial point
    /// `start`. It gives parameters with a range the values in `near`, the middles of the ranges.
    pub(super) fn lifting(
        &self,
        start: Option<(Vec<Rational>, Vec<String>)>,
        near: Vec<(String, Rational)>,
    ) -> Result<Option<Lifting>, UsageError> {
        let Some(which) = self.lift else {
            let refusal = || UsageError::new("--all shows the new variables of a lift; add --lift");
            return if self.all { Err(refusal()) } else { Ok(None) };
        };
        let time = self.t0.as_deref().map(|time| number(time, "--t0")).transpose()?.unwrap_or_default();
        let (start, names) = start.map_or((None, Vec::new()), |(start, names)| (Some(start), names));
        Ok(Some(Lifting { which, start, names, near, time, shows_all: self.all }))
    }

    pub(crate) fn is_named(&self) -> bool {
        self.system.is_some() || self.field.is_some() || self.file.is_some()
    }

    pub(crate) fn has_parameters(&self) -> bool {
        !self.parameters.is_empty()
    }

    pub(super) fn given(&self) -> Result<Vec<(String, Rational)>, UsageError> {
        let value = |given: &String| {
            let (name, value) = named(given, "--param", "xi=1/2")?;
            Ok((name.to_owned(), number(value, &format!("--param {name}"))?))
        };
        self.parameters.iter().map(value).collect()
    }

    /// Refuses the command if a quantity on `axes` has a fixed value, too. That of ε is in `step`.
    pub(crate) fn leaves_free(&self, axes: &[Axis], step: &StepLength) -> Result<(), UsageError> {
        let parameters = self.given()?.into_iter().map(|(name, _)| (format!("--param {name}"), name));
        let mut given =
            parameters.chain(step.given().map(|(option, _)| (option.to_owned(), "eps".to_owned())));
        let Some((option, name)) = given.find(|(_, name)| axes.iter().any(|axis| axis.name == *name)) else {
            return Ok(());
        };
        Err(UsageError::new(format!("--over already varies {name}; leave {option} out")))
    }

    pub(super) fn subject(&self) -> Result<Subject, UsageError> {
        match &self.system {
            Some(name) if self.field.is_none() && self.file.is_none() => Ok(Subject::named(name)),
            _ => Ok(self.required_block()?.subject()),
        }
    }

    pub(crate) fn block(&self) -> Result<Option<Block>, UsageError> {
        match (&self.system, &self.field, &self.file) {
            (None, None, None) => Ok(None),
            (Some(name), None, None) => match Block::named(name) {
                None => Err(StudyError::unknown_system(name, &Systems).into()),
                block => Ok(block),
            },
            (None, Some(text), None) => Ok(Some(Block::of_text(text.clone(), "--field".to_owned()))),
            (None, None, Some(path)) if path.extension().is_some_and(|ending| ending == "npz") => {
                Block::of_arrays(path).map(Some)
            }
            (None, None, Some(path)) => {
                let (text, origin) = read_file(path)?;
                let body = select_block(&text, &origin, self.block.as_deref())?;
                let block = Block::within(text, body, origin);
                if self.is_input() {
                    self.notes_on(&block, &[]).iter().for_each(|note| warn(note));
                }
                Ok(Some(block))
            }
            (Some(word), ..) => Err(UsageError::new(format!(
                "one field at a time: `{word}` is read as a SYSTEM, and --field or --file is given as well; {ONE_WORD}"
            ))),
            _ => Err(UsageError::new("one field at a time: give --field or --file")),
        }
    }

    /// Returns whether the field comes from standard input, which can be read only once.
    fn is_input(&self) -> bool {
        self.file.as_deref().is_some_and(|path| path == Path::new("-"))
    }

    /// Returns notes on how the text was read, and on undeclared names with no value and no range.
    pub(crate) fn notes(&self, ranges: &[String]) -> Vec<String> {
        let block = if self.is_input() { None } else { self.block().ok().flatten() };
        block.map_or_else(Vec::new, |block| self.notes_on(&block, ranges))
    }

    fn notes_on(&self, block: &Block, ranges: &[String]) -> Vec<String> {
        let given = self.parameters.iter().chain(ranges);
        let given: Vec<&str> = given.filter_map(|given| Some(given.split_once('=')?.0.trim())).collect();
        block.notes(&given).into_iter().chain(undeclared_in(block, &given)).collect()
    }

    /// Separates parameters that are given as ranges, such as `xi=-2:2:+1/12`, from the others.
    pub(crate) fn without_ranges(&self) -> (Self, Vec<(&str, &str)>) {
        let mut single = self.clone();
        single.parameters.retain(|given| !given.contains(':'));
        let ranges = self.parameters.iter().filter(|given| given.contains(':'));
        (single, ranges.map(|given| given.split_once('=').unwrap_or((given, ""))).collect())
    }

    pub(crate) fn with_parameter(mut self, name: &str, value: &Rational) -> Self {
        self.parameters.push(format!("{name}={value}"));
        self
    }

    pub(crate) fn with_text(self, text: String) -> Self {
        Source { system: None, field: Some(text), file: None, block: None, ..self }
    }

    /// Returns the block that the arguments select. Refuses the command if they select none.
    pub(crate) fn required_block(&self) -> Result<Block, UsageError> {
        self.block()?.ok_or_else(|| {
            let names = joined(Systems.names().iter().map(|[name, _]| name), ", ");
            UsageError::new(format!("which system? give one of {names}, or --field TEXT, or --file FILE"))
        })
    }
}

/// Returns a note on the undeclared names in a text that have no value.
fn undeclared_in(block: &Block, given: &[&str]) -> Option<String> {
    const MOST: usize = 8;

    let mut names = block.undeclared();
    let has_value = |name: &String| block.parameters().iter().any(|(own, _)| own == name);
    names.retain(|name| !given.contains(&name.as_str()) && !has_value(name));
    let number = |(name, value): &(&str, f64)| {
        names.iter().any(|own| own == name).then(|| format!("; `const {name} = {value};` is the number"))
    };
    let product = |name: &String| Some(format!("; for a product write {}", block.product(name)?));
    let products = names.iter().filter_map(product);
    let hints: String = [("E", E), ("pi", PI)].iter().filter_map(number).chain(products).collect();
    let more = if names.len() > MOST { ", …" } else { "" };
    names.truncate(MOST);
    let equations = joined(names.iter().map(|name| format!("{name}dot")), ", ");
    let taken = match names.len() {
        0 => return None,
        1 => "is taken as a parameter",
        _ => "are taken as parameters",
    };
    let names = names.join(", ");
    Some(brief(&format!("{names}{more} {taken}: nothing defines {equations}{more}{hints}")))
}
