//! The list of observables with their observers, and the observation of one or many orbits.
//!
//! In: a map for each orbit, first points, and observables. Out: the observed values in the
//! requested order, equal for single orbits and for groups.
//!
//! # Files
//!
//! An observable can have a file in `running/`, such as `last.rs`. There, `ABOUT` describes the
//! observable, `Own` is the type of its observer, `observer` makes an observer, and `seen` turns it
//! into the observed value.

use std::ops::ControlFlow;

use kahan_core::observe::{
    Burst, Escape, Extrema, Extremes, Fli, GROUP, Grouped, Lyapunov, MeanLogDet, Megno, Observer, Observers,
    Sali, SparseObserver, Spectrum,
};
use kahan_core::{EmbedScalar, Step};

use super::ObservationRequest;
use super::carried::has_carried;
use super::observable::{ColumnScope, ObservableInfo, ObservedValue};
use super::tangent::TangentCarrier;
use crate::{
    DimensionError, End, Follow, Followed, IntegralDrift, MachineFloat, MapAt, PassedPoles, WhileFinite,
};

/// The extremes of each xᵢ, then those of each ẋᵢ. Their midpoints are the centers of rotation.
type Middles<T> = [Vec<Option<Extremes<T>>>; 2];
type Quantity<T> = Box<dyn Fn(&[T]) -> T>;

macro_rules! observables {
    ($at:ident, $carrier:ident, $asked:ident, $middles:ident: $(
        $name:ident, $meaning:literal,
        $(in $module:ident)? $($type:ty = $new:expr, $one:ident => $seen:expr, $about:expr)?;
    )*) => {
        $($(mod $module;)?)*

        /// An observable of an orbit.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Observable {
            $(#[doc = $meaning] $name,)*
        }

        impl Observable {
            /// All observables.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// The names of all observables, in the order of [`ALL`](Self::ALL).
            pub const NAMES: &'static [&'static str] = &[$(($($module::ABOUT)? $($about)?).name),*];

            /// Returns the meaning, as a sentence.
            #[must_use]
            pub fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => $meaning,)*
                }
            }

            pub(super) fn about(self) -> ObservableInfo {
                match self {
                    $(Self::$name => $($module::ABOUT)? $($about)?,)*
                }
            }
        }

        /// The observer of one observable. `M` is the type of the observer that finds the extremes
        /// for rotations, and `B` the type of the test for escapes.
        enum RunningObserver<'a, T: MachineFloat + EmbedScalar, M, B> {
            $($name($($module::Own<'a, T>)? $($type)?),)*
        }

        fn running<'a, T: MachineFloat + EmbedScalar + PartialOrd>(
            observable: Observable,
            $at: &'a MapAt<T>,
            $carrier: &TangentCarrier<'a, T>,
            $asked: &ObservationRequest<'_>,
        ) -> RunningObserver<'a, T, impl Observer<T, Report = Middles<T>> + use<'a, T>, impl Fn(&[T]) -> bool + use<T>> {
            match observable {
                $(Observable::$name => RunningObserver::$name($($module::observer($at, $asked))? $($new)?),)*
            }
        }

        impl<T, M, B> RunningObserver<'_, T, M, B>
        where
            T: MachineFloat + EmbedScalar + PartialOrd,
            M: Observer<T, Report = Middles<T>>,
            B: Fn(&[T]) -> bool,
        {
            fn observe(&mut self, step: u64, x: &[T]) {
                match self {
                    $(RunningObserver::$name(one) => one.observe(step, x),)*
                }
            }

            /// Shows a burst of consecutive points to the observers of one observable.
            fn observe_burst<P: Grouped<T>>(mut own: [Option<&mut Self>; GROUP], burst: &Burst<'_, P>) {
                match &own[0] {
                    $(Some(RunningObserver::$name(_)) => {
                        let mut own = own.each_mut().map(|running| match running {
                            Some(RunningObserver::$name(one)) => Some(one),
                            _ => None,
                        });
                        Observer::observe_burst(&mut own, burst);
                    })*
                    None => {}
                }
            }

            fn resumed(&mut self) -> Option<&mut dyn SparseObserver<T>> {
                match self {
                    $(RunningObserver::$name(one) => one.resumed(),)*
                }
            }

            fn report(self, $middles: &mut Option<Middles<T>>) -> ObservedValue {
                match self {
                    $(RunningObserver::$name(own) => {
                        $($module::seen(own))?
                        $({
                            let $one = own;
                            $seen
                        })?
                    })*
                }
            }
        }
    };
}

