//! Orbits in floats, observed in the loop.

use std::ops::ControlFlow;

use kahan_core::Composition;
use kahan_core::observe::Observer;
use kahan_runtime::{Follow, Followed, MachineFloat, Map, MapAt, WhileFinite};

use super::Task;
use super::watch::{Watch, Watches};
use crate::columns::{Column, Entry, Kind};
use crate::plan::{Axis, Plan, Point};

/// What is asked of each orbit.
#[derive(Clone, Debug)]
pub(crate) struct Orbit {
    pub(crate) steps: u64,
    /// Steps between two orthogonalisations of tangent vectors.
    pub(crate) every: u64,
    /// The size beyond which an orbit has escaped.
    pub(crate) escape: f64,
    pub(crate) observe: Vec<Watch>,
}

impl Orbit {
    pub(crate) fn columns(&self, plan: &Plan) -> Vec<Column> {
        let steps = Column::new(
            "steps",
            Kind::Integer,
            "steps that were made, fewer where numbers leave their range",
        );
        [steps].into_iter().chain(self.observe.iter().flat_map(|watch| watch.columns(plan))).collect()
    }
}

/// The map at one point of the parameters, ε, order and scalar.
enum Prepared {
    Double(MapAt<f64>),
    Single(MapAt<f32>),
}

/// Follows one orbit after another; a map that the next one has too is prepared once.
pub(super) struct Follower {
    /// The field at parameters, if it has a value there.
    map: Option<(Vec<f64>, Option<Map>)>,
    /// ε, order and bits, with the map at them.
    prepared: Option<((f64, u32, u32), Prepared)>,
    /// Columns of what is found.
    columns: usize,
    are_abreast: bool,
}

/// Orbits that fill registers.
pub(super) const LANES: usize = 16;
/// Steps of all orbits that are followed at once.
const AT_ONCE: u64 = 1 << 24;

/// Whether the orbits of a plan are followed side by side. Where neighbours have maps of their own
/// nothing is gained by that, and where they are long too much would be lost with a process that
/// ends.
///
/// Orbits of which nothing is asked but their ends then go through the map's step for columns,
/// which is faster, and whose last digits differ from those of single steps; so the plan chooses,
/// and not what happens to stand together.
pub(super) fn are_abreast(plan: &Plan) -> bool {
    let is_short = |orbit: &Orbit| orbit.steps <= AT_ONCE / LANES as u64;
    matches!(&plan.task, Task::Orbit(orbit) if plan.neighbours_share_a_map() && is_short(orbit))
}

impl Follower {
    pub(super) fn new(plan: &Plan) -> Self {
        Self {
            map: None,
            prepared: None,
            columns: plan.task.columns(plan).len(),
            are_abreast: are_abreast(plan),
        }
    }

    /// What is found on the orbits of points, of which the first has this index, and which have
    /// one map.
    pub(super) fn follow(
        &mut self,
        orbit: &Orbit,
        plan: &Plan,
        index: u64,
        points: &[Point<f64>],
    ) -> Vec<Vec<Entry>> {
        let starts: Vec<&[f64]> = points.iter().map(|point| &point.start[..]).collect();
        let (are_abreast, columns) = (self.are_abreast, self.columns);
        match self.prepare(plan, index, &points[0]) {
            Some(Prepared::Double(at)) => orbit.observed(are_abreast, at, &starts),
            Some(Prepared::Single(at)) => orbit.observed(are_abreast, at, &starts),
            None => {
                // Where the field divides by zero there is no orbit.
                let mut nothing = vec![Entry::Double(f64::NAN); columns];
                nothing[0] = Entry::Integer(0);
                vec![nothing; points.len()]
            }
        }
    }

    /// How many points with one map are followed at once: enough to fill registers, few enough that
    /// they are done in a moment.
    pub(super) fn at_once(&self, orbit: &Orbit) -> usize {
        if self.are_abreast { (AT_ONCE / orbit.steps).clamp(LANES as u64, 64) as usize } else { 1 }
    }

    fn prepare(&mut self, plan: &Plan, index: u64, point: &Point<f64>) -> Option<&Prepared> {
        let same = |a: &[f64], b: &[f64]| a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()));
        if !self.map.as_ref().is_some_and(|(at, _)| same(at, &point.parameters)) {
            let exact = plan.point(&plan.values(index, Axis::value), |_| 0);
            let given = plan.field.parameters().iter().zip(exact.parameters);
            self.map = Some((point.parameters.clone(), plan.field.with(given).ok()));
            self.prepared = None;
        }
        let key = (point.eps, point.order, point.bits);
        if !self.prepared.as_ref().is_some_and(|(at, _)| *at == key) {
            let map = self.map.as_ref().and_then(|(_, map)| map.as_ref())?;
            let composition = Composition::of_order(point.order).unwrap_or(Composition::KAHAN);
            self.prepared = Some((
                key,
                match point.bits {
                    32 => Prepared::Single(map.at(point.eps as f32).composed(composition)),
                    _ => Prepared::Double(map.at(point.eps).composed(composition)),
                },
            ));
        }
        self.prepared.as_ref().map(|(_, prepared)| prepared)
    }
}

