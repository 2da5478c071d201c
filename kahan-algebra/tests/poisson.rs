//! The constructor of invariant brackets: the tables of the paper come out of it exactly, the prover agrees with it in any
//! dimension, and what it cannot do it says.

use kahan_algebra::poisson::{
    PoissonError, PoissonTensor, claim_functions, default_budget, invariant_bracket,
};
use kahan_algebra::poly::{Budget, OverBudget, Variable};
use kahan_algebra::prove::{Verdict, prove_all};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::{Notation, claim_statement, claim_text};
use kahan_algebra::system::{Claim, Condition, System};
use kahan_algebra::{lexer, read};

/// The block of a source file of the catalog.
fn block(file: &'static str) -> &'static str {
    let (_, rest) = file.split_once("\nkahan! {\n").expect("the file has a block");
    rest.split_once("\n}\n").expect("the block ends").0
}

/// E1 to E6 in order: the blocks, whose P and Q are Table 3 and Table 4 divided by c.
const TABLES: [&str; 6] = [
    include_str!("../../systems/src/catalog/e1.rs"),
    include_str!("../../systems/src/catalog/e2.rs"),
    include_str!("../../systems/src/catalog/e3.rs"),
    include_str!("../../systems/src/catalog/e4.rs"),
    include_str!("../../systems/src/catalog/e5.rs"),
    include_str!("../../systems/src/catalog/e6.rs"),
];

fn system(text: &str) -> System {
    let reading = read(&lexer::lex(text).tokens);
    assert!(reading.diagnostics.is_empty(), "{:?}", reading.diagnostics);
    reading.system
}

fn claim<'a>(system: &'a System, name: &str) -> &'a Claim {
    system.claims.iter().find(|claim| claim.name.text == name).expect("the claim exists")
}

fn functions(system: &System, name: &str) -> Vec<RationalFunction> {
    claim_functions(claim(system, name), &mut default_budget()).expect("within the budget")
}

fn function(system: &System, name: &str) -> RationalFunction {
    let [function] = <[_; 1]>::try_from(functions(system, name)).expect("one function");
    function
}

fn tensor(system: &System, name: &str) -> PoissonTensor {
    PoissonTensor::new(&system.field.symbols, functions(system, name)).expect("a tensor")
}

fn bracket(
    system: &System,
    density: &RationalFunction,
    integrals: &[RationalFunction],
) -> Result<PoissonTensor, PoissonError> {
    invariant_bracket(&system.field.symbols, density, integrals, &mut default_budget())
}

/// Reads the field with the tensor's claim behind it: the claim must come back as the same tensor, proved.
fn assert_proved(field: &str, tensor: &PoissonTensor) {
    let mut own = system(field);
    let constructed = tensor.claim(&own.field.symbols, "Constructed", Vec::new());
    let text = claim_text(&own, &constructed);
    let again = system(&format!("{field} {text}"));
    assert_eq!(&self::tensor(&again, "Constructed"), tensor, "{text}");
    // The claim is proved as data as well as read from its text.
    own.claims.push(constructed);
    let verdict = prove_all(&own, 1).pop().flatten();
    assert!(matches!(verdict, Some(Verdict::Proved(_))), "{text}: {verdict:?}");
}

#[test]
fn the_brackets_of_tables_3_and_4_come_out_of_densities_and_integrals() {
    for file in TABLES {
        let system = system(block(file));
        let (h, k) = (function(&system, "H"), function(&system, "K"));
        // ρ ĤK̂ with ρ = c/(HK): formulas (p1) and (q3).
        let density = &(&function(&system, "rho") * &h) * &k;
        let p = bracket(&system, &-&density, std::slice::from_ref(&h)).expect("a bracket");
        let q = bracket(&system, &density, std::slice::from_ref(&k)).expect("a bracket");
        assert_eq!(p, tensor(&system, "P"), "P of {}", system.name());
        assert_eq!(q, tensor(&system, "Q"), "Q/c of {}", system.name());
        // The other sign is another bracket: the comparison could have failed.
        assert_ne!(bracket(&system, &density, &[h]).expect("a bracket"), tensor(&system, "P"));
    }
}

#[test]
fn the_pairs_are_poisson_compatible_and_in_involution() {
    let budget = &mut default_budget();
    for file in TABLES {
        let system = system(block(file));
        let (h, k) = (function(&system, "H"), function(&system, "K"));
        let (p, q) = (tensor(&system, "P"), tensor(&system, "Q"));
        assert_eq!(p.is_poisson(budget), Ok(true));
        assert_eq!(q.is_poisson(budget), Ok(true));
        assert_eq!(p.is_compatible_with(&q, budget), Ok(true));
        assert_eq!(p.is_casimir(&h, budget), Ok(true));
        assert_eq!(p.is_casimir(&k, budget), Ok(false));
        assert_eq!(q.is_casimir(&k, budget), Ok(true));
        assert_eq!(q.is_casimir(&h, budget), Ok(false));
        for tensor in [&p, &q] {
            assert!(tensor.bracket(&h, &k, budget).expect("within the budget").is_zero());
        }
    }
}

