//! Tests identities of special functions, whose two sides are computed in different ways.

use kahan_core::num_traits::One;
use kahan_systems::special::{
    Float256, Modulus, Real, centered_digamma_difference, centered_gamma_ratio, digamma, elliptic_k, gamma,
    gamma_ratio, jacobi, theta,
};

use crate::solutions::measure::{assert_close, number};

fn int(n: i64) -> Float256 {
    Float256::from_int(n)
}

const ARGUMENTS: [&str; 6] = ["1/7", "0.5", "13/11", "41/6", "-2.75", "-31/9"];

#[test]
fn gamma_satisfies_recurrence_and_duplication() {
    for x in ARGUMENTS.map(number) {
        assert_close(&gamma(&(x + int(1))), &(x * gamma(&x)), 73, "recurrence");
        // Γ(x)Γ(x + 1/2) = 2^(1−2x) √π Γ(2x)
        let left = gamma(&x) * gamma(&(x + Float256::half()));
        let power = int(2).power_real(&(int(1) - int(2) * x));
        let double = int(2) * x;
        if double.floor() != double || double.is_positive() {
            assert_close(&left, &(power * Float256::pi().sqrt() * gamma(&double)), 72, "duplication");
        }
    }
}

#[test]
fn digamma_satisfies_recurrence_reflection_and_duplication() {
    for x in ARGUMENTS.map(number) {
        assert_close(&(digamma(&(x + int(1))) - digamma(&x)), &(int(1) / x), 73, "recurrence");
        let (sine, cosine) = (Float256::pi() * x).sin_cos();
        let reflected = digamma(&(int(1) - x)) - digamma(&x);
        if cosine.abs() > number("1e-60") {
            assert_close(&reflected, &(Float256::pi() * cosine / sine), 72, "reflection");
        }
        // ψ(2x) = ln 2 + (ψ(x) + ψ(x + 1/2))/2
        let mean = (digamma(&x) + digamma(&(x + Float256::half()))) * Float256::half();
        let double = int(2) * x;
        if double.floor() != double || double.is_positive() {
            assert_close(&digamma(&double), &(mean + int(2).ln()), 72, "duplication");
        }
    }
}

#[test]
fn the_ratio_is_the_quotient_of_gammas() {
    for x in ARGUMENTS.map(number) {
        for (a, b) in [("1/3", "2/7"), ("-5/3", "9/4"), ("11/2", "-1/5")] {
            let (a, b) = (number(a), number(b));
            let quotient = gamma(&(x + a)) / gamma(&(x + b));
            assert_close(&gamma_ratio(&x, &a, &b), &quotient, 70, "ratio");
        }
    }
}

#[test]
fn the_centred_ratio_with_an_integer_difference_is_the_limit_of_its_neighbours() {
    // For integer 2σ a polynomial is used, and for other σ the series. Both must agree at nearby σ.
    let small = number("1e-40");
    for w in ARGUMENTS.map(number) {
        for two_sigma in [-3, -2, -1, 1, 2, 3, 4] {
            let sigma = Float256::from_ratio(two_sigma, 2);
            let here = centered_gamma_ratio(&w, &sigma);
            if here.is_defined() && here.abs() > small {
                let beside = centered_gamma_ratio(&w, &(sigma + small));
                assert_close(&beside, &here, 37, "2 sigma is an integer");
            }
        }
    }
}

#[test]
fn the_centred_ratio_has_no_false_poles() {
    // For (w, σ) = (−1/4, 3/4), Γ(1)/Γ(−1/2) = −1/(2√π). For (3/4, 5/4), Γ(5/2)/Γ(0) = 0.
    let ratio = centered_gamma_ratio(&number("-1/4"), &number("3/4"));
    assert_close(&ratio, &(int(-1) / (int(2) * Float256::pi().sqrt())), 74, "no pole");
    assert_eq!(centered_gamma_ratio(&number("3/4"), &number("5/4")), int(0));
    assert!(!centered_gamma_ratio(&number("-3/4"), &number("-3/4")).is_defined());
    // ψ(1) − ψ(−1/2) = ψ(1) − ψ(1/2) − 2 = 2 ln 2 − 2
    let difference = centered_digamma_difference(&number("-1/4"), &number("3/4"));
    assert_close(&difference, &(int(2) * int(2).ln() - int(2)), 73, "no pole");
}

