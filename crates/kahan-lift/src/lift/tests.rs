use kahan_algebra::lenient;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::Shake256;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use super::{Lift, LiftCriterion, Options, RelationBehaviour, lift};
use crate::embedding::Builder;
use crate::laurent::{Laurent, Monomial};

fn lifted(text: &str, options: &Options) -> Result<Lift, String> {
    let read = lenient::read(text);
    lift(&read.lexed.tokens, options).map_err(|mistakes| format!("{text}: {}", mistakes[0]))
}

fn smallest(text: &str) -> Lift {
    lifted(text, &Options { which: LiftCriterion::Smallest, ..Options::default() }).expect(text)
}

/// Substitutes the expressions of the new variables into an equation.
fn restricted(lift: &Lift, index: usize) -> Laurent {
    let component = &lift.field.components[index];
    let states = lift.states.len();
    let variables = lift.variables().len();
    let parameter = |polynomial: &Polynomial| {
        RationalFunction::from(polynomial.map_variables(|variable| {
            kahan_algebra::poly::Variable(variable.0 - u16::try_from(variables).expect("few"))
        }))
    };
    let mut sum = Laurent::zero();
    let groups = component.numerator().group(|variable| usize::from(variable.0) < variables);
    for (monomial, coefficient) in groups.iter() {
        let mut product = Laurent::from(Monomial::one());
        for &(variable, exponent) in monomial.powers() {
            let variable = usize::from(variable.0);
            let value = match variable.checked_sub(states) {
                None => Laurent::coordinate(variable),
                Some(new) => lift.new[new].value.clone(),
            };
            for _ in 0..exponent {
                product = lift.ring.product(&product, &value);
            }
        }
        sum.add_scaled(&product, &parameter(coefficient));
    }
    let divisor = parameter(component.denominator());
    sum.scale(&RationalFunction::one().checked_div(&divisor).expect("not 0"))
}

/// Checks that the expressions of new variables satisfy all lifted equations.
fn check_restriction(lift: &Lift, text: &str) {
    for index in 0..lift.variables().len() {
        let expected = match index.checked_sub(lift.states.len()) {
            None => lift.ring.field[index].clone(),
            Some(new) => lift.ring.derivative(&lift.new[new].value),
        };
        let difference = {
            let mut difference = restricted(lift, index);
            difference.add_scaled(&expected, &-&RationalFunction::one());
            lift.ring.normalised(&difference)
        };
        assert!(difference.is_zero(), "{text}: {} in {}", lift.variables()[index], lift.text());
    }
}

