//! Follows orbits in SIMD lanes, and finds crossings where the formula changes its sign.
//!
//! Crossings have the same bits as those of an orbit that is followed singly.

use std::cell::Cell;
use std::ops::ControlFlow;

use kahan_core::Step;
use kahan_core::observe::{Burst, Direction, GROUP, Group, Grouped, Observer, Observers, Section};
use kahan_runtime::{End, MapAt};

use crate::formula::{Formula, FormulaGroup};
use crate::study::Study;

use super::plane::Plane;
use super::section_orbit::{BufferedCrossings, SectionOrbit};

/// The number of steps in a round; orbits that ended leave the group after each round.
const STEPS_PER_ROUND: u64 = 1024;
/// Fewer orbits than this number are followed one by one.
const MIN_GROUPED_ORBITS: usize = 4;

/// The parts of the question that are the same for all orbits.
pub(super) struct SectionRequest<'a> {
    pub(super) study: &'a Study,
    pub(super) direction: Direction,
    pub(super) transient: u64,
    /// The number of steps to the last point, including the transient.
    pub(super) limit: u64,
    pub(super) tell: &'a dyn Fn(u64) -> ControlFlow<()>,
}

/// An orbit with its section and its last observed point.
struct SectionLane<'a, F> {
    section: Section<&'a dyn Step<Scalar = f64>, F, BufferedCrossings<'a>>,
    level: F,
    x: &'a mut Vec<f64>,
    made: &'a mut u64,
    end: &'a mut Option<End>,
    height: f64,
    direction: Direction,
}

impl<'a, F: Fn(&[f64]) -> f64 + Copy> SectionLane<'a, F> {
    fn new(
        asked: &'a SectionRequest<'_>,
        course: &'a mut SectionOrbit,
        at: &'a MapAt<f64>,
        level: F,
    ) -> Self {
        let SectionOrbit { x, made, kept, end, .. } = course;
        let (height, taking) = (level(x), BufferedCrossings { kept, study: asked.study });
        let by: &dyn Step<Scalar = f64> = at;
        let (direction, section) = (asked.direction, Section::new(by, level, asked.direction, taking));
        SectionLane { section, level, x, made, end, height, direction }
    }

    fn goes_on(&self) -> bool {
        self.end.is_none() && !self.section.is_done()
    }

    /// Takes the next point. If the formula changed its sign, the section computes the crossing.
    fn take_point(&mut self, step: u64, x: &[f64], height: f64) {
        let rises = self.direction != Direction::Falling && self.height < 0.0 && height >= 0.0;
        let falls = self.direction != Direction::Rising && self.height > 0.0 && height <= 0.0;
        if rises || falls {
            self.section.restart();
            self.section.observe(step - 1, self.x);
            self.section.observe(step, x);
        }
        self.x.copy_from_slice(x);
        (self.height, *self.made) = (height, step);
    }
}

struct LaneObserver<'c, 'a, F> {
    lane: &'c mut SectionLane<'a, F>,
    /// The formula for all orbits of the group at once; `None` if the formula depends on integrals.
    abreast: Option<&'c FormulaGroup>,
    before: u64,
}

impl<F: Fn(&[f64]) -> f64 + Copy> Observer<f64> for LaneObserver<'_, '_, F> {
    type Report = ();

    fn observe(&mut self, step: u64, x: &[f64]) {
        if step == 0 || !self.lane.goes_on() {
            return;
        }
        if x.iter().all(|x| x.is_finite()) {
            let height = (self.lane.level)(x);
            self.lane.take_point(self.before + step, x, height);
        } else {
            *self.lane.end = Some(End::Range(self.before + step - 1));
        }
    }

    fn is_done(&self) -> bool {
        !self.lane.goes_on()
    }

    fn report(self) {}

    /// Evaluates the formula on all orbits at once; if a point is not finite, on each orbit alone.
    fn observe_burst<P: Grouped<f64>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>) {
        let abreast = group.iter().flatten().find_map(|own| own.abreast);
        let last = burst.steps().last();
        let (Some(abreast), Some((_, last))) = (abreast, last) else {
            return show(group, burst);
        };
        if !last.as_ref().iter().flatten().all(|x| x.is_finite()) {
            return show(group, burst);
        }
        let (mut heights, mut go_on) = ([f64::NAN; GROUP], [false; GROUP]);
        for (lane, own) in group.iter().enumerate() {
            let Some(own) = own.as_ref().filter(|own| own.lane.goes_on()) else { continue };
            (heights[lane], go_on[lane]) = (own.lane.height, true);
        }
        let mut earlier: Option<&P> = None;
        for (step, points) in burst.steps() {
            let now = abreast.at(points.as_ref());
            if changes(&heights, &now) {
                for (lane, own) in group.iter_mut().enumerate() {
                    let Some(own) = own.as_mut().filter(|own| own.lane.goes_on()) else { continue };
                    own.lane.height = heights[lane];
                    earlier.into_iter().for_each(|points| points.read(lane, own.lane.x));
                    own.lane.take_point(own.before + step, points.of(lane).as_ref(), now[lane]);
                    go_on[lane] = own.lane.goes_on();
                }
            }
            // NaN prevents further sign changes of a finished orbit.
            for ((height, now), goes_on) in heights.iter_mut().zip(now).zip(go_on) {
                *height = if goes_on { now } else { f64::NAN };
            }
            earlier = Some(points);
        }
        let Some((step, points)) = burst.steps().last() else { return };
        for (lane, own) in group.iter_mut().enumerate() {
            let Some(own) = own.as_mut().filter(|own| own.lane.goes_on()) else { continue };
            points.read(lane, own.lane.x);
            (own.lane.height, *own.lane.made) = (heights[lane], own.before + step);
        }
    }
}

