//! Tests `lift` blocks, which the macro makes quadratic: initial values, steps, and integrals.

use kahan_core::num_rational::BigRational;
use kahan_core::prelude::*;

kahan! {
    /// A pendulum.
    lift pub struct Pendulum { g }

    xdot = v;
    vdot = -g*sin(x);

    integral E = 1/2*v^2 - g*cos_x - eps^2*g^2*sin_x^2/2;
    integral R = (sin_x^2 + cos_x^2)/(1 + eps^2*v^2);
}

kahan! {
    lift pub struct Kepler;

    xdot = p;
    ydot = q;
    pdot = -x/(x^2 + y^2)^(3/2);
    qdot = -y/(x^2 + y^2)^(3/2);

    integral E = W + 1/2*(p^2 + q^2) - eps^2/2*(x_inv_r3^2 + y_inv_r3^2);
}

kahan! {
    lift pub struct Morse { depth, a }

    const two = 2;
    xdot = v;
    vdot = -two*depth*a*(1 - exp(-a*x))*exp(-a*x);

    integral E = v^2/two + depth*(exp_minus_2ax - 2*exp_minus_ax)
        - 2*eps^2*depth^2*a^2*(exp_minus_ax - exp_minus_2ax)^2;
}

kahan! {
    lift pub struct FitzHughNagumo { a, b, tau, current }

    vdot = v - v^3/3 - w + current;
    wdot = (v + a - b*w)/tau;
}

kahan! {
    /// A field that depends on the time t, which becomes the second state.
    lift struct Forced;
    xdot = t^3 - x;
}

kahan! {
    /// The parameter occurs in the initial value of the new variable, but not in the lifted field.
    lift struct Root { a }
    xdot = sqrt(a + x);
}

