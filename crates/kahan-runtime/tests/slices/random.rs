//! Compares maps of random fields over slices with maps over vectors of fixed length.

use kahan_core::KahanMap;
use kahan_core::nalgebra::SVector;
use kahan_runtime::interpreted::Interpreted;
use kahan_runtime::{Field, MachineFloat, Map};

use super::support::{Random, assert_same, steps};

const NAMES: [&str; 6] = ["u", "v", "w", "x", "y", "z"];

fn field(random: &mut Random, n: u32) -> String {
    let name = |random: &mut Random| NAMES[random.below(n) as usize];
    let mut equation = |variable: &str| {
        let terms = (0..=random.below(4)).map(|_| {
            let number = format!("{}/{}", 1 + random.below(9), 1 + random.below(12));
            let sign = if random.below(2) == 0 { "-" } else { "+" };
            let scale = ["", "*a", "*b", "/c"][random.below(4) as usize];
            let factors: String = (0..random.below(3)).map(|_| format!("*{}", name(random))).collect();
            format!("{sign} {number}{scale}{factors}")
        });
        format!("{variable}dot = a*b/c*{variable} {};", terms.collect::<Vec<_>>().join(" "))
    };
    NAMES[..n as usize].iter().map(|variable| equation(variable)).collect()
}

fn agree<T: MachineFloat, const N: usize>(text: &str, map: &Map) {
    let typed: Interpreted<T, N> = map.as_kahan_map().expect("a type that is large enough");
    let mut random = Random(11);
    for eps in steps::<T>() {
        let (ours, theirs) = (map.at(eps), typed.at(eps));
        let x = SVector::<T, N>::from_vec(random.point(N));
        let what = format!("{text} at {x:?}, {eps:?}");
        let (mut next, mut entries) = (vec![T::zero(); N], vec![T::zero(); N * N]);
        ours.step(x.as_slice(), &mut next).unwrap();
        assert_same(&next, theirs.step(&x).as_slice(), &what);
        ours.jacobian(x.as_slice(), &mut entries).unwrap();
        assert_same(&entries, theirs.jacobian(&x).transpose().as_slice(), &what);
        let mut last = x.as_slice().to_vec();
        ours.advance(&mut last, 20).unwrap();
        assert_same(&last, typed.orbit(x, eps).nth(20).unwrap().as_slice(), &what);
    }
}

#[test]
fn random_fields_are_the_same_as_slices_and_as_vectors() {
    let mut random = Random(1_974);
    for round in 0..40 {
        let n = 1 + round % 6;
        let text = field(&mut random, n);
        let read = Field::parse(&text).unwrap_or_else(|why| panic!("{text}: {why}"));
        let map = read.with([("c", 1.75), ("b", -0.3), ("a", 1.0 / 3.0)]).expect("three parameters");
        match n {
            1 => (agree::<f64, 1>(&text, &map), agree::<f32, 1>(&text, &map)),
            2 => (agree::<f64, 2>(&text, &map), agree::<f32, 2>(&text, &map)),
            3 => (agree::<f64, 3>(&text, &map), agree::<f32, 3>(&text, &map)),
            4 => (agree::<f64, 4>(&text, &map), agree::<f32, 4>(&text, &map)),
            5 => (agree::<f64, 5>(&text, &map), agree::<f32, 5>(&text, &map)),
            _ => (agree::<f64, 6>(&text, &map), agree::<f32, 6>(&text, &map)),
        };
    }
}
