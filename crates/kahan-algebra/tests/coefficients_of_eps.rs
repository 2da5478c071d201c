//! Tests coefficients that depend on ε. At each ε, the map is that of a field with a parameter k =
//! ε².

use kahan_algebra::arithmetic::{Exact, Float64};
use kahan_algebra::diagnostics::Diagnostic;
use kahan_algebra::interpret::{Evaluation, Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::prove::prove_by_normal_form;
use kahan_algebra::rational::Rational;
use kahan_algebra::read;
use kahan_algebra::system::System;
use kahan_algebra::variational::Sensitivity;

/// With k = ε², the map of this field has a common factor that must be divided out.
const REPAIRED: &str = "struct P { b, k } xdot = x^2; ydot = (1 - k*b^2)*x*y + b*y;";

/// The parameter `k` is replaced by ε².
const FIELDS: [&str; 12] = [
    "xdot = k*x^2 + x;",
    "struct P { k } xdot = (1 - k)*x^2 + k^2*x - 3*k;",
    "struct P { a, k } xdot = y + a*k*x^2; ydot = -x*(1 + a*k);",
    "struct P { a, b, k } xdot = (a - k)*(x - b*y)*(x + k*y) + 1; ydot = x*y/(1 + a*k) - k*y^2/b;",
    "struct P { k } xdot = x^2*(1 + k) - 2*x*y; ydot = y*(x - k*y)/(2 - k);",
    "struct P { a, k } xdot = y*z*(1 - a*k); ydot = x*z + k*(x - y)*(z + a); zdot = x*y + k*x - k*x;",
    "struct P { a, k } xdot = y; ydot = z + k*x*(x - a); zdot = -x*y - k*z^2/(a + k);",
    // A factor of det A cancels in these maps.
    "struct P { k } xdot = (1 + k)*x^2; ydot = (1 + k)*x*y; zdot = (1 + k)*x*z;",
    REPAIRED,
    "struct P { a, k } x1dot = x2*x3 + k*x1; x2dot = x3*x4 - a; x3dot = k*x4*x1; x4dot = x1*x2 - x3/(1 + k^2); \
     x5dot = x4^2*k + x5;",
    "struct P { a, k } x1dot = x2*x3 + k*x1; x2dot = x3*x4 - a; x3dot = k*x4*x5; x4dot = x5*x6 - x3/(1 + k); \
     x5dot = x6*x7*k; x6dot = x7*x8 + k*x6; x7dot = x8*x9 - a*k; x8dot = x9*x1; x9dot = x1*x2*(1 - k);",
    "struct P { k } x1dot = (x1 + x2)*(x2 - k*x3)*k; x2dot = (x1 - k)*(x2 + x3); x3dot = (1 + k)*(x1 + k*x2)^2;",
];

fn system(text: &str) -> System {
    read(&lex(text).tokens).system().unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"))
}

fn with_eps(text: &str) -> System {
    let declared = text.replace(", k }", " }").replace("struct P { k }", "");
    system(&declared.replace('k', "(eps^2)"))
}

struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> Rational {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let drawn = self.0 >> 33;
        Rational::new((drawn % 41) as i64 - 20, 1 + (drawn / 41 % 17) as i64)
    }

    fn point(&mut self, system: &System) -> Point<Rational> {
        let symbols = &system.field.symbols;
        let mut values = |names: &[String]| names.iter().map(|_| self.next()).collect();
        let (state, parameters) = (values(&symbols.states), values(&symbols.parameters));
        Point { state, parameters, eps: self.next() }
    }
}

fn at_parameter(point: &Point<Rational>, squared: &Rational) -> Point<Rational> {
    let mut point = point.clone();
    point.parameters.push(squared * squared);
    point
}

fn evaluate(interpreter: &Interpreter, point: &Point<Rational>) -> Option<Evaluation<Rational>> {
    interpreter.evaluate(&Exact, point).ok()
}

