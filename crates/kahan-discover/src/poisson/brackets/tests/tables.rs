//! Tests the brackets in the paper's tables, and the brackets of the Euler top and of E7.

use super::*;

fn block(file: &'static str) -> &'static str {
    let (_, rest) = file.split_once("\nkahan! {\n").expect("the file has a block");
    rest.split_once("\n}\n").expect("the block ends").0
}

/// The systems E1 to E6 of Hone and Petrera claim the bracket P of Table 3, and Q/c for the bracket
/// Q of Table 4. The function c satisfies f = −(1/c) Q∇H for the field f and its integral H.
const TABLES: [&str; 6] = [
    include_str!("../../../../../../systems/src/catalog/e1.rs"),
    include_str!("../../../../../../systems/src/catalog/e2.rs"),
    include_str!("../../../../../../systems/src/catalog/e3.rs"),
    include_str!("../../../../../../systems/src/catalog/e4.rs"),
    include_str!("../../../../../../systems/src/catalog/e5.rs"),
    include_str!("../../../../../../systems/src/catalog/e6.rs"),
];

#[test]
fn the_brackets_of_tables_3_and_4_come_out_of_densities_and_integrals() {
    for file in TABLES {
        let system = system(block(file));
        let [h, k, rho] = ["H", "K", "rho"].map(|name| stated(&system, name));
        let [p, q] = ["P", "Q"].map(|name| tensor_of(&system, name));
        // Formulas (p1) and (q3) of Hone and Petrera use the density ρHK with integrals H and K.
        let density = &(&rho * &h) * &k;
        assert_eq!(
            bracket(&system, &-&density, std::slice::from_ref(&h)).as_ref(),
            Some(&p),
            "P of {}",
            system.name()
        );
        assert_eq!(bracket(&system, &density, &[k]).as_ref(), Some(&q), "Q/c of {}", system.name());
        assert_ne!(bracket(&system, &density, &[h]), Some(p));
    }
}

#[test]
fn the_pairs_of_tables_3_and_4_are_poisson_and_compatible() {
    for file in TABLES {
        let system = system(block(file));
        let [p, q] = ["P", "Q"].map(|name| tensor_of(&system, name));
        for tensor in [&p, &q, &sum(&p, &q)] {
            assert!(is_poisson(tensor) && is_proved(&system, tensor), "{}", system.name());
        }
    }
}

#[test]
fn the_undivided_tensor_of_table_4_is_compatible_only_where_c_is_constant() {
    let system = system(block(TABLES[0]));
    let c = power(system.field.symbols.state(0), 2).recip().expect("x is not zero");
    let undivided: Vec<_> = tensor_of(&system, "Q").iter().map(|entry| entry * &c).collect();
    assert!(is_poisson(&undivided));
    assert!(!is_poisson(&sum(&undivided, &tensor_of(&system, "P"))));
}

#[test]
fn the_euler_top_has_two_compatible_brackets_of_its_density() {
    let system = system(block(include_str!("../../../../../../systems/src/catalog/euler.rs")));
    let symbols = &system.field.symbols;
    let square = power(symbols.epsilon(), 2);
    let scale = |parameter: usize, sign: i64| {
        let product = &square * &RationalFunction::variable(symbols.parameter(parameter));
        (&product * &RationalFunction::constant(Rational::from(2 * sign))).recip().expect("not zero")
    };
    let density = stated(&system, "rho");
    let h = &stated(&system, "H") * &scale(0, 1);
    let k = &stated(&system, "K").recip().expect("not zero") * &scale(1, -1);
    let [p, q] = [h, k].map(|integral| bracket(&system, &density, &[integral]).expect("a bracket"));
    assert_eq!([&p, &q], [&tensor_of(&system, "P"), &tensor_of(&system, "Q")]);
    for tensor in [&p, &q, &sum(&p, &q)] {
        assert!(is_proved(&system, tensor));
    }
    let wrong = bracket(&system, &RationalFunction::one(), &[stated(&system, "H")]).expect("a bracket");
    assert!(!is_proved(&system, &wrong));
}

#[test]
fn the_brackets_of_e7_at_integer_xi_belong_to_the_density_times_the_integral() {
    let system = system(block(include_str!("../../../../../../systems/src/catalog/e7.rs")));
    let density = stated(&system, "rho");
    let cases =
        [("H1", "P1", -1, 1), ("H2", "P2", -1, -1), ("H_at_2", "P_at_2", 1, 2), ("H_at_3", "P_at_3", 1, 3)];
    for (integral, printed, sign, xi) in cases {
        let h = stated(&system, integral);
        let weight = &(&density * &h) * &RationalFunction::constant(Rational::from(sign));
        let constructed = bracket(&system, &weight, &[h]).expect("a bracket");
        assert_eq!(constructed, tensor_of(&system, printed), "{printed}");
        let at = |xi: i64| [("xi".to_owned(), Rational::from(xi))];
        assert!(is_proved_at(&system, &at(xi), &constructed), "{printed}");
        assert!(!is_proved_at(&system, &at(xi + 5), &constructed), "{printed} belongs to its xi alone");
    }
}

#[test]
fn in_the_plane_the_bracket_is_the_reciprocal_of_the_density() {
    let system = system(block(include_str!("../../../../../../systems/src/catalog/lotka_volterra.rs")));
    let constructed = bracket(&system, &stated(&system, "rho"), &[]).expect("a bracket");
    assert_eq!(constructed, tensor_of(&system, "P"));
    assert!(is_proved(&system, &constructed));
}

#[test]
fn a_bracket_is_written_in_factors() {
    let e6 = system(block(TABLES[5]));
    let claims = Claims::new(&e6, &[], None);
    assert_eq!(
        claims.bracket_entries(&e6.field.symbols, &tensor_of(&e6, "P")),
        "{x, y} = x*(1 + 3*eps^2*y^2); {x, z} = -2*y*(1 - 3*eps^2*x*z); {y, z} = z*(1 + 3*eps^2*y^2);"
    );
}
