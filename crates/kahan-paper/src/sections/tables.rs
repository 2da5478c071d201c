//! Claims of Tables 1 to 4 and of Theorems 1 and 2, for each row of E1 to E6. The rows of E7 to E9
//! have only claims about the flow, from section 6.
//!
//! In the texts, `{P12}` stands for the row's definition of `P12`, `{e}` for the name of the
//! system, and `{i}` for the number of the system.

use super::super::claim::Claim;
use super::super::id::Id;
use super::super::section::Section;
use super::structures::{Algebra, STRUCTURES, StructureRow};
use super::text::{ClaimText, read};

/// Claims about a flow, from Table 1 and Section 3, or for E7 to E9 from Section 6.
const FLOW_CLAIMS: &str = "
table1.{e}.P | {table}, P |
    {P12}; {P23}; {P31}; jacobi(P12, P23, P31) = 0;
    P12*d(H, y) - P31*d(H, z) = 0; P23*d(H, z) - P12*d(H, x) = 0; P31*d(H, x) - P23*d(H, y) = 0;
    P12*d(K, y) - P31*d(K, z) = -f1; P23*d(K, z) - P12*d(K, x) = -f2; P31*d(K, x) - P23*d(K, y) = -f3
table1.{e}.Q | {table}, Q |
    {Q12}; {Q23}; {Q31}; jacobi(Q12, Q23, Q31) = 0;
    Q12*d(K, y) - Q31*d(K, z) = 0; Q23*d(K, z) - Q12*d(K, x) = 0; Q31*d(K, x) - Q23*d(K, y) = 0;
    Q12*d(H, y) - Q31*d(H, z) = -c*f1; Q23*d(H, z) - Q12*d(H, x) = -c*f2;
    Q31*d(H, x) - Q23*d(H, y) = -c*f3
table1.{e}.H | {table}, H |
    {H}; dot(H) = 0;
    P12*d(H, y) - P31*d(H, z) = 0; P23*d(H, z) - P12*d(H, x) = 0; P31*d(H, x) - P23*d(H, y) = 0
table1.{e}.K | {table}, K |
    {K}; dot(K) = 0;
    Q12*d(K, y) - Q31*d(K, z) = 0; Q23*d(K, z) - Q12*d(K, x) = 0; Q31*d(K, x) - Q23*d(K, y) = 0
table1.{e}.c | {table}, c |
    {c}; divergence(c) = 0; Q12*d(H, y) - Q31*d(H, z) = -c*f1; Q23*d(H, z) - Q12*d(H, x) = -c*f2;
    Q31*d(H, x) - Q23*d(H, y) = -c*f3
section3.{e}.chain | {section}, Lenard-Magri chain |
    P12*d(K, y) - P31*d(K, z) = (Q12*d(H, y) - Q31*d(H, z))/c;
    P23*d(K, z) - P12*d(K, x) = (Q23*d(H, z) - Q12*d(H, x))/c;
    P31*d(K, x) - P23*d(K, y) = (Q31*d(H, x) - Q23*d(H, y))/c
section3.{e}.compatible | {section}, compatibility |
    jacobi(P12 + lambda*Q12/c, P23 + lambda*Q23/c, P31 + lambda*Q31/c) = 0
";

/// Claims about the Lie algebra of a tensor.
const ALGEBRA_CLAIMS: &str = "
section3.{e}.algebra_{t} | {table}, {t} is the algebra {algebra} |
    bracket({t}12, {t}23, {t}31, {e1}, {e2}) = {e1e2}; bracket({t}12, {t}23, {t}31, {e2}, {e3}) = {e2e3};
    bracket({t}12, {t}23, {t}31, {e3}, {e1}) = {e3e1}
";

/// Claims about a map, from Tables 2 to 4 and Theorems 1 and 2.
const MAP_CLAIMS: &str = "
table2.{e}.limit | Table 2, i = {i}, at eps = 0 | at(H_eps, eps, 0) = H; at(K_eps, eps, 0) = K
theorem1.{e}.flow | Theorem 1, the volume form of the flow, i = {i} | divergence(c/(H*K)) = 0
theorem1.{e}.map | Theorem 1, (form), the volume form of the map, i = {i} | detJ*next(c/(H*K)) = c/(H*K)
table3.{e}.P12 | Table 3, i = {i}, P12, from (p1) |
    {P12_eps}; -1/c*H*K/(H_eps*K_eps)*d(H_eps, z) = P12_eps
