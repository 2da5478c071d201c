//! The block of a field, from the catalog, from a text, or from a file (`--file`, `--block`).

use std::cell::RefCell;
use std::ops::Range;
use std::path::Path;
use std::{fs, io};

use kahan_algebra::family::Family;
use kahan_algebra::rational::Rational;
use kahan_runtime::FieldText;
use kahan_study::Subject;
use kahan_systems::entry::Entry;
use kahan_systems::lattices;
use kahan_systems::registry::find;

use super::npz::coefficients;
use super::rust_file::{RustBlock, blocks};
use crate::printing::{UsageError, joined};

thread_local! {
    /// The last block that was read. A command needs its block twice, but reads it only once.
    static LAST_BLOCK: RefCell<Option<Block>> = const { RefCell::new(None) };
}

/// File extensions of models that only the Python package reads.
const MODEL_EXTENSIONS: [&str; 3] = ["xml", "sbml", "ant"];

#[derive(Clone, Debug)]
pub(crate) struct Block {
    pub(crate) entry: Option<&'static Entry>,
    text: FieldText,
    is_rust: bool,
}

impl Block {
    pub(super) fn named(name: &str) -> Option<Self> {
        let of = |entry, text: &str, name: &str| Block::new(entry, text.to_owned(), name.to_owned());
        let system = find(name).map(|entry| of(Some(entry), entry.text(), entry.command));
        system.or_else(|| lattices::find(name).map(|family| of(None, family.text, family.command)))
    }

    /// Returns the block in a text; `origin` names the text in reports.
    pub(crate) fn of_text(text: String, origin: String) -> Self {
        Block::new(None, text, origin)
    }

    /// Makes a block from the first call of `kahan!` in a text, or else from the whole text.
    fn new(entry: Option<&'static Entry>, text: String, origin: String) -> Self {
        let body = blocks(&text).into_iter().next().map_or(0..text.len(), |block| block.range);
        Block { entry, ..Block::within(text, body, origin) }
    }

    pub(super) fn of_arrays(path: &Path) -> Result<Self, UsageError> {
        let origin = path.display();
        let bytes = fs::read(path)
            .map_err(|error| UsageError::new(format!("cannot read the file {origin}: {error}")))?;
        let field = coefficients(&bytes).map_err(|why| UsageError::new(format!("{origin} {why}")))?;
        let text = FieldText::of_system(field.system(), origin.to_string());
        Ok(Block { entry: None, text, is_rust: false })
    }

    pub(super) fn within(text: String, body: Range<usize>, origin: String) -> Self {
        let is_rust = body != (0..text.len());
        let block = Block { entry: None, text: FieldText::part(text, body, origin), is_rust };
        if let Some(last) =
            LAST_BLOCK.take().filter(|last| last.text == block.text && last.is_rust == is_rust)
        {
            return last;
        }
        LAST_BLOCK.set(Some(block.clone()));
        block
    }

    pub(super) fn subject(&self) -> Subject {
        Subject::block(self.text.clone())
    }

    /// Returns the parameters that the text does not declare. A Rust file has none of these.
    pub(super) fn undeclared(&self) -> Vec<String> {
        if self.is_rust { Vec::new() } else { self.text.undeclared() }
    }

    /// Returns the block as a family, written `for i in …`. Refuses `option` for a single system.
    pub(crate) fn family(&self, option: &str) -> Result<Family, UsageError> {
        self.text.family().map_err(|mistakes| UsageError::reports(mistakes.to_string()))?.ok_or_else(|| {
            UsageError::new(format!(
                "{option} is for a family, `for i in periodic {{ x[i]dot = …; }}`, and this field has its equations written out"
            ))
        })
    }

    pub(crate) fn text(&self) -> &str {
        self.text.given()
    }

    /// Returns two texts with initial values: in the user's notation, and in that of `kahan!`.
    pub(crate) fn with_start(&self, states: &[String], start: &[Rational]) -> [String; 2] {
        let values = self.text.parameters().iter().map(|(name, value)| format!("{name} = {value}; "));
        let first = states.iter().zip(start).map(|(state, value)| format!("{state}(0) = {value};"));
        let first = joined(first, " ");
        let given = self.text().trim().trim_end_matches(';');
        [format!("{given}; {first}"), format!("{} {}{first}", self.text.text(), values.collect::<String>())]
    }

