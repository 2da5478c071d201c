//! Tests that all ways to take a step yield equal bits.

use kahan_algebra::arithmetic::{Arithmetic, Float32, Float64};
use kahan_algebra::derive;
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_core::Pivot;
use kahan_tests::maps::{every_way, paper_and_random};
use kahan_tests::subject::{Subject, paper, random};

const STEPS: usize = 50;

/// The values of ε at which steps in `f32` (the first two) and `f64` switch to another formula.
const BORDERS: [f32; 4] =
    [1.0 / 65_536.0, 65_536.0, 1.0 / 18_446_744_073_709_551_616.0, 18_446_744_073_709_551_616.0];

fn subjects() -> Vec<Subject> {
    paper().into_iter().chain(random()).collect()
}

fn bits<T: Into<f64> + Copy>(points: &[Vec<T>]) -> Vec<Vec<u64>> {
    let canonical = |entry: &T| {
        let entry: f64 = (*entry).into();
        if entry.is_nan() { f64::NAN.to_bits() } else { entry.to_bits() }
    };
    points.iter().map(|point| point.iter().map(canonical).collect()).collect()
}

fn start(draws: &mut SplitMix64, dimension: usize) -> (Vec<f32>, f32) {
    let mut entry = |scale: f32| (draws.below(2001) as f32 / 1000.0 - 1.0) * scale;
    ((0..dimension).map(|_| entry(2.0)).collect(), entry(0.1))
}

fn every_way_gives_the_same_bits<T: Pivot + Copy + From<f32> + Into<f64>>(seed: u64) {
    for (index, (subject, map)) in subjects().iter().zip(paper_and_random::<T>()).enumerate() {
        let mut draws = SplitMix64::new(seed * 1000 + index as u64);
        for _ in 0..4 {
            let (x, eps) = start(&mut draws, subject.dimension());
            let wide: Vec<T> = x.iter().map(|entry| T::from(*entry)).collect();
            let [by_step, others @ ..] = every_way(map.as_ref(), &wide, T::from(eps), STEPS);
            assert_eq!(by_step.len(), STEPS);
            for (way, other) in ["at(ε).step", "at(ε).orbit", "orbit"].iter().zip(&others) {
                let place = format!("{} by {way}: x = {x:?}, eps = {eps}", subject.name);
                assert_eq!(bits(&by_step), bits(other), "{place}");
            }
        }
    }
}

#[test]
fn every_way_to_step_gives_the_same_bits_in_double_precision() {
    every_way_gives_the_same_bits::<f64>(501);
}

#[test]
fn every_way_to_step_gives_the_same_bits_in_single_precision() {
    every_way_gives_the_same_bits::<f32>(502);
}

/// Targets with fused multiply-adds round a multiply-add once, and the interpreter rounds it twice.
#[cfg_attr(target_feature = "fma", ignore = "this target fuses multiply-adds")]
#[test]
fn the_interpreter_steps_with_the_same_bits() {
    interpreter_agrees(&Float64, 503);
    interpreter_agrees(&Float32, 504);
}

fn interpreter_agrees<A>(arithmetic: &A, seed: u64)
where
    A: Arithmetic<Constant = Rational>,
    A::Value: Pivot + Copy + From<f32> + Into<f64>,
{
    let mut compared = 0;
    for (index, (subject, map)) in subjects().iter().zip(paper_and_random::<A::Value>()).enumerate() {
        let parameter = |value: &kahan_tests::exact::Q| arithmetic.constant(&Rational::from(value.clone()));
        let parameters: Vec<A::Value> = subject
            .parameters
            .iter()
            .map(|value| parameter(value).expect("floats have every constant"))
            .collect();
        if derive(subject.system).map.is_none() {
            continue;
        }
        let interpreter = Interpreter::new(subject.system);
        let mut draws = SplitMix64::new(seed * 1000 + index as u64);
        let (x, eps) = start(&mut draws, subject.dimension());
        for eps in
            [eps].into_iter().chain(BORDERS.into_iter().flat_map(|at| [at.next_down(), at, at.next_up()]))
        {
            let eps = A::Value::from(eps);
            let mut state: Vec<A::Value> = x.iter().map(|entry| A::Value::from(*entry)).collect();
            let [by_step, ..] = every_way(map.as_ref(), &state, eps, STEPS);
            for point in by_step {
                // Compare points until the first one that is not finite.
                let here = Point { state, parameters: parameters.clone(), eps };
                let Some(next) = interpreter
                    .next(arithmetic, &here)
                    .filter(|_| point.iter().all(A::Value::is_finite_number))
                else {
                    break;
                };
                state = next;
                assert_eq!(
                    bits(&[state.clone()]),
                    bits(&[point]),
                    "{}: x = {x:?}, eps = {eps:?}",
                    subject.name
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 13 * 20 * STEPS / 2, "only {compared} steps compared");
}
