//! The syntax tree of a block, with the spans of tokens.
//!
//! The tree is not checked: names may be unknown, degrees too high, and claims false. Long sums and
//! products are flat lists, not nested trees.

use core::fmt;
use std::borrow::Cow;

use crate::rational::Rational;
use crate::token::Span;

/// A name, with its span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The identifier, without a leading `r#`.
    pub text: String,
    /// The tokens of the name.
    pub span: Span,
}

/// A block, which has the form `[header] (const | equation | family | claim)*`.
///
/// `X` is the syntax beyond arithmetic in constants and right-hand sides: [`FamilySyntax`], or
/// [`FormulaSyntax`] if the block is to be lifted.
#[derive(Clone, Debug)]
pub struct Block<X = FamilySyntax> {
    /// The header, such as `pub struct E7 { xi }`.
    pub header: Option<Header>,
    /// The span of the keyword `lift`, if the equations are to be lifted.
    pub lift: Option<Span>,
    /// Constants, such as `const xi = 1/2;`.
    pub constants: Vec<Constant<X>>,
    /// Equations, such as `xdot = y*z;`. In a family, the equation of `x[i]` has the state `x`.
    pub equations: Vec<Equation<X>>,
    /// The head of the family, such as `for i in periodic { … }`.
    pub family: Option<FamilyHead>,
    /// The claims, which begin with `integral`, `density`, `bracket` or `drift`.
    pub claims: Vec<Claim>,
    /// The Hamiltonians of a family, `hamiltonian H = sum(…);`, stored with the kind `Integral`.
    pub hamiltonians: Vec<Claim>,
    /// Left-hand sides without `dot`, which were already reported.
    pub misspelt_states: Vec<Name>,
}

impl<X> Default for Block<X> {
    fn default() -> Self {
        Block {
            header: None,
            lift: None,
            constants: Vec::new(),
            equations: Vec::new(),
            family: None,
            claims: Vec::new(),
            hamiltonians: Vec::new(),
            misspelt_states: Vec::new(),
        }
    }
}

/// The boundary condition of a chain of sites.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// The site after the last site is site 0.
    Periodic,
    /// States beyond the ends are 0.
    Open,
}

/// The head of a family of equations: `for i in periodic`.
#[derive(Clone, Debug)]
pub struct FamilyHead {
    /// The boundary condition.
    pub boundary: Boundary,
    /// The tokens of the head.
    pub span: Span,
    /// The number of equations before the family.
    pub equations_before: usize,
    /// The number of equations before and in the family.
    pub equations_until: usize,
}

/// A header, which has the form `attributes [lift] visibility struct Name (; | { param, … })`.
#[derive(Clone, Debug)]
pub struct Header {
    /// The documentation and the attributes of the type.
    pub attributes: WrittenTokens,
    /// The visibility, which is `pub`, `pub(crate)` or similar, or empty.
    pub visibility: WrittenTokens,
    /// The type's name.
    pub name: Name,
    /// The parameters in order.
    pub parameters: Vec<Name>,
    /// The documentation and the attributes of each parameter.
    pub described: Vec<WrittenTokens>,
}

/// Tokens that only Rust understands, kept as written.
#[derive(Clone, Debug, Default)]
pub struct WrittenTokens {
    /// The text of the tokens, with one entry for each attribute or line of documentation.
    pub lines: Vec<String>,
    /// The span of the tokens; `None` without tokens. In texts, `///` lines are no tokens.
    pub span: Option<Span>,
}

/// A constant, `const NAME = expr;`.
#[derive(Clone, Debug)]
pub struct Constant<X = FamilySyntax> {
    /// The constant's name.
    pub name: Name,
    /// The value; `None` if it could not be read.
    pub value: Option<Expr<X>>,
}

/// An equation, `STATEdot = expr;`.
#[derive(Clone, Debug)]
pub struct Equation<X = FamilySyntax> {
    /// The name of the state, which is the left-hand side without `dot`.
    pub state: Name,
    /// The right-hand side; `None` if it could not be read.
    pub value: Option<Expr<X>>,
}

