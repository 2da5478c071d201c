//! The colour map viridis (Van der Walt and Smith, matplotlib 2015), from dark to light. Equal
//! steps look about equally large, also in grey. For readers without short-wave cones, steps in
//! violet and blue are smaller.

pub(super) type Rgb = [u8; 3];

const COLOURS_AT_EIGHTHS: [Rgb; 9] = [
    [0x44, 0x01, 0x54],
    [0x47, 0x2d, 0x7b],
    [0x3b, 0x52, 0x8b],
    [0x2c, 0x72, 0x8e],
    [0x21, 0x91, 0x8c],
    [0x28, 0xae, 0x80],
    [0x5e, 0xc9, 0x62],
    [0xad, 0xdc, 0x30],
    [0xfd, 0xe7, 0x25],
];

pub(super) fn colour(part: f64) -> Rgb {
    let at = part.clamp(0.0, 1.0) * (COLOURS_AT_EIGHTHS.len() - 1) as f64;
    let below = (at as usize).min(COLOURS_AT_EIGHTHS.len() - 2);
    let share = at - below as f64;
    let between = |i: usize| {
        let (from, to) =
            (f64::from(COLOURS_AT_EIGHTHS[below][i]), f64::from(COLOURS_AT_EIGHTHS[below + 1][i]));
        (from + share * (to - from)).round() as u8
    };
    [between(0), between(1), between(2)]
}

#[cfg(test)]
mod tests {
    use super::super::colour_vision::{ColourVision, KINDS, lab, linear, simulated};
    use super::colour;

    #[test]
    fn lightness_grows_for_every_kind_of_sight_and_evenly_with_two_kinds_of_cones() {
        for kind in KINDS {
            let light: Vec<f64> =
                (0..=64).map(|i| lab(simulated(colour(f64::from(i) / 64.0).map(linear), kind))[0]).collect();
            let mean = (light[64] - light[0]) / 64.0;
            assert!(mean > 1.0, "{kind:?}: {mean}");
            for step in light.windows(2).map(|pair| pair[1] - pair[0]) {
                // Without short-wave cones, violet looks like blue, so small steps are allowed.
                let least = if matches!(kind, ColourVision::NoShort) { 0.0 } else { mean / 3.0 };
                assert!(step > least && step < 2.5 * mean, "{kind:?}: {step} of {mean}");
            }
        }
    }
}
