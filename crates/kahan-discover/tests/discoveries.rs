//! Tests the findings for known systems, and the sentences for fields with few structures.

use kahan_algebra::rational::Rational;
use kahan_algebra::render::Text;
use kahan_algebra::syntax::ClaimKind;
use kahan_discover::orbits::growth::Growth;
use kahan_discover::report::{Bound, ModifiedPlace};
use kahan_discover::{DiscoverError, Options, Unwatched, discover};

mod support;
use support::*;

#[test]
fn integrals_of_known_systems_are_found_at_their_degree_and_proved() {
    check(E1, &[1, 2], Some(4));
    check(E2, &[2, 2], Some(4));
    check(E3, &[1, 2], Some(4));
    for text in [E4, E5, E6, EULER] {
        check(text, &[2, 2], Some(4));
    }
    check(WEIERSTRASS, &[3], Some(1));
    check(VOLTERRA, &[1, 3], Some(2));
    check(HENON_HEILES, &[4], Some(2));
}

#[test]
fn fields_without_integrals_have_none_and_a_bound() {
    for (text, density) in
        [(E7, Some(4)), (E8, Some(4)), (E9, Some(4)), (LOTKA_VOLTERRA, Some(2)), (LORENZ, None)]
    {
        let report = check(text, &[], density);
        let bound = format!("none of degree ≤ {}", report.hilbert.as_ref().unwrap().degree());
        assert!(report.sentences.iter().any(|sentence| sentence.contains(&bound)), "{:?}", report.sentences);
    }
}

#[test]
fn what_is_fixed_stands_behind_when() {
    let with_eps = Options { eps: Some(Rational::one()), ..options() };
    let report = check_with(LOTKA_VOLTERRA, &with_eps, &[4], Some(2));
    assert!(report.integrals[0].text.ends_with(" when eps = 1;"));
    let with_xi = Options { parameters: vec![("xi".to_owned(), Rational::from(-1))], ..options() };
    let report = check_with(E9, &with_xi, &[2, 2], Some(4));
    assert!(report.integrals.iter().all(|formula| formula.text.ends_with(" when xi = -1;")));
}

#[test]
#[ignore = "some ten seconds unoptimised"]
fn the_lagrange_top_has_four_integrals() {
    let report = report(LAGRANGE, &options());
    assert_eq!((report.independent_integrals(), report.integrals.len()), (4, 4));
    check_lines(LAGRANGE, &report);
    assert!(report.integrals[2].denominator.is_one() && report.densities.len() == 1);
    let lengths: Vec<usize> = report.integrals.iter().map(|formula| formula.text.len()).collect();
    assert!(lengths.iter().sum::<usize>() <= 2500, "{lengths:?}");
}

/// Tests Nahm's system of octahedral monopoles (Hitchin, Manton and Murray 1995).
#[test]
fn integrals_and_densities_stand_in_factors() {
    let nahm = report("xdot = 2*x^2 - 12*y^2; ydot = -6*x*y - 4*y^2;", &options());
    assert!(nahm.integrals[0].text.starts_with("integral H1 = y*(2*x + 3*y)*(x - y)^2/("), "{nahm:?}");
    assert_eq!(nahm.densities[0].text, "density rho = 1/(y*(2*x + 3*y)*(x - y));");
    let e2 = report(E2, &options());
    assert_eq!(e2.integrals[0].text, "integral H1 = x*y/((1 + eps*x)*(1 - eps*x));");
}

/// Three integrals of Kirchhoff's case have formulas of some thousand terms.
#[test]
fn what_is_too_long_to_be_written_is_given_by_a_basis() {
    let kirchhoff =
        "m1dot = (a3 - a1)*m2*m3 + (b3 - b1)*p2*p3; m2dot = (a1 - a3)*m1*m3 + (b1 - b3)*p1*p3; m3dot = 0;
        p1dot = a3*p2*m3 - a1*p3*m2; p2dot = a1*p3*m1 - a3*p1*m3; p3dot = a1*(p1*m2 - p2*m1);";
    let values = [("a1", 1), ("a3", 2), ("b1", 3), ("b3", 5)];
    let parameters = values.map(|(name, value)| (name.to_owned(), Rational::from(value))).to_vec();
    let report = report(kirchhoff, &Options { parameters, ..options() });
    assert_eq!(report.independent_integrals(), 4);
    let in_bases: usize = report.bases.iter().map(|basis| basis.integrals.len()).sum();
    assert_eq!(report.integrals.len() + in_bases, 4, "{:?}", report.bases);
    assert!(report.bases.iter().all(|basis| basis.proof.is_some()));
    assert!(report.sentences.iter().any(|sentence| sentence.contains("Hirota-Kimura basis")));
}

