//! Computes the rows of an orbit in blocks, for steps of any kind.

use std::ops::{ControlFlow, Range};

use kahan_algebra::kahan::TERM_BUDGET;
use kahan_core::SingularStep;
use kahan_discover::Watch;
use kahan_runtime::{End, Followed};

use crate::count::WorkCount;
use crate::lifted_step::LiftEnds;
use crate::numbers::{Number, ScalarKind};
use crate::rows::{Column, Ending, Rows, Values};
use crate::study::Study;

use super::Orbit;
use super::maps::PointArithmetic;
use super::row_schedule::RowSchedule;

pub(super) enum EarlyEnd {
    /// The watch stopped the orbit after this number of steps.
    Stopped(u64),
    /// No next point exists, after this number of steps.
    Ended(u64, EndReason),
}

#[derive(Clone, Copy)]
pub(super) enum EndReason {
    /// The matrix A of Kahan's map is singular. If `is_reduced` is false, no reduced formula of the
    /// map is known, and such a formula might give an image.
    Pole { is_reduced: bool },
    /// A stage of a composition has a pole.
    StagePole,
    /// The limit of the projective map depends on the direction of approach.
    NoLimit(Option<SingularStep>),
    /// A step of Kahan's map leaves the range of the scalar.
    Range,
    /// A step of another method leaves the range of the scalar.
    TooLarge,
    /// The solution of the equations becomes infinite before the next step.
    Escapes,
    /// A step of a lifted field fails.
    Lift(LiftEnds),
}

pub(super) trait OrbitPoints<A: PointArithmetic> {
    /// Appends the cells of the point: coordinates, then integrals.
    fn row(&mut self, cells: &mut Vec<A::Cell>);

    /// Advances by `steps` steps, or to the last point.
    fn advance(&mut self, steps: u64, progress: &WorkCount<'_>) -> Result<(), EarlyEnd>;

    /// Appends the cells of `count` rows, each after `every` steps. An [`EarlyEnd`] counts steps
    /// from the call.
    fn rows(
        &mut self,
        every: u64,
        count: usize,
        cells: &mut Vec<A::Cell>,
        progress: &WorkCount<'_>,
    ) -> Result<(), EarlyEnd> {
        for row in 0..count as u64 {
            self.advance(every, progress).map_err(|halt| halt.after(row * every))?;
            self.row(cells);
        }
        Ok(())
    }

    /// Returns the number of rows in a block, which is small so that readers see rows soon.
    fn at_once(&self, _every: u64) -> usize {
        1
    }

    /// Returns the coordinates for a message; empty if these may be infinite, or are too many.
    fn point(&self) -> Vec<Number> {
        Vec::new()
    }

    /// Returns whether float steps of Kahan's map run as machine code; `None` for other steps.
    fn is_code(&self) -> Option<bool> {
        None
    }
}

/// Returns a number of rows of floats that takes some milliseconds to compute.
pub(super) fn rows_in_milliseconds(variables: usize, every: u64) -> usize {
    const MOST: u64 = 1024;
    // The cost of a step is taken to grow with the square of the number of variables.
    let steps = (1 << 20) / (variables as u64).pow(2);
    (steps / every).clamp(1, MOST) as usize
}

pub(super) fn one_by_one(
    steps: u64,
    progress: &WorkCount<'_>,
    mut advance: impl FnMut() -> Result<(), EndReason>,
) -> Result<(), EarlyEnd> {
    for made in 0..steps {
        advance().map_err(|why| EarlyEnd::Ended(made, why))?;
        if progress.tell(1).is_break() && made + 1 < steps {
            return Err(EarlyEnd::Stopped(made + 1));
        }
    }
    Ok(())
}

impl EarlyEnd {
    /// Returns an [`EarlyEnd`] if the orbit did not make all its steps.
    pub(super) fn of<R>(followed: &Followed<R>, why: impl FnOnce() -> EndReason) -> Result<(), Self> {
        match followed.end {
            End::Complete => Ok(()),
            End::Stopped(steps) | End::Time(steps) => Err(EarlyEnd::Stopped(steps)),
            End::Range(steps) | End::Pole(steps) | End::Escaped(steps) | End::Reembed(steps) => {
                Err(EarlyEnd::Ended(steps, why()))
            }
        }
    }

    pub(super) fn after(self, steps: u64) -> Self {
        match self {
            Self::Stopped(more) => Self::Stopped(steps + more),
            Self::Ended(more, why) => Self::Ended(steps + more, why),
        }
    }
}

pub(super) struct OrbitRows<'a, A: PointArithmetic> {
    pub(super) arithmetic: &'a A,
    pub(super) columns: &'a [Column],
    pub(super) eps: A::Value,
    pub(super) paces: RowSchedule,
}

