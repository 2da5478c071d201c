//! The constant antisymmetric stencil K with ẋ = K∇H, boundary rows included.
//!
//! Where there is one, and H is of degree three at most, Kahan's map keeps H + (2ε/3) ∇Hᵀ A⁻¹ f, as
//! x̃ − x = 2ε A⁻¹ f (E. Celledoni, R. I. McLachlan, B. Owren, G. R. W. Quispel, J. Phys. A 46
//! (2013) 025201).

use kahan_syntax::diagnostics::{Diagnostic, Kind};
use kahan_syntax::syntax::{Boundary, Reference};
use kahan_syntax::table::Table;

use crate::poly::{Monomial, Polynomial};
use crate::rational_function::RationalFunction;
use crate::render::{Notation, Text};
use crate::symbols::Symbols;

use super::conserved::{longest, plural};
use super::linear::Equations;
use super::{Family, Role, SiteSum};

/// One entry of K above the diagonal: of the row of array `row` at site i and the column of array
/// `column` at site i + `offset`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct StencilEntry {
    /// The array of the row.
    pub row: usize,
    /// The array of the column.
    pub column: usize,
    /// How far the column's site is from the row's.
    pub offset: usize,
    /// The entry, which depends on parameters of the chain at most.
    pub value: RationalFunction,
}

/// Finds K for the Hamiltonian, and proves ẋ = K∇H for every number of sites.
pub(super) fn stencil(family: &Family, hamiltonian: &SiteSum) -> Result<Vec<StencilEntry>, Diagnostic> {
    let name = &hamiltonian.name;
    let refuse = |message: String, help: &str| Diagnostic::new(Kind::Claim, name.span, message, help);
    let degree = family.symbols.degree(&hamiltonian.density.numerator);
    if degree > 3 {
        return Err(refuse(
            format!(
                "`{}` is of degree {degree}: the map keeps a modified energy where it is at most 3",
                name.text
            ),
            "write a Hamiltonian of degree three at most",
        ));
    }
    if degree == 0 {
        return Err(refuse(
            format!("`{}` says nothing: it depends on no state", name.text),
            "write a sum of states",
        ));
    }
    let divides_by_site = hamiltonian
        .density
        .denominator
        .variables()
        .into_iter()
        .any(|variable| matches!(family.role(variable), Role::SiteParameter { .. }));
    if divides_by_site {
        return Err(refuse(
            format!("`{}` divides by a parameter of a site", name.text),
            "declare the reciprocal as the parameter",
        ));
    }
    let unknowns = unknowns(family);
    let mut equations = Equations::default();
    // The longest chain first: its middle names the term that is in the way.
    let shortest = match family.boundary {
        // Shorter rings are this one with sites identified, on both sides of the equations.
        Boundary::Periodic => longest(family),
        Boundary::Open => 1,
    };
    for sites in (shortest..=longest(family)).rev() {
        Chain::of(family, hamiltonian, sites).equate(&unknowns, &mut equations).map_err(|(site, array, monomial)| {
            let term = relative(family, &family.symbols_at(sites), &monomial, site, sites);
            let place = match family.boundary {
                Boundary::Periodic => String::new(),
                Boundary::Open => format!(" (site {site} of {sites} {})", plural(sites)),
            };
            let array = &family.arrays[array];
            Diagnostic::new(
                Kind::FalseClaim,
                name.span,
                format!(
                    "`{0}` is no Hamiltonian of this family: for every constant antisymmetric stencil K of reach {1}, K∇{0} differs from `{array}[i]dot` at the term `{term}`{place}",
                    name.text, family.reach
                ),
                "correct the Hamiltonian or the equations",
            )
        })?;
    }
    let values = equations.solution(unknowns.len());
    let entry = |((row, column, offset), value)| StencilEntry { row, column, offset, value };
    Ok(unknowns.into_iter().zip(values).map(entry).filter(|entry| !entry.value.is_zero()).collect())
}

/// The entries of K that fix all others: above the diagonal.
fn unknowns(family: &Family) -> Vec<(usize, usize, usize)> {
    let arrays = 0..family.block();
    let pairs = arrays.clone().flat_map(|row| arrays.clone().map(move |column| (row, column)));
    let offsets = |(row, column)| {
        let first = usize::from(row >= column);
        (first..=family.reach).map(move |offset| (row, column, offset))
    };
    pairs.flat_map(offsets).collect()
}

/// A term that no K gives: site, array, monomial.
type Missing = (usize, usize, Monomial);

/// A chain with its energy's gradient.
struct Chain<'a> {
    family: &'a Family,
    symbols: Symbols,
    sites: usize,
    gradient: Vec<Polynomial>,
    /// What the energy is divided by.
    divisor: Polynomial,
}

