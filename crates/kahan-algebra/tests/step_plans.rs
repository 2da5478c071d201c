//! Tests that the plan of a step solves (x̃ − x)/(2ε) = P(x, x̃) over ℚ, where P is the polarised
//! field. The fields cover all paths of the planner.

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::field::Field;
use kahan_algebra::kahan::polarization;
use kahan_algebra::lexer::lex;
use kahan_algebra::plan::{Input, plan_of};
use kahan_algebra::plan::{Node, Operation, Plan, StepPlan};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::read;
use kahan_algebra::symbols::Symbol;

const FIELDS: [(&str, &str); 19] = [
    ("Lotka–Volterra", "xdot = x*(1 - y); ydot = y*(x - 1);"),
    ("E1, reduced", "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z;"),
    ("E3, reduced", "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;"),
    ("E5", "xdot = x*y; ydot = -x^2; zdot = y*(2*x - z);"),
    ("E6", "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);"),
    ("Euler", "struct S { a, b, c } xdot = a*y*z; ydot = b*z*x; zdot = c*x*y;"),
    ("Lorenz", "struct S { s, r, b } xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z;"),
    (
        "Clebsch",
        "struct S { u, v, w } adot = (w - v)*y*z; bdot = (u - w)*z*x; cdot = (v - u)*x*y;
         xdot = y*c - z*b; ydot = z*a - x*c; zdot = x*b - y*a;",
    ),
    (
        "the Lagrange top",
        "struct S { k } adot = k*b*c + y; bdot = -k*a*c - x; cdot = 0; xdot = c*y - b*z; ydot = a*z - c*x;
         zdot = b*x - a*y;",
    ),
    (
        "Volterra, five sites",
        "adot = a*(b - e); bdot = b*(c - a); cdot = c*(d - b); ddot = d*(e - c); edot = e*(a - d);",
    ),
    ("two blocks, one driving the other", "adot = a*b; bdot = -a^2; xdot = x*y + a; ydot = x*a - y^2 + b*x;"),
    ("a chain of blocks", "adot = a; bdot = a*b + b^2; cdot = b*c + a; ddot = c*d + b^2; edot = d*e - a*b;"),
    ("decoupled", "adot = a^2; bdot = b*c; cdot = b^2 - c; xdot = 1; ydot = x^2;"),
    (
        "a parameter in a denominator",
        "struct S { m } xdot = x*y/m; ydot = (x^2 - y)/(1 + m); zdot = x*z; wdot = w*z/m;",
    ),
    (
        "volumes shrink at a rate of many constants",
        "struct S { p, h, o, y, q, l, m, k } adot = p*b + h*c; bdot = o*a - q*c^2; cdot = y*q*a*b + l; ddot = m*a + 2*d*k;",
    ),
    (
        "the second factor of the denominator negative",
        "struct S { k } xdot = x*y/k + 1/3; ydot = -y^2 + 0.1;",
    ),
    ("linear", "adot = b; bdot = -a; cdot = 2*c; ddot = a - d;"),
    ("nothing to divide", "xdot = y; ydot = 1; zdot = x*y; wdot = x^2;"),
    ("zero", "xdot = 0; ydot = 0;"),
];

fn field(text: &str) -> Field {
    let reading = read(&lex(text).tokens);
    assert!(reading.diagnostics().is_empty(), "{text}: {:?}", reading.diagnostics());
    reading.system().expect("a system").field.as_ref().clone()
}

struct Numbers(SplitMix64);

impl Numbers {
    fn next(&mut self) -> Rational {
        let size = Rational::new(1 + self.0.below(9) as i64, 1 + self.0.below(9) as i64);
        if self.0.below(2) == 0 { size } else { -size }
    }
}

/// Runs the plan at a point of states, parameters and ε. Returns `None` at a pole.
fn next(step: &StepPlan, point: &[Rational]) -> Option<Vec<Rational>> {
    let value = |variable: kahan_algebra::poly::Variable| Some(point[usize::from(variable.0)].clone());
    let constants = step.constants.evaluate(&Exact, |input| input.value(&[], value));
    let results = step.kernel.plan.evaluate(&Exact, |input| input.value(&constants, value));
    let results: Vec<Rational> = results.into_iter().collect::<Option<_>>()?;
    let component = |(x, (numerator, reciprocal)): (_, (&Rational, Option<&Rational>))| match reciprocal {
        Some(reciprocal) => x + &(numerator * reciprocal),
        None => x + numerator,
    };
    Some(point.iter().zip(step.kernel.factors(&results)).map(component).collect())
}

