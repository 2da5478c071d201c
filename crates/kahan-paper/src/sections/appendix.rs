//! Claims of section 7 and of the appendix: the linearisation of dE3, and the curve, bilinear
//! equations and theta functions of dE4.

use kahan_algebra::rational::Rational;

use super::super::claim::Claim;
use super::super::section::Section;
use super::structures::structure;
use super::text::read;

/// Definitions for the recurrence of w = 1/x along orbits of dE3 at ε = 1/2.
const LINEARISED_DEFINITIONS: &str = "
    w0 := 1/x; w1 := at(next(1/x), eps, 1/2); w2 := at(next(next(1/x)), eps, 1/2);
    s := 1 + y^2/x^2; K := at(1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2)), eps, 1/2);
    L := (2*(w0^2 + w1^2) + s)/(4*w0*w1 - s)";
const LINEARISATION: &str = "
recurrence | recurrence of second order for w = 1/x | w2 = (4*w1^3 + s*(2*w1 + w0))/(4*w0*w1 - s)
L | the integral L of the recurrence |
    L := (2*(w0^2 + w1^2) + s)/(4*w0*w1 - s); (2*(w1^2 + w2^2) + s)/(4*w1*w2 - s) = L
L.K | L by K(eps) of dE3 | L = (2 + K)/(2 - K)
L.delta | L is cosh 2 delta | K := 2*tanh(delta)^2; (2 + K)/(2 - K) = cosh(2*delta)
linear | (linde3), the linear recurrence | w2 - 2*L*w1 + w0 = 0
";

/// The level set of dE4's integrals H and K, as two quadrics in s = x + y, d = x − y and z.
const LEVEL_CURVE: &str = "
curve.H | first equation of the curve in s and d |
    s := x + y; d := x - y; (1 - 2*H*eps^2)*s^2 - (1 + 2*H*eps^2)*d^2 = 4*H
curve.K | second equation of the curve in s and d |
    s := x + y; d := x - y; (1 - 2*K*eps^2)*(s^2 + d^2) + 2*z^2 = 4*K
    misprint A6: s := x + y; d := x - y; (1 - 2*K*eps^2)*(s^2 + d^2) + 4*z^2 = 4*K
    refuted: eps := 1/2; x := 1; y := 1; z := 1; K = 1; (1 - 2*K*eps^2)*(s^2 + d^2) + 4*z^2 = 6
";
const SQUARES: &str = "
    h := 2*H*eps^2; g := 2*K*eps^2;
    s2 := 2*H + 2*K*(1 + h)/(1 - g); d2 := 2*K*(1 - h)/(1 - g) - 2*H";
const BRANCH_POINTS: &str = "
curve.branch_points |
    the four points (+-s, +-d, 0) at which the double cover of a conic branches: genus 1, by Riemann-Hurwitz |
    s2 := 2*H + 2*K*(1 + h)/(1 - g); d2 := 2*K*(1 - h)/(1 - g) - 2*H; (1 - h)*s2 - (1 + h)*d2 = 4*H;
    (1 - g)*(s2 + d2) = 4*K; genus := 1; points := 2*2; 2*genus - 2 = 2*(2*0 - 2) + points
curve.distinct | the four branch points are different |
    s2 := 2*H + 2*K*(1 + h)/(1 - g);
    s2*d2*(1 - g)^2 = 4*(K*(1 + h) + H*(1 - g))*(K*(1 - h) - H*(1 - g)); s2 != 0; d2 != 0
";
const RATIOS: &str =
    "h := 2*H*eps^2; g := 2*K*eps^2; r1 := (1 - h)/(1 - g); r2 := -(1 + h)/(1 - g); r3 := H/K";
