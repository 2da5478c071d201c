//! Checks the names, equations and sums of a family.

use rustc_hash::FxHashSet;

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::syntax::{
    Block, Boundary, Claim, ClaimBody, ClaimKind, Expr, ExprKind, Factor, FamilyHead, FamilySyntax,
    Reference, Term,
};

use crate::family::{Family, Role, SiteSum};
use crate::poly::Monomial;
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;

use super::constants;
use super::equations;
use super::expand::{expand_in_claim, is_spent};
use super::names::{Scope, references};
use super::stand_in::StandIn;
use super::{report_names, report_size};

pub(crate) fn check_family(
    block: &Block,
    head: &FamilyHead,
    diagnostics: &mut Diagnostics,
) -> (StandIn, Option<Family>) {
    let before = diagnostics.len();
    if report_size(block, diagnostics) {
        return (StandIn::of_type(block.header.clone()), None);
    }
    report_items_beside_family(block, head, diagnostics);
    let equations = block.equations[head.equations_before..head.equations_until].to_vec();
    let block = &Block { equations, ..block.clone() };
    let declared = Scope::new(block, diagnostics);
    let names = FamilyNames::of(block, &declared.symbols);
    if report_names(names.seen() + block.constants.len(), block, diagnostics) {
        return (StandIn::of_type(block.header.clone()), None);
    }
    let mut scope = declared.with(names.symbols());
    names.report_plain_arrays(block, &mut scope, diagnostics);
    let constants = constants::evaluate(block, &mut scope, diagnostics);
    let (components, kept) = equations::expand_all(block, &mut scope, diagnostics);
    let sums = |claims: &[Claim], scope: &mut Scope, diagnostics: &mut Diagnostics| -> Vec<SiteSum> {
        claims.iter().filter_map(|claim| sum(claim, &names.arrays, scope, diagnostics)).collect()
    };
    let linear: Vec<Claim> =
        block.claims.iter().filter(|claim| claim.kind == ClaimKind::Integral).cloned().collect();
    let integrals = sums(&linear, &mut scope, diagnostics);
    let hamiltonians = sums(&block.hamiltonians, &mut scope, diagnostics);
    if let [_, second, ..] = &*block.hamiltonians {
        let help = "write one";
        diagnostics.report(Kind::Claim, second.name.span, "a family has one Hamiltonian", help);
    }
    scope.report_unused(block, diagnostics);
    let mut stand_in = StandIn::of_type(block.header.clone());
    stand_in.symbols.parameters.clone_from(&names.parameters);
    stand_in.site_parameters.clone_from(&names.site_parameters);
    let family = Family {
        header: block.header.clone(),
        constants,
        boundary: head.boundary,
        arrays: names.arrays,
        parameters: names.parameters,
        site_parameters: names.site_parameters,
        reach: names.reach,
        symbols: scope.symbols,
        components,
        kept,
        integrals,
        hamiltonian: hamiltonians.into_iter().next(),
        span: head.span,
    };
    if family.boundary == Boundary::Open && diagnostics.len() == before {
        values_beyond_the_ends(&family, block, diagnostics);
    }
    (stand_in, diagnostics.is_empty().then_some(family))
}

fn report_items_beside_family(block: &Block, head: &FamilyHead, diagnostics: &mut Diagnostics) {
    for (index, equation) in block.equations.iter().enumerate() {
        if !(head.equations_before..head.equations_until).contains(&index) {
            let help =
                format!("write `{}[i]dot = …;` into the family, or a block of its own", equation.state.text);
            let message =
                "a block has equations or one family, and this equation stands outside of the family";
            diagnostics.report(Kind::Syntax, equation.state.span, message, help);
        }
    }
    if head.equations_before == head.equations_until && diagnostics.is_empty() {
        let help = "write one equation an array, as in `x[i]dot = x[i]*(x[i+1] - x[i-1]);`";
        diagnostics.report(Kind::Empty, head.span, "the family holds no equation", help);
    }
    for claim in &block.claims {
        if claim.kind != ClaimKind::Integral {
            let message = format!("a family has no `{}`", claim.kind.keyword());
            let help = "it may claim `integral S = sum(…);` and `hamiltonian H = sum(…);`";
            diagnostics.report(Kind::Claim, claim.name.span, message, help);
        }
    }
    for claim in block.claims.iter().chain(&block.hamiltonians) {
        if let Some(condition) = claim.conditions.first() {
            let help = "remove `when`, or fix the parameter by `const`";
            diagnostics.report(Kind::Claim, condition.span(), "claims of a family have no conditions", help);
        }
    }
}

