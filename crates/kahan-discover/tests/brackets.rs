//! Tests fields with known invariant Poisson brackets, and with known constant K in f = K∇H.

use kahan_algebra::render::Text;
use kahan_discover::report::{ModifiedPlace, Report};

mod support;
use support::*;

fn texts(report: &Report) -> Vec<&str> {
    report.brackets.iter().map(|bracket| bracket.text.as_str()).collect()
}

fn ranks(report: &Report) -> Vec<usize> {
    report.brackets.iter().map(|bracket| bracket.rank).collect()
}

#[test]
fn brackets_come_from_a_density_and_integrals() {
    for (text, brackets) in
        [(E6, 2), (EULER, 2), (LOTKA_VOLTERRA, 1), (WEIERSTRASS, 1), (VOLTERRA, 2), (E7, 0)]
    {
        let report = report(text, &options());
        assert_eq!(report.brackets.len(), brackets, "{text}: {:?}", report.brackets);
        check_lines(text, &report);
    }
    let plane = report(LOTKA_VOLTERRA, &options());
    assert_eq!(texts(&plane), ["bracket P1 { {x, y} = x*y; };"]);
}

/// Sources: Kouloukas, Quispel and Vanhaecke, "Liouville integrability and superintegrability of a
/// generalized Lotka–Volterra system and its Kahan discretization" (2016); Petrera and Suris, "A
/// construction of a large family of commuting pairs of integrable symplectic birational
/// four-dimensional maps" (2017).
#[test]
fn brackets_of_full_rank_are_found() {
    let first = |text: &str| texts(&report(text, &options())).first().copied().unwrap_or_default().to_owned();
    let volterra = "x1dot = x1*(x2 + x3 + x4); x2dot = x2*(x3 + x4 - x1); x3dot = x3*(x4 - x1 - x2); \
        x4dot = x4*(-x1 - x2 - x3);";
    assert_eq!(
        first(volterra),
        "bracket P1 { {x1, x2} = x1*x2; {x1, x3} = x1*x3; {x1, x4} = x1*x4; {x2, x3} = x2*x3; \
        {x2, x4} = x2*x4; {x3, x4} = x3*x4; };"
    );
    let canonical = "xdot = p; ydot = q; pdot = -a*x - 2*x*y; qdot = -a*y - x^2 - y^2;";
    assert_eq!(
        texts(&report(canonical, &options())),
        [
            "bracket P1 { {x, p} = 2*eps^2*x; {x, q} = 1 + eps^2*(2*y + a); {y, p} = 1 + eps^2*(2*y + a); \
            {y, q} = 2*eps^2*x; };",
            "bracket P2 { {x, p} = 1 + eps^2*(2*y + a); {x, q} = 2*eps^2*x; {y, p} = 2*eps^2*x; \
            {y, q} = 1 + eps^2*(2*y + a); };"
        ]
    );
}

#[test]
fn a_bracket_of_highest_rank_has_a_density() {
    let volterra = "x1dot = x1*(x2 + x3 + x4 + x5 + x6); x2dot = x2*(x3 + x4 + x5 + x6 - x1); \
        x3dot = x3*(x4 + x5 + x6 - x1 - x2); x4dot = x4*(x5 + x6 - x1 - x2 - x3); \
        x5dot = x5*(x6 - x1 - x2 - x3 - x4); x6dot = x6*(-x1 - x2 - x3 - x4 - x5);";
    let found = report(volterra, &options());
    assert_eq!(found.densities[0].text, "density rho = 1/(x1*x2*x3*x4*x5*x6);");
    assert_eq!((&ranks(&found)[..3], found.polynomial_brackets), (&[6, 4, 2][..], 3));
    assert!(found.sentences.iter().any(|said| said.contains("Poisson brackets") && said.contains("6, 4, 2")));
    assert!(found.sentences.iter().all(|said| !said.contains("too long")));
}

/// Two planar systems, each without the variables of the other, have brackets of degrees 0 and 1.
#[test]
fn brackets_of_parts_are_added() {
    let parts = "qdot = p; pdot = -w^2*q - 3*k*q^2 + r; udot = v; vdot = -1000*u;";
    let found = report(parts, &options());
    assert_eq!(ranks(&found)[..found.polynomial_brackets], [4, 2]);
    assert_eq!(found.brackets[0].text, "bracket P1 { {q, p} = 1 + eps^2*(6*k*q + w^2); {u, v} = 1; };");
    assert_eq!(found.brackets[1].text, "bracket P2 { {u, v} = 1; };");
    assert_eq!(found.densities[0].text, "density rho = 1/(1 + eps^2*(6*k*q + w^2));");
}

