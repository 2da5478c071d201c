//! Compares Taylor series with the closed-form solution, or with Kahan's map composed to order 8.

use kahan_core::nalgebra::SVector;
use kahan_core::{Composition, Dd, KahanMap};
use kahan_dynamics::Flow;
use serde::{Serialize, Serializer};

use super::no_reference::{LEAST_DIFFERENCE, NoReference};
use super::path::TrajectoryLimits;

const FEWEST_STEPS: f64 = 16.0;
/// After a failed trial, the number of steps is multiplied by at least this factor.
const LEAST_MORE: f64 = 1.25;
const MOST_MORE: f64 = 2.0;
/// A trial of the composition stops if its relative difference from the Taylor series exceeds this
/// bound.
const STOPPING_DIFFERENCE: f64 = 0.1;
/// The number of times at which a path is compared with a closed solution.
const CLOSED_SAMPLES: u32 = 64;
const SAMPLES: u64 = 4096;

/// The evidence for a reference trajectory.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Certificate {
    /// The second method.
    #[serde(rename = "second_method", serialize_with = "name")]
    pub method: Method,
    /// The largest difference from the second method, relative to the trajectory's
    /// [`scale`](kahan_dynamics::Flow::scale).
    pub difference: f64,
    /// Up to this time, all compared differences are at most the allowed difference.
    #[serde(skip)]
    pub agreed_until: f64,
}

fn name<S: Serializer>(method: &Method, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(match method {
        Method::ClosedSolution => "closed solution",
        Method::Composition { .. } => "composition",
    })
}

/// The method that a Taylor series is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// A closed-form solution from the catalog.
    ClosedSolution,
    /// The Kahan–Li composition of order 8.
    Composition {
        /// The number of steps.
        steps: u64,
    },
}

impl Certificate {
    pub(super) fn by_solution(path: &Flow<Dd>, solution: &dyn Fn(Dd) -> Vec<Dd>, allowed: f64) -> Self {
        let times = (1..=CLOSED_SAMPLES).map(|k| path.end() * f64::from(k) / f64::from(CLOSED_SAMPLES));
        let mut comparison = Comparison::new(allowed);
        for t in times {
            comparison.add(t, path.distance(Dd::from(t), &solution(Dd::from(t))));
        }
        comparison.certificate(Method::ClosedSolution)
    }

    /// Compares a Taylor path with a composition. Increases the number of steps until the
    /// difference is allowed or stops falling, or until the time is over.
    pub(super) fn by_composition<M, const N: usize>(
        path: &Flow<Dd>,
        map: &M,
        start: SVector<Dd, N>,
        allowed: f64,
        limits: &TrajectoryLimits<'_>,
    ) -> Result<Self, NoReference>
    where
        M: KahanMap<Dd, N>,
    {
        let steepest = 2.0 * path.end() * path.slope();
        let mut steps = path.turning().ceil().max(FEWEST_STEPS) as u64;
        let mut before: Option<Comparison> = None;
        loop {
            let Some(comparison) = Comparison::with_steps(path, map, start, steps, allowed, limits) else {
                return Err(NoReference::NoTime { reached: path.end() });
            };
            let has_gained = before.is_none_or(|before| comparison.gains_on(&before));
            // More steps bring no gain if only rounding errors are left. To be sure of this, the
            // difference must be tiny, or steps at most 1/(2‖f′‖) long for the field f.
            let has_stalled =
                !has_gained && (steps as f64 >= steepest || comparison.difference < LEAST_DIFFERENCE);
            if comparison.difference <= allowed || has_stalled {
                return Ok(comparison.certificate(Method::Composition { steps }));
            }
            let order = f64::from(Composition::KAHAN_LI_8.order());
            let missing = 1.05 * libm::pow(comparison.difference / allowed, 1.0 / order);
            let more = if has_gained { missing.clamp(LEAST_MORE, MOST_MORE) } else { MOST_MORE };
            steps = (steps as f64 * more).ceil() as u64;
            before = Some(comparison);
        }
    }
}

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

    /// Returns whether the methods differ clearly less than in `before`, or agree clearly longer.
    fn gains_on(&self, before: &Self) -> bool {
        self.difference < 0.5 * before.difference || self.agreed_until > 1.02 * before.agreed_until
    }

    fn certificate(self, method: Method) -> Certificate {
        let Comparison { difference, agreed_until, .. } = self;
        Certificate { method, difference, agreed_until }
    }

    fn with_steps<M, const N: usize>(
        path: &Flow<Dd>,
        map: &M,
        start: SVector<Dd, N>,
        steps: u64,
        allowed: f64,
        limits: &TrajectoryLimits<'_>,
    ) -> Option<Self>
    where
        M: KahanMap<Dd, N>,
    {
        let dt = Dd::from(path.end()) / Dd::from(steps as f64);
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
            comparison.add(t.into(), path.distance(t, x.as_slice()));
            if comparison.difference > STOPPING_DIFFERENCE.max(allowed) {
                break;
            }
            step += stride as u64;
        }
        Some(comparison)
    }
}

#[cfg(test)]
mod tests {
    use super::{Certificate, Comparison, Method};

    fn certificate(differences: &[f64]) -> Certificate {
        let mut comparison = Comparison::new(1e-9);
        for (k, difference) in (1..).zip(differences) {
            comparison.add(f64::from(k), *difference);
        }
        comparison.certificate(Method::ClosedSolution)
    }

    #[test]
    fn a_certificate_holds_the_largest_difference_and_the_time_before_it() {
        let smooth = certificate(&[1e-12, 3e-11, 2e-11]);
        assert_eq!((smooth.difference, smooth.agreed_until), (3e-11, 3.0));
        let parted = certificate(&[1e-12, 1e-3, 1e-12, 1e-12]);
        assert_eq!((parted.difference, parted.agreed_until), (1e-3, 1.0));
        let infinite = certificate(&[f64::INFINITY, 1e-12]);
        assert_eq!((infinite.difference, infinite.agreed_until), (f64::INFINITY, 0.0));
        assert_eq!(certificate(&[1e-9, 1.0001e-9]).agreed_until, 1.0);
    }

    #[test]
    fn a_sensitive_motion_that_is_followed_for_longer_has_gained() {
        let of = |difference: f64, agreed_until: f64| Comparison { allowed: 1e-9, difference, agreed_until };
        assert!(of(1e-5, 0.0).gains_on(&of(2e-3, 0.0)));
        assert!(of(1.2, 36.0).gains_on(&of(1.1, 30.0)));
        assert!(of(f64::INFINITY, 2.0).gains_on(&of(f64::INFINITY, 1.0)));
        assert!(!of(1.2, 30.1).gains_on(&of(1.1, 30.0)));
        assert!(!of(f64::INFINITY, 0.0).gains_on(&of(f64::INFINITY, 0.0)));
        assert!(!of(0.9e-28, 0.0).gains_on(&of(1e-28, 0.0)));
    }
}
