//! Derivatives of orbits with respect to first points, parameters and ε.

use kahan_core::Dd;
use kahan_runtime::{Composition, Field, Map, MapAt, Rational, Sensitivity};

/// A field as text, with the values of its parameters and a first point.
pub(crate) type Case = (String, Vec<(&'static str, f64)>, Vec<f64>);

/// Returns fields whose steps are straight-line programs, and fields whose steps use elimination.
pub(crate) fn fields() -> Vec<Case> {
    let network: String = (0..7)
        .map(|i| {
            let (left, right) = ((i + 6) % 7, (i + 1) % 7);
            format!("x{i}dot = a*x{left}*x{right} - b*x{i} - x{i}*x{right} + c*(x{left} - x{i});")
        })
        .collect();
    vec![
        (
            "xdot = a*x - b*x*y; ydot = c*x*y - d*y;".to_owned(),
            vec![("a", 1.5), ("b", 0.75), ("c", 0.5), ("d", 1.25)],
            vec![1.25, 0.5],
        ),
        (
            "xdot = (y - z)*(x + a)/s; ydot = x*(r - z)/(s + a) - y; zdot = x*y - b*z;".to_owned(),
            vec![("a", 0.25), ("s", 3.0), ("r", 2.0), ("b", 0.625)],
            vec![0.5, -0.25, 0.375],
        ),
        (
            network,
            vec![("a", 0.5), ("b", 0.25), ("c", 0.375)],
            (0..7).map(|i| 0.25 + f64::from(i) / 16.0).collect(),
        ),
    ]
}

fn moved(field: &Field, values: &[(&'static str, f64)], by: Option<&str>, by_how_much: &Rational) -> Map {
    let value = |(name, value): &(&'static str, f64)| {
        let exact = Rational::from_f64(*value).unwrap();
        (*name, if by == Some(*name) { &exact + by_how_much } else { exact })
    };
    field.with(values.iter().map(value)).unwrap()
}

fn end(at: &MapAt<Dd>, start: &[Dd], steps: u64) -> Vec<Dd> {
    let mut x = start.to_vec();
    at.advance(&mut x, steps).unwrap();
    x
}

#[test]
fn derivatives_are_those_of_differences_in_double_double() {
    const STEPS: u64 = 40;
    let (eps, tiny) = (1.0 / 64.0, Rational::new(1, 1 << 40));
    let half = Dd::from(2.0_f64.powi(39));
    for (text, values, start) in fields() {
        let field = Field::parse(&text).unwrap();
        let n = start.len();
        let by: Vec<Sensitivity> = (0..values.len())
            .map(Sensitivity::Parameter)
            .chain([Sensitivity::Epsilon])
            .chain((0..n).map(|_| Sensitivity::Start))
            .collect();
        for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
            let map = field.with(values.iter().copied()).unwrap();
            let at = map.at(eps).composed(composition).sensitivities(&by);
            let mut state = start.clone();
            state.resize(n * (1 + by.len()), 0.0);
            for i in 0..n {
                state[n * (2 + values.len() + i) + i] = 1.0;
            }
            at.advance(&mut state, STEPS).unwrap();
            let wide: Vec<Dd> = start.iter().map(|x| Dd::from(*x)).collect();
            let ends = |sign: f64, k: usize| {
                let shift = &tiny * &Rational::from_f64(sign).unwrap();
                let name = field.parameters().get(k).map(String::as_str);
                let map = moved(&field, &values, name, &shift);
                let small = Dd::from(sign / 2.0_f64.powi(40));
                let eps = if k == values.len() { Dd::from(eps) + small } else { Dd::from(eps) };
                let mut x = wide.clone();
                if k > values.len() {
                    x[k - values.len() - 1] = x[k - values.len() - 1] + small;
                }
                end(&map.at(eps).composed(composition), &x, STEPS)
            };
            for k in 0..by.len() {
                let (above, below) = (ends(1.0, k), ends(-1.0, k));
                let own = &state[n * (1 + k)..n * (2 + k)];
                let expected: Vec<f64> =
                    above.iter().zip(&below).map(|(a, b)| f64::from((*a - *b) * half)).collect();
                let size = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                for (own, expected) in own.iter().zip(&expected) {
                    assert!((own - expected).abs() <= 1e-13 * size, "{text} {k}: {own}, not {expected}");
                }
            }
        }
    }
}