#[test]
fn what_the_map_keeps_of_the_flow_stands_as_it_is() {
    let text = "qdot = k*p; pdot = -q; sdot = 2*t; tdot = -2*s;";
    let report = report(text, &options());
    let lines: Vec<&str> = report.integrals.iter().map(|formula| formula.text.as_str()).collect();
    assert_eq!(lines, ["integral H1 = s^2 + t^2;", "integral H2 = q^2 + k*p^2;"]);
    assert!(report.sentences.iter().any(|sentence| sentence.contains("which the map keeps as they stand")));
    check_lines(text, &report);
}

/// For ε → 0, each formula must become an integral of the flow, and its denominator must become 1.
#[test]
fn formulas_have_a_limit_at_small_steps() {
    let text = "q1dot = p1; q2dot = p2; p1dot = -q1^2 - q2^2 - w*q1; p2dot = -2*q1*q2 - w*q2;";
    let report = report(text, &options());
    assert_eq!(report.integrals.len(), 2);
    for formula in &report.integrals {
        let (_, below) = formula.text.rsplit_once('/').expect("a quotient");
        assert!(below.trim_start_matches('(').starts_with("1 + "), "{}", formula.text);
    }
}

/// The field has 24 integrals. A search over all their 2^24 subsets would take too long.
#[test]
fn many_integrals_are_no_burden() {
    let resting: String = (0..24).map(|i| format!("c{i}dot = 0; ")).collect();
    let text = format!("{resting} xdot = x^2 + c0*y; ydot = y^2 + x + c1; zdot = z*x + y;");
    let report = report(&text, &Options { degree: Some(1), ..options() });
    assert_eq!(report.integrals.len(), 24);
}

#[test]
fn linear_integrals_of_long_chains_come_first() {
    let n = 60;
    let equation = |i: usize| format!("x{i}dot = x{i}*(x{} - x{});", (i + 1) % n, (i + n - 1) % n);
    let chain: String = (0..n).map(equation).collect();
    let few = Options { iterates: 1, iterate_degree: 10, degree: Some(1), ..options() };
    let report = report(&chain, &few);
    let sum: Vec<String> = (0..n).map(|i| format!("x{i}")).collect();
    assert_eq!(report.integrals[0].text, format!("integral H1 = {};", sum.join(" + ")));
}

#[test]
fn the_lattice_of_four_sites_has_three_integrals() {
    let text = "xdot = x*(y - w); ydot = y*(z - x); zdot = z*(w - y); wdot = w*(x - z);";
    check(text, &[1, 2, 2], Some(4));
}

#[test]
fn hamiltonian_structure_is_found_with_its_tensor() {
    let mut structure = report(HENON_HEILES, &options()).structure;
    assert!(structure.is_even);
    assert_eq!(structure.divergence, "0");
    let hamiltonian = structure.hamiltonians.pop().expect("f = K grad H");
    assert!(hamiltonian.modified_is_proved);
    let expected = [["0", "0", "1", "0"], ["0", "0", "0", "1"], ["-1", "0", "0", "0"], ["0", "-1", "0", "0"]];
    assert_eq!(hamiltonian.tensor, expected);
    assert_eq!(hamiltonian.hamiltonian, "1/2*p^2 + 1/2*q^2 + x^2*y + 1/2*a*x^2 + 1/2*b*y^2 - 1/3*c*y^3");
    let structure = report(EULER, &options()).structure;
    assert!(structure.hamiltonians.is_empty() && !structure.is_even);
    assert_eq!(structure.quadratic_integrals.len(), 2);
}

