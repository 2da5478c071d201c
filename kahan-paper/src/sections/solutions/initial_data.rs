//! The parameters of each solution from a point: the solution with these parameters passes through
//! it.

use super::super::super::claim::Claim;
use super::super::super::section::Section;
use super::branches::BRANCHES;
use super::{SOLUTIONS, Solution};

/// A name with the fractions between which it lies.
type Interval = (&'static str, (i64, i64), (i64, i64));

/// The parameters as functions of (x, y, z), and where the point lies for a numerical test.
struct Parameters {
    solution: &'static Solution,
    id: &'static str,
    place: &'static str,
    parameters: &'static str,
    /// Intervals other than (1/5, 4/5).
    domain: &'static [Interval],
}

static PARAMETERS: [Parameters; 7] = [
    Parameters {
        solution: &SOLUTIONS[0],
        id: "",
        place: "",
        parameters: "tau := 1/(2*eps*x); beta := H_eps; gamma := K_eps",
        domain: &[],
    },
    Parameters {
        solution: &SOLUTIONS[1],
        id: "",
        place: "",
        parameters: "tau := 1/(2*eps*x); beta := H_eps; gamma := K_eps",
        domain: &[],
    },
    Parameters {
        solution: &SOLUTIONS[2],
        id: "",
        place: ", |eps z| < 1",
        parameters: "theta := atan2(y, x); delta := atanh(eps*sqrt(2*K_eps));
        kappa := atanh(eps*z/tanh(delta))",
        domain: &[],
    },
    Parameters {
        solution: &SOLUTIONS[3],
        id: "",
        place: ", x y > 0, |eps z| < 1",
        parameters: "
            h := 2*eps^2*H_eps; g := 2*eps^2*K_eps;
            sn_delta := sqrt((g + h)/(1 + h)); cn_delta := sqrt((1 - g)/(1 + h));
            dn_delta := sqrt((1 - g)/(1 - h));
            k := sqrt((g - h)*(1 + h)/((g + h)*(1 - h)));
            delta := F(atan2(sn_delta, cn_delta), k);
            kappa := F(atan2(eps*z/(k*sn_delta), eps*(x - y)*dn_delta/(k*sn_delta)), k)",
        domain: &[],
    },
    Parameters {
        solution: &SOLUTIONS[4],
        id: "",
        place: ", |eps y| < 1",
        parameters: "
            delta := atanh(eps*sqrt(2*H_eps)); kappa := -atanh(eps*y/tanh(delta));
            mu := (K_eps - tanh(delta)^2/eps^2)*eps/sinh(delta)",
        domain: &[],
    },
    Parameters {
        solution: &BRANCHES[0].0,
        id: "branch.",
        place: ", eps z > 1",
        parameters: "
            theta := atan2(y, x); delta := atanh(1/(eps*sqrt(2*K_eps))); kappa := atanh(coth(delta)/(eps*z))",
        domain: &[("z", (6, 1), (9, 1))],
    },
    Parameters {
        solution: &BRANCHES[1].0,
        id: "branch.",
        place: ", eps y < -1",
        parameters: "
            delta := atanh(1/(eps*sqrt(2*H_eps))); kappa := -atanh(coth(delta)/(eps*y));
            nu := (K_eps - coth(delta)^2/eps^2)*eps/cosh(delta)",
        domain: &[("y", (-9, 1), (-6, 1))],
    },
];

/// The claims.
pub(super) fn claims() -> Vec<Claim> {
    let through = PARAMETERS.iter().map(|row| {
        let Parameters { solution, id, place, parameters, domain } = row;
        let system = solution.system;
        let source =
            format!("Theorem 3, i = {}, addition: the parameters from initial data{place}", &system[1..]);
        let id = ["theorem3", system, &format!("{id}through")];
        let claim = Claim::new(
            Section::MapSolutions,
            id,
            system,
            source,
            format!("{parameters}; X(0) = x; Y(0) = y; Z(0) = z"),
        )
        .given(&solution.definitions());
        domain.iter().fold(claim, |claim, (name, low, high)| claim.within(name, *low, *high))
    });
    through.chain(tau()).chain(elliptic()).collect()
}

/// τ of dE1 and dE2.
fn tau() -> impl Iterator<Item = Claim> {
    SOLUTIONS[..2].iter().map(|solution| {
        let system = solution.system;
        let source = format!("Theorem 3, i = {}, tau", &system[1..]);
        Claim::new(Section::MapSolutions, ["theorem3", system, "tau"], system, source, "tau = 1/(2*eps*X(0))")
            .given(&solution.definitions())
    })
}

/// What lies behind the parameters of dE4: with sn²δ = s the values of H and K determine s and k²,
/// and every point of their level set is one of the orbit's curve.
fn elliptic() -> Vec<Claim> {
    let claim = |id: &str, place: &str, statement: &str, given: &str| {
        Claim::new(
            Section::MapSolutions,
            ["theorem3", "e4", id],
            "e4",
            format!("Theorem 3, i = 4, addition: {place}"),
            statement,
        )
        .spelling(given)
    };
    let values = "
        c := 1 - s; d2 := 1 - k2*s;
        h := (1 - k2)*s/(2 - (1 + k2)*s); g := 1 - 2*c*d2/(c + d2)";
    let point = "
        h := 2*eps^2*x*y/(1 + eps^2*(x^2 + y^2)); g := eps^2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
        s := (g + h)/(1 + h); k2 := (g - h)*(1 + h)/((g + h)*(1 - h)); c := 1 - s; d2 := 1 - k2*s";
    vec![
        claim(
            "delta",
            "sn, cn, dn of delta and k from h = 2 eps^2 H(eps), g = 2 eps^2 K(eps)",
            "s = (g + h)/(1 + h); c = (1 - g)/(1 + h); d2 = (1 - g)/(1 - h);
            k2 = (g - h)*(1 + h)/((g + h)*(1 - h))",
            values,
        ),
        claim(
            "kappa",
            "sn, cn, dn of kappa from the point: their squares belong together",
            "eps^2*z^2/(k2*s) + eps^2*(x - y)^2*d2/(k2*s) = 1; eps^2*z^2/s + eps^2*(x + y)^2*c/s = 1",
            point,
        ),
    ]
}
