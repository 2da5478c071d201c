//! What was written: a block of `kahan!`, item by item, with the place of everything.
//!
//! Nothing here is checked: names may be unknown, degrees too high, claims false. `kahan-algebra`
//! turns a block into a field and claims about it. Sums and products are flat lists, so that a sum
//! of 20 000 terms is as shallow as one of two.

use core::fmt;
use std::borrow::Cow;

use crate::rational::Rational;
use crate::token::Span;

/// A name and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The identifier, a raw one without `r#`.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// `[header] (const | equation | family | claim)*`. `X` is what constants and the right-hand sides
/// of equations have besides arithmetic: in a block that is to be lifted, functions and any powers.
#[derive(Clone, Debug)]
pub struct Block<X = InFamily> {
    /// `pub struct E7 { xi }`, where there is one.
    pub header: Option<Header>,
    /// The `lift` of the header, or the one before the items: the equations are to be lifted.
    pub lift: Option<Span>,
    /// `const xi = 1/2;`
    pub constants: Vec<Constant<X>>,
    /// `xdot = y*z;`, or the equations of the family, whose states are the names of its arrays.
    pub equations: Vec<Equation<X>>,
    /// `for i in periodic { … }`, where the equations stand in one.
    pub family: Option<FamilyHead>,
    /// `integral`, `density`, `bracket`, `drift`.
    pub claims: Vec<Claim>,
    /// `hamiltonian H = sum(…);` of a family, read as a claim of an integral.
    pub hamiltonians: Vec<Claim>,
    /// Left-hand sides without `dot`: mistakes already, but their names are not to be reported a
    /// second time.
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

/// What lies beyond the two ends of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// The other end: site n is site 0.
    Periodic,
    /// Nothing: states there are 0.
    Open,
}

/// `for i in periodic`, which one family of equations for every site stands behind.
#[derive(Clone, Debug)]
pub struct FamilyHead {
    /// What lies beyond the ends of the chain.
    pub boundary: Boundary,
    /// Where it stands.
    pub span: Span,
    /// How many equations stood before it, outside of the family.
    pub equations_before: usize,
    /// How many stood in it and before it.
    pub equations_until: usize,
}

/// `attributes [lift] visibility struct Name (; | { param, … })`.
#[derive(Clone, Debug)]
pub struct Header {
    /// Documentation and attributes.
    pub attributes: Written,
    /// `pub`, `pub(crate)`, or nothing.
    pub visibility: Written,
    /// The type's name.
    pub name: Name,
    /// The parameters in order.
    pub parameters: Vec<Name>,
    /// Documentation and attributes of each parameter.
    pub described: Vec<Written>,
}

/// What only Rust understands.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// As written, in lines.
    pub lines: Vec<String>,
    /// Its tokens, if there are some: documentation in a text is none.
    pub span: Option<Span>,
}

/// `const NAME = constant expr;`
#[derive(Clone, Debug)]
pub struct Constant<X = InFamily> {
    /// The constant's name.
    pub name: Name,
    /// Its value; absent where it could not be read.
    pub value: Option<Expr<X>>,
}

/// `STATEdot = expr;`
#[derive(Clone, Debug)]
pub struct Equation<X = InFamily> {
    /// The state: the left-hand side without `dot`.
    pub state: Name,
    /// The right-hand side; absent where it could not be read.
    pub value: Option<Expr<X>>,
}

/// What a claim asserts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ClaimKind {
    /// F(x̃) = F(x).
    Integral,
    /// ρ(x̃) det ∂x̃/∂x = ρ(x).
    Density,
    /// J P(x) Jᵀ = P(x̃), and the Jacobi identity.
    Bracket,
    /// F(x̃) is a function of F(x).
    Drift,
}

impl ClaimKind {
    /// The kind of claim that `word` begins.
    pub fn of_keyword(word: &str) -> Option<Self> {
        [ClaimKind::Integral, ClaimKind::Density, ClaimKind::Bracket, ClaimKind::Drift]
            .into_iter()
            .find(|kind| kind.keyword() == word)
    }

