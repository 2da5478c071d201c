//! Expands a family with a given number of sites to a plain system.

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Boundary, ClaimBody, ClaimKind, Expr, ExprKind, Factor, Term};
use kahan_syntax::token::Span;

use crate::field::Field;
use crate::plan::PlanBuilder;
use crate::poly::{Monomial, Polynomial, Variable};
use crate::rational_function::RationalFunction;
use crate::subexpressions::{FieldWithSubexpressions, Subexpressions};
use crate::symbols::Symbols;
use crate::system::{Claim, System};

use super::{Family, Role, SiteSum};

impl Family {
    /// Returns the names of a chain. States `x0`, `x1`, … are ordered by site, then by array. The
    /// parameters of the chain precede site parameters `c0`, `c1`, ….
    #[must_use]
    pub fn symbols_at(&self, sites: usize) -> Symbols {
        let names = || self.arrays.iter().chain(&self.site_parameters);
        let all: Vec<&String> = names().chain(&self.parameters).collect();
        // If `x11` could be site 11 of `x` or site 1 of `x1`, the names are `x_11` and `x1_1`.
        let is_number = |rest: &str| !rest.is_empty() && rest.chars().all(|c| c.is_ascii_digit());
        let is_prefix =
            |name: &String, other: &String| other.strip_prefix(name.as_str()).is_some_and(is_number);
        let is_unclear = names().any(|name| all.iter().any(|other| is_prefix(name, other)));
        let infix = if is_unclear { "_" } else { "" };
        let at = |name: &String, site: usize| format!("{name}{infix}{site}");
        let states = (0..sites).flat_map(|site| self.arrays.iter().map(move |name| at(name, site)));
        let of_sites =
            self.site_parameters.iter().flat_map(|name| (0..sites).map(move |site| at(name, site)));
        Symbols {
            states: states.collect(),
            parameters: self.parameters.iter().cloned().chain(of_sites).collect(),
        }
    }

    /// Returns the system of a chain with the linear integrals as claims. Returns `None` if a
    /// divisor is identically 0 at some site, which can happen in short rings.
    #[must_use]
    pub fn at_sites(&self, sites: usize) -> Option<System> {
        let chain = self.chain(sites);
        let mut components = Vec::with_capacity(sites * self.block());
        let mut values = Subexpressions::of(&chain.symbols);
        let mut kept = Vec::with_capacity(sites * self.block());
        for site in 0..sites {
            for component in &self.components {
                components.push(chain.moved(component, site)?);
            }
            kept.extend(self.kept.with(&mut values, |variable| {
                chain.moved_variable(variable, site).map_or_else(Polynomial::zero, Polynomial::variable)
            }));
        }
        let claims = self.integrals.iter().map(|sum| chain.claim(sum)).collect::<Option<_>>()?;
        let field = Field { symbols: chain.symbols, components };
        let kept = FieldWithSubexpressions::new(values, kept);
        let (header, constants) = (self.header.clone(), self.constants.clone());
        Some(System { header, constants, claims, ..System::of(field, kept) })
    }

    pub(super) fn chain(&self, sites: usize) -> Chain<'_> {
        Chain { family: self, symbols: self.symbols_at(sites), sites }
    }
}

pub(super) struct Chain<'a> {
    pub family: &'a Family,
    pub symbols: Symbols,
    pub sites: usize,
}

impl Chain<'_> {
    fn claim(&self, sum: &SiteSum) -> Option<Claim> {
        let mut builder = PlanBuilder::default();
        let mut total = builder.polynomial(&Polynomial::zero());
        let mut terms = Vec::with_capacity(self.sites);
        for site in 0..self.sites {
            let density = self.moved(&sum.density, site)?;
            let term = builder.quotient(density.numerator(), density.denominator());
            total = builder.add(total, term);
            terms.push(density);
        }
        Some(Claim {
            kind: ClaimKind::Integral,
            name: sum.name.clone(),
            body: ClaimBody::Function(written(&terms, &self.symbols, sum.written.span)),
            plan: builder.finish(&[total]),
            conditions: Vec::new(),
        })
    }

    /// Moves a function of site i to `site`. Returns `None` if the denominator vanishes there.
    pub(super) fn moved(&self, function: &RationalFunction, site: usize) -> Option<RationalFunction> {
        // A variable beyond the end of an open chain is 0, so its terms are dropped.
        let moved = |monomial: &Monomial| -> Option<Monomial> {
            let powers = monomial.powers().iter();
            powers.map(|&(variable, power)| Some((self.moved_variable(variable, site)?, power))).collect()
        };
        function.map(|polynomial| polynomial.map_monomials(moved))
    }

    fn moved_variable(&self, variable: Variable, site: usize) -> Option<Variable> {
        let Chain { family, symbols, sites } = self;
        let neighbour = |offset: i64| {
            let place = site as i64 + offset;
            match family.boundary {
                Boundary::Periodic => Some(place.rem_euclid(*sites as i64) as usize),
                Boundary::Open => usize::try_from(place).ok().filter(|place| place < sites),
            }
        };
        Some(match family.role(variable) {
            Role::State { offset, array } => symbols.state(neighbour(offset)? * family.block() + array),
            Role::Parameter(k) => symbols.parameter(k),
            Role::SiteParameter { offset, index } => {
                symbols.parameter(family.parameters.len() + index * sites + neighbour(offset)?)
            }
            Role::Epsilon => symbols.epsilon(),
        })
    }
}

fn written(terms: &[RationalFunction], symbols: &Symbols, span: Span) -> Expr {
    let expr = |kind| Expr { kind, span };
    let factor = |divides, expr| Factor { divides, expr };
    let polynomial = |polynomial: &Polynomial| {
        let terms = polynomial.terms().map(|(monomial, coefficient)| {
            let number = factor(false, expr(ExprKind::Number(coefficient.abs())));
            let powers = monomial.powers().iter().map(|&(variable, exponent)| {
                let name = expr(ExprKind::Name(symbols.name(variable)));
                let power = ExprKind::Power(Box::new(name.clone()), exponent.into());
                factor(false, if exponent == 1 { name } else { expr(power) })
            });
            let is_one = coefficient.abs() == Rational::ONE && !monomial.is_one();
            let factors: Vec<Factor> = (!is_one).then_some(number).into_iter().chain(powers).collect();
            Term { negative: coefficient.is_negative(), expr: expr(ExprKind::Product(factors)) }
        });
        terms.collect::<Vec<Term>>()
    };
    let mut sum = Vec::new();
    for term in terms {
        if let Some(whole) = term.as_polynomial() {
            sum.extend(polynomial(whole));
        } else {
            let parts = [term.numerator(), term.denominator()].map(|of| expr(ExprKind::Sum(polynomial(of))));
            let [above, below] = parts;
            let quotient = ExprKind::Product(vec![factor(false, above), factor(true, below)]);
            sum.push(Term { negative: false, expr: expr(quotient) });
        }
    }
    expr(ExprKind::Sum(sum))
}