impl<A: PointArithmetic> OrbitRows<'_, A> {
    /// Passes a range of rows to a consumer, in reused blocks. An [`EarlyEnd`] counts steps from
    /// the first point.
    pub(super) fn pass_rows(
        &self,
        points: &mut dyn OrbitPoints<A>,
        range: Range<u64>,
        rows: &mut dyn Rows,
        watch: &dyn Watch,
    ) -> Result<(), EarlyEnd> {
        let (paces, every) = (self.paces, self.paces.every.get());
        let end = range.end.min(paces.rows());
        if range.start >= end {
            return Ok(());
        }
        let progress = WorkCount::new("steps", paces.in_all(), watch);
        let numbers = vec![Vec::new(); self.columns.len() - 2];
        let mut block = CellBlock::<A> { counts: Vec::new(), times: Vec::new(), numbers };
        let (mut cells, mut next, mut gone) = (Vec::new(), range.start, Ok(()));
        points.advance(paces.steps_to(next), &progress)?;
        points.row(&mut cells);
        loop {
            block.fill(self, next, &mut cells);
            next += block.counts.len() as u64;
            let made = paces.steps_to(next - 1);
            if block.pass_rows(self.columns, rows).is_break() {
                return Err(EarlyEnd::Stopped(made));
            }
            gone?;
            if next == end {
                // After the last row, the remaining steps are still made, because they may fail.
                let left = if end == paces.rows() { paces.in_all() - made } else { 0 };
                return points.advance(left, &progress).map_err(|halt| halt.after(made));
            }
            if progress.is_stopped() {
                return Err(EarlyEnd::Stopped(made));
            }
            let now = (end - next).min(points.at_once(every) as u64) as usize;
            gone = points.rows(every, now, &mut cells, &progress).map_err(|halt| halt.after(made));
        }
    }
}

struct CellBlock<A: PointArithmetic> {
    counts: Vec<i64>,
    times: Vec<A::Cell>,
    numbers: Vec<Vec<A::Cell>>,
}

impl<A: PointArithmetic> CellBlock<A> {
    /// Replaces the rows of the block by rows of these cells, numbered from `first` on.
    fn fill(&mut self, course: &OrbitRows<'_, A>, first: u64, cells: &mut Vec<A::Cell>) {
        let OrbitRows { arithmetic, eps, paces, .. } = course;
        let time_step = arithmetic.add(eps, eps);
        let time = |n: &i64| A::cell(&arithmetic.multiply(&A::whole(*n), &time_step));
        let width = self.numbers.len();
        let rows = first..first + (cells.len() / width) as u64;
        self.counts.clear();
        self.counts
            .extend(rows.map(|row| i64::try_from(paces.steps_to(row)).expect("nobody makes so many steps")));
        self.times.clear();
        self.times.extend(self.counts.iter().map(time));
        self.numbers.iter_mut().for_each(Vec::clear);
        let mut cells = cells.drain(..);
        while cells.len() > 0 {
            self.numbers.iter_mut().for_each(|column| column.extend(cells.next()));
        }
    }

    fn pass_rows(&self, columns: &[Column], rows: &mut dyn Rows) -> ControlFlow<()> {
        if self.counts.is_empty() {
            return ControlFlow::Continue(());
        }
        let numbers = self.numbers.iter().map(|cells| A::values(cells));
        let values = [Values::Integer(&self.counts), A::values(&self.times)].into_iter();
        rows.block(columns, &values.chain(numbers).collect::<Vec<_>>())
    }
}

pub(super) fn ended(study: &Study, asked: &Orbit, n: u64, why: EndReason, at: &[Number]) -> Ending {
    let (name, next, scalar) = (study.name(), n + 1, asked.scalar.name());
    let point = study.place(at, &asked.eps);
    let kept = "the rows up to it are kept";
    let why_ended = match why {
        EndReason::Pole { is_reduced } => {
            let by_convention = if is_reduced {
                String::new()
            } else {
                format!(
                    " (its closed form is beyond the budget of {TERM_BUDGET} terms, so every such point counts as a pole)"
                )
            };
            format!(
                "ends at a pole: at n = {n} det A = 0{by_convention}, so step {next} has no value. The point is {point}; {kept}"
            )
        }
        EndReason::StagePole => format!(
            "ends at a pole: det A = 0 at a stage of step {next}, so the step has no value. The point before it is {point}; \
             {kept}"
        ),
        EndReason::NoLimit(singular) => {
            let singular = singular.map_or_else(String::new, |why| format!(": {why}"));
            format!("ends at n = {n}{singular}; {kept}")
        }
        EndReason::Range => format!(
            "leaves the range of {scalar} at step {next}: at n = {n} det A = 0 nearly or the numbers are too large. The point \
             is {point}; {kept}"
        ),
        EndReason::TooLarge => format!(
            "leaves the range of {scalar} at step {next}: at n = {n} the numbers are too large. The point is {point}; {kept}"
        ),
        EndReason::Lift(ends) => format!("{}. The point is {point}; {kept}", ends.in_words(study, n)),
        EndReason::Escapes => format!(
            "ends at n = {n}: the solution escapes to infinity, or leaves the range of {scalar}, before step {next}. The \
             point is {point}; {kept}"
        ),
    };
    // In floats, a pole and an overflow cannot be told apart, so both end with `Range`.
    let end = match why {
        EndReason::Pole { .. } if asked.scalar == ScalarKind::Exact => End::Pole(n),
        EndReason::NoLimit(_) => End::Pole(n),
        EndReason::Lift(LiftEnds::NotReembedded) => End::Reembed(n),
        _ => End::Range(n),
    };
    let instead = match why {
        EndReason::StagePole => Some(["order", "2, which takes no step back"]),
        EndReason::Range => Some(["scalar", "exact"]),
        _ => None,
    };
    Ending { end, step: n, why: Some(format!("the orbit of {name} {why_ended}")), instead, note: None }
}