struct FamilyNames {
    arrays: Vec<String>,
    parameters: Vec<String>,
    site_parameters: Vec<String>,
    reach: usize,
}

impl FamilyNames {
    /// Collects the names of a family. A parameter with an index is a parameter of each site.
    fn of(block: &Block, declared: &Symbols) -> Self {
        let (mut reach, mut at_sites) = (1, FxHashSet::default());
        for (reference, _) in references(block) {
            if let Reference::Site { array, offset } = reference {
                reach = reach.max(offset.unsigned_abs() as usize);
                at_sites.insert(array);
            }
        }
        let Symbols { states, parameters } = declared.clone();
        let (site_parameters, parameters) =
            parameters.into_iter().partition(|name| at_sites.contains(name.as_str()));
        FamilyNames { arrays: states, parameters, site_parameters, reach }
    }

    fn seen(&self) -> usize {
        (2 * self.reach + 1) * (self.arrays.len() + self.site_parameters.len()) + self.parameters.len()
    }

    fn symbols(&self) -> Symbols {
        let reach = self.reach as i64;
        let at = |array: &String, offset| Reference::Site { array, offset }.to_string();
        let states =
            (-reach..=reach).flat_map(|offset| self.arrays.iter().map(move |array| at(array, offset)));
        let of_sites =
            self.site_parameters.iter().flat_map(|name| (-reach..=reach).map(move |offset| at(name, offset)));
        Symbols {
            states: states.collect(),
            parameters: self.parameters.iter().cloned().chain(of_sites).collect(),
        }
    }

    fn report_plain_arrays(&self, block: &Block, scope: &mut Scope, diagnostics: &mut Diagnostics) {
        let at_sites: FxHashSet<&str> =
            self.arrays.iter().chain(&self.site_parameters).map(String::as_str).collect();
        for (reference, span) in references(block) {
            let Reference::Name(name) = reference else { continue };
            if at_sites.contains(name) && !scope.is_poisoned(name) {
                let message = format!("`{name}` has a value at each site");
                diagnostics.report(Kind::Name, span, message, format!("write `{name}[i]`"));
                scope.poison(name);
            }
        }
    }
}

fn sum(
    claim: &Claim,
    arrays: &[String],
    scope: &mut Scope,
    diagnostics: &mut Diagnostics,
) -> Option<SiteSum> {
    let name = &claim.name;
    if arrays.contains(&name.text) {
        let message = format!("the claim `{}` has the name of an array", name.text);
        diagnostics.report(Kind::Name, name.span, message, "rename the claim");
        return None;
    }
    if !scope.is_free(name, "claim", diagnostics) {
        return None;
    }
    scope.claims.push(name.text.clone());
    let Some(ClaimBody::Function(written)) = &claim.body else { return None };
    if !scope.resolve(written, true, diagnostics) || is_spent(scope) {
        return None;
    }
    let density = density(written, scope).map_err(|mistake| diagnostics.push(mistake)).ok()?;
    Some(SiteSum { name: name.clone(), written: written.clone(), density })
}

fn density(written: &Expr, scope: &Scope) -> Result<RationalFunction, Diagnostic> {
    let density = expand_in_claim(&summand(written)?, scope)?.function();
    if density.contains(scope.symbols.epsilon()) {
        let message = "a sum over sites that is claimed is free of `eps`";
        let help = "write the sum that the field keeps; what the map keeps is made of it";
        return Err(Diagnostic::new(Kind::Claim, written.span, message, help));
    }
    Ok(density)
}