const ORDERS: [(&str, usize); 45] = [
    ("x' = p; p' = -x^3", 1),
    ("x' = y; y' = mu*(1 - x^2)*y - x", 1),
    ("v' = v - v^3/3 - w + I; w' = k*(v + a - b*w)", 1),
    ("x' = alpha*(y - a*x^3 - c*x); y' = x - y + z; z' = -b*y", 1),
    ("x' = -x^3", 1),
    ("x' = -x^5", 1),
    ("x' = p; y' = q; p' = -x - 2*x*y - 4*x^3; q' = -y - x^2 + y^2", 1),
    ("x' = a + x^2*y - b*x - x; y' = b*x - x^2*y", 2),
    ("x' = a - x + x^2*y; y' = b - x^2*y", 2),
    ("x' = -x + a*y + x^2*y; y' = b - a*y - x^2*y", 2),
    ("x' = v; v' = -g*sin(x)", 2),
    ("x' = v; v' = -x^5", 2),
    ("s' = -V*s/(K + s); p' = V*s/(K + s)", 2),
    ("x' = y*(z - 1 + x^2) + g*x; y' = x*(3*z + 1 - x^2) + g*y; z' = -2*z*(a + x*y)", 3),
    (
        "x1' = p1; x2' = p2; x3' = p3; p1' = x2 - 2*x1 - x1^3; p2' = x1 + x3 - 2*x2 - x2^3; p3' = x2 - 2*x3 - x3^3",
        3,
    ),
    ("x' = v; v' = -d*v - a*x - b*x^3 + g*cos(w*t)", 3),
    ("x' = v; v' = -d*v - sin(x) + g*cos(w*t)", 4),
    ("S' = -b*S*I/(1 + a*I); I' = b*S*I/(1 + a*I) - g*I; R' = g*I", 3),
    ("x' = r*x*(1 - x/K) - a*x*y/(1 + h*x); y' = e*a*x*y/(1 + h*x) - m*y", 3),
    ("x' = a/(1 + y^2) - x; y' = b/(1 + x^2) - y", 5),
    ("x' = a/(1 + y^4) - x; y' = b/(1 + x^4) - y", 8),
    ("x' = a/(1 + z^2) - x; y' = a/(1 + x^2) - y; z' = a/(1 + y^2) - z", 9),
    (
        "m1' = a/(1 + p3^2) - m1; m2' = a/(1 + p1^2) - m2; m3' = a/(1 + p2^2) - m3; p1' = b*(m1 - p1); p2' = b*(m2 - p2); p3' = b*(m3 - p3)",
        12,
    ),
    ("x' = p; y' = q; p' = -x/(x^2 + y^2)^(3/2); q' = -y/(x^2 + y^2)^(3/2)", 3),
    (
        "x' = p; y' = q; z' = s; p' = -x/(x^2 + y^2 + z^2)^(3/2); q' = -y/(x^2 + y^2 + z^2)^(3/2); s' = -z/(x^2 + y^2 + z^2)^(3/2)",
        3,
    ),
    ("r' = p; p' = 12/r^13 - 6/r^7", 3),
    ("x' = p; p' = -2*(exp(-x) - exp(-2*x))", 1),
    ("x' = -y - z; y' = x + a*y; z' = b + z*(exp(x) - c)", 1),
    (
        "q1' = p1; q2' = p2; q3' = p3; p1' = exp(q3 - q1) - exp(q1 - q2); p2' = exp(q1 - q2) - exp(q2 - q3); p3' = exp(q2 - q3) - exp(q3 - q1)",
        3,
    ),
    ("x' = A*sin(z) + C*cos(y); y' = B*sin(x) + A*cos(z); z' = C*sin(y) + B*cos(x)", 6),
    (
        "a' = u + k*(sin(b - a) + sin(c - a)); b' = v + k*(sin(a - b) + sin(c - b)); c' = w + k*(sin(a - c) + sin(b - c))",
        6,
    ),
    ("x' = sin(y) - b*x; y' = sin(z) - b*y; z' = sin(x) - b*z", 6),
    (
        "x1' = p1; x2' = p2; x3' = p3; p1' = x2 - 2*x1 - sin(x1); p2' = x1 + x3 - 2*x2 - sin(x2); p3' = x2 - 2*x3 - sin(x3)",
        6,
    ),
    (
        "a1' = -(b2 + b3) - b1*(a1^2 + b1^2); a2' = -(b1 + b3) - b2*(a2^2 + b2^2); a3' = -(b1 + b2) - b3*(a3^2 + b3^2); b1' = a2 + a3 + a1*(a1^2 + b1^2); b2' = a1 + a3 + a2*(a2^2 + b2^2); b3' = a1 + a2 + a3*(a3^2 + b3^2)",
        9,
    ),
    ("x' = y^3; y' = x^3", 3),
    ("x' = y^4; y' = x^4", 4),
    ("x' = y^5; y' = x^5", 4),
    ("x' = y^6; y' = x^6", 5),
    ("h' = 5*i^2*s^4; i' = -5*i^2*s^4; s' = 1", 2),
    ("h' = 5*i^2*s^9; i' = -5*i^2*s^9; s' = 1", 4),
    ("h' = 5*i^2*s^14; i' = -5*i^2*s^14; s' = 1", 5),
    ("x' = -x^(3/2)", 1),
    ("x' = x^n", 2),
    ("x' = t^2 - x^2", 0),
    ("x' = y; y' = -x + y*z; z' = 1 - y^2", 0),
];

#[test]
fn orders_are_at_most_those_of_the_literature() {
    for (text, most) in ORDERS {
        let lift = smallest(text);
        assert!(lift.order() <= most, "{text}: {} new variables, not {most}", lift.order());
        check_restriction(&lift, text);
    }
}

#[test]
fn fields_of_many_functions_have_a_lift() {
    let text = "x' = tan(x) + atan(y)/cosh(y); y' = log(x)*sqrt(1 - y^2)";
    check_restriction(&smallest(text), text);
}