#[test]
fn composition_keeps_what_does_not_depend_on_the_step() {
    for (text, kept, quotients) in
        [(E1, vec![true, false], 0), (E6, vec![false, false], 1), (WEIERSTRASS, vec![false], 0)]
    {
        let survivors = report(text, &options()).survivors.expect("there are integrals");
        assert_eq!(survivors.formulas, kept, "{text}");
        assert_eq!(survivors.quotients.len(), quotients, "{text}");
        assert_eq!(survivors.hilbert.integrals, usize::from(kept.contains(&true)) + quotients, "{text}");
    }
}

#[test]
fn fields_with_little_in_them_end_in_true_sentences() {
    // Each case has a field, the number of integrals, the growth, and an expected sentence.
    let cases = [
        ("xdot = 0; ydot = 0;", 2, "bounded", "identity"),
        ("xdot = 0;", 1, "bounded", "identity"),
        ("xdot = 1;", 0, "bounded", "preserves volume"),
        ("xdot = x^2 + 1;", 0, "bounded", "invariant density is proved"),
        ("xdot = y; ydot = -x;", 1, "bounded", "formula of one integral is proved"),
        ("xdot = x + y; ydot = -2*x + y;", 0, "bounded", "divergence of the field is 2"),
        ("xdot = x*y/2; ydot = a*x*y - a*y*x + x^2;", 1, "linear", "formula of one integral is proved"),
        (
            "xdot = x^2 + y*z + 1; ydot = x*y - z^2; zdot = y^2 + 3*x;",
            0,
            "exponential",
            "No algebraic integral",
        ),
    ];
    for (text, integrals, growth, sentence) in cases {
        let report = report(text, &options());
        assert_eq!(
            (report.independent_integrals(), report.integrals.len()),
            (integrals, integrals),
            "{text}"
        );
        assert_eq!(report.growth.growth.word(), growth, "{text}");
        let all = report.sentences.join(" ");
        assert!(all.contains(sentence), "{text}: {all}");
        check_lines(text, &report);
        assert!(report.densities.iter().all(|formula| formula.claim.kind == ClaimKind::Density));
    }
}

#[test]
fn the_modified_hamiltonian_of_a_map_too_long_to_write_is_written() {
    // The modified Hamiltonian is an integral of degree 7, which relations of orbits do not show.
    // Its numerator and its denominator have more than 500 terms.
    let chain = "adot = a*(b - c + d - e); bdot = b*(c - d + e - a); cdot = c*(d - e + a - b);
        ddot = d*(e - a + b - c); edot = e*(a - b + c - d);";
    let report = report(chain, &options());
    assert_eq!(report.hilbert.as_ref().unwrap().integrals, 1);
    assert_eq!(report.integrals.iter().map(|formula| formula.degree).collect::<Vec<_>>(), [1, 7]);
    check_lines(chain, &report);
}

#[test]
fn a_modified_hamiltonian_beyond_the_degree_looked_at_counts() {
    let chain = |last: &str| {
        format!(
            "adot = a*(b - c + d - e) + 3/7; bdot = b*(c - d + e - a) + 1/5; cdot = c*(d - e + a - b) + 2/3;
             ddot = d*(e - a + b - c) - 1/2; edot = e*(a - b + c - d) - {last};"
        )
    };
    let text = chain("167/210");
    let found = report(&text, &options());
    assert_eq!(found.hilbert.as_ref().map(|hilbert| hilbert.integrals), Some(1));
    assert_eq!((found.independent_integrals(), found.integrals.len(), found.not_reached()), (2, 2, 0));
    let hamiltonian = found.structure.hamiltonians.first().expect("f = K grad H");
    assert_eq!((hamiltonian.modified_is_proved, hamiltonian.place), (true, ModifiedPlace::InsteadOf(1)));
    let modified = hamiltonian.modified(&Text);
    assert!(modified.len() * 4 < found.integrals[1].text.len(), "{modified}");
    check_lines(&text, &found);
    let found = report(&chain("1"), &options());
    assert_eq!((found.independent_integrals(), found.structure.hamiltonians.is_empty()), (0, true));
}

