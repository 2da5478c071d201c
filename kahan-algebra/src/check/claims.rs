//! Claims: names resolved, entries of brackets in order, compiled to plans.

use rustc_hash::FxHashMap;

use crate::diagnostics::{Diagnostic, Diagnostics, Kind};
use crate::field::Component;
use crate::plan::{Node, Plan, PlanBuilder};
use crate::rational::Rational;
use crate::syntax::{self, Block, ClaimBody, ClaimKind, Expr, ExprKind, Reference};
use crate::system::{Claim, upper_index};
use crate::token::Span;

use super::conditions;
use super::entries::entry_places;
use super::expand::{MOST_BITS, sum_out_of_place};
use super::names::{Meaning, Scope, expressions};

/// The largest exponent in a claim.
const HIGHEST_POWER: i64 = 64;

/// Compiles the claims in order. One that is broken keeps its name and a harmless zero, and is not
/// proved.
pub(super) fn compile_all(
    block: &Block,
    components: &[Component],
    scope: &mut Scope,
    diagnostics: &mut Diagnostics,
) -> Vec<Claim> {
    let mut compiler = Compiler { builder: PlanBuilder::default(), functions: FxHashMap::default() };
    let mut claims: Vec<Claim> = Vec::new();
    for claim in &block.claims {
        if !scope.is_free(&claim.name, "claim", diagnostics) {
            continue;
        }
        check_density_is_single(claim, &claims, diagnostics);
        let conditions = conditions::evaluate(&claim.conditions, components, scope, diagnostics);
        let entries = entry_places(claim, scope, diagnostics);
        let outputs = claim
            .body
            .as_ref()
            .filter(|body| {
                // Every expression is looked at, so that all unknown names are reported.
                let unsound =
                    expressions(body).into_iter().filter(|expr| !scope.resolve(expr, true, diagnostics));
                unsound.count() == 0
            })
            .zip(entries)
            .and_then(|(body, entries)| match compiler.body(body, &entries, scope) {
                Ok(outputs) => Some(outputs),
                Err(diagnostic) => {
                    diagnostics.push(diagnostic);
                    None
                }
            });
        scope.claims.push(claim.name.text.clone());
        let sound = outputs.is_some() && conditions.is_some();
        match outputs.as_deref() {
            Some([output]) if claim.kind != ClaimKind::Bracket => {
                compiler.functions.insert(claim.name.text.clone(), *output);
            }
            Some(_) => {}
            // The mistake in it is reported already, so later claims that use it are silent.
            None => scope.poison(&claim.name.text),
        }
        claims.push(Claim {
            kind: claim.kind,
            name: claim.name.clone(),
            body: claim.body.clone().filter(|_| sound),
            plan: compiler.plan(claim.kind, outputs.as_deref(), scope.symbols.dimension()),
            conditions: conditions.unwrap_or_default(),
        });
    }
    claims
}

fn check_density_is_single(claim: &syntax::Claim, earlier: &[Claim], diagnostics: &mut Diagnostics) {
    let is_second = claim.kind == ClaimKind::Density
        && claim.conditions.is_empty()
        && earlier.iter().any(|other| other.kind == ClaimKind::Density && other.is_unconditional());
    if is_second {
        diagnostics.report(
            Kind::Claim,
            claim.name.span,
            "a block has at most one density without `when`",
            "the quotient of two densities is an integral: write `integral R = …;`",
        );
    }
}

struct Compiler {
    builder: PlanBuilder,
    functions: FxHashMap<String, Node>,
}

impl Compiler {
    /// The results of a claim whose names and entries are sound.
    fn body(
        &mut self,
        body: &ClaimBody,
        entries: &[(usize, usize)],
        scope: &Scope,
    ) -> Result<Vec<Node>, Diagnostic> {
        match body {
            ClaimBody::Function(expr) => Ok(vec![self.node(expr, scope)?]),
            ClaimBody::Tensor(values) => {
                let n = scope.symbols.dimension();
                let zero = self.builder.constant(&Rational::zero());
                let mut upper = vec![zero; n * (n.max(1) - 1) / 2];
                for (entry, &(row, column)) in values.iter().zip(entries) {
                    let node = self.node(&entry.value, scope)?;
                    let place = upper_index(n, row.min(column), row.max(column));
                    upper[place] = if row < column { node } else { self.builder.negate(node) };
                }
                Ok(upper)
            }
        }
    }

