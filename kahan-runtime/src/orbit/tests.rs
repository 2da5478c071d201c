//! Orbits by code against those of the macro's maps and of the interpreter, in every scheme.

use kahan_algebra::rational::Rational;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, Lift, Scheme};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};

use super::interpreted::of_map;
use super::Orbits;

fn q(text: &str) -> Rational {
    Rational::parse(text).expect("a number")
}

fn same(a: &[Dd], b: &[Dd]) -> bool {
    let bits = |x: &Dd| (x.high().to_bits(), x.low().to_bits());
    a.iter().zip(b).all(|(a, b)| (a.is_nan() && b.is_nan()) || bits(a) == bits(b))
}

/// Every scheme from several points and ε, ordinary ones, one beyond those that are divided by, and
/// 0.
fn agree<M, const N: usize>(command: &str, parameters: &[&str], exact: &M)
where
    M: Lift<BigRational, N, Lifted<f32>: 'static, Lifted<f64>: 'static, Lifted<Dd>: 'static>,
{
    let text = kahan_systems::registry::find(command).expect("in the catalog").text();
    let system = kahan_algebra::read(&kahan_algebra::lexer::lex(text).tokens).system;
    let parameters: Vec<Rational> = parameters.iter().map(|value| q(value)).collect();
    let map = Orbits::of(&system, &parameters).expect("a field");
    let starts = [["3/7", "-0.4", "1.1"], ["0", "1", "0"], ["12.3", "1e-3", "-7"], ["1e200", "1", "-1e160"]];
    for eps in ["0.05", "-1/3", "1e-30", "1e30", "0"] {
        for start in &starts {
            let (eps, start): (Rational, Vec<Rational>) = (q(eps), start[..N].iter().map(|x| q(x)).collect());
            for scheme in Scheme::all() {
                let mut orbit = map.begin(scheme, &eps, &start).expect("few variables");
                let mut compiled = of_map(exact, scheme, &eps, &start);
                let mut expected = vec![Dd::default(); N];
                for steps in [0, 1, 2, 40, 0, 1] {
                    orbit.advance(steps);
                    compiled.advance(steps);
                    compiled.point(&mut expected);
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
