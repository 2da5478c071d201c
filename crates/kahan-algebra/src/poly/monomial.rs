//! Variables and monomials.
//!
//! A monomial is a sparse list of pairs (variable, exponent). The order is graded lexicographic: by
//! total degree, then by the exponent of the first variable in which monomials differ. In this
//! order, multiplication or division by a monomial keeps terms sorted.

mod products;

use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

use super::powers::{Power, Powers};

/// A variable, identified by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Variable(
    /// The index of the variable.
    pub u16,
);

/// A product of powers of variables.
///
/// # Panics
/// If the total degree of a product or power exceeds `u32::MAX`.
#[derive(Clone, Debug)]
pub struct Monomial {
    degree: u32,
    powers: Powers,
}

impl Monomial {
    /// Returns the monomial 1.
    pub fn one() -> Self {
        Self { degree: 0, powers: Powers::NONE }
    }

    /// Returns the monomial of a variable.
    pub fn variable(variable: Variable) -> Self {
        Self::power(variable, 1)
    }

    /// Returns the power `variable`^`exponent`.
    pub fn power(variable: Variable, exponent: u32) -> Self {
        let mut power = Self::one();
        power.push(variable, exponent);
        power
    }

    fn push(&mut self, variable: Variable, exponent: u32) {
        if exponent > 0 {
            self.powers.push((variable, exponent));
            self.degree += exponent;
        }
    }

    /// Returns whether the monomial is 1.
    pub fn is_one(&self) -> bool {
        self.degree == 0
    }

    /// Returns the pairs of variable and exponent. Variables increase, and exponents are positive.
    pub fn powers(&self) -> &[(Variable, u32)] {
        self.powers.as_slice()
    }

    /// Returns the sum of all exponents.
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// Returns the exponent of `variable`, which is 0 if it does not occur.
    pub fn exponent(&self, variable: Variable) -> u32 {
        let powers = self.powers();
        let mut index = 0;
        while index < powers.len() {
            if powers[index].0.0 >= variable.0 {
                return if powers[index].0.0 == variable.0 { powers[index].1 } else { 0 };
            }
            index += 1;
        }
        0
    }

    /// Returns the sum of the exponents of the variables that satisfy `belongs`.
    pub fn degree_where(&self, mut belongs: impl FnMut(Variable) -> bool) -> u32 {
        let mut degree = 0;
        for (variable, exponent) in self.powers() {
            if belongs(*variable) {
                degree += exponent;
            }
        }
        degree
    }

    /// Splits the monomial into one in the variables that satisfy `belongs`, and one in all others.
    pub fn split(&self, mut belongs: impl FnMut(Variable) -> bool) -> (Self, Self) {
        self.parted(&mut belongs)
    }

    fn parted(&self, belongs: &mut dyn FnMut(Variable) -> bool) -> (Self, Self) {
        let (mut inside, mut outside) = (Self::one(), Self::one());
        for &(variable, exponent) in self.powers() {
            let part = if belongs(variable) { &mut inside } else { &mut outside };
            part.push(variable, exponent);
        }
        (inside, outside)
    }
}

impl FromIterator<(Variable, u32)> for Monomial {
    fn from_iter<I: IntoIterator<Item = (Variable, u32)>>(powers: I) -> Self {
        let mut product = Self::one();
        for (variable, exponent) in powers {
            product.multiply_by(variable, exponent);
        }
        product
    }
}

impl Default for Monomial {
    fn default() -> Self {
        Self::one()
    }
}

impl PartialEq for Monomial {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Monomial {}

impl Hash for Monomial {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.powers().hash(state);
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.degree != other.degree {
            return if self.degree < other.degree { Ordering::Less } else { Ordering::Greater };
        }
        let (left, right) = (self.powers(), other.powers());
        // Both degrees are equal, so the lists differ at some index within both.
        let mut index = 0;
        while index < left.len() && index < right.len() {
            let ((v, e), (w, f)): (Power, Power) = (left[index], right[index]);
            if v.0 != w.0 {
                return if v.0 < w.0 { Ordering::Greater } else { Ordering::Less };
            }
            if e != f {
                return if e < f { Ordering::Less } else { Ordering::Greater };
            }
            index += 1;
        }
        Ordering::Equal
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
