//! Checks that a family with the Hamiltonian H has a constant antisymmetric matrix K with ẋ = K∇H.
//! The entry of K for two states depends only on their arrays and the difference of their sites,
//! which is at most the family's reach.
//!
//! If K exists and deg H ≤ 3, Kahan's map preserves H + (2ε/3) ∇Hᵀ A⁻¹ f, where f is the field and
//! A = I − εf′. This follows from x̃ − x = 2ε A⁻¹ f (E. Celledoni, R. I. McLachlan, B. Owren, G. R.
//! W. Quispel, J. Phys. A 46 (2013) 025201).

use kahan_syntax::diagnostics::{Diagnostic, Kind};
use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Boundary, Reference};
use kahan_syntax::table::Table;

use crate::poly::{Budget, Monomial, OverBudget, Polynomial, Variable, WithinBudget};
use crate::rational_function::{RationalFunction, Row, reduced, with_leading_one};
use crate::render::{Notation, Text};
use crate::symbols::Symbol;

use super::conserved::{plural, too_long};
use super::everywhere::{MiddleSite, SiteRange, budget, product};
use super::{Family, Role, SiteSum};

pub(super) fn check_hamiltonian(family: &Family, hamiltonian: &SiteSum) -> Result<(), Diagnostic> {
    let name = &hamiltonian.name;
    let refuse = |message: &str, help: &str| {
        Err(Diagnostic::new(Kind::Claim, name.span, format!("`{}` {message}", name.text), help))
    };
    let degree = family.symbols.degree(hamiltonian.density.numerator());
    if degree > 3 {
        let message = format!("is of degree {degree}: the map keeps a modified energy where it is at most 3");
        return refuse(&message, "write a Hamiltonian of degree three at most");
    }
    if degree == 0 {
        return refuse("says nothing: it depends on no state", "write a sum of states");
    }
    let is_of_site = |&variable: &Variable| matches!(family.role(variable), Role::SiteParameter { .. });
    let divides_by_site = hamiltonian.density.denominator().variables().iter().any(is_of_site);
    if divides_by_site {
        return refuse("divides by a parameter of a site", "declare the reciprocal as the parameter");
    }
    match find_unmatched_term(&MiddleSite::of(family), hamiltonian, &mut budget()) {
        Ok(None) => Ok(()),
        Err(OverBudget) => Err(too_long(name)),
        Ok(Some(UnmatchedTerm { array, term, site, sites })) => {
            let place = match family.boundary {
                Boundary::Periodic => String::new(),
                Boundary::Open => format!(" (site {site} of {sites} {})", plural(sites)),
            };
            let array = &family.arrays[array];
            let message = format!(
                "`{0}` is no Hamiltonian of this family: for every constant antisymmetric stencil K of reach {1}, K∇{0} differs from `{array}[i]dot` at the term `{term}`{place}",
                name.text, family.reach
            );
            let help = "correct the Hamiltonian or the equations";
            Err(Diagnostic::new(Kind::FalseClaim, name.span, message, help))
        }
    }
}

/// Returns the unknown entries of K, as the array of the row, the array of the column, and the
/// distance of their sites.
fn unknowns(family: &Family) -> Vec<(usize, usize, usize)> {
    let arrays = 0..family.block();
    let pairs = arrays.clone().flat_map(|row| arrays.clone().map(move |column| (row, column)));
    let offsets = |(row, column)| {
        let first = usize::from(row >= column);
        (first..=family.reach).map(move |offset| (row, column, offset))
    };
    pairs.flat_map(offsets).collect()
}

/// A term of ẋ that K∇H cannot produce.
pub(super) struct UnmatchedTerm {
    array: usize,
    term: String,
    site: usize,
    sites: usize,
}

struct Term {
    monomial: Monomial,
    coefficient: Rational,
    extent: SiteRange,
}

/// A term of one array's equation in ẋ = K∇H, written at the middle site.
struct RowTerm {
    monomial: Monomial,
    extent: SiteRange,
    /// The index of the unknown entry of K that multiplies the term. Terms of ẋ have no unknown
    /// factor; their index is one past the last unknown.
    unknown: usize,
    coefficient: Polynomial,
}

