//! Claims of section 1 on all quadratic and homogeneous fields, and of sections 2 and 4 on brackets
//! in three dimensions.

use super::super::claim::Claim;
use super::super::section::Section;
use super::text::read;

/// Definitions of the field's components Fᵢ, of their parts Qᵢ of degree 2, Bᵢ of degree 1 and Cᵢ
/// of degree 0, and of Kronecker's δᵢⱼ.
const COMPONENT_DEFINITIONS: &str = "
    F1(u, v, w) := at(f1, x, u, y, v, z, w); F2(u, v, w) := at(f2, x, u, y, v, z, w);
    F3(u, v, w) := at(f3, x, u, y, v, z, w);
    C1 := F1(0, 0, 0); C2 := F2(0, 0, 0); C3 := F3(0, 0, 0);
    B1(u, v, w) := (F1(u, v, w) - F1(-u, -v, -w))/2; B2(u, v, w) := (F2(u, v, w) - F2(-u, -v, -w))/2;
    B3(u, v, w) := (F3(u, v, w) - F3(-u, -v, -w))/2;
    Q1(u, v, w) := F1(u, v, w) - B1(u, v, w) - C1; Q2(u, v, w) := F2(u, v, w) - B2(u, v, w) - C2;
    Q3(u, v, w) := F3(u, v, w) - B3(u, v, w) - C3;
    X := next(x); Y := next(y); Z := next(z);
    delta11 := 1; delta12 := 0; delta13 := 0; delta21 := 0; delta22 := 1; delta23 := 0;
    delta31 := 0; delta32 := 0; delta33 := 1;
";

/// Identities for generic fields. The placeholder `{i}` stands for a row, `{x}` for its state,
/// `{X}` for this state at the next point, and `{j}` for a column.
const METHOD_CLAIMS: &str = "
scheme | definition of the map |
    ({X} - {x})/(2*eps) = (Q{i}(x + X, y + Y, z + Z) - Q{i}(x, y, z) - Q{i}(X, Y, Z))/2
        + B{i}(x + X, y + Y, z + Z)/2 + C{i}
matrix | A = I - eps f' |
    A({i},1) = delta{i}1 - eps*d(f{i}, x); A({i},2) = delta{i}2 - eps*d(f{i}, y);
    A({i},3) = delta{i}3 - eps*d(f{i}, z)
rhs | b = x + eps B x + 2 eps c | b({i}) = {x} + eps*B{i}(x, y, z) + 2*eps*C{i}
linear_system | A x~ = b | A({i},1)*X + A({i},2)*Y + A({i},3)*Z = b({i})
increment | increment form | A({i},1)*(X - x) + A({i},2)*(Y - y) + A({i},3)*(Z - z) = 2*eps*f{i}
midpoint | midpoint form, addition |
    ({X} - {x})/(2*eps) = 2*F{i}((x + X)/2, (y + Y)/2, (z + Z)/2) - F{i}(x, y, z)/2 - F{i}(X, Y, Z)/2
inverse | the inverse map has -eps | next(back({x})) = {x}; back({X}) = {x}
inverse_system | A(x~,-eps) x = b(x~,-eps) |
    on(at(A({i},1), eps, -eps), X, Y, Z)*x + on(at(A({i},2), eps, -eps), X, Y, Z)*y
        + on(at(A({i},3), eps, -eps), X, Y, Z)*z = on(at(b({i}), eps, -eps), X, Y, Z)
jacobian | A(x,eps) J = A(x~,-eps) |
    A({i},1)*J(1,{j}) + A({i},2)*J(2,{j}) + A({i},3)*J(3,{j}) = on(at(A({i},{j}), eps, -eps), X, Y, Z)
det_jacobian | det J | detA*detJ = on(at(detA, eps, -eps), X, Y, Z)
";

const HOMOGENEOUS: &str = "
homogeneous | homogeneous fields: A x~ = x | A({i},1)*X + A({i},2)*Y + A({i},3)*Z = {x}
reversed | (df56), homogeneous fields: x~ = A(x~,-eps) x |
    {X} = on(at(A({i},1), eps, -eps), X, Y, Z)*x + on(at(A({i},2), eps, -eps), X, Y, Z)*y
        + on(at(A({i},3), eps, -eps), X, Y, Z)*z
