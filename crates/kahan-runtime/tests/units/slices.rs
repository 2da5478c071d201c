//! Maps over slices in all units: orbits, objects of the map, and reports of observers.

use kahan_core::Composition;
use kahan_core::observe::{
    Direction, Drift, Escape, Extrema, Extremes, FirstCrossings, Fli, Lyapunov, MeanLogDet, Megno, Observer,
    Period, Residence, Rotation, Sali, Section, Spectrum,
};
use kahan_runtime::{Field, IntegralDrift, MachineFloat, MapAt};

use crate::answers::{AREA, Answers, Dimension, LENGTH, NUMBER, RATE, SPEED, check_units};
use crate::fields::{CASES, Case, Unit, map};
use crate::{SHORT_UNITS, UNITS};

struct Subject<'a, T: MachineFloat> {
    case: &'a Case,
    unit: Unit,
    at: MapAt<T>,
    to: fn(f64) -> T,
}

impl<T: MachineFloat + PartialOrd> Subject<'_, T> {
    fn start(&self) -> Vec<T> {
        self.case.start(self.unit).into_iter().map(self.to).collect()
    }

    fn length(&self, ordinary: f64) -> T {
        (self.to)(self.unit.length(ordinary))
    }

    fn orbits(&self, answers: &mut Answers) {
        for composition in Composition::BEST {
            let at = self.at.composed(composition);
            let mut x = self.start();
            at.advance(&mut x, 50).unwrap();
            answers.add("orbit", LENGTH, &x);
            let (mut x, mut carry) = (self.start(), vec![T::zero(); self.case.start.len()]);
            at.advance_with_carry(&mut x, &mut carry, 50).unwrap();
            answers.add("compensated orbit", LENGTH, &[x, carry].concat());
        }
    }

    fn objects(&self, answers: &mut Answers) {
        let (x, n) = (self.start(), self.case.start.len());
        let mut matrix = vec![T::zero(); n * n];
        self.at.jacobian(&x, &mut matrix).unwrap();
        answers.add("Jacobian", NUMBER, &matrix);
        self.at.matrix(&x, &mut matrix).unwrap();
        answers.add("matrix", NUMBER, &matrix);
        self.at.field_jacobian(&x, &mut matrix).unwrap();
        answers.add("slopes", RATE, &matrix);
        let mut speed = vec![T::zero(); n];
        self.at.field(&x, &mut speed).unwrap();
        answers.add("field", SPEED, &speed);
    }

    fn tangents(&self, answers: &mut Answers) {
        let vectors = (
            Spectrum::new(&self.at, self.case.start.len(), 5),
            Lyapunov::new(&self.at),
            MeanLogDet::new(&self.at),
            Fli::new(&self.at),
            Megno::new(&self.at),
            Sali::new(&self.at),
        );
        let (spectrum, lyapunov, log_det, fli, megno, sali) = self.observe(vectors);
        let exponents =
            spectrum.iter().chain([&lyapunov]).flat_map(|exponent| [exponent.value, exponent.error]);
        answers.add("exponents", RATE, &exponents.chain([log_det]).collect::<Vec<_>>());
        answers.add("indicators", NUMBER, &[fli, megno.mean, megno.last, sali]);
    }

    fn places(&self, answers: &mut Answers) {
        let square = |x: &[T]| x.iter().fold(T::zero(), |sum, x| sum + *x * *x);
        let seen = |x: &[T]| [x[0], x[x.len() - 1]];
        let near = self.length(self.case.start[0] + 0.01);
        let is_far = |x: &[T]| x.iter().any(|x| x.approximate().abs() > self.unit.length(1.1));
        let extremes = [[-0.7, 0.5], [-0.2, 0.9]]
            .map(|[least, greatest]| Extremes { least: self.length(least), greatest: self.length(greatest) });
        let places = (
            Drift::of(|x: &[T]| [square(x)]),
            Extrema::of(square),
            Escape::when(is_far),
            Residence::of(|x: &[T]| x[0], self.unit.length(0.1)..self.unit.length(1.7), [0; 5]),
            Period::within(self.length(0.1), self.start()),
            Rotation::of(STEPS, seen),
            Rotation::between(STEPS, seen, extremes),
            Section::new(&self.at, |x: &[T]| x[0] - near, Direction::Both, FirstCrossings::new(20)),
        );
        let ([drift], extrema, escape, stays, back, turns, between, crossings) = self.observe(places);
        answers.add("drift", NUMBER, &[drift.max, drift.last]);
        let extrema = extrema.expect("numbers");
        answers.add("extrema", AREA, &[extrema.least, extrema.greatest]);
        answers.say("steps", (escape, stays, back.map(|back| back.step)));
        answers.add("distance", AREA, back.map(|back| back.squared_distance).as_slice());
        answers.add("rotation", NUMBER, &[turns.value, turns.error, between.value, between.error]);
        answers.say("jumps", crossings.jumps);
        for crossing in &crossings.points.kept {
            answers.say("crossing", crossing.step);
            answers.add("part", NUMBER, &[crossing.part]);
            answers.add("crossing", LENGTH, &crossing.point);
        }
    }

    fn observe<O: Observer<T>>(&self, mut observers: O) -> O::Report {
        let mut x = self.start();
        for step in 0..=STEPS {
            observers.observe(step, &x);
            self.at.advance(&mut x, 1).unwrap();
        }
        observers.report()
    }
}

