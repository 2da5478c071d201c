//! Special values of parameters and of ε: where degrees or ranks on a rational grid are not the
//! generic ones.

mod proposals;
mod shapes;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;

use crate::deadline::{Deadline, Work};
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::modular::monomials::Monomials;
use crate::orbits::degrees::{DegreeLimits, degrees};
use crate::orbits::hilbert::{Hilbert, default_degree};
use crate::report::{DiscoverError, Options};
use crate::stages::specialised;
use crate::watch::{Progress, Watch};

pub use proposals::Proposal;

/// A parameter, or ε, with the values that it takes on a grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scanned {
    /// The parameter, or `eps`.
    pub name: String,
    /// The values.
    pub values: Vec<Rational>,
}

/// What was seen at values of the scanned quantities.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sight {
    /// d₀ = 1, d₁, ….
    pub degrees: Vec<usize>,
    /// h(1), h(2), ….
    pub hilbert: Vec<usize>,
    /// The independent algebraic integrals that orbits show.
    pub integrals: usize,
}

/// A point of the grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridPoint {
    /// The values, in the order of the names.
    pub values: Vec<Rational>,
    /// What was seen there; absent where there is no map, or none that can be inverted, or its
    /// orbits end at poles.
    pub sight: Option<Sight>,
}

/// A grid, and what is seen at generic values.
#[derive(Clone, Debug)]
pub struct Scan {
    /// The names of what is scanned.
    pub names: Vec<String>,
    /// What was seen with all scanned quantities generic.
    pub generic: Sight,
    /// The grid, the last quantity running fastest; shorter than it where time ran out.
    pub points: Vec<GridPoint>,
    /// Relations between scanned quantities at which all points of the grid are special, where
    /// there are two or more.
    pub relations: Vec<Proposal>,
    /// Whether time ran out.
    pub out_of_time: bool,
}

impl Scan {
    /// The points where something else is seen than at generic values.
    pub fn special(&self) -> impl Iterator<Item = &GridPoint> {
        self.points.iter().filter(|point| point.sight.as_ref() != Some(&self.generic))
    }
}

/// Iterates, the degree of the last of them, and monomials of relations: enough to tell special
/// values, little enough for thousands of points.
const ITERATES: usize = 6;
const ITERATE_DEGREE: usize = 250;
const MOST_MONOMIALS: usize = 84;

/// Degrees and ranks on the grid of all quantities, and what is proved where relations between them
/// hold. `options` fixes further parameters and ε, the degree of relations and the time; `watch`
/// is told how many points are done, and of claims where relations hold as they are proved.
///
/// # Errors
/// As [`discover`](crate::discover()), for the field at generic values of what is scanned.
pub fn scan(
    system: &System,
    scanned: &[Scanned],
    options: &Options,
    watch: &dyn Watch,
) -> Result<Scan, DiscoverError> {
    let work = &Work::new(watch);
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
    // Without it there is nothing to compare with: it is looked at in any case.
    let generic = look(system, &[], options, degree, &Deadline::never())?.ok_or(DiscoverError::NoMap)?;
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
        let sight = look(system, &values, options, degree, &deadline).unwrap_or(None);
        // What was cut short says nothing.
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

/// Degrees and ranks at these values; `None` inside where orbits end at poles.
fn look(
    system: &System,
    values: &[(String, Rational)],
    options: &Options,
    degree: u32,
    deadline: &Deadline<'_>,
) -> Result<Option<Sight>, DiscoverError> {
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
    let limits = DegreeLimits { iterates: ITERATES, degree: ITERATE_DEGREE, deadline };
    let degrees = degrees(&sample.map, &mut random, limits);
    Ok(Hilbert::of(&searched, degree, &mut random, deadline).map(|hilbert| Sight {
        degrees,
        integrals: hilbert.integrals,
        hilbert: hilbert.values,
    }))
}
