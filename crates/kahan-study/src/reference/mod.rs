//! Reference trajectories: solutions of the flow with an error estimate by an independent method.
//!
//! The first method is a Taylor series in time. The second method is the catalog's closed solution,
//! or Kahan's map composed to order 8. The difference is evidence, not a proof.

mod certificate;
#[cfg(feature = "catalog")]
mod closed;
mod no_reference;
mod path;

use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, KahanMap};
use kahan_dynamics::Flow;

use kahan_runtime::interpreted::round;

use path::path;

pub use certificate::{Certificate, Method};
pub use no_reference::NoReference;
pub use path::TrajectoryLimits;

/// Orbits are compared with a reference. The two methods that compute it may differ by this
/// fraction of the error that is allowed in the orbits.
pub const PART_OF_TOLERANCE: f64 = 1e-2;

/// A certified trajectory x(t), 0 ≤ t ≤ [`end`](Flow::end).
#[derive(Clone, Debug)]
pub struct Reference {
    flow: Flow<Dd>,
    certificate: Certificate,
    /// The number of coordinates of the flow; further coordinates are padding and stay 0.
    variables: usize,
}

/// A request for a reference trajectory.
#[derive(Clone, Copy, Debug)]
pub struct Trajectory<'a> {
    /// The system's name in the catalog, by which a closed-form solution is found; else any text.
    pub command: &'a str,
    /// The parameters.
    pub parameters: &'a [BigRational],
    /// The initial point x(0).
    pub start: &'a [BigRational],
    /// The last time, positive.
    pub end: f64,
    /// The largest accepted difference between the methods, relative to [`scale`](Flow::scale).
    pub allowed: f64,
}

impl Reference {
    /// Computes the trajectory of a field in double-double arithmetic. A start with fewer than N
    /// coordinates is padded with zeros.
    ///
    /// Each Taylor step costs about 250 evaluations of the bilinear form. The check costs the steps
    /// of a composition, or some evaluations of a closed-form solution.
    ///
    /// # Errors
    /// [`NoReference`].
    pub fn of<M, const N: usize>(
        map: &M,
        asked: &Trajectory<'_>,
        limits: &TrajectoryLimits<'_>,
    ) -> Result<Self, NoReference>
    where
        M: KahanMap<Dd, N>,
    {
        let start =
            SVector::from_fn(|i, _| asked.start.get(i).map_or(Dd::from(0.0), |x| round(&x.clone().into())));
        let flow = path(map, start, asked.end, limits)?;
        #[cfg(feature = "catalog")]
        let solution = closed::closed_solution(asked.command, asked.parameters, asked.start);
        #[cfg(not(feature = "catalog"))]
        let solution = None::<fn(Dd) -> Vec<Dd>>;
        let certificate = match solution {
            Some(solution) => Certificate::by_solution(&flow, &|t| padded(&solution(t), N), asked.allowed),
            None => Certificate::by_composition(&flow, map, start, asked.allowed, limits)?,
        };
        let Certificate { difference, agreed_until: until, .. } = certificate;
        if difference <= asked.allowed {
            Ok(Reference { flow, certificate, variables: N })
        } else {
            Err(NoReference::Disagree { difference, allowed: asked.allowed, until })
        }
    }

    /// Returns x(t), with the scale to which relative errors refer.
    pub fn flow(&self) -> &Flow<Dd> {
        &self.flow
    }

    /// Returns the evidence that the trajectory is accurate.
    pub fn certificate(&self) -> Certificate {
        self.certificate
    }

    /// Returns the distance of a point from x(t) in the maximum norm, relative to the flow's scale.
    pub fn distance(&self, t: Dd, x: &[Dd]) -> f64 {
        self.flow.distance(t, &padded(x, self.variables))
    }
}

fn padded(x: &[Dd], variables: usize) -> Vec<Dd> {
    (0..variables).map(|i| x.get(i).copied().unwrap_or_default()).collect()
}