observables! {
    at, carrier, asked, middles:
    Last, "The last point.", in last;
    Lyapunov, "The largest Lyapunov exponent, per unit of time.",
        Lyapunov<TangentCarrier<'a, T>> = Lyapunov::new(carrier.clone()), one => ObservedValue::Exponent(one.report()),
        ObservableInfo::new("lyapunov", ColumnScope::Orbit, &[
            ("lyapunov", "largest Lyapunov exponent, per unit of time"),
            ("lyapunov_error", "how far the exponent has converged, per unit of time"),
        ]).of_tangent_vectors().usual().colour("largest exponent per unit of t");
    Spectrum, "All Lyapunov exponents, or the K largest, per unit of time.",
        Spectrum<TangentCarrier<'a, T>> = {
            let exponents = asked.exponents.min(Step::dimension(carrier));
            Spectrum::new(carrier.clone(), exponents, asked.renormalize)
        },
        one => ObservedValue::Spectrum(one.report()),
        ObservableInfo::new("spectrum", ColumnScope::Numbers, &[
            ("spectrum_{}", "Lyapunov exponent, the largest first, per unit of time"),
        ]).of_tangent_vectors().usual();
    LogDet, "The mean of log |det ∂x̃/∂x| per unit of time, the sum of all exponents.",
        MeanLogDet<TangentCarrier<'a, T>> = MeanLogDet::new(carrier.clone()), one => ObservedValue::Number(one.report()),
        ObservableInfo::new("log_det", ColumnScope::Orbit, &[
            ("mean_log_det", "sum of all Lyapunov exponents, per unit of time"),
        ]).of_tangent_vectors().usual().colour("sum of all exponents per unit of t");
    Fli, "FLI, the fast Lyapunov indicator.",
        Fli<TangentCarrier<'a, T>> = Fli::new(carrier.clone()), one => ObservedValue::Number(one.report()),
        ObservableInfo::new("fli", ColumnScope::Orbit, &[("fli", "fast Lyapunov indicator")])
            .of_tangent_vectors().usual().colour("FLI");
    Megno, "The mean of MEGNO, the mean exponential growth factor of nearby orbits.",
        Megno<TangentCarrier<'a, T>> = Megno::new(carrier.clone()), one => ObservedValue::Number(one.report().mean),
        ObservableInfo::new("megno", ColumnScope::Orbit, &[("megno", "mean exponential growth factor of nearby orbits")])
            .of_tangent_vectors().usual().colour("mean MEGNO");
    Sali, "SALI, the smaller alignment index of two tangent vectors.",
        Sali<TangentCarrier<'a, T>> = Sali::new(carrier.clone()), one => ObservedValue::Number(one.report()),
        ObservableInfo::new("sali", ColumnScope::Orbit, &[("sali", "smaller alignment index")])
            .of_tangent_vectors().usual().colour("SALI").logarithmic();
    Rotation, "The rotation number of each variable, in turns per step.",
        M = at.extremes(), one => {
            *middles = Some(one.report());
            // A second pass over the orbit computes the rotation numbers, and fills this list.
            ObservedValue::Turns(Vec::new())
        },
        ObservableInfo::new("rotation", ColumnScope::Variables, &[
            ("rotation_{}", "turns a step, modulo 1"),
            ("rotation_{}_error", "turns a step that may be wrong"),
        ]).usual();
    Drift, "The largest change of each claimed integral, relative to its first value.",
        IntegralDrift<'a, T> = IntegralDrift::of(at), one => ObservedValue::Drift(one.report()),
        ObservableInfo::new("drift", ColumnScope::Integrals, &[
            ("drift_{}", "largest change of the integral, relative to its first value"),
            ("drift_{}_final", "change of the integral after the last step, relative to its first value"),
        ]).usual().colour("greatest relative drift").logarithmic();
    Extrema, "The least and the greatest value of each variable.",
        Vec<Extrema<Quantity<T>, T>> =
            (0..at.dimension()).map(|k| Extrema::of(Box::new(move |x: &[T]| x[k]) as Quantity<T>)).collect(),
        one => ObservedValue::Extrema(one.report().into_iter().map(|of| of.map(in_doubles)).collect()),
        ObservableInfo::new("extrema", ColumnScope::Variables, &[
            ("least_{}", "least value"), ("greatest_{}", "greatest value"),
        ]).usual();
    Escape, "The step after which a variable is larger than a bound.",
        Escape<B> = {
            let size = asked.escape.unwrap_or(ObservationRequest::USUAL_SIZE);
            Escape::when(move |x: &[T]| !x.iter().all(|x| x.approximate().abs() <= size))
        }, one => ObservedValue::Step(Observer::<T>::report(one)),
        ObservableInfo::new("escape", ColumnScope::Orbit, &[
            ("escaped", "step after which a variable is beyond `escape`; not a number where none is"),
        ]).usual().colour("step of the escape");
    PassedPoles, "The number of steps that pass over a pole of the map.",
        PassedPoles<'a, T> = PassedPoles::of(at), one => ObservedValue::Passed(one.report()),
        ObservableInfo::new("passed_poles", ColumnScope::Orbit, &[
            ("passed_poles", "steps over a pole: the reduced denominator has a root in (0, ε]"),
            ("passed_poles_lower_bound", "1 where that is a lower bound, by the sign of det A, else 0"),
        ]).of_the_map().colour("steps over a pole");
}