/// Returns (x̃ − x) − 2ε P(x, x̃), each entry multiplied by the denominator of its equation.
fn residuals(field: &Field, point: &[Rational], next: &[Rational]) -> Vec<Rational> {
    let eps = &point[usize::from(field.symbols.epsilon().0)];
    let value = |variable| match field.symbols.symbol(variable) {
        Symbol::SecondState(i) => next[i].clone(),
        _ => point[usize::from(variable.0)].clone(),
    };
    let run = |plan: Plan| {
        let results = plan.evaluate(&Exact, |input| input.variable().map(value)).into_iter();
        results.map(Option::unwrap).collect::<Vec<_>>()
    };
    let polarized = run(plan_of(polarization(field).iter()));
    let denominators = run(plan_of(field.denominators()));
    (0..next.len())
        .map(|i| &(&denominators[i] * &(&next[i] - &point[i])) - &(&(eps + eps) * &polarized[i]))
        .collect()
}

fn solves_the_scheme(name: &str, field: &Field, numbers: &mut Numbers) {
    let step = StepPlan::of(field).unwrap_or_else(|| panic!("{name} is small enough for straight lines"));
    if let Some(lanes) = &step.general {
        plan_solves_the_scheme(name, field, lanes, numbers);
    }
    plan_solves_the_scheme(name, field, &step, numbers);
}

fn plan_solves_the_scheme(name: &str, field: &Field, step: &StepPlan, numbers: &mut Numbers) {
    let inputs = usize::from(field.symbols.epsilon().0) + 1;
    let mut points = 0;
    for _ in 0..5 {
        let point: Vec<Rational> = (0..inputs).map(|_| numbers.next()).collect();
        let Some(next) = next(step, &point) else { continue };
        points += 1;
        assert!(residuals(field, &point, &next).iter().all(Rational::is_zero), "{name} at {point:?}");
    }
    assert!(points > 2, "{name}: poles everywhere");
}

#[test]
fn every_form_solves_the_scheme() {
    let mut numbers = Numbers(SplitMix64::new(41));
    for (name, text) in FIELDS {
        solves_the_scheme(name, &field(text), &mut numbers);
    }
}

/// Random fields with four to seven states and few terms. Their maps are too large to expand.
#[test]
fn random_sparse_fields_are_stepped_by_their_structure() {
    let mut numbers = Numbers(SplitMix64::new(42));
    for _ in 0..40 {
        let n = 4 + numbers.0.below(4);
        let names = ["a", "b", "c", "d", "f", "g", "h"];
        let mut text = String::new();
        for state in &names[..n as usize] {
            text += &format!("{state}dot = ");
            for _ in 0..=numbers.0.below(3) {
                let mut one = || names[numbers.0.below(n) as usize];
                text += &format!("+ {}*{} - {}", one(), one(), one());
            }
            text += ";\n";
        }
        let text = text.replace("= +", "=");
        let field = field(&text);
        if StepPlan::of(&field).is_some() {
            solves_the_scheme(&text, &field, &mut numbers);
        }
    }
}

/// Fields with one to three states have reduced maps with various factors and signs.
#[test]
fn random_small_fields_are_stepped_by_their_reduced_maps() {
    let mut numbers = Numbers(SplitMix64::new(43));
    let mut two_divisions = 0;
    for _ in 0..300 {
        let n = 1 + numbers.0.below(3);
        let mut text = "struct S { k } ".to_string();
        for state in 0..n {
            let driven = numbers.0.below(2) == 0;
            text += &format!("{}dot = 0", ["x", "y", "z"][state as usize]);
            for _ in 0..=numbers.0.below(3) {
                let mut one = || match numbers.0.below(5) {
                    0 => "1",
                    _ if driven => ["x", "y", "z"][state as usize],
                    _ => ["x", "y", "z"][numbers.0.below(n) as usize],
                };
                let (one, two) = (one(), one());
                let sign = if numbers.0.below(2) == 0 { "+" } else { "-" };
                let factor = ["", "2*", "k*", "1/3*", "1/k*"][numbers.0.below(5) as usize];
                text += &format!(" {sign} {factor}{one}*{two}");
            }
            text += "; ";
        }
        let text = if text.contains("k*") || text.contains("/k") { text } else { text.replace("{ k }", "") };
        let text = text.replace("struct S  ", "");
        let field = field(&text);
        let step = StepPlan::of(&field).expect("small enough for straight lines");
        two_divisions += usize::from(step.general.is_some());
        solves_the_scheme(&text, &field, &mut numbers);
    }
    assert!(two_divisions > 10, "{two_divisions}");
}

