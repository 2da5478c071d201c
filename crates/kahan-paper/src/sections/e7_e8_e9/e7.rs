//! Claims about dE7: the solution with the gamma function, the integral Ĥ₇, the bracket with the
//! digamma function, and the series for K̂₇.

use super::super::super::claim::Claim;
use super::super::super::section::Section;
use super::super::text::read;

/// The variables of the recurrences: N = 1/(2εx), Y = y/x and Z = z/x.
const RATIOS: &str = "N := 1/(2*eps*x); Y := y/x; Z := z/x";

/// The solution that starts at x₀ = 1/(2ετ), y₀ = β/(2ε), z₀ = γ/(2ε).
const SOLUTION: &str = "
    N(n) := n + tau;
    G0 := gamma(tau + xi/2)/gamma(tau + 1 - xi/2);
    g(n) := gamma(N(n) + 1 - xi/2)/gamma(N(n) + xi/2);
    W(n) := sum(j, 0, n - 1, (2*(N(j) + 1) - xi)*g(j)^2/((2*N(j) + 3)*(2*N(j) + xi)*(4*N(j)^2 - 1)));
    X(n) := 1/(2*eps*N(n));
    Y(n) := tau*beta/(2*eps*N(n))*g(n)*G0;
    Z(n) := tau*gamma*(4*N(n)^2 - 1)/(2*eps*(4*tau^2 - 1)*N(n))
        + 2*tau^2*beta^2*xi*(4*N(n)^2 - 1)*G0^2/(eps*N(n))*W(n)";

/// `SOLUTION` at a fixed n, with g for g(n) and W for W(n). `step(F)` is F at n + 1.
const STEP: &str = "
    X := 1/(2*eps*N); Y := tau*beta/(2*eps*N)*g*G0;
    Z := tau*gamma*(4*N^2 - 1)/(2*eps*(4*tau^2 - 1)*N) + 2*tau^2*beta^2*xi*(4*N^2 - 1)*G0^2/(eps*N)*W;
    step(F) := at(F, N, N + 1, g, g*(N + 1 - xi/2)/(N + xi/2),
        W, W + (2*(N + 1) - xi)*g^2/((2*N + 3)*(2*N + xi)*(4*N^2 - 1)))";

const RECURRENCES: &str = "
recurrence.N | 1/(2 eps x) grows by one | next(N) = N + 1
recurrence.Y | recurrence for Y = y/x | next(Y) = Y*(N + 1 - xi/2)/(N + xi/2)
recurrence.Z | recurrence for Z = z/x | (N - 1/2)*next(Z) = (N + 3/2)*Z + 2*xi*Y*next(Y)
";

/// Claims about the solution. If a name ends in `.step`, the claim is about a single step.
const SOLUTIONS: &str = "
x | (ss), solution x_n | X(n) := 1/(2*eps*N(n)); on(next(x), X(n), y, z) = X(n + 1); tau = 1/(2*eps*X(0))
y | (ww), solution y_n |
    Y(n) := tau*beta/(2*eps*N(n))*g(n)*G0; on(next(y), X(n), Y(n), z) = Y(n + 1); Y(0) = beta/(2*eps)
y.step | (ww), for every n | on(next(y), X, Y, z) = step(Y)
z | (ew), solution z_n at n = 0, 1, 2, 3 |
    Z(0) = gamma/(2*eps); on(next(z), X(0), Y(0), Z(0)) = Z(1);
    on(next(z), X(1), Y(1), Z(1)) = Z(2); on(next(z), X(2), Y(2), Z(2)) = Z(3)
    within tau: 3/5, 2
z.step | (ew), for every n | on(next(z), X, Y, Z) = step(Z)
";

const INTEGRAL: &str = "u := 1/(2*eps*x); H7 := y/x*gamma(xi/2 + u)/gamma(1 - xi/2 + u)";

