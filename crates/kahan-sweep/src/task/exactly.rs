//! Exact questions: how the heights of an orbit grow, and what a map preserves.

use kahan_algebra::rational::Rational;
use kahan_discover::hilbert::default_degree;
use kahan_discover::{Options, Unwatched, discover};
use kahan_runtime::heights::{HeightsOrbit, Survey};

use crate::columns::{Column, Entry, Kind};
use crate::plan::{Plan, Point};

/// A question with an exact answer.
#[derive(Clone, Debug)]
pub(crate) enum Exactly {
    Heights(Heights),
    Search(Search),
}

/// How the heights of an exact orbit grow.
#[derive(Clone, Debug)]
pub(crate) struct Heights {
    pub(crate) steps: u64,
    /// The most digits of a numerator or denominator, where the orbit ends.
    pub(crate) digits: u64,
}

/// What the map preserves.
#[derive(Clone, Debug)]
pub(crate) struct Search {
    /// The degree of the relations that are looked for, where the plan says it.
    pub(crate) degree: Option<u32>,
}

impl Exactly {
    pub(crate) fn columns(&self, plan: &Plan) -> Vec<Column> {
        let integer = |name: &str, meaning: &str| Column::new(name, Kind::Integer, meaning);
        let text = |name: &str, meaning: &str| Column::new(name, Kind::Text, meaning);
        match self {
            Exactly::Heights(_) => {
                let heights = plan.field.variables().iter().map(|name| {
                    Column::new(
                        format!("height_{name}"),
                        Kind::Double,
                        "logarithmic height at the last step, natural logarithm",
                    )
                });
                let growth = [
                    integer("steps", "steps that were made"),
                    text(
                        "growth",
                        "how heights grow: bounded, logarithmic, linear, quadratic, exponential or undecided",
                    ),
                    Column::new(
                        "entropy",
                        Kind::Double,
                        "logarithm of the last quotient of heights where these grow exponentially",
                    ),
                ];
                growth.into_iter().chain(heights).collect()
            }
            Exactly::Search(_) => vec![
                integer("independent_integrals", "number of independent algebraic integrals that were seen"),
                text("growth", "how the degrees of iterates grow"),
                Column::new("entropy", Kind::Double, "algebraic entropy"),
                text("integrals", "integrals in the language of kahan!, proved"),
                text("densities", "invariant densities, proved"),
            ],
        }
    }

    /// What was found at a point.
    pub(crate) fn entries(&self, plan: &Plan, point: &Point<Rational>) -> Vec<Entry> {
        match self {
            Exactly::Heights(heights) => heights.entries(plan, point),
            Exactly::Search(search) => search.entries(plan, point),
        }
    }
}

impl Heights {
    fn entries(&self, plan: &Plan, point: &Point<Rational>) -> Vec<Entry> {
        let variables = plan.field.variables().len();
        let nothing = |growth: &str| {
            let none = vec![Entry::Double(f64::NAN); variables + 1];
            [Entry::Integer(0), Entry::Text(growth.to_owned())].into_iter().chain(none).collect()
        };
        let orbit = HeightsOrbit::new(plan.system(), &point.parameters, &point.eps, &point.start);
        let Ok(orbit) = orbit else { return nothing("undefined") };
        let mut orbit = orbit.within_digits(self.digits);
        let survey = Survey::of(&mut orbit, self.steps);
        let Some(last) = survey.heights.last() else { return nothing("undecided") };
        let heights = last.logarithms.iter().map(|height| Entry::Double(*height));
        let growth = [
            Entry::Integer(survey.heights.len() as i64 - 1),
            Entry::Text(survey.growth.to_string()),
            Entry::Double(survey.entropy),
        ];
        growth.into_iter().chain(heights).collect()
    }
}

impl Search {
    fn entries(&self, plan: &Plan, point: &Point<Rational>) -> Vec<Entry> {
        let names = plan.field.parameters().iter().cloned();
        let options = Options {
            eps: Some(point.eps.clone()),
            parameters: names.zip(point.parameters.iter().cloned()).collect(),
            // Nobody watches, as what is found must not depend on how fast a machine is; so a
            // degree has to end the search.
            degree: Some(self.degree.unwrap_or_else(|| default_degree(plan.system().field.dimension()))),
            ..Options::default()
        };
        match discover(plan.system(), &options, &Unwatched) {
            Ok(report) => {
                let texts = |formulas: &[kahan_discover::claims::Formula]| {
                    Entry::Text(
                        formulas.iter().map(|formula| formula.text.clone()).collect::<Vec<_>>().join("\n"),
                    )
                };
                vec![
                    Entry::Integer(report.independent_integrals() as i64),
                    Entry::Text(report.growth.growth.word().to_owned()),
                    Entry::Double(report.growth.growth.entropy()),
                    texts(&report.integrals),
                    texts(&report.densities),
                ]
            }
            Err(why) => vec![
                Entry::Integer(-1),
                Entry::Text(why.to_string()),
                Entry::Double(f64::NAN),
                Entry::Text(String::new()),
                Entry::Text(String::new()),
            ],
        }
    }
}
