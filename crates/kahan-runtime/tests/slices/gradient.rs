//! Compares gradients by a reverse sweep with forward-mode derivatives.

use std::num::NonZeroU64;
use std::ops::ControlFlow;

use kahan_core::Dd;
use kahan_runtime::{Composition, End, Field, Gradient, MapAt, Rational, RuntimeFloat, Sensitivity};

use super::derivatives::{Case, fields};
use super::large::{chain, dense};
use super::support::Random;

const GO_ON: fn(u64) -> ControlFlow<()> = |_| ControlFlow::Continue(());

fn larger_fields() -> Vec<Case> {
    let start = |n: usize| (0..n).map(|i| 0.25 + 0.5 / (2.0 + i as f64)).collect::<Vec<f64>>();
    let growing: String = chain(30).replace(" - ", " + a - b*").replace("dot = ", "dot = c + ");
    vec![
        ("xdot = a^2*x^2/(1 + b) - a*b^3;".to_owned(), vec![("a", -0.75), ("b", 0.5)], vec![0.3]),
        (dense(9), vec![("a", 0.25), ("b", 4.5)], vec![0.03; 9]),
        (growing, vec![("a", 0.125), ("b", 0.5), ("c", 0.25)], start(30)),
    ]
}

fn number<T: RuntimeFloat>(value: f64) -> T {
    kahan_runtime::interpreted::round(&Rational::from_f64(value).unwrap())
}

fn carried<T: RuntimeFloat>(at: &MapAt<T>, start: &[T], every: u64, weights: &[T]) -> Gradient<T> {
    let (n, parameters) = (start.len(), at.map().parameters().len());
    let by: Vec<Sensitivity> = (0..parameters)
        .map(Sensitivity::Parameter)
        .chain([Sensitivity::Epsilon])
        .chain((0..n).map(|_| Sensitivity::Start))
        .collect();
    let mut state = start.to_vec();
    state.resize(n * (1 + by.len()), T::zero());
    for i in 0..n {
        state[n * (2 + parameters + i) + i] = T::one();
    }
    let at = at.sensitivities(&by);
    let mut sums = vec![T::zero(); by.len()];
    for (k, weights) in weights.chunks_exact(n).enumerate() {
        at.advance(&mut state, if k == 0 { 0 } else { every }).unwrap();
        for (sum, vector) in sums.iter_mut().zip(state[n..].chunks_exact(n)) {
            vector.iter().zip(weights).for_each(|(slope, weight)| *sum += *slope * *weight);
        }
    }
    let start = sums.split_off(parameters + 1);
    let eps = sums.pop().unwrap();
    Gradient { start, parameters: sums, eps }
}

fn assert_near<T: RuntimeFloat>(own: &Gradient<T>, expected: &Gradient<T>, bound: f64, what: &str) {
    let all = |of: &Gradient<T>| [&of.start[..], &of.parameters, &[of.eps]].concat();
    for (k, (own, expected)) in all(own).into_iter().zip(all(expected)).enumerate() {
        let error = (own - expected).approximate().abs();
        let size = expected.approximate().abs();
        assert!(error <= bound * size, "{what}, {k}: {own:?}, not {expected:?}");
    }
}

fn gradients_are_those_carried_forward<T: RuntimeFloat>(
    cases: Vec<Case>,
    compositions: &[Composition],
    bound: f64,
) {
    let mut random = Random(5);
    for (text, values, start) in cases {
        let map = Field::parse(&text).unwrap().with(values).unwrap();
        let start: Vec<T> = start.into_iter().map(number).collect();
        for &composition in compositions {
            let at = map.at(number::<T>(1.0 / 64.0)).composed(composition);
            for (every, rows) in [(1, 40), (7, 6), (3, 1)] {
                let weights = (0..rows * start.len()).map(|_| f64::from(random.below(63)) / 64.0 + 0.25);
                let weights: Vec<T> = weights.map(number).collect();
                let found = at.gradient(&start, NonZeroU64::new(every).unwrap(), &weights, GO_ON).unwrap();
                assert_eq!(found.end, End::Complete);
                let expected = carried(&at, &start, every, &weights);
                assert_near(&found.report.unwrap(), &expected, bound, &format!("{text} {composition:?}"));
            }
        }
    }
}

#[test]
fn gradients_are_those_of_derivatives_carried_forward() {
    let compositions = [Composition::KAHAN, Composition::SUZUKI_4, Composition::KAHAN_LI_8];
    gradients_are_those_carried_forward::<f64>(fields(), &compositions, 1e-12);
    gradients_are_those_carried_forward::<f64>(larger_fields(), &compositions[..2], 1e-12);
    gradients_are_those_carried_forward::<f32>(fields(), &compositions[..2], 1e-4);
    gradients_are_those_carried_forward::<Dd>(fields(), &compositions[..2], 1e-27);
}

