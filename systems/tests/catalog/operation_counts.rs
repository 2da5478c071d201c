//! Tests the operation counts of steps, which must not exceed those of careful manual code.
//!
//! `KAHAN_GOLDEN=overwrite cargo test -p kahan-systems operation_counts` rewrites the table.

use std::fmt::Write;
use std::path::PathBuf;

use kahan_algebra::field::Field;
use kahan_algebra::lexer::lex;
use kahan_algebra::plan::{Cost, StepPlan};
use kahan_algebra::rational::Rational;
use kahan_algebra::read_unproved;
use kahan_algebra::system::System;
use kahan_systems::registry::{SYSTEMS, find};

const FURTHER: [&str; 2] = ["lorenz", "clebsch"];
const OTHERS: [(&str, &str); 4] = [
    (
        "volterra lattice, 6",
        "adot = a*(b - f); bdot = b*(c - a); cdot = c*(d - b); ddot = d*(e - c); edot = e*(f - d);
         fdot = f*(a - e);",
    ),
    (
        "two euler tops",
        "struct S { p, q, r } adot = p*b*c; bdot = q*c*a; cdot = r*a*b; xdot = p*y*z; ydot = q*z*x; zdot = r*x*y;",
    ),
    (
        "dense, 3",
        "xdot = x^2 + 2*x*y - 3*y*z + z^2 - x + 1; ydot = 2*x^2 - x*y + 5*z*x + y^2 + 2*y - 2;
         zdot = x^2 + 3*y^2 - x*z + 4*y*z + x - z;",
    ),
    (
        "dense, 4",
        "wdot = w^2 + w*x - y*z + 2*z^2; xdot = x*y - 3*w*z + y^2; ydot = w*y + x*z - x^2 + 1;
         zdot = z*w - 2*x*y + y*z - w;",
    ),
];

fn system(text: &str) -> System {
    read_unproved(&lex(text).tokens).system().unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"))
}

fn catalog(name: &str) -> System {
    system(find(name).expect("a system of the catalog").text())
}

fn step_cost(field: &Field) -> Option<(usize, Cost)> {
    let step = StepPlan::of(field)?;
    Some((step.constants.outputs.len(), step.next(&field.symbols).cost()))
}

fn table() -> String {
    let titles =
        ["constants", "additions", "multiplications", "multiply-adds", "divisions", "operations", "chain"];
    let mut table = format!("{:<20}", "system");
    for title in titles {
        write!(table, "  {title}").expect("a string takes everything");
    }
    table.push('\n');
    let further = FURTHER.map(|name| find(name).expect("a system of the catalog"));
    let catalog = SYSTEMS.iter().chain(further).map(|entry| (entry.command, entry.text()));
    for (name, text) in catalog.chain(OTHERS) {
        write!(table, "{name:<20}").expect("a string takes everything");
        let cost = step_cost(&system(text).field);
        let numbers = cost.map(|(constants, cost)| {
            let Cost { additions, multiplications, fused, divisions, critical_path } = cost;
            let critical_path = usize::try_from(critical_path).expect("a critical path is short");
            [constants, additions, multiplications, fused, divisions, cost.operations(), critical_path]
        });
        for (column, title) in titles.iter().enumerate() {
            let number = numbers.map_or_else(|| "-".to_owned(), |numbers| numbers[column].to_string());
            write!(table, "  {number:>width$}", width = title.len()).expect("a string takes everything");
        }
        table.push('\n');
    }
    table
}

#[test]
fn the_table_of_operation_counts_is_the_committed_one() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/plans.txt");
    let table = table();
    if std::env::var("KAHAN_GOLDEN").is_ok_and(|mode| mode == "overwrite") {
        std::fs::write(&path, &table).expect("the table can be written");
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        committed == table,
        "the operation counts changed. If that is meant, write them anew with KAHAN_GOLDEN=overwrite.\n\
         committed:\n{committed}\nnow:\n{table}"
    );
}

