//! Gradients of a scalar of an orbit by one reverse sweep, the discrete adjoint method.
//!
//! In: a map, the start of an orbit, and weights w₀, w₁, …: the derivatives of a scalar L with
//! respect to the rows of the orbit. Out: the derivatives of L with respect to start, parameters
//! and ε.
//!
//! # Method
//!
//! A step solves R = x̃ − x − 2ε q(x,x̃) = 0 for x̃. Here q is the polarised field, and A(x,ε) = I
//! − εf′(x):
//!
//! ```text
//! q(x,x̃) = Q(x,x̃) + ½B(x + x̃) + c,   ∂R/∂x̃ = A(x,ε),   ∂R/∂x = −A(x̃,−ε).
//! ```
//!
//! If λ̃ = ∂L/∂x̃ is known, one solve with the transposed matrix gives λ = ∂L/∂x. For a parameter
//! a:
//!
//! ```text
//! A(x,ε)ᵀ μ = λ̃
//! λ = A(x̃,−ε)ᵀ μ = μ + ε f′(x̃)ᵀ μ
//! ∂L/∂a += 2ε μ·∂q/∂a (x,x̃)
//! ∂L/∂ε += 2 μ·q(x,x̃)
//! ```
//!
//! The states are recomputed from about √(steps · stages) checkpoints. If coefficients depend on ε,
//! or near det A = 0, dual numbers differentiate a stage.

mod backward_pass;
mod terms;

use core::num::NonZeroU64;
use core::ops::ControlFlow;

use crate::dimension::Argument;
use crate::follow::pause;
use crate::{DimensionError, End, Follow, Followed, MapAt, RuntimeFloat};

use backward_pass::BackwardPass;

/// The derivatives of a function of an orbit with respect to the orbit's first point, the
/// parameters and ε; made by [`MapAt::gradient`].
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient<T> {
    /// The derivatives with respect to the coordinates of the start.
    pub start: Vec<T>,
    /// The derivatives with respect to the parameters, in the order of
    /// [`Field::parameters`](crate::Field::parameters).
    pub parameters: Vec<T>,
    /// The derivative with respect to ε, half the time step.
    pub eps: T,
}

impl<T: RuntimeFloat> Gradient<T> {
    fn zero(variables: usize, parameters: usize) -> Self {
        Gradient {
            start: vec![T::zero(); variables],
            parameters: vec![T::zero(); parameters],
            eps: T::zero(),
        }
    }
}

