//! The whole search, stage by stage.

use std::time::Instant;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::render::Notation;
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::System;

use crate::basis::{candidates, completing, prove};
use crate::brackets::brackets;
use crate::claims::{Claims, Formula};
use crate::composition::survivors;
use crate::deadline::Deadline;
use crate::degrees::{DegreeLimits, degrees};
use crate::densities::densities;
use crate::growth::GrowthVerdict;
use crate::hamiltonian::hamiltonian;
use crate::hilbert::{Hilbert, default_degree};
use crate::independent::{Independent, quotient_gradient};
use crate::integrals::{Aims, integrals};
use crate::modulus::Modulus;
use crate::report::{DiscoverError, HamiltonianReport, Options, Report, Stage, StructureReport};
use crate::search::Reach;
use crate::setting::Setting;
use crate::space::tidy;
use crate::structure::{FlowIntegrals, divergence, flow_integrals, is_even};
use crate::words::sentences;
use crate::writing::factors_of;

/// A formula of more characters is left to a basis, where there is one.
const MOST_CHARACTERS: usize = 4000;

/// Finds what the Kahan map of a system's field preserves. The claims of the system are not looked
/// at, so that nothing is found but from the equations; `progress` is told of every stage as it
/// begins.
///
/// Equal fields and options give equal results, unless time runs out.
///
/// # Errors
/// Where there is no map to look at: see [`DiscoverError`].
pub fn discover(
    system: &System,
    options: &Options,
    progress: &mut dyn FnMut(Stage),
) -> Result<Report, DiscoverError> {
    let start = Instant::now();
    // Until when each stage may go on.
    let [for_flow, for_degrees, for_orbits, for_structure, for_integrals, for_densities, for_composition] =
        [0.1, 0.25, 0.42, 0.5, 0.85, 0.95, 1.0].map(|share| Deadline::after(start, options.seconds * share));
    let fixed = specialised(system, &options.parameters)?;
    let symbols = &fixed.field.symbols;
    if options.eps.as_ref().is_some_and(Rational::is_zero) {
        return Err(DiscoverError::ZeroStep);
    }
    let setting = Setting::new(&fixed.field, options.eps.clone());
    let mut random = SplitMix64::from_bytes(format!("{:?}{:?}", fixed.field, options.eps).as_bytes());
    let random = &mut random;
    let draw = setting.draw(Modulus::mersenne_61(), random).ok_or(DiscoverError::NoMap)?;
    if options.eps.is_some() && !setting.is_invertible(random) {
        return Err(DiscoverError::Collapse);
    }

    progress(Stage::Flow);
    let of_flow = flow_integrals(&setting, 2, random, &for_flow);

    progress(Stage::Degrees);
    let limits =
        DegreeLimits { iterates: options.iterates, degree: options.iterate_degree, deadline: &for_degrees };
    let degrees = degrees(&draw.map, random, limits);

    progress(Stage::Orbits);
    let usual = default_degree(setting.dimension());
    let degree = options.degree.unwrap_or(usual);
    let mut hilbert = Hilbert::of(&setting, degree, random, &for_orbits);
    // A lower degree is a fraction of the work, and better than nothing: the usual one, or half of
    // that.
    if hilbert.is_none() && for_orbits.has_stopped() && degree > 1 {
        let lower = if degree > usual { usual } else { degree / 2 };
        hilbert = Hilbert::of(&setting, lower, random, &for_structure);
    }

    progress(Stage::Structure);
    let claims = Claims::new(system, &options.parameters, options.eps.as_ref());
    let mut structure = structure(&setting, &fixed, &of_flow, random);
    let hamiltonian = hamiltonian(&setting, random, &for_structure);

    progress(Stage::Integrals);
    let place = draw.step(random).ok_or(DiscoverError::NoMap)?;
    let shown = hilbert.as_ref().map_or(0, |hilbert| hilbert.integrals);
    let candidates = hilbert
        .as_ref()
        .filter(|_| shown > 0)
        .and_then(|hilbert| hilbert.defining_degree(&place.draw.map, random, &for_integrals))
        .map_or_else(Vec::new, |degree| candidates(&setting, degree, random, &for_integrals));
    // Where bases say all, formulas are worth looking for only where they are short.
    let in_bases = completing(&candidates, shown, &place, Vec::new(), &for_integrals);
    let are_enough = in_bases.iter().map(|basis| basis.integrals.len()).sum::<usize>() >= shown;
    let reach = if are_enough { Reach::SHORT } else { Reach::FULL };
    let modified = hamiltonian.as_ref().and_then(|found| {
        let (above, below) = found.modified(&setting, &fixed.field)?;
        Some((tidy(symbols, &above), tidy(symbols, &below)))
    });
    let kept = of_flow.kept(&setting, random);
    structure.kept = kept.len();
    let aims = Aims { kept, hilbert: hilbert.as_ref(), known: modified.as_ref(), reach };
    let mut integrals = integrals(&setting, &claims, &aims, random, &for_integrals);
    if let Some(found) = &hamiltonian {
        let proved = modified.as_ref().is_some_and(|(above, below)| {
            let is_listed = |known: &Formula| known.numerator == *above && known.denominator == *below;
            if integrals.iter().any(is_listed) {
                return true;
            }
            let formula =
                claims.integral(symbols, integrals.len() + 1, above, below, &factors_of(&integrals));
            let is_proved = formula.is_some();
            add_if_independent(&setting, &mut integrals, formula, random);
            is_proved
        });
        structure.hamiltonian = Some(HamiltonianReport {
            tensor: found.tensor.iter().map(|row| row.iter().map(|k| text(symbols, k)).collect()).collect(),
            hamiltonian: text(symbols, &found.hamiltonian),
            modified_is_proved: proved,
        });
    }

    // What a basis says in a line need not fill a page.
    let is_short = |formula: &&Formula| !are_enough || formula.text.len() <= MOST_CHARACTERS;
    let all_integrals = integrals;
    let integrals: Vec<Formula> = all_integrals.iter().filter(is_short).cloned().collect();
    let known = integrals.iter().filter_map(|formula| {
        quotient_gradient(&setting, &place.draw, &place.here, &formula.numerator, &formula.denominator)
    });
    let mut bases = completing(&candidates, shown, &place, known.collect(), &for_densities);
    for basis in &mut bases {
        basis.proof = prove(basis, &setting, &fixed.field, random, &for_densities);
    }

    progress(Stage::Densities);
    let (densities, density_search) =
        densities(&setting, &claims, &all_integrals, &fixed.field, structure.is_even, random, &for_densities);
    let brackets = match densities.first() {
        Some(density) => brackets(&claims, symbols, &integrals, density, &for_densities),
        None => Vec::new(),
    };

    progress(Stage::Composition);
    let survivors = hilbert
        .as_ref()
        .filter(|hilbert| hilbert.integrals > 0)
        .and_then(|hilbert| survivors(&setting, &integrals, hilbert.degree(), random, &for_composition));
    let deadlines =
        [for_flow, for_degrees, for_orbits, for_structure, for_integrals, for_densities, for_composition];
    let mut report = Report {
        variables: symbols.states.clone(),
        parameters: symbols.parameters.clone(),
        growth: GrowthVerdict::of(&degrees),
        degrees,
        hilbert,
        integrals,
        bases,
        densities,
        brackets,
        density_search,
        own_density: claims.own_density().map(str::to_owned),
        structure,
        survivors,
        out_of_time: deadlines.iter().any(Deadline::has_stopped),
        sentences: Vec::new(),
    };
    report.sentences = sentences(&report);
    Ok(report)
}

