//! Evaluates exactly the equation A(x,ε)(x̃ − x) = 2εf(x) of Kahan's step x̃, with A = I − εf′(x).
//!
//! Each row is multiplied by the denominator of its component of f. Polynomials are evaluated term
//! by term, independently of the tested code.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::system::System;

use super::dyadic::Dyadic;
use super::polynomial::{Powers, Terms, common_denominator, greatest_power};

#[derive(Debug)]
pub(crate) struct Equation {
    rows: Vec<Row>,
    degree: usize,
    states: usize,
    parameters: usize,
}

/// A component p/q of the field: p, q, and ∂p/∂xⱼ for every state xⱼ that p depends on.
#[derive(Debug)]
struct Row {
    field: Terms,
    denominator: Terms,
    slopes: Vec<(usize, Terms)>,
    /// The second derivatives ∂²p/∂xⱼ∂xₖ that are not zero.
    curvature: Vec<(usize, usize, Terms)>,
}

#[derive(Debug)]
pub(crate) struct Curvature {
    pub(crate) first: usize,
    pub(crate) second: usize,
    pub(crate) value: Dyadic,
}

#[derive(Debug)]
pub(crate) struct AtPoint {
    pub(crate) x: Vec<Dyadic>,
    pub(crate) eps: Dyadic,
    pub(crate) rows: Vec<RowAtPoint>,
}

/// The values of a [`Row`] at a point.
#[derive(Debug)]
pub(crate) struct RowAtPoint {
    pub(crate) field: Dyadic,
    pub(crate) denominator: Dyadic,
    pub(crate) slopes: Vec<(usize, Dyadic)>,
}

impl Equation {
    pub(crate) fn of(system: &System) -> Self {
        let symbols = &system.field.symbols;
        let row = |component: &RationalFunction| {
            let (numerator, denominator) = (component.numerator(), component.denominator());
            let scale = common_denominator([numerator, denominator]);
            let terms = |polynomial: &Polynomial| Terms::of(polynomial, &scale);
            let derivatives = |polynomial: &Polynomial| {
                let states = polynomial.variables().into_iter().filter(|v| symbols.is_state(*v));
                let derivatives = states.map(|v| (usize::from(v.0), polynomial.derivative(v)));
                derivatives.collect::<Vec<_>>()
            };
            let slopes = derivatives(numerator);
            let seconds = slopes.iter().flat_map(|(j, slope)| {
                derivatives(slope).into_iter().map(|(k, second)| (*j, k, terms(&second)))
            });
            Row {
                field: terms(numerator),
                denominator: terms(denominator),
                curvature: seconds.collect(),
                slopes: slopes.iter().map(|(j, slope)| (*j, terms(slope))).collect(),
            }
        };
        let all = system.field.numerators().chain(system.field.denominators());
        Self {
            rows: system.field.components.iter().map(row).collect(),
            degree: greatest_power(all),
            states: symbols.dimension(),
            parameters: symbols.parameters.len(),
        }
    }

    pub(crate) fn dimension(&self) -> usize {
        self.states
    }

    pub(crate) fn epsilon(&self) -> usize {
        self.states + self.parameters
    }

    pub(crate) fn at(&self, point: &[Dyadic]) -> AtPoint {
        let powers = Powers::of(point, self.degree);
        let row = |row: &Row| RowAtPoint {
            field: row.field.at(&powers),
            denominator: row.denominator.at(&powers),
            slopes: row.slopes.iter().map(|(j, slope)| (*j, slope.at(&powers))).collect(),
        };
        AtPoint {
            rows: self.rows.iter().map(row).collect(),
            x: point[..self.states].to_vec(),
            eps: point[self.epsilon()].clone(),
        }
    }

    pub(crate) fn curvature(&self, point: &[Dyadic]) -> Vec<Vec<Curvature>> {
        let powers = Powers::of(point, self.degree);
        let row = |row: &Row| {
            let entries = row.curvature.iter();
            entries
                .map(|(j, k, terms)| Curvature { first: *j, second: *k, value: terms.at(&powers) })
                .collect()
        };
        self.rows.iter().map(row).collect()
    }
}

impl AtPoint {
    pub(crate) fn is_defined(&self) -> bool {
        self.rows.iter().all(|row| !row.denominator.is_zero())
    }

    /// Returns the entries of row i of A(x,ε), times the denominator qᵢ of component i. The
    /// diagonal entry comes first.
    pub(crate) fn row(&self, i: usize) -> Vec<(usize, Dyadic)> {
        let row = &self.rows[i];
        let mut entries = vec![(i, row.denominator.clone())];
        for (j, slope) in &row.slopes {
            let entry = slope * &self.eps;
            if *j == i {
                entries[0].1 = &entries[0].1 - &entry;
            } else {
                entries.push((*j, &Dyadic::zero() - &entry));
            }
        }
        entries
    }

    /// Returns the right-hand side 2εpᵢ of row i, where pᵢ is the numerator of component i.
    pub(crate) fn increment(&self, i: usize) -> Dyadic {
        (&self.rows[i].field * &self.eps).scaled(1)
    }

    /// Returns an approximation of ‖f′(x)‖∞.
    pub(crate) fn slope(&self) -> f64 {
        let sum = |row: &RowAtPoint| {
            row.slopes.iter().fold(Dyadic::zero(), |sum, (_, slope)| &sum + &slope.clone().abs())
        };
        self.rows.iter().map(|row| sum(row).ratio(&row.denominator)).fold(0.0, f64::max)
    }
}