scaling | scaling, homogeneous fields |
    at({X}, x, lambda*x, y, lambda*y, z, lambda*z, eps, eps/lambda) = lambda*{X}
";

/// Claims about a bracket from an integral and a volume form.
const CONSTRUCTION_CLAIMS: &str = "
proposition |
    proposition (n = 3): an invariant I and an invariant volume (1/phi) dx dy dz give an invariant bracket;
    m is the Jacobian matrix, g the gradient of I at the next point, v that of I at this point |
    v1 := m11*g1 + m21*g2 + m31*g3; v2 := m12*g1 + m22*g2 + m32*g3; v3 := m13*g1 + m23*g2 + m33*g3;
    det := m11*(m22*m33 - m23*m32) - m12*(m21*m33 - m23*m31) + m13*(m21*m32 - m22*m31);
    phi*v3*(m11*m22 - m12*m21) + phi*v1*(m12*m23 - m13*m22) + phi*v2*(m13*m21 - m11*m23) = phi*det*g3;
    phi*v3*(m21*m32 - m22*m31) + phi*v1*(m22*m33 - m23*m32) + phi*v2*(m23*m31 - m21*m33) = phi*det*g1;
    phi*v3*(m31*m12 - m32*m11) + phi*v1*(m32*m13 - m33*m12) + phi*v2*(m33*m11 - m31*m13) = phi*det*g2
";

/// Claims about the Poisson tensors φ∇I and φ∇L, for generic polynomials φ, I, L of degree 2.
const BRACKETS: &str = "
bracket.jacobi | phi (I_z, I_x, I_y) is a Poisson tensor | jacobi(P12, P23, P31) = 0
bracket.casimir | its Casimir function is I |
    P12*d(I, y) - P31*d(I, z) = 0; P23*d(I, z) - P12*d(I, x) = 0; P31*d(I, x) - P23*d(I, y) = 0
bracket.compatible | brackets with one phi are compatible |
    jacobi(P12 + lambda*phi*d(L, z), P23 + lambda*phi*d(L, x), P31 + lambda*phi*d(L, y)) = 0
";

/// Repeats a statement for each row and column that its placeholders mention.
fn for_rows_and_columns(pattern: &str) -> String {
    let row = |i: usize| {
        let (x, next) = [("x", "X"), ("y", "Y"), ("z", "Z")][i];
        pattern.replace("{i}", &(i + 1).to_string()).replace("{x}", x).replace("{X}", next)
    };
    let rows = if row(0) == pattern { 1 } else { 3 };
    let columns = if pattern.contains("{j}") { 3 } else { 1 };
    let column = |j: usize| (0..rows).map(move |i| row(i).replace("{j}", &(j + 1).to_string()));
    (0..columns).flat_map(column).collect::<Vec<_>>().join("; ")
}

fn generic_function(name: &str) -> String {
    let monomials = ["1", "x", "y", "z", "x^2", "y^2", "z^2", "x*y", "y*z", "z*x"];
    let terms: Vec<String> =
        monomials.iter().enumerate().map(|(index, monomial)| format!("{name}{index}*{monomial}")).collect();
    terms.join(" + ")
}

pub(super) fn claims() -> Vec<Claim> {
    let of = |section: Section, number: &'static str, system: &'static str, given: &str| {
        let given = given.to_owned();
        move |id: &str, place: &str, statement: &str| {
            let place = format!("Section {number}, {place}");
            let id = [&format!("section{number}"), id];
            Claim::new(section, id, system, place, for_rows_and_columns(statement)).given_definitions(&given)
        }
    };
    let [phi, integral, other] = ["p", "i", "l"].map(generic_function);
    let functions = format!(
        "phi := {phi}; I := {integral}; L := {other}; \
         P12 := phi*d(I, z); P23 := phi*d(I, x); P31 := phi*d(I, y)"
    );
    [
        read(METHOD_CLAIMS, of(Section::Method, "1", "general", COMPONENT_DEFINITIONS)),
        read(HOMOGENEOUS, of(Section::Method, "1", "homogeneous", COMPONENT_DEFINITIONS)),
        read(CONSTRUCTION_CLAIMS, of(Section::Construction, "4", "general", "")),
        read(BRACKETS, of(Section::Brackets, "2", "general", &functions)),
    ]
    .concat()
}
