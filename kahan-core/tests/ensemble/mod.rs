//! Compares ensembles with single steps, bit for bit.
//!
//! # Miri
//! Instruction sets that the processor lacks are skipped with a message. The tests also run under
//! Miri, without estimated reciprocals, on the instruction sets that the flags name:
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=x86-64-v4" cargo +nightly miri test -p kahan-core --lib ensemble
//! RUSTFLAGS="-C target-cpu=x86-64-v4" cargo +nightly miri test -p kahan-core-tests ensemble
//! ```

mod contents;
mod fused;
mod in_lanes;
mod levels;
mod maps;
mod neighbours;

use kahan_core::nalgebra::SVector;
use kahan_core::{Ensemble, EnsembleScalar, Level};

fn levels() -> impl Iterator<Item = Level> {
    [Level::Baseline, Level::Avx2, Level::Avx512, Level::Neon].into_iter().filter(|level| {
        if !level.is_available() {
            eprintln!("left out: this processor lacks {level:?}");
        }
        level.is_available()
    })
}

fn fuses(level: Level) -> bool {
    level > Level::Baseline || cfg!(target_feature = "fma")
}

fn points<const N: usize>(count: usize) -> Vec<SVector<f64, N>> {
    (0..count)
        .map(|i| SVector::from_fn(|c, _| 0.5 + ((i * N + c) as f64 * 0.618_033_988_749_895).fract() / 2.0))
        .collect()
}

/// Compares debug texts, in which all NaNs are equal.
#[track_caller]
fn assert_same<T: EnsembleScalar, const N: usize>(ensemble: &Ensemble<T, N>, expected: &[SVector<T, N>]) {
    assert_eq!(ensemble.len(), expected.len());
    for (i, (point, expected)) in ensemble.points().zip(expected).enumerate() {
        let (text, of_expected) = (format!("{:?}", point.data.0), format!("{:?}", expected.data.0));
        assert_eq!(text, of_expected, "point {i} of {} at {:?}", ensemble.len(), ensemble.level());
    }
}
