//! Tests that projective orbits agree with `kahan poles` and with limits of nearby orbits.
//!
//! The orbits begin at rational points of the curves that a map contracts or sends to infinity.
//! They are compared with ordinary exact orbits from nearby points, and with orbits over `f64`.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::{ExtendScalars, KahanMap, ProjectivePoint};
use kahan_discover::poles::Pattern;
use kahan_discover::{Options, Unwatched, poles};
use kahan_runtime::Field;
use kahan_runtime::interpreted::Interpreted;
use kahan_tests::exact::{Q, q};
use kahan_tests::subject::{Subject, further, paper, random};
use kahan_tests::surface::moved_onto;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

/// The dimension. Systems with fewer variables get additional constant variables.
const N: usize = 4;

type Map = Interpreted<Q, N>;

/// The number of steps computed for a curve whose singularity is never confined.
const STEPS: usize = 4;

/// Returns the first convergent of a continued fraction within `distance` of the number.
fn simplest_near(number: &Q, distance: &Q) -> Q {
    let (mut rest, mut before, mut last) =
        (number.clone(), (BigInt::zero(), BigInt::one()), (BigInt::one(), BigInt::zero()));
    loop {
        let whole = rest.floor().to_integer();
        let next = (&whole * &last.0 + &before.0, &whole * &last.1 + &before.1);
        (before, last) = (last, next);
        let convergent = Q::new(last.0.clone(), last.1.clone());
        if (&convergent - number).abs() <= *distance {
            return convergent;
        }
        rest = (rest - Q::from(whole)).recip();
    }
}

fn bits(point: &ProjectivePoint<Q, N>) -> usize {
    let of = |x: &Q| x.numer().bits().max(x.denom().bits());
    point.coordinates().iter().map(of).max().unwrap_or(0) as usize
}

/// Returns the limit of the n-th points of nearby orbits, and whether the limit is at infinity. A
/// limit at infinity is a direction whose largest coordinate is 1.
fn tends_to(map: &Map, x: &SVector<Q, N>, eps: &Q, n: usize, bits: usize) -> (SVector<Q, N>, bool) {
    let power = |k: usize| Q::new(BigInt::one(), BigInt::one() << k);
    let (delta, near) = (power(6 * bits + 600), power(3 * bits + 100));
    let directions = [q(3, 1), q(-7, 2), q(5, 3), q(1, 1)];
    let moved = SVector::from_fn(|i, _| &x[i] + &delta * &directions[i]);
    let there = map.orbit(moved, eps.clone()).nth(n).expect("no pole at a point that is moved");
    let still = |i: usize| i >= map.variables().len();
    let largest = (0..N).filter(|i| !still(*i)).max_by_key(|&i| there[i].abs()).expect("a variable");
    let is_infinite = there[largest].abs() * &near > Q::one();
    let divisor = if is_infinite { there[largest].clone() } else { Q::one() };
    let limit = |i: usize| {
        if still(i) { Q::zero() } else { simplest_near(&(&there[i] / &divisor), &near) }
    };
    (SVector::from_fn(|i, _| limit(i)), is_infinite)
}

fn point_on(
    pattern: &Pattern,
    symbols: &kahan_algebra::symbols::Symbols,
    eps: &Rational,
    draws: &mut SplitMix64,
) -> Option<Vec<Rational>> {
    const DRAWS: usize = 20;
    let curve = pattern.curve.as_ref()?;
    (0..DRAWS).find_map(|_| {
        let number =
            |draws: &mut SplitMix64| Rational::new(draws.below(97) as i64 - 48, draws.below(7) as i64 + 2);
        let mut values: Vec<Rational> = (0..symbols.dimension()).map(|_| number(draws)).collect();
        values.push(eps.clone());
        let mut values = moved_onto(curve, symbols, values)?;
        values.pop();
        Some(values)
    })
}

