//! Observing one orbit.

use nalgebra::SVector;

use crate::map::{Accumulation, Sees};
use crate::{FloatScalar, KahanMap, Method, Orbit, Scalar, Scaled};

use super::section::First;
use super::{Crossing, Direction, Observer, Section};

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
    /// there, and [`stopped`](Self::stopped) says so: the reports are of the points before it. One
    /// whose observers are [done](Observer::is_done) stands at the last point that they saw.
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
        // They are moved, so that the loop keeps them in registers.
        let mut seer = Seer(observers);
        self.show(steps, &mut seer);
        seer.0.report()
    }
}

impl<M, T, K, A, const N: usize> Orbit<M, T, N, K, A>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
    K: Method,
    A: Accumulation,
{
    /// Where this orbit first crosses `level` = 0 within so many steps of its next point, as
    /// [`first_crossing`](super::first_crossing) tells it; the orbit stands at the point after it.
    pub fn first_crossing(
        &mut self,
        steps: u64,
        level: impl Fn(&[T]) -> T,
    ) -> Option<Crossing<SVector<T, N>, T>> {
        let section = Section::new(self.prepared(), level, Direction::Both, First(None));
        self.observe(steps, section)
    }
}

/// Observers as an orbit knows them.
struct Seer<O>(O);

impl<T, O: Observer<T>, const N: usize> Sees<T, N> for Seer<O> {
    #[inline(always)]
    fn see(&mut self, step: u64, point: &SVector<T, N>) {
        self.0.observe(step, point.as_slice());
    }

    #[inline(always)]
    fn is_done(&self) -> bool {
        self.0.is_done()
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
            if observers.is_done() {
                break;
            }
        }
        observers.report()
    }
}
