//! Tests claims with conditions behind `when`.

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::check::Checked;
use kahan_algebra::prove::{Refutation, Verdict, prove_all, prove_by_normal_form};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{claim_text, condition_note, macro_block};
use kahan_algebra::system::System;
use kahan_algebra::{derive, lexer, read, read_unproved, seed};

/// The time derivative of x + y + z is (p + q + r) x y.
const SUM: &str = "xdot = p*x*y; ydot = q*x*y; zdot = r*x*y;";
/// The derivative of a b x + y − a z is (a b c + 1) x y.
const VOLTERRA: &str = "xdot = x*(c*y + z); ydot = y*(x + a*z); zdot = z*(b*x + y);";
/// Two oscillators with frequencies a1 a2 and a5 a6.
const OSCILLATORS: &str = "xdot = a1*a2*y; ydot = -a1*a2*x; udot = a5*a6*v; vdot = -a5*a6*u;";
/// The map multiplies x by (1 + ε p)/(1 − ε p), and y by (1 + ε q)/(1 − ε q).
const GROWTH: &str = "xdot = p*x; ydot = q*y;";

fn reading(text: &str) -> Checked {
    read(&lexer::lex(text).tokens)
}

fn sound(text: &str) -> System {
    let reading = reading(text);
    assert_eq!(reading.diagnostics(), [], "{text}");
    reading.system().expect("a system")
}

fn verdict(text: &str) -> Verdict {
    let tokens = lexer::lex(text).tokens;
    let verdicts = prove_all(&read_unproved(&tokens).system().expect("a system"), seed(&tokens));
    let [verdict] = &verdicts[..] else { panic!("one claim: {text}") };
    verdict.clone()
}

#[test]
fn both_provers_decide_claims_on_their_relations() {
    let cases: [(&str, &str, &[&str], &[&str]); 7] = [
        (
            SUM,
            "integral S = x + y + z",
            &[
                "r = -p - q",
                "p + q = -r",
                "0 = p + q + r",
                "r/q + p/q = -1",
                "(r + p)*q^-1 = -1",
                "r = -p - q, eps = 1",
                "eps = 1, r = -p - q",
                "r = -2*q, p = q",
                "p = q, r = -2*p",
            ],
            &["p = q, r = 2*p", "r = p - q", "r = -p - 2*q", "eps = 1"],
        ),
        // To solve p·q = r² for p, q ≠ 0 is assumed. Then r = 0 and p = 0.
        (SUM, "integral D = x + z", &["p*q = r^2, q*r = 0"], &[]),
        (
            VOLTERRA,
            "integral L = a*b*x + y - a*z",
            &["a*b*c = -1", "c = -1/(a*b)", "a*b*c = -1, a = b^2", "a = b^2, a*b*c = -1"],
            &["a*b*c = -2", "a*b*c = 1"],
        ),
        (
            OSCILLATORS,
            "integral G = x*u + y*v",
            &["a1*a2 = a5*a6", "a1*a2 = a5*a6, a1 = a5", "a1*a2 = a5*a6, a2*a5 = a2*a1"],
            &["a1*a2 = -a5*a6", "a1 = a5"],
        ),
        (OSCILLATORS, "integral G = x*u - y*v", &["a1*a2 = -a5*a6"], &[]),
        (
            GROWTH,
            "integral F = x^2*y",
            &[
                "2*p + q + eps^2*p^2*q = 0",
                "q = -2*p/(1 + eps^2*p^2)",
                "eps*p = 2, 5*q = -2*p",
                "eps*p = 2, eps*q = -4/5",
            ],
            &["q = -2*p/(1 - eps^2*p^2)", "q = -2*p", "eps*p = 2, 5*q = -4*p"],
        ),
        (GROWTH, "density R = 1", &["p = -q"], &["p = q", "eps^2*p*q = -1"]),
    ];
    for (field, claim, proved, refuted) in cases {
        let proved = proved.iter().map(|when| (when, true));
        for (when, holds) in proved.chain(refuted.iter().map(|when| (when, false))) {
            let text = format!("{field} {claim} when {when};");
            let system = read_unproved(&lexer::lex(&text).tokens).system().expect("a system");
            assert_eq!(matches!(verdict(&text), Verdict::Proved(_)), holds, "{text}");
            assert_eq!(prove_by_normal_form(&system, &system.claims[0]), Some(holds), "{text}");
            assert_eq!(reading(&text).diagnostics().is_empty(), holds, "{text}");
        }
    }
}

