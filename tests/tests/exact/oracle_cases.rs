//! Checks the cases of the reference files over ℚ, in both back ends. A value that a file omits
//! must be undefined here, too.

use std::cell::Cell;

use kahan_tests::back_end::BackEnd;
use kahan_tests::exact::{Matrix, Q, Vector, q, scaled, shown};
use kahan_tests::oracle::{Entry, SYSTEMS, file};
use kahan_tests::subject::{Subject, catalog};

/// Checks every case of the reference files in both back ends. Returns the number of checks.
fn on_every_case(check: impl Fn(&str, Entry<'_>, &dyn BackEnd, &[Q], &Q)) -> usize {
    on_every_entry("cases", |name, case, subject| {
        let (x, eps) = (case.vector("x").expect("a point"), case.scalar("eps").expect("eps"));
        for back_end in subject.back_ends() {
            eprintln!("{}: x = ({}), eps = {eps}", back_end.label(), shown(&x));
            check(name, case, back_end, &x, &eps);
        }
    })
}

fn on_every_entry(key: &str, check: impl Fn(&str, Entry<'_>, &Subject)) -> usize {
    let mut seen = 0;
    for name in SYSTEMS {
        for entry in file(name).entries(key) {
            check(name, entry, &catalog(name, &entry.parameters()));
            seen += 1;
        }
    }
    seen
}

#[test]
fn the_field_and_its_slope_are_the_oracle_s() {
    let seen = on_every_case(|_, case, back_end, x, _| {
        assert_eq!(Some(back_end.field(x)), case.vector("f"));
        assert_eq!(Some(back_end.field_jacobian(x)), case.matrix("field_jacobian"));
    });
    assert_eq!(seen, 132);
}

#[test]
fn the_linear_system_is_the_oracle_s() {
    on_every_case(|_, case, back_end, x, eps| {
        assert_eq!(Some(back_end.matrix(x, eps)), case.matrix("A"));
        assert_eq!(Some(back_end.rhs(x, eps)), case.vector("b"));
        assert_eq!(Some(back_end.det_matrix(x, eps)), case.scalar("det_A"));
    });
}

#[test]
fn the_step_and_its_jacobian_are_the_oracle_s() {
    on_every_case(|_, case, back_end, x, eps| {
        assert_eq!(back_end.step(x, eps), case.vector("x_next"));
        assert_eq!(back_end.jacobian(x, eps), case.matrix("jacobian"));
        assert_eq!(back_end.det_jacobian(x, eps), case.scalar("det_jacobian"));
    });
}

#[test]
fn orbits_are_the_oracle_s_for_eight_steps() {
    let seen = on_every_entry("orbits", |name, orbit, subject| {
        let (x, eps) = (orbit.vector("x0").expect("a point"), orbit.scalar("eps").expect("eps"));
        let iterates = orbit.matrix("iterates").expect("points");
        assert_eq!(iterates.len(), 8, "{name}");
        for back_end in subject.back_ends() {
            let (points, stopped) = back_end.orbit(&x, &eps, 8);
            assert_eq!(points[0], x);
            assert_eq!(points[1..], iterates, "{}", back_end.label());
            assert!(!stopped);
        }
    });
    assert_eq!(seen, 11);
}

#[test]
fn the_integrals_are_the_oracle_s() {
    let mut compared = 0;
    for name in ["euler", "e1", "e2", "e3", "e4", "e5", "e6"] {
        for case in file(name).entries("cases") {
            // The paper states no integrals of the Euler top, so its file has `extra_integrals`.
            let expected: Option<Vector> = if case.mentions("extra_integrals") {
                case.vector("extra_integrals")
            } else {
                case.scalar("H_eps").zip(case.scalar("K_eps")).map(|(h, k)| vec![h, k])
            };
            let (x, eps) = (case.vector("x").expect("a point"), case.scalar("eps").expect("eps"));
            for back_end in catalog(name, &case.parameters()).back_ends() {
                assert_eq!(back_end.integrals(&x, &eps), expected, "{} at {}", back_end.label(), shown(&x));
            }
            compared += usize::from(expected.is_some());
        }
    }
    assert!(compared >= 80, "only {compared} cases have values");
}

#[test]
fn the_integrals_agree_at_the_next_point() {
    let compared = Cell::new(0);
    on_every_case(|name, case, back_end, x, eps| {
        let next = case.vector("x_next").and_then(|next| back_end.integrals(&next, eps));
        if let (Some(there), Some(here)) = (next, back_end.integrals(x, eps)) {
            assert_eq!(there, here, "{name}");
            compared.set(compared.get() + here.len());
        }
    });
    assert_eq!(compared.get(), 328, "integrals with a value at both points");
}

#[test]
fn the_densities_are_the_oracle_s() {
    let mut compared = 0;
    for name in SYSTEMS.iter().filter(|name| **name != "e9") {
        for case in file(name).entries("cases") {
            let mut keys = ["extra_volume_density", "volume_density"].into_iter();
            let key = keys.find(|key| case.mentions(key)).unwrap_or_else(|| panic!("{name} has no density"));
            let expected = case.scalar(key);
            let (x, eps) = (case.vector("x").expect("a point"), case.scalar("eps").expect("eps"));
            for back_end in catalog(name, &case.parameters()).back_ends() {
                assert_eq!(back_end.density(&x, &eps), expected, "{} at {}", back_end.label(), shown(&x));
            }
            compared += usize::from(expected.is_some());
        }
    }
    assert!(compared >= 100, "only {compared} cases have values");
}

#[test]
fn the_brackets_are_the_oracle_s() {
    let mut compared = [0; 2];
    for name in ["lv", "e1", "e2", "e3", "e4", "e5", "e6"] {
        for case in file(name).entries("cases") {
            let (x, eps) = (case.vector("x").expect("a point"), case.scalar("eps").expect("eps"));
            compared[0] += usize::from(case.matrix("P").is_some());
            compared[1] += usize::from(case.scalar("c").and(case.matrix("Q")).is_some());
            for back_end in catalog(name, &case.parameters()).back_ends() {
                assert_eq!(back_end.bracket("P", &x, &eps), case.matrix("P"), "{}", back_end.label());
                // The file stores `c` times the catalog's bracket Q. It stores no `c` where the
                // factor is undefined, as 1/x² is for E1 and E3 at x = 0.
                if let Some(c) = case.scalar("c") {
                    let times_c = |m: Matrix| m.iter().map(|row| scaled(&c, row)).collect::<Matrix>();
                    assert_eq!(
                        back_end.bracket("Q", &x, &eps).map(times_c),
                        case.matrix("Q"),
                        "{}",
                        back_end.label()
                    );
                }
            }
        }
    }
    assert_eq!(compared, [84, 70], "cases with values");
}

fn upper(matrix: &Matrix) -> Vector {
    (0..matrix.len()).flat_map(|i| matrix[i][i + 1..].to_vec()).collect()
}

/// Compares `factor` times a claim with an entry of the file. Returns the number of comparisons.
fn compare_claim(subject: &Subject, claim: &str, factor: &Q, case: Entry<'_>, key: &str) -> usize {
    let (x, eps) = (case.vector("x").expect("a point"), case.scalar("eps").expect("eps"));
    let Some(expected) = case.scalar(key).map(|value| vec![value]) else { return 0 };
    let value = subject.interpreted.claim(claim, &x, &eps).map(|value| scaled(factor, &value));
    assert_eq!(value, Some(expected), "{}.{claim} at {}", subject.name, shown(&x));
    1
}

fn compare_bracket(subject: &Subject, claim: &str, factor: &Q, case: Entry<'_>, key: &str) -> usize {
    let (x, eps) = (case.vector("x").expect("a point"), case.scalar("eps").expect("eps"));
    let Some(expected) = case.matrix(key) else { return 0 };
    let value = subject.interpreted.claim(claim, &x, &eps).map(|value| scaled(factor, &value));
    assert_eq!(value, Some(upper(&expected)), "{}.{claim} at {}", subject.name, shown(&x));
    1
}

#[test]
fn the_integral_of_lotka_volterra_at_eps_one_and_minus_one_is_the_oracle_s() {
    let subject = catalog("lv", &[]);
    let mut compared = 0;
    for case in file("lv").entries("cases") {
        let claim = match case.scalar("eps") {
            Some(eps) if eps == q(1, 1) => "H_forward",
            Some(eps) if eps == q(-1, 1) => "H_backward",
            _ => continue,
        };
        compared += compare_claim(&subject, claim, &q(1, 1), case, "H_eps");
    }
    assert_eq!(compared, 2);
}

/// The reference file has Ĥ₇ = (y/x) Γ(ξ/2+u)/Γ(1−ξ/2+u), where u = 1/(2εx) and Γ is the gamma
/// function. For an integer ξ, this is (2ε)^(1−ξ) times the catalog's integral of E7.
#[test]
fn the_claims_of_e7_at_integers_are_the_oracle_s() {
    let mut compared = 0;
    for case in file("e7").entries("cases") {
        let (parameters, eps) = (case.parameters(), case.scalar("eps").expect("eps"));
        let subject = catalog("e7", &parameters);
        let xi = parameters[0].clone();
        if !xi.is_integer() {
            continue;
        }
        let two_eps = q(2, 1) * eps;
        let factor = |exponent: i32| two_eps.clone().pow(exponent);
        for (value, claim, exponent) in [
            (1, "H1", 0),
            (-1, "H2", 2),
            (2, "H_at_2", -1),
            (3, "H_at_3", -2),
            (-2, "H_at_minus_2", 3),
            (-3, "H_at_minus_3", 4),
        ] {
            if xi == q(value, 1) {
                compared += compare_claim(&subject, claim, &factor(exponent), case, "H_eps");
            }
        }
        for (value, claim, sign) in [(1, "P1", -1), (-1, "P2", -1), (2, "P_at_2", 1), (3, "P_at_3", 1)] {
            if xi == q(value, 1) {
                compared += compare_bracket(&subject, claim, &q(sign, 1), case, "P");
            }
        }
        for (value, claim) in [(1, "K1"), (-1, "K2")] {
            if xi == q(value, 1) {
                compared += compare_claim(&subject, claim, &q(1, 1), case, "K_eps");
            }
        }
    }
    assert_eq!(compared, 12, "5 of H, 4 of P, 3 of K");
}

#[test]
fn the_claims_of_e9_at_one_and_minus_one_are_the_oracle_s() {
    let mut compared = 0;
    for case in file("e9").entries("cases") {
        let parameters = case.parameters();
        let subject = catalog("e9", &parameters);
        let at = match &parameters[0] {
            xi if *xi == q(1, 1) => 3,
            xi if *xi == q(-1, 1) => 4,
            _ => continue,
        };
        let one = q(1, 1);
        for (claim, key) in [("H", "H_eps"), ("K", "K_eps"), ("rho", "volume_density")] {
            compared += compare_claim(&subject, &format!("{claim}{at}"), &one, case, key);
        }
        compared += compare_bracket(&subject, &format!("P{at}"), &one, case, "P");
        let c = case.scalar("c").expect("the factor of Q");
        compared += compare_bracket(&subject, &format!("Q{at}"), &c, case, "Q");
    }
    assert_eq!(compared, 20, "four cases, five claims each");
}

#[test]
fn where_the_oracle_s_determinant_is_zero_every_way_to_step_says_pole() {
    let seen = on_every_entry("singular", |_, point, subject| {
        let (x, eps) = (point.vector("x").expect("a point"), point.scalar("eps").expect("eps"));
        assert_eq!(point.scalar("det_A"), Some(q(0, 1)));
        for back_end in subject.back_ends() {
            eprintln!("{}: x = ({}), eps = {eps}", back_end.label(), shown(&x));
            assert_eq!(Some(back_end.matrix(&x, &eps)), point.matrix("A"));
            assert_eq!(Some(back_end.rhs(&x, &eps)), point.vector("b"));
            assert_eq!(back_end.det_matrix(&x, &eps), q(0, 1));
            // The pole is not removable, so every way to step must fail.
            assert_eq!(back_end.step(&x, &eps), None);
            assert_eq!(back_end.jacobian(&x, &eps), None);
            assert_eq!(back_end.det_jacobian(&x, &eps), None);
            assert_eq!(back_end.orbit(&x, &eps, 3), (vec![x.clone()], true));
        }
    });
    assert_eq!(seen, 12);
}
