//! What is done with each point of a sweep.
//!
//! In: a plan and the indices of some points. Out: their rows. A row depends on the plan and its
//! index alone, so that it does not matter where, when, and beside what it is computed.

mod exactly;
mod orbit;
mod watch;

use std::fmt;
use std::ops::Range;

use crate::columns::{Column, Entry, Rows, all, chosen};
use crate::plan::{Axis, Plan, Target};

pub(crate) use exactly::{Exactly, Heights, Search};
pub(crate) use orbit::Orbit;
pub(crate) use watch::{WATCHES, Watch};

/// What is done with a point.
#[derive(Clone, Debug)]
pub(crate) enum Task {
    /// An orbit in floats is followed, and observed.
    Orbit(Orbit),
    /// A question is answered in exact numbers.
    Exactly(Exactly),
}

impl Task {
    /// Whether a point has first values of the variables.
    pub(crate) fn has_starts(&self) -> bool {
        !matches!(self, Task::Exactly(Exactly::Search(_)))
    }

    /// Whether it asks for integrals of the field.
    pub(crate) fn needs_integrals(&self) -> bool {
        matches!(self, Task::Orbit(orbit) if orbit.observe.contains(&Watch::Drift))
    }

    /// The columns of what is found.
    pub(crate) fn columns(&self, plan: &Plan) -> Vec<Column> {
        match self {
            Task::Orbit(orbit) => orbit.columns(plan),
            Task::Exactly(exactly) => exactly.columns(plan),
        }
    }
}

impl fmt::Display for Task {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Task::Orbit(orbit) => write!(f, "{orbit:?}"),
            Task::Exactly(exactly) => write!(f, "{exactly:?}"),
        }
    }
}

/// The fewest rows that a thread should take at once.
pub(crate) fn least_rows(plan: &Plan) -> u64 {
    if orbit::are_abreast(plan) { orbit::LANES as u64 } else { 1 }
}

/// The rows of these points, as far as they were made before it was over.
pub(crate) fn rows(plan: &Plan, indices: Range<u64>, is_over: &dyn Fn() -> bool) -> Rows {
    let chosen = chosen(plan);
    let columns = all(plan);
    let mut rows = Rows::of(&chosen.iter().map(|&place| columns[place].clone()).collect::<Vec<_>>());
    let mut put = |index: u64, values: &[f64], found: Vec<Entry>| {
        let mut entries = place(plan, index, values);
        entries.extend(found);
        for (column, &place) in chosen.iter().enumerate() {
            rows.push(column, entries[place].clone());
        }
    };
    match &plan.task {
        Task::Exactly(exactly) => {
            for index in indices.take_while(|_| !is_over()) {
                put(
                    index,
                    &plan.values(index, Axis::double),
                    exactly.entries(plan, &plan.exact_point(index)),
                );
            }
        }
        Task::Orbit(orbit) => {
            let mut follower = orbit::Follower::new(plan);
            let at_once = follower.at_once(orbit);
            let mut next = indices.start;
            while next < indices.end && !is_over() {
                let values = (next..indices.end).take(at_once).map(|index| plan.values(index, Axis::double));
                let mut values: Vec<Vec<f64>> = values.collect();
                let mut points: Vec<_> =
                    values.iter().map(|values| plan.point(values, |value| *value as u32)).collect();
                let same = points.iter().take_while(|point| point.has_the_map_of(&points[0])).count();
                values.truncate(same);
                points.truncate(same);
                let found = follower.follow(orbit, plan, next, &points);
                for (index, (values, found)) in (next..).zip(values.iter().zip(found)) {
                    put(index, values, found);
                }
                next += same as u64;
            }
        }
    }
    rows
}

/// The index, and the values of the axes that vary.
fn place(plan: &Plan, index: u64, values: &[f64]) -> Vec<Entry> {
    let varying = plan.axes.iter().zip(values).filter(|(axis, _)| axis.varies());
    let entries = varying.map(|(axis, &value)| match axis.target {
        Target::Order | Target::Bits => Entry::Integer(value as i64),
        _ => Entry::Double(value),
    });
    [Entry::Integer(index as i64)].into_iter().chain(entries).collect()
}
