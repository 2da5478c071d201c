//! Orbits in floats, observed in the loop.

use kahan_core::Composition;
use kahan_core::observe::{Extrema, Observer};
use kahan_runtime::{MachineFloat, Map, MapAt};

use super::Task;
use super::walk::{Gait, Walked};
use super::watch::{Quantity, Rotations, Running, Watch};
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
    gait: Gait,
}

/// Orbits that fill registers.
pub(super) const LANES: usize = 16;
/// Steps of all orbits that are followed at once.
const AT_ONCE: u64 = 1 << 24;

/// How the orbits of a plan are followed. Where neighbours have maps of their own nothing is gained
/// side by side, and where they are long too much would be lost with a process that ends.
pub(super) fn gait(plan: &Plan) -> Gait {
    match &plan.task {
        Task::Orbit(orbit) if plan.neighbours_share_a_map() && orbit.steps <= AT_ONCE / LANES as u64 => {
            Gait::Abreast
        }
        _ => Gait::OneByOne,
    }
}

impl Follower {
    pub(super) fn new(plan: &Plan) -> Self {
        Self { map: None, prepared: None, columns: plan.task.columns(plan).len(), gait: gait(plan) }
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
        let (gait, columns) = (self.gait, self.columns);
        match self.prepare(plan, index, &points[0]) {
            Some(Prepared::Double(at)) => orbit.observed(gait, at, &starts),
            Some(Prepared::Single(at)) => orbit.observed(gait, at, &starts),
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
        match self.gait {
            Gait::OneByOne => 1,
            Gait::Abreast => (AT_ONCE / orbit.steps).clamp(LANES as u64, 64) as usize,
        }
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
    fn observed<T: Machine>(&self, gait: Gait, at: &MapAt<T>, starts: &[&[f64]]) -> Vec<Vec<Entry>> {
        let starts: Vec<Vec<T>> =
            starts.iter().map(|start| start.iter().map(|&x| T::nearest(x)).collect()).collect();
        let own = |value: &[T]| [value[0]];
        let running = self.observe.iter().map(|watch| Running::new(*watch, at, self, starts.len(), own));
        let mut running: Vec<Running<'_, T, _>> = running.collect();
        let looks = self.observe.iter().any(|watch| !matches!(watch, Watch::Last | Watch::Rotation));
        let walked = if looks {
            gait.walk(at, &starts, &vec![self.steps; starts.len()], |seen| {
                running.iter_mut().for_each(|one| one.observe(seen));
            })
        } else {
            gait.advance(at, &starts, self.steps)
        };
        let rotations = match self.observe.contains(&Watch::Rotation) {
            true => Self::rotations(gait, at, &starts, &walked),
            false => Vec::new(),
        };
        let mut rows: Vec<Vec<Entry>> =
            walked.iter().map(|walked| vec![Entry::Integer(walked.steps as i64)]).collect();
        let mut rotations = rotations.into_iter();
        for (watch, one) in self.observe.iter().zip(running) {
            match watch {
                Watch::Last => {
                    for (row, walked) in rows.iter_mut().zip(&walked) {
                        row.extend(walked.last.iter().map(|&x| Entry::Double(x.into())));
                    }
                }
                Watch::Rotation => rows.iter_mut().zip(&mut rotations).for_each(|(row, one)| one.report(row)),
                _ => one.report(&mut rows),
            }
        }
        rows
    }

    /// The rotation of each variable of each orbit, in two more runs.
    fn rotations<T: Machine>(
        gait: Gait,
        at: &MapAt<T>,
        starts: &[Vec<T>],
        walked: &[Walked<T>],
    ) -> Vec<Rotations<T>> {
        let steps: Vec<u64> = walked.iter().map(|walked| walked.steps).collect();
        let variables = at.map().field().variables().len();
        let mut both = vec![T::zero(); 2 * variables];
        let mut with_rates = |x: &[T]| {
            both[..variables].copy_from_slice(x);
            // Both are as long as the field has variables.
            let _ = at.field(x, &mut both[variables..]);
            both.clone()
        };
        let of = |k: usize| Extrema::of(Box::new(move |both: &[T]| both[k]) as Quantity<T>);
        let mut extrema: Vec<Vec<_>> = starts.iter().map(|_| (0..2 * variables).map(of).collect()).collect();
        gait.walk(at, starts, &steps, |seen| {
            seen.each().for_each(|(orbit, x)| extrema[orbit].observe(seen.step, &with_rates(x)));
        });
        let with_steps = extrema.into_iter().zip(&steps);
        let mut rotations: Vec<_> =
            with_steps.map(|(extrema, &steps)| Rotations::new(steps, extrema.report())).collect();
        gait.walk(at, starts, &steps, |seen| {
            seen.each().for_each(|(orbit, x)| rotations[orbit].observe(seen.step, &with_rates(x)));
        });
        rotations
    }
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
