//! dE7: solution with Γ, the integral Ĥ₇, the bracket with ψ, the series for K̂₇.

use super::super::super::claim::Claim;
use super::super::super::erratum::Erratum::B;
use super::super::super::section::Section;

/// N = u = 1/(2εx) and the ratios Y = y/x, Z = z/x in which the map is linear.
const RATIOS: &str = "N := 1/(2*eps*x); Y := y/x; Z := z/x";

/// The solution through x₀ = 1/(2ετ), y₀ = β/(2ε), z₀ = γ/(2ε).
const SOLUTION: &str = "
    N(n) := n + tau;
    G0 := gamma(tau + xi/2)/gamma(tau + 1 - xi/2);
    g(n) := gamma(N(n) + 1 - xi/2)/gamma(N(n) + xi/2);
    W(n) := sum(j, 0, n - 1, (2*(N(j) + 1) - xi)*g(j)^2/((2*N(j) + 3)*(2*N(j) + xi)*(4*N(j)^2 - 1)));
    X(n) := 1/(2*eps*N(n));
    Y(n) := tau*beta/(2*eps*N(n))*g(n)*G0;
    Z(n) := tau*gamma*(4*N(n)^2 - 1)/(2*eps*(4*tau^2 - 1)*N(n))
        + 2*tau^2*beta^2*xi*(4*N(n)^2 - 1)*G0^2/(eps*N(n))*W(n)";

/// The same at one point of the orbit, with g = g_n and W = W_n as names; `step(F)` puts in what
/// they are a step later.
const STEP: &str = "
    X := 1/(2*eps*N); Y := tau*beta/(2*eps*N)*g*G0;
    Z := tau*gamma*(4*N^2 - 1)/(2*eps*(4*tau^2 - 1)*N) + 2*tau^2*beta^2*xi*(4*N^2 - 1)*G0^2/(eps*N)*W;
    step(F) := at(F, N, N + 1, g, g*(N + 1 - xi/2)/(N + xi/2),
        W, W + (2*(N + 1) - xi)*g^2/((2*N + 3)*(2*N + xi)*(4*N^2 - 1)))";

const INTEGRAL: &str = "u := 1/(2*eps*x); H7 := y/x*gamma(xi/2 + u)/gamma(1 - xi/2 + u)";

const BRACKET: &str = "
    u := 1/(2*eps*x);
    P12 := 0;
    P23 := y*(1 - eps^2*x^2)*((digamma(1 - xi/2 + u) - digamma(xi/2 + u))/(2*eps*x) - 1);
    P31 := x*(1 - eps^2*x^2)";

fn claim(id: &str, place: &str, statement: &str, given: &str) -> Claim {
    Claim::new(
        Section::Transcendental,
        ["section6", "e7", id],
        "e7",
        format!("Section 6 (dE7), {place}"),
        statement,
    )
    .spelling(given)
}

/// The claims, in the order of the paper.
pub(super) fn claims() -> Vec<Claim> {
    [recurrences(), solution(), integral(), bracket(), second_integral(), special_cases()].concat()
}

fn recurrences() -> Vec<Claim> {
    vec![
        claim("recurrence.N", "1/(2 eps x) grows by one", "next(N) = N + 1", RATIOS),
        claim("recurrence.Y", "recurrence for Y = y/x", "next(Y) = Y*(N + 1 - xi/2)/(N + xi/2)", RATIOS),
        claim(
            "recurrence.Z",
            "recurrence for Z = z/x",
            "(N - 1/2)*next(Z) = (N + 3/2)*Z + 2*xi*Y*next(Y)",
            RATIOS,
        ),
    ]
}

