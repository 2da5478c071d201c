//! Observation of a group of orbits whose points and tangent vectors advance by machine code.
//!
//! In: maps, points, and observers that do not need every point. Out: points and reports with the
//! bits of single orbits. After the first [`PAUSE`] steps, the code makes up to [`PAUSE`] steps in
//! one call. Observers read the vectors after 2ᵏ steps, at the end, and when a vector becomes too
//! long or short.

use core::array::from_fn;
use std::ops::ControlFlow;

use kahan_core::observe::{GROUP, Group, Observer, PAUSE, are_moderate};

use crate::at::group::{AlignedGroups, MOST, RuntimeGroup};
use crate::{End, MachineFloat, MapAt, RuntimePoint, WhileFinite};

/// The largest number of columns of a group: `MOST` for points and for each of three vectors.
const MOST_COLUMNS: usize = 4 * MOST;

/// Follows a group of orbits by machine code, or does nothing and returns `false`.
pub(super) fn has_carried<T: MachineFloat, O: Observer<T>>(
    maps: [&MapAt<T>; GROUP],
    points: &mut RuntimeGroup<T>,
    observers: &mut [WhileFinite<O>],
    steps: u64,
    tell: &mut dyn FnMut(u64) -> ControlFlow<()>,
) -> bool {
    let first = observers.first_mut().filter(|first| first.bound == f64::MAX && steps > PAUSE);
    let Some(vectors) = first.and_then(|first| Some(first.observers.resumed()?.vectors())) else {
        return false;
    };
    let variables = points.as_ref().len();
    let count = variables * (1 + vectors);
    if count > MOST_COLUMNS {
        return false;
    }
    let Some(code) = MapAt::group_code_with_vectors(maps, (vectors, false), Vec::new()) else { return false };
    if !MapAt::has_observed_group(maps, points, observers, PAUSE, tell) {
        return false;
    }
    let mut columns = AlignedGroups::<T, MOST_COLUMNS>::zeros();
    let columns = &mut columns.0[..count];
    let mut before = AlignedGroups::<T, MOST_COLUMNS>::zeros();
    let before = &mut before.0[..count];
    columns[..variables].copy_from_slice(points.as_ref());
    take_vectors(observers, &mut columns[variables..], variables);
    let mut step = PAUSE;
    while step < steps {
        let now = PAUSE.min(steps - step);
        before.copy_from_slice(columns);
        code.advance(columns, now);
        let are_finite = are_finite(&columns[..variables]);
        for (lane, own) in observers.iter_mut().enumerate() {
            if !are_finite[lane] && own.end == End::Complete {
                resume(own, step, before, lane, variables);
                let mut x: RuntimePoint<T> = before[..variables].iter().map(|column| column[lane]).collect();
                for step in step + 1..=step + now {
                    maps[lane].advance_checked([&mut x, &mut []], 1);
                    own.observe(step, &x);
                }
            }
        }
        step += now;
        let flow = tell(now);
        let is_over = step == steps || flow.is_break();
        if is_over || step.is_power_of_two() || !have_moderate(&columns[variables..], variables) {
            for (lane, own) in observers.iter_mut().enumerate().filter(|(_, own)| own.end == End::Complete) {
                resume(own, step, columns, lane, variables);
            }
            take_vectors(observers, &mut columns[variables..], variables);
        }
        if flow.is_break() {
            break;
        }
    }
    points.as_mut().copy_from_slice(&columns[..variables]);
    true
}

fn take_vectors<T: MachineFloat, O: Observer<T>>(
    observers: &mut [WhileFinite<O>],
    columns: &mut [Group<T>],
    variables: usize,
) {
    let going_on = observers.iter_mut().enumerate().filter(|(_, own)| own.end == End::Complete);
    for (lane, resumed) in going_on.filter_map(|(lane, own)| Some((lane, own.observers.resumed()?))) {
        for (k, vector) in columns.chunks_exact_mut(variables).enumerate() {
            for (column, entry) in vector.iter_mut().zip(resumed.vector(k)) {
                column[lane] = *entry;
            }
        }
    }
}

fn resume<T: MachineFloat, O: Observer<T>>(
    own: &mut WhileFinite<O>,
    step: u64,
    columns: &[Group<T>],
    lane: usize,
    variables: usize,
) {
    let (x, vectors) = columns.split_at(variables);
    let x: RuntimePoint<T> = x.iter().map(|column| column[lane]).collect();
    if let Some(resumed) = own.observers.resumed() {
        resumed.resume(step, &x, &|k, i| vectors[k * variables + i][lane]);
    }
}

fn are_finite<T: MachineFloat>(points: &[Group<T>]) -> [bool; GROUP] {
    let mut all = [true; GROUP];
    for column in points {
        all = from_fn(|lane| all[lane] & (column[lane].approximate().abs() <= f64::MAX));
    }
    all
}

fn have_moderate<T: MachineFloat>(vectors: &[Group<T>], variables: usize) -> bool {
    vectors.chunks_exact(variables).all(|vector| {
        let mut squares = [T::zero(); GROUP];
        for column in vector {
            squares = from_fn(|lane| squares[lane] + column[lane] * column[lane]);
        }
        are_moderate(&[squares])
    })
}
