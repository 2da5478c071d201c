//! Degrees of the iterates of the map, as a projective map without common factors.
//!
//! Iterate n is evaluated on a random line, at points given by a random Möbius function of t, so
//! that t = 0 and t = ∞ are not special. A random combination of the iterate's components is a
//! rational function of t with the degree of the iterate. Common factors cancel in values, and no
//! polynomial is formed.

use kahan_algebra::prime_field::SplitMix64;

use crate::deadline::Deadline;
use crate::maps::map::ModularMap;
use crate::maps::modular_step::ModularStep;
use crate::modular::thiele::{SPARE_POINTS, degree};
use crate::orbits::growth::{Growth, GrowthVerdict};

/// The limits of a computation of degrees.
#[derive(Clone, Copy)]
pub struct DegreeLimits<'a> {
    /// The number of iterates to compute.
    pub iterates: usize,
    /// The computation ends with the first iterate whose degree exceeds this. For the first four
    /// iterates, the limit is four times as high while the growth of degrees is undecided.
    pub degree: usize,
    /// The deadline of the computation.
    pub deadline: &'a Deadline<'a>,
}

const ENOUGH_DEGREES: usize = 6;

/// Returns the degrees d₀ = 1, d₁, … of iterates on a random line. The list is empty if the map is
/// undefined there. An iterate of degree d takes 2d evaluations of the map and 8d² multiplications.
pub fn degrees(map: &ModularMap, random: &mut SplitMix64, limits: DegreeLimits<'_>) -> Vec<usize> {
    let mut line = RandomLine::new(map, random);
    let mut degrees = vec![1];
    let most_points = 16 * limits.degree + 16;
    while degrees.len() <= limits.iterates {
        let known = degrees.len();
        let last = degrees[known - 1];
        let before = if known > 1 { degrees[known - 2] } else { 1 };
        let expected = last * last / before.max(1) + 2;
        let mut points = (2 * expected + SPARE_POINTS + 1).max(16);
        let found = loop {
            if limits.deadline.passed() || points > most_points {
                break None;
            }
            if !line.prepare(points, known, random, limits.deadline) {
                if limits.deadline.has_stopped() {
                    break None;
                }
                // Too few points have an image, so the list ends, or is empty at the first iterate.
                return if known == 1 { Vec::new() } else { degrees };
            }
            let values: Vec<u64> = line.samples[..points].iter().map(|sample| line.value(sample)).collect();
            let parameters: Vec<u64> = line.samples[..points].iter().map(|sample| sample.parameter).collect();
            match degree(map.modulus(), &parameters, &values, limits.deadline) {
                Some(degree) => break Some(degree),
                None => points += points / 2,
            }
        };
        let Some(found) = found else { break };
        degrees.push(found);
        let is_short =
            degrees.len() < ENOUGH_DEGREES && GrowthVerdict::of(&degrees).growth == Growth::Undecided;
        let limit = if is_short { 4 * limits.degree } else { limits.degree };
        if found > limit {
            break;
        }
    }
    degrees
}

struct RandomLine<'a> {
    map: &'a ModularMap,
    base: Vec<u64>,
    direction: Vec<u64>,
    /// The coefficient c of t/(1 + ct), the position on the line of the sample with parameter t.
    bend: u64,
    weights: Vec<u64>,
    samples: Vec<Sample>,
}

struct Sample {
    parameter: u64,
    state: Vec<u64>,
    steps: usize,
}

impl<'a> RandomLine<'a> {
    fn new(map: &'a ModularMap, random: &mut SplitMix64) -> Self {
        RandomLine {
            map,
            base: map.point(random),
            direction: map.point(random),
            bend: map.modulus().sample(random),
            weights: map.point(random),
            samples: Vec::new(),
        }
    }

    /// Maps samples on the line `steps` times, until at least `count` of them have met no pole.
    /// Returns `false` after 16 samples that meet poles, or if the deadline passes.
    fn prepare(
        &mut self,
        count: usize,
        steps: usize,
        random: &mut SplitMix64,
        deadline: &Deadline<'_>,
    ) -> bool {
        let map = self.map;
        self.samples.retain_mut(|sample| sample.advance(map, steps));
        let mut failures = 0;
        while self.samples.len() < count && failures < 16 && !deadline.passed() {
            let modulus = map.modulus();
            let parameter = modulus.sample(random);
            let below = modulus.plus(modulus.one(), modulus.times(self.bend, parameter));
            let Some(inverse) = modulus.inverse(below) else { continue };
            let place = modulus.times(parameter, inverse);
            let state = self.base.iter().zip(&self.direction);
            let state =
                state.map(|(base, slope)| modulus.plus(*base, modulus.times(*slope, place))).collect();
            let mut sample = Sample { parameter, state, steps: 0 };
            if sample.advance(map, steps) {
                self.samples.push(sample);
            } else {
                failures += 1;
            }
        }
        self.samples.len() >= count
    }

    fn value(&self, sample: &Sample) -> u64 {
        self.map.modulus().dot(&self.weights, &sample.state)
    }
}

impl Sample {
    fn advance(&mut self, map: &ModularMap, steps: usize) -> bool {
        while self.steps < steps {
            match map.next(&self.state) {
                Some(next) => self.state = next,
                None => return false,
            }
            self.steps += 1;
        }
        true
    }
}