fn solution() -> Vec<Claim> {
    vec![
        claim(
            "x",
            "(ss), solution x_n",
            "X(n) := 1/(2*eps*N(n)); on(next(x), X(n), y, z) = X(n + 1); tau = 1/(2*eps*X(0))",
            SOLUTION,
        ),
        claim(
            "y",
            "(ww), solution y_n",
            "Y(n) := tau*beta/(2*eps*N(n))*g(n)*G0; on(next(y), X(n), Y(n), z) = Y(n + 1);
            Y(0) = beta/(2*eps)",
            SOLUTION,
        ),
        claim("y.step", "(ww), for every n", "on(next(y), X, Y, z) = step(Y)", STEP),
        claim(
            "z",
            "(ew), solution z_n at n = 0, 1, 2, 3",
            "Z(0) = gamma/(2*eps);
            on(next(z), X(0), Y(0), Z(0)) = Z(1);
            on(next(z), X(1), Y(1), Z(1)) = Z(2);
            on(next(z), X(2), Y(2), Z(2)) = Z(3)",
            SOLUTION,
        )
        .within("tau", (6, 10), (2, 1)),
        claim("z.step", "(ew), for every n", "on(next(z), X, Y, Z) = step(Z)", STEP),
    ]
}

fn integral() -> Vec<Claim> {
    vec![
        claim(
            "H",
            "the integral H_7",
            "H7 := y/x*gamma(xi/2 + u)/gamma(1 - xi/2 + u); next(H7) = H7",
            "u := 1/(2*eps*x)",
        ),
        claim("H.at_1", "H_7 at xi = 1 is H_1", "at(H7, xi, 1) = y/x", INTEGRAL),
        claim(
            "H.at_minus_1",
            "H_7 at xi = -1 is 4 eps^2 H_2",
            "at(H7, xi, -1) = 4*eps^2*x*y/(1 - eps^2*x^2)",
            INTEGRAL,
        ),
        claim(
            "H.value",
            "H_7 at a point, addition",
            "at(on(H7, 3/7, 11/13, 23/47), eps, 1/2, xi, 19/17) ~ 2.1831913544543205827",
            INTEGRAL,
        ),
    ]
}

/// With w = (P₂₃, P₃₁, P₁₂) invariance is Jᵀ w(x̃) = det J · w(x).
fn bracket() -> Vec<Claim> {
    let row = |i: usize| format!("J(1,{i})*next(P23) + J(2,{i})*next(P31) + J(3,{i})*next(P12) = detJ");
    vec![
        claim(
            "bracket.P23",
            "the bracket {y,z}, from H_7 and the volume form",
            "P23 := y*(1 - eps^2*x^2)*((digamma(1 - xi/2 + u) - digamma(xi/2 + u))/(2*eps*x) - 1);
            P23 = x*y*(1 - eps^2*x^2)/H7*d(H7, x)",
            INTEGRAL,
        ),
        claim(
            "bracket.P31",
            "the bracket {z,x}, from H_7 and the volume form",
            "P31 := x*(1 - eps^2*x^2); P31 = x*y*(1 - eps^2*x^2)/H7*d(H7, y)",
            INTEGRAL,
        ),
        claim(
            "bracket.P12",
            "the bracket {x,y}, from H_7 and the volume form",
            "P12 := 0; P12 = x*y*(1 - eps^2*x^2)/H7*d(H7, z)",
            INTEGRAL,
        ),
        claim("bracket.jacobi", "the bracket's Jacobi identity", "jacobi(P12, P23, P31) = 0", BRACKET),
        claim(
            "bracket.invariance",
            "the map preserves the bracket",
            &format!("{}*P23; {}*P31; {}*P12", row(1), row(2), row(3)),
            BRACKET,
        ),
        claim(
            "bracket.casimir",
            "H_7 is a Casimir function of the bracket",
            "P12*d(H7, y) - P31*d(H7, z) = 0; P23*d(H7, z) - P12*d(H7, x) = 0;
            P31*d(H7, x) - P23*d(H7, y) = 0",
            BRACKET,
        )
        .spelling(INTEGRAL),
        claim(
            "bracket.at_1",
            "the bracket at xi = 1 is -P of dE1",
            "at(P23, xi, 1) = -y*(1 - eps^2*x^2); at(P31, xi, 1) = x*(1 - eps^2*x^2)",
            BRACKET,
        ),
        claim(
            "bracket.at_minus_1",
            "the bracket at xi = -1 is -P of dE2",
            "at(P23, xi, -1) = y*(1 + eps^2*x^2); at(P31, xi, -1) = x*(1 - eps^2*x^2)",
            BRACKET,
        ),
    ]
}

