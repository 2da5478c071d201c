//! The state of one orbit: its point, and the crossings that were not yet passed on.

use std::ops::ControlFlow;

use kahan_core::Step;
use kahan_core::observe::{Crossing, CrossingReceiver, Direction, Observer, Section};
use kahan_runtime::{End, Follow};

use crate::rows::{Column, Rows, Values};
use crate::study::Study;

/// An orbit that is followed until its buffer of crossings is full, and continued when the buffer
/// is empty again.
#[derive(Clone, Debug)]
pub(super) struct SectionOrbit {
    pub(super) x: Vec<f64>,
    pub(super) made: u64,
    pub(super) kept: CrossingBuffer,
    pub(super) jumps: u64,
    /// The end; `None` if the orbit can go on.
    pub(super) end: Option<End>,
}

/// The buffered crossings: steps, times, and the columns of the shown variables.
#[derive(Clone, Debug, Default)]
pub(super) struct CrossingBuffer {
    steps: Vec<i64>,
    times: Vec<f64>,
    points: Vec<Vec<f64>>,
    pub(super) all: u64,
    most: u64,
    room: usize,
}

impl CrossingBuffer {
    fn is_full(&self) -> bool {
        self.all >= self.most || self.steps.len() >= self.room
    }
}

/// A receiver that stores crossings in columns, one for each coordinate.
pub(super) struct BufferedCrossings<'a> {
    pub(super) kept: &'a mut CrossingBuffer,
    pub(super) study: &'a Study,
}

impl CrossingReceiver<Crossing<Vec<f64>, f64>> for BufferedCrossings<'_> {
    type Report = ();

    fn take(&mut self, crossing: Crossing<Vec<f64>, f64>) {
        let BufferedCrossings { kept, study } = self;
        let time = study.time_place().map_or(crossing.time, |place| crossing.point[place]);
        kept.steps.push(crossing.step as i64);
        kept.times.push(time);
        let point = study.project(&crossing.point);
        kept.points.iter_mut().zip(point).for_each(|(column, value)| column.push(value));
        kept.all += 1;
    }

    fn is_full(&self) -> bool {
        self.kept.is_full()
    }

    fn report(self) {}
}

/// An observer of an orbit that is followed in several calls. It counts all steps of the orbit.
struct ContinuedObserver<'a, O> {
    section: &'a mut O,
    before: u64,
}

impl<O: Observer<f64>> Observer<f64> for ContinuedObserver<'_, O> {
    type Report = ();

    fn observe(&mut self, step: u64, x: &[f64]) {
        self.section.observe(self.before + step, x);
    }

    fn is_done(&self) -> bool {
        self.section.is_done()
    }

    fn report(self) {}
}

impl SectionOrbit {
    /// Prepares an orbit that ends after `most` crossings. The buffer holds `room` crossings.
    pub(super) fn new(x: Vec<f64>, shown: usize, most: u64, room: usize) -> Self {
        let kept =
            CrossingBuffer { points: vec![Vec::new(); shown], most, room, ..CrossingBuffer::default() };
        SectionOrbit { x, made: 0, kept, jumps: 0, end: None }
    }

    pub(super) fn never(mut self) -> Self {
        self.end = Some(End::Range(0));
        self
    }

    pub(super) fn pass(
        &mut self,
        by: &dyn Step<Scalar = f64>,
        transient: u64,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) {
        let left = transient.saturating_sub(self.made);
        if left > 0 && self.end.is_none() {
            let end = by.follow(&mut self.x, left, tell).expect("the point is of the field").end;
            self.ends(end, left);
        }
    }

    /// Follows the orbit to step `limit`, or until all crossings are found or the buffer is full.
    pub(super) fn follow(
        &mut self,
        study: &Study,
        by: &dyn Step<Scalar = f64>,
        height: impl Fn(&[f64]) -> f64,
        direction: Direction,
        limit: u64,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) {
        let left = limit.saturating_sub(self.made);
        if self.end.is_some() {
            return;
        }
        if left == 0 {
            self.end = Some(End::Complete);
            return;
        }
        let SectionOrbit { x, made, kept, .. } = self;
        let mut section = Section::new(by, height, direction, BufferedCrossings { kept, study });
        let going_on = ContinuedObserver { section: &mut section, before: *made };
        let end = by.observe(x, left, going_on, tell).expect("the point is of the field").end;
        let (is_full, jumps) = (section.is_done(), section.report().jumps);
        self.jumps += jumps;
        let has_all = self.kept.all >= self.kept.most;
        match end {
            End::Stopped(steps) if is_full && !has_all => self.made += steps,
            End::Complete => (self.made, self.end) = (limit, Some(End::Complete)),
            end => self.ends(end, left),
        }
    }

    /// Ends the orbit if it has all crossings or has reached the last step.
    pub(super) fn end_if_complete(&mut self, limit: u64) {
        if self.end.is_none() && self.kept.all >= self.kept.most {
            self.end = Some(End::Stopped(self.made));
        } else if self.end.is_none() && self.made >= limit {
            self.end = Some(End::Complete);
        }
    }

    fn ends(&mut self, end: End, asked: u64) {
        let before = self.made;
        self.made += end.steps(asked);
        self.end = (end != End::Complete).then(|| end.after(before));
    }

    /// Passes a row for each crossing, with `values` to its left, and empties the buffer.
    pub(super) fn pass_crossings(
        &mut self,
        columns: &[Column],
        start: Option<u64>,
        values: &[f64],
        rows: &mut dyn Rows,
    ) -> ControlFlow<()> {
        const BLOCK: usize = 1024;

        let CrossingBuffer { steps, times, points, .. } = &mut self.kept;
        let flow = (0..steps.len()).step_by(BLOCK).try_for_each(|first| {
            let own = first..steps.len().min(first + BLOCK);
            let starts: Vec<i64> = start.iter().flat_map(|start| vec![*start as i64; own.len()]).collect();
            let given: Vec<Vec<f64>> = values.iter().map(|value| vec![*value; own.len()]).collect();
            let numbers = points.iter().map(|column| Values::F64(&column[own.clone()]));
            let front = start.map(|_| Values::Integer(&starts)).into_iter();
            let block: Vec<Values<'_>> = front
                .chain(given.iter().map(|column| Values::F64(column)))
                .chain([Values::Integer(&steps[own.clone()]), Values::F64(&times[own.clone()])])
                .chain(numbers)
                .collect();
            rows.block(columns, &block)
        });
        steps.clear();
        times.clear();
        points.iter_mut().for_each(Vec::clear);
        flow
    }
}
