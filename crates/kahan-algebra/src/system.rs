//! A checked block, with a field and unproved claims about its map.

use std::ops::Range;
use std::sync::Arc;

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{self, ClaimBody, ClaimKind, Expr, ExprKind, Header, Name};
use kahan_syntax::token::Span;

use crate::field::Field;
use crate::plan::{Plan, PlanBuilder};
use crate::poly::{Polynomial, Variable};
use crate::rational_function::RationalFunction;
use crate::relations::Relations;
use crate::subexpressions::FieldWithSubexpressions;
use crate::symbols::Symbols;

/// A field with its claims. A clone does not copy the field.
#[derive(Clone, Debug)]
pub struct System {
    /// The header of the block.
    pub header: Option<Header>,
    /// The constants with their values.
    pub constants: Vec<(String, Rational)>,
    /// The vector field.
    pub field: Arc<Field>,
    /// The field with sums and divisors as written. Step plans are made from it.
    pub kept: Arc<FieldWithSubexpressions>,
    /// The right-hand sides as written. The list is empty for derived systems.
    pub written: Arc<[Expr]>,
    /// The claims.
    pub claims: Vec<Claim>,
}

/// A claim with resolved names.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The kind of claim.
    pub kind: ClaimKind,
    /// The name of the claim.
    pub name: Name,
    /// The claim as written.
    pub body: ClaimBody,
    /// The plan of the claim. Its outputs are F(x) and the claimed F(x̃) for a drift, and the
    /// entries above the diagonal, row by row, for a bracket. Any other claim has one output.
    pub plan: Plan,
    /// The conditions of the claim.
    pub conditions: Vec<Condition>,
}

/// A relation between parameters and ε, written after `when` and solved for one name.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The condition as written.
    pub written: syntax::Condition,
    /// The name for which the relation was solved.
    pub variable: Variable,
    /// The value of `variable`, as a function of names for which no condition is solved.
    pub value: RationalFunction,
    /// The polynomials that must be nonzero: divisors, and the coefficient of `variable`.
    pub nonzero: Vec<Polynomial>,
}

impl Condition {
    /// Builds a claim's conditions. An item holds the relation as written, the name for which it
    /// was solved, and the indices of its divisors in `relations.nonzero()`.
    pub(crate) fn all(
        solved: Vec<(syntax::Condition, Variable, Range<usize>)>,
        relations: &Relations,
    ) -> Vec<Condition> {
        let condition = |(written, variable, added): (syntax::Condition, Variable, Range<usize>)| {
            let value = relations.value(variable).expect("a relation was solved for it").clone();
            Condition { written, variable, value, nonzero: relations.nonzero()[added].to_vec() }
        };
        solved.into_iter().map(condition).collect()
    }

    /// Returns the condition `NAME = value`.
    #[must_use]
    pub fn fixed(symbols: &Symbols, variable: Variable, value: &Rational) -> Condition {
        let expr = |kind| Expr { kind, span: Span::token(0) };
        Condition {
            written: syntax::Condition {
                left: expr(ExprKind::Name(symbols.name(variable))),
                right: expr(ExprKind::Number(value.clone())),
            },
            variable,
            value: RationalFunction::constant(value.clone()),
            nonzero: Vec::new(),
        }
    }

    /// Returns the value if it is a number.
    #[must_use]
    pub fn number(&self) -> Option<Rational> {
        self.value.as_polynomial().and_then(Polynomial::as_constant)
    }
}

impl Claim {
    /// Replaces names in the claim by their values.
    pub fn put_values(&mut self, values: &[(String, Rational)]) {
        match &mut self.body {
            ClaimBody::Function(value) => value.put_values(values),
            ClaimBody::Tensor(entries) => entries.iter_mut().for_each(|entry| entry.value.put_values(values)),
            ClaimBody::Recurrence { function, next } => {
                function.put_values(values);
                next.put_values(values);
            }
        }
        for Condition { written, .. } in &mut self.conditions {
            written.left.put_values(values);
            written.right.put_values(values);
        }
    }

    /// Returns the plan of the claim with the values of solved names inserted.
    #[must_use]
    pub fn where_it_holds(&self) -> Plan {
        let mut builder = PlanBuilder::default();
        let outputs = builder.include_mapped(&self.plan, |builder, variable| {
            let Some(condition) = self.conditions.iter().find(|condition| condition.variable == variable)
            else {
                return builder.input(variable);
            };
            builder.quotient(condition.value.numerator(), condition.value.denominator())
        });
        builder.finish(&outputs)
    }

    /// Returns whether the claim has no conditions.
    #[must_use]
    pub fn is_unconditional(&self) -> bool {
        self.conditions.is_empty()
    }
}

/// Returns the row-by-row index of entry (i, j) with i < j among the entries above the diagonal.
#[must_use]
pub fn upper_index(n: usize, i: usize, j: usize) -> usize {
    i * (2 * n - i - 1) / 2 + (j - i - 1)
}

impl System {
    pub(crate) fn of(field: Field, kept: FieldWithSubexpressions) -> Self {
        System {
            header: None,
            constants: Vec::new(),
            field: field.into(),
            kept: kept.into(),
            written: Arc::default(),
            claims: Vec::new(),
        }
    }

    /// Returns the claims of one kind without conditions. Generated code has methods for them.
    pub fn accessors(&self, kind: ClaimKind) -> impl Iterator<Item = &Claim> {
        self.claims.iter().filter(move |claim| claim.kind == kind && claim.is_unconditional())
    }

    /// Returns the claims with conditions.
    pub fn conditional(&self) -> impl Iterator<Item = &Claim> {
        self.claims.iter().filter(|claim| !claim.is_unconditional())
    }

    /// Returns the name of the system, or `field` if it has no name.
    #[must_use]
    pub fn name(&self) -> &str {
        self.header.as_ref().map_or("field", |header| header.name.text.as_str())
    }
}