impl<'a> Chain<'a> {
    fn of(family: &'a Family, hamiltonian: &SiteSum, sites: usize) -> Self {
        let symbols = family.symbols_at(sites);
        let mut gradient = vec![Polynomial::zero(); symbols.states.len()];
        let mut divisor = Polynomial::one();
        for site in 0..sites {
            let density = family.moved(&hamiltonian.density, site, sites, &symbols);
            for state in density.numerator.variables() {
                if symbols.is_state(state) {
                    let slope = &mut gradient[usize::from(state.0)];
                    *slope = &*slope + &density.numerator.derivative(state);
                }
            }
            divisor = density.denominator;
        }
        Chain { family, symbols, sites, gradient, divisor }
    }

    /// Adds ẋ = K∇H, term by term; the middle of the chain first.
    fn equate(&self, unknowns: &[(usize, usize, usize)], equations: &mut Equations) -> Result<(), Missing> {
        let system = self.family.at_sites(self.sites);
        let middle = self.sites / 2;
        let rest = (0..self.sites).filter(|site| *site != middle && self.family.boundary == Boundary::Open);
        let mut known: Vec<Vec<RationalFunction>> = Vec::new();
        for site in std::iter::once(middle).chain(rest) {
            for array in 0..self.family.block() {
                let component = &system.field.components[site * self.family.block() + array];
                let sides: Vec<Polynomial> = unknowns
                    .iter()
                    .map(|unknown| &self.column(*unknown, site, array) * &component.denominator)
                    .chain([&component.numerator * &self.divisor])
                    .collect();
                for (monomial, row) in self.by_monomial(&sides) {
                    if known.contains(&row) {
                        continue;
                    }
                    known.push(row.clone());
                    if !equations.add(row) {
                        return Err((site, array, monomial));
                    }
                }
            }
        }
        Ok(())
    }

    /// What an unknown entry of K, and its negative below the diagonal, multiplies in the row of an
    /// array at a site.
    fn column(&self, (row, column, offset): (usize, usize, usize), site: usize, array: usize) -> Polynomial {
        let mut sum = Polynomial::zero();
        if row == array
            && let Some(slope) = self.slope(site as i64 + offset as i64, column)
        {
            sum = &sum + slope;
        }
        if column == array
            && let Some(slope) = self.slope(site as i64 - offset as i64, row)
        {
            sum = &sum - slope;
        }
        sum
    }

    fn slope(&self, site: i64, array: usize) -> Option<&Polynomial> {
        let site = match self.family.boundary {
            Boundary::Periodic => site.rem_euclid(self.sites as i64),
            Boundary::Open => site,
        };
        let site = usize::try_from(site).ok().filter(|site| *site < self.sites)?;
        Some(&self.gradient[site * self.family.block() + array])
    }

    /// The coefficients of each monomial in states and in parameters of sites, one a side. Terms of
    /// the last side come first.
    fn by_monomial(&self, sides: &[Polynomial]) -> Vec<(Monomial, Vec<RationalFunction>)> {
        let first_of_sites = self.symbols.states.len() + self.family.parameters.len();
        let epsilon = self.symbols.epsilon();
        let varies = |variable: crate::poly::Variable| {
            self.symbols.is_state(variable)
                || (usize::from(variable.0) >= first_of_sites && variable != epsilon)
        };
        let groups: Vec<_> = sides.iter().map(|side| side.group(varies)).collect();
        let mut monomials: Vec<&Monomial> = Vec::new();
        for (monomial, _) in groups.iter().rev().flat_map(Table::iter) {
            if !monomials.contains(&monomial) {
                monomials.push(monomial);
            }
        }
        let row = |monomial: &Monomial| {
            let coefficients = groups.iter().map(|side| side.get(monomial).cloned().unwrap_or_default());
            coefficients.map(RationalFunction::from).collect()
        };
        monomials.into_iter().map(|monomial| (monomial.clone(), row(monomial))).collect()
    }
}

/// A monomial of a chain as one of its family, seen from a site.
fn relative(family: &Family, symbols: &Symbols, monomial: &Monomial, site: usize, sites: usize) -> String {
    let name = |index: usize| {
        let states = symbols.states.len();
        let parameters = family.parameters.len();
        let (base, place) = if index < states {
            (&family.arrays[index % family.block()], index / family.block())
        } else if index < states + parameters {
            return family.parameters[index - states].clone();
        } else {
            let rest = index - states - parameters;
            (&family.site_parameters[rest / sites], rest % sites)
        };
        Reference::Site { array: base, offset: place as i64 - site as i64 }.to_string()
    };
    let factors = monomial
        .powers()
        .iter()
        .map(|&(variable, exponent)| Text.power(&name(usize::from(variable.0)), exponent.into()));
    let factors: Vec<String> = factors.collect();
    if factors.is_empty() { "1".to_owned() } else { Text.product(&factors) }
}