pub(super) fn find_unmatched_term(
    middle: &MiddleSite<'_>,
    hamiltonian: &SiteSum,
    budget: &mut Budget,
) -> WithinBudget<Option<UnmatchedTerm>> {
    let unknowns = unknowns(middle.chain.family);
    budget.charge(unknowns.len() as u64)?;
    let gradient = gradient(middle, hamiltonian, budget)?;
    let divisor = middle.at(&hamiltonian.density, 0).denominator().clone();
    let mut rows = Vec::new();
    for array in 0..middle.chain.family.block() {
        rows.push(row(middle, &unknowns, &gradient, &divisor, array, budget)?);
    }
    let mut equations = Equations::new(unknowns.len());
    let name = |array, term: &RowTerm, extent: SiteRange| UnmatchedTerm {
        array,
        term: relative_monomial(middle, &term.monomial),
        site: middle.site - extent.first,
        sites: extent.sites(),
    };
    // In long chains, terms with equal monomials must cancel, so each group of them gives an
    // equation. Groups with a term of ẋ come first, so that an error message names this term.
    let long = SiteRange { first: 0, last: middle.chain.sites - 1 };
    for is_given in [true, false] {
        for (array, terms) in rows.iter().enumerate() {
            let given = |term: &RowTerm| term.unknown == unknowns.len();
            let groups = terms.chunk_by(|one, other| one.monomial == other.monomial);
            for group in groups.filter(|group| group.iter().any(given) == is_given) {
                if !equations.add(group.iter().map(|term| (term.unknown, &term.coefficient)), budget)? {
                    return Ok(Some(name(array, &group[0], long)));
                }
            }
        }
    }
    // A short chain lacks some sites, and with them some terms. Therefore terms with equal
    // monomials must cancel separately for each `extent`.
    for (array, mut terms) in rows.into_iter().enumerate() {
        let order = |term: &RowTerm| (term.extent.sites(), term.extent.first);
        terms.sort_by_key(order);
        for group in terms.chunk_by(|one, other| one.extent == other.extent && one.monomial == other.monomial)
        {
            if !equations.add(group.iter().map(|term| (term.unknown, &term.coefficient)), budget)? {
                return Ok(Some(name(array, &group[0], group[0].extent)));
            }
        }
    }
    Ok(None)
}

/// Returns the derivatives of H by the states of the middle site, multiplied by the divisor of H.
fn gradient(
    middle: &MiddleSite<'_>,
    hamiltonian: &SiteSum,
    budget: &mut Budget,
) -> WithinBudget<Vec<Vec<Term>>> {
    let mut gradient: Vec<Vec<Term>> = (0..middle.chain.family.block()).map(|_| Vec::new()).collect();
    let density = middle.at(&hamiltonian.density, 0);
    for (monomial, value) in density.numerator().terms() {
        let extent = middle.extent(monomial, middle.extent_of_site(0));
        for &(state, exponent) in monomial.powers() {
            if !middle.chain.symbols.is_state(state) {
                continue;
            }
            budget.charge(1)?;
            let (offset, array) = middle.state(state);
            let slope = monomial.lowered(state).expect("it occurs");
            gradient[array].push(Term {
                monomial: middle.shifted(&slope, -offset),
                coefficient: value * &Rational::from(i64::from(exponent)),
                extent: middle.moved(extent, -offset),
            });
        }
    }
    Ok(gradient)
}

