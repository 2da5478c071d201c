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
        let part = Rational::from(half_steps).checked_div(&steps).unwrap_or_default();
        &self.from + &(&part * &(&self.to - &self.from))
    }
}
