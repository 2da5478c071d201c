//! Measures errors in `f64` against 256 bits, and compares them with the documented bounds.

use kahan_systems::special::{
    Float256, Jacobi, Modulus, Theta, centered_digamma_difference, centered_gamma_ratio, digamma, elliptic_f,
    elliptic_k, gamma, jacobi, theta,
};

use crate::solutions::measure::ulps_above;

const SAMPLES: usize = 400;

struct Random(u64);

impl Random {
    fn new() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        from + (to - from) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Asserts that each error is at most bound·2⁻⁵²·max(|value|, `floor`).
fn assert_bounded<A: Copy + core::fmt::Debug>(
    what: &str,
    bound: f64,
    floor: f64,
    mut draw: impl FnMut(&mut Random) -> A,
    float: impl Fn(A) -> f64,
    exact: impl Fn(A) -> Float256,
) {
    let mut random = Random::new();
    let mut worst = 0.0_f64;
    for _ in 0..SAMPLES {
        let argument = draw(&mut random);
        let units = ulps_above(float(argument), &exact(argument), floor);
        assert!(units <= bound, "{what} at {argument:?}: {units} ulp");
        worst = worst.max(units);
    }
    println!("{what}: {worst:.2} ulp of at most {bound}");
}

fn p(x: f64) -> Float256 {
    x.into()
}

#[test]
fn gamma_is_within_8_ulp() {
    for (from, to) in [(0.0, 2.0), (2.0, 20.0), (20.0, 171.0), (-30.0, 0.0)] {
        assert_bounded("gamma", 8.0, 0.0, |r| r.between(from, to), |x| gamma(&x), |x| gamma(&p(x)));
    }
}

#[test]
fn digamma_is_within_16_ulp() {
    for (from, to) in [(0.0, 3.0), (3.0, 20.0), (20.0, 1e6), (-30.0, 0.0)] {
        assert_bounded("digamma", 16.0, 1.0, |r| r.between(from, to), |x| digamma(&x), |x| digamma(&p(x)));
    }
}

#[test]
fn ratios_of_gamma_are_within_64_ulp() {
    for (from, to, bound) in [(-20.0, 0.0, 64.0), (0.0, 20.0, 40.0), (20.0, 1e6, 4.0)] {
        assert_bounded(
            "the centred ratio",
            bound,
            0.0,
            |r| (r.between(from, to), r.between(-3.0, 3.0)),
            |(w, s)| centered_gamma_ratio(&w, &s),
            |(w, s)| centered_gamma_ratio(&p(w), &p(s)),
        );
    }
    // For |w| ≤ |σ|, this difference of digammas has zeros and poles. Here |w| is larger.
    assert_bounded(
        "the difference of digammas",
        16.0,
        0.0,
        |r| (r.between(4.0, 100.0), r.between(-3.0, 3.0)),
        |(w, s)| centered_digamma_difference(&w, &s),
        |(w, s)| centered_digamma_difference(&p(w), &p(s)),
    );
}

/// Draws a modulus from [0, 1), uniformly or close to 1.
fn modulus(random: &mut Random, near_one: bool) -> f64 {
    if near_one { 1.0 - 10.0_f64.powf(random.between(-15.0, -1.0)) } else { random.between(0.0, 0.999) }
}

#[test]
fn elliptic_integrals_are_within_6_ulp() {
    for near_one in [false, true] {
        assert_bounded("K", 4.0, 0.0, |r| modulus(r, near_one), |k| elliptic_k(&k), |k| elliptic_k(&p(k)));
        assert_bounded(
            "F",
            6.0,
            0.0,
            |r| (r.between(-1.57, 1.57), modulus(r, near_one)),
            |(phi, k)| elliptic_f(&phi, &k),
            |(phi, k)| elliptic_f(&p(phi), &p(k)),
        );
    }
    assert_bounded(
        "F of large angles",
        8.0,
        0.0,
        |r| (r.between(-50.0, 50.0), modulus(r, false)),
        |(phi, k)| elliptic_f(&phi, &k),
        |(phi, k)| elliptic_f(&p(phi), &p(k)),
    );
}

#[test]
fn jacobi_functions_are_within_8_units() {
    let parts: [fn(Jacobi<Float256>) -> Float256; 3] = [|j| j.sn, |j| j.cn, |j| j.dn];
    let floats: [fn(Jacobi<f64>) -> f64; 3] = [|j| j.sn, |j| j.cn, |j| j.dn];
    for (near_one, bound) in [(false, 8.0), (true, 64.0)] {
        for (part, float) in parts.iter().zip(floats) {
            assert_bounded(
                "sn, cn or dn",
                bound,
                1.0,
                |r| {
                    let k = modulus(r, near_one);
                    (2.0 * elliptic_k(&k) * r.between(-1.0, 1.0), k)
                },
                |(u, k)| float(jacobi(&u, &Modulus::new(k))),
                |(u, k)| part(jacobi(&p(u), &Modulus::new(p(k)))),
            );
        }
    }
}

#[test]
fn theta_functions_are_within_10_units() {
    let parts: [fn(Theta<Float256>) -> Float256; 4] = [|t| t.one, |t| t.two, |t| t.three, |t| t.four];
    let floats: [fn(Theta<f64>) -> f64; 4] = [|t| t.one, |t| t.two, |t| t.three, |t| t.four];
    for (part, float) in parts.iter().zip(floats) {
        assert_bounded(
            "theta",
            10.0,
            1.0,
            |r| (r.between(-10.0, 10.0), r.between(0.0, 0.9)),
            |(z, q)| float(theta(&z, &q)),
            |(z, q)| part(theta(&p(z), &p(q))),
        );
    }
}
