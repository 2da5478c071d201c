//! Invariant Poisson brackets from an invariant density and integrals, in any dimension.
//!
//! **Proposition** (Hone and Petrera, section 4). Let a map φ of Rⁿ preserve the measure ρ dx₁∧…∧dxₙ and n−2 independent
//! functions I₁ … Iₙ₋₂. Then φ preserves the Poisson bracket
//!
//! ```text
//! {F,G} ρ dx₁∧…∧dxₙ = dF∧dG∧dI₁∧…∧dIₙ₋₂,
//! P_jk = {x_j,x_k} = (1/ρ) Σ ε(j,k,l₁,…,lₙ₋₂) ∂I₁/∂x_l₁ … ∂Iₙ₋₂/∂x_lₙ₋₂,
//! ```
//!
//! whose Casimirs are the I's. So P_jk, j < k counted from 1, is (−1)^(j+k−1)/ρ times the minor of the Jacobian matrix
//! ∂I/∂x without the columns j and k. This is the **sign convention** here: for n = 2, {x,y} = 1/ρ; for n = 3,
//! ({x,y}, {y,z}, {z,x}) = (1/ρ)(I_z, I_x, I_y).
//!
//! ρ and −ρ are invariant together, and so are ρ and ρF for any integral F. A bracket of a table may therefore differ from
//! that of its ρ by a factor which is a function of integrals; it is the bracket of another density. With ρ = c/(HK) and the
//! integrals Ĥ, K̂ of a system E1 to E6, Theorem 2's P(ε) belongs to −ρĤK̂ and Ĥ, its Q(ε)/c to ρĤK̂ and K̂.
//!
//! In come reduced rational functions ([`claim_functions`] makes them of claims); out comes a [`PoissonTensor`] of reduced
//! rational functions, or the [`PoissonError`] that says what is wrong with them. All work is charged to a
//! [`Budget`], so nothing hangs. Whether ρ and the I's are invariant is not asked: the prover decides it,
//! on them or on the tensor's own [claim](PoissonTensor::claim).

mod claims;
mod construct;
mod error;
mod expression;
mod reduced;
mod tensor;

pub use claims::claim_functions;
pub use construct::invariant_bracket;
pub use error::PoissonError;
pub use tensor::PoissonTensor;

use crate::poly::Budget;

/// A budget that suffices for every bracket of the catalog many times over, and ends after a few seconds unoptimised.
#[must_use]
pub fn default_budget() -> Budget {
    Budget::new(20_000, 5_000_000)
}
