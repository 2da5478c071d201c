//! Tests every hand-written step against the exact map over ℚ.

use kahan_bench_fields as fields;
use kahan_core::num_traits::ToPrimitive;
use kahan_core::prelude::*;

/// The largest permitted error: half an ulp, and a few roundings of the increment.
const BOUND: f64 = 3.0 * f64::EPSILON;

/// Half the time step, large enough for all powers of ε to matter.
const EPS: f64 = 0.1;

/// Returns points that fill the box (−1, 1)ᴺ.
fn points<const N: usize>() -> impl Iterator<Item = [f64; N]> {
    (1..=200)
        .map(|k| std::array::from_fn(|i| 2.0 * (f64::from(k) * (i as f64 + 2.0).sqrt() * 0.37).fract() - 1.0))
}

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

fn agree<const N: usize>(
    map: impl KahanMap<BigRational, N>,
    eps: f64,
    variants: &[&dyn Fn([f64; N]) -> [f64; N]],
) {
    let at = map.at(exact(eps));
    for x in points::<N>() {
        let next = at.step(&SVector::from(x.map(exact)));
        for (v, variant) in variants.iter().enumerate() {
            for (i, value) in variant(x).into_iter().enumerate() {
                let true_value = next[i].to_f64().expect("a rational near 1");
                let error = (value - true_value).abs() / (1.0 + x[i].abs());
                assert!(error <= BOUND, "variant {v}, component {i} at {x:?}: {value} for {true_value}");
            }
        }
    }
}

#[test]
fn lotka_volterra() {
    use super::lotka_volterra::{fewest_operations, over_time_step, short_chain, two_divisions};
    let (few, short) = (fewest_operations(EPS), short_chain(EPS));
    agree(fields::LotkaVolterra, EPS, &[&few, &short, &two_divisions(EPS), &over_time_step(EPS)]);
}

#[test]
fn euler_top() {
    use super::euler_top::{fewest_operations, short_chain};
    let top = fields::euler_top();
    let map = fields::EulerTop { a1: exact(top.a1), a2: exact(top.a2), a3: exact(top.a3) };
    agree(map, EPS, &[&fewest_operations(top, EPS), &short_chain(top, EPS)]);
}

#[test]
fn e1() {
    use super::e1::{one_reciprocal, over_time_step, three_divisions, two_reciprocals};
    let (one, two) = (one_reciprocal(EPS), two_reciprocals(EPS));
    agree(fields::E1, EPS, &[&one, &two, &three_divisions(EPS), &over_time_step(EPS)]);
}

#[test]
fn e3() {
    use super::e3::{fewest_operations, one_sum_of_squares, over_time_step, short_chain};
    let (few, short) = (fewest_operations(EPS), short_chain(EPS));
    agree(fields::E3, EPS, &[&few, &short, &one_sum_of_squares(EPS), &over_time_step(EPS)]);
}

#[test]
fn e5() {
    use super::e5::{fewest_operations, mixed_divisions, over_time_step, two_reciprocals};
    let (few, two) = (fewest_operations(EPS), two_reciprocals(EPS));
    agree(fields::E5, EPS, &[&few, &two, &mixed_divisions(EPS), &over_time_step(EPS)]);
}

#[test]
fn e6() {
    use super::e6::{fewest_operations, short_chain, shortest_chain};
    agree(fields::E6, EPS, &[&fewest_operations(EPS), &short_chain(EPS), &shortest_chain(EPS)]);
}

/// Since ρ is large, ε must be small, so that ερ creates no poles in the box.
#[test]
fn lorenz() {
    use super::lorenz::{fewest_operations, short_chain};
    let (map, eps) = (fields::lorenz(), EPS / 16.0);
    let exact = fields::Lorenz { sigma: exact(map.sigma), rho: exact(map.rho), beta: exact(map.beta) };
    agree(exact, eps, &[&fewest_operations(map, eps), &short_chain(map, eps)]);
}

#[test]
fn clebsch() {
    use super::clebsch::{m_beside_p, short_chain, skew_part};
    let map = fields::clebsch();
    let exact = fields::Clebsch { w1: exact(map.w1), w2: exact(map.w2), w3: exact(map.w3) };
    agree(exact, EPS, &[&skew_part(map, EPS), &short_chain(map, EPS), &m_beside_p(map, EPS)]);
}