/// K̂₇ as a function of the point (erratum B7): ε²K̂₇ = Z/(4N²−1) + Σ t_j.
fn second_integral() -> Vec<Claim> {
    let series = "N := 1/(2*eps*x); Y := y/x; Z := z/x; t := 4*xi*Y*next(Y)/((4*N^2 - 1)*(2*N + 3))";
    vec![
        claim(
            "K.telescope",
            "the series for K_7, addition: a step takes its first term away",
            "t := 4*xi*Y*next(Y)/((4*N^2 - 1)*(2*N + 3)); next(Z/(4*N^2 - 1)) = Z/(4*N^2 - 1) + t",
            RATIOS,
        )
        .explaining(B(7)),
        claim(
            "K.ratio",
            "the series for K_7, addition: the ratio of its terms, that of 4F3",
            "next(t)/t = (N + 1 - xi/2)*(N + 2 - xi/2)*(N - 1/2)/((N + xi/2)*(N + 1 + xi/2)*(N + 5/2))",
            series,
        ),
        claim(
            "K",
            "the integral K_7, addition",
            "next(K7(x, y, z, eps, xi)) = K7(x, y, z, eps, xi);
            eps^2*K7(x, y, z, eps, xi)
                = Z/(4*N^2 - 1) + t + next(eps^2*K7(x, y, z, eps, xi) - Z/(4*N^2 - 1))",
            series,
        )
        .explaining(B(7)),
        claim(
            "K.at_1",
            "K_7 at xi = 1 is K_1, addition",
            "S := Y^2/(4*N^2 - 1); at(S - t - next(S), xi, 1) = 0;
            eps^2*(x*z + y^2)/(1 - eps^2*x^2) = Z/(4*N^2 - 1) + S;
            K7(x, y, z, eps, 1) = (x*z + y^2)/(1 - eps^2*x^2)",
            series,
        ),
        claim(
            "K.series",
            "the series for K_7, summed at xi = 41/2, where it converges fast, addition",
            "ratio(j) := gamma(N + j + 1 - 41/4)*gamma(N + 41/4)/(gamma(N + j + 41/4)*gamma(N + 1 - 41/4));
            term(j) := 82*Y^2*ratio(j)*ratio(j + 1)/((4*(N + j)^2 - 1)*(2*(N + j) + 3));
            eps^2*K7(x, y, z, eps, 41/2) = Z/(4*N^2 - 1) + sum(j, 0, 120, term(j))",
            RATIOS,
        )
        .within("x", (1, 5), (2, 5))
        .within("eps", (1, 5), (2, 5)),
        claim(
            "K.value",
            "K_7 at a point, addition",
            "K7(3/7, 11/13, 23/47, 1/2, 19/17) ~ 0.9698134589166862554",
            RATIOS,
        ),
    ]
}

/// β and γ of Theorem 3 from those of (ww), (ew).
fn special_cases() -> Vec<Claim> {
    let given = "point(F) := on(F, 1/(2*eps*tau), beta/(2*eps), gamma/(2*eps))";
    vec![
        claim("parameters.beta1", "beta_1 at xi = 1", "point(y/x) = tau*beta", given),
        claim(
            "parameters.gamma1",
            "gamma_1 at xi = 1",
            "point((x*z + y^2)/(1 - eps^2*x^2)) = (tau*gamma + tau^2*beta^2)/(eps^2*(4*tau^2 - 1))",
            given,
        ),
        claim(
            "parameters.beta2",
            "beta_2 at xi = -1",
            "point(x*y/(1 - eps^2*x^2)) = tau*beta/(eps^2*(4*tau^2 - 1))",
            given,
        ),
        claim(
            "parameters.gamma2",
            "gamma_2 at xi = -1",
            "beta2 := tau*beta/(eps^2*(4*tau^2 - 1));
            point((x*z + y^2)/(1 - eps^2*x^2))
                = tau*gamma/(eps^2*(4*tau^2 - 1)) + eps^2*(4*tau^2 - 1)*beta2^2",
            given,
        ),
    ]
}
