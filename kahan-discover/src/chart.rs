//! A leaf together with the formulas of what chooses it, by which formulas on the leaf become formulas everywhere.

use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::Notation;
use kahan_algebra::symbols::{Symbol, Symbols};

use crate::leaf::{Coordinate, Leaf};
use crate::setting::Setting;
use crate::space::Names;
use crate::writing::{factored, is_product, quotient};

/// The work that putting the formulas of a leaf's coordinates in may take, in products of terms.
const SUBSTITUTION_WORK: u64 = 20_000_000;

/// A leaf with the formulas of what chooses it: its entries, and perhaps the value of an integral on it.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The leaf.
    pub leaf: Leaf,
    /// The formulas, in the order of the entries; the value of an integral last.
    pub coordinates: Vec<Coordinate>,
}

impl Chart {
    fn variable(&self, symbols: &Symbols, j: usize) -> Variable {
        symbols.variable(Symbol::SecondState(j))
    }

    /// Which variables of formulas on the leaf stand for what.
    #[must_use]
    pub fn names(&self, setting: &Setting) -> Names {
        let symbols = setting.family().symbols();
        let mut names = Names::of(setting);
        names.unknowns.extend((0..self.coordinates.len()).map(|j| self.variable(symbols, j)));
        names.states = self.leaf.order().iter().map(|&state| symbols.state(state)).collect();
        if let Some((weights, unknowns)) = &mut names.weights {
            unknowns.extend(self.coordinates.iter().map(|coordinate| coordinate.weight(weights)));
        }
        names
    }

    /// P/Q in lowest terms with every coordinate replaced by its formula; `None` beyond the budget, and where Q becomes 0.
    #[must_use]
    pub fn substituted(
        &self,
        symbols: &Symbols,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Option<(Polynomial, Polynomial)> {
        if self.coordinates.is_empty() {
            return Some((numerator.clone(), denominator.clone()));
        }
        let mut budget = Budget::new(20_000, SUBSTITUTION_WORK);
        let mut quotient = [numerator.clone(), denominator.clone()];
        for (j, coordinate) in self.coordinates.iter().enumerate() {
            let variable = self.variable(symbols, j);
            let highest = quotient.iter().map(|side| side.degree_in(variable)).max()?;
            for side in &mut quotient {
                let mut sum = Polynomial::zero();
                for (exponent, coefficient) in side.coefficients_in(variable) {
                    let above = coordinate.numerator.pow_within(exponent, &mut budget).ok()?;
                    let below = coordinate.denominator.pow_within(highest - exponent, &mut budget).ok()?;
                    let power = above.mul_within(&below, &mut budget).ok()?;
                    sum = sum + coefficient.mul_within(&power, &mut budget).ok()?;
                }
                *side = sum;
            }
        }
        let [above, below] = quotient;
        let reduced = RationalFunction::new_within(above, below, &mut budget).ok()??;
        Some((reduced.numerator().clone(), reduced.denominator().clone()))
    }

    /// P/Q as text with every coordinate written out where it stands, which keeps its formula in one piece; `None` without
    /// coordinates.
    #[must_use]
    pub fn written(
        &self,
        symbols: &Symbols,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Option<String> {
        if self.coordinates.is_empty() {
            return None;
        }
        let above = self.written_sum(symbols, numerator);
        let above = if is_product(&above) { above } else { format!("({above})") };
        Some(match denominator.as_constant().is_some_and(|constant| constant.is_one()) {
            true => above,
            false => format!("{above}/({})", self.written_sum(symbols, denominator)),
        })
    }

    /// A polynomial by the powers of its coordinates.
    fn written_sum(&self, symbols: &Symbols, polynomial: &Polynomial) -> String {
        // Coordinates that are one variable each are put in as such.
        let short = |coordinate: &Coordinate| coordinate.denominator.is_one() && coordinate.numerator.len() == 1;
        let is_coordinate = |variable: Variable| matches!(symbols.symbol(variable), Symbol::SecondState(_));
        let mut sum = polynomial.clone();
        for (j, coordinate) in self.coordinates.iter().enumerate().filter(|(_, own)| short(own)) {
            let powers = sum.coefficients_in(self.variable(symbols, j)).into_iter();
            sum = powers.fold(Polynomial::zero(), |sum, (exponent, coefficient)| {
                let power = (0..exponent).fold(coefficient, |power, _| &power * &coordinate.numerator);
                sum + power
            });
        }
        let mut text = String::new();
        for (powers, coefficient) in sum.group(is_coordinate) {
            let mut parts: Vec<String> = Vec::new();
            for &(variable, exponent) in powers.powers() {
                let Symbol::SecondState(j) = symbols.symbol(variable) else { continue };
                let Coordinate { numerator, denominator } = &self.coordinates[j];
                let own = quotient(symbols, &[numerator.clone()], &[denominator.clone()]);
                parts.push(Notation::Text.power(&format!("({own})"), i64::from(exponent)));
            }
            let own = factored(symbols, &coefficient);
            let (sign, own) = match own.strip_prefix('-') {
                Some(positive) if is_product(&own) => ("-", positive.to_owned()),
                _ => ("+", own),
            };
            if parts.is_empty() || own != "1" {
                let is_sum = !parts.is_empty() && !is_product(&own);
                parts.insert(0, if is_sum { format!("({own})") } else { own });
            }
            match (text.is_empty(), sign) {
                (true, "-") => text.push('-'),
                (true, _) => {}
                (false, sign) => text.push_str(&format!(" {sign} ")),
            }
            text.push_str(&parts.join("*"));
        }
        text
    }
}