fn in_doubles<T: MachineFloat>(of: Extremes<T>) -> Extremes<f64> {
    Extremes { least: of.least.approximate(), greatest: of.greatest.approximate() }
}

/// The observers of one orbit. The report holds the values, and the extremes for a second pass.
struct AllObservers<'a, T: MachineFloat + EmbedScalar, M, B> {
    carrier: TangentCarrier<'a, T>,
    running: Vec<(Observable, RunningObserver<'a, T, M, B>)>,
}

fn all<'a, T: MachineFloat + EmbedScalar + PartialOrd>(
    at: &'a MapAt<T>,
    asked: &ObservationRequest<'a>,
) -> AllObservers<'a, T, impl Observer<T, Report = Middles<T>> + use<'a, T>, impl Fn(&[T]) -> bool + use<T>> {
    let needs_vectors = asked.of.iter().any(|one| one.is_of_tangent_vectors());
    let carrier = TangentCarrier::new(at, asked.relations.filter(|_| needs_vectors));
    let own = |one: &Observable| (*one, running(*one, at, &carrier, asked));
    let running = asked.of.iter().map(own).collect();
    AllObservers { carrier, running }
}

impl<T, M, B> Observer<T> for AllObservers<'_, T, M, B>
where
    T: MachineFloat + EmbedScalar + PartialOrd,
    M: Observer<T, Report = Middles<T>>,
    B: Fn(&[T]) -> bool,
{
    type Report = (Vec<ObservedValue>, Option<Middles<T>>);

    const MAY_END: bool = false;

    fn observe(&mut self, step: u64, x: &[T]) {
        self.carrier.follow(step, x);
        for (observable, running) in &mut self.running {
            let seen = if observable.is_of_tangent_vectors() { self.carrier.seen(x) } else { x };
            running.observe(step, seen);
        }
    }

    /// Shows a burst of consecutive points of all orbits to the observers, one observable after the
    /// other.
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>) {
        let Some(first) = &group[0] else { return };
        if first.carrier.plane.is_some() {
            for (lane, all) in group.iter_mut().flatten().enumerate() {
                burst.show(lane, 0, |step, x| all.observe(step, x));
            }
            return;
        }
        for place in 0..first.running.len() {
            let own = group.each_mut().map(|all| Some(&mut all.as_mut()?.running[place].1));
            RunningObserver::observe_burst(own, burst);
        }
    }

    fn resumed(&mut self) -> Option<&mut dyn SparseObserver<T>> {
        let can_resume = self.running.iter_mut().all(|(_, running)| running.resumed().is_some());
        if can_resume && self.carrier.plane.is_none() { Some(self) } else { None }
    }

    fn report(self) -> Self::Report {
        let mut middles = None;
        let seen = self.running.into_iter().map(|(_, running)| running.report(&mut middles)).collect();
        (seen, middles)
    }
}

