//! A reference trajectory of the flow in double-double.
//!
//! The points of a time grid come from the composition of order 8, and points between these from
//! one more step.

use kahan_core::num_traits::Zero;
use kahan_core::prelude::*;
use kahan_core::{Composition, ExtendScalars};
use kahan_dynamics::Setting;

pub(crate) struct Trajectory<M: ExtendScalars<f64, N>, const N: usize> {
    map: M::Extended<Dd>,
    points: Vec<SVector<Dd, N>>,
    dt: f64,
    scale: f64,
}

const HIGHEST: Composition = Composition::KAHAN_LI_8;

impl<M: ExtendScalars<f64, N>, const N: usize> Trajectory<M, N> {
    /// Creates a trajectory a little beyond the horizon, which orbits with a rounded ε may reach.
    pub(crate) fn new(map: &M, x0: &SVector<f64, N>, horizon: f64, steps: usize) -> Self {
        let map = map.extend_scalars::<Dd>(|parameter| Dd::from(*parameter));
        let dt = horizon / steps as f64;
        let orbit = map.orbit(x0.map(Dd::from), Dd::from(dt / 2.0)).composed(HIGHEST);
        let points: Vec<_> = orbit.take(steps + steps / 64 + 2).collect();
        let scale = points.iter().map(norm).fold(0.0, f64::max);
        Self { map, points, dt, scale }
    }

    /// Returns the largest relative difference from `coarse`, a trajectory with half the steps.
    pub(crate) fn doubt(&self, coarse: &Self) -> f64 {
        let pairs = self.points.iter().step_by(2).zip(&coarse.points);
        pairs.map(|(fine, coarse)| norm(&(fine - coarse)) / self.scale).fold(0.0, f64::max)
    }

    fn at(&self, t: f64) -> SVector<Dd, N> {
        let before = (t / self.dt) as usize;
        let rest = Dd::from(t) - Dd::from(before as f64) * Dd::from(self.dt);
        let eps = rest * Dd::from(0.5);
        if rest.is_zero() {
            self.points[before]
        } else {
            self.map.at(eps).composed(HIGHEST).step(&self.points[before])
        }
    }

    fn distance(&self, t: f64, x: &SVector<f64, N>) -> f64 {
        let distance = norm(&(x.map(Dd::from) - self.at(t))) / self.scale;
        if distance.is_nan() { f64::INFINITY } else { distance }
    }

    /// Returns the largest relative distance between a setting's orbit and this trajectory, at the
    /// end and at about `samples` points. The first distance above `enough` is returned at once.
    pub(crate) fn error(
        &self,
        setting: &Setting,
        map: &M,
        x0: SVector<f64, N>,
        samples: u64,
        enough: f64,
    ) -> f64 {
        let (steps, dt) = (setting.steps(), 2.0 * setting.eps());
        let stride = steps.div_ceil(samples);
        let mut worst = 0.0_f64;
        setting.visit(map, x0, |n, x| {
            if (n % stride == 0 || n == steps) && worst <= enough {
                worst = worst.max(self.distance(n as f64 * dt, x));
            }
        });
        worst
    }
}

fn norm<const N: usize>(x: &SVector<Dd, N>) -> f64 {
    x.iter()
        .map(|entry| f64::from(entry.abs()))
        .fold(0.0, |a, b| if b.is_nan() { f64::NAN } else { a.max(b) })
}
