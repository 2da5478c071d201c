//! Whether errors of relations grow as is predicted.
//!
//! In: all lifts and forms between which `kahan lift` chooses. Each is followed at ε = 0.01 to the
//! time 300. It is good if the relations hold to 5 % of the size of their variable, and the states
//! come as near to the solution where that is predictable. Table: how many were good and bad, by
//! what was predicted, then every miss.

use kahan_lift::{Along, Lift, Which};

use crate::systems::{System, distance};

const EPS: f64 = 0.01;
const TIME: f64 = 300.0;
/// How often states and relations are looked at.
const LOOKS: u32 = 300;
/// The largest error of what is good.
const GOOD: f64 = 0.05;
/// The factor by which ε is smaller where what was predicted stable is bad at first.
const FINER: u32 = 8;

/// The largest errors along an orbit of the map, relative to the size of their variables.
struct Errors {
    relations: f64,
    states: f64,
}

impl Errors {
    fn is_good(&self) -> bool {
        self.relations <= GOOD && self.states <= GOOD
    }
}

fn largest<'a>(rows: impl Iterator<Item = &'a [f64]>) -> Vec<f64> {
    rows.fold(Vec::new(), |mut most: Vec<f64>, row| {
        most.resize(row.len(), 0.0);
        most.iter_mut().zip(row).for_each(|(most, value)| *most = most.max(value.abs()));
        most
    })
}

fn errors(system: &System, lift: &Lift, reference: &[Vec<f64>], finer: u32) -> Errors {
    let at = system.map(lift).at(EPS / f64::from(finer));
    let states = system.start.len();
    let steps = (TIME / (2.0 * EPS) / f64::from(LOOKS)).round() as u64 * u64::from(finer);
    let mut point = system.embedded(lift, &system.start);
    let embedded: Vec<_> =
        reference.iter().map(|states| lift.embed(states, &system.values())).collect();
    let sizes = largest(embedded.iter().map(Vec::as_slice));
    let size = largest(reference.iter().map(Vec::as_slice)).into_iter().fold(0.0, f64::max);
    let mut errors = Errors { relations: 0.0, states: 0.0 };
    for expected in reference {
        at.advance(&mut point, steps).expect("the dimension of the lift");
        let (reached, new) = point.split_at(states);
        for ((value, wanted), size) in new.iter().zip(lift.embed(reached, &system.values())).zip(&sizes) {
            let error = (value - wanted).abs() / size;
            errors.relations = if error.is_finite() { errors.relations.max(error) } else { f64::INFINITY };
        }
        if !system.is("chaotic") {
            let length = expected.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            errors.states = errors.states.max(distance(reached, expected) * length / size);
        }
    }
    errors
}

/// What is predicted of the relations that are not kept.
fn predicted(lift: &Lift) -> Along {
    let mut others = lift.relations.iter().filter_map(|one| one.along).filter(|one| *one != Along::Kept);
    others.next().unwrap_or(Along::Kept)
}

pub(crate) fn stability() {
    let dump = std::env::var("DUMP").is_ok();
    for system in System::all() {
        let Some(reference) = system.solution(TIME, LOOKS, 1e-12) else {
            println!("{}: no reference", system.name);
            continue;
        };
        let judge = |lift: &Lift, label: &str| {
            let along = predicted(lift);
            let found = errors(&system, lift, &reference, 1);
            let fine = if !found.is_good() { Some(errors(&system, lift, &reference, FINER)) } else { None };
            if dump {
                println!("{}\t{label}\t{}\t{along:?}\t{:?}\t{:.1e}\t{:.1e}\t{}", system.name, lift.order(),
                    lift.relations.iter().find_map(|r| r.rate), found.relations, found.states,
                    fine.map_or(String::new(), |f| format!("{:.1e}\t{:.1e}", f.relations, f.states)));
            }
        };
        judge(&system.lift(Which::Automatic), "default");
        for lift in system.lifts() {
            if lift.order() > 0 {
            judge(&lift, "any");
            }
        }
    }
}