#[test]
fn canonical_systems_with_symbols_have_both_brackets() {
    let newton = "xdot = y; udot = v; ydot = -3*a0*(x^2 + d*u^2) - 6*b0*d*u*x - 2*a1*x - 2*b1*d*u - a2; \
        vdot = -6*a0*u*x - 3*b0*(x^2 + d*u^2) - 2*a1*u - 2*b1*x - b2;";
    let found = report(newton, &options());
    assert_eq!((&ranks(&found)[..], found.polynomial_brackets), (&[4, 4][..], 2));
    assert_eq!(
        found.brackets[0].text,
        "bracket P1 { {x, y} = 2*eps^2*d*(b1 + 3*b0*x + 3*a0*u); \
        {x, v} = 1 + 2*eps^2*(a1 + 3*a0*x + 3*d*b0*u); \
        {u, y} = 1 + 2*eps^2*(a1 + 3*a0*x + 3*d*b0*u); \
        {u, v} = 2*eps^2*(b1 + 3*b0*x + 3*a0*u); };"
    );
    assert!(found.structure.hamiltonians.iter().all(|structure| structure.bracket_is_proved));
    assert!(
        found.sentences.iter().any(|said| said.contains("(I - eps^2 f'^2) K") && said.contains("K1 and K2"))
    );
}

/// Source: Evripidou, Kassotakis and Vanhaecke, "Integrable reductions of the dressing chain"
/// (2019).
#[test]
fn brackets_with_constants_are_short() {
    let reduced = "x1dot = x1*(x2 + x3) + b; x2dot = x2*(x3 - x1); x3dot = -x3*(x1 + x2) - b;";
    let found = report(reduced, &options());
    assert_eq!(
        texts(&found)[..2],
        [
            "bracket P1 { {x1, x2} = x2^2; {x1, x3} = -x2^2; {x2, x3} = x2^2; };",
            "bracket P2 { {x1, x2} = x1*x2; {x1, x3} = b + x1*x3; {x2, x3} = x2*x3; };"
        ]
    );
}

/// A complex Hamiltonian (Petrera and Suris 2017) has the real part H₁ and the imaginary part H₂.
/// Its field is K₁∇H₁ and also K₂∇H₂.
#[test]
fn each_constant_k_has_an_integral() {
    let weierstrass = "xdot = y; udot = v; ydot = 6*x^2 - 6*u^2 - a; vdot = 12*x*u - b;";
    let found = report(weierstrass, &options());
    let hamiltonians = found.integrals.iter().map(|formula| formula.text.as_str()).collect::<Vec<_>>();
    assert_eq!(hamiltonians.len(), 2, "{hamiltonians:?}");
    assert!(hamiltonians.iter().all(|text| text.len() < 500), "{hamiltonians:?}");
    assert!(found.bases.is_empty());
    assert_eq!(
        texts(&found),
        [
            "bracket P1 { {x, y} = 12*eps^2*u; {x, v} = 1 - 12*eps^2*x; {u, y} = 1 - 12*eps^2*x; \
            {u, v} = -12*eps^2*u; };",
            "bracket P2 { {x, y} = 1 - 12*eps^2*x; {x, v} = -12*eps^2*u; {u, y} = -12*eps^2*u; \
            {u, v} = -(1 - 12*eps^2*x); };"
        ]
    );
}

/// The field has a holomorphic cubic Hamiltonian in two complex variables, and formulas of
/// thousands of characters.
#[test]
fn each_constant_k_has_a_compact_form() {
    let generic = "xdot = x*y - u*v + y^2 - v^2 + x; udot = x*v + u*y + 2*y*v + u; \
        ydot = -(x^2 - u^2 + (y^2 - v^2)/2 + y + a); vdot = -(2*x*u + y*v + v + b);";
    let found = report(generic, &options());
    let structures = &found.structure.hamiltonians;
    assert_eq!(structures.len(), 2);
    for structure in structures {
        assert_ne!(structure.place, ModifiedPlace::Implied);
        assert!(structure.modified(&Text).len() < 400, "{}", structure.modified(&Text));
    }
    assert_ne!(structures[0].hamiltonian, structures[1].hamiltonian);
    assert_eq!((found.independent_integrals(), found.not_reached(), found.bases.len()), (2, 0, 0));
}
