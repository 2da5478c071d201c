//! A checked block: the field, and claims about its map that can be evaluated (whether they hold is the prover's
//! question).

use crate::field::Field;
use crate::plan::Plan;
use crate::poly::Variable;
use crate::rational::Rational;
use crate::syntax::{ClaimBody, ClaimKind, Header, Name};

/// A field with its claims.
#[derive(Clone, Debug)]
pub struct System {
    /// The header, where the block has one.
    pub header: Option<Header>,
    /// Constants in the order of their declaration, evaluated.
    pub constants: Vec<(String, Rational)>,
    /// The vector field.
    pub field: Field,
    /// Whether the field is the one that was written; if not, nothing can be said of the claims.
    pub is_field_sound: bool,
    /// The claims, in order.
    pub claims: Vec<Claim>,
}

/// A claim with resolved names.
#[derive(Clone, Debug)]
pub struct Claim {
    /// What is claimed.
    pub kind: ClaimKind,
    /// Its name.
    pub name: Name,
    /// What was written, for display; absent where it was not understood.
    pub body: Option<ClaimBody>,
    /// The function (one result), or the tensor's entries above the diagonal, row by row (n(n−1)/2 results).
    pub plan: Plan,
    /// The specialisation on which the claim is made: values of parameters and of ε.
    pub conditions: Vec<(Variable, Rational)>,
}

impl Claim {
    /// Whether the claim is made for generic parameters and ε.
    #[must_use]
    pub fn is_unconditional(&self) -> bool {
        self.conditions.is_empty()
    }
}

/// The index of entry (i, j), i < j, among the entries above the diagonal of an n×n matrix, row by row.
#[must_use]
pub fn upper_index(n: usize, i: usize, j: usize) -> usize {
    i * (2 * n - i - 1) / 2 + (j - i - 1)
}

impl System {
    /// The unconditional claims of one kind, in order.
    pub fn accessors(&self, kind: ClaimKind) -> impl Iterator<Item = &Claim> {
        self.claims.iter().filter(move |claim| claim.kind == kind && claim.is_unconditional())
    }

    /// The system's name; `field` where it has none.
    #[must_use]
    pub fn name(&self) -> &str {
        self.header.as_ref().map_or("field", |header| header.name.text.as_str())
    }
}
