//! Tables 1 to 4 and Theorems 1 and 2, cell by cell.

use super::super::claim::Claim;
use super::super::erratum::Erratum;
use super::super::id::Id;
use super::super::section::Section;
use super::structures::{ENTRIES, STRUCTURES, Structure, triple};

/// P dF for the tensor with this name and suffix, as three formulas.
fn applied(tensor: &str, suffix: &str, function: &str) -> [String; 3] {
    let [p12, p23, p31] = ENTRIES.map(|index| format!("{tensor}{index}{suffix}"));
    [
        format!("{p12}*d({function}, y) - {p31}*d({function}, z)"),
        format!("{p23}*d({function}, z) - {p12}*d({function}, x)"),
        format!("{p31}*d({function}, x) - {p23}*d({function}, y)"),
    ]
}

/// `a = b` for each pair.
fn equations(left: &[String; 3], right: [&str; 3]) -> String {
    left.iter().zip(right).map(|(left, right)| format!("{left} = {right}")).collect::<Vec<_>>().join("; ")
}

/// The claims of Tables 1 to 4.
pub(super) fn claims() -> Vec<Claim> {
    let claims = STRUCTURES.iter().flat_map(|row| [table1(row), pair(row), map(row)].concat());
    claims.map(with_misprint).collect()
}