#[test]
fn the_centred_difference_is_the_difference_of_digammas() {
    for w in ["1/7", "13/11", "41/6", "-2.75", "-31/9"].map(number) {
        for sigma in ["1/5", "-2/3", "17/8"].map(number) {
            let middle = w + Float256::half();
            let difference = digamma(&(middle + sigma)) - digamma(&(middle - sigma));
            assert_close(&centered_digamma_difference(&w, &sigma), &difference, 70, "difference");
        }
    }
}

/// Returns the complete elliptic integral of the second kind, E(k) = K(1 − Σ 2^(n−1) cₙ²). Here c₀
/// = k, and cₙ = (aₙ₋₁ − bₙ₋₁)/2 with the arithmetic-geometric mean of a₀ = 1 and b₀ = √(1 − k²).
fn second_kind(k: &Float256) -> Float256 {
    let (mut a, mut b) = (int(1), ((int(1) - *k) * (int(1) + *k)).sqrt());
    let mut c = *k;
    let mut weight = Float256::half();
    let mut sum = weight * c.square();
    for _ in 0..12 {
        let mean = (a + b) * Float256::half();
        c = (a - b) * Float256::half();
        b = (a * b).sqrt();
        a = mean;
        weight *= int(2);
        sum += weight * c.square();
    }
    elliptic_k(k) * (int(1) - sum)
}

#[test]
fn legendre_relation_holds() {
    for k in ["1/9", "3/5", "0.9", "0.9999"].map(number) {
        let complementary = Modulus::new(k).complement;
        let (kk, ee) = (elliptic_k(&k), second_kind(&k));
        let (kc, ec) = (elliptic_k(&complementary), second_kind(&complementary));
        let relation = ee * kc + ec * kk - kk * kc;
        assert_close(&relation, &(Float256::pi() * Float256::half()), 70, "Legendre");
    }
}

#[test]
fn jacobi_functions_satisfy_the_addition_theorem_and_invert_the_integral() {
    for k in ["1/9", "3/5", "0.9", "0.9999"] {
        let modulus = Modulus::new(number(k));
        let square = modulus.k.square();
        for (u, v) in [("2/7", "13/11"), ("-5/3", "41/6"), ("1/100", "-31/9")] {
            let (u, v) = (number(u), number(v));
            let (at_u, at_v) = (jacobi(&u, &modulus), jacobi(&v, &modulus));
            let sum = jacobi(&(u + v), &modulus);
            let divisor = Float256::one() - square * (at_u.sn * at_v.sn).square();
            let left = at_u.sn * at_v.cn * at_v.dn + at_v.sn * at_u.cn * at_u.dn;
            assert_close(&sum.sn, &(left / divisor), 70, "sn(u+v)");
            let left = at_u.cn * at_v.cn - at_u.sn * at_v.sn * at_u.dn * at_v.dn;
            assert_close(&sum.cn, &(left / divisor), 69, "cn(u+v)");
            let left = at_u.dn * at_v.dn - square * at_u.sn * at_v.sn * at_u.cn * at_v.cn;
            assert_close(&sum.dn, &(left / divisor), 70, "dn(u+v)");
            assert_close(&(at_u.sn.square() + at_u.cn.square()), &int(1), 74, "circle");
            let turns = (u / (int(4) * modulus.quarter_period()) + Float256::half()).floor();
            let reduced = u - int(4) * turns * modulus.quarter_period();
            assert_close(&modulus.inverse(&at_u.sn, &at_u.cn), &reduced, 72, "inverse");
        }
    }
}

#[test]
fn theta_quotients_are_the_jacobi_functions() {
    for k in ["1/9", "3/5", "0.99"].map(number) {
        let modulus = Modulus::new(k);
        let q = modulus.nome();
        let zero = theta(&int(0), &q);
        assert_close(&(zero.two / zero.three).square(), &modulus.k, 71, "k = (theta2/theta3)^2");
        for u in ["2/7", "-5/3", "41/6"].map(number) {
            let at = theta(&(u / zero.three.square()), &q);
            let value = jacobi(&u, &modulus);
            let sn = zero.three / zero.two * at.one / at.four;
            let cn = zero.four / zero.two * at.two / at.four;
            let dn = zero.four / zero.three * at.three / at.four;
            assert_close(&sn, &value.sn, 70, "sn");
            assert_close(&cn, &value.cn, 70, "cn");
            assert_close(&dn, &value.dn, 70, "dn");
        }
    }
}
