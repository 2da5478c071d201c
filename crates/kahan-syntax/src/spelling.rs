//! Names as letters: which ones Rust keeps for itself, and which are slips of others.

/// Keywords of Rust, strict and reserved, which cannot name a field of a struct.
#[must_use]
pub fn is_keyword(name: &str) -> bool {
    const KEYWORDS: [&str; 53] = [
        "_", "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern",
        "false", "fn", "for", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref",
        "return", "self", "Self", "static", "struct", "super", "trait", "true", "type", "unsafe", "use",
        "where", "while", "abstract", "become", "box", "do", "final", "gen", "macro", "override", "priv",
        "try", "typeof", "unsized", "virtual", "yield",
    ];
    KEYWORDS.contains(&name)
}

/// The name that `name` is a slip of, if one of them is close enough; of equals, the first. Two
/// neighbours that changed places are one slip.
#[must_use]
pub fn nearest<'a, N: AsRef<str>>(name: &str, known: &'a [N]) -> Option<&'a N> {
    let tolerance = match name.chars().count() {
        0..=1 => 0,
        2..=4 => 1,
        _ => 2,
    };
    let distance = |known: &&N| strsim::osa_distance(&name.to_lowercase(), &known.as_ref().to_lowercase());
    known.iter().min_by_key(distance).filter(|nearest| distance(nearest) <= tolerance)
}
