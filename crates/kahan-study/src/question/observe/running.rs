//! The observers of what is asked, and the orbits that they see.
//!
//! In: a map, or one an orbit, first points, and what is asked of each orbit. Out: what was seen, in
//! that order. An orbit has the same numbers alone and beside others.

use std::ops::ControlFlow;

use kahan_core::observe::{
    Burst, Escape, Extrema, Extremes, Fli, Grouped, Lyapunov, MeanLogDet, Megno, Observer, Observers, Sali,
    Spectrum,
};
use kahan_runtime::{Ended, Follow, Followed, IntegralDrift, MachineFloat, MapAt, WhileFinite};

use super::Observe;
use super::observable::{Observable, Seen};

/// Why calls of a map are not refused.
pub(in crate::question) const FITTING: &str = "a column a variable, all of one length, and a map an orbit";

/// The extremes of each variable, and of each rate of change.
type Middles<T> = [Vec<Option<Extremes<T>>>; 2];
/// A number of a point.
type Quantity<T> = Box<dyn Fn(&[T]) -> T>;
/// A condition on a point.
type Condition<T> = Box<dyn Fn(&[T]) -> bool>;

/// An observer of one thing; `M` sees what the rotation turns about.
enum Running<'a, T: MachineFloat, M> {
    Last(Last<T>),
    Drift(IntegralDrift<'a, T>),
    Extrema(Vec<Extrema<Quantity<T>, T>>),
    Lyapunov(Lyapunov<&'a MapAt<T>>),
    Spectrum(Spectrum<&'a MapAt<T>>),
    LogDet(MeanLogDet<&'a MapAt<T>>),
    Fli(Fli<&'a MapAt<T>>),
    Megno(Megno<&'a MapAt<T>>),
    Sali(Sali<&'a MapAt<T>>),
    Rotation(M),
    Escape(Escape<Condition<T>>),
}

/// The last point.
struct Last<T>(Vec<T>);

impl<T: MachineFloat> Observer<T> for Last<T> {
    type Report = Vec<T>;

    const MAY_END: bool = false;

    fn observe(&mut self, _: u64, x: &[T]) {
        self.0.clear();
        self.0.extend_from_slice(x);
    }

    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>) {
        let Some((step, points)) = burst.steps().last() else { return };
        for (lane, last) in group.iter_mut().flatten().enumerate() {
            last.observe(step, points.of(lane).as_ref());
        }
    }

    fn report(self) -> Vec<T> {
        self.0
    }
}

fn running<'a, T: MachineFloat + PartialOrd>(
    observable: Observable,
    at: &'a MapAt<T>,
    asked: &Observe,
) -> Running<'a, T, impl Observer<T, Report = Middles<T>> + use<'a, T>> {
    let variables = at.map().field().variables().len();
    match observable {
        Observable::Last => Running::Last(Last(Vec::new())),
        Observable::Drift => Running::Drift(IntegralDrift::of(at)),
        Observable::Extrema => {
            let of = |k: usize| Extrema::of(Box::new(move |x: &[T]| x[k]) as Quantity<T>);
            Running::Extrema((0..variables).map(of).collect())
        }
        Observable::Lyapunov => Running::Lyapunov(Lyapunov::new(at)),
        Observable::Spectrum => Running::Spectrum(Spectrum::new(at, variables, asked.every)),
        Observable::LogDet => Running::LogDet(MeanLogDet::new(at)),
        Observable::Fli => Running::Fli(Fli::new(at)),
        Observable::Megno => Running::Megno(Megno::new(at)),
        Observable::Sali => Running::Sali(Sali::new(at)),
        Observable::Rotation => Running::Rotation(at.extremes()),
        Observable::Escape => {
            let size = asked.escape;
            let is_beyond = move |x: &[T]| !x.iter().all(|x| x.approximate().abs() <= size);
            Running::Escape(Escape::when(Box::new(is_beyond) as Condition<T>))
        }
    }
}

/// All that is asked of an orbit. Its report is what was seen, and what a second run turns about.
struct All<'a, T: MachineFloat, M>(Vec<Running<'a, T, M>>);

fn all<'a, T: MachineFloat + PartialOrd>(
    at: &'a MapAt<T>,
    asked: &Observe,
) -> All<'a, T, impl Observer<T, Report = Middles<T>> + use<'a, T>> {
    All(asked.observables().map(|observable| running(observable, at, asked)).collect())
}

/// Does the same with the observer of each variant.
macro_rules! for_each_variant {
    ($macro:ident) => {
        $macro!(Last, Drift, Extrema, Lyapunov, Spectrum, LogDet, Fli, Megno, Sali, Rotation, Escape)
    };
}

impl<T, M> Observer<T> for All<'_, T, M>
where
    T: MachineFloat + PartialOrd,
    M: Observer<T, Report = Middles<T>>,
{
    type Report = (Vec<Seen>, Option<Middles<T>>);

    const MAY_END: bool = false;

    fn observe(&mut self, step: u64, x: &[T]) {
        for running in &mut self.0 {
            macro_rules! show {
                ($($variant:ident),*) => {
                    match running { $(Running::$variant(one) => one.observe(step, x),)* }
                };
            }
            for_each_variant!(show);
        }
    }

    /// Each observable of all orbits at once, so that their tangent vectors and integrals go side
    /// by side.
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>) {
        for place in 0..group[0].as_ref().map_or(0, |all| all.0.len()) {
            macro_rules! show {
                ($($variant:ident),*) => {
                    match group[0].as_ref().map(|all| &all.0[place]) {
                        $(Some(Running::$variant(_)) => {
                            let mut own = group.each_mut().map(|all| match &mut all.as_mut()?.0[place] {
                                Running::$variant(one) => Some(one),
                                _ => None,
                            });
                            Observer::observe_burst(&mut own, burst);
                        })*
                        None => {}
                    }
                };
            }
            for_each_variant!(show);
        }
    }

    fn report(self) -> Self::Report {
        let floats = |point: Vec<T>| point.iter().map(T::approximate).collect();
        let mut middles = None;
        let seen = self.0.into_iter().map(|running| match running {
            Running::Last(one) => Seen::Point(floats(one.report())),
            Running::Drift(one) => Seen::Drift(one.report()),
            Running::Extrema(one) => {
                let ends = |of: Extremes<T>| Extremes {
                    least: of.least.approximate(),
                    greatest: of.greatest.approximate(),
                };
                Seen::Extrema(one.report().into_iter().map(|of| of.map(ends)).collect())
            }
            Running::Lyapunov(one) => Seen::Exponent(one.report()),
            Running::Spectrum(one) => Seen::Spectrum(one.report()),
            Running::LogDet(one) => Seen::Number(one.report()),
            Running::Fli(one) => Seen::Number(one.report()),
            Running::Megno(one) => Seen::Number(one.report().mean),
            Running::Sali(one) => Seen::Number(one.report()),
            Running::Rotation(one) => {
                middles = Some(one.report());
                Seen::Turns(Vec::new())
            }
            Running::Escape(one) => Seen::Step(Observer::<T>::report(one)),
        });
        (seen.collect(), middles)
    }
}

/// What is seen of the orbit of `start`, which goes as far as its points are finite; a second run
/// counts turns, where they are asked for. `tell` hears of steps, and may stop the orbit.
pub(in crate::question) fn alone<T: MachineFloat + PartialOrd>(
    at: &MapAt<T>,
    start: &[T],
    asked: &Observe,
    tell: impl Fn(u64) -> ControlFlow<()>,
) -> Followed<Vec<Seen>> {
    let first = at.observe(&mut start.to_vec(), asked.steps, all(at, asked), &tell).expect(FITTING);
    let Followed { report: (mut seen, middles), steps, ended } = first;
    if let Some(middles) = middles {
        // Who stopped the first run wants no second one.
        let again = if ended == Ended::Stopped { 0 } else { steps };
        let turns = at.observe(&mut start.to_vec(), again, at.rotations(steps, &middles), &tell);
        put(&mut seen, Seen::Turns(turns.expect(FITTING).report));
    }
    Followed { report: seen, steps, ended }
}

/// The same of many orbits, side by side where there is code for that: a map an orbit, and column c
/// has variable c of all first points.
pub(in crate::question) fn abreast<T: MachineFloat + PartialOrd>(
    maps: &[&MapAt<T>],
    starts: &[Vec<T>],
    asked: &Observe,
) -> Vec<Followed<Vec<Seen>>> {
    let observers = |orbit: usize| WhileFinite::new(all(maps[orbit], asked));
    let first = MapAt::observe_columns(maps, &mut slices(&mut starts.to_vec()), asked.steps, observers);
    let first = first.expect(FITTING);
    let turns = if asked.of.contains(&Observable::Rotation) {
        let observers = |orbit: usize| {
            let Followed { report: (_, middles), steps, .. } = &first[orbit];
            WhileFinite::new(maps[orbit].rotations(*steps, middles.as_ref().expect("rotation is asked for")))
        };
        let again = MapAt::observe_columns(maps, &mut slices(&mut starts.to_vec()), asked.steps, observers);
        again.expect(FITTING).into_iter().map(|followed| Some(followed.report)).collect()
    } else {
        vec![None; first.len()]
    };
    let seen =
        first.into_iter().zip(turns).map(|(Followed { report: (mut seen, _), steps, ended }, turns)| {
            turns.into_iter().for_each(|turns| put(&mut seen, Seen::Turns(turns)));
            Followed { report: seen, steps, ended }
        });
    seen.collect()
}

/// Puts turns in their place.
fn put(seen: &mut [Seen], turns: Seen) {
    seen.iter_mut().filter(|seen| matches!(seen, Seen::Turns(_))).for_each(|seen| seen.clone_from(&turns));
}

/// Columns as maps take them.
fn slices<T>(columns: &mut [Vec<T>]) -> Vec<&mut [T]> {
    columns.iter_mut().map(Vec::as_mut_slice).collect()
}
