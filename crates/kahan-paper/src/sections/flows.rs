//! Claims of Table 5, on the solutions of the flows.

use kahan_systems::registry::find;

use super::super::claim::Claim;
use super::super::section::Section;
use super::structures::structure;
use super::text::read;

/// A row of Table 5, with formulas in T = t + α for a constant α.
struct Row {
    system: &'static str,
    solution: [&'static str; 3],
    values: [&'static str; 2],
}

const ROWS: [Row; 7] = [
    Row { system: "e1", solution: ["1/T", "beta/T", "gamma*T - beta^2/T"], values: ["beta", "gamma"] },
    Row { system: "e2", solution: ["1/T", "beta*T", "T*(gamma - beta^2*T^2)"], values: ["beta", "gamma"] },
    Row {
        system: "e3",
        solution: [
            "lambda*cos(theta)*sech(lambda*T)",
            "lambda*sin(theta)*sech(lambda*T)",
            "lambda*tanh(lambda*T)",
        ],
        values: ["tan(theta)", "lambda^2/2"],
    },
    Row {
        system: "e4",
        solution: [
            "lambda/2*(dn(lambda*T, k) + k*cn(lambda*T, k))",
            "lambda/2*(dn(lambda*T, k) - k*cn(lambda*T, k))",
            "k*lambda*sn(lambda*T, k)",
        ],
        values: ["lambda^2*(1 - k^2)/4", "lambda^2*(1 + k^2)/4"],
    },
    Row {
        system: "e5",
        solution: [
            "lambda*sech(lambda*T)",
            "-lambda*tanh(lambda*T)",
            "mu*cosh(lambda*T) + lambda*sech(lambda*T)",
        ],
        values: ["lambda^2/2", "lambda*(mu + lambda)"],
    },
    Row {
        system: "e7",
        solution: ["1/T", "beta*T^(-xi)", "T*(gamma - beta^2*T^(-2*xi))"],
        values: ["beta", "gamma"],
    },
    Row {
        system: "e8",
        solution: ["1/T", "(beta - log(T))/T", "gamma*T - (beta - log(T))^2/T"],
        values: ["exp(-beta)", "gamma"],
    },
];

const STATES: [&str; 3] = ["x", "y", "z"];

pub(super) fn claims() -> Vec<Claim> {
    ROWS.iter().flat_map(row).chain(other_tops()).collect()
}

fn row(row: &Row) -> Vec<Claim> {
    let Row { system, solution, values } = row;
    let orbit: String =
        STATES.iter().zip(solution).map(|(state, value)| format!("{state} := {value}; ")).collect();
    let claim = |cell: &str, statement: String| {
        let source = format!("Table 5, i = {}, {cell}", &system[1..]);
        Claim::new(Section::FlowSolutions, ["table5", system, cell], system, source, statement)
            .given_definitions(&orbit)
    };
    let table1 = |name| structure(system).and_then(|row| row.value(name)).expect("the tables have it");
    let components = (0..3).map(|i| {
        let state = STATES[i];
        claim(state, format!("{state} := {}; d({state}, T) = f{}", solution[i], i + 1))
    });
    let integrals = ["H", "K"].into_iter().zip(values);
    let integrals =
        integrals.map(|(name, value)| claim(name, format!("{name} := {}; {name} = {value}", table1(name))));
    components.chain(integrals).collect()
}

/// The solutions of E6 and of the Euler top in terms of E4's solution.
const OTHER_TOPS: &str = "
table5.e6.solution | Table 5, addition: E6 is E4 with the time reversed, by two Euler tops |
    x := (p/sqrt(3) + r)/2; y := q/sqrt(3); z := (r - p/sqrt(3))/2;
    d(x, T) = -f1; d(y, T) = -f2; d(z, T) = -f3
table5.euler.solution | Table 5, addition: the Euler top with alpha1 alpha2 > 0 > alpha1 alpha3 |
    x := s1*p; y := s2*q; z := s3*r;
    a1 := -s1/(s2*s3); a2 := -s2/(s3*s1); a3 := s3/(s1*s2);
    d(x, T) = f1; d(y, T) = f2; d(z, T) = f3
";

fn other_tops() -> Vec<Claim> {
    read(OTHER_TOPS, |id, place, statement| {
        let system = id.split('.').find_map(find).expect("a system in the name").command;
        Claim::new(Section::FlowSolutions, [id], system, place, statement).with_used_definitions(
            "p := lambda*k*cn(lambda*T, k); q := lambda*dn(lambda*T, k); r := lambda*k*sn(lambda*T, k)",
        )
    })
}
