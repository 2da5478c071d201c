//! Axes with round ticks. If all values begin with equal digits, the axis subtracts a number from
//! them. If they are then very large or small, the axis divides them by a power of ten. The name of
//! the axis states both, as in `(x − 2.5) / 10⁻⁸`.

use super::script::superscript;

/// An axis.
#[derive(Clone, Debug)]
pub struct NumberLine {
    /// The label. Single letters denote variables, as in `ln n`.
    pub label: String,
    /// The least value shown.
    pub low: f64,
    /// The greatest value shown.
    pub high: f64,
    /// The kind of ticks.
    pub marks: TickKind,
}

/// A kind of ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TickKind {
    /// Round numbers.
    Round,
    /// Whole numbers, for counts.
    Whole,
    /// Powers of ten for values that are decimal logarithms. A short axis shows the logarithms
    /// instead.
    Powers,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) text: String,
}

impl NumberLine {
    /// Makes an axis with round ticks.
    #[must_use]
    pub fn new(label: &str, low: f64, high: f64) -> Self {
        NumberLine { label: label.to_owned(), low, high, marks: TickKind::Round }
    }

    /// Makes an axis that shows all finite values with small margins. Differences of the size of
    /// rounding errors are ignored.
    #[must_use]
    pub fn around(label: &str, values: impl Iterator<Item = f64>) -> Self {
        const ROUNDING: f64 = 1e-13;
        let (low, high) = values
            .filter(|value| value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        let size = low.abs().max(high.abs());
        let room = match high - low {
            _ if size == 0.0 => 0.5,
            length if length > ROUNDING * size => 0.04 * length,
            _ => 0.5 * size,
        };
        NumberLine::new(label, low - room, high + room)
    }

    /// Makes an axis that shows nearly all values. A few distant values are left out.
    #[must_use]
    pub fn around_most(label: &str, values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        values.sort_unstable_by(f64::total_cmp);
        let (Some(&least), Some(&greatest)) = (values.first(), values.last()) else {
            return NumberLine::around(label, std::iter::empty());
        };
        let part = |share: f64| values[(share * (values.len() - 1) as f64) as usize];
        let (low, high) = (part(0.02), part(0.98));
        let reach = high - low;
        let ends = [least.max(low - reach), greatest.min(high + reach)];
        NumberLine::around(label, ends.into_iter())
    }

    /// Returns the label with shift and scale, such as `(x − 2.5) / 10⁻⁸`.
    pub(super) fn name(&self) -> String {
        let label = match self.marks {
            TickKind::Powers if !self.has_powers() => format!("log₁₀ of {}", self.label),
            _ => self.label.clone(),
        };
        let offset = self.offset();
        let (label, is_one) = match offset {
            0.0 => (label, !self.label.contains(' ')),
            _ if offset < 0.0 => (format!("{label} + {}", number(-offset)), false),
            _ => (format!("{label} − {}", number(offset)), false),
        };
        match self.power() {
            0 => label,
            power if is_one => format!("{label} / 10{}", superscript(power)),
            power => format!("({label}) / 10{}", superscript(power)),
        }
    }

    /// Returns the largest power of ten that does not exceed the length of the axis.
    fn unit(&self) -> f64 {
        libm::exp10(libm::log10(self.high - self.low).floor())
    }

    /// Returns the number that is subtracted from values with equal leading digits, else 0.
    fn offset(&self) -> f64 {
        const SHARED: f64 = 1e4;
        let unit = self.unit();
        let is_far = self.low.abs().max(self.high.abs()) >= SHARED * unit;
        if is_far { ((self.low / 2.0 + self.high / 2.0) / unit).round() * unit } else { 0.0 }
    }

    /// Returns the exponent of the power of ten that divides tick labels.
    fn power(&self) -> i32 {
        let offset = self.offset();
        let largest = (self.low - offset).abs().max((self.high - offset).abs());
        if (1e-2..1e5).contains(&largest) { 0 } else { libm::log10(largest).floor() as i32 }
    }

    fn has_powers(&self) -> bool {
        self.high.floor() - self.low.ceil() >= 1.0
    }

    /// Returns four to seven ticks at round values. Fewer ticks are returned if `fits` rejects the
    /// labels.
    pub(super) fn ticks(&self, fits: impl Fn(&[Tick]) -> bool) -> Vec<Tick> {
        let unit = self.unit();
        // Successive round steps differ by factors of 2 or 2.5, so one gives four to seven ticks.
        let finer = |factors: &'static [f64]| {
            [10.0, 1.0, 0.1].into_iter().flat_map(move |power| factors.iter().map(move |f| f * power))
        };
        let steps = finer(&[5.0, 2.0, 1.0]).chain(finer(&[2.5])).map(|factor| factor * unit);
        let is_whole = self.marks == TickKind::Whole || self.marks == TickKind::Powers && self.has_powers();
        let steps =
            steps.filter(|step| !is_whole || step.round() >= 1.0 && (step - step.round()).abs() < 1e-6);
        let marked = steps.map(|step| self.every(step)).filter(|ticks| ticks.len() <= 7);
        let mut marked: Vec<Vec<Tick>> = marked.collect();
        marked.sort_by_key(|ticks| std::cmp::Reverse(ticks.len().min(4)));
        let chosen = marked.iter().position(|ticks| fits(ticks));
        chosen.map_or_else(Vec::new, |index| marked.swap_remove(index))
    }

