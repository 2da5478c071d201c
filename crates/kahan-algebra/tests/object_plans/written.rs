//! Evaluates a block as written in any arithmetic, without polynomials and plans of the library.

use kahan_algebra::arithmetic::{Arithmetic, Dual};
use kahan_algebra::diagnostics::Diagnostics;
use kahan_algebra::interpret::Point;
use kahan_algebra::lexer::lex;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::{Block, ClaimBody, ClaimKind, Expr, ExprKind, FamilySyntax};
use kahan_syntax::parse::parse;

pub(crate) struct Written {
    block: Block,
    symbols: Symbols,
}

impl Written {
    /// Parses a text. The coordinates of points in the other methods have the order of `symbols`.
    pub(crate) fn new(text: &str, symbols: &Symbols) -> Self {
        let mut diagnostics = Diagnostics::default();
        let block = parse(&lex(text).tokens, &mut diagnostics);
        assert!(diagnostics.finish().is_empty(), "{text}");
        Written { block, symbols: symbols.clone() }
    }

    /// Returns f(x). Returns `None` at a division by zero.
    pub(crate) fn field<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<A::Value>> {
        let equations = self.block.equations.iter();
        equations
            .map(|equation| self.value(arithmetic, equation.value.as_ref().expect("it was read"), point))
            .collect()
    }

    /// Returns f′(x) by the rules for sums, products and quotients.
    pub(crate) fn field_jacobian<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<Vec<A::Value>>> {
        let n = point.state.len();
        let dual = Dual { base: arithmetic, directions: n };
        let zero = arithmetic.constant(&Rational::zero())?;
        let states = point.state.iter().enumerate().map(|(i, value)| dual.coordinate(value.clone(), i));
        let extended = Point {
            state: states.collect::<Option<_>>()?,
            parameters: point.parameters.iter().map(|value| dual.fixed(value.clone())).collect(),
            eps: dual.fixed(point.eps.clone()),
        };
        let rows = self.field(&dual, &extended)?.into_iter().map(|component| component.gradient);
        Some(rows.map(|row| if row.is_empty() { vec![zero.clone(); n] } else { row }).collect())
    }

    /// Returns the unconditional claims of one kind by name. A bracket has its entries above the
    /// diagonal.
    pub(crate) fn claims<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        kind: ClaimKind,
        point: &Point<A::Value>,
    ) -> Vec<(String, Option<Vec<A::Value>>)> {
        let claims =
            self.block.claims.iter().filter(|claim| claim.kind == kind && claim.conditions.is_empty());
        let value = |body: &ClaimBody| match body {
            ClaimBody::Function(expr) => Some(vec![self.value(arithmetic, expr, point)?]),
            ClaimBody::Tensor(_) => self.above_the_diagonal(arithmetic, body, point),
            ClaimBody::Recurrence { function, next } => {
                Some(vec![self.value(arithmetic, function, point)?, self.value(arithmetic, next, point)?])
            }
        };
        claims
            .map(|claim| (claim.name.text.clone(), value(claim.body.as_ref().expect("it was read"))))
            .collect()
    }

    /// Returns the entries {xᵢ,xⱼ}, i < j, row by row. Unwritten entries are 0.
    fn above_the_diagonal<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        body: &ClaimBody,
        point: &Point<A::Value>,
    ) -> Option<Vec<A::Value>> {
        let ClaimBody::Tensor(entries) = body else { panic!("a bracket has entries") };
        let states = &self.symbols.states;
        let mut above = Vec::new();
        for (i, row) in states.iter().enumerate() {
            for column in &states[i + 1..] {
                let written = |a: &str, b: &str| {
                    let entry = entries.iter().find(|entry| entry.row.text == a && entry.column.text == b)?;
                    Some(self.value(arithmetic, &entry.value, point))
                };
                above.push(match (written(row, column), written(column, row)) {
                    (Some(value), None) => value?,
                    (None, Some(value)) => arithmetic.negate(&value?),
                    (None, None) => arithmetic.constant(&Rational::zero())?,
                    (Some(_), Some(_)) => panic!("{{{row},{column}}} stands twice"),
                });
            }
        }
        Some(above)
    }

    fn value<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        expr: &Expr,
        point: &Point<A::Value>,
    ) -> Option<A::Value> {
        let value = |expr: &Expr| self.value(arithmetic, expr, point);
        match &expr.kind {
            ExprKind::Number(number) => arithmetic.constant(number),
            ExprKind::Name(name) => self.named(arithmetic, name, point),
            ExprKind::Special(FamilySyntax::Site { .. }) => None,
            ExprKind::Negation(inner) => Some(arithmetic.negate(&value(inner)?)),
            ExprKind::Sum(terms) => {
                let mut sum: Option<A::Value> = None;
                for term in terms {
                    let next = value(&term.expr)?;
                    sum = Some(match (sum, term.negative) {
                        (None, false) => next,
                        (None, true) => arithmetic.negate(&next),
                        (Some(sum), false) => arithmetic.add(&sum, &next),
                        (Some(sum), true) => arithmetic.subtract(&sum, &next),
                    });
                }
                sum
            }
            ExprKind::Product(factors) => {
                let mut product: Option<A::Value> = None;
                for factor in factors {
                    let next = value(&factor.expr)?;
                    product = Some(match (product, factor.divides) {
                        (None, false) => next,
                        (None, true) => arithmetic.divide(&arithmetic.constant(&Rational::one())?, &next)?,
                        (Some(product), false) => arithmetic.multiply(&product, &next),
                        (Some(product), true) => arithmetic.divide(&product, &next)?,
                    });
                }
                product
            }
            ExprKind::Power(base, exponent) => {
                let one = arithmetic.constant(&Rational::one())?;
                let base = value(base)?;
                let size = exponent.unsigned_abs();
                let power = (1..size).fold(base.clone(), |power, _| arithmetic.multiply(&power, &base));
                match exponent {
                    0 => Some(one),
                    1.. => Some(power),
                    _ => arithmetic.divide(&one, &power),
                }
            }
            ExprKind::Special(FamilySyntax::OverSites(_)) => panic!("a plain block has no sites"),
        }
    }

    /// Returns the value of a state, a parameter, ε, a constant, or an earlier claim.
    fn named<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        name: &str,
        point: &Point<A::Value>,
    ) -> Option<A::Value> {
        let position = |names: &[String]| names.iter().position(|known| known == name);
        if let Some(i) = position(&self.symbols.states) {
            return Some(point.state[i].clone());
        }
        if let Some(k) = position(&self.symbols.parameters) {
            return Some(point.parameters[k].clone());
        }
        if matches!(name, "eps" | "ε") {
            return Some(point.eps.clone());
        }
        if let Some(constant) = self.block.constants.iter().find(|constant| constant.name.text == name) {
            return self.value(arithmetic, constant.value.as_ref().expect("it was read"), point);
        }
        let claim = self.block.claims.iter().find(|claim| claim.name.text == name);
        match claim.and_then(|claim| claim.body.as_ref()) {
            Some(ClaimBody::Function(expr) | ClaimBody::Recurrence { function: expr, .. }) => {
                self.value(arithmetic, expr, point)
            }
            _ => panic!("{name} has no value"),
        }
    }
}
