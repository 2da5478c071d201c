//! Compares the rounding errors of plans with those of the formulas in the text.
//!
//! The formulas are evaluated in 24 runs, which round each operation up or down at random. Let E be
//! the largest error of these runs, but at least half an ulp. The error of a plan must be at most 8
//! E at each point, and at most 2 E in the median over a field's points. Errors of a step are
//! relative to the largest component.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use kahan_algebra::arithmetic::{Arithmetic, Exact, Float64};
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_algebra::read;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;

use super::written::Written;

/// Returns the number of random fields. The environment variable `KAHAN_FIELDS` changes it.
fn fields() -> usize {
    std::env::var("KAHAN_FIELDS")
        .map_or(200, |number| number.parse().expect("KAHAN_FIELDS is a whole number"))
}

const POINTS: usize = 7;
/// The number of runs at each point.
const RUNS: usize = 24;
/// The largest allowed ratio between the errors of a plan and of the formulas as written, at each
/// point.
const EVERYWHERE: f64 = 8.0;
/// The largest allowed median of these ratios over the points of a field.
const IN_THE_MEDIAN: f64 = 2.0;

/// Floats in which every inexact operation is rounded up or down at random.
struct Random {
    draws: RefCell<SplitMix64>,
    literals: RefCell<HashMap<Rational, (f64, f64)>>,
}

impl Random {
    fn seeded(seed: &str) -> Self {
        let draws = RefCell::new(SplitMix64::from_bytes(seed.as_bytes()));
        Random { draws, literals: RefCell::default() }
    }

    /// Returns `nearest` or the next float in the direction of `rest` ≠ 0, at random.
    fn rounded(&self, nearest: f64, rest: f64) -> f64 {
        let other = if rest > 0.0 {
            nearest.next_up()
        } else if rest < 0.0 {
            nearest.next_down()
        } else {
            return nearest;
        };
        if self.draws.borrow_mut().below(2) == 0 { nearest } else { other }
    }
}

impl Arithmetic for Random {
    type Value = f64;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<f64> {
        let mut literals = self.literals.borrow_mut();
        let (nearest, rest) = *literals.entry(value.clone()).or_insert_with(|| value.to_double_double());
        Some(self.rounded(nearest, rest))
    }

    fn add(&self, a: &f64, b: &f64) -> f64 {
        let sum = a + b;
        let part = sum - a;
        self.rounded(sum, (a - (sum - part)) + (b - part))
    }

    fn subtract(&self, a: &f64, b: &f64) -> f64 {
        self.add(a, &-b)
    }

    fn multiply(&self, a: &f64, b: &f64) -> f64 {
        let product = a * b;
        self.rounded(product, a.mul_add(*b, -product))
    }

    fn negate(&self, a: &f64) -> f64 {
        -a
    }

    fn divide(&self, a: &f64, b: &f64) -> Option<f64> {
        let quotient = a / b;
        Some(self.rounded(quotient, (-quotient).mul_add(*b, *a) * b.signum()))
    }

    fn is_zero(&self, a: &f64) -> bool {
        *a == 0.0
    }

    fn is_better_pivot(&self, a: &f64, than: &f64) -> bool {
        a.abs() > than.abs()
    }
}

const OBJECTS: [&str; 5] = ["f", "f'", "A", "b", "step"];