    fn every(&self, step: f64) -> Vec<Tick> {
        let first = (self.low / step).ceil();
        let ticks = (0..12).map(|i| (first + f64::from(i)) * step).take_while(|tick| *tick <= self.high);
        let (offset, scale) = (self.offset(), 10_f64.powi(-self.power()));
        // The number of decimals of the step, such as 1 for 0.2. A second one, as for 0.25, is
        // added below. The factor 1.001 allows for rounding errors of a step such as 0.1.
        let size = (-libm::log10(step * scale * 1.001).floor()).max(0.0) as usize;
        let is_whole = |decimals: usize| {
            let digits = step * scale * 10_f64.powi(decimals as i32);
            (digits - digits.round()).abs() < 1e-6 * digits
        };
        let decimals = if is_whole(size) { size } else { size + 1 };
        let round = |value: f64| if value.abs() < step / 2.0 { 0.0 } else { value };
        let text = |value: f64| match self.marks {
            TickKind::Powers if self.has_powers() => format!("10{}", superscript(value.round() as i32)),
            _ => decimal(round(value - offset) * scale, decimals),
        };
        ticks.map(round).map(|value| Tick { value, text: text(value) }).collect()
    }

    /// Returns the position of a value, where `low` is at `from` and `high` at `to`.
    #[must_use]
    pub fn place(&self, value: f64, from: f64, to: f64) -> f64 {
        from + (value - self.low) / (self.high - self.low) * (to - from)
    }

    /// Returns whether a value lies on the axis.
    #[must_use]
    pub fn shows(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// Writes a number with a typographic minus sign.
#[must_use]
pub fn decimal(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}").replace('-', "−")
}

/// Writes a number with at most fourteen significant digits.
fn number(value: f64) -> String {
    let digits = format!("{value:.13e}");
    let (digits, power) = digits.split_once('e').expect("digits and a power");
    let power: i32 = power.parse().expect("a whole number");
    let rounded: f64 = format!("{digits}e{power}").parse().expect("a number");
    if (-3..9).contains(&power) {
        return rounded.to_string();
    }
    format!("{}×10{}", digits.trim_end_matches('0').trim_end_matches('.'), superscript(power))
}

#[cfg(test)]
mod tests {
    use super::{NumberLine, TickKind, decimal};
    use kahan_algebra::prime_field::SplitMix64;

    fn line(low: f64, high: f64) -> NumberLine {
        NumberLine::new("x", low, high)
    }

    #[test]
    fn numbers_are_rounded_with_a_minus_sign() {
        assert_eq!(decimal(-1.005, 1), "−1.0");
    }

    #[test]
    fn four_to_seven_ticks_are_round_and_lie_on_the_axis() {
        let mut random = SplitMix64::new(3);
        let mut part = || random.below(1 << 20) as f64 / f64::from(1 << 20);
        let drawn = (0..3000).map(|i| {
            let (low, length) = (2.0 * part() - 1.0, 10_f64.powf(-1.5 * part()));
            let scale = 10_f64.powi(i % 40 - 20);
            (low * scale, (low + length) * scale)
        });
        let known = [(0.0, 1.0), (-3.2, 7.9), (0.0, 812_345.0), (1.59, 1.64), (-1e-9, 1e-9), (-3e17, 1e16)];
        for (low, high) in drawn.collect::<Vec<_>>().into_iter().chain(known) {
            let line = line(low, high);
            let ticks = line.ticks(|_| true);
            assert!((4..=7).contains(&ticks.len()), "{low}..{high}: {ticks:?}");
            assert!(ticks.iter().all(|tick| line.shows(tick.value)), "{low}..{high}: {ticks:?}");
            assert!(ticks.iter().all(|tick| tick.text.chars().count() <= 8), "{low}..{high}: {ticks:?}");
            let labels: std::collections::BTreeSet<&str> = ticks.iter().map(|tick| &*tick.text).collect();
            assert_eq!(labels.len(), ticks.len(), "the labels differ: {labels:?}");
            let scale = 10_f64.powi(-line.power());
            for tick in &ticks {
                let read: f64 = tick.text.replace('−', "-").parse().expect("a number");
                let error = (read - tick.value * scale).abs();
                assert!(error < 1e-9 * (high - low) * scale, "{low}..{high}: {tick:?}");
            }
        }
    }

