//! Compiles claims to plans.

use rustc_hash::FxHashMap;

use kahan_syntax::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{self, Block, ClaimBody, ClaimKind, Expr, Reference, TensorEntry};
use kahan_syntax::token::Span;

use crate::plan::{Node, PlanBuilder};
use crate::rational_function::RationalFunction;
use crate::system::{Claim, upper_index};

use super::conditions;
use super::lower::{HIGHEST_EXPONENT, LoweringTarget, MOST_BITS, lower};
use super::names::{NameMeaning, Scope};
use super::stand_in::StandIn;

/// Compiles the claims in order. Claims with mistakes are left out of the result, but recorded in
/// `stand_in`.
pub(super) fn compile_all(
    block: &Block,
    components: &[RationalFunction],
    scope: &mut Scope,
    stand_in: &mut StandIn,
    diagnostics: &mut Diagnostics,
) -> Vec<Claim> {
    let (builder, functions) = (PlanBuilder::default(), FxHashMap::default());
    let mut compiler = ClaimCompiler { builder, functions, scope };
    let mut claims: Vec<Claim> = Vec::new();
    for claim in &block.claims {
        if !compiler.scope.is_free(&claim.name, "claim", diagnostics) {
            continue;
        }
        check_density_is_single(claim, &claims, diagnostics);
        let conditions = conditions::evaluate(&claim.conditions, components, compiler.scope, diagnostics);
        let entries = entry_places(claim, compiler.scope, diagnostics);
        let outputs = claim
            .body
            .as_ref()
            .filter(|body| {
                // All expressions are resolved before the first is compiled, so all unknown names
                // are reported.
                let mut resolve = |expr: &Expr| compiler.scope.resolve(expr, true, diagnostics);
                match body {
                    ClaimBody::Recurrence { function, next } => {
                        resolve(function) & resolve_next(next, claim, &claims, compiler.scope, diagnostics)
                    }
                    ClaimBody::Function(function) => resolve(function),
                    ClaimBody::Tensor(entries) => {
                        entries.iter().filter(|entry| !resolve(&entry.value)).count() == 0
                    }
                }
            })
            .zip(entries)
            .and_then(|(body, entries)| match compiler.body(&claim.name.text, body, &entries) {
                Ok(outputs) => Some(outputs),
                Err(diagnostic) => {
                    diagnostics.push(diagnostic);
                    None
                }
            });
        compiler.scope.claims.push(claim.name.text.clone());
        stand_in.push_claim(claim.kind, &claim.name, claim.conditions.is_empty());
        match outputs.as_deref() {
            Some([output, ..]) if claim.kind != ClaimKind::Bracket => {
                compiler.functions.insert(claim.name.text.clone(), *output);
            }
            Some(_) => {}
            // The claim's mistake is already reported. Later claims that use its name are dropped
            // without a report.
            None => compiler.scope.poison(&claim.name.text),
        }
        if let (Some(outputs), Some(body), Some(conditions)) = (outputs, &claim.body, conditions) {
            claims.push(Claim {
                kind: claim.kind,
                name: claim.name.clone(),
                body: body.clone(),
                plan: compiler.builder.finish(&outputs),
                conditions,
            });
        }
    }
    claims
}

/// Checks the expression G of a claim `drift F by G`. Reports states, densities and unknown names
/// in G. The claim's own name is allowed, and means F(x).
fn resolve_next(
    next: &Expr,
    claim: &syntax::Claim,
    earlier: &[Claim],
    scope: &mut Scope,
    diagnostics: &mut Diagnostics,
) -> bool {
    let name = &claim.name.text;
    scope.claims.push(name.clone());
    let mut is_sound = scope.resolve(next, true, diagnostics);
    scope.claims.pop();
    next.visit_names(&mut |reference, span| {
        let used = &*reference.to_string();
        let is_density = |other: &Claim| other.kind == ClaimKind::Density && other.name.text == used;
        let what = if scope.symbols.states.iter().any(|state| state == used) {
            "a state"
        } else if earlier.iter().any(is_density) {
            "a density"
        } else {
            return;
        };
        is_sound = false;
        let message =
            format!("`{used}` is {what}, and the next value of `{name}` is to follow from `{name}`");
        let help = format!("behind `by` stand `{name}`, parameters, `eps`, and earlier integrals and drifts");
        diagnostics.report(Kind::Claim, span, message, help);
    });
    is_sound
}

fn check_density_is_single(claim: &syntax::Claim, earlier: &[Claim], diagnostics: &mut Diagnostics) {
    let is_second = claim.kind == ClaimKind::Density
        && claim.conditions.is_empty()
        && earlier.iter().any(|other| other.kind == ClaimKind::Density && other.is_unconditional());
    if is_second {
        let message = "a block has at most one density without `when`";
        let help = "the quotient of two densities is an integral: write `integral R = …;`";
        diagnostics.report(Kind::Claim, claim.name.span, message, help);
    }
}

struct ClaimCompiler<'a> {
    builder: PlanBuilder,
    functions: FxHashMap<String, Node>,
    scope: &'a mut Scope,
}

