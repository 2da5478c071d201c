//! The eight systems of the benchmarks, and the protocol of the processes that time them
//! ([`serve`]). Each system's file holds only its `kahan!` block.

mod clebsch;
mod e1;
mod e3;
mod e5;
mod e6;
mod euler_top;
mod lorenz;
mod lotka_volterra;
pub mod serve;

pub use clebsch::Clebsch;
pub use e1::E1;
pub use e3::E3;
pub use e5::E5;
pub use e6::E6;
pub use euler_top::EulerTop;
pub use lorenz::Lorenz;
pub use lotka_volterra::LotkaVolterra;

/// Half the time step, ε, of all steps that are timed.
pub const EPS: f64 = 1.0 / 1000.0;

/// The text of a system. Its `kahan!` block is compiled by the macro, or read at run time.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// The name of the type that the block declares.
    pub name: &'static str,
    /// A Rust expression for a value of this type.
    pub value: &'static str,
    /// The number of variables.
    pub dimension: usize,
    /// The text of the file that holds the block.
    pub text: &'static str,
}

/// All systems as text.
pub const SOURCES: [Source; 8] = [
    Source {
        name: "LotkaVolterra",
        value: "LotkaVolterra",
        dimension: 2,
        text: include_str!("lotka_volterra.rs"),
    },
    Source {
        name: "EulerTop",
        value: "EulerTop { a1: 1.1, a2: -2.3, a3: 1.7 }",
        dimension: 3,
        text: include_str!("euler_top.rs"),
    },
    Source { name: "E1", value: "E1", dimension: 3, text: include_str!("e1.rs") },
    Source { name: "E3", value: "E3", dimension: 3, text: include_str!("e3.rs") },
    Source { name: "E5", value: "E5", dimension: 3, text: include_str!("e5.rs") },
    Source { name: "E6", value: "E6", dimension: 3, text: include_str!("e6.rs") },
    Source {
        name: "Lorenz",
        value: "Lorenz { sigma: 10.0, rho: 28.0, beta: 8.0 / 3.0 }",
        dimension: 3,
        text: include_str!("lorenz.rs"),
    },
    Source {
        name: "Clebsch",
        value: "Clebsch { w1: 1.0, w2: 1.7, w3: 2.9 }",
        dimension: 6,
        text: include_str!("clebsch.rs"),
    },
];

/// Returns the text between the braces of a file's `kahan!` block; `None` if there is no block.
pub fn block_of(file: &str) -> Option<&str> {
    let (_, block) = file.split_once("kahan! {")?;
    Some(block.split_once("\n}")?.0)
}

/// Returns the Euler top that is timed. Its orbits are bounded.
pub fn euler_top() -> EulerTop<f64> {
    EulerTop { a1: 1.1, a2: -2.3, a3: 1.7 }
}

/// Returns Lorenz's system with the classical chaotic parameters.
pub fn lorenz() -> Lorenz<f64> {
    Lorenz { sigma: 10.0, rho: 28.0, beta: 8.0 / 3.0 }
}

/// Returns Clebsch's system with three different weights.
pub fn clebsch() -> Clebsch<f64> {
    Clebsch { w1: 1.0, w2: 1.7, w3: 2.9 }
}

/// The initial states from which orbits are timed.
pub mod start {
    /// The initial state for [`LotkaVolterra`](crate::LotkaVolterra).
    pub const LOTKA_VOLTERRA: [f64; 2] = [1.5, 0.8];
    /// The initial state for systems of three variables.
    pub const SPACE: [f64; 3] = [1.3, 0.7, 0.4];
    /// The initial state for [`Lorenz`](crate::Lorenz), near the attractor.
    pub const LORENZ: [f64; 3] = [1.3, 0.7, 20.4];
    /// The initial state for [`Clebsch`](crate::Clebsch).
    pub const CLEBSCH: [f64; 6] = [0.3, 0.7, 0.4, 0.8, 0.5, 0.6];
}

#[cfg(test)]
mod tests {
    use kahan_core::prelude::*;

    /// Tests that the gradients of the flow's integrals are orthogonal to the field.
    #[test]
    fn clebsch_is_the_integrable_case() {
        let w = super::clebsch();
        for x in [[0.3, -0.7, 0.4, 0.8, 0.5, -0.6], [1.0, 2.0, -3.0, 0.5, 0.25, 4.0]] {
            let f = w.field(&SVector::from(x));
            let [k, l, m, p, q, r] = x;
            let gradients =
                [[0.0, 0.0, 0.0, p, q, r], [p, q, r, k, l, m], [k, l, m, w.w1 * p, w.w2 * q, w.w3 * r]];
            for gradient in gradients {
                assert!(SVector::from(gradient).dot(&f).abs() < 1e-13 * f.norm());
            }
        }
    }
}
