//! Chains in all units of length and time.

use kahan_core::prelude::*;
use kahan_runtime::{FieldText, Lattice};

use crate::UNITS;
use crate::answers::{Answers, Dimension, LENGTH, NUMBER, check_units};
use crate::fields::{Unit, two_to};

const SITES: usize = 700;

kahan! {
    /// Lorenz's model of an atmosphere: advection around a ring, with damping and a force.
    struct Atmosphere { q, nu }
    for i in periodic {
        x[i]dot = nu*(q*x[i-1]*(x[i+1] - x[i-2]) - x[i] + 8/q);
    }
}

kahan! {
    /// Coupled springs with a quadratic force.
    struct Springs { q, nu }
    for i in periodic {
        x[i]dot = nu*p[i];
        p[i]dot = nu*(x[i+1] - 2*x[i] + x[i-1] + q*(x[i+1] - x[i])^2 - q*(x[i] - x[i-1])^2);
    }
    hamiltonian H = sum(nu*(p[i]^2/2 + (x[i+1] - x[i])^2/2 + q*(x[i+1] - x[i])^3/3));
}

fn start(unit: Unit, len: usize) -> Vec<f64> {
    (0..len).map(|i| unit.length(1.0 + 0.3 * ((37 * i) % 19) as f64 / 19.0)).collect()
}

fn add_orbit<M: LatticeMap<f64> + Clone>(
    map: &M,
    unknowns: usize,
    eps: f64,
    unit: Unit,
    answers: &mut Answers,
) {
    let mut at = map.at(unit.time(eps), SITES).unwrap();
    let start = start(unit, unknowns);
    let mut state = start.clone();
    at.advance(&mut state, 20);
    answers.add("orbit", LENGTH, &state);
    at.step_back(&mut state);
    answers.add("back", LENGTH, &state);
    let mut next = start.clone();
    at.step(&mut next);
    answers.add("residual", NUMBER, &[at.residual(&start, &next)]);
    // `try_step` may round differently in other units of length and time, but succeeds alike.
    answers.say("promise", at.try_step(&mut next).is_ok());
}

#[test]
fn chains_have_the_same_bits_in_every_unit() {
    check_units("atmosphere", &UNITS, |unit, answers| {
        let map = Atmosphere { q: two_to(unit.length), nu: two_to(unit.time) };
        add_orbit(&map, SITES, 0.01, unit, answers);
    });
    check_units("springs", &UNITS, |unit, answers| {
        let map = Springs { q: two_to(unit.length), nu: two_to(unit.time) };
        add_orbit(&map, 2 * SITES, 0.1, unit, answers);
        let energy = Dimension { length: 2, time: -1 };
        let state = start(unit, 2 * SITES);
        let mut at = map.at(unit.time(0.1), SITES).unwrap();
        answers.add("energy", energy, &[at.hamiltonian(&state), at.modified_energy(&state)]);
    });
}

#[test]
fn chains_that_are_read_have_the_same_bits_in_every_unit() {
    let text = "for i in periodic { x[i]dot = nu*(q*x[i-1]*(x[i+1] - x[i-2]) - x[i] + 8/q); }";
    let family = FieldText::new(text.to_owned(), "chain".to_owned()).family().unwrap().unwrap();
    check_units("atmosphere", &UNITS, |unit, answers| {
        let values = [("q", [two_to(unit.length)]), ("nu", [two_to(unit.time)])];
        let mut at = Lattice::of(&family).at(unit.time(0.01), 40, values).unwrap();
        let mut state = start(unit, 40);
        for _ in 0..20 {
            at.step(&mut state).unwrap();
        }
        answers.add("orbit", LENGTH, &state);
    });
}
