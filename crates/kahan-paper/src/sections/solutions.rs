//! Claims of Theorem 3, on the solutions of the maps dE1 to dE6 and of the Euler top.

mod branches;
mod initial_data;

use kahan_systems::registry::find;

use super::super::claim::Claim;
use super::super::section::Section;
use super::structures::structure;
use super::text::read;

/// A solution of a map. One step of the map increases n by 1.
pub(super) struct Solution {
    system: &'static str,
    /// Definitions of abbreviations that the solution uses.
    given: &'static str,
    components: [&'static str; 3],
    /// The values of the integrals H(ε) and K(ε) on the solution.
    values: [&'static str; 2],
}

static SOLUTIONS: [Solution; 5] = [
    Solution {
        system: "e1",
        given: "N(n) := n + tau;",
        components: [
            "1/(2*eps*N(n))",
            "beta/(2*eps*N(n))",
            "2*gamma*eps*N(n) - (beta^2/eps + gamma*eps)/(2*N(n))",
        ],
        values: ["beta", "gamma"],
    },
    Solution {
        system: "e2",
        given: "N(n) := n + tau;",
        components: [
            "1/(2*eps*N(n))",
            "2*beta*eps*(N(n) - 1/(4*N(n)))",
            "eps*(2*N(n) - 1/(2*N(n)))*(gamma - beta^2*eps^2*(4*N(n)^2 - 1))",
        ],
        values: ["beta", "gamma"],
    },
    Solution {
        system: "e3",
        given: "T(n) := 2*delta*n + kappa;",
        components: [
            "cos(theta)*sinh(delta)/(eps*cosh(T(n)))",
            "sin(theta)*sinh(delta)/(eps*cosh(T(n)))",
            "tanh(delta)*tanh(T(n))/eps",
        ],
        values: ["tan(theta)", "tanh(delta)^2/(2*eps^2)"],
    },
    Solution {
        system: "e4",
        given: "v(n) := 2*delta*n + kappa;",
        components: [
            "sn(delta, k)/(2*eps)*(dn(v(n), k)/cn(delta, k) + k*cn(v(n), k)/dn(delta, k))",
            "sn(delta, k)/(2*eps)*(dn(v(n), k)/cn(delta, k) - k*cn(v(n), k)/dn(delta, k))",
            "k*sn(delta, k)*sn(v(n), k)/eps",
        ],
        values: [
            "(1 - k^2)*sn(delta, k)^2/(2*eps^2*(2 - (1 + k^2)*sn(delta, k)^2))",
            "1/eps^2*(1/2 - cn(delta, k)^2*dn(delta, k)^2/(cn(delta, k)^2 + dn(delta, k)^2))",
        ],
    },
    Solution {
        system: "e5",
        given: "T(n) := 2*delta*n + kappa;",
        components: [
            "sinh(delta)/(eps*cosh(T(n)))",
            "-tanh(delta)*tanh(T(n))/eps",
            "mu*cosh(T(n)) + (1/eps + mu*sinh(delta))*sinh(delta)/cosh(T(n))",
        ],
        values: ["tanh(delta)^2/(2*eps^2)", "mu*sinh(delta)/eps + tanh(delta)^2/eps^2"],
    },
];

const STATES: [&str; 3] = ["x", "y", "z"];
const FUNCTIONS: [&str; 3] = ["X", "Y", "Z"];

pub(super) fn claims() -> Vec<Claim> {
    let theorem = SOLUTIONS.iter().flat_map(|solution| solution.claims("", "", ["", "", ""]));
    [
        theorem.collect(),
        read(PROOF_CLAIMS, solution_claim),
        read(SYMMETRIES, claim),
        branches::claims(),
        initial_data::claims(),
        read(OTHER_TOPS, |id, place, statement| claim(id, place, statement).with_used_definitions(ELLIPTIC)),
    ]
    .concat()
}

impl Solution {
    fn definitions(&self) -> String {
        let components = FUNCTIONS.iter().zip(self.components);
        let components: String = components.map(|(name, value)| format!("{name}(n) := {value}; ")).collect();
        let integrals = structure(self.system).map_or("", |row| row.definitions);
        format!("{}{components}{integrals}", self.given)
    }

    /// Makes the claims that each component solves its equation, and that the integrals have the
    /// stated values. A sign `-` gives a component the additional factor (−1)ⁿ.
    fn claims(&self, id: &str, place: &str, signs: [&str; 3]) -> Vec<Claim> {
        let system = self.system;
        let claim = |cell: &str, statement: String| {
            let source = format!("Theorem 3, i = {}, {cell}{place}", &system[1..]);
            Claim::new(
                Section::MapSolutions,
                ["theorem3", system, &format!("{id}{cell}")],
                system,
                source,
                statement,
            )
            .given_definitions(&self.definitions())
        };
        let steps = (0..3).map(|i| {
            let (state, name, value, sign) = (STATES[i], FUNCTIONS[i], self.components[i], signs[i]);
            let step =
                format!("{name}(n) := {value}; on(next({state}), X(n), Y(n), Z(n)) = {sign}{name}(n + 1)");
            if signs == [""; 3] {
                return claim(state, step);
            }
            // `step` is the claim for even n. The claim for odd n has (−1)ⁿ = −1 and (−1)ⁿ⁺¹ = 1.
            let [x, y, z] = [0, 1, 2].map(|j| format!("{}{}(n)", signs[j], FUNCTIONS[j]));
            claim(state, format!("{step}; on(next({state}), {x}, {y}, {z}) = {name}(n + 1)"))
        });
        let integrals = ["H", "K"]
            .iter()
            .zip(self.values)
            .map(|(name, value)| claim(name, format!("on({name}_eps, X(n), Y(n), Z(n)) = {value}")));
        steps.chain(integrals).collect()
    }
}

/// Further claims that the proof of the theorem makes.
const PROOF_CLAIMS: &str = "
theorem3.e3.proof.K | Theorem 3, proof, i = 3, value of K(eps) |
    delta := log(u); on(K_eps, X(n), Y(n), Z(n)) = tanh(delta)^2/(2*eps^2);
    on(H_eps, X(n), Y(n), Z(n)) = tan(theta)
    within u: 2, 4
    misprint A4: on(K_eps, X(n), Y(n), Z(n)) = sinh(delta)^2/(2*eps^2)
    refuted: eps := 1; u := 3; kappa := 0; theta := 0; n := 0;
        X(n) = 4/3; Y(n) = 0; Z(n) = 0; on(K_eps, 4/3, 0, 0) = 8/25; sinh(delta)^2/(2*eps^2) = 8/9
";
const SYMMETRIES: &str = "
theorem3.e4.symmetries | Theorem 3, i = 4, addition: the symmetries (x,y,z) -> (x,-y,z) and (y,x,-z) |
    on(next(x), x, -y, z) = next(x); on(next(y), x, -y, z) = -next(y); on(next(z), x, -y, z) = next(z);
    on(next(x), y, x, -z) = next(y); on(next(y), y, x, -z) = next(x); on(next(z), y, x, -z) = -next(z)
";

/// Functions on an orbit of dE4 that solve the map of an Euler top.
const ELLIPTIC: &str = "
    v(n) := 2*delta*n + kappa;
    p(n) := k*sn(delta, k)*cn(v(n), k)/(eps*dn(delta, k));
    q(n) := sn(delta, k)*dn(v(n), k)/(eps*cn(delta, k));
    r(n) := k*sn(delta, k)*sn(v(n), k)/eps";

/// The solutions of dE6 and of the map of the Euler top in terms of dE4's solution.
const OTHER_TOPS: &str = "
theorem3.euler.scaling |
    Theorem 3, addition: the Euler top with alpha1 alpha2 > 0 > alpha1 alpha3 is dE4 |
    step(w) := at(on(next(w), s1*(x - y), s2*(x + y), s3*z),
        a1, -s1/(s2*s3), a2, -s2/(s3*s1), a3, s3/(s1*s2));
    step(x) = s1*next(e4, x - y); step(y) = s2*next(e4, x + y); step(z) = s3*next(e4, z)
theorem3.euler.solution | Theorem 3, addition: the Euler top with alpha1 alpha2 > 0 > alpha1 alpha3 |
    X(n) := s1*p(n); Y(n) := s2*q(n); Z(n) := s3*r(n);
    step(w) := at(on(next(w), X(n), Y(n), Z(n)), a1, -s1/(s2*s3), a2, -s2/(s3*s1), a3, s3/(s1*s2));
    step(x) = X(n + 1); step(y) = Y(n + 1); step(z) = Z(n + 1)
theorem3.e6.change |
    Theorem 3, addition: dE6 is dE4 with eps -> -eps after a swap of two axes and a scaling |
    x4 := sqrt(3)/2*(x - z + y); y4 := sqrt(3)/2*(y - x + z); z4 := x + z;
    step(w) := at(on(e4, next(w), x4, y4, z4), eps, -eps);
    step(x) = next(x4); step(y) = next(y4); step(z) = next(z4)
theorem3.e6.solution | Theorem 3, addition: the solution of dE6 |
    X(n) := (r(n) + p(n)/sqrt(3))/2; Y(n) := q(n)/sqrt(3); Z(n) := (r(n) - p(n)/sqrt(3))/2;
    step(w) := on(at(next(w), eps, -eps), X(n), Y(n), Z(n));
    step(x) = X(n + 1); step(y) = Y(n + 1); step(z) = Z(n + 1)
";

fn claim(id: &str, place: &str, statement: &str) -> Claim {
    let system = id.split('.').find_map(find).expect("a system in the name").command;
    Claim::new(Section::MapSolutions, [id], system, place, statement)
}

/// Makes a claim whose statement may use the solution.
fn solution_claim(id: &str, place: &str, statement: &str) -> Claim {
    let claim = claim(id, place, statement);
    let solution = SOLUTIONS.iter().find(|solution| solution.system == claim.system);
    claim.given_definitions(&solution.map_or_else(String::new, Solution::definitions))
}
