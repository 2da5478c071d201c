//! Tests that catalog systems that are read at run time compute the same bits as compiled systems.

use kahan_core::nalgebra::{SMatrix, SVector};
use kahan_core::prelude::*;
use kahan_core::{Composition, ExtendScalars, Integrals};
use kahan_runtime::interpreted::round;
use kahan_runtime::{MachineFloat, Map, ParameterError};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};

use super::support::{Random, assert_same, catalog, number, steps};

fn rows<T: Scalar + Copy, const N: usize>(matrix: &SMatrix<T, N, N>) -> Vec<T> {
    (0..N).flat_map(|i| (0..N).map(move |j| matrix[(i, j)])).collect()
}

fn steps_agree<M, T, const N: usize>(name: &str, compiled: &M, map: &Map)
where
    M: ExtendScalars<T, N>,
    T: MachineFloat,
{
    let mut random = Random(20_261_123);
    for eps in steps::<T>() {
        let (ours, theirs) = (map.at(eps), compiled.at(eps));
        for _ in 0..4 {
            let x = SVector::<T, N>::from_vec(random.point(N));
            let what = format!("{name} at {x:?}, {eps:?}");
            let (mut next, mut entries) = (vec![T::zero(); N], vec![T::zero(); N * N]);
            ours.step(x.as_slice(), &mut next).unwrap();
            assert_same(&next, theirs.step(&x).as_slice(), &what);
            ours.field(x.as_slice(), &mut next).unwrap();
            assert_same(&next, compiled.field(&x).as_slice(), &what);
            ours.field_jacobian(x.as_slice(), &mut entries).unwrap();
            assert_same(&entries, &rows(&compiled.field_jacobian(&x)), &what);
            ours.matrix(x.as_slice(), &mut entries).unwrap();
            assert_same(&entries, &rows(&compiled.matrix(&x, eps)), &what);
            ours.jacobian(x.as_slice(), &mut entries).unwrap();
            assert_same(&entries, &rows(&compiled.jacobian(&x, eps)), &what);
        }
    }
}

fn orbits_agree<M, T, const N: usize>(name: &str, compiled: &M, map: &Map)
where
    M: ExtendScalars<T, N>,
    T: MachineFloat,
{
    let (start, eps) = (SVector::<T, N>::from_vec(Random(7).point(N)), number::<T>(0.01));
    for composition in Composition::ALL {
        let ours = map.at(eps).composed(composition);
        let what = format!("{name}, {composition:?}");
        let mut x = start.as_slice().to_vec();
        ours.advance(&mut x, 300).unwrap();
        let orbit = compiled.orbit(start, eps).composed(composition).nth(300).unwrap();
        assert_same(&x, orbit.as_slice(), &what);

        let (mut x, mut carry) = (start.as_slice().to_vec(), vec![T::zero(); N]);
        for steps in [1, 0, 199, 100] {
            ours.advance_with_carry(&mut x, &mut carry, steps).unwrap();
        }
        let orbit = compiled.orbit(start, eps).composed(composition).compensated().nth(300).unwrap();
        assert_same(&x, orbit.as_slice(), &what);
    }
}

fn agree<C, const N: usize>(command: &str, exact: &C, parameters: &[(&str, BigRational)])
where
    C: ExtendScalars<BigRational, N>,
{
    let map = catalog(command).with(parameters.iter().map(|(name, value)| (name, value))).expect("a map");
    let double = exact.extend_scalars(|value| round::<f64>(&value.clone().into()));
    let single = exact.extend_scalars(|value| round::<f32>(&value.clone().into()));
    steps_agree(command, &double, &map);
    steps_agree(command, &single, &map);
    orbits_agree(command, &double, &map);
    orbits_agree(command, &single, &map);
}

fn q(text: &str) -> BigRational {
    text.parse().expect("a number")
}

#[test]
fn steps_and_orbits_of_the_catalog_are_those_of_compiled_code() {
    let [a1, a2, a3] = ["1/3", "-17/10", "2"].map(q);
    let euler = EulerTop { a1: a1.clone(), a2: a2.clone(), a3: a3.clone() };
    agree("euler", &euler, &[("a3", a3), ("a1", a1), ("a2", a2)]);
    agree("lv", &LotkaVolterra, &[]);
    agree("e1", &E1, &[]);
    agree("e2", &E2, &[]);
    agree("e3", &E3, &[]);
    agree("e4", &E4, &[]);
    agree("e5", &E5, &[]);
    agree("e6", &E6, &[]);
    agree("e7", &E7 { xi: q("19/17") }, &[("xi", q("19/17"))]);
    agree("e8", &E8, &[]);
    agree("e9", &E9 { xi: q("1/10") }, &[("xi", q("1/10"))]);
}

fn claims_agree<T: MachineFloat>() -> Result<(), ParameterError> {
    let (e6, e9) = (catalog("e6").map()?, catalog("e9").with([("xi", 0.75)])?);
    let mut random = Random(3);
    for eps in steps::<T>() {
        let x = SVector::<T, 3>::from_vec(random.point(3));
        let (ours, own) = (e6.at(eps), e9.at(eps));
        let integrals = Integrals::<T, 3, 2>::integrals(&E6, &x, eps);
        let mut values = [T::zero(); 2];
        ours.integrals(x.as_slice(), &mut values).unwrap();
        assert_same(&values, integrals.as_slice(), ("integrals", x, eps));
        assert_same(&[ours.density(x.as_slice()).unwrap()], &[E6.density(&x, eps)], ("density", x, eps));
        let mut tensor = [T::zero(); 9];
        for (name, expected) in [("P", E6.bracket_P(&x, eps)), ("Q", E6.bracket_Q(&x, eps))] {
            ours.bracket(name, x.as_slice(), &mut tensor).unwrap();
            assert_same(&tensor, &rows(&expected), (name, x, eps));
        }
        let compiled = E9 { xi: number::<T>(0.75) };
        assert_same(&[own.density(x.as_slice()).unwrap()], &[compiled.density(&x, eps)], ("e9", x, eps));
    }
    Ok(())
}

#[test]
fn claims_of_the_catalog_are_those_of_compiled_code() {
    claims_agree::<f64>().unwrap();
    claims_agree::<f32>().unwrap();
}
