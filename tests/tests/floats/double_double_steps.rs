//! Compares steps computed in double-double and rounded to `f64` with exact steps, near true poles.
//!
//! At a relative distance δ from a pole, the relative error in double-double is a few dozen u²/δ,
//! where u = 2⁻⁵³. If a component nearly cancels, its error is small only relative to the largest
//! component.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::Dd;
use kahan_tests::back_end::BackEnd;
use kahan_tests::doubles::{exact, float, signed_unit, ulp};
use kahan_tests::exact::Vector;
use kahan_tests::maps::{Steps, steps};
use kahan_tests::rounding::UNIT_F64;
use kahan_tests::subject::{Subject, paper};
use num_traits::{Signed, Zero};

#[derive(Clone, Debug)]
struct Place {
    x: Vec<f64>,
    eps: f64,
}

impl Place {
    /// Returns coordinate i, or ε if i is the number of coordinates.
    fn number(&mut self, i: usize) -> &mut f64 {
        if i < self.x.len() { &mut self.x[i] } else { &mut self.eps }
    }

    fn with(&self, i: usize, value: f64) -> Self {
        let mut place = self.clone();
        *place.number(i) = value;
        place
    }

    fn state(&self) -> Vector {
        self.x.iter().map(|entry| exact(*entry)).collect()
    }

    fn exact_step(&self, subject: &Subject) -> Option<Vector> {
        subject.interpreted.step(&self.state(), &exact(self.eps))
    }

    fn step(&self, map: &dyn Steps<Dd>) -> Vec<f64> {
        let x: Vec<Dd> = self.x.iter().copied().map(Dd::from).collect();
        map.step(&x, self.eps.into()).into_iter().map(f64::from).collect()
    }
}

fn is_positive(subject: &Subject, place: &Place) -> bool {
    subject.generated.det_matrix(&place.state(), &exact(place.eps)).is_positive()
}

/// Bisects coordinate i (the last is ε) to find a zero of det A, and returns a double next to it.
fn zero_between(subject: &Subject, place: &Place, i: usize, mut low: f64, mut high: f64) -> Option<f64> {
    let sign_at = |value: f64| is_positive(subject, &place.with(i, value));
    let sign = sign_at(low);
    if sign_at(high) == sign {
        return None;
    }
    loop {
        let middle = low + (high - low) / 2.0;
        if middle == low || middle == high {
            return Some(low);
        }
        if sign_at(middle) == sign { low = middle } else { high = middle }
    }
}

