//! Compositions: steps made of Kahan steps, for a higher order. `KAHAN` is a single Kahan step.
//!
//! The inverse of a Kahan step φ_ε is φ₋ε. Therefore a composition φ_{γ₁ε} ∘ … ∘ φ_{γₛε} with
//! symmetric coefficients γᵢ of sum 1 is symmetric, too, and has an even order. The order is p if
//! the [`coefficients`] satisfy the order conditions up to p.

mod coefficients;
mod composed;
mod decimal;
mod stages;

use core::fmt;

use crate::{Constant, StepCost};

pub use composed::Composed;
pub(crate) use stages::Staged;

/// A symmetric composition of s Kahan steps, with coefficients γ₁, …, γₛ and γᵢ = γₛ₊₁₋ᵢ. A
/// composed step at ε runs Kahan steps at γ₁ε, …, γₛε in this order.
///
/// # Properties that a composition keeps
/// - **Reversibility**: the inverse of a composition is the composition with −ε.
/// - **Affine equivariance** and **linear integrals**, as for Kahan's map.
/// - **Integrals and invariant measures that do not depend on ε**: in the catalog
///   `kahan-systems`, the systems E1 and E3 have the integral y/x. E2, E4, E5, E6 and the Euler top
///   have integrals H and K that depend on ε. Independent of ε are H/K and, for the Euler top,
///   (1 − H)/(1 − 1/K).
///
/// # Properties that a composition loses
/// - **Integrals and measures that depend on ε**: the composition conserves none of these. In a
///   method of order p, the integrals H and K of E2, E4, E5, E6 and the Euler top oscillate by
///   O(εᵖ) around the flow's integral, without drift.
/// - **Exactness**: the coefficients are irrational, so a composition exists only over floats.
/// - **Short binary ε** ([`nearest_short_eps`](crate::nearest_short_eps)): the products γᵢε are
///   rounded.
///
/// # Cost
/// A composed step costs s Kahan steps, of which (s + 1)/2 are distinct and prepared once. A
/// smaller sum Σ|γᵢ| means a smaller error. Some γᵢ are negative. Hence a composition also steps
/// back, and may meet a pole that the plain step avoids.
///
/// | constant | order | stages | Σ\|γ\| |
/// |---|---|---|---|
/// | [`KAHAN`](Self::KAHAN) | 2 | 1 | 1 |
/// | [`TRIPLE_JUMP`](Self::TRIPLE_JUMP) | 4 | 3 | 4.40 |
/// | [`SUZUKI_4`](Self::SUZUKI_4) | 4 | 5 | 2.32 |
/// | [`KAHAN_LI_6`](Self::KAHAN_LI_6) | 6 | 9 | 3.82 |
/// | [`SUZUKI_UMENO_8`](Self::SUZUKI_UMENO_8) | 8 | 15 | 6.53 |
/// | [`KAHAN_LI_8`](Self::KAHAN_LI_8) | 8 | 17 | 5.35 |
#[derive(Clone, Copy)]
pub struct Composition {
    name: &'static str,
    order: u32,
    /// The coefficients γ₁, …, γ_{(s+1)/2} of s stages, up to the middle coefficient.
    first_half: &'static [Constant<'static>],
}

impl Composition {
    /// Kahan's map itself, of order 2 with one stage.
    pub const KAHAN: Self = Self::new("KAHAN", 2, coefficients::KAHAN);

    /// Order 4 with 3 stages, the minimum: γ₁ = 1/(2 − 2^{1/3}), and Σ|γ| = 4.40.
    /// [`SUZUKI_4`](Self::SUZUKI_4) is more accurate for its cost.
    ///
    /// M. Creutz, A. Gocksch, Phys. Rev. Lett. 63 (1989) 9; E. Forest, R. D. Ruth, Physica D 43
    /// (1990) 105; H. Yoshida, Phys. Lett. A 150 (1990) 262.
    pub const TRIPLE_JUMP: Self = Self::new("TRIPLE_JUMP", 4, coefficients::TRIPLE_JUMP);

