//! The first method: the solution of the flow as a Taylor series in time, continued from point to point.
//!
//! In: a field over double-double numbers, a point, a time. Out: a polynomial for each stretch of time, and the sizes that errors and
//! steps are compared with.

use std::time::Instant;

use kahan_core::nalgebra::SVector;
use kahan_core::{Dd, KahanMap};

use super::dense::{MOST_PIECES, Piece, piece_at};
use super::refusal::NoReference;
use super::taylor::Expansion;

/// How far beyond its end a trajectory is followed, and how long that may take.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// The part of [`Trajectory::end`](super::Trajectory::end) by which orbits that do not end there exactly may go further.
    /// Where the solution escapes to infinity first, nothing is added.
    pub margin: f64,
    /// When to give up.
    pub deadline: Option<Instant>,
}

impl Limits {
    pub(super) fn is_over(&self) -> bool {
        self.deadline.is_some_and(|deadline| Instant::now() > deadline)
    }
}

/// x(t) piece by piece; the sizes are those up to the time that was asked for.
#[derive(Clone, Debug)]
pub(super) struct Path {
    pieces: Vec<Piece>,
    pub(super) end: f64,
    pub(super) scale: f64,
    pub(super) slope: f64,
    pub(super) turning: f64,
}

impl Path {
    /// Follows the flow from `start` to the time `end`, and beyond by the margin.
    pub(super) fn of<M, const N: usize>(
        map: &M,
        start: SVector<Dd, N>,
        end: f64,
        limits: &Limits,
    ) -> Result<Self, NoReference>
    where
        M: KahanMap<Dd, N>,
    {
        let expansion = Expansion::of(map);
        let size =
            |x: &SVector<Dd, N>, size| x.iter().map(|entry| f64::from(entry.abs())).fold(size, f64::max);
        let last = end * (1.0 + limits.margin);
        let mut path = Path { pieces: Vec::new(), end: last, scale: 0.0, slope: 0.0, turning: 0.0 };
        let (mut t, mut x) = (Dd::from(0.0), start);
        let (mut rate, mut first) = (norm(map, &start), None);
        loop {
            let (now, slope) = (f64::from(t), norm(map, &x));
            let series = expansion.at(x, rate);
            rate = 1.0 / series.radius;
            path.pieces.push(series.piece(t));
            // A double, so that the sum of the steps in double-double is exact for long.
            let step = series.reach().min(2.0 * last);
            // Before a pole each step is a part of the way that is left.
            if !(x.iter().all(|entry| entry.is_finite()) && step > 1e-9 * (now + *first.get_or_insert(step)))
            {
                if now >= end {
                    path.end = end;
                    break;
                }
                return Err(NoReference::Escapes {
                    time: now + if step > 0.0 { series.radius } else { 0.0 },
                });
            }
            if now <= end {
                path.scale = size(&x, path.scale);
                path.slope = path.slope.max(slope);
                path.turning += series.turning * step.min(end - now);
            }
            if now <= end && now + step >= end {
                path.scale = size(&series.value(Dd::from(end) - t), path.scale);
            }
            if now + step >= last {
                break;
            }
            if path.pieces.len() == MOST_PIECES {
                return Err(NoReference::TooLong { reached: now });
            }
            if limits.is_over() {
                return Err(NoReference::NoTime { reached: now });
            }
            x = series.value(Dd::from(step));
            t += Dd::from(step);
        }
        if path.scale == 0.0 {
            // A solution that rests in the origin has errors, and no size.
            path.scale = 1.0;
        }
        Ok(path)
    }

    pub(super) fn at(&self, t: Dd) -> Vec<Dd> {
        piece_at(&self.pieces, t).value(t)
    }

    /// The distance of a point from x(t) in the maximum norm, relative to the scale; what is not a number is infinitely far.
    pub(super) fn distance(&self, t: Dd, x: &[Dd]) -> f64 {
        let differences =
            self.at(t).into_iter().zip(x).map(|(exact, entry)| f64::from((*entry - exact).abs()));
        worst(differences) / self.scale
    }
}

/// The largest; infinite if one is no number.
fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |worst, value| if value.is_nan() { f64::INFINITY } else { worst.max(value) })
}

/// ‖f′(x)‖∞.
fn norm<M: KahanMap<Dd, N>, const N: usize>(map: &M, x: &SVector<Dd, N>) -> f64 {
    let slopes = map.field_jacobian(x);
    let row = |i: usize| (0..N).map(|j| f64::from(slopes[(i, j)].abs())).sum::<f64>();
    (0..N).map(row).fold(0.0, f64::max)
}
