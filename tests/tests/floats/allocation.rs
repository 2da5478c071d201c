//! Tests that steps over floats allocate no memory.

use allocation_counter::measure;
use kahan_core::__private::{Boundary, Sizes, Stencil};
use kahan_core::observe::{
    Crossing, Direction, Drift, Escape, Extrema, Fli, Lyapunov, MeanLogDet, Megno, Period, Residence,
    Rotation, Sali, Section, Spectrum,
};
use kahan_core::prelude::*;
use kahan_core::{Composition, Ensemble, ExtendScalars, LatticeMap, LatticeScalar, ProjectivePoint};
use kahan_systems::{E1, E3, E6, E9, EulerTop, LotkaVolterra};
use kahan_tests::random_systems::Dense6;

const STEPS: usize = 100;

fn allocations<M, const N: usize>(map: &M, start: [f64; N], eps: f64) -> u64
where
    M: ExtendScalars<f64, N>,
{
    let start = SVector::from(start);
    let counted = measure(|| {
        let prepared = map.at(eps);
        let (mut x, mut y, mut z, mut w) = (start, start, start, start);
        for _ in 0..STEPS {
            x = map.step(&x, eps);
            y = prepared.step(&y);
            z = map.try_step(&z, eps).unwrap_or(start);
            w = prepared.try_step(&w).unwrap_or(start);
        }
        let last = map.orbit(start, eps).nth(STEPS);
        let also = prepared.orbit(start).nth(STEPS);
        let projective = map.orbit(start, eps).projective().nth(STEPS);
        let both = map.orbit(start, eps).composed(Composition::KAHAN_LI_8).compensated().nth(STEPS);
        let composed = prepared.composed(Composition::SUZUKI_4).step(&start);
        assert!(both.is_some_and(|x| x.iter().chain(composed.iter()).all(|entry| entry.is_finite())));
        assert!(last == Some(x) && also == Some(x) && x == y && z == w);
        assert!(projective.and_then(ProjectivePoint::affine) == Some(x));
        // `step` and `try_step` may round differently, so only one step of each is compared.
        let stable = map.try_step(&start, eps).unwrap_or(start);
        assert!(stable != start && (stable - map.step(&start, eps)).amax() <= 1e-13);
        assert!(z.iter().all(|entry| entry.is_finite()));
        assert!(x.iter().all(|entry| entry.is_finite()));
    });
    counted.count_total
}

#[test]
fn the_counter_counts() {
    assert_eq!(measure(|| drop(std::hint::black_box(vec![1.0; 3]))).count_total, 1);
}

#[test]
fn closed_forms_allocate_nothing() {
    assert_eq!(allocations(&LotkaVolterra, [1.5, 1.0], 0.05), 0);
    assert_eq!(allocations(&EulerTop { a1: 1.0, a2: -2.0, a3: 1.0 }, [0.5, 1.0, 0.25], 0.05), 0);
    assert_eq!(allocations(&E1, [0.5, 1.0, 0.25], 0.05), 0);
    assert_eq!(allocations(&E3, [0.5, 1.0, 0.25], 0.05), 0);
    assert_eq!(allocations(&E6, [0.5, 1.0, 0.25], 0.05), 0);
    assert_eq!(allocations(&E9 { xi: -0.5 }, [0.5, 1.0, 0.25], 0.05), 0);
}

#[test]
fn elimination_allocates_nothing() {
    assert_eq!(allocations(&Dense6, [0.01, 0.02, -0.01, 0.03, 0.01, -0.02], 0.001), 0);
}

#[test]
fn advancing_an_ensemble_allocates_nothing() {
    let points: Vec<SVector<f64, 3>> = (0..1000).map(|i| vector![0.5, 1.0, f64::from(i) * 1e-3]).collect();
    let mut ensemble = Ensemble::new(points);
    let (e3, top) = (E3.at(0.05), EulerTop { a1: 1.0, a2: -2.0, a3: 1.0 }.at(0.05));
    // The first call is not counted, since it queries the processor's instruction sets.
    ensemble.advance(&e3, 1);
    let counted = measure(|| {
        ensemble.advance(&e3, STEPS as u64);
        ensemble.advance(&top, STEPS as u64);
    });
    assert_eq!(counted.count_total, 0);
    assert!(ensemble.points().all(|point| point.iter().all(|entry| entry.is_finite())));
}

#[test]
fn observing_an_orbit_allocates_nothing() {
    let map = E6.at(0.05);
    let start = vector![0.5, 1.0, 0.25];
    let mut crossings = 0;
    let counted = measure(|| {
        let integrals = |x: &[f64]| E6.integrals(&vector![x[0], x[1], x[2]], 0.05).data.0[0];
        let height = |x: &[f64]| x[0];
        let tangents = (Lyapunov::new(&map), MeanLogDet::new(&map), Megno::new(&map));
        let section = Section::new(&map, height, Direction::Both, |_: Crossing<_, _>| crossings += 1);
        let observers = (
            Extrema::of(height),
            Drift::of(integrals),
            tangents,
            (Fli::new(&map), Sali::new(&map)),
            Rotation::of(STEPS as u64, |x: &[f64]| [x[0], x[2]]),
            section,
            (Escape::when(|x: &[f64]| x[0] > 9.0), Period::within(0.1, [0.0; 3])),
            Residence::of(height, -1.0..1.0, [0; 10]),
        );
        let reports = map.orbit(start).observe(STEPS as u64, observers);
        assert!(reports.1.iter().all(|drifted| drifted.max < 1e-12));
    });
    assert!(crossings > 0);
    assert_eq!(counted.count_total, 0);
}