/// Asserts that the exact projective orbit from a point agrees with the limits of nearby orbits.
fn follows(name: &str, map: &Map, pattern: &Pattern, x: &[Rational], eps: &Q) {
    let x: SVector<Q, N> = SVector::from_fn(|i, _| x.get(i).map_or_else(Q::zero, Rational::to_big));
    let is_confined = pattern.confined == Some(true);
    let steps = if is_confined { pattern.steps } else { STEPS };
    let mut orbit = map.orbit(x.clone(), eps.clone()).projective();
    assert_eq!(orbit.next(), Some(x.clone().into()));
    for n in 1..=steps {
        let here = || format!("{name}, eps = {eps}, step {n} from {:?}", x.map(|x| x.to_string()));
        let Some(point) = orbit.next() else {
            assert!(!is_confined && n > 1 && orbit.stopped().is_some(), "{}", here());
            return;
        };
        assert_eq!(point.is_infinite(), pattern.images[n - 1].is_infinite, "{}", here());
        let (limit, is_infinite) = tends_to(map, &x, eps, n, bits(&point));
        assert_eq!(point.is_infinite(), is_infinite, "{}", here());
        // Directions agree up to a factor, which is ±1 here.
        let is_same = *point.coordinates() == limit || (is_infinite && *point.coordinates() == -&limit);
        assert!(is_same, "{}: {:?}, not {limit:?}", here(), point);
    }
}

fn follow_all(subject: &Subject, eps: &Rational) -> usize {
    let names = subject.system.field.symbols.parameters.clone();
    let parameters: Vec<(String, Rational)> =
        names.into_iter().zip(subject.parameters.iter().map(|value| value.clone().into())).collect();
    let map = Field::of(subject.system).with(parameters.iter().map(|(name, value)| (name, value)));
    let map: Map = map.expect("a field").as_kahan_map().expect("few variables");
    let options = Options { eps: Some(eps.clone()), parameters, iterates: 2, ..Options::default() };
    let found = match poles(subject.system, &options, 8, &Unwatched) {
        Ok(found) => found,
        Err(_) => return 0,
    };
    let mut draws = SplitMix64::new(7);
    let mut followed = 0;
    for pattern in found.patterns.iter().filter(|pattern| pattern.confined.is_some()) {
        if let Some(x) = point_on(pattern, &found.symbols, eps, &mut draws) {
            eprintln!("{}: {}", subject.name, pattern.name(&found.symbols));
            follows(subject.name, &map, pattern, &x, &eps.to_big());
            floats_follow(subject.name, &map, pattern, &x, &eps.to_big());
            followed += 1;
        }
    }
    followed
}

/// The error bound of projective orbits over `f64`, relative to the largest coordinate.
const BOUND: f64 = 65536.0 * f64::EPSILON / 2.0;

fn floats_follow(name: &str, map: &Map, pattern: &Pattern, x: &[Rational], eps: &Q) {
    let exactly = |value: f64| Q::from_float(value).expect("finite");
    let floats: Interpreted<f64, N> = map.rounded();
    let start: SVector<f64, N> = SVector::from_fn(|i, _| x.get(i).map_or(0.0, Rational::to_f64));
    let eps_float = Rational::from(eps.clone()).to_f64();
    let exact = floats.extend_scalars(|parameter| exactly(*parameter));
    let exact = exact.orbit(start.map(exactly), eps.clone()).projective();
    let found = floats.orbit(start, eps_float).projective();
    let steps = if pattern.confined == Some(true) { pattern.steps } else { STEPS };
    for (n, (found, exact)) in found.zip(exact).enumerate().take(steps + 1) {
        let here = || format!("{name}, eps = {eps}, step {n} from {start:?}: {found:?}");
        assert_eq!(found.is_infinite(), exact.is_infinite(), "{}", here());
        let exact = exact.coordinates().map(|entry| Rational::from(entry).to_f64());
        let error = (found.coordinates() - exact).amax() / exact.amax().max(f64::MIN_POSITIVE);
        assert!(error <= BOUND, "{}, off by {error:e}", here());
    }
}

#[test]
fn an_orbit_through_poles_is_what_moved_orbits_tend_to() {
    let catalog = [paper(), further()].into_iter().flatten().filter(|subject| subject.dimension() <= 3);
    // Numbers on exact orbits of random fields in three variables grow too fast.
    let random = random().into_iter().filter(|subject| subject.dimension() <= 2);
    let eps = Rational::new(1, 2);
    let followed: usize = catalog.chain(random).map(|subject| follow_all(&subject, &eps)).sum();
    assert!(followed > 40, "{followed} curves have rational points");
}
