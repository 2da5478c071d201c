//! Compares the results of `step` and `try_step` near a pole.
//!
//! The map of ẋ = x² is x̃ = x/(1 − 2εx). For x = 5 and the float nearest to 0.1 as ε, the
//! denominator is −2⁻⁵⁴, which `step` rounds to 0. `try_step` returns a value with a relative error
//! of at most 64 rounding units, or an `Err` that states the reason.

use kahan_core::prelude::*;

kahan! {
    /// The solution x(t) = x₀/(1 − x₀ t) becomes infinite at t = 1/x₀.
    struct BlowUp;
    xdot = x^2;
}

/// Prints and returns the results of `step` and `try_step` at several ε.
pub(crate) fn run() -> Vec<(f64, Result<f64, SingularStep>)> {
    let x = vector![5.0];
    let cases = [(0.05, x), (0.09, x), (0.099_999_999, x), (0.1, x), (0.12, x), (0.125, vector![4.0])];
    let mut answers = Vec::new();
    for (eps, x) in cases {
        let (fast, checked) = (BlowUp.step(&x, eps)[0], BlowUp.try_step(&x, eps).map(|next| next[0]));
        println!("x = {}, eps = {eps:<11}   step {fast:<22}   try_step {checked:?}", x[0]);
        if let Err(why) = &checked {
            println!("    {why}");
        }
        answers.push((fast, checked));
    }
    answers
}

fn main() {
    run();
}