/// Claims about the integral, and about the bracket from the integral and the volume form.
const INTEGRALS: &str = "
H | the integral H_7 | H7 := y/x*gamma(xi/2 + u)/gamma(1 - xi/2 + u); next(H7) = H7
H.at_1 | H_7 at xi = 1 is H_1 | at(H7, xi, 1) = y/x
H.at_minus_1 | H_7 at xi = -1 is 4 eps^2 H_2 | at(H7, xi, -1) = 4*eps^2*x*y/(1 - eps^2*x^2)
H.value | H_7 at a point, addition |
    at(on(H7, 3/7, 11/13, 23/47), eps, 1/2, xi, 19/17) ~ 2.1831913544543205827
bracket.P23 | the bracket {y,z}, from H_7 and the volume form |
    P23 := y*(1 - eps^2*x^2)*((digamma(1 - xi/2 + u) - digamma(xi/2 + u))/(2*eps*x) - 1);
    P23 = x*y*(1 - eps^2*x^2)/H7*d(H7, x)
bracket.P31 | the bracket {z,x}, from H_7 and the volume form |
    P31 := x*(1 - eps^2*x^2); P31 = x*y*(1 - eps^2*x^2)/H7*d(H7, y)
bracket.P12 | the bracket {x,y}, from H_7 and the volume form |
    P12 := 0; P12 = x*y*(1 - eps^2*x^2)/H7*d(H7, z)
";

const BRACKET: &str = "
    u := 1/(2*eps*x);
    P12 := 0;
    P23 := y*(1 - eps^2*x^2)*((digamma(1 - xi/2 + u) - digamma(xi/2 + u))/(2*eps*x) - 1);
    P31 := x*(1 - eps^2*x^2)";

/// Claims about brackets. If the map preserves the bracket with the entries Pᵢⱼ, then the vector w
/// = (P₂₃, P₃₁, P₁₂) satisfies Jᵀ w(x̃) = det J · w(x), where J = ∂x̃/∂x.
const BRACKETS: &str = "
bracket.jacobi | the bracket's Jacobi identity | jacobi(P12, P23, P31) = 0
bracket.invariance | the map preserves the bracket |
    J(1,1)*next(P23) + J(2,1)*next(P31) + J(3,1)*next(P12) = detJ*P23;
    J(1,2)*next(P23) + J(2,2)*next(P31) + J(3,2)*next(P12) = detJ*P31;
    J(1,3)*next(P23) + J(2,3)*next(P31) + J(3,3)*next(P12) = detJ*P12
bracket.casimir | H_7 is a Casimir function of the bracket |
    P12*d(H7, y) - P31*d(H7, z) = 0; P23*d(H7, z) - P12*d(H7, x) = 0; P31*d(H7, x) - P23*d(H7, y) = 0
bracket.at_1 | the bracket at xi = 1 is -P of dE1 |
    at(P23, xi, 1) = -y*(1 - eps^2*x^2); at(P31, xi, 1) = x*(1 - eps^2*x^2)
bracket.at_minus_1 | the bracket at xi = -1 is -P of dE2 |
    at(P23, xi, -1) = y*(1 + eps^2*x^2); at(P31, xi, -1) = x*(1 - eps^2*x^2)
";

/// The series ε²K̂₇ = Z/(4N²−1) + Σ t_j, where t_j is the value of `t` after j steps (erratum B7).
const SERIES: &str = "N := 1/(2*eps*x); Y := y/x; Z := z/x; t := 4*xi*Y*next(Y)/((4*N^2 - 1)*(2*N + 3))";
const SECOND_INTEGRAL: &str = "
K.telescope | the series for K_7, addition: a step takes its first term away |
    t := 4*xi*Y*next(Y)/((4*N^2 - 1)*(2*N + 3)); next(Z/(4*N^2 - 1)) = Z/(4*N^2 - 1) + t
    explains B7
K.ratio | the series for K_7, addition: the ratio of its terms, that of 4F3 |
    next(t)/t = (N + 1 - xi/2)*(N + 2 - xi/2)*(N - 1/2)/((N + xi/2)*(N + 1 + xi/2)*(N + 5/2))
