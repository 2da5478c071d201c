//! The numerators of the bilinear form Q(x, y) = ½[Q(x+y) − Q(x) − Q(y)] and of the polarised
//! field.

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::poly::{Monomial, Polynomial};
use crate::symbols::Symbol;

/// Returns the numerators of the bilinear form Q(x, y). Their denominators are those of the field.
/// The second states stand for y.
#[must_use]
pub fn bilinear_form(field: &Field) -> Vec<Polynomial> {
    (0..field.dimension()).map(|i| polarize(field, &field.homogeneous_part(i, 2))).collect()
}

/// Returns the numerators of the polarised field f(x,y), for which f(x,x) = f(x). Their
/// denominators are those of f. The second states stand for y.
#[must_use]
pub fn polarization(field: &Field) -> Vec<Polynomial> {
    (0..field.dimension()).map(|i| polarize(field, field.components[i].numerator())).collect()
}

/// Replaces xⱼxₖ by ½(xⱼyₖ + xₖyⱼ) and xⱼ by ½(xⱼ + yⱼ), where y are the second states.
fn polarize(field: &Field, polynomial: &Polynomial) -> Polynomial {
    let symbols = &field.symbols;
    let first = |i: usize| Monomial::variable(symbols.state(i));
    let second = |i: usize| Monomial::variable(symbols.variable(Symbol::SecondState(i)));
    let half = Rational::new(1, 2);
    let mut terms = Vec::new();
    for (monomial, coefficient) in polynomial.terms() {
        let (_, parameters) = monomial.split(|variable| symbols.is_state(variable));
        let mut push =
            |states: Monomial, factor: &Rational| terms.push((parameters.mul(&states), coefficient * factor));
        match field.states_of(monomial)[..] {
            [j, k] => {
                push(first(j).mul(&second(k)), &half);
                push(first(k).mul(&second(j)), &half);
            }
            [j] => {
                push(first(j), &half);
                push(second(j), &half);
            }
            _ => push(Monomial::one(), &Rational::one()),
        }
    }
    Polynomial::from_terms(terms)
}