#[test]
fn the_map_is_that_of_the_field_with_eps_squared_put_in() {
    for text in FIELDS {
        let own = with_eps(text);
        let (interpreter, other) = (Interpreter::new(&own), Interpreter::new(&system(text)));
        let (mut numbers, mut compared) = (Numbers(7), 0);
        for _ in 0..12 {
            let point = numbers.point(&own);
            let at = |squared: &Rational| evaluate(&other, &at_parameter(&point, squared));
            let (Some(found), Some(map), Some(field)) =
                (evaluate(&interpreter, &point), at(&point.eps), at(&Rational::ZERO))
            else {
                continue;
            };
            assert_eq!(found.field, field.field, "{text}");
            assert_eq!(found.field_jacobian, field.field_jacobian, "{text}");
            assert_eq!(found.matrix, map.matrix, "{text}");
            assert_eq!(found.rhs, map.rhs, "{text}");
            assert_eq!(found.det_matrix, map.det_matrix, "{text}");
            if map.next.is_some() {
                assert_eq!(found.next, map.next, "{text} at {point:?}");
                assert_eq!(found.jacobian, map.jacobian, "{text} at {point:?}");
                compared += 1;
            }
            let y: Vec<Rational> = point.state.iter().map(|_| numbers.next()).collect();
            let flow = at_parameter(&point, &Rational::ZERO);
            let forms =
                |of: &Interpreter, point| [of.bilinear(&Exact, point, &y), of.polarized(&Exact, point, &y)];
            assert_eq!(forms(&interpreter, &point), forms(&other, &flow), "{text}");
        }
        assert!(compared >= 8, "{text}: {compared}");
    }
}

#[test]
fn factors_that_cancel_for_these_coefficients_are_divided_out() {
    let own = with_eps(REPAIRED);
    let [half, one, y] = [Rational::new(1, 2), Rational::ONE, Rational::from(5)];
    let point = Point { state: vec![Rational::new(4, 3), y], parameters: vec![one], eps: half };
    let next = Interpreter::new(&own).next(&Exact, &point).expect("the reduced map has a value");
    assert_eq!(next, [Rational::from(-4), Rational::from(-45)]);
}

#[test]
fn a_step_of_floats_is_near_the_exact_one() {
    let float = |values: &[Rational]| values.iter().map(Rational::to_f64).collect::<Vec<_>>();
    for text in FIELDS {
        let own = with_eps(text);
        let (interpreter, mut numbers, mut compared) = (Interpreter::new(&own), Numbers(11), 0);
        for _ in 0..12 {
            let mut point = numbers.point(&own);
            point.eps = &point.eps * &Rational::new(1, 256);
            let rounded = Point {
                state: float(&point.state),
                parameters: float(&point.parameters),
                eps: point.eps.to_f64(),
            };
            let (Some(exact), Some(next)) =
                (interpreter.next(&Exact, &point), interpreter.next(&Float64, &rounded))
            else {
                continue;
            };
            for (exact, next) in exact.iter().zip(next) {
                let exact = exact.to_f64();
                assert!((next - exact).abs() <= 1e-12 * exact.abs().max(1.0), "{text}: {next} for {exact}");
            }
            compared += 1;
        }
        assert!(compared >= 8, "{text}: {compared}");
    }
}

#[test]
fn stepping_back_returns_the_start() {
    for text in FIELDS {
        let own = with_eps(text);
        let (interpreter, mut numbers, mut returned) = (Interpreter::new(&own), Numbers(5), 0);
        for _ in 0..12 {
            let point = numbers.point(&own);
            let Some(state) = interpreter.next(&Exact, &point) else { continue };
            let behind = Point { state, eps: -&point.eps, parameters: point.parameters.clone() };
            if let Some(start) = interpreter.next(&Exact, &behind) {
                assert_eq!(start, point.state, "{text}");
                returned += 1;
            }
        }
        assert!(returned >= 8, "{text}: {returned}");
    }
}

/// The map is x ↦ x/(1 − 2ε³x). Its derivative with respect to ε is 6ε²x²/(1 − 2ε³x)².
#[test]
fn the_derivative_by_eps_has_that_of_the_coefficients() {
    let with_derivative = system("xdot = eps^2*x^2;").sensitivities(&[Sensitivity::Epsilon]);
    let (x, eps) = (Rational::new(3, 2), Rational::new(1, 3));
    let inverse = eps.recip().expect("it is not 0");
    let point = Point { state: vec![x.clone(), Rational::ZERO], parameters: vec![inverse], eps };
    let next = Interpreter::new(&with_derivative).next(&Exact, &point).expect("no pole");
    assert_eq!(next, [Rational::new(27, 16), Rational::new(243, 128)]);
}