#[test]
fn steps_of_observed_ensembles_and_of_spectra_allocate_nothing() {
    let map = E6.at(0.05);
    let points: Vec<SVector<f64, 3>> = (0..100).map(|i| vector![0.5, 1.0, f64::from(i) * 1e-2]).collect();
    let allocations = |steps: u64| {
        let mut ensemble = Ensemble::new(points.clone());
        let observers = |_| (Fli::new(&map), Sali::new(&map), Extrema::of(|x: &[f64]| x[0]));
        let many = measure(|| drop(ensemble.observe(&map, steps, observers)));
        let spectrum = Spectrum::new(&map, 3, 2);
        let one = measure(|| drop(map.orbit(points[0]).observe(steps, spectrum)));
        [many.count_total, one.count_total]
    };
    // The first call is not compared, since it queries the processor's instruction sets.
    allocations(1);
    assert_eq!(allocations(10), allocations(1000));
}

/// Volterra's ring of variables, ẋᵢ = xᵢ(xᵢ₊₁ − xᵢ₋₁).
#[derive(Clone, Debug)]
struct Ring;

impl<T: LatticeScalar> LatticeMap<T> for Ring {
    const ARRAYS: &'static [&'static str] = &["x"];
    const REACH: usize = 1;

    type Kernels = Stencil<1, 1, 0, 1, 1, 1, 3, 3>;

    fn sizes(&self) -> Sizes {
        Self::Kernels::SIZES
    }

    fn boundary(&self) -> Boundary {
        Boundary::Periodic
    }

    fn constants<L: Scalar>(&self, eps: L, _lift: impl Fn(&T) -> L) -> Option<Vec<L>> {
        Some(vec![eps])
    }

    #[inline(always)]
    fn rows<L: Scalar>(&self, constants: &[L], x: &[L], _c: &[L], _: &mut [L], f: &mut [L], a: &mut [L]) {
        let (eps, difference) = (constants[0].clone(), x[2].clone() - x[0].clone());
        f[0] = x[1].clone() * difference.clone();
        a[0] = eps.clone() * x[1].clone();
        a[1] = L::one() - eps.clone() * difference;
        a[2] = -(eps * x[1].clone());
    }
}

#[test]
fn chains_allocate_nothing_once_they_are_made() {
    for sites in [20, 3000] {
        let mut at = Ring.at(0.05, sites).expect("sites");
        let mut x: Vec<f64> = (0..sites).map(|i| 1.0 + 0.5 * (i as f64).sin()).collect();
        let counted = measure(|| {
            at.advance(&mut x, 3);
            at.step_back(&mut x);
            at.for_each(&mut x, 2, |k, x| assert!(k > 0 && x[0] > 0.0));
            at.try_step(&mut x).expect("no pole");
            x[0] = f64::NAN;
            at.step(&mut x);
        });
        assert_eq!(counted.count_total, 0, "{sites} sites");
    }
}

kahan! {
    /// A ring with the half-bandwidth 3·5 + 2 = 17, the largest of any chain in the tests.
    struct Wide;
    for i in periodic {
        x[i]dot = x[i]*(x[i+1] - z[i-5]);
        y[i]dot = y[i]*(x[i+2] - y[i-3]);
        z[i]dot = z[i]*(x[i+5] - z[i-1]);
    }
}

kahan! {
    struct Narrow;
    for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
}

kahan! {
    struct Open;
    for i in open { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
}

/// Asserts that a chain stores at most 3·`half_bandwidth` + 12 numbers for each unknown.
fn holds_few_numbers<M: LatticeMap<f64>>(map: &M, half_bandwidth: usize) {
    const SITES: usize = 12_000;
    let mut state: Vec<f64> = (0..SITES * M::BLOCK).map(|k| 1.0 + 0.1 * (k as f64).sin()).collect();
    let mut begun = None;
    let counted = measure(|| {
        let chain = begun.insert(map.at(0.01, SITES).expect("a chain"));
        chain.step(&mut state);
        chain.try_step(&mut state).expect("a step");
    });
    assert!(state.iter().all(|x| x.is_finite()));
    let numbers = counted.bytes_max as f64 / (8.0 * state.len() as f64);
    assert!(numbers <= (3 * half_bandwidth + 12) as f64, "{numbers} for h = {half_bandwidth}");
}

#[test]
fn a_chain_holds_few_numbers_an_unknown() {
    holds_few_numbers(&Open, 1);
    holds_few_numbers(&Narrow, 1);
    holds_few_numbers(&Wide, 17);
}
