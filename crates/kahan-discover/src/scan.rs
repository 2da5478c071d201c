//! Finds special values of parameters and ε on a rational grid, where degrees or ranks are not
//! generic.

mod proposals;
mod vanishing_polynomials;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;

use crate::deadline::{Deadline, WatchedSearch};
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::orbits::degrees::{DegreeLimits, degrees};
use crate::orbits::hilbert::{Hilbert, default_degree};
use crate::report::{DiscoverError, Options};
use crate::stages::specialised;
use crate::watch::{Progress, Watch};

pub use proposals::Proposal;

/// A parameter, or ε, with its values on a grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScannedQuantity {
    /// The name of the parameter, or `eps`.
    pub name: String,
    /// The values on the grid.
    pub values: Vec<Rational>,
}

/// Degrees and ranks observed at one grid point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DegreesAndRanks {
    /// The degrees d₀ = 1, d₁, … of the iterates.
    pub degrees: Vec<usize>,
    /// The values h(1), h(2), … of the Hilbert function.
    pub hilbert: Vec<usize>,
    /// The number of independent algebraic integrals that orbits show.
    pub integrals: usize,
}

/// A point of the grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridPoint {
    /// The values of the scanned parameters, in the order of the names.
    pub values: Vec<Rational>,
    /// The degrees and ranks, or `None` if no map exists or its orbits end at poles.
    pub sight: Option<DegreesAndRanks>,
}

/// The degrees and ranks observed on a grid, and at generic values.
#[derive(Clone, Debug)]
pub struct Scan {
    /// The names of the scanned parameters.
    pub names: Vec<String>,
    /// The degrees and ranks at generic values of all scanned parameters.
    pub generic: DegreesAndRanks,
    /// The points of the grid. The last parameter changes fastest. Points are missing if time ran
    /// out.
    pub points: Vec<GridPoint>,
    /// Relations between scanned parameters. Every grid point that satisfies a relation is special.
    pub relations: Vec<Proposal>,
    /// Whether time ran out.
    pub out_of_time: bool,
}

impl Scan {
    /// Returns the points at which degrees or ranks differ from the generic values.
    pub fn special(&self) -> impl Iterator<Item = &GridPoint> {
        self.points.iter().filter(|point| point.sight.as_ref() != Some(&self.generic))
    }
}

/// The number of iterates at each point, which is low enough for thousands of points.
const ITERATES_PER_POINT: usize = 6;
const ITERATE_DEGREE: usize = 250;
const MOST_MONOMIALS: usize = 84;

/// Observes degrees and ranks on the grid, and proves claims that hold under a relation of the
/// parameters and ε.
///
/// `options` fixes further parameters and ε, and limits the time and the degree of relations on
/// orbits. `watch` is told the number of finished points, and each proved claim.
///
/// # Errors
/// Returns the errors of [`discover`](crate::discover()) for the field at generic values of the
/// scanned parameters.
pub fn scan(
    system: &System,
    scanned: &[ScannedQuantity],
    options: &Options,
    watch: &dyn Watch,
) -> Result<Scan, DiscoverError> {
    let work = &WatchedSearch::new(watch);
    let deadline = Deadline::after(work, options.seconds);
    for quantity in scanned.iter().filter(|quantity| quantity.name != "eps") {
        if !system.field.symbols.parameters.contains(&quantity.name) {
            return Err(DiscoverError::UnknownParameter(quantity.name.clone()));
        }
    }
    let n = system.field.dimension();
    let degree = options.degree.unwrap_or_else(|| {
        let small = |degree: &u32| Monomials::count(n, *degree) <= MOST_MONOMIALS;
        (1..=default_degree(n)).rev().find(small).unwrap_or(1)
    });
    let total: usize = scanned.iter().map(|quantity| quantity.values.len()).product();
    let show =
        |done: usize| work.show(&Progress { what: "points", done: done as u64, of: Some(total as u64) });
    show(0);
    // The generic degrees and ranks are needed for every comparison, so they are computed without a
    // deadline.
    let generic =
        degrees_and_ranks(system, &[], options, degree, &Deadline::never())?.ok_or(DiscoverError::NoMap)?;
    let mut points = Vec::new();
    for index in 0..total {
        if deadline.passed() {
            break;
        }
        let mut rest = index;
        let mut values = Vec::with_capacity(scanned.len());
        for quantity in scanned.iter().rev() {
            values.push((quantity.name.clone(), quantity.values[rest % quantity.values.len()].clone()));
            rest /= quantity.values.len();
        }
        values.reverse();
        let sight = degrees_and_ranks(system, &values, options, degree, &deadline).unwrap_or(None);
        if deadline.has_stopped() {
            break;
        }
        points.push(GridPoint { values: values.into_iter().map(|(_, value)| value).collect(), sight });
        show(index + 1);
    }
    let out_of_time = points.len() < total;
    let names = scanned.iter().map(|quantity| quantity.name.clone()).collect();
    let mut scan = Scan { names, generic, points, relations: Vec::new(), out_of_time };
    scan.relations = proposals::proposals(system, &scan, options, work, &deadline);
    Ok(scan)
}

/// Observes degrees and ranks at these values. Returns `Ok(None)` if orbits end at poles or time
/// runs out.
fn degrees_and_ranks(
    system: &System,
    values: &[(String, Rational)],
    options: &Options,
    degree: u32,
    deadline: &Deadline<'_>,
) -> Result<Option<DegreesAndRanks>, DiscoverError> {
    let is_scanned = |name: &str| values.iter().any(|(scanned, _)| scanned == name);
    let mut parameters: Vec<(String, Rational)> =
        values.iter().filter(|(name, _)| name != "eps").cloned().collect();
    parameters.extend(options.parameters.iter().filter(|(name, _)| !is_scanned(name)).cloned());
    let eps = values.iter().find(|(name, _)| name == "eps").map(|(_, value)| value.clone());
    let eps = eps.or_else(|| options.eps.clone());
    let fixed = specialised(system, &parameters, eps.as_ref())?;
    let searched = SearchField::new(&fixed.field, eps);
    let mut random = SplitMix64::from_bytes(format!("{values:?}").as_bytes());
    let sample = searched.sample(Modulus::mersenne_61(), &mut random).ok_or(DiscoverError::NoMap)?;
    if searched.eps().is_some() && !searched.is_invertible(&mut random) {
        return Err(DiscoverError::Collapse);
    }
    let limits = DegreeLimits { iterates: ITERATES_PER_POINT, degree: ITERATE_DEGREE, deadline };
    let degrees = degrees(&sample.map, &mut random, limits);
    Ok(Hilbert::of(&searched, degree, &mut random, deadline).map(|hilbert| DegreesAndRanks {
        degrees,
        integrals: hilbert.integrals,
        hilbert: hilbert.values,
    }))
}
