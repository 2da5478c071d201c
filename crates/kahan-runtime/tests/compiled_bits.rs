//! Systems read at run time agree with the macro's code: bit by bit in floats, and exactly over ℚ.

use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_core::{Elimination, ExtendScalars, KahanMap, Pivot, PreparedStep, Scalar};
use kahan_runtime::Field;
use kahan_runtime::interpreted::{Interpreted, round};
use kahan_systems::registry::find;
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};

mod support;
use support::{q, read, samples};

fn same<T: Scalar>(a: &T, b: &T) -> bool {
    let is_number = |value: &T| *value == value.clone();
    a == b || (!is_number(a) && !is_number(b))
}

fn agree<C, T, const N: usize>(name: &str, compiled: &C, interpreted: &Interpreted<T, N>)
where
    C: ExtendScalars<T, N>,
    T: Pivot,
{
    assert_eq!(C::Prepared::COST, interpreted.cost(), "{name}");
    let mut compared = 0;
    for (x, eps) in samples::<T, N>(60) {
        let (left, right) = (compiled.at(eps.clone()), interpreted.at(eps.clone()));
        let quotients = (left.prepared().quotients(&x), right.prepared().quotients(&x));
        let (Some(one), Some(other)) = &quotients else {
            assert!(quotients.0.is_none() && quotients.1.is_none(), "{name}: a pole of one at {x:?}");
            continue;
        };
        compared += 1;
        for i in 0..N {
            assert!(same(&one.numerators[i], &other.numerators[i]), "{name} at {x:?}, {eps:?}");
            let same_reciprocals = match (&one.reciprocals[i], &other.reciprocals[i]) {
                (Some(one), Some(other)) => same(one, other),
                (one, other) => one.is_none() && other.is_none(),
            };
            assert!(same_reciprocals, "{name} at {x:?}, {eps:?}");
        }
        let (next, back) = (left.step(&x), compiled.step_back(&x, eps.clone()));
        assert!(next.iter().zip(right.step(&x).iter()).all(|(a, b)| same(a, b)), "{name}");
        assert!(
            back.iter().zip(interpreted.step_back(&x, eps.clone()).iter()).all(|(a, b)| same(a, b)),
            "{name}"
        );
        assert_eq!(left.try_step(&x).ok(), right.try_step(&x).ok(), "{name}");
        assert_eq!(compiled.field(&x), interpreted.field(&x), "{name}");
        assert_eq!(compiled.field_jacobian(&x), interpreted.field_jacobian(&x), "{name}");
        assert_eq!(compiled.bilinear(&x, &next), interpreted.bilinear(&x, &next), "{name}");
        assert_eq!(compiled.polarized(&x, &next), interpreted.polarized(&x, &next), "{name}");
        assert_eq!(compiled.det_matrix(&x, eps.clone()), interpreted.det_matrix(&x, eps.clone()), "{name}");
        assert_eq!(
            compiled.rational_map(&x, eps.clone()),
            interpreted.rational_map(&x, eps.clone()),
            "{name}"
        );
        let jacobians = (compiled.jacobian(&x, eps.clone()), interpreted.jacobian(&x, eps.clone()));
        assert!(jacobians.0.iter().zip(jacobians.1.iter()).all(|(a, b)| same(a, b)), "{name}");
    }
    assert!(compared > 50, "{name}: {compared} steps");
}

fn agree_everywhere<C, const N: usize>(command: &str, parameters: &[&str], exact: &C)
where
    C: ExtendScalars<BigRational, N>,
{
    let text = find(command).expect("in the catalog").text();
    let parameters: Vec<BigRational> = parameters.iter().map(|text| q(text)).collect();
    let interpreted = read::<N>(text, &parameters);
    agree(command, exact, &interpreted);
    let double = exact.extend_scalars(|p| round::<f64>(&p.clone().into()));
    agree(command, &double, &interpreted.rounded());
    agree(command, &double, &interpreted.extend_scalars(|p| round::<f64>(&p.clone().into())));
    agree(command, &exact.extend_scalars(|p| round::<f32>(&p.clone().into())), &interpreted.rounded());
}

