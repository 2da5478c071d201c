//! A trajectory to measure others by: a solution of the flow, with an error bound that a second, independent method has earned.
//!
//! In: a field, a point, a time. Out: a function of time in double-double numbers, and by how much the second method differs. The
//! first method is a Taylor series in time, the second the closed solution, where the catalog has one, or Kahan's map
//! composed to order 8: a composition knows nothing of derivatives in time, a series nothing of the map. Two settings of one method
//! could share a mistake.
//! Deliberately absent: interval arithmetic. The difference of two methods is evidence, not a proof.

mod closed;
mod dense;
mod refusal;
mod taylor;

use std::time::Instant;

use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Composition, Dd, KahanMap, Scalar};

use crate::interpreted::constant;

use dense::{Piece, piece_at};
use taylor::Expansion;

pub use refusal::NoReference;

/// A certified trajectory x(t), 0 ≤ t ≤ [`end`](Self::end).
#[derive(Clone, Debug)]
pub struct Reference {
    pieces: Vec<Piece>,
    end: f64,
    scale: f64,
    slope: f64,
    turning: f64,
    certificate: Certificate,
}

/// What stands behind a reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// The second method.
    pub method: Method,
    /// The largest difference from it that was seen, relative to the trajectory's [`scale`](Reference::scale).
    pub difference: f64,
    /// The last time before which every difference was as small as was asked for.
    pub agreed_until: f64,
}

/// The method that a Taylor series is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The catalog's closed solution.
    ClosedSolution,
    /// The Kahan–Li composition of order 8, with so many steps.
    Composition {
        /// The steps.
        steps: u64,
    },
}

/// The most steps of a series.
const MOST_PIECES: usize = 50_000;
/// The most steps of the composition, 17 stages each.
const MOST_STEPS: u64 = 1 << 20;
/// The times at which a closed solution, which is slow, is compared.
const CLOSED_SAMPLES: u32 = 64;
/// The most times at which the composition is compared.
const SAMPLES: u64 = 4096;

/// What a reference is made for.
#[derive(Clone, Copy, Debug)]
pub struct Trajectory<'a> {
    /// The system's name in the catalog, or anything else for a field that is not in it.
    pub command: &'a str,
    /// The parameters.
    pub parameters: &'a [BigRational],
    /// x(0).
    pub start: &'a [BigRational],
    /// The last time, above 0.
    pub end: f64,
    /// The largest difference between the methods that is accepted, relative to the scale.
    pub allowed: f64,
}

/// How far beyond its end a trajectory is followed, and how long that may take.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// The part of [`Trajectory::end`] by which orbits that do not end there exactly may go further. Where the solution escapes to
    /// infinity first, nothing is added.
    pub margin: f64,
    /// When to give up.
    pub deadline: Option<Instant>,
}

impl Limits {
    fn is_over(&self) -> bool {
        self.deadline.is_some_and(|deadline| Instant::now() > deadline)
    }
}

