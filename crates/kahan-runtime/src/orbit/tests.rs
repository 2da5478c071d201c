//! Orbits by code against those of the macro's maps and of the interpreter, in every scheme.

use kahan_algebra::rational::Rational;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, ExtendScalars, FloatScalar, KahanMap, Precision, Scheme, ThroughF64};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};

use crate::Field;
use crate::interpreted::round;

use super::{Asked, End};

fn q(text: &str) -> Rational {
    Rational::parse(text).expect("a number")
}

fn same(a: &[Dd], b: &[Dd]) -> bool {
    let bits = |x: &Dd| (x.high().to_bits(), x.low().to_bits());
    a.iter().zip(b).all(|(a, b)| (a.is_nan() && b.is_nan()) || bits(a) == bits(b))
}

/// An orbit that is at some point.
trait Steps {
    /// So many steps further.
    fn advance(&mut self, steps: u64);
    /// The coordinates of the point.
    fn point(&self, point: &mut [Dd]);
}

/// An iterator over points, and the one that it is at.
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
            // Orbits over floats have no end.
            && let Some(point) = self.orbit.nth(usize::try_from(further).unwrap_or(usize::MAX))
        {
            self.point = point;
        }
    }

    fn point(&self, point: &mut [Dd]) {
        point.iter_mut().zip(self.point.iter()).for_each(|(x, entry)| *x = Dd::from(*entry));
    }
}

/// The orbit of any map over ℚ in a scheme, at its first point. Coordinates that lack are 0.
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

/// An orbit after its first point.
fn at<O, T, const N: usize>(mut orbit: O, point: SVector<T, N>) -> Box<dyn Steps>
where
    O: Iterator<Item = SVector<T, N>> + 'static,
    T: FloatScalar,
    Dd: From<T>,
{
    orbit.next();
    Box::new(At { orbit, point })
}

/// Every scheme from several points and ε, ordinary ones, one beyond those that are divided by, and
/// 0.
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
    for eps in ["0.05", "-1/3", "1e-30", "1e30", "0"] {
        for start in &starts {
            let (eps, start): (Rational, Vec<Rational>) = (q(eps), start[..N].iter().map(|x| q(x)).collect());
            for scheme in Scheme::all() {
                let mut orbit = map.orbit(scheme, &eps, &start).expect("a coordinate a variable");
                let mut interpreted = Asked { map: &map, scheme, eps: &eps, start: &start }.begin().0;
                let mut found = vec![Dd::default(); N];
                let mut compiled = of_map(exact, scheme, &eps, &start);
                let mut expected = vec![Dd::default(); N];
                for steps in [0, 1, 2, 40, 0, 1] {
                    orbit.advance(steps);
                    compiled.advance(steps);
                    compiled.point(&mut expected);
                    interpreted.advance(steps);
                    interpreted.point(&mut found);
                    assert!(same(&found, &expected), "{command}, {scheme}, eps {eps}, {start:?}: {found:?}");
                    assert!(
                        same(orbit.point(), &expected),
                        "{command}, {scheme}, eps {eps}, {start:?}: {:?}, not {expected:?}",
                        orbit.point()
                    );
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

/// A sum that rounds to the largest float goes beyond it with its lower parts: code sees it, too.
#[test]
fn sums_at_the_end_of_the_range_are_those_of_the_interpreter() {
    let map = Field::parse("xdot = y; ydot = 0;").expect("a field").map().expect("no parameters");
    let exact = |value: f64| Rational::from_f64(value).expect("finite");
    let half = 2_f64.powi(969);
    // Half a unit of the largest float, in two parts that it does not show by itself.
    for share in [0.5, 1.0, 1.0 + f64::EPSILON, 1.5] {
        let start = [&exact(f64::MAX) + &exact(half), exact(half * share)];
        for scheme in Scheme::all().filter(|scheme| scheme.precision == Precision::DoubleDouble) {
            let eps = q("1/2");
            let mut orbit = map.orbit(scheme, &eps, &start).expect("two variables");
            let mut interpreted = Asked { map: &map, scheme, eps: &eps, start: &start }.begin().0;
            let mut expected = vec![Dd::default(); 2];
            orbit.advance(1);
            interpreted.advance(1);
            interpreted.point(&mut expected);
            assert!(same(orbit.point(), &expected), "{scheme}: {:?}, not {expected:?}", orbit.point());
        }
    }
}

/// The end of an orbit in one stretch is where single steps come to it, in every scheme.
#[test]
fn an_orbit_ends_after_its_last_finite_point() {
    let end_of = |text: &str, eps: &str, scheme: Scheme| {
        let map = Field::parse(text).expect("a field").map().expect("no parameters");
        let begin = || map.orbit(scheme, &q(eps), &[q("1")]).expect("one variable");
        let (mut orbit, mut stepped) = (begin(), begin());
        let end = orbit.advance_while_finite(5000).expect_err("it ends");
        (0..end.steps).for_each(|_| stepped.advance(1));
        assert!(same(orbit.point(), stepped.point()), "{text}, {scheme}: {:?}", orbit.point());
        stepped.advance(1);
        assert!(!stepped.is_finite(), "{text}, {scheme}: {:?}", stepped.point());
        end
    };
    for scheme in Scheme::all() {
        let end = end_of("xdot = 1000*x;", "1/2000", scheme);
        assert!(end.steps > 0 && !end.is_pole, "{scheme}: {end:?}");
        if scheme.order() == 2 {
            // A step of x' = x² goes from x to x/(1 - 2εx): from 1 to 2, and from 2 nowhere.
            assert_eq!(end_of("xdot = x^2;", "1/4", scheme), End { steps: 1, is_pole: true }, "{scheme}");
        }
    }
}
