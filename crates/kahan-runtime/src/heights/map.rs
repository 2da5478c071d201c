//! Kahan's map on projective integers (X₁ : … : X_n : W), which stand for the point xᵢ = σXᵢ/W.
//!
//! In: a system, values of its parameters, and ε. Out: steps without fractions, by the map in
//! lowest terms, homogenised with W. If that map has too many terms, elimination over ℤ solves
//! A(x,ε) x̃ = b. The constant σ is 1/ε for a homogeneous field whose coefficients do not depend on
//! ε, otherwise 1.

use dashu_int::{IBig, UBig};
use kahan_algebra::field::Field;
use kahan_algebra::kahan::{RationalMap, scaled_matrix, scaled_rhs};
use kahan_algebra::plan::{Plan, plan_of};
use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;

use super::elimination::solve_projectively;
use super::integers::{
    common_denominator, denominator, greatest_common_divisor, numerator, rational, values,
};
use super::split::Splits;

/// The error that the field divides by zero at these values of the parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UndefinedField;

/// A step of Kahan's map in projective integers.
#[derive(Clone, Debug)]
pub struct ProjectiveMap {
    dimension: usize,
    unit: Rational,
    formula: Formula,
}

#[derive(Clone, Debug)]
enum Formula {
    /// The reduced map, with numerators N₁ … N_n and a denominator D that `monomial` divides. The
    /// plan computes N₁ … N_n and D/`monomial`, then the denominator of the inverse map.
    Reduced { plan: Plan, monomial: Monomial, split: Splits },
    /// The plan of A and b in A x̃ = b; their entries are homogeneous of degree 1 in X and W.
    Elimination(Plan),
}

/// The result of a step, before the common factor of its coordinates is divided out.
#[derive(Clone, Debug)]
pub(crate) struct Image {
    pub(crate) point: Vec<IBig>,
    pub(crate) weight_parts: Vec<IBig>,
    /// The last coordinate of F₋(X), where F₋ is the inverse map and X the point before the step.
    pub(crate) weight_behind: Option<IBig>,
}

impl ProjectiveMap {
    /// Prepares the map of `system` at ε, half the time step. Parameter values have the order of
    /// declaration.
    ///
    /// The map is reduced over ℚ(ε, parameters) before the values are substituted, so factors that
    /// are common only at these values are not cancelled.
    ///
    /// # Errors
    /// [`UndefinedField`] if the field divides by zero at the parameters.
    ///
    /// # Panics
    /// If the number of values is not the number of parameters of the system.
    pub fn new(system: &System, parameters: &[Rational], eps: &Rational) -> Result<Self, UndefinedField> {
        Self::of(system, RationalMap::of(&system.field).as_ref(), parameters, eps)
    }

    pub(crate) fn of(
        system: &System,
        map: Option<&RationalMap>,
        parameters: &[Rational],
        eps: &Rational,
    ) -> Result<Self, UndefinedField> {
        let field = &system.field;
        assert_eq!(parameters.len(), field.symbols.parameters.len(), "one value a parameter");
        let is_scaled = field.is_homogeneous() && !field.depends_on_eps() && !eps.is_zero();
        let unit = eps.recip().filter(|_| is_scaled).unwrap_or_else(Rational::one);
        let at = |eps: Rational| Values { field, parameters, eps };
        let ahead = at(if is_scaled { Rational::one() } else { eps.clone() });
        let behind = at(-&ahead.eps);
        if field.components.iter().any(|component| ahead.put_into(component.denominator()).is_zero()) {
            return Err(UndefinedField);
        }
        let formula = match map {
            Some(map) => {
                let mut forms = ahead.forms(map);
                let split = Splits::of(forms.clone());
                let mut monomial = Monomial::one();
                if let Some(denominator) = forms.last_mut() {
                    monomial = denominator.monomial_content();
                    *denominator = denominator.div_monomial(&monomial).expect("all terms have it");
                }
                forms.extend(behind.forms(map).pop());
                Formula::Reduced { plan: plan_of(&forms), monomial, split }
            }
            None => Formula::Elimination(plan_of(&ahead.linear_system())),
        };
        Ok(ProjectiveMap { dimension: field.dimension(), unit, formula })
    }

    /// Returns the factor σ with which a projective point (X₁, …, X_n, W) stands for xᵢ = σXᵢ/W.
    /// For a homogeneous field whose coefficients do not depend on ε, σ is 1/ε, otherwise 1.
    #[must_use]
    pub fn unit(&self) -> &Rational {
        &self.unit
    }

    pub(crate) fn point(&self, x: &[Rational]) -> Vec<IBig> {
        let scale = self.unit.recip().expect("1/ε or 1 is not zero");
        let scaled: Vec<Rational> = x.iter().map(|x| x * &scale).collect();
        let weight = common_denominator(&scaled);
        let mut point: Vec<IBig> = scaled.iter().map(|x| numerator(x) * (&weight / denominator(x))).collect();
        point.push(weight.into());
        point
    }