    #[test]
    fn where_there_is_little_room_there_are_fewer_ticks() {
        for most in 1..=7 {
            let ticks = line(0.1, 9.9).ticks(|ticks| ticks.len() <= most);
            assert!((1..=most).contains(&ticks.len()), "{most}: {ticks:?}");
        }
        assert_eq!(line(0.1, 9.9).ticks(|_| false), []);
    }

    #[test]
    fn the_power_that_is_taken_out_stands_in_the_name() {
        let small = line(-2e-9, 2e-9);
        assert_eq!(small.name(), "x / 10⁻⁹");
        let ticks = small.ticks(|_| true);
        assert!(ticks.iter().any(|tick| tick.text == "−1"), "{ticks:?}");
        assert_eq!(line(0.0, 10.0).name(), "x");
    }

    #[test]
    fn what_values_share_stands_in_the_name() {
        let texts =
            |line: &NumberLine| line.ticks(|_| true).into_iter().map(|tick| tick.text).collect::<Vec<_>>();
        let far = line(1_000_000.000_2, 1_000_000.001_8);
        assert_eq!(
            (far.name(), texts(&far)),
            (
                "(x − 1000000.001) / 10⁻⁴".into(),
                ["−7.5", "−5.0", "−2.5", "0.0", "2.5", "5.0", "7.5"].map(str::to_owned).into()
            )
        );
        let near = line(-2.531_915, -2.531_909);
        assert_eq!(near.name(), "(x + 2.531912) / 10⁻⁶");
        assert!(texts(&near).contains(&"−2".to_owned()), "{:?}", texts(&near));
        assert_eq!(line(2.0, 2.1).name(), "x");
    }

    #[test]
    fn what_is_counted_has_whole_ticks_and_logarithms_are_powers_of_ten() {
        let texts = |marks, low, high| {
            let line = NumberLine { marks, ..line(low, high) };
            (
                line.name(),
                line.ticks(|_| true).into_iter().map(|tick| tick.text).collect::<Vec<_>>().join(" "),
            )
        };
        assert_eq!(texts(TickKind::Whole, 0.6, 4.4), ("x".into(), "1 2 3 4".into()));
        assert_eq!(texts(TickKind::Powers, -8.5, -1.5), ("x".into(), "10⁻⁸ 10⁻⁶ 10⁻⁴ 10⁻²".into()));
        assert_eq!(
            texts(TickKind::Powers, -8.5, -7.9),
            ("log₁₀ of x".into(), "−8.5 −8.4 −8.3 −8.2 −8.1 −8.0 −7.9".into())
        );
    }

    #[test]
    fn an_axis_around_one_value_or_none_still_has_a_length() {
        for values in [vec![], vec![2.0], vec![1e300], vec![f64::NAN, 2.0, f64::INFINITY]] {
            let line = NumberLine::around("", values.clone().into_iter());
            assert!(line.high > line.low, "{line:?}");
            let line = NumberLine::around_most("", values.into_iter());
            assert!(line.high > line.low, "{line:?}");
        }
    }

    #[test]
    fn a_few_values_far_away_do_not_make_the_rest_a_dot() {
        let usual = (0..1000).map(|i| f64::from(i) / 1000.0);
        let line = NumberLine::around_most("", usual.clone().chain([1e9, -1e12]));
        assert!(line.low > -2.0 && line.high < 3.0 && line.shows(0.0) && line.shows(0.999), "{line:?}");
        let (most, all) = (NumberLine::around_most("", usual.clone()), NumberLine::around("", usual));
        assert_eq!((most.low, most.high), (all.low, all.high));
    }
}
