//! Fused steps have the bits of ensembles with fused multiply-adds, in one call or in several.

use kahan_core::{Composition, Level};
use kahan_runtime::{Field, Map, MapAt};

const FIELDS: [(&str, &[f64]); 4] = [
    ("xdot = 10*(y - x); ydot = 28*x - y - x*z; zdot = x*y - 8/3*z;", &[1.0, 1.0, 1.0]),
    ("xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);", &[1.0, 2.0, 3.0]),
    ("xdot = v; vdot = -x - x^2;", &[0.3, 0.0]),
    ("xdot = u; ydot = v; udot = -x - 2*x*y; vdot = -y - x^2 + y^2;", &[0.1, 0.2, 0.3, -0.1]),
];

fn fused(text: &str) -> Option<[Map; 2]> {
    let map = Field::parse(text).expect("a field").map().expect("no parameters");
    let fused = map.clone().fused();
    if fused.is_none() {
        assert!(!map.field().has_fused_steps());
        println!("not run: no fused steps here");
    }
    Some([map, fused?])
}

fn after(at: &MapAt<f64>, start: &[f64], calls: u64, steps: u64) -> Vec<u64> {
    let mut x = start.to_vec();
    (0..calls).for_each(|_| at.advance(&mut x, steps).expect("a state of its length"));
    x.iter().map(|x| x.to_bits()).collect()
}

#[test]
fn fused_orbits_are_those_of_a_fused_level() {
    for (text, start) in FIELDS {
        let Some([plain, fused]) = fused(text) else { return };
        for order in [2, 4] {
            let composition = Composition::of_order(order).expect("an order");
            let at = |map: &Map| map.at(0.005).composed(composition);
            let level = [Level::Avx2, Level::Neon].into_iter().find_map(|level| at(&plain).at_level(level));
            let (plain, fused) = (at(&plain), at(&fused));
            let whole = after(&fused, start, 1, 3000);
            assert_eq!(whole, after(&level.expect("a fused level"), start, 1, 3000), "{text}");
            assert_eq!(whole, after(&fused, start, 3000, 1), "{text}");
            assert_ne!(whole, after(&plain, start, 1, 3000), "{text}");
            assert_eq!(
                after(&plain, start, 1, 3000),
                after(&fused.at_level(Level::Baseline).expect("a level"), start, 1, 3000)
            );
        }
    }
}

#[test]
fn compensated_sums_are_fused_from_the_first_step() {
    for (text, start) in FIELDS {
        let Some([_, fused]) = fused(text) else { return };
        let whole = fused.at(0.005);
        let (mut x, mut carry) = (start.to_vec(), vec![0.0; start.len()]);
        whole.advance_with_carry(&mut x, &mut carry, 50_000).expect("states of its length");
        // This new map has no code yet, and no call has enough steps to compile it.
        let cut = fused.at(0.005);
        let (mut y, mut rest) = (start.to_vec(), vec![0.0; start.len()]);
        for _ in 0..50_000 {
            cut.advance_with_carry(&mut y, &mut rest, 1).expect("states of its length");
        }
        assert_eq!((x, carry), (y, rest), "{text}");
    }
}

#[test]
fn columns_of_fused_maps_are_fused_orbits() {
    for (text, start) in FIELDS {
        let Some([_, fused]) = fused(text) else { return };
        // For two variables, bits differ: a step divides twice, but a step of columns once.
        if start.len() < 3 {
            continue;
        }
        let at = fused.at(0.005);
        let mut columns: Vec<Vec<f64>> = start.iter().map(|x| vec![*x; 9]).collect();
        let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        at.advance_columns(&mut slices, &[], &[], 1000).expect("columns that fit");
        let last: Vec<u64> = columns.iter().map(|column| column[8].to_bits()).collect();
        assert_eq!(last, after(&at, start, 1, 1000), "{text}");
    }
}

#[test]
fn a_step_by_elimination_has_no_fused_code() {
    let names = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"];
    let sum = names.join(" + ");
    let text: String = names.iter().map(|name| format!("{name}dot = {name}^2 - ({sum})^2;\n")).collect();
    let map = Field::parse(&text).expect("a field").map().expect("no parameters");
    assert!(!map.field().has_fused_steps() && map.fused().is_none());
}
