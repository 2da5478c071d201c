//! Computes orbits with the method, the precision and the ε of a `Setting`.

use kahan_core::nalgebra::SVector;

use kahan_core::{Composition, Dd, ExtendScalars, FloatScalar, KahanMap, ThroughF64};

use super::{Precision, Scheme, Setting};

/// A computation on an orbit of any type. `widen` converts points to `Dd` without rounding.
trait OrbitTask<const N: usize> {
    type Output;

    fn run<X>(self, orbit: impl Iterator<Item = X>, widen: impl Fn(X) -> [Dd; N]) -> Self::Output;
}

struct LastPoint(usize);

struct VisitWhile<F>(u64, F);

impl<const N: usize> OrbitTask<N> for LastPoint {
    type Output = Option<SVector<f64, N>>;

    fn run<X>(self, mut orbit: impl Iterator<Item = X>, widen: impl Fn(X) -> [Dd; N]) -> Self::Output {
        // `nth` comes before the conversion, so that only one point is converted.
        orbit.nth(self.0).map(|x| rounded(&widen(x)))
    }
}

impl<F: FnMut(u64, &[Dd; N]) -> bool, const N: usize> OrbitTask<N> for VisitWhile<F> {
    type Output = ();

    fn run<X>(mut self, orbit: impl Iterator<Item = X>, widen: impl Fn(X) -> [Dd; N]) {
        for (step, x) in (0..=self.0).zip(orbit) {
            if !self.1(step, &widen(x)) {
                break;
            }
        }
    }
}

fn rounded<const N: usize>(x: &[Dd; N]) -> SVector<f64, N> {
    SVector::from(x.map(f64::from))
}

impl Setting {
    /// Returns the last point of the orbit from `x0`, at the time 2ε·[`steps`](Self::steps). The
    /// point is not finite if the orbit met a pole.
    ///
    /// The parameters and `x0` are rounded to the setting's precision, and the result to `f64`. The
    /// orbit allocates nothing.
    pub fn run<M, const N: usize>(&self, map: &M, x0: SVector<f64, N>) -> SVector<f64, N>
    where
        M: ExtendScalars<f64, N>,
    {
        let steps = usize::try_from(self.steps).unwrap_or(usize::MAX);
        match self.with_orbit(map, x0, LastPoint(steps)) {
            Some(last) => last,
            None => SVector::from_element(f64::NAN),
        }
    }

    /// Shows each point of the orbit to `visit` with its index n, from the rounded x₀ to the last
    /// point. Point n is the state at the time 2ε·n.
    pub fn visit<M, const N: usize>(
        &self,
        map: &M,
        x0: SVector<f64, N>,
        mut visit: impl FnMut(u64, &SVector<f64, N>),
    ) where
        M: ExtendScalars<f64, N>,
    {
        self.follow(map, x0, |step, x| {
            visit(step, &rounded(x));
            true
        });
    }

    /// Calls `go_on` with the number and the coordinates of each point, until it returns `false`.
    pub(super) fn follow<M, const N: usize>(
        &self,
        map: &M,
        x0: SVector<f64, N>,
        go_on: impl FnMut(u64, &[Dd; N]) -> bool,
    ) where
        M: ExtendScalars<f64, N>,
    {
        self.with_orbit(map, x0, VisitWhile(self.steps, go_on));
    }

    fn with_orbit<M, K, const N: usize>(&self, map: &M, x0: SVector<f64, N>, task: K) -> K::Output
    where
        M: ExtendScalars<f64, N>,
        K: OrbitTask<N>,
    {
        let single = |x: f64| x as f32;
        match self.scheme.precision {
            Precision::Single => {
                let map = map.extend_scalars::<f32>(|parameter| single(*parameter));
                self.with_mode(&map, x0.map(single), single(self.eps), Dd::from, task)
            }
            Precision::SingleThroughDouble => {
                let map = ThroughF64(map.extend_scalars::<f32>(|parameter| single(*parameter)));
                self.with_mode(&map, x0.map(single), single(self.eps), Dd::from, task)
            }
            Precision::Double => self.with_mode(map, x0, self.eps, Dd::from, task),
            Precision::DoubleDouble => {
                let map = map.extend_scalars::<Dd>(|parameter| Dd::from(*parameter));
                self.with_mode(&map, x0.map(Dd::from), Dd::from(self.eps), |x| x, task)
            }
        }
    }

    fn with_mode<M, T, K, const N: usize>(
        &self,
        map: &M,
        x0: SVector<T, N>,
        eps: T,
        widen: impl Fn(T) -> Dd,
        task: K,
    ) -> K::Output
    where
        M: KahanMap<T, N>,
        T: FloatScalar,
        K: OrbitTask<N>,
    {
        let Scheme { composition, compensated, .. } = self.scheme;
        let orbit = map.orbit(x0, eps);
        let widen = |x: SVector<T, N>| <[T; N]>::from(x).map(&widen);
        match (composition == Composition::KAHAN, compensated) {
            (true, false) => task.run(orbit, widen),
            (true, true) => task.run(orbit.compensated(), widen),
            (false, false) => task.run(orbit.composed(composition), widen),
            (false, true) => task.run(orbit.composed(composition).compensated(), widen),
        }
    }
}
