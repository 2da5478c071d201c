//! Claims about dE8: solution with the digamma function, integral Ĥ₈, and series for K̂₈.

use super::super::super::claim::Claim;
use super::super::super::section::Section;
use super::super::text::read;

/// Defines N, Z and t in the series ε²K̂₈ = Z/(4N²−1) + Σ t_j, where t_j is t after j steps.
const SERIES: &str = "
    u := 1/(2*eps*x); N := 1/(2*eps*x); Y := y/x; Z := z/x;
    t := 2*(Y + next(Y) + 2*Y*next(Y))/((4*N^2 - 1)*(2*N + 3))";

/// The solution that starts at x₀ = 1/(2ετ), y₀ = β/(2ε), z₀ = γ/(2ε).
const SOLUTION: &str = "
    N(n) := n + tau;
    U(n) := digamma(N(n) + 1/2) - digamma(tau + 1/2);
    V(n) := sum(j, 0, n - 1,
        (1 + 2*beta*tau + U(j)*(2*N(j)*(1 + 2*beta*tau) - 1 + 2*beta*tau) - U(j)^2*(2*N(j) + 1))
        /((2*N(j) + 3)*(2*N(j) + 1)*(4*N(j)^2 - 1)));
    X(n) := 1/(2*eps*N(n));
    Y(n) := (tau*beta - U(n))/(2*eps*N(n));
    solution(n, prefactor) := tau*(4*n*(n + 2*tau)*(beta^2*tau + beta + gamma) + 4*tau^2*gamma - gamma)
        /(2*eps*(4*tau^2 - 1)*N(n)) - prefactor*(4*N(n)^2 - 1)/(2*eps*N(n))*V(n)";

/// The formulas of `SOLUTION` without arguments: U is U(n), and V is V(n). `step(F)` is F at n + 1.
const STEP: &str = "
    N := n + tau; X := 1/(2*eps*N); Y := (tau*beta - U)/(2*eps*N);
    Z := tau*(4*n*(n + 2*tau)*(beta^2*tau + beta + gamma) + 4*tau^2*gamma - gamma)/(2*eps*(4*tau^2 - 1)*N)
        - 4*(4*N^2 - 1)/(2*eps*N)*V;
    step(F) := at(F, n, n + 1, U, U + 1/(N + 1/2),
        V, V + (1 + 2*beta*tau + U*(2*N*(1 + 2*beta*tau) - 1 + 2*beta*tau) - U^2*(2*N + 1))
            /((2*N + 3)*(2*N + 1)*(4*N^2 - 1)))";

const RECURRENCES: &str = "
recurrence.N | 1/(2 eps x) grows by one | next(N) = N + 1
recurrence.Y | recurrence for Y = y/x | next(Y) = Y - 1/(N + 1/2)
recurrence.Z | recurrence for Z = z/x | (N - 1/2)*next(Z) = (N + 3/2)*Z + Y + next(Y) + 2*Y*next(Y)
";

/// Claims about the solution. If a name ends in `.step`, the claim is about a single step.
const SOLUTIONS: &str = "
x | (b12), solution x_n | X(n) := 1/(2*eps*N(n)); on(next(x), X(n), y, z) = X(n + 1); tau = 1/(2*eps*X(0))
U | U_n as a sum | U(0) = 0; U(n + 1) = U(n) + 1/(N(n) + 1/2); U(4) = sum(j, 0, 3, 1/(j + tau + 1/2))
y | (ww2), solution y_n |
    Y(n) := (tau*beta - U(n))/(2*eps*N(n)); on(next(y), X(n), Y(n), z) = Y(n + 1); Y(0) = beta/(2*eps)
y.step | (ww2), for every n | on(next(y), X, Y, z) = step(Y)
z | (jbn), solution z_n at n = 0, 1, 2, 3, prefactor of V_n |
    Z(n) := solution(n, 4); Z(0) = gamma/(2*eps); on(next(z), X(0), Y(0), Z(0)) = Z(1);
    on(next(z), X(1), Y(1), Z(1)) = Z(2); on(next(z), X(2), Y(2), Z(2)) = Z(3)
    within tau: 3/5, 2
    misprint A3: Z(n) := solution(n, 2); on(next(z), X(0), Y(0), Z(0)) = Z(1)
    refuted: eps := 1/2; tau := 1; beta := 0; gamma := 0; X(0) = 1; Y(0) = 0; Z(0) = 0;
        on(next(z), 1, 0, 0) = -2/3; solution(1, 2) = -1/3
z.step | (jbn), for every n | on(next(z), X, Y, Z) = step(Z)
";

const INTEGRALS: &str = "
H | the integral H_8 | H8 := y/x + digamma(1/2 + u); next(H8) = H8
K.telescope | the series for K_8, addition: a step takes its first term away |
    t := 2*(Y + next(Y) + 2*Y*next(Y))/((4*N^2 - 1)*(2*N + 3));
    next(Z/(4*N^2 - 1)) = Z/(4*N^2 - 1) + t
K | the integral K_8, addition |
    next(K8(x, y, z, eps)) = K8(x, y, z, eps);
    eps^2*K8(x, y, z, eps) = Z/(4*N^2 - 1) + t + next(eps^2*K8(x, y, z, eps) - Z/(4*N^2 - 1))
K.value | K_8 at a point, by Euler-Maclaurin summation of its series, addition |
    K8(3/7, 11/13, 23/47, 1/2) ~ 0.96199969351111768436670
";

pub(super) fn claims() -> Vec<Claim> {
    [RECURRENCES, SOLUTIONS, INTEGRALS].map(|text| read(text, claim)).concat()
}

fn claim(id: &str, place: &str, statement: &str) -> Claim {
    let place = format!("Section 6 (dE8), {place}");
    let claim = Claim::new(Section::Transcendental, ["section6", "e8", id], "e8", place, statement);
    claim.with_used_definitions(match id {
        _ if id.ends_with(".step") => STEP,
        "x" | "U" | "y" | "z" => SOLUTION,
        _ => SERIES,
    })
}
