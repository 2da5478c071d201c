//! Proves algebraic stability on ℙ² modulo a prime.
//!
//! A birational map φ of ℙ² is *algebraically stable* if no iterate sends a curve to a point of
//! indeterminacy. Then deg φᵏ = (deg φ)ᵏ (Fornæss and Sibony 1995; Diller and Favre 2001, theorem
//! 1.14). A map that is not stable has iterates whose forms share a factor. Reduction modulo a
//! prime preserves common factors, so stability modulo a prime suffices.

use kahan_algebra::prime_field::{PrimeField, SplitMix64};

use crate::deadline::Deadline;
use crate::maps::map::{ModularMap, Term};
use crate::maps::modular_step::ModularStep;
use crate::maps::search_field::SearchField;
use crate::modular::modulus::Modulus;

/// The least prime to try. Modulo a prime p, a stable map appears unstable by chance with a
/// probability of about 3/p.
const LEAST_PRIME: u64 = 211;
/// The search for a prime starts at [`LEAST_PRIME`] plus a random number below this.
const PRIME_SEARCH_RANGE: u64 = 1000;

/// The most samples. If the three contracted lines are the roots of one irreducible equation, all
/// exist modulo the prime for about one sample in six.
const MOST_SAMPLES: usize = 64;

type Point = [u64; 3];

/// Finds a prime modulo which the map is algebraically stable of degree 2.
///
/// Let Φ be the homogeneous components of the map φ, and Ψ those of the inverse (the map at −ε).
/// Then Ψ∘Φ is κ times the identity, with a cubic form κ. The map contracts exactly the curves of
/// κ. If κ is a product of linear forms, these curves are lines ℓᵢ with images qᵢ. Outside of the
/// lines φ is injective and never takes the value qᵢ. So the orbit of qᵢ cannot return to qᵢ before
/// it meets a line. Modulo the prime there are finitely many points, so the orbit of qᵢ reaches a
/// point of indeterminacy, or a line ℓⱼ and then qⱼ. Finitely many steps from each qᵢ therefore
/// decide stability.
pub(super) fn prime_of_stability(
    searched: &SearchField,
    random: &mut SplitMix64,
    deadline: &Deadline<'_>,
) -> Option<u64> {
    (0..MOST_SAMPLES).find_map(|_| {
        if deadline.passed() {
            return None;
        }
        let prime = (LEAST_PRIME + random.below(PRIME_SEARCH_RANGE)..).find_map(PrimeField::new)?;
        let modulus = Modulus::of(prime);
        let unknowns: Vec<u64> = (0..searched.unknowns()).map(|_| modulus.sample(random)).collect();
        let plane = Forms { map: searched.at(modulus, &unknowns)? };
        plane.is_stable(random).then_some(modulus.prime())
    })
}

struct Forms {
    map: ModularMap,
}

impl Forms {
    /// Returns whether the map is stable and has degree 2. The cubic form κ must have three linear
    /// factors, counted with multiplicity. If the degree is lower, all homogeneous components of
    /// the map vanish on one of these three lines.
    fn is_stable(&self, random: &mut SplitMix64) -> bool {
        let Some(lines) = self.contracted_lines(random) else { return false };
        // A quadratic form with three zeros on a line vanishes on the line, so three points
        // suffice.
        let image =
            |line: &Point| (0..3).map(|t| self.image(self.on(line, t))).find(|image| *image != [0; 3]);
        lines.iter().all(|line| image(line).is_some_and(|start| self.walk_is_stable(start)))
    }

    /// Returns whether the orbit of a point meets a contracted line before any point of
    /// indeterminacy. The image of that line is tested as another start.
    fn walk_is_stable(&self, start: Point) -> bool {
        let mut point = start;
        // A line has about 1/`prime` of all points, so orbits meet one long before this limit.
        for _ in 0..100 * self.modulus().prime() {
            let next = self.image(point);
            if next == [0; 3] {
                return false;
            }
            if self.cubic(point) == 0 {
                return true;
            }
            point = next;
        }
        false
    }

    fn contracted_lines(&self, random: &mut SplitMix64) -> Option<Vec<Point>> {
        let sampled = |random: &mut SplitMix64| [(); 3].map(|()| self.modulus().sample(random));
        let [first, second] = [(); 2].map(|()| [sampled(random), sampled(random)]);
        let (first, second) = (self.zeros_between(first)?, self.zeros_between(second)?);
        let mut lines: Vec<Point> = Vec::new();
        for (&a, &b) in first.iter().flat_map(|a| second.iter().map(move |b| (a, b))) {
            let line = self.normalised(self.cross(a, b));
            // A cubic form with four zeros on a line vanishes on the line.
            let is_zero = line != [0; 3] && (0..4).all(|t| self.cubic(self.on(&line, t)) == 0);
            if is_zero && !lines.contains(&line) {
                lines.push(line);
            }
        }
        let powers: &[&[u32]] = match lines.len() {
            1 => &[&[3]],
            2 => &[&[2, 1], &[1, 2]],
            3 => &[&[1, 1, 1]],
            _ => return None,
        };
        powers.iter().any(|powers| self.is_product(&lines, powers)).then_some(lines)
    }

