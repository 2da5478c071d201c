//! Maps over points in all units: orbits, steps with error bounds, ensembles, and `Scene`s.

use kahan_core::nalgebra::SVector;
use kahan_core::prelude::*;
use kahan_core::{ExtendScalars, FloatScalar, ThroughPoles};
use kahan_dynamics::{Need, NoSetting, Scene};

use crate::answers::{Answers, NUMBER, RATE, SPEED, TIME, check_units};
use crate::fields::{CASES, Case, Unit, map, two_to};
use crate::{SHORT_UNITS, UNITS};

struct Subject<'a, M, T, const N: usize> {
    case: &'a Case,
    unit: Unit,
    map: &'a M,
    to: fn(f64) -> T,
}

impl<M: ExtendScalars<T, N>, T: FloatScalar + Pivot, const N: usize> Subject<'_, M, T, N> {
    fn start(&self) -> SVector<T, N> {
        SVector::from_fn(|i, _| (self.to)(self.unit.length(self.case.start[i])))
    }

    fn eps(&self) -> T {
        (self.to)(self.unit.time(self.case.eps))
    }

    fn orbits(&self, answers: &mut Answers) {
        const STEPS: usize = 20;
        let orbit = || self.map.orbit(self.start(), self.eps());
        let mut add = |name, last: Option<SVector<T, N>>| {
            answers.add_point(name, &last.expect("orbits over floats have no end"));
        };
        add("orbit", orbit().nth(STEPS));
        add("compensated orbit", orbit().compensated().nth(STEPS));
        for composition in Composition::BEST {
            add("composed orbit", orbit().composed(composition).nth(STEPS));
            add("both", orbit().composed(composition).compensated().nth(STEPS));
        }
        add("error", orbit().with_error_estimate().nth(STEPS).map(|estimated| estimated.error));
    }

    fn objects(&self, answers: &mut Answers) {
        let (x, at) = (self.start(), self.map.at(self.eps()));
        let next = at.step(&x);
        answers.add("Jacobian", NUMBER, at.jacobian(&x).as_slice());
        answers.add("determinant", NUMBER, &[self.map.det_matrix(&x, self.eps())]);
        answers.add("slopes", RATE, self.map.field_jacobian(&x).as_slice());
        answers.add("field", SPEED, self.map.field(&x).as_slice());
        answers.add("polarized field", SPEED, self.map.polarized(&x, &next).as_slice());
        answers.add_point("local error", &at.local_error(&x));
        answers.add_point("back", &self.map.step_back(&next, self.eps()));
        // In other units `try_step` may round differently, so only its success is compared.
        answers.say("promise", at.try_step(&x).is_ok());
    }

    fn through_poles(&self, answers: &mut Answers)
    where
        T: ThroughPoles,
    {
        for point in self.map.orbit(self.start(), self.eps()).projective().take(20) {
            match point.affine() {
                Some(x) => answers.add_point("projective orbit", &x),
                None => answers.say("projective orbit", "infinity"),
            }
        }
    }
}

impl<M: ExtendScalars<f64, N>, const N: usize> Subject<'_, M, f64, N> {
    fn scenes(&self, answers: &mut Answers) {
        let scenes = [
            (Need::Trajectory, 20.0, 1e-6),
            (Need::Trajectory, 4.0, 1e-13),
            (Need::Integrals, 100.0, 1e-12),
            (Need::Integrals, 100.0, 1e-40),
        ];
        for (need, horizon, tolerance) in scenes {
            let scene = Scene::new(self.unit.time(horizon * self.case.eps), need, tolerance);
            match scene.choose(self.map, &self.start()) {
                Ok(setting) => {
                    answers.say("scheme", (setting.scheme(), setting.steps()));
                    answers.add("eps", TIME, &[setting.eps()]);
                    answers.add("error", NUMBER, &[setting.error()]);
                    answers.add_point("last point", &setting.run(self.map, self.start()));
                }
                Err(NoSetting::Lost { time } | NoSetting::TooLong { time }) => {
                    answers.add("none", TIME, &[time]);
                }
                Err(why) => answers.say("none", why),
            }
        }
    }
}