K | the integral K_7, addition |
    next(K7(x, y, z, eps, xi)) = K7(x, y, z, eps, xi);
    eps^2*K7(x, y, z, eps, xi) = Z/(4*N^2 - 1) + t + next(eps^2*K7(x, y, z, eps, xi) - Z/(4*N^2 - 1))
    explains B7
K.at_1 | K_7 at xi = 1 is K_1, addition |
    S := Y^2/(4*N^2 - 1); at(S - t - next(S), xi, 1) = 0;
    eps^2*(x*z + y^2)/(1 - eps^2*x^2) = Z/(4*N^2 - 1) + S;
    K7(x, y, z, eps, 1) = (x*z + y^2)/(1 - eps^2*x^2)
K.series | the series for K_7, summed at xi = 41/2, where it converges fast, addition |
    ratio(j) := gamma(N + j + 1 - 41/4)*gamma(N + 41/4)/(gamma(N + j + 41/4)*gamma(N + 1 - 41/4));
    term(j) := 82*Y^2*ratio(j)*ratio(j + 1)/((4*(N + j)^2 - 1)*(2*(N + j) + 3));
    eps^2*K7(x, y, z, eps, 41/2) = Z/(4*N^2 - 1) + sum(j, 0, 120, term(j))
    within x: 1/5, 2/5
    within eps: 1/5, 2/5
K.value | K_7 at a point, addition | K7(3/7, 11/13, 23/47, 1/2, 19/17) ~ 0.9698134589166862554
";

/// The call `point(F)` is F at the initial state that the parameters τ, β and γ determine.
const POINT_DEFINITION: &str = "point(F) := on(F, 1/(2*eps*tau), beta/(2*eps), gamma/(2*eps))";
const SPECIAL_CASES: &str = "
parameters.beta1 | beta_1 at xi = 1 | point(y/x) = tau*beta
parameters.gamma1 | gamma_1 at xi = 1 |
    point((x*z + y^2)/(1 - eps^2*x^2)) = (tau*gamma + tau^2*beta^2)/(eps^2*(4*tau^2 - 1))
parameters.beta2 | beta_2 at xi = -1 | point(x*y/(1 - eps^2*x^2)) = tau*beta/(eps^2*(4*tau^2 - 1))
parameters.gamma2 | gamma_2 at xi = -1 |
    beta2 := tau*beta/(eps^2*(4*tau^2 - 1));
    point((x*z + y^2)/(1 - eps^2*x^2)) = tau*gamma/(eps^2*(4*tau^2 - 1)) + eps^2*(4*tau^2 - 1)*beta2^2
";

pub(super) fn claims() -> Vec<Claim> {
    [
        read(RECURRENCES, |id, place, statement| claim(id, place, statement).with_used_definitions(RATIOS)),
        read(SOLUTIONS, |id, place, statement| {
            claim(id, place, statement).with_used_definitions(if id.ends_with(".step") {
                STEP
            } else {
                SOLUTION
            })
        }),
        read(INTEGRALS, |id, place, statement| claim(id, place, statement).with_used_definitions(INTEGRAL)),
        read(BRACKETS, |id, place, statement| {
            claim(id, place, statement).with_used_definitions(BRACKET).with_used_definitions(INTEGRAL)
        }),
        read(SECOND_INTEGRAL, |id, place, statement| {
            claim(id, place, statement).with_used_definitions(SERIES)
        }),
        read(SPECIAL_CASES, |id, place, statement| {
            claim(id, place, statement).with_used_definitions(POINT_DEFINITION)
        }),
    ]
    .concat()
}

fn claim(id: &str, place: &str, statement: &str) -> Claim {
    let place = format!("Section 6 (dE7), {place}");
    Claim::new(Section::Transcendental, ["section6", "e7", id], "e7", place, statement)
}
