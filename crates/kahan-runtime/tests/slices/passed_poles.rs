//! The counts of steps that pass a pole agree with exact arithmetic on the floats of the orbit.

use std::ops::ControlFlow;

use kahan_core::nalgebra::DMatrix;
use kahan_core::{Composition, Scalar};
use kahan_runtime::{
    Field, Follow, MachineFloat, MapAt, Observable, ObservationRequest, ObservedFloat, ObservedValue,
    PassedPoleCount, PassedPoles, Rational,
};

use super::large::{chain, dense};
use super::support::{Random, catalog};

const RICCATI: &str = "xdot = x^2;";

fn map(text: &str, eps: f64) -> MapAt<f64> {
    Field::parse(text).expect("a field").map().expect("no parameters").at(eps)
}

fn passed<T: MachineFloat>(at: &MapAt<T>, start: &[T], steps: u64) -> PassedPoleCount {
    let followed = at.observe(&mut start.to_vec(), steps, PassedPoles::of(at), |_| ControlFlow::Continue(()));
    followed.expect("a number a variable").report
}

fn exactly(steps: u64) -> PassedPoleCount {
    PassedPoleCount { steps, is_lower_bound: false }
}

/// A function that returns the coefficients of the denominator, by powers of ε, at an exact point.
type Denominator = fn(&[Rational]) -> Vec<Rational>;

/// Returns whether Σ cₖtᵏ has a root between 0 and `end`, including `end`.
fn has_root(coefficients: &[Rational], end: &Rational) -> bool {
    let zero = Rational::ZERO;
    let at = |t: &Rational| coefficients.iter().rev().fold(zero.clone(), |sum, c| &(&sum * t) + c);
    let mut open = vec![(zero.clone(), end.clone())];
    while let Some((low, high)) = open.pop() {
        assert!(open.len() < 60, "a double root, or nearly one");
        if at(&high).is_zero() || at(&low).is_negative() != at(&high).is_negative() {
            return true;
        }
        let half = Rational::new(1, 2);
        let (middle, reach) = (&(&low + &high) * &half, (&(&high - &low) * &half).abs());
        let mut slopes = coefficients.to_vec();
        for first in 0..slopes.len() {
            for k in (first + 1..slopes.len()).rev() {
                slopes[k - 1] = &slopes[k - 1] + &(&slopes[k] * &middle);
            }
        }
        let sizes = slopes.iter().skip(1).rev().fold(zero.clone(), |sum, c| &(&sum + &c.abs()) * &reach);
        if slopes[0].abs() <= sizes {
            open.extend([(low, middle.clone()), (middle, high)]);
        }
    }
    false
}

fn of_floats(x: &[f64]) -> Vec<Rational> {
    x.iter().map(|x| Rational::from_f64(*x).expect("finite")).collect()
}

/// Counts an orbit's steps, up to the last finite point, in which a stage passes a root of `d`.
fn counted(kahan: &MapAt<f64>, composition: Composition, d: Denominator, start: &[f64], steps: u64) -> u64 {
    let (mut x, mut count) = (start.to_vec(), 0);
    for _ in 0..steps {
        let mut passes = false;
        for coefficient in composition.coefficients() {
            if !x.iter().all(|x| x.is_finite()) {
                return count;
            }
            let eps = f64::constant(coefficient) * kahan.eps();
            passes |= has_root(&d(&of_floats(&x)), &of_floats(&[eps])[0]);
            kahan.each(&[eps], &[]).expect("one map")[0].advance(&mut x, 1).expect("a number a variable");
        }
        count += u64::from(passes && x.iter().all(|x| x.is_finite()));
    }
    count
}

/// The denominator of Riccati's equation is d = 1 − 2xε.
fn of_riccati(x: &[Rational]) -> Vec<Rational> {
    vec![Rational::ONE, &x[0] * &Rational::from(-2)]
}

fn of_lotka_volterra(x: &[Rational]) -> Vec<Rational> {
    vec![Rational::ONE, &x[1] - &x[0], &(&x[0] + &x[1]) - &Rational::ONE]
}

/// The denominator is det(I − εf′) with f′ = (−y, 2z − x, 2y; 2x, 0, −2z; −2y, z − 2x, y).
fn of_e6(x: &[Rational]) -> Vec<Rational> {
    let [x, y, z] = x else { panic!("{x:?}") };
    let times = |k: i64, a: &Rational, b: &Rational| &(a * b) * &Rational::from(k);
    let minors = &(&times(2, x, x) + &times(3, y, y)) + &(&times(2, z, z) - &times(8, x, z));
    vec![Rational::ONE, Rational::ZERO, minors, times(6, y, &(&times(1, x, x) - &times(1, z, z)))]
}