/// At a = ε = 1 the diagonal of A nearly vanishes, so that elimination exchanges rows.
#[test]
fn gradients_of_sparse_fields_are_those_of_differences() {
    let n = 250;
    let neighbour = |i: usize| if i < n { format!("x{i}") } else { "0".to_owned() };
    let equation = |i: usize| {
        let (left, right) = (neighbour(i.wrapping_sub(1)), neighbour(i + 1));
        format!("x{i}dot = a*x{i} + 3*({right} - {left}) - b*x{i}^2;")
    };
    let text: String = (0..n).map(equation).collect();
    let values = [("a", 1.0), ("b", 0.125)];
    let map = Field::parse(&text).unwrap().with(values).unwrap();
    let start: Vec<f64> = (0..n).map(|i| 0.25 + 0.5 / (2.0 + i as f64)).collect();
    let mut random = Random(7);
    for (eps, rows) in [(1.0 / 64.0, 30), (1.0, 3)] {
        let weights: Vec<f64> = (0..rows * n).map(|_| f64::from(random.below(63)) / 64.0).collect();
        let at = map.at(eps);
        let every = NonZeroU64::new(2).unwrap();
        let own = at.gradient(&start, every, &weights, GO_ON).unwrap().report.unwrap();
        let tiny = 2.0_f64.powi(-40);
        let direction: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i % 3 == 0))).collect();
        let loss = |by: usize, sign: f64| {
            let shift = Dd::from(sign * tiny);
            let [a, b] = [0, 1].map(|k| {
                let moved = if by == k {
                    &Rational::new(1, 1 << 40) * &Rational::from(sign as i64)
                } else {
                    Rational::zero()
                };
                &Rational::from_f64(values[k].1).unwrap() + &moved
            });
            let at = Field::parse(&text).unwrap().with([("a", a), ("b", b)]).unwrap();
            let at = at.at(if by == 2 { Dd::from(eps) + shift } else { Dd::from(eps) });
            let moved = |(x, along): (&f64, &f64)| {
                if by == 3 { Dd::from(*x) + shift * Dd::from(*along) } else { Dd::from(*x) }
            };
            let mut x: Vec<Dd> = start.iter().zip(&direction).map(moved).collect();
            let mut sum = Dd::from(0.0);
            for (k, weights) in weights.chunks_exact(n).enumerate() {
                at.advance(&mut x, if k == 0 { 0 } else { 2 }).unwrap();
                x.iter().zip(weights).for_each(|(x, weight)| sum += *x * Dd::from(*weight));
            }
            sum
        };
        let along = own.start.iter().zip(&direction).map(|(slope, along)| slope * along).sum();
        for (k, own) in [own.parameters[0], own.parameters[1], own.eps, along].into_iter().enumerate() {
            let expected = f64::from((loss(k, 1.0) - loss(k, -1.0)) * Dd::from(0.5 / tiny));
            assert!((own - expected).abs() <= 1e-12 * expected.abs(), "{eps} {k}: {own}, not {expected}");
        }
    }
}

/// For ε = 1/2, det A vanishes at z = −2 and is small nearby, but the reduced map is defined there.
#[test]
fn gradients_near_removable_poles_are_those_of_the_reduced_map() {
    let map = super::support::catalog("e3").map().unwrap();
    let eps = 0.5;
    for z in [-2.0, -2.0 + 2.0_f64.powi(-40)] {
        let start = [0.75, 0.5, z];
        let at = map.at(eps);
        let weights = [1.0, 2.0, 3.0];
        let found = at.gradient(&start, NonZeroU64::MIN, &[[0.0; 3], weights].concat(), GO_ON).unwrap();
        let mut jacobian = [0.0; 9];
        at.jacobian(&start, &mut jacobian).unwrap();
        let own = found.report.unwrap();
        for (j, own) in own.start.iter().enumerate() {
            let expected: f64 = (0..3).map(|i| jacobian[3 * i + j] * weights[i]).sum();
            assert!((own - expected).abs() <= 1e-12 * expected.abs(), "{z} {j}: {own}, not {expected}");
        }
    }
}

#[test]
fn gradients_say_what_does_not_fit_and_how_orbits_end() {
    let at = Field::parse("xdot = a*x^2; ydot = -y;").unwrap().with([("a", 1)]).unwrap().at(0.25);
    let error = at.gradient(&[0.5, 1.0], NonZeroU64::MIN, &[1.0; 7], GO_ON).unwrap_err();
    let expected = "the weights have 7 entries; give a multiple of 2, one a variable for each row";
    assert_eq!(error.to_string(), expected);
    let error = at.gradient(&[0.5], NonZeroU64::MIN, &[1.0; 2], GO_ON).unwrap_err();
    assert_eq!(error.to_string(), "the state has 1 entry; give 2, one a variable");
    // From x = 1, each step lowers 1/x by 2ε = 1/2, so the second step meets the pole 1 − 2εx = 0.
    let at_pole = at.gradient(&[1.0, 1.0], NonZeroU64::MIN, &[1.0; 8], GO_ON).unwrap();
    assert_eq!((at_pole.report, at_pole.end), (None, End::Range(1)));
    let none = at.gradient(&[1.0, 1.0], NonZeroU64::MIN, &[], GO_ON).unwrap().report.unwrap();
    assert_eq!(none, Gradient { start: vec![0.0; 2], parameters: vec![0.0], eps: 0.0 });
}

#[test]
fn a_watch_stops_a_sweep() {
    let at = Field::parse("xdot = y; ydot = -x;").unwrap().map().unwrap().at(0.01);
    let every = NonZeroU64::new(50_000).unwrap();
    let weights = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
    let mut told = 0;
    let all = at.gradient(&[1.0, 0.0], every, &weights, |made| {
        told += made;
        ControlFlow::Continue(())
    });
    assert!(all.unwrap().report.is_some());
    assert_eq!(told, 200_000);
    for limit in [30_000, 150_000] {
        let mut told = 0;
        let stopped = at.gradient(&[1.0, 0.0], every, &weights, |made| {
            told += made;
            if told > limit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        let stopped = stopped.unwrap();
        assert!(stopped.report.is_none() && matches!(stopped.end, End::Stopped(_)));
        assert!(told < limit + 10_000);
    }
}