#[test]
fn the_catalog_read_at_run_time_is_the_catalog_compiled() {
    agree_everywhere("euler", &["1/3", "-1.7", "2"], &EulerTop { a1: q("1/3"), a2: q("-1.7"), a3: q("2") });
    agree_everywhere("lv", &[], &LotkaVolterra);
    agree_everywhere("e1", &[], &E1);
    agree_everywhere("e2", &[], &E2);
    agree_everywhere("e3", &[], &E3);
    agree_everywhere("e4", &[], &E4);
    agree_everywhere("e5", &[], &E5);
    agree_everywhere("e6", &[], &E6);
    agree_everywhere("e7", &["19/17"], &E7 { xi: q("19/17") });
    agree_everywhere("e8", &[], &E8);
    agree_everywhere("e9", &["0.1"], &E9 { xi: q("0.1") });
}

#[test]
fn long_constants_are_rounded_once_for_each_scalar() {
    let third = Rational::parse("0.33333333333333333333333333333333333").expect("a number");
    assert_eq!(round::<f64>(&third), 1.0 / 3.0);
    assert_eq!(round::<f32>(&third), 1.0_f32 / 3.0);
    assert_eq!(round::<BigRational>(&third), third.to_big());
    assert_eq!(round::<BigRational>(&Rational::parse("-1e40").expect("a number")), q("-1e40"));

    let field = "xdot = 0.33333333333333333333333333333333333*x*y - 1e-20; ydot = 123456789.987654321*x;";
    let compiled =
        kahan! { xdot = 0.33333333333333333333333333333333333*x*y - 1e-20; ydot = 123456789.987654321*x; };
    let exact = read::<2>(field, &[]);
    agree::<_, f64, 2>("long constants", &compiled, &exact.rounded());
    let compiled =
        kahan! { xdot = 0.33333333333333333333333333333333333*x*y - 1e-20; ydot = 123456789.987654321*x; };
    agree::<_, BigRational, 2>("long constants", &compiled, &exact);
}

/// Returns a field in seven variables, too dense for a step by a straight-line program.
fn beyond_the_budget() -> String {
    let names = ["a", "b", "c", "d", "e", "f", "g"];
    let equation = |i: usize| {
        let terms = (0..7).flat_map(|j| (j..7).map(move |k| (j, k)));
        let terms = terms.map(|(j, k)| format!("{}*{}*{}", (i * 5 + j * 3 + k) % 7 + 1, names[j], names[k]));
        format!("{}dot = {};", names[i], terms.collect::<Vec<_>>().join(" + "))
    };
    (0..7).map(equation).collect()
}

#[test]
fn a_field_beyond_the_budget_obeys_the_defining_equation() {
    let map = read::<7>(&beyond_the_budget(), &[]);
    let (x, eps) = (SVector::from_fn(|i, _| q("1/7") * q(&format!("{}", i + 1))), q("1/100"));
    let next = map.step(&x, eps.clone());
    let increment = map.polarized(&x, &next) * (eps.clone() + eps.clone());
    assert_eq!(next.clone() - x.clone(), increment);
    let (numerators, denominator) = map.rational_map(&x, eps.clone());
    assert_eq!(denominator, map.det_matrix(&x, eps.clone()));
    assert_eq!(numerators, next.clone() * denominator);
    let slopes = map.matrix(&x, eps.clone()) * map.jacobian(&x, eps.clone());
    assert_eq!(slopes, map.matrix(&next, -eps));
}

#[test]
fn integrals_are_the_generated_ones_and_stay() {
    let exact = read::<3>(find("e6").expect("e6").text(), &[]);
    assert_eq!(exact.integral_names().collect::<Vec<_>>(), E6::INTEGRALS);
    assert_eq!(exact.variables(), E6::VARIABLES);
    for (x, eps) in samples::<BigRational, 3>(20) {
        let values: Vec<BigRational> = exact.integrals(&x, &eps).into_iter().flatten().collect();
        assert_eq!(values, E6.integrals(&x, eps.clone()).as_slice());
        let next: Vec<BigRational> =
            exact.integrals(&exact.step(&x, eps.clone()), &eps).into_iter().flatten().collect();
        assert_eq!(values, next);
    }
    let undefined = read::<3>(find("e3").expect("e3").text(), &[]);
    let x = vector![q("0"), q("1"), q("1")];
    assert_eq!(undefined.integrals(&x, &q("1/2"))[0], None, "H = y/x at x = 0");
}

#[test]
fn a_widened_step_is_the_step_over_the_wider_scalar() {
    let map = read::<3>(find("e9").expect("e9").text(), &[q("0.75")]).rounded::<f32>();
    let (x, eps) = (vector![0.5_f32, -0.25, 0.75], 0.125_f32);
    let wide = map.at(eps).prepared().widen(|value| f64::from(*value));
    let wider = map.extend_scalars(|value| f64::from(*value)).at(f64::from(eps));
    assert_eq!(wide.next(&x.map(f64::from)), Some(wider.step(&x.map(f64::from))));
}