/// A cell that is printed wrongly.
struct Misprinted {
    claim: [&'static str; 3],
    erratum: Erratum,
    printed: &'static str,
    counterexample: &'static str,
}

const MISPRINTED: [Misprinted; 3] = [
    // Without its sign, c does not link the two forms of the field.
    Misprinted {
        claim: ["table1", "e8", "c"],
        erratum: Erratum::A(2),
        printed: "c := exp(-y/x)/x; P12*d(K, y) - P31*d(K, z) = (Q12*d(H, y) - Q31*d(H, z))/c",
        counterexample: "eps := 1; x := 1; y := 0; z := 0; P12*d(K, y) - P31*d(K, z) = 1; P23*d(K, z) - P12*d(K, x) = 1;
         P31*d(K, x) - P23*d(K, y) = 0; Q12*d(H, y) - Q31*d(H, z) = -1; Q23*d(H, z) - Q12*d(H, x) = -1; 1/c = -1",
    },
    // As printed the tensor is Poisson, but the map does not keep it.
    Misprinted {
        claim: ["table4", "e3", "Q23"],
        erratum: Erratum::A(1),
        printed: "Q23_eps := x*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2)); Q31_eps := y*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2));
         Q12_eps/c*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps/c*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
         + Q31_eps/c*(J(1,3)*J(2,1) - J(1,1)*J(2,3)) = next(Q12_eps/c);
         H*K/(H_eps*K_eps)*d(K_eps, x) = Q23_eps",
        counterexample: "eps := 1/2; x := 1; y := 2; z := 3; next(x) = -1/10; next(y) = -1/5; next(z) = 5/2; next(Q12_eps/c) = 1/40;
         Q12_eps/c*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps/c*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
         + Q31_eps/c*(J(1,3)*J(2,1) - J(1,1)*J(2,3)) = 1/40;
         H*K/(H_eps*K_eps)*d(K_eps, x) = -5/9",
    },
    Misprinted {
        claim: ["table4", "e3", "Q31"],
        erratum: Erratum::A(1),
        printed: "Q31_eps := y*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2)); H*K/(H_eps*K_eps)*d(K_eps, y) = Q31_eps",
        counterexample: "eps := 1/2; x := 1; y := 2; z := 3; H*K/(H_eps*K_eps)*d(K_eps, y) = -10/9",
    },
];

fn with_misprint(claim: Claim) -> Claim {
    match MISPRINTED.iter().find(|misprinted| claim.id == Id::of(misprinted.claim)) {
        Some(m) => claim.misprinted(m.erratum, m.printed, m.counterexample),
        None => claim,
    }
}

fn place(structure: &Structure) -> String {
    let index = &structure.system[1..];
    // Table 1 has the systems whose maps are in Tables 2 to 4.
    if structure.discrete.is_some() {
        format!("Table 1, i = {index}")
    } else {
        format!("Section 6, E{index}")
    }
}

/// Where the paper has the Lie-Poisson pair of a flow.
fn section(structure: &Structure) -> Section {
    if structure.discrete.is_some() { Section::FlowPairs } else { Section::Transcendental }
}

const ZERO: [&str; 3] = ["0"; 3];
const MINUS_FIELD: [&str; 3] = ["-f1", "-f2", "-f3"];
const MINUS_C_FIELD: [&str; 3] = ["-c*f1", "-c*f2", "-c*f3"];

/// The cells of Table 1 for one system.
fn table1(s: &Structure) -> Vec<Claim> {
    let cell = |name: &str, statement: String| {
        Claim::new(
            section(s),
            ["table1", s.system, name],
            s.system,
            format!("{}, {name}", place(s)),
            statement,
        )
        .given(&s.definitions())
        .within("x", (1, 5), (4, 5))
    };
    let jacobi = |t: &str| format!("jacobi({t}12, {t}23, {t}31) = 0");
    let c = cell(
        "c",
        format!("c := {}; divergence(c) = 0; {}", s.c, equations(&applied("Q", "", "H"), MINUS_C_FIELD)),
    );
    vec![
        cell(
            "P",
            format!(
                "{}{}; {}; {}",
                triple("P", "", &s.p),
                jacobi("P"),
                equations(&applied("P", "", "H"), ZERO),
                equations(&applied("P", "", "K"), MINUS_FIELD)
            ),
        ),
        cell(
            "Q",
            format!(
                "{}{}; {}; {}",
                triple("Q", "", &s.q),
                jacobi("Q"),
                equations(&applied("Q", "", "K"), ZERO),
                equations(&applied("Q", "", "H"), MINUS_C_FIELD)
            ),
        ),
        cell("H", format!("H := {}; dot(H) = 0; {}", s.h, equations(&applied("P", "", "H"), ZERO))),
        cell("K", format!("K := {}; dot(K) = 0; {}", s.k, equations(&applied("Q", "", "K"), ZERO))),
        c,
    ]
}

/// What section 3 says of the pair of one flow, and Lie algebras.
fn pair(s: &Structure) -> Vec<Claim> {
    let claim = |name: &str, place: String, statement: String| {
        Claim::new(section(s), ["section3", s.system, name], s.system, place, statement)
            .given(&s.definitions())
    };
    let in_section =
        |what: &str| format!("{}, {what}", if s.discrete.is_some() { "Section 3" } else { "Section 6" });
    let right = applied("Q", "", "H").map(|entry| format!("({entry})/c"));
    let chain: Vec<String> =
        applied("P", "", "K").iter().zip(&right).map(|(a, b)| format!("{a} = {b}")).collect();
    let mut claims = vec![
        claim("chain", in_section("Lenard-Magri chain"), chain.join("; ")),
        claim(
            "compatible",
            in_section("compatibility"),
            "jacobi(P12 + lambda*Q12/c, P23 + lambda*Q23/c, P31 + lambda*Q31/c) = 0".to_owned(),
        ),
    ];
    for (tensor, algebra) in ["P", "Q"].into_iter().zip(s.algebras) {
        let (e, f, g) = algebra.basis;
        let brackets = [(e, f), (f, g), (g, e)]
            .map(|(a, b)| format!("bracket({tensor}12, {tensor}23, {tensor}31, {a}, {b})"));
        let relations: Vec<String> =
            brackets.iter().zip(algebra.brackets).map(|(a, b)| format!("{a} = {b}")).collect();
        claims.push(claim(
            &format!("algebra_{tensor}"),
            format!("{}, {tensor} is the algebra {}", place(s), algebra.name),
            relations.join("; "),
        ));
    }
    claims
}

/// Tables 2 to 4 and Theorems 1 and 2 for one map.
fn map(s: &Structure) -> Vec<Claim> {
    let Some(map) = &s.discrete else { return Vec::new() };
    let index = &s.system[1..];
    let definitions = s.definitions();
    let claim = |section: Section, table: &str, name: &str, place: String, statement: String| {
        Claim::new(section, [table, s.system, name], s.system, place, statement).given(&definitions)
    };
    let mut claims = vec![
        claim(
            Section::Maps,
            "table2",
            "limit",
            format!("Table 2, i = {index}, at eps = 0"),
            "at(H_eps, eps, 0) = H; at(K_eps, eps, 0) = K".to_owned(),
        ),
        claim(
            Section::Maps,
            "theorem1",
            "flow",
            format!("Theorem 1, the volume form of the flow, i = {index}"),
            "divergence(c/(H*K)) = 0".to_owned(),
        ),
        claim(
            Section::Maps,
            "theorem1",
            "map",
            format!("Theorem 1, (form), the volume form of the map, i = {index}"),
            "detJ*next(c/(H*K)) = c/(H*K)".to_owned(),
        ),
    ];
    let directions = ["z", "x", "y"];
    for (cell, (entry, direction)) in map.p.iter().zip(ENTRIES.iter().zip(directions)) {
        claims.push(claim(
            Section::MapPairs,
            "table3",
            &format!("P{entry}"),
            format!("Table 3, i = {index}, P{entry}, from (p1)"),
            format!("P{entry}_eps := {cell}; -1/c*H*K/(H_eps*K_eps)*d(H_eps, {direction}) = P{entry}_eps"),
        ));
    }
    for (cell, (entry, direction)) in map.q.iter().zip(ENTRIES.iter().zip(directions)) {
        claims.push(claim(
            Section::MapPairs,
            "table4",
            &format!("Q{entry}"),
            format!("Table 4, i = {index}, Q{entry}, from (q3)"),
            format!("Q{entry}_eps := {cell}; H*K/(H_eps*K_eps)*d(K_eps, {direction}) = Q{entry}_eps"),
        ));
    }
    let limits = |t: &str| -> String {
        ENTRIES.map(|entry| format!("at({t}{entry}_eps, eps, 0) = {t}{entry}")).join("; ")
    };
    let sum = ENTRIES.map(|entry| format!("P{entry}_eps + lambda*Q{entry}_eps/c")).join(", ");
    let poisson = |t: &str| format!("{t}12_eps, {t}23_eps, {t}31_eps");
    let theorem2 = |name: &str, what: &str, statement: String| {
        claim(Section::MapPairs, "theorem2", name, format!("Theorem 2, i = {index}, {what}"), statement)
    };
    claims.extend([
        claim(Section::MapPairs, "table3", "limit", format!("Table 3, i = {index}, at eps = 0"), limits("P")),
        claim(Section::MapPairs, "table4", "limit", format!("Table 4, i = {index}, at eps = 0"), limits("Q")),
        theorem2("jacobi_P", "Jacobi identity of P(eps)", format!("jacobi({}) = 0", poisson("P"))),
        theorem2(
            "jacobi_Q",
            "Jacobi identity of Q(eps) and Q(eps)/c",
            format!("jacobi({}) = 0; jacobi(Q12_eps/c, Q23_eps/c, Q31_eps/c) = 0", poisson("Q")),
        ),
        theorem2("compatible", "compatibility", format!("jacobi({sum}) = 0")),
        theorem2(
            "casimirs",
            "Casimir functions",
            format!(
                "{}; {}",
                equations(&applied("P", "_eps", "H_eps"), ZERO),
                equations(&applied("Q", "_eps", "K_eps"), ZERO)
            ),
        ),
        theorem2(
            "involution",
            "H(eps) and K(eps) commute",
            format!(
                "bracket({}, H_eps, K_eps) = 0; bracket({}, H_eps, K_eps) = 0",
                poisson("P"),
                poisson("Q")
            ),
        ),
    ]);
    if ["e1", "e3"].contains(&s.system) {
        claims.push(theorem2("factor", "Q(eps) without the factor 1/c is not invariant", {
            "Q12_eps*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
             + Q31_eps*(J(1,3)*J(2,1) - J(1,1)*J(2,3)) != next(Q12_eps);
             (Q12_eps*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
             + Q31_eps*(J(1,3)*J(2,1) - J(1,1)*J(2,3)))/c = next(Q12_eps/c)"
                .to_owned()
        }));
    }
    claims
}
