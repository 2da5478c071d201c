//! Tests `try_step` against exact steps, and compiled fields against run-time fields.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::ExtendScalars;
use kahan_core::prelude::*;
use kahan_runtime::{Field, MachineFloat, ParameterValue};
use num_traits::{FromPrimitive, Signed, ToPrimitive, Zero};

use super::systems::{ARROW, Arrow, CASCADE, Cascade, RING, Ring, WEB, Web};

trait Judged: MachineFloat + ParameterValue + Pivot + ToPrimitive {
    const UNIT: f64;
    /// States are scaled by powers of ten with exponents from −`SIZES` to `SIZES`.
    const SIZES: i32;
    fn near(value: f64) -> Self;
}

impl Judged for f64 {
    const UNIT: f64 = f64::EPSILON / 2.0;
    const SIZES: i32 = 100;
    fn near(value: f64) -> Self {
        value
    }
}

impl Judged for f32 {
    const UNIT: f64 = f32::EPSILON as f64 / 2.0;
    const SIZES: i32 = 12;
    fn near(value: f64) -> Self {
        value as f32
    }
}

fn exact<T: ToPrimitive>(value: &T) -> BigRational {
    BigRational::from_f64(value.to_f64().expect("a float")).expect("finite")
}

/// Returns the largest number of entries in a row of A, at a point where no entry is 0 by chance.
fn widest_row<T: Judged, M: ExtendScalars<T, N>, const N: usize>(map: &M) -> usize {
    let x = SVector::from_fn(|i, _| BigRational::new((i * i + 3).into(), 7.into()));
    let matrix = map.extend_scalars(exact::<T>).matrix(&x, BigRational::new(1.into(), 11.into()));
    let widths = matrix.row_iter().map(|row| row.iter().filter(|entry| !entry.is_zero()).count());
    widths.max().unwrap_or(0)
}

/// Returns maxᵢ |Ax̃ − b|ᵢ/(|A||x̃| + |b|)ᵢ for a computed step x̃.
fn backward_error<T, M, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
    next: &SVector<T, N>,
) -> BigRational
where
    T: Judged,
    M: ExtendScalars<T, N>,
{
    let map = map.extend_scalars(exact::<T>);
    let (x, eps, next) = (x.map(|x| exact(&x)), exact(eps), next.map(|x| exact(&x)));
    let (a, b) = (map.matrix(&x, eps.clone()), map.rhs(&x, eps));
    let mut worst = BigRational::zero();
    for i in 0..N {
        let terms = || (0..N).map(|j| &a[(i, j)] * &next[j]);
        let left: BigRational = terms().sum::<BigRational>() - &b[i];
        let size: BigRational = terms().map(|term| term.abs()).sum::<BigRational>() + b[i].abs();
        assert!(!size.is_zero() || left.is_zero(), "a row of zeros with a residual");
        if !size.is_zero() {
            worst = worst.max(left.abs() / size);
        }
    }
    worst
}

/// Checks `try_step` at points of ordinary and mixed sizes, for ε from 1e-6 to 1e3.
fn keeps_its_promise<T, M, const N: usize>(map: &M, seed: u64, count: usize)
where
    T: Judged,
    M: ExtendScalars<T, N>,
{
    let mut random = SplitMix64::new(seed);
    let mut below = |n: u64| (random.next_u64() % n) as f64;
    let promise = (widest_row(map) as f64 + 8.0) * T::UNIT;
    for trial in 0..count {
        let sizes = [0, 0, T::SIZES / 12, T::SIZES][trial % 4];
        let size = |power: f64| 10_f64.powf(power * f64::from(sizes));
        let x = SVector::<T, N>::from_fn(|_, _| {
            let value = (below(41) - 20.0) / 7.0 * size(below(201) / 100.0 - 1.0);
            T::near(if trial % 3 == 2 && below(4) == 0.0 { 0.0 } else { value })
        });
        let eps = T::near(10_f64.powf(below(91) / 10.0 - 6.0));
        match map.try_step(&x, eps) {
            Ok(next) => {
                let error = backward_error(map, &x, &eps, &next);
                assert!(error.to_f64().expect("a float") <= promise, "{error} at {x:?}, {eps:?}");
            }
            // Steps at extreme points may fail. Steps at ordinary points fail at poles only.
            Err(_) if sizes == T::SIZES => {}
            Err(why) => {
                let determinant =
                    map.extend_scalars(exact::<T>).det_matrix(&x.map(|x| exact(&x)), exact(&eps));
                assert!(determinant.is_zero(), "{why} at {x:?}, {eps:?}");
            }
        }
    }
}