/// The kind of a claim about the map x ↦ x̃.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ClaimKind {
    /// The claim F(x̃) = F(x) for a function F.
    Integral,
    /// The claim ρ(x̃) det ∂x̃/∂x = ρ(x) for a density ρ.
    Density,
    /// The claim J P(x) Jᵀ = P(x̃) with J = ∂x̃/∂x, and the Jacobi identity, for a tensor P.
    Bracket,
    /// The claim that F(x̃) is a given function of F(x).
    Drift,
}

impl ClaimKind {
    /// Returns the kind of claim that a keyword begins.
    pub fn of_keyword(word: &str) -> Option<Self> {
        [ClaimKind::Integral, ClaimKind::Density, ClaimKind::Bracket, ClaimKind::Drift]
            .into_iter()
            .find(|kind| kind.keyword() == word)
    }

    /// Returns the keyword that begins a claim of this kind.
    #[must_use]
    pub fn keyword(self) -> &'static str {
        match self {
            ClaimKind::Integral => "integral",
            ClaimKind::Density => "density",
            ClaimKind::Bracket => "bracket",
            ClaimKind::Drift => "drift",
        }
    }
}

/// A claim, which may have conditions. There are four forms:
///
/// `integral NAME = expr;`, `density NAME = expr;`, `drift NAME = expr by expr;`, `bracket NAME {
/// {x,y} = expr; … }`.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The kind of claim.
    pub kind: ClaimKind,
    /// The claim's name.
    pub name: Name,
    /// The claimed function or tensor; `None` if it could not be read.
    pub body: Option<ClaimBody>,
    /// The conditions, `when expr = expr, …`.
    pub conditions: Vec<Condition>,
}

/// The right-hand side of a claim.
#[derive(Clone, Debug)]
pub enum ClaimBody {
    /// The function of an integral or a density.
    Function(Expr),
    /// The entries of a bracket.
    Tensor(Vec<TensorEntry>),
    /// The two expressions of a drift.
    Recurrence {
        /// The function F(x).
        function: Expr,
        /// The value F(x̃) as a formula, in which the claim's name stands for F(x).
        next: Expr,
    },
}

impl ClaimBody {
    /// Returns the expressions of the claim in the order of the text.
    #[must_use]
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            ClaimBody::Function(expr) => vec![expr],
            ClaimBody::Tensor(entries) => entries.iter().map(|entry| &entry.value).collect(),
            ClaimBody::Recurrence { function, next } => vec![function, next],
        }
    }
}

/// An entry of a bracket, `{x, y} = expr;`.
#[derive(Clone, Debug)]
pub struct TensorEntry {
    /// The first state.
    pub row: Name,
    /// The second state.
    pub column: Name,
    /// The value of the entry.
    pub value: Expr,
}

/// A condition after `when`: a relation `expr = expr` between parameters and `eps`.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
}

impl Condition {
    /// Returns the span of the relation.
    #[must_use]
    pub fn span(&self) -> Span {
        self.left.span.to(self.right.span)
    }

    /// Calls `visit` with each name or site in the relation and its span, from left to right.
    pub fn visit_names<'a>(&'a self, visit: &mut dyn FnMut(Reference<'a>, Span)) {
        self.left.visit_names(visit);
        self.right.visit_names(visit);
    }
}

/// An expression with its span; `X` is the syntax that goes beyond arithmetic.
#[derive(Clone, Debug)]
pub struct Expr<X = FamilySyntax> {
    /// The operation, with its operands.
    pub kind: ExprKind<X>,
    /// The tokens of the expression.
    pub span: Span,
}

impl Expr {
    /// Calls `visit` with each name or site in the expression and its span, from left to right.
    pub fn visit_names<'a>(&'a self, visit: &mut dyn FnMut(Reference<'a>, Span)) {
        match &self.kind {
            ExprKind::Name(name) => visit(Reference::Name(name), self.span),
            ExprKind::Special(FamilySyntax::Site { array, offset }) => {
                visit(Reference::Site { array, offset: *offset }, self.span);
            }
            _ => self.parts().into_iter().for_each(|part| part.visit_names(visit)),
        }
    }

