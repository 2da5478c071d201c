//! The observers of an orbit, as a plan names them, and their columns.

use kahan_core::observe::{
    Drift, Escape, Extrema, Fli, Lyapunov, MeanLogDet, Megno, Observer, Rotation, Sali, Spectrum,
};
use kahan_runtime::MapAt;

use super::orbit::{Machine, Orbit};
use super::walk::Seen;
use crate::columns::{Column, Entry, Kind};
use crate::plan::Plan;

/// What may be observed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Watch {
    Last,
    Drift,
    Extrema,
    Lyapunov,
    Spectrum,
    LogDet,
    Fli,
    Megno,
    Sali,
    Rotation,
    Escape,
}

/// Their names in a plan.
pub(crate) const WATCHES: [(&str, Watch); 11] = [
    ("final", Watch::Last),
    ("drift", Watch::Drift),
    ("extrema", Watch::Extrema),
    ("lyapunov", Watch::Lyapunov),
    ("spectrum", Watch::Spectrum),
    ("log_det", Watch::LogDet),
    ("fli", Watch::Fli),
    ("megno", Watch::Megno),
    ("sali", Watch::Sali),
    ("rotation", Watch::Rotation),
    ("escape", Watch::Escape),
];

impl Watch {
    pub(crate) fn columns(self, plan: &Plan) -> Vec<Column> {
        let double = |name: String, meaning: &str| Column::new(name, Kind::Double, meaning);
        let variables = plan.field.variables();
        let each = |parts: &[(&str, &str, &str)]| {
            let columns = variables.iter().flat_map(|name| {
                parts
                    .iter()
                    .map(move |(before, after, meaning)| double(format!("{before}{name}{after}"), meaning))
            });
            columns.collect()
        };
        let one = |name: &str, meaning: &str| vec![double(name.to_owned(), meaning)];
        match self {
            Watch::Last => each(&[("final_", "", "value after the last step")]),
            Watch::Drift => {
                let columns = plan.field.integrals().iter().flat_map(|name| {
                    [
                        double(
                            format!("drift_{name}"),
                            "largest change of the integral, relative to its first value",
                        ),
                        double(
                            format!("drift_{name}_final"),
                            "change of the integral after the last step, relative to its first value",
                        ),
                    ]
                });
                columns.collect()
            }
            Watch::Extrema => each(&[("least_", "", "least value"), ("greatest_", "", "greatest value")]),
            Watch::Lyapunov => {
                let value = one("lyapunov", "largest Lyapunov exponent, per unit of time");
                [value, one("lyapunov_error", "how far the exponent has converged, per unit of time")]
                    .concat()
            }
            Watch::Spectrum => {
                let all = 1..=variables.len();
                all.flat_map(|k| one(&format!("lyapunov_{k}"), "Lyapunov exponent, per unit of time"))
                    .collect()
            }
            Watch::LogDet => one("mean_log_det", "sum of all Lyapunov exponents, per unit of time"),
            Watch::Fli => one("fli", "fast Lyapunov indicator"),
            Watch::Megno => one("megno", "mean exponential growth factor of nearby orbits"),
            Watch::Sali => one("sali", "smaller alignment index"),
            Watch::Rotation => each(&[
                ("rotation_", "", "turns a step, modulo 1"),
                ("rotation_", "_error", "turns a step that may be wrong"),
            ]),
            Watch::Escape => {
                one("escaped", "step after which a variable is beyond `escape`; not a number where none is")
            }
        }
    }
}

/// A number of a point.
pub(super) type Quantity<T> = Box<dyn Fn(&[T]) -> T>;
/// A condition on a point.
type Condition<T> = Box<dyn Fn(&[T]) -> bool>;
/// Two numbers of a point.
type Plane<T> = Box<dyn Fn(&[T]) -> [T; 2]>;

