//! Beyond the ends of an open chain: states are 0 there, and parameters of sites have no value.

use kahan_syntax::diagnostics::{Diagnostics, Kind};
use kahan_syntax::syntax::{Block, Reference};

use crate::family::{Family, Role};
use crate::poly::Monomial;
use crate::rational_function::RationalFunction;

/// Reports parameters of neighbours that are needed where there is no neighbour: they may only
/// multiply a state that lies as far outside, which is 0.
pub(super) fn values_beyond_the_ends(family: &Family, block: &Block, diagnostics: &mut Diagnostics) {
    let equations = family.components.iter().zip(&block.equations);
    let equations =
        equations.filter_map(|(component, equation)| Some((component, equation.value.as_ref()?.span)));
    let sums = family.sums().map(|sum| (&sum.density, sum.written.span));
    for (component, span) in equations.chain(sums) {
        if let Some(name) = undefined(family, component) {
            let message = format!("`{name}` has no value where site `i` is the last one on that side");
            let help = "beyond the ends of an open chain only states have a value, 0: use the parameter of site `i`, \
                        or multiply by a state at the same site";
            diagnostics.report(Kind::Name, span, message, help);
        }
    }
}

/// A parameter that a quotient needs beyond an end.
fn undefined(family: &Family, component: &RationalFunction) -> Option<String> {
    let divisors = component.denominator().terms().map(|(monomial, _)| monomial);
    let divisor = divisors.filter_map(|monomial| beyond(family, monomial, (0, 0))).next();
    divisor.or_else(|| {
        let terms = component.numerator().terms();
        terms.filter_map(|(monomial, _)| beyond(family, monomial, states(family, monomial))).next()
    })
}

/// The smallest and the largest offset of the states of a monomial, and 0.
fn states(family: &Family, monomial: &Monomial) -> (i64, i64) {
    let offsets = monomial.powers().iter().filter_map(|&(variable, _)| match family.role(variable) {
        Role::State { offset, .. } => Some(offset),
        _ => None,
    });
    offsets.fold((0, 0), |(least, most), offset| (least.min(offset), most.max(offset)))
}

/// A parameter of a site outside of these offsets.
fn beyond(family: &Family, monomial: &Monomial, (least, most): (i64, i64)) -> Option<String> {
    monomial.powers().iter().find_map(|&(variable, _)| match family.role(variable) {
        Role::SiteParameter { offset, index } if offset < least || offset > most => {
            Some(Reference::Site { array: &family.site_parameters[index], offset }.to_string())
        }
        _ => None,
    })
}
