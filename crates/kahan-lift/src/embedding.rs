//! A program without branches that computes the initial values of new variables.
//!
//! `Lift::embed` runs the program in `f64`. Generated code performs the same operations, so the
//! results have equal bits. Each operation is a correctly rounded operation of IEEE 754, a power by
//! repeated squaring, or a call of `libm`.

use kahan_algebra::arithmetic::{Exact, Float64};
use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_program::{Calls, Node, Program};

use crate::laurent::Laurent;
use crate::ring::{CoordinateDefinition, Function, Ring};

/// An input of the program that computes new variables: a state or a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// A state by its index in a point. The time, if present, has the highest index.
    State(usize),
    /// A parameter by its index.
    Parameter(usize),
}

/// A function that the program for the new variables calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CalledFunction {
    /// The power aⁿ by repeated squaring. For negative n, the reciprocal of a⁻ⁿ is returned.
    Power(i32),
    /// The power a^b by `libm::pow`.
    RealPower,
    /// The square root.
    SquareRoot,
    /// The cube root.
    CubeRoot,
    /// An elementary function.
    Elementary(Function),
}

impl CalledFunction {
    /// Returns the name of the function in generated code. All names but `power` are names in
    /// `libm`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            CalledFunction::Power(_) => "power",
            CalledFunction::RealPower => "pow",
            CalledFunction::SquareRoot => "sqrt",
            CalledFunction::CubeRoot => "cbrt",
            CalledFunction::Elementary(function) => function.name(),
        }
    }
}

impl kahan_program::Function for CalledFunction {
    fn arguments(&self) -> usize {
        if *self == CalledFunction::RealPower { 2 } else { 1 }
    }
}

/// An instruction of the program that computes new variables.
pub type Operation = kahan_program::Operation<Input, Rational, CalledFunction>;

impl Calls<CalledFunction> for Float64 {
    fn call(&self, function: &CalledFunction, a: &f64, b: &f64) -> Option<f64> {
        Some(match *function {
            CalledFunction::Power(exponent) => {
                let power = num_traits::pow(*a, exponent.unsigned_abs() as usize);
                if exponent < 0 { 1.0 / power } else { power }
            }
            CalledFunction::RealPower => libm::pow(*a, *b),
            CalledFunction::SquareRoot => libm::sqrt(*a),
            CalledFunction::CubeRoot => libm::cbrt(*a),
            CalledFunction::Elementary(function) => function.at(*a),
        })
    }
}

impl Calls<CalledFunction> for Exact {
    fn call(&self, function: &CalledFunction, a: &Rational, _: &Rational) -> Option<Rational> {
        match *function {
            CalledFunction::Power(exponent) => a.pow(exponent),
            _ => None,
        }
    }
}

/// The new variables as functions of the states and the parameters.
#[derive(Clone, Debug, Default)]
pub struct Embedding {
    /// The program. The outputs are the values of the new variables.
    pub program: Program<Vec<Operation>>,
    /// The values of the program's constants, in its registers. All other registers begin with 0.
    constants: Vec<f64>,
}

impl Embedding {
    fn new(program: Program<Vec<Operation>>) -> Self {
        let mut constants = vec![0.0; program.operations.len()];
        program.load(&Float64, |_| Some(0.0), &mut constants).expect("numbers have floats next to them");
        Embedding { program, constants }
    }

    /// Returns the new variables at a point, computed in floats.
    #[must_use]
    pub fn values(&self, states: &[f64], parameters: &[f64]) -> Vec<f64> {
        let found = self.run(states, parameters);
        self.program.outputs.iter().map(|value| found[value.0]).collect()
    }

    /// Returns the new variables at a point. Rational functions are computed exactly, and other
    /// functions in floats. Returns `None` if a value is infinite.
    pub(crate) fn exact(&self, states: &[Rational], parameters: &[Rational]) -> Option<Vec<Rational>> {
        let [floats, of] =
            [states, parameters].map(|one| one.iter().map(Rational::to_f64).collect::<Vec<_>>());
        let floats = self.run(&floats, &of);
        let operations = self.program.operations.iter().zip(floats).map(|(operation, float)| {
            Some(match operation {
                Operation::Call(CalledFunction::Power(_), ..) => operation.clone(),
                Operation::Call(..) => Operation::Constant(Rational::from_f64(float)?),
                _ => operation.clone(),
            })
        });
        let program = Program { operations: operations.collect::<Option<_>>()?, ..self.program.clone() };
        let input = |input: &Input| match *input {
            Input::State(index) => Some(states[index].clone()),
            Input::Parameter(index) => Some(parameters[index].clone()),
        };
        program.evaluate(&Exact, input).into_iter().collect()
    }

    fn run(&self, states: &[f64], parameters: &[f64]) -> Vec<f64> {
        let mut found = self.constants.clone();
        for (value, operation) in found.iter_mut().zip(&self.program.operations) {
            match *operation {
                Operation::Input(Input::State(index)) => *value = states[index],
                Operation::Input(Input::Parameter(index)) => *value = parameters[index],
                _ => {}
            }
        }
        self.program.compute(&Float64, 0, &mut found).expect("floats have quotients by zero");
        found
    }
}

