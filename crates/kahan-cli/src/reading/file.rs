//! `--file` and `--block`: the text of a file, and which part of it is the field.

use std::ops::Range;
use std::path::Path;
use std::{fs, io};

use super::rust_file::{RustBlock, blocks};
use crate::printing::Refusal;

/// The text of a file, or of standard input for `-`, and what it is called in reports.
pub(super) fn read_file(path: &Path) -> Result<(String, String), Refusal> {
    let is_input = path.as_os_str() == "-";
    let origin = if is_input { "standard input".to_owned() } else { path.display().to_string() };
    let read = if is_input { io::read_to_string(io::stdin()) } else { fs::read_to_string(path) };
    match read {
        Ok(text) => Ok((text, origin)),
        Err(error) if is_input => Err(Refusal::new(format!("cannot read {origin}: {error}"))),
        Err(error) => Err(Refusal::new(format!("cannot read the file {origin}: {error}"))),
    }
}

/// Where the field stands: all of the text, or one call of `kahan!`, by its name or line if there
/// are several.
pub(super) fn chosen(text: &str, origin: &str, wanted: Option<&str>) -> Result<Range<usize>, Refusal> {
    let blocks = blocks(text);
    let is_wanted = |block: &&RustBlock| {
        wanted.is_none_or(|wanted| block.name.as_deref() == Some(wanted) || block.line.to_string() == wanted)
    };
    let found: Vec<&RustBlock> = blocks.iter().filter(is_wanted).collect();
    let listed = blocks.iter().map(|block| match &block.name {
        Some(name) => format!("{name} (line {})", block.line),
        None => format!("line {}", block.line),
    });
    let listed = listed.collect::<Vec<_>>().join(", ");
    Err(Refusal::new(match (&found[..], wanted) {
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