/// Returns the objects at a point, computed from the text. Returns `None` if one is undefined.
fn of_text<A: Arithmetic<Constant = Rational>>(
    written: &Written,
    arithmetic: &A,
    point: &Point<A::Value>,
) -> Option<[Vec<A::Value>; 5]> {
    let n = point.state.len();
    let zero = arithmetic.constant(&Rational::zero())?;
    let one = arithmetic.constant(&Rational::one())?;
    let at_origin = Point { state: vec![zero; n], ..point.clone() };
    let (eps, two_eps) = (&point.eps, arithmetic.add(&point.eps, &point.eps));
    let field = written.field(arithmetic, point)?;
    let slopes = written.field_jacobian(arithmetic, point)?;
    let entry = |i: usize, j: usize| {
        let change = arithmetic.multiply(eps, &slopes[i][j]);
        if i == j { arithmetic.subtract(&one, &change) } else { arithmetic.negate(&change) }
    };
    let matrix: Vec<Vec<A::Value>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
    let constants = written.field(arithmetic, &at_origin)?;
    let linear = written.field_jacobian(arithmetic, &at_origin)?;
    let right = (0..n).map(|i| {
        let product = |j: usize| arithmetic.multiply(&linear[i][j], &point.state[j]);
        let sum = (1..n).fold(product(0), |sum, j| arithmetic.add(&sum, &product(j)));
        let start = arithmetic.add(&point.state[i], &arithmetic.multiply(eps, &sum));
        arithmetic.add(&start, &arithmetic.multiply(&two_eps, &constants[i]))
    });
    let right: Vec<A::Value> = right.collect();
    let gained = eliminated(arithmetic, &matrix, &field)?;
    let next = point.state.iter().zip(&gained);
    let next = next.map(|(x, gained)| arithmetic.add(x, &arithmetic.multiply(&two_eps, gained))).collect();
    Some([field, slopes.concat(), matrix.concat(), right, next])
}

/// Returns M⁻¹v by elimination with partial pivoting.
fn eliminated<A: Arithmetic<Constant = Rational>>(
    arithmetic: &A,
    matrix: &[Vec<A::Value>],
    right: &[A::Value],
) -> Option<Vec<A::Value>> {
    let n = matrix.len();
    let extended =
        matrix.iter().zip(right).map(|(row, entry)| [row.as_slice(), std::slice::from_ref(entry)].concat());
    let mut rows: Vec<Vec<A::Value>> = extended.collect();
    let less = |a: &A::Value, factor: &A::Value, b: &A::Value| {
        arithmetic.subtract(a, &arithmetic.multiply(factor, b))
    };
    for k in 0..n {
        let better = |best: usize, i: usize| {
            if arithmetic.is_better_pivot(&rows[i][k], &rows[best][k]) { i } else { best }
        };
        let pivot = (k + 1..n).fold(k, better);
        rows.swap(k, pivot);
        if arithmetic.is_zero(&rows[k][k]) {
            return None;
        }
        let pivot = rows[k].clone();
        for row in &mut rows[k + 1..] {
            let factor = arithmetic.divide(&row[k], &pivot[k])?;
            for (entry, above) in row.iter_mut().zip(&pivot).skip(k + 1) {
                *entry = less(entry, &factor, above);
            }
        }
    }
    let mut solution: Vec<A::Value> = Vec::new();
    for row in rows.iter().enumerate().rev().map(|(k, row)| &row[k..]) {
        let known = row[1..].iter().zip(solution.iter().rev());
        let rest = known.fold(row[row.len() - 1].clone(), |rest, (entry, x)| less(&rest, entry, x));
        solution.push(arithmetic.divide(&rest, &row[0])?);
    }
    solution.reverse();
    Some(solution)
}

/// An exact number as the sum of a float and a small correction.
type Double = (f64, f64);

