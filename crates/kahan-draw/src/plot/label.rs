//! Draws labels. Single letters denote variables and are italic. Superscripts and subscripts are
//! drawn as small digits and signs, because some fonts lack these characters.

use maud::{Markup, html};

use super::path::{Place, tenths};
use super::script::{SUBSCRIPTS, SUPERSCRIPTS};

/// The font size of tick labels and legends, which is 8.6 points in print.
pub(super) const SMALL_FONT_SIZE: f64 = 12.0;
pub(super) const LARGE_FONT_SIZE: f64 = 13.0;
/// The smallest font size, which is 6 points in print.
const LEAST_FONT_SIZE: f64 = 8.4;

/// Returns the width of a label in DejaVu Sans, a wide common font.
pub(super) fn width(words: &str, size: f64) -> f64 {
    let part = |c: char| match c {
        ' ' | '.' | ',' | ':' | ';' | '(' | ')' | '/' | '|' | 'f' | 'i' | 'j' | 'l' | 'r' | 't' => 0.41,
        'm' | 'w' | 'M' | 'W' | '−' | '+' | '=' | '≤' | '≥' | '<' | '>' | '×' | '…' => 0.98,
        'A'..='Z' => 0.75,
        _ => 0.64,
    };
    words.chars().map(|c| style_of(c).map_or(size * part(c), |(_, c)| small(size) * part(c))).sum()
}

fn small(size: f64) -> f64 {
    (0.7 * size).max(LEAST_FONT_SIZE)
}

const USUAL: f64 = 0.92;

/// Returns an upper bound on the distance between the middle and the ends of a label in common
/// fonts.
pub(super) fn reach(words: &str, size: f64) -> f64 {
    (1.0 - USUAL / 2.0) * width(words, size)
}

/// Shrinks a label to the width `room`. If the text becomes too small, shortens it.
pub(super) fn fit_to_width(words: &str, size: f64, room: f64) -> (String, f64) {
    let smaller = (size * (room / 2.0 / reach(words, size)).clamp(0.7, 1.0)).max(LEAST_FONT_SIZE);
    let mut shown = words.to_owned();
    while 2.0 * reach(&shown, smaller) > room && shown.chars().count() > 2 {
        let count = shown.chars().count();
        shown = shown.chars().take(count - 2).chain(['…']).collect();
    }
    (shown, smaller)
}

#[derive(Clone, Copy, PartialEq)]
enum FontStyle {
    Upright,
    Italic,
    Raised,
    Lowered,
}

impl FontStyle {
    /// Returns how far characters of this style are lowered, as a multiple of the font size.
    fn drop(self) -> f64 {
        match self {
            FontStyle::Raised => -0.35,
            FontStyle::Lowered => 0.2,
            FontStyle::Upright | FontStyle::Italic => 0.0,
        }
    }
}

fn style_of(c: char) -> Option<(FontStyle, char)> {
    let digit = |index: usize, tenth: char| char::from_digit(index as u32, 10).unwrap_or(tenth);
    let raised =
        SUPERSCRIPTS.iter().position(|raised| *raised == c).map(|i| (FontStyle::Raised, digit(i, '−')));
    raised
        .or_else(|| SUBSCRIPTS.iter().position(|low| *low == c).map(|i| (FontStyle::Lowered, digit(i, 'n'))))
}

fn styled_parts(words: &str) -> Vec<(FontStyle, String)> {
    let letters: Vec<char> = words.chars().collect();
    let is_word = |i: usize| {
        letters.get(i).is_some_and(|c| (c.is_alphanumeric() || *c == '_') && style_of(*c).is_none())
    };
    let mut parts: Vec<(FontStyle, String)> = Vec::new();
    for (i, &letter) in letters.iter().enumerate() {
        let stands_alone = letter.is_alphabetic() && !(is_word(i + 1) || i > 0 && is_word(i - 1));
        let plain = if stands_alone { FontStyle::Italic } else { FontStyle::Upright };
        let (set, letter) = style_of(letter).unwrap_or((plain, letter));
        match parts.last_mut() {
            Some((before, part)) if *before == set => part.push(letter),
            _ => parts.push((set, letter.to_string())),
        }
    }
    parts
}

/// Writes a label, rotated by `turn` degrees. The anchor is `start`, `middle` or `end`.
pub(super) fn text(at: Place, turn: i32, anchor: &str, size: f64, words: &str) -> Markup {
    let transform =
        (turn != 0).then(|| format!("translate({} {}) rotate({turn})", tenths(at.0), tenths(at.1)));
    let (x, y) = if turn == 0 { at } else { (0.0, 0.0) };
    let italic = |set: FontStyle| (set == FontStyle::Italic).then_some("italic");
    let parts = styled_parts(words);
    if let [(set, part)] = &parts[..] {
        return html! {
            text transform=[transform] x=(tenths(x)) y=(tenths(y)) text-anchor=(anchor) font-size=(tenths(size)) font-style=[italic(*set)] {
                (part)
            }
        };
    }
    // Programs disagree about the width of a label with several parts, so its start is computed.
    let before = match anchor {
        "start" => 0.0,
        "middle" => 0.5,
        _ => 1.0,
    };
    let x = x - USUAL * before * width(words, size);
    let mut line = 0.0;
    let parts = parts.into_iter().map(|(set, part)| {
        let drop = set.drop() * size;
        let dy = (drop != line).then(|| tenths(drop - line));
        line = drop;
        let small = (set.drop() != 0.0).then(|| tenths(small(size)));
        html! { tspan dy=[dy] font-size=[small] font-style=[italic(set)] { (part) } }
    });
    html! {
        text transform=[transform] x=(tenths(x)) y=(tenths(y)) text-anchor="start" font-size=(tenths(size)) {
            @for part in parts { (part) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{LEAST_FONT_SIZE, fit_to_width, text, width};

    #[test]
    fn variables_are_italic_and_words_and_numbers_are_not() {
        let set = |words| text((0.0, 0.0), 0, "start", 12.0, words).into_string();
        assert!(set("x").contains("font-style=\"italic\">x<") && !set("n1").contains("italic"));
        let ln = set("ln n");
        assert!(ln.contains("<tspan>ln </tspan><tspan font-style=\"italic\">n<"), "{ln}");
        let power = set("10⁻⁸");
        assert!(power.contains("<tspan>10</tspan><tspan dy=\"-4.2\" font-size=\"8.4\">−8<"), "{power}");
        let index = set("x₀ + 1");
        assert!(index.contains("italic\">x<") && index.contains("<tspan dy=\"-2.4\"> + 1<"), "{index}");
    }

    #[test]
    fn what_is_too_long_is_smaller_and_then_cut() {
        let words = "a long name of an axis";
        for room in [20.0, 60.0, 100.0, 170.0, 900.0] {
            let (shown, size) = fit_to_width(words, 13.0, room);
            assert!(width(&shown, size) <= room && size >= LEAST_FONT_SIZE, "{room}: {shown} at {size}");
            assert_eq!(shown == words, room > 150.0, "{room}: {shown}");
        }
    }
}
