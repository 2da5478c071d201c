//! The passage through a pole: steps advance lines that pass through the point before the pole.
//!
//! A line consists of the points x + δv for one direction v. Each step solves A(x,ε)·x̃ = b(x,ε)
//! over numbers that depend on δ. If two lines have one limit as δ → 0, this limit is the next
//! point of the orbit. Over floats a single line with δ = 0 is tried first. The passage ends after
//! merged points are separate again, or after `MOST_STEPS` steps.

use std::vec::Vec;

use nalgebra::{SMatrix, SVector};
use num_traits::{One, Zero};

use crate::field::linear::solve;
use crate::{ExtendScalars, KahanMap, Scalar};

use super::ThroughPoles;
use super::delta_series::DeltaSeries;
use super::point::ProjectivePoint;

/// The components of the directions of lines, chosen arbitrarily.
const LINE_SLOPES: [i64; 13] = [271, -314, 577, 618, -161, 803, -398, 874, -989, 484, -820, 459, -236];

fn slope<S: Scalar>(i: usize, line: usize, effort: usize) -> S {
    let place = i + 5 * line + 3 * effort;
    S::constant(&crate::Constant::integer(LINE_SLOPES[place % LINE_SLOPES.len()]))
}

/// A line through the point before the pole, advanced by the steps so far.
#[derive(Clone)]
struct ProjectiveLine<S, const N: usize> {
    point: SVector<S, N>,
    /// The Jacobian of the steps from the current point back to the first, or `None` if unknown.
    derivative: Option<SMatrix<S, N, N>>,
}

impl<S: Scalar, const N: usize> ProjectiveLine<S, N> {
    /// Advances the line by one step. Returns `None` if A is not known to be invertible.
    fn advance<M: KahanMap<S, N>>(&mut self, map: &M, eps: &S) -> Option<()> {
        let matrix = map.matrix(&self.point, eps.clone());
        let next = solve(matrix.clone(), map.rhs(&self.point, eps.clone()))?;
        self.derivative = self.derivative.take().and_then(|derivative| {
            let step_back = solve(map.matrix(&next, -eps.clone()), matrix)?;
            Some(product(&derivative, &step_back))
        });
        self.point = next;
        Some(())
    }
}

fn product<S: Scalar, const N: usize>(a: &SMatrix<S, N, N>, b: &SMatrix<S, N, N>) -> SMatrix<S, N, N> {
    SMatrix::from_fn(|i, j| (0..N).fold(S::zero(), |sum, k| sum + a[(i, k)].clone() * b[(k, j)].clone()))
}

pub(super) struct PassagePoint<T, const N: usize> {
    pub(super) point: ProjectivePoint<T, N>,
    /// Whether merged points are separate again, `None` if this is unknown.
    pub(super) is_through: Option<bool>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoLimit {
    /// The limits along two lines differ, even in the last attempt.
    Ambiguous,
    /// Even the last attempt finds no limit.
    Unknown,
}

#[derive(Clone)]
pub(super) struct Passage<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> {
    start: SVector<T, N>,
    unit: T::DeltaSeries,
    map: M::Extended<T::DeltaSeries>,
    eps: T::DeltaSeries,
    effort: usize,
    taken: usize,
    last: Option<ProjectivePoint<T, N>>,
    lines: Vec<ProjectiveLine<T::DeltaSeries, N>>,
}

impl<M: ExtendScalars<T, N>, T: ThroughPoles, const N: usize> Passage<M, T, N> {
    pub(super) fn from(map: &M, eps: &T, start: SVector<T, N>) -> Self {
        let (map, eps, unit) = (
            map.extend_scalars(T::DeltaSeries::of),
            T::DeltaSeries::of(eps),
            T::DeltaSeries::unit(start.as_slice()),
        );
        let mut passage = Self { start, unit, map, eps, effort: 0, taken: 0, last: None, lines: Vec::new() };
        passage.begin();
        passage
    }

    pub(super) fn steps_taken(&self) -> usize {
        self.taken
    }

    pub(super) fn into_last_point(self) -> Option<ProjectivePoint<T, N>> {
        self.last
    }

    /// Returns the next point. A failed attempt is followed by another from the passage's start.
    pub(super) fn advance(&mut self) -> Result<PassagePoint<T, N>, NoLimit> {
        let mut steps = 1;
        loop {
            let place = self.attempt(steps);
            let is_last = self.effort + 1 == T::DeltaSeries::EFFORTS;
            match place {
                Some(Err(lost)) if is_last => return Err(lost),
                Some(Ok(place)) if place.is_through.is_some() || is_last => {
                    self.taken += 1;
                    self.last = Some(place.point.clone());
                    return Ok(place);
                }
                None if is_last => return Err(NoLimit::Unknown),
                _ => {
                    self.effort += 1;
                    self.begin();
                    steps = self.taken + 1;
                }
            }
        }
    }

    fn begin(&mut self) {
        let delta = T::DeltaSeries::delta(self.effort);
        let lines = if delta.is_zero() { 1 } else { 2 };
        self.lines = (0..lines).map(|line| self.line(line, &delta)).collect();
    }

    fn line(&self, line: usize, delta: &T::DeltaSeries) -> ProjectiveLine<T::DeltaSeries, N> {
        let along = self.unit.clone() * delta.clone();
        let moved =
            |i: usize| T::DeltaSeries::of(&self.start[i]) + along.clone() * slope(i, line, self.effort);
        let unit = |i, j| if i == j { T::DeltaSeries::one() } else { T::DeltaSeries::zero() };
        let derivative = (line == 0).then(|| SMatrix::from_fn(unit));
        ProjectiveLine { point: SVector::from_fn(|i, _| moved(i)), derivative }
    }

    /// Advances all lines by `steps` steps. Returns `None` if this attempt does not determine the
    /// point.
    fn attempt(&mut self, steps: usize) -> Option<Result<PassagePoint<T, N>, NoLimit>> {
        let Self { unit, map, eps, effort, lines, .. } = self;
        let mut common: Option<ProjectivePoint<T, N>> = None;
        for line in lines.iter_mut() {
            for _ in 0..steps {
                line.advance(map, eps)?;
            }
            let limit = T::DeltaSeries::limit(&line.point, unit, *effort)?;
            match &common {
                Some(other) if !are_near(other, &limit) => return Some(Err(NoLimit::Ambiguous)),
                Some(_) => {}
                None => common = Some(limit),
            }
        }
        let point = common?;
        let is_through = if point.is_infinite() {
            Some(false)
        } else {
            let line = &lines[0];
            line.derivative
                .as_ref()
                .and_then(|derivative| T::DeltaSeries::is_one_to_one(derivative, &line.point, unit))
        };
        Some(Ok(PassagePoint { point, is_through }))
    }
}

fn are_near<T: ThroughPoles, const N: usize>(a: &ProjectivePoint<T, N>, b: &ProjectivePoint<T, N>) -> bool {
    a == b || (a.is_infinite() == b.is_infinite() && T::are_near(a.coordinates(), b.coordinates()))
}