fn errors(floats: &[f64], exact: &[Double]) -> Vec<f64> {
    let error = |(float, (high, low)): (&f64, &Double)| {
        let error = ((float - high) - low).abs();
        if error.is_nan() { f64::INFINITY } else { error }
    };
    floats.iter().zip(exact).map(error).collect()
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

/// Returns the error of a planned computation, divided by the largest error in `runs`. Returns
/// `None` if the runs keep fewer than three digits.
fn lost(ours: Option<&[f64]>, runs: &[&[f64]], exact: &[Double], by_entry: bool) -> Option<f64> {
    let runs: Vec<Vec<f64>> = runs.iter().map(|run| errors(run, exact)).collect();
    let sizes: Vec<f64> = exact.iter().map(|(high, _)| high.abs()).collect();
    let of_text = |i: usize| largest(runs.iter().map(|run| run[i])).max(f64::EPSILON / 2.0 * sizes[i]);
    let of_text: Vec<f64> = (0..exact.len()).map(of_text).collect();
    if largest(of_text.iter().copied()) > 1e-3 * largest(sizes) {
        return None;
    }
    let Some(ours) = ours else { return Some(f64::INFINITY) };
    let ours = errors(ours, exact);
    Some(if by_entry {
        largest(ours.iter().zip(&of_text).map(|(ours, text)| if *ours == 0.0 { 0.0 } else { ours / text }))
    } else {
        largest(ours) / largest(of_text)
    })
}

/// The ratios of errors of each object at all points.
#[derive(Default)]
struct Losses(BTreeMap<&'static str, Vec<f64>>);

impl Losses {
    fn fail(ratios: &[f64]) -> bool {
        largest(ratios.iter().copied()) > EVERYWHERE || median(ratios) > IN_THE_MEDIAN
    }
}

fn median(ratios: &[f64]) -> f64 {
    let mut sorted = ratios.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

struct Subject<'a> {
    name: &'a str,
    written: Written,
    interpreter: Interpreter,
    random: Random,
}

impl<'a> Subject<'a> {
    fn new(name: &'a str, text: &str, system: &System) -> Self {
        let written = Written::new(text, &system.field.symbols);
        Subject { name, written, interpreter: Interpreter::new(system), random: Random::seeded(name) }
    }

    /// Returns the ratios of errors at the first `wanted` usable points.
    fn losses(&self, points: impl Iterator<Item = Point<f64>>, wanted: usize) -> Losses {
        let mut losses = Losses::default();
        let mut seen = 0;
        for point in points {
            let Some(found) = self.at(&point) else { continue };
            for (object, ratio) in found {
                losses.0.entry(object).or_default().push(ratio);
            }
            seen += 1;
            if seen == wanted {
                return losses;
            }
        }
        panic!("{}: the text has its digits at {seen} points only", self.name);
    }

    fn at(&self, point: &Point<f64>) -> Option<Vec<(&'static str, f64)>> {
        let exactly = |value: &f64| Rational::from_f64(*value).expect("a finite float");
        let exact = Point {
            state: point.state.iter().map(exactly).collect(),
            parameters: point.parameters.iter().map(exactly).collect(),
            eps: exactly(&point.eps),
        };
        let double = |values: Vec<Rational>| -> Vec<Double> {
            values.iter().map(Rational::to_double_double).collect()
        };
        let ours = self.interpreter.evaluate(&Float64, point).ok();
        let integrals = self.integrals(&Exact, &exact)?;
        if !integrals.is_empty() {
            let runs: Option<Vec<Vec<f64>>> =
                (0..RUNS).map(|_| self.integrals(&self.random, point)).collect();
            let ours = ours.and_then(|found| {
                found.integrals.into_iter().map(|(_, value)| value).collect::<Option<Vec<f64>>>()
            });
            let ratio = lost(ours.as_deref(), &slices(&runs?), &double(integrals), true)?;
            return Some(vec![("integrals", ratio)]);
        }
        let exact = of_text(&self.written, &Exact, &exact)?.map(double);
        let runs: Option<Vec<[Vec<f64>; 5]>> =
            (0..RUNS).map(|_| of_text(&self.written, &self.random, point)).collect();
        let runs = runs?;
        let ours = ours.map(|found| {
            let next = found.next.unwrap_or_else(|| vec![f64::NAN; found.field.len()]);
            [found.field, found.field_jacobian.concat(), found.matrix.concat(), found.rhs, next]
        });
        let to_nearest = of_text(&self.written, &Float64, point)?;
        let ratio = |k: usize| {
            let runs: Vec<&[f64]> = runs.iter().map(|run| run[k].as_slice()).collect();
            let lost = |floats: Option<&[f64]>| lost(floats, &runs, &exact[k], OBJECTS[k] != "step");
            let lost_by_text = lost(Some(&to_nearest[k]))?;
            assert!(lost_by_text <= EVERYWHERE, "{} of {}: {lost_by_text} E", OBJECTS[k], self.name);
            Some((OBJECTS[k], lost(ours.as_ref().map(|ours| ours[k].as_slice()))?))
        };
        (0..OBJECTS.len()).map(ratio).collect()
    }

    fn integrals<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        point: &Point<A::Value>,
    ) -> Option<Vec<A::Value>> {
        let claims = self.written.claims(arithmetic, ClaimKind::Integral, point).into_iter();
        Some(claims.map(|(_, value)| value).collect::<Option<Vec<_>>>()?.concat())
    }
}

fn slices(runs: &[Vec<f64>]) -> Vec<&[f64]> {
    runs.iter().map(Vec::as_slice).collect()
}

struct Draw {
    random: SplitMix64,
    /// The typical sizes of differences between nearly equal parameters.
    nearness: &'static [f64],
}

impl Draw {
    /// Every fourth field has no nearly equal parameters.
    fn of(name: &str, number: usize) -> Self {
        let nearness: [&[f64]; 4] = [&[1.0], &[1.0, 1e-3], &[1.0, 1e-6], &[1.0, 1e-3, 1e-6, 1e-9]];
        Draw {
            random: SplitMix64::from_bytes(format!("digits {name}").as_bytes()),
            nearness: nearness[number % 4],
        }
    }

    fn below(&mut self, bound: usize) -> usize {
        self.random.below(bound as u64) as usize
    }

    fn one<'a, V>(&mut self, choices: &'a [V]) -> &'a V {
        &choices[self.below(choices.len())]
    }

    fn share(&mut self) -> f64 {
        self.random.below(1 << 53) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    fn distance(&mut self) -> f64 {
        let size = *self.one(self.nearness);
        let sign = *self.one(&[1.0, -1.0]);
        sign * size * self.between(0.5, 1.0)
    }

    /// Draws a point. The parameters p, q and s are near each other, r is near −1, and states are
    /// near 1.
    fn point(&mut self, system: &System) -> Point<f64> {
        let p = self.between(0.5, 2.0);
        let q = p - self.distance();
        let s = q - self.distance();
        let r = self.distance() - 1.0;
        let value = |name: &String| match name.as_str() {
            "p" => p,
            "q" => q,
            "s" => s,
            "r" => r,
            name => panic!("{name} has no value"),
        };
        let parameters = system.field.symbols.parameters.iter().map(value).collect();
        let mut state: Vec<f64> = Vec::new();
        for _ in 0..system.field.dimension() {
            let near = *self.one(&[Some(1.0), state.last().copied(), None]);
            state.push(match near {
                Some(near) => near + self.distance(),
                None => self.between(-2.0, 2.0),
            });
        }
        Point { state, parameters, eps: self.between(0.01, 0.2) }
    }

    /// Draws a field in two or three variables. Coefficients contain differences and divisors with
    /// parameters.
    fn field(&mut self) -> String {
        let states = &["x", "y", "z"][..2 + self.below(2)];
        let mut text = String::new();
        for state in states {
            let terms: Vec<String> = (0..1 + self.below(3)).map(|_| self.term(states)).collect();
            let _ = writeln!(text, "{state}dot = {};", terms.join(" + "));
        }
        text
    }

    fn term(&mut self, states: &[&str]) -> String {
        let (x, y) = (*self.one(states), *self.one(states));
        let monomial = match self.below(8) {
            0 => x.to_owned(),
            1 => format!("({x} - 1)"),
            2 => format!("({x} - 1)*({y} - 1)"),
            3 => format!("({x} - {y})^2"),
            4 => format!("(p*{x} - q*{y})*{x}"),
            _ => format!("{x}*{y}"),
        };
        let factors = ["0.1", "3/7", "p", "(p - q)", "(q - s)", "(1 + r)", "-2*r", "(p*q - s^2)"];
        let divisors = ["(p - q)", "(q - s)", "(1 + r)", "(p*s - q^2)", "s", "0.3"];
        match self.below(5) {
            0 => format!("{}*{monomial}", self.one(&factors)),
            1 | 2 => format!("{monomial}/{}", self.one(&divisors)),
            _ => format!("{}*{monomial}/{}", self.one(&factors), self.one(&divisors)),
        }
    }
}

