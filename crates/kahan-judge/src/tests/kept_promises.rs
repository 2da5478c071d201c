//! Tests the guarantee of `try_step` near the limits of float formats, on a seeded sample.
//!
//! An `Ok` of `try_step` must lie within 64 u of the exact step, relative to its largest component,
//! where u is the unit roundoff. An `Err` is allowed only if the condition number is at least 1e12
//! (f32: 1e4) or the format cannot hold the result. The comparison is exact. `kahan extremes
//! --trials 1000000` takes a large sample.

use std::ops::ControlFlow;

use kahan_algebra::lexer::lex;
use kahan_algebra::read_unproved;
use kahan_algebra::system::System;
use kahan_core::prelude::*;
use kahan_runtime::threads::available;
use kahan_study::{Progress, Study, Subject, Systems, Unwatched, Watch};
use kahan_systems::E2;
use serde_json::json;

use super::compiled::Compiled;
use super::drawn::{Drawn, odd, odd_chain, odd_of_many};
use crate::{Cell, CellKey, Extremes, Regime, Tally, usual_subjects};

const TRIALS: u64 = 2000;

struct Threads(usize);

impl Watch for Threads {
    fn threads(&self) -> usize {
        self.0
    }
}

fn studies(subjects: impl IntoIterator<Item = Subject>) -> Vec<Study> {
    subjects.into_iter().map(|subject| subject.study(&Systems).expect("a system of the catalog")).collect()
}

fn judged(trials: u64, seed: u64) -> Tally {
    let asked = Extremes { trials, seed, ..Extremes::default() };
    asked.of(&studies(usual_subjects()), &Threads(available())).expect("an answer").tally
}

fn system(drawn: &Drawn) -> System {
    let block = drawn.field.block();
    read_unproved(&lex(&block).tokens).system().unwrap_or_else(|_| panic!("{block}"))
}

fn sum(tally: &Tally, belongs: impl Fn(&CellKey) -> bool, of: impl Fn(&Cell) -> u64) -> u64 {
    tally.cells.iter().filter(|(place, _)| belongs(place)).map(|(_, cell)| of(cell)).sum()
}

#[test]
fn the_stable_tier_keeps_its_promise_at_the_extremes() {
    let tally = judged(TRIALS, 20);
    let is_stable = |place: &CellKey| place.1 == "stable";
    assert!(sum(&tally, is_stable, |cell| cell.trials) >= 3 * TRIALS);
    let wrong = sum(&tally, is_stable, |cell| cell.silently_wrong);
    let flags = sum(&tally, is_stable, |cell| cell.unjustified);
    assert_eq!((wrong, flags), (0, 0), "silently wrong, and flagged without right: {:#?}", tally.failures);
}

/// For the state 1e154, only the last multiply-add overflows, after all bounds are computed.
#[test]
fn a_result_beyond_the_largest_float_is_flagged() {
    for (x, eps) in [(12.0, 0.125), (40.0, 0.03125)] {
        assert!(E2.try_step(&vector![x, 1e154, 1.0], eps).is_err());
        assert!(E2.try_step(&vector![x, 1e154, 1.0].map(Dd::from), Dd::from(eps)).is_err());
    }
    assert!(E2.try_step(&vector![12.0, 1e153, 1.0], 0.125).is_ok());
}

#[test]
fn the_fast_tier_is_caught_near_poles_and_not_at_ordinary_points() {
    let tally = judged(TRIALS, 21);
    for scalar in ["f32", "f64"] {
        let of = |regime| tally.cells.get(&(regime, "fast", scalar)).expect("every regime is drawn");
        for regime in [Regime::NearPole, Regime::NearRemovablePole, Regime::MixedMagnitudes] {
            assert!(of(regime).silently_wrong > 0, "{scalar}, {regime:?}");
        }
        assert_eq!(of(Regime::Ordinary).silently_wrong, 0);
        let special = of(Regime::NotFinite);
        assert_eq!((special.flagged, special.max_error_u), (special.trials, None));
    }
}

