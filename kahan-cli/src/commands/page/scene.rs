//! The scene of a page: ε and a first point, chosen where they are not given, so that there is an
//! orbit to see.

use kahan_algebra::rational::Rational;
use kahan_runtime::{Field, MapAt};

use crate::printing::Refusal;

/// An orbit that the figures show.
#[derive(Clone, Debug)]
pub(super) struct Scene {
    pub(super) eps: Rational,
    pub(super) start: Vec<Rational>,
    /// The least and the greatest value of each variable on the orbit.
    pub(super) extremes: Vec<[f64; 2]>,
    /// Whether it stays within reach for as long as it was followed.
    pub(super) stays: bool,
}

/// Steps that an orbit is followed.
const STEPS: u64 = 4000;
/// The size, seen from the first point, beyond which an orbit is lost to a picture.
const REACH: f64 = 1e3;
/// Numbers that first points are made of: of small height, so that exact orbits can be followed,
/// and different, so that no symmetry holds them.
const NUMBERS: [(i64, i64); 6] = [(1, 1), (1, 2), (1, 3), (2, 3), (1, 4), (3, 4)];
/// Sizes that first points have, in the order in which they are tried.
const SIZES: [(i64, i64); 6] = [(1, 1), (1, 5), (5, 1), (1, 20), (20, 1), (1, 100)];

impl Scene {
    /// The scene of a field at these values of its parameters.
    ///
    /// What is not given is chosen: ε as a fifth of what the field's rates allow, and the first
    /// point as the first of some small fractions whose orbit stays and goes on moving.
    pub(super) fn of(
        field: &Field,
        parameters: &[Rational],
        eps: Option<&Rational>,
        start: Option<&[Rational]>,
    ) -> Result<Self, Refusal> {
        let map = field.with(field.parameters().iter().zip(parameters)).map_err(|_| {
            Refusal::new("the field divides by zero at these values of its parameters; choose other values")
        })?;
        let starts = start.map_or_else(|| starts(field.variables().len()), |start| vec![start.to_vec()]);
        let mut best: Option<Followed> = None;
        for start in starts {
            let mut rate = Followed::rate(&map.at(0.0), &floats(&start));
            // A second look, at the rates where the orbit went.
            for _ in 0..2 {
                let eps = eps.cloned().unwrap_or_else(|| round_below(0.2 / rate));
                let followed = Followed::of(&map.at(eps.to_f64()), eps, &start);
                rate = rate.max(followed.rate);
                if best.as_ref().is_none_or(|best| best.rank() < followed.rank()) {
                    best = Some(followed);
                }
            }
            if best.as_ref().is_some_and(|best| best.scene.stays && best.moves) {
                break;
            }
        }
        best.map(|best| best.scene).ok_or_else(|| Refusal::new("the field has no variables"))
    }
}

/// A scene, and what there is to choose it by.
struct Followed {
    scene: Scene,
    steps: u64,
    /// Whether it still moves in the second half.
    moves: bool,
    /// The largest size of f′ on it.
    rate: f64,
}

impl Followed {
    fn of(at: &MapAt<f64>, eps: Rational, start: &[Rational]) -> Self {
        let mut x = floats(start);
        let size = x.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
        let is_within = |x: &[f64]| x.iter().all(|x| x.abs() <= REACH * size);
        let mut extremes: Vec<[f64; 2]> = x.iter().map(|&x| [x, x]).collect();
        let mut late = extremes.clone();
        let (mut steps, mut rate) = (0, 0.0f64);
        while steps < STEPS && is_within(&x) {
            widen(&mut extremes, &x);
            if steps == STEPS / 2 {
                late = x.iter().map(|&x| [x, x]).collect();
            }
            widen(&mut late, &x);
            if steps % 16 == 0 {
                rate = rate.max(Followed::rate(at, &x));
            }
            // The state is as long as the field has variables.
            let _ = at.advance(&mut x, 1);
            steps += 1;
        }
        let spread = |ends: &[[f64; 2]]| ends.iter().fold(0.0, |most: f64, [low, high]| most.max(high - low));
        let moves = spread(&late) > 1e-3 * size;
        let scene = Scene { eps, start: start.to_vec(), extremes, stays: steps == STEPS };
        Followed { scene, steps, moves, rate }
    }

