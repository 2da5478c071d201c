//! The rotation number of an orbit that is projected to a plane.

use core::f64::consts::TAU;
use core::marker::PhantomData;

use crate::Scalar;

use super::{Extremes, Observer};

/// An observer of the rotation number: the revolutions per step of the orbit projected to a plane.
///
/// The angles between consecutive points are averaged with the weight exp(−1/(t(1 − t))) at the
/// fraction t of the run. On a torus with a smooth angle the average converges faster than any
/// power of the number of steps (S. Das, Y. Saiki, E. Sander, J. A. Yorke, Nonlinearity 30 (2017)
/// 4111). About a hundred revolutions give all digits of `f64`.
///
/// The projected curve should encircle the origin once. For the frequency of one variable, project
/// to the variable and its rate of change, and pass their extremes to [`between`](Self::between).
/// The result is known modulo 1.
///
/// A step costs an arctangent and at most two exponentials.
///
/// ```
/// use kahan_core::observe::Rotation;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// A circle around the origin.
///     pub struct Turn;
///     xdot = -y;
///     ydot = x;
/// }
///
/// let eps = 0.05_f64;
/// let seen = Rotation::of(1000, |x: &[f64]| [x[0], x[1]]);
/// let turns = Turn.orbit(vector![1.0, 0.0], eps).observe(1000, seen);
/// let exact = eps.atan() / std::f64::consts::PI;
/// assert!((turns.value - exact).abs() < 1e-15 && turns.error < 1e-15);
/// ```
#[derive(Clone, Debug)]
pub struct Rotation<F, T> {
    plane: F,
    steps: u64,
    middle: [f64; 2],
    /// For each coordinate, 2 divided by the difference of its extremes.
    units: [f64; 2],
    last: [f64; 2],
    /// The angle from the first point to the second, as seen from `middle`, in revolutions.
    first: f64,
    whole: Mean,
    half: Mean,
    scalar: PhantomData<T>,
}

/// The report of [`Rotation`], NaN without a step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RotationNumber {
    /// The number of revolutions per step, modulo 1, positive from the first axis to the second.
    pub value: f64,
    /// An estimate of the error: the distance of `value` from the mean over the first half of the
    /// run.
    pub error: f64,
}

impl<F: Fn(&[T]) -> [T; 2], T: Scalar> Rotation<F, T> {
    /// Creates an observer of the rotation of the points `plane(x)` around the origin. It averages
    /// over `steps` steps and ignores later points. After fewer steps the result is less accurate.
    pub fn of(steps: u64, plane: F) -> Self {
        let unit = Extremes { least: T::zero() - T::one(), greatest: T::one() };
        Self::between(steps, plane, [unit.clone(), unit])
    }

    /// Creates an observer of the rotation around the centre of the extremes, over `steps` steps.
    /// Both coordinates are divided by half their range, so that the angle grows evenly.
    pub fn between(steps: u64, plane: F, extremes: [Extremes<T>; 2]) -> Self {
        let ends = extremes.map(|Extremes { least, greatest }| [least.approximate(), greatest.approximate()]);
        Self {
            plane,
            steps,
            middle: ends.map(|[least, greatest]| least / 2.0 + greatest / 2.0),
            units: ends.map(|[least, greatest]| 2.0 / (greatest - least)),
            last: [0.0; 2],
            first: 0.0,
            whole: Mean::default(),
            half: Mean::default(),
            scalar: PhantomData,
        }
    }
}

impl<F: Fn(&[T]) -> [T; 2], T: Scalar> Observer<T> for Rotation<F, T> {
    type Report = RotationNumber;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, step: u64, x: &[T]) {
        if step > self.steps {
            return;
        }
        let point = (self.plane)(x);
        let [u, v] = [0, 1].map(|i| (point[i].approximate() - self.middle[i]) * self.units[i]);
        let [from_u, from_v] = core::mem::replace(&mut self.last, [u, v]);
        if step == 0 {
            return;
        }
        let turns = libm::atan2(from_u * v - from_v * u, from_u * u + from_v * v) / TAU;
        if step == 1 {
            self.first = turns;
        }
        let turns = within_half_a_turn(turns, self.first);
        self.whole.add(turns, step, self.steps);
        self.half.add(turns, step, self.steps / 2);
    }

    fn report(self) -> RotationNumber {
        let [whole, half] = [self.whole, self.half].map(|mean| mean.sum / mean.weights);
        RotationNumber { value: whole, error: (whole - half).abs() }
    }
}

/// Returns the angle that equals `turns` modulo 1 revolution and differs from `of` by at most ½.
fn within_half_a_turn(turns: f64, of: f64) -> f64 {
    if turns - of > 0.5 {
        turns - 1.0
    } else if turns - of < -0.5 {
        turns + 1.0
    } else {
        turns
    }
}

/// A mean with weights that vanish smoothly at both ends.
#[derive(Clone, Copy, Debug, Default)]
struct Mean {
    sum: f64,
    weights: f64,
}

impl Mean {
    #[inline]
    fn add(&mut self, value: f64, step: u64, steps: u64) {
        if step <= steps {
            let t = (step as f64 - 0.5) / steps as f64;
            let weight = libm::exp(-1.0 / (t * (1.0 - t)));
            self.sum += weight * value;
            self.weights += weight;
        }
    }
}