    /// Order 4 with 5 stages, recommended at order 4: γ₁ = γ₂ = 1/(4 − 4^{1/3}), and Σ|γ| = 2.32.
    /// M. Suzuki, Phys. Lett. A 146 (1990) 319.
    pub const SUZUKI_4: Self = Self::new("SUZUKI_4", 4, coefficients::SUZUKI_4);

    /// Order 6 with 9 stages, Σ|γ| = 3.82, known as s9odr6a. W. Kahan, R.-C. Li, Math. Comp. 66
    /// (1997) 1089.
    pub const KAHAN_LI_6: Self = Self::new("KAHAN_LI_6", 6, coefficients::KAHAN_LI_6);

    /// Order 8 with 15 stages, the minimum, and Σ|γ| = 6.53. [`KAHAN_LI_8`](Self::KAHAN_LI_8) is
    /// more accurate for its cost.
    ///
    /// M. Suzuki, K. Umeno, in Computer Simulation Studies in Condensed-Matter Physics VI (1993)
    /// 74; R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151.
    pub const SUZUKI_UMENO_8: Self = Self::new("SUZUKI_UMENO_8", 8, coefficients::SUZUKI_UMENO_8);

    /// Order 8 with 17 stages, Σ|γ| = 5.35, known as s17odr8a and recommended at order 8. W. Kahan,
    /// R.-C. Li, Math. Comp. 66 (1997) 1089.
    pub const KAHAN_LI_8: Self = Self::new("KAHAN_LI_8", 8, coefficients::KAHAN_LI_8);

    /// All compositions, sorted by order and then by number of stages.
    pub const ALL: [Self; 6] = [
        Self::KAHAN,
        Self::TRIPLE_JUMP,
        Self::SUZUKI_4,
        Self::KAHAN_LI_6,
        Self::SUZUKI_UMENO_8,
        Self::KAHAN_LI_8,
    ];

    const fn new(name: &'static str, order: u32, first_half: &'static [Constant<'static>]) -> Self {
        assert!(!first_half.is_empty() && first_half.len() <= composed::MOST);
        Self { name, order, first_half }
    }

    /// The best composition of each order: others cost more for an equal error.
    pub const BEST: [Self; 4] = [Self::KAHAN, Self::SUZUKI_4, Self::KAHAN_LI_6, Self::KAHAN_LI_8];

    /// Returns the composition of this order in [`BEST`](Self::BEST), if there is one.
    pub fn of_order(order: u32) -> Option<Self> {
        Self::BEST.into_iter().find(|best| best.order == order)
    }

    /// Returns the name of the composition's constant, as written in Rust.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the order p. A step has an error O(εᵖ⁺¹), and an orbit at a fixed time O(εᵖ).
    pub const fn order(&self) -> u32 {
        self.order
    }

    /// Returns the number s of stages, the Kahan steps in a composed step.
    pub const fn stages(&self) -> usize {
        2 * self.first_half.len() - 1
    }

    /// Iterates over the coefficients γ₁, …, γₛ, exact decimals with 40 digits and the exact sum 1.
    pub fn coefficients(
        &self,
    ) -> impl DoubleEndedIterator<Item = &'static Constant<'static>> + ExactSizeIterator {
        let (half, last) = (self.first_half, self.stages() - 1);
        (0..self.stages()).map(move |k| &half[k.min(last - k)])
    }

    /// Returns the cost of a composed step, computed from the cost of one stage.
    pub const fn cost(&self, stage: StepCost) -> StepCost {
        let stages = self.stages() as u32;
        StepCost {
            operations: stages * stage.operations,
            divisions: stages * stage.divisions,
            critical_path: stages * stage.critical_path,
        }
    }
}

impl PartialEq for Composition {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Composition {}

impl fmt::Debug for Composition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Composition::{}", self.name)
    }
}