#[test]
fn a_field_of_more_variables_than_the_type_has_is_refused() {
    for n in [8, 9] {
        let text: String = (0..n).map(|i| format!("x{i}dot = x{i}^2;")).collect();
        let map = Field::parse(&text).expect("a field").with([("", 0.0); 0]).expect("no parameters");
        match map.as_padded_kahan_map::<f64>() {
            Ok(_) => assert_eq!(n, 8),
            Err(why) => assert!(why.to_string().contains("9 variables"), "{n}: {why}"),
        }
    }
}

/// A field of three variables runs as a map in four or eight; the added variables are constant.
#[test]
fn variables_that_stand_still_change_nothing() {
    for (command, parameters) in [("e1", vec![]), ("e3", vec![]), ("e9", vec![q("0.1")])] {
        stand_still::<f64, 4>(command, &parameters);
        stand_still::<f64, 8>(command, &parameters);
        stand_still::<f32, 4>(command, &parameters);
    }
}

fn stand_still<T: Pivot + Copy, const N: usize>(command: &str, parameters: &[BigRational]) {
    let text = find(command).expect("in the catalog").text();
    let own = read::<3>(text, parameters).rounded::<T>();
    let among = read::<N>(text, parameters).rounded::<T>();
    for (x, eps) in samples::<T, 3>(40) {
        let wide = SVector::<T, N>::from_fn(|i, _| x.get(i).copied().unwrap_or_else(T::zero));
        let same = |next: SVector<T, 3>, wide: SVector<T, N>| {
            assert_eq!(next.as_slice(), &wide.as_slice()[..3], "{command} at {x:?}, {eps:?}");
            assert!(wide.as_slice()[3..].iter().all(T::is_zero), "{command}");
        };
        same(own.step(&x, eps), among.step(&wide, eps));
        let by_elimination = Elimination::new(own.clone(), eps).next(&x).expect("a float has a value");
        same(by_elimination, Elimination::new(among.clone(), eps).next(&wide).expect("the same"));
        same(own.field(&x), among.field(&wide));
        same(own.bilinear(&x, &own.field(&x)), among.bilinear(&wide, &among.field(&wide)));
        same(own.rational_map(&x, eps).0, among.rational_map(&wide, eps).0);
        assert_eq!(own.rational_map(&x, eps).1, among.rational_map(&wide, eps).1, "{command}");
        assert_eq!(own.det_matrix(&x, eps), among.det_matrix(&wide, eps), "{command}");
        match (own.try_step(&x, eps).ok(), among.try_step(&wide, eps).ok()) {
            (Some(next), Some(wide)) => same(next, wide),
            (one, other) => assert!(one.is_none() && other.is_none(), "{command}: a flag of one"),
        }
        let (slopes, wide_slopes) = (own.field_jacobian(&x), among.field_jacobian(&wide));
        assert_eq!(slopes, wide_slopes.fixed_view::<3, 3>(0, 0).into_owned(), "{command}");
    }
}

/// In the catalog's system E1, det A vanishes at 1 + εx = 0, where the reduced map is defined.
#[test]
fn a_removable_pole_has_its_value() {
    let entry = find("e1").expect("the catalog has E1");
    let read = read::<3>(entry.text(), &[]).rounded::<f64>();
    for size in [1.0, 1e-140, 1e140] {
        for x in [-2.0, -2.0_f64.next_up(), -3.0] {
            let (x, eps) = (vector![x * size, 0.75 * size, 0.5], 0.5 / size);
            let compiled = E1.try_step(&x, eps).expect("the reduced map has a value");
            let next = read.try_step(&x, eps).expect("the same for the field that was read");
            assert!((next - compiled).amax() <= 1e-14 * compiled.amax(), "{next:?}, {compiled:?}");
        }
    }
}

/// The reduced map is undefined at these parameters; `try_step` must not panic.
#[test]
fn a_field_that_divides_by_zero_has_no_step() {
    let text = "struct Divided { a, b } xdot = x*y + 1/(a - b); ydot = x - y;";
    let read = read::<2>(text, &[q("2"), q("1")]);
    let step =
        |a: f64, b: f64| read.rounded::<f64>().with_parameters(&[a, b]).try_step(&vector![0.5, 0.25], 0.125);
    assert!(step(2.0, 1.0).is_ok());
    let why = step(1.0, 1.0).expect_err("no field").to_string();
    assert!(why.contains("divides by zero") || why.contains("pole"), "{why}");
}
