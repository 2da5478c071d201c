//! Writes terms. A constant is merged with a scaled symbol, such as εx, if this saves an operation.

use kahan_syntax::rational::Rational;

use crate::poly::{Monomial, Variable};

use super::Writer;
use crate::plan::Node;
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::scaling::{INVERSE_STEP, is_power_of_two};

impl Writer {
    pub(super) fn term(
        &mut self,
        monomial: &Monomial,
        coefficient: &Rational,
        factor: Option<Node>,
    ) -> Signed {
        let (mut factors, negative) = self.factors_of_term(monomial, coefficient);
        factors.extend(factor);
        Signed { node: self.draft.product(&factors), negative }
    }

    /// Returns the factors of a term and whether its sign is negative.
    pub(in crate::plan) fn factors_of_term(
        &mut self,
        monomial: &Monomial,
        coefficient: &Rational,
    ) -> (Vec<Node>, bool) {
        let negative = coefficient.is_negative();
        let size = if negative { -coefficient } else { coefficient.clone() };
        let powers = monomial.powers().iter();
        let repeated =
            powers.flat_map(|&(variable, exponent)| std::iter::repeat_n(variable, exponent as usize));
        let mut symbols: Vec<Variable> = repeated.collect();
        let mut factors: Vec<Node> = Vec::new();
        if self.scaling.folds {
            return (self.folded_factors(&size, &symbols), negative);
        }
        if let Some(place) = symbols.iter().position(|&variable| variable == INVERSE_STEP)
            && is_power_of_two(&size)
        {
            symbols.remove(place);
            factors.push(self.inverse_step(&size));
        } else if !size.is_one() {
            let scaled = symbols.iter().position(|&variable| self.scaling.unscaled(variable).is_some());
            match scaled.filter(|_| is_power_of_two(&size)) {
                Some(place) => {
                    let symbol = self.scaling.unscaled(symbols.remove(place));
                    factors.push(self.scaled_by(&size, symbol));
                }
                None => factors.push(self.draft.constant(&size)),
            }
        }
        factors.extend(symbols.into_iter().map(|variable| self.variable(variable)));
        (factors, negative)
    }

    /// Returns the factors of a term, with all constants multiplied into one.
    pub(super) fn folded_factors(&mut self, size: &Rational, symbols: &[Variable]) -> Vec<Node> {
        let is_state = |variable: &Variable| self.scaling.ready(*variable).is_some();
        let (mut states, constants): (Vec<Variable>, Vec<Variable>) =
            symbols.iter().partition(|v| is_state(v));
        let mut fixed: Vec<Node> = constants.into_iter().map(|variable| self.variable(variable)).collect();
        if !size.is_one() {
            fixed.push(self.draft.constant(size));
        }
        let mut factors = Vec::new();
        if !fixed.is_empty() {
            let scaled = states.iter().position(|&variable| self.scaling.unscaled(variable).is_some());
            if let Some(symbol) = scaled.and_then(|place| self.scaling.unscaled(states.remove(place))) {
                fixed.push(self.draft.input(self.scaling.epsilon()));
                factors.push(self.symbol(symbol));
            }
            let fixed = self.draft.product(&fixed);
            match factors.pop() {
                Some(symbol) => factors.push(self.draft.multiply(fixed, symbol)),
                None => factors.push(fixed),
            }
        }
        factors.extend(states.into_iter().map(|variable| self.variable(variable)));
        factors
    }

    /// Returns (cε)·v with v = `symbol`, or cε if that is `None`. cε is a prepared constant.
    pub(super) fn scaled_by(&mut self, c: &Rational, symbol: Option<Variable>) -> Node {
        let (eps, c) = (self.draft.input(self.scaling.epsilon()), self.draft.constant(c));
        let prepared = self.draft.multiply(c, eps);
        match symbol {
            Some(symbol) => {
                let symbol = self.symbol(symbol);
                self.draft.multiply(prepared, symbol)
            }
            None => prepared,
        }
    }
}
