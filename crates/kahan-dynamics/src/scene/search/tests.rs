//! Tests searches for settings whose errors follow a known law.

use kahan_core::Composition;

use super::choose::COUNTED;
use super::*;
use crate::{Need, Scene};

/// Errors that follow the law error ∝ ε^order, plus rounding errors.
#[derive(Clone, Copy, Debug)]
struct Law {
    price_of_order: fn(u32) -> f64,
    count: usize,
}

impl Law {
    fn error_of(setting: &Setting) -> f64 {
        let (order, steps) = (setting.scheme.order(), setting.steps as f64);
        let unit = setting.scheme.precision.unit();
        let roundings = if setting.scheme.compensated { unit } else { unit * steps };
        (30.0 / steps).powi(order as i32) + roundings
    }
}

impl Trials for Law {
    fn setting(&self, scheme: Scheme, steps: u64) -> Setting {
        Scene::new(10.0, Need::Trajectory, 1e-9).setting(scheme, steps)
    }

    fn error(&mut self, setting: &Setting, _share: f64) -> Option<f64> {
        self.count += 1;
        Some(Self::error_of(setting))
    }

    fn price(&self, scheme: Scheme) -> f64 {
        let numbers = if scheme.precision == Precision::DoubleDouble { 10.0 } else { 1.0 };
        let carried = if scheme.compensated { 1.1 } else { 1.0 };
        numbers * carried * (self.price_of_order)(scheme.order())
    }
}

/// Two prices of a step by its order: the number of stages, and one that favours order 4.
const PRICES: [fn(u32) -> f64; 2] = [
    |order| Composition::of_order(order).expect("an order").stages() as f64,
    |order| 0.7 + f64::from(order).powi(2),
];

const SHOWN: SearchParameters =
    SearchParameters { enough: 1.0, aim: 1.0, surplus: 1.01, leaps: false, surely: 2.0, share: 0.3 };

fn plain() -> impl Iterator<Item = Scheme> {
    Composition::BEST.into_iter().rev().map(|composition| PLAIN_DOUBLE.composed(composition))
}

fn least(law: &Law, enough: f64) -> f64 {
    let cost = |scheme: Scheme| {
        let serves = |steps: &u64| Law::error_of(&law.setting(scheme, *steps)) <= enough;
        (1..20_000).find(serves).map(|steps| law.price(scheme) * steps as f64)
    };
    plain().filter_map(cost).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_choice_is_as_cheap_as_any_under_either_price_and_either_rules() {
    for price_of_order in PRICES {
        for tolerance in [1e-2, 1e-4, 1e-6, 1e-8] {
            for rules in [COUNTED, SHOWN] {
                let mut search = Search::new(Law { price_of_order, count: 0 }, tolerance, rules);
                for scheme in plain() {
                    search.refine_steps(scheme, 10);
                }
                for scheme in plain() {
                    search.refine(scheme);
                }
                let best = search.best().expect("something serves");
                let law = search.trials();
                assert!(Law::error_of(&best) <= rules.enough * tolerance, "{best:?}");
                let cost = law.price(best.scheme) * best.steps as f64;
                let least = least(law, rules.enough * tolerance);
                assert!(cost <= EQUAL_STEPS_RATIO * least, "{best:?}: {cost} against {least} at {tolerance}");
                assert!(law.count <= 40, "{} trials at {tolerance}", law.count);
            }
        }
    }
}

#[test]
fn ladders_that_are_shown_leave_out_no_rung() {
    let mut search = Search::new(Law { price_of_order: PRICES[0], count: 0 }, 1e-9, SHOWN);
    search.refine_steps(PLAIN_DOUBLE.composed(Composition::BEST[1]), 3);
    let steps: Vec<u64> = search.tried.iter().map(|trial| trial.steps).collect();
    assert!(steps.len() > 5);
    assert!(steps.iter().enumerate().all(|(rung, steps)| *steps == 3 << rung), "{steps:?}");
}

#[test]
fn ladders_end_where_roundings_end_them() {
    let mut search = Search::new(Law { price_of_order: PRICES[0], count: 0 }, 1e-17, SHOWN);
    let climb = search.refine_steps(PLAIN_DOUBLE.composed(Composition::BEST[3]), 3);
    assert!(climb.has_felt_roundings() && climb.has_stalled(), "{climb:?}");
    assert!(
        search.has_tried(PLAIN_DOUBLE_DOUBLE.composed(Composition::BEST[3])),
        "what shows that it is roundings"
    );
}

#[test]
fn nothing_is_refined_where_nothing_serves() {
    let mut search = Search::new(Law { price_of_order: PRICES[0], count: 0 }, 1e-17, SHOWN);
    search.refine_steps(PLAIN_DOUBLE, 3);
    let count = search.trials().count;
    search.refine(PLAIN_DOUBLE);
    assert_eq!(search.trials().count, count);
}
