//! Ranges behind options. For this version a note says what a bare third part meant before.

use kahan_study::{Axis, Range, Spacing};

use crate::printing::{Refusal, warn};

/// NAME=FROM:TO:…, as `--over` has it; `before` as of [`axis`].
pub(crate) fn over(text: &str, before: fn(usize) -> Spacing) -> Result<Axis, Refusal> {
    let (name, range) = text.split_once('=').ok_or_else(|| {
        Refusal::new(format!(
            "--over: `{text}` does not say of what; write NAME=FROM:TO:COUNT, as in eps=1/10:1:400"
        ))
    })?;
    axis(name.trim(), range, &format!("--over {}", name.trim()), before)
}

/// FROM:TO:… behind an option, for what has this name. `before` is what a bare COUNT meant there
/// until now.
pub(crate) fn axis(
    name: &str,
    text: &str,
    option: &str,
    before: fn(usize) -> Spacing,
) -> Result<Axis, Refusal> {
    let range = Range::read(text).map_err(|why| Refusal::new(format!("{option}: {why}")))?;
    if let Spacing::Count(count) = range.spacing()
        && let Some(meant) = range.spaced(before(*count))
    {
        warn(&format!(
            "{option}: {range} means {} now; it meant {}, which is written {meant}",
            range.spacing().words(),
            meant.spacing().words()
        ));
    }
    Ok(Axis { name: name.to_owned(), range })
}
