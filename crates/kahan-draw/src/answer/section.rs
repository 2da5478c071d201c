//! Sentences about Poincaré sections.

/// Says how many sign changes of the formula `plane` along an orbit are jumps instead of zeros.
/// Returns `None` if there are none.
#[must_use]
pub fn jumps(plane: &str, jumps: u64) -> Option<String> {
    let count = match jumps {
        0 => return None,
        1 => "1 jump".to_owned(),
        many => format!("{many} jumps"),
    };
    Some(format!(
        "{count}: there {plane} changes its sign without a zero, as at a pole of the formula or of the map; a jump is no crossing"
    ))
}
