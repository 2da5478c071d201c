//! Fields with coefficients that depend on ε, whose maps have an integral. If the coefficients are
//! replaced by their values at ε = 0, the maps have none.
//!
//! Let z = 1 + x + y. At ε = 0 the first field is 1/z times the Hamiltonian field of xyz². The
//! second field is 1/(yz²) times the Hamiltonian field of xy²z³. They are inhomogeneous reduced
//! Nahm systems of octahedral and icosahedral symmetry. The maps contract three lines, whose images
//! reach points of indeterminacy after 4, 4, 2 and 6, 3, 2 steps. Source of the method: Schmalian,
//! Suris and Tumarkin, "How one can repair non-integrable Kahan discretizations. II" (2021).

use kahan_algebra::rational::Rational;
use kahan_discover::{Options, Report, Unwatched, discover};

mod support;
use support::*;

const OF_DEGREE_4: [&str; 2] = [
    "xdot = x*(1 + x + 3*y); ydot = -y*(1 + 3*x + y);",
    "xdot = x*(1 + x + (3 + eps^2)/(1 + eps^2)*y); ydot = -y*(1 + (3 + eps^2)/(1 + eps^2)*x + y);",
];

const OF_DEGREE_6: [&str; 2] = [
    "xdot = x*(2 + 2*x + 5*y); ydot = -y*(1 + 4*x + y);",
    "xdot = x*(2*(1 + x)/(1 + eps^2) + (5 + 10*eps^2 + eps^4)/((1 + eps^2)*(1 + 3*eps^2))*y); \
     ydot = -y*(1 + 4*(1 + eps^2)/(1 + 3*eps^2)*x + y);",
];

fn found(text: &str, eps: Option<Rational>) -> Report {
    let options = Options { seconds: 3600.0, eps, ..Options::default() };
    let report = discover(&system(text), &options, &Unwatched).expect("there is a map");
    check_lines(text, &report);
    report
}

#[test]
fn the_fields_approximated_are_those_without_eps() {
    for [plain, repaired] in [OF_DEGREE_4, OF_DEGREE_6] {
        let limit = system(repaired).at_eps(&Rational::ZERO).expect("there is a field");
        assert_eq!(limit.field, system(plain).field);
    }
}

#[test]
fn without_the_repair_no_integral_exists() {
    for [plain, _] in [OF_DEGREE_4, OF_DEGREE_6] {
        let report = found(plain, None);
        assert_eq!(report.independent_integrals(), 0, "{plain}");
        assert!(report.growth.proof.is_some(), "{plain}");
    }
}

#[test]
fn the_repaired_map_of_degree_4_has_its_integral_found() {
    let report = found(OF_DEGREE_4[1], None);
    assert_eq!(report.independent_integrals(), 1);
    assert!(report.integrals[0].text.starts_with("integral H1 = x*y*(1 + x + y)^2/("));
    assert_eq!(report.densities[0].text, "density rho = 1/(x*y*(1 + x + y));");
    assert!(report.sentences[0].contains("quadratic"), "{:?}", report.sentences);
    assert_eq!(report.ceiling, None);
}

#[test]
fn the_repaired_map_of_degree_6_has_its_integral_found() {
    let report = found(OF_DEGREE_6[1], None);
    assert_eq!((report.independent_integrals(), report.integrals_in_bases()), (1, 0));
    assert!(
        report.integrals[0].text.starts_with("integral H1 = x*y^2*(1 + x + y)^3/("),
        "{:?}",
        report.integrals[0].text
    );
    assert_eq!(report.densities[0].text, "density rho = 1/(x*y*(1 + x + y));");
    assert!(report.sentences[0].contains("quadratic"), "{:?}", report.sentences);
    let report = found(OF_DEGREE_6[1], Some(Rational::new(1, 2)));
    assert_eq!(report.independent_integrals(), 1);
    let text = &report.integrals[0].text;
    assert!(
        text.starts_with("integral H1 = x*y^2*(1 + x + y)^3/(") && text.ends_with(" when eps = 1/2;"),
        "{text}"
    );
}

/// The field's eigenvalues λ₁ = 2/(1 + ε²) and λ₂ = 1 have different squares. Still, an integral
/// exists, because the map's eigenvalues μᵢ = (1 + ελᵢ)/(1 − ελᵢ) satisfy μ₁ = μ₂².
#[test]
fn eigenvalues_that_depend_on_eps_are_no_bound() {
    let report = found("xdot = 2*x/(1 + eps^2); ydot = y;", None);
    assert_eq!(report.integrals[0].text, "integral H1 = y^2/x;");
    assert_eq!(report.ceiling, None);
}

#[test]
fn hamiltonians_depend_on_eps() {
    let report = found("xdot = y; ydot = -x - c*eps^2*x^2 - a*x^2;", None);
    let [hamiltonian] = &report.structure.hamiltonians[..] else { panic!("{:?}", report.structure) };
    assert!(hamiltonian.hamiltonian.contains("eps^2"), "{}", hamiltonian.hamiltonian);
    assert!(hamiltonian.modified_is_proved);
}
