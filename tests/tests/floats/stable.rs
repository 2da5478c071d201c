//! Checks the guarantee of `try_step` by exact rational numbers. An `Ok` is within 64 u of the
//! exact step, where u is the unit roundoff. An error has a reason: a pole, a result outside the
//! scalar's range, or an ill-conditioned step.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::ExtendScalars;
use kahan_core::prelude::*;
use num_traits::{FromPrimitive, Signed, ToPrimitive, Zero};

use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra, VolterraLattice};

kahan! {
    /// The field of May and Leonard: three species in cyclic competition.
    struct MayLeonard { a, b }
    xdot = x*(1 - x - a*y - b*z);
    ydot = y*(1 - b*x - y - a*z);
    zdot = z*(1 - a*x - b*y - z);
}

kahan! {
    /// A field whose products of states can overflow where the step does not.
    struct Wave;
    xdot = y*z;
    ydot = -x*z;
    zdot = x*y;
}

trait Judged: Pivot + Copy + ToPrimitive {
    const STATES: i32;
    const EPS: i32;
    /// The exponent of the unit roundoff as a power of two, −53 or −24.
    const UNIT: i32;
    /// The exponent of the least normal number as a power of two.
    const NORMAL: i32;
    const CONDITION: f64;
    fn of(value: f64) -> Self;
    fn exact(&self) -> BigRational;
    fn largest() -> BigRational;
}

impl Judged for f64 {
    const STATES: i32 = 498;
    const EPS: i32 = 996;
    const UNIT: i32 = -53;
    const NORMAL: i32 = -1022;
    const CONDITION: f64 = 1e12;
    fn of(value: f64) -> Self {
        value
    }
    fn exact(&self) -> BigRational {
        BigRational::from_f64(*self).expect("finite")
    }
    fn largest() -> BigRational {
        f64::MAX.exact()
    }
}

impl Judged for f32 {
    const STATES: i32 = 62;
    const EPS: i32 = 120;
    const UNIT: i32 = -24;
    const NORMAL: i32 = -126;
    const CONDITION: f64 = 1e4;
    fn of(value: f64) -> Self {
        value as f32
    }
    fn exact(&self) -> BigRational {
        BigRational::from_f32(*self).expect("finite")
    }
    fn largest() -> BigRational {
        f32::MAX.exact()
    }
}

fn two_to(exponent: i32) -> BigRational {
    BigRational::from_integer(2.into()).pow(exponent)
}

fn size<const N: usize>(x: &SVector<BigRational, N>) -> BigRational {
    x.iter().map(Signed::abs).max().expect("a state has entries")
}

struct Draws(SplitMix64);

impl Draws {
    fn unit(&mut self) -> f64 {
        self.0.below(1 << 53) as f64 / (1_u64 << 53) as f64
    }

    fn sign(&mut self) -> f64 {
        if self.0.below(2) == 0 { 1.0 } else { -1.0 }
    }

    fn ordinary(&mut self) -> f64 {
        self.sign() * (0.1 + 2.0 * self.unit())
    }

    fn any(&mut self, exponents: i32) -> f64 {
        let exponent = self.0.below(2 * exponents as u64 + 1) as i32 - exponents;
        self.sign() * (1.0 + self.unit()) * 2.0_f64.powi(exponent)
    }
}

#[derive(Default)]
struct Tally {
    established: usize,
    flagged: usize,
}

