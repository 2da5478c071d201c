//! Compares every instruction set with plain steps.

use kahan_core::prelude::*;
use kahan_core::{Constant, Ensemble, EnsembleScalar, KahanAt, Level, PreparedStep, Reciprocal};

use crate::ensemble::fused::Fused;
use crate::ensemble::in_lanes::{ByElimination, Clebsch, E3, E5, Logistic};
use crate::ensemble::{assert_same, fuses, levels, points};
use crate::systems::{EulerTop, LotkaVolterra};

/// Numbers of points near multiples of the register width and the tile length.
#[cfg(not(miri))]
const LENGTHS: [usize; 13] = [0, 1, 2, 3, 4, 5, 7, 8, 9, 17, 511, 513, 1000];
#[cfg(not(miri))]
const STEPS: u64 = 7;

#[cfg(miri)]
const LENGTHS: [usize; 3] = [1, 8, 17];
#[cfg(miri)]
const STEPS: u64 = 1;

fn step_each<T: Scalar, M: KahanMap<T, N>, const N: usize>(
    map: &KahanAt<M, T, N>,
    mut points: Vec<SVector<T, N>>,
) -> Vec<SVector<T, N>> {
    for point in &mut points {
        for _ in 0..STEPS {
            *point = map.step(point);
        }
    }
    points
}

/// Steps each point separately, by the formulas of steps in SIMD lanes.
fn step_each_as_lanes<T, M, const N: usize>(
    map: &KahanAt<M, T, N>,
    mut points: Vec<SVector<T, N>>,
) -> Vec<SVector<T, N>>
where
    T: Scalar,
    M: KahanMap<T, N>,
{
    let step = map.prepared().widen(T::clone);
    for point in &mut points {
        for _ in 0..STEPS {
            *point = step.next(point).expect("no pole");
        }
    }
    points
}

/// Compares a map on every instruction set with single steps, over fused floats if the set fuses.
fn compare<F, M, W, const N: usize>(
    map: &KahanAt<M, F, N>,
    fused: &KahanAt<W, Fused<F>, N>,
    round: fn(f64) -> F,
) where
    F: EnsembleScalar,
    Fused<F>: Scalar,
    M: KahanMap<F, N, Prepared: Sync> + Sync,
    W: KahanMap<Fused<F>, N>,
{
    for len in LENGTHS {
        let start: Vec<_> = points(len).into_iter().map(|x: SVector<f64, N>| x.map(round)).collect();
        let each = step_each_as_lanes(map, start.clone());
        let each_fused = step_each_as_lanes(fused, start.iter().map(|x| x.map(Fused)).collect());
        let each_fused: Vec<_> = each_fused.into_iter().map(|x| x.map(|Fused(entry)| entry)).collect();
        for level in levels() {
            let mut ensemble = Ensemble::new(start.clone()).at_level(level).expect("it is available");
            ensemble.advance(map, STEPS);
            assert_same(&ensemble, if fuses(level) { &each_fused } else { &each });
        }
    }
}

macro_rules! every_level_computes_as_single_steps {
    ($($name:ident: $map:expr,)*) => {$(
        #[test]
        fn $name() {
            compare(&$map.at(0.125), &$map.at(Fused(0.125)), |x| x);
            compare(&$map.at(0.125), &$map.at(Fused(0.125)), |x| x as f32);
        }
    )*};
}

every_level_computes_as_single_steps! {
    one_variable: Logistic { rate: ratio(3, 2) },
    two_variables: LotkaVolterra,
    three_variables: E3,
    a_plan_of_its_own_for_lanes: E5,
    with_parameters: EulerTop { a1: ratio(1, 1), a2: ratio(-3, 10), a3: ratio(7, 10) },
    six_variables: Clebsch { w1: ratio(1, 1), w2: ratio(2, 1), w3: ratio(4, 1) },
}

fn ratio<T: Scalar>(p: i64, q: i64) -> T {
    T::constant(&Constant::ratio(p, q))
}

/// Compares ensembles on every instruction set with single steps, for maps without SIMD code.
fn every_level_computes_as<T: EnsembleScalar, M, const N: usize>(
    map: &KahanAt<M, T, N>,
    start: &[SVector<T, N>],
) where
    M: KahanMap<T, N, Prepared: Sync> + Sync,
{
    let each = step_each(map, start.to_vec());
    for level in levels() {
        let mut ensemble = Ensemble::new(start.to_vec()).at_level(level).expect("it is available");
        ensemble.advance(map, STEPS);
        assert_same(&ensemble, &each);
    }
}

#[test]
fn a_map_by_elimination_needs_no_lanes() {
    for len in LENGTHS {
        every_level_computes_as(&ByElimination.at(0.125), &points(len));
    }
}

#[test]
fn any_scalar_that_is_copy_makes_ensembles() {
    for len in LENGTHS {
        let start: Vec<_> = points(len).into_iter().map(|x: SVector<f64, 3>| x.map(Fused)).collect();
        every_level_computes_as(&E3.at(Fused(0.125)), &start);
    }
}

#[test]
#[should_panic(expected = "det A = 0: the Kahan map has a pole at this point")]
fn a_scalar_without_a_reciprocal_of_zero_panics_at_a_pole() {
    // The denominator 1 − ε·rate·(1 − 2x) is 0.
    let mut ensemble = Ensemble::new(vec![vector![Fused(0.5)], vector![Fused(0.0)]]);
    ensemble.advance(&Logistic { rate: Fused(4.0) }.at(Fused(0.25)), 1);
}

#[test]
#[cfg_attr(miri, ignore = "Miri knows no estimate")]
fn an_estimated_reciprocal_changes_avx_512_only_and_little() {
    let map = E3.at(0.125);
    for level in levels() {
        let start = points::<3>(1000);
        let mut divided = Ensemble::new(start).at_level(level).expect("it is available");
        let mut estimated = divided.clone().with_reciprocal(Reciprocal::Estimated);
        divided.advance(&map, 20);
        estimated.advance(&map, 20);
        if level == Level::Avx512 {
            let furthest = divided.points().zip(estimated.points()).map(|(a, b)| (a - b).amax());
            assert!(furthest.fold(0.0, f64::max) < 1e-14);
            assert!(divided != estimated, "the estimate is not used");
        } else {
            assert_eq!(divided, estimated);
        }
    }
}
