//! First points of orbits: as they are given, in files, along a line, or drawn at random.

use std::fmt;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_study::Study;

use crate::printing::{Refusal, joined};
use crate::reading::{is_number_file, point, points};

/// What an `--at` gives.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum At {
    /// A point.
    Point(Vec<Rational>),
    /// The ends of a line.
    Line(Vec<Rational>, Vec<Rational>),
}

/// How many first points each `--at` stands for, and where points around it lie.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Spread {
    /// `None` for the point itself.
    pub(crate) count: Option<usize>,
    pub(crate) radius: Rational,
    pub(crate) seed: u64,
}

impl Default for Spread {
    fn default() -> Self {
        Spread { count: None, radius: Rational::new(1, 10), seed: 1 }
    }
}

impl At {
    /// Reads one; a file has a point in each row.
    pub(super) fn read(at: &str, spread: &Spread, study: &Study) -> Result<Vec<Self>, Refusal> {
        // The path of a file may have dots of its own.
        match at.split_once("..").filter(|_| !is_number_file(at)) {
            Some(_) if spread.count.is_none() => Err(Refusal::new(format!(
                "--at {at} is a line; say by --starts how many first points it has"
            ))),
            Some((from, to)) => Ok(vec![At::Line(point(Some(from), study)?, point(Some(to), study)?)]),
            None => Ok(points(Some(at), study)?.into_iter().map(At::Point).collect()),
        }
    }
}

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            At::Point(point) => f.write_str(&joined(point, ",")),
            At::Line(from, to) => write!(f, "{}..{}", joined(from, ","), joined(to, ",")),
        }
    }
}

impl Spread {
    /// The first points that these stand for, in their order.
    pub(super) fn starts(&self, at: &[At]) -> Vec<Vec<Rational>> {
        let mut random = SplitMix64::new(self.seed);
        let starts = at.iter().flat_map(|at| match (at, self.count) {
            (At::Point(point), None) => vec![point.clone()],
            (At::Point(middle), Some(count)) => self.around(middle, count, &mut random),
            (At::Line(from, to), count) => along(from, to, count.unwrap_or(1)),
        });
        starts.collect()
    }

    /// At random in the cube around a point.
    fn around(&self, middle: &[Rational], count: usize, random: &mut SplitMix64) -> Vec<Vec<Rational>> {
        /// Parts of the radius, so that the fractions stay short.
        const PARTS: i64 = 1 << 20;

        let part = self.radius.checked_div(&Rational::from(PARTS)).expect("there are parts");
        let mut near = |value: &Rational| {
            let drawn = random.below(2 * PARTS as u64 + 1) as i64 - PARTS;
            value + &(&part * &Rational::from(drawn))
        };
        (0..count).map(|_| middle.iter().map(&mut near).collect()).collect()
    }
}

/// Evenly on the line between two points, both of them among these; one start is the first.
fn along(from: &[Rational], to: &[Rational], count: usize) -> Vec<Vec<Rational>> {
    let parts = Rational::from(count.saturating_sub(1).max(1) as i64);
    let start = |i: usize| {
        let part = Rational::from(i as i64).checked_div(&parts).expect("there is a part");
        from.iter().zip(to).map(|(a, b)| a + &(&part * &(b - a))).collect()
    };
    (0..count).map(start).collect()
}
