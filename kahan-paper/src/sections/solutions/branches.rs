//! The second real branches of the solutions of dE3 (|εz| > 1) and dE5 (|εy| > 1), and what
//! separates them.

use super::super::super::claim::Claim;
use super::super::super::section::Section;
use super::{SOLUTIONS, Solution};

/// δ and κ of Theorem 3 moved by πi/2, with ν = iμ: (−1)ⁿ comes with some components.
pub(super) static BRANCHES: [(Solution, [&str; 3]); 2] = [
    (
        Solution {
            system: "e3",
            given: "T(n) := 2*delta*n + kappa;",
            components: [
                "cos(theta)*cosh(delta)/(eps*sinh(T(n)))",
                "sin(theta)*cosh(delta)/(eps*sinh(T(n)))",
                "coth(delta)*coth(T(n))/eps",
            ],
            values: ["tan(theta)", "coth(delta)^2/(2*eps^2)"],
        },
        ["-", "-", ""],
    ),
    (
        Solution {
            system: "e5",
            given: "T(n) := 2*delta*n + kappa;",
            components: [
                "cosh(delta)/(eps*sinh(T(n)))",
                "-coth(delta)*coth(T(n))/eps",
                "nu*sinh(T(n)) + (1/eps + nu*cosh(delta))*cosh(delta)/sinh(T(n))",
            ],
            values: ["coth(delta)^2/(2*eps^2)", "nu*cosh(delta)/eps + coth(delta)^2/eps^2"],
        },
        ["-", "", "-"],
    ),
];

/// The second branches and the degenerate case between the two.
pub(super) fn claims() -> Vec<Claim> {
    let branches = BRANCHES
        .iter()
        .flat_map(|(solution, signs)| solution.claims("branch.", ", second real branch, addition", *signs));
    branches.chain(separation()).collect()
}

/// No orbit passes from one branch to the other.
fn separation() -> Vec<Claim> {
    let claim = |id: &str, system: &'static str, place: &str, statement: &str| {
        let source = format!("Theorem 3, i = {}, addition: {place}", &system[1..]);
        let integrals =
            SOLUTIONS.iter().find(|solution| solution.system == system).map(Solution::definitions);
        Claim::new(Section::MapSolutions, ["theorem3", system, id], system, source, statement)
            .given(&integrals.unwrap_or_default())
    };
    vec![
        claim(
            "sides",
            "e3",
            "the sign of 1 - eps^2 z^2 is kept",
            "1 - 2*eps^2*K_eps = (1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2))",
        ),
        claim(
            "degenerate",
            "e3",
            "between the branches, eps z = 1 and -1",
            "on(next(x), x, y, 1/eps) = 0; on(next(y), x, y, 1/eps) = 0; on(next(z), x, y, 1/eps) = 1/eps;
            on(detA, x, y, -1/eps) = 0",
        ),
        claim(
            "sides",
            "e5",
            "the sign of 1 - eps^2 y^2 is kept",
            "1 - 2*eps^2*H_eps = (1 - eps^2*y^2)/(1 + eps^2*x^2)",
        ),
        claim(
            "symmetry",
            "e5",
            "the symmetry (x,y,z) -> (-x,y,-z)",
            "on(next(x), -x, y, -z) = -next(x); on(next(y), -x, y, -z) = next(y);
            on(next(z), -x, y, -z) = -next(z)",
        ),
    ]
}
