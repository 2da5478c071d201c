//! Compares orbits of machine code with those of compiled Rust code and of the interpreter.

use core::array::from_fn;
use core::ops::ControlFlow;

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Composition, Dd, ExtendScalars, FloatScalar, KahanMap, ThroughF64};
use kahan_dynamics::{Precision, Scheme};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};

use crate::interpreted::round;
use crate::{End, Field, Follow, Map};

use super::{MapAt, RuntimeFloat};

fn q(text: &str) -> Rational {
    Rational::parse(text).expect("a number")
}

fn same(a: &[Dd], b: &[Dd]) -> bool {
    let bits = |x: &Dd| (x.high().to_bits(), x.low().to_bits());
    a.iter().zip(b).all(|(a, b)| (a.is_nan() && b.is_nan()) || bits(a) == bits(b))
}

trait Steps {
    fn advance(&mut self, steps: u64);
    fn point(&self, point: &mut [Dd]);
}

struct At<O, T, const N: usize> {
    orbit: O,
    point: SVector<T, N>,
}

impl<O, T, const N: usize> Steps for At<O, T, N>
where
    O: Iterator<Item = SVector<T, N>>,
    T: FloatScalar,
    Dd: From<T>,
{
    fn advance(&mut self, steps: u64) {
        if let Some(further) = steps.checked_sub(1)
            && let Some(point) = self.orbit.nth(usize::try_from(further).unwrap_or(usize::MAX))
        {
            self.point = point;
        }
    }

    fn point(&self, point: &mut [Dd]) {
        point.iter_mut().zip(self.point.iter()).for_each(|(x, entry)| *x = Dd::from(*entry));
    }
}

struct Read<T: RuntimeFloat> {
    at: MapAt<T>,
    x: Vec<T>,
    carry: Option<Vec<T>>,
}

impl<T: RuntimeFloat> Steps for Read<T>
where
    Dd: From<T>,
{
    fn advance(&mut self, steps: u64) {
        let Read { at, x, carry } = self;
        match carry {
            Some(carry) => at.advance_with_carry(x, carry, steps),
            None => at.advance(x, steps),
        }
        .expect("a number a variable");
    }

    fn point(&self, point: &mut [Dd]) {
        point.iter_mut().zip(&self.x).for_each(|(x, entry)| *x = Dd::from(*entry));
    }
}

/// Returns the orbit of a map by machine code where available, and the interpreted orbit.
fn read(map: &Map, scheme: Scheme, eps: &Rational, start: &[Rational]) -> [Box<dyn Steps>; 2] {
    fn both<T: RuntimeFloat>(at: MapAt<T>, scheme: Scheme, x: Vec<T>) -> [Box<dyn Steps>; 2]
    where
        Dd: From<T>,
    {
        let at = at.composed(scheme.composition);
        let carry = scheme.compensated.then(|| vec![T::zero(); x.len()]);
        let interpreted = MapAt { coded: None, ..at.clone() };
        [at, interpreted]
            .map(|at| Box::new(Read { at, x: x.clone(), carry: carry.clone() }) as Box<dyn Steps>)
    }
    match scheme.precision {
        Precision::Single => both::<f32>(map.at(round(eps)), scheme, start.iter().map(round).collect()),
        Precision::SingleThroughDouble => {
            let x = start.iter().map(|x| f64::from(round::<f32>(x))).collect();
            both(map.through_f64(round(eps)), scheme, x)
        }
        Precision::Double => both::<f64>(map.at(round(eps)), scheme, start.iter().map(round).collect()),
        Precision::DoubleDouble => both::<Dd>(map.at(round(eps)), scheme, start.iter().map(round).collect()),
    }
}

/// Returns the orbit of a map in the precision of `scheme`. Coordinates that `start` lacks are 0.
fn of_map<M, const N: usize>(exact: &M, scheme: Scheme, eps: &Rational, start: &[Rational]) -> Box<dyn Steps>
where
    M: ExtendScalars<BigRational, N, Extended<f32>: 'static, Extended<f64>: 'static, Extended<Dd>: 'static>,
{
    match scheme.precision {
        Precision::Single => in_scheme(&exact.extend_scalars(number::<f32>), scheme, eps, start),
        Precision::SingleThroughDouble => {
            in_scheme(&ThroughF64(exact.extend_scalars(number::<f32>)), scheme, eps, start)
        }
        Precision::Double => in_scheme(&exact.extend_scalars(number::<f64>), scheme, eps, start),
        Precision::DoubleDouble => in_scheme(&exact.extend_scalars(number::<Dd>), scheme, eps, start),
    }
}

