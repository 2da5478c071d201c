//! Claims about E9: the time as an integral over x, closed forms of orbits, and the fixed points of
//! flow and map.

use super::super::super::claim::Claim;
use super::super::super::section::Section;
use super::super::text::read;

const INTEGRALS: &str = "H := 1/2*(x^2 + y^2 + z^2); K := y*x^(-xi)";

/// The orbits of E9 on the intersection of a sphere and a cylinder, and the time along them.
const QUADRATURE: &str = "
quadrature.y | y on the orbit; H and K mean K_9 and H_9 | y = K*x^xi
    misprint A8: H := y*x^(-xi); K := 1/2*(x^2 + y^2 + z^2); y = K*x^xi
    refuted: xi := 1; x := 1; y := 2; z := 0; y*x^(-xi) = 2; 1/2*(x^2 + y^2 + z^2) = 5/2
quadrature.z | z on the orbit | z^2 = 2*H - x^2 - K^2*x^(2*xi)
quadrature.t | the time along the orbit | f1^2 = x^2*(2*H - x^2 - K^2*x^(2*xi))
quadrature.xi_1 | xi = 1: elementary | u := x^2; xi := 1; (d(u, x)*f1)^2 = 4*u^2*(2*H - (1 + K^2)*u)
quadrature.xi_2 | xi = 2: elementary | u := x^2; xi := 2; (d(u, x)*f1)^2 = 4*u^2*(2*H - u - K^2*u^2)
quadrature.xi_minus_1 | xi = -1: elliptic | u := x^2; xi := -1; (d(u, x)*f1)^2 = 4*u*(2*H*u - u^2 - K^2)
quadrature.xi_minus_2 | xi = -2: elliptic | u := x^2; xi := -2; (d(u, x)*f1)^2 = 4*(2*H*u^2 - u^3 - K^2)
quadrature.xi_half | xi = 1/2: elementary, x = s^2 |
    x := s^2; K := y/s; H := (x^2 + y^2 + z^2)/2; xi := 1/2; f1^2 = x^2*(2*H - x^2 - K^2*x)
quadrature.xi_minus_half | xi = -1/2: elliptic, x = s^2 |
    x := s^2; K := y*s; H := (x^2 + y^2 + z^2)/2; xi := -1/2; f1^2 = x*(2*H*x - x^3 - K^2)
quadrature.xi_three_halves | xi = 3/2: elliptic, of the third kind, x = s^2 |
    x := s^2; K := y/s^3; H := (x^2 + y^2 + z^2)/2; xi := 3/2; f1^2 = x^2*(2*H - x^2 - K^2*x^3)
";

const ANTIDERIVATIVE: &str = "R := 2*H - s^2 - K^2*s^4; root := sqrt(2*H)";
const ELEMENTARY: &str = "
quadrature.elementary | xi = 2: the integral is elementary, by u = s^2 |
    L := -log((2*root*sqrt(R) + 2*root^2 - s^2)/s^2)/(2*root); d(L, s) = 1/(s*sqrt(R))
    within H: 2, 3
    misprint A9: L := -log((2*root*sqrt(R) + 2*root^2 - s^2)/s^2)/(2*root); d(L, s) != 1/(s*sqrt(R))
fixed_points | the fixed points of the flow and of the map |
    on(f1, 0, 0, z) = 0; on(f2, 0, 0, z) = 0; on(f3, 0, 0, z) = 0;
    on(next(x), 0, 0, z) = 0; on(next(y), 0, 0, z) = 0; on(next(z), 0, 0, z) = z
fixed_points.slopes | the slopes at the fixed points: of one sign for xi > 0, of two for xi < 0 |
    on(d(f1, x), 0, 0, z) = -z; on(d(f2, y), 0, 0, z) = -xi*z; on(d(f3, z), 0, 0, z) = 0
";

/// Defines w = 1/x² on an orbit for ξ = 2 as a function of the time t, with constants k, b and K.
const W_DEFINITION: &str = "w := 2/k^2 + b*(exp(k*t) + exp(-k*t)); K := sqrt(k^2*b^2 - 1/k^2)";
const ORBIT: &str = "x := 1/sqrt(w); y := K/w; z := d(w, t)/(2*w)";
/// Defines u = 1/y² on an orbit for ξ = 1/2 as a function of the time t, with constants k and b.
const U_DEFINITION: &str = "u := 2/k^2 + b*(exp(k*t/2) + exp(-k*t/2))";

/// The orbits of E9 in closed form for ξ = 2, 1/2 and 0.
const CLOSED_CASES: &str = "
xi_2.w | xi = 2: w = 1/x^2, addition |
    w := 2/k^2 + b*(exp(k*t) + exp(-k*t)); w*d(d(w, t), t) - d(w, t)^2 = 2*w + 4*(k^2*b^2 - 1/k^2)
xi_2.solution | xi = 2: the solution, addition |
    xi := 2; x := 1/sqrt(w); y := K/w; z := d(w, t)/(2*w); d(x, t) = f1; d(y, t) = f2; d(z, t) = f3
    within b: 3, 5
    within k: 1, 2
xi_2.integrals | xi = 2: the values of H and K, addition | 1/2*(x^2 + y^2 + z^2) = k^2/8; y/x^2 = K
    within b: 3, 5
    within k: 1, 2
xi_half.solution | xi = 1/2: the solution, addition |
    xi := 1/2; x := K/u; y := 1/sqrt(u); z := d(u, t)/u; d(x, t) = f1; d(y, t) = f2; d(z, t) = f3
    within b: 3, 5
    within k: 1, 2
xi_0.solution | xi = 0: the solution |
    xi := 0; x := lambda*sech(lambda*t); y := beta; z := lambda*tanh(lambda*t);
    d(x, t) = f1; d(y, t) = f2; d(z, t) = f3
";

pub(super) fn claims() -> Vec<Claim> {
    [
        read(QUADRATURE, |id, place, statement| claim(id, place, statement).with_used_definitions(INTEGRALS)),
        read(ELEMENTARY, |id, place, statement| {
            claim(id, place, statement).with_used_definitions(ANTIDERIVATIVE)
        }),
        read(CLOSED_CASES, |id, place, statement| {
            claim(id, place, statement)
                .with_used_definitions(ORBIT)
                .with_used_definitions(W_DEFINITION)
                .with_used_definitions(U_DEFINITION)
        }),
    ]
    .concat()
}

fn claim(id: &str, place: &str, statement: &str) -> Claim {
    let place = format!("Section 6.3, {place}");
    Claim::new(Section::Transcendental, ["section6", "e9", id], "e9", place, statement)
}
