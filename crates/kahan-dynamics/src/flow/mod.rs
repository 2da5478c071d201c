//! The solution x(t) of ẋ = f(x), a reference for orbits of the map.
//!
//! The pieces of the solution are Taylor polynomials of high degree ([`series`]). They are short
//! where the motion is fast or near a pole. Kahan's map is not used, so agreement with an orbit is
//! independent evidence. Errors are not bounded rigorously.

mod piece;
mod series;

use kahan_core::nalgebra::SVector;

use kahan_core::{Dd, FloatScalar, QuadraticField};

use piece::TaylorPiece;
use series::Expansion;
pub(crate) use series::SeriesScalar;

/// The solution x(t), 0 ≤ t ≤ [`end`](Self::end), of a quadratic field through a point, computed in
/// the type T: `f64` or [`Dd`].
///
/// Each piece adds a relative error of about T's unit roundoff. The flow may amplify these errors.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_dynamics::Flow;
///
/// kahan! {
///     /// Logistic growth to the capacity 1.
///     pub struct Logistic;
///     xdot = x*(1 - x);
/// }
///
/// let flow = Flow::through(&Logistic, vector![Dd::from(0.25)], 10.0, 0.0, &mut |_| true)?;
/// let exact = 0.25 / (0.25 + 0.75 * (-3.0_f64).exp());
/// assert!((f64::from(flow.at(Dd::from(3.0))[0]) - exact).abs() < 1e-15);
/// # Ok::<(), kahan_dynamics::NoFlow>(())
/// ```
#[derive(Clone, Debug)]
pub struct Flow<T> {
    pieces: Vec<TaylorPiece<T>>,
    end: f64,
    /// Distances and the scale use only the first `measured` variables.
    measured: usize,
    scale: f64,
    slope: f64,
    turning: f64,
}

/// The reason why a flow does not reach its end time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoFlow {
    /// The solution escapes to infinity, or beyond the range of `f64`.
    Escapes {
        /// The approximate time of the escape.
        time: f64,
    },
    /// The caller stopped the computation.
    Stopped {
        /// The time that the pieces reached.
        reached: f64,
    },
}

impl std::fmt::Display for NoFlow {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Escapes { time } => write!(f, "the solution escapes to infinity near t = {time}"),
            Self::Stopped { reached } => write!(f, "the solution was followed to t = {reached} only"),
        }
    }
}

impl std::error::Error for NoFlow {}

impl<T: FloatScalar + From<f64> + From<Dd> + Into<Dd>> Flow<T> {
    /// The degree of the polynomial pieces.
    pub const DEGREE: usize = T::TERMS;