#[test]
fn try_step_promises_a_small_backward_error() {
    keeps_its_promise::<f64, _, 12>(&Ring, 11, 80);
    keeps_its_promise::<f64, _, 11>(&Arrow { a: 0.3 }, 12, 80);
    keeps_its_promise::<f64, _, 10>(&Cascade, 13, 80);
    keeps_its_promise::<f64, _, 18>(&Web, 14, 24);
    keeps_its_promise::<f32, _, 12>(&Ring, 15, 80);
    keeps_its_promise::<f32, _, 10>(&Cascade, 16, 80);
}

#[test]
fn try_step_says_why_there_is_no_step() {
    let start = SVector::<f64, 11>::from_fn(|i, _| if i == 3 { f64::NAN } else { 1.0 });
    let why = Arrow { a: 0.5 }.try_step(&start, 0.1).expect_err("no number");
    assert!(why.to_string().contains("not a finite number"), "{why}");
    // The variable x6 forms a block of A of its own, whose only entry is 1 − εx3.
    let mut start = SVector::<f64, 10>::repeat(1.0);
    (start[3], start[6]) = (2.0, 5.0);
    let why = Cascade.try_step(&start, 0.5).expect_err("a pole");
    assert!(why.determinant() == 0.0 && why.to_string().contains("pole"), "{why}");
}

fn has_the_bits_of_the_field_read_at_run_time<T, M, const N: usize>(
    map: &M,
    text: &str,
    parameters: &[(&str, T)],
) where
    T: Judged,
    M: ExtendScalars<T, N>,
{
    let read = Field::parse(text).expect("a field");
    let read = read.with(parameters.iter().copied()).expect("its parameters");
    let mut random = SplitMix64::new(17);
    for trial in 0..200 {
        let mut below = |n: u64| (random.next_u64() % n) as f64;
        let x = SVector::<T, N>::from_fn(|_, _| T::near((below(41) - 20.0) / 7.0));
        let eps = T::near(10_f64.powf(below(91) / 10.0 - 6.0));
        let at = read.at(eps);
        let mut next = vec![T::zero(); N];
        at.step(x.as_slice(), &mut next).expect("as many variables");
        let compiled = map.step(&x, eps);
        // Printed numbers distinguish signed zeros, but not NaNs from each other.
        let same = |a: &T, b: &T| format!("{a:?}") == format!("{b:?}");
        assert!(next.iter().zip(&compiled).all(|(a, b)| same(a, b)), "{trial}: {x:?}, {eps:?}");
        if trial % 10 == 0 {
            let mut jacobian = vec![T::zero(); N * N];
            at.jacobian(x.as_slice(), &mut jacobian).expect("as many entries");
            let compiled = map.jacobian(&x, eps).transpose();
            assert!(jacobian.iter().zip(&compiled).all(|(a, b)| same(a, b)), "{trial}: {x:?}, {eps:?}");
        }
    }
}

#[test]
fn compiled_steps_have_the_bits_of_tables() {
    has_the_bits_of_the_field_read_at_run_time::<f64, _, 12>(&Ring, RING, &[]);
    has_the_bits_of_the_field_read_at_run_time::<f64, _, 11>(&Arrow { a: 0.3 }, ARROW, &[("a", 0.3)]);
    has_the_bits_of_the_field_read_at_run_time::<f64, _, 10>(&Cascade, CASCADE, &[]);
    has_the_bits_of_the_field_read_at_run_time::<f32, _, 10>(&Cascade, CASCADE, &[]);
    has_the_bits_of_the_field_read_at_run_time::<f64, _, 18>(&Web, WEB, &[]);
}
