//! Checks that the map preserves the integrals that `modified_integrals` finds.

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::field::Field;
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::modified_integrals::{ModifiedIntegral, Rule, modified_integral, modified_integrals};
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::System;
use kahan_algebra::{read, read_unproved};

fn system(text: &str) -> System {
    read(&lex(text).tokens).system().unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"))
}

fn system_of(symbols: &Symbols, components: &[Polynomial]) -> System {
    let equations = symbols.states.iter().zip(components);
    let lines: Vec<String> = equations
        .map(|(state, value)| format!("{state}dot = {};", Text.polynomial(symbols, value)))
        .collect();
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

fn small(random: &mut SplitMix64) -> Rational {
    Rational::new(random.below(13) as i64 - 6, 1 + random.below(5) as i64)
}

/// Returns whether the map preserves a function at three random points.
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

/// Checks that at ε = 0 the integral of the map is the integral of the flow.
fn check_limit(field: &Field, found: &ModifiedIntegral) {
    let eps = field.symbols.epsilon();
    let [above, below] = [found.of_map.numerator(), found.of_map.denominator()]
        .map(|side| side.substitute(eps, &Rational::zero()));
    assert_eq!(RationalFunction::new(above, below), Some(found.of_flow.clone().into()));
    assert_eq!(modified_integral(field, &found.of_flow).as_ref(), Some(found));
}

fn check(text: &str, expected: &[&str]) {
    assert_eq!(found(text), expected, "{text}");
}

#[test]
fn lifted_fields_keep_relations_and_energies() {
    let relation = "Polarisation: -w + x^2 - eps^2*y^2";
    check("xdot = y; ydot = x*w - 3*y^2 + y*w; wdot = 2*x*y;", &[relation]);
    check("xdot = y; ydot = mu*(y - w*y) - x; wdot = 2*x*y;", &[relation]);
    let turning = "Rotation: (s^2 + c^2)/(1 + eps^2*p^2)";
    check(
        "xdot = p; pdot = -s; sdot = c*p; cdot = -s*p;",
        &["Polarisation: -2*c + p^2 - eps^2*s^2", turning],
    );
    check(
        "xdot = p; pdot = -g/l*s; sdot = c*p; cdot = -s*p;",
        &["Polarisation: (-2*g*l*c + l^2*p^2 - eps^2*g^2*s^2)/(l)", turning],
    );
    check("xdot = p; pdot = -s - k*p; sdot = c*p; cdot = -s*p;", &[turning]);
    // Morse's potential is u² − 2u with u = exp(−x) and v = u².
    check(
        "xdot = p; pdot = 2*v - 2*u; udot = -u*p; vdot = -2*v*p;",
        &["Polarisation: -4*u + 2*v + p^2 - 4*eps^2*u^2 + 8*eps^2*u*v - 4*eps^2*v^2"],
    );
    check("xdot = w*y; ydot = -w*x;", &["Polarisation: x^2 + y^2"]);
    check(
        "p1dot = -a; p2dot = a - b; p3dot = b; adot = a*(p1 - p2); bdot = b*(p2 - p3);",
        &[
            "Polarisation: p1 + p2 + p3",
            "Polarisation: 2*a + 2*b + p1^2 + p2^2 + p3^2 - 2*eps^2*a^2 + 2*eps^2*a*b - 2*eps^2*b^2",
        ],
    );
    // Kepler's problem with r² = x² + y². The other variables are a = r⁻³, b = (xp + yq)/r², c =
    // (p² + q²)/r², F = ax, G = ay, u = −1/r.
    check(
        "xdot = p; ydot = q; pdot = -F; qdot = -G; adot = -3*a*b; bdot = c - 2*b^2 - a; \
         cdot = -2*b*(a + c); Fdot = a*p - 3*b*F; Gdot = a*q - 3*b*G; udot = F*p + G*q;",
        &["Polarisation: 2*u + p^2 + q^2 - eps^2*F^2 - eps^2*G^2"],
    );
}

#[test]
fn pairs_that_turn_are_found_with_their_scales_and_centres() {
    check(
        "xdot = a1*y*z; ydot = a2*z*x; zdot = a3*x*y;",
        &[
            "Hyperbolic: (-a2*x^2 + a1*y^2)/(-1 + eps^2*a1*a2*z^2)",
            "Hyperbolic: (-a3*x^2 + a1*z^2)/(-1 + eps^2*a1*a3*y^2)",
            "Hyperbolic: (-a3*y^2 + a2*z^2)/(-1 + eps^2*a2*a3*x^2)",
        ],
    );
    check("sdot = k*s*m; wdot = -k*w*m; mdot = s*m + w^2 - 1;", &["Hyperbolic: (-s*w)/(-1 + eps^2*k^2*m^2)"]);
    check(
        "xdot = (2*x + 3*y)*z; ydot = (x - 2*y)*z; zdot = x*y + 1;",
        &["Hyperbolic: (-x^2 + 4*x*y + 3*y^2)/(-1 + 7*eps^2*z^2)"],
    );
    check(
        "sdot = (c + 2)*m; cdot = (3 - s)*m; mdot = s*m + c^2 - 1;",
        &["Rotation: (13 - 6*s + 4*c + s^2 + c^2)/(1 + eps^2*m^2)"],
    );
    check("sdot = c*m; cdot = -s*m; mdot = 0;", &["Polarisation: m", "Rotation: s^2 + c^2"]);
    let four =
        found("sdot = c*(m + 1); cdot = -s*(m + 1); udot = v*(m + 1); vdot = -u*(m + 1); mdot = s*u - m^2;");
    assert_eq!(four.len(), 4);
    assert_eq!(four[1], "Rotation: (s*v - c*u)/(1 + eps^2 + 2*eps^2*m + eps^2*m^2)");
}

#[test]
fn fields_that_nearly_fit_keep_nothing() {
    for text in [
        // Polarisation needs an affine ẋ.
        "xdot = y + x^2; ydot = x*w - 3*y^2; wdot = 2*x*y + x^2;",
        "xdot = p; pdot = -s; sdot = 2*c*p; cdot = -s*p + c;",
        // The hyperbolic case needs ṡ/(sm) = −ẇ/(wm). In the next field, ċ contains m².
        "sdot = s*m; wdot = -2*w*m; mdot = s*m + w^2 - 1;",
        "sdot = c*m; cdot = (m - s)*m; mdot = s*m + w^2 - 1; wdot = s^2 - w;",
        "sdot = c*m + s*c; cdot = -s*m - s^2 + 1; mdot = s*m + c^2 - 1;",
    ] {
        check(text, &[]);
    }
    let euler = system("xdot = y*z; ydot = z*x; zdot = -2*x*y;");
    let of = |text: &str| {
        let claimed = read_unproved(&lex(&format!("xdot = {text}; ydot = 0*y; zdot = 0*z;")).tokens);
        claimed.system().expect("a system").field.components[0].numerator().clone()
    };
    assert!(modified_integral(&euler.field, &of("x^2 - y^2")).is_some());
    for text in ["x^2 + y^2 + z^2", "x^2 + y^2", "x", "3"] {
        assert!(modified_integral(&euler.field, &of(text)).is_none(), "{text}");
    }
    let with_eps = &of("x^2 - y^2") + &Polynomial::variable(euler.field.symbols.epsilon());
    assert!(modified_integral(&euler.field, &with_eps).is_none());
}

/// Returns a random polynomial in all states, with a parameter in the constant term.
fn polynomial(symbols: &Symbols, degree: u32, random: &mut SplitMix64) -> Polynomial {
    let mut factors = vec![Polynomial::one()];
    factors.extend((0..symbols.dimension()).map(|i| Polynomial::variable(symbols.state(i))));
    let mut sum = Polynomial::variable(symbols.parameter(0)).scale(&small(random));
    for i in 0..factors.len() {
        let last = if degree > 1 { i } else { 0 };
        for second in &factors[..=last] {
            sum = &sum + &(&factors[i] * second).scale(&small(random));
        }
    }
    sum
}

/// Returns the field in coordinates with xᵢ − `by` in place of xᵢ.
fn sheared(symbols: &Symbols, components: &[Polynomial], i: usize, by: &Polynomial) -> Vec<Polynomial> {
    let slopes = by.gradient(|variable| symbols.is_state(variable));
    let moved = slopes.into_iter().fold(components[i].clone(), |sum, (variable, slope)| {
        &sum - &(&slope * &components[usize::from(variable.0)])
    });
    let with = |component: &Polynomial| {
        component.composed(symbols.state(i), &(&Polynomial::variable(symbols.state(i)) + by))
    };
    let mut changed: Vec<Polynomial> = components.iter().map(with).collect();
    changed[i] = with(&moved);
    changed
}

fn symbols(states: &[&str]) -> Symbols {
    let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    Symbols { states: names(states), parameters: names(&["k"]) }
}

#[test]
fn what_polarisation_finds_is_kept_by_random_fields() {
    let random = &mut SplitMix64::new(57);
    let symbols = symbols(&["w", "u", "x", "y"]);
    let state = |i: usize| Polynomial::variable(symbols.state(i));
    for _ in 0..40 {
        let slopes = [1, 1].map(|degree| polynomial(&symbols, degree, random));
        let other = polynomial(&symbols, 2, random);
        let [a, b, c, d] = [(); 4].map(|()| small(random));
        let square = &(&state(2) * &state(2)).scale(&a) + &(&state(3) * &state(3)).scale(&b);
        let mut integral =
            &(&state(0) + &state(1).scale(&d)) + &(&square + &(&state(2) * &state(3)).scale(&c));
        let along = |slope: &Polynomial, i: usize| &integral.derivative(symbols.state(i)) * slope;
        let others = &along(&other, 1) + &(&along(&slopes[0], 2) + &along(&slopes[1], 3));
        let mut components = vec![-&others, other, slopes[0].clone(), slopes[1].clone()];
        for (i, by) in
            [(0, state(2).scale(&2.into())), (2, state(1).scale(&(-3).into())), (3, small(random).into())]
        {
            components = sheared(&symbols, &components, i, &by);
            integral = integral.composed(symbols.state(i), &(&state(i) + &by));
        }
        let system = system_of(&symbols, &components);
        let found = modified_integral(&system.field, &integral).expect("it is an integral");
        assert_eq!(found.rule, Rule::Polarisation);
        assert!(is_kept(&system, &found.of_map, random), "{components:?}");
        assert!(!is_kept(&system, &integral.clone().into(), random) || found.of_map == integral.into());
        let all = modified_integrals(&system.field);
        assert_eq!(all.len(), 1, "{components:?}: {all:?}");
        check_limit(&system.field, &all[0]);
        components[0] = &components[0] + &(&state(1) * &state(2));
        assert!(modified_integrals(&system_of(&symbols, &components).field).is_empty(), "{components:?}");
    }
}

#[test]
fn what_rotation_finds_is_kept_by_random_fields() {
    let random = &mut SplitMix64::new(58);
    let symbols = symbols(&["s", "c", "x"]);
    let state = |i: usize| Polynomial::variable(symbols.state(i));
    let mut rules = Vec::new();
    for round in 0..40 {
        let m = polynomial(&symbols, 1, random);
        let [alpha, beta] = [(); 2].map(|()| &small(random) + &Rational::new(1, 7));
        let (mut first, second) = if round % 2 == 0 { (1, 0) } else { (0, 1) };
        let factors = if first == 0 { [alpha.clone(), -&alpha] } else { [alpha.clone(), -&beta] };
        let [ds, dc] =
            [(first, &factors[0]), (second, &factors[1])].map(|(i, factor)| (&state(i) * &m).scale(factor));
        let mut integral = if first == 0 {
            &state(0) * &state(1)
        } else {
            &(&state(0) * &state(0)).scale(&beta) + &(&state(1) * &state(1)).scale(&alpha)
        };
        let mut components = vec![ds, dc, polynomial(&symbols, 2, random)];
        for i in 0..2 {
            let centre = Polynomial::from(small(random));
            components = sheared(&symbols, &components, i, &centre);
            integral = integral.composed(symbols.state(i), &(&state(i) + &centre));
        }
        let system = system_of(&symbols, &components);
        let all = modified_integrals(&system.field);
        assert_eq!(all.len(), 1, "{components:?}: {all:?}");
        assert!(is_kept(&system, &all[0].of_map, random), "{components:?}");
        check_limit(&system.field, &all[0]);
        rules.push(all[0].rule);
        for (i, by) in [(0, state(2)), (2, state(1).scale(&(-2).into()))] {
            components = sheared(&symbols, &components, i, &by);
            integral = integral.composed(symbols.state(i), &(&state(i) + &by));
        }
        let mixed = system_of(&symbols, &components);
        let found = modified_integral(&mixed.field, &integral).expect("it is an integral");
        assert_eq!(found.rule, all[0].rule);
        assert!(is_kept(&mixed, &found.of_map, random), "{components:?}");
        first = round % 3;
        components[first] = &components[first] + &state(first);
        assert!(modified_integral(&system_of(&symbols, &components).field, &integral).is_none());
    }
    assert!([Rule::Rotation, Rule::Hyperbolic].iter().all(|rule| rules.contains(rule)));
}