/// The number of operations of careful manual code with the shortest critical path and one
/// reciprocal (two for E5). Multiplications of ε and parameters are done before the step.
///
/// In the comments of the rows, e = ε, d = 2ε, X = e·x, Y = e·y, Z = e·z, D is the denominator, and
/// i = 1/D. The numerators are n, m or n₁, n₂, n₃. A variable's increment is its numerator times i.
const BY_HAND: [(&str, usize); 8] = [
    // D = (1 + (Y−X)) + e((X+Y)−e), n = d·x·((1−y)−(X−e)), m = d·y·((x−1)+(e−Y)): 13 additions, 9
    // multiplications, 1 division.
    ("lv", 23),
    // Let p, q, r be e times the coefficients, and qx = q·x and so on. Then D = ((1 − pz·(q z)) −
    // (qx·(r x) + ry·(p y))) − (qx·ry)·(pz+pz), and the first numerator is n₁ =
    // 2p·(y+qx·z)·(z+ry·x): 11 additions, 23 multiplications, 1 division.
    ("euler", 35),
    // D = (1+dx)(1−X), n₁ = x·(dx·(1−X)), n₂ = y·(dx·(1−X)), n₃ = d·y·(y+y) + z·(dx·(1+X)): 8
    // additions, 13 multiplications, 1 division.
    ("e1", 22),
    // R = X·(d x) + Y·(d y), D = (1+Z)+R, h = d·z + R, n₁ = x·h, n₂ = y·h, n₃ = (x·(d x) + y·(d
    // y))·(1−Z): 9 additions, 16 multiplications, 1 division.
    ("e3", 26),
    // v = 1−Y, u = 1+Y, i = 1/(v + X·(d x)), j = 1/u, P = d(y − X·x). The increments are (x·P)i,
    // −(d x·(x·u))i, ((P·((x+x) − z·v))j)i: 9 additions, 15 multiplications, 2 divisions.
    ("e5", 26),
    // T = 3Y, u = 1+T, v = 1−T, s = x+z, δ = x−z.
    // D = ((1 + T·Y) − 4X·(d z)) + ((X·(d x))u + (Z·(d z))v).
    // With a = d(y + (X+Z)δ), b = δ + Y·s, c = s − T·δ, the numerators are
    // a·((z+z) − x·u), d·b·c, a·(z·v − (x+x)): 19 additions, 26 multiplications, 1 division.
    ("e6", 46),
    // Let σ, ρ, β be e times the parameters. The constants c₀, c₁, c₂, t₀ contain no state. Let k =
    // 1+σ, ke = k·e, σe = σ·e, b₁ = 1+β, b₁e = b₁·e. Then D = X(ke·x + σe·y) + (c₀ + c₁·z), q = 2(x
    // + σy), R = ρ−Z, T = t₀ + σZ, n₁ = 2σ(b₁·y + x((c₂−Z) − X²)), n₂ = q(b₁·R − X·Y) − 2k(b₁e·y −
    // β(X·z)), n₃ = q(R·X + Y) − (2σ·X·Y + 2β·z·T): 19 additions, 29 multiplications, 1 division.
    ("lorenz", 49),
    // Let m and p be the states, w the parameters, (i, j, k) cyclic, and × the cross product.
    // cᵢ = wₖ−wⱼ, P = e·p, fᵢ = e·cᵢ·pⱼ, gᵢ = e·cᵢ·pₖ, aᵢ = e·mᵢ + fᵢ·Pₖ.
    // dᵢ = 1 + (Pₖ·fⱼ − Pⱼ·gₖ), s = Σ dᵢaᵢ², q = Σ dᵢaᵢpᵢ, D = d₁d₂d₃ + s.
    // nᵢ = 2dⱼdₖ(p×a)ᵢ + (2q·aᵢ − 2s·pᵢ), p̃ = p + n/D, m̃ᵢ = mᵢ + (fᵢ·p̃ₖ + gᵢ·p̃ⱼ).
    // 37 additions, 59 multiplications, 1 division.
    ("clebsch", 97),
];

#[test]
fn no_step_takes_more_operations_than_careful_code_by_hand() {
    let mut exceeded = String::new();
    for (name, by_hand) in BY_HAND {
        let other = OTHERS.iter().find(|(known, _)| *known == name);
        let system = other.map_or_else(|| catalog(name), |(_, text)| system(text));
        let (_, cost) = step_cost(&system.field).expect("a step in straight lines");
        if cost.operations() > by_hand {
            writeln!(exceeded, "{name}: {} operations, {by_hand} by hand", cost.operations())
                .expect("a string takes everything");
        }
    }
    assert!(exceeded.is_empty(), "{exceeded}");
}

mod folding {
    use super::*;

    /// Substitutes ξ = 1 in a catalog system, cancels common factors, and returns the step plan.
    fn at_xi_1(name: &str) -> Option<StepPlan> {
        let special =
            catalog(name).specialise(&[(0, Rational::one())]).expect("the field has a value at ξ = 1");
        StepPlan::of(&special.field)
    }

    #[test]
    fn e9_at_xi_1_has_the_plan_of_e3() {
        let e3 = StepPlan::of(&catalog("e3").field);
        assert!(e3.is_some());
        assert_eq!(at_xi_1("e9"), e3);
        let written = system("struct E9; const xi = 1; xdot = -x*z; ydot = -xi*y*z; zdot = x^2 + xi*y^2;");
        assert_eq!(StepPlan::of(&written.field), e3);
    }

    #[test]
    fn e7_at_xi_1_has_the_plan_of_e1() {
        let e1 = StepPlan::of(&catalog("e1").field);
        assert!(e1.is_some());
        assert_eq!(at_xi_1("e7"), e1);
        let written = system("struct E7; const xi = 1; xdot = -x^2; ydot = -xi*x*y; zdot = 2*xi*y^2 + x*z;");
        assert_eq!(StepPlan::of(&written.field), e1);
    }
}
