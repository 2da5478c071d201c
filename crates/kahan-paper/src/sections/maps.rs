//! Claims of sections 2, 3, 5, 6 and 8 about fields, maps, and relations between the systems.

use kahan_systems::registry::find;

use super::super::claim::Claim;
use super::super::section::Section;
use super::text::read;

const EULER_TOP: &str = "
section2.euler.condition | Section 2, condition for an integral of the Euler top |
    dot(gamma1*x^2 + gamma2*y^2 + gamma3*z^2) = 2*(gamma1*a1 + gamma2*a2 + gamma3*a3)*x*y*z
    misprint A5: dot(gamma1*x^2 + gamma2*y^2 + gamma3*z^2) = 2*(gamma1*a1 + gamma2*a2 + gamma2*a2)*x*y*z
    refuted: a1 := 1; a2 := 1; a3 := 1; gamma1 := -2; gamma2 := 1; gamma3 := 0; x := 1; y := 1; z := 1;
        eps := 1; gamma1*a1 + gamma2*a2 + gamma2*a2 = 0;
        dot(gamma1*x^2 + gamma2*y^2 + gamma3*z^2) = -2
section2.euler.H1 | Section 2, integral H1 | H1 := a3*y^2 - a2*z^2; dot(H1) = 0
section2.euler.H2 | Section 2, integral H2 | H2 := a1*z^2 - a3*x^2; dot(H2) = 0
section2.euler.H3 | Section 2, integral H3 | H3 := a2*x^2 - a1*y^2; dot(H3) = 0
section2.euler.relation | Section 2, the integrals are dependent |
    H1 := a3*y^2 - a2*z^2; H2 := a1*z^2 - a3*x^2; H3 := a2*x^2 - a1*y^2; a1*H1 + a2*H2 + a3*H3 = 0
";

/// The fields and their matrices A(x,ε).
const MATRICES: &str = "
field.euler | Section 2, the vector field | f1 = a1*y*z; f2 = a2*z*x; f3 = a3*x*y
matrix.euler | Section 2, A(x, eps) |
    A(1,1) = 1; A(1,2) = -eps*a1*z; A(1,3) = -eps*a1*y; A(2,1) = -eps*a2*z; A(2,2) = 1; A(2,3) = -eps*a2*x;
    A(3,1) = -eps*a3*y; A(3,2) = -eps*a3*x; A(3,3) = 1
determinant.euler | Section 2, det A, addition |
    detA = 1 - eps^2*(a2*a3*x^2 + a3*a1*y^2 + a1*a2*z^2) - 2*eps^3*a1*a2*a3*x*y*z
field.e1 | Section 3, the vector field | f1 = -x^2; f2 = -x*y; f3 = 2*y^2 + x*z
matrix.e1 | Section 5, A(x, eps) |
    A(1,1) = 1 + 2*eps*x; A(1,2) = 0; A(1,3) = 0; A(2,1) = eps*y; A(2,2) = 1 + eps*x; A(2,3) = 0;
    A(3,1) = -eps*z; A(3,2) = -4*eps*y; A(3,3) = 1 - eps*x
determinant.e1 | Section 5, det A, addition | detA = (1 + 2*eps*x)*(1 - eps^2*x^2)
field.e2 | Section 3, the vector field | f1 = -x^2; f2 = x*y; f3 = -2*y^2 + x*z
matrix.e2 | Section 5, A(x, eps) |
    A(1,1) = 1 + 2*eps*x; A(1,2) = 0; A(1,3) = 0; A(2,1) = -eps*y; A(2,2) = 1 - eps*x; A(2,3) = 0;
    A(3,1) = -eps*z; A(3,2) = 4*eps*y; A(3,3) = 1 - eps*x
determinant.e2 | Section 5, det A, addition | detA = (1 + 2*eps*x)*(1 - eps*x)^2
field.e3 | Section 3, the vector field | f1 = -x*z; f2 = -y*z; f3 = x^2 + y^2
matrix.e3 | Section 5, A(x, eps) |
    A(1,1) = 1 + eps*z; A(1,2) = 0; A(1,3) = eps*x; A(2,1) = 0; A(2,2) = 1 + eps*z; A(2,3) = eps*y;
    A(3,1) = -2*eps*x; A(3,2) = -2*eps*y; A(3,3) = 1
