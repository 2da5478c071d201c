//! Tests that a density and n − 2 integrals give an invariant bracket (section 4 of the paper).

use super::*;
use kahan_algebra::read_unproved;

const E1_IN_FIVE: &str = "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z; wdot = -x*w; vdot = -x*v;
    integral H = y/x; integral K = (x*z + y^2)/(1 - eps^2*x^2); integral L = w/x; integral M = (v + w)/x;
    density rho = 1/(x^3*y*(x*z + y^2));";

#[test]
fn brackets_in_dimensions_4_and_5_are_proved() {
    let oscillators = "xdot = y; ydot = -x; udot = a*v; vdot = -a*u;
        integral E = x^2 + y^2; integral F = u^2 + v^2; density one = 1;";
    let cases: [(&str, &str, &[&str]); 5] = [
        (oscillators, "one", &["E", "F"]),
        (E1_IN_FOUR, "rho", &["H", "K"]),
        (E1_IN_FOUR, "rho", &["K", "L"]),
        (E1_IN_FIVE, "rho", &["H", "K", "L"]),
        (E1_IN_FIVE, "rho", &["M", "K", "L"]),
    ];
    for (field, density, integrals) in cases {
        let system = system(field);
        let symbols = &system.field.symbols;
        let chosen: Vec<RationalFunction> = integrals.iter().map(|name| stated(&system, name)).collect();
        let tensor = bracket(&system, &stated(&system, density), &chosen).expect("independent integrals");
        assert!(is_proved(&system, &tensor), "{field} {integrals:?}");
        for casimir in &chosen {
            let n = symbols.dimension();
            for j in 0..n {
                let terms = (0..n).map(|k| &entry(n, &tensor, j, k) * &casimir.derivative(symbols.state(k)));
                assert!(terms.reduce(|sum, term| &sum + &term).is_some_and(|sum| sum.is_zero()), "{field}");
            }
        }
    }
}

#[test]
fn a_density_of_another_map_makes_a_bracket_that_is_refuted() {
    let system = system(E1_IN_FOUR);
    let casimirs = ["H", "K"].map(|name| stated(&system, name));
    let wrong = bracket(&system, &RationalFunction::one(), &casimirs).expect("independent integrals");
    assert!(!is_proved(&system, &wrong));
}

#[test]
fn jacobi_fails_where_it_should() {
    let poisson = |entries: &str| {
        let text = format!("xdot = 0; ydot = 0; zdot = 0; bracket P {{ {entries} }}");
        is_poisson(&tensor_of(&read_unproved(&lexer::lex(&text).tokens).system().expect("a system"), "P"))
    };
    assert!(!poisson("{x,y} = z; {y,z} = x; {z,x} = x*y;"));
    assert!(poisson("{x,y} = z; {y,z} = x; {z,x} = y;"));
    for entries in ["{x,y} = 1;", "{y,z} = x;", "{y,z} = y;", "{x,y} = 1; {y,z} = x;"] {
        assert!(poisson(entries), "{entries}");
    }
    assert!(!poisson("{x,y} = 1; {y,z} = y;"));
}

fn entry(n: usize, tensor: &[RationalFunction], j: usize, k: usize) -> RationalFunction {
    match j.cmp(&k) {
        std::cmp::Ordering::Less => tensor[upper_index(n, j, k)].clone(),
        std::cmp::Ordering::Equal => RationalFunction::zero(),
        std::cmp::Ordering::Greater => -&tensor[upper_index(n, k, j)],
    }
}

fn permutations(n: usize) -> Vec<(Vec<usize>, i64)> {
    if n == 0 {
        return vec![(Vec::new(), 1)];
    }
    let mut all = Vec::new();
    for (shorter, sign) in permutations(n - 1) {
        for place in 0..n {
            let mut longer = shorter.clone();
            longer.insert(place, n - 1);
            all.push((longer, if (n - 1 - place) % 2 == 1 { -sign } else { sign }));
        }
    }
    all
}

#[test]
fn every_entry_is_the_alternating_sum_of_the_proposition() {
    let text = "xdot = y; ydot = -x; zdot = x*y; udot = -z; vdot = x;
        density rho = 1/(2 + x*u - eps*y);
        integral A = x^2*z - v/(1 + u); integral B = y*z + u*v^2; integral C = (x - v)/(z + eps*y);";
    let system = read_unproved(&lexer::lex(text).tokens).system().expect("a system");
    let symbols = &system.field.symbols;
    let integrals = ["A", "B", "C"].map(|name| stated(&system, name));
    let density = stated(&system, "rho");
    let constructed = bracket(&system, &density, &integrals).expect("a bracket");
    let n = symbols.dimension();
    let slope = |m: usize, l: usize| integrals[m].derivative(symbols.state(l));
    for (j, k) in (0..n).flat_map(|j| (j + 1..n).map(move |k| (j, k))) {
        let mut sum = RationalFunction::zero();
        for (order, sign) in permutations(n).iter().filter(|(order, _)| order[0] == j && order[1] == k) {
            let product = (2..n).fold(RationalFunction::constant(Rational::from(*sign)), |product, m| {
                &product * &slope(m - 2, order[m])
            });
            sum = &sum + &product;
        }
        let expected = sum.checked_div(&density).expect("the density is not zero");
        assert_eq!(entry(n, &constructed, j, k), expected, "entry {j}, {k}");
    }
}

#[test]
fn coordinates_as_integrals_leave_one_entry_in_any_dimension() {
    let names: Vec<String> = (0..40).map(|i| format!("x{i}")).collect();
    let field: String = names.iter().map(|name| format!("{name}dot = 0*{name}; ")).collect();
    let large = read_unproved(&lexer::lex(&field).tokens).system().expect("a system");
    let symbols = &large.field.symbols;
    let integrals: Vec<RationalFunction> = (0..40)
        .filter(|i| ![3, 17].contains(i))
        .map(|i| RationalFunction::variable(symbols.state(i)))
        .collect();
    let constructed = bracket(&large, &RationalFunction::one(), &integrals).expect("a bracket");
    let nonzero: Vec<usize> = (0..constructed.len()).filter(|&e| !constructed[e].is_zero()).collect();
    assert_eq!(nonzero, [upper_index(40, 3, 17)]);
    // To move x3 and x17 to the front takes 3 + 16 interchanges of neighbours, so the sign is −1.
    assert_eq!(entry(40, &constructed, 3, 17), RationalFunction::constant(Rational::from(-1)));
}