#[test]
fn derivatives_by_eps_are_limits_of_differences() {
    for text in FIELDS {
        let own = with_eps(text);
        let n = own.field.dimension();
        let derived = Interpreter::new(&own.sensitivities(&[Sensitivity::Epsilon]));
        let (interpreter, mut numbers, mut compared) = (Interpreter::new(&own), Numbers(3), 0);
        for _ in 0..8 {
            let mut point = numbers.point(&own);
            point.eps = &point.eps * &Rational::new(1, 64);
            let Some(inverse) = point.eps.recip() else { continue };
            let step = |shift: &Rational| {
                interpreter.next(&Exact, &Point { eps: &point.eps + shift, ..point.clone() })
            };
            let shift = Rational::new(1, 1 << 30);
            let mut extended = point.clone();
            extended.state.extend((0..n).map(|_| Rational::ZERO));
            extended.parameters.push(inverse);
            let (Some(above), Some(below), Some(found)) =
                (step(&shift), step(&-&shift), derived.next(&Exact, &extended))
            else {
                continue;
            };
            for i in 0..n {
                let slope = (&above[i] - &below[i]).to_f64() / (2.0 * shift.to_f64());
                let found = found[n + i].to_f64();
                assert!((slope - found).abs() <= 1e-6 * found.abs().max(1.0), "{text}: {found} for {slope}");
            }
            compared += 1;
        }
        assert!(compared >= 5, "{text}: {compared}");
    }
}

#[test]
fn values_of_parameters_leave_eps_in_the_coefficients() {
    let text = "struct P { a } xdot = y + a*eps^2*x^2; ydot = (a - eps^2)*(x + y)/(1 + a*eps^2);";
    let fixed = system(text).specialise(&[(0, Rational::from(3))]).expect("it divides by nothing");
    let same = system("xdot = y + 3*eps^2*x^2; ydot = (3 - eps^2)*(x + y)/(1 + 3*eps^2);");
    assert_eq!(fixed.field, same.field);
    let point = Numbers(9).point(&fixed);
    let next = |system| Interpreter::new(system).next(&Exact, &point);
    assert!(next(&fixed).is_some());
    assert_eq!(next(&fixed), next(&same));
}

/// The map is equivalent to 1/x̃ = 1/x − 2ε³.
#[test]
fn claims_about_such_a_map_are_proved() {
    let text = "xdot = eps^2*x^2; ydot = -eps^2*y^2; integral I = 1/x + 1/y;";
    let own = system(text);
    assert_eq!(prove_by_normal_form(&own, &own.claims[0]), Some(true));
    let mistakes = read(&lex(&text.replace("-eps^2", "-2*eps^2")).tokens).system().expect_err("it is false");
    assert!(mistakes[0].message.contains("not"), "{mistakes:?}");
}

fn mistakes(text: &str) -> Vec<Diagnostic> {
    read(&lex(text).tokens).system().expect_err("a mistake")
}

fn place(text: &str, mistake: &Diagnostic) -> std::ops::Range<usize> {
    let ranges = lex(text).ranges;
    ranges[mistake.span.first].start..ranges[mistake.span.last].end
}

#[test]
fn odd_powers_of_eps_are_refused_at_the_token() {
    for (text, start) in [
        ("xdot = y + eps*x^2; ydot = eps^2*x;", 11),
        ("xdot = y; ydot = eps^2*x + x*(1 - eps^3*y);", 34),
        ("xdot = x/(1 + eps);", 14),
        ("struct P { a } xdot = -(a*eps^2 + (x + eps)^2);", 39),
    ] {
        let found = mistakes(text);
        assert_eq!(found.len(), 1, "{text}: {found:?}");
        assert!(found[0].message.contains("odd powers"), "{found:?}");
        assert_eq!(place(text, &found[0]), start..start + 3, "{text}");
    }
    // In accepted equations, odd powers of ε cancel or multiply to even powers.
    system("xdot = (x + eps*y)*(x - eps*y) + eps*x - eps*x; ydot = eps*x*eps;");
}

#[test]
fn a_field_without_a_value_at_eps_zero_is_refused() {
    let text = "xdot = x/eps^2;";
    let found = mistakes(text);
    assert!(found.len() == 1 && found[0].message.contains("no value at `eps = 0`"), "{found:?}");
    assert_eq!(place(text, &found[0]), 9..12);
    let family = "for i in periodic { x[i]dot = eps^2*x[i+1]; }";
    let checked = read(&lex(family).tokens);
    let found = checked.diagnostics();
    assert!(found.len() == 1 && found[0].message.contains("free of `eps`"), "{found:?}");
    let constant = mistakes("const c = eps^2; xdot = c*x;");
    assert!(constant[0].message.contains("`eps` is no constant"), "{constant:?}");
}