determinant.e3 | Section 5, det A, addition | detA = (1 + eps*z)*(1 + eps*z + 2*eps^2*(x^2 + y^2))
field.e4 | Section 3, the vector field | f1 = -x*z; f2 = y*z; f3 = x^2 - y^2
matrix.e4 | Section 5, A(x, eps) |
    A(1,1) = 1 + eps*z; A(1,2) = 0; A(1,3) = eps*x; A(2,1) = 0; A(2,2) = 1 - eps*z; A(2,3) = -eps*y;
    A(3,1) = -2*eps*x; A(3,2) = 2*eps*y; A(3,3) = 1
determinant.e4 | Section 5, det A, addition |
    detA = 1 - eps^2*z^2 + 2*eps^2*x^2*(1 - eps*z) + 2*eps^2*y^2*(1 + eps*z)
field.e5 | Section 3, the vector field | f1 = x*y; f2 = -x^2; f3 = y*(2*x - z)
matrix.e5 | Section 5, A(x, eps) |
    A(1,1) = 1 - eps*y; A(1,2) = -eps*x; A(1,3) = 0; A(2,1) = 2*eps*x; A(2,2) = 1; A(2,3) = 0;
    A(3,1) = -2*eps*y; A(3,2) = -eps*(2*x - z); A(3,3) = 1 + eps*y
determinant.e5 | Theorem 1, proof, det A | detA = (1 + eps*y)*(1 - eps*y + 2*eps^2*x^2)
field.e6 | Section 3, the vector field | f1 = y*(2*z - x); f2 = x^2 - z^2; f3 = y*(z - 2*x)
matrix.e6 | Section 5, A(x, eps) |
    A(1,1) = 1 + eps*y; A(1,2) = eps*(x - 2*z); A(1,3) = -2*eps*y; A(2,1) = -2*eps*x; A(2,2) = 1;
    A(2,3) = 2*eps*z; A(3,1) = 2*eps*y; A(3,2) = eps*(2*x - z); A(3,3) = 1 - eps*y
determinant.e6 | Section 5, det A, addition |
    detA = 1 + 3*eps^2*y^2 + 2*eps^2*(x^2 + z^2 - 4*x*z) + 6*eps^3*y*(x^2 - z^2)
field.e7 | Section 6, the vector field | f1 = -x^2; f2 = -xi*x*y; f3 = 2*xi*y^2 + x*z
matrix.e7 | Section 6, A(x, eps) |
    A(1,1) = 1 + 2*eps*x; A(1,2) = 0; A(1,3) = 0; A(2,1) = xi*eps*y; A(2,2) = 1 + xi*eps*x; A(2,3) = 0;
    A(3,1) = -eps*z; A(3,2) = -4*xi*eps*y; A(3,3) = 1 - eps*x
determinant.e7 | Section 6, det A, addition | detA = (1 + 2*eps*x)*(1 + xi*eps*x)*(1 - eps*x)
field.e8 | Section 6, the vector field | f1 = -x^2; f2 = -x*(x + y); f3 = 2*y*(x + y) + x*z
matrix.e8 | Section 6, A(x, eps) |
    A(1,1) = 1 + 2*eps*x; A(1,2) = 0; A(1,3) = 0; A(2,1) = eps*(2*x + y); A(2,2) = 1 + eps*x; A(2,3) = 0;
    A(3,1) = -eps*(2*y + z); A(3,2) = -2*eps*(x + 2*y); A(3,3) = 1 - eps*x
