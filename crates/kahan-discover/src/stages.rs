//! The whole search, stage by stage.

use kahan_algebra::field::Field;
use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;

use crate::basis::{Basis, candidates, completing, prove};
use crate::brackets::{Brackets, PoissonTensor, brackets, of_structure, polynomial_tensors};
use crate::ceiling::{Ceiling, FEW_TRIALS, MANY_TRIALS, ceiling};
use crate::claims::{Claims, Formula};
use crate::composition::{Survivors, survivors};
use crate::deadline::{Deadline, Work};
use crate::degrees::{DegreeLimits, degrees};
use crate::densities::{densities, pfaffian_density};
use crate::drift::{self, drifts};
use crate::hilbert::{Hilbert, MOST_MONOMIALS_AT_ALL, default_degree};
use crate::independent::quotient_gradient;
use crate::integrals::{Aims, integrals};
use crate::matrix::Echelon;
use crate::modified::{Gradients, Modified, add_modified};
use crate::modulus::Modulus;
use crate::monomials::Monomials;
use crate::plane;
use crate::relations::Relations;
use crate::report::{
    Bound, DensitySearch, DiscoverError, HamiltonianReport, MOST_READABLE, MOST_VARIABLES, ModifiedPlace,
    Options, Report, StructureReport,
};
use crate::search::Reach;
use crate::search_field::{SampledStep, SearchField};
use crate::stepping::Stepping;
use crate::structure::{ByRules, FlowIntegrals, by_rules, divergence, flow_integrals, is_even};
use crate::watch::{Progress, Watch};
use crate::words::sentences;

/// The share of the remaining time for formulas, if compact forms give all integrals or a bracket
/// gives the density.
const SHARE_FOR_FORMULAS: f64 = 0.1;

/// Finds what the Kahan map of a system's field preserves. The claims of the system are not looked
/// at, so that nothing is found but from the equations. `watch` is told of every stage as it
/// begins, and of each claim that the report will hold as soon as that is proved; where relations
/// of higher degrees show more, a claim may be written anew, and is told again.
///
/// Equal fields and options give equal results, unless time runs out. Where no degree is given,
/// the search goes on to higher degrees while something may be missing and there is time, and
/// [`Report::bound`] says what ended it; what lower degrees show is the same on every machine.
///
/// # Errors
/// Where there is no map to look at: see [`DiscoverError`].
pub fn discover(system: &System, options: &Options, watch: &dyn Watch) -> Result<Report, DiscoverError> {
    let work = Work::new(watch);
    discover_within(system, options, &work, &|kind, text| work.found(kind, text))
}

