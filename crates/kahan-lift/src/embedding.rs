//! The first values of new variables as a straight line of steps.
//!
//! `Lift::embed` runs the steps in `f64`, and generated code is written from them, so that both
//! have the same bits: every step is one operation that rounds once, or a function of `libm`.

use std::collections::hash_map::Entry;

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use rustc_hash::FxHashMap;

use crate::laurent::Laurent;
use crate::ring::{Function, Meaning, Ring};

/// One step; operands are places of earlier steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// A state, by its place in a point; the lifted time is the last one.
    State(usize),
    /// A parameter, by its place.
    Parameter(usize),
    /// A number, by its place among the numbers.
    Number(usize),
    /// −a
    Negation(usize),
    /// a + b
    Sum(usize, usize),
    /// a·b
    Product(usize, usize),
    /// a/b
    Quotient(usize, usize),
    /// aⁿ by repeated squaring, and 1/a⁻ⁿ where n is negative.
    Power(usize, i32),
    /// a^b by `libm::pow`.
    RealPower(usize, usize),
    /// The square root.
    SquareRoot(usize),
    /// The cube root.
    CubeRoot(usize),
    /// A function; `libm` has it by the same name.
    Function(Function, usize),
}

/// The first values of new variables as functions of the states and the parameters.
#[derive(Clone, Debug, Default)]
pub struct Embedding {
    /// The steps, operands before their uses and no step twice.
    pub steps: Vec<Step>,
    /// The step of each new variable's value.
    pub values: Vec<usize>,
    /// The numbers that occur, and the floats next to them.
    pub numbers: Vec<(Rational, f64)>,
}

/// base^exponent by squaring.
fn power(base: f64, exponent: i32) -> f64 {
    let power = num_traits::pow(base, exponent.unsigned_abs() as usize);
    if exponent < 0 { 1.0 / power } else { power }
}

impl Embedding {
    /// The values at a point, with these values of the parameters.
    #[must_use]
    pub fn values(&self, states: &[f64], parameters: &[f64]) -> Vec<f64> {
        let found = self.run(states, parameters);
        self.values.iter().map(|&value| found[value]).collect()
    }

    /// The values at a point: exact for rational functions of the states, else those of floats.
    /// Returns `None` if one has no finite value.
    pub(crate) fn exact(&self, states: &[Rational], parameters: &[Rational]) -> Option<Vec<Rational>> {
        let [floats, of] =
            [states, parameters].map(|one| one.iter().map(Rational::to_f64).collect::<Vec<_>>());
        let mut found: Vec<Rational> = Vec::with_capacity(self.steps.len());
        for (&step, float) in self.steps.iter().zip(self.run(&floats, &of)) {
            found.push(match step {
                Step::State(index) => states[index].clone(),
                Step::Parameter(index) => parameters[index].clone(),
                Step::Number(index) => self.numbers[index].0.clone(),
                Step::Negation(a) => -&found[a],
                Step::Sum(a, b) => &found[a] + &found[b],
                Step::Product(a, b) => &found[a] * &found[b],
                Step::Quotient(a, b) => found[a].checked_div(&found[b])?,
                Step::Power(a, exponent) => found[a].pow(exponent)?,
                Step::RealPower(..) | Step::SquareRoot(_) | Step::CubeRoot(_) | Step::Function(..) => {
                    Rational::from_f64(float)?
                }
            });
        }
        Some(self.values.iter().map(|&value| found[value].clone()).collect())
    }

    /// The values of all steps.
    fn run(&self, states: &[f64], parameters: &[f64]) -> Vec<f64> {
        let mut found: Vec<f64> = Vec::with_capacity(self.steps.len());
        for &step in &self.steps {
            found.push(match step {
                Step::State(index) => states[index],
                Step::Parameter(index) => parameters[index],
                Step::Number(index) => self.numbers[index].1,
                Step::Negation(a) => -found[a],
                Step::Sum(a, b) => found[a] + found[b],
                Step::Product(a, b) => found[a] * found[b],
                Step::Quotient(a, b) => found[a] / found[b],
                Step::Power(a, exponent) => power(found[a], exponent),
                Step::RealPower(a, b) => libm::pow(found[a], found[b]),
                Step::SquareRoot(a) => libm::sqrt(found[a]),
                Step::CubeRoot(a) => libm::cbrt(found[a]),
                Step::Function(function, a) => function.at(found[a]),
            });
        }
        found
    }
}

/// Writes steps, each once.
pub(crate) struct Builder<'a> {
    ring: &'a Ring,
    embedding: Embedding,
    known: FxHashMap<Step, usize>,
    coordinates: Vec<Option<usize>>,
}