#[test]
fn each_regime_has_its_quarter() {
    let tally = judged(TRIALS, 22);
    for scalar in ["f32", "f64"] {
        for regime in [Regime::NearPole, Regime::NearRemovablePole, Regime::MixedMagnitudes, Regime::Ordinary]
        {
            let trials = tally.cells[&(regime, "stable", scalar)].trials;
            // Up to 2 % of these trials may find no pole, and count as `MixedMagnitudes`.
            assert!(4 * trials >= TRIALS - TRIALS / 50, "{scalar}, {regime:?}: {trials}");
        }
        for regime in [Regime::Subnormal, Regime::NotFinite, Regime::LargeSteps] {
            assert_eq!(tally.cells[&(regime, "stable", scalar)].trials, TRIALS / 32);
        }
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let studies = studies(["euler", "volterra"].map(Subject::named));
    let judged = |seed, threads| {
        let asked = Extremes { trials: 400, seed, odd_fields: 2, odd_trials: 4, ..Extremes::default() };
        asked.of(&studies, &Threads(threads)).expect("an answer").tally
    };
    let one = judged(5, 1);
    assert_eq!(one, judged(5, 3));
    assert_ne!(one, judged(6, 1));
}

#[test]
fn fields_of_odd_tempers_are_in_the_language() {
    for seed in 1..=3 {
        for number in (0..64).chain([244, 279, 314, 349, 384]) {
            system(&odd(seed, number));
        }
        (0..12).for_each(|number| drop(system(&odd_of_many(seed, number))));
    }
}

#[test]
fn what_is_drawn_is_judged() {
    let asked = Extremes { trials: 1, seed: 3, odd_fields: 24, odd_trials: 16, ..Extremes::default() };
    let judged = asked.of(&studies([Subject::named("e1")]), &Threads(available())).expect("an answer");
    let stable = sum(&judged.tally, |place| place.1 == "stable", |cell| cell.trials);
    assert_eq!(stable, asked.total());
}

#[test]
fn who_stops_the_trials_has_those_that_were_made() {
    struct Impatient;
    impl Watch for Impatient {
        fn look(&self, _: &Progress<'_>) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }
    let judged = Extremes::default().of(&studies([Subject::named("e1")]), &Impatient).expect("an answer");
    assert_eq!(sum(&judged.tally, |place| place.1 == "stable", |cell| cell.trials), 64);
}

#[test]
fn fields_of_many_variables_and_chains_can_be_drawn_and_judged() {
    let of_chain = |number| {
        let Drawn { field, sites, .. } = odd_chain(1, number);
        let family = read_unproved(&lex(&field.block()).tokens).family();
        let family = family.unwrap_or_else(|_| panic!("{}", field.block()));
        Compiled::of_chain(&field.name, &family.expect("a chain"), sites.expect("a chain"))
    };
    let of_many = |number| Compiled::new("Many", &system(&odd_of_many(1, number)));
    for field in (0..6).map(of_chain).chain((0..3).map(of_many)) {
        let count = Compiled::count(8);
        assert_eq!(field.inputs::<f64>(8, 5), field.inputs::<f64>(8, 5));
        assert_eq!(field.inputs::<f32>(8, 5).len() * 2, field.inputs::<Dd>(8, 5).len());
        let (flags, mut tally) = (vec![0; count as usize], Tally::default());
        field.judge::<f32>(8, 5, &mut &flags[..], &mut tally);
        field.judge::<f64>(8, 5, &mut &flags[..], &mut tally);
        field.judge::<Dd>(8, 5, &mut &flags[..], &mut tally);
        assert_eq!(sum(&tally, |_| true, |cell| cell.flagged), 3 * count);
    }
}

#[test]
fn verdicts_have_the_names_of_json() {
    let asked = Extremes { trials: 8, seed: 3, ..Extremes::default() };
    let judged = json!(asked.of(&studies([Subject::named("e1")]), &Unwatched).expect("an answer"));
    let names: Vec<&str> = judged.as_object().expect("an object").keys().map(String::as_str).collect();
    let of_question = ["system", "systems", "random_fields", "odd_fields", "trials", "seed", "seconds"];
    assert_eq!(names, [&of_question[..], &["cells", "broken", "failures"]].concat());
    let cell = judged["cells"][0].as_object().expect("an object");
    let of_cell = ["regime", "tier", "scalar", "trials", "max_error_u", "flagged", "unjustified_flags"];
    assert!(cell.keys().eq(of_cell.iter().chain(&["silently_wrong"])), "{cell:?}");
    assert_eq!(json!([judged["system"], judged["broken"]]), json!(["e1", []]));
}
