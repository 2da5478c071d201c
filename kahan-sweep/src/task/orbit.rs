//! Orbits in floats, observed in the loop.

use kahan_core::Composition;
use kahan_core::observe::{Extrema, Observer};
use kahan_runtime::{MachineFloat, Map, MapAt};

use super::watch::{Rotations, Running, Watch};
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
}

impl Follower {
    pub(super) fn new(plan: &Plan) -> Self {
        Self { map: None, prepared: None, columns: plan.task.columns(plan).len() }
    }

    /// What is found on the orbit of a point.
    pub(super) fn follow(
        &mut self,
        orbit: &Orbit,
        plan: &Plan,
        index: u64,
        values: &[f64],
        entries: &mut Vec<Entry>,
    ) {
        let point = plan.point(values, |value| *value as u32);
        let before = entries.len();
        match self.prepare(plan, index, &point) {
            Some(Prepared::Double(at)) => orbit.observed(at, &point.start, entries),
            Some(Prepared::Single(at)) => orbit.observed(at, &point.start, entries),
            None => {
                // Where the field divides by zero there is no orbit.
                entries.push(Entry::Integer(0));
                entries.resize(before + self.columns, Entry::Double(f64::NAN));
            }
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
    /// The steps made, and what the observers report.
    fn observed<T: Machine>(&self, at: &MapAt<T>, start: &[f64], entries: &mut Vec<Entry>) {
        let start: Vec<T> = start.iter().map(|&x| T::nearest(x)).collect();
        let own = |value: &[T]| [value[0]];
        let mut running: Vec<Running<'_, T, _>> =
            self.observe.iter().map(|watch| Running::new(*watch, at, self, own)).collect();
        let mut last = start.clone();
        let steps = if running.iter().all(|one| matches!(one, Running::Nothing)) {
            self.advance(at, &mut last)
        } else {
            let mut steps = 0;
            let made = self.walk(at, &start, self.steps, |step, x| {
                running.iter_mut().for_each(|one| one.observe(step, x));
                steps = step;
            });
            last = made;
            steps
        };
        entries.push(Entry::Integer(steps as i64));
        for (watch, one) in self.observe.iter().zip(running) {
            match watch {
                Watch::Last => entries.extend(last.iter().map(|&x| Entry::Double(x.into()))),
                Watch::Rotation => self.rotations(at, &start, steps).report(entries),
                _ => one.report(entries),
            }
        }
    }

    /// All steps without a look at the points, the steps made among them.
    fn advance<T: Machine>(&self, at: &MapAt<T>, x: &mut Vec<T>) -> u64 {
        let start = x.clone();
        // The state is as long as the field has variables.
        let _ = at.advance(x, self.steps);
        if x.iter().all(|&x| x.into().is_finite()) {
            return self.steps;
        }
        // Somewhere on the way numbers left their range: that step is looked for.
        let mut steps = 0;
        *x = self.walk(at, &start, self.steps, |step, _| steps = step);
        steps
    }

    /// Shows the points with their steps as long as they are numbers; the last of them.
    fn walk<T: Machine>(
        &self,
        at: &MapAt<T>,
        start: &[T],
        steps: u64,
        mut show: impl FnMut(u64, &[T]),
    ) -> Vec<T> {
        let mut x = start.to_vec();
        show(0, &x);
        for step in 1..=steps {
            // As above.
            let _ = at.advance(&mut x, 1);
            if !x.iter().all(|&x| x.into().is_finite()) {
                // The point before is found again, so that no other orbit pays for keeping it.
                x.copy_from_slice(start);
                let _ = at.advance(&mut x, step - 1);
                break;
            }
            show(step, &x);
        }
        x
    }

    /// The rotation of each variable, in two more runs.
    fn rotations<T: Machine>(&self, at: &MapAt<T>, start: &[T], steps: u64) -> Rotations<T> {
        let variables = start.len();
        let mut both = [start, start].concat();
        let mut with_rates = |x: &[T], see: &mut dyn FnMut(&[T])| {
            both[..variables].copy_from_slice(x);
            let _ = at.field(x, &mut both[variables..]);
            see(&both);
        };
        let of = |k: usize| Extrema::of(Box::new(move |both: &[T]| both[k]) as Box<dyn Fn(&[T]) -> T>);
        let mut extrema: Vec<_> = (0..2 * variables).map(of).collect();
        self.walk(at, start, steps, |step, x| with_rates(x, &mut |both| extrema.observe(step, both)));
        let mut rotations = Rotations::new(steps, extrema.report());
        self.walk(at, start, steps, |step, x| with_rates(x, &mut |both| rotations.observe(step, both)));
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
