//! Test fields: the catalog, some fields known to be hard, and random sparse fields.

use kahan_algebra::prime_field::SplitMix64;
use kahan_systems::registry::SYSTEMS;

/// Fields of five or six variables whose steps lose digits.
const HARD: [(&str, &str); 6] = [
    (
        "three waves",
        "adot = -b*z - y*c; xdot = b*c - y*z; bdot = x*c - a*z; ydot = -a*c - x*z; cdot = x*b - a*y;
         zdot = -a*b - x*y;",
    ),
    (
        "clebsch",
        "struct S { u, v, w } adot = (w - v)*y*z; bdot = (u - w)*z*x; cdot = (v - u)*x*y;
         xdot = y*c - z*b; ydot = z*a - x*c; zdot = x*b - y*a;",
    ),
    (
        "kirchhoff",
        "adot = 3*b*c + 2*y*z; bdot = -5*c*a - 7*z*x; cdot = 2*a*b + 5*x*y; xdot = 2*y*c - 3*z*b;
         ydot = 5*z*a - 2*x*c; zdot = 3*x*b - 5*y*a;",
    ),
    (
        "two euler tops",
        "struct S { p, q, r } adot = p*b*c; bdot = q*c*a; cdot = r*a*b; xdot = p*y*z; ydot = q*z*x; zdot = r*x*y;",
    ),
    (
        "volterra lattice, 6",
        "adot = a*(b - f); bdot = b*(c - a); cdot = c*(d - b); ddot = d*(e - c); edot = e*(f - d);
         fdot = f*(a - e);",
    ),
    ("five variables", "xdot = y*z + u*v; ydot = x*z - u^2; zdot = x*y; udot = v*x - y*u; vdot = u*y - z*v;"),
];

const STATES: [&str; 6] = ["x", "y", "z", "u", "v", "w"];

pub(crate) type Named = (String, String);

pub(crate) fn known() -> Vec<Named> {
    let catalog = SYSTEMS.iter().map(|entry| (entry.command.to_owned(), entry.text().to_owned()));
    catalog.chain(HARD.map(|(name, text)| (name.to_owned(), text.to_owned()))).collect()
}

/// Draws a field with one or two quadratic terms in each equation, and sometimes linear terms.
pub(crate) fn sparse(dimension: usize, seed: u64) -> Named {
    let name = format!("random field {seed} of {dimension} variables");
    let mut random = SplitMix64::from_bytes(name.as_bytes());
    let states = &STATES[..dimension];
    let state = |random: &mut SplitMix64| states[random.below(dimension as u64) as usize];
    let mut text = String::new();
    for variable in states {
        let mut terms = Vec::new();
        for _ in 0..=random.below(2) {
            let sign = ["", "-"][random.below(2) as usize];
            terms.push(format!(
                "({sign}{})*{}*{}",
                random.below(9) + 1,
                state(&mut random),
                state(&mut random)
            ));
        }
        if seed % 3 == 2 && random.below(2) == 0 {
            terms.push(format!("{}*{}", random.below(9) + 1, state(&mut random)));
        }
        text += &format!("{variable}dot = {};\n", terms.join(" + "));
    }
    (name, text)
}
