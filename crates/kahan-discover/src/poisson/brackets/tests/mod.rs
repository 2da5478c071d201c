//! Tests of constructed and proved brackets in any dimension.

mod dimensions;
mod limits;
mod tables;

use kahan_algebra::poly::{Monomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::{System, upper_index};
use kahan_algebra::{lexer, read};

use super::construct::invariant_tensor;
use super::*;
use crate::deadline::WatchedSearch;
use crate::tests::{Ticking, claim, function, functions};

fn system(text: &str) -> System {
    let reading = read(&lexer::lex(text).tokens);
    assert!(reading.diagnostics().is_empty(), "{:?}", reading.diagnostics());
    reading.system().expect("a system")
}

fn stated(system: &System, name: &str) -> RationalFunction {
    function(claim(system, name))
}

fn tensor_of(system: &System, name: &str) -> Vec<RationalFunction> {
    functions(claim(system, name))
}

fn bracket(
    system: &System,
    density: &RationalFunction,
    integrals: &[RationalFunction],
) -> Option<Vec<RationalFunction>> {
    let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
    invariant_tensor(&system.field.symbols, density, integrals, &mut budget)
}

/// Returns whether a tensor is proved to be Poisson and invariant under the map of a system.
fn is_proved_at(system: &System, values: &[(String, Rational)], tensor: &[RationalFunction]) -> bool {
    let claims = Claims::new(system, values, None);
    claims.bracket(1, 2, &claims.bracket_entries(&system.field.symbols, tensor)).is_some()
}

fn is_proved(system: &System, tensor: &[RationalFunction]) -> bool {
    is_proved_at(system, &[], tensor)
}

/// Tests Jacobi's identity of a tensor in x, y, z. The map of the zero field preserves all tensors.
fn is_poisson(tensor: &[RationalFunction]) -> bool {
    is_proved(&system("xdot = 0; ydot = 0; zdot = 0;"), tensor)
}

fn power(variable: Variable, exponent: u32) -> RationalFunction {
    Polynomial::term(Monomial::power(variable, exponent), Rational::one()).into()
}

fn sum(left: &[RationalFunction], right: &[RationalFunction]) -> Vec<RationalFunction> {
    left.iter().zip(right).map(|(left, right)| left + right).collect()
}

/// E1 with a further component w, which is proportional to y along solutions.
const E1_IN_FOUR: &str = "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z; wdot = -x*w;
    integral H = y/x; integral K = (x*z + y^2)/(1 - eps^2*x^2); integral L = w/x;
    density rho = 1/(x^2*y*(x*z + y^2));";