const SMOOTHNESS: &str = "
curve.infinity | no branch point at infinity: there s^2 (1 - h) = d^2 (1 + h), and z is not 0 |
    h := 2*H*eps^2; g := 2*K*eps^2; d2 := s2*(1 - h)/(1 + h); z2 := -(1 - g)*s2/(1 + h);
    (1 - g)*(s2 + d2) + 2*z2 = 0; (1 - h)*s2 - (1 + h)*d2 = 0; z2 != 0
curve.pencil | the four singular quadrics of the pencil are different: the curve is smooth |
    det(r) := ((1 - h) - r*(1 - g))*(-(1 + h) - r*(1 - g))*(-2*r)*(-4*H + 4*r*K);
    det(r1) = 0; det(r2) = 0; det(0) = 0; det(r3) = 0;
    r1 != 0; r2 != 0; r3 != 0; r1 != r2; r1 != r3; r2 != r3
";

/// Homogeneous coordinates A, B, C, D of a point of dE4, and A1, B1, C1, D1 of the next point.
const HOMOGENEOUS: &str = "
    x := (A + B)/(2*eps*D); y := (A - B)/(2*eps*D); z := C/(eps*D);
    X := (A1 + B1)/(2*eps*D1); Y := (A1 - B1)/(2*eps*D1); Z := C1/(eps*D1);
    first := A1*D - A*D1 + B1*C + B*C1; second := B1*D - B*D1 + A1*C + A*C1;
    third := C1*D - C*D1 - A1*B - A*B1";
const BILINEAR: &str = "
bilinear.x | bilinear equations: the equation of x | 2*eps*D*D1*(X - x + eps*(x*Z + X*z)) = first + second
bilinear.y | bilinear equations: the equation of y | 2*eps*D*D1*(Y - y - eps*(y*Z + Y*z)) = first - second
bilinear.z | bilinear equations: the equation of z | eps*D*D1*(Z - z - 2*eps*(x*X - y*Y)) = third
";

/// The addition theorem of Jacobi's function sn.
const ELLIPTIC: &str = "
snadd | (snadd), the addition theorem of sn |
    sn(u + v, k)
    = (sn(u, k)*cn(v, k)*dn(v, k) + sn(v, k)*cn(u, k)*dn(u, k))/(1 - k^2*sn(u, k)^2*sn(v, k)^2)
integral | the integral of the first kind: sn is its inverse |
    d(sn(u, k), u)^2 = (1 - sn(u, k)^2)*(1 - k^2*sn(u, k)^2); F(atan2(sn(u, k), cn(u, k)), k) = u
";

/// The parameters δ and κ of dE4's solution, as elliptic integrals F with the modulus k.
const PARAMETERS: &str = "
    k := sqrt((g - h)*(1 + h)/((g + h)*(1 - h))); s := sqrt((g + h)/(1 + h));
    delta := F(atan2(s, sqrt(1 - s^2)), k);
    kappa := F(atan2(eps*z, eps*(x - y)*sqrt((1 - g)/(1 - h))), k)";
const INTEGRALS: &str = "
delta | the integral for delta |
    sn(delta, k)^2 = (g + h)/(1 + h); d(sn(u, k), u) = sqrt((1 - sn(u, k)^2)*(1 - k^2*sn(u, k)^2))
kappa | the integral for kappa |
    sn(kappa, k) = eps*z/(k*sn(delta, k)); dn(kappa, k) = eps*(x + y)*cn(delta, k)/sn(delta, k)
";

/// Theta constants of nome q, and the modulus k.
const CONSTANTS: &str = "t2 := theta2(0, q); t3 := theta3(0, q); t4 := theta4(0, q); k := (t2/t3)^2";
const SOLUTION: &str = "
    A(w) := theta1(v, q)/theta2(v, q)*theta3(w, q); B(w) := theta1(v, q)/theta3(v, q)*theta2(w, q);
    C(w) := theta1(v, q)/theta4(v, q)*theta1(w, q); D(w) := theta4(w, q)";
