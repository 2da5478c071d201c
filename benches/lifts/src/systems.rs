//! Reads the systems of `systems.tsv`, and computes their lifts and reference solutions.

use kahan_algebra::diagnostics::Diagnostics;
use kahan_algebra::lenient;
use kahan_algebra::parse::parse_lifted;
use kahan_algebra::syntax::{Expr, ExprKind, Factor, FormulaSyntax, Term};
use kahan_algebra::token::Token;
use kahan_lift::{Lift, LiftCriterion, Options, lift, stated};
use kahan_runtime::Map;
use ode_solvers::{DVector, Dop853, OutputType};

pub(crate) struct System {
    pub(crate) name: &'static str,
    tokens: Vec<Token>,
    pub(crate) parameters: Vec<(String, f64)>,
    /// The initial state; if the equations depend on the time, followed by the time 0.
    pub(crate) start: Vec<f64>,
    pub(crate) time: f64,
    pub(crate) energy: Option<Formula>,
    kind: &'static str,
    field: Vec<Formula>,
}

impl System {
    pub(crate) fn all() -> Vec<System> {
        include_str!("../systems.tsv").lines().skip(1).map(System::read).collect()
    }

    pub(crate) fn is(&self, word: &str) -> bool {
        self.kind.split(' ').any(|one| one == word)
    }

    fn read(line: &'static str) -> Self {
        let cells: Vec<&str> = line.split('\t').collect();
        let [name, text, parameters, start, time, energy, kind] = cells[..] else {
            panic!("seven cells: {line}")
        };
        let tokens = lenient::read(text).lexed.tokens;
        let stated = stated(&tokens).unwrap_or_else(|mistakes| panic!("{name}: {}", mistakes[0]));
        let number = |word: &str| word.parse::<f64>().unwrap_or_else(|_| panic!("{name}: {word}"));
        let values: Vec<(&str, f64)> = parameters
            .split_whitespace()
            .filter_map(|word| word.split_once('=').map(|(name, value)| (name, number(value))))
            .collect();
        let value = |name: &String| values.iter().find(|(known, _)| known == name).expect("a value").1;
        let parameters: Vec<_> = stated.parameters.iter().map(|name| (name.clone(), value(name))).collect();
        let time_at_start = stated.has_time.then_some(0.0);
        let start = start.split_whitespace().map(number).chain(time_at_start).collect();
        let names: Vec<&str> = stated.states.iter().map(String::as_str).collect();
        let mut field = Formula::read(text, &names, &values);
        field.extend(stated.has_time.then_some(Formula::Number(1.0)));
        let energy = (!energy.is_empty()).then(|| Formula::read(&format!("E' = {energy}"), &names, &values));
        let energy = energy.map(|mut one| one.remove(0));
        System { name, tokens, parameters, start, time: number(time), energy, kind, field }
    }

    fn options(&self, which: LiftCriterion) -> Options {
        Options { which, orbit: Some((self.start.clone(), self.values())), ..Options::default() }
    }

    pub(crate) fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|(_, value)| *value).collect()
    }

    pub(crate) fn lift(&self, which: LiftCriterion) -> Lift {
        let lift = lift(&self.tokens, &self.options(which));
        lift.unwrap_or_else(|mistakes| panic!("{}: {}", self.name, mistakes[0]))
    }

    pub(crate) fn lifts(&self) -> Vec<Lift> {
        kahan_lift::lifts(&self.tokens, &self.options(LiftCriterion::Automatic)).expect("equations")
    }

    pub(crate) fn map(&self, lift: &Lift) -> Map {
        let field = kahan_runtime::Field::parse(&lift.text())
            .unwrap_or_else(|_| panic!("{}: {}", self.name, lift.text()));
        let used = |name: &str| field.parameters().iter().any(|known| known == name);
        let values = self.parameters.iter().filter(|(name, _)| used(name));
        field.with(values.map(|(name, value)| (name.as_str(), *value))).expect("all parameters")
    }

    pub(crate) fn embedded(&self, lift: &Lift, states: &[f64]) -> Vec<f64> {
        [states.to_vec(), lift.embed(states, &self.values())].concat()
    }

    fn slope(&self, x: &[f64], slope: &mut [f64]) {
        slope.iter_mut().zip(&self.field).for_each(|(slope, formula)| *slope = formula.value(x));
    }

    /// Returns the states at `parts` equidistant times up to `time`, by the Dormand–Prince method.
    pub(crate) fn solution(&self, time: f64, parts: u32, tolerance: f64) -> Vec<Vec<f64>> {
        let mut x = DVector::from_column_slice(&self.start);
        let part = time / f64::from(parts);
        (0..parts)
            .map(|_| {
                let mut solver = Dop853::new(Slope(self), 0.0, part, part, x.clone(), tolerance, tolerance);
                solver.set_output(OutputType::Sparse);
                solver.integrate().unwrap_or_else(|error| panic!("{}: {error}", self.name));
                x.clone_from(solver.y_out().last().expect("the end is put out"));
                x.as_slice().to_vec()
            })
            .collect()
    }
}

