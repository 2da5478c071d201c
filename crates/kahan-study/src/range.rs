//! Ranges of exact values, in one grammar for all questions: `1/10:1:400`.
//!
//! A range is written as text that reads back as an equal range.

use std::fmt;

use kahan_algebra::rational::Rational;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::numbers::{number, whole};

/// A parameter, a variable or `eps`, with the values on its axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// The name of the parameter or variable, or `eps`.
    pub name: String,
    /// The values.
    pub range: Range,
}

/// Two or more values, ascending or descending.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Range {
    from: Rational,
    to: Rational,
    spacing: Spacing,
}

/// The reason why a text is not a range, as a sentence that also gives a correction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoRange(String);

impl fmt::Display for NoRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for NoRange {}

/// The rule for the values between the two ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// `FROM:TO:COUNT`: the number of values, both ends included.
    Count(usize),
    /// `FROM:TO:+STEP`: FROM, FROM + STEP, …, up to TO.
    Step(Rational),
    /// `FROM:TO:/CELLS`: the midpoints of this number of cells.
    Cells(usize),
}

/// The most values of a range read by [`Range::read`].
const MAX_VALUES: usize = 100_000;
/// The largest number of values on an axis of a table: 2⁴⁰ − 1 with 64-bit indices.
const MAX_TABLE_VALUES: usize = usize::MAX >> (usize::BITS / 2 - 8);

impl Range {
    /// Reads `FROM:TO:COUNT`, `FROM:TO:+STEP` or `FROM:TO:/CELLS`, or describes the mistake.
    pub fn read(text: &str) -> Result<Self, NoRange> {
        Self::up_to(MAX_VALUES, text)
    }

    /// Reads a range for an axis of a table, of fewer than 2⁴⁰ values.
    pub fn of_table(text: &str) -> Result<Self, NoRange> {
        Self::up_to(MAX_TABLE_VALUES, text)
    }

    fn up_to(most: usize, text: &str) -> Result<Self, NoRange> {
        let [from, to, third] = text.split(':').map(str::trim).collect::<Vec<_>>()[..] else {
            return Err(NoRange(format!(
                "`{text}` is no range; write FROM:TO:COUNT for so many values with both ends, FROM:TO:+STEP for steps \
                 from FROM, or FROM:TO:/CELLS for the middles of cells, as in 0:1:11, 0:1:+1/10 or 0:1:/10"
            )));
        };
        let refused = |why: String| NoRange(format!("`{text}`: {why}"));
        let count = |text: &str| whole(text, 2, most);
        let spacing = match (third.strip_prefix('+'), third.strip_prefix('/')) {
            (Some(step), _) => Spacing::Step(number(step).map_err(NoRange)?),
            (_, Some(cells)) => Spacing::Cells(count(cells).map_err(|why| refused(format!("CELLS: {why}")))?),
            _ => Spacing::Count(count(third).map_err(|why| {
                let step =
                    number(third).map(|_| format!("; for steps of {third} write {from}:{to}:+{third}"));
                refused(format!("COUNT: {why}{}", step.unwrap_or_default()))
            })?),
        };
        let [from, to] = [from, to].map(|end| number(end).map_err(NoRange));
        let range = Range { from: from?, to: to?, spacing };
        range.check(most as u64).map_err(refused)?;
        Ok(range)
    }

    /// Returns the rule for the values between the ends.
    #[must_use]
    pub fn spacing(&self) -> &Spacing {
        &self.spacing
    }

    /// Returns the range whose cells have `values` as midpoints, if these are equally spaced.
    #[must_use]
    pub fn around(values: &[f64]) -> Option<Self> {
        let mut found = values.to_vec();
        found.sort_unstable_by(f64::total_cmp);
        found.dedup();
        // Convert each float by its shortest decimal, because files contain that decimal.
        let exactly = |value: &f64| Rational::parse(&format!("{value:?}"));
        let (from, to) = (exactly(found.first()?)?, exactly(found.last()?)?);
        let range = Range { from, to, spacing: Spacing::Count(found.len()) };
        range.check(MAX_TABLE_VALUES as u64).ok()?;
        // Values may deviate by a thousandth of their spacing, which far exceeds rounding errors.
        let near = 1e-3 * range.step().to_f64();
        let is_near = |(found, value): (&f64, Rational)| (found - value.to_f64()).abs() < near;
        let is_spaced = found.iter().zip(range.values()).all(is_near);
        is_spaced.then_some(range)
    }