#[test]
fn the_undivided_tensor_of_table_4_is_compatible_only_where_c_is_constant() {
    // Q(ε) of E1 is Poisson, being a multiple of Q(ε)/c in dimension 3, but does not go with P(ε).
    let system = system(block(TABLES[0]));
    let budget = &mut default_budget();
    let x = RationalFunction::variable(system.field.symbols.state(0));
    let c = x.pow(-2).expect("x is not zero");
    let q = tensor(&system, "Q").scaled(&c, budget).expect("within the budget");
    assert_eq!(q.is_poisson(budget), Ok(true));
    assert_eq!(q.is_compatible_with(&tensor(&system, "P"), budget), Ok(false));
}

#[test]
fn the_euler_top_has_the_brackets_of_its_density() {
    let system = system(block(include_str!("../../systems/src/catalog/euler.rs")));
    let symbols = &system.field.symbols;
    let (eps, a1, a2) = (symbols.epsilon(), symbols.parameter(0), symbols.parameter(1));
    let scale = |parameter: Variable, sign: i64| {
        let product = &RationalFunction::variable(eps).pow(2).expect("positive")
            * &RationalFunction::variable(parameter);
        (&product * &RationalFunction::constant(Rational::from(2 * sign))).recip().expect("not zero")
    };
    let density = function(&system, "rho");
    let h = &function(&system, "H") * &scale(a1, 1);
    let k = &function(&system, "K").recip().expect("not zero") * &scale(a2, -1);
    assert_eq!(bracket(&system, &density, &[h]), Ok(tensor(&system, "P")));
    assert_eq!(bracket(&system, &density, &[k]), Ok(tensor(&system, "Q")));
}

#[test]
fn in_the_plane_the_bracket_is_the_reciprocal_of_the_density() {
    let field = block(include_str!("../../systems/src/catalog/lotka_volterra.rs"));
    let system = system(field);
    let constructed = bracket(&system, &function(&system, "rho"), &[]).expect("a bracket");
    assert_eq!(constructed, tensor(&system, "P"));
    assert_proved(field, &constructed);
}

#[test]
fn the_brackets_of_e7_at_integer_xi_belong_to_the_density_times_the_integral() {
    let system = system(block(include_str!("../../systems/src/catalog/e7.rs")));
    let density = function(&system, "rho");
    let signs = [("H1", "P1", -1), ("H2", "P2", -1), ("H_at_2", "P_at_2", 1), ("H_at_3", "P_at_3", 1)];
    for (integral, printed, sign) in signs {
        let h = function(&system, integral);
        let weight = &(&density * &h) * &RationalFunction::constant(Rational::from(sign));
        assert_eq!(bracket(&system, &weight, &[h]), Ok(tensor(&system, printed)), "{printed}");
    }
}

/// E1 with further components that follow y, each with the integral quotient by x.
const E1_IN_FOUR: &str = "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z; wdot = -x*w;
    integral H = y/x; integral K = (x*z + y^2)/(1 - eps^2*x^2); integral L = w/x;
    density rho = 1/(x^2*y*(x*z + y^2));";
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
        let integrals: Vec<RationalFunction> = integrals.iter().map(|name| function(&system, name)).collect();
        let constructed = bracket(&system, &function(&system, density), &integrals).expect("a bracket");
        assert!(!constructed.is_zero());
        let budget = &mut default_budget();
        for integral in &integrals {
            assert_eq!(constructed.is_casimir(integral, budget), Ok(true));
        }
        assert_eq!(constructed.is_poisson(budget), Ok(true));
        assert_proved(field, &constructed);
    }
}

#[test]
fn a_density_of_another_map_makes_a_bracket_that_is_refuted() {
    let mut system = system(E1_IN_FOUR);
    let integrals = [function(&system, "H"), function(&system, "K")];
    let constructed = bracket(&system, &RationalFunction::one(), &integrals).expect("a bracket");
    system.claims.push(constructed.claim(&system.field.symbols, "Wrong", Vec::new()));
    assert!(matches!(prove_all(&system, 1).pop(), Some(Some(Verdict::Refuted(_)))));
}