impl<'a> Builder<'a> {
    /// The embedding by these values.
    pub(crate) fn embedding<'b>(ring: &'a Ring, values: impl IntoIterator<Item = &'b Laurent>) -> Embedding {
        let mut builder = Builder {
            ring,
            embedding: Embedding::default(),
            known: FxHashMap::default(),
            coordinates: vec![None; ring.coordinates.len()],
        };
        let values = values.into_iter().map(|value| builder.laurent(value)).collect();
        Embedding { values, ..builder.embedding }
    }

    fn push(&mut self, step: Step) -> usize {
        match self.known.entry(step) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(new) => {
                self.embedding.steps.push(*new.key());
                *new.insert(self.embedding.steps.len() - 1)
            }
        }
    }

    fn number(&mut self, number: &Rational) -> usize {
        let numbers = &mut self.embedding.numbers;
        let known = numbers.iter().position(|(known, _)| known == number);
        let place = known.unwrap_or_else(|| {
            numbers.push((number.clone(), number.to_f64()));
            numbers.len() - 1
        });
        self.push(Step::Number(place))
    }

    fn power(&mut self, base: usize, exponent: i32) -> usize {
        if exponent == 1 { base } else { self.push(Step::Power(base, exponent)) }
    }

    /// number·factors from left to right, without a factor that is 1.
    fn product(&mut self, number: &Rational, factors: Vec<usize>) -> usize {
        let mut factors = factors.into_iter();
        let first = if number.abs().is_one() { factors.next() } else { None };
        let mut product = first.unwrap_or_else(|| self.number(number));
        if first.is_some() && number.is_negative() {
            product = self.push(Step::Negation(product));
        }
        factors.fold(product, |product, factor| self.push(Step::Product(product, factor)))
    }

    fn sum(&mut self, terms: Vec<usize>) -> usize {
        let sum = terms.into_iter().reduce(|sum, term| self.push(Step::Sum(sum, term)));
        sum.unwrap_or_else(|| self.number(&Rational::zero()))
    }

    /// A polynomial in the parameters.
    fn polynomial(&mut self, polynomial: &Polynomial) -> usize {
        let mut terms = Vec::new();
        for (monomial, number) in polynomial.terms() {
            let mut factors = Vec::new();
            for &(parameter, exponent) in monomial.powers() {
                let parameter = self.push(Step::Parameter(usize::from(parameter.0)));
                factors.push(self.power(parameter, exponent.cast_signed()));
            }
            terms.push(self.product(number, factors));
        }
        self.sum(terms)
    }

    /// A coefficient as a number and, unless that is all of it, a factor.
    fn coefficient(&mut self, value: &RationalFunction) -> (Rational, Option<usize>) {
        if let Some(number) = value.as_polynomial().and_then(Polynomial::as_constant) {
            return (number, None);
        }
        let above = self.polynomial(value.numerator());
        let whole = if value.denominator().is_one() {
            above
        } else {
            let below = self.polynomial(value.denominator());
            self.push(Step::Quotient(above, below))
        };
        (Rational::one(), Some(whole))
    }

    fn laurent(&mut self, polynomial: &Laurent) -> usize {
        let mut terms = Vec::new();
        for (monomial, value) in polynomial.terms() {
            let (number, factor) = self.coefficient(value);
            let mut factors: Vec<usize> = factor.into_iter().collect();
            for (coordinate, exponent) in monomial.powers() {
                let coordinate = self.coordinate(coordinate);
                factors.push(self.power(coordinate, exponent.into()));
            }
            terms.push(self.product(&number, factors));
        }
        self.sum(terms)
    }

    fn coordinate(&mut self, index: usize) -> usize {
        if let Some(known) = self.coordinates[index] {
            return known;
        }
        let ring = self.ring;
        let meaning = &ring.coordinates[index].meaning;
        let argument = meaning.argument().map(|argument| self.laurent(argument));
        let place = match (meaning, argument) {
            (Meaning::State(state), _) => self.push(Step::State(*state)),
            (Meaning::Function(function, _), Some(argument)) => {
                self.push(Step::Function(*function, argument))
            }
            (Meaning::Root(_, 2), Some(argument)) => self.push(Step::SquareRoot(argument)),
            (Meaning::Root(_, 3), Some(argument)) => self.push(Step::CubeRoot(argument)),
            (Meaning::Root(_, degree @ 4..), Some(argument)) => {
                let exponent = self.number(&Rational::new(1, i64::from(*degree)));
                self.push(Step::RealPower(argument, exponent))
            }
            (Meaning::Power(_, exponent), Some(argument)) => {
                let (number, factor) = self.coefficient(exponent);
                let exponent = factor.unwrap_or_else(|| self.number(&number));
                self.push(Step::RealPower(argument, exponent))
            }
            (Meaning::Root(..) | Meaning::Sum(_), Some(argument)) => argument,
            (_, None) => unreachable!("every coordinate but a state has an argument"),
        };
        self.coordinates[index] = Some(place);
        place
    }
}

#[cfg(test)]
mod tests {
    use kahan_algebra::lexer::lex;
    use kahan_algebra::rational::Rational;

    use crate::{Options, lift};

    /// The steps against values in rational numbers, which go another way.
    #[test]
    fn steps_have_the_exact_values_to_rounding() {
        for text in [
            "xdot = v; vdot = -g*sin(x);",
            "xdot = p; ydot = q; pdot = -k*x*(x^2 + y^2)^(-3/2); qdot = -k*y*(x^2 + y^2)^(-3/2);",
            "xdot = a^2*x^3/(a + k*x^2) - x^7 + 1/3*tan(k*x/2);",
            "xdot = -x^n/(k + x^n);",
            "xdot = cbrt(x)*x^(5/7);",
            "xdot = log(1 + x^2/a);",
            "xdot = tanh(x - a) + cosh(x - a);",
            "xdot = asin(x/9); ydot = atanh(y/9); zdot = acosh(z + 2);",
            "xdot = -exp(-k*t)*x^2*sin(t)^3;",
        ] {
            let options = Options { budget: 200, ..Options::default() };
            let lift = lift(&lex(text).tokens, &options).expect(text);
            let [states, parameters] = [&lift.states, &lift.parameters]
                .map(|names| (0..names.len()).map(|i| Rational::new(3 + i as i64, 8)).collect::<Vec<_>>());
            let floats = |values: &[Rational]| values.iter().map(Rational::to_f64).collect::<Vec<f64>>();
            let found = lift.embed(&floats(&states), &floats(&parameters));
            let exact = floats(&lift.embed_exact(&states, &parameters).expect("values"));
            assert_eq!(found.len(), lift.order(), "{text}");
            for (found, exact) in found.iter().zip(&exact) {
                assert!((found - exact).abs() <= 1e-14 * exact.abs(), "{text}: {found} {exact}");
            }
        }
    }
}