table3.{e}.P23 | Table 3, i = {i}, P23, from (p1) |
    {P23_eps}; -1/c*H*K/(H_eps*K_eps)*d(H_eps, x) = P23_eps
table3.{e}.P31 | Table 3, i = {i}, P31, from (p1) |
    {P31_eps}; -1/c*H*K/(H_eps*K_eps)*d(H_eps, y) = P31_eps
table4.{e}.Q12 | Table 4, i = {i}, Q12, from (q3) | {Q12_eps}; H*K/(H_eps*K_eps)*d(K_eps, z) = Q12_eps
table4.{e}.Q23 | Table 4, i = {i}, Q23, from (q3) | {Q23_eps}; H*K/(H_eps*K_eps)*d(K_eps, x) = Q23_eps
table4.{e}.Q31 | Table 4, i = {i}, Q31, from (q3) | {Q31_eps}; H*K/(H_eps*K_eps)*d(K_eps, y) = Q31_eps
table3.{e}.limit | Table 3, i = {i}, at eps = 0 |
    at(P12_eps, eps, 0) = P12; at(P23_eps, eps, 0) = P23; at(P31_eps, eps, 0) = P31
table4.{e}.limit | Table 4, i = {i}, at eps = 0 |
    at(Q12_eps, eps, 0) = Q12; at(Q23_eps, eps, 0) = Q23; at(Q31_eps, eps, 0) = Q31
theorem2.{e}.jacobi_P | Theorem 2, i = {i}, Jacobi identity of P(eps) | jacobi(P12_eps, P23_eps, P31_eps) = 0
theorem2.{e}.jacobi_Q | Theorem 2, i = {i}, Jacobi identity of Q(eps) and Q(eps)/c |
    jacobi(Q12_eps, Q23_eps, Q31_eps) = 0; jacobi(Q12_eps/c, Q23_eps/c, Q31_eps/c) = 0
theorem2.{e}.compatible | Theorem 2, i = {i}, compatibility |
    jacobi(P12_eps + lambda*Q12_eps/c, P23_eps + lambda*Q23_eps/c, P31_eps + lambda*Q31_eps/c) = 0
theorem2.{e}.casimirs | Theorem 2, i = {i}, Casimir functions |
    P12_eps*d(H_eps, y) - P31_eps*d(H_eps, z) = 0; P23_eps*d(H_eps, z) - P12_eps*d(H_eps, x) = 0;
    P31_eps*d(H_eps, x) - P23_eps*d(H_eps, y) = 0; Q12_eps*d(K_eps, y) - Q31_eps*d(K_eps, z) = 0;
    Q23_eps*d(K_eps, z) - Q12_eps*d(K_eps, x) = 0; Q31_eps*d(K_eps, x) - Q23_eps*d(K_eps, y) = 0
theorem2.{e}.involution | Theorem 2, i = {i}, H(eps) and K(eps) commute |
    bracket(P12_eps, P23_eps, P31_eps, H_eps, K_eps) = 0; bracket(Q12_eps, Q23_eps, Q31_eps, H_eps, K_eps) = 0
";

/// Claims for maps that preserve the bracket Q(ε)/c, but not Q(ε), because c is not constant.
const DENSITY_FACTOR_CLAIMS: &str = "
theorem2.{e}.factor | Theorem 2, i = {i}, Q(eps) without the factor 1/c is not invariant |
    Q12_eps*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
        + Q31_eps*(J(1,3)*J(2,1) - J(1,1)*J(2,3)) != next(Q12_eps);
    (Q12_eps*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
        + Q31_eps*(J(1,3)*J(2,1) - J(1,1)*J(2,3)))/c = next(Q12_eps/c)
";