    fn node(&mut self, expr: &Expr, scope: &Scope) -> Result<Node, Diagnostic> {
        match &expr.kind {
            ExprKind::Number(value) => Ok(self.builder.constant(value)),
            ExprKind::Name(name) => self.name(name, expr.span, scope),
            ExprKind::Site { array, offset } => {
                self.name(&Reference::Site { array, offset: *offset }.to_string(), expr.span, scope)
            }
            ExprKind::Negation(inner) => {
                let inner = self.node(inner, scope)?;
                Ok(self.builder.negate(inner))
            }
            ExprKind::Sum(terms) => {
                let mut sum = self.builder.constant(&Rational::zero());
                for term in terms {
                    let node = self.node(&term.expr, scope)?;
                    sum = if term.negative {
                        self.builder.subtract(sum, node)
                    } else {
                        self.builder.add(sum, node)
                    };
                }
                Ok(sum)
            }
            ExprKind::Product(factors) => {
                let mut product = self.builder.constant(&Rational::one());
                for factor in factors {
                    let node = self.node(&factor.expr, scope)?;
                    product = if factor.divides {
                        self.divide(product, node, factor.expr.span)?
                    } else {
                        self.builder.multiply(product, node)
                    };
                }
                Ok(product)
            }
            ExprKind::Power(base, exponent) => self.power(base, *exponent, expr.span, scope),
            ExprKind::OverSites(_) => Err(sum_out_of_place(expr.span)),
        }
    }

    fn name(&mut self, name: &str, span: Span, scope: &Scope) -> Result<Node, Diagnostic> {
        if let Some(node) = self.functions.get(name) {
            return Ok(*node);
        }
        match scope.meaning(name) {
            Some(Meaning::Variable(variable)) => Ok(self.builder.input(variable)),
            Some(Meaning::Constant(value)) => Ok(self.builder.constant(&value)),
            None => Err(Diagnostic::new(
                Kind::Claim,
                span,
                format!("`{name}` is a bracket, not a function"),
                "a claim may use earlier integrals and densities",
            )),
        }
    }

    fn power(&mut self, base: &Expr, exponent: i64, span: Span, scope: &Scope) -> Result<Node, Diagnostic> {
        let node = self.node(base, scope)?;
        let bits = self.builder.constant_size(node).map(|value| value.bits().max(1));
        let is_short_number =
            bits.is_some_and(|bits| bits.saturating_mul(exponent.unsigned_abs()) <= MOST_BITS);
        if !is_short_number && !(-HIGHEST_POWER..=HIGHEST_POWER).contains(&exponent) {
            return Err(Diagnostic::new(
                Kind::Exponent,
                span,
                format!("exponents in claims go from −{HIGHEST_POWER} to {HIGHEST_POWER}"),
                "write the claim with smaller powers",
            ));
        }
        let power = self.builder.power(node, exponent.unsigned_abs() as u32);
        if exponent >= 0 {
            return Ok(power);
        }
        let one = self.builder.constant(&Rational::one());
        self.divide(one, power, base.span)
    }

    fn divide(&mut self, dividend: Node, divisor: Node, span: Span) -> Result<Node, Diagnostic> {
        if self.builder.is_zero(divisor) {
            return Err(Diagnostic::new(
                Kind::ZeroDivisor,
                span,
                "this divisor is zero",
                "correct the divisor, or remove the division",
            ));
        }
        Ok(self.builder.divide(dividend, divisor))
    }

    /// The plan of these results, or of zeros where there are none.
    fn plan(&mut self, kind: ClaimKind, outputs: Option<&[Node]>, n: usize) -> Plan {
        let zero = self.builder.constant(&Rational::zero());
        match outputs {
            Some(outputs) => self.builder.finish(outputs),
            None if kind == ClaimKind::Bracket => self.builder.finish(&vec![zero; n * (n.max(1) - 1) / 2]),
            None => self.builder.finish(&[zero]),
        }
    }
}
