//! Ensembles against single steps, bit for bit.
//!
//! 1. `levels`: every level, system, width of float and awkward length against plain steps of the
//!    same arithmetic.
//! 2. `neighbours`: what is not finite stays alone; the place of a trajectory and the number of
//!    threads change nothing.
//! 3. `maps`: a map for each trajectory does what it does alone.
//! 4. `contents`: points, columns and grids come back as they were given.
//!
//! What a processor lacks is left out, and the test says so. The same tests run under Miri,
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=x86-64-v4" cargo +nightly miri test -p kahan-core --lib ensemble
//! RUSTFLAGS="-C target-cpu=x86-64-v4" cargo +nightly miri test -p kahan-core-tests ensemble
//! ```
//!
//! where the levels are those of the processor that the flags name, and nothing is estimated.

mod contents;
mod fused;
mod in_lanes;
mod levels;
mod maps;
mod neighbours;

use kahan_core::nalgebra::SVector;
use kahan_core::{Ensemble, EnsembleScalar, Level};

/// The levels of this processor.
fn levels() -> impl Iterator<Item = Level> {
    [Level::Baseline, Level::Avx2, Level::Avx512, Level::Neon].into_iter().filter(|level| {
        if !level.is_available() {
            eprintln!("left out: this processor lacks {level:?}");
        }
        level.is_available()
    })
}

/// Whether multiply-adds on this level are rounded once.
fn fuses(level: Level) -> bool {
    level > Level::Baseline || cfg!(target_feature = "fma")
}

/// `count` points with entries between ½ and 1, all different.
fn points<const N: usize>(count: usize) -> Vec<SVector<f64, N>> {
    (0..count)
        .map(|i| SVector::from_fn(|c, _| 0.5 + ((i * N + c) as f64 * 0.618_033_988_749_895).fract() / 2.0))
        .collect()
}

/// Equal texts: bit for bit, but for one not-a-number from another.
#[track_caller]
fn assert_same<T: EnsembleScalar, const N: usize>(ensemble: &Ensemble<T, N>, expected: &[SVector<T, N>]) {
    assert_eq!(ensemble.len(), expected.len());
    for (i, (point, expected)) in ensemble.points().zip(expected).enumerate() {
        let (text, of_expected) = (format!("{:?}", point.data.0), format!("{:?}", expected.data.0));
        assert_eq!(text, of_expected, "point {i} of {} at {:?}", ensemble.len(), ensemble.level());
    }
}