/// Returns a claim's expression with each `sum(…)` replaced by its argument.
fn summand(expr: &Expr) -> Result<Expr, Diagnostic> {
    let with = |kind| Ok(Expr { kind, span: expr.span });
    match &expr.kind {
        ExprKind::Special(FamilySyntax::OverSites(inner)) => match find_sum(inner) {
            Some(nested) => Err(Diagnostic::new(
                Kind::Claim,
                nested.span,
                "a `sum(…)` inside of a `sum(…)`",
                "sum once: densities couple neighbours, as in `sum(x[i]*x[i+1])`",
            )),
            None => Ok((**inner).clone()),
        },
        ExprKind::Negation(inner) => with(ExprKind::Negation(Box::new(summand(inner)?))),
        ExprKind::Sum(terms) => {
            let term = |term: &Term| Ok(Term { negative: term.negative, expr: summand(&term.expr)? });
            with(ExprKind::Sum(terms.iter().map(term).collect::<Result<_, Diagnostic>>()?))
        }
        ExprKind::Product(factors) => {
            let sums = factors.iter().filter(|factor| !factor.divides && find_sum(&factor.expr).is_some());
            let others = factors.iter().filter(|factor| find_sum(&factor.expr).is_none());
            if sums.count() != 1 || others.clone().count() + 1 != factors.len() {
                return Err(outside_sum(expr));
            }
            if let Some(factor) = others.clone().find(|factor| is_at_sites(&factor.expr)) {
                return Err(outside_sum(&factor.expr));
            }
            let factor = |factor: &Factor| {
                let expr = match find_sum(&factor.expr) {
                    Some(_) => summand(&factor.expr)?,
                    None => factor.expr.clone(),
                };
                Ok(Factor { divides: factor.divides, expr })
            };
            with(ExprKind::Product(factors.iter().map(factor).collect::<Result<_, Diagnostic>>()?))
        }
        ExprKind::Number(_)
        | ExprKind::Name(_)
        | ExprKind::Special(FamilySyntax::Site { .. })
        | ExprKind::Power(..) => Err(outside_sum(expr)),
    }
}

fn outside_sum(expr: &Expr) -> Diagnostic {
    let message = "a claim of a family is a sum over all sites, and this stands outside of it";
    let help = "write `sum(…)` around what belongs to site `i`";
    Diagnostic::new(Kind::Claim, expr.span, message, help)
}

fn find_sum(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Special(FamilySyntax::OverSites(_)) => Some(expr),
        _ => expr.parts().into_iter().find_map(find_sum),
    }
}

fn is_at_sites(expr: &Expr) -> bool {
    let mut found = false;
    expr.visit_names(&mut |name, _| found |= matches!(name, Reference::Site { .. }));
    found
}

/// Reports parameters of sites beyond an end of the chain, where they are undefined. A term may
/// contain one if it also contains a state at its site or farther out, because this state is 0.
fn values_beyond_the_ends(family: &Family, block: &Block, diagnostics: &mut Diagnostics) {
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

fn undefined(family: &Family, component: &RationalFunction) -> Option<String> {
    let divisors = component.denominator().terms().map(|(monomial, _)| monomial);
    let divisor = divisors.filter_map(|monomial| beyond_reach(family, monomial, (0, 0))).next();
    divisor.or_else(|| {
        let terms = component.numerator().terms();
        terms.filter_map(|(monomial, _)| beyond_reach(family, monomial, states(family, monomial))).next()
    })
}

fn states(family: &Family, monomial: &Monomial) -> (i64, i64) {
    let offsets = monomial.powers().iter().filter_map(|&(variable, _)| match family.role(variable) {
        Role::State { offset, .. } => Some(offset),
        _ => None,
    });
    offsets.fold((0, 0), |(least, most), offset| (least.min(offset), most.max(offset)))
}

fn beyond_reach(family: &Family, monomial: &Monomial, (least, most): (i64, i64)) -> Option<String> {
    monomial.powers().iter().find_map(|&(variable, _)| match family.role(variable) {
        Role::SiteParameter { offset, index } if offset < least || offset > most => {
            Some(Reference::Site { array: &family.site_parameters[index], offset }.to_string())
        }
        _ => None,
    })
}
