//! Products, quotients and common divisors of monomials.

use super::super::powers::{Power, Powers};
use super::{Monomial, Variable};

impl Monomial {
    /// Returns the product of two monomials.
    pub fn mul(&self, other: &Self) -> Self {
        if other.is_one() {
            return self.clone();
        }
        let (left, right) = (self.powers(), other.powers());
        let mut powers = Powers::NONE;
        let (mut i, mut j) = (0, 0);
        while i < left.len() || j < right.len() {
            if j == right.len() || (i < left.len() && left[i].0.0 < right[j].0.0) {
                powers.push(left[i]);
                i += 1;
            } else if i == left.len() || right[j].0.0 < left[i].0.0 {
                powers.push(right[j]);
                j += 1;
            } else {
                powers.push((left[i].0, left[i].1 + right[j].1));
                i += 1;
                j += 1;
            }
        }
        Self { degree: self.degree + other.degree, powers }
    }

    /// Multiplies the monomial by a power of a variable.
    pub fn multiply_by(&mut self, variable: Variable, exponent: u32) {
        if exponent == 0 {
            return;
        }
        self.degree += exponent;
        let powers = self.powers.as_mut_slice();
        let mut place = powers.len();
        while place > 0 && powers[place - 1].0.0 > variable.0 {
            place -= 1;
        }
        if place > 0 && powers[place - 1].0.0 == variable.0 {
            powers[place - 1].1 += exponent;
        } else {
            self.powers.insert(place, (variable, exponent));
        }
    }

    /// Returns the quotient by a variable. Returns `None` if the variable does not occur.
    pub fn lowered(&self, variable: Variable) -> Option<Self> {
        let powers = self.powers();
        let mut place = 0;
        while place < powers.len() && powers[place].0.0 != variable.0 {
            place += 1;
        }
        if place == powers.len() {
            return None;
        }
        let mut lowered = self.clone();
        lowered.degree -= 1;
        if powers[place].1 > 1 {
            lowered.powers.as_mut_slice()[place].1 -= 1;
        } else {
            lowered.powers.remove(place);
        }
        Some(lowered)
    }

    /// Returns the quotient. Returns `None` unless `divisor` divides the monomial.
    pub fn div(&self, divisor: &Self) -> Option<Self> {
        if !divisor.divides(self) {
            return None;
        }
        let mut powers = Powers::NONE;
        let right = divisor.powers();
        let mut j = 0;
        for &(variable, exponent) in self.powers() {
            if j < right.len() && right[j].0.0 == variable.0 {
                if exponent > right[j].1 {
                    powers.push((variable, exponent - right[j].1));
                }
                j += 1;
            } else {
                powers.push((variable, exponent));
            }
        }
        Some(Self { degree: self.degree - divisor.degree, powers })
    }

    /// Returns whether the monomial divides `multiple`.
    pub fn divides(&self, multiple: &Self) -> bool {
        if self.degree > multiple.degree {
            return false;
        }
        let (left, right) = (multiple.powers(), self.powers());
        let (mut i, mut j) = (0, 0);
        while i < left.len() && j < right.len() {
            let ((v, e), (w, f)): (Power, Power) = (left[i], right[j]);
            if v.0 > w.0 || (v.0 == w.0 && e < f) {
                return false;
            }
            j += usize::from(v.0 == w.0);
            i += 1;
        }
        j == right.len()
    }

    /// Returns the monomial to the power `exponent`.
    pub fn pow(&self, exponent: u32) -> Self {
        if exponent == 0 {
            return Self::one();
        }
        let mut power = self.clone();
        power.degree *= exponent;
        for (_, own) in power.powers.as_mut_slice() {
            *own *= exponent;
        }
        power
    }

    /// Returns the greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        let mut common = Self::one();
        for &(variable, exponent) in self.powers() {
            common.push(variable, exponent.min(other.exponent(variable)));
        }
        common
    }
}
