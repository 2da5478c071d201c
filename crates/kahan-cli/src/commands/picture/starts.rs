//! First points of orbits: as they are given, in files, along a line, or drawn at random.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;

use super::Subject;
use crate::printing::Refusal;
use crate::reading::{is_number_file, number, point, points};

impl Subject<'_> {
    /// The first points, in the order of `--at`.
    pub(super) fn starts(&self) -> Result<Vec<Vec<Rational>>, Refusal> {
        let mut random = SplitMix64::new(self.asked.seed);
        let mut starts = Vec::new();
        for at in &self.asked.at {
            // The path of a file may have dots of its own.
            let line = at.split_once("..").filter(|_| !is_number_file(at));
            match (line, self.asked.starts) {
                (Some((from, to)), Some(count)) => starts.extend(self.along(from, to, count)?),
                (Some(_), None) => {
                    return Err(Refusal::new(format!(
                        "--at {at} is a line; say by --starts how many first points it has"
                    )));
                }
                (None, Some(count)) => {
                    for middle in points(at, self.variables())? {
                        starts.extend(self.around(&middle, count, &mut random)?);
                    }
                }
                (None, None) => starts.extend(points(at, self.variables())?),
            }
        }
        Ok(starts)
    }

    pub(super) fn point(&self, at: &str) -> Result<Vec<Rational>, Refusal> {
        point(at, self.variables())
    }

    /// Evenly on the line between two points, both of them among these; one start is the first.
    fn along(&self, from: &str, to: &str, count: usize) -> Result<Vec<Vec<Rational>>, Refusal> {
        let (from, to) = (self.point(from)?, self.point(to)?);
        let parts = Rational::from(count.saturating_sub(1).max(1) as i64);
        let start = |i: usize| {
            let part = Rational::from(i as i64).checked_div(&parts).expect("there is a part");
            from.iter().zip(&to).map(|(a, b)| a + &(&part * &(b - a))).collect()
        };
        Ok((0..count).map(start).collect())
    }

    /// At random in the cube around a point.
    fn around(
        &self,
        middle: &[Rational],
        count: usize,
        random: &mut SplitMix64,
    ) -> Result<Vec<Vec<Rational>>, Refusal> {
        /// Parts of the radius, so that the fractions stay short.
        const PARTS: i64 = 1 << 20;

        let radius = number(&self.asked.radius, "--radius")?;
        let part = radius.checked_div(&Rational::from(PARTS)).expect("there are parts");
        let mut near = |value: &Rational| {
            let drawn = random.below(2 * PARTS as u64 + 1) as i64 - PARTS;
            value + &(&part * &Rational::from(drawn))
        };
        Ok((0..count).map(|_| middle.iter().map(&mut near).collect()).collect())
    }
}

/// Rounded for orbits of doubles.
pub(super) fn rounded(start: &[Rational]) -> Vec<f64> {
    start.iter().map(Rational::to_f64).collect()
}
