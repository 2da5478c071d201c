//! Names as letters: which ones Rust keeps for itself.

/// Keywords of Rust, strict and reserved, which cannot name a field of a struct.
pub(super) fn is_keyword(name: &str) -> bool {
    const KEYWORDS: [&str; 53] = [
        "_", "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern",
        "false", "fn", "for", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref",
        "return", "self", "Self", "static", "struct", "super", "trait", "true", "type", "unsafe", "use",
        "where", "while", "abstract", "become", "box", "do", "final", "gen", "macro", "override", "priv",
        "try", "typeof", "unsized", "virtual", "yield",
    ];
    KEYWORDS.contains(&name)
}
