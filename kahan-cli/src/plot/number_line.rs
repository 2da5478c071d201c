//! A number line with round ticks.

/// A number line.
#[derive(Clone, Debug)]
pub(crate) struct NumberLine {
    /// What it shows: `log n`.
    pub(crate) label: String,
    /// The least value shown.
    pub(crate) low: f64,
    /// The greatest value shown.
    pub(crate) high: f64,
}

impl NumberLine {
    /// One that shows all these values, with a little room.
    pub(crate) fn around(label: &str, values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values
            .filter(|value| value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        let room = if high > low { 0.04 * (high - low) } else { 0.5 };
        NumberLine { label: label.to_owned(), low: low - room, high: high + room }
    }

    /// Round values on it, three to eight of them, and how many decimals they need.
    pub(super) fn ticks(&self) -> (Vec<f64>, usize) {
        let rough = (self.high - self.low) / 7.0;
        let power = rough.log10().floor();
        let unit = 10_f64.powf(power);
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().find(|m| m * unit >= rough).unwrap_or(10.0) * unit;
        let first = (self.low / step).ceil();
        let ticks = (0..12).map(|i| (first + f64::from(i)) * step).take_while(|tick| *tick <= self.high);
        // 0.1 + 0.2 is no label.
        let decimals = (-step.log10().floor()).max(0.0) as usize;
        (ticks.map(|tick| if tick.abs() < step / 2.0 { 0.0 } else { tick }).collect(), decimals)
    }

    pub(super) fn place(&self, value: f64, from: f64, to: f64) -> f64 {
        from + (value - self.low) / (self.high - self.low) * (to - from)
    }

    pub(super) fn shows(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

#[cfg(test)]
mod tests {
    use super::NumberLine;

    #[test]
    fn ticks_are_round_and_lie_on_the_axis() {
        for (low, high) in [(0.0, 1.0), (-3.2, 7.9), (0.0, 812_345.0), (1.59, 1.64), (-1e-9, 1e-9)] {
            let line = NumberLine { label: String::new(), low, high };
            let (ticks, decimals) = line.ticks();
            assert!((3..=8).contains(&ticks.len()), "{low}..{high}: {ticks:?}");
            assert!(ticks.iter().all(|tick| line.shows(*tick)), "{low}..{high}: {ticks:?}");
            let labels: std::collections::BTreeSet<String> =
                ticks.iter().map(|tick| format!("{tick:.decimals$}")).collect();
            assert_eq!(labels.len(), ticks.len(), "the labels differ: {labels:?}");
        }
    }

    #[test]
    fn an_axis_around_one_value_or_none_still_has_a_length() {
        for values in [vec![], vec![2.0], vec![f64::NAN, 2.0, f64::INFINITY]] {
            let line = NumberLine::around("", values.into_iter());
            assert!(line.high > line.low, "{line:?}");
        }
    }
}
