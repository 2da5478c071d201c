//! The solution of ẋ = f(x) itself, to measure orbits by.
//!
//! In: a field, a point, a time. Out: x(t) as polynomials, one for each stretch of time, so that it
//! has a value at every time, whatever grid asks. They are Taylor series of high order
//! ([`series`]), whose steps follow the motion: short where it is fast, long where it is slow, ever
//! shorter before a pole. Nothing here knows of Kahan's map, so whatever agrees with a flow shares
//! no mistake with it. Deliberately absent: a bound. How far a flow is from the solution shows in
//! how far it is from a second method.

mod piece;
mod series;

use kahan_core::nalgebra::SVector;

use kahan_core::{Dd, FloatScalar, QuadraticField};

use piece::Piece;
pub(crate) use series::Digits;
use series::Expansion;

/// The solution x(t), 0 ≤ t ≤ [`end`](Self::end), of a quadratic field through a point, computed in
/// T: `f64` or [`Dd`].
///
/// Each piece errs by about T's unit roundoff relative to each component; what the flow then makes
/// of these errors is in x(t).
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_dynamics::Flow;
///
/// kahan! {
///     /// Growth that a pond has room for.
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
    pieces: Vec<Piece<T>>,
    end: f64,
    /// The variables that distances and the scale are of.
    measured: usize,
    scale: f64,
    slope: f64,
    turning: f64,
}

/// Why a flow was not followed to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoFlow {
    /// The solution escapes to infinity, or beyond the range of `f64`.
    Escapes {
        /// When, about.
        time: f64,
    },
    /// The caller wanted no more pieces.
    Stopped {
        /// How far they came.
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
    /// The degree of a piece, whose coefficients are this many and one more for each variable.
    pub const DEGREE: usize = T::TERMS;

    /// Follows the flow from `start` to the time `end`, above 0, and by the part `beyond` of it
    /// further, for orbits that do not end there exactly; where the solution escapes to infinity in
    /// between, nothing is added. Before each piece `go_on` is asked with the number of pieces so
    /// far.
    ///
    /// Cost: a piece takes about 90 evaluations of the bilinear form in `f64`, 240 in [`Dd`]; it is
    /// as long as 0.14 and 0.09 of the distance to the nearest singularity in complex time.
    ///
    /// # Errors
    /// [`NoFlow`].
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
            flow.pieces.push(Piece::of(&series, t));
            // A double, so that the sum of the steps in double-double is exact for long.
            let step = series.reach().min(2.0 * last);
            // Before a pole each step is a part of the way that is left.
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
            // A solution that rests in the origin has errors, and no size.
            flow.scale = 1.0;
        }
        Ok(flow)
    }

    /// The flow with distances and the scale of its first `variables` alone, up to the `end`
    /// that was asked for.
    #[must_use]
    pub fn of_first(self, variables: usize, end: f64) -> Self {
        let size = |t: f64| {
            let sizes = self.at(Dd::from(t)).into_iter().take(variables);
            sizes.map(|entry| entry.approximate().abs()).fold(0.0, f64::max)
        };
        let scale = self.breaks().filter(|t| *t < end).chain([end]).map(size).fold(0.0, f64::max);
        Self { measured: variables, scale: if scale > 0.0 { scale } else { 1.0 }, ..self }
    }

    /// The last time.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The largest |xᵢ(t)|, over all components and times up to the `end` that was asked for: what
    /// errors are relative to.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The largest ‖f′(x(t))‖ in the maximum norm: ε times this tells how coarse a step is.
    pub fn slope(&self) -> f64 {
        self.slope
    }

    /// The integral of ‖ẍ‖/‖ẋ‖ over the time, in the maximum norm: by what angle, so to say, the
    /// motion turns. Unlike the slope it says nothing of directions in which nothing moves.
    pub fn turning(&self) -> f64 {
        self.turning
    }

    /// The times at which pieces begin, the first of them 0: they lie close where the solution
    /// moves fast.
    pub fn breaks(&self) -> impl ExactSizeIterator<Item = f64> {
        self.pieces.iter().map(|piece| piece.start.into())
    }

    /// x(t), the nearest end's polynomial beyond the ends. Cost: about 60 operations a component in
    /// [`Dd`], 36 in `f64`.
    pub fn at(&self, t: Dd) -> Vec<T> {
        let piece = self.piece_at(t);
        let dimension = piece.coefficients.len() / (T::TERMS + 1);
        let mut value = vec![T::zero(); dimension];
        piece.value(t, &mut value);
        value
    }

    /// The distance of a point from x(t) in the maximum norm, relative to the
    /// [`scale`](Self::scale); what is not a number is infinitely far.
    pub fn distance(&self, t: Dd, x: &[Dd]) -> f64 {
        self.measure(self.piece_at(t), t, x, &mut vec![T::zero(); x.len()])
    }

    /// The same for points in N variables whose times grow.
    pub(crate) fn along<const N: usize>(&self) -> Along<'_, T, N> {
        Along { flow: self, piece: 0, value: [T::zero(); N] }
    }

    /// The piece to which time t belongs: the last that begins before it.
    fn piece_at(&self, t: Dd) -> &Piece<T> {
        let later = self.pieces.partition_point(|piece| piece.start <= t);
        &self.pieces[later.saturating_sub(1)]
    }

    #[inline(always)]
    fn measure(&self, piece: &Piece<T>, t: Dd, x: &[Dd], value: &mut [T]) -> f64 {
        piece.value(t, value);
        let apart =
            value.iter().zip(x).take(self.measured).map(|(value, x)| f64::from((*x - (*value).into()).abs()));
        let largest = |far: f64, entry: f64| if entry.is_nan() { f64::INFINITY } else { far.max(entry) };
        apart.fold(0.0, largest) / self.scale
    }
}

/// Distances from a flow at times that grow: no piece is searched for twice, and nothing is
/// allocated.
#[derive(Debug)]
pub(crate) struct Along<'a, T, const N: usize> {
    flow: &'a Flow<T>,
    piece: usize,
    value: [T; N],
}

impl<T: Digits, const N: usize> Along<'_, T, N> {
    /// As [`Flow::distance`].
    pub(crate) fn distance(&mut self, t: Dd, x: &[Dd; N]) -> f64 {
        let pieces = &self.flow.pieces;
        while pieces.get(self.piece + 1).is_some_and(|next| next.start <= t) {
            self.piece += 1;
        }
        self.flow.measure(&pieces[self.piece], t, x, &mut self.value)
    }
}

/// ‖x‖∞; infinite if a coordinate is no number.
pub(crate) fn norm<T: Digits, const N: usize>(x: &SVector<T, N>) -> f64 {
    let sizes = x.iter().map(|entry| entry.approximate().abs());
    sizes.fold(0.0, |size, entry| if entry.is_nan() { f64::INFINITY } else { entry.max(size) })
}

/// ‖f′(x)‖∞
pub(crate) fn slope<T, F, const N: usize>(field: &F, x: &SVector<T, N>) -> f64
where
    T: Digits,
    F: QuadraticField<T, N>,
{
    let slopes = field.field_jacobian(x);
    let row = |i: usize| (0..N).map(|j| slopes[(i, j)].approximate().abs()).sum::<f64>();
    (0..N).map(row).fold(0.0, f64::max)
}
