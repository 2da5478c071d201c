//! A map in two forms: the macro's code, and the field read at run time.

use std::time::Instant;

use kahan_bench_fields::serve::Task;
use kahan_bench_fields::{EPS, Source, block_of};
use kahan_core::prelude::*;
use kahan_runtime::{Field, Map};

/// After this number of steps, a run starts again at the initial state.
pub(crate) const SEGMENT: usize = 1024;

/// A map as the macro's code and as read at run time, and the initial state of the timed orbits.
pub(crate) struct Pair<M, const N: usize> {
    pub(crate) system: &'static str,
    pub(crate) generated: M,
    pub(crate) read: Map,
    pub(crate) start: [f64; N],
}

impl<M: KahanMap<f64, N>, const N: usize> Pair<M, N> {
    /// Reads the map from the text of its block. Panics if the orbits of the two maps differ.
    pub(crate) fn new(source: Source, generated: M, values: &[(&str, f64)], start: [f64; N]) -> Self {
        let text = block_of(source.text).unwrap_or_else(|| panic!("{}: a file without a block", source.name));
        let field = Field::parse(text).unwrap_or_else(|mistakes| panic!("{}: {mistakes}", source.name));
        let read = field.with(values.iter().copied());
        let read = read.unwrap_or_else(|error| panic!("{}: {error}", source.name));
        let at = read.at(EPS);
        assert!(at.is_code(), "{}: this processor has no machine code", source.name);
        let generated_end = generated.orbit(SVector::from(start), EPS).nth(SEGMENT);
        let mut end = start;
        at.advance(&mut end, SEGMENT as u64).expect("as many entries as variables");
        assert_eq!(generated_end, Some(SVector::from(end)), "{}: the same bits", source.name);
        Pair { system: source.name, generated, read, start }
    }
}

/// Makes a task from `run`, which makes the steps of a segment and returns the seconds.
pub(crate) fn in_segments(
    system: &'static str,
    what: &'static str,
    run: impl Fn(usize) -> f64 + 'static,
) -> Task {
    let seconds = Box::new(move |steps: usize| {
        (0..steps).step_by(SEGMENT).map(|done| run(SEGMENT.min(steps - done))).sum()
    });
    Task { system, what, operations: 0, seconds }
}

pub(crate) fn timed(run: impl FnOnce()) -> f64 {
    let begun = Instant::now();
    run();
    begun.elapsed().as_secs_f64()
}