#[test]
fn no_sign_and_no_coefficient_can_be_changed() {
    for (field, claim, changes) in [
        (
            SUM,
            "integral S = x + y + z when r = -p - q;",
            &[
                ("+ y", "- y"),
                ("x +", "2*x +"),
                ("-p", "p"),
                ("- q", "- 2*q"),
                ("r =", "3*r ="),
                ("when r", "when r + 1"),
            ][..],
        ),
        (
            VOLTERRA,
            "integral L = a*b*x + y - a*z when a*b*c = -1;",
            &[
                ("+ y", "- y"),
                ("- a*z", "+ a*z"),
                ("a*b*x", "2*a*b*x"),
                ("= -1", "= 1"),
                ("a*b*c", "a*b^2*c"),
            ],
        ),
        (
            GROWTH,
            "integral F = x^2*y when 2*p + q + eps^2*p^2*q = 0;",
            &[
                ("x^2", "x"),
                ("2*p", "p"),
                ("+ q", "- q"),
                ("eps^2", "eps"),
                ("p^2*q", "2*p^2*q"),
                ("= 0", "= 1"),
            ],
        ),
    ] {
        assert!(matches!(verdict(&format!("{field} {claim}")), Verdict::Proved(_)), "{claim}");
        for (from, to) in changes {
            let changed = claim.replacen(from, to, 1);
            let verdict = verdict(&format!("{field} {changed}"));
            assert!(matches!(verdict, Verdict::Refuted(Refutation::At { .. })), "{changed}: {verdict:?}");
        }
    }
}

#[test]
fn tensors_are_decided_on_relations_too() {
    let bracket = "bracket P { {x,v} = 1; {y,u} = -1; }";
    assert!(matches!(verdict(&format!("{OSCILLATORS} {bracket} when a1*a2 = a5*a6;")), Verdict::Proved(_)));
    assert!(matches!(verdict(&format!("{OSCILLATORS} {bracket} when a1 = a5;")), Verdict::Refuted(_)));
}

#[test]
fn a_counterexample_satisfies_the_relations() {
    let text = format!("{SUM} integral S = x + y - z when r = -p - q, eps*p = q;");
    let Verdict::Refuted(Refutation::At { point, left, right, .. }) = verdict(&text) else {
        panic!("x + y - z changes")
    };
    let [_, _, _, p, q, r, eps] = &point[..] else { panic!("three states, three parameters, eps") };
    assert_eq!(*r, -&(p + q));
    assert_eq!(&(eps * p), q);
    assert!(!eps.is_zero());
    assert_ne!(left, right);
}

#[test]
fn the_degrees_of_solved_names_enter_the_error_bound() {
    // With p = q^64, the degree of the claim rises from about 10⁵ to more than the limit 2²⁰.
    let of = |when: &str| verdict(&format!("{SUM} integral S = ((x + y + z)^64)^64 when {when};"));
    assert!(matches!(of("r = -p - q"), Verdict::Proved(_)));
    assert_eq!(of("r = -p - q, p = q^64"), Verdict::TooLarge);
}