impl LoweringTarget for ClaimCompiler<'_> {
    type Value = Node;

    fn number(&mut self, value: &Rational) -> Node {
        self.builder.constant(value)
    }

    fn named(&mut self, reference: Reference<'_>, span: Span) -> Result<Node, Diagnostic> {
        let name = reference.to_string();
        if let Some(node) = self.functions.get(&name) {
            return Ok(*node);
        }
        match self.scope.meaning(&name) {
            Some(NameMeaning::Variable(variable)) => Ok(self.builder.input(variable)),
            Some(NameMeaning::Constant(value)) => Ok(self.number(&value)),
            None => Err(Diagnostic::new(
                Kind::Claim,
                span,
                format!("`{name}` is a bracket, not a function"),
                "a claim may use earlier integrals and densities",
            )),
        }
    }

    fn negate(&mut self, a: Node) -> Node {
        self.builder.negate(a)
    }

    fn sum(&mut self, terms: Vec<(bool, Node)>, _: Span) -> Result<Node, Diagnostic> {
        let zero = self.number(&Rational::zero());
        let builder = &mut self.builder;
        Ok(terms.into_iter().fold(zero, |sum, (negative, term)| match negative {
            true => builder.subtract(sum, term),
            false => builder.add(sum, term),
        }))
    }

    fn multiply(&mut self, a: Node, b: Node, _: Span) -> Result<Node, Diagnostic> {
        Ok(self.builder.multiply(a, b))
    }

    fn divide(&mut self, a: Node, b: Node, _: Span) -> Result<Node, Diagnostic> {
        Ok(self.builder.divide(a, b))
    }

    fn power(&mut self, a: Node, exponent: u64, span: Span) -> Result<Node, Diagnostic> {
        let bits = self.builder.constant_size(a).map(|value| value.bits().max(1));
        let is_short_number = bits.is_some_and(|bits| bits.saturating_mul(exponent) <= MOST_BITS);
        if !is_short_number && exponent > HIGHEST_EXPONENT.unsigned_abs() {
            let message = format!("exponents in claims go from −{HIGHEST_EXPONENT} to {HIGHEST_EXPONENT}");
            let help = "write the claim with smaller powers";
            return Err(Diagnostic::new(Kind::Exponent, span, message, help));
        }
        Ok(self.builder.power(a, exponent as u32))
    }

    fn is_zero(&self, a: &Node) -> bool {
        self.builder.is_zero(*a)
    }

    fn allows_negative_exponents(&self) -> bool {
        true
    }
}

impl ClaimCompiler<'_> {
    fn body(
        &mut self,
        name: &str,
        body: &ClaimBody,
        entries: &[(usize, usize)],
    ) -> Result<Vec<Node>, Diagnostic> {
        match body {
            ClaimBody::Function(expr) => Ok(vec![lower(expr, self)?]),
            ClaimBody::Recurrence { function, next } => {
                let function = lower(function, self)?;
                self.functions.insert(name.to_owned(), function);
                Ok(vec![function, lower(next, self)?])
            }
            ClaimBody::Tensor(values) => {
                let n = self.scope.symbols.dimension();
                let zero = self.builder.constant(&Rational::zero());
                let mut upper = vec![zero; n * (n.max(1) - 1) / 2];
                for (entry, &(row, column)) in values.iter().zip(entries) {
                    let node = lower(&entry.value, self)?;
                    let place = upper_index(n, row.min(column), row.max(column));
                    upper[place] = if row < column { node } else { self.builder.negate(node) };
                }
                Ok(upper)
            }
        }
    }
}

fn entry_places(
    claim: &syntax::Claim,
    scope: &Scope,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<(usize, usize)>> {
    let Some(ClaimBody::Tensor(entries)) = &claim.body else { return Some(Vec::new()) };
    if entries.is_empty() {
        let message = format!("the bracket `{}` has no entries", claim.name.text);
        let help = "write its entries, as in `{x,y} = x*y;`";
        diagnostics.report(Kind::Claim, claim.name.span, message, help);
        return None;
    }
    let mut places: Vec<(usize, usize)> = Vec::new();
    for entry in entries {
        match entry_place(entry, &places, scope) {
            Ok(place) => places.push(place),
            Err(diagnostic) => diagnostics.push(diagnostic),
        }
    }
    (places.len() == entries.len()).then_some(places)
}

fn entry_place(
    entry: &TensorEntry,
    earlier: &[(usize, usize)],
    scope: &Scope,
) -> Result<(usize, usize), Diagnostic> {
    let index = |name: &syntax::Name| {
        scope.symbols.states.iter().position(|state| *state == name.text).ok_or_else(|| {
            let message = format!("`{}` is not a state variable", name.text);
            let help = format!("the entries of a bracket are pairs of {}", scope.symbols.states.join(", "));
            Diagnostic::new(Kind::Claim, name.span, message, help)
        })
    };
    let (row, column) = (index(&entry.row)?, index(&entry.column)?);
    let wrong = |message: String, help: &str| {
        Err(Diagnostic::new(Kind::Claim, entry.row.span.to(entry.column.span), message, help))
    };
    if row == column {
        let message = format!("{{{0},{0}}} is zero for every bracket", entry.row.text);
        return wrong(message, "remove the entry, or name two different states");
    }
    if earlier.contains(&(row, column)) || earlier.contains(&(column, row)) {
        let message = format!("the entry {{{},{}}} is given twice", entry.row.text, entry.column.text);
        return wrong(message, "give each pair once; {y,x} is −{x,y} by itself");
    }
    Ok((row, column))
}
