//! Short lists of powers, which most monomials have, without an allocation.
//!
//! Polynomials are made of monomials, and a plan takes thousands of polynomials that live for a
//! moment: allocating each list took a tenth of an expansion of the macro, which is not optimised.

use super::Variable;

/// How many powers stand in the list itself.
const FEW: usize = 4;

/// A variable with its exponent.
pub(super) type Power = (Variable, u32);

/// A list of powers.
#[derive(Clone, Debug)]
pub(super) enum Powers {
    /// The first so many of these.
    Few(usize, [Power; FEW]),
    Many(Vec<Power>),
}

impl Powers {
    pub(super) const NONE: Self = Powers::Few(0, [(Variable(0), 0); FEW]);

    pub(super) fn as_slice(&self) -> &[Power] {
        match self {
            Powers::Few(count, powers) => &powers[..*count],
            Powers::Many(powers) => powers,
        }
    }

    pub(super) fn as_mut_slice(&mut self) -> &mut [Power] {
        match self {
            Powers::Few(count, powers) => &mut powers[..*count],
            Powers::Many(powers) => powers,
        }
    }

    /// Adds one at the end.
    pub(super) fn push(&mut self, power: Power) {
        match self {
            Powers::Few(count, powers) if *count < FEW => {
                powers[*count] = power;
                *count += 1;
            }
            Powers::Few(_, powers) => {
                let mut many = Vec::with_capacity(2 * FEW);
                many.extend_from_slice(powers);
                many.push(power);
                *self = Powers::Many(many);
            }
            Powers::Many(powers) => powers.push(power),
        }
    }

    /// Adds one at a place, those from there on standing behind it.
    pub(super) fn insert(&mut self, place: usize, power: Power) {
        self.push(power);
        let powers = self.as_mut_slice();
        let mut last = powers.len() - 1;
        while last > place {
            powers[last] = powers[last - 1];
            last -= 1;
        }
        powers[place] = power;
    }

    /// Takes one out.
    pub(super) fn remove(&mut self, place: usize) {
        let powers = self.as_mut_slice();
        let last = powers.len() - 1;
        let mut index = place;
        while index < last {
            powers[index] = powers[index + 1];
            index += 1;
        }
        match self {
            Powers::Few(count, _) => *count = last,
            Powers::Many(powers) => powers.truncate(last),
        }
    }
}