impl Orbit {
    /// The steps made, and what the observers report, of each orbit.
    fn observed<T: Machine>(&self, are_abreast: bool, at: &MapAt<T>, starts: &[&[f64]]) -> Vec<Vec<Entry>> {
        let nearest = |start: &&[f64]| start.iter().map(|&x| T::nearest(x)).collect();
        let starts: Vec<Vec<T>> = starts.iter().map(nearest).collect();
        let found = if self.observe.iter().all(|watch| *watch == Watch::Last) {
            self.ends(are_abreast, at, &starts)
        } else {
            self.watched(at, &starts)
        };
        let row = |Followed { steps, report, .. }: Followed<Vec<f64>>| {
            let numbers = report.into_iter().map(Entry::Double);
            [Entry::Integer(steps as i64)].into_iter().chain(numbers).collect()
        };
        found.into_iter().map(row).collect()
    }

    /// The last point of each orbit, as often as it is asked; nothing is looked at on the way.
    fn ends<T: Machine>(
        &self,
        are_abreast: bool,
        at: &MapAt<T>,
        starts: &[Vec<T>],
    ) -> Vec<Followed<Vec<f64>>> {
        let mut ends = columns(starts);
        let followed = if are_abreast {
            at.follow_columns(&mut slices(&mut ends), &[], &[], self.steps).expect(FITTING)
        } else {
            let alone = starts.iter().enumerate().map(|(orbit, start)| {
                let mut x = start.clone();
                let followed = at.follow(&mut x, self.steps, |_| ControlFlow::Continue(()));
                ends.iter_mut().zip(x).for_each(|(column, x)| column[orbit] = x);
                followed.expect(FITTING)
            });
            alone.collect()
        };
        let point = |orbit: usize| ends.iter().map(move |column| column[orbit].into());
        let told = |(orbit, Followed { steps, ended, .. })| {
            let report = self.observe.iter().flat_map(|_| point(orbit)).collect();
            Followed { report, steps, ended }
        };
        followed.into_iter().enumerate().map(told).collect()
    }

    /// What is seen of each orbit, in the order of the columns.
    fn watched<T: Machine>(&self, at: &MapAt<T>, starts: &[Vec<T>]) -> Vec<Followed<Vec<f64>>> {
        let found = observe(at, starts, self.steps, |_| Watches::new(self, at));
        let turns = if self.observe.contains(&Watch::Rotation) { self.turns(at, starts) } else { Vec::new() };
        let told = |(orbit, Followed { report, steps, ended }): (usize, Followed<Vec<Vec<f64>>>)| {
            let numbers = self.observe.iter().zip(report);
            let numbers = numbers.flat_map(|(watch, numbers)| match watch {
                Watch::Rotation => turns[orbit].clone(),
                _ => numbers,
            });
            Followed { report: numbers.collect(), steps, ended }
        };
        found.into_iter().enumerate().map(told).collect()
    }

    /// The rotation of each variable of each orbit, and how wrong it may be, in two more runs.
    fn turns<T: Machine>(&self, at: &MapAt<T>, starts: &[Vec<T>]) -> Vec<Vec<f64>> {
        let first = observe(at, starts, self.steps, |_| at.extremes());
        let again = observe(at, starts, self.steps, |orbit| {
            let Followed { report, steps, .. } = &first[orbit];
            at.rotations(*steps, report)
        });
        let told = again.into_iter().map(|followed| followed.report.into_iter());
        told.map(|turns| turns.flat_map(|turns| [turns.value, turns.error]).collect()).collect()
    }
}

/// Why calls of a map are not refused.
const FITTING: &str = "there are as many columns as the field has variables, all of one length";

/// What observers tell of each orbit of a map, as far as it goes: the same alone and side by side.
fn observe<T: Machine, O: Observer<T>>(
    at: &MapAt<T>,
    starts: &[Vec<T>],
    steps: u64,
    observers: impl Fn(usize) -> O,
) -> Vec<Followed<O::Report>> {
    if let [start] = starts {
        let alone = at.observe(&mut start.clone(), steps, observers(0), |_| ControlFlow::Continue(()));
        return vec![alone.expect(FITTING)];
    }
    let of = |orbit| WhileFinite::new(observers(orbit));
    MapAt::observe_columns(&[at], &mut slices(&mut columns(starts)), steps, of).expect(FITTING)
}

fn columns<T: Machine>(starts: &[Vec<T>]) -> Vec<Vec<T>> {
    let variables = starts.first().map_or(0, Vec::len);
    (0..variables).map(|k| starts.iter().map(|start| start[k]).collect()).collect()
}

fn slices<T>(columns: &mut [Vec<T>]) -> Vec<&mut [T]> {
    columns.iter_mut().map(Vec::as_mut_slice).collect()
}

/// A float of the machine, from doubles and to them.
pub(super) trait Machine: MachineFloat + PartialOrd + Into<f64> {
    /// The nearest one.
    fn nearest(value: f64) -> Self;
}

impl Machine for f64 {
    fn nearest(value: f64) -> Self {
        value
    }
}

impl Machine for f32 {
    fn nearest(value: f64) -> Self {
        value as f32
    }
}