/// Returns the terms of ẋ = K∇H for one array, ordered by monomial. The equation is multiplied by
/// the divisors of both sides.
fn row(
    middle: &MiddleSite<'_>,
    unknowns: &[(usize, usize, usize)],
    gradient: &[Vec<Term>],
    divisor: &Polynomial,
    array: usize,
    budget: &mut Budget,
) -> WithinBudget<Vec<RowTerm>> {
    let component = middle.at(&middle.chain.family.components[array], 0);
    let here = middle.extent_of_site(0);
    let mut terms = Vec::new();
    let mut add = |unknown, monomial: &Monomial, coefficient: Rational, extent: SiteRange| {
        let (of_sites, of_chain) = monomial.split(|variable| middle.is_at_sites(variable));
        let coefficient = Polynomial::term(of_chain, coefficient);
        terms.push(RowTerm { monomial: of_sites, extent, unknown, coefficient });
    };
    let written = product(component.numerator(), divisor, budget)?;
    for (monomial, value) in written.terms() {
        add(unknowns.len(), monomial, value.clone(), middle.extent(monomial, here));
    }
    for (unknown, &(row, column, offset)) in unknowns.iter().enumerate() {
        let offset = offset as i64;
        // K is antisymmetric, so each unknown also stands for an entry with the opposite sign.
        for (_, other, offset, sign) in
            [(row, column, offset, 1), (column, row, -offset, -1)].iter().filter(|(of, ..)| *of == array)
        {
            budget.charge((gradient[*other].len() * component.denominator().len()) as u64)?;
            for term in &gradient[*other] {
                let slope = middle.shifted(&term.monomial, *offset);
                let extent = middle.moved(term.extent, *offset).with(here);
                let value = &term.coefficient * &Rational::from(*sign);
                for (factor, by) in component.denominator().terms() {
                    add(unknown, &slope.mul(factor), &value * by, middle.extent(factor, extent));
                }
            }
        }
    }
    terms.sort_by(|one, other| one.monomial.cmp(&other.monomial));
    Ok(terms)
}

fn relative_monomial(middle: &MiddleSite<'_>, monomial: &Monomial) -> String {
    let family = middle.chain.family;
    let name = |variable| match middle.chain.symbols.symbol(variable) {
        Symbol::State(_) => {
            let (offset, array) = middle.state(variable);
            Reference::Site { array: &family.arrays[array], offset }.to_string()
        }
        Symbol::Parameter(k) if k >= family.parameters.len() => {
            let (k, sites) = (k - family.parameters.len(), middle.chain.sites);
            let offset = (k % sites) as i64 - middle.site as i64;
            Reference::Site { array: &family.site_parameters[k / sites], offset }.to_string()
        }
        _ => middle.chain.symbols.name(variable),
    };
    let powers = monomial.powers().iter();
    let factors: Vec<String> =
        powers.map(|&(variable, exponent)| Text.power(&name(variable), exponent.into())).collect();
    if factors.is_empty() { "1".to_owned() } else { Text.product(&factors) }
}

/// Linear equations in row echelon form. Each row has its right-hand side at the index `unknowns`.
struct Equations {
    unknowns: usize,
    /// The rows, by the index of their first unknown, which has the coefficient 1.
    rows: Table<usize, Row>,
}

impl Equations {
    fn new(unknowns: usize) -> Self {
        Equations { unknowns, rows: Table::new() }
    }

    /// Adds an equation. Returns `false` if it contradicts earlier equations.
    fn add<'a>(
        &mut self,
        terms: impl Iterator<Item = (usize, &'a Polynomial)>,
        budget: &mut Budget,
    ) -> WithinBudget<bool> {
        let mut sums: Table<usize, RationalFunction> = Table::new();
        for (unknown, coefficient) in terms {
            let sum = sums.or_insert_with(unknown, |_| RationalFunction::zero());
            *sum = sum.add_within(&RationalFunction::from(coefficient.clone()), budget)?;
        }
        let mut equation: Row = sums.into_iter().filter(|(_, value)| !value.is_zero()).collect();
        loop {
            let Some((first, factor)) = equation.first() else { return Ok(true) };
            if *first == self.unknowns {
                return Ok(false);
            }
            let Some(row) = self.rows.get(first) else {
                self.rows.insert(*first, with_leading_one(&equation, budget)?);
                return Ok(true);
            };
            equation = reduced(&equation, factor, row, budget)?;
        }
    }
}