    /// Integrates from `start` to the time `end` > 0, and on to `end`·(1 + `beyond`), because the
    /// last step of an orbit may pass `end`. Calls `go_on` before each piece with the number of
    /// pieces so far. If the solution escapes after `end`, the flow ends at `end`.
    ///
    /// A piece costs about 90 evaluations of the bilinear form in `f64`, and 240 in [`Dd`]. The
    /// length of a piece is 0.14 (in `Dd` 0.09) of the distance to the nearest singularity in
    /// complex time.
    ///
    /// # Errors
    /// Returns [`NoFlow`] if the solution escapes before `end`, or if `go_on` returns `false`.
    pub fn through<F, const N: usize>(
        field: &F,
        start: SVector<T, N>,
        end: f64,
        beyond: f64,
        go_on: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Self, NoFlow>
    where
        F: QuadraticField<T, N>,
    {
        let expansion = Expansion::of(field);
        let last = end * (1.0 + beyond);
        let mut flow =
            Self { pieces: Vec::new(), end: last, measured: N, scale: 0.0, slope: 0.0, turning: 0.0 };
        let (mut t, mut x) = (Dd::from(0.0), start);
        let (mut rate, mut first) = (slope(field, &start), None);
        loop {
            let now = f64::from(t);
            if !go_on(flow.pieces.len()) {
                return Err(NoFlow::Stopped { reached: now });
            }
            let series = expansion.at(x, rate);
            rate = 1.0 / series.radius;
            flow.pieces.push(TaylorPiece::of(&series, t));
            // Steps are of type `f64`, so that the time `t`, their sum, is exact in double-double.
            let step = series.reach().min(2.0 * last);
            // The solution escapes if a value is not finite or the step is very short. Near a pole,
            // each step is a fixed fraction of the time left until the pole.
            if !(x.iter().all(|entry| entry.approximate().is_finite())
                && step > 1e-9 * (now + *first.get_or_insert(step)))
            {
                if now >= end {
                    flow.end = end;
                    break;
                }
                return Err(NoFlow::Escapes { time: now + if step > 0.0 { series.radius } else { 0.0 } });
            }
            if now <= end {
                flow.scale = flow.scale.max(norm(&x));
                flow.slope = flow.slope.max(slope(field, &x));
                flow.turning += series.turning * step.min(end - now);
            }
            if now <= end && now + step >= end {
                flow.scale = flow.scale.max(norm(&series.value((Dd::from(end) - t).into())));
            }
            if now + step >= last {
                break;
            }
            x = series.value(step.into());
            t += Dd::from(step);
        }
        if flow.scale == 0.0 {
            flow.scale = 1.0;
        }
        Ok(flow)
    }

    /// Uses only the first `variables` variables for distances and for the scale. The scale becomes
    /// their largest absolute value up to the time `end`.
    #[must_use]
    pub fn of_first(self, variables: usize, end: f64) -> Self {
        let size = |t: f64| {
            let sizes = self.at(Dd::from(t)).into_iter().take(variables);
            sizes.map(|entry| entry.approximate().abs()).fold(0.0, f64::max)
        };
        let scale = self.breaks().filter(|t| *t < end).chain([end]).map(size).fold(0.0, f64::max);
        Self { measured: variables, scale: if scale > 0.0 { scale } else { 1.0 }, ..self }
    }

    /// Returns the time at which the last piece ends.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Returns the scale of relative errors: the largest |xᵢ(t)| over all components, up to the
    /// requested end.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Returns max ‖f′(x(t))‖∞, the inverse of the shortest time scale along the solution.
    pub fn slope(&self) -> f64 {
        self.slope
    }

    /// Returns ∫ ‖ẍ‖∞/‖ẋ‖∞ dt, roughly the angle by which the motion turns. Constant components do
    /// not contribute.
    pub fn turning(&self) -> f64 {
        self.turning
    }

    /// Iterates over the start times of the pieces, beginning with 0.
    pub fn breaks(&self) -> impl ExactSizeIterator<Item = f64> {
        self.pieces.iter().map(|piece| piece.start.into())
    }

    /// Returns x(t). Outside of the flow's times, the nearest piece is extrapolated. Each component
    /// costs about 60 operations in [`Dd`], and 36 in `f64`.
    pub fn at(&self, t: Dd) -> Vec<T> {
        let piece = self.piece_at(t);
        let dimension = piece.coefficients.len() / (T::TERMS + 1);
        let mut value = vec![T::zero(); dimension];
        piece.value(t, &mut value);
        value
    }

    /// Returns the distance of a point from x(t) in the maximum norm, relative to the
    /// [`scale`](Self::scale). The distance is infinite if a coordinate is NaN.
    pub fn distance(&self, t: Dd, x: &[Dd]) -> f64 {
        self.measure(self.piece_at(t), t, x, &mut vec![T::zero(); x.len()])
    }

    /// Prepares [`Flow::distance`] for points in N variables at increasing times.
    pub(crate) fn distances<const N: usize>(&self) -> FlowDistance<'_, T, N> {
        FlowDistance { flow: self, piece: 0, value: [T::zero(); N] }
    }

    fn piece_at(&self, t: Dd) -> &TaylorPiece<T> {
        let later = self.pieces.partition_point(|piece| piece.start <= t);
        &self.pieces[later.saturating_sub(1)]
    }

    #[inline(always)]
    fn measure(&self, piece: &TaylorPiece<T>, t: Dd, x: &[Dd], value: &mut [T]) -> f64 {
        piece.value(t, value);
        let apart =
            value.iter().zip(x).take(self.measured).map(|(value, x)| f64::from((*x - (*value).into()).abs()));
        let largest = |far: f64, entry: f64| if entry.is_nan() { f64::INFINITY } else { far.max(entry) };
        apart.fold(0.0, largest) / self.scale
    }
}

/// Computes distances from a flow at increasing times. Later times use the same or a later piece.
#[derive(Debug)]
pub(crate) struct FlowDistance<'a, T, const N: usize> {
    flow: &'a Flow<T>,
    piece: usize,
    value: [T; N],
}

impl<T: SeriesScalar, const N: usize> FlowDistance<'_, T, N> {
    pub(crate) fn distance(&mut self, t: Dd, x: &[Dd; N]) -> f64 {
        let pieces = &self.flow.pieces;
        while pieces.get(self.piece + 1).is_some_and(|next| next.start <= t) {
            self.piece += 1;
        }
        self.flow.measure(&pieces[self.piece], t, x, &mut self.value)
    }
}

/// Returns ‖x‖∞, or infinity if a coordinate is NaN.
pub(crate) fn norm<T: SeriesScalar, const N: usize>(x: &SVector<T, N>) -> f64 {
    let sizes = x.iter().map(|entry| entry.approximate().abs());
    sizes.fold(0.0, |size, entry| if entry.is_nan() { f64::INFINITY } else { entry.max(size) })
}

pub(crate) fn slope<T, F, const N: usize>(field: &F, x: &SVector<T, N>) -> f64
where
    T: SeriesScalar,
    F: QuadraticField<T, N>,
{
    let slopes = field.field_jacobian(x);
    let row = |i: usize| (0..N).map(|j| slopes[(i, j)].approximate().abs()).sum::<f64>();
    (0..N).map(row).fold(0.0, f64::max)
}