#[test]
fn a_modified_hamiltonian_too_long_to_be_written_counts() {
    let names = ["a", "b", "c", "d", "e", "f", "g"];
    let equation = |i: usize| {
        let at = |k: usize| names[(i + k) % 7];
        let sum = format!("{} - {} + {} - {} + {} - {}", at(1), at(2), at(3), at(4), at(5), at(6));
        format!("{0}dot = {0}*({sum}) + {1};", names[i], [1, -2, 3, -4, 5, -6, 3][i])
    };
    let text: String = (0..7).map(equation).collect();
    let found = report(&text, &options());
    let hamiltonian = found.structure.hamiltonians.first().expect("f = K grad H");
    assert_eq!((hamiltonian.modified_is_proved, hamiltonian.place), (false, ModifiedPlace::Alone));
    assert_eq!((found.independent_integrals(), found.integrals.len(), found.not_reached()), (2, 1, 0));
}

/// Bogoyavlenskij and Itoh's chain of five sites shows one integral in the default degree 4, and
/// two in degree 5. A fixed point of the map bounds the number of integrals by three.
#[test]
fn degrees_go_on_until_nothing_can_be_missing() {
    let chain = "adot = a*(b + c - d - e); bdot = b*(c + d - e - a); cdot = c*(d + e - a - b);
        ddot = d*(e + a - b - c); edot = e*(a + b - c - d);";
    let found = searched(chain, &options());
    assert_eq!((found.independent_integrals(), found.not_reached(), found.bound), (3, 0, Bound::Ceiling));
    assert_eq!(
        (found.hilbert.as_ref().map(kahan_discover::orbits::hilbert::Hilbert::degree), found.out_of_time),
        (Some(5), false)
    );
    assert!(found.ceiling.as_ref().is_some_and(|ceiling| ceiling.integrals == 3));
    check_lines(chain, &found);
    let found = searched(chain, &Options { degree: Some(3), ..options() });
    assert_eq!(found.hilbert.as_ref().map(kahan_discover::orbits::hilbert::Hilbert::degree), Some(3));
    assert!(found.sentences.iter().any(|said| said.contains("degree that was given, 3, ended the search")));
}

/// The time limit is an hour, and the searches must end long before it.
#[test]
fn searches_end_where_nothing_can_be_missing() {
    let cases = [
        (LORENZ, 0, Bound::Ceiling),
        ("xdot = x^2 + y*z + 1; ydot = x*y - z^2; zdot = y^2 + 3*x;", 0, Bound::Ceiling),
        ("xdot = 2*x; ydot = -3*y; zdot = 5*z;", 0, Bound::Ceiling),
        ("xdot = x^2 - 1;", 0, Bound::Orbits),
        ("xdot = x; ydot = x + y;", 0, Bound::Drifts),
        ("xdot = -1; ydot = -3*y - 3; zdot = y;", 1, Bound::Drifts),
        (EULER, 2, Bound::Orbits),
        ("xdot = 0; ydot = 0;", 2, Bound::Orbits),
        (
            "m1dot = (w3 - w2)*p2*p3; m2dot = (w1 - w3)*p3*p1; m3dot = (w2 - w1)*p1*p2;
             p1dot = p2*m3 - p3*m2; p2dot = p3*m1 - p1*m3; p3dot = p1*m2 - p2*m1;",
            4,
            Bound::Ceiling,
        ),
    ];
    for (text, integrals, bound) in cases {
        let found = searched(text, &options());
        assert_eq!((found.independent_integrals(), found.not_reached()), (integrals, 0), "{text}");
        assert_eq!((found.bound, found.out_of_time), (bound, false), "{text}");
        let all = found.sentences.join(" ");
        assert!(all.contains("othing can be missing") || all.contains("the identity"), "{text}: {all}");
    }
}

#[test]
fn the_time_ends_a_search_where_something_may_be_missing() {
    let found = searched(E7, &Options { seconds: 1.0, ..options() });
    assert_eq!((found.independent_integrals(), found.bound, found.out_of_time), (0, Bound::Time, true));
    let usual = report(E7, &options());
    let [longer, shorter] = [&found, &usual].map(|report| &report.hilbert.as_ref().unwrap().values);
    assert!(longer.starts_with(shorter) || shorter.starts_with(longer));
    assert!(
        found
            .sentences
            .iter()
            .any(|said| said.contains("ime ended the search") || said.contains("time ran out"))
    );
}

