//! Tests that both provers agree on true and false claims.

use kahan_algebra::check::Checked;
use kahan_algebra::diagnostics::Kind;
use kahan_algebra::prove::{Refutation, Verdict, points_needed, prove_all, prove_by_normal_form};
use kahan_algebra::{lexer, read, read_unproved, seed};

const E3: &str = "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;";
const SQUARE: &str = "xdot = x^2;";
const GROWING: &str = "xdot = 0; ydot = y; zdot = z;";
const E6: &str = "xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);";

fn reading(text: &str) -> Checked {
    read(&lexer::lex(text).tokens)
}

fn verdicts(text: &str) -> Vec<Verdict> {
    let tokens = lexer::lex(text).tokens;
    prove_all(&read_unproved(&tokens).system().expect("a system"), seed(&tokens))
}

#[test]
fn both_provers_agree_on_true_and_on_false_claims() {
    let claims = [
        (E3, "integral F = y/x;", true),
        (E3, "integral F = x/y + 7;", true),
        (E3, "integral F = y/x + x;", false),
        (E3, "integral F = (x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));", true),
        (E3, "integral F = (x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2 + z^2));", false),
        (SQUARE, "drift F = 1/x by F - 2*eps;", true),
        (SQUARE, "drift F = 1/x by F + 2*eps;", false),
        (SQUARE, "drift F = x by F/(1 - 2*eps*F);", true),
        (SQUARE, "drift F = x by F;", false),
        ("xdot = a*x;", "drift F = x^2 by (1 + a*eps)^2/(1 - a*eps)^2*F;", true),
        ("xdot = a*x;", "drift F = x by 3*F when a*eps = 1/2;", true),
        ("xdot = a*x;", "drift F = x by 2*F when a*eps = 1/2;", false),
        (E6, "density F = 1/((x*z + y^2)*(x^2 + y^2 + z^2));", true),
        (E6, "density F = 1/((x*z + y^2)^2*(x^2 + y^2 + z^2));", false),
        (E6, "density F = 1/(x*z + y^2)^2;", true),
        (E6, "density F = 1/(x*z + y^2)^2 when eps = 1/3;", true),
        (E6, "density F = 1/(x*z + y^2) when eps = 1/3;", false),
        (
            E6,
            "bracket F { {x,y} = x*(1 + 3*eps^2*y^2); {y,z} = z*(1 + 3*eps^2*y^2); {z,x} = 2*y*(1 - 3*eps^2*x*z); }",
            true,
        ),
        (E6, "bracket F { {x,y} = x*(1 + 3*eps^2*y^2); {y,z} = z*(1 + 3*eps^2*y^2); {z,x} = 2*y; }", false),
        (GROWING, "bracket F { {y,z} = y*z; }", true),
        (GROWING, "bracket F { {y,z} = 1; }", false),
        // The claim divides by zero if x is a fraction of integers up to 3.
        (
            GROWING,
            "integral F = 1/(x*(x^2 - 1)*(x^2 - 4)*(x^2 - 9)*(4*x^2 - 1)*(4*x^2 - 9)*(9*x^2 - 1)*(9*x^2 - 4));",
            true,
        ),
    ];
    for (field, claim, holds) in claims {
        let text = format!("{field} {claim}");
        let system = read_unproved(&lexer::lex(&text).tokens).system().expect("a system");
        assert_eq!(prove_by_normal_form(&system, &system.claims[0]), Some(holds), "{claim}");
        let proved = matches!(verdicts(&text)[..], [Verdict::Proved(_)]);
        assert_eq!(proved, holds, "{claim}");
    }
}

#[test]
fn an_invariant_tensor_that_is_not_poisson_is_refused() {
    // Every bracket is invariant under the identity, but this one violates the Jacobi identity.
    let text = "xdot = 0; ydot = 0; zdot = 0; bracket P { {x,y} = z; {y,z} = x; {z,x} = x*y; }";
    let reading = reading(text);
    let [diagnostic] = reading.diagnostics() else { panic!("one mistake") };
    assert_eq!(diagnostic.kind, Kind::FalseClaim);
    assert!(diagnostic.message.contains("Jacobi sum of x, y, z"), "{}", diagnostic.message);
}

#[test]
fn a_refutation_shows_two_different_values() {
    let text = format!("{E3} integral F = z;");
    let [Verdict::Refuted(Refutation::At { left, right, .. })] = &verdicts(&text)[..] else {
        panic!("z is no integral")
    };
    assert_ne!(left, right);
}