impl Reference {
    /// The trajectory of a field (the catalog's system, at its parameters, over double-double numbers).
    ///
    /// Cost: about 250 evaluations of the bilinear form a step of the series, whose length is a tenth of the distance to the
    /// nearest singularity in complex time, and the composition's steps.
    ///
    /// # Errors
    /// [`NoReference`].
    ///
    /// # Panics
    /// If the start has not N coordinates.
    pub fn of<M, const N: usize>(map: &M, asked: &Trajectory<'_>) -> Result<Self, NoReference>
    where
        M: KahanMap<Dd, N>,
    {
        Self::within(map, asked, &Limits::default())
    }

    /// The same within limits.
    ///
    /// # Errors
    /// [`NoReference`].
    ///
    /// # Panics
    /// If the start has not N coordinates.
    pub fn within<M, const N: usize>(
        map: &M,
        asked: &Trajectory<'_>,
        limits: &Limits,
    ) -> Result<Self, NoReference>
    where
        M: KahanMap<Dd, N>,
    {
        let start = SVector::from_fn(|i, _| Dd::constant(&constant(&asked.start[i].clone().into())));
        let mut reference = Self::by_series(map, start, asked.end, limits)?;
        reference.certificate = match closed::closed_solution(asked.command, asked.parameters, asked.start) {
            Some(solution) => reference.against_solution(&solution, asked.allowed),
            None => reference.against_composition(map, start, asked.allowed, limits)?,
        };
        let Certificate { difference, agreed_until: until, .. } = reference.certificate;
        if difference <= asked.allowed {
            Ok(reference)
        } else {
            Err(NoReference::Disagree { difference, allowed: asked.allowed, until })
        }
    }

    /// x(t), the nearest end's polynomial beyond the ends. Cost: about 60 operations a component.
    pub fn at(&self, t: Dd) -> Vec<Dd> {
        piece_at(&self.pieces, t).value(t)
    }

    /// The last time.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The largest |xᵢ(t)|, over all components and times up to [`Trajectory::end`]: what errors are relative to.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The largest ‖f′(x(t))‖ in the maximum norm: ε times this tells how coarse a step is.
    pub fn slope(&self) -> f64 {
        self.slope
    }

    /// The integral of ‖ẍ‖/‖ẋ‖ over the time, in the maximum norm: by what angle, so to say, the motion turns. Unlike the slope it says
    /// nothing of directions in which nothing moves.
    pub fn turning(&self) -> f64 {
        self.turning
    }

    /// What stands behind it.
    pub fn certificate(&self) -> Certificate {
        self.certificate
    }

    fn by_series<M, const N: usize>(
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
        let certificate =
            Certificate { method: Method::ClosedSolution, difference: f64::INFINITY, agreed_until: 0.0 };
        let last = end * (1.0 + limits.margin);
        let mut reference =
            Reference { pieces: Vec::new(), end: last, scale: 0.0, slope: 0.0, turning: 0.0, certificate };
        let (mut t, mut x) = (Dd::from(0.0), start);
        let (mut rate, mut first) = (norm(map, &start), None);
        loop {
            let (now, slope) = (f64::from(t), norm(map, &x));
            let series = expansion.at(x, rate);
            rate = 1.0 / series.radius;
            reference.pieces.push(series.piece(t));
            // A double, so that the sum of the steps in double-double is exact for long.
            let step = series.reach().min(2.0 * last);
            // Before a pole each step is a part of the way that is left.
            if !(x.iter().all(|entry| entry.is_finite()) && step > 1e-9 * (now + *first.get_or_insert(step)))
            {
                if now >= end {
                    reference.end = end;
                    break;
                }
                return Err(NoReference::Escapes {
                    time: now + if step > 0.0 { series.radius } else { 0.0 },
                });
            }
            if now <= end {
                reference.scale = size(&x, reference.scale);
                reference.slope = reference.slope.max(slope);
                reference.turning += series.turning * step.min(end - now);
            }
            if now <= end && now + step >= end {
                reference.scale = size(&series.value(Dd::from(end) - t), reference.scale);
            }
            if now + step >= last {
                break;
            }
            if reference.pieces.len() == MOST_PIECES {
                return Err(NoReference::TooLong { reached: now });
            }
            if limits.is_over() {
                return Err(NoReference::NoTime { reached: now });
            }
            x = series.value(Dd::from(step));
            t += Dd::from(step);
        }
        if reference.scale == 0.0 {
            // A solution that rests in the origin has errors, and no size.
            reference.scale = 1.0;
        }
        Ok(reference)
    }

    fn against_solution(&self, solution: &closed::Solution, allowed: f64) -> Certificate {
        let times = (1..=CLOSED_SAMPLES).map(|k| self.end * f64::from(k) / f64::from(CLOSED_SAMPLES));
        let mut comparison = Comparison::new(allowed);
        for t in times {
            comparison.add(t, self.distance(Dd::from(t), &solution(Dd::from(t))));
        }
        comparison.certificate(Method::ClosedSolution)
    }

    /// More and more steps, until the two are as near as was asked for, or come no nearer.
    fn against_composition<M, const N: usize>(
        &self,
        map: &M,
        start: SVector<Dd, N>,
        allowed: f64,
        limits: &Limits,
    ) -> Result<Certificate, NoReference>
    where
        M: KahanMap<Dd, N>,
    {
        let mut steps = ((2.0 * self.end * self.slope).ceil() as u64).clamp(16, MOST_STEPS);
        let mut before = f64::INFINITY;
        loop {
            let Some(comparison) = self.against_steps(map, start, steps, allowed, limits) else {
                return Err(NoReference::NoTime { reached: self.end });
            };
            let difference = comparison.difference;
            // Order 8 gains a factor of 256 with each doubling; without a gain it is roundings that differ.
            let has_stalled = difference.is_finite() && before.is_finite() && difference > 0.5 * before;
            if difference <= allowed || has_stalled || steps >= MOST_STEPS {
                return Ok(comparison.certificate(Method::Composition { steps }));
            }
            before = difference;
            steps *= 2;
        }
    }

    /// `None` where the time is over first.
    fn against_steps<M, const N: usize>(
        &self,
        map: &M,
        start: SVector<Dd, N>,
        steps: u64,
        allowed: f64,
        limits: &Limits,
    ) -> Option<Comparison>
    where
        M: KahanMap<Dd, N>,
    {
        let dt = Dd::from(self.end) / Dd::from(steps as f64);
        let stride = steps.div_ceil(SAMPLES) as usize;
        let mut orbit = map.orbit(start, dt * Dd::from(0.5)).composed(Composition::KAHAN_LI_8);
        orbit.next();
        let mut comparison = Comparison::new(allowed);
        let mut step = stride as u64;
        while step <= steps {
            if limits.is_over() {
                return None;
            }
            let Some(x) = orbit.nth(stride - 1) else { break };
            let t = dt * Dd::from(step as f64);
            comparison.add(t.into(), self.distance(t, x.as_slice()));
            step += stride as u64;
        }
        Some(comparison)
    }

    /// The distance of a point from x(t) in the maximum norm, relative to the scale; what is not a number is infinitely far.
    pub fn distance(&self, t: Dd, x: &[Dd]) -> f64 {
        let differences =
            self.at(t).into_iter().zip(x).map(|(exact, entry)| f64::from((*entry - exact).abs()));
        worst(differences) / self.scale
    }
}

/// Two methods, compared at times that grow.
#[derive(Clone, Copy, Debug)]
struct Comparison {
    allowed: f64,
    difference: f64,
    agreed_until: f64,
}

impl Comparison {
    fn new(allowed: f64) -> Self {
        Comparison { allowed, difference: 0.0, agreed_until: 0.0 }
    }

    fn add(&mut self, t: f64, difference: f64) {
        self.difference = self.difference.max(difference);
        if self.difference <= self.allowed {
            self.agreed_until = t;
        }
    }

    fn certificate(self, method: Method) -> Certificate {
        let Comparison { difference, agreed_until, .. } = self;
        Certificate { method, difference, agreed_until }
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
