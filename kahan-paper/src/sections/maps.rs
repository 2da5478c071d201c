//! Sections 2, 3 and 5: the fields, the matrices A(x,ε) with their determinants, the difference
//! equations, reductions of one system to another, and changes of variables.

use super::super::claim::Claim;
use super::super::erratum::Erratum::A;
use super::super::section::Section;

/// A field and its matrix A, row by row, with the sections of the paper that they are in.
struct Matrix {
    system: &'static str,
    section_of_field: Section,
    section_of_matrix: Section,
    field: [&'static str; 3],
    rows: [[&'static str; 3]; 3],
    determinant: &'static str,
    /// Where the paper has the determinant, if it has.
    place_of_determinant: Option<&'static str>,
}

const MATRICES: [Matrix; 10] = [
    Matrix {
        system: "euler",
        section_of_field: Section::Brackets,
        section_of_matrix: Section::Brackets,
        field: ["a1*y*z", "a2*z*x", "a3*x*y"],
        rows: [
            ["1", "-eps*a1*z", "-eps*a1*y"],
            ["-eps*a2*z", "1", "-eps*a2*x"],
            ["-eps*a3*y", "-eps*a3*x", "1"],
        ],
        determinant: "1 - eps^2*(a2*a3*x^2 + a3*a1*y^2 + a1*a2*z^2) - 2*eps^3*a1*a2*a3*x*y*z",
        place_of_determinant: None,
    },
    Matrix {
        system: "e1",
        section_of_field: Section::FlowPairs,
        section_of_matrix: Section::Maps,
        field: ["-x^2", "-x*y", "2*y^2 + x*z"],
        rows: [["1 + 2*eps*x", "0", "0"], ["eps*y", "1 + eps*x", "0"], ["-eps*z", "-4*eps*y", "1 - eps*x"]],
        determinant: "(1 + 2*eps*x)*(1 - eps^2*x^2)",
        place_of_determinant: None,
    },
    Matrix {
        system: "e2",
        section_of_field: Section::FlowPairs,
        section_of_matrix: Section::Maps,
        field: ["-x^2", "x*y", "-2*y^2 + x*z"],
        rows: [["1 + 2*eps*x", "0", "0"], ["-eps*y", "1 - eps*x", "0"], ["-eps*z", "4*eps*y", "1 - eps*x"]],
        determinant: "(1 + 2*eps*x)*(1 - eps*x)^2",
        place_of_determinant: None,
    },
    Matrix {
        system: "e3",
        section_of_field: Section::FlowPairs,
        section_of_matrix: Section::Maps,
        field: ["-x*z", "-y*z", "x^2 + y^2"],
        rows: [["1 + eps*z", "0", "eps*x"], ["0", "1 + eps*z", "eps*y"], ["-2*eps*x", "-2*eps*y", "1"]],
        determinant: "(1 + eps*z)*(1 + eps*z + 2*eps^2*(x^2 + y^2))",
        place_of_determinant: None,
    },
    Matrix {
        system: "e4",
        section_of_field: Section::FlowPairs,
        section_of_matrix: Section::Maps,
        field: ["-x*z", "y*z", "x^2 - y^2"],
        rows: [["1 + eps*z", "0", "eps*x"], ["0", "1 - eps*z", "-eps*y"], ["-2*eps*x", "2*eps*y", "1"]],
        determinant: "1 - eps^2*z^2 + 2*eps^2*x^2*(1 - eps*z) + 2*eps^2*y^2*(1 + eps*z)",
        place_of_determinant: None,
    },
    Matrix {
        system: "e5",
        section_of_field: Section::FlowPairs,
        section_of_matrix: Section::Maps,
        field: ["x*y", "-x^2", "y*(2*x - z)"],
        rows: [
            ["1 - eps*y", "-eps*x", "0"],
            ["2*eps*x", "1", "0"],
            ["-2*eps*y", "-eps*(2*x - z)", "1 + eps*y"],
        ],
        determinant: "(1 + eps*y)*(1 - eps*y + 2*eps^2*x^2)",
        place_of_determinant: Some("Theorem 1, proof, det A"),
    },
    Matrix {
        system: "e6",
        section_of_field: Section::FlowPairs,
        section_of_matrix: Section::Maps,
        field: ["y*(2*z - x)", "x^2 - z^2", "y*(z - 2*x)"],
        rows: [
            ["1 + eps*y", "eps*(x - 2*z)", "-2*eps*y"],
            ["-2*eps*x", "1", "2*eps*z"],
            ["2*eps*y", "eps*(2*x - z)", "1 - eps*y"],
        ],
        determinant: "1 + 3*eps^2*y^2 + 2*eps^2*(x^2 + z^2 - 4*x*z) + 6*eps^3*y*(x^2 - z^2)",
        place_of_determinant: None,
    },
    Matrix {
        system: "e7",
        section_of_field: Section::Transcendental,
        section_of_matrix: Section::Transcendental,
        field: ["-x^2", "-xi*x*y", "2*xi*y^2 + x*z"],
        rows: [
            ["1 + 2*eps*x", "0", "0"],
            ["xi*eps*y", "1 + xi*eps*x", "0"],
            ["-eps*z", "-4*xi*eps*y", "1 - eps*x"],
        ],
        determinant: "(1 + 2*eps*x)*(1 + xi*eps*x)*(1 - eps*x)",
        place_of_determinant: None,
    },
    Matrix {
        system: "e8",
        section_of_field: Section::Transcendental,
        section_of_matrix: Section::Transcendental,
        field: ["-x^2", "-x*(x + y)", "2*y*(x + y) + x*z"],
        rows: [
            ["1 + 2*eps*x", "0", "0"],
            ["eps*(2*x + y)", "1 + eps*x", "0"],
            ["-eps*(2*y + z)", "-2*eps*(x + 2*y)", "1 - eps*x"],
        ],
        determinant: "(1 + 2*eps*x)*(1 - eps^2*x^2)",
        place_of_determinant: None,
    },
    Matrix {
        system: "e9",
        section_of_field: Section::Transcendental,
        section_of_matrix: Section::Transcendental,
        field: ["-x*z", "-xi*y*z", "x^2 + xi*y^2"],
        rows: [
            ["1 + eps*z", "0", "eps*x"],
            ["0", "1 + xi*eps*z", "xi*eps*y"],
            ["-2*eps*x", "-2*xi*eps*y", "1"],
        ],
        determinant: "(1 + eps*z)*(1 + xi*eps*z) + 2*eps^2*x^2*(1 + xi*eps*z) + 2*xi^2*eps^2*y^2*(1 + eps*z)",
        place_of_determinant: None,
    },
];

/// x̃ − x, ỹ − y, z̃ − z, with X, Y, Z for the next point.
const DIFFERENCES: [(Section, &str, &str, [&str; 3]); 10] = [
    (
        Section::Brackets,
        "euler",
        "Section 2",
        ["eps*a1*(Y*z + y*Z)", "eps*a2*(Z*x + z*X)", "eps*a3*(X*y + x*Y)"],
    ),
    (
        Section::Maps,
        "e1",
        "Section 5, dE1",
        ["-2*eps*x*X", "-eps*(Y*x + y*X)", "eps*(X*z + x*Z) + 4*eps*y*Y"],
    ),
    (Section::Maps, "e2", "Section 5, dE2", ["-2*eps*x*X", "eps*(Y*x + y*X)", "eps*(X*z + x*Z) - 4*eps*y*Y"]),
    (
        Section::Maps,
        "e3",
        "Section 5, dE3",
        ["-eps*(x*Z + X*z)", "-eps*(y*Z + Y*z)", "2*eps*x*X + 2*eps*y*Y"],
    ),
    (Section::Maps, "e4", "Section 5, dE4", ["-eps*(x*Z + X*z)", "eps*(y*Z + Y*z)", "2*eps*x*X - 2*eps*y*Y"]),
    (
        Section::Maps,
        "e5",
        "Section 5, dE5",
        ["eps*(x*Y + X*y)", "-2*eps*x*X", "eps*(2*x*Y + 2*X*y - y*Z - Y*z)"],
    ),
    (
        Section::Maps,
        "e6",
        "Section 5, dE6",
        ["eps*(2*(y*Z + Y*z) - (x*Y + X*y))", "2*eps*(x*X - z*Z)", "eps*((y*Z + Y*z) - 2*(x*Y + X*y))"],
    ),
    (
        Section::Transcendental,
        "e7",
        "Section 6, (e1)-(e3)",
        ["-2*eps*x*X", "-eps*xi*(Y*x + y*X)", "eps*(X*z + x*Z) + 4*eps*xi*y*Y"],
    ),
    (
        Section::Transcendental,
        "e8",
        "Section 6, (e12)-(e32)",
        ["-2*eps*x*X", "-eps*(Y*x + y*X) - 2*eps*x*X", "eps*(X*z + x*Z) + 2*eps*(Y*x + y*X) + 4*eps*y*Y"],
    ),
    (
        Section::Transcendental,
        "e9",
        "Section 6, dE9",
        ["-eps*(x*Z + X*z)", "-eps*xi*(Y*z + y*Z)", "2*eps*x*X + 2*eps*xi*y*Y"],
    ),
];

/// The claims, in the order of the paper.
pub(super) fn claims() -> Vec<Claim> {
    [
        euler_top(),
        fields_and_matrices(),
        difference_equations(),
        reductions(),
        changes_of_variables(),
        poles(),
    ]
    .concat()
}

fn fields_and_matrices() -> Vec<Claim> {
    let mut claims = Vec::new();
    for matrix in &MATRICES {
        let &Matrix { system, section_of_field, section_of_matrix, .. } = matrix;
        let field: Vec<String> =
            matrix.field.iter().enumerate().map(|(i, value)| format!("f{} = {value}", i + 1)).collect();
        claims.push(Claim::new(
            section_of_field,
            ["field", system],
            system,
            format!("{}, the vector field", section_of_field.place()),
            field.join("; "),
        ));
        let mut entries = Vec::new();
        for (i, row) in matrix.rows.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                entries.push(format!("A({},{}) = {value}", i + 1, j + 1));
            }
        }
        claims.push(Claim::new(
            section_of_matrix,
            ["matrix", system],
            system,
            format!("{}, A(x, eps)", section_of_matrix.place()),
            entries.join("; "),
        ));
        let of_determinant = matrix
            .place_of_determinant
            .map_or_else(|| format!("{}, det A, addition", section_of_matrix.place()), str::to_owned);
        claims.push(Claim::new(
            section_of_matrix,
            ["determinant", system],
            system,
            of_determinant,
            format!("detA = {}", matrix.determinant),
        ));
    }
    claims
}

fn difference_equations() -> Vec<Claim> {
    let mut claims = Vec::new();
    for (section, system, place, increments) in DIFFERENCES {
        for (state, increment) in ["x", "y", "z"].iter().zip(increments) {
            claims.push(
                Claim::new(
                    section,
                    ["difference", system, state],
                    system,
                    format!("{place}, equation of {state}"),
                    format!("next({state}) - {state} = {increment}"),
                )
                .given("X := next(x); Y := next(y); Z := next(z)"),
            );
        }
    }
    claims
}

fn euler_top() -> Vec<Claim> {
    let claim = |id: &str, what: &str, statement: &str| {
        Claim::new(
            Section::Brackets,
            ["section2", "euler", id],
            "euler",
            format!("Section 2, {what}"),
            statement,
        )
        .spelling("H1 := a3*y^2 - a2*z^2; H2 := a1*z^2 - a3*x^2; H3 := a2*x^2 - a1*y^2")
    };
    vec![
        claim(
            "condition",
            "condition for an integral of the Euler top",
            "dot(gamma1*x^2 + gamma2*y^2 + gamma3*z^2) = 2*(gamma1*a1 + gamma2*a2 + gamma3*a3)*x*y*z",
        )
        .misprinted(
            A(5),
            "dot(gamma1*x^2 + gamma2*y^2 + gamma3*z^2) = 2*(gamma1*a1 + gamma2*a2 + gamma2*a2)*x*y*z",
            "a1 := 1; a2 := 1; a3 := 1; gamma1 := -2; gamma2 := 1; gamma3 := 0; x := 1; y := 1; z := 1; eps := 1;
             gamma1*a1 + gamma2*a2 + gamma2*a2 = 0; dot(gamma1*x^2 + gamma2*y^2 + gamma3*z^2) = -2",
        ),
        claim("H1", "integral H1", "H1 := a3*y^2 - a2*z^2; dot(H1) = 0"),
        claim("H2", "integral H2", "H2 := a1*z^2 - a3*x^2; dot(H2) = 0"),
        claim("H3", "integral H3", "H3 := a2*x^2 - a1*y^2; dot(H3) = 0"),
        claim("relation", "the integrals are dependent", "a1*H1 + a2*H2 + a3*H3 = 0"),
    ]
}

/// Systems with a parameter at special values of it.
fn reductions() -> Vec<Claim> {
    let mut claims = Vec::new();
    for (general, special, xi) in
        [("e7", "e1", "1"), ("e7", "e2", "-1"), ("e9", "e3", "1"), ("e9", "e4", "-1")]
    {
        let equations = ["x", "y", "z"]
            .map(|state| format!("at(next({general}, {state}), xi, {xi}) = next({special}, {state})"));
        let fields = ["1", "2", "3"].map(|i| format!("at(f({general}, {i}), xi, {xi}) = f({special}, {i})"));
        claims.push(Claim::new(
            Section::Transcendental,
            ["reduction", general, special],
            general,
            format!("Section 6, d{} at xi = {xi} is d{}", general.to_uppercase(), special.to_uppercase()),
            [fields.join("; "), equations.join("; ")].join("; "),
        ));
    }
    claims
}

/// Kahan's map commutes with linear changes of variables.
fn changes_of_variables() -> Vec<Claim> {
    let top = |system: &'static str, u: [&str; 3], a: [&str; 3]| {
        let (names, place) =
            (["x", "y", "z"], format!("Section 3, {} is an Euler top", system.to_uppercase()));
        let point =
            format!("x, {}, y, {}, z, {}, a1, {}, a2, {}, a3, {}", u[0], u[1], u[2], a[0], a[1], a[2]);
        let map =
            names.iter().zip(u).map(|(name, u)| format!("next({u}) = at(next(euler, {name}), {point})"));
        let flow: Vec<String> =
            (1..=3).zip(u).map(|(i, u)| format!("dot({u}) = at(f(euler, {i}), {point})")).collect();
        [
            Claim::new(
                Section::FlowPairs,
                ["change", system, "euler", "flow"],
                system,
                place.clone(),
                flow.join("; "),
            ),
            Claim::new(
                Section::FlowPairs,
                ["change", system, "euler", "map"],
                system,
                format!("{place}, the maps (addition)"),
                map.collect::<Vec<_>>().join("; "),
            ),
        ]
    };
    let mut claims = Vec::new();
    claims.extend(top("e4", ["x - y", "x + y", "z"], ["-1", "-1", "1"]));
    claims.extend(top("e6", ["x - z", "x + z", "y"], ["1", "-3", "1"]));
    claims.push(Claim::new(
        Section::Maps,
        ["change", "e4", "sign"],
        "e4",
        "Section 8, the symmetry (x, y, z) to (-x, -y, z) of dE4, addition",
        "on(next(x), -x, -y, z) = -next(x); on(next(y), -x, -y, z) = -next(y); on(next(z), -x, -y, z) = next(z)",
    ));
    claims.push(Claim::new(
        Section::Transcendental,
        ["change", "e9", "inverse", "flow"],
        "e9",
        "Section 6, E9 with x and y exchanged and time multiplied by xi is E9 at 1/xi, the flow, addition",
        "f1 = xi*at(f2, x, y, y, x, xi, 1/xi); f2 = xi*at(f1, x, y, y, x, xi, 1/xi); f3 = xi*at(f3, x, y, y, x, xi, 1/xi)",
    ));
    let swapped = "x, y, y, x, xi, 1/xi, eps, xi*eps";
    claims.push(Claim::new(
        Section::Transcendental,
        ["change", "e9", "inverse"],
        "e9",
        "Section 6, E9 with x and y exchanged and time multiplied by xi is E9 at 1/xi, addition",
        format!(
            "next(x) = at(next(y), {swapped}); next(y) = at(next(x), {swapped}); next(z) = at(next(z), {swapped})"
        ),
    ));
    claims
}