#[test]
fn claims_that_say_nothing_are_refused() {
    for claim in [
        "integral F = 3;",
        "integral F = eps;",
        "integral F = x - x;",
        "integral F = (y/x)^0;",
        "density F = 0;",
        "density F = x - x;",
        "bracket F { {x,y} = 0; }",
    ] {
        let text = format!("{E3} {claim}");
        assert_eq!(verdicts(&text), [Verdict::Vacuous], "{claim}");
        assert_eq!(reading(&text).diagnostics().len(), 1, "{claim}");
    }
}

#[test]
fn a_claim_that_divides_by_zero_identically_is_undefined() {
    for claim in
        ["integral F = x/(y - y);", "integral F = 1/(x*y - y*x);", "density F = 1/(1 - eps) when eps = 1;"]
    {
        assert_eq!(verdicts(&format!("{E3} {claim}")), [Verdict::Undefined], "{claim}");
    }
}

#[test]
fn multiples_of_large_primes_are_no_hiding_place() {
    // The claim holds modulo `prime`. A proof modulo this prime alone would accept it.
    for prime in ["2305843009213693951", "2305843009213693921", "1152921504606846883"] {
        let text = format!("{E3} integral F = y/x + {prime}*z;");
        assert!(matches!(verdicts(&text)[..], [Verdict::Refuted(_)]), "{prime}");
    }
}

#[test]
fn the_number_of_points_follows_from_the_bound() {
    assert_eq!(points_needed(1, 1), Some(3));
    assert_eq!(points_needed(900, 100), Some(3));
    assert_eq!(points_needed(1 << 36, 0), Some(7));
    assert_eq!(points_needed(u64::MAX, 0), None);
}

/// To prove a claim with k points, the prover tries at most k + 15 steps. For each step it draws at
/// most 16 points.
#[test]
fn the_points_of_a_proof_pay_for_every_draw_that_may_pass_wrongly() {
    for degree in (0..46).flat_map(|power| [1_u64 << power, 3 << power]) {
        for bits in [0, 100, 1 << 20] {
            let points = points_needed(degree, bits).expect("a reasonable number of points");
            let draw = (bits as f64 / 60.0).mul_add(64.0, degree as f64).log2() - 60.0;
            let choices: f64 = (1..=15).map(|i| (f64::from(points + i) / f64::from(i)).log2()).sum();
            let error = f64::from(points).mul_add(draw + 4.0, choices);
            assert!(error <= -100.0, "{points} points err by 2^{error} at {degree}, {bits}");
        }
    }
}

#[test]
fn a_proof_is_the_same_every_time() {
    let text = format!("{E6} integral F = x;");
    assert_eq!(reading(&text).diagnostics(), reading(&text).diagnostics());
}

#[test]
fn conditions_specialise_the_map() {
    let lv = "xdot = x*(1 - y); ydot = y*(x - 1);";
    let integral = "x^2/y^2 + y^2/x^2 + 4*(1/x - 1/y)^2*(1 - x - y)";
    for (when, holds) in
        [("when eps = 1", true), ("when eps = -1", true), ("when eps = 2", false), ("", false)]
    {
        let text = format!("{lv} integral F = {integral} {when};");
        assert_eq!(reading(&text).diagnostics().is_empty(), holds, "{when}");
    }
}

#[test]
fn a_claim_where_there_is_no_map_says_so() {
    // For this field, det A is 1 − ε, so there is no map at ε = 1.
    let text = "xdot = x; integral F = x when eps = 1;";
    assert_eq!(verdicts(text), [Verdict::NoMap]);
    assert!(reading(text).diagnostics()[0].message.contains("eps = 1"));
}

#[test]
fn a_normal_form_that_grows_too_large_is_given_up() {
    let text = "sdot = -b*s*i; idot = b*s*i - g*i; rdot = g*i; integral N = (s + i + r)^64;
        integral M = 1/N; integral Q = M*N^2 + b*g*eps;";
    let system = read_unproved(&lexer::lex(text).tokens).system().expect("a system");
    assert_eq!(prove_by_normal_form(&system, &system.claims[2]), None);
    assert!(verdicts(text).iter().all(|verdict| matches!(verdict, Verdict::Proved(_))));
}