    /// Checks the range, which may have at most `most` values. An error says how to correct it.
    fn check(&self, most: u64) -> Result<(), String> {
        let Range { from, to, .. } = self;
        let way = to - from;
        let part = |parts: i64| way.checked_div(&Rational::from(parts)).expect("there are parts");
        Err(match &self.spacing {
            _ if way.is_zero() => format!(
                "FROM and TO are both {from}, and a range has two ends, as {from}:{}:+1/10 has",
                from + &Rational::one()
            ),
            Spacing::Step(step) if step.is_zero() || step.is_negative() != way.is_negative() => format!(
                "a step of {step} does not lead from {from} to {to}; write one that does, as {from}:{to}:+{}",
                part(10)
            ),
            Spacing::Step(step) => match way.checked_div(step) {
                Some(steps) if steps < Rational::one() => format!(
                    "the first step of {step} passes {to}, and one value is no range; write a smaller one, as {from}:{to}:+{}",
                    part(10)
                ),
                Some(steps) if steps >= Rational::from(most as i64) => format!(
                    "steps of {step} make more than {most} values; write larger ones, as {from}:{to}:+{}",
                    part(100)
                ),
                _ => return Ok(()),
            },
            Spacing::Count(count) | Spacing::Cells(count) if !(2..=most).contains(&(*count as u64)) => {
                format!("{count} values are no range; it has 2 or more, up to {most}")
            }
            Spacing::Count(_) | Spacing::Cells(_) => return Ok(()),
        })
    }

    /// Returns the number of values.
    #[must_use]
    pub fn count(&self) -> usize {
        match &self.spacing {
            Spacing::Count(count) | Spacing::Cells(count) => *count,
            Spacing::Step(step) => {
                let steps = (&self.to - &self.from).checked_div(step).expect("a range has steps");
                // `to_f64` may round `steps` up to a whole number, but no further.
                let near = steps.to_f64() as usize;
                if Rational::from(near as i64) > steps { near } else { near + 1 }
            }
        }
    }

    /// Returns the distance from each value to the next; negative in a descending range.
    #[must_use]
    pub fn step(&self) -> Rational {
        let parts = match &self.spacing {
            Spacing::Count(count) => count - 1,
            Spacing::Cells(count) => *count,
            Spacing::Step(step) => return step.clone(),
        };
        (&self.to - &self.from).checked_div(&Rational::from(parts as i64)).expect("a range has parts")
    }

    /// Returns the value at `index`, counted from 0.
    #[must_use]
    pub fn value(&self, index: usize) -> Rational {
        let step = self.step();
        let first = match self.spacing {
            Spacing::Cells(_) => &self.from + &half(&step),
            Spacing::Count(_) | Spacing::Step(_) => self.from.clone(),
        };
        &first + &(&step * &Rational::from(index as i64))
    }

    /// Iterates over all values, from FROM to TO.
    pub fn values(&self) -> impl Iterator<Item = Rational> {
        (0..self.count()).map(|index| self.value(index))
    }

    /// Returns the first and the last value.
    #[must_use]
    pub fn ends(&self) -> [Rational; 2] {
        [0, self.count() - 1].map(|index| self.value(index))
    }

    /// Returns the start of the first cell and the end of the last cell. Each value is the midpoint
    /// of a cell.
    #[must_use]
    pub fn edges(&self) -> [Rational; 2] {
        let ([first, last], half) = (self.ends(), half(&self.step()));
        [&first - &half, &last + &half]
    }

    /// Returns the index of the cell that contains `value`.
    #[must_use]
    pub fn place(&self, value: f64) -> Option<usize> {
        let ([from, to], cells) = (self.edges().map(|edge| edge.to_f64()), self.count() as f64);
        let place = (value - from) / (to - from) * cells;
        // The last cell includes its end.
        let place = if value == to { place - 0.5 } else { place.floor() };
        (place >= 0.0 && place < cells).then_some(place as usize)
    }
}

fn half(step: &Rational) -> Rational {
    step.checked_div(&Rational::from(2)).expect("2 is not 0")
}

/// Writes the range in the grammar of [`Range::read`].
impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Range { from, to, .. } = self;
        match &self.spacing {
            Spacing::Count(count) => write!(f, "{from}:{to}:{count}"),
            Spacing::Step(step) => write!(f, "{from}:{to}:+{step}"),
            Spacing::Cells(cells) => write!(f, "{from}:{to}:/{cells}"),
        }
    }
}