fn judge<T, M, const N: usize>(name: &str, map: &M, x: SVector<T, N>, eps: T, tally: &mut Tally)
where
    T: Judged,
    M: ExtendScalars<T, N>,
{
    let exact_map = map.extend_scalars(T::exact);
    let exact_x = x.map(|entry| entry.exact());
    let exact_eps = eps.exact();
    let step = |x: &SVector<BigRational, N>, eps: &BigRational| exact_map.try_step(x, eps.clone()).ok();
    let exact = step(&exact_x, &exact_eps);
    match map.try_step(&x, eps) {
        Ok(next) => {
            tally.established += 1;
            assert!(next.iter().all(Pivot::is_finite_number), "{name} at {x:?}, {eps:?}: {next:?}");
            let Some(exact) = exact else { panic!("{name} at {x:?}, {eps:?}: a value at a pole") };
            let error = size(&(next.map(|entry| entry.exact()) - &exact));
            let allowed = two_to(T::UNIT + 6) * size(&exact);
            assert!(
                error <= allowed,
                "{name} at {x:?}, {eps:?}: {next:?} is off by {:e} of what is allowed",
                (error / allowed).to_f64().unwrap_or(f64::INFINITY)
            );
        }
        Err(error) => {
            tally.flagged += 1;
            let Some(exact) = exact else { return };
            if size(&exact) > T::largest()
                || exact.iter().any(|entry| !entry.is_zero() && entry.abs() < two_to(T::NORMAL))
            {
                return;
            }
            // To get the condition number, change each input by the relative amount 2⁻⁸⁰.
            let change = two_to(-80);
            let moved = |x: &SVector<BigRational, N>, eps: &BigRational| {
                step(x, eps).map(|next| (next - &exact).map(|entry| entry.abs()))
            };
            let mut total = moved(&exact_x, &(&exact_eps * (BigRational::from_integer(1.into()) + &change)));
            for j in 0..N {
                let mut x = exact_x.clone();
                x[j] = &x[j] * (BigRational::from_integer(1.into()) + &change);
                total = total.zip(moved(&x, &exact_eps)).map(|(total, one)| total + one);
            }
            let Some(total) = total else { return };
            if size(&exact).is_zero() {
                panic!("{name} at {x:?}, {eps:?}: {error} where the next state is 0");
            }
            let condition = (size(&total) / change / size(&exact)).to_f64().unwrap_or(f64::INFINITY);
            assert!(condition >= T::CONDITION, "{name} at {x:?}, {eps:?}: {error}, condition {condition:e}");
        }
    }
}

fn sample<T, M, const N: usize>(name: &str, map: &M, trials: usize) -> Tally
where
    T: Judged,
    M: ExtendScalars<T, N>,
{
    let mut draws = Draws(SplitMix64::from_bytes(name.as_bytes()));
    let mut tally = Tally::default();
    for trial in 0..trials {
        let (x, eps) = match trial % 4 {
            0 => (SVector::from_fn(|_, _| T::of(draws.ordinary())), T::of(0.5 * draws.ordinary())),
            1 => (SVector::from_fn(|_, _| T::of(draws.any(T::STATES))), T::of(draws.any(T::EPS))),
            2 => (SVector::from_fn(|_, _| T::of(draws.any(8))), T::of(draws.any(60))),
            _ => {
                let x = SVector::from_fn(|_, _| T::of(draws.ordinary()));
                (x, near_a_pole(map, &x, &mut draws))
            }
        };
        judge(name, map, x, eps, &mut tally);
    }
    tally
}

/// Returns an ε at a small relative distance from a zero of det A(x,ε).
fn near_a_pole<T, M, const N: usize>(map: &M, x: &SVector<T, N>, draws: &mut Draws) -> T
where
    T: Judged,
    M: ExtendScalars<T, N>,
{
    let extended = map.extend_scalars(|parameter| parameter.to_f64().expect("a float"));
    let state = x.map(|entry| entry.to_f64().expect("a float"));
    let sign = |eps: f64| extended.det_matrix(&state, eps) > 0.0;
    let (mut near, mut far) = (0.0, 0.0);
    for step in 1..=64 {
        for eps in [0.1 * f64::from(step), -0.1 * f64::from(step)] {
            if !sign(eps) {
                far = eps;
                break;
            }
        }
        if far != 0.0 {
            break;
        }
    }
    for _ in 0..80 {
        let middle = 0.5 * (near + far);
        if sign(middle) {
            near = middle;
        } else {
            far = middle;
        }
    }
    T::of(far * (1.0 + draws.sign() * 2.0_f64.powi(-(draws.0.below(54) as i32))))
}

fn both<M64, M32, const N: usize>(name: &str, double: &M64, single: &M32, trials: usize)
where
    M64: ExtendScalars<f64, N>,
    M32: ExtendScalars<f32, N>,
{
    for tally in [sample::<f64, _, N>(name, double, trials), sample::<f32, _, N>(name, single, trials)] {
        // An `Err` satisfies every error bound, so at least a third of the results must be `Ok`.
        assert!(tally.established > trials / 3, "{name}: {} of {trials} flagged", tally.flagged);
    }
}

