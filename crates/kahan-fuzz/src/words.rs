//! Makes texts from bytes.

/// Returns the bytes after the first as a text, or as tokens of `words` if the first byte is odd.
pub(crate) fn text(bytes: &[u8], words: &[&str]) -> Option<String> {
    let (&first, rest) = bytes.split_first()?;
    if first % 2 == 0 {
        return Some(str::from_utf8(rest).ok()?.to_owned());
    }
    Some(rest.iter().map(|byte| words[usize::from(*byte) % words.len()]).collect())
}
