//! Tests that observables of many orbits equal those of single orbits bit for bit.

use std::ops::ControlFlow;

use kahan_core::Composition;
use kahan_runtime::{End, MapAt, Observable, ObservationRequest, ObservedFloat};

use super::support::{columns, maps};

const ORBITS: usize = 37;

fn agree<T: ObservedFloat>(at: &MapAt<T>, starts: &[Vec<T>], asked: &ObservationRequest<'_>) -> Vec<End> {
    let go_on = |_| ControlFlow::Continue(());
    let found = T::observe_many(&[at; ORBITS], starts, asked, &go_on).expect("columns that fit");
    for (orbit, found) in found.iter().enumerate() {
        let start: Vec<T> = starts.iter().map(|column| column[orbit]).collect();
        let single = T::observe_one(None, at, &start, asked, &go_on).expect("a number a variable");
        assert_eq!(format!("{found:?}"), format!("{single:?}"), "{:?}: orbit {orbit}", asked.of);
    }
    found.iter().map(|found| found.end).collect()
}

#[test]
fn observables_are_those_of_each_orbit_alone() {
    use Observable::{Extrema, Fli, Last, Lyapunov, Sali};

    let mut ends = Vec::new();
    // The last field, with nine variables, has no code and is left out.
    for (field, map) in maps().take(5) {
        let starts = columns::<f64>(field.variables().len(), ORBITS);
        for of in [&[Last][..], &[Lyapunov], &[Sali, Last], &[Lyapunov, Sali], &[Sali, Fli], &[Extrema]] {
            for (eps, steps) in [(0.05, 7), (0.05, 131), (0.4, 128), (2.5, 50)] {
                let asked = ObservationRequest {
                    of,
                    steps,
                    renormalize: 1,
                    exponents: 1,
                    escape: None,
                    relations: None,
                };
                ends.extend(agree(&map.at(eps), &starts, &asked));
                agree(&map.at(eps).composed(Composition::SUZUKI_4), &starts, &asked);
                agree(&map.at(eps), &starts, &ObservationRequest { escape: Some(2.0), ..asked });
            }
        }
    }
    assert!(ends.iter().any(|end| matches!(end, End::Range(step) if *step > 16)), "none left the range");
}
