//! Observing one orbit.

use nalgebra::SVector;

#[cfg(feature = "std")]
use crate::ensemble::lanes::run_alone;
use crate::map::{Accumulation, Sees};
use crate::scalar::Alone;
use crate::{FloatScalar, KahanMap, Method, Orbit, Scalar, Scaled};

use super::Observer;

impl<M, T, K, A, const N: usize> Orbit<M, T, N, K, A>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
    A: Accumulation,
{
    /// Shows the observers the next point of this orbit, x₀, as that of step 0, and the points of
    /// `steps` steps more; then reports.
    ///
    /// The orbit stands at the last of these points afterwards. An exact one that meets a pole ends
    /// there, and [`stopped`](Self::stopped) says so: the reports are of the points before it.
    ///
    /// It allocates nothing. `BENCHMARKS.md` has the times.
    ///
    /// ```
    /// use kahan_core::observe::Escape;
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Growth without limits.
    ///     pub struct Growth;
    ///     xdot = x;
    /// }
    ///
    /// let beyond_two = Escape::when(|x: &[f64]| x[0] > 2.0);
    /// assert_eq!(Growth.orbit(vector![1.0], 0.05).observe(100, beyond_two), Some(7));
    /// ```
    pub fn observe<O: Observer<T>>(&mut self, steps: u64, observers: O) -> O::Report {
        let shown = Shown { orbit: self, steps, observers };
        #[cfg(feature = "std")]
        let observers = run_alone(shown);
        #[cfg(not(feature = "std"))]
        let observers = shown.run();
        observers.report()
    }
}

/// An orbit before its observers.
struct Shown<'a, I, O> {
    orbit: &'a mut I,
    steps: u64,
    observers: O,
}

impl<M, T, K, A, O, const N: usize> Alone for Shown<'_, Orbit<M, T, N, K, A>, O>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
    A: Accumulation,
    O: Observer<T>,
{
    /// The observers, which are moved so that a loop keeps them in registers.
    type Output = O;

    #[inline(always)]
    fn run(self) -> O {
        let Self { orbit, steps, observers } = self;
        let mut seer = Seer(observers);
        orbit.show(steps, &mut seer);
        seer.0
    }
}

/// Observers as an orbit knows them.
struct Seer<O>(O);

impl<T, O: Observer<T>, const N: usize> Sees<T, N> for Seer<O> {
    #[inline(always)]
    fn see(&mut self, step: u64, point: &SVector<T, N>) {
        self.0.observe(step, point.as_slice());
    }
}

impl<M, T, A, const N: usize> Scaled<M, T, N, A>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
    A: Accumulation,
{
    /// As [`Orbit::observe`], of the points that this orbit yields.
    pub fn observe<O: Observer<T>>(&mut self, steps: u64, mut observers: O) -> O::Report {
        for (step, point) in (0..=steps).zip(self) {
            observers.observe(step, point.as_slice());
        }
        observers.report()
    }
}
