//! Compares the predicted with the observed growth of errors of a lift's relations.
//!
//! Each lift that `kahan lift` considers runs to the time 300 at ε = 0.01. If a relative error of a
//! relation or a state exceeds 0.05, the lift runs again at ε/8. If an error at ε/8 exceeds 0.05,
//! the lift runs at ε/64. A lift is bad if an error of its last run exceeds 0.05. Other lifts are
//! good, or good at smaller ε if an error of a relation exceeded 0.05 at ε = 0.01.

use std::fmt;

use kahan_lift::{Lift, LiftCriterion, RelationBehaviour};

use crate::systems::{System, distance, size};

const EPS: f64 = 0.01;
const TIME: f64 = 300.0;
const LOOKS: u32 = 300;
const GOOD: f64 = 0.05;
/// The factors by which ε is reduced if a lift is not good at ε = 0.01.
const FINER: [u32; 2] = [8, 64];
const MOST: usize = 120;

/// The largest errors along an orbit, relative to the sizes of the variables.
#[derive(Clone, Copy)]
struct Errors {
    relations: f64,
    states: f64,
}

impl fmt::Display for Errors {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{:.0e} and {:.0e}", self.relations, self.states)
    }
}

fn errors(system: &System, lift: &Lift, reference: &[Vec<f64>], finer: u32) -> Errors {
    let at = system.map(lift).at(EPS / f64::from(finer));
    let steps = (TIME / (2.0 * EPS) / f64::from(LOOKS)).round() as u64 * u64::from(finer);
    let mut sizes = vec![0.0_f64; lift.order()];
    for states in reference {
        let new = lift.embed(states, &system.values());
        sizes.iter_mut().zip(new).for_each(|(size, value)| *size = size.max(value.abs()));
    }
    let length = reference.iter().map(|states| size(states)).fold(0.0, f64::max);
    let mut point = system.embedded(lift, &system.start);
    let mut errors = Errors { relations: 0.0, states: 0.0 };
    for expected in reference {
        at.advance(&mut point, steps).expect("the dimension of the lift");
        let (reached, new) = point.split_at(expected.len());
        for ((value, wanted), size) in new.iter().zip(lift.embed(reached, &system.values())).zip(&sizes) {
            let error = (value - wanted).abs() / size;
            errors.relations = if error.is_finite() { errors.relations.max(error) } else { f64::INFINITY };
        }
        if !system.is("chaotic") {
            errors.states = errors.states.max(distance(reached, expected) * size(expected) / length);
        }
    }
    errors
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Predicted {
    Stable,
    Drifts,
    Grows,
}

impl Predicted {
    fn of(lift: &Lift) -> Self {
        match lift.relations.iter().filter_map(|one| one.along).find(|one| *one != RelationBehaviour::Kept) {
            Some(RelationBehaviour::Grows) => Predicted::Grows,
            Some(RelationBehaviour::Drifts) => Predicted::Drifts,
            _ => Predicted::Stable,
        }
    }

    fn name(self) -> &'static str {
        ["stable", "drifts", "grows"][self as usize]
    }
}

/// A lift with its errors at ε = 0.01, and at smaller ε if the errors at ε = 0.01 are large.
struct Judged {
    predicted: Predicted,
    errors: Vec<Errors>,
    lift: Lift,
}

impl Judged {
    fn new(system: &System, lift: Lift, reference: &[Vec<f64>]) -> Self {
        let mut judged = Judged { predicted: Predicted::of(&lift), errors: Vec::new(), lift };
        for finer in [1].into_iter().chain(FINER) {
            if !judged.is_right() {
                judged.errors.push(errors(system, &judged.lift, reference, finer));
            }
        }
        judged
    }

    fn is_right(&self) -> bool {
        self.errors.last().is_some_and(|one| one.relations <= GOOD && one.states <= GOOD)
    }

    fn fate(&self) -> usize {
        if self.is_right() { usize::from(self.errors[0].relations > GOOD) } else { 2 }
    }

    fn errors(&self) -> String {
        self.errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    }
}

/// The number of lifts for each prediction and outcome: good, good at smaller ε, or bad.
#[derive(Clone, Copy, Default)]
struct Counts([[usize; 3]; 3]);

impl Counts {
    fn add(&mut self, judged: &Judged) {
        self.0[judged.predicted as usize][judged.fate()] += 1;
    }

    fn row(&self) -> String {
        let cell = |counts: &[usize; 3]| counts.map(|count| count.to_string()).join(" / ");
        self.0.iter().map(cell).collect::<Vec<_>>().join(" | ")
    }
}

pub(crate) fn stability() {
    println!(
        "Errors are those of relations and of states, at ε = 0.01 and, where they are large, ε/8 and ε/64."
    );
    println!(
        "| system | stable: good / at smaller ε / bad | drifts: the same | grows: the same | chosen: predicted, errors |"
    );
    println!("|---|---|---|---|---|");
    let mut all = Counts::default();
    let mut misses = Vec::new();
    let mut wrong = Vec::new();
    for system in System::all() {
        let chosen = system.lift(LiftCriterion::Automatic);
        if chosen.order() == 0 {
            continue;
        }
        let reference = system.solution(TIME, LOOKS, 1e-12);
        let mut counts = Counts::default();
        let lifts = system.lifts();
        let stride = lifts.len().div_ceil(MOST).max(1);
        for lift in lifts.into_iter().step_by(stride) {
            let judged = Judged::new(&system, lift, &reference);
            counts.add(&judged);
            let is_right = match judged.predicted {
                Predicted::Stable => judged.fate() == 0,
                Predicted::Drifts => true,
                Predicted::Grows => judged.fate() > 0,
            };
            if !is_right {
                let rate = judged.lift.relations.iter().find_map(|one| one.rate).unwrap_or(0.0);
                let (order, name) = (judged.lift.order(), judged.predicted.name());
                misses.push(format!(
                    "{}: order {order}, {name} at {rate:.3}: {}",
                    system.name,
                    judged.errors()
                ));
            }
        }
        for (sum, own) in all.0.iter_mut().flatten().zip(counts.0.iter().flatten()) {
            *sum += own;
        }
        let judged = Judged::new(&system, chosen, &reference);
        if judged.fate() == 2 {
            wrong.push(system.name);
        }
        println!("| {} | {} | {}: {} |", system.name, counts.row(), judged.predicted.name(), judged.errors());
    }
    println!("| all | {} | |\n", all.row());
    let share = |part: usize, predicted: Predicted| {
        let whole: usize = all.0[predicted as usize].iter().sum();
        100.0 * part as f64 / whole as f64
    };
    let [[good, later, _], _, [_, late, bad]] = all.0;
    println!(
        "predicted stable: {:.1} % good, {:.1} % at smaller ε, too",
        share(good, Predicted::Stable),
        share(good + later, Predicted::Stable)
    );
    println!(
        "predicted to grow: {:.1} % bad, {:.1} % at every ε",
        share(late + bad, Predicted::Grows),
        share(bad, Predicted::Grows)
    );
    println!("chosen and bad at every ε: {wrong:?}\n\nMisses:");
    misses.iter().for_each(|miss| println!("{miss}"));
}
