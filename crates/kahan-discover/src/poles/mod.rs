//! Maps at their poles: curves (surfaces in three variables) that are sent to infinity or
//! contracted.
//!
//! A curve is *blown down* if its image has a lower dimension. This singularity is *confined* after
//! k steps if the image after k steps is a curve again. Results must agree modulo two primes at
//! random points, with random values of parameters and ε that are not fixed. Confinement alone
//! proves nothing: Hietarinta and Viallet's map (Phys. Rev. Lett. 81, 1998) has confined
//! singularities and is chaotic. The degrees of iterates are reported, too.

pub(crate) mod curves;
mod implied_degrees;
mod jet;
mod roots;
mod series;

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::System;

use crate::deadline::{Deadline, WatchedSearch};
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::orbits::degrees::{DegreeLimits, degrees};
use crate::report::{DiscoverError, Options};
use crate::stages::specialised;
use crate::watch::{Progress, Watch};
use curves::Curves;
pub use jet::Image;
use jet::{CurvePoint, Homogeneous, NoImage, Values};

/// The singularity pattern of one curve.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The polynomial that vanishes on the curve, or `None` for the points at infinity.
    pub curve: Option<Polynomial>,
    /// The images of the curve after 1, 2, … steps, or none if two primes disagree.
    pub images: Vec<Image>,
    /// The number of steps until the image is a curve again, or else the number of steps followed.
    pub steps: usize,
    /// Whether an image of the curve is a curve again. This is `None` if the results modulo two
    /// primes differ or are undecided.
    pub confined: Option<bool>,
}

/// The singularity patterns of a map.
#[derive(Clone, Debug)]
pub struct Poles {
    /// The names of states and parameters.
    pub symbols: Symbols,
    /// The patterns of the followed curves.
    pub patterns: Vec<Pattern>,
    /// The number of steps for which curves were followed.
    pub bound: usize,
    /// Whether `patterns` has all curves whose image has a lower dimension. Some may be missing if
    /// the Jacobian determinant is too long to be factored.
    pub is_complete: bool,
    /// The measured degrees d₀, d₁, … of the iterates.
    pub degrees: Vec<usize>,
    /// The degrees that the patterns imply, or `None` if a pattern is undecided or missing.
    pub implied_degrees: Option<Vec<usize>>,
}

impl Pattern {
    /// Returns whether the first image has a lower dimension than the curve.
    #[must_use]
    pub fn is_blown_down(&self) -> bool {
        self.confined != Some(true) || self.steps > 1
    }

    /// Writes the curve in words.
    #[must_use]
    pub fn name(&self, symbols: &Symbols) -> String {
        self.curve.as_ref().map_or_else(|| "infinity".to_owned(), |curve| Text.polynomial(symbols, curve))
    }
}

const SHORTEST: usize = 12;
const LONGEST: usize = 200;

/// The most attempts to follow a curve. For example, a random line may have no point on the curve.
const MOST_SAMPLES: usize = 40;

/// The fraction of the time limit that the degrees of iterates may take.
const FOR_DEGREES: f64 = 0.4;

