//! Tests formulas of Sections 1 to 5 as the paper states them. Matrices and determinants are
//! compared as polynomials, all other formulas over ℚ in both back ends.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use kahan_algebra::kahan::{RationalMap, scaled_matrix, scaled_rhs};
use kahan_paper::Paper;
use kahan_tests::exact::{Q, Rationals, numbers, q, shown};
use kahan_tests::expression::{Expression, evaluate};
use kahan_tests::subject::{Subject, catalog, paper};

static STATEMENTS: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
    let paper = Paper::new();
    paper.claims().iter().map(|claim| (claim.id.to_string(), claim.statement.clone())).collect()
});

const SYSTEMS: [&str; 11] = ["lv", "euler", "e1", "e2", "e3", "e4", "e5", "e6", "e7", "e8", "e9"];

/// Returns both sides of each equation in a claim such as `matrix` or `difference.x`.
fn equations(system: &str, claim: &str) -> Vec<(String, String)> {
    let id = match (system, claim.split_once('.')) {
        ("lv", _) => format!("section1.lv.{claim}"),
        (_, Some((claim, state))) => format!("{claim}.{system}.{state}"),
        (_, None) => format!("{claim}.{system}"),
    };
    let statement = STATEMENTS.get(&id).unwrap_or_else(|| panic!("no claim {id}"));
    let sides = statement.split(';').map(|equation| equation.split_once(" = ").expect("an equation"));
    sides.map(|(left, right)| (left.trim().to_owned(), right.to_owned())).collect()
}

fn named(name: &str) -> Subject {
    paper().into_iter().find(|subject| subject.name == type_name(name)).expect("a system")
}

fn type_name(command: &str) -> &'static str {
    kahan_systems::registry::find(command).expect("a system").type_name
}

fn formula(subject: &Subject, text: &str) -> Expression {
    let symbols = &subject.system.field.symbols;
    let names: Vec<&str> = symbols.states.iter().chain(&symbols.parameters).map(String::as_str).collect();
    Expression::new(&names, text)
}

#[test]
fn the_matrices_of_section_4_are_those_of_the_fields_entry_by_entry() {
    for name in SYSTEMS {
        let subject = named(name);
        let derived = scaled_matrix(&subject.system.field);
        let mut rationals = Rationals::seeded(301);
        let (x, eps) = (rationals.point(subject.dimension()), rationals.nonzero());
        let values: Vec<Q> = x.iter().chain(&subject.parameters).chain([&eps]).cloned().collect();
        let entries = equations(name, "matrix");
        assert_eq!(entries.len(), subject.dimension().pow(2), "{name}");
        for (index, (entry, text)) in entries.iter().enumerate() {
            let (i, j) = (index / subject.dimension(), index % subject.dimension());
            assert_eq!(*entry, format!("A({},{})", i + 1, j + 1), "{name}");
            let printed = formula(&subject, text).polynomial();
            assert_eq!(derived[i][j], printed, "{name}: {entry}");
            for back_end in subject.back_ends() {
                let computed = back_end.matrix(&x, &eps)[i][j].clone();
                assert_eq!(computed, evaluate(&printed, &values), "{}: {entry}", back_end.label());
            }
        }
    }
}

#[test]
fn the_determinants_are_as_verified() {
    for name in SYSTEMS {
        let subject = named(name);
        let (_, determinant) = equations(name, "determinant").remove(0);
        let map = RationalMap::of(&subject.system.field).expect("the catalog is within the budget");
        assert!(map.divisor.is_one());
        assert_eq!(map.denominator, formula(&subject, &determinant).polynomial(), "{name}");
    }
}

#[test]
fn only_lotka_volterra_has_a_right_hand_side_other_than_x() {
    for name in SYSTEMS {
        let subject = named(name);
        let printed = match name {
            "lv" => equations(name, "rhs").into_iter().map(|(_, right)| right).collect(),
            _ => ["x", "y", "z"].map(str::to_owned).to_vec(),
        };
        let expected: Vec<_> = printed.iter().map(|text| formula(&subject, text).polynomial()).collect();
        assert_eq!(scaled_rhs(&subject.system.field), expected, "{name}");
    }
}