/// All permutations of 0 … n−1 with their signs.
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
    // These are no invariants; the entries are defined all the same.
    let system = read(&lexer::lex(text).tokens).system;
    let symbols = &system.field.symbols;
    let names = ["A", "B", "C"];
    let integrals: Vec<RationalFunction> = names.iter().map(|name| function(&system, name)).collect();
    let density = function(&system, "rho");
    let constructed = bracket(&system, &density, &integrals).expect("a bracket");
    let n = symbols.dimension();
    let slope = |m: usize, l: usize| integrals[m].derivative(symbols.state(l));
    for j in 0..n {
        for k in 0..n {
            let mut sum = RationalFunction::zero();
            for (order, sign) in permutations(n).iter().filter(|(order, _)| order[0] == j && order[1] == k) {
                let product = (2..n).fold(RationalFunction::constant(Rational::from(*sign)), |product, m| {
                    &product * &slope(m - 2, order[m])
                });
                sum = &sum + &product;
            }
            let expected = sum.checked_div(&density).expect("the density is not zero");
            assert_eq!(constructed.entry(j, k), expected, "entry {j}, {k}");
        }
    }
}

#[test]
fn what_is_wrong_is_said_in_the_words_of_the_problem() {
    let system = system(E1_IN_FOUR);
    let (h, k, rho) = (function(&system, "H"), function(&system, "K"), function(&system, "rho"));
    let error = |density: &RationalFunction, integrals: &[RationalFunction]| {
        bracket(&system, density, integrals).expect_err("no bracket")
    };
    assert_eq!(error(&rho, std::slice::from_ref(&h)), PoissonError::IntegralCount { dimension: 4, given: 1 });
    assert_eq!(error(&RationalFunction::zero(), &[h.clone(), k.clone()]), PoissonError::ZeroDensity);
    let dependent = &(&h * &h) + &RationalFunction::one();
    assert_eq!(error(&rho, &[h.clone(), dependent]), PoissonError::DependentIntegral { index: 1 });
    let constant = RationalFunction::variable(system.field.symbols.epsilon());
    assert_eq!(error(&rho, &[constant, k]), PoissonError::DependentIntegral { index: 0 });
    let message = PoissonError::IntegralCount { dimension: 4, given: 1 }.to_string();
    assert!(message.contains("a density and 2 integrals") && message.contains("1 were given"), "{message}");

    let line = self::system("xdot = x;");
    assert_eq!(bracket(&line, &h, &[]), Err(PoissonError::Dimension { dimension: 1 }));
    let plane = self::system("xdot = y; ydot = -x;");
    assert_eq!(
        PoissonTensor::new(&plane.field.symbols, vec![h.clone(), h]),
        Err(PoissonError::EntryCount { dimension: 2, given: 2 })
    );
}

#[test]
fn a_claim_that_divides_by_zero_at_its_condition_has_no_function() {
    let text =
        "xdot = y; ydot = -x; integral F = x/(1 - eps) when eps = 1; integral G = x/eps when eps = 1/2;";
    let system = read(&lexer::lex(text).tokens).system;
    let budget = &mut default_budget();
    assert_eq!(
        claim_functions(claim(&system, "F"), budget),
        Err(PoissonError::UndefinedClaim { name: "F".to_owned() })
    );
    let twice =
        &RationalFunction::variable(system.field.symbols.state(0)) * &RationalFunction::constant(2.into());
    assert_eq!(claim_functions(claim(&system, "G"), budget), Ok(vec![twice]));
}

#[test]
fn work_beyond_the_budget_is_refused_and_not_begun() {
    let system = system(block(TABLES[5]));
    let (h, rho) = (function(&system, "H"), function(&system, "rho"));
    let mut little = Budget::new(100, 20);
    assert_eq!(
        invariant_bracket(&system.field.symbols, &rho, std::slice::from_ref(&h), &mut little),
        Err(PoissonError::OverBudget)
    );
    assert_eq!(claim_functions(claim(&system, "K"), &mut Budget::new(100, 5)), Err(PoissonError::OverBudget));
    assert_eq!(tensor(&system, "P").is_poisson(&mut Budget::new(100, 5)), Err(OverBudget));

    // Twenty-four states and dense integrals: 2²⁴ minors in the middle.
    let names: Vec<String> = (0..24).map(|i| format!("x{i}")).collect();
    let field: String = names.iter().map(|name| format!("{name}dot = {name}; ")).collect();
    let large = read(&lexer::lex(&field).tokens).system;
    let symbols = &large.field.symbols;
    let power_sum = |exponent: i32| {
        (0..24).fold(RationalFunction::zero(), |sum, i| {
            &sum + &RationalFunction::variable(symbols.state(i)).pow(exponent).expect("positive")
        })
    };
    let integrals: Vec<RationalFunction> = (1..=22).map(power_sum).collect();
    let refused = invariant_bracket(symbols, &RationalFunction::one(), &integrals, &mut default_budget());
    assert_eq!(refused, Err(PoissonError::OverBudget));
}