fn changes(before: &Group<f64>, now: &Group<f64>) -> bool {
    let mut any = false;
    for (before, now) in before.iter().zip(now) {
        any |= ((*before < 0.0) & (*now >= 0.0)) | ((*before > 0.0) & (*now <= 0.0));
    }
    any
}

fn show<F: Fn(&[f64]) -> f64 + Copy, P: Grouped<f64>>(
    group: &mut Observers<'_, LaneObserver<'_, '_, F>>,
    burst: &Burst<'_, P>,
) {
    for (lane, own) in group.iter_mut().flatten().enumerate() {
        burst.show(lane, 0, |step, x| own.observe(step, x));
    }
}

pub(super) fn pass(asked: &SectionRequest<'_>, maps: &[&MapAt<f64>], courses: &mut [SectionOrbit]) {
    /// The number of steps that an orbit makes between two checks of the watch.
    const AT_ONCE: u64 = 1 << 14;

    let (eps, first) = (maps.iter().map(|map| MapAt::eps(map)).collect::<Vec<_>>(), maps[0]);
    let parameter = |k: usize| maps.iter().map(|map| map.map().parameters()[k].to_f64()).collect();
    let parameters: Vec<Vec<f64>> = (0..first.map().parameters().len()).map(parameter).collect();
    let parameters: Vec<&[f64]> = parameters.iter().map(Vec::as_slice).collect();
    let column = |k: usize| courses.iter().map(|course| course.x[k]).collect();
    let mut columns: Vec<Vec<f64>> = (0..courses[0].x.len()).map(column).collect();
    let mut made = 0;
    while made < asked.transient {
        let steps = AT_ONCE.min(asked.transient - made);
        let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        let ends = first.follow_columns(&mut slices, &eps, &parameters, steps);
        for (course, end) in courses.iter_mut().zip(ends.expect("the points are of the field")) {
            if course.end.is_none() {
                course.made = made + end.steps(steps);
                course.end = (end != End::Complete).then(|| end.after(made));
            }
        }
        made += steps;
        if (asked.tell)(steps * courses.len() as u64).is_break() {
            let going_on = courses.iter_mut().filter(|course| course.end.is_none());
            going_on.for_each(|course| course.end = Some(End::Stopped(course.made)));
            break;
        }
    }
    for (k, course) in courses.iter_mut().enumerate() {
        course.x.iter_mut().zip(&columns).for_each(|(x, column)| *x = column[k]);
    }
}

/// Follows orbits until they end or their buffers of crossings are full.
pub(super) fn follow(
    asked: &SectionRequest<'_>,
    maps: &[&MapAt<f64>],
    planes: &[&Plane],
    courses: &mut [SectionOrbit],
) {
    let levels: Vec<_> = planes.iter().zip(maps).map(|(plane, at)| plane.height(at)).collect();
    let variables = courses[0].x.len();
    let names_integrals = planes[0].last_variable().is_some_and(|last| last >= variables);
    let begun = courses.iter_mut().zip(maps).zip(&levels);
    let mut lanes: Vec<_> =
        begun.map(|((course, at), level)| SectionLane::new(asked, course, at, level)).collect();
    let mut made = lanes.iter().filter(|lane| lane.goes_on()).map(|lane| *lane.made).min().unwrap_or(0);
    let is_stopped = Cell::new(false);
    let tell = |steps| {
        let flow = (asked.tell)(steps);
        is_stopped.set(is_stopped.get() || flow.is_break());
        flow
    };
    loop {
        let live: Vec<usize> = (0..lanes.len()).filter(|k| lanes[*k].goes_on()).collect();
        if live.len() < MIN_GROUPED_ORBITS || made >= asked.limit || is_stopped.get() {
            break;
        }
        let steps = STEPS_PER_ROUND.min(asked.limit - made);
        let own: Vec<&MapAt<f64>> = live.iter().map(|k| maps[*k]).collect();
        let formulas: Vec<&Formula> = live.iter().map(|k| &planes[*k].0).collect();
        let abreast = (!names_integrals).then(|| FormulaGroup::of(&formulas));
        let column = |k: usize| live.iter().map(|lane| lanes[*lane].x[k]).collect();
        let mut columns: Vec<Vec<f64>> = (0..variables).map(column).collect();
        let mut columns: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        let seen = lanes.iter_mut().filter(|lane| lane.goes_on());
        let seen: Vec<_> = seen.map(|lane| Cell::new(Some(lane))).collect();
        let looking = |orbit: usize| {
            let lane = seen[orbit].take().expect("each orbit is asked for once");
            LaneObserver { lane, abreast: abreast.as_ref(), before: made }
        };
        let done = MapAt::observe_columns_while(&own, &mut columns, steps, looking, &tell);
        done.expect("the points are of the field");
        made += steps;
    }
    for lane in &mut lanes {
        if is_stopped.get() && lane.goes_on() {
            *lane.end = Some(End::Stopped(*lane.made));
        }
    }
    let jumps: Vec<u64> = lanes.into_iter().map(|lane| lane.section.report().jumps).collect();
    for (course, jumps) in courses.iter_mut().zip(jumps) {
        course.jumps += jumps;
        course.end_if_complete(asked.limit);
    }
}
