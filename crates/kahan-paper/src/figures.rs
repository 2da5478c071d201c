//! The exact orbits of the paper's figures and further exact orbits, with the heights (sizes of
//! fractions) of their points.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use kahan_algebra::rational::Rational;

use kahan_core::prelude::*;
use kahan_runtime::heights::{DiophantineTest, Growth, HeightsOrbit};

use super::formula::Formula;
use super::model::Model;
use kahan_systems::E4;
use kahan_systems::registry::find;

/// An exact orbit of the paper.
#[derive(Debug)]
pub struct Figure {
    /// The name of the figure's orbit, for example `dE3`.
    pub name: &'static str,
    /// The name of the system in commands.
    pub system: &'static str,
    /// The values of the parameters, each as a fraction, in the order of the system's header.
    pub parameters: &'static [(i64, i64)],
    /// Half the time step, ε, as a fraction.
    pub eps: (i64, i64),
    /// The coordinates of the initial state x₀, each as a fraction.
    pub start: &'static [(i64, i64)],
    /// The number of iterates of the initial state.
    pub steps: u64,
    /// The statement that the paper makes about the orbit.
    pub caption: &'static str,
}

const START: &[(i64, i64)] = &[(3, 7), (11, 13), (23, 47)];
const START_4: &[(i64, i64)] = &[(7, 3), (11, 13), (23, 47)];
const HALF: (i64, i64) = (1, 2);

macro_rules! figure {
    ($name:ident, $system:literal, $parameters:expr, $eps:expr, $start:expr, $steps:literal, $caption:literal) => {
        #[doc = concat!("The orbit of d", $system, ".")]
        pub static $name: Figure = Figure {
            name: stringify!($name),
            system: $system,
            parameters: $parameters,
            eps: $eps,
            start: $start,
            steps: $steps,
            caption: $caption,
        };
    };
}

figure!(DE1, "e1", &[], HALF, START, 1000, "no figure; the data of dE3");
figure!(DE2, "e2", &[], HALF, START, 1000, "no figure; the data of dE3");
figure!(DE3, "e3", &[], HALF, START, 200, "the first 200 iterates of dE3");
figure!(DE4, "e4", &[], HALF, START_4, 125, "the first 125 iterates of dE4");
figure!(DE5, "e5", &[], HALF, START, 200, "no figure; the data of dE3");
figure!(DE6, "e6", &[], HALF, START_4, 125, "no figure; the data of dE4");
figure!(DE7, "e7", &[(19, 17)], HALF, START, 2000, "the first 2000 iterates of dE7, xi = 19/17");
figure!(
    DE7_1_5,
    "e7",
    &[(19, 17)],
    HALF,
    &[(1, 5), (11, 13), (23, 47)],
    2000,
    "no figure; dE7 from x0 = 1/5"
);
figure!(
    DE7_2_9,
    "e7",
    &[(19, 17)],
    HALF,
    &[(2, 9), (11, 13), (23, 47)],
    2000,
    "no figure; dE7 from x0 = 2/9"
);
figure!(DE8, "e8", &[], HALF, START, 2000, "no figure; the data of dE7");
figure!(
    DE9,
    "e9",
    &[(-1, 2)],
    HALF,
    &[(2, 5), (7, 3), (11, 13)],
    11,
    "the first 11 iterates of dE9, xi = -1/2"
);
figure!(LV, "lv", &[], (9, 14), &[(1, 2), (5, 3)], 17, "the first 17 iterates of Kahan's Lotka-Volterra map");

static ALL: [&Figure; 12] = [&DE1, &DE2, &DE3, &DE4, &DE5, &DE6, &DE7, &DE7_1_5, &DE7_2_9, &DE8, &DE9, &LV];

/// The measured heights along an orbit.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// The names of the variables whose heights are measured.
    pub variables: Vec<String>,
    /// The heights of all variables, from the initial state on.
    pub survey: DiophantineTest,
}

impl Figure {
    /// Returns exact orbits of systems of the paper: those of its figures, and others.
    pub fn all() -> impl Iterator<Item = &'static Figure> {
        ALL.into_iter()
    }

    /// Computes the orbit exactly, which takes a few seconds at most.
    ///
    /// # Panics
    /// If the catalog lacks the system.
    #[must_use]
    pub fn measure(&self) -> Measurement {
        let entry = find(self.system).expect("a figure is about a system of the catalog");
        let model = Model::of_catalog(entry);
        let system = model.system();
        let exact = |&(p, q): &(i64, i64)| Rational::new(p, q);
        let parameters: Vec<Rational> = self.parameters.iter().map(exact).collect();
        let start: Vec<Rational> = self.start.iter().map(exact).collect();
        let mut orbit = HeightsOrbit::new(system, &parameters, &exact(&self.eps), &start)
            .expect("the field has a value at these parameters");
        let survey = DiophantineTest::of(&mut orbit, self.steps);
        Measurement { variables: system.field.symbols.states.clone(), survey }
    }
}

impl Measurement {
    /// Returns the logarithmic heights h₀, h₁, … of a variable.
    #[must_use]
    pub fn log_heights(&self, variable: &str) -> Option<Vec<f64>> {
        let index = self.variables.iter().position(|known| known == variable)?;
        Some(self.survey.heights.iter().map(|heights| heights.logarithms[index]).collect())
    }