const EXACT: [(&str, Denominator); 3] = [("riccati", of_riccati), ("lv", of_lotka_volterra), ("e6", of_e6)];

fn of_name(name: &str, eps: f64) -> MapAt<f64> {
    if name == "riccati" { map(RICCATI, eps) } else { catalog(name).map().expect("no parameters").at(eps) }
}

/// In each step 1/x falls by 2ε.
#[test]
fn a_step_that_jumps_over_the_pole_is_counted_once() {
    assert_eq!(passed(&map(RICCATI, 0.07), &[1.0], 7), exactly(0));
    assert_eq!(passed(&map(RICCATI, 0.07), &[1.0], 8), exactly(1));
    assert_eq!(passed(&map(RICCATI, 0.07), &[1.0], 100), exactly(1));
    let single = Field::parse(RICCATI).expect("a field").map().expect("no parameters").at(0.07_f32);
    assert_eq!(passed(&single, &[1.0], 100), exactly(1));
    // Backwards in time the pole is on the other side.
    assert_eq!(passed(&map(RICCATI, -0.07), &[1.0], 100), exactly(0));
    assert_eq!(passed(&map(RICCATI, -0.07), &[-1.0], 100), exactly(1));
    // The tenth step is at the pole, and ends the orbit.
    assert_eq!(passed(&map(RICCATI, 0.05), &[1.0], 11), exactly(0));
    // The solution of ẋ = x² + 1 is tan t, which has 32 poles between t = 0 and t = 100.
    assert_eq!(passed(&map("xdot = x^2 + 1;", 0.05), &[0.0], 1000), exactly(32));
}

#[test]
fn counts_are_those_of_exact_arithmetic_on_the_same_points() {
    let (mut random, mut passes) = (Random(5), 0);
    for (name, d) in EXACT {
        for eps in [0.3, 1.0, -0.7, 4.0] {
            let at = of_name(name, eps);
            let reduced = &at.map().field().derived().map.as_ref().expect("a short map").reduced;
            assert!(reduced.common_factor.as_constant().is_some(), "{name} has removable poles");
            for _ in 0..4 {
                let start = random.point::<f64>(at.map().field().variables().len());
                let count = counted(&at, Composition::KAHAN, d, &start, 12);
                assert_eq!(passed(&at, &start, 12), exactly(count), "{name}: {eps} from {start:?}");
                passes += count;
            }
        }
    }
    assert!(passes > 50, "{passes} poles");
}

#[test]
fn a_composed_step_counts_where_one_of_its_stages_does() {
    let (mut random, mut passes) = (Random(7), 0);
    for (name, d) in EXACT {
        for order in [4, 6, 8] {
            let composition = Composition::of_order(order).expect("an order that there is");
            for eps in [0.2, -0.3] {
                let kahan = of_name(name, eps);
                let at = kahan.composed(composition);
                let start = random.point::<f64>(at.map().field().variables().len());
                let count = counted(&kahan, composition, d, &start, 12);
                assert_eq!(passed(&at, &start, 12), exactly(count), "{name}: {order}, {eps} from {start:?}");
                passes += count;
            }
        }
    }
    assert!(passes > 20, "{passes} poles");
    let kahan = map(RICCATI, 0.1);
    for start in [1.0 / 0.23, -1.0 / 0.05] {
        assert_eq!(passed(&kahan, &[start], 1), exactly(0));
        assert_eq!(passed(&kahan.composed(Composition::TRIPLE_JUMP), &[start], 1), exactly(1));
    }
}

#[test]
fn a_pole_that_is_touched_is_passed_and_one_that_is_missed_is_not() {
    // The denominator (1 − 2εx)² + 4ε²y² has a double root only for y = 0.
    let complex = map("xdot = x^2 - y^2; ydot = 2*x*y;", 0.07);
    assert_eq!(passed(&complex, &[1.0, 0.0], 12), exactly(1));
    assert_eq!(passed(&complex, &[0.1, 0.0], 12), exactly(0));
    for y in [1e-3, 1e-9, 1e-100, 5e-324] {
        assert_eq!(passed(&complex, &[8.0, y], 1), exactly(0), "{y}");
    }
    // The denominator (1 − 2εx)² does not change its sign at its root.
    let square = map("xdot = x^2; ydot = 2*x*y;", 0.07);
    assert_eq!(passed(&square, &[1.0, 3.0], 12), exactly(1));
}

