//! Proves the claims of a family for every number of sites. Sums over sites are reduced to finitely
//! many terms ([`everywhere`](super::everywhere)).

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Boundary, Name};
use rustc_hash::FxHashMap;

use crate::poly::{Budget, Monomial, Polynomial, WithinBudget};
use crate::rational_function::RationalFunction;
use crate::render::{Notation, Text};

use super::everywhere::{MOST_WORK, MiddleSite, SiteRange, budget, product};
use super::expand::Chain;
use super::hamiltonian::check_hamiltonian;
use super::{Family, SiteSum};

/// Reports every false claim of the family.
pub fn check_claims(family: &Family, diagnostics: &mut Diagnostics) {
    for integral in &family.integrals {
        if let Err(mistake) = linear_integral(family, integral) {
            diagnostics.push(mistake);
        }
    }
    if let Some(hamiltonian) = &family.hamiltonian
        && let Err(mistake) = check_hamiltonian(family, hamiltonian)
    {
        diagnostics.push(mistake);
    }
}

/// Checks a linear integral such as Σ xᵢ. The map preserves linear integrals of the field.
fn linear_integral(family: &Family, integral: &SiteSum) -> Result<(), Diagnostic> {
    let name = &integral.name;
    let degree = family.symbols.degree(integral.density.numerator());
    if degree > 1 {
        let message = format!(
            "`{}` is of degree {degree}: of sums over all sites, linear ones are proved for every chain",
            name.text
        );
        let help = "write `hamiltonian` for the energy; at a given number of sites `kahan discover --sites 4` looks for others";
        return Err(Diagnostic::new(Kind::Claim, integral.written.span, message, help));
    }
    let over_budget = |_| too_long(name);
    let middle = MiddleSite::of(family);
    if degree == 0 || is_constant(&middle, integral, &mut budget()).map_err(over_budget)? {
        let message = format!("`{}` says nothing: it depends on no state", name.text);
        let help = "write a sum of states, as in `sum(x[i])`";
        return Err(Diagnostic::new(Kind::FalseClaim, name.span, message, help));
    }
    if cancels(&middle, integral, &mut budget()).map_err(over_budget)? {
        return Ok(());
    }
    let budget = &mut budget();
    for sites in 1..=middle.chain.sites {
        let chain = family.chain(sites);
        if let Some(left) = derivative(&chain, integral, budget).map_err(over_budget)? {
            let text = Text.polynomial(&chain.symbols, &left);
            let message = format!(
                "`{}` is not kept: in a chain of {sites} {} its derivative is {text}",
                name.text,
                plural(sites)
            );
            let help = "correct the claim or the equations; at a given number of sites `kahan discover --sites 4` finds what the map keeps";
            return Err(Diagnostic::new(Kind::FalseClaim, name.span, message, help));
        }
    }
    Ok(())
}

pub(super) fn too_long(name: &Name) -> Diagnostic {
    let message = format!("to prove `{}` takes more than {MOST_WORK} products of terms", name.text);
    let help = "remove the claim, or let it and the equations reach fewer neighbours, in fewer terms; at a given number of sites `kahan discover --sites 4` finds what the map keeps";
    Diagnostic::new(Kind::TooLarge, name.span, message, help)
}

/// Returns whether the sum over all sites contains no state, as `sum(x[i+1] - x[i])` in a ring.
fn is_constant(middle: &MiddleSite<'_>, sum: &SiteSum, budget: &mut Budget) -> WithinBudget<bool> {
    let density = middle.at(&sum.density, 0);
    let mut slopes: FxHashMap<(usize, SiteRange), RationalFunction> = FxHashMap::default();
    for (monomial, value) in density.numerator().terms() {
        let mut variables = monomial.powers().iter().map(|(variable, _)| *variable);
        let Some(state) = variables.find(|variable| middle.chain.symbols.is_state(*variable)) else {
            continue;
        };
        let (offset, array) = middle.state(state);
        budget.charge(1 + density.denominator().len() as u64)?;
        let extent = middle.extent(monomial, middle.extent_of_site(0));
        let extent = middle.moved(extent, -offset);
        let slope = monomial.lowered(state).expect("it occurs");
        let slope = Polynomial::term(middle.shifted(&slope, -offset), value.clone());
        let below = middle.shifted_polynomial(density.denominator(), -offset);
        let slope = RationalFunction::new_within(slope, below, budget)?.expect("a divisor is not zero");
        let total = slopes.entry((array, extent)).or_insert_with(RationalFunction::zero);
        *total = total.add_within(&slope, budget)?;
    }
    Ok(slopes.values().all(RationalFunction::is_zero))
}

