//! Relations between parameters that a grid suggests, with claims that hold under the relations.

use std::cmp::Reverse;
use std::collections::{BTreeSet, HashMap};

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::relations::Relations;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::{ClaimBody, ClaimKind};
use kahan_algebra::system::{Condition, System};

use super::vanishing_polynomials::{Grid, VanishingPolynomial, vanishing_polynomials};
use super::{DegreesAndRanks, Scan};
use crate::claims::proved::{Claims, Formula};
use crate::deadline::{Deadline, WatchedSearch};
use crate::orbits::hilbert::default_degree;
use crate::report::Options;
use crate::stages::discover_within;

/// A relation between scanned parameters. Where it holds, degrees or ranks are not generic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proposal {
    /// The relation as written in a `when` clause, for example `c = -a - b`.
    pub relation: String,
    /// The number of grid points that satisfy the relation.
    pub points: usize,
    /// The most frequent degrees and ranks at points with the fewest integrals.
    pub sight: DegreesAndRanks,
    /// Proved claims, ready to paste, that hold only under the relation.
    pub claims: Vec<String>,
}

pub(super) fn proposals(
    system: &System,
    scan: &Scan,
    options: &Options,
    work: &WatchedSearch<'_>,
    deadline: &Deadline<'_>,
) -> Vec<Proposal> {
    let symbols = &system.field.symbols;
    // Points without observed ranks are left out. Points with ε = 0, where the map is the identity,
    // are also left out.
    let zero_step = |values: &[Rational]| {
        scan.names.iter().zip(values).any(|(name, value)| name == "eps" && value.is_zero())
    };
    let seen = || scan.points.iter().filter(|point| point.sight.is_some() && !zero_step(&point.values));
    let sights: Vec<&DegreesAndRanks> = seen().filter_map(|point| point.sight.as_ref()).collect();
    let grid = |is_special: &dyn Fn(&DegreesAndRanks) -> bool| Grid {
        points: seen().map(|point| point.values.clone()).collect(),
        special: sights.iter().map(|sight| is_special(sight)).collect(),
    };
    let axes: Option<Vec<Variable>> = scan.names.iter().map(|name| symbols.named(name)).collect();
    let (Some(axes), true) = (axes, scan.names.len() > 1) else { return Vec::new() };
    // Points with more integrals than generic points are better evidence, so they are used first.
    let mut found = vanishing_polynomials(&grid(&|sight| sight.integrals > scan.generic.integrals), &[]);
    let others = vanishing_polynomials(&grid(&|sight| *sight != scan.generic), &found);
    found.extend(others);
    let mut prover = RelationProver::new(system, options, work);
    let mut proposals = Vec::new();
    for (index, VanishingPolynomial { polynomial, points }) in found.iter().enumerate() {
        let polynomial = polynomial.map_variables(|axis| axes[usize::from(axis.0)]);
        let Some(sight) = usual_degrees(points.iter().map(|&at| sights[at])) else { continue };
        let relation = relation_text(symbols, &polynomial);
        let seconds = deadline.left() / (found.len() - index) as f64;
        let claims = prover.prove(&polynomial, &relation, seconds);
        proposals.push(Proposal { relation, points: points.len(), sight: sight.clone(), claims });
    }
    proposals
}

/// Returns the most frequent entry among those with the fewest integrals.
fn usual_degrees<'a>(sights: impl Iterator<Item = &'a DegreesAndRanks>) -> Option<&'a DegreesAndRanks> {
    let mut counts: HashMap<String, (usize, &DegreesAndRanks)> = HashMap::new();
    for sight in sights {
        counts.entry(format!("{sight:?}")).or_insert((0, sight)).0 += 1;
    }
    let rank = |(text, (count, sight)): &(String, (usize, &DegreesAndRanks))| {
        (Reverse(sight.integrals), *count, text.clone())
    };
    counts.into_iter().max_by_key(rank).map(|(_, (_, sight))| sight)
}

/// Writes the equation that sets a polynomial to zero. A name with coefficient ±1 stands on the
/// left if possible.
fn relation_text(symbols: &Symbols, polynomial: &Polynomial) -> String {
    let is_linear = polynomial.degree() == 1;
    let mut terms = polynomial.terms();
    let isolated = terms.rfind(|(monomial, value)| is_linear && !monomial.is_one() && value.abs().is_one());
    let constant = Polynomial::constant(polynomial.coefficient(&Monomial::one()));
    let (mut left, mut right) = match isolated {
        Some((monomial, value)) => {
            let left = Polynomial::term(monomial.clone(), value.clone());
            let right = &left - polynomial;
            (left, right)
        }
        None if is_linear || !constant.is_zero() => (polynomial - &constant, -&constant),
        None => {
            let negative = polynomial.terms().filter(|(_, value)| value.is_negative());
            let right = Polynomial::from_terms(negative.map(|(monomial, value)| (monomial.clone(), -value)));
            (polynomial + &right, right)
        }
    };
    if left.terms().all(|(_, value)| value.is_negative()) {
        (left, right) = (-&left, -&right);
    }
    let text = |side: &Polynomial| Text.polynomial(symbols, side);
    format!("{} = {}", text(&left), text(&right))
}

