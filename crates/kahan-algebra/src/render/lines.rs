//! Breaks long plain text into lines at spaces.

/// Breaks a text into lines of at most `width` characters. A sign stays with the next term, and `=`
/// with the text before it. Longer words get their own line.
///
/// ```
/// let lines = kahan_algebra::render::lines("x~ = a*x + b*y - c*z", 10);
/// assert_eq!(lines, ["x~ = a*x", "+ b*y", "- c*z"]);
/// ```
#[must_use]
pub fn lines(text: &str, width: usize) -> Vec<String> {
    if length(text) <= width {
        return vec![text.to_owned()];
    }
    let mut lines: Vec<String> = Vec::new();
    let mut taken = 0;
    for unit in units(text) {
        match lines.last_mut() {
            Some(line) if taken + length(unit) <= width => {
                line.push_str(unit);
                taken += length(unit);
            }
            _ => {
                let unit = unit.trim_start_matches(' ');
                lines.push(unit.to_owned());
                taken = length(unit);
            }
        }
    }
    lines
}

/// Breaks long lines. Continuation lines are indented further. Rust comments are not broken.
#[must_use]
pub fn folded(text: &str, width: usize) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let body = line.trim_start_matches(' ');
        // A deep indent would leave no room for text.
        let indent = (line.len() - body.len()).min(width / 2);
        let further = (indent + 4).min(width / 2);
        let stays = length(line) <= width || body.starts_with("//");
        let parts = if stays { vec![line.to_owned()] } else { lines(body, width - further) };
        for (index, part) in parts.iter().enumerate() {
            let spaces = if index > 0 { further } else { indent * usize::from(parts.len() > 1) };
            out.push_str(&" ".repeat(spaces));
            out.push_str(part);
            out.push('\n');
        }
    }
    out
}

fn length(text: &str) -> usize {
    text.chars().count()
}

fn units(text: &str) -> Vec<&str> {
    let mut starts = vec![0];
    let mut after_sign = false;
    let mut gap = None;
    for (at, c) in text.char_indices() {
        if c == ' ' {
            gap = gap.or(Some(at));
            continue;
        }
        if let Some(gap) = gap.take() {
            let word = text[at..].split(' ').next().unwrap_or_default();
            if gap > 0 && !after_sign && !matches!(word, "=" | ":=") {
                starts.push(gap);
            }
            after_sign = matches!(word, "+" | "-");
        }
    }
    starts.push(text.len());
    starts.windows(2).map(|pair| &text[pair[0]..pair[1]]).collect()
}
