//! The variational field: a field and a tangent vector that it carries along.
//!
//! In: ẋ = f(x). Out: ẋ = f(x), v̇ = f′(x)·v, which is quadratic, too. Kahan's map of it is x ↦ x̃
//! with v ↦ (∂x̃/∂x)·v: to polarise and to differentiate along v is the same in either order.

use std::sync::Arc;

use crate::field::{Component, Field};
use crate::poly::{Polynomial, gcd};
use crate::symbols::Symbols;
use crate::system::System;

impl System {
    /// The system of x and a tangent vector v, whose names are those of x with a `d` before them;
    /// without claims.
    #[must_use]
    pub fn variational(&self) -> System {
        let field = &self.field;
        let dimension = field.dimension();
        let symbols = field.symbols.with_tangent();
        let renamed = |polynomial: &Polynomial| {
            polynomial.map_variables(|variable| symbols.variable(field.symbols.symbol(variable)))
        };
        let along = |component: &Component| {
            let mut sum = Polynomial::zero();
            for k in 0..dimension {
                let slope = renamed(&component.numerator.derivative(field.symbols.state(k)));
                let tangent = Polynomial::variable(symbols.state(dimension + k));
                sum = &sum + &(&slope * &tangent);
            }
            let denominator = renamed(&component.denominator);
            let common = gcd(&sum, &denominator);
            let [numerator, denominator] =
                [sum, denominator].map(|of| of.checked_div(&common).expect("a common divisor divides"));
            Component { numerator, denominator }
        };
        let moved = |component: &Component| Component {
            numerator: renamed(&component.numerator),
            denominator: renamed(&component.denominator),
        };
        let components = field.components.iter().map(moved).chain(field.components.iter().map(along));
        System {
            header: None,
            constants: self.constants.clone(),
            kept: self.kept.variational(&field.symbols, &symbols).into(),
            field: Field { components: components.collect(), symbols }.into(),
            written: Arc::default(),
            claims: Vec::new(),
        }
    }
}

impl Symbols {
    /// These names, and one more for the tangent of each state.
    fn with_tangent(&self) -> Symbols {
        let mut states = self.states.clone();
        for state in &self.states {
            let mut name = format!("d{state}");
            while states.contains(&name) || self.parameters.contains(&name) {
                name.insert(0, 'd');
            }
            states.push(name);
        }
        Symbols { states, parameters: self.parameters.clone() }
    }
}

#[cfg(test)]
mod tests {
    use kahan_syntax::lexer::lex;

    use crate::render::{Notation, Text};

    #[test]
    fn tangents_are_carried_by_the_derivative() {
        let text = "xdot = a*x*dx + x^2/b; dxdot = (x - 3)/b;";
        let system = crate::read(&lex(text).tokens).system().expect("a system").variational();
        let symbols = &system.field.symbols;
        assert_eq!(symbols.states, ["x", "dx", "ddx", "dddx"]);
        let lines = system.field.components.iter().map(|component| {
            let [above, below] =
                [&component.numerator, &component.denominator].map(|of| Text.polynomial(symbols, of));
            format!("({above})/({below})")
        });
        assert_eq!(
            lines.collect::<Vec<_>>(),
            ["(x^2 + a*b*x*dx)/(b)", "(-3 + x)/(b)", "(2*x*ddx + a*b*x*dddx + a*b*dx*ddx)/(b)", "(ddx)/(b)"]
        );
    }
}