    /// Returns notes on how the text was read, and on its values except of parameters in `given`.
    pub(super) fn notes(&self, given: &[&str]) -> Vec<String> {
        let is_noted = |name: &str| {
            let named = format!("`{name}` with the value");
            self.text.notes().iter().any(|note| note.contains(&named))
        };
        let is_left = |name: &str| !given.contains(&name) && !is_noted(name);
        let parameters = self.text.parameters().iter().filter(|(name, _)| is_left(name));
        let list = |values: &mut dyn Iterator<Item = &(String, Rational)>| {
            joined(values.map(|(name, value)| format!("{name} = {value}")), ", ")
        };
        let values = [
            (list(&mut parameters.into_iter()), "where numbers are needed; --param gives others"),
            (list(&mut self.text.start().iter()), "at the beginning; --at gives another point"),
        ];
        let values = values.into_iter().filter(|(values, _)| !values.is_empty());
        let values = values.map(|(values, when)| format!("the text gives {values} {when}"));
        self.text.notes().iter().cloned().chain(values).collect()
    }

    /// If a name is several states written together, returns their product, such as `x*y` for `xy`.
    pub(super) fn product(&self, name: &str) -> Option<String> {
        let system = self.text.unproved_system().ok()?;
        let letters: Vec<String> = name.chars().map(String::from).collect();
        let are_states = letters.iter().all(|letter| system.field.symbols.states.contains(letter));
        (are_states && letters.len() > 1).then(|| letters.join("*"))
    }

    pub(super) fn parameters(&self) -> &[(String, Rational)] {
        self.text.parameters()
    }
}

/// Reads a file, or standard input for `-`. Returns the text and its name in reports.
pub(super) fn read_file(path: &Path) -> Result<(String, String), UsageError> {
    let is_input = path.as_os_str() == "-";
    let origin = if is_input { "standard input".to_owned() } else { path.display().to_string() };
    let read = if is_input { io::read_to_string(io::stdin()) } else { fs::read_to_string(path) };
    let what = if is_input { "" } else { "the file " };
    let ending = path.extension().filter(|_| !is_input).unwrap_or_default();
    let is_of_system = |error: &io::Error| error.kind() != io::ErrorKind::InvalidData;
    Err(UsageError::new(match read {
        Err(error) if is_of_system(&error) => format!("cannot read {what}{origin}: {error}"),
        _ if MODEL_EXTENSIONS.iter().any(|model| ending.eq_ignore_ascii_case(model)) => format!(
            "{origin} is a model that Python reads: kahan.read(\"{origin}\"); its `source` is a text for --file"
        ),
        Err(_) => format!(
            "{origin} is no text in UTF-8; arrays c, B and Q come in a file F.npz: \
             np.savez(\"F.npz\", c=c, B=B, Q=Q)"
        ),
        Ok(text) => return Ok((text, origin)),
    }))
}

/// Returns the byte range of the whole text, or of the call of `kahan!` that `wanted` selects.
pub(super) fn select_block(
    text: &str,
    origin: &str,
    wanted: Option<&str>,
) -> Result<Range<usize>, UsageError> {
    let blocks = blocks(text);
    let is_wanted = |block: &&RustBlock| {
        wanted.is_none_or(|wanted| block.name.as_deref() == Some(wanted) || block.line.to_string() == wanted)
    };
    let found: Vec<&RustBlock> = blocks.iter().filter(is_wanted).collect();
    let listed = blocks.iter().map(|block| match &block.name {
        Some(name) => format!("{name} (line {})", block.line),
        None => format!("line {}", block.line),
    });
    let listed = joined(listed, ", ");
    Err(UsageError::new(match (&found[..], wanted) {
        ([one], _) => return Ok(one.range.clone()),
        ([], None) => return Ok(0..text.len()),
        ([], Some(wanted)) if blocks.is_empty() => {
            format!("--block {wanted}: {origin} has no call of `kahan!`; leave it out")
        }
        ([], Some(wanted)) => {
            format!("--block {wanted}: there is no such block in {origin}; it has {listed}")
        }
        (several, None) => format!(
            "{origin} has {} blocks: {listed}; choose one by --block NAME, or by its line",
            several.len()
        ),
        (_, Some(wanted)) => {
            format!("--block {wanted} is not one block: {origin} has {listed}; choose by the line")
        }
    }))
}
