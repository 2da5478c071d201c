//! The search, stage by stage.

mod formulas;
mod search;

use self::formulas::Integrals;
use self::search::{Search, SearchResult};
use crate::claims::proved::Claims;
use crate::claims::verdicts::sentences;
use crate::deadline::{Deadline, WatchedSearch};
use crate::drift::{self, drifts};
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::orbits::degrees::{DegreeLimits, degrees};
use crate::orbits::hilbert::{Hilbert, MOST_MONOMIALS_AT_ALL, default_degree};
use crate::orbits::integral_bound::{FEW_TRIALS, IntegralBound, MANY_TRIALS, integral_bound};
use crate::orbits::plane;
use crate::poisson::modified::Modified;
use crate::poisson::structure::{
    FlowIntegrals, IntegralsByRules, divergence, flow_integrals, integrals_by_rules, is_even,
};
use crate::report::{
    Bound, DiscoverError, HamiltonianReport, MOST_READABLE, MOST_VARIABLES, Options, Report, StructureReport,
};
use crate::watch::{Progress, Watch};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::system::{Claim, System};

/// Finds the structures that the Kahan map of a system's field preserves. The claims of the system
/// are ignored.
///
/// `watch` is told of every stage as it begins, and of each proved claim. After a search up to a
/// higher degree, a claim may be rewritten and reported again.
///
/// Equal fields and options give equal results, unless time runs out. Without a given degree, the
/// search continues to higher degrees while integrals may be missing and time is left. These later
/// results may differ between machines. [`Report::bound`] tells why the search ended.
///
/// # Errors
/// Returns a [`DiscoverError`] if the field has no invertible map or too many variables, or for
/// wrong options.
pub fn discover(system: &System, options: &Options, watch: &dyn Watch) -> Result<Report, DiscoverError> {
    let work = WatchedSearch::new(watch);
    discover_within(system, options, &work, &|claim, text| work.found(claim, text))
}