const THETA: &str = "
theta.sn | theta form of sn | sn(zeta*t3^2, k) = t3/t2*theta1(zeta, q)/theta4(zeta, q)
theta.cn | theta form of cn | cn(zeta*t3^2, k) = t4/t2*theta2(zeta, q)/theta4(zeta, q)
    misprint A7: cn(zeta*t3^2, k) = t4/t2*theta3(zeta, q)/theta4(zeta, q)
    refuted: q := 1/10; zeta := 0; cn(zeta*t3^2, k) = 1; theta3(0, 1/10)/theta2(0, 1/10) ~ 1.05658
theta.dn | theta form of dn | dn(zeta*t3^2, k) = t4/t3*theta3(zeta, q)/theta4(zeta, q)
theta.k | the modulus and its complement |
    t2 := theta2(0, q); t3 := theta3(0, q); t4 := theta4(0, q); k := sqrt(1 - (t4/t3)^4);
    t3^4 = t2^4 + t4^4; k = (t2/t3)^2; K(k) = pi/2*t3^2
theta.solution | theta functions solve dE4: the solution of Theorem 3 |
    delta := v*t3^2; u := zeta*t3^2; A(zeta)/D(zeta) = sn(delta, k)*dn(u, k)/cn(delta, k);
    B(zeta)/D(zeta) = k*sn(delta, k)*cn(u, k)/dn(delta, k); C(zeta)/D(zeta) = k*sn(delta, k)*sn(u, k)
theta.first | (thetarel), the first bilinear equation |
    A(zeta + 2*v)*D(zeta) - A(zeta)*D(zeta + 2*v) = -(B(zeta + 2*v)*C(zeta) + B(zeta)*C(zeta + 2*v))
theta.second | (thetarel), the second bilinear equation |
    B(zeta + 2*v)*D(zeta) - B(zeta)*D(zeta + 2*v) = -(A(zeta + 2*v)*C(zeta) + A(zeta)*C(zeta + 2*v))
theta.third | (thetarel2), the third bilinear equation |
    C(zeta + 2*v)*D(zeta) - C(zeta)*D(zeta + 2*v) = A(zeta + 2*v)*B(zeta) + A(zeta)*B(zeta + 2*v)
";

pub(super) fn claims() -> Vec<Claim> {
    let value = |name| structure("e4").and_then(|row| row.value(name)).expect("the tables have it");
    let integrals = format!("H := {}; K := {};", value("H_eps"), value("K_eps"));
    let level = format!("{integrals} h := 2*eps^2*H; g := 2*eps^2*K;");
    [
        read(LINEARISATION, |id, place, statement| {
            let place = format!("Section 7, {place}");
            Claim::new(Section::Diophantine, ["section7", "e3", id], "e3", place, statement)
                .with_used_definitions(LINEARISED_DEFINITIONS)
        }),
        read(LEVEL_CURVE, |id, place, statement| claim(id, place, statement).given_definitions(&integrals)),
        read(BRANCH_POINTS, |id, place, statement| {
            claim(id, place, statement).with_used_definitions(SQUARES)
        }),
        read(SMOOTHNESS, |id, place, statement| claim(id, place, statement).with_used_definitions(RATIOS)),
        read(BILINEAR, |id, place, statement| claim(id, place, statement).with_used_definitions(HOMOGENEOUS)),
        read(ELLIPTIC, claim),
        read(INTEGRALS, |id, place, statement| {
            claim(id, place, statement).given_definitions(&level).with_used_definitions(PARAMETERS)
        }),
        read(THETA, |id, place, statement| {
            let claim =
                claim(id, place, statement).with_used_definitions(SOLUTION).with_used_definitions(CONSTANTS);
            claim.within("q", Rational::new(1, 50), Rational::new(1, 4))
        }),
    ]
    .concat()
}

fn claim(id: &str, place: &str, statement: &str) -> Claim {
    Claim::new(Section::Appendix, ["appendix", id], "e4", format!("Appendix, {place}"), statement)
}
