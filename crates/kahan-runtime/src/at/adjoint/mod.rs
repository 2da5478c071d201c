//! Gradients of a scalar of an orbit, by one sweep back over it.
//!
//! In: a map, the start of an orbit, and w₀, w₁, …, the derivatives of a scalar L by the rows that
//! are shown of the orbit. Out: the derivatives of L by the start, by each parameter and by ε.
//!
//! A step solves R = x̃ − x − 2ε q(x,x̃) = 0 for x̃, where q is the polarised field
//!
//! ```text
//! q(x,x̃) = Q(x,x̃) + ½B(x + x̃) + c,   ∂R/∂x̃ = A(x,ε),   ∂R/∂x = −A(x̃,−ε).
//! ```
//!
//! So it takes λ̃, the derivative of L by x̃, back to λ, that by x, by one transposed solve:
//!
//! ```text
//! A(x,ε)ᵀ μ = λ̃
//! λ = A(x̃,−ε)ᵀ μ = μ + ε f′(x̃)ᵀ μ
//! ∂L/∂a += 2ε μ·∂q/∂a (x,x̃)
//! ∂L/∂ε += 2 μ·q(x,x̃)
//! ```
//!
//! No step is taken back: the states are computed forward again from checkpoints, which are as many
//! as the steps from one to the next. A stage of a composition is a step with γε, and adds γ times
//! its derivative by γε to that by ε.
//!
//! - `terms` has the coefficients of the field as numbers, and their derivatives.
//! - `back` takes one step of Kahan's map back.

mod back;
mod terms;

use core::num::NonZeroU64;
use core::ops::ControlFlow;

use crate::dimension::Argument;
use crate::follow::pause;
use crate::{DimensionError, End, Follow, Followed, MapAt, RuntimeFloat};

use back::Back;

/// The derivatives of a scalar by what an orbit depends on; made by [`MapAt::gradient`].
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient<T> {
    /// By the coordinates of the start.
    pub start: Vec<T>,
    /// By the parameters, in the order of [`Field::parameters`](crate::Field::parameters).
    pub parameters: Vec<T>,
    /// By ε, half the time step.
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
    /// The gradient of a scalar L of the orbit from `start`, which is seen after 0, `every`,
    /// 2·`every`, … steps: `weights` are the derivatives of L by these rows, row after row. The
    /// orbit has as many steps as lead to the last row.
    ///
    /// The gradient is that of the computed orbit, in the precision of the map: of a
    /// [composition](Self::composed) that of its steps. The report is `None` where the orbit ends
    /// before its last row.
    ///
    /// `watch` is told of the steps made since it was asked last, as by [`Follow`]: of all steps
    /// forward, and of as many back. It stops the work by [`ControlFlow::Break`].
    ///
    /// Cost: each step is made twice, and taken back once, by a factorisation of A(x,ε)ᵀ, whatever
    /// the number of parameters; only terms of the field with a parameter count once more for each.
    /// Memory: about 2√`steps` states.
    ///
    /// # Errors
    /// [`DimensionError`] if `start` has not an entry a variable, or `weights` is not a whole
    /// number of rows.
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
        let mut back = Back::of(self);
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
            // Sums of a part are added to the total at once: long sums lose fewer digits so.
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

    /// The states after 0, `length`, 2·`length`, … steps, but for the last state, which replaces
    /// `x`; and how the orbit ended.
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
            // The last steps of a part are not the last ones of the work.
            let end = if is_stopped && end == End::Complete { End::Stopped(made) } else { end };
            if end != End::Complete {
                return Ok((checkpoints, end));
            }
        }
        Ok((checkpoints, End::Complete))
    }
}
