//! Writes names in LaTeX, and as plain text with Greek letters and indices.

/// Writes a name in LaTeX. For example, `x1_b` becomes x with the indices 1 and b. Greek names
/// become letters. Indices that are words are upright. A final `_` becomes a prime.
pub(super) fn latex_name(name: &str) -> String {
    if let Some(name) = name.strip_suffix('_').filter(|name| !name.is_empty()) {
        return format!("{}'", latex_name(name));
    }
    let parts: Vec<&str> = name.split('_').collect();
    let [first, rest @ ..] = &parts[..] else { return word("mathit", name) };
    let stem = first.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.is_empty() || rest.iter().any(|part| part.is_empty()) {
        return word("mathit", name);
    }
    let digits = Some(&first[stem.len()..]).filter(|digits| !digits.is_empty());
    let indices: Vec<String> =
        digits.into_iter().map(str::to_owned).chain(rest.iter().map(|part| index(part))).collect();
    let stem = letters("mathit", stem);
    if indices.is_empty() { stem } else { format!("{stem}_{{{}}}", indices.join(",")) }
}

/// Writes a name as plain text, with Greek letters and digits as indices, for example `μ₁`.
#[must_use]
pub fn symbol(name: &str) -> String {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let letters = stem.strip_suffix('_').filter(|_| stem != name).unwrap_or(stem);
    let sign = |text: &str| {
        GREEK.iter().find(|(known, _)| *known == text).map_or(text, |(_, sign)| *sign).to_owned()
    };
    let letter = if letters == "eps" { "ε".to_owned() } else { sign(letters) };
    if letter.chars().count() != 1 {
        return name.to_owned();
    }
    let index =
        name[stem.len()..].bytes().filter_map(|digit| char::from_u32('₀' as u32 + u32::from(digit - b'0')));
    letter + &index.collect::<String>()
}

/// Writes an index: a number, a letter, a word, or a Greek name with an optional number.
fn index(part: &str) -> String {
    let stem = part.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &part[stem.len()..];
    match (stem, digits) {
        ("", _) => digits.to_owned(),
        (_, "") => letters("mathrm", stem),
        _ if greek(stem).is_some() => format!("{}_{{{digits}}}", letters("mathrm", stem)),
        _ => word("mathrm", part),
    }
}

/// Writes a Greek letter, a single letter, or a word in the typeface `face`.
fn letters(face: &str, text: &str) -> String {
    match greek(text) {
        Some(letter) => format!("\\{letter}"),
        None if text.chars().count() == 1 => text.to_owned(),
        None => word(face, text),
    }
}

fn word(face: &str, text: &str) -> String {
    format!("\\{face}{{{}}}", text.replace('_', "\\_"))
}

/// Returns the LaTeX command of a Greek letter, which is given by name or as a character.
fn greek(text: &str) -> Option<&'static str> {
    match text {
        // The name of ε, half the time step, is always written `\varepsilon`.
        "eps" | "ε" => return Some("varepsilon"),
        "ϵ" => return Some("epsilon"),
        _ => {}
    }
    GREEK.iter().find(|(name, sign)| *name == text || *sign == text).map(|(name, _)| *name)
}

/// Greek letters with LaTeX commands. The others look like Latin letters, and have no commands.
const GREEK: [(&str, &str); 40] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ϵ"),
    ("varepsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("vartheta", "ϑ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("varpi", "ϖ"),
    ("rho", "ρ"),
    ("varrho", "ϱ"),
    ("sigma", "σ"),
    ("varsigma", "ς"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("varphi", "ϕ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
];

#[cfg(test)]
mod tests {
    use super::{latex_name, symbol};

    #[test]
    fn names_are_symbols_in_plain_text_where_they_are_letters() {
        for (name, text) in [
            ("eps", "ε"),
            ("xi", "ξ"),
            ("x0", "x₀"),
            ("mu_12", "μ₁₂"),
            ("al3", "al3"),
            ("x_", "x_"),
            ("prey", "prey"),
        ] {
            assert_eq!(symbol(name), text);
        }
    }

    #[test]
    fn names_are_set_by_their_kind() {
        for (name, latex) in [
            ("x", "x"),
            ("x1", "x_{1}"),
            ("mu_1", "\\mu_{1}"),
            ("mu1", "\\mu_{1}"),
            ("alpha12", "\\alpha_{12}"),
            ("al", "\\mathit{al}"),
            ("al3", "\\mathit{al}_{3}"),
            ("x_max", "x_{\\mathrm{max}}"),
            ("x_e7", "x_{\\mathrm{e7}}"),
            ("a_1_2", "a_{1,2}"),
            ("x1_max", "x_{1,\\mathrm{max}}"),
            ("x_i", "x_{i}"),
            ("x_mu", "x_{\\mu}"),
            ("x_mu2", "x_{\\mu_{2}}"),
            ("k_on_off", "k_{\\mathrm{on},\\mathrm{off}}"),
            ("Gamma", "\\Gamma"),
            ("Alpha", "\\mathit{Alpha}"),
            ("eps", "\\varepsilon"),
            ("eps_0", "\\varepsilon_{0}"),
            ("epsilon", "\\epsilon"),
            ("ξ2", "\\xi_{2}"),
            ("_x", "\\mathit{\\_x}"),
            ("x_", "x'"),
            ("rho__", "\\rho''"),
            ("a__b", "\\mathit{a\\_\\_b}"),
            ("H2O", "\\mathit{H2O}"),
        ] {
            assert_eq!(latex_name(name), latex, "{name}");
        }
    }
}
