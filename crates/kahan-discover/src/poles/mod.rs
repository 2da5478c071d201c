//! What a map does after a pole: which curves (in three variables surfaces) it sends to infinity or
//! blows down, and whether what is lost there comes back.
//!
//! In: a system. Out: a [`Pattern`] for each curve. A curve is *blown down* where its image has a
//! lower dimension: its points can no longer be told apart. The singularity is *confined* after k
//! steps if the image of the curve under k steps is a curve (surface) again. Everything is seen
//! modulo two primes at random parameters, ε and points; where they disagree nothing is said.
//!
//! Confinement alone proves nothing: Hietarinta and Viallet's map (Phys. Rev. Lett. 81, 1998)
//! confines and is chaotic. So the growth of degrees stands beside the patterns.

pub(crate) mod curves;
mod implied;
mod jet;
mod roots;
mod series;

use kahan_algebra::poly::Polynomial;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::system::System;

use crate::deadline::{Deadline, Work};
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;
use crate::orbits::degrees::{DegreeLimits, degrees};
use crate::report::{DiscoverError, Options};
use crate::stages::specialised;
use crate::watch::{Progress, Watch};
use curves::Curves;
pub use jet::Image;
use jet::{Homogeneous, Lost, Place, Values};

/// What becomes of one curve.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The curve, as the polynomial that vanishes on it; `None` is the points at infinity.
    pub curve: Option<Polynomial>,
    /// The images of the curve after 1, 2, … steps; empty where nothing could be decided.
    pub images: Vec<Image>,
    /// After how many steps the image is a curve again, or how many were looked at.
    pub steps: usize,
    /// Whether an image is a curve again; `None` where time, or the length of the series, ran out,
    /// or the primes disagree.
    pub confined: Option<bool>,
}

/// What is known of a map's poles.
#[derive(Clone, Debug)]
pub struct Poles {
    /// The names of states and parameters.
    pub symbols: Symbols,
    /// A pattern for each curve.
    pub patterns: Vec<Pattern>,
    /// How many steps were looked at.
    pub bound: usize,
    /// Whether all curves that are blown down are listed: the Jacobian determinant of some maps is
    /// too long to factor.
    pub is_complete: bool,
    /// d₀, d₁, …: the degrees of iterates, measured.
    pub degrees: Vec<usize>,
    /// The degrees that the patterns imply, as far as these were followed; `None` where one is
    /// undecided or missing.
    pub implied_degrees: Option<Vec<usize>>,
}

impl Pattern {
    /// Whether the first step already loses dimension.
    #[must_use]
    pub fn is_blown_down(&self) -> bool {
        self.confined != Some(true) || self.steps > 1
    }

    /// The curve in words.
    #[must_use]
    pub fn name(&self, symbols: &Symbols) -> String {
        self.curve.as_ref().map_or_else(|| "infinity".to_owned(), |curve| Text.polynomial(symbols, curve))
    }
}

/// The lengths of the power series that are tried.
const SHORTEST: usize = 12;
const LONGEST: usize = 200;

/// How often parameters, ε and a point are sampled again: not every sampled line meets its curve
/// modulo the prime.
const MOST_SAMPLES: usize = 40;

/// The share of the time that the degrees of iterates may take.
const FOR_DEGREES: f64 = 0.4;

/// What the map of a system does after its poles, within so many steps. Of the options the fixed
/// values and the bounds on degrees and time count. `watch` is told of every curve before it is
/// followed: how many are done, and of how many.
///
/// Equal fields and options give equal results, unless time runs out.
///
/// # Errors
/// Where there is no map to look at, or its closed form is beyond the budget of terms.
pub fn poles(
    system: &System,
    options: &Options,
    steps: usize,
    watch: &dyn Watch,
) -> Result<Poles, DiscoverError> {
    let work = &Work::new(watch);
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
    let implied_degrees = if is_decided { implied::degrees(degree as usize, &with_degrees) } else { None };
    // The points at infinity are every map's; they are news where they are blown down.
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
    /// What two primes say, if they agree.
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

    /// The images modulo one prime; `None` where the series were too short, or time ran out. A
    /// curve may fall apart over a larger field only, so that few primes have points on it; every
    /// sample has a prime of its own.
    fn images(&self, curve: Option<&Polynomial>, random: &mut SplitMix64) -> Option<Vec<Image>> {
        let mut length = SHORTEST;
        for _ in 0..MOST_SAMPLES {
            if self.deadline.passed() || length > LONGEST {
                return None;
            }
            match self.sampled(curve, Modulus::random(random), length, random) {
                Some(Ok(images)) => return Some(images),
                Some(Err(Lost::TooShort)) => length *= 2,
                Some(Err(Lost::SpecialPoint)) | None => {}
            }
        }
        None
    }

    /// The images of one point; `None` where the sample brought none.
    fn sampled(
        &self,
        curve: Option<&Polynomial>,
        modulus: Modulus,
        length: usize,
        random: &mut SplitMix64,
    ) -> Option<Result<Vec<Image>, Lost>> {
        let sample = self.searched.sample(modulus, random)?;
        let symbols = self.searched.family().symbols();
        let values = Values { symbols, parameters: &sample.unknowns, eps: sample.map.eps() };
        let map = Homogeneous::map(modulus, &self.curves.components, &values)?;
        let curves = Homogeneous::curves(modulus, &self.curves.factors, &values)?;
        let n = self.searched.dimension();
        let place = match curve {
            Some(curve) => Place::on(&modulus, curve, &values, random)?,
            None => Place::at_infinity(&modulus, n, random),
        };
        Some(map.follow(&place, &curves, self.steps, length, random))
    }
}
