//! Ranges of values: `eps=1/10:1:400`.

use kahan_algebra::rational::Rational;

use super::values::{number, whole};
use crate::printing::Refusal;

/// The values that a parameter, ε or a coordinate goes through.
#[derive(Debug)]
pub(crate) struct Range<'a> {
    pub(crate) name: &'a str,
    pub(crate) from: Rational,
    pub(crate) to: Rational,
    pub(crate) steps: usize,
}

impl<'a> Range<'a> {
    /// NAME=FROM:TO:STEPS.
    pub(crate) fn read(text: &'a str) -> Result<Self, Refusal> {
        let wrong = |why: &str| {
            Refusal::new(format!("--over: `{text}` is not NAME=FROM:TO:STEPS, as in eps=1/10:1:400{why}"))
        };
        let (name, range) = text.split_once('=').ok_or_else(|| wrong(""))?;
        let [from, to, steps] = range.split(':').collect::<Vec<_>>()[..] else { return Err(wrong("")) };
        let steps = whole(steps, 1, 100_000).map_err(|why| wrong(&format!("; STEPS: {why}")))?;
        let (from, to) = (number(from, "--over")?, number(to, "--over")?);
        if from == to {
            return Err(wrong("; FROM and TO differ"));
        }
        Ok(Range { name: name.trim(), from, to, steps })
    }

    /// Steps with these values in their middles; `None` where they are not equally spaced, or fewer
    /// than two.
    pub(crate) fn around(name: &'a str, values: &[f64]) -> Option<Self> {
        let mut found = values.to_vec();
        found.sort_unstable_by(f64::total_cmp);
        found.dedup();
        // The shortest decimals that mean these numbers are those that they were written with.
        let exactly = |value: &f64| Rational::typed(&format!("{value:?}"));
        let (first, last) = (exactly(found.first()?)?, exactly(found.last()?)?);
        let steps = found.len();
        let width = (&last - &first).checked_div(&Rational::from(steps as i64 - 1))?;
        let half = width.checked_div(&Rational::from(2))?;
        let range = Range { name, from: &first - &half, to: &last + &half, steps };
        // A thousandth of a step is far more than what roundings move a value by.
        let is_near =
            |(value, middle): (&f64, Rational)| (value - middle.to_f64()).abs() < 1e-3 * width.to_f64();
        let is_spaced = found.iter().zip(range.middles()).all(is_near);
        is_spaced.then_some(range)
    }

    /// The step that a value lies in.
    pub(crate) fn place(&self, value: f64) -> Option<usize> {
        let (from, to) = (self.from.to_f64(), self.to.to_f64());
        let place = (value - from) / (to - from) * self.steps as f64;
        // The last step has its end.
        let place = if value == to { place - 0.5 } else { place.floor() };
        (place >= 0.0 && place < self.steps as f64).then_some(place as usize)
    }

    /// The value after so many steps.
    pub(crate) fn value(&self, index: usize) -> Rational {
        self.part(2 * index as i64)
    }

    /// The values in the middle of each step.
    pub(crate) fn middles(&self) -> impl Iterator<Item = Rational> {
        (0..self.steps).map(|index| self.part(2 * index as i64 + 1))
    }

    /// The value after so many half steps.
    fn part(&self, half_steps: i64) -> Rational {
        let steps = Rational::from(2 * self.steps as i64);
        let part = Rational::from(half_steps).checked_div(&steps).expect("there is a step");
        &self.from + &(&part * &(&self.to - &self.from))
    }
}

#[cfg(test)]
mod tests {
    use super::Range;

    #[test]
    fn steps_around_values_have_them_in_their_middles() {
        let values = [0.3, 0.1, 0.2, 0.1, 0.4];
        let range = Range::around("x", &values).expect("equally spaced");
        assert_eq!(
            (range.from.to_string(), range.to.to_string(), range.steps),
            ("1/20".into(), "9/20".into(), 4)
        );
        assert_eq!(values.map(|value| range.place(value)), [Some(2), Some(0), Some(1), Some(0), Some(3)]);
        assert_eq!([0.04, 0.05, 0.45, 0.46].map(|value| range.place(value)), [None, Some(0), Some(3), None]);
        for values in [&[0.1, 0.2, 0.4][..], &[0.1], &[], &[0.1, f64::INFINITY]] {
            assert!(Range::around("x", values).is_none(), "{values:?}");
        }
    }

    #[test]
    fn steps_may_go_downwards() {
        let range = Range::read("x=1:0:4").expect("a range");
        assert_eq!(
            [1.0, 0.8, 0.1, 0.0, -0.1].map(|value| range.place(value)),
            [Some(0), Some(0), Some(3), Some(3), None]
        );
    }
}
