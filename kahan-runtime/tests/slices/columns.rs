//! Columns are ensembles, and each trajectory of them is the one of its own ε and parameters.

use kahan_core::prelude::*;
use kahan_core::{Composition, Ensemble, EnsembleScalar, Level, Lift};
use kahan_runtime::{Field, MachineFloat, Map};
use kahan_systems::{E3, E6, E9, LotkaVolterra};

use super::support::{Random, assert_same, catalog, number, steps};

/// Numbers of trajectories that fill groups, and that leave some over.
const COUNTS: [usize; 5] = [0, 1, 7, 16, 37];

/// The columns of so many points.
fn columns<T: MachineFloat>(n: usize, count: usize) -> Vec<Vec<T>> {
    let mut random = Random(5);
    (0..n).map(|_| random.point(count)).collect()
}

fn advance<T: MachineFloat>(
    map: &Map,
    (eps, each): (T, &[T]),
    composition: Composition,
    parameters: &[&[T]],
    columns: &mut [Vec<T>],
) {
    let mut slices: Vec<&mut [T]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    map.at(eps).composed(composition).advance_columns(&mut slices, each, parameters, 5).unwrap();
}

fn ensembles_agree<M, T, const N: usize>(name: &str, compiled: &M, map: &Map)
where
    M: Lift<T, N, Prepared: kahan_core::WideStep<T, N> + Sync> + Sync,
    T: MachineFloat + EnsembleScalar,
{
    for (count, eps) in
        COUNTS.into_iter().flat_map(|count| steps::<T>().into_iter().map(move |eps| (count, eps)))
    {
        for composition in [Composition::KAHAN, Composition::KAHAN_LI_6] {
            let start = columns::<T>(N, count);
            let points = (0..count).map(|i| SVector::<T, N>::from_fn(|c, _| start[c][i])).collect();
            let mut ensemble = Ensemble::new(points).at_level(Level::Baseline).expect("everywhere");
            if composition == Composition::KAHAN {
                ensemble.advance(&compiled.at(eps), 5);
            } else {
                ensemble.advance(&compiled.at(eps).composed(composition), 5);
            }
            let mut ours = start;
            advance(map, (eps, &[]), composition, &[], &mut ours);
            for (c, column) in ours.iter().enumerate() {
                assert_same(column, ensemble.column(c), (name, count, eps, composition));
            }
        }
    }
}

#[test]
fn columns_are_ensembles_at_the_baseline() {
    let [lv, e3, e6] = ["lv", "e3", "e6"].map(|name| catalog(name).map().expect("no parameters"));
    let e9 = catalog("e9").with([("xi", 0.75)]).expect("one parameter");
    ensembles_agree::<_, f64, 2>("lv", &LotkaVolterra, &lv);
    ensembles_agree::<_, f32, 2>("lv", &LotkaVolterra, &lv);
    ensembles_agree::<_, f64, 3>("e3", &E3, &e3);
    ensembles_agree::<_, f64, 3>("e6", &E6, &e6);
    ensembles_agree::<_, f32, 3>("e6", &E6, &e6);
    ensembles_agree::<_, f64, 3>("e9", &E9 { xi: 0.75 }, &e9);
    ensembles_agree::<_, f32, 3>("e9", &E9 { xi: 0.75 }, &e9);
}

fn trajectories_are_their_own<T: MachineFloat>(text: &str) {
    let field = Field::parse(text).expect("a field");
    let (n, count) = (field.variables().len(), 21);
    let mut random = Random(17);
    let [a, b] = [0; 2].map(|_| random.point::<T>(count));
    let each: Vec<T> = (0..count).map(|i| steps::<T>()[i % steps::<T>().len()]).collect();
    let start = columns::<T>(n, count);
    let map = field.with([("a", 1), ("b", 2)]).expect("two parameters");
    for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
        let mut together = start.clone();
        advance(&map, (number(0.5), &each), composition, &[&a, &b], &mut together);
        for i in 0..count {
            let exact =
                |value: &T| kahan_algebra::rational::Rational::from_f64(value.approximate()).expect("finite");
            let own = field.with([("a", exact(&a[i])), ("b", exact(&b[i]))]).expect("no zero divides");
            let mut alone: Vec<Vec<T>> = start.iter().map(|column| vec![column[i]]).collect();
            advance(&own, (each[i], &[]), composition, &[], &mut alone);
            let (found, expected): (Vec<T>, Vec<T>) = (0..n).map(|c| (together[c][i], alone[c][0])).unzip();
            assert_same(&found, &expected, (text, i, composition));
        }
    }
}

#[test]
fn a_trajectory_has_the_bits_of_its_own_eps_and_parameters() {
    for text in ["xdot = a*x*y + b; ydot = b*y^2 - x;", "udot = a*u^2 + b;", &super::large::dense(9)] {
        trajectories_are_their_own::<f64>(text);
        trajectories_are_their_own::<f32>(text);
    }
}