fn number<T: FloatScalar>(value: &BigRational) -> T {
    round(&value.clone().into())
}

fn in_scheme<M, T, const N: usize>(
    map: &M,
    scheme: Scheme,
    eps: &Rational,
    start: &[Rational],
) -> Box<dyn Steps>
where
    M: KahanMap<T, N> + 'static,
    T: FloatScalar,
    Dd: From<T>,
{
    let point = SVector::from_fn(|i, _| start.get(i).map_or_else(T::zero, round));
    let orbit = map.orbit(point, round(eps));
    match (scheme.order(), scheme.compensated) {
        (2, false) => at(orbit, point),
        (2, true) => at(orbit.compensated(), point),
        (_, false) => at(orbit.composed(scheme.composition), point),
        (_, true) => at(orbit.composed(scheme.composition).compensated(), point),
    }
}

fn at<O, T, const N: usize>(mut orbit: O, point: SVector<T, N>) -> Box<dyn Steps>
where
    O: Iterator<Item = SVector<T, N>> + 'static,
    T: FloatScalar,
    Dd: From<T>,
{
    orbit.next();
    Box::new(At { orbit, point })
}

/// Compares all schemes at five ε, including 0, from two of four points each.
fn agree<M, const N: usize>(command: &str, parameters: &[&str], exact: &M)
where
    M: ExtendScalars<BigRational, N, Extended<f32>: 'static, Extended<f64>: 'static, Extended<Dd>: 'static>,
{
    let text = kahan_systems::registry::find(command).expect("in the catalog").text();
    let system = kahan_algebra::read(&kahan_algebra::lexer::lex(text).tokens).system().expect("a system");
    let parameters: Vec<Rational> = parameters.iter().map(|value| q(value)).collect();
    let field = Field::of(&system);
    let names = field.parameters().to_vec();
    let map = field.with(names.iter().zip(&parameters)).expect("a map");
    let starts = [["3/7", "-0.4", "1.1"], ["0", "1", "0"], ["12.3", "1e-3", "-7"], ["1e200", "1", "-1e160"]];
    for (k, eps) in ["0.05", "-1/3", "1e-30", "1e30", "0"].into_iter().enumerate() {
        for start in starts.iter().cycle().skip(k).take(2) {
            let (eps, start): (Rational, Vec<Rational>) = (q(eps), start[..N].iter().map(|x| q(x)).collect());
            for scheme in Scheme::all() {
                let mut orbits = read(&map, scheme, &eps, &start);
                let mut compiled = of_map(exact, scheme, &eps, &start);
                let [mut found, mut expected] = [vec![Dd::default(); N], vec![Dd::default(); N]];
                for steps in [0, 1, 2, 40, 0, 1] {
                    compiled.advance(steps);
                    compiled.point(&mut expected);
                    for (orbit, what) in orbits.iter_mut().zip(["code", "interpreted"]) {
                        orbit.advance(steps);
                        orbit.point(&mut found);
                        assert!(
                            same(&found, &expected),
                            "{command}, {scheme}, {what}, eps {eps}, {start:?}: {found:?}, not {expected:?}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn the_catalog_by_code_is_the_catalog_compiled() {
    let big = |text: &str| q(text).to_big();
    agree("euler", &["1/3", "-1.7", "2"], &EulerTop { a1: big("1/3"), a2: big("-1.7"), a3: big("2") });
    agree::<_, 2>("lv", &[], &LotkaVolterra);
    agree::<_, 3>("e1", &[], &E1);
    agree::<_, 3>("e2", &[], &E2);
    agree::<_, 3>("e3", &[], &E3);
    agree::<_, 3>("e4", &[], &E4);
    agree::<_, 3>("e5", &[], &E5);
    agree::<_, 3>("e6", &[], &E6);
    agree("e7", &["19/17"], &E7 { xi: big("19/17") });
    agree::<_, 3>("e8", &[], &E8);
    agree("e9", &["0.1"], &E9 { xi: big("0.1") });
}

#[test]
fn sums_at_the_end_of_the_range_are_those_of_the_interpreter() {
    let map = Field::parse("xdot = y; ydot = 0;").expect("a field").map().expect("no parameters");
    let exact = |value: f64| Rational::from_f64(value).expect("finite");
    let half = 2_f64.powi(969);
    for share in [0.5, 1.0, 1.0 + f64::EPSILON, 1.5] {
        let start = [&exact(f64::MAX) + &exact(half), exact(half * share)];
        for scheme in Scheme::all().filter(|scheme| scheme.precision == Precision::DoubleDouble) {
            let [found, expected] = read(&map, scheme, &q("1/2"), &start).map(|mut orbit| {
                let mut point = vec![Dd::default(); 2];
                orbit.advance(1);
                orbit.point(&mut point);
                point
            });
            assert!(same(&found, &expected), "{scheme}: {found:?}, not {expected:?}");
        }
    }
}

#[test]
fn an_orbit_ends_after_its_last_finite_point() {
    let end_of = |text: &str, eps: f64, scheme: Scheme| {
        let map = Field::parse(text).expect("a field").map().expect("no parameters");
        let at = map.at(Dd::from(eps)).composed(scheme.composition);
        let (mut x, mut stepped) = ([Dd::from(1.0)], [Dd::from(1.0)]);
        let followed = at.follow(&mut x, 5000, |_| ControlFlow::Continue(())).expect("one variable");
        let End::Range(steps) = followed.end else { panic!("{text}, {scheme}: {:?}", followed.end) };
        (0..steps).for_each(|_| at.advance(&mut stepped, 1).expect("one variable"));
        assert!(same(&x, &stepped), "{text}, {scheme}: {x:?}");
        at.advance(&mut stepped, 1).expect("one variable");
        assert!(!stepped[0].is_finite(), "{text}, {scheme}: {stepped:?}");
        (steps, at.divides_by_zero(&x).expect("one variable"))
    };
    for scheme in Scheme::all().filter(|scheme| scheme.precision == Precision::DoubleDouble) {
        let (steps, is_pole) = end_of("xdot = 1000*x;", 1.0 / 2000.0, scheme);
        assert!(steps > 0 && !is_pole, "{scheme}: {steps}");
        if scheme.order() == 2 {
            // With ε = 1/4, the step x/(1 − 2εx) of x' = x² takes 1 to 2, and has a pole at 2.
            assert_eq!(end_of("xdot = x^2;", 0.25, scheme), (1, true), "{scheme}");
        }
    }
}

#[test]
fn columns_through_f64_are_rounded_as_single_orbits_are() {
    let lorenz = Field::parse("xdot = 10*(y - x); ydot = x*(28 - z) - y; zdot = x*y - 8/3*z;");
    let map = lorenz.expect("a field").map().expect("no parameters");
    for composition in Composition::BEST {
        let at = map.through_f64(0.0125).composed(composition);
        let start: [[f64; 9]; 3] = from_fn(|i| from_fn(|k| f64::from((i as f32 + 0.1) * (k as f32 - 3.7))));
        let mut columns = start;
        let mut slices = columns.each_mut().map(|column| &mut column[..]);
        at.follow_columns(&mut slices, &[], &[], 50).expect("a column a variable");
        for k in 0..9 {
            let mut x = start.map(|column| column[k]);
            at.advance(&mut x, 50).expect("a number a variable");
            assert_eq!(x, columns.map(|column| column[k]), "{composition:?}");
            assert_eq!(x, x.map(|x| f64::from(x as f32)), "{composition:?}");
        }
    }
}

fn below(end: u64, random: &mut SplitMix64) -> u64 {
    random.next_u64() % end
}

/// Returns a random field of n variables, in which x1 stays 0 if it begins there. Each product of
/// two variables occurs with a probability of `percent` %. Coefficients are multiples of `unit`;
/// constant terms are multiples of `unit`·`p`, where `p` is a number or the parameter p.
fn dense(n: usize, percent: u64, [unit, p]: [&str; 2], random: &mut SplitMix64) -> Field {
    let coefficient = |random: &mut SplitMix64| format!("{}*{unit}", below(255, random) as i64 - 127);
    let component = |i: usize| {
        if i == 1 {
            return "x1dot = x0*x1;".to_owned();
        }
        let mut terms = vec![format!("{}*{p}", coefficient(random))];
        for j in 0..n {
            terms.push(format!("{}*x{j}", coefficient(random)));
            for k in j..n {
                if below(100, random) < percent {
                    terms.push(format!("{}*x{j}*x{k}", coefficient(random)));
                }
            }
        }
        format!("x{i}dot = {};", terms.join(" + ").replace("+ -", "- "))
    };
    Field::parse(&(0..n).map(component).collect::<String>()).expect("a field")
}

#[test]
fn loops_of_dense_fields_have_the_bits_of_the_interpreter() {
    fn agree<T: RuntimeFloat>(at: &MapAt<T>, start: &[T], steps: u64)
    where
        Dd: From<T>,
    {
        let interpreted = MapAt { coded: None, ..at.clone() };
        let [mut x, mut y] = [start.to_vec(), start.to_vec()];
        at.advance(&mut x, steps).expect("a state");
        interpreted.advance(&mut y, steps).expect("a state");
        let words = |state: &[T]| -> Vec<Dd> { state.iter().map(|x| Dd::from(*x)).collect() };
        assert!(same(&words(&x), &words(&y)), "{x:?} {y:?}");

        let [mut carry, mut other] = [vec![T::zero(); start.len()], vec![T::zero(); start.len()]];
        let [mut x, mut y] = [start.to_vec(), start.to_vec()];
        at.advance_with_carry(&mut x, &mut carry, steps).expect("a state");
        interpreted.advance_with_carry(&mut y, &mut other, steps).expect("a state");
        assert!(same(&words(&x), &words(&y)) && same(&words(&carry), &words(&other)), "{x:?} {y:?}");
    }
    let mut random = SplitMix64::new(55);
    let long = ["0.0156250000000000017", "0.7312345678901234567"];
    for (n, percent, numbers) in [
        (10, 100, ["1/64", "p"]),
        (11, 60, ["1/64", "p"]),
        (17, 25, ["1/64", "p"]),
        (10, 70, long),
        (10, 70, ["1/64", "1"]),
    ] {
        let field = dense(n, percent, numbers, &mut random);
        let map = if numbers[1] == "p" { field.with([("p", 0.75)]) } else { field.map() };
        let map = map.expect("its parameter");
        let number = |random: &mut SplitMix64| (below(2001, random) as f64 - 1000.0) / 1024.0;
        for eps in [1e-3, 0.05, 0.7, 30.0] {
            let mut start: Vec<f64> = (0..n).map(|_| number(&mut random)).collect();
            let at = map.at(eps);
            assert!(at.coded.is_some());
            agree(&at, &start, 20);
            agree(&at.composed(Composition::SUZUKI_4), &start, 5);
            agree(&map.through_f64(eps as f32), &start, 5);
            let single: Vec<f32> = start.iter().map(|x| *x as f32).collect();
            agree(&map.at(eps as f32), &single, 20);
            [start[0], start[1]] = [0.0, -0.0];
            agree(&at, &start, 3);
            start[2] = 1e200;
            agree(&at, &start, 3);
            start[2] = f64::INFINITY;
            agree(&at, &start, 2);
        }
    }
}

#[test]
fn columns_of_eliminated_fields_are_their_orbits() {
    let mut random = SplitMix64::new(6);
    for (n, percent) in [(6, 100), (9, 60), (12, 4), (10, 100), (15, 40)] {
        let field = dense(n, percent, ["1/64", "p"], &mut random);
        let map = field.with([("p", 0.75)]).expect("its parameter");
        let number = |random: &mut SplitMix64| (below(2001, random) as f64 - 1000.0) / 1024.0;
        for eps in [0.01, 30.0] {
            let at = map.at(eps);
            let mut columns: Vec<Vec<f64>> =
                (0..n).map(|_| (0..11).map(|_| number(&mut random)).collect()).collect();
            columns[0][3] = 1e200;
            columns[0][4] = f64::NAN;
            let start = columns.clone();
            let own_eps: Vec<f64> = (0..11).map(|k| eps * (1.0 + f64::from(k))).collect();
            let own: Vec<f64> = (0..11).map(|k| 0.5 + f64::from(k)).collect();
            for (eps_of, own) in [(&[][..], &[][..]), (&own_eps, &own)] {
                let mut columns = start.clone();
                let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
                let parameters: &[&[f64]] = if own.is_empty() { &[] } else { &[own] };
                at.advance_columns(&mut slices, eps_of, parameters, 70).expect("a column a variable");
                for k in 0..11 {
                    let map =
                        field.with([("p", own.get(k).copied().unwrap_or(0.75))]).expect("its parameter");
                    let alone = map.at(eps_of.get(k).copied().unwrap_or(eps));
                    let interpreted = MapAt { coded: None, ..alone };
                    let mut x: Vec<f64> = start.iter().map(|column| column[k]).collect();
                    interpreted.advance(&mut x, 70).expect("a number a variable");
                    let found: Vec<Dd> = columns.iter().map(|column| Dd::from(column[k])).collect();
                    let expected: Vec<Dd> = x.into_iter().map(Dd::from).collect();
                    assert!(same(&found, &expected), "{n} {eps} {k}: {found:?}, not {expected:?}");
                }
            }
        }
    }
}

fn lattice(side: usize) -> Field {
    let site = |i: usize, j: usize| (i < side && j < side).then(|| format!("x{}", i * side + j));
    let equation = |i: usize, j: usize| {
        let beside = [site(i.wrapping_sub(1), j), site(i + 1, j), site(i, j.wrapping_sub(1)), site(i, j + 1)];
        let beside: Vec<String> = beside.into_iter().flatten().collect();
        let (x, count, sum) = (site(i, j).expect("a site"), beside.len(), beside.join(" + "));
        format!("{x}dot = {x} - {x}^2 + 3/10*({sum} - {count}*{x});")
    };
    let equations = (0..side * side).map(|site| equation(site / side, site % side));
    Field::parse(&equations.collect::<String>()).expect("a field")
}

#[test]
fn steps_of_large_lattices_are_those_in_double_double() {
    let map = lattice(28).map().expect("no parameters");
    let n = 28 * 28;
    let start: Vec<f64> = (0..n).map(|i| 0.1 + f64::from(i * i % 17) / 32.0).collect();
    let single: Vec<f32> = start.iter().map(|x| *x as f32).collect();
    for eps in [1e-12, 0.01, 0.1] {
        let [at, back] = [eps, -eps].map(|eps| map.at(eps));
        let mut expected: Vec<Dd> = start.iter().copied().map(Dd::from).collect();
        map.at(Dd::from(eps)).advance(&mut expected, 3).expect("a number a variable");
        let distance = |x: Dd, y: Dd| (x - y).high().abs();
        let mut x = start.clone();
        at.advance(&mut x, 3).expect("a number a variable");
        for (x, expected) in x.iter().zip(&expected) {
            assert!(distance(Dd::from(*x), *expected) <= 16.0 * f64::EPSILON, "{eps}: {x}, not {expected:?}");
        }
        let mut columns: Vec<Vec<f64>> = start.iter().map(|x| vec![*x; 3]).collect();
        let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        at.advance_columns(&mut slices, &[], &[], 3).expect("a column a variable");
        assert!(columns.iter().zip(&x).all(|(column, x)| column.iter().all(|other| other == x)));
        back.advance(&mut x, 3).expect("a number a variable");
        assert!(x.iter().zip(&start).all(|(x, start)| (x - start).abs() <= 32.0 * f64::EPSILON), "{eps}");
        let mut x = single.clone();
        map.at(eps as f32).advance(&mut x, 3).expect("a number a variable");
        for (x, expected) in x.iter().zip(&expected) {
            let distance = distance(Dd::from(*x), *expected);
            assert!(distance <= 16.0 * f64::from(f32::EPSILON), "{eps}: {x}, not {expected:?}");
        }
    }
}

fn ten_million_steps(of: impl FnOnce(MapAt<f64>) -> MapAt<f64>) {
    let text = kahan_systems::registry::find("e3").expect("in the catalog").text();
    let map = Field::parse(text).expect("a field").with::<&str, f64>([]).expect("it has no parameters");
    let (mut x, at) = ([1.0, 2.0, 3.0], of(map.at(0.01)));
    at.advance(&mut x, 10_000_000).expect("three variables");
    assert!(x.iter().all(|x| x.is_finite()), "{x:?}");
}

#[test]
#[ignore = "`arm/steps` reads how long it takes"]
fn ten_million_steps_in_code() {
    ten_million_steps(|at| {
        assert!(at.is_code());
        at
    });
}

#[test]
#[ignore = "`arm/steps` reads how long it takes"]
fn ten_million_interpreted_steps() {
    ten_million_steps(|at| MapAt { coded: None, ..at });
}