/// Returns the errors of a rounded step in ulps of the exact components.
fn errors(computed: &[f64], next: &Vector) -> Vec<f64> {
    let pairs = computed.iter().zip(next);
    pairs.map(|(value, next)| float(&(exact(*value) - next).abs()) / ulp(float(next))).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

fn size(next: &Vector) -> f64 {
    next.iter().map(|entry| float(&entry.abs())).fold(0.0, f64::max)
}

#[derive(Default)]
struct Worst {
    poles: usize,
    down_to_1e_9: f64,
    at_1e_12: f64,
    plain: f64,
}

impl Worst {
    /// Checks steps near the pole at which coordinate i is `pole`, or ε is `pole` if i is the
    /// number of coordinates. Removable poles are skipped.
    fn look(
        &mut self,
        subject: &Subject,
        (map, plain): (&dyn Steps<Dd>, &dyn Steps<f64>),
        place: &Place,
        i: usize,
        pole: f64,
    ) {
        const DISTANCES: [f64; 6] = [1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-4];
        let at = |distance: f64| place.with(i, pole * (1.0 + distance));
        let near = at(1e-12).exact_step(subject).expect("det A is not 0 there");
        // Near a pole of the map, a component of the next point grows like 1/distance.
        if size(&near) < 1e6 * largest(&place.x.iter().copied().map(f64::abs).collect::<Vec<_>>()) {
            return;
        }
        self.poles += 1;
        for distance in DISTANCES {
            let place = at(distance);
            let next = place.exact_step(subject).expect("det A is not 0 there");
            let error = largest(&errors(&place.step(map), &next));
            let (limit, worst) = if distance.abs() < 1e-10 {
                (0.6, &mut self.at_1e_12)
            } else {
                (0.5 + 1e-5, &mut self.down_to_1e_9)
            };
            assert!(error <= limit, "{} at {place:?}, {distance:e} from a pole: {error}", subject.name);
            *worst = worst.max(error);
            self.plain = self.plain.max(largest(&errors(&plain.step(&place.x, place.eps), &next)));
        }
    }
}

#[test]
fn a_step_near_a_pole_is_half_an_ulp_from_the_exact_one() {
    const POLES: usize = 12;
    let maps = steps::<Dd>().into_iter().zip(steps::<f64>());
    for (index, (subject, (map, plain))) in paper().iter().zip(maps).enumerate() {
        let mut draws = SplitMix64::new(7300 + index as u64);
        let mut worst = Worst::default();
        for trial in 0..4000 {
            if worst.poles >= POLES {
                break;
            }
            let numbers = subject.dimension() + 1;
            let x = (1..numbers)
                .map(|_| 2.0_f64.powi(2 - draws.below(4) as i32) * signed_unit(&mut draws))
                .collect();
            let place = Place { x, eps: signed_unit(&mut draws) };
            let (i, other) = (trial % numbers, 3.0 * signed_unit(&mut draws));
            let start = *place.clone().number(i);
            if let Some(pole) = zero_between(subject, &place, i, start, other) {
                worst.look(subject, (map.as_ref(), plain.as_ref()), &place, i, pole);
            }
        }
        let Worst { poles, down_to_1e_9, at_1e_12, plain } = worst;
        eprintln!("{}: {poles} poles, {down_to_1e_9:.9}, {at_1e_12:.6}, in f64 {plain:.1e}", subject.name);
        assert!(poles >= POLES, "{}: {poles} poles are too few", subject.name);
        // Errors in `f64` exceed 10⁹ ulps; those in double-double nearly reach their bound, ½ ulp.
        assert!(plain > 1e9 && down_to_1e_9 > 0.45, "{}: {plain:e}, {down_to_1e_9}", subject.name);
    }
}

/// Tests steps to points near a coordinate plane, where a component is as small as the errors.
#[test]
fn a_component_that_cancels_is_exact_against_the_others() {
    /// The bound on an error, in u²·‖x̃‖/|det A| with u = 2⁻⁵³. The measured value is 1.6.
    const BOUND: f64 = 8.0;
    let (mut worst, mut worst_in_ulps, mut shown) = (0.0_f64, 0.0_f64, String::new());
    for (index, (subject, map)) in paper().iter().zip(steps::<Dd>()).enumerate() {
        let mut draws = SplitMix64::new(7400 + index as u64);
        let mut judged = 0;
        while judged < 40 {
            let mut target: Vec<f64> = (0..subject.dimension()).map(|_| signed_unit(&mut draws)).collect();
            let i = judged % target.len();
            target[i] = 0.0;
            let eps = signed_unit(&mut draws) / 8.0;
            let target: Vector = target.into_iter().map(exact).collect();
            let Some(before) = subject.interpreted.step(&target, &exact(-eps)) else { continue };
            let place = Place { x: before.iter().map(float).collect(), eps };
            let determinant = float(&subject.generated.det_matrix(&place.state(), &exact(eps)).abs());
            let Some(next) = place.exact_step(subject) else { continue };
            judged += 1;
            if next[i].is_zero() {
                // A component that is exactly 0 must be computed as 0.
                assert_eq!(place.step(map.as_ref())[i], 0.0);
                continue;
            }
            let error = float(&(exact(place.step(map.as_ref())[i]) - &next[i]).abs());
            let place_of_last_digit = ulp(float(&next[i]));
            let excess = (error - 0.5 * place_of_last_digit) * determinant;
            let units = excess / (UNIT_F64 * UNIT_F64 * size(&next));
            assert!(units <= BOUND, "{} at {place:?}: {units} u²", subject.name);
            worst = worst.max(units);
            if error / place_of_last_digit > worst_in_ulps {
                worst_in_ulps = error / place_of_last_digit;
                shown = format!("{} at {place:?}, component {i}", subject.name);
            }
        }
    }
    eprintln!(
        "{worst:.2} u² beyond the half ulp, up to {worst_in_ulps:.1} ulp of the component itself: {shown}"
    );
    assert!(worst_in_ulps > 0.6, "no point shows the exception: {worst_in_ulps}");
}