pub(crate) fn discover_within(
    system: &System,
    options: &Options,
    work: &WatchedSearch<'_>,
    tell: &dyn Fn(&Claim, &str),
) -> Result<Report, DiscoverError> {
    let [for_flow, for_degrees, for_orbits, for_structure, for_integrals, for_densities, end] =
        [0.1, 0.25, 0.42, 0.5, 0.85, 0.95, 1.0].map(|share| Deadline::after(work, options.seconds * share));
    let begins = |stage: &str| work.show(&Progress::stage(stage));
    let fixed = specialised(system, &options.parameters, options.eps.as_ref())?;
    let symbols = &fixed.field.symbols;
    if options.eps.as_ref().is_some_and(Rational::is_zero) {
        return Err(DiscoverError::ZeroStep);
    }
    let searched = SearchField::new(&fixed.field, options.eps.clone());
    let mut random = SplitMix64::from_bytes(format!("{:?}{:?}", fixed.field, options.eps).as_bytes());
    let random = &mut random;
    let sample = searched.sample(Modulus::mersenne_61(), random).ok_or(DiscoverError::NoMap)?;
    if options.eps.is_some() && !searched.is_invertible(random) {
        return Err(DiscoverError::Collapse);
    }

    begins("linear and quadratic integrals of the flow");
    let claims = Claims::new(system, &options.parameters, options.eps.as_ref());
    let rules = if for_flow.passed() {
        IntegralsByRules::default()
    } else {
        integrals_by_rules(&searched, &fixed.field)
    };
    let proved = rules.proved(&searched, &claims, &mut random.clone());
    for formula in proved.iter().filter(|formula| formula.text.len() <= MOST_READABLE) {
        tell(&formula.claim, &formula.text);
    }
    let of_flow = flow_integrals(&searched, 2, random, &for_flow);

    begins("degrees of iterates");
    let limits =
        DegreeLimits { iterates: options.iterates, degree: options.iterate_degree, deadline: &for_degrees };
    let degrees = degrees(&sample.map, random, limits);
    let growth = plane::growth(&searched, &sample.map, &degrees, &mut random.clone(), &for_degrees);

    begins("relations on orbits");
    let usual = default_degree(searched.dimension());
    let degree = options.degree.unwrap_or(usual);
    let mut hilbert = Hilbert::of(&searched, degree, random, &for_orbits);
    // Orbits took too long up to this degree, so they are followed up to a lower one.
    if hilbert.is_none() && for_orbits.has_stopped() && degree > 1 {
        let lower = if degree > usual { usual } else { degree / 2 };
        hilbert = Hilbert::of(&searched, lower, random, &for_structure);
    }

    begins("structure of the field");
    let mut structure = structure(&searched, &fixed, &of_flow, random);
    let modified = Modified::all(&searched, &fixed.field, random, &for_structure);
    let place = sample.step(random).ok_or(DiscoverError::NoMap)?;
    let kept = of_flow.kept(&searched, random);
    structure.kept = kept.len();

    let search = Search {
        searched: &searched,
        field: &fixed.field,
        claims: &claims,
        modified: &modified,
        proved: &proved,
        kept: &kept,
        further: &rules.later,
        is_even: structure.is_even,
        place: &place,
        begins: &begins,
        tell,
    };
    let until = Deadlines { integrals: for_integrals, densities: for_densities, end: end.clone() };
    let mut found = search.found(hilbert.as_ref(), None, random, &until);
    begins("functions whose next value follows from their value");
    let until_drifts = Deadline::after(work, end.left().min(drift::TIME_SHARE * options.seconds));
    let drifts = drifts(
        &searched,
        &fixed.field,
        &claims,
        &found.of.integrals,
        &mut random.clone(),
        &until_drifts,
        tell,
    );
    let before = found.of.integrals.clone();
    let mut is_stopped =
        [&for_flow, &for_degrees, &for_orbits, &for_structure].iter().any(|deadline| deadline.has_stopped())
            || until.has_stopped();

    let n = searched.dimension();
    let linear =
        plane::linear(&searched, &place.sample.map, &growth, &drifts, &mut random.clone(), &for_structure);
    let by_drifts = drift::most_integrals(&drifts, n);
    let complete = |hilbert: &Hilbert, known, ceiling: Option<&IntegralBound>| {
        Bound::complete(hilbert, n, known, ceiling, &growth, linear, by_drifts)
    };
    let is_open = |hilbert: &Hilbert| complete(hilbert, found.of.independent, None).is_none();
    let trials = if options.degree.is_some() { FEW_TRIALS } else { MANY_TRIALS };
    let ceiling = hilbert
        .as_ref()
        .filter(|hilbert| is_open(hilbert))
        .and_then(|_| integral_bound(&searched, found.of.independent, trials, &mut random.clone(), &end));
    let bound = loop {
        let Some(known) = &hilbert else {
            break if is_stopped { Bound::Time } else { Bound::Poles };
        };
        if let Some(complete) = complete(known, found.of.independent, ceiling.as_ref()) {
            break complete;
        }
        if options.degree.is_some() {
            break if known.degree() < degree { Bound::Time } else { Bound::Degree };
        }
        let degree = known.degree() + 1;
        if Monomials::count(n, degree) > MOST_MONOMIALS_AT_ALL {
            break Bound::Size;
        }
        begins(&format!("relations of degree {degree} on orbits"));
        let Some(further) = known.further(&searched, degree, random, &end) else {
            break if end.has_stopped() { Bound::Time } else { Bound::Poles };
        };
        let are_more = further.integrals > known.integrals;
        hilbert = Some(further);
        if are_more {
            let until = Deadlines::shares_of(work, end.left());
            let next = search.found(hilbert.as_ref(), Some(&found), random, &until);
            is_stopped |= until.has_stopped();
            found = if next.integrals_found() < found.integrals_found() {
                SearchResult { of: Integrals { independent: next.of.independent, ..found.of }, ..found }
            } else {
                next
            };
        }
    };

    let count = modified.len();
    structure.hamiltonians = (1..)
        .zip(modified)
        .zip(&found.of.modified)
        .map(|((number, modified), &(is_proved, place))| {
            let tensor = &modified.found.tensor;
            HamiltonianReport {
                number: (count > 1).then_some(number),
                tensor: tensor
                    .iter()
                    .map(|row| row.iter().map(|k| Text.function(symbols, k)).collect())
                    .collect(),
                hamiltonian: Text.function(symbols, &modified.found.hamiltonian),
                modified_is_proved: is_proved,
                bracket_is_proved: found.brackets.structures.contains(&(number - 1)),
                found: modified.found,
                symbols: symbols.clone(),
                place,
            }
        })
        .collect();
    let mut report = Report {
        variables: symbols.states.clone(),
        parameters: symbols.parameters.clone(),
        growth,
        linear_iterates: linear,
        degrees,
        hilbert,
        independent: found.of.independent,
        ceiling,
        bound,
        drifts: drift::independent(drifts, &searched, &before, &found.of.integrals, &mut random.clone()),
        integrals: found.of.integrals,
        bases: found.of.bases,
        densities: found.densities,
        brackets: found.brackets.proved,
        polynomial_brackets: found.brackets.polynomial,
        density_search: found.density_search,
        own_density: claims.own_density().map(str::to_owned),
        structure,
        survivors: found.survivors,
        out_of_time: is_stopped || bound == Bound::Time,
        sentences: Vec::new(),
    };
    report.sentences = sentences(&report, is_stopped);
    Ok(report)
}

