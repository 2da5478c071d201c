//! Claims on the parameters of the solution through a given state.

use super::super::super::claim::Claim;
use super::super::text::read;
use super::branches::BRANCHES;
use super::{claim, solution_claim};

/// The parameters of the solution as functions of the state (x, y, z).
const PARAMETERS_OF_STATE: &str = "
theorem3.e1.through | Theorem 3, i = 1, addition: the parameters from initial data |
    tau := 1/(2*eps*x); beta := H_eps; gamma := K_eps; X(0) = x; Y(0) = y; Z(0) = z
theorem3.e2.through | Theorem 3, i = 2, addition: the parameters from initial data |
    tau := 1/(2*eps*x); beta := H_eps; gamma := K_eps; X(0) = x; Y(0) = y; Z(0) = z
theorem3.e3.through | Theorem 3, i = 3, addition: the parameters from initial data, |eps z| < 1 |
    theta := atan2(y, x); delta := atanh(eps*sqrt(2*K_eps)); kappa := atanh(eps*z/tanh(delta));
    X(0) = x; Y(0) = y; Z(0) = z
theorem3.e4.through | Theorem 3, i = 4, addition: the parameters from initial data, x y > 0, |eps z| < 1 |
    h := 2*eps^2*H_eps; g := 2*eps^2*K_eps;
    sn_delta := sqrt((g + h)/(1 + h)); cn_delta := sqrt((1 - g)/(1 + h)); dn_delta := sqrt((1 - g)/(1 - h));
    k := sqrt((g - h)*(1 + h)/((g + h)*(1 - h))); delta := F(atan2(sn_delta, cn_delta), k);
    kappa := F(atan2(eps*z/(k*sn_delta), eps*(x - y)*dn_delta/(k*sn_delta)), k);
    X(0) = x; Y(0) = y; Z(0) = z
theorem3.e5.through | Theorem 3, i = 5, addition: the parameters from initial data, |eps y| < 1 |
    delta := atanh(eps*sqrt(2*H_eps)); kappa := -atanh(eps*y/tanh(delta));
    mu := (K_eps - tanh(delta)^2/eps^2)*eps/sinh(delta); X(0) = x; Y(0) = y; Z(0) = z
";

/// The parameters of the solutions on the second real branches.
const THROUGH_BRANCHES: &str = "
theorem3.e3.branch.through | Theorem 3, i = 3, addition: the parameters from initial data, eps z > 1 |
    theta := atan2(y, x); delta := atanh(1/(eps*sqrt(2*K_eps))); kappa := atanh(coth(delta)/(eps*z));
    X(0) = x; Y(0) = y; Z(0) = z
    within z: 6, 9
theorem3.e5.branch.through | Theorem 3, i = 5, addition: the parameters from initial data, eps y < -1 |
    delta := atanh(1/(eps*sqrt(2*H_eps))); kappa := -atanh(coth(delta)/(eps*y));
    nu := (K_eps - coth(delta)^2/eps^2)*eps/cosh(delta); X(0) = x; Y(0) = y; Z(0) = z
    within y: -9, -6
";

const TAU: &str = "
theorem3.e1.tau | Theorem 3, i = 1, tau | tau = 1/(2*eps*X(0))
theorem3.e2.tau | Theorem 3, i = 2, tau | tau = 1/(2*eps*X(0))
";

/// The values h = 2ε²H and g = 2ε²K by s = sn²(δ, k) and k2 = k², for the parameters δ and k.
const VALUES: &str = "
    c := 1 - s; d2 := 1 - k2*s;
    h := (1 - k2)*s/(2 - (1 + k2)*s); g := 1 - 2*c*d2/(c + d2)";
const OF_VALUES: &str = "
theorem3.e4.delta |
    Theorem 3, i = 4, addition: sn, cn, dn of delta and k from h = 2 eps^2 H(eps), g = 2 eps^2 K(eps) |
    s = (g + h)/(1 + h); c = (1 - g)/(1 + h); d2 = (1 - g)/(1 - h);
    k2 = (g - h)*(1 + h)/((g + h)*(1 - h))
";

/// Definitions for the claim that a solution passes through each point of a level set of H and K.
const POINT: &str = "
    h := 2*eps^2*x*y/(1 + eps^2*(x^2 + y^2)); g := eps^2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
    s := (g + h)/(1 + h); k2 := (g - h)*(1 + h)/((g + h)*(1 - h)); c := 1 - s; d2 := 1 - k2*s";
const OF_POINT: &str = "
theorem3.e4.kappa |
    Theorem 3, i = 4, addition: sn, cn, dn of kappa from the point: their squares belong together |
    eps^2*z^2/(k2*s) + eps^2*(x - y)^2*d2/(k2*s) = 1; eps^2*z^2/s + eps^2*(x + y)^2*c/s = 1
";

pub(super) fn claims() -> Vec<Claim> {
    [
        read(PARAMETERS_OF_STATE, solution_claim),
        read(THROUGH_BRANCHES, |id, place, statement| {
            let claim = claim(id, place, statement);
            let branch = BRANCHES.iter().find(|(solution, _)| solution.system == claim.system);
            claim.given_definitions(&branch.map_or_else(String::new, |(solution, _)| solution.definitions()))
        }),
        read(TAU, solution_claim),
        read(OF_VALUES, |id, place, statement| claim(id, place, statement).with_used_definitions(VALUES)),
        read(OF_POINT, |id, place, statement| claim(id, place, statement).with_used_definitions(POINT)),
    ]
    .concat()
}