    /// The keyword that begins such a claim.
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

/// `integral NAME = expr [when];`, `density NAME = expr [when];`, `drift NAME = expr by expr
/// [when];`, `bracket NAME { {x,y} = expr; … } [when] [;]`.
#[derive(Clone, Debug)]
pub struct Claim {
    /// What is claimed.
    pub kind: ClaimKind,
    /// The claim's name.
    pub name: Name,
    /// The claimed function or tensor; absent where it could not be read.
    pub body: Option<ClaimBody>,
    /// `when expr = expr, …`.
    pub conditions: Vec<Condition>,
}

/// The right-hand side of a claim.
#[derive(Clone, Debug)]
pub enum ClaimBody {
    /// Of an integral or a density.
    Function(Expr),
    /// Of a bracket.
    Tensor(Vec<TensorEntry>),
    /// Of a drift.
    Recurrence {
        /// F(x).
        function: Expr,
        /// F(x̃), in which the claim's name stands for F(x).
        next: Expr,
    },
}

impl ClaimBody {
    /// The expressions of the claim: a function, a function and its next value, or entries' values.
    #[must_use]
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            ClaimBody::Function(expr) => vec![expr],
            ClaimBody::Tensor(entries) => entries.iter().map(|entry| &entry.value).collect(),
            ClaimBody::Recurrence { function, next } => vec![function, next],
        }
    }
}

/// `{x, y} = expr;`
#[derive(Clone, Debug)]
pub struct TensorEntry {
    /// The first state.
    pub row: Name,
    /// The second state.
    pub column: Name,
    /// Its value.
    pub value: Expr,
}

/// A relation between parameters and `eps` behind `when`: `expr = expr`.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
}

impl Condition {
    /// Where the relation stands.
    #[must_use]
    pub fn span(&self) -> Span {
        self.left.span.to(self.right.span)
    }

    /// Calls `visit` with every value that the relation names and its place, from left to right.
    pub fn visit_names<'a>(&'a self, visit: &mut dyn FnMut(Reference<'a>, Span)) {
        self.left.visit_names(visit);
        self.right.visit_names(visit);
    }
}

/// An expression and its place. `X` is what the language has besides arithmetic: in a block what
/// stands in a family, in a formula calls.
#[derive(Clone, Debug)]
pub struct Expr<X = InFamily> {
    /// What it is.
    pub kind: ExprKind<X>,
    /// Where it stands.
    pub span: Span,
}

impl Expr {
    /// Calls `visit` with every value that the expression names and its place, from left to right.
    pub fn visit_names<'a>(&'a self, visit: &mut dyn FnMut(Reference<'a>, Span)) {
        match &self.kind {
            ExprKind::Name(name) => visit(Reference::Name(name), self.span),
            ExprKind::Special(InFamily::Site { array, offset }) => {
                visit(Reference::Site { array, offset: *offset }, self.span);
            }
            _ => self.parts().into_iter().for_each(|part| part.visit_names(visit)),
        }
    }

    /// Returns the expressions that it is made of, from left to right.
    #[must_use]
    pub fn parts(&self) -> Vec<&Expr> {
        match &self.kind {
            ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Special(InFamily::Site { .. }) => Vec::new(),
            ExprKind::Sum(terms) => terms.iter().map(|term| &term.expr).collect(),
            ExprKind::Product(factors) => factors.iter().map(|factor| &factor.expr).collect(),
            ExprKind::Negation(inner)
            | ExprKind::Power(inner, _)
            | ExprKind::Special(InFamily::OverSites(inner)) => vec![inner],
        }
    }

    /// Writes the values of these names in their place; numbers that are multiplied then become
    /// one.
    pub fn put_values(&mut self, values: &[(String, Rational)]) {
        match &mut self.kind {
            ExprKind::Number(_) | ExprKind::Special(InFamily::Site { .. }) => {}
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
            ExprKind::Negation(inner) | ExprKind::Special(InFamily::OverSites(inner)) => {
                inner.put_values(values);
            }
        }
    }