#[test]
fn relations_that_cannot_be_solved_are_explained_at_their_place() {
    for (when, at, message) in [
        ("p^2 = q^2 + 1", "p ^ 2 = q ^ 2 + 1", "no name enters this relation linearly"),
        ("eps^2 = 2", "eps ^ 2 = 2", "no name enters this relation linearly"),
        ("p = x", "x", "`x` is a state"),
        ("x = 1", "x", "`x` is a state"),
        ("p = pp", "pp", "`pp` is neither a parameter nor `eps`"),
        ("p = S", "S", "`S` is neither a parameter nor `eps`"),
        ("0 = 1", "0 = 1", "never holds"),
        ("p = p + 1", "p = p + 1", "never holds"),
        ("p = p", "p = p", "always holds"),
        ("p = q, p = q + 1", "p = q + 1", "contradicts those before it"),
        ("p = 1, p = 2", "p = 2", "contradicts those before it"),
        ("p*q = 1, p = 0", "p = 0", "contradicts those before it"),
        ("p = 1, p = 1", "p = 1", "follows from those before it"),
        ("p = q, r = q, p = r", "p = r", "follows from those before it"),
        ("p*q^2 = p", "p * q ^ 2 = p", "is a product, which holds where p = 0 and where -1 + q^2 = 0"),
        ("p*q = 0", "p * q = 0", "is a product, which holds where p = 0 and where q = 0"),
        ("p*q = p*r", "p * q = p * r", "is a product"),
        ("(q - 1)*(p - r) = 0", "( q - 1 ) * ( p - r ) = 0", "is a product"),
        ("(p - r)*(q - 1) = 0", "( p - r ) * ( q - 1 ) = 0", "is a product"),
        ("p*p = p*q", "p * p = p * q", "is a product"),
        ("eps = 0", "eps = 0", "at eps = 0 the map is the identity"),
        ("eps = p, p = 0", "p = 0", "at eps = 0 the map is the identity"),
        ("k = 0", "k = 0", "the field divides by zero"),
        ("p = k, p = 0", "p = 0", "the field divides by zero"),
        (
            "(p^2 - 1)/(p - 1) = 2",
            "( p ^ 2 - 1 ) / ( p - 1 ) = 2",
            "where this relation holds it divides by zero",
        ),
        ("p = 1/(q - q)", "( q - q )", "this divisor is zero"),
        ("p = q = r", "q =", "an `=` inside an expression"),
        ("", "when", "there is no relation behind `when`"),
        ("p", "p ;", "expected `=`"),
        ("p = (q + r + 1)^60, q = (p*r + 2)^60, r^60*q = p", "", "too large to be solved"),
    ] {
        let text = format!("xdot = p*x*y/k; ydot = q*x*y; zdot = r*x*y; integral T = 1 + S when {when};");
        let text =
            text.replace("1 + S", "q*x - p*y/k").replace("integral T", "integral S = z + x; integral T");
        let lexed = lexer::lex(&text);
        let read = read(&lexed.tokens);
        let diagnostics = read.diagnostics();
        let own = diagnostics.iter().find(|d| !d.message.contains("`S` does not hold"));
        let Some(own) = own else { panic!("{when}: nothing is reported") };
        assert!(own.message.contains(message), "{when}: {}", own.message);
        let tokens = lexed.tokens[own.span.first..=own.span.last].iter().map(|token| &*token.text);
        let found = tokens.collect::<Vec<_>>().join(" ");
        assert!(at.is_empty() || at.ends_with(' ') || found == at, "{when}: at `{found}`");
    }
}

#[test]
fn what_is_fixed_later_is_put_into_relations() {
    let text = format!("{OSCILLATORS} integral G = x*u + y*v when a1*a2 = a5*a6, eps = 1/2;");
    let system = sound(&text);
    let condition = |fixed: &[(usize, i64)]| {
        let values: Vec<(usize, Rational)> = fixed.iter().map(|&(k, v)| (k, Rational::from(v))).collect();
        let special = system.specialise(&values).expect("the field divides by nothing");
        special.claims.first().map(|claim| {
            sound(macro_block(&special).replace("kahan! {", "").trim_end_matches('}'));
            assert_eq!(prove_by_normal_form(&special, claim), Some(true), "{fixed:?}");
            claim_text(&special, claim).split_once(" when ").map(|(_, when)| when.to_owned())
        })
    };
    let some = |text: &str| Some(Some(text.to_owned()));
    assert_eq!(condition(&[]), some("a1*a2 = a5*a6, eps = 1/2;"));
    assert_eq!(condition(&[(0, 2), (1, 3)]), some("a1*a2 = a5*a6, eps = 1/2;"));
    assert_eq!(condition(&[(0, 2), (1, 3), (2, 4)]), some("a6 = 3/2, eps = 1/2;"));
    assert_eq!(condition(&[(0, 2), (1, 6), (2, 4), (3, 3)]), some("eps = 1/2;"));
    assert_eq!(condition(&[(0, 2), (1, 6), (2, 4), (3, 4)]), None);
    // With a2 = 0, the relation divides by zero, so the claim is dropped.
    assert_eq!(condition(&[(1, 0)]), None);
    assert_eq!(condition(&[(1, 0), (2, 0)]), None);
}

