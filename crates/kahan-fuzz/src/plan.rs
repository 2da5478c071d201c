//! Plans of sweeps.

use kahan_sweep::Plan;

use crate::words::text;

const WORDS: &[&str] = &[
    "\n",
    " ",
    " = ",
    ", ",
    "{ ",
    " }",
    "[",
    "]",
    "\"",
    "\"",
    "'",
    "#",
    "-",
    ".",
    "e",
    "0",
    "1",
    "2",
    "3",
    "7",
    "9",
    "0.1",
    "1/3",
    "1e300",
    "1e-5",
    "9223372036854775807",
    "\n[system]\n",
    "\n[system.params]\n",
    "\n[axes]\n",
    "\n[task]\n",
    "\n[output]\n",
    "name = \"e6\"",
    "name = \"henon-heiles\"",
    "name = \"volterra\"",
    "field = \"xdot = y; ydot = -a*x*y;\"",
    "field = \"for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }\"",
    "sites = ",
    "seed = ",
    "draws = ",
    "eps = ",
    "x = ",
    "y = ",
    "a = ",
    "b = ",
    "from = ",
    "to = ",
    "points = ",
    "step = ",
    "draw = \"sobol\"",
    "draw = \"uniform\"",
    "low = ",
    "high = ",
    "kind = \"orbit\"",
    "kind = \"heights\"",
    "kind = \"discover\"",
    "steps = ",
    "order = ",
    "scalar = ",
    "\"f64\"",
    "\"f32\"",
    "observe = ",
    "\"sali\"",
    "\"drift\"",
    "\"final\"",
    "\"spectrum\"",
    "\"escape\"",
    "\"rotation\"",
    "every = ",
    "escape = ",
    "digits = ",
    "degree = ",
    "rows_per_part = ",
    "columns = ",
    "\"x\"",
    "\"eps\"",
    "x = 1\neps = 0.1\n",
    "y = { from = 0, to = 1, points = 3 }\n",
    "q = [1, \"1/2\"]\n",
    "kind = \"orbit\"\nsteps = 3\n",
];

/// Reads a plan; one without mistakes has points.
pub fn read_plan(bytes: &[u8]) {
    let Some(text) = text(bytes, WORDS) else { return };
    match Plan::read(&text, "plan.toml") {
        Ok(plan) => {
            assert!(plan.points() >= 1 && plan.parts() >= 1, "{}", plan.canonical());
            assert_eq!(plan.hash().len(), 64);
        }
        Err(mistakes) => assert!(!mistakes.is_empty()),
    }
}