#[test]
fn the_difference_equations_hold_along_the_step() {
    for name in SYSTEMS {
        let subject = named(name);
        let symbols = &subject.system.field.symbols;
        let n = subject.dimension();
        // Capital letters stand for the next state.
        let capitals: Vec<String> = symbols.states.iter().map(|state| state.to_uppercase()).collect();
        let names = symbols.states.iter().chain(&capitals).chain(&symbols.parameters);
        let names: Vec<&str> = names.map(String::as_str).collect();
        let residual = |state: &String| {
            let (left, right) = equations(name, &format!("difference.{state}")).remove(0);
            let text = symbols
                .states
                .iter()
                .zip(&capitals)
                .fold(format!("{left} - ({right})"), |text, (state, capital)| {
                    text.replace(&format!("next({state})"), capital)
                });
            Expression::new(&names, &text)
        };
        let residuals: Vec<Expression> = symbols.states.iter().map(residual).collect();
        let mut rationals = Rationals::seeded(302);
        let mut compared = 0;
        for _ in 0..5 {
            let (x, eps) = (rationals.point(n), rationals.nonzero());
            for back_end in subject.back_ends() {
                let Some(next) = back_end.step(&x, &eps) else { continue };
                let values: Vec<Q> = x.iter().chain(&next).chain(&subject.parameters).cloned().collect();
                for residual in &residuals {
                    assert_eq!(
                        residual.at(&values, &eps),
                        Some(q(0, 1)),
                        "{} at {}",
                        back_end.label(),
                        shown(&x)
                    );
                    compared += 1;
                }
            }
        }
        assert!(compared >= 6 * n, "{name}: {compared} residuals");
    }
}

#[test]
fn the_two_removable_poles_have_their_values() {
    for (name, x, next, det_jacobian) in [
        ("e1", "-2, 1, 1/3", "2, -1, -2/3", q(-1, 1)),
        ("e3", "3/2, 1, -2", "24/13, 16/13, 2", q(4096, 2197)),
    ] {
        let (x, next, eps) = (numbers(x), numbers(next), q(1, 2));
        for back_end in named(name).back_ends() {
            let label = back_end.label();
            assert_eq!(back_end.det_matrix(&x, &eps), q(0, 1), "{label}");
            assert_eq!(back_end.rational_map(&x, &eps), (vec![q(0, 1); 3], q(0, 1)), "{label}");
            assert_eq!(back_end.step(&x, &eps), Some(next.clone()), "{label}");
            assert_eq!(back_end.det_jacobian(&x, &eps), Some(det_jacobian.clone()), "{label}");
            assert!(back_end.jacobian(&x, &eps).is_some(), "{label}");
            let (points, _) = back_end.orbit(&x, &eps, 1);
            assert_eq!(points, [x.clone(), next.clone()], "{label}");
        }
    }
}

/// At a removable pole the Jacobian agrees with nearby steps to first order.
#[test]
fn the_jacobian_at_a_removable_pole_is_the_slope_of_the_steps_beside_it() {
    for (name, x) in [("e1", "-2, 1, 1/3"), ("e3", "3/2, 1, -2")] {
        let (x, eps, small) = (numbers(x), q(1, 2), q(1, 1_000_000));
        let subject = named(name);
        for back_end in subject.back_ends() {
            let jacobian = back_end.jacobian(&x, &eps).expect("a removable pole has a Jacobian");
            for j in 0..3 {
                let (mut right, mut left) = (x.clone(), x.clone());
                right[j] += &small;
                left[j] -= &small;
                let (right, left) = (back_end.step(&right, &eps), back_end.step(&left, &eps));
                let (right, left) = (right.expect("beside the pole"), left.expect("beside the pole"));
                for i in 0..3 {
                    let slope = (&right[i] - &left[i]) / (q(2, 1) * &small);
                    // The central difference has an error of order `small`², below `small`.
                    let error = slope - &jacobian[i][j];
                    assert!(error < small && -error < small, "{}: entry ({i},{j})", back_end.label());
                }
            }
        }
    }
}