    /// Returns the operands of the outermost operation, from left to right.
    #[must_use]
    pub fn parts(&self) -> Vec<&Expr> {
        match &self.kind {
            ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Special(FamilySyntax::Site { .. }) => {
                Vec::new()
            }
            ExprKind::Sum(terms) => terms.iter().map(|term| &term.expr).collect(),
            ExprKind::Product(factors) => factors.iter().map(|factor| &factor.expr).collect(),
            ExprKind::Negation(inner)
            | ExprKind::Power(inner, _)
            | ExprKind::Special(FamilySyntax::OverSites(inner)) => vec![inner],
        }
    }

    /// Replaces names by numbers, and multiplies the numbers in products where a name was replaced.
    pub fn put_values(&mut self, values: &[(String, Rational)]) {
        match &mut self.kind {
            ExprKind::Number(_) | ExprKind::Special(FamilySyntax::Site { .. }) => {}
            ExprKind::Name(name) => {
                if let Some((_, value)) = values.iter().find(|(known, _)| known == name) {
                    self.kind = ExprKind::number(value, self.span);
                }
            }
            ExprKind::Sum(terms) => {
                for Term { negative, expr } in terms {
                    let was_negative = matches!(expr.kind, ExprKind::Negation(_));
                    expr.put_values(values);
                    if let ExprKind::Negation(inner) = &expr.kind
                        && !was_negative
                    {
                        (*negative, *expr) = (!*negative, (**inner).clone());
                    }
                }
            }
            ExprKind::Product(factors) => {
                let numbers = |factors: &[Factor]| factors.iter().filter_map(|one| one.expr.number()).count();
                let written = numbers(factors);
                factors.iter_mut().for_each(|factor| factor.expr.put_values(values));
                if numbers(factors) > written {
                    self.gather_numbers();
                }
            }
            ExprKind::Power(base, exponent) => {
                let exponent = i32::try_from(*exponent).ok().filter(|_| base.number().is_none());
                base.put_values(values);
                if let Some(power) =
                    base.number().zip(exponent).and_then(|(base, exponent)| base.pow(exponent))
                {
                    self.kind = ExprKind::number(&power, self.span);
                }
            }
            ExprKind::Negation(inner) | ExprKind::Special(FamilySyntax::OverSites(inner)) => {
                inner.put_values(values);
            }
        }
    }

    fn number(&self) -> Option<Rational> {
        match &self.kind {
            ExprKind::Number(value) => Some(value.clone()),
            ExprKind::Negation(inner) => inner.number().map(|value| -value),
            _ => None,
        }
    }

    /// Combines the numeric factors of a product, unless it contains a division by 0.
    fn gather_numbers(&mut self) {
        let ExprKind::Product(factors) = &mut self.kind else { return };
        let mut whole = Rational::one();
        for Factor { divides, expr } in &*factors {
            let Some(number) = expr.number() else { continue };
            let Some(number) = (if *divides { number.recip() } else { Some(number) }) else { return };
            whole = &whole * &number;
        }
        factors.retain(|factor| factor.expr.number().is_none());
        if !whole.abs().is_one() || factors.first().is_none_or(|first| first.divides) {
            let expr = Expr { kind: ExprKind::Number(whole.abs()), span: self.span };
            factors.insert(0, Factor { divides: false, expr });
        }
        if whole.is_negative() {
            let product = Box::new(self.clone());
            self.kind = ExprKind::Negation(product);
        }
    }
}

impl ExprKind {
    fn number(value: &Rational, span: Span) -> Self {
        let size = ExprKind::Number(value.abs());
        if value.is_negative() { ExprKind::Negation(Box::new(Expr { kind: size, span })) } else { size }
    }
}

