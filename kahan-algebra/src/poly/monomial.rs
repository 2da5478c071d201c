//! Variables and their power products.
//!
//! A monomial is a sparse list of (variable, exponent), variables increasing, exponents positive.
//! The order is graded lexicographic: the higher total degree is greater; at equal degree, the
//! first variable (by index) in which two monomials differ decides, the higher exponent being
//! greater. It is admissible: 1 is least, and m < n implies mk < nk, so multiplying or dividing
//! sorted terms by a monomial leaves them sorted.

use std::cmp::Ordering;

/// A variable, by its index; whoever made it knows its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Variable(
    /// The index.
    pub u16,
);

/// A product of powers of variables.
///
/// # Panics
/// Products and powers whose total degree exceeds `u32::MAX`.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Monomial {
    degree: u32,
    powers: Vec<(Variable, u32)>,
}

impl Monomial {
    /// The empty product, 1.
    pub fn one() -> Self {
        Self::default()
    }

    /// The variable itself.
    pub fn variable(variable: Variable) -> Self {
        Self::power(variable, 1)
    }

    /// `variable`^`exponent`.
    pub fn power(variable: Variable, exponent: u32) -> Self {
        if exponent == 0 {
            return Self::one();
        }
        Self { degree: exponent, powers: vec![(variable, exponent)] }
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        self.degree == 0
    }

    /// The factors, variables increasing, exponents positive.
    pub fn powers(&self) -> &[(Variable, u32)] {
        &self.powers
    }

    /// The sum of all exponents.
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// The exponent of `variable`, 0 where it does not occur.
    pub fn exponent(&self, variable: Variable) -> u32 {
        let powers: &[(Variable, u32)] = &self.powers;
        let mut index = 0;
        while index < powers.len() {
            if powers[index].0.0 >= variable.0 {
                return if powers[index].0.0 == variable.0 { powers[index].1 } else { 0 };
            }
            index += 1;
        }
        0
    }

    /// The sum of the exponents of the variables that `belongs` picks.
    pub fn degree_where(&self, mut belongs: impl FnMut(Variable) -> bool) -> u32 {
        let mut degree = 0;
        for (variable, exponent) in &self.powers {
            if belongs(*variable) {
                degree += exponent;
            }
        }
        degree
    }

    /// The product.
    pub fn mul(&self, other: &Self) -> Self {
        if other.is_one() {
            return self.clone();
        }
        let (left, right): (&[_], &[_]) = (&self.powers, &other.powers);
        let mut powers = Vec::with_capacity(left.len() + right.len());
        let (mut i, mut j) = (0, 0);
        while i < left.len() && j < right.len() {
            let ((v, e), (w, f)): ((Variable, u32), (Variable, u32)) = (left[i], right[j]);
            if v.0 == w.0 {
                powers.push((v, e + f));
                i += 1;
                j += 1;
            } else if v.0 < w.0 {
                powers.push((v, e));
                i += 1;
            } else {
                powers.push((w, f));
                j += 1;
            }
        }
        powers.extend_from_slice(&left[i..]);
        powers.extend_from_slice(&right[j..]);
        Self { degree: self.degree + other.degree, powers }
    }

    /// The quotient; `None` where `divisor` does not divide.
    pub fn div(&self, divisor: &Self) -> Option<Self> {
        if !divisor.divides(self) {
            return None;
        }
        let mut powers = Vec::with_capacity(self.powers.len());
        let right: &[(Variable, u32)] = &divisor.powers;
        let mut j = 0;
        for &(variable, exponent) in &self.powers {
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

    /// Whether `multiple` is this times a monomial. It allocates nothing: most divisions fail.
    pub fn divides(&self, multiple: &Self) -> bool {
        let (left, right): (&[_], &[_]) = (&multiple.powers, &self.powers);
        if self.degree > multiple.degree || right.len() > left.len() {
            return false;
        }
        let (mut i, mut j) = (0, 0);
        while i < left.len() && j < right.len() {
            let ((v, e), (w, f)): ((Variable, u32), (Variable, u32)) = (left[i], right[j]);
            if v.0 > w.0 || (v.0 == w.0 && e < f) {
                return false;
            }
            j += usize::from(v.0 == w.0);
            i += 1;
        }
        j == right.len()
    }

    /// The power.
    pub fn pow(&self, exponent: u32) -> Self {
        if exponent == 0 {
            return Self::one();
        }
        let powers = self.powers.iter().map(|&(variable, e)| (variable, e * exponent)).collect();
        Self { degree: self.degree * exponent, powers }
    }

    /// The greatest common divisor: the lower exponent of each variable.
    pub fn gcd(&self, other: &Self) -> Self {
        let mut common = Self::one();
        for &(variable, exponent) in &self.powers {
            let exponent = exponent.min(other.exponent(variable));
            if exponent > 0 {
                common.powers.push((variable, exponent));
                common.degree += exponent;
            }
        }
        common
    }

    /// The part in the variables that `belongs` picks, and the part in the others.
    pub fn split(&self, mut belongs: impl FnMut(Variable) -> bool) -> (Self, Self) {
        self.parted(&mut belongs)
    }

    fn parted(&self, belongs: &mut dyn FnMut(Variable) -> bool) -> (Self, Self) {
        let (mut inside, mut outside) = (Self::one(), Self::one());
        for &(variable, exponent) in &self.powers {
            let part = if belongs(variable) { &mut inside } else { &mut outside };
            part.powers.push((variable, exponent));
            part.degree += exponent;
        }
        (inside, outside)
    }
}

/// The product of the given powers, in any order.
impl FromIterator<(Variable, u32)> for Monomial {
    fn from_iter<I: IntoIterator<Item = (Variable, u32)>>(powers: I) -> Self {
        powers
            .into_iter()
            .fold(Self::one(), |product, (variable, exponent)| product.mul(&Self::power(variable, exponent)))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.degree != other.degree {
            return if self.degree < other.degree { Ordering::Less } else { Ordering::Greater };
        }
        let (left, right): (&[_], &[_]) = (&self.powers, &other.powers);
        // At equal degree neither list is a proper prefix of the other.
        let mut index = 0;
        while index < left.len() && index < right.len() {
            let ((v, e), (w, f)): ((Variable, u32), (Variable, u32)) = (left[index], right[index]);
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