struct Example {
    name: &'static str,
    text: &'static str,
    parameters: fn(&mut Draw) -> Vec<(&'static str, f64)>,
}

const EXAMPLES: [Example; 5] = [
    Example {
        name: "a-common-divisor",
        text: "xdot = -g*x/(1 + nu) - 0.1*mu*y + x*y/(mu - nu); ydot = x - y;",
        parameters: |draw| {
            let nu = draw.between(0.65, 0.75);
            vec![("g", 1.3), ("nu", nu), ("mu", nu + 1e-9 * draw.between(0.5, 1.0))]
        },
    },
    Example {
        name: "a-difference-before-a-product",
        text: "xdot = (p - q)*x*y; ydot = x - y;",
        parameters: |draw| {
            let q = draw.between(0.5, 2.0);
            vec![("p", q + 1e-8 * draw.between(0.5, 1.0)), ("q", q)]
        },
    },
    Example {
        name: "a-product-of-differences",
        text: "xdot = (x - 1)*(y - 1); ydot = x - y;",
        parameters: |_| Vec::new(),
    },
    Example {
        name: "a-large-product-of-differences",
        text: "xdot = p*(x - 1)*(y - 1); ydot = x - y;",
        parameters: |draw| vec![("p", 1e9 * draw.between(0.5, 1.0))],
    },
    // Here (q − s)(p − q) is smaller than the rounding error of its expansion.
    Example {
        name: "two-small-differences",
        text: "xdot = 0.1*x - x*y/(q - s) + x/(p - q); ydot = x - y;",
        parameters: |_| vec![("p", 1.0 + 2e-9), ("q", 1.0 + 1e-9), ("s", 1.0)],
    },
];

/// Returns the blocks of the catalog with integrals, by file name.
fn catalog() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../systems/src/catalog");
    let files = fs::read_dir(folder).expect("the catalog").map(|file| file.expect("a file").path());
    let mut files: Vec<_> = files.filter(|path| path.extension().is_some_and(|end| end == "rs")).collect();
    files.sort();
    let block = |path: &std::path::PathBuf| {
        let source = fs::read_to_string(path).expect("a source");
        let (_, block) = source.split_once("kahan! {\n")?;
        let (block, _) = block.split_once("\n}\n").expect("the end of the block");
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        Some((name, block.to_owned()))
    };
    files.iter().filter_map(block).collect()
}

