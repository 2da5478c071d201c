//! Text from bytes.

/// A text for a parser: either the bytes as they stand, or each of them a word of its language.
///
/// From words the fuzzer finds texts that are nearly right, which bytes alone take very long to
/// become; only bytes hold what is no word.
pub(crate) fn text(bytes: &[u8], words: &[&str]) -> Option<String> {
    let (&first, rest) = bytes.split_first()?;
    if first % 2 == 0 {
        return Some(str::from_utf8(rest).ok()?.to_owned());
    }
    Some(rest.iter().map(|byte| words[usize::from(*byte) % words.len()]).collect())
}