#[test]
fn poles_of_the_reduced_map_are_poles_of_the_plan_and_removable_ones_are_not() {
    let e1 = field(FIELDS[1].1);
    let step = StepPlan::of(&e1).expect("E1 is small");
    let at = |x: Rational| [x, Rational::from(2), Rational::from(3), Rational::new(1, 2)];
    // The map has the denominator (1 − εx)(1 + 2εx). The factor 1 + εx of det A cancels.
    assert!(next(&step, &at(Rational::from(2))).is_none());
    assert!(next(&step, &at(Rational::from(-1))).is_none());
    assert!(next(&step, &at(Rational::from(-2))).is_some());
}

/// With one variable, a divisor that depends on the state divides the increment. Any other divisor
/// is replaced by a prepared reciprocal.
#[test]
fn a_single_variable_is_divided_at_once() {
    for (text, divisions, reciprocals) in [
        ("xdot = x^2;", 1, 0),
        ("xdot = a*x - x^2/3 + b;", 1, 0),
        ("xdot = a - x;", 1, 1),
        ("xdot = 2;", 0, 1),
    ] {
        let step = StepPlan::of(&field(text)).expect("the fields are small");
        for form in [Some(&step), step.general.as_deref()].into_iter().flatten() {
            let found = (form.kernel.plan.cost().divisions, form.kernel.reciprocals().len());
            assert_eq!(found, (divisions, reciprocals), "{text}");
        }
    }
}

/// A scalar step has a single division, except for the fields E1 and E5. A step in SIMD lanes
/// always has a single division.
#[test]
fn divisions_are_as_few_as_possible() {
    for (name, text) in &FIELDS[..8] {
        let step = StepPlan::of(&field(text)).expect("the fields are small");
        let divisions = step.kernel.plan.cost().divisions;
        let has_two = ["E1, reduced", "E5"].contains(name);
        assert_eq!(divisions, if has_two { 2 } else { 1 }, "{name}");
        assert_eq!(step.general.is_some(), divisions > 1 || step.has_inverse_step, "{name}");
        assert_eq!(step.general.map_or(1, |lanes| lanes.kernel.plan.cost().divisions), 1, "{name}");
    }
}

/// Plans for floats divide the equations by ε if this shortens the dependence chain. For the fields
/// E1, E3 and E5, only 1/ε is rounded, so the step is Kahan's map at a nearby ε.
#[test]
fn steps_are_divided_by_the_time_step_where_that_shortens_the_chain() {
    for (name, text) in &FIELDS[..8] {
        let field = field(text);
        let step = StepPlan::of(&field).expect("the fields are small");
        let expected = ["Lotka–Volterra", "E1, reduced", "E3, reduced", "E5"].contains(name);
        assert_eq!(step.has_inverse_step, expected, "{name}");
        assert!(!step.for_any_step().has_inverse_step, "{name}");
        if !expected {
            continue;
        }
        assert!(step.cycles() + 3 < step.for_any_step().cycles(), "{name}");
        let eps = Operation::Input(Input::Variable(field.symbols.epsilon()));
        let is_over_eps = |output: &Node| match &step.constants.operations[output.0] {
            Operation::Divide(above, below) => {
                let is_literal = matches!(step.constants.operations[above.0], Operation::Constant(_));
                is_literal && step.constants.operations[below.0] == eps
            }
            _ => false,
        };
        let is_homogeneous = *name != "Lotka–Volterra";
        assert_eq!(step.constants.outputs.iter().all(is_over_eps), is_homogeneous, "{name}");
    }
}

#[test]
fn only_eps_its_multiples_and_its_products_with_parameters_are_prepared_for_homogeneous_fields() {
    for (name, text) in &FIELDS[1..6] {
        let field = field(text);
        let step = StepPlan::of(&field).expect("the fields are small");
        let epsilon = field.symbols.epsilon();
        let mut degree = Vec::new();
        for operation in &step.constants.operations {
            degree.push(match operation {
                Operation::Input(Input::Variable(variable)) => usize::from(*variable == epsilon),
                Operation::Multiply(a, b) => degree[a.0] + degree[b.0],
                _ => operation.operands().map(|operand| degree[operand.0]).max().unwrap_or(0),
            });
        }
        assert!(step.constants.outputs.iter().all(|output| degree[output.0] <= 1), "{name}");
    }
}

#[test]
fn a_field_with_too_many_minors_is_left_to_elimination() {
    let names: Vec<String> = (0..9).map(|i| format!("x{i}")).collect();
    let sum = names.join(" + ");
    let text: String = names
        .iter()
        .enumerate()
        .map(|(i, x)| format!("{x}dot = {x}*({sum}) + {}*({sum});\n", i + 2))
        .collect();
    assert!(StepPlan::of(&field(&text)).is_none());
}
