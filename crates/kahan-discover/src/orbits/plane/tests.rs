use kahan_algebra::field::Field;
use kahan_algebra::{lexer, read};

use super::*;
use crate::modular::modulus::Modulus;

const LOTKA_VOLTERRA: &str = "xdot = x*(1 - y); ydot = y*(x - 1);";
const ZANDER_113: &str = "xdot = x*(x + y) + 3*x*y; ydot = -(y*(x + y) + 3*x*y);";

fn field(text: &str) -> std::sync::Arc<Field> {
    read(&lexer::lex(text).tokens).system().expect("a system").field
}

fn verdict(text: &str, seed: u64) -> GrowthVerdict {
    let searched = SearchField::new(&field(text), None);
    let mut random = SplitMix64::new(seed);
    let map = searched.sample(Modulus::mersenne_61(), &mut random).expect("a map").map;
    let far = Deadline::never();
    let limits = DegreeLimits { iterates: 12, degree: 40, deadline: &far };
    growth(&searched, &map, &degrees::degrees(&map, &mut random, limits), &mut random, &far)
}

#[test]
fn exponential_growth_is_proved() {
    for seed in 0..4 {
        let found = verdict(LOTKA_VOLTERRA, seed);
        assert!(matches!(found.proof, Some(GrowthProof::Stable { .. })), "{found:?}");
        assert!((found.growth.entropy() - 2f64.ln()).abs() < 1e-15);
        // The orbits of contracted lines reach points of indeterminacy, so iterate 6 has the degree
        // 62 instead of 64.
        let found = verdict(ZANDER_113, seed);
        assert!(matches!(found.proof, Some(GrowthProof::Degree { iterate: 5, degree: 32 })), "{found:?}");
    }
}

#[test]
fn growth_that_shows_is_proved_from_more_degrees() {
    let searched = SearchField::new(&field(ZANDER_113), None);
    let mut random = SplitMix64::new(5);
    let map = searched.sample(Modulus::mersenne_61(), &mut random).expect("a map").map;
    let few = [1, 2, 4, 8, 16];
    let found = growth(&searched, &map, &few, &mut random, &Deadline::never());
    assert!(matches!(found.proof, Some(GrowthProof::Degree { iterate: 5, degree: 32 })), "{found:?}");
}

#[test]
fn no_other_growth_is_proved_exponential() {
    let integrable = [
        "xdot = y; ydot = 6*x^2 - a;",
        "xdot = x^2 - y^2; ydot = -2*x*y;",
        "xdot = 2*x^2 - 12*y^2; ydot = -6*x*y - 4*y^2;",
        "xdot = 2*x^2 - y^2; ydot = -10*x*y + y^2;",
        "xdot = x^2; ydot = x*y + a*y^2;",
        "xdot = x^2; ydot = a*x*y;",
        "xdot = a*x; ydot = b*y;",
        "xdot = y + 1; ydot = x;",
        "xdot = x^2; ydot = y^2;",
        "xdot = 1; ydot = 0;",
    ];
    for text in integrable {
        let searched = SearchField::new(&field(text), None);
        for seed in 0..3 {
            let found = verdict(text, seed);
            assert_eq!(found.proof, None, "{text}: {found:?}");
        }
        let stable = stability::prime_of_stability(&searched, &mut SplitMix64::new(7), &Deadline::never());
        assert_eq!(stable, None, "{text}");
    }
}