const MECHANICAL: [&str; 12] = [
    "x' = v; v' = -g*sin(x)",
    "x' = p; p' = x - x^3",
    "x' = p; p' = -2*a*D*(exp(-a*x) - exp(-2*a*x))",
    "r' = p; p' = 12/r^13 - 6/r^7",
    "x' = p; y' = q; p' = -x - 2*x*y - 4*x^3; q' = -y - x^2 + y^2",
    "x' = v; y' = u; v' = -x/(x^2 + y^2 + s^2)^(3/2); u' = -y/(x^2 + y^2 + s^2)^(3/2)",
    "x1' = p1; x2' = p2; x3' = p3; p1' = x2 - 2*x1 - x1^3; p2' = x1 + x3 - 2*x2 - x2^3; p3' = x2 - 2*x3 - x3^3",
    "x1' = p1; x2' = p2; x3' = p3; p1' = x2 - 2*x1 - sin(x1); p2' = x1 + x3 - 2*x2 - sin(x2); p3' = x2 - 2*x3 - sin(x3)",
    "q1' = p1; q2' = p2; q3' = p3; p1' = exp(q3 - q1) - exp(q1 - q2); p2' = exp(q1 - q2) - exp(q2 - q3); p3' = exp(q2 - q3) - exp(q3 - q1)",
    "x' = p/m1; y' = q/m2; p' = -sin(x - y); q' = sin(x - y) - k*y",
    "x' = 2*p + q; y' = p + 3*q; p' = -sin(x); q' = -y^3",
    "x' = v; y' = u; v' = -2*sin(x) + y^3; u' = sin(x) - y^3",
];

#[test]
fn maps_of_mechanical_systems_keep_an_energy() {
    for text in MECHANICAL {
        let lift = lifted(text, &Options::default()).expect(text);
        let energy = lift.energy.as_ref().expect(text);
        assert!(energy.contains("eps"), "{text}: {energy}");
        check_restriction(&lift, text);
    }
    for text in ["x' = v; v' = -x^3 - v", "x' = p; y' = q; p' = -y*x^2; q' = -x", "x' = v; v' = cos(t) - x^3"]
    {
        let lift = lifted(text, &Options::default()).expect(text);
        assert_eq!(lift.energy, None, "{text}");
        let energy = Options { which: LiftCriterion::Energy, ..Options::default() };
        assert!(lifted(text, &energy).expect_err(text).contains("mechanical"), "{text}");
    }
}

/// Central forces −g·(x, y) in the plane. Each entry is g and the largest allowed number of
/// variables.
const CENTRAL: [(&str, usize); 6] = [
    ("6/(x^2 + y^2)^4 - 12/(x^2 + y^2)^7", 8),
    ("(x^2 + y^2)^(-5/6)", 6),
    ("1/(x^2 + y^2 + 1)", 6),
    ("(x^2 + y^2 + b^2)^(-3/2)", 7),
    ("1/(x^2 + y^2)^2 - 1/(x^2 + y^2)^3", 8),
    ("1/(x^2 + y^2)^(5/2)", 6),
];

#[test]
fn energies_of_central_forces_are_kept() {
    let options = Options { which: LiftCriterion::Energy, ..Options::default() };
    for (ratio, most) in CENTRAL {
        let text = format!("x' = p; y' = q; p' = -x*({ratio}); q' = -y*({ratio})");
        let lift = lifted(&text, &options).expect(&text);
        assert!(lift.order() <= most, "{text}: {} new variables, not {most}", lift.order());
        assert!(lift.energy.is_some_and(|energy| energy.contains("eps")), "{text}");
    }
}

fn below(random: &mut Vec<u8>, bound: u8) -> u8 {
    random.pop().expect("enough bytes") % bound
}