macro_rules! over_points {
    ($case:expr, $map:expr, $scalar:ty, |$points:ident| $body:expr) => {
        over_points!($case, $map, $scalar, |$points| $body; 1 2 3 4 5 6 8 10)
    };
    ($case:expr, $map:expr, $scalar:ty, |$points:ident| $body:expr; $($n:literal)*) => {
        match $case.start.len() {
            $($n => {
                let $points = &$map.as_kahan_map::<$scalar, $n>().expect("as many variables");
                $body
            })*
            n => unreachable!("{n} variables"),
        }
    };
}

#[test]
fn orbits_of_points_have_the_same_bits_in_every_unit() {
    for case in &CASES {
        let field = case.field();
        check_units(case.name, &UNITS, |unit, answers| {
            over_points!(case, map(&field, unit), f64, |map| {
                let subject = Subject { case, unit, map, to: |x| x };
                subject.orbits(answers);
                subject.objects(answers);
                subject.through_poles(answers);
            });
        });
    }
}

#[test]
fn scenes_are_chosen_for_in_the_same_way_in_every_unit() {
    for case in &CASES {
        let field = case.field();
        let units =
            [&UNITS[..2], &UNITS[4..], &[[0, 40], [0, -40]].map(|[length, time]| Unit { length, time })]
                .concat();
        let units = if case.start.len() > 4 { &units[2..3] } else { &units };
        check_units(case.name, units, |unit, answers| {
            over_points!(case, map(&field, unit), f64, |map| {
                Subject { case, unit, map, to: |x| x }.scenes(answers);
            });
        });
    }
}

kahan! {
    struct Predators { q, nu }
    xdot = nu*x*(1 - q*y);
    ydot = nu*y*(q*x - 1);
}

kahan! {
    struct Roessler { q, nu }
    xdot = nu*(-y - z);
    ydot = nu*(x + 0.2*y);
    zdot = nu*(0.2/q + z*(q*x - 5.7));
}

kahan! {
    struct E6 { q, nu }
    xdot = nu*q*y*(2*z - x);
    ydot = nu*q*(x^2 - z^2);
    zdot = nu*q*y*(z - 2*x);
}

fn check_compiled<M, T, const N: usize>(name: &str, units: &[Unit], to: fn(f64) -> T, map: impl Fn(T, T) -> M)
where
    M: ExtendScalars<T, N>,
    T: FloatScalar + ThroughPoles,
{
    let case = CASES.iter().find(|case| case.name == name).expect("a case");
    check_units(name, units, |unit, answers| {
        let map = &map(to(two_to(unit.length)), to(two_to(unit.time)));
        let subject = Subject { case, unit, map, to };
        subject.orbits(answers);
        subject.objects(answers);
        subject.through_poles(answers);
    });
}

#[test]
fn compiled_maps_have_the_same_bits_in_every_unit() {
    let double = |x: f64| x;
    let single = |x: f64| x as f32;
    check_compiled("predators", &UNITS, double, |q, nu| Predators { q, nu });
    check_compiled("predators", &SHORT_UNITS, single, |q, nu| Predators { q, nu });
    check_compiled("predators", &UNITS, Dd::from, |q, nu| Predators { q, nu });
    check_compiled("roessler", &UNITS, double, |q, nu| Roessler { q, nu });
    check_compiled("roessler", &UNITS, Dd::from, |q, nu| Roessler { q, nu });
    check_compiled("e6", &UNITS, double, |q, nu| E6 { q, nu });
    check_compiled("e6", &SHORT_UNITS, single, |q, nu| E6 { q, nu });
    check_compiled("e6", &UNITS, Dd::from, |q, nu| E6 { q, nu });
}

#[test]
fn ensembles_have_the_same_bits_in_every_unit() {
    check_units("roessler", &UNITS, |unit, answers| {
        let map = Roessler { q: two_to(unit.length), nu: two_to(unit.time) };
        let start = |k: usize| vector![1.0 + 0.01 * k as f64, -2.0, 0.3].map(|x| unit.length(x));
        let mut many = Ensemble::new((0..50).map(start).collect());
        many.advance(&map.at(unit.time(0.02)), 100);
        many.points().for_each(|point| answers.add_point("point", &point));
    });
}
