//! Exact orbits of rational points under the generated maps.

use kahan_core::prelude::*;
use kahan_systems::special::{Float256, Real};

use crate::solutions::measure::{assert_close_above, ten_to_minus};

pub(crate) type Rational = BigRational;
pub(crate) type Point<T> = SVector<T, 3>;

pub(crate) fn rational(text: &str) -> Rational {
    text.parse().unwrap_or_else(|_| panic!("{text} is not a rational"))
}

/// A case of the reference tables: parameters, ε and an initial point.
pub(crate) struct Case {
    pub(crate) parameters: Vec<Rational>,
    pub(crate) eps: Rational,
    pub(crate) start: Point<Rational>,
}

pub(crate) fn cases(system: &str) -> Vec<Case> {
    let path = format!("{}/../tests/data/{system}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let data: serde_json::Value = serde_json::from_str(&text).expect("the table is JSON");
    let number = |value: &serde_json::Value| rational(value.as_str().expect("a number as text"));
    let names = data["param_names"].as_array().expect("names");
    let read = |case: &serde_json::Value| Case {
        parameters: names.iter().map(|name| number(&case["params"][name.as_str().unwrap()])).collect(),
        eps: number(&case["eps"]),
        start: vector![number(&case["x"][0]), number(&case["x"][1]), number(&case["x"][2])],
    };
    data["cases"].as_array().expect("cases").iter().map(read).collect()
}

/// Returns n and the point for −back ≤ n ≤ forward. In each direction the orbit ends at the first
/// pole.
pub(crate) fn orbit<M, T>(
    map: M,
    start: &Point<T>,
    eps: &T,
    [back, forward]: [i64; 2],
) -> Vec<(i64, Point<T>)>
where
    M: KahanMap<T, 3> + Clone,
    T: Scalar,
{
    let side = |eps: T, count: i64, sign: i64| {
        let points = map.clone().orbit(start.clone(), eps).take(count as usize + 1);
        points.zip(0..).map(move |(point, n)| (sign * n, point)).collect::<Vec<_>>()
    };
    let mut points = side(-eps.clone(), back, -1);
    points.reverse();
    points.pop();
    points.extend(side(eps.clone(), forward, 1));
    points
}

pub(crate) fn precise(point: &Point<Rational>) -> Point<Float256> {
    point.map(|value| Float256::from_rational(&value))
}

pub(crate) fn norm(point: &Point<Float256>) -> Float256 {
    point
        .iter()
        .fold(Float256::from_int(0), |norm, value| if value.abs() > norm { value.abs() } else { norm })
}

/// Asserts that a solution agrees with the exact orbit to `digits` digits of each point's norm, and
/// returns the number of points.
pub(crate) fn assert_on_orbit(
    exact: &[(i64, Point<Rational>)],
    at: impl Fn(i64) -> Point<Float256>,
    digits: i64,
    what: &str,
) -> usize {
    for (n, point) in exact {
        let (value, expected) = (at(*n), precise(point));
        let size = norm(&expected);
        for i in 0..3 {
            // The fixed point 0 has size 0, so a lower bound replaces the size.
            let floor = if size > ten_to_minus(200) { size } else { ten_to_minus(200) };
            assert_close_above(&value[i], &expected[i], digits, &floor, &format!("{what}, n = {n}"));
        }
    }
    exact.len()
}

pub(crate) struct Rounded {
    pub(crate) parameters: Vec<f64>,
    pub(crate) eps: f64,
    pub(crate) start: Point<f64>,
}

pub(crate) fn rounded(case: &Case) -> Rounded {
    let float = |value: &Rational| <f64 as Real>::from_rational(value);
    Rounded {
        parameters: case.parameters.iter().map(float).collect(),
        eps: float(&case.eps),
        start: case.start.map(|value| float(&value)),
    }
}

/// Compares an `f64` solution with 8 backward and 12 forward steps in 256 bits. Returns the largest
/// error in units of 2⁻⁵² · r · (1 + |v|) · max(1, |ε|·`rate`·r). Here r is the norm of the point,
/// v is the `argument` of the solution's functions, and `rate` is the size of the field's
/// coefficients.
pub(crate) fn ulps<M>(
    map: M,
    case: &Rounded,
    rate: f64,
    argument: impl Fn(i64) -> f64,
    at: impl Fn(i64) -> Point<f64>,
) -> f64
where
    M: KahanMap<Float256, 3> + Clone,
{
    let (mut worst, mut compared) = (0.0_f64, 0);
    for (n, expected) in orbit(map, &case.start.map(Float256::from), &Float256::from(case.eps), [8, 12]) {
        if expected.iter().any(|value| !value.is_defined()) {
            continue;
        }
        compared += 1;
        let size = norm(&expected);
        let condition = (1.0 + argument(n).abs()) * (case.eps.abs() * rate * size.to_f64()).max(1.0);
        let error = norm(&(at(n).map(Float256::from) - expected));
        let units = (error / (size * Float256::from(f64::EPSILON * condition))).to_f64();
        worst = if units <= worst {
            worst
        } else if units.is_nan() {
            f64::INFINITY
        } else {
            units
        };
    }
    assert!(compared > 0, "no point of the orbit has a value");
    worst
}