    /// The number that it is, with its sign.
    fn number(&self) -> Option<Rational> {
        match &self.kind {
            ExprKind::Number(value) => Some(value.clone()),
            ExprKind::Negation(inner) => inner.number().map(|value| -value),
            _ => None,
        }
    }

    /// Makes one number of those among the factors, unless it would divide by zero.
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
    /// A number, with its sign before it.
    fn number(value: &Rational, span: Span) -> Self {
        let size = ExprKind::Number(value.abs());
        if value.is_negative() { ExprKind::Negation(Box::new(Expr { kind: size, span })) } else { size }
    }
}

/// The shapes of an expression.
#[derive(Clone, Debug)]
pub enum ExprKind<X = InFamily> {
    /// A literal, exactly.
    Number(Rational),
    /// An identifier.
    Name(String),
    /// `a + b − c …`
    Sum(Vec<Term<X>>),
    /// `a * b / c …`
    Product(Vec<Factor<X>>),
    /// `−a`
    Negation(Box<Expr<X>>),
    /// `a^n`
    Power(Box<Expr<X>>, i64),
    /// What only this language has.
    Special(X),
}

/// What the expressions of a family have besides arithmetic.
#[derive(Clone, Debug)]
pub enum InFamily {
    /// A value at a site: `x[i]`, `x[i+1]`, `x[i-2]`.
    Site {
        /// `x`
        array: String,
        /// How far from site i.
        offset: i64,
    },
    /// `sum(a)` over all sites, in a claim.
    OverSites(Box<Expr>),
}

/// What formulas outside of a block have besides arithmetic. No block can hold it, so that a field
/// stays polynomial and a claim rational.
#[derive(Clone, Debug)]
pub enum InFormula {
    /// `name(a, …)`; whoever evaluates the formula knows which functions there are.
    Call {
        /// `name`
        function: String,
        /// What stands in the parentheses, at least one.
        arguments: Vec<Expr<InFormula>>,
    },
    /// `a^b` where b is anything but a number that is an integer.
    Power(Box<[Expr<InFormula>; 2]>),
}

impl Expr<InFormula> {
    /// The expression without functions and general powers; `None` where it has one.
    #[must_use]
    pub fn rational(&self) -> Option<Expr> {
        let boxed = |inner: &Expr<InFormula>| inner.rational().map(Box::new);
        let kind = match &self.kind {
            ExprKind::Number(value) => ExprKind::Number(value.clone()),
            ExprKind::Name(name) => ExprKind::Name(name.clone()),
            ExprKind::Sum(terms) => {
                let term = |term: &Term<InFormula>| {
                    Some(Term { negative: term.negative, expr: term.expr.rational()? })
                };
                ExprKind::Sum(terms.iter().map(term).collect::<Option<_>>()?)
            }
            ExprKind::Product(factors) => {
                let factor = |factor: &Factor<InFormula>| {
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

/// What an expression names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference<'a> {
    /// `x`
    Name(&'a str),
    /// `x[i+1]`
    Site {
        /// `x`
        array: &'a str,
        /// How far from site i.
        offset: i64,
    },
}

impl<'a> Reference<'a> {
    /// The text by which it is looked up, as it is written.
    #[must_use]
    pub fn key(self) -> Cow<'a, str> {
        match self {
            Reference::Name(name) => Cow::Borrowed(name),
            Reference::Site { .. } => Cow::Owned(self.to_string()),
        }
    }
}

/// As it is written.
impl fmt::Display for Reference<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Reference::Name(name) => f.write_str(name),
            Reference::Site { array, offset: 0 } => write!(f, "{array}[i]"),
            Reference::Site { array, offset } => write!(f, "{array}[i{offset:+}]"),
        }
    }
}

/// One term of a sum.
#[derive(Clone, Debug)]
pub struct Term<X = InFamily> {
    /// Whether `−` stands before it.
    pub negative: bool,
    /// The term.
    pub expr: Expr<X>,
}

/// One factor of a product.
#[derive(Clone, Debug)]
pub struct Factor<X = InFamily> {
    /// Whether `/` stands before it.
    pub divides: bool,
    /// The factor.
    pub expr: Expr<X>,
}
