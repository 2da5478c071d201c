//! The objects of a system as formulas.

use num_bigint::BigInt;

use crate::field::{Component, Field};
use crate::kahan::{RationalMap, bilinear_form, field_jacobian, scaled_matrix, scaled_rhs};
use crate::poly::Polynomial;
use crate::rational::Rational;

use super::notation::{Notation, parenthesize};

/// Writes the objects of one field in one notation.
#[derive(Clone, Copy, Debug)]
pub struct Formulas<'a> {
    /// The field.
    pub field: &'a Field,
    /// Its map in closed form; `None` beyond the budget.
    pub map: Option<&'a RationalMap>,
    /// The notation.
    pub notation: Notation,
}

/// A matrix of formulas.
pub type MatrixText = Vec<Vec<String>>;

impl Formulas<'_> {
    fn polynomial(&self, polynomial: &Polynomial) -> String {
        self.notation.polynomial(&self.field.symbols, polynomial)
    }

    /// p/q for a polynomial over the denominator of component `i`.
    fn over(&self, polynomial: &Polynomial, component: &Component) -> String {
        if component.denominator.is_one() || polynomial.is_zero() {
            return self.polynomial(polynomial);
        }
        let (above, below) = (polynomial, &component.denominator);
        match self.notation {
            Notation::Text => self.notation.quotient(&self.polynomial(above), &self.polynomial(below)),
            Notation::Latex => self.fraction(above, below),
        }
    }

    /// One line between whole numbers: (½ x y)/a is xy/(2a), and −x/a has its sign in front.
    fn fraction(&self, above: &Polynomial, below: &Polynomial) -> String {
        // Both keep their signs: a denominator that begins with 1 does so here, too.
        let (numerator, denominator) = (above.content().abs(), below.content().abs());
        let Some(factor) = numerator.checked_div(&denominator) else { return self.polynomial(above) };
        let is_negative = above.terms().all(|(_, coefficient)| coefficient.is_negative());
        let whole = |part: &Polynomial, content: &Rational, times: BigInt| {
            let scale = Rational::from(times).checked_div(content);
            scale.map_or_else(|| part.clone(), |scale| part.scale(&scale))
        };
        let above = whole(above, &numerator, factor.numerator());
        let below = whole(below, &denominator, factor.denominator());
        let (above, sign) = if is_negative { (above.scale(&Rational::from(-1)), "-") } else { (above, "") };
        format!("{sign}{}", self.notation.quotient(&self.polynomial(&above), &self.polynomial(&below)))
    }

    fn over_each(&self, polynomials: &[Polynomial]) -> Vec<String> {
        polynomials
            .iter()
            .zip(&self.field.components)
            .map(|(polynomial, component)| self.over(polynomial, component))
            .collect()
    }

    /// f(x)
    #[must_use]
    pub fn field(&self) -> Vec<String> {
        self.field.components.iter().map(|component| self.over(&component.numerator, component)).collect()
    }

    /// f′(x)
    #[must_use]
    pub fn field_jacobian(&self) -> MatrixText {
        self.matrix_over(&field_jacobian(self.field))
    }

    /// A(x,ε)
    #[must_use]
    pub fn matrix(&self) -> MatrixText {
        self.matrix_over(&scaled_matrix(self.field))
    }

    /// b(x,ε)
    #[must_use]
    pub fn rhs(&self) -> Vec<String> {
        self.over_each(&scaled_rhs(self.field))
    }

    /// Q(x,y), the second point with primes.
    #[must_use]
    pub fn bilinear(&self) -> Vec<String> {
        self.over_each(&bilinear_form(self.field))
    }

    /// The reduced map x̃ᵢ = xᵢ + 2ε nᵢ/d; `None` beyond the budget.
    #[must_use]
    pub fn map(&self) -> Option<Vec<String>> {
        let map = self.map?;
        let below = self.polynomial(&map.reduced.denominator);
        let rows = map.reduced.increments.iter().enumerate().map(|(i, increment)| {
            let state = self.notation.name(&self.field.symbols.states[i]);
            if increment.is_zero() {
                return state;
            }
            let above = self.polynomial(increment);
            match self.notation {
                Notation::Text if below == "1" => format!("{state} + 2*eps*{}", parenthesize(&above)),
                Notation::Text => {
                    format!("{state} + 2*eps*{}/{}", parenthesize(&above), parenthesize(&below))
                }
                Notation::Latex if above == "1" && below == "1" => format!("{state} + 2\\varepsilon"),
                Notation::Latex if below == "1" => {
                    let is_plain = above.starts_with(char::is_alphabetic) || above.starts_with('\\');
                    let factor = if is_plain && !above.contains(" + ") && !above.contains(" - ") {
                        format!("\\,{above}")
                    } else {
                        format!("\\left({above}\\right)")
                    };
                    format!("{state} + 2\\varepsilon{factor}")
                }
                Notation::Latex => {
                    let quotient = self.fraction(increment, &map.reduced.denominator);
                    match quotient.strip_prefix('-') {
                        Some(size) => format!("{state} - 2\\varepsilon\\,{size}"),
                        None => format!("{state} + 2\\varepsilon\\,{quotient}"),
                    }
                }
            }
        });
        Some(rows.collect())
    }

    /// det A(x,ε); `None` beyond the budget.
    #[must_use]
    pub fn determinant(&self) -> Option<String> {
        let map = self.map?;
        let above = self.polynomial(&map.denominator);
        Some(if map.divisor.is_one() {
            above
        } else {
            match self.notation {
                Notation::Text => self.notation.quotient(&above, &self.polynomial(&map.divisor)),
                Notation::Latex => self.fraction(&map.denominator, &map.divisor),
            }
        })
    }

    /// What was divided out of the map; `None` if nothing was.
    #[must_use]
    pub fn removed_factor(&self) -> Option<String> {
        let map = self.map?;
        let factor = &map.reduced.common_factor;
        factor.as_constant().is_none().then(|| self.polynomial(factor))
    }

    fn matrix_over(&self, rows: &[Vec<Polynomial>]) -> MatrixText {
        rows.iter()
            .zip(&self.field.components)
            .map(|(row, component)| row.iter().map(|entry| self.over(entry, component)).collect())
            .collect()
    }
}
