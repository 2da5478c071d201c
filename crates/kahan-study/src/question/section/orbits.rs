//! Follows the orbits of a section in groups on all threads, and passes on their crossings. With
//! `carry`, one orbit follows after another.
//!
//! An orbit whose buffer of crossings is full waits until its rows are passed on, so that memory is
//! bounded.

use std::ops::{ControlFlow, Range};

use kahan_algebra::rational::Rational;
use kahan_core::observe::GROUP;
use kahan_core::{Composition, Step};
use kahan_discover::Watch;
use kahan_runtime::{End, MapAt, threads};

use crate::count::WorkCount;
use crate::error::StudyError;
use crate::rows::{Column, Rows};
use crate::study::Study;

use super::plane::Plane;
use super::section_orbit::SectionOrbit;
use super::side_by_side::{self, SectionRequest};
use super::{Cells, Crossed, Section};

/// The number of crossings that all buffers together can hold.
const CROSSINGS_CAPACITY: usize = 1 << 21;

pub(super) struct Orbits<'a> {
    asked: &'a Section,
    study: &'a Study,
    cells: &'a Cells<'a>,
    composition: Composition,
    columns: Vec<Column>,
    /// The number of steps to the last point of an orbit, including the transient.
    limit: u64,
    room: usize,
}

struct StartedOrbit {
    at: MapAt<f64>,
    plane: Plane,
}

impl<'a> Orbits<'a> {
    /// Checks the question, and checks its plane for the first orbit. Prepares the orbits.
    pub(super) fn of(asked: &'a Section, study: &'a Study, cells: &'a Cells<'a>) -> Result<Self, StudyError> {
        let system = study.proved()?;
        study.can_reembed(asked.reembed)?;
        let composition = Composition::of_order(asked.order).ok_or(StudyError::Order(asked.order))?;
        let limit = asked.transient.saturating_add(asked.most_steps()?);
        let (place, (in_doubles, _)) = (cells.exactly(0), cells.in_doubles(0));
        Plane::of(system, &place.parameters, &place.eps, &asked.plane)?;
        if !asked.is_of_many() {
            // A mistake in the only orbit is an error; a mistake in one of many ends that orbit.
            study.in_floats(&place.at, &place.eps)?;
        }
        study.within_range(&in_doubles.at, in_doubles.eps)?;
        let columns = asked.columns_of(study, cells);
        Ok(Orbits { asked, study, cells, composition, columns, limit, room: CROSSINGS_CAPACITY })
    }

    /// Prepares the orbit of a cell. An undefined field, plane or point ends the orbit at once.
    fn prepare_orbit(&self, index: u64, room: usize) -> (Option<StartedOrbit>, SectionOrbit) {
        let place = self.cells.exactly(index);
        let is_own = self.study.values().is_ok_and(|values| values == place.parameters);
        let own = || self.study.at(place.parameters.iter().cloned().map(Some).collect());
        let study = if is_own { self.study.clone() } else { own() };
        let point = study.point(&place.at);
        let x = point.iter().flatten().map(Rational::to_f64).collect();
        let most = self.asked.crossings.unwrap_or(u64::MAX);
        let course = SectionOrbit::new(x, self.study.shown().len(), most, room);
        let plane = Plane::of(self.study.system(), &place.parameters, &place.eps, &self.asked.plane);
        let at = study.map().map(|map| map.at(place.eps.to_f64()).composed(self.composition));
        match (at, plane, point) {
            (Ok(at), Ok(plane), Ok(_)) if at.eps().is_finite() => (Some(StartedOrbit { at, plane }), course),
            _ => (None, course.never()),
        }
    }

    /// Follows a single orbit until its end, or until its buffer is full.
    fn follow_alone(&self, begun: &StartedOrbit, course: &mut SectionOrbit, count: &WorkCount<'_>) {
        let (tell, reembed) = (|steps| count.tell(steps), self.asked.reembed);
        let lifted = self.study.steps(&begun.at, reembed);
        let by: &dyn Step<Scalar = f64> = lifted.as_ref().map_or(&begun.at, |step| step);
        course.pass(by, self.asked.transient, &tell);
        let height = begun.plane.height(&begun.at);
        course.follow(self.study, by, height, self.asked.direction, self.limit, &tell);
        if let (Some(step), Some(end)) = (&lifted, course.end) {
            course.end = Some(step.end(end, &course.x));
        }
    }

    /// Follows a group of orbits until their ends, or until their buffers are full.
    fn group(&self, cells: Range<u64>, room: usize, count: &WorkCount<'_>) -> Vec<SectionOrbit> {
        let begun = cells.map(|index| self.prepare_orbit(index, room));
        let (begun, mut courses): (Vec<Option<StartedOrbit>>, Vec<SectionOrbit>) = begun.unzip();
        let is_plain = |begun: &StartedOrbit| self.study.steps(&begun.at, self.asked.reembed).is_none();
        if begun.len() > 1 && begun.iter().all(|begun| begun.as_ref().is_some_and(is_plain)) {
            let tell = |steps| count.tell(steps);
            let Section { direction, transient, .. } = *self.asked;
            let asked =
                SectionRequest { study: self.study, direction, transient, limit: self.limit, tell: &tell };
            let of_each = begun.iter().flatten();
            let maps: Vec<&MapAt<f64>> = of_each.clone().map(|begun| &begun.at).collect();
            let planes: Vec<&Plane> = of_each.map(|begun| &begun.plane).collect();
            side_by_side::pass(&asked, &maps, &mut courses);
            side_by_side::follow(&asked, &maps, &planes, &mut courses);
        }
        for (begun, course) in begun.iter().zip(&mut courses) {
            begun.iter().for_each(|begun| self.follow_alone(begun, course, count));
        }
        courses
    }

