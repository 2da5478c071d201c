//! Tests that float steps are within the bound derived in `rounding`, and that nothing panics.
//! Points and ε have few bits, so both float types represent them exactly.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::Pivot;
use kahan_tests::back_end::BackEnd;
use kahan_tests::doubles::exact;
use kahan_tests::exact::{Q, shown};
use kahan_tests::maps::{Steps, call_everything, paper_and_random};
use kahan_tests::rounding::{Place, StepBound, UNIT_F32, UNIT_F64};
use kahan_tests::subject::{Subject, paper, random};
use num_traits::ToPrimitive;

fn dyadic(draws: &mut SplitMix64, size: u64, bits: u32) -> f64 {
    let p = (draws.below(size) + 1) as f64 / f64::from(1_u32 << bits);
    if draws.below(2) == 0 { p } else { -p }
}

trait Float: Pivot + Copy + ToPrimitive + Into<f64> {
    const UNIT: f64;
    fn narrowed(value: f64) -> Self;
}

impl Float for f64 {
    const UNIT: f64 = UNIT_F64;
    fn narrowed(value: f64) -> Self {
        value
    }
}

impl Float for f32 {
    const UNIT: f64 = UNIT_F32;
    fn narrowed(value: f64) -> Self {
        value as f32
    }
}

fn subjects() -> Vec<Subject> {
    paper().into_iter().chain(random()).collect()
}

/// Checks a float step against its bound. Returns the bound relative to the exact step.
fn compare<T: Float>(
    subject: &Subject,
    bound: &StepBound<'_>,
    map: &dyn Steps<T>,
    x: &[f64],
    eps: f64,
) -> Option<f64> {
    let state: Vec<Q> = x.iter().map(|entry| exact(*entry)).collect();
    let next = subject.interpreted.step(&state, &exact(eps))?;
    let place = Place { x: state, eps: exact(eps), next };
    let bounds = bound.at(&place)?;
    let narrow: Vec<T> = x.iter().map(|entry| T::narrowed(*entry)).collect();
    let computed = map.step(&narrow, T::narrowed(eps));
    let mut relative_bound = 0.0_f64;
    for (i, bound) in bounds.iter().enumerate() {
        let at = || format!("{}, component {i}: x = ({}), eps = {eps}", subject.name, shown(&place.x));
        let value: f64 = computed[i].into();
        assert!(value.is_finite(), "{}: {value}", at());
        let error = (exact(value) - &place.next[i]).to_f64().expect("a number").abs();
        assert!(error <= *bound, "{}: error {error:e}, bound {bound:e}", at());
        let size = place.next.iter().map(|entry| entry.to_f64().expect("a number").abs()).fold(0.0, f64::max);
        relative_bound = relative_bound.max(bound / size);
    }
    Some(relative_bound)
}

fn ordinary_points_stay_within_the_bound<T: Float>(seed: u64) {
    for (index, (subject, map)) in subjects().iter().zip(paper_and_random::<T>()).enumerate() {
        let mut draws = SplitMix64::new(seed * 1000 + index as u64);
        let bound = StepBound::new(subject, T::UNIT);
        let mut judged = Vec::new();
        for _ in 0..12 {
            let x: Vec<f64> = (0..subject.dimension()).map(|_| dyadic(&mut draws, 64, 5)).collect();
            let eps = dyadic(&mut draws, 16, 9);
            judged.extend(compare(subject, &bound, map.as_ref(), &x, eps));
        }
        judged.sort_by(f64::total_cmp);
        assert!(judged.len() >= 9, "{} (seed {seed}): only {} points judged", subject.name, judged.len());
        // At half of the points the bound must be at most 2²⁰ units of roundoff.
        let median = judged[judged.len() / 2];
        assert!(median <= T::UNIT * 2_f64.powi(20), "{} (seed {seed}): a bound of {median:e}", subject.name);
    }
}

#[test]
fn a_double_precision_step_stays_within_its_derived_bound() {
    ordinary_points_stay_within_the_bound::<f64>(401);
}

