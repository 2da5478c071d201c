//! Tests that each trajectory of an ensemble has the bits of its own map.

use kahan_core::observe::{Extrema, Lyapunov};
use kahan_core::prelude::*;
use kahan_core::{Advances, Composition, Dd, Ensemble, EnsembleScalar};

use super::levels;
use crate::observe::Lorenz;
use crate::systems::{E6, EulerTop};

kahan! {
    /// A ring of nine variables. Its step uses elimination, and therefore no SIMD lanes.
    struct Nine;
    adot = a*(b - i); bdot = b*(c - a); cdot = c*(d - b); ddot = d*(e - c); edot = e*(f - d);
    fdot = f*(g - e); gdot = g*(h - f); hdot = h*(i - g); idot = i*(a - h);
}

const STEPS: u64 = 23;

fn start<T: Scalar, const N: usize>(k: usize, from: impl Fn(f64) -> T) -> SVector<T, N> {
    SVector::from_fn(|i, _| from(0.5 + 0.25 * i as f64 + 0.01 * k as f64))
}

fn check<S, T, const N: usize>(map: &dyn Fn(usize) -> S, from: fn(f64) -> T)
where
    S: Advances<T, N>,
    [S]: Advances<T, N>,
    T: EnsembleScalar,
{
    for len in [1, 2, 7, 16, 17, 45] {
        let maps: Vec<_> = (0..len).map(map).collect();
        let starts: Vec<SVector<T, N>> = (0..len).map(|k| start(k, from)).collect();
        for level in levels() {
            let mut together = Ensemble::new(starts.clone()).at_level(level).unwrap();
            together.advance(&maps, STEPS);
            for (k, start) in starts.iter().enumerate() {
                let mut alone = Ensemble::new(vec![*start]).at_level(level).unwrap();
                alone.advance(&maps[k], STEPS);
                assert_eq!(together.point(k), alone.point(0), "{k} of {len} on {level:?}");
            }
        }
    }
}

fn eps(k: usize) -> f64 {
    0.001 * (1 + k % 13) as f64
}

#[test]
fn each_trajectory_has_the_bits_of_its_own_map() {
    let lorenz = |k: usize| Lorenz { sigma: 10.0, rho: 20.0 + 0.1 * k as f64, beta: 8.0 / 3.0 };
    check(&|k| lorenz(k).at(eps(k)), |x| x);
    check(&|k| lorenz(k).at(eps(k)).composed(Composition::SUZUKI_4), |x| x);
    // At this small ε, the formulas that divide by ε must not be used.
    check(&|k| lorenz(k).at(if k % 3 == 0 { 1e-30 } else { eps(k) }), |x| x);
    check(&|k| E6.at(eps(k) as f32), |x| x as f32);
    let top =
        |k: usize| EulerTop { a1: Dd::from(1.0), a2: Dd::from(-2.0 + 0.01 * k as f64), a3: Dd::from(1.0) };
    check(&|k| top(k).at(Dd::from(eps(k))), Dd::from);
    check(&|k| Nine.at(eps(k)), |x| x);
    let all = [Composition::SUZUKI_4, Composition::KAHAN_LI_8];
    check(&|k| E6.at(eps(k)).composed(all[k % 2]), |x| x);
}

#[test]
fn what_moves_an_ensemble_is_observed_alike() {
    let maps: Vec<_> = (0..21).map(|k| E6.at(eps(k))).collect();
    let starts: Vec<SVector<f64, 3>> = (0..21).map(|k| start(k, |x| x)).collect();
    let mut ensemble = Ensemble::new(starts.clone());
    let observers = |k: usize| (Extrema::of(|x: &[f64]| x[0]), Lyapunov::new(&maps[k]));
    let reports = ensemble.observe(&maps, STEPS, observers);
    let mut advanced = Ensemble::new(starts.clone());
    advanced.advance(&maps, STEPS);
    assert_eq!(ensemble, advanced);
    for (k, (start, report)) in starts.iter().zip(reports).enumerate() {
        let mut alone = Ensemble::new(vec![*start]);
        let own = alone.observe(&maps[k], STEPS, |_| observers(k));
        assert_eq!(format!("{report:?}"), format!("{:?}", own[0]));
    }
}

#[test]
#[should_panic(expected = "2 maps for 3 points")]
fn as_many_maps_as_points_are_wanted() {
    let maps = [E6.at(0.01), E6.at(0.02)];
    Ensemble::new(vec![vector![1.0, 2.0, 3.0]; 3]).advance(&maps[..], 1);
}