    pub(crate) fn coordinates(&self, point: &[IBig]) -> Vec<Rational> {
        let Some((weight, x)) = point.split_last() else { return Vec::new() };
        x.iter().map(|x| &rational(x, weight) * &self.unit).collect()
    }

    /// Makes one step; divides the coordinates by a common factor if a gcd in `factors` is long.
    pub(crate) fn apply(&mut self, point: &[IBig], factors: &[UBig]) -> Image {
        match &mut self.formula {
            Formula::Reduced { plan, monomial, split } => {
                if let Some(point) = split.apply(point, factors) {
                    return Image { point, weight_parts: Vec::new(), weight_behind: None };
                }
                let mut image = values(plan, point);
                let weight_behind = image.pop();
                let mut weight_parts: Vec<IBig> = image.pop().into_iter().collect();
                for &(variable, exponent) in monomial.powers() {
                    let factor = &point[usize::from(variable.0)];
                    weight_parts.extend(std::iter::repeat_n(factor, exponent as usize).cloned());
                }
                image.push(weight_parts.iter().product());
                Image { point: image, weight_parts, weight_behind }
            }
            Formula::Elimination(plan) => {
                let mut entries = values(plan, point);
                let rhs = entries.split_off(self.dimension * self.dimension);
                let rows = entries.chunks(self.dimension).zip(rhs);
                let rows = rows.map(|(row, b)| row.iter().cloned().chain([b]).collect()).collect();
                Image { point: solve_projectively(rows), weight_parts: Vec::new(), weight_behind: None }
            }
        }
    }
}

struct Values<'a> {
    field: &'a Field,
    parameters: &'a [Rational],
    eps: Rational,
}

impl Values<'_> {
    fn put_into(&self, polynomial: &Polynomial) -> Polynomial {
        let symbols = &self.field.symbols;
        let at_eps = polynomial.substitute(symbols.epsilon(), &self.eps);
        self.parameters
            .iter()
            .enumerate()
            .fold(at_eps, |polynomial, (k, value)| polynomial.substitute(symbols.parameter(k), value))
    }

    /// For a map x̃ = x + 2εn/d, returns xᵢd + 2εnᵢ and d, homogenised with W to equal degrees.
    fn forms(&self, map: &RationalMap) -> Vec<Polynomial> {
        let denominator = self.put_into(&map.reduced.denominator);
        let two_eps = &self.eps + &self.eps;
        let numerator = |(i, increment): (usize, &Polynomial)| {
            let start = &Polynomial::variable(self.field.symbols.state(i)) * &denominator;
            &start + &self.put_into(increment).scale(&two_eps)
        };
        let mut forms: Vec<Polynomial> = map.reduced.increments.iter().enumerate().map(numerator).collect();
        forms.push(denominator);
        let degree = forms.iter().map(Polynomial::degree).max().unwrap_or(0);
        self.homogeneous(&forms, degree)
    }

    /// Returns A, row by row, and b from A x̃ = b, as forms of degree one with coprime coefficients
    /// in each row.
    fn linear_system(&self) -> Vec<Polynomial> {
        let (mut entries, mut right) = (Vec::new(), Vec::new());
        for (row, b) in scaled_matrix(self.field).iter().zip(scaled_rhs(self.field)) {
            let row: Vec<Polynomial> = row.iter().chain([&b]).map(|entry| self.put_into(entry)).collect();
            let mut row = self.homogeneous(&row, 1);
            right.extend(row.pop());
            entries.append(&mut row);
        }
        entries.append(&mut right);
        entries
    }

    /// Returns the polynomials as forms in the states and W, with coprime integer coefficients.
    fn homogeneous(&self, polynomials: &[Polynomial], degree: u32) -> Vec<Polynomial> {
        let coefficients = || polynomials.iter().flat_map(|p| p.terms().map(|(_, coefficient)| coefficient));
        let multiple = IBig::from(common_denominator(coefficients()));
        let cleared = |c: &Rational| numerator(c) * (&multiple / IBig::from(denominator(c)));
        let content = greatest_common_divisor(coefficients().map(cleared).collect::<Vec<_>>().iter());
        let scale = rational(&multiple, &if content.is_zero() { IBig::ONE } else { content.into() });
        let weight = weight(self.field.dimension());
        let homogenise = |polynomial: &Polynomial| {
            Polynomial::from_terms(polynomial.terms().map(|(monomial, coefficient)| {
                let rest = Monomial::power(weight, degree - monomial.degree());
                (monomial.mul(&rest), coefficient * &scale)
            }))
        };
        polynomials.iter().map(homogenise).collect()
    }
}

fn weight(dimension: usize) -> Variable {
    Variable(u16::try_from(dimension).expect("states are numbered by 16 bits"))
}