/// Misprinted cells.
const MISPRINTS: &str = "
table1.e8.c
    misprint A2: c := exp(-y/x)/x; P12*d(K, y) - P31*d(K, z) = (Q12*d(H, y) - Q31*d(H, z))/c
    refuted: eps := 1; x := 1; y := 0; z := 0; P12*d(K, y) - P31*d(K, z) = 1; P23*d(K, z) - P12*d(K, x) = 1;
        P31*d(K, x) - P23*d(K, y) = 0; Q12*d(H, y) - Q31*d(H, z) = -1; Q23*d(H, z) - Q12*d(H, x) = -1; 1/c = -1
table4.e3.Q23
    misprint A1: Q23_eps := x*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2));
        Q31_eps := y*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2));
        Q12_eps/c*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps/c*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
        + Q31_eps/c*(J(1,3)*J(2,1) - J(1,1)*J(2,3)) = next(Q12_eps/c);
        H*K/(H_eps*K_eps)*d(K_eps, x) = Q23_eps
    refuted: eps := 1/2; x := 1; y := 2; z := 3; next(x) = -1/10; next(y) = -1/5; next(z) = 5/2;
        next(Q12_eps/c) = 1/40;
        Q12_eps/c*(J(1,1)*J(2,2) - J(1,2)*J(2,1)) + Q23_eps/c*(J(1,2)*J(2,3) - J(1,3)*J(2,2))
        + Q31_eps/c*(J(1,3)*J(2,1) - J(1,1)*J(2,3)) = 1/40;
        H*K/(H_eps*K_eps)*d(K_eps, x) = -5/9
table4.e3.Q31
    misprint A1: Q31_eps := y*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2)); H*K/(H_eps*K_eps)*d(K_eps, y) = Q31_eps
    refuted: eps := 1/2; x := 1; y := 2; z := 3; H*K/(H_eps*K_eps)*d(K_eps, y) = -10/9
";

pub(super) fn claims() -> Vec<Claim> {
    let misprints = ClaimText::all(MISPRINTS);
    let claims = STRUCTURES.iter().flat_map(row).map(|claim| {
        let misprint = misprints.iter().find(|misprint| claim.id == Id::of([&misprint.head]));
        misprint.map_or(claim.clone(), |misprint| misprint.annotate(claim))
    });
    claims.collect()
}

fn row(s: &StructureRow) -> Vec<Claim> {
    let index = &s.system[1..];
    let (section, table) = if s.has_map() {
        ("3", format!("Table 1, i = {index}"))
    } else {
        ("6", format!("Section 6, E{index}"))
    };
    let filled = |text: &str| {
        let text = text.replace("{e}", s.system).replace("{i}", index).replace("{table}", &table);
        let text = text.replace("{section}", &format!("Section {section}"));
        s.pairs().fold(text, |text, (name, value)| {
            text.replace(&format!("{{{name}}}"), &format!("{name} := {value}"))
        })
    };
    let claim = |id: &str, place: &str, statement: &str| {
        let section = match (id.split('.').next(), s.has_map()) {
            (Some("table1" | "section3"), true) => Section::FlowPairs,
            (Some("table1" | "section3"), false) => Section::Transcendental,
            (Some("table2" | "theorem1"), _) => Section::Maps,
            _ => Section::MapPairs,
        };
        Claim::new(section, [id], s.system, place, statement).given_definitions(s.definitions)
    };
    let mut text = filled(FLOW_CLAIMS);
    for (tensor, algebra) in ["P", "Q"].into_iter().zip(s.algebras) {
        text += &of_algebra(tensor, algebra, &filled(ALGEBRA_CLAIMS));
    }
    if s.has_map() {
        text += &filled(MAP_CLAIMS);
    }
    if ["e1", "e3"].contains(&s.system) {
        text += &filled(DENSITY_FACTOR_CLAIMS);
    }
    read(&text, claim)
}

fn of_algebra(tensor: &str, algebra: Algebra, text: &str) -> String {
    let (basis, brackets) = (algebra.basis, algebra.brackets);
    let values =
        [("t", tensor), ("algebra", algebra.name), ("e1", basis.0), ("e2", basis.1), ("e3", basis.2)];
    let brackets = ["e1e2", "e2e3", "e3e1"].into_iter().zip(brackets);
    let fill = |text: String, (name, value): (&str, &str)| text.replace(&format!("{{{name}}}"), value);
    values.into_iter().chain(brackets).fold(text.to_owned(), fill)
}
