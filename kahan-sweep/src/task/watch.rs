//! The observers of an orbit, as a plan names them, and their columns.

use kahan_core::observe::{
    Drift, Escape, Extrema, Fli, Lyapunov, MeanLogDet, Megno, Observer, Rotation, Sali, Spectrum,
};
use kahan_runtime::{MapAt, TangentAt};

use super::orbit::{Machine, Orbit};
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

/// An observer at work.
pub(super) enum Running<'a, T: Machine, F> {
    Drift {
        at: &'a MapAt<T>,
        values: Vec<T>,
        drifts: Vec<Drift<F, T, 1>>,
    },
    Extrema(Vec<Extrema<Box<dyn Fn(&[T]) -> T>, T>>),
    Lyapunov(Lyapunov<TangentAt<T>, T>),
    Spectrum(Spectrum<TangentAt<T>, T>),
    LogDet(MeanLogDet<TangentAt<T>, T>),
    Fli(Fli<TangentAt<T>, T>),
    Megno(Megno<TangentAt<T>, T>),
    Sali(Sali<TangentAt<T>, T>),
    Escape(Escape<Box<dyn Fn(&[T]) -> bool>>),
    /// What needs no look at the points on the way.
    Nothing,
}

impl<'a, T: Machine, F: Fn(&[T]) -> [T; 1] + Copy> Running<'a, T, F> {
    /// An observer of an orbit at the beginning; `own` is the number that a slice of one number holds.
    pub(super) fn new(watch: Watch, at: &'a MapAt<T>, orbit: &Orbit, own: F) -> Self {
        let (variables, integrals) = (at.map().field().variables().len(), at.map().field().integrals().len());
        match watch {
            Watch::Drift => {
                let drifts = (0..integrals).map(|_| Drift::of(own)).collect();
                Running::Drift { at, values: vec![T::zero(); integrals], drifts }
            }
            Watch::Extrema => {
                let of = |k: usize| Extrema::of(Box::new(move |x: &[T]| x[k]) as Box<dyn Fn(&[T]) -> T>);
                Running::Extrema((0..variables).map(of).collect())
            }
            Watch::Lyapunov => Running::Lyapunov(Lyapunov::new(at.tangent())),
            Watch::Spectrum => Running::Spectrum(Spectrum::new(at.tangent(), variables, orbit.every)),
            Watch::LogDet => Running::LogDet(MeanLogDet::new(at.tangent())),
            Watch::Fli => Running::Fli(Fli::new(at.tangent())),
            Watch::Megno => Running::Megno(Megno::new(at.tangent())),
            Watch::Sali => Running::Sali(Sali::new(at.tangent())),
            Watch::Escape => {
                let radius = orbit.escape;
                Running::Escape(Escape::when(Box::new(move |x: &[T]| {
                    !x.iter().all(|&x| x.into().abs() <= radius)
                }) as Box<dyn Fn(&[T]) -> bool>))
            }
            Watch::Last | Watch::Rotation => Running::Nothing,
        }
    }

    #[inline]
    pub(super) fn observe(&mut self, step: u64, x: &[T]) {
        match self {
            Running::Drift { at, values, drifts } => {
                // The state is as long as the field has variables.
                let _ = at.integrals(x, values);
                for (drift, value) in drifts.iter_mut().zip(values.iter()) {
                    drift.observe(step, std::slice::from_ref(value));
                }
            }
            Running::Extrema(extrema) => extrema.iter_mut().for_each(|one| one.observe(step, x)),
            Running::Lyapunov(one) => one.observe(step, x),
            Running::Spectrum(one) => one.observe(step, x),
            Running::LogDet(one) => one.observe(step, x),
            Running::Fli(one) => one.observe(step, x),
            Running::Megno(one) => one.observe(step, x),
            Running::Sali(one) => one.observe(step, x),
            Running::Escape(one) => one.observe(step, x),
            Running::Nothing => {}
        }
    }

    /// The entries of its columns.
    pub(super) fn report(self, entries: &mut Vec<Entry>) {
        let mut put = |value: f64| entries.push(Entry::Double(value));
        match self {
            Running::Drift { drifts, .. } => {
                for drift in drifts {
                    let [drifted] = drift.report();
                    put(drifted.max);
                    put(drifted.last);
                }
            }
            Running::Extrema(extrema) => {
                for one in extrema {
                    let ends = one.report();
                    put(ends.map_or(f64::NAN, |ends| ends.least.into()));
                    put(ends.map_or(f64::NAN, |ends| ends.greatest.into()));
                }
            }
            Running::Lyapunov(one) => {
                let exponent = one.report();
                put(exponent.value);
                put(exponent.error);
            }
            Running::Spectrum(one) => one.report().into_iter().for_each(|exponent| put(exponent.value)),
            Running::LogDet(one) => put(one.report()),
            Running::Fli(one) => put(one.report()),
            Running::Megno(one) => put(one.report().mean),
            Running::Sali(one) => put(one.report()),
            Running::Escape(one) => put(one.report().map_or(f64::NAN, |step| step as f64)),
            Running::Nothing => {}
        }
    }
}

/// The rotation of each variable about the middle of its extremes, in the plane of the variable and
/// its rate, seen in a second run.
pub(super) struct Rotations<T: Machine> {
    of: Vec<Option<Rotation<Box<dyn Fn(&[T]) -> [T; 2]>, T>>>,
}

impl<T: Machine> Rotations<T> {
    /// From the extremes of variables, and behind them those of their rates.
    pub(super) fn new(steps: u64, extremes: Vec<Option<kahan_core::observe::Extremes<T>>>) -> Self {
        let variables = extremes.len() / 2;
        let of = (0..variables).map(|k| {
            let plane =
                Box::new(move |both: &[T]| [both[k], both[variables + k]]) as Box<dyn Fn(&[T]) -> [T; 2]>;
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