#[test]
fn growth_ends_searches_in_the_plane() {
    let cases = [
        (LOTKA_VOLTERRA, Bound::Growth, "2^n, proved"),
        ("xdot = x^2 + 4*x*y; ydot = -4*x*y - y^2;", Bound::Growth, "exponentially, proved"),
        (
            "xdot = x^2; ydot = x*y - al*x*y - al*y^2;",
            Bound::Linear,
            "Linear growth is observed over 200 iterates",
        ),
    ];
    for (text, bound, said) in cases {
        let found = searched(text, &options());
        assert_eq!(
            (found.independent_integrals(), found.bound, found.out_of_time),
            (0, bound, false),
            "{text}"
        );
        let all = found.sentences.join(" ");
        assert!(all.contains(said) && all.contains("Diller and Favre 2001"), "{text}: {all}");
        assert_eq!(found.growth.proof.is_some(), bound == Bound::Growth, "{text}");
    }
    // Nahm's octahedral field has an integral of degree 4, beyond the degree of this search.
    let nahm = "xdot = 2*x^2 - 12*y^2; ydot = -6*x*y - 4*y^2;";
    let found = searched(nahm, &Options { degree: Some(3), iterates: 24, iterate_degree: 400, ..options() });
    assert_eq!((found.independent_integrals(), found.growth.proof), (0, None));
    let all = found.sentences.join(" ");
    assert!(all.contains("elliptic fibration") && all.contains("of a degree above 3."), "{all}");
    let found = searched(LOTKA_VOLTERRA, &Options { eps: Some(Rational::one()), ..options() });
    assert_eq!((found.growth.proof, found.bound), (None, Bound::Orbits));
    let periodic = "struct S { a } xdot = 1 + x^2/(4*(a + eps^2)); ydot = x*y + 1;";
    let at_zero = vec![("a".to_owned(), Rational::zero())];
    let found = searched(periodic, &Options { degree: Some(1), parameters: at_zero, ..options() });
    assert_eq!((found.growth.growth, found.bound), (Growth::Linear, Bound::Degree));
}

#[test]
fn a_density_that_the_field_brings_along_is_named() {
    let text = format!("{E6} density rho = 1/((x*z + y^2)*(x^2 + y^2 + z^2));");
    let report = report(&text, &options());
    assert!(report.densities[0].text.starts_with("density rho = "));
    assert!(report.sentences.iter().any(|sentence| sentence.contains("brings the density `rho` along")));
    check_lines(E6, &report);
}

#[test]
fn wrong_input_is_explained() {
    let with = |name: &str, value: i64| Options {
        parameters: vec![(name.to_owned(), Rational::from(value))],
        ..options()
    };
    let error = |text: &str, options: &Options| discover(&system(text), options, &Unwatched).unwrap_err();
    assert_eq!(error(E9, &with("zeta", 1)), DiscoverError::UnknownParameter("zeta".to_owned()));
    assert_eq!(error("xdot = y/a; ydot = x;", &with("a", 0)), DiscoverError::UndefinedField);
    let at_one = Options { eps: Some(Rational::one()), ..options() };
    assert_eq!(error("xdot = x;", &at_one), DiscoverError::NoMap);
    let at_half = Options { eps: Some(Rational::new(1, 2)), ..options() };
    assert_eq!(error("xdot = -2*x; ydot = -y;", &at_half), DiscoverError::Collapse);
    let at_zero = Options { eps: Some(Rational::zero()), ..options() };
    assert_eq!(error(E6, &at_zero), DiscoverError::ZeroStep);
}

#[test]
fn without_time_there_is_still_a_report() {
    let report = report(E6, &Options { seconds: 0.0, ..options() });
    assert!(report.out_of_time && report.integrals.is_empty());
    assert!(report.sentences.iter().any(|sentence| sentence.contains("time ran out")));
    let all = report.sentences.join(" ");
    for denial in ["No invariant density", "The flow has no", "ended at a pole", "No algebraic integral"] {
        assert!(!all.contains(denial), "{all}");
    }
}

/// Source: Evripidou, Kassotakis and Vanhaecke, "Morphisms and automorphisms of skew-symmetric
/// Lotka-Volterra systems" (2021).
#[test]
fn quotients_of_two_terms_are_integrals() {
    let found = report("xdot = x*(y + z); ydot = -x*y; zdot = -x*z;", &options());
    let texts: Vec<&str> = found.integrals.iter().map(|formula| formula.text.as_str()).collect();
    assert_eq!(texts, ["integral H1 = x + y + z;", "integral H2 = y/z;"]);
    assert!(found.bases.is_empty());
    let found = report("xdot = x^2; ydot = y^2; zdot = z^2;", &options());
    let texts: Vec<&str> = found.integrals.iter().map(|formula| formula.text.as_str()).collect();
    assert_eq!(texts, ["integral H1 = x*y/(x - y);", "integral H2 = x*z/(x - z);"]);
    assert_eq!(found.drifts.len(), 1);
}

