//! `sum(…)` in the claims of a family: what it sums.

use kahan_syntax::diagnostics::{Diagnostic, Kind};
use kahan_syntax::syntax::{Expr, ExprKind, Factor, InFamily, Reference, Term};

/// What a claim sums over all sites: the claim with `sum` taken off, as sums are linear.
pub(super) fn summand(expr: &Expr) -> Result<Expr, Diagnostic> {
    let with = |kind| Ok(Expr { kind, span: expr.span });
    match &expr.kind {
        ExprKind::Special(InFamily::OverSites(inner)) => match find_sum(inner) {
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
                return Err(outside(expr));
            }
            if let Some(factor) = others.clone().find(|factor| is_at_sites(&factor.expr)) {
                return Err(outside(&factor.expr));
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
        | ExprKind::Special(InFamily::Site { .. })
        | ExprKind::Power(..) => Err(outside(expr)),
    }
}

fn outside(expr: &Expr) -> Diagnostic {
    let message = "a claim of a family is a sum over all sites, and this stands outside of it";
    let help = "write `sum(…)` around what belongs to site `i`";
    Diagnostic::new(Kind::Claim, expr.span, message, help)
}

fn find_sum(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Special(InFamily::OverSites(_)) => Some(expr),
        _ => expr.parts().into_iter().find_map(find_sum),
    }
}

/// Whether a value at a site occurs.
fn is_at_sites(expr: &Expr) -> bool {
    let mut found = false;
    expr.visit_names(&mut |name, _| found |= matches!(name, Reference::Site { .. }));
    found
}