/// What is observed of some orbits, an observer an orbit.
pub(super) enum Running<'a, T: Machine, F> {
    /// Those of one orbit behind those of another.
    Drift {
        at: &'a MapAt<T>,
        values: Vec<T>,
        drifts: Vec<Drift<F, T, 1>>,
    },
    Extrema(Vec<Vec<Extrema<Quantity<T>, T>>>),
    Lyapunov(Vec<Lyapunov<&'a MapAt<T>>>),
    Spectrum(Vec<Spectrum<&'a MapAt<T>>>),
    LogDet(Vec<MeanLogDet<&'a MapAt<T>>>),
    Fli(Vec<Fli<&'a MapAt<T>>>),
    Megno(Vec<Megno<&'a MapAt<T>>>),
    Sali(Vec<Sali<&'a MapAt<T>>>),
    Escape(Vec<Escape<Condition<T>>>),
    /// What needs no look at the points on the way.
    Nothing,
}

impl<'a, T: Machine, F: Fn(&[T]) -> [T; 1] + Copy> Running<'a, T, F> {
    /// Observers of so many orbits; `own` is the number that a slice of one number holds.
    pub(super) fn new(watch: Watch, at: &'a MapAt<T>, orbit: &Orbit, orbits: usize, own: F) -> Self {
        let (variables, integrals) = (at.map().field().variables().len(), at.map().field().integrals().len());
        let maps = || (0..orbits).map(|_| at);
        match watch {
            Watch::Drift => {
                let drifts = (0..orbits * integrals).map(|_| Drift::of(own)).collect();
                Running::Drift { at, values: vec![T::zero(); integrals], drifts }
            }
            Watch::Extrema => {
                let of = |k: usize| Extrema::of(Box::new(move |x: &[T]| x[k]) as Quantity<T>);
                Running::Extrema((0..orbits).map(|_| (0..variables).map(of).collect()).collect())
            }
            Watch::Lyapunov => Running::Lyapunov(maps().map(Lyapunov::new).collect()),
            Watch::Spectrum => {
                Running::Spectrum(maps().map(|map| Spectrum::new(map, variables, orbit.every)).collect())
            }
            Watch::LogDet => Running::LogDet(maps().map(MeanLogDet::new).collect()),
            Watch::Fli => Running::Fli(maps().map(Fli::new).collect()),
            Watch::Megno => Running::Megno(maps().map(Megno::new).collect()),
            Watch::Sali => Running::Sali(maps().map(Sali::new).collect()),
            Watch::Escape => {
                let radius = orbit.escape;
                let beyond = move |x: &[T]| !x.iter().all(|&x| x.into().abs() <= radius);
                Running::Escape((0..orbits).map(|_| Escape::when(Box::new(beyond) as Condition<T>)).collect())
            }
            Watch::Last | Watch::Rotation => Running::Nothing,
        }
    }

    pub(super) fn observe(&mut self, seen: &Seen<'_, T>) {
        match self {
            Running::Drift { at, values, drifts } => {
                let integrals = values.len();
                for (orbit, x) in seen.each() {
                    // The state is as long as the field has variables.
                    let _ = at.integrals(x, values);
                    for (drift, value) in drifts[orbit * integrals..].iter_mut().zip(values.iter()) {
                        drift.observe(seen.step, std::slice::from_ref(value));
                    }
                }
            }
            Running::Extrema(each) => show(each, seen),
            Running::Lyapunov(each) => show(each, seen),
            Running::Spectrum(each) => show(each, seen),
            Running::LogDet(each) => show(each, seen),
            Running::Fli(each) => show(each, seen),
            Running::Megno(each) => show(each, seen),
            Running::Sali(each) => show(each, seen),
            Running::Escape(each) => show(each, seen),
            Running::Nothing => {}
        }
    }

    /// Adds the entries of its columns to the row of each orbit.
    pub(super) fn report(self, rows: &mut [Vec<Entry>]) {
        match self {
            Running::Drift { values, drifts, .. } => {
                // Without integrals there is nothing to share out.
                let integrals = values.len().max(1);
                for (place, drift) in drifts.into_iter().enumerate() {
                    let [drifted] = drift.report();
                    put(&mut rows[place / integrals], &[drifted.max, drifted.last]);
                }
            }
            Running::Extrema(each) => tell(each, rows, |ends| {
                let ends = ends.into_iter().flat_map(|ends| match ends {
                    Some(ends) => [ends.least.into(), ends.greatest.into()],
                    None => [f64::NAN; 2],
                });
                ends.collect()
            }),
            Running::Lyapunov(each) => tell(each, rows, |exponent| vec![exponent.value, exponent.error]),
            Running::Spectrum(each) => {
                tell(each, rows, |exponents| exponents.into_iter().map(|exponent| exponent.value).collect());
            }
            Running::LogDet(each) => tell(each, rows, |value| vec![value]),
            Running::Fli(each) => tell(each, rows, |value| vec![value]),
            Running::Megno(each) => tell(each, rows, |megno| vec![megno.mean]),
            Running::Sali(each) => tell(each, rows, |value| vec![value]),
            Running::Escape(each) => {
                tell(each, rows, |step| vec![step.map_or(f64::NAN, |step| step as f64)]);
            }
            Running::Nothing => {}
        }
    }
}

fn show<T, O: Observer<T>>(observers: &mut [O], seen: &Seen<'_, T>) {
    seen.each().for_each(|(orbit, x)| observers[orbit].observe(seen.step, x));
}

fn tell<T, O: Observer<T>>(
    observers: Vec<O>,
    rows: &mut [Vec<Entry>],
    numbers: impl Fn(O::Report) -> Vec<f64>,
) {
    for (observer, row) in observers.into_iter().zip(rows) {
        put(row, &numbers(observer.report()));
    }
}

fn put(row: &mut Vec<Entry>, numbers: &[f64]) {
    row.extend(numbers.iter().map(|&number| Entry::Double(number)));
}

/// The rotation of each variable about the middle of its extremes, in the plane of the variable and
/// its rate, seen in a second run.
pub(super) struct Rotations<T: Machine> {
    of: Vec<Option<Rotation<Plane<T>, T>>>,
}

impl<T: Machine> Rotations<T> {
    /// From the extremes of variables, and behind them those of their rates.
    pub(super) fn new(steps: u64, extremes: Vec<Option<kahan_core::observe::Extremes<T>>>) -> Self {
        let variables = extremes.len() / 2;
        let of = (0..variables).map(|k| {
            let plane = Box::new(move |both: &[T]| [both[k], both[variables + k]]) as Plane<T>;
            Some(Rotation::between(steps, plane, [extremes[k]?, extremes[variables + k]?]))
        });
        Self { of: of.collect() }
    }

    pub(super) fn observe(&mut self, step: u64, both: &[T]) {
        self.of.iter_mut().flatten().for_each(|rotation| rotation.observe(step, both));
    }

    pub(super) fn report(self, entries: &mut Vec<Entry>) {
        for rotation in self.of {
            let turns = rotation.map(Observer::report);
            entries.push(Entry::Double(turns.map_or(f64::NAN, |turns| turns.value)));
            entries.push(Entry::Double(turns.map_or(f64::NAN, |turns| turns.error)));
        }
    }
}
