//! Computes both sides of each identity in a claim, which is true if the two sides are equal.
//!
//! Let Â be the matrix A = I − ε f′ with each row multiplied by the denominator of its equation.
//! Since J = ∂x̃/∂x is Â(x,ε)⁻¹ Â(x̃,−ε), the invariance J P(x) Jᵀ = P(x̃) has the sides below.
//!
//! | claim | left | right |
//! |---|---|---|
//! | integral F | F(x̃) | F(x) |
//! | drift F by G | F(x̃) | G(F(x)) |
//! | density ρ | ρ(x̃) det ∂x̃/∂x | ρ(x) |
//! | bracket P, invariance | Â(x̃,−ε) P(x) Â(x̃,−ε)ᵀ | Â(x,ε) P(x̃) Â(x,ε)ᵀ |
//! | bracket P, Jacobi | Σ Pᵢₗ ∂ₗPⱼₖ over the cyclic permutations of i, j, k | 0 |

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::ClaimKind;

use crate::arithmetic::{Arithmetic, Dual, DualNumber, OverRationals};
use crate::system::{Claim, upper_index};

use super::sample::{Sample, run};

/// The two sides of an identity, which must be equal.
pub(super) struct Sides<V> {
    pub(super) place: Identity,
    pub(super) left: V,
    pub(super) right: V,
}

/// An identity that a claim asserts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Identity {
    /// The only identity of an integral, a drift or a density.
    Value,
    /// The invariance of the entry {i, j} of a bracket.
    Entry(usize, usize),
    /// The Jacobi identity of a bracket for the states i, j, k.
    Jacobi(usize, usize, usize),
}

pub(super) struct SampledClaim<'a, A: Arithmetic> {
    pub(super) claim: &'a Claim,
    pub(super) arithmetic: &'a A,
    pub(super) sample: &'a Sample<A::Value>,
}

impl<A: OverRationals> SampledClaim<'_, A> {
    fn n(&self) -> usize {
        self.sample.matrix.len()
    }

    pub(super) fn pairs(&self) -> Option<Vec<Sides<A::Value>>> {
        let SampledClaim { claim, arithmetic, sample } = *self;
        let here = run(arithmetic, &claim.plan, &sample.here)?;
        let there = run(arithmetic, &claim.plan, &sample.there)?;
        let single = |left: A::Value, right: &A::Value| {
            vec![Sides { place: Identity::Value, left, right: right.clone() }]
        };
        Some(match claim.kind {
            ClaimKind::Integral => single(there[0].clone(), &here[0]),
            ClaimKind::Drift => single(there[0].clone(), &here[1]),
            ClaimKind::Density => {
                single(arithmetic.multiply(&there[0], &sample.jacobian_determinant), &here[0])
            }
            ClaimKind::Bracket => {
                [self.invariance(&here, &there), self.jacobi()?].into_iter().flatten().collect()
            }
        })
    }

    fn invariance(&self, here: &[A::Value], there: &[A::Value]) -> Vec<Sides<A::Value>> {
        let left = self.congruence(&self.sample.back_matrix, here);
        let right = self.congruence(&self.sample.matrix, there);
        let n = self.n();
        let places = (0..n).flat_map(|i| (i + 1..n).map(move |j| Identity::Entry(i, j)));
        let pairs = places.zip(left.into_iter().zip(right));
        pairs.map(|(place, (left, right))| Sides { place, left, right }).collect()
    }

    /// Returns the entries of M P Mᵀ above the diagonal: Σ_{k<l} (MᵢₖMⱼₗ − MᵢₗMⱼₖ) Pₖₗ for i < j.
    /// The list `upper` has the entries of P above the diagonal.
    pub(super) fn congruence(&self, matrix: &[Vec<A::Value>], upper: &[A::Value]) -> Vec<A::Value> {
        let (arithmetic, n) = (self.arithmetic, self.n());
        let mut entries = Vec::new();
        for i in 0..n {
            for j in i + 1..n {
                let mut sum: Option<A::Value> = None;
                for k in 0..n {
                    for l in k + 1..n {
                        let value = &upper[upper_index(n, k, l)];
                        if arithmetic.is_zero(value) {
                            continue;
                        }
                        let minor = arithmetic.subtract(
                            &arithmetic.multiply(&matrix[i][k], &matrix[j][l]),
                            &arithmetic.multiply(&matrix[i][l], &matrix[j][k]),
                        );
                        let term = arithmetic.multiply(&minor, value);
                        sum = Some(sum.map_or_else(|| term.clone(), |sum| arithmetic.add(&sum, &term)));
                    }
                }
                entries.push(sum.unwrap_or_else(|| upper[0].clone()));
            }
        }
        entries
    }

    fn jacobi(&self) -> Option<Vec<Sides<A::Value>>> {
        let (arithmetic, n) = (self.arithmetic, self.n());
        let zero = arithmetic.constant(&Rational::zero())?;
        let upper = self.gradients()?;
        let entry = |i: usize, j: usize| -> Option<(&DualNumber<A::Value>, bool)> {
            (i != j).then(|| (&upper[upper_index(n, i.min(j), i.max(j))], i > j))
        };
        let signed =
            |value: A::Value, negative: bool| if negative { arithmetic.negate(&value) } else { value };
        let mut pairs = Vec::new();
        for i in 0..n {
            for j in i + 1..n {
                for k in j + 1..n {
                    let mut sum = zero.clone();
                    for (a, b, c) in [(i, j, k), (j, k, i), (k, i, j)] {
                        let Some((tensor, tensor_negative)) = entry(b, c) else { continue };
                        for (l, slope) in tensor.gradient.iter().enumerate() {
                            let Some((weight, weight_negative)) = entry(a, l) else { continue };
                            let product = arithmetic.multiply(&weight.value, slope);
                            sum = arithmetic.add(&sum, &signed(product, weight_negative != tensor_negative));
                        }
                    }
                    pairs.push(Sides { place: Identity::Jacobi(i, j, k), left: sum, right: zero.clone() });
                }
            }
        }
        Some(pairs)
    }

    pub(super) fn gradients(&self) -> Option<Vec<DualNumber<A::Value>>> {
        let (here, n) = (&self.sample.here, self.n());
        let dual = Dual { base: self.arithmetic, directions: n };
        let mut values = Vec::with_capacity(here.len());
        for (index, value) in here.iter().enumerate() {
            let moves = index < n;
            let value = value.clone();
            values.push(if moves { dual.coordinate(value, index)? } else { dual.fixed(value) });
        }
        run(&dual, &self.claim.plan, &values)
    }
}