/// The operation of an expression.
#[derive(Clone, Debug)]
pub enum ExprKind<X = FamilySyntax> {
    /// A number, stored exactly.
    Number(Rational),
    /// A name.
    Name(String),
    /// A sum `a + b − c …`.
    Sum(Vec<Term<X>>),
    /// A product `a * b / c …`.
    Product(Vec<Factor<X>>),
    /// A negation `−a`.
    Negation(Box<Expr<X>>),
    /// A power `a^n`.
    Power(Box<Expr<X>>, i64),
    /// Syntax that goes beyond arithmetic.
    Special(X),
}

/// Syntax of families beyond arithmetic: values at sites, and sums over all sites.
#[derive(Clone, Debug)]
pub enum FamilySyntax {
    /// A value at a site, such as `x[i]`, `x[i+1]` or `x[i-2]`.
    Site {
        /// The name of the array, such as `x`.
        array: String,
        /// The distance from site i.
        offset: i64,
    },
    /// The sum `sum(a)` over all sites, which occurs only in claims.
    OverSites(Box<Expr>),
}

/// Syntax of formulas beyond arithmetic: function calls and general powers.
#[derive(Clone, Debug)]
pub enum FormulaSyntax {
    /// A function call `name(a, …)`.
    Call {
        /// The name of the function.
        function: String,
        /// One or more arguments.
        arguments: Vec<Expr<FormulaSyntax>>,
    },
    /// A power `a^b` whose exponent b is not an integer literal.
    Power(Box<[Expr<FormulaSyntax>; 2]>),
}

impl Expr<FormulaSyntax> {
    /// Converts to a rational expression; `None` if function calls or general powers occur.
    #[must_use]
    pub fn rational(&self) -> Option<Expr> {
        let boxed = |inner: &Expr<FormulaSyntax>| inner.rational().map(Box::new);
        let kind = match &self.kind {
            ExprKind::Number(value) => ExprKind::Number(value.clone()),
            ExprKind::Name(name) => ExprKind::Name(name.clone()),
            ExprKind::Sum(terms) => {
                let term = |term: &Term<FormulaSyntax>| {
                    Some(Term { negative: term.negative, expr: term.expr.rational()? })
                };
                ExprKind::Sum(terms.iter().map(term).collect::<Option<_>>()?)
            }
            ExprKind::Product(factors) => {
                let factor = |factor: &Factor<FormulaSyntax>| {
                    Some(Factor { divides: factor.divides, expr: factor.expr.rational()? })
                };
                ExprKind::Product(factors.iter().map(factor).collect::<Option<_>>()?)
            }
            ExprKind::Negation(inner) => ExprKind::Negation(boxed(inner)?),
            ExprKind::Power(base, exponent) => ExprKind::Power(boxed(base)?, *exponent),
            ExprKind::Special(_) => return None,
        };
        Some(Expr { kind, span: self.span })
    }
}

/// A name or a site that occurs in an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference<'a> {
    /// A name such as `x`.
    Name(&'a str),
    /// A site such as `x[i+1]`.
    Site {
        /// The name of the array, such as `x`.
        array: &'a str,
        /// The distance from site i.
        offset: i64,
    },
}

impl<'a> Reference<'a> {
    /// Returns the key of this name or site in symbol tables.
    #[must_use]
    pub fn key(self) -> Cow<'a, str> {
        match self {
            Reference::Name(name) => Cow::Borrowed(name),
            Reference::Site { .. } => Cow::Owned(self.to_string()),
        }
    }
}

/// The name or site is written as in a block.
impl fmt::Display for Reference<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Reference::Name(name) => f.write_str(name),
            Reference::Site { array, offset: 0 } => write!(f, "{array}[i]"),
            Reference::Site { array, offset } => write!(f, "{array}[i{offset:+}]"),
        }
    }
}

/// A term of a sum.
#[derive(Clone, Debug)]
pub struct Term<X = FamilySyntax> {
    /// Whether `-` precedes the term.
    pub negative: bool,
    /// The expression of the term.
    pub expr: Expr<X>,
}

/// A factor of a product.
#[derive(Clone, Debug)]
pub struct Factor<X = FamilySyntax> {
    /// Whether `/` precedes the factor.
    pub divides: bool,
    /// The expression of the factor.
    pub expr: Expr<X>,
}