impl<T: MachineFloat + EmbedScalar, M, B> SparseObserver<T> for AllObservers<'_, T, M, B>
where
    T: PartialOrd,
    M: Observer<T, Report = Middles<T>>,
    B: Fn(&[T]) -> bool,
{
    fn vectors(&mut self) -> usize {
        self.running
            .iter_mut()
            .filter_map(|(_, running)| running.resumed())
            .map(SparseObserver::vectors)
            .sum()
    }

    fn vector(&mut self, k: usize) -> &[T] {
        let mut before = 0;
        for resumed in self.running.iter_mut().filter_map(|(_, running)| running.resumed()) {
            let own = resumed.vectors();
            if k < before + own {
                return resumed.vector(k - before);
            }
            before += own;
        }
        unreachable!("there are {before} vectors")
    }

    fn resume(&mut self, step: u64, x: &[T], entry: &dyn Fn(usize, usize) -> T) {
        let mut before = 0;
        for resumed in self.running.iter_mut().filter_map(|(_, running)| running.resumed()) {
            resumed.resume(step, x, &|k, i| entry(before + k, i));
            before += resumed.vectors();
        }
    }
}

/// Observes the orbit of `start` under `step`; a second pass finds rotations.
pub(super) fn observe_one<T: MachineFloat + EmbedScalar + PartialOrd>(
    step: &impl Follow<Scalar = T>,
    at: &MapAt<T>,
    start: &[T],
    asked: &ObservationRequest<'_>,
    tell: &dyn Fn(u64) -> ControlFlow<()>,
) -> Result<Followed<Vec<ObservedValue>>, DimensionError> {
    let bound = asked.escape_bound();
    let observers = WhileFinite::within(bound, all(at, asked));
    let Followed { report: own, end } = step.observe(&mut start.to_vec(), asked.steps, observers, tell)?;
    let Followed { report: (mut seen, middles), end: seen_end } = own;
    // If an observer ended the orbit, the end that it reports is used.
    let end = if seen_end == End::Complete { end } else { seen_end };
    if let Some(middles) = middles {
        let steps = end.steps(asked.steps);
        let again = if matches!(end, End::Stopped(_)) { 0 } else { steps };
        let turns = step.observe(&mut start.to_vec(), again, at.rotations(steps, &middles), tell)?;
        put(&mut seen, ObservedValue::Turns(turns.report));
    }
    Ok(Followed { report: seen, end })
}

pub(super) fn observe_many<T: MachineFloat + EmbedScalar + PartialOrd>(
    maps: &[&MapAt<T>],
    starts: &[Vec<T>],
    asked: &ObservationRequest<'_>,
    tell: &dyn Fn(u64) -> ControlFlow<()>,
) -> Result<Vec<Followed<Vec<ObservedValue>>>, DimensionError> {
    let observers = |orbit: usize| WhileFinite::within(asked.escape_bound(), all(maps[orbit], asked));
    let points = &mut starts.to_vec();
    let by_code =
        |maps: [&MapAt<T>; GROUP], points: &mut _, observers: &mut [_], tell: &mut dyn FnMut(u64) -> _| {
            has_carried(maps, points, observers, asked.steps, tell)
        };
    let first = MapAt::observe_groups(maps, &mut slices(points), asked.steps, observers, tell, by_code)?;
    let turns = if asked.of.contains(&Observable::Rotation) {
        let observers = |orbit: usize| {
            let Followed { report: (_, middles), end } = &first[orbit];
            let middles = middles.as_ref().expect("rotation is asked for");
            WhileFinite::within(asked.escape_bound(), maps[orbit].rotations(end.steps(asked.steps), middles))
        };
        let points = &mut starts.to_vec();
        let again = MapAt::observe_columns_while(maps, &mut slices(points), asked.steps, observers, tell)?;
        again.into_iter().map(|followed| Some(followed.report)).collect()
    } else {
        vec![None; first.len()]
    };
    let seen = first.into_iter().zip(turns).map(|(Followed { report: (mut seen, _), end }, turns)| {
        turns.into_iter().for_each(|turns| put(&mut seen, ObservedValue::Turns(turns)));
        Followed { report: seen, end }
    });
    Ok(seen.collect())
}

fn put(seen: &mut [ObservedValue], turns: ObservedValue) {
    seen.iter_mut()
        .filter(|seen| matches!(seen, ObservedValue::Turns(_)))
        .for_each(|seen| seen.clone_from(&turns));
}

fn slices<T>(columns: &mut [Vec<T>]) -> Vec<&mut [T]> {
    columns.iter_mut().map(Vec::as_mut_slice).collect()
}
