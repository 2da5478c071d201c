//! What the map of a family keeps, whatever the number of sites.
//!
//! A statement about every number of sites is one about finitely many. Which terms meet at a place
//! of the chain depends on its distance to the ends only, as far as couplings reach; so what holds
//! for all chains up to [`longest`] sites, in which places near the left end, near the right end
//! and in between occur by themselves, holds for all. Each chain is expanded and compared exactly.

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};

use crate::poly::Polynomial;
use crate::rational_function::RationalFunction;
use crate::render::{Notation, Text};
use crate::symbols::Symbols;

use super::hamiltonian::stencil;
use super::{Family, SiteSum};

/// The number of sites up to which chains are compared.
///
/// A claim couples sites at most its own reach apart, their equations as many more, so that terms
/// of the time derivative meet within four times the reach; past twice that, and a site for the
/// constant terms, nothing new occurs.
#[must_use]
pub fn longest(family: &Family) -> usize {
    8 * family.reach + 2
}

/// Reports every claim of the family that is false.
pub fn check_claims(family: &Family, diagnostics: &mut Diagnostics) {
    for integral in &family.integrals {
        if let Err(mistake) = linear_integral(family, integral) {
            diagnostics.push(mistake);
        }
    }
    if let Some(hamiltonian) = &family.hamiltonian
        && let Err(mistake) = stencil(family, hamiltonian)
    {
        diagnostics.push(mistake);
    }
}

/// Σ xᵢ and the like: kept by Kahan's map where it is kept by the field, as 2ε times the defining
/// equation is summed.
fn linear_integral(family: &Family, integral: &SiteSum) -> Result<(), Diagnostic> {
    let name = &integral.name;
    let degree = family.symbols.degree(&integral.density.numerator);
    if degree > 1 {
        return Err(Diagnostic::new(
            Kind::Claim,
            integral.written.span,
            format!(
                "`{}` is of degree {degree}: of sums over all sites, linear ones are proved for every chain",
                name.text
            ),
            "write `hamiltonian` for the energy; at a given number of sites `kahan discover --sites 4` looks for others",
        ));
    }
    if degree == 0 || is_constant(family, integral) {
        return Err(Diagnostic::new(
            Kind::FalseClaim,
            name.span,
            format!("`{}` says nothing: it depends on no state", name.text),
            "write a sum of states, as in `sum(x[i])`",
        ));
    }
    for sites in 1..=longest(family) {
        let symbols = family.symbols_at(sites);
        if let Some(left) = derivative(family, integral, sites, &symbols) {
            let text = Text.polynomial(&symbols, &left);
            return Err(Diagnostic::new(
                Kind::FalseClaim,
                name.span,
                format!(
                    "`{}` is not kept: in a chain of {sites} {} its derivative is {text}",
                    name.text,
                    plural(sites)
                ),
                "correct the claim or the equations; at a given number of sites `kahan discover --sites 4` finds what the map keeps",
            ));
        }
    }
    Ok(())
}

/// Whether the sum over a long chain depends on no state: its terms cancel, as those of
/// `sum(x[i+1] - x[i])` do in a ring.
fn is_constant(family: &Family, sum: &SiteSum) -> bool {
    let sites = longest(family);
    let symbols = family.symbols_at(sites);
    let mut slopes = vec![RationalFunction::zero(); symbols.dimension()];
    for site in 0..sites {
        let density = family.moved(&sum.density, site, sites, &symbols);
        for (k, slope) in slopes.iter_mut().enumerate() {
            let own = density.numerator.derivative(symbols.state(k));
            if let Some(own) = RationalFunction::new(own, density.denominator.clone()) {
                *slope = &*slope + &own;
            }
        }
    }
    slopes.iter().all(RationalFunction::is_zero)
}

pub(super) fn plural(sites: usize) -> &'static str {
    if sites == 1 { "site" } else { "sites" }
}

/// The numerator of the sum's derivative along the field; `None` where it vanishes.
fn derivative(family: &Family, sum: &SiteSum, sites: usize, symbols: &Symbols) -> Option<Polynomial> {
    let field = family.at_sites(sites).field;
    // Terms over one divisor cancel among themselves, most often all of them.
    let mut groups: Vec<(Polynomial, Polynomial)> = Vec::new();
    for site in 0..sites {
        let density = family.moved(&sum.density, site, sites, symbols);
        let states = density.numerator.variables().into_iter().filter(|variable| symbols.is_state(*variable));
        for state in states {
            let component = &field.components[usize::from(state.0)];
            let slope = density.numerator.derivative(state);
            let above = &slope * &component.numerator;
            let below = &density.denominator * &component.denominator;
            match groups.iter_mut().find(|(divisor, _)| *divisor == below) {
                Some((_, total)) => *total = &*total + &above,
                None => groups.push((below, above)),
            }
        }
    }
    let mut total = RationalFunction::zero();
    for (below, above) in groups.into_iter().filter(|(_, above)| !above.is_zero()) {
        if let Some(quotient) = RationalFunction::new(above, below) {
            total = &total + &quotient;
        }
    }
    (!total.is_zero()).then(|| total.numerator().clone())
}