determinant.e8 | Section 6, det A, addition | detA = (1 + 2*eps*x)*(1 - eps^2*x^2)
field.e9 | Section 6, the vector field | f1 = -x*z; f2 = -xi*y*z; f3 = x^2 + xi*y^2
matrix.e9 | Section 6, A(x, eps) |
    A(1,1) = 1 + eps*z; A(1,2) = 0; A(1,3) = eps*x; A(2,1) = 0; A(2,2) = 1 + xi*eps*z; A(2,3) = xi*eps*y;
    A(3,1) = -2*eps*x; A(3,2) = -2*xi*eps*y; A(3,3) = 1
determinant.e9 | Section 6, det A, addition |
    detA = (1 + eps*z)*(1 + xi*eps*z) + 2*eps^2*x^2*(1 + xi*eps*z) + 2*xi^2*eps^2*y^2*(1 + eps*z)
";

/// The differences x̃ − x, ỹ − y and z̃ − z, in which X, Y and Z denote the next state.
const DIFFERENCES: &str = "
difference.euler.x | Section 2, equation of x | next(x) - x = eps*a1*(Y*z + y*Z)
difference.euler.y | Section 2, equation of y | next(y) - y = eps*a2*(Z*x + z*X)
difference.euler.z | Section 2, equation of z | next(z) - z = eps*a3*(X*y + x*Y)
difference.e1.x | Section 5, dE1, equation of x | next(x) - x = -2*eps*x*X
difference.e1.y | Section 5, dE1, equation of y | next(y) - y = -eps*(Y*x + y*X)
difference.e1.z | Section 5, dE1, equation of z | next(z) - z = eps*(X*z + x*Z) + 4*eps*y*Y
difference.e2.x | Section 5, dE2, equation of x | next(x) - x = -2*eps*x*X
difference.e2.y | Section 5, dE2, equation of y | next(y) - y = eps*(Y*x + y*X)
difference.e2.z | Section 5, dE2, equation of z | next(z) - z = eps*(X*z + x*Z) - 4*eps*y*Y
difference.e3.x | Section 5, dE3, equation of x | next(x) - x = -eps*(x*Z + X*z)
difference.e3.y | Section 5, dE3, equation of y | next(y) - y = -eps*(y*Z + Y*z)
difference.e3.z | Section 5, dE3, equation of z | next(z) - z = 2*eps*x*X + 2*eps*y*Y
difference.e4.x | Section 5, dE4, equation of x | next(x) - x = -eps*(x*Z + X*z)
difference.e4.y | Section 5, dE4, equation of y | next(y) - y = eps*(y*Z + Y*z)
difference.e4.z | Section 5, dE4, equation of z | next(z) - z = 2*eps*x*X - 2*eps*y*Y
difference.e5.x | Section 5, dE5, equation of x | next(x) - x = eps*(x*Y + X*y)
difference.e5.y | Section 5, dE5, equation of y | next(y) - y = -2*eps*x*X
difference.e5.z | Section 5, dE5, equation of z | next(z) - z = eps*(2*x*Y + 2*X*y - y*Z - Y*z)
difference.e6.x | Section 5, dE6, equation of x | next(x) - x = eps*(2*(y*Z + Y*z) - (x*Y + X*y))
difference.e6.y | Section 5, dE6, equation of y | next(y) - y = 2*eps*(x*X - z*Z)
difference.e6.z | Section 5, dE6, equation of z | next(z) - z = eps*((y*Z + Y*z) - 2*(x*Y + X*y))
difference.e7.x | Section 6, (e1)-(e3), equation of x | next(x) - x = -2*eps*x*X
difference.e7.y | Section 6, (e1)-(e3), equation of y | next(y) - y = -eps*xi*(Y*x + y*X)
difference.e7.z | Section 6, (e1)-(e3), equation of z | next(z) - z = eps*(X*z + x*Z) + 4*eps*xi*y*Y
difference.e8.x | Section 6, (e12)-(e32), equation of x | next(x) - x = -2*eps*x*X
difference.e8.y | Section 6, (e12)-(e32), equation of y | next(y) - y = -eps*(Y*x + y*X) - 2*eps*x*X
difference.e8.z | Section 6, (e12)-(e32), equation of z |
    next(z) - z = eps*(X*z + x*Z) + 2*eps*(Y*x + y*X) + 4*eps*y*Y