    /// Passes all crossings of an orbit to a consumer, and appends the orbit's end to `found`.
    fn finish(
        &self,
        index: u64,
        mut course: SectionOrbit,
        rows: &mut dyn Rows,
        count: &WorkCount<'_>,
        found: &mut Vec<Crossed>,
    ) -> ControlFlow<(), SectionOrbit> {
        let (_, values) = self.cells.in_doubles(index);
        let (values, start) = (self.cells.varying(&values), self.cells.start(index));
        let front = self.asked.is_of_many().then_some(start);
        let mut flow = course.pass_crossings(&self.columns, front, &values, rows);
        if course.end.is_none() && flow.is_continue() {
            let begun = self.prepare_orbit(index, 1).0.expect("the orbit was begun before");
            while course.end.is_none() && flow.is_continue() {
                self.follow_alone(&begun, &mut course, count);
                flow = course.pass_crossings(&self.columns, front, &values, rows);
            }
        }
        let (end, steps) = (course.end.unwrap_or(End::Stopped(course.made)), course.made);
        found.push(Crossed {
            start,
            values,
            steps,
            end,
            why: self.why(index, end, &course),
            crossings: course.kept.all,
            jumps: course.jumps,
        });
        flow.map_continue(|()| course)
    }

    fn why(&self, index: u64, end: End, course: &SectionOrbit) -> Option<String> {
        if !end.is_early() || self.study.lift().is_none() {
            return None;
        }
        let begun = self.prepare_orbit(index, 1).0?;
        let ends = self.study.steps(&begun.at, self.asked.reembed)?.ends(&course.x)?;
        Some(ends.in_words(self.study, course.made))
    }

    pub(super) fn find(&self, rows: &mut dyn Rows, watch: &dyn Watch) -> Vec<Crossed> {
        let all = self.limit.saturating_mul(self.cells.count);
        let count = WorkCount::new("steps", all, watch);
        if self.asked.carry {
            self.follow_in_sequence(rows, &count)
        } else {
            self.in_parallel_blocks(rows, &count)
        }
    }

    /// Alternates between following some groups on all threads and passing on their rows.
    fn in_parallel_blocks(&self, rows: &mut dyn Rows, count: &WorkCount<'_>) -> Vec<Crossed> {
        /// The number of groups that each thread follows before rows are passed on.
        const GROUPS_PER_THREAD: u64 = 4;

        let (all, threads) = (self.cells.count, count.threads() as u64);
        let group = all.div_ceil(threads).clamp(1, GROUP as u64);
        let wave = group * GROUPS_PER_THREAD * threads;
        let room = (self.room as u64 / wave.min(all)).max(1) as usize;
        let mut found = Vec::new();
        for first in (0..all).step_by(wave as usize) {
            let groups = wave.min(all - first).div_ceil(group) as usize;
            let cells = |place: usize| {
                let start = first + place as u64 * group;
                start..all.min(start + group)
            };
            let work = |place: usize| self.group(cells(place), room, count);
            let courses = threads::map(groups, Some(threads as usize), work);
            for (index, course) in (first..).zip(courses.into_iter().flatten()) {
                if self.finish(index, course, rows, count, &mut found).is_break() {
                    return found;
                }
            }
            if count.is_stopped() {
                break;
            }
        }
        found
    }

    /// Follows one orbit after another. Each orbit starts at the last point of the previous orbit.
    fn follow_in_sequence(&self, rows: &mut dyn Rows, count: &WorkCount<'_>) -> Vec<Crossed> {
        let (mut found, mut last) = (Vec::new(), None::<Vec<f64>>);
        for index in 0..self.cells.count {
            let (begun, mut course) = self.prepare_orbit(index, self.room);
            if !index.is_multiple_of(self.cells.last_count()) {
                last.into_iter().for_each(|x| course.x = x);
            }
            begun.iter().for_each(|begun| self.follow_alone(begun, &mut course, count));
            let ControlFlow::Continue(course) = self.finish(index, course, rows, count, &mut found) else {
                break;
            };
            last = course.x.iter().all(|x| x.is_finite()).then_some(course.x);
            if count.is_stopped() {
                break;
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use kahan_discover::Unwatched;

    use super::*;
    use crate::rows::{Table, Values};
    use crate::{Direction, Subject, Systems};

    #[derive(Default)]
    struct Counted(Table, usize);

    impl Rows for Counted {
        fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
            self.1 = self.1.max(values[0].count());
            self.0.block(columns, values)
        }
    }

    #[test]
    fn crossings_beyond_all_room_come_in_the_order_of_orbits() {
        let turn = Subject::text("xdot = y; ydot = -x;").study(&Systems).expect("a field");
        let starts = (1..=7).map(|k| vec![Rational::from(k), Rational::zero()]).collect();
        let plain = Section::new(Rational::new(1, 5), Vec::new(), 2500, "y");
        let asked = Section { direction: Direction::Both, starts, ..plain };
        let found = |room: usize| {
            let over = asked.as_over();
            let cells = Cells::with_starts(&over, 0, &turn).expect("starts");
            let orbits = Orbits::of(&asked, &turn, &cells).expect("a section");
            let mut rows = Counted::default();
            (Orbits { room, ..orbits }.find(&mut rows, &Unwatched), rows.0, rows.1)
        };
        let (orbits, table, block) = found(CROSSINGS_CAPACITY);
        assert!(table.count() > 2000 && block > 200, "{} {block}", table.count());
        for room in [7, 70, 1000] {
            let few = found(room);
            assert_eq!((&few.0, &few.1), (&orbits, &table), "{room}");
            assert!(few.2 <= room.div_ceil(7), "{} of {room}", few.2);
        }
    }
}
