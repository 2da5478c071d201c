//! The entries of a bracket: pairs of different states, each once.

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::syntax::{self, ClaimBody, TensorEntry};

use super::names::Scope;

/// The indices of the states of a bracket's entries, none for other claims; `None` if an entry is
/// wrong. All wrong entries are reported.
pub(super) fn entry_places(
    claim: &syntax::Claim,
    scope: &Scope,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<(usize, usize)>> {
    let Some(ClaimBody::Tensor(entries)) = &claim.body else { return Some(Vec::new()) };
    if entries.is_empty() {
        let message = format!("the bracket `{}` has no entries", claim.name.text);
        let help = "write its entries, as in `{x,y} = x*y;`";
        diagnostics.report(Kind::Claim, claim.name.span, message, help);
        return None;
    }
    let mut places: Vec<(usize, usize)> = Vec::new();
    for entry in entries {
        match entry_place(entry, &places, scope) {
            Ok(place) => places.push(place),
            Err(diagnostic) => diagnostics.push(diagnostic),
        }
    }
    (places.len() == entries.len()).then_some(places)
}

/// The indices of an entry's states.
fn entry_place(
    entry: &TensorEntry,
    earlier: &[(usize, usize)],
    scope: &Scope,
) -> Result<(usize, usize), Diagnostic> {
    let index = |name: &syntax::Name| {
        scope.symbols.states.iter().position(|state| *state == name.text).ok_or_else(|| {
            let message = format!("`{}` is not a state variable", name.text);
            let help = format!("the entries of a bracket are pairs of {}", scope.symbols.states.join(", "));
            Diagnostic::new(Kind::Claim, name.span, message, help)
        })
    };
    let (row, column) = (index(&entry.row)?, index(&entry.column)?);
    let wrong = |message: String, help: &str| {
        Err(Diagnostic::new(Kind::Claim, entry.row.span.to(entry.column.span), message, help))
    };
    if row == column {
        return wrong(
            format!("{{{0},{0}}} is zero for every bracket", entry.row.text),
            "remove the entry, or name two different states",
        );
    }
    if earlier.contains(&(row, column)) || earlier.contains(&(column, row)) {
        return wrong(
            format!("the entry {{{},{}}} is given twice", entry.row.text, entry.column.text),
            "give each pair once; {y,x} is −{x,y} by itself",
        );
    }
    Ok((row, column))
}
