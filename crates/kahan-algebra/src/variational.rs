//! The variational field: a field and tangent vectors that it carries along.
//!
//! In: ẋ = f(x). Out: ẋ = f(x), v̇ = f′(x)·v + ∂f/∂a, which is quadratic, too. Its Kahan
//! map is x ↦ x̃, v ↦ (∂x̃/∂x)·v + ∂x̃/∂a, since polarising and differentiating commute. For a = ε
//! f/ε + ∂f/∂ε stands in place of ∂f/∂a.

use std::sync::Arc;

use crate::field::{Component, Field};
pub use crate::kept::By;
use crate::poly::{Polynomial, gcd};
use crate::symbols::Symbols;
use crate::system::System;

impl System {
    /// The system of x and a tangent vector v, whose names are those of x with a `d` before them;
    /// without claims.
    #[must_use]
    pub fn variational(&self) -> System {
        self.sensitivities(&[By::Start])
    }

    /// The system of x and of its derivatives, a vector for each entry of `by`, without claims. The
    /// names of a vector are those of x with `d`s in front. With [`By::Epsilon`], 1/ε is one more
    /// parameter, the last.
    #[must_use]
    pub fn sensitivities(&self, by: &[By]) -> System {
        let field = &self.field;
        let dimension = field.dimension();
        let symbols = field.symbols.with_tangents(by);
        let renamed = |polynomial: &Polynomial| {
            polynomial.map_variables(|variable| symbols.variable(field.symbols.symbol(variable)))
        };
        let moved = |component: &Component| Component {
            numerator: renamed(&component.numerator),
            denominator: renamed(&component.denominator),
        };
        let along = |(vector, by): (usize, By), component: &Component| {
            let Component { numerator, denominator } = component;
            let slopes = (0..dimension).map(|k| {
                let slope = renamed(&numerator.derivative(field.symbols.state(k)));
                &slope * &Polynomial::variable(symbols.state((vector + 1) * dimension + k))
            });
            let slopes: Vec<Polynomial> = slopes.collect();
            let mut sum = Polynomial::sum_of(slopes.iter().map(|slope| (false, slope)));
            let mut divisor = denominator.clone();
            let source = match by {
                By::Start => None,
                By::Parameter(k) => {
                    let slope = |of: &Polynomial| of.derivative(field.symbols.parameter(k));
                    Some((slope(numerator), slope(denominator), Polynomial::one()))
                }
                By::Epsilon => {
                    let eps = field.symbols.epsilon();
                    let slope = |of: &Polynomial| &of.derivative(eps) * &Polynomial::variable(eps);
                    let inverse = Polynomial::variable(symbols.parameter(symbols.parameters.len() - 1));
                    Some((numerator + &slope(numerator), slope(denominator), inverse))
                }
            };
            if let Some((above, below, factor)) = source {
                sum = &sum + &(&renamed(&above) * &factor);
                if !below.is_zero() {
                    let bent = &renamed(&(numerator * &below)) * &factor;
                    sum = &(&sum * &renamed(denominator)) - &bent;
                    divisor = denominator * denominator;
                }
            }
            let denominator = renamed(&divisor);
            let common = gcd(&sum, &denominator);
            let [numerator, denominator] =
                [sum, denominator].map(|of| of.checked_div(&common).expect("a common divisor divides"));
            Component { numerator, denominator }
        };
        let of_vector = |own: (usize, By)| field.components.iter().map(move |one| along(own, one));
        let vectors = by.iter().copied().enumerate().flat_map(of_vector);
        let components = field.components.iter().map(moved).chain(vectors);
        System {
            header: None,
            constants: self.constants.clone(),
            kept: self.kept.sensitivities(&field.symbols, &symbols, by).into(),
            field: Field { components: components.collect(), symbols: symbols.clone() }.into(),
            written: Arc::default(),
            claims: Vec::new(),
        }
    }
}

impl Symbols {
    /// Adds names of a vector for each entry of `by`, and a parameter where one is by ε.
    fn with_tangents(&self, by: &[By]) -> Symbols {
        let (mut states, mut parameters) = (self.states.clone(), self.parameters.clone());
        for state in by.iter().flat_map(|_| &self.states) {
            let mut name = format!("d{state}");
            while states.contains(&name) || parameters.contains(&name) {
                name.insert(0, 'd');
            }
            states.push(name);
        }
        if by.contains(&By::Epsilon) {
            let mut name = "inverse_eps".to_owned();
            while states.contains(&name) || parameters.contains(&name) {
                name.push('_');
            }
            parameters.push(name);
        }
        Symbols { states, parameters }
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