difference.e9.x | Section 6, dE9, equation of x | next(x) - x = -eps*(x*Z + X*z)
difference.e9.y | Section 6, dE9, equation of y | next(y) - y = -eps*xi*(Y*z + y*Z)
difference.e9.z | Section 6, dE9, equation of z | next(z) - z = 2*eps*x*X + 2*eps*xi*y*Y
";

/// Reductions of systems to other systems at special values of a parameter.
const REDUCTIONS: &str = "
reduction.e7.e1 | Section 6, dE7 at xi = 1 is dE1 |
    at(f(e7, 1), xi, 1) = f(e1, 1); at(f(e7, 2), xi, 1) = f(e1, 2); at(f(e7, 3), xi, 1) = f(e1, 3);
    at(next(e7, x), xi, 1) = next(e1, x); at(next(e7, y), xi, 1) = next(e1, y);
    at(next(e7, z), xi, 1) = next(e1, z)
reduction.e7.e2 | Section 6, dE7 at xi = -1 is dE2 |
    at(f(e7, 1), xi, -1) = f(e2, 1); at(f(e7, 2), xi, -1) = f(e2, 2); at(f(e7, 3), xi, -1) = f(e2, 3);
    at(next(e7, x), xi, -1) = next(e2, x); at(next(e7, y), xi, -1) = next(e2, y);
    at(next(e7, z), xi, -1) = next(e2, z)
reduction.e9.e3 | Section 6, dE9 at xi = 1 is dE3 |
    at(f(e9, 1), xi, 1) = f(e3, 1); at(f(e9, 2), xi, 1) = f(e3, 2); at(f(e9, 3), xi, 1) = f(e3, 3);
    at(next(e9, x), xi, 1) = next(e3, x); at(next(e9, y), xi, 1) = next(e3, y);
    at(next(e9, z), xi, 1) = next(e3, z)
reduction.e9.e4 | Section 6, dE9 at xi = -1 is dE4 |
    at(f(e9, 1), xi, -1) = f(e4, 1); at(f(e9, 2), xi, -1) = f(e4, 2); at(f(e9, 3), xi, -1) = f(e4, 3);
    at(next(e9, x), xi, -1) = next(e4, x); at(next(e9, y), xi, -1) = next(e4, y);
    at(next(e9, z), xi, -1) = next(e4, z)
";

/// Kahan's map commutes with linear changes of variables.
const LINEAR_CHANGES: &str = "
change.e4.euler.flow | Section 3, E4 is an Euler top |
    dot(x - y) = at(f(euler, 1), x, x - y, y, x + y, z, z, a1, -1, a2, -1, a3, 1);
    dot(x + y) = at(f(euler, 2), x, x - y, y, x + y, z, z, a1, -1, a2, -1, a3, 1);
    dot(z) = at(f(euler, 3), x, x - y, y, x + y, z, z, a1, -1, a2, -1, a3, 1)
change.e4.euler.map | Section 3, E4 is an Euler top, the maps (addition) |
    next(x - y) = at(next(euler, x), x, x - y, y, x + y, z, z, a1, -1, a2, -1, a3, 1);
    next(x + y) = at(next(euler, y), x, x - y, y, x + y, z, z, a1, -1, a2, -1, a3, 1);
    next(z) = at(next(euler, z), x, x - y, y, x + y, z, z, a1, -1, a2, -1, a3, 1)
change.e6.euler.flow | Section 3, E6 is an Euler top |
    dot(x - z) = at(f(euler, 1), x, x - z, y, x + z, z, y, a1, 1, a2, -3, a3, 1);
    dot(x + z) = at(f(euler, 2), x, x - z, y, x + z, z, y, a1, 1, a2, -3, a3, 1);
    dot(y) = at(f(euler, 3), x, x - z, y, x + z, z, y, a1, 1, a2, -3, a3, 1)
