//! What the rules of polarisation and rotation give is kept by the map, to the last digit.

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::field::Field;
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::modified_integrals::{ModifiedIntegral, Rule, modified_integral, modified_integrals};
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::{Random, SplitMix64};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::read;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::System;

fn system(text: &str) -> System {
    read(&lex(text).tokens).system().unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"))
}

/// The system of such components.
fn system_of(symbols: &Symbols, components: &[Polynomial]) -> System {
    let equations = symbols.states.iter().zip(components);
    let lines: Vec<String> =
        equations.map(|(state, value)| format!("{state}dot = {};", Text.polynomial(symbols, value))).collect();
    system(&lines.join(" "))
}

fn value(polynomial: &Polynomial, at: &[Rational]) -> Rational {
    polynomial.terms().fold(Rational::zero(), |sum, (monomial, coefficient)| {
        let powers = monomial.powers().iter();
        let term = powers.fold(coefficient.clone(), |product, (variable, exponent)| {
            &product * &at[usize::from(variable.0)].pow(*exponent as i32).expect("exponents are positive")
        });
        &sum + &term
    })
}

/// p/d with small p and d.
fn small(random: &mut SplitMix64) -> Rational {
    Rational::new(random.below(13) as i64 - 6, 1 + random.below(5) as i64)
}

/// Whether the map keeps a function at three random points, parameters and steps.
fn is_kept(system: &System, function: &RationalFunction, random: &mut SplitMix64) -> bool {
    let interpreter = Interpreter::new(system);
    let symbols = &system.field.symbols;
    let mut points = 0;
    while points < 3 {
        let [state, parameters] = [symbols.dimension(), symbols.parameters.len()]
            .map(|count| (0..count).map(|_| small(random)).collect::<Vec<_>>());
        let eps = Rational::new(1 + random.below(9) as i64, 7);
        let point = Point { state, parameters, eps };
        let is_defined = interpreter.evaluate(&Exact, &point).is_ok();
        let Some(next) = interpreter.next(&Exact, &point).filter(|_| is_defined) else { continue };
        let [here, there] = [point.state.clone(), next].map(|state| {
            let all = [state, point.parameters.clone(), vec![point.eps.clone()]].concat();
            value(function.numerator(), &all).checked_div(&value(function.denominator(), &all))
        });
        let (Some(here), Some(there)) = (here, there) else { continue };
        if here != there {
            return false;
        }
        points += 1;
    }
    true
}

/// The formulas found for a text, `kept of the flow → kept by the map`, each checked.
fn found(text: &str) -> Vec<String> {
    let system = system(text);
    let symbols = &system.field.symbols;
    let found = modified_integrals(&system.field);
    let written = |function: &RationalFunction| {
        let [above, below] =
            [function.numerator(), function.denominator()].map(|side| Text.polynomial(symbols, side));
        if below == "1" { above } else { format!("({above})/({below})") }
    };
    let line = |found: &ModifiedIntegral| {
        assert!(is_kept(&system, &found.of_map, &mut SplitMix64::new(1)), "{text}: {found:?}");
        check_limit(&system.field, found);
        format!("{:?}: {}", found.rule, written(&found.of_map))
    };
    found.iter().map(line).collect()
}

/// I where ε = 0, and found for I alone, too.
fn check_limit(field: &Field, found: &ModifiedIntegral) {
    let eps = field.symbols.epsilon();
    let [above, below] = [found.of_map.numerator(), found.of_map.denominator()]
        .map(|side| side.substitute(eps, &Rational::zero()));
    assert_eq!(RationalFunction::new(above, below), Some(found.of_flow.clone().into()));
    assert_eq!(modified_integral(field, &found.of_flow).as_ref(), Some(found));
}

#[test]
fn print() {
    for text in [
        "xdot = y; ydot = x*w - 3*y^2 + y*w; wdot = 2*x*y;",
        "xdot = p; pdot = -s; sdot = c*p; cdot = -s*p;",
        "xdot = p; pdot = -g/l*s; sdot = c*p; cdot = -s*p;",
        "xdot = p; pdot = -s - k*p; sdot = c*p; cdot = -s*p;",
        "xdot = p; pdot = 2*v - 2*u; udot = -u*p; vdot = -2*v*p;",
        "xdot = p; ydot = q; pdot = -F; qdot = -G; adot = -3*a*b; bdot = c - 2*b^2 - a; cdot = -2*b*(a + c); \
         Fdot = a*p - 3*b*F; Gdot = a*q - 3*b*G; udot = F*p + G*q;",
        "p1dot = -a; p2dot = a - b; p3dot = b; adot = a*(p1 - p2); bdot = b*(p2 - p3);",
        "xdot = a1*y*z; ydot = a2*z*x; zdot = a3*x*y;",
        "xdot = -x^2; ydot = x*y; zdot = -2*y^2 + x*z;",
        "sdot = k*s*m; wdot = -k*w*m; mdot = s*m + w^2 - 1;",
        "sdot = a*(c + 2)*m; cdot = b*(s - 1)*m; mdot = s*m + c^2 - 1;",
        "sdot = c*(m + 1); cdot = -s*(m + 1); udot = v*(m + 1); vdot = -u*(m + 1); mdot = s*u - m^2;",
        "xdot = y; ydot = -x; zdot = w; wdot = -z;",
        "xdot = (2*x + 3*y)*z; ydot = (x - 2*y)*z; zdot = x*y + 1;",
        "x1dot = y1; y1dot = -F1; x2dot = y2; y2dot = -F2; F1dot = x1*F2; F2dot = y1*y2; Wdot = F1*y1 + F2*y2;",
    ] {
        println!("{text}\n  {:#?}", found(text));
    }
}
