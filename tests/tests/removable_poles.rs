//! Tests points with det A = 0. All back ends must return the value of the map in lowest terms, or
//! all must report a pole.

use kahan_algebra::arithmetic::{Exact, Float64};
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_algebra::{Derived, derive};
use kahan_core::ExtendScalars;
use kahan_core::prelude::*;
use kahan_factor::factors;
use kahan_runtime::Field;
use kahan_runtime::heights::HeightsOrbit;
use kahan_runtime::interpreted::Interpreted;
use kahan_systems::registry::find;
use kahan_systems::{E1, E3, E9};
use kahan_tests::expression::read_unproved;
use kahan_tests::surface::moved_onto;

const POINTS: usize = 12;

/// A point at which the map may be undefined, in exact numbers.
struct Place {
    x: Vec<Rational>,
    parameters: Vec<Rational>,
    eps: Rational,
}

fn number(draws: &mut SplitMix64) -> Rational {
    let size = Rational::new(1 + draws.below(9) as i64, 1 + draws.below(4) as i64);
    if draws.below(2) == 0 { size } else { -size }
}

/// Returns points at which the simplest cancelled factor vanishes.
fn removable_poles(derived: &Derived, parameters: &[Rational], seed: u64) -> Vec<Place> {
    let symbols = &derived.system.field.symbols;
    let n = symbols.dimension();
    let common = &derived.map.as_ref().expect("within the budget").reduced.common_factor;
    let factors = factors(common, &mut Budget::new(500, 10_000_000));
    let of_states = |factor: &&Polynomial| factor.variables().iter().any(|v| symbols.is_state(*v));
    let factor = factors.factors.iter().map(|(factor, _)| factor).find(of_states).expect("a common factor");
    let mut draws = SplitMix64::new(seed);
    let mut places = Vec::new();
    while places.len() < POINTS {
        let mut values: Vec<Rational> = (0..n).map(|_| number(&mut draws)).collect();
        values.extend(parameters.iter().cloned().chain([number(&mut draws)]));
        let Some(mut values) = moved_onto(factor, symbols, values) else { continue };
        let eps = values.pop().expect("ε stands last");
        values.truncate(n);
        places.push(Place { x: values, parameters: parameters.to_vec(), eps });
    }
    places
}

fn vector<const N: usize>(x: &[Rational]) -> SVector<BigRational, N> {
    SVector::from_fn(|i, _| x[i].to_big())
}

fn read_at<const N: usize>(system: &System, parameters: &[Rational]) -> Interpreted<BigRational, N> {
    let map = Field::of(system).with(system.field.symbols.parameters.iter().zip(parameters));
    map.expect("a field").as_kahan_map().expect("as many variables")
}

/// Compares generated code with the system read at run time: exact steps, and float steps by bits.
fn compiled_and_read_agree<M, const N: usize>(
    name: &str,
    map: &M,
    read: &Interpreted<BigRational, N>,
    place: &Place,
) where
    M: ExtendScalars<BigRational, N>,
{
    let (x, eps) = (vector::<N>(&place.x), place.eps.to_big());
    assert_eq!(map.det_matrix(&x, eps.clone()), BigRational::from_integer(0.into()), "{name}: det A");
    assert_eq!(
        map.try_step(&x, eps.clone()).ok(),
        read.try_step(&x, eps.clone()).ok(),
        "{name} over ℚ at {x:?}"
    );
    assert_eq!(map.reduced_map(&x, eps.clone()), read.reduced_map(&x, eps.clone()), "{name} at {x:?}");
    if let Ok(next) = map.try_step(&x, eps.clone()) {
        let v = SVector::from_fn(|i, _| BigRational::new((2 * i as i64 - 3).into(), 5.into()));
        let carried = map.at(eps.clone()).tangent().push_forward_to(&x, &next, &v);
        assert_eq!(carried, Some(map.jacobian(&x, eps.clone()) * v), "{name} at {x:?}");
    }
    let float = |value: &BigRational| Rational::from(value.clone()).to_f64();
    let (compiled, interpreted) = (map.extend_scalars(float), read.extend_scalars(float));
    let (near, near_eps) = (x.map(|x| float(&x)), float(&eps));
    for x in [near, near.map(f64::next_up)] {
        let (one, other) = (compiled.try_step(&x, near_eps), interpreted.try_step(&x, near_eps));
        assert_eq!(one.is_ok(), other.is_ok(), "{name} at {x:?}, {near_eps}: {one:?}, {other:?}");
        assert_eq!(one.ok(), other.ok(), "{name} at {x:?}, {near_eps}");
        assert_eq!(compiled.reduced_map(&x, near_eps), interpreted.reduced_map(&x, near_eps), "{name}");
    }
}

/// Returns the step by `try_step`, and checks that the interpreter and `HeightsOrbit` agree.
fn run_time_maps_agree<const N: usize>(name: &str, system: &System, place: &Place) -> Option<Vec<Rational>> {
    let read = read_at::<N>(system, &place.parameters);
    let step = read.try_step(&vector::<N>(&place.x), place.eps.to_big()).ok();
    let step: Option<Vec<Rational>> = step.map(|next| next.iter().cloned().map(Rational::from).collect());
    let point =
        Point { state: place.x.clone(), parameters: place.parameters.clone(), eps: place.eps.clone() };
    assert_eq!(Interpreter::new(system).next(&Exact, &point), step, "{name}, interpreted at {:?}", place.x);
    let mut orbit = HeightsOrbit::new(system, &place.parameters, &place.eps, &place.x).expect("a field");
    let next = orbit.nth(1);
    assert_eq!(next.is_some(), step.is_some(), "{name}, projectively at {:?}", place.x);
    step
}