/// Removable poles: components and det A share a factor.
fn poles() -> Vec<Claim> {
    vec![
        Claim::new(
            Section::Maps,
            ["removable", "e1"],
            "e1",
            "Section 5, dE1 on the whole of 1 + eps x = 0, addition",
            "at(detA, x, -1/eps) = 0; on(next(x), -1/eps, y, z) = 1/eps; on(next(y), -1/eps, y, z) = -y;
             on(next(z), -1/eps, y, z) = z - 2*eps*y^2",
        ),
        Claim::new(
            Section::Maps,
            ["removable", "e3"],
            "e3",
            "Section 5, dE3 on the whole of 1 + eps z = 0, addition",
            "at(detA, z, -1/eps) = 0; on(next(x), x, y, -1/eps) = x/(eps^2*(x^2 + y^2));
             on(next(y), x, y, -1/eps) = y/(eps^2*(x^2 + y^2)); on(next(z), x, y, -1/eps) = 1/eps",
        ),
        Claim::new(
            Section::Maps,
            ["pole", "e1"],
            "e1",
            "Section 5, removable pole of dE1 on 1 + eps x = 0, addition",
            "at(detA, eps, 1/2, x, -2) = 0; at(on(next(x), -2, 1, 1/3), eps, 1/2) = 2;
             at(on(next(y), -2, 1, 1/3), eps, 1/2) = -1; at(on(next(z), -2, 1, 1/3), eps, 1/2) = -2/3;
             at(on(detJ, -2, 1, 1/3), eps, 1/2) = -1",
        ),
        Claim::new(
            Section::Maps,
            ["pole", "e3"],
            "e3",
            "Section 5, removable pole of dE3 on 1 + eps z = 0, addition",
            "at(detA, eps, 1/2, z, -2) = 0; at(on(next(x), 3/2, 1, -2), eps, 1/2) = 24/13;
             at(on(next(y), 3/2, 1, -2), eps, 1/2) = 16/13; at(on(next(z), 3/2, 1, -2), eps, 1/2) = 2;
             at(on(detJ, 3/2, 1, -2), eps, 1/2) = 4096/2197",
        ),
    ]
}