macro_rules! promise {
    ($($test:ident: $map:expr;)*) => {$(
        #[test]
        fn $test() {
            both(stringify!($test), &$map, &$map, 120);
        }
    )*};
}

promise! {
    euler: EulerTop { a1: 1.0, a2: -2.0, a3: 0.75 };
    lotka_volterra: LotkaVolterra;
    e1: E1;
    e2: E2;
    e3: E3;
    e4: E4;
    e5: E5;
    e6: E6;
    e7: E7 { xi: 0.5 };
    e8: E8;
    e9: E9 { xi: -1.25 };
    volterra: VolterraLattice;
    may_leonard: MayLeonard { a: 0.5, b: 0.75 };
    wave: Wave;
}

#[test]
fn states_far_out_are_right_or_flagged() {
    let mut tally = Tally::default();
    judge("May–Leonard", &MayLeonard { a: 0.5, b: 0.7 }, vector![1e100, 0.2, 0.3], 0.05, &mut tally);
    judge("E3", &E3, vector![1e60, 1e130, 0.0], 0.5, &mut tally);
    // Elimination has a small backward error here, but its result is wrong.
    judge("Volterra", &VolterraLattice, vector![0.3, 1.7, 2.9], 1e17, &mut tally);
    judge("E6", &E6, vector![1e-200, 1e-200, -1e-200], 0.5, &mut tally);
    judge("E6 at rest", &E6, vector![0.0, 0.0, 0.0], 0.5, &mut tally);
    // The difference x² − y² of the dominating terms is exactly 0.
    judge("wave", &Wave, vector![1e60, 1e60, 1e-160], 0.5, &mut tally);
    // The point is a removable pole, with increments 10¹⁶⁸ times the components of the result.
    let x = vector![-8.676922526036922e48, -1.5830949700414324e75, 4.794036587204811e-94];
    judge("E3", &E3, x, -2.0859248397665138e93, &mut tally);
    // The parameter ξ is 1, so the largest terms of E9 vanish: they have the factor 1 − ξ.
    let x = vector![-6096532.558838251, -242655735183791.94, -1.8544218759589321e-93];
    judge("E9", &E9 { xi: 1.0 }, x, 5.392351629290315e92, &mut tally);
    assert_eq!(tally.flagged, 0);
    // Only the last addition overflows.
    judge("E2", &E2, vector![12.0, 1e154, 1.0], 0.125, &mut tally);
    assert_eq!(tally.flagged, 1);
}

#[test]
fn what_is_not_finite_is_never_ok() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for i in 0..3 {
            let mut x = vector![0.5, 0.25, -0.75];
            x[i] = bad;
            assert!(E6.try_step(&x, 0.125).is_err());
            assert!(E7 { xi: 0.5 }.try_step(&x, 0.125).is_err());
        }
        assert!(E6.try_step(&vector![0.5, 0.25, -0.75], bad).is_err());
        assert!(E7 { xi: bad }.try_step(&vector![0.5, 0.25, -0.75], 0.125).is_err());
    }
}

/// E1 has a removable pole at 1 + εx = 0, and a true pole at 1 − εx = 0.
#[test]
fn removable_poles_have_values_and_true_ones_have_none() {
    let next = E1.try_step(&vector![-2.0, 0.75, 0.5], 0.5).expect("the reduced map has a value");
    let exact = E1
        .extend_scalars(|x: &f64| x.exact())
        .step(&vector![-2.0, 0.75, 0.5].map(|x: f64| x.exact()), 0.5.exact());
    assert_eq!(next.map(|x| x.exact()), exact);
    let error = E1.try_step(&vector![2.0, 0.75, 0.5], 0.5).expect_err("a pole");
    assert_eq!((error.determinant(), error.eps(), error.bound()), (0.0, 0.5, f64::INFINITY));
}

/// Ordinary points need no higher precision, so the bits of `try_step` equal those of `step`.
#[test]
fn ordinary_points_have_the_bits_of_the_fast_step() {
    let mut draws = Draws(SplitMix64::new(5));
    for _ in 0..1000 {
        let x = SVector::from_fn(|_, _| draws.ordinary());
        let eps = 0.02 * draws.ordinary();
        assert_eq!(E6.try_step(&x, eps).expect("no pole is near"), E6.step(&x, eps));
        assert_eq!(E6.at(eps).try_step(&x), E6.try_step(&x, eps));
    }
}