struct Deadlines<'a> {
    integrals: Deadline<'a>,
    densities: Deadline<'a>,
    end: Deadline<'a>,
}

impl<'a> Deadlines<'a> {
    fn shares_of(work: &'a WatchedSearch<'a>, left: f64) -> Self {
        let after = |share: f64| Deadline::after(work, share * left);
        Deadlines { integrals: after(0.7), densities: after(0.9), end: after(1.0) }
    }

    fn has_stopped(&self) -> bool {
        [&self.integrals, &self.densities, &self.end].iter().any(|deadline| deadline.has_stopped())
    }
}

pub(crate) fn specialised(
    system: &System,
    parameters: &[(String, Rational)],
    eps: Option<&Rational>,
) -> Result<System, DiscoverError> {
    let n = system.field.dimension();
    if n > MOST_VARIABLES {
        return Err(DiscoverError::TooManyVariables(n));
    }
    let mut values = Vec::new();
    for (name, value) in parameters {
        let place = system.field.symbols.parameters.iter().position(|known| known == name);
        values.push((place.ok_or_else(|| DiscoverError::UnknownParameter(name.clone()))?, value.clone()));
    }
    let bare = System { claims: Vec::new(), ..system.clone() };
    let fixed = bare.specialise(&values).ok_or(DiscoverError::UndefinedField)?;
    match eps {
        Some(eps) if fixed.field.depends_on_eps() => fixed.at_eps(eps).ok_or(DiscoverError::UndefinedField),
        _ => Ok(fixed),
    }
}

fn structure(
    searched: &SearchField,
    system: &System,
    of_flow: &FlowIntegrals,
    random: &mut SplitMix64,
) -> StructureReport {
    let symbols = &system.field.symbols;
    let written = |wanted: u32| -> Vec<String> {
        let chosen = of_flow.found.iter().filter(|polynomial| symbols.degree(polynomial) == wanted);
        chosen.map(|polynomial| Text.polynomial(symbols, polynomial)).collect()
    };
    StructureReport {
        depends_on_eps: system.field.depends_on_eps(),
        divergence: Text.function(symbols, &divergence(&system.field)),
        is_even: is_even(searched, random),
        linear_integrals: written(1),
        quadratic_integrals: written(2),
        flow_degree: of_flow.degree,
        kept: 0,
        hamiltonians: Vec::new(),
    }
}