#[test]
fn e3_steps_where_e9_at_one_has_a_pole() {
    // The factor 1 + εz cancels for E3, which is E9 at ξ = 1, but not for general ξ.
    let (x, eps) = (numbers("3/2, 1, -2"), q(1, 2));
    for back_end in catalog("e9", &[q(1, 1)]).back_ends() {
        assert_eq!(back_end.step(&x, &eps), None, "{}", back_end.label());
    }
}

#[test]
fn e7_and_e9_become_e1_to_e4_at_one_and_minus_one() {
    for (family, xi, member) in [("e7", 1, "e1"), ("e7", -1, "e2"), ("e9", 1, "e3"), ("e9", -1, "e4")] {
        let (family, member) = (catalog(family, &[q(xi, 1)]), named(member));
        let mut rationals = Rationals::seeded(303);
        let mut compared = 0;
        for _ in 0..8 {
            let (x, y, eps) = (rationals.point(3), rationals.point(3), rationals.nonzero());
            for (one, other) in family.back_ends().into_iter().zip(member.back_ends()) {
                assert_eq!(one.field(&x), other.field(&x));
                assert_eq!(one.bilinear(&x, &y), other.bilinear(&x, &y));
                assert_eq!(one.matrix(&x, &eps), other.matrix(&x, &eps));
                assert_eq!(one.rational_map(&x, &eps), other.rational_map(&x, &eps));
                if one.det_matrix(&x, &eps) != q(0, 1) {
                    assert_eq!(one.step(&x, &eps), other.step(&x, &eps));
                    assert_eq!(one.jacobian(&x, &eps), other.jacobian(&x, &eps));
                    compared += 1;
                }
            }
        }
        assert!(compared >= 12, "too many points on det A = 0");
    }
}

#[test]
fn e4_and_e6_are_euler_tops_in_other_coordinates() {
    // Kahan's map commutes with linear changes of variables.
    for (name, coordinates, parameters) in [
        ("e4", ["x - y", "x + y", "z"], [q(-1, 1), q(-1, 1), q(1, 1)]),
        ("e6", ["x - z", "x + z", "y"], [q(1, 1), q(-3, 1), q(1, 1)]),
    ] {
        let (subject, top) = (named(name), catalog("euler", &parameters));
        let change = coordinates.map(|text| Expression::new(&["x", "y", "z"], text));
        let changed = |x: &[Q]| -> Vec<Q> {
            change.iter().map(|coordinate| coordinate.at(x, &q(0, 1)).expect("a linear form")).collect()
        };
        let mut rationals = Rationals::seeded(304);
        for _ in 0..5 {
            let (x, eps) = (rationals.point(3), rationals.nonzero());
            for (one, other) in subject.back_ends().into_iter().zip(top.back_ends()) {
                let moved = one.step(&x, &eps).map(|next| changed(&next));
                assert_eq!(moved, other.step(&changed(&x), &eps), "{}", one.label());
            }
        }
    }
}

#[test]
fn lotka_volterra_at_eps_one_is_the_recurrence_of_section_1() {
    let subject = named("lv");
    let recurrence = Expression::new(&["x", "X", "Y"], "Y*X - x*(2 - x)");
    let mut rationals = Rationals::seeded(305);
    let mut compared = 0;
    for _ in 0..5 {
        let x = rationals.point(2);
        for back_end in subject.back_ends() {
            // For this map at ε = 1, ỹ = x and x_{n+1} x_{n−1} = x_n (2 − x_n).
            let Some(next) = back_end.step(&x, &q(1, 1)) else { continue };
            assert_eq!(next[1], x[0], "{}", back_end.label());
            let values = [x[0].clone(), next[0].clone(), x[1].clone()];
            assert_eq!(recurrence.at(&values, &q(1, 1)), Some(q(0, 1)), "{}", back_end.label());
            compared += 1;
        }
    }
    assert!(compared >= 6, "{compared} steps");
}