change.e6.euler.map | Section 3, E6 is an Euler top, the maps (addition) |
    next(x - z) = at(next(euler, x), x, x - z, y, x + z, z, y, a1, 1, a2, -3, a3, 1);
    next(x + z) = at(next(euler, y), x, x - z, y, x + z, z, y, a1, 1, a2, -3, a3, 1);
    next(y) = at(next(euler, z), x, x - z, y, x + z, z, y, a1, 1, a2, -3, a3, 1)
change.e4.sign | Section 8, the symmetry (x, y, z) to (-x, -y, z) of dE4, addition |
    on(next(x), -x, -y, z) = -next(x); on(next(y), -x, -y, z) = -next(y); on(next(z), -x, -y, z) = next(z)
change.e9.inverse.flow |
    Section 6, E9 with x and y exchanged and time multiplied by xi is E9 at 1/xi, the flow, addition |
    f1 = xi*at(f2, x, y, y, x, xi, 1/xi); f2 = xi*at(f1, x, y, y, x, xi, 1/xi);
    f3 = xi*at(f3, x, y, y, x, xi, 1/xi)
change.e9.inverse | Section 6, E9 with x and y exchanged and time multiplied by xi is E9 at 1/xi, addition |
    next(x) = at(next(y), x, y, y, x, xi, 1/xi, eps, xi*eps);
    next(y) = at(next(x), x, y, y, x, xi, 1/xi, eps, xi*eps);
    next(z) = at(next(z), x, y, y, x, xi, 1/xi, eps, xi*eps)
";

/// Removable poles: det A and the numerators of the map have a common factor.
const REMOVABLE_POLES: &str = "
removable.e1 | Section 5, dE1 on the whole of 1 + eps x = 0, addition |
    at(detA, x, -1/eps) = 0; on(next(x), -1/eps, y, z) = 1/eps; on(next(y), -1/eps, y, z) = -y;
    on(next(z), -1/eps, y, z) = z - 2*eps*y^2
removable.e3 | Section 5, dE3 on the whole of 1 + eps z = 0, addition |
    at(detA, z, -1/eps) = 0; on(next(x), x, y, -1/eps) = x/(eps^2*(x^2 + y^2));
    on(next(y), x, y, -1/eps) = y/(eps^2*(x^2 + y^2)); on(next(z), x, y, -1/eps) = 1/eps
pole.e1 | Section 5, removable pole of dE1 on 1 + eps x = 0, addition |
    at(detA, eps, 1/2, x, -2) = 0; at(on(next(x), -2, 1, 1/3), eps, 1/2) = 2;
    at(on(next(y), -2, 1, 1/3), eps, 1/2) = -1; at(on(next(z), -2, 1, 1/3), eps, 1/2) = -2/3;
    at(on(detJ, -2, 1, 1/3), eps, 1/2) = -1
pole.e3 | Section 5, removable pole of dE3 on 1 + eps z = 0, addition |
    at(detA, eps, 1/2, z, -2) = 0; at(on(next(x), 3/2, 1, -2), eps, 1/2) = 24/13;
    at(on(next(y), 3/2, 1, -2), eps, 1/2) = 16/13; at(on(next(z), 3/2, 1, -2), eps, 1/2) = 2;
    at(on(detJ, 3/2, 1, -2), eps, 1/2) = 4096/2197
";

pub(super) fn claims() -> Vec<Claim> {
    let texts = [EULER_TOP, MATRICES, DIFFERENCES, REDUCTIONS, LINEAR_CHANGES, REMOVABLE_POLES];
    texts.iter().flat_map(|text| read(text, claim)).collect()
}

fn claim(id: &str, place: &str, statement: &str) -> Claim {
    let system = id.split('.').find_map(find).expect("a system in the name").command;
    let section = match place.split(',').next() {
        Some("Section 2") => Section::Brackets,
        Some("Section 3") => Section::FlowPairs,
        Some("Section 6") => Section::Transcendental,
        _ => Section::Maps,
    };
    Claim::new(section, [id], system, place, statement)
        .given_definitions("X := next(x); Y := next(y); Z := next(z)")
}