const STEPS: u64 = 60;

fn check<T: MachineFloat + PartialOrd>(case: &Case, field: &Field, units: &[Unit], to: fn(f64) -> T) {
    check_units(case.name, units, |unit, answers| {
        let at = map(field, unit).at(to(unit.time(case.eps)));
        let subject = Subject { case, unit, at, to };
        subject.orbits(answers);
        subject.objects(answers);
        subject.tangents(answers);
        subject.places(answers);
    });
}

#[test]
fn orbits_and_what_observers_say_have_the_same_bits_in_every_unit() {
    for case in &CASES {
        let field = case.field();
        check::<f64>(case, &field, &UNITS, |x| x);
        check::<f32>(case, &field, &SHORT_UNITS, |x| x as f32);
    }
}

#[test]
fn many_orbits_side_by_side_have_the_same_bits_in_every_unit() {
    for case in &CASES {
        let field = case.field();
        check_units(case.name, &UNITS, |unit, answers| {
            let at = map(&field, unit).at(unit.time(case.eps));
            let of = |x: &f64| (0..20).map(|k| x * (1.0 + 0.01 * f64::from(k))).collect();
            let mut columns: Vec<Vec<f64>> = case.start(unit).iter().map(of).collect();
            let mut columns: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
            let size = unit.length(1.1);
            let observers = |_| {
                let beyond = Escape::when(move |x: &[f64]| !x.iter().all(|x| x.abs() <= size));
                let growth = (Fli::new(&at), Megno::new(&at), Lyapunov::new(&at));
                (Sali::new(&at), growth, IntegralDrift::of(&at), beyond)
            };
            let found = MapAt::observe_columns(&[&at], &mut columns, STEPS, observers).unwrap();
            for (sali, (fli, megno, exponent), drifts, escaped) in found {
                let drifts = drifts.iter().flat_map(|drift| [drift.max, drift.last]);
                let numbers = [sali, fli, megno.mean, megno.last].into_iter().chain(drifts);
                answers.add("indicators", NUMBER, &numbers.collect::<Vec<_>>());
                answers.add("exponent", RATE, &[exponent.value, exponent.error]);
                answers.add("escape", NUMBER, &[escaped.map_or(f64::NAN, |step| step as f64)]);
            }
            columns.iter().for_each(|column| answers.add("column", LENGTH, column));
        });
    }
}

#[test]
fn claims_of_degree_m_have_the_same_bits_in_units_up_to_the_mth_part() {
    for case in &CASES {
        let field = case.field();
        let units = [300, -300, 225, -225].map(|length| Unit { length, time: 0 });
        if !field.integrals().is_empty() {
            check_units(case.name, &units, |unit, answers| {
                let mut values = vec![0.0; field.integrals().len()];
                map(&field, unit).at(unit.time(case.eps)).integrals(&case.start(unit), &mut values).unwrap();
                answers.add("integrals", AREA, &values);
            });
        }
        if field.derived().density.is_some() {
            check_units(case.name, &units[2..], |unit, answers| {
                let density = map(&field, unit).at(unit.time(case.eps)).density(&case.start(unit)).unwrap();
                answers.add("density", Dimension { length: -4, time: 0 }, &[density]);
            });
        }
    }
}