#[test]
fn a_relation_with_a_value_alone_is_a_value() {
    let text = |when: &str| {
        let system = sound(&format!("const half = 1/2; {SUM} integral S = q*x - p*y when {when};"));
        claim_text(&system, &system.claims[0])
    };
    assert_eq!(text("2*p = half, eps = 2"), "integral S = q*x - p*y when p = 1/4, eps = 2;");
    assert_eq!(text("p = q, q = half"), "integral S = q*x - p*y when p = 1/2, q = 1/2;");
    assert_eq!(text("r = -p-q"), "integral S = q*x - p*y when r = -p - q;");
    assert_eq!(text("p*(q + 1)=r/half"), "integral S = q*x - p*y when p*(q + 1) = r/half;");
}

#[test]
fn what_relations_were_divided_by_is_said() {
    let note = |when: &str| {
        let system = sound(&format!("{SUM} integral S = q*x - p*y when {when};"));
        condition_note(&system, &system.claims[0])
    };
    assert_eq!(note("r = -p - q, eps = 1"), "");
    assert_eq!(note("p*q = r^2"), "q != 0");
    assert_eq!(note("p*q = r^2, eps*p = 1/(r + 1)"), "q != 0, 1 + r != 0");
}

#[test]
fn a_conditional_claim_is_evaluated_where_it_holds() {
    let system = sound(&format!("{SUM} integral S = r*(x + y + z) when r = -p - q;"));
    assert_eq!(system.accessors(system.claims[0].kind).count(), 0);
    let derived = derive(&system);
    let [plan] = &derived.conditional[..] else { panic!("one claim") };
    let value = |variable| match system.field.symbols.name(variable).as_str() {
        "p" => Rational::new(1, 2),
        "q" => Rational::new(1, 3),
        "r" => Rational::from(7),
        _ => Rational::from(2),
    };
    assert_eq!(plan.evaluate(&Exact, |input| input.variable().map(value)), [Some(Rational::from(-5))]);
}

#[test]
fn values_are_put_into_what_was_written() {
    let put = |claim: &str, value: (i64, i64)| {
        let mut system =
            sound(&format!("const a = 3; xdot = y; ydot = -x; integral H = {claim}*(x^2 + y^2);"));
        system.claims[0].put_values(&[("a".to_owned(), Rational::new(value.0, value.1))]);
        let text = claim_text(&system, &system.claims[0]);
        text.strip_prefix("integral H = ")
            .and_then(|text| text.strip_suffix(';'))
            .expect("a claim")
            .to_owned()
    };
    for (claim, value, wanted) in [
        ("(1 - a)", (1, 2), "(1 - 1/2)*(x^2 + y^2)"),
        ("(1 - a)", (-1, 2), "(1 + 1/2)*(x^2 + y^2)"),
        ("6*a^2/5", (1, 2), "(3/10)*(x^2 + y^2)"),
        ("6*a", (-1, 2), "-(3*(x^2 + y^2))"),
        ("a", (1, 1), "(x^2 + y^2)"),
        ("1/a", (1, 3), "3*(x^2 + y^2)"),
        ("2*3", (1, 3), "2*3*(x^2 + y^2)"),
    ] {
        assert_eq!(put(claim, value), wanted, "{claim}");
    }
}