/// Returns random equations of up to four states, with up to four terms in each equation.
fn random_field(seed: u64) -> String {
    let mut shake = Shake256::new(&seed.to_le_bytes());
    let mut random: Vec<u8> = (0..16).flat_map(|_| shake.next_seed()).collect();
    let states = 1 + below(&mut random, 4);
    let name = |index: u8| ["x", "y", "z", "u"][usize::from(index)];
    let mut text = String::new();
    for state in 0..states {
        text.push_str(&format!("{}' = 0", name(state)));
        for _ in 0..=below(&mut random, 4) {
            let sign = if below(&mut random, 2) == 0 { '+' } else { '-' };
            text.push_str(&format!(" {sign} {}", 1 + below(&mut random, 3)));
            let mut degree = 1 + below(&mut random, 5);
            while degree > 0 {
                let power = (1 + below(&mut random, 3)).min(degree);
                text.push_str(&format!("*{}^{power}", name(below(&mut random, states))));
                degree -= power;
            }
            let argument = name(below(&mut random, states));
            match below(&mut random, 12) {
                0 => text.push_str(&format!("*sin({argument})")),
                1 => text.push_str(&format!("*exp(-2*{argument})")),
                2 => text.push_str(&format!("/(1 + {argument}^2)")),
                3 => text.push_str(&format!("*sqrt(2 + {argument})")),
                4 => text.push_str(&format!("/{argument}")),
                _ => {}
            }
        }
        text.push_str("; ");
    }
    text
}

fn check_random_fields(seeds: std::ops::Range<u64>) {
    let options = Options { budget: 300, ..Options::default() };
    let mut found = 0;
    for seed in seeds.clone() {
        let text = random_field(seed);
        if let Ok(lift) = lifted(&text, &options) {
            found += 1;
            if lift.new.iter().all(|one| one.expression.is_some()) {
                check_restriction(&lift, &text);
            }
        }
    }
    assert!(10 * found > 7 * (seeds.end - seeds.start), "{found} lifts");
}

#[test]
fn lifts_of_random_fields_restrict_to_them() {
    check_random_fields(0..60);
}

#[test]
#[ignore = "takes minutes"]
fn lifts_of_two_thousand_random_fields_restrict_to_them() {
    check_random_fields(60..2060);
}

#[test]
fn roots_of_sums_with_poles_are_read() {
    for text in [
        "x' = asinh(1/x)",
        "x' = asin(1/x)",
        "x' = acosh(2/x)",
        "x' = sqrt(1 + 1/x^2)",
        "x' = 1/sqrt(1 + 1/x)",
    ] {
        if let Ok(lift) = lifted(text, &Options { which: LiftCriterion::Smallest, ..Options::default() }) {
            check_restriction(&lift, text);
        }
    }
    assert!(lifted("x' = 1/sqrt(1 + 1/x)", &Options::default()).is_ok());
}

#[test]
fn what_cannot_be_lifted_is_refused_with_its_reason() {
    for (text, reason) in [
        ("x' = abs(x)", "has a corner or a jump"),
        ("x' = sign(y); y' = -x", "has a corner or a jump"),
        ("x' = f(x)", "no function that can be lifted"),
        ("x' = erf(x)", "`erf(…)` is not lifted"),
        ("x' = log10(x)", "write `c*log(u)`, with a parameter c = 0.434"),
        ("x' = x^100", "too large"),
        ("x' = 1/(x - x)", "divides by zero"),
        ("x' = sin(x); x' = y; y' = 1", "two equations"),
        ("x' = eps^2*sin(x)", "free of `eps`"),
    ] {
        let mistake = lifted(text, &Options::default()).expect_err(text);
        assert!(mistake.contains(reason), "{mistake}");
    }
}

#[test]
fn a_lift_whose_errors_grow_warns() {
    let orbit = Some((vec![1.0, 0.0], Vec::new()));
    let text = "x' = -x + 2*tanh(x) - y; y' = x - y/2";
    let lift =
        lifted(text, &Options { orbit, which: LiftCriterion::Smallest, ..Options::default() }).expect(text);
    let grows = lift.relations.iter().any(|relation| relation.along == Some(RelationBehaviour::Grows));
    assert_eq!(lift.warning().is_some(), grows);
    assert!(grows, "{:?}", lift.relations);
}

#[test]
fn singular_points_and_late_phases_are_told() {
    let gate = smallest("v' = -(v + 40)/(1 - exp(-(v + 40)/10))");
    assert!(gate.notes[0].contains("is infinite at v = -40,"), "{:?}", gate.notes);
    let driven = smallest("x' = v; v' = -x^3 + g*cos(w*t)");
    assert_eq!(driven.notes, ["the phase of sin(w*t) falls behind by (w)^3*eps^2/3 in a unit of time"]);
}