#[test]
fn coordinates_as_integrals_leave_one_entry_in_any_dimension() {
    let names: Vec<String> = (0..40).map(|i| format!("x{i}")).collect();
    let field: String = names.iter().map(|name| format!("{name}dot = 0*{name}; ")).collect();
    let large = read(&lexer::lex(&field).tokens).system;
    let symbols = &large.field.symbols;
    // All coordinates but x3 and x17.
    let integrals: Vec<RationalFunction> = (0..40)
        .filter(|i| ![3, 17].contains(i))
        .map(|i| RationalFunction::variable(symbols.state(i)))
        .collect();
    let constructed = bracket(&large, &RationalFunction::one(), &integrals).expect("a bracket");
    let nonzero: Vec<(usize, usize)> = (0..40)
        .flat_map(|i| (i + 1..40).map(move |j| (i, j)))
        .filter(|&(i, j)| !constructed.entry(i, j).is_zero())
        .collect();
    assert_eq!(nonzero, [(3, 17)]);
    // x3 passes 3 variables, x17 the 16 that are left before it.
    assert_eq!(constructed.entry(3, 17), RationalFunction::constant(Rational::from(-1)));
}

#[test]
fn jacobi_fails_where_it_should() {
    let text = "xdot = 0; ydot = 0; zdot = 0; bracket P { {x,y} = z; {y,z} = x; {z,x} = x*y; }
        bracket Q { {x,y} = 1; } bracket R { {x,y} = z; {y,z} = y; }";
    let system = read(&lexer::lex(text).tokens).system;
    let budget = &mut default_budget();
    let [p, q, r] = ["P", "Q", "R"].map(|name| tensor(&system, name));
    assert_eq!(p.is_poisson(budget), Ok(false));
    assert_eq!(q.is_poisson(budget), Ok(true));
    // Σ over x, y, z of Q_il ∂_l P_jk: only {x,y} = 1 acts, on {y,z} by ∂_y and on {z,x} by −∂_x.
    let y = RationalFunction::variable(system.field.symbols.state(1));
    assert_eq!(q.schouten(&p, budget), Ok(vec![-&y]));
    assert_eq!(p.schouten(&q, budget), Ok(vec![-&y]));
    assert_eq!(q.schouten(&r, budget), Ok(vec![RationalFunction::one()]));
    assert_eq!(q.is_compatible_with(&q.scaled(&y, budget).expect("small"), budget), Ok(true));
}

#[test]
fn a_constructed_bracket_is_written_as_people_write_it() {
    let e6 = system(block(TABLES[5]));
    let claim = tensor(&e6, "P").claim(&e6.field.symbols, "P", Vec::new());
    assert_eq!(
        claim_text(&e6, &claim),
        "bracket P { {x,y} = x*(1 + 3*eps^2*y^2); {y,z} = z*(1 + 3*eps^2*y^2); {z,x} = 2*y*(1 - 3*eps^2*x*z); }"
    );
    assert_eq!(
        claim_statement(&claim, Notation::Latex)[2],
        ("\\{z,x\\}".to_owned(), "2 y \\left(1 - 3 \\varepsilon^{2} x z\\right)".to_owned())
    );
    let e1 = system(block(TABLES[0]));
    let claim = tensor(&e1, "Q").claim(
        &e1.field.symbols,
        "Q",
        vec![Condition::fixed(&e1.field.symbols, e1.field.symbols.epsilon(), &Rational::new(1, 2))],
    );
    let text = claim_text(&e1, &claim);
    assert!(text.starts_with("bracket Q { {x,y} = x^3; {y,z} = x^2*"), "{text}");
    assert!(text.ends_with("} when eps = 1/2;"), "{text}");
}

#[test]
fn any_entry_reads_back_as_itself() {
    let entries = [
        "0",
        "1",
        "-1",
        "-2/3",
        "x",
        "-x/y",
        "1/x",
        "-1/(x*y)",
        "3/4*a*x^2/(5*y)",
        "x - y",
        "y - x",
        "-(x + y)",
        "(x - 1/2)/(y - 1/3)",
        "-(x^2 - y)/(7*(y - x))",
        "a*(x - y)/(x + y)^2",
        "x^60*x^60*y",
        "1/(x^50*y^60*y^60)",
        "1/(1 - eps^2*x^2)",
        "(eps - 1)/(eps + 1)/a",
    ];
    for entry in entries {
        let text = format!("xdot = 0; ydot = a - a; bracket P {{ {{x,y}} = {entry}; }}");
        let first = read(&lexer::lex(&text).tokens).system;
        let expected = tensor(&first, "P");
        let written = claim_text(&first, &expected.claim(&first.field.symbols, "P", Vec::new()));
        let again = read(&lexer::lex(&format!("xdot = 0; ydot = a - a; {written}")).tokens).system;
        assert_eq!(tensor(&again, "P"), expected, "{entry} was written {written}");
    }
}
