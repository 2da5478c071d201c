//! A trajectory to measure others by: a solution of the flow, with an error bound that a second,
//! independent method has earned.
//!
//! In: a field, a point, a time. Out: a function of time in double-double numbers, and by how much
//! the second method differs. The first method is a Taylor series in time, the second the closed
//! solution, where the catalog has one, or Kahan's map composed to order 8: a composition knows
//! nothing of derivatives in time, a series nothing of the map. Two settings of one method could
//! share a mistake. Deliberately absent: interval arithmetic. The difference of two methods is
//! evidence, not a proof.

mod certificate;
#[cfg(feature = "catalog")]
mod closed;
mod path;
mod refusal;

use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, KahanMap};
use kahan_dynamics::Flow;

use kahan_runtime::interpreted::round;

use path::path;

pub use certificate::{Certificate, Method};
pub use path::Limits;
pub use refusal::NoReference;

/// The part of a tolerance that the two methods may differ by, where orbits are to be judged by
/// that tolerance: it takes errors to a tenth of it, which a tenth of that does not change.
pub const PART_OF_TOLERANCE: f64 = 1e-2;

/// A certified trajectory x(t), 0 ≤ t ≤ [`end`](Flow::end).
#[derive(Clone, Debug)]
pub struct Reference {
    flow: Flow<Dd>,
    certificate: Certificate,
    /// The coordinates of the flow; those beyond the system's own stay 0.
    variables: usize,
}

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

impl Reference {
    /// The trajectory of a field (the catalog's system, at its parameters, over double-double
    /// numbers).
    ///
    /// Cost: about 250 evaluations of the bilinear form a step of the series, whose length is a
    /// tenth of the distance to the nearest singularity in complex time, and the composition's
    /// steps.
    ///
    /// A start of fewer than N coordinates is at 0 in the others.
    ///
    /// # Errors
    /// [`NoReference`].
    pub fn of<M, const N: usize>(
        map: &M,
        asked: &Trajectory<'_>,
        limits: &Limits<'_>,
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

    /// x(t) itself, and its scale, which errors are relative to.
    pub fn flow(&self) -> &Flow<Dd> {
        &self.flow
    }

    /// What stands behind it.
    pub fn certificate(&self) -> Certificate {
        self.certificate
    }

    /// The distance of a point from x(t) in the maximum norm, relative to the scale; what is not a
    /// number is infinitely far.
    pub fn distance(&self, t: Dd, x: &[Dd]) -> f64 {
        self.flow.distance(t, &padded(x, self.variables))
    }
}

/// The point in so many coordinates, those that it lacks being 0.
fn padded(x: &[Dd], variables: usize) -> Vec<Dd> {
    (0..variables).map(|i| x.get(i).copied().unwrap_or_default()).collect()
}