    /// Returns whether the form κ is a nonzero constant times these powers of lines. Cubic forms
    /// that agree at the ten points (i, j, k) with i + j + k = 3 are equal.
    fn is_product(&self, lines: &[Point], powers: &[u32]) -> bool {
        let modulus = self.modulus();
        let places = (0..=3).flat_map(|i| (0..=3 - i).map(move |j| [i, j, 3 - i - j]));
        let values = places.map(|place| {
            let point = place.map(|entry| modulus.integer(entry));
            let factors = lines.iter().zip(powers);
            let product = factors.fold(modulus.one(), |product, (line, &power)| {
                modulus.times(product, modulus.power(modulus.dot(line, &point), power))
            });
            (self.cubic(point), product)
        });
        let values: Vec<(u64, u64)> = values.collect();
        let Some(&(left, right)) = values.iter().find(|(left, _)| *left != 0) else { return false };
        right != 0 && values.iter().all(|&(a, b)| modulus.times(a, right) == modulus.times(b, left))
    }

    /// Returns the zeros of the cubic form κ on the line through `infinity` and `base`, except
    /// `infinity`. Returns `None` if κ vanishes on the line.
    fn zeros_between(&self, [infinity, base]: [Point; 2]) -> Option<Vec<Point>> {
        let modulus = self.modulus();
        let mut point = base;
        let mut zeros = Vec::new();
        for _ in 0..modulus.prime() {
            if self.cubic(point) == 0 {
                zeros.push(point);
            }
            point = std::array::from_fn(|i| modulus.plus(point[i], infinity[i]));
        }
        (zeros.len() <= 3).then_some(zeros)
    }

    /// Maps t to a point of a line. Different t below the prime give different points.
    fn on(&self, line: &Point, t: u64) -> Point {
        let modulus = self.modulus();
        let [a, b] = match line.iter().position(|&entry| entry != 0) {
            Some(0) => [[line[1], modulus.opposite(line[0]), 0], [line[2], 0, modulus.opposite(line[0])]],
            Some(1) => [[modulus.one(), 0, 0], [0, line[2], modulus.opposite(line[1])]],
            _ => [[modulus.one(), 0, 0], [0, modulus.one(), 0]],
        };
        let t = modulus.integer(t);
        std::array::from_fn(|i| modulus.plus(a[i], modulus.times(t, b[i])))
    }

    fn cross(&self, a: Point, b: Point) -> Point {
        let modulus = self.modulus();
        [(1, 2), (2, 0), (0, 1)]
            .map(|(i, j)| modulus.minus(modulus.times(a[i], b[j]), modulus.times(a[j], b[i])))
    }

    fn normalised(&self, point: Point) -> Point {
        let first = point.iter().copied().find(|&entry| entry != 0);
        let inverse = first.and_then(|first| self.modulus().inverse(first)).unwrap_or(0);
        point.map(|entry| self.modulus().times(entry, inverse))
    }

    fn cubic(&self, point: Point) -> u64 {
        let back = self.map_forms(self.image(point), self.modulus().opposite(self.map.eps()));
        let quotients = back.iter().zip(point);
        let mut quotients =
            quotients.filter_map(|(&above, below)| Some((above, self.modulus().inverse(below)?)));
        quotients.next().map_or(0, |(above, inverse)| self.modulus().times(above, inverse))
    }

    fn image(&self, point: Point) -> Point {
        self.map_forms(point, self.map.eps())
    }

    /// Returns homogeneous coordinates (adj A · b, det A) of the image of the point (x : Z). The
    /// map solves the linear system A x̃ = b with A = Z − ε f′ and b = x + ε Bx + 2ε cZ. The field
    /// f has the linear part Bx and the constant part c.
    fn map_forms(&self, point: Point, eps: u64) -> Point {
        let modulus = self.modulus();
        let mut matrix = [[point[2], 0], [0, point[2]]];
        let mut right = [point[0], point[1]];
        for &Term { component, coefficient, first, second } in self.map.terms() {
            let scaled = modulus.times(eps, coefficient);
            let product = |place: usize| modulus.times(scaled, point[place]);
            let (row, entry) = (&mut matrix[component], &mut right[component]);
            match (first, second) {
                (Some(j), Some(k)) => {
                    row[j] = modulus.minus(row[j], product(k));
                    row[k] = modulus.minus(row[k], product(j));
                }
                (Some(j), None) => {
                    row[j] = modulus.minus(row[j], product(2));
                    *entry = modulus.plus(*entry, product(j));
                }
                _ => *entry = modulus.plus(*entry, modulus.plus(product(2), product(2))),
            }
        }
        let [[a, b], [c, d]] = matrix;
        let difference = |a, b, c, d| modulus.minus(modulus.times(a, b), modulus.times(c, d));
        [difference(d, right[0], b, right[1]), difference(a, right[1], c, right[0]), difference(a, d, b, c)]
    }

    fn modulus(&self) -> &Modulus {
        self.map.modulus()
    }
}
