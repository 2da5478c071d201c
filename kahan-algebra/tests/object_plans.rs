//! The plans of the objects compute what the objects are: each is run over ℚ and compared with the
//! interpreter, and the listing of a step is read back and computed line by line.

use std::collections::BTreeMap;

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::derived::StepListing;
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::plan::{Plan, StepPlan};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;
use kahan_algebra::system::System;
use kahan_algebra::{derive, read};

const SYSTEMS: [&str; 5] = [
    "xdot = x*(1 - y); ydot = y*(x - 1);",
    "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;
     integral H = y/x; integral K = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
     density rho = 2/(x*y*(x^2 + y^2 + z^2));
     bracket P { {y,z} = y*(1 + eps^2*(x^2 + y^2)); {z,x} = -x*(1 + eps^2*(x^2 + y^2)); }",
    "struct S { s, r, b } xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;",
    "struct S { m } xdot = x*y/m; ydot = (x^2 - y)/(1 + m) + 1/3; zdot = x*z;",
    "struct S { u, v, w } adot = (w - v)*y*z; bdot = (u - w)*z*x; cdot = (v - u)*x*y;
     xdot = y*c - z*b; ydot = z*a - x*c; zdot = x*b - y*a;",
];

fn system(text: &str) -> System {
    let reading = read(&lex(text).tokens);
    assert!(reading.diagnostics.is_empty(), "{text}: {:?}", reading.diagnostics);
    reading.system
}

fn point(system: &System) -> (Point<Rational>, Vec<Rational>) {
    let n = system.field.dimension() as i64;
    let state = (0..n).map(|i| Rational::new(2 * i + 3, i + 2)).collect();
    let parameters = (0..system.field.symbols.parameters.len() as i64).map(|k| Rational::new(k + 2, 3));
    let second = (0..n).map(|i| Rational::new(5 - 3 * i, 4)).collect();
    (Point { state, parameters: parameters.collect(), eps: Rational::new(1, 7) }, second)
}

/// Values of the results, `prepared` being those of the prepared constants.
fn run(plan: &Plan, system: &System, prepared: &[Option<Rational>]) -> Vec<Rational> {
    let (point, second) = point(system);
    let values = plan.evaluate_prepared(&Exact, prepared, |variable| {
        Some(match system.field.symbols.symbol(variable) {
            Symbol::State(i) => point.state[i].clone(),
            Symbol::Parameter(k) => point.parameters[k].clone(),
            Symbol::Epsilon => point.eps.clone(),
            Symbol::SecondState(i) => second[i].clone(),
        })
    });
    values.into_iter().map(|value| value.expect("no pole at this point")).collect()
}

#[test]
fn every_object_has_the_interpreters_value() {
    for text in SYSTEMS {
        let system = system(text);
        let (point, second) = point(&system);
        let interpreter = Interpreter::new(&system);
        let expected = interpreter.evaluate(&Exact, &point).expect("the field has a value");
        let derived = derive(&system);
        let step = derived.step().expect("a closed form");
        let prepared = |constants: &Plan| -> Vec<Option<Rational>> {
            run(constants, &system, &[]).into_iter().map(Some).collect()
        };
        let own = prepared(&step.constants);
        let general = step.general.as_ref().map(|general| prepared(&general.constants));
        let next = expected.next.clone().expect("no pole");
        let claims = |integrals: &[(String, Option<Rational>)]| -> Vec<Rational> {
            integrals.iter().map(|(_, value)| value.clone().expect("a value")).collect()
        };
        let mut seen = 0;
        for (name, plan) in derived.functions() {
            // Clebsch's N and D are beyond the budget; its step is not.
            let Some(plan) = plan else {
                assert!(["det A", "(N, D)"].contains(&name.as_str()) && derived.map.is_none());
                continue;
            };
            let constants = if name == "general step" { general.as_ref().expect("one") } else { &own };
            let values = run(&plan, &system, constants);
            let value = match name.as_str() {
                "field f" => expected.field.clone(),
                "f'(x)" => expected.field_jacobian.concat(),
                "Q(x,x')" => interpreter.bilinear(&Exact, &point, &second).expect("a value"),
                "polarised field" => interpreter.polarized(&Exact, &point, &second).expect("a value"),
                "prepared constants" | "general constants" => continue,
                "step" | "general step" => next.clone(),
                "det A" => vec![expected.det_matrix.clone()],
                "(N, D)" => {
                    let below = expected.det_matrix.clone();
                    next.iter().map(|x| x * &below).chain([below.clone()]).collect()
                }
                "(N, D) reduced" => {
                    let below = values.last().expect("a denominator").clone();
                    next.iter().map(|x| x * &below).chain([below.clone()]).collect()
                }
                "integrals" => claims(&expected.integrals),
                "density" => vec![expected.density.clone().flatten().expect("a value")],
                "bracket P" => {
                    let tensor = expected.brackets[0].1.clone().expect("a value");
                    vec![tensor[0][1].clone(), tensor[0][2].clone(), tensor[1][2].clone()]
                }
                name => panic!("{name} is not compared"),
            };
            assert_eq!(values, value, "{name} of {text}");
            seen += 1;
        }
        assert!(seen >= 5, "{seen} objects of {text}");
    }
}