/// Returns `true` only if the derivative of the sum along the field vanishes in every chain. The
/// derivative may vanish despite `false`, because terms with different divisors are not combined.
pub(super) fn cancels(middle: &MiddleSite<'_>, sum: &SiteSum, budget: &mut Budget) -> WithinBudget<bool> {
    let density = middle.at(&sum.density, 0);
    let mut terms: FxHashMap<(Polynomial, Monomial, usize), Rational> = FxHashMap::default();
    for state in
        density.numerator().variables().into_iter().filter(|&state| middle.chain.symbols.is_state(state))
    {
        let (offset, array) = middle.state(state);
        let component = middle.at(&middle.chain.family.components[array], offset);
        let place = middle.extent_of_site(0).with(middle.extent_of_site(offset));
        let below = product(density.denominator(), component.denominator(), budget)?;
        let content = below.monomial_content();
        budget.charge(density.numerator().len() as u64)?;
        for (written, value) in density.numerator().terms() {
            let Some(slope) = written.lowered(state) else { continue };
            budget.charge((component.numerator().len() * (1 + below.len())) as u64)?;
            for (factor, by) in component.numerator().terms() {
                let extent = middle.extent(factor, middle.extent(&slope, place));
                let above = slope.mul(factor);
                let common = above.gcd(&content);
                let above = above.div(&common).expect("a common divisor divides");
                let below = below.div_monomial(&common).expect("a common divisor divides");
                let first = match middle.chain.family.boundary {
                    Boundary::Open => extent.first,
                    Boundary::Periodic => {
                        middle.first_site(below.terms().map(|(monomial, _)| monomial).chain([&above]))
                    }
                };
                let by_first = -(first as i64);
                let below = middle.shifted_polynomial(&below, by_first);
                let total =
                    terms.entry((below, middle.shifted(&above, by_first), extent.sites())).or_default();
                *total = &*total + &(value * by);
            }
        }
    }
    Ok(terms.values().all(Rational::is_zero))
}

pub(super) fn plural(sites: usize) -> &'static str {
    if sites == 1 { "site" } else { "sites" }
}

fn derivative(chain: &Chain<'_>, sum: &SiteSum, budget: &mut Budget) -> WithinBudget<Option<Polynomial>> {
    let Chain { family, symbols, sites } = chain;
    let mut groups: Vec<(Polynomial, Polynomial)> = Vec::new();
    for site in 0..*sites {
        let Some(density) = chain.moved(&sum.density, site) else { continue };
        let states =
            density.numerator().variables().into_iter().filter(|variable| symbols.is_state(*variable));
        for state in states {
            let place = usize::from(state.0);
            let (site, array) = (place / family.block(), place % family.block());
            let Some(component) = chain.moved(&family.components[array], site) else { continue };
            let slope = density.numerator().derivative(state);
            let above = product(&slope, component.numerator(), budget)?;
            let below = product(density.denominator(), component.denominator(), budget)?;
            match groups.iter_mut().find(|(divisor, _)| *divisor == below) {
                Some((_, total)) => *total = total.add_within(&above, budget)?,
                None => groups.push((below, above)),
            }
        }
    }
    let mut total = RationalFunction::zero();
    for (below, above) in groups.into_iter().filter(|(_, above)| !above.is_zero()) {
        if let Some(quotient) = RationalFunction::new_within(above, below, budget)? {
            total = total.add_within(&quotient, budget)?;
        }
    }
    Ok((!total.is_zero()).then(|| total.numerator().clone()))
}
