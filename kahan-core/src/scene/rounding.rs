//! What roundings grow to over a scene, for every kind of number.
//!
//! In: a map, a first point, a composition and an ε at which its orbit is smooth. Out: the distance of each kind's orbit from the
//! orbit of the same steps in double-double: its roundings, those of the parameters and of x₀ among them. What is measured over few
//! steps is continued like a random walk.

use nalgebra::SVector;

use crate::{Composition, Dd, FloatScalar, KahanMap, Lift, ThroughF64, nearest_short_eps};

use super::Precision;
use super::gap::norm;

/// The distances, relative to the largest coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roundings {
    /// Of `f32`, `f32` through `f64`, `f64`: plain, and compensated.
    measured: [[f64; 2]; 3],
    /// The steps of the map over the pilots' time, all stages counted, that they belong to.
    pub(super) stages: f64,
}

impl Roundings {
    /// Measured at so many steps.
    pub(super) fn of<M, const N: usize>(
        map: &M,
        x0: &SVector<f64, N>,
        composition: Composition,
        time: f64,
        steps: u64,
    ) -> Self
    where
        M: Lift<f64, N>,
    {
        // The same in every precision.
        let eps = nearest_short_eps((0.5 * time / steps as f64) as f32);
        let single = map.lift::<f32>(|parameter| *parameter as f32);
        let start = x0.map(|entry| entry as f32);
        let measured = [
            distances(&single, start, eps, f64::from, map, x0, composition, steps),
            distances(&ThroughF64(single.clone()), start, eps, f64::from, map, x0, composition, steps),
            of_double(map, x0, composition, f64::from(eps), steps),
        ];
        Self { measured, stages: steps as f64 * composition.stages() as f64 }
    }

    /// What to expect after so many steps of the map over the pilots' time.
    pub(super) fn expected(&self, precision: Precision, compensated: bool, stages: f64) -> f64 {
        let further = (stages / self.stages).max(1.0).sqrt();
        let [plain, carried] = match precision {
            Precision::Single => self.measured[0],
            Precision::SingleThroughDouble => self.measured[1],
            Precision::Double => self.measured[2],
            Precision::DoubleDouble => {
                let smaller = Precision::DoubleDouble.unit() / Precision::Double.unit();
                self.measured[2].map(|distance| smaller * distance)
            }
        };
        // The carried error of a step is proportional to ε, so a finer ε does not add to it.
        let grown = if compensated { carried } else { plain * further };
        grown.max(precision.unit())
    }
}

/// What roundings come to in `f64` at this very ε: of the plain orbit and of the compensated one.
pub(super) fn of_double<M, const N: usize>(
    map: &M,
    x0: &SVector<f64, N>,
    composition: Composition,
    eps: f64,
    steps: u64,
) -> [f64; 2]
where
    M: Lift<f64, N>,
{
    distances(map, *x0, eps, |x| x, map, x0, composition, steps)
}

/// The largest distances of the plain and of the compensated orbit from that in double-double.
#[expect(clippy::too_many_arguments, reason = "the orbit's four, the same in double-double, and how far")]
fn distances<P, T, M, const N: usize>(
    map: &P,
    start: SVector<T, N>,
    eps: T,
    widen: impl Fn(T) -> f64,
    exact: &M,
    x0: &SVector<f64, N>,
    composition: Composition,
    steps: u64,
) -> [f64; 2]
where
    P: KahanMap<T, N>,
    T: FloatScalar,
    M: Lift<f64, N>,
{
    let wide = exact.lift::<Dd>(|parameter| Dd::from(*parameter));
    let wide = wide.orbit(x0.map(Dd::from), Dd::from(eps.approximate())).composed(composition);
    let plain = map.orbit(start, eps).composed(composition);
    let mut carried = plain.clone().compensated();
    let (mut worst, mut scale) = ([0.0_f64; 2], 0.0_f64);
    for ((_, exact), plain) in (0..=steps).zip(wide).zip(plain) {
        let Some(carried) = carried.next() else { break };
        scale = scale.max(norm(&exact.map(f64::from)));
        for (worst, point) in worst.iter_mut().zip([plain, carried]) {
            let distance: SVector<f64, N> =
                exact.zip_map(&point, |exact, entry| f64::from(exact - Dd::from(widen(entry))));
            *worst = worst.max(norm(&distance));
        }
    }
    worst.map(|distance| if distance > 0.0 { distance / scale } else { 0.0 })
}