/// The system at the values given, and without claims.
pub(crate) fn specialised(
    system: &System,
    parameters: &[(String, Rational)],
) -> Result<System, DiscoverError> {
    if !system.is_field_sound || system.field.dimension() == 0 {
        return Err(DiscoverError::UnsoundField);
    }
    let mut values = Vec::new();
    for (name, value) in parameters {
        let place = system.field.symbols.parameters.iter().position(|known| known == name);
        values.push((place.ok_or_else(|| DiscoverError::UnknownParameter(name.clone()))?, value.clone()));
    }
    let bare = System { claims: Vec::new(), ..system.clone() };
    bare.specialise(&values).ok_or(DiscoverError::UndefinedField)
}

fn structure(
    setting: &Setting,
    system: &System,
    of_flow: &FlowIntegrals,
    random: &mut SplitMix64,
) -> StructureReport {
    let symbols = &system.field.symbols;
    let written = |wanted: u32| -> Vec<String> {
        let chosen = of_flow.found.iter().filter(|polynomial| symbols.degree(polynomial) == wanted);
        chosen.map(|polynomial| Notation::Text.polynomial(symbols, polynomial)).collect()
    };
    StructureReport {
        divergence: text(symbols, &divergence(&system.field)),
        is_even: is_even(setting, random),
        linear_integrals: written(1),
        quadratic_integrals: written(2),
        flow_degree: of_flow.degree,
        kept: 0,
        hamiltonian: None,
    }
}

fn text(symbols: &Symbols, function: &RationalFunction) -> String {
    let above = Notation::Text.polynomial(symbols, function.numerator());
    match function.as_polynomial() {
        Some(_) => above,
        None => Notation::Text.quotient(&above, &Notation::Text.polynomial(symbols, function.denominator())),
    }
}

/// A formula that depends on the others adds nothing; one that replaces nothing is kept.
fn add_if_independent(
    setting: &Setting,
    integrals: &mut Vec<Formula>,
    formula: Option<Formula>,
    random: &mut SplitMix64,
) {
    let Some(formula) = formula else { return };
    let mut independent = Independent::new(setting, random);
    for known in integrals.iter() {
        independent.keep(&known.numerator, &known.denominator);
    }
    if independent.admits(&formula.numerator, &formula.denominator) {
        integrals.push(formula);
    }
}