/// Asserts that all back ends agree, and that the map is defined at a system's removable poles.
fn agree<M, const N: usize>(name: &str, text: &str, parameters: &[i64], map: &M)
where
    M: ExtendScalars<BigRational, N>,
{
    let system = read_unproved(text);
    let parameters: Vec<Rational> = parameters.iter().map(|p| Rational::from(*p)).collect();
    let read = read_at::<N>(&system, &parameters);
    for place in removable_poles(&derive(&system), &parameters, 601) {
        compiled_and_read_agree(name, map, &read, &place);
        let next = run_time_maps_agree::<N>(name, &system, &place);
        assert!(next.is_some(), "{name}: the reduced map has a value at {:?}", place.x);
    }
}

#[test]
fn the_catalog_has_its_values() {
    let text = |name: &str| find(name).expect("a system of the catalog").text();
    agree("e1", text("e1"), &[], &E1);
    agree("e3", text("e3"), &[], &E3);
}

/// E9 at ξ = 1 keeps the factor that E3 cancels, so all back ends must report a pole.
#[test]
fn e9_at_xi_1_has_the_pole_that_e3_loses() {
    let [e3, e9] = ["e3", "e9"].map(|name| read_unproved(find(name).expect("in the catalog").text()));
    let one = Rational::one();
    let map = E9 { xi: one.to_big() };
    let read = read_at::<3>(&e9, core::slice::from_ref(&one));
    for place in removable_poles(&derive(&e3), &[], 602) {
        let place = Place { parameters: vec![one.clone()], ..place };
        compiled_and_read_agree("e9", &map, &read, &place);
        assert_eq!(run_time_maps_agree::<3>("e9", &e9, &place), None, "{:?}", place.x);
    }
}

#[test]
fn fields_in_four_to_six_variables_have_their_values() {
    agree(
        "four",
        "adot = a*(2*z + 1); bdot = b*(2*z + 1); cdot = c*(2*z + 1); zdot = a^2 - b*c + z;",
        &[],
        &kahan! { adot = a*(2*z + 1); bdot = b*(2*z + 1); cdot = c*(2*z + 1); zdot = a^2 - b*c + z; },
    );
    agree(
        "five",
        "adot = -a*z; bdot = -b*z; cdot = -c*z; ddot = -d*z; zdot = a*b + c^2 - d;",
        &[],
        &kahan! { adot = -a*z; bdot = -b*z; cdot = -c*z; ddot = -d*z; zdot = a*b + c^2 - d; },
    );
    agree(
        "six",
        "adot = a*z; bdot = b*z; cdot = c*z; ddot = d*z; edot = e*z; zdot = a^2 + b^2 - c*d + e;",
        &[],
        &kahan! {
            adot = a*z; bdot = b*z; cdot = c*z; ddot = d*z; edot = e*z; zdot = a^2 + b^2 - c*d + e;
        },
    );
}

/// Returns a random field with last variable z. Every other variable x has the equation ẋ = u·x·z,
/// with the same random number u. Therefore the factor 1 − εu·z cancels in the map.
fn random_field(n: usize, draws: &mut SplitMix64) -> String {
    let names = ["a", "b", "c", "d", "e", "f"];
    let (last, u) = (names[n - 1], number(draws));
    let ray: String = names[..n - 1].iter().map(|x| format!("{x}dot = ({u})*{x}*{last}; ")).collect();
    let name = |draws: &mut SplitMix64| names[draws.below(n as u64) as usize];
    let terms: Vec<String> =
        (0..3).map(|_| format!("({})*{}*{}", number(draws), name(draws), name(draws))).collect();
    format!("{ray}{last}dot = {} + ({})*{};", terms.join(" + "), number(draws), name(draws))
}

fn random_fields_agree<const N: usize>(seed: u64) {
    let mut draws = SplitMix64::new(seed);
    for _ in 0..3 {
        let text = random_field(N, &mut draws);
        let system = read_unproved(&text);
        for place in removable_poles(&derive(&system), &[], draws.next_u64()) {
            let next = run_time_maps_agree::<N>(&text, &system, &place);
            assert!(next.is_some(), "{text}: the reduced map has a value at {:?}", place.x);
        }
    }
}

#[test]
fn random_fields_have_their_values() {
    random_fields_agree::<3>(603);
    random_fields_agree::<4>(604);
    random_fields_agree::<5>(605);
    random_fields_agree::<6>(606);
}

/// Interpreters over floats must yield the bits of `step`, even next to a removable pole.
#[test]
fn float_interpreters_agree_beside_removable_poles() {
    let system = read_unproved(find("e3").expect("E3").text());
    let interpreter = Interpreter::new(&system);
    for place in removable_poles(&derive(&system), &[], 607) {
        let (state, eps): (Vec<f64>, f64) =
            (place.x.iter().map(Rational::to_f64).collect(), place.eps.to_f64());
        let compiled = E3.step(&SVector::<f64, 3>::from_column_slice(&state), eps);
        let point = Point { state, parameters: Vec::new(), eps };
        let next = interpreter.next(&Float64, &point).expect("the reduced denominator is not 0 there");
        // Targets with fused multiply-adds round once where the interpreter rounds twice.
        if !cfg!(target_feature = "fma") {
            assert_eq!(next, compiled.as_slice());
        }
    }
}