/// Follows curves that a system's map sends to infinity or contracts, for a number of `steps`.
///
/// Only the fixed values and the limits on degrees and time are used from `options`. `watch` is
/// told of every curve before the curve is followed. Equal fields and options give equal results,
/// unless time runs out.
///
/// # Errors
/// Returns an error if the field has no invertible map, or if the map is beyond the budget of
/// terms.
pub fn poles(
    system: &System,
    options: &Options,
    steps: usize,
    watch: &dyn Watch,
) -> Result<Poles, DiscoverError> {
    let work = &WatchedSearch::new(watch);
    let [for_degrees, deadline] =
        [FOR_DEGREES, 1.0].map(|share| Deadline::after(work, options.seconds * share));
    work.show(&Progress::stage("degrees of iterates"));
    let field = specialised(system, &options.parameters, options.eps.as_ref())?.field;
    if options.eps.as_ref().is_some_and(Rational::is_zero) {
        return Err(DiscoverError::ZeroStep);
    }
    let searched = SearchField::new(&field, options.eps.clone());
    let mut random = SplitMix64::from_bytes(format!("{field:?}{:?}", options.eps).as_bytes());
    let sample = searched.sample(Modulus::mersenne_61(), &mut random).ok_or(DiscoverError::NoMap)?;
    if !searched.is_invertible(&mut random) {
        return Err(DiscoverError::Collapse);
    }
    let limits =
        DegreeLimits { iterates: options.iterates, degree: options.iterate_degree, deadline: &for_degrees };
    let degrees = degrees(&sample.map, &mut random, limits);
    let curves = Curves::of(&field, &searched).ok_or(DiscoverError::TooLong)?;
    let is_complete = curves.has_jacobian;
    let all: Vec<Option<Polynomial>> = curves.factors.iter().cloned().map(Some).chain([None]).collect();
    let count = all.len();
    let follower = Follower { searched: &searched, curves: &curves, steps, deadline };
    let mut patterns = Vec::with_capacity(count);
    for (done, curve) in all.into_iter().enumerate() {
        work.show(&Progress { what: "curves", done: done as u64, of: Some(count as u64) });
        patterns.push(follower.pattern(curve, &mut random));
    }
    let symbols = field.symbols.clone();
    let with_degrees: Vec<(usize, &[Image])> = patterns
        .iter()
        .map(|pattern| {
            let degree = pattern.curve.as_ref().map_or(1, |curve| symbols.degree(curve));
            (degree as usize, &pattern.images[..])
        })
        .collect();
    let degree = curves.components.iter().map(|component| symbols.degree(component)).max().unwrap_or(0);
    let is_decided = is_complete && patterns.iter().all(|pattern| pattern.confined.is_some());
    let implied_degrees =
        if is_decided { implied_degrees::degrees(degree as usize, &with_degrees) } else { None };
    // Every map has points at infinity, so they are listed only if they are blown down.
    patterns.retain(|pattern| pattern.curve.is_some() || pattern.is_blown_down());
    Ok(Poles { symbols, patterns, bound: steps, is_complete, degrees, implied_degrees })
}

struct Follower<'a> {
    searched: &'a SearchField,
    curves: &'a Curves,
    steps: usize,
    deadline: Deadline<'a>,
}

impl Follower<'_> {
    /// Returns the pattern of a curve, without images if the results modulo two primes differ.
    fn pattern(&self, curve: Option<Polynomial>, random: &mut SplitMix64) -> Pattern {
        let first = self.images(curve.as_ref(), random);
        let second = self.images(curve.as_ref(), random);
        let decided = first.filter(|first| second.as_ref() == Some(first));
        let enough = self.searched.dimension() - 1;
        let images = decided.as_deref().unwrap_or_default();
        let back = images.iter().position(|image| image.dimension >= enough);
        let confined = decided.is_some().then_some(back.is_some());
        let steps = back.map_or(images.len(), |place| place + 1);
        Pattern { curve, images: decided.unwrap_or_default(), steps, confined }
    }

    /// Returns the images of a curve modulo one prime. Every sample has its own prime, because a
    /// curve may have points modulo some primes only.
    fn images(&self, curve: Option<&Polynomial>, random: &mut SplitMix64) -> Option<Vec<Image>> {
        let mut length = SHORTEST;
        for _ in 0..MOST_SAMPLES {
            if self.deadline.passed() || length > LONGEST {
                return None;
            }
            match self.sampled(curve, Modulus::random(random), length, random) {
                Some(Ok(images)) => return Some(images),
                Some(Err(NoImage::TooShort)) => length *= 2,
                Some(Err(NoImage::SpecialPoint)) | None => {}
            }
        }
        None
    }

    fn sampled(
        &self,
        curve: Option<&Polynomial>,
        modulus: Modulus,
        length: usize,
        random: &mut SplitMix64,
    ) -> Option<Result<Vec<Image>, NoImage>> {
        let sample = self.searched.sample(modulus, random)?;
        let symbols = self.searched.family().symbols();
        let values = Values { symbols, parameters: &sample.unknowns, eps: sample.map.eps() };
        let map = Homogeneous::map(modulus, &self.curves.components, &values)?;
        let curves = Homogeneous::curves(modulus, &self.curves.factors, &values)?;
        let n = self.searched.dimension();
        let place = match curve {
            Some(curve) => CurvePoint::on(&modulus, curve, &values, random)?,
            None => CurvePoint::at_infinity(&modulus, n, random),
        };
        Some(map.follow(&place, &curves, self.steps, length, random))
    }
}