impl Serialize for Range {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Range {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Range::read(&String::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use kahan_algebra::prime_field::SplitMix64;
    use kahan_algebra::rational::Rational;

    use super::{MAX_VALUES, Range, Spacing};

    fn read(text: &str) -> Result<Range, String> {
        Range::read(text).map_err(|why| why.to_string())
    }

    fn values(text: &str) -> Vec<String> {
        read(text).expect(text).values().map(|value| value.to_string()).collect()
    }

    #[test]
    fn the_third_part_says_which_values_are_meant() {
        assert_eq!(values("0:1:3"), ["0", "1/2", "1"]);
        assert_eq!(values("0:1:/2"), ["1/4", "3/4"]);
        assert_eq!(values("0:1:+1/3"), ["0", "1/3", "2/3", "1"]);
        assert_eq!(values("0:1:+0.4"), ["0", "2/5", "4/5"]);
        assert_eq!(values(" 1 : -1 : 1e1 ").len(), 10);
        assert_eq!(values("1:-1:+-1"), ["1", "0", "-1"]);
        assert_eq!(values("1:0:/2"), ["3/4", "1/4"]);
        // The value 3 exceeds the end, although the end rounds to the double 3.
        assert_eq!(values("0:2.9999999999999999999999:+1").len(), 3);
    }

    #[test]
    fn a_range_reads_back_from_its_text() {
        let mut random = SplitMix64::new(5);
        let mut read_back = 0;
        while read_back < 300 {
            let mut drawn = |numbers: u64| Rational::from(random.below(numbers) as i64);
            let (below, over) = (&drawn(30) + &Rational::one(), &drawn(30) + &Rational::one());
            let [from, to] = [&drawn(99), &drawn(99)]
                .map(|above| (above - &Rational::from(50)).checked_div(&below).expect("not 0"));
            let step = (&to - &from).checked_div(&over).expect("not 0");
            for spacing in [Spacing::Count(7), Spacing::Cells(7), Spacing::Step(step)] {
                let range = Range { from: from.clone(), to: to.clone(), spacing };
                let text = format!("{range}");
                assert_eq!(
                    read(&text).ok(),
                    range.check(MAX_VALUES as u64).ok().map(|()| range.clone()),
                    "{text}"
                );
                read_back += usize::from(range.check(MAX_VALUES as u64).is_ok());
            }
        }
    }

    #[test]
    fn what_is_no_range_is_told_what_to_write() {
        for (text, part) in [
            ("0:1", "0:1:11, 0:1:+1/10 or 0:1:/10"),
            ("0:1:2:3", "is no range"),
            (
                "0:1:1",
                "COUNT: write a whole number, 2 or more, such as 1000 or 1e3; for steps of 1 write 0:1:+1",
            ),
            ("0:1:/1", "CELLS: write a whole number, 2 or more"),
            ("1:1:5", "two ends, as 1:2:+1/10"),
            ("0:1:1/12", "for steps of 1/12 write 0:1:+1/12"),
            ("0:1:many", "whole number"),
            ("0:1:+0", "as 0:1:+1/10"),
            ("0:1:+-1/2", "does not lead from 0 to 1"),
            ("1:0:+1/2", "as 1:0:+-1/10"),
            ("0:1:+2", "passes 1"),
            ("0:1:+1e-5", "as 0:1:+1/100"),
            ("0:1:100001", "the most is 100000"),
            ("0:1:/1e6", "the most is 100000"),
            ("a:1:5", "not an exact number"),
        ] {
            let why = read(text).expect_err(text);
            assert!(why.contains(part), "{text}: {why}");
        }
        assert_eq!(values("0:1:+1/99999").len(), 100_000);
    }

    #[test]
    fn cells_around_values_have_them_in_their_middles() {
        let values = [0.3, 0.1, 0.2, 0.1, 0.4];
        let range = Range::around(&values).expect("equally spaced");
        let [from, to] = range.edges().map(|edge| edge.to_string());
        assert_eq!((&*from, &*to, range.count()), ("1/20", "9/20", 4));
        assert_eq!(values.map(|value| range.place(value)), [Some(2), Some(0), Some(1), Some(0), Some(3)]);
        assert_eq!([0.04, 0.05, 0.45, 0.46].map(|value| range.place(value)), [None, Some(0), Some(3), None]);
        for values in [&[0.1, 0.2, 0.4][..], &[0.1], &[], &[0.1, f64::INFINITY]] {
            assert!(Range::around(values).is_none(), "{values:?}");
        }
        let edges = |text: &str| read(text).expect(text).edges().map(|edge| edge.to_string());
        assert_eq!(edges("0:1:/4"), ["0", "1"]);
        assert_eq!(edges("0:1:+2/5"), ["-1/5", "1"]);
    }

    #[test]
    fn cells_may_go_downwards() {
        let range = read("1:0:/4").expect("a range");
        assert_eq!(
            [1.0, 0.8, 0.1, 0.0, -0.1].map(|value| range.place(value)),
            [Some(0), Some(0), Some(3), Some(3), None]
        );
    }
}