    /// Replaces measured functions in a formula by numbers. Below, h is `h(v, n)` for n = a, …, b.
    ///
    /// | call | meaning |
    /// |---|---|
    /// | `h(v, n)`, `digits(v, n)` | logarithmic height and number of digits of v after n steps |
    /// | `slope(v, a, b)` | the least squares slope of h against n |
    /// | `logslope(v, a, b)` | the least squares slope of h against log n |
    /// | `mean(v, a, b)` | the mean of log(h/n) |
    /// | `growth(v)` | the growth class, to be compared with `linear`, `quadratic`, … |
    pub(super) fn put_into(&self, formula: &Formula) -> Result<Formula, String> {
        formula.replaced(&|name, arguments| match class(name) {
            Some(class) if arguments.is_empty() => Ok(Some(Rational::from(class))),
            _ => self.quantity(name, arguments),
        })
    }

    /// Evaluates a measured function; `None` for other functions.
    fn quantity(&self, name: &str, arguments: &[Formula]) -> Result<Option<Rational>, String> {
        let numbers: Vec<Rational> = arguments.iter().filter_map(Formula::as_number).collect();
        if !matches!(name, "h" | "digits" | "slope" | "logslope" | "mean" | "growth") {
            return Ok(None);
        }
        let Some(Formula::Name(variable)) = arguments.first() else {
            return Err(format!("`{name}` takes a variable first"));
        };
        let heights = self.log_heights(variable).ok_or_else(|| format!("`{variable}` is no variable"))?;
        let index = |position: usize| {
            let n = numbers.get(position).and_then(Rational::as_i64).and_then(|n| usize::try_from(n).ok());
            n.filter(|&n| n < heights.len()).ok_or_else(|| format!("`{name}`: no such iterate"))
        };
        let value = match name {
            "h" => heights[index(0)?],
            "digits" => {
                let column = self.variables.iter().position(|known| known == variable);
                let column = column.expect("its heights are known");
                return Ok(i64::try_from(self.survey.heights[index(0)?].digits[column])
                    .ok()
                    .map(Rational::from));
            }
            "growth" => {
                let class = self.growth(variable).and_then(|growth| class(&growth.to_string()));
                return Ok(class.map(Rational::from));
            }
            _ => {
                let points = (index(0)?..=index(1)?).map(|n| (n as f64, heights[n]));
                match name {
                    "slope" => slope(points),
                    "logslope" => slope(points.map(|(n, h)| (libm::log(n), h))),
                    _ => {
                        let logarithms: Vec<f64> = points.map(|(n, h)| libm::log(h / n)).collect();
                        logarithms.iter().sum::<f64>() / logarithms.len() as f64
                    }
                }
            }
        };
        Rational::from_f64(value).map(Some).ok_or_else(|| format!("`{name}` has no value"))
    }

    /// Returns the growth class of a variable's heights.
    #[must_use]
    pub fn growth(&self, variable: &str) -> Option<Growth> {
        Some(Growth::of(&self.log_heights(variable)?[1..]))
    }
}

/// Returns the number that stands for a growth class in comparisons.
fn class(name: &str) -> Option<i64> {
    ["undecided", "bounded", "logarithmic", "linear", "quadratic", "exponential"]
        .iter()
        .position(|known| *known == name)
        .and_then(|index| i64::try_from(index).ok())
}

/// Returns `parts` + 1 points on the closed curve through `point` = (x, y, z) on which the
/// integrals H and K of Kahan's map of E4 are constant. Requires xy > 0 and |εz| < 1.
///
/// With s = x + y, d = x − y, h = 2ε²H and g = 2ε²K, the integrals give (1−h)s² − (1+h)d² = 4H and
/// (1−g)(s² + d²) + 2z² = 4K. Elimination of s leaves an ellipse in d and z.
#[must_use]
pub fn level_curve(point: &SVector<f64, 3>, eps: f64, parts: usize) -> Vec<SVector<f64, 3>> {
    let integrals = E4.integrals(point, eps);
    let (big_h, big_k) = (integrals[0], integrals[1]);
    let (h, g) = (2.0 * eps * eps * big_h, 2.0 * eps * eps * big_k);
    // The ellipse is 2z² = a − b d².
    let a = 4.0 * big_k - (1.0 - g) * 4.0 * big_h / (1.0 - h);
    let b = (1.0 - g) * (1.0 + (1.0 + h) / (1.0 - h));
    let sign = point[0].signum();
    let at = |phase: f64| {
        let d = (a / b).sqrt() * libm::cos(phase);
        let s = sign * ((4.0 * big_h + (1.0 + h) * d * d) / (1.0 - h)).sqrt();
        SVector::<f64, 3>::new((s + d) / 2.0, (s - d) / 2.0, (a / 2.0).sqrt() * libm::sin(phase))
    };
    (0..=parts).map(|i| at(TAU * i as f64 / parts as f64)).collect()
}

/// Returns the slope of the least squares line through points.
#[must_use]
pub fn slope(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let points: Vec<(f64, f64)> = points.collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let above: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let below: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    above / below
}

/// The measurements of all orbits, computed on first use.
pub(super) type Measurements = BTreeMap<&'static str, std::sync::OnceLock<Measurement>>;
