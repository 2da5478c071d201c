//! Estimates of the error of steps and orbits against the flow.
//!
//! The estimates are the leading term of the discretisation error, without rounding errors. They
//! need no reference solution.

use core::array::from_fn;

use nalgebra::SVector;

use crate::field::linear::vector;
use crate::{Constant, ExtendScalars, FloatScalar, KahanAt, KahanMap, Orbit, Scalar, StateVector, Step};

use super::Compensated;
use super::tangent::push_forward_to;

impl<M: KahanMap<T, N>, T: Scalar, const N: usize> KahanAt<M, T, N> {
    /// Estimates the local error by its leading term. The local error is x̃ minus the flow from x
    /// for the time h = 2ε:
    ///
    ///   h³[f′f′f/12 − f″(f,f)/6] + O(h⁴)
    ///
    /// If coefficients of f depend on ε, 2ε(f at ε − f at 0) is added. Subtracting the estimate
    /// from x̃ raises the order to 3 but destroys the map's structure. The cost is one evaluation
    /// of f, f′ and f″(f,f), and two products with f′.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Logistic growth to the capacity 1.
    ///     pub struct Logistic;
    ///     xdot = x*(1 - x);
    /// }
    ///
    /// let (x, eps) = (0.25_f64, 0.05_f64);
    /// let flow = x / (x + (1.0 - x) * (-2.0 * eps).exp());
    /// let error = Logistic.step(&vector![x], eps)[0] - flow;
    /// let estimate = Logistic.at(eps).local_error(&vector![x])[0];
    /// assert!((error - estimate).abs() < 0.1 * error.abs());
    /// ```
    pub fn local_error(&self, x: &SVector<T, N>) -> SVector<T, N> {
        local_error(self.map(), self.eps(), x)
    }
}

fn local_error<M: KahanMap<T, N>, T: Scalar, const N: usize>(
    map: &M,
    eps: &T,
    x: &SVector<T, N>,
) -> SVector<T, N> {
    let times_eps = |v: SVector<T, N>| -> SVector<T, N> { vector(from_fn(|i| eps.clone() * v[i].clone())) };
    let slopes = map.field_jacobian(x);
    let along = |v: &SVector<T, N>| -> SVector<T, N> {
        let row = |i: usize| {
            (0..N).fold(T::zero(), |sum, j| slopes[(i, j)].clone().multiply_add(v[j].clone(), sum))
        };
        times_eps(vector(from_fn(row)))
    };
    let g = times_eps(map.field(x));
    let bent = times_eps(map.bilinear(&g, &g));
    let turned = along(&along(&g));
    let (four, two_thirds) = (T::constant(&Constant::integer(4)), T::constant(&Constant::ratio(2, 3)));
    let error: SVector<T, N> = vector(from_fn(|i| {
        two_thirds.clone() * turned[i].clone().subtract_product(four.clone(), bent[i].clone())
    }));
    if !map.has_coefficients_of_eps() {
        return error;
    }
    let moved = times_eps(map.field_at(x, eps));
    vector(from_fn(|i| {
        let difference = moved[i].clone() - g[i].clone();
        error[i].clone() + difference.clone() + difference
    }))
}

/// A point of an orbit, with an estimate of the point's distance from the flow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimated<T, const N: usize> {
    /// The point xₙ of the orbit.
    pub point: SVector<T, N>,
    /// An estimate of xₙ minus the flow from x₀ for the time 2εn.
    pub error: SVector<T, N>,
}

/// An orbit with error estimates; see [`Orbit::with_error_estimate`].
#[derive(Clone)]
#[must_use = "an orbit computes nothing until it is iterated"]
pub struct ErrorEstimates<S: Step, M: ExtendScalars<T, N>, T: Scalar, const N: usize> {
    orbit: Orbit<S>,
    at: KahanAt<M, T, N>,
    /// The last yielded point, and the local error of a step from this point.
    last: Option<(Estimated<T, N>, SVector<T, N>)>,
}

impl<M: ExtendScalars<T, N>, T: Scalar, const N: usize> Orbit<KahanAt<M, T, N>> {
    /// Adds an estimate of each point's error, its distance from the flow that starts at the next
    /// point that this orbit yields.
    ///
    /// With the [local error](KahanAt::local_error) d and the map's Jacobian φ′, the estimates eₙ
    /// satisfy
    ///
    ///   eₙ₊₁ = φ′(xₙ)·(eₙ + ½d(xₙ)) + ½d(xₙ₊₁)
    ///
    /// At a fixed time the error is O(ε²), and the estimate deviates from the error by O(ε⁴). This
    /// requires φ′ to be nearly constant over a distance as large as the error. Rounding errors are
    /// not included. Each step costs as much as three plain steps.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Logistic growth to the capacity 1.
    ///     pub struct Logistic;
    ///     xdot = x*(1 - x);
    /// }
    ///
    /// let (start, eps) = (0.25_f64, 0.05_f64);
    /// let mut orbit = Logistic.orbit(vector![start], eps).with_error_estimate();
    /// let tenth = orbit.nth(10).unwrap();
    /// let flow = start / (start + (1.0 - start) * (-20.0 * eps).exp());
    /// let error = tenth.point[0] - flow;
    /// assert!((error - tenth.error[0]).abs() < 0.01 * error.abs());
    /// ```
    pub fn with_error_estimate(self) -> ErrorEstimates<KahanAt<M, T, N>, M, T, N> {
        let at = self.map.clone();
        ErrorEstimates { orbit: self, at, last: None }
    }
}

impl<M: ExtendScalars<T, N>, T: FloatScalar, const N: usize> Orbit<Compensated<KahanAt<M, T, N>>> {
    /// Adds estimates of the discretisation error, computed as for an orbit without compensation.
    pub fn with_error_estimate(self) -> ErrorEstimates<Compensated<KahanAt<M, T, N>>, M, T, N> {
        let Compensated(at) = self.map.clone();
        ErrorEstimates { orbit: self, at, last: None }
    }
}

impl<S: Step, M: ExtendScalars<T, N>, T: Scalar, const N: usize> ErrorEstimates<S, M, T, N> {
    /// Returns the underlying orbit, which also tells why the orbit [stopped](Orbit::stopped).
    pub fn orbit(&self) -> &Orbit<S> {
        &self.orbit
    }
}

impl<S, M, T, const N: usize> Iterator for ErrorEstimates<S, M, T, N>
where
    S: Step<Scalar = T, State: StateVector<T, Point = SVector<T, N>>>,
    M: ExtendScalars<T, N>,
    T: Scalar,
{
    type Item = Estimated<T, N>;

    fn next(&mut self) -> Option<Self::Item> {
        let point = self.orbit.next()?;
        let local = self.at.local_error(&point);
        let half = T::constant(&Constant::ratio(1, 2));
        let error = match &self.last {
            None => vector(from_fn(|_| T::zero())),
            Some((Estimated { point: before, error }, local_before)) => {
                let left = |i: usize| half.clone().multiply_add(local_before[i].clone(), error[i].clone());
                let stage = [(&self.at.map, &self.at.eps)].into_iter();
                let carried = push_forward_to(stage, before, &point, &vector(from_fn(left)))?;
                vector(from_fn(|i| half.clone().multiply_add(local[i].clone(), carried[i].clone())))
            }
        };
        let estimated = Estimated { point, error };
        self.last = Some((estimated.clone(), local));
        Some(estimated)
    }
}