impl<T: RuntimeFloat> MapAt<T> {
    /// Computes the gradient of a scalar L of the orbit from `start`.
    ///
    /// The rows of `weights` are the derivatives of L with respect to the points after 0, `every`,
    /// 2·`every`, … steps. The gradient is that of the computed orbit, not that of the flow. The
    /// report is `None` if the orbit ends before the last row.
    ///
    /// The `watch` is called as in [`Follow`], first for the steps forward, then for equally many
    /// steps backward.
    ///
    /// Cost of each step: two steps of the map, one factorisation of A(x,ε)ᵀ, and one
    /// multiplication for each parameter in each term of the field. Memory: about 2√`steps` states.
    ///
    /// # Errors
    /// [`DimensionError`] for a `start` of a wrong length, or `weights` that are not whole rows.
    ///
    /// ```
    /// use std::num::NonZeroU64;
    /// use std::ops::ControlFlow;
    ///
    /// use kahan_runtime::Field;
    ///
    /// // x' = a·x²: one step takes x to x/(1 − 2εax). L = x₀ + x₁.
    /// let at = Field::parse("xdot = a*x^2;").unwrap().with([("a", 2)]).unwrap().at(0.25);
    /// let weights = [1.0, 1.0];
    /// let found = at.gradient(&[0.5], NonZeroU64::MIN, &weights, |_| ControlFlow::Continue(()));
    /// let gradient = found.unwrap().report.unwrap();
    /// assert_eq!((gradient.start[0], gradient.parameters[0], gradient.eps), (5.0, 0.5, 4.0));
    /// ```
    pub fn gradient(
        &self,
        start: &[T],
        every: NonZeroU64,
        weights: &[T],
        mut watch: impl FnMut(u64) -> ControlFlow<()>,
    ) -> Result<Followed<Option<Gradient<T>>>, DimensionError> {
        let n = start.len().max(1);
        let mut x = start.to_vec();
        let end = self.follow(&mut x, 0, &mut watch)?.end;
        if !weights.len().is_multiple_of(n) {
            return Err(DimensionError::new(Argument::Weights, weights.len(), n));
        }
        let rows = (weights.len() / n) as u64;
        let steps = rows.saturating_sub(1).saturating_mul(every.get());
        let mut back = BackwardPass::of(self);
        let length = (steps / back.stages() as u64).isqrt().max(1);
        let (checkpoints, end) = match end {
            End::Complete => self.checkpoints(&mut x, [steps, length], &mut watch)?,
            end => (Vec::new(), end),
        };
        if end != End::Complete {
            return Ok(Followed { report: None, end });
        }
        let mut total = Gradient::zero(x.len(), self.map().parameters().len());
        let row = |step: u64| {
            let row = step.is_multiple_of(every.get()).then_some(step / every).filter(|row| *row < rows);
            row.into_iter().flat_map(|row| &weights[row as usize * n..][..n])
        };
        total.start.iter_mut().zip(row(steps)).for_each(|(slope, weight)| *slope = *weight);
        back.begin(&x);
        let (pause, mut points, mut left) = (pause(x.len()), Vec::new(), steps);
        for checkpoint in checkpoints.chunks_exact(n).rev() {
            let first = (left - 1) / length * length;
            points.clear();
            points.extend_from_slice(checkpoint);
            for step in first..left {
                back.make_step(&mut points);
                if step.is_multiple_of(pause) && watch(0).is_break() {
                    return Ok(Followed { report: None, end: End::Stopped(left) });
                }
            }
            // Each segment between checkpoints has its own sum. A single sum would lose digits.
            let mut part = Gradient::zero(0, total.parameters.len());
            std::mem::swap(&mut part.start, &mut total.start);
            let mut told = left;
            while left > first {
                left -= 1;
                back.take_step(&mut points, &mut part);
                part.start.iter_mut().zip(row(left)).for_each(|(slope, weight)| *slope += *weight);
                let is_time = left == first || told - left >= pause;
                if is_time && watch(std::mem::replace(&mut told, left) - left).is_break() && left > 0 {
                    return Ok(Followed { report: None, end: End::Stopped(left) });
                }
            }
            std::mem::swap(&mut part.start, &mut total.start);
            total.parameters.iter_mut().zip(part.parameters).for_each(|(sum, more)| *sum += more);
            total.eps += part.eps;
        }
        Ok(Followed { report: Some(total), end })
    }

    /// Replaces `x` by the last state of the orbit. Returns every `length`-th state, beginning with
    /// the first, and how the orbit ended.
    fn checkpoints(
        &self,
        x: &mut [T],
        [steps, length]: [u64; 2],
        mut watch: impl FnMut(u64) -> ControlFlow<()>,
    ) -> Result<(Vec<T>, End), DimensionError> {
        let (mut made, mut checkpoints, mut is_stopped) = (0, Vec::new(), false);
        while made < steps {
            checkpoints.extend_from_slice(x);
            let now = length.min(steps - made);
            let watch = |made| {
                let flow = watch(made);
                is_stopped = flow.is_break();
                flow
            };
            let end = self.follow(x, now, watch)?.end.after(made);
            made += now;
            let end = if is_stopped && end == End::Complete { End::Stopped(made) } else { end };
            if end != End::Complete {
                return Ok((checkpoints, end));
            }
        }
        Ok((checkpoints, End::Complete))
    }
}