#[test]
fn first_values_are_those_of_the_expressions() {
    let text = "x' = v; v' = -sin(2*x)/sqrt(1 + v^2) + tanh(x)*exp(-x/3)";
    let lift = lifted(text, &Options::default()).expect(text);
    let (x, v): (f64, f64) = (0.7, -0.3);
    let values = lift.embed(&[x, v], &[]);
    for (new, value) in lift.new.iter().zip(values) {
        let expression = new.expression.as_ref().expect("an expression");
        let again =
            lifted(&format!("x' = v; v' = 0*x; w' = {expression}"), &Options::default()).expect(expression);
        let slope = Builder::embedding(&again.ring, &again.ring.field).values(&[x, v, 0.0], &[])[2];
        let bound = 1e-14 * slope.abs();
        assert!((value - slope).abs() <= bound, "{expression}: {value} {slope}");
    }
}

#[test]
fn lifts_are_chosen_by_structure_then_by_the_orbit() {
    let at = |start: &[f64], parameters: &[f64]| Options {
        orbit: Some((start.to_vec(), parameters.to_vec())),
        ..Options::default()
    };
    let van_der_pol = lifted("x' = y; y' = mu*(1 - x^2)*y - x", &Options::default()).expect("a lift");
    assert_eq!(van_der_pol.relations[0].formula.as_deref(), Some("x2 - x^2 + eps^2*y^2"));
    // In u′ for u = v², the term 2v² must not become 2u, with which errors of u = v² grow.
    let text = "v' = v - v^3/3 - w + 1/2; w' = 2/25*(v + 7/10 - 4/5*w)";
    let nagumo = lifted(text, &at(&[0.0, 0.0], &[])).expect("a lift");
    assert!(nagumo.text().contains("v2dot = v + 2*v^2"), "{}", nagumo.text());
    assert_eq!(nagumo.relations[0].along, Some(RelationBehaviour::Decays));
    for (text, start, parameters) in [
        ("x' = a + x^2*y - b*x - x; y' = b*x - x^2*y", &[1.0, 1.0][..], &[1.0, 3.0][..]),
        ("x' = a - x + x^2*y; y' = b - x^2*y", &[1.0, 1.0], &[0.1, 0.9]),
        ("x' = a/(1 + z^2) - x; y' = a/(1 + x^2) - y; z' = a/(1 + y^2) - z", &[1.0, 2.0, 3.0], &[10.0]),
        (
            "x' = r*x*(1 - x/K) - a*x*y/(1 + h*x); y' = e*a*x*y/(1 + h*x) - m*y",
            &[1.0, 1.0],
            &[1.0, 4.0, 1.0, 0.5, 0.5, 0.3],
        ),
    ] {
        let lift = lifted(text, &at(start, parameters)).expect(text);
        let usable = |along| {
            matches!(
                along,
                Some(RelationBehaviour::Kept | RelationBehaviour::Bounded | RelationBehaviour::Decays)
            )
        };
        assert!(lift.relations.iter().all(|one| usable(one.along)), "{text}: {:?}", lift.relations);
        check_restriction(&lift, text);
    }
}

#[test]
fn first_values_of_rational_functions_are_exact() {
    let text = "x' = a/(1 + y^2) - x; y' = b/(1 + x^2) - y";
    let lift = smallest(text);
    let numbers =
        |values: &[(i64, i64)]| values.iter().map(|&(p, q)| Rational::new(p, q)).collect::<Vec<_>>();
    let values = lift.embed_exact(&numbers(&[(1, 2), (1, 3)]), &numbers(&[(3, 1), (2, 1)])).expect("no pole");
    for (expression, expected) in
        [("1/(x^2 + 1)", Rational::new(4, 5)), ("1/(y^2 + 1)", Rational::new(9, 10))]
    {
        let new = lift.new.iter().position(|new| new.expression.as_deref() == Some(expression));
        assert_eq!(values[new.expect(expression)], expected);
    }
    let pole = smallest("x' = 1/x");
    assert_eq!(pole.embed_exact(&[Rational::zero()], &[]), None);
}
