//! A setting run: every kind of orbit, chosen once before the first step.

use nalgebra::SVector;

use crate::{Composition, Dd, FloatScalar, KahanMap, Lift, ThroughF64};

use super::{Precision, Setting};

/// What to do with an orbit of whatever type, whose points `round` turns back into `f64`.
trait Task<const N: usize> {
    type Output;

    fn run<X>(self, orbit: impl Iterator<Item = X>, round: impl Fn(X) -> SVector<f64, N>) -> Self::Output;
}

/// The point after so many steps.
struct Last(usize);

/// Every point up to so many steps.
struct Each<F>(u64, F);

impl<const N: usize> Task<N> for Last {
    type Output = Option<SVector<f64, N>>;

    fn run<X>(
        self,
        mut orbit: impl Iterator<Item = X>,
        round: impl Fn(X) -> SVector<f64, N>,
    ) -> Self::Output {
        // Not through `Iterator::map`, which would ask for every point.
        orbit.nth(self.0).map(round)
    }
}

impl<F: FnMut(u64, &SVector<f64, N>), const N: usize> Task<N> for Each<F> {
    type Output = ();

    fn run<X>(mut self, orbit: impl Iterator<Item = X>, round: impl Fn(X) -> SVector<f64, N>) {
        for (step, x) in (0..=self.0).zip(orbit) {
            self.1(step, &round(x));
        }
    }
}

impl Setting {
    /// The last point of the orbit that begins with `x0`, at the time 2ε·[`steps`](Self::steps); not finite where the orbit met a
    /// pole.
    ///
    /// Parameters and `x0` are rounded to the setting's precision, the result is rounded or widened to `f64`. It runs as the line
    /// that the setting prints would.
    ///
    /// Cost: as the setting says; no allocation, nothing decided within the orbit.
    pub fn run<M, const N: usize>(&self, map: &M, x0: SVector<f64, N>) -> SVector<f64, N>
    where
        M: Lift<f64, N>,
    {
        let steps = usize::try_from(self.steps).unwrap_or(usize::MAX);
        match self.with_orbit(map, x0, Last(steps)) {
            Some(last) => last,
            // Orbits over floats have no end.
            None => SVector::from_element(f64::NAN),
        }
    }

    /// The same orbit, each of its points shown to `visit` with its number: x₀ as it was rounded with 0, the last with
    /// [`steps`](Self::steps). The n-th belongs to the time 2ε·n.
    pub fn visit<M, const N: usize>(
        &self,
        map: &M,
        x0: SVector<f64, N>,
        visit: impl FnMut(u64, &SVector<f64, N>),
    ) where
        M: Lift<f64, N>,
    {
        self.with_orbit(map, x0, Each(self.steps, visit));
    }

    fn with_orbit<M, K, const N: usize>(&self, map: &M, x0: SVector<f64, N>, task: K) -> K::Output
    where
        M: Lift<f64, N>,
        K: Task<N>,
    {
        let single = |x: f64| x as f32;
        match self.precision {
            Precision::Single => {
                let map = map.lift::<f32>(|parameter| single(*parameter));
                self.with_mode(&map, x0.map(single), single(self.eps), f64::from, task)
            }
            Precision::SingleThroughDouble => {
                let map = ThroughF64(map.lift::<f32>(|parameter| single(*parameter)));
                self.with_mode(&map, x0.map(single), single(self.eps), f64::from, task)
            }
            Precision::Double => self.with_mode(map, x0, self.eps, |x| x, task),
            Precision::DoubleDouble => {
                let map = map.lift::<Dd>(|parameter| Dd::from(*parameter));
                self.with_mode(&map, x0.map(Dd::from), Dd::from(self.eps), f64::from, task)
            }
        }
    }

    fn with_mode<M, T, K, const N: usize>(
        &self,
        map: &M,
        x0: SVector<T, N>,
        eps: T,
        round: impl Fn(T) -> f64,
        task: K,
    ) -> K::Output
    where
        M: KahanMap<T, N>,
        T: FloatScalar,
        K: Task<N>,
    {
        let orbit = map.orbit(x0, eps);
        let round = |x: SVector<T, N>| x.map(&round);
        match (self.composition == Composition::KAHAN, self.compensated) {
            (true, false) => task.run(orbit, round),
            (true, true) => task.run(orbit.compensated(), round),
            (false, false) => task.run(orbit.composed(self.composition), round),
            (false, true) => task.run(orbit.composed(self.composition).compensated(), round),
        }
    }
}