#[test]
fn a_field_beyond_straight_lines_has_no_plan_of_its_step() {
    let states = ["a", "b", "c", "d", "e", "f", "g", "h"];
    let text: String =
        states.iter().map(|state| format!("{state}dot = ({})^2;", states.join(" + "))).collect();
    let dense = states.iter().enumerate().fold(text, |text, (i, state)| {
        text.replace(&format!("{state}dot = ("), &format!("{state}dot = {}*{state}*a + (", i + 2))
    });
    let system = system(&dense);
    let derived = derive(&system);
    assert!(derived.map.is_none() && derived.step().is_none(), "the field is large enough");
    let without: Vec<String> =
        derived.functions().into_iter().filter(|(_, plan)| plan.is_none()).map(|(name, _)| name).collect();
    assert_eq!(without, ["prepared constants", "step", "det A", "(N, D)"]);
}

/// One line `name = right` of a listing, computed with the values so far.
fn compute(line: &str, values: &mut BTreeMap<String, Rational>) {
    let (name, right) = line.split_once(" = ").expect("an equation");
    let lookup = |text: &str| -> Rational {
        let (negative, text) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let inner = text.trim_start_matches('(').trim_end_matches(')');
        let value =
            values.get(inner).cloned().or_else(|| Rational::parse(inner)).expect("a name or a number");
        if negative { -value } else { value }
    };
    let product = |text: &str| -> Rational {
        // The slash of a literal stands in parentheses.
        if let Some((a, b)) = text.rsplit_once('/').filter(|(_, below)| !below.contains(')')) {
            return lookup(a).checked_div(&lookup(b)).expect("no pole");
        }
        text.split('*').map(lookup).reduce(|a, b| &a * &b).expect("a factor")
    };
    let value = if let Some((a, b)) = right.split_once(" + ") {
        &product(a) + &product(b)
    } else if let Some((a, b)) = right.split_once(" - ") {
        &product(a) - &product(b)
    } else {
        product(right)
    };
    let known = values.insert(name.to_owned(), value);
    assert!(known.is_none(), "{name} is defined twice");
}

#[test]
fn a_listing_can_be_computed_line_by_line() {
    for text in SYSTEMS {
        let system = system(text);
        let (point, _) = point(&system);
        let symbols = &system.field.symbols;
        let step = StepPlan::of(&system.field).expect("a closed form");
        let listing = StepListing::of(&step, symbols);
        let states = symbols.states.iter().cloned().zip(point.state.iter().cloned());
        let parameters = symbols.parameters.iter().cloned().zip(point.parameters.iter().cloned());
        let mut values: BTreeMap<String, Rational> = states.chain(parameters).collect();
        values.insert("eps".to_owned(), point.eps.clone());
        let kept = |line: &&String| line.contains('=');
        let lines = listing.constants.iter().filter(kept).chain(&listing.kernel).chain(&listing.next);
        for line in lines {
            compute(line, &mut values);
        }
        let next = Interpreter::new(&system).next(&Exact, &point).expect("no pole");
        for (state, value) in symbols.states.iter().zip(next) {
            assert_eq!(values[&format!("{state}~")], value, "{state}~ of {text}");
        }
        for reciprocal in listing.reciprocals.iter().flatten() {
            assert!(values.contains_key(reciprocal), "{reciprocal} of {text}");
        }
    }
}