#[test]
fn a_single_precision_step_stays_within_its_derived_bound() {
    ordinary_points_stay_within_the_bound::<f32>(402);
}

/// Returns a random point and an ε near a sign change of det A, found by bisection to 16 bits.
fn near_pole(subject: &Subject, draws: &mut SplitMix64) -> Option<(Vec<f64>, f64)> {
    let x: Vec<f64> = (0..subject.dimension()).map(|_| dyadic(draws, 64, 5)).collect();
    let state: Vec<Q> = x.iter().map(|entry| exact(*entry)).collect();
    let sign = |eps: f64| subject.generated.det_matrix(&state, &exact(eps)).to_f64().expect("a number");
    let grid: Vec<f64> = (1..=32).map(|k| f64::from(k) / 16.0).collect();
    let bracket = grid.windows(2).find(|pair| sign(pair[0]) * sign(pair[1]) < 0.0)?;
    let (mut low, mut high) = (bracket[0], bracket[1]);
    for _ in 0..12 {
        let middle = f64::midpoint(low, high);
        if sign(middle) * sign(low) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some((x, low))
}

fn points_near_poles_stay_within_the_bound<T: Float>(seed: u64) {
    let mut judged = 0;
    let mut near = 0;
    for (index, (subject, map)) in subjects().iter().zip(paper_and_random::<T>()).enumerate() {
        let mut draws = SplitMix64::new(seed * 1000 + index as u64);
        let bound = StepBound::new(subject, T::UNIT);
        for _ in 0..4 {
            let Some((x, eps)) = near_pole(subject, &mut draws) else { continue };
            near += 1;
            for away in [0.0, 2_f64.powi(-8), 2_f64.powi(-12)] {
                judged += usize::from(compare(subject, &bound, map.as_ref(), &x, eps - away).is_some());
            }
        }
    }
    assert!(near >= 40, "only {near} poles found");
    assert!(judged >= near, "only {judged} of {} points judged", 3 * near);
}

#[test]
fn near_a_pole_a_double_precision_step_stays_within_its_derived_bound() {
    points_near_poles_stay_within_the_bound::<f64>(403);
}

#[test]
fn near_a_pole_a_single_precision_step_stays_within_its_derived_bound() {
    points_near_poles_stay_within_the_bound::<f32>(404);
}

/// Numbers for which naive formulas trap, overflow, underflow or lose their sign.
const HARD: [f64; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    -2.0,
    0.5,
    1e-300,
    5e-324,
    -1e160,
    1e308,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

fn no_input_panics<T: Float>(seed: u64) {
    for (index, (subject, map)) in subjects().iter().zip(paper_and_random::<T>()).enumerate() {
        let mut draws = SplitMix64::new(seed * 1000 + index as u64);
        let mut hard = || T::narrowed(HARD[draws.below(HARD.len() as u64) as usize]);
        for _ in 0..150 {
            let (x, eps): (Vec<T>, T) = ((0..subject.dimension()).map(|_| hard()).collect(), hard());
            eprintln!("{} (seed {seed}): x = {x:?}, eps = {eps:?}", subject.name);
            // Orbits over floats never end, since points after a pole are infinite or NaN.
            assert_eq!(call_everything(map.as_ref(), &x, eps), 4);
            match map.try_step(&x, eps) {
                Ok(next) => assert!(next.iter().all(T::is_finite_number), "Ok with {next:?}"),
                Err(why) => assert!(!why.to_string().is_empty()),
            }
        }
    }
}

/// Calls `run` on a thread whose stack is smaller than the usual 2 MiB.
fn on_a_small_stack(run: fn()) {
    let thread = std::thread::Builder::new().stack_size(3 << 19).spawn(run).expect("a thread");
    thread.join().expect("no panic");
}

#[test]
fn no_double_precision_input_panics_and_ok_is_finite() {
    on_a_small_stack(|| no_input_panics::<f64>(405));
}

#[test]
fn no_single_precision_input_panics_and_ok_is_finite() {
    on_a_small_stack(|| no_input_panics::<f32>(406));
}
