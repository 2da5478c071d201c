//! First points of orbits: single points, files, points along a line, or random points.

use std::fmt;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_study::Study;

use crate::printing::{UsageError, joined};
use crate::reading::{is_number_file, point, points};

/// The value of one `--at`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum StartSpec {
    Point(Vec<Rational>),
    /// The two ends of a line.
    Line(Vec<Rational>, Vec<Rational>),
}

/// The number and the distribution of the initial points that each `--at` gives.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StartSpread {
    /// The number of points. `None` means that each `--at` is one point.
    pub(crate) count: Option<usize>,
    pub(crate) radius: Rational,
    pub(crate) seed: u64,
}

impl Default for StartSpread {
    fn default() -> Self {
        StartSpread { count: None, radius: Rational::new(1, 10), seed: 1 }
    }
}

impl StartSpec {
    /// Reads the value of an `--at`. A file gives a point for each of its rows.
    pub(super) fn read(at: &str, spread: &StartSpread, study: &Study) -> Result<Vec<Self>, UsageError> {
        // A file is recognised first, because its path may contain `..`.
        match at.split_once("..").filter(|_| !is_number_file(at)) {
            Some(_) if spread.count.is_none() => Err(UsageError::new(format!(
                "--at {at} is a line; say by --starts how many first points it has"
            ))),
            Some((from, to)) => Ok(vec![StartSpec::Line(point(Some(from), study)?, point(Some(to), study)?)]),
            None => Ok(points(Some(at), study)?.into_iter().map(StartSpec::Point).collect()),
        }
    }
}

impl fmt::Display for StartSpec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StartSpec::Point(point) => f.write_str(&joined(point, ",")),
            StartSpec::Line(from, to) => write!(f, "{}..{}", joined(from, ","), joined(to, ",")),
        }
    }
}

impl StartSpread {
    /// Returns all initial points, in the order of `at`.
    pub(super) fn starts(&self, at: &[StartSpec]) -> Vec<Vec<Rational>> {
        let mut random = SplitMix64::new(self.seed);
        let starts = at.iter().flat_map(|at| match (at, self.count) {
            (StartSpec::Point(point), None) => vec![point.clone()],
            (StartSpec::Point(middle), Some(count)) => self.around(middle, count, &mut random),
            (StartSpec::Line(from, to), count) => points_on_line(from, to, count.unwrap_or(1)),
        });
        starts.collect()
    }

    /// Draws random points in a cube around a point.
    fn around(&self, middle: &[Rational], count: usize, random: &mut SplitMix64) -> Vec<Vec<Rational>> {
        /// Random coordinates are multiples of the radius divided by this number.
        const COORDINATE_DENOMINATOR: i64 = 1 << 20;

        let part = self.radius.checked_div(&Rational::from(COORDINATE_DENOMINATOR)).expect("there are parts");
        let mut near = |value: &Rational| {
            let drawn = random.below(2 * COORDINATE_DENOMINATOR as u64 + 1) as i64 - COORDINATE_DENOMINATOR;
            value + &(&part * &Rational::from(drawn))
        };
        (0..count).map(|_| middle.iter().map(&mut near).collect()).collect()
    }
}

/// Returns equidistant points from one end of a line to the other.
fn points_on_line(from: &[Rational], to: &[Rational], count: usize) -> Vec<Vec<Rational>> {
    let parts = Rational::from(count.saturating_sub(1).max(1) as i64);
    let start = |i: usize| {
        let part = Rational::from(i as i64).checked_div(&parts).expect("there is a part");
        from.iter().zip(to).map(|(a, b)| a + &(&part * &(b - a))).collect()
    };
    (0..count).map(start).collect()
}