struct Slope<'a>(&'a System);

impl ode_solvers::System<f64, DVector<f64>> for Slope<'_> {
    fn system(&self, _time: f64, x: &DVector<f64>, slope: &mut DVector<f64>) {
        self.0.slope(x.as_slice(), slope.as_mut_slice());
    }
}

/// A right-hand side, which is evaluated independently of the crate under test.
pub(crate) enum Formula {
    Number(f64),
    State(usize),
    Sum(Vec<(bool, Formula)>),
    Product(Vec<(bool, Formula)>),
    Power(Box<Formula>, f64),
    Call(fn(f64) -> f64, Box<Formula>),
}

impl Formula {
    pub(crate) fn read(text: &str, states: &[&str], parameters: &[(&str, f64)]) -> Vec<Self> {
        let mut mistakes = Diagnostics::default();
        let block = parse_lifted(&lenient::read(text).lexed.tokens, &mut mistakes);
        assert!(mistakes.finish().is_empty(), "{text}");
        let sides = block.equations.iter().filter_map(|equation| equation.value.as_ref());
        sides.map(|side| Formula::of(side, states, parameters)).collect()
    }

    fn of(expr: &Expr<FormulaSyntax>, states: &[&str], parameters: &[(&str, f64)]) -> Self {
        let read = |expr: &Expr<FormulaSyntax>| Formula::of(expr, states, parameters);
        match &expr.kind {
            ExprKind::Number(number) => Formula::Number(number.to_f64()),
            ExprKind::Name(name) => match states.iter().position(|state| state == name) {
                Some(state) => Formula::State(state),
                None => {
                    let known = parameters.iter().find(|(known, _)| known == name);
                    Formula::Number(known.unwrap_or_else(|| panic!("{name} has no value")).1)
                }
            },
            ExprKind::Sum(terms) => {
                Formula::Sum(terms.iter().map(|Term { negative, expr }| (*negative, read(expr))).collect())
            }
            ExprKind::Product(factors) => Formula::Product(
                factors.iter().map(|Factor { divides, expr }| (*divides, read(expr))).collect(),
            ),
            ExprKind::Negation(inner) => Formula::Sum(vec![(true, read(inner))]),
            ExprKind::Power(base, exponent) => Formula::Power(Box::new(read(base)), *exponent as f64),
            ExprKind::Special(FormulaSyntax::Power(parts)) => {
                Formula::Power(Box::new(read(&parts[0])), read(&parts[1]).value(&[]))
            }
            ExprKind::Special(FormulaSyntax::Call { function, arguments }) => {
                let function = match function.as_str() {
                    "sin" => f64::sin,
                    "cos" => f64::cos,
                    "exp" => f64::exp,
                    _ => panic!("{function}"),
                };
                Formula::Call(function, Box::new(read(&arguments[0])))
            }
        }
    }

    pub(crate) fn size(&self, x: &[f64]) -> f64 {
        match self {
            Formula::Sum(terms) => terms.iter().map(|(_, term)| term.value(x).abs()).sum(),
            _ => self.value(x).abs(),
        }
    }

    pub(crate) fn value(&self, x: &[f64]) -> f64 {
        match self {
            Formula::Number(number) => *number,
            Formula::State(state) => x[*state],
            Formula::Sum(terms) => {
                terms.iter().fold(
                    0.0,
                    |sum, (negative, term)| {
                        if *negative { sum - term.value(x) } else { sum + term.value(x) }
                    },
                )
            }
            Formula::Product(factors) => factors.iter().fold(1.0, |product, (divides, factor)| {
                if *divides { product / factor.value(x) } else { product * factor.value(x) }
            }),
            Formula::Power(base, exponent) if exponent.fract() == 0.0 => base.value(x).powi(*exponent as i32),
            Formula::Power(base, exponent) => base.value(x).powf(*exponent),
            Formula::Call(function, argument) => function(argument.value(x)),
        }
    }
}

pub(crate) fn size(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |size, value| size.max(value.abs()))
}

/// Returns the largest difference of the components of `a` and `b`, relative to the size of `b`.
pub(crate) fn distance(a: &[f64], b: &[f64]) -> f64 {
    // NaN must give infinity, because `max` below ignores NaN.
    let far = |a: f64, b: f64| if a.is_finite() { (a - b).abs() } else { f64::INFINITY };
    a.iter().zip(b).fold(0.0_f64, |most, (&a, &b)| most.max(far(a, b))) / size(b)
}