/// The same as a part of other work; `tell` hears the kind and the line of each claim.
pub(crate) fn discover_within(
    system: &System,
    options: &Options,
    work: &Work<'_>,
    tell: &dyn Fn(ClaimKind, &str),
) -> Result<Report, DiscoverError> {
    // Until when each stage may go on.
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
    let rules = if for_flow.passed() { ByRules::default() } else { by_rules(&searched, &fixed.field) };
    let proved = rules.proved(&searched, &claims, &mut random.clone());
    for formula in proved.iter().filter(|formula| formula.text.len() <= MOST_READABLE) {
        tell(formula.kind, &formula.text);
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
    // A lower degree is a fraction of the work, and better than nothing: the usual one, or half of
    // that.
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
    let until = Until { integrals: for_integrals, densities: for_densities, end: end.clone() };
    let mut found = search.found(hilbert.as_ref(), None, random, &until);
    begins("functions whose next value follows from their value");
    let until_drifts = Deadline::after(work, end.left().min(drift::SHARE * options.seconds));
    let drifts =
        drifts(&searched, &fixed.field, &claims, &found.integrals, &mut random.clone(), &until_drifts, tell);
    let before = found.integrals.clone();
    let mut is_stopped =
        [&for_flow, &for_degrees, &for_orbits, &for_structure].iter().any(|deadline| deadline.has_stopped())
            || until.has_stopped();

    let n = searched.dimension();
    let linear =
        plane::linear(&searched, &place.sample.map, &growth, &drifts, &mut random.clone(), &for_structure);
    let by_drifts = drift::most_integrals(&drifts, n);
    let complete = |hilbert: &Hilbert, known, ceiling: Option<&Ceiling>| {
        Bound::complete(hilbert, n, known, ceiling, &growth, linear, by_drifts)
    };
    let is_open = |hilbert: &Hilbert| complete(hilbert, found.independent, None).is_none();
    let trials = if options.degree.is_some() { FEW_TRIALS } else { MANY_TRIALS };
    let ceiling = hilbert
        .as_ref()
        .filter(|hilbert| is_open(hilbert))
        .and_then(|_| ceiling(&searched, found.independent, trials, &mut random.clone(), &end));
    let bound = loop {
        let Some(known) = &hilbert else {
            break if is_stopped { Bound::Time } else { Bound::Poles };
        };
        if let Some(complete) = complete(known, found.independent, ceiling.as_ref()) {
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
            let until = Until::shares_of(work, end.left());
            let next = search.found(hilbert.as_ref(), Some(&found), random, &until);
            is_stopped |= until.has_stopped();
            // Where the time ran out the formulas before may be more.
            found = if next.said() < found.said() {
                Found { independent: next.independent, ..found }
            } else {
                next
            };
        }
    };

    let count = modified.len();
    structure.hamiltonians = (1..)
        .zip(modified)
        .zip(&found.modified)
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
    let (bracket_ranks, brackets) = found.brackets.claims.into_iter().unzip();
    let mut report = Report {
        variables: symbols.states.clone(),
        parameters: symbols.parameters.clone(),
        growth,
        linear_iterates: linear,
        degrees,
        hilbert,
        independent: found.independent,
        ceiling,
        bound,
        drifts: drift::independent(drifts, &searched, &before, &found.integrals, &mut random.clone()),
        integrals: found.integrals,
        bases: found.bases,
        densities: found.densities,
        bracket_ranks,
        brackets,
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

/// Until when the stages that look for formulas may go on.
struct Until<'a> {
    integrals: Deadline<'a>,
    densities: Deadline<'a>,
    end: Deadline<'a>,
}

impl<'a> Until<'a> {
    /// As much of the time that is left as each had of the whole after the stages before.
    fn shares_of(work: &'a Work<'a>, left: f64) -> Self {
        let after = |share: f64| Deadline::after(work, share * left);
        Until { integrals: after(0.7), densities: after(0.9), end: after(1.0) }
    }

    fn has_stopped(&self) -> bool {
        [&self.integrals, &self.densities, &self.end].iter().any(|deadline| deadline.has_stopped())
    }
}

/// What formulas are looked for with.
struct Search<'a> {
    searched: &'a SearchField,
    field: &'a Field,
    claims: &'a Claims<'a>,
    /// The modified Hamiltonians of all K.
    modified: &'a [Modified],
    /// Integrals of the map that the field shows at once, proved.
    proved: &'a [Formula],
    /// Integrals of the flow that the map keeps.
    kept: &'a [Polynomial],
    /// Integrals of the map by the rotation rule.
    further: &'a [(Polynomial, Polynomial)],
    is_even: bool,
    /// Where independence is seen.
    place: &'a SampledStep,
    /// Who hears of a stage that begins, and of a claim that is proved.
    begins: &'a dyn Fn(&str),
    tell: &'a dyn Fn(ClaimKind, &str),
}

/// What was found with the relations of some degree.
struct Found {
    integrals: Vec<Formula>,
    bases: Vec<Basis>,
    /// How many independent integrals there are, with those that only orbits show.
    independent: usize,
    /// For each modified Hamiltonian, whether it is proved as a claim, and how it is to be given.
    modified: Vec<(bool, ModifiedPlace)>,
    densities: Vec<Formula>,
    density_search: DensitySearch,
    /// The tensors of the polynomial brackets.
    tensors: Vec<PoissonTensor>,
    brackets: Brackets,
    survivors: Option<Survivors>,
}

impl Found {
    /// How many integrals have a formula, a compact form, or stand in a basis.
    fn said(&self) -> usize {
        let in_bases: usize = self.bases.iter().map(|basis| basis.integrals.len()).sum();
        let alone = self.modified.iter().filter(|(_, place)| *place == ModifiedPlace::Alone);
        self.integrals.len() + in_bases + alone.count()
    }
}

impl Search<'_> {
    /// Looks for formulas, bases, densities and brackets; a density that was found `before` is not
    /// looked for again.
    fn found(
        &self,
        hilbert: Option<&Hilbert>,
        before: Option<&Found>,
        random: &mut SplitMix64,
        until: &Until<'_>,
    ) -> Found {
        let searched = self.searched;
        let symbols = &self.field.symbols;
        (self.begins)("formulas of integrals");
        let shown = hilbert.map_or(0, |hilbert| hilbert.integrals);
        let defining = hilbert
            .filter(|_| shown > 0)
            .and_then(|hilbert| hilbert.defining_degree(&self.place.sample.map, random, &until.integrals));
        let candidates =
            defining.map_or_else(Vec::new, |degree| candidates(searched, degree, random, &until.integrals));
        let SampledStep { sample, here, .. } = self.place;
        let of_modified = |modified: &Modified| modified.found.modified_gradient(searched, sample, here);
        let own: Vec<Option<Vec<u64>>> = self.modified.iter().map(of_modified).collect();
        let in_compact_forms = self.rank(&own.iter().flatten().cloned().collect::<Vec<_>>());
        // If bases or compact forms give all integrals, only short formulas are searched for.
        let in_bases = completing(&candidates, shown, self.place, &mut Vec::new(), &until.integrals);
        let in_bases = in_bases.iter().map(|basis| basis.integrals.len()).sum::<usize>();
        let are_enough = in_bases.max(in_compact_forms) >= shown;
        let for_formulas = until.integrals.after_share(SHARE_FOR_FORMULAS);
        let until_formulas = if in_compact_forms >= shown { &for_formulas } else { &until.integrals };
        let reach = if are_enough { Reach::SHORT } else { Reach::FULL };
        // A long formula is left out if bases or compact forms give all integrals.
        let is_short = |formula: &Formula| !are_enough || formula.text.len() <= MOST_READABLE;
        let tell = |formula: &Formula| (self.tell)(formula.kind, &formula.text);
        let tell_if_short = |formula: &Formula| {
            if is_short(formula) {
                tell(formula);
            }
        };
        let known: Vec<_> = self.modified.iter().filter_map(|modified| modified.written.clone()).collect();
        let quotients =
            candidates.iter().filter_map(|basis| basis.quotient_of_terms(searched, &mut random.clone()));
        let further: Vec<_> = self.further.iter().cloned().chain(quotients).collect();
        let aims = Aims {
            proved: self.proved,
            kept: self.kept,
            further: (&further, &until.end),
            hilbert,
            known: &known,
            reach,
            tell: &tell_if_short,
        };
        let mut all_integrals = integrals(searched, self.claims, &aims, random, until_formulas);
        let are_proved =
            add_modified(self.modified, searched, self.claims, symbols, &mut all_integrals, random);
        // Each but the modified Hamiltonians was told; none is told twice.
        all_integrals.iter().for_each(tell_if_short);

        let mut gradients: Vec<Vec<u64>> =
            all_integrals.iter().filter_map(|formula| self.gradient(formula)).collect();
        gradients.extend(own.iter().flatten().cloned());
        gradients.extend(defining.map_or_else(Vec::new, |degree| self.normals(degree, &until.integrals)));
        let independent = self.rank(&gradients).max(shown);

        let (mut integrals, long): (Vec<Formula>, Vec<Formula>) =
            all_integrals.iter().cloned().partition(is_short);
        let mut gradients: Vec<Vec<u64>> =
            integrals.iter().filter_map(|formula| self.gradient(formula)).collect();
        let mut add = |gradients: &mut Vec<Vec<u64>>, formula: Formula| {
            let gradient = self.gradient(&formula);
            if gradient.is_some_and(|gradient| self.extends(gradients, gradient)) {
                tell(&formula);
                integrals.push(formula);
            }
        };
        // Whether a formula depends on the formulas so far and the modified Hamiltonians, but not
        // on the formulas so far alone.
        let says_the_same = |formula: &Formula| {
            let mut rows = [&gradients[..], &own.iter().flatten().cloned().collect::<Vec<_>>()].concat();
            let rank = self.rank(&rows);
            rows.extend(self.gradient(formula));
            rank > gradients.len() && self.rank(&rows) == rank
        };
        let (same, long): (Vec<Formula>, Vec<Formula>) = long.into_iter().partition(says_the_same);
        for formula in same {
            add(&mut gradients, formula);
        }
        for own in own.iter().flatten() {
            self.extends(&mut gradients, own.clone());
        }
        let mut bases = completing(&candidates, independent, self.place, &mut gradients, &until.densities);
        for basis in &mut bases {
            basis.join(searched, random);
            basis.proof = prove(basis, searched, self.field, &until.densities);
        }
        for formula in long {
            add(&mut gradients, formula);
        }
        let in_bases = bases.iter().filter_map(|basis| basis.gradients(&sample.map, here)).flatten();
        let known = Gradients {
            formulas: integrals.iter().map(|formula| self.gradient(formula)).collect(),
            in_bases: in_bases.collect(),
            modified: &own,
            rank: &|gradients| self.rank(gradients),
        };
        let places = known.places(self.modified, &integrals, symbols);

        (self.begins)("invariant Poisson brackets");
        // In two and three variables the density and the integrals give all brackets. A search in
        // three variables up to degree 2 may find shorter ones.
        let is_said = searched.dimension() < 4 && integrals.len() + 2 >= searched.dimension();
        let highest = if is_said { 2 } else { u32::MAX };
        let tensors = match before {
            Some(before) => before.tensors.clone(),
            None if searched.dimension() < 3 => Vec::new(),
            None => {
                let structures = self.modified.iter().map(|modified| &modified.found).enumerate();
                let known = structures.filter_map(|one| of_structure(searched, self.field, one, random));
                let known = known.collect();
                polynomial_tensors(searched, known, highest, random, &until.densities)
            }
        };

        (self.begins)("invariant densities");
        let of_tensor =
            tensors.iter().find_map(|tensor| pfaffian_density(tensor, self.claims, symbols, &all_integrals));
        let known = before.filter(|before| !before.densities.is_empty());
        // A bracket of full rank implies a density. If none was found from it, the formula is long.
        let is_implied = tensors.first().is_some_and(|tensor| tensor.rank == searched.dimension());
        let for_formulas = until.densities.after_share(SHARE_FOR_FORMULAS);
        let until_densities = if is_implied { &for_formulas } else { &until.densities };
        let (densities, density_search) = match (of_tensor, known) {
            (Some(density), _) => {
                let search = DensitySearch { seen: Some(density.degree), none_up_to: None };
                (vec![density], search)
            }
            (None, Some(before)) => (before.densities.clone(), before.density_search),
            (None, None) => densities(
                searched,
                self.claims,
                &all_integrals,
                self.field,
                self.is_even,
                random,
                until_densities,
            ),
        };
        densities.iter().for_each(tell);
        let density = densities.first();
        let brackets = brackets(self.claims, symbols, &tensors, &integrals, density, &until.densities);
        brackets.claims.iter().for_each(|(_, bracket)| (self.tell)(ClaimKind::Bracket, bracket));

        (self.begins)("what survives composition");
        let survivors = hilbert
            .filter(|hilbert| hilbert.integrals > 0)
            .and_then(|hilbert| survivors(searched, &integrals, hilbert.degree(), random, &until.end));
        Found {
            integrals,
            bases,
            independent,
            modified: are_proved.into_iter().zip(places).collect(),
            densities,
            density_search,
            tensors,
            brackets,
            survivors,
        }
    }

    /// The gradient of a formula, up to a factor.
    fn gradient(&self, formula: &Formula) -> Option<Vec<u64>> {
        let SampledStep { sample, here, .. } = self.place;
        quotient_gradient(self.searched, sample, here, &formula.numerator, &formula.denominator)
    }

    fn rank(&self, gradients: &[Vec<u64>]) -> usize {
        let modulus = self.place.sample.map.modulus();
        Echelon::of(modulus, gradients.to_vec(), self.searched.dimension()).rank()
    }

    /// Adds a gradient that is independent of those before; whether it is.
    fn extends(&self, gradients: &mut Vec<Vec<u64>>, gradient: Vec<u64>) -> bool {
        gradients.push(gradient);
        let is_independent = self.rank(gradients) == gradients.len();
        if !is_independent {
            gradients.pop();
        }
        is_independent
    }

    /// What the relations up to a degree on the orbit of the place say of gradients there; nothing
    /// where the time is over.
    fn normals(&self, degree: u32, deadline: &Deadline<'_>) -> Vec<Vec<u64>> {
        let SampledStep { sample, here, .. } = self.place;
        let monomials = Monomials::new(self.searched.dimension(), degree);
        Relations::on_orbit(&sample.map, here.clone(), &monomials, deadline)
            .map_or_else(Vec::new, |relations| relations.normals(sample.map.modulus(), &monomials))
    }
}

/// The system at the values given, and without claims.
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
