//! The observers of an orbit, as a plan names them, and their columns.

use kahan_core::observe::{
    Burst, Escape, Extrema, Fli, Grouped, Lyapunov, MeanLogDet, Megno, Observer, Observers, Sali, Spectrum,
};
use kahan_runtime::{IntegralDrift, MapAt};

use super::orbit::{Machine, Orbit};
use crate::columns::{Column, Kind};
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
type Quantity<T> = Box<dyn Fn(&[T]) -> T>;
/// A condition on a point.
type Condition<T> = Box<dyn Fn(&[T]) -> bool>;

/// What is observed of an orbit; its report are the entries of the columns.
enum Running<'a, T: Machine> {
    Last(Vec<T>),
    Drift(IntegralDrift<'a, T>),
    Extrema(Vec<Extrema<Quantity<T>, T>>),
    Lyapunov(Lyapunov<&'a MapAt<T>>),
    Spectrum(Spectrum<&'a MapAt<T>>),
    LogDet(MeanLogDet<&'a MapAt<T>>),
    Fli(Fli<&'a MapAt<T>>),
    Megno(Megno<&'a MapAt<T>>),
    Sali(Sali<&'a MapAt<T>>),
    Escape(Escape<Condition<T>>),
    /// What is found in runs of its own.
    Rotation,
}

impl<'a, T: Machine> Running<'a, T> {
    fn new(watch: Watch, at: &'a MapAt<T>, orbit: &Orbit) -> Self {
        let variables = at.map().field().variables().len();
        match watch {
            Watch::Last => Running::Last(vec![T::zero(); variables]),
            Watch::Drift => Running::Drift(IntegralDrift::of(at)),
            Watch::Extrema => {
                let of = |k: usize| Extrema::of(Box::new(move |x: &[T]| x[k]) as Quantity<T>);
                Running::Extrema((0..variables).map(of).collect())
            }
            Watch::Lyapunov => Running::Lyapunov(Lyapunov::new(at)),
            Watch::Spectrum => Running::Spectrum(Spectrum::new(at, variables, orbit.every)),
            Watch::LogDet => Running::LogDet(MeanLogDet::new(at)),
            Watch::Fli => Running::Fli(Fli::new(at)),
            Watch::Megno => Running::Megno(Megno::new(at)),
            Watch::Sali => Running::Sali(Sali::new(at)),
            Watch::Rotation => Running::Rotation,
            Watch::Escape => {
                let radius = orbit.escape;
                let beyond = move |x: &[T]| !x.iter().all(|&x| x.into().abs() <= radius);
                Running::Escape(Escape::when(Box::new(beyond) as Condition<T>))
            }
        }
    }

    /// The entries of its columns.
    fn report(self) -> Vec<f64> {
        match self {
            Running::Last(last) => last.into_iter().map(Into::into).collect(),
            Running::Drift(one) => {
                one.report().into_iter().flat_map(|drifted| [drifted.max, drifted.last]).collect()
            }
            Running::Extrema(one) => {
                let ends = one.report().into_iter();
                ends.flat_map(|ends| {
                    ends.map_or([f64::NAN; 2], |ends| [ends.least.into(), ends.greatest.into()])
                })
                .collect()
            }
            Running::Lyapunov(one) => {
                let exponent = one.report();
                vec![exponent.value, exponent.error]
            }
            Running::Spectrum(one) => one.report().into_iter().map(|exponent| exponent.value).collect(),
            Running::LogDet(one) => vec![one.report()],
            Running::Fli(one) => vec![one.report()],
            Running::Megno(one) => vec![one.report().mean],
            Running::Sali(one) => vec![one.report()],
            Running::Escape(one) => {
                vec![Observer::<T>::report(one).map_or(f64::NAN, |step| step as f64)]
            }
            Running::Rotation => Vec::new(),
        }
    }
}

/// What a plan observes of an orbit, in its order.
pub(super) struct Watches<'a, T: Machine>(Vec<Running<'a, T>>);

impl<'a, T: Machine> Watches<'a, T> {
    pub(super) fn new(orbit: &Orbit, at: &'a MapAt<T>) -> Self {
        Watches(orbit.observe.iter().map(|watch| Running::new(*watch, at, orbit)).collect())
    }
}

impl<T: Machine> Observer<T> for Watches<'_, T> {
    type Report = Vec<Vec<f64>>;

    const MAY_END: bool = false;

    fn observe(&mut self, step: u64, x: &[T]) {
        for watch in &mut self.0 {
            match watch {
                Running::Last(last) => last.copy_from_slice(x),
                Running::Drift(one) => one.observe(step, x),
                Running::Extrema(one) => one.observe(step, x),
                Running::Lyapunov(one) => one.observe(step, x),
                Running::Spectrum(one) => one.observe(step, x),
                Running::LogDet(one) => one.observe(step, x),
                Running::Fli(one) => one.observe(step, x),
                Running::Megno(one) => one.observe(step, x),
                Running::Sali(one) => one.observe(step, x),
                Running::Escape(one) => one.observe(step, x),
                Running::Rotation => {}
            }
        }
    }

    /// Each watch of all orbits at once, so that their tangent vectors and integrals go side by
    /// side.
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>) {
        /// Shows a burst to what all orbits have at a place, which is of one variant.
        macro_rules! show {
            ($place:expr, $($variant:ident),*) => {
                match group[0].as_ref().map(|watches| &watches.0[$place]) {
                    $(Some(Running::$variant(_)) => {
                        let mut own = group.each_mut().map(|watches| match watches {
                            Some(watches) => match &mut watches.0[$place] {
                                Running::$variant(one) => Some(one),
                                _ => None,
                            },
                            None => None,
                        });
                        Observer::observe_burst(&mut own, burst);
                    })*
                    Some(Running::Last(_)) => {
                        let Some((_, points)) = burst.steps().last() else { continue };
                        for (lane, watches) in group.iter_mut().flatten().enumerate() {
                            if let Running::Last(last) = &mut watches.0[$place] {
                                points.read(lane, last);
                            }
                        }
                    }
                    Some(Running::Rotation) | None => {}
                }
            };
        }
        for place in 0..group[0].as_ref().map_or(0, |watches| watches.0.len()) {
            show!(place, Drift, Extrema, Lyapunov, Spectrum, LogDet, Fli, Megno, Sali, Escape);
        }
    }

    fn report(self) -> Self::Report {
        self.0.into_iter().map(Running::report).collect()
    }
}