#[test]
fn a_denominator_without_states_has_its_roots_at_every_step_or_at_none() {
    assert_eq!(passed(&map("xdot = y; ydot = 1;", 1e6), &[1.0, 1.0], 9), exactly(0));
    assert_eq!(passed(&map("xdot = y; ydot = -x;", 50.0), &[1.0, 1.0], 9), exactly(0));
    // The denominator is 1 − ε.
    assert_eq!(passed(&map("xdot = x;", 0.99), &[1.0], 9), exactly(0));
    assert_eq!(passed(&map("xdot = x;", 1.5), &[1.0], 9), exactly(9));
    assert_eq!(passed(&map("xdot = x;", -1.5), &[1.0], 9), exactly(0));
    assert_eq!(passed(&map("xdot = x^2;", 0.0), &[1.0], 9), exactly(0));
}

#[test]
fn counts_depend_on_no_unit() {
    let scaled = Field::parse("xdot = x*(1 - k*y); ydot = y*(k*x - 1);").expect("a field");
    let mut random = Random(11);
    let starts: Vec<Vec<f64>> = (0..8).map(|_| random.point(2)).collect();
    let mut passes = 0;
    for start in &starts {
        let count = |power: i32| {
            let unit = 2_f64.powi(power);
            let at = scaled.with([("k", 1.0 / unit)]).expect("its parameter").at(1.0);
            let start: Vec<f64> = start.iter().map(|x| x * unit).collect();
            passed(&at, &start, 12)
        };
        passes += count(0).steps;
        for power in [-600, -300, 40, 300, 600] {
            assert_eq!(count(power), count(0), "2^{power} from {start:?}");
        }
    }
    assert!(passes > 10, "{passes} poles");
}

#[test]
fn beyond_the_budget_the_sign_of_the_determinant_is_a_lower_bound() {
    for text in [dense(7), chain(12)] {
        let field = Field::parse(&text).expect("a field");
        assert!(field.derived().map.is_none());
        let parameters: Vec<_> = field.parameters().iter().map(|name| (name.clone(), 0.25)).collect();
        let at = field.with(parameters).expect("its parameters").at(0.7);
        let (n, mut random, mut passes) = (field.variables().len(), Random(3), 0);
        for _ in 0..10 {
            let start = random.point::<f64>(n);
            let (mut x, mut count) = (start.clone(), 0);
            for _ in 0..5 {
                let mut matrix = vec![0.0; n * n];
                at.matrix(&x, &mut matrix).expect("an entry each");
                count += u64::from(DMatrix::from_row_slice(n, n, &matrix).determinant() < 0.0);
                at.advance(&mut x, 1).expect("a number a variable");
            }
            assert!(x.iter().all(|x| x.is_finite()));
            assert_eq!(passed(&at, &start, 5), PassedPoleCount { steps: count, is_lower_bound: true });
            passes += count;
        }
        assert!((5..45).contains(&passes), "{passes} poles");
        assert_eq!(passed(&at, &vec![0.5; n], 0), exactly(0));
    }
}

#[test]
fn orbits_side_by_side_are_counted_as_each_is_alone() {
    let of = [Observable::PassedPoles, Observable::Last];
    let asked = ObservationRequest {
        of: &of,
        steps: 40,
        renormalize: 10,
        exponents: 1,
        escape: None,
        relations: None,
    };
    let go_on = |_| ControlFlow::Continue(());
    for (name, _) in EXACT {
        let at = of_name(name, 0.4);
        let mut random = Random(13);
        let starts: Vec<Vec<f64>> =
            (0..at.map().field().variables().len()).map(|_| random.point(37)).collect();
        let beside = f64::observe_many(&[&at; 37], &starts, &asked, &go_on).expect("columns that fit");
        for (orbit, beside) in beside.iter().enumerate() {
            let start: Vec<f64> = starts.iter().map(|column| column[orbit]).collect();
            let single = f64::observe_one(None, &at, &start, &asked, &go_on).expect("a number a variable");
            assert_eq!(format!("{beside:?}"), format!("{single:?}"), "{name}: orbit {orbit}");
            let ObservedValue::Passed(found) = single.report[0] else { panic!("{single:?}") };
            assert_eq!(found, passed(&at, &start, 40));
        }
    }
}