    /// The largest sum of a row of |f′|.
    fn rate(at: &MapAt<f64>, x: &[f64]) -> f64 {
        let mut jacobian = vec![0.0; x.len() * x.len()];
        // Both are as long as the field has variables.
        let _ = at.field_jacobian(x, &mut jacobian);
        let rows = jacobian.chunks(x.len().max(1));
        rows.map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max)
    }

    /// Larger for what is better: an orbit that stays and moves, then one that stays, then a longer
    /// one.
    fn rank(&self) -> (bool, bool, u64) {
        (self.scene.stays && self.moves, self.scene.stays, self.steps)
    }
}

fn widen(extremes: &mut [[f64; 2]], x: &[f64]) {
    for (ends, x) in extremes.iter_mut().zip(x) {
        *ends = [ends[0].min(*x), ends[1].max(*x)];
    }
}

fn floats(start: &[Rational]) -> Vec<f64> {
    start.iter().map(Rational::to_f64).collect()
}

/// First points to be tried: of each size, with all coordinates above 0, then with signs in turn.
fn starts(variables: usize) -> Vec<Vec<Rational>> {
    let signs = [[1, 1], [1, -1]];
    let starts = SIZES.iter().flat_map(|size| signs.iter().map(move |signs| (size, signs)));
    let coordinate = |size: &(i64, i64), sign: i64, k: usize| {
        let (above, below) = NUMBERS[k % NUMBERS.len()];
        Rational::new(sign * above * size.0, below * size.1)
    };
    starts.map(|(size, signs)| (0..variables).map(|k| coordinate(size, signs[k % 2], k)).collect()).collect()
}

/// The greatest of 1, 1/2, 1/5, 1/10, 1/20, … that is at most this.
fn round_below(bound: f64) -> Rational {
    let mut denominators = (0..9).flat_map(|power| [1, 2, 5].map(|factor| factor * 10i64.pow(power)));
    let fits = denominators.find(|&denominator| 1.0 / denominator as f64 <= bound);
    Rational::new(1, fits.unwrap_or(1_000_000_000))
}

#[cfg(test)]
mod tests {
    use kahan_runtime::Field;

    use super::*;

    #[test]
    fn eps_is_a_round_number_below_its_bound() {
        for (bound, below) in [(3.0, 1), (1.0, 1), (0.7, 2), (0.2, 5), (0.19, 10), (0.004, 500)] {
            assert_eq!(round_below(bound), Rational::new(1, below), "{bound}");
        }
        assert!(round_below(f64::NAN).to_f64() > 0.0 && round_below(0.0).to_f64() > 0.0);
    }

    #[test]
    fn an_orbit_that_stays_is_found() {
        // Half of the plane escapes; the start of size 1 does.
        let field = Field::parse("xdot = y; ydot = x^2 - x;").unwrap();
        let scene = Scene::of(&field, &[], None, None).unwrap();
        assert!(scene.stays && scene.start[0] != Rational::one(), "{scene:?}");
        let given = [Rational::new(1, 7), Rational::new(0, 1)];
        let scene = Scene::of(&field, &[], Some(&Rational::new(1, 9)), Some(&given)).unwrap();
        assert_eq!((scene.start.as_slice(), scene.eps), (&given[..], Rational::new(1, 9)));
    }

    #[test]
    fn where_none_stays_the_longest_is_taken() {
        let field = Field::parse("xdot = x^2 + 1;").unwrap();
        let scene = Scene::of(&field, &[], None, None).unwrap();
        assert_eq!(scene.start.len(), 1);
    }
}
