//! Periodic points and their branches, in all units of length and time.

use std::ops::ControlFlow;

use kahan_dynamics::periodic::{Branch, NoPeriodicPoint, PeriodicPoint, branch, periodic_point};
use kahan_runtime::Field;

use crate::UNITS;
use crate::answers::{Answers, Dimension, LENGTH, NUMBER, TIME, check_units};
use crate::fields::{CASES, Unit, map, two_to};

fn add_cycle(cycle: &PeriodicPoint, answers: &mut Answers) {
    answers.say("cycle", (cycle.points.len(), cycle.stability(), cycle.family));
    answers.add("points", LENGTH, &cycle.points.concat());
    answers.add("residual", LENGTH, &[cycle.residual, cycle.size()]);
    let multipliers = cycle.multipliers.iter().flat_map(|one| [one.re, one.im]);
    answers.add("multipliers", NUMBER, &multipliers.collect::<Vec<_>>());
}

fn add_branch(branch: &Branch, dimension: Dimension, answers: &mut Answers) {
    answers.say("cut", branch.is_cut);
    for point in &branch.points {
        answers.add("parameter", dimension, &[point.parameter]);
        add_cycle(&point.cycle, answers);
    }
    for turn in &branch.turns {
        answers.say("turn", turn.change);
        answers.add("parameter", dimension, &[turn.parameter]);
    }
}

#[test]
fn cycles_and_branches_have_the_same_bits_in_every_unit() {
    let mut found = 0;
    for case in &CASES {
        let field = case.field();
        for (period, part) in [(1, 0.9), (1, 0.0), (3, 1.0)] {
            let start = |unit| -> Vec<f64> { case.start(unit).iter().map(|x| part * x).collect() };
            let cycle =
                |unit: Unit| periodic_point(&map(&field, unit).at(unit.time(case.eps)), &start(unit), period);
            found += u32::from(cycle(crate::fields::ORDINARY).is_ok());
            check_units(case.name, &UNITS, |unit, answers| match cycle(unit) {
                Ok(cycle) => {
                    add_cycle(&cycle, answers);
                    let map = |eps| map(&field, unit).at(eps).by(None);
                    let range = [unit.time(case.eps), unit.time(2.5 * case.eps)];
                    add_branch(&branch(map, &cycle, range, 8, |_| ControlFlow::Continue(())), TIME, answers);
                }
                Err(NoPeriodicPoint::NotFound { residual }) => answers.add("none", LENGTH, &[residual]),
                Err(why) => answers.say("none", why),
            });
        }
    }
    assert!(found > 40, "{found} of 60");
}

#[test]
fn branches_over_a_parameter_have_the_same_bits_in_every_unit() {
    let fold = Field::parse("xdot = a - q*x^2 - x; ydot = x - y;").unwrap();
    let oscillator = Field::parse("xdot = y; ydot = b*y - x - q*x^2;").unwrap();
    for (field, name, [from, to], dimension, start) in [
        (&fold, "a", [0.0, -0.5], LENGTH, [0.0, 0.0]),
        (&fold, "a", [0.0, 2.0], LENGTH, [0.1, 0.2]),
        (&oscillator, "b", [-0.5, 0.5], NUMBER, [0.1, 0.1]),
    ] {
        check_units(name, &UNITS[..2], |unit, answers| {
            let scaled = |ordinary: f64| ordinary * two_to(-unit.length * dimension.length);
            let place = field.parameters().iter().position(|known| known == name);
            let at = |value: f64| {
                let values = [("q", two_to(unit.length)), (name, value)];
                field.with(values).unwrap().at(0.1).by(place)
            };
            let start = start.map(|x| unit.length(x));
            let cycle = periodic_point(&at(scaled(from)), &start, 1).unwrap();
            let branch = branch(at, &cycle, [scaled(from), scaled(to)], 12, |_| ControlFlow::Continue(()));
            assert!(branch.points.len() > 10, "{name}: {branch:?}");
            add_branch(&branch, dimension, answers);
        });
    }
}