#[test]
fn the_digits_of_the_text_are_kept() {
    let mut all: Vec<(String, Losses)> = Vec::new();
    for number in 0..fields() {
        let name = format!("{number:03}");
        let mut draw = Draw::of(&name, number);
        let text = draw.field();
        let system = super::system(&text);
        let points = (0..20 * POINTS).map(|_| draw.point(&system));
        let losses = Subject::new(&name, &text, &system).losses(points, POINTS);
        all.push((name, losses));
    }
    for Example { name, text, parameters } in EXAMPLES {
        let system = super::system(text);
        let mut draw = Draw::of(name, 0);
        let points = (0..20 * POINTS).map(|_| {
            let values = parameters(&mut draw);
            let value = |name: &String| values.iter().find(|(known, _)| known == name).expect("a value").1;
            let parameters = system.field.symbols.parameters.iter().map(value).collect();
            let state = (0..2).map(|_| 1.0 + 1e-8 * draw.between(-1.0, 1.0)).collect();
            Point { state, parameters, eps: draw.between(0.01, 0.2) }
        });
        all.push((name.to_owned(), Subject::new(name, text, &system).losses(points, POINTS)));
    }
    let mut with_integrals = 0;
    for (name, text) in catalog() {
        let system = super::system(&text);
        if system.accessors(ClaimKind::Integral).next().is_none() {
            continue;
        }
        with_integrals += 1;
        let mut draw = Draw::of(&name, 0);
        let points = (0..20 * POINTS).map(|_| {
            let mut numbers = |count: usize| (0..count).map(|_| draw.between(-2.0, 2.0)).collect();
            let state = numbers(system.field.dimension());
            let parameters = numbers(system.field.symbols.parameters.len());
            Point { state, parameters, eps: draw.between(0.01, 0.2) }
        });
        all.push((name.clone(), Subject::new(&name, &text, &system).losses(points, POINTS)));
    }
    assert!(with_integrals >= 15, "{with_integrals} systems of the catalog claim integrals");

    let mut wrong = String::new();
    let mut ratios: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for (name, losses) in &all {
        for (object, lost) in &losses.0 {
            ratios.entry(object).or_default().extend(lost);
            if Losses::fail(lost) {
                let (middle, most) = (median(lost), largest(lost.clone()));
                let _ = writeln!(
                    wrong,
                    "{object} of {name} loses digits: {middle:.1} E in the median, {most:.1e} at most"
                );
            }
        }
    }
    for (object, ratios) in &ratios {
        let (middle, most) = (median(ratios), largest(ratios.clone()));
        println!("{object}: {middle:.1} E in the median, {most:.1e} E at most");
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn the_digits_of_a_family_are_kept_at_every_number_of_sites() {
    let site = "{x}*({right} - {left})/(p - q) + (p - q)*{x}/(1 + p) - {x}/(1 + p)";
    let family = site.replace("{x}", "x[i]").replace("{right}", "x[i+1]").replace("{left}", "x[i-1]");
    let text = format!("for i in periodic {{ x[i]dot = {family}; }}");
    let family = read(&lex(&text).tokens).family().expect("no mistake").expect("a family");
    for sites in 3..6_usize {
        let at = |site: usize| format!("x{}", site % sites);
        let equation = |i: usize| {
            let [x, right, left] = [at(i), at(i + 1), at(i + sites - 1)];
            let site = site.replace("{x}", &x).replace("{right}", &right).replace("{left}", &left);
            format!("{x}dot = {site};")
        };
        let (chain, name) = ((0..sites).map(equation).collect::<String>(), format!("{sites} sites"));
        let system = family.at_sites(sites).expect("no site divides by zero");
        let mut draw = Draw::of(&name, sites);
        let points = (0..20 * POINTS).map(|_| {
            let q = draw.between(0.5, 2.0);
            let parameters = vec![q + 1e-9 * draw.between(0.5, 1.0), q];
            let state = (0..sites).map(|_| draw.between(-2.0, 2.0)).collect();
            Point { state, parameters, eps: draw.between(0.01, 0.2) }
        });
        let losses = Subject::new(&name, &chain, &system).losses(points, POINTS);
        for (object, lost) in &losses.0 {
            assert!(!Losses::fail(lost), "{object} of {name}: {:.1e} at most", largest(lost.clone()));
        }
    }
}

#[test]
fn the_digits_of_a_text_are_kept_where_parameters_have_values() {
    let text = "xdot = (x - a)*(y - 1)/(p - q) + x/(a + q); ydot = (1 + a)*(x - y)^2/q;";
    let system = super::system(text).specialise(&[(0, Rational::one())]).expect("defined there");
    assert_eq!(system.field.symbols.parameters, ["p", "q"]);
    let mut draw = Draw::of("values", 0);
    let points = (0..20 * POINTS).map(|_| {
        let q = draw.between(0.5, 2.0);
        let state = (0..2).map(|_| 1.0 + 1e-8 * draw.between(-1.0, 1.0)).collect();
        let parameters = vec![q + 1e-9 * draw.between(0.5, 1.0), q];
        Point { state, parameters, eps: draw.between(0.01, 0.2) }
    });
    let with_numbers = text.replace('a', "1");
    let losses = Subject::new("values", &with_numbers, &system).losses(points, POINTS);
    for (object, lost) in &losses.0 {
        assert!(!Losses::fail(lost), "{object}: {:.1e} at most", largest(lost.clone()));
    }
}