pub(crate) struct Builder<'a> {
    ring: &'a Ring,
    program: kahan_program::Builder<Input, Rational, CalledFunction>,
    coordinates: Vec<Option<Node>>,
}

impl<'a> Builder<'a> {
    pub(crate) fn embedding<'b>(ring: &'a Ring, values: impl IntoIterator<Item = &'b Laurent>) -> Embedding {
        let (program, coordinates) = (kahan_program::Builder::default(), vec![None; ring.coordinates.len()]);
        let mut builder = Builder { ring, program, coordinates };
        let values: Vec<Node> = values.into_iter().map(|value| builder.laurent(value)).collect();
        Embedding::new(builder.program.finish(&values))
    }

    fn push(&mut self, operation: Operation) -> Node {
        self.program.push(operation)
    }

    fn number(&mut self, number: &Rational) -> Node {
        self.push(Operation::Constant(number.clone()))
    }

    fn call(&mut self, function: CalledFunction, argument: Node) -> Node {
        self.push(Operation::Call(function, argument, argument))
    }

    fn power(&mut self, base: Node, exponent: i32) -> Node {
        if exponent == 1 { base } else { self.call(CalledFunction::Power(exponent), base) }
    }

    /// Multiplies a number and factors from left to right. A number ±1 is omitted.
    fn product(&mut self, number: &Rational, factors: Vec<Node>) -> Node {
        let mut factors = factors.into_iter();
        let first = if number.abs().is_one() { factors.next() } else { None };
        let mut product = first.unwrap_or_else(|| self.number(number));
        if first.is_some() && number.is_negative() {
            product = self.push(Operation::Negate(product));
        }
        factors.fold(product, |product, factor| self.push(Operation::Multiply(product, factor)))
    }

    fn sum(&mut self, terms: Vec<Node>) -> Node {
        let sum = terms.into_iter().reduce(|sum, term| self.push(Operation::Add(sum, term)));
        sum.unwrap_or_else(|| self.number(&Rational::zero()))
    }

    fn polynomial(&mut self, polynomial: &Polynomial) -> Node {
        let mut terms = Vec::new();
        for (monomial, number) in polynomial.terms() {
            let mut factors = Vec::new();
            for &(parameter, exponent) in monomial.powers() {
                let parameter = self.push(Operation::Input(Input::Parameter(parameter.0.into())));
                factors.push(self.power(parameter, exponent.cast_signed()));
            }
            terms.push(self.product(number, factors));
        }
        self.sum(terms)
    }

    /// Splits a coefficient into a rational number and a factor that depends on parameters.
    fn coefficient(&mut self, value: &RationalFunction) -> (Rational, Option<Node>) {
        if let Some(number) = value.as_polynomial().and_then(Polynomial::as_constant) {
            return (number, None);
        }
        let above = self.polynomial(value.numerator());
        let whole = if value.denominator().is_one() {
            above
        } else {
            let below = self.polynomial(value.denominator());
            self.push(Operation::Divide(above, below))
        };
        (Rational::one(), Some(whole))
    }

    fn laurent(&mut self, polynomial: &Laurent) -> Node {
        let mut terms = Vec::new();
        for (monomial, value) in polynomial.terms() {
            let (number, factor) = self.coefficient(value);
            let mut factors: Vec<Node> = factor.into_iter().collect();
            for (coordinate, exponent) in monomial.powers() {
                let coordinate = self.coordinate(coordinate);
                factors.push(self.power(coordinate, exponent.into()));
            }
            terms.push(self.product(&number, factors));
        }
        self.sum(terms)
    }

    fn coordinate(&mut self, index: usize) -> Node {
        if let Some(known) = self.coordinates[index] {
            return known;
        }
        let ring = self.ring;
        let meaning = &ring.coordinates[index].meaning;
        let argument = meaning.argument().map(|argument| self.laurent(argument));
        let place = match (meaning, argument) {
            (CoordinateDefinition::State(state), _) => self.push(Operation::Input(Input::State(*state))),
            (CoordinateDefinition::Function(function, _), Some(argument)) => {
                self.call(CalledFunction::Elementary(*function), argument)
            }
            (CoordinateDefinition::Root(_, 2), Some(argument)) => {
                self.call(CalledFunction::SquareRoot, argument)
            }
            (CoordinateDefinition::Root(_, 3), Some(argument)) => {
                self.call(CalledFunction::CubeRoot, argument)
            }
            (CoordinateDefinition::Root(_, degree @ 4..), Some(argument)) => {
                let exponent = self.number(&Rational::new(1, i64::from(*degree)));
                self.push(Operation::Call(CalledFunction::RealPower, argument, exponent))
            }
            (CoordinateDefinition::Power(_, exponent), Some(argument)) => {
                let (number, factor) = self.coefficient(exponent);
                let exponent = factor.unwrap_or_else(|| self.number(&number));
                self.push(Operation::Call(CalledFunction::RealPower, argument, exponent))
            }
            (CoordinateDefinition::Root(..) | CoordinateDefinition::Sum(_), Some(argument)) => argument,
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

    #[test]
    fn programs_have_the_exact_values_to_rounding() {
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
