//! Claims on the second real branches of the solutions of dE3 (|εz| > 1) and dE5 (|εy| > 1).

use super::super::super::claim::Claim;
use super::super::text::read;
use super::{Solution, solution_claim};

/// Second branches of solutions in Theorem 3, with πi/2 added to the parameters δ and κ.
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

/// Claims that an orbit cannot change its branch.
const SEPARATION: &str = "
theorem3.e3.sides | Theorem 3, i = 3, addition: the sign of 1 - eps^2 z^2 is kept |
    1 - 2*eps^2*K_eps = (1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2))
theorem3.e3.degenerate | Theorem 3, i = 3, addition: between the branches, eps z = 1 and -1 |
    on(next(x), x, y, 1/eps) = 0; on(next(y), x, y, 1/eps) = 0; on(next(z), x, y, 1/eps) = 1/eps;
    on(detA, x, y, -1/eps) = 0
theorem3.e5.sides | Theorem 3, i = 5, addition: the sign of 1 - eps^2 y^2 is kept |
    1 - 2*eps^2*H_eps = (1 - eps^2*y^2)/(1 + eps^2*x^2)
theorem3.e5.symmetry | Theorem 3, i = 5, addition: the symmetry (x,y,z) -> (-x,y,-z) |
    on(next(x), -x, y, -z) = -next(x); on(next(y), -x, y, -z) = next(y); on(next(z), -x, y, -z) = -next(z)
";

pub(super) fn claims() -> Vec<Claim> {
    let branches = BRANCHES
        .iter()
        .flat_map(|(solution, signs)| solution.claims("branch.", ", second real branch, addition", *signs));
    branches.chain(read(SEPARATION, solution_claim)).collect()
}