/// Tests Kirchhoff's case of a rigid body in a fluid (Petrera, Pfadler, Suris 2011).
#[test]
fn densities_of_degree_six_are_found() {
    let kirchhoff = "m1dot = (a3 - a1)*m2*m3 + (b3 - b1)*p2*p3; m2dot = (a1 - a3)*m1*m3 + (b1 - b3)*p1*p3; \
        m3dot = 0; p1dot = a3*p2*m3 - a1*p3*m2; p2dot = a1*p3*m1 - a3*p1*m3; p3dot = a1*(p1*m2 - p2*m1);";
    let found = report(kirchhoff, &Options { degree: Some(2), ..options() });
    assert_eq!((found.densities.len(), found.densities[0].degree), (1, 6));
}

/// Tests Nambu's bracket of two quadratic polynomials with ten parameters.
#[test]
fn ten_parameters_have_formulas_of_one_line() {
    let nambu = "xdot = (b*x + c*y + e)*(g*y + h*z + l); ydot = -(a*x + b*y + d)*(g*y + h*z + l); \
        zdot = (a*x + b*y + d)*(f*y + g*z + k);";
    let found = check_with(nambu, &Options { degree: Some(2), ..options() }, &[2, 2], Some(4));
    assert_eq!(
        found.densities[0].text,
        "density rho = 1/((1 - eps^2*(b^2 - c*a)*(l + g*y + h*z)^2)*(1 - eps^2*(g^2 - h*f)*(d + a*x + b*y)^2));"
    );
    assert_eq!(
        found.integrals[0].text,
        "integral H1 = (2*b*e*d - c*d^2 - e^2*a + (b^2 - c*a)*(2*d*x + 2*e*y + a*x^2 + 2*b*x*y + c*y^2))/\
        (1 - eps^2*(b^2 - c*a)*(l + g*y + h*z)^2);"
    );
}

/// The field is a linear factor times the field of a quadratic Hamiltonian. It has an integral P/Q.
/// One sum P + cQ does not contain ε, and another such sum is a product of two linear polynomials.
#[test]
fn a_pencil_is_given_by_its_members_that_fall_apart() {
    let linear = "xdot = (p*x + q*y + r)*(b*x + 2*c*y + e); ydot = -(p*x + q*y + r)*(2*a*x + b*y + d);";
    let found = check(linear, &[2], Some(3));
    let poles = "1 - eps^2*(b^2 - 4*c*a)*(r + p*x + q*y)^2";
    assert_eq!(
        found.integrals[0].text,
        format!(
            "integral H1 = (b*e*d - c*d^2 - e^2*a + (b^2 - 4*c*a)*(d*x + e*y + a*x^2 + b*x*y + c*y^2))/({poles});"
        )
    );
    assert_eq!(found.densities[0].text, format!("density rho = 1/(({poles})*(r + p*x + q*y));"));
}

/// Tests Zander's field of three linear forms with the exponents 1, 1 and 2.
#[test]
fn six_symbols_have_an_integral_in_linear_factors() {
    let zander = "xdot = b1*(a2*x + b2*y)*(a3*x + b3*y) + b2*(a1*x + b1*y)*(a3*x + b3*y) \
        + 2*b3*(a1*x + b1*y)*(a2*x + b2*y); ydot = -(a1*(a2*x + b2*y)*(a3*x + b3*y) \
        + a2*(a1*x + b1*y)*(a3*x + b3*y) + 2*a3*(a1*x + b1*y)*(a2*x + b2*y));";
    let found = check(zander, &[4], Some(3));
    let text = &found.integrals[0].text;
    assert!(
        text.starts_with("integral H1 = (a2*x + b2*y)*(a3*x + b3*y)^2*(a1*x + b1*y)/((1 - eps^2*("),
        "{text}"
    );
    assert!(text.len() <= 300, "{text}");
}