/// Searches for formulas that hold under a relation, and proves them as claims about `system`.
struct RelationProver<'a> {
    system: &'a System,
    options: &'a Options,
    work: &'a WatchedSearch<'a>,
    claims: Claims<'a>,
    taken: BTreeSet<String>,
}

impl<'a> RelationProver<'a> {
    fn new(system: &'a System, options: &'a Options, work: &'a WatchedSearch<'a>) -> Self {
        let symbols = &system.field.symbols;
        let claims = system.claims.iter().map(|claim| claim.name.text.clone());
        let constants = system.constants.iter().map(|(name, _)| name.clone());
        let names = symbols.states.iter().chain(&symbols.parameters).cloned();
        RelationProver {
            system,
            options,
            work,
            claims: Claims::new(system, &[], None),
            taken: claims.chain(constants).chain(names).collect(),
        }
    }

    /// Within `seconds`, proves claims that hold only where the polynomial vanishes.
    fn prove(&mut self, polynomial: &Polynomial, relation: &str, seconds: f64) -> Vec<String> {
        let Some((system, options)) = self.restricted(polynomial, seconds) else { return Vec::new() };
        let found = discover_within(&system, &options, self.work, &|_, _| ());
        let Ok(report) = found else { return Vec::new() };
        let formulas = report.integrals.iter().chain(&report.densities);
        formulas.filter_map(|formula| self.claim(formula, relation)).collect()
    }

    /// Restricts the system to the zeros of the polynomial, by solving it for ε or a parameter.
    fn restricted(&self, polynomial: &Polynomial, seconds: f64) -> Option<(System, Options)> {
        let symbols = &self.system.field.symbols;
        // With a fixed degree the search does not continue to higher degrees, so there is time for
        // other relations.
        let degree = Some(self.options.degree.unwrap_or_else(|| default_degree(symbols.dimension())));
        let mut options = Options { seconds, degree, ..self.options.clone() };
        let mut relations = Relations::default();
        let name = relations.add(polynomial, &[]).ok()?;
        let value = relations.value(name)?;
        if name == symbols.epsilon() {
            options.eps = Some(value.as_polynomial()?.as_constant()?);
            return Some((System { claims: Vec::new(), ..self.system.clone() }, options));
        }
        // Relations with ε are rejected: substitution could bring odd powers of ε into the field,
        // and `kahan!` allows only even powers.
        let is_free = !value.numerator().contains(symbols.epsilon())
            && !value.denominator().contains(symbols.epsilon());
        let system = is_free.then(|| self.system.on(&relations))??;
        Some((system, options))
    }

    /// Claims the formula under the relation, unless the formula holds without the relation.
    fn claim(&mut self, formula: &Formula, relation: &str) -> Option<String> {
        let ClaimBody::Function(value) = &formula.claim.body else { return None };
        let value = Text.expression(value);
        let eps_is_fixed = relation.starts_with("eps = ");
        let sides = formula.claim.conditions.iter().map(|Condition { written, .. }| {
            [&written.left, &written.right].map(|side| Text.expression(side))
        });
        let fixed = sides.filter(|[left, _]| !eps_is_fixed || left != "eps");
        let fixed: Vec<String> = fixed.map(|sides| sides.join(" = ")).collect();
        let fixed: Vec<&str> = fixed.iter().map(String::as_str).collect();
        let kind = formula.claim.kind;
        let name = self.free_name(kind);
        let claim = |relations: &[&str]| {
            let when =
                if relations.is_empty() { String::new() } else { format!(" when {}", relations.join(", ")) };
            format!("{} {name} = {value}{when};", kind.keyword())
        };
        let on_relation = claim(&[&[relation], &fixed[..]].concat());
        if self.claims.proved(&[], &claim(&fixed)).is_some() {
            return None;
        }
        self.work.found(&self.claims.proved(&[], &on_relation)?, &on_relation);
        self.taken.insert(name);
        Some(on_relation)
    }

    fn free_name(&self, kind: ClaimKind) -> String {
        let name = |index: usize| match (kind, index) {
            (ClaimKind::Integral | ClaimKind::Drift, _) => format!("H{index}"),
            (_, 1) => "rho".to_owned(),
            _ => format!("rho{index}"),
        };
        (1..).map(name).find(|name| !self.taken.contains(name)).expect("numbers have no end")
    }
}
