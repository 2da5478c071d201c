//! Recognises wrong keywords. For `invariant H = …`, the help proposes `integral`.

use crate::diagnostics::{Diagnostic, Kind};
use crate::syntax::{Block, Claim, ClaimKind, Constant};

use super::cursor::Cursor;

const KEYWORDS: [&str; 5] = ["integral", "density", "bracket", "drift", "const"];

/// The synonyms of each keyword, in lower case and without underscores.
const SYNONYMS: [(&str, &str); 5] = [
    (
        "integral",
        "invariant conserved conserve conserves preserved preserves firstintegral first constantofmotion \
         conservedquantity conservation hamiltonian energy casimir quantity",
    ),
    ("density", "measure invariantmeasure volume volumeform multiplier jacobimultiplier weight"),
    ("bracket", "poisson poissonbracket poissontensor liepoisson tensor symplectic structure"),
    ("drift", "recurrence drifting semiinvariant relativeinvariant"),
    ("const", "constant let static define def val var"),
];

const PARAMETERS: [&str; 4] = ["parameter", "parameters", "param", "params"];

/// Returns the keyword that `word` probably means, because it is a synonym or is spelt similarly.
fn probable_keyword(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase().replace('_', "");
    let synonym = SYNONYMS.iter().find(|(_, words)| words.split(' ').any(|known| known == word));
    // A synonym may have one wrong letter, as in `poison` for `poisson`.
    let slip = || {
        let is_near = |known: &str| word.len() > 4 && strsim::levenshtein(&word, known) == 1;
        SYNONYMS.iter().find(|(_, words)| words.split(' ').any(is_near)).map(|(keyword, _)| *keyword)
    };
    let near = || KEYWORDS.iter().find(|keyword| word.len() > 3 && strsim::levenshtein(&word, keyword) <= 2);
    synonym.map(|(keyword, _)| *keyword).or_else(|| near().copied()).or_else(slip)
}

/// Reports an item `WORD NAME …` with an unknown keyword, and declares NAME to avoid more errors.
pub(super) fn wrong_keyword<X>(cursor: &Cursor<'_>, block: &mut Block<X>) -> Option<Diagnostic> {
    let word = cursor.identifier(0)?;
    cursor.identifier(1)?;
    let ahead =
        if KEYWORDS.contains(&cursor.identifier(1)?) && cursor.identifier(2).is_some() { 2 } else { 1 };
    let name = cursor.name(ahead)?;
    let wrong = |help: String| {
        Diagnostic::new(Kind::Syntax, cursor.here(), format!("`{word}` is no keyword of the language"), help)
    };
    if PARAMETERS.contains(&word.to_lowercase().as_str()) {
        return Some(wrong(format!("parameters stand in the header: `struct Name {{ {} }}`", name.text)));
    }
    if ahead == 2 {
        return Some(wrong(format!("did you mean `{} {} …`?", cursor.identifier(1)?, name.text)));
    }
    let keyword = probable_keyword(word)?;
    let Some(kind) = ClaimKind::of_keyword(keyword) else {
        let help = format!("did you mean `const {} = …;`?", name.text);
        block.constants.push(Constant { name, value: None });
        return Some(wrong(help));
    };
    let shape = match kind {
        ClaimKind::Bracket => "{ {x,y} = …; }",
        ClaimKind::Drift => "= … by …;",
        ClaimKind::Integral | ClaimKind::Density => "= …;",
    };
    let help = format!("did you mean `{keyword} {} {shape}`?", name.text);
    block.claims.push(Claim { kind, name, body: None, conditions: Vec::new() });
    Some(wrong(help))
}