fn rational(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

/// Returns a point whose coordinates are distinct rationals.
fn rationals<const N: usize>() -> SVector<BigRational, N> {
    SVector::from_fn(|i, _| rational(3 * i as i64 + 1, i as i64 + 5))
}

#[test]
fn first_values_are_those_of_libm() {
    let pendulum = Pendulum { g: 1.5 };
    let point = pendulum.embed(&vector![0.7, -0.25]);
    assert_eq!(point, vector![0.7, -0.25, 0.644_217_687_237_691, 0.764_842_187_284_488_5]);
    assert_eq!(pendulum.project(&point), vector![0.7, -0.25]);
    assert_eq!(Pendulum::<f64>::NEW_VARIABLES, ["sin_x", "cos_x"]);
    assert_eq!(Pendulum::<f64>::VARIABLES, ["x", "v", "sin_x", "cos_x"]);
    assert_eq!(Pendulum::<f64>::RELATIONS[0], "-1 + sin_x^2 + cos_x^2");

    let single = Pendulum { g: 1.5_f32 }.embed(&vector![0.7_f32, -0.25]);
    assert_eq!(
        single,
        vector![0.7_f32, -0.25, f64::from(0.7_f32).sin() as f32, f64::from(0.7_f32).cos() as f32]
    );

    let kepler = Kepler.embed(&vector![3.0, 4.0, 0.5, -0.25]);
    assert_eq!(Kepler::NEW_VARIABLES, ["x_inv_r3", "y_inv_r3", "r_sum2", "sum1_inv_r2", "inv_r3", "W"]);
    assert_eq!(kepler, vector![3.0, 4.0, 0.5, -0.25, 0.024, 0.032, 1.5625, 0.02, 0.008, -0.2]);

    let morse = Morse { depth: 2.0, a: 0.5 }.embed(&vector![1.0, 0.0]);
    // This is e^½ = exp(a x) for a = ½ and x = 1. The new variables are powers of exp(a x).
    let exponential = 1.648_721_270_700_128_2_f64;
    assert_eq!(morse, vector![1.0, 0.0, (exponential * exponential).recip(), exponential.recip()]);
}

#[test]
fn exact_steps_keep_the_energy_of_the_lift() {
    let eps = rational(1, 7);
    let pendulum = Pendulum { g: rational(3, 2) };
    let (x, k) = (rationals::<4>(), rationals::<10>());
    assert_eq!(
        pendulum.integrals(&pendulum.step(&x, eps.clone()), eps.clone()),
        pendulum.integrals(&x, eps.clone())
    );
    assert_eq!(Kepler.E(&Kepler.step(&k, eps.clone()), eps.clone()), Kepler.E(&k, eps.clone()));
    let morse = Morse { depth: rational(2, 3), a: rational(5, 4) };
    assert_eq!(morse.E(&morse.step(&x, eps.clone()), eps.clone()), morse.E(&x, eps.clone()));
    assert_eq!(pendulum.project(&x), vector![x[0].clone(), x[1].clone()]);
}

/// Returns the largest change of a function along an orbit over floats.
fn change<M: KahanMap<f64, N> + Clone, const N: usize>(
    map: &M,
    start: SVector<f64, N>,
    eps: f64,
    steps: usize,
    function: impl Fn(&SVector<f64, N>) -> f64,
) -> f64 {
    let first = function(&start);
    map.orbit(start, eps).take(steps).map(|x| (function(&x) - first).abs()).fold(0.0, f64::max)
}

#[test]
fn orbits_keep_the_energy_to_rounding() {
    let pendulum = Pendulum { g: 1.0 };
    let start = pendulum.embed(&vector![2.0, 0.1]);
    assert!(change(&pendulum, start, 0.05, 20_000, |x| pendulum.E(x, 0.05)) < 1e-13);
    let start = Kepler.embed(&vector![1.0, 0.0, 0.0, 1.2]);
    assert!(change(&Kepler, start, 0.01, 20_000, |x| Kepler.E(x, 0.01)) < 1e-13);
    let morse = Morse { depth: 1.0, a: 1.0 };
    let start = morse.embed(&vector![0.5, 0.0]);
    assert!(change(&morse, start, 0.05, 20_000, |x| morse.E(x, 0.05)) < 1e-13);
}

/// With half of ε, the error is a quarter. The limit cycle attracts, so that errors do not grow.
#[test]
fn the_lift_has_the_solutions_of_the_equations() {
    let neuron = FitzHughNagumo { a: 0.7, b: 0.8, tau: 12.5, current: 0.5 };
    let at = |eps: f64, steps: usize| {
        let start = neuron.embed(&vector![-1.0, 1.0]);
        neuron.orbit(start, eps).nth(steps).expect("an orbit of floats does not end")
    };
    let [coarse, middle, fine] = [(0.02, 1000), (0.01, 2000), (0.005, 4000)].map(|(eps, n)| at(eps, n));
    let ratio = (coarse[0] - middle[0]) / (middle[0] - fine[0]);
    assert!((ratio - 4.0).abs() < 0.1, "{ratio}");
    assert!((fine[2] - fine[0] * fine[0]).abs() < 1e-4);
}

#[test]
fn time_is_a_state_and_parameters_may_stand_in_first_values_alone() {
    assert_eq!(Forced::VARIABLES, ["x", "t", "t2"]);
    assert_eq!(Forced.embed(&vector![2.0, 3.0]), vector![2.0, 3.0, 9.0]);
    assert_eq!(Forced.project(&vector![2.0, 3.0, 9.0]), vector![2.0, 3.0]);
    assert_eq!(Root::<f64>::RELATIONS[0], "-x - a + r^2");
    assert_eq!(Root { a: 2.0 }.embed(&vector![2.0]), vector![2.0, 2.0]);
}

#[test]
fn a_block_without_a_header_is_a_value() {
    let g = 2.0;
    let field = kahan! { lift; xdot = v; vdot = -g*sin(x); };
    let named = Pendulum { g };
    let start = named.embed(&vector![1.0, 0.0]);
    assert_eq!(field.embed(&vector![1.0, 0.0]), start);
    assert_eq!(field.step(&start, 0.1), named.step(&start, 0.1));
    let a = 3.0;
    assert_eq!(kahan! { lift; xdot = sqrt(a + x); }.embed(&vector![1.0])[1], 2.0);
}
