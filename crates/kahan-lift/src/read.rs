//! Parses expressions into Laurent polynomials in coordinates.
//!
//! Functions become coordinates. If exp, sin, cos, sinh or cosh occurs with arguments such as u/2
//! and u/3, coordinates with the argument u/6 serve for both. The equations are read repeatedly
//! until no coordinate's argument changes.

use kahan_algebra::check::number;
use kahan_algebra::diagnostics::{Diagnostic, Kind};
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::syntax::{Constant, Expr, ExprKind, Factor, FormulaSyntax};
use kahan_algebra::token::Span;

use crate::laurent::{Laurent, Monomial};
use crate::ring::{CoordinateDefinition, Function, Ring};

const LARGEST_POWER: i64 = 64;
const MOST_TERMS: usize = 20_000;

type ReadResult<T> = Result<T, Diagnostic>;

#[derive(Debug, Default)]
pub(crate) struct Reader {
    /// The names of the states. The time `t` comes last.
    pub states: Vec<String>,
    pub parameters: Vec<String>,
    pub is_declared: bool,
    constants: Vec<(String, Laurent)>,
    pub ring: Ring,
    /// For each kind of function and each primitive argument: the greatest common divisor of all
    /// rational numbers that multiply this argument.
    units: Vec<(FunctionFamily, Laurent, Rational)>,
}

/// Functions whose values at n·u are polynomials in their values at u, for every integer n.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FunctionFamily {
    Exponential,
    Circular,
    Hyperbolic,
    Root,
}

fn refuse<T>(span: Span, message: impl Into<String>, help: impl Into<String>) -> ReadResult<T> {
    Err(Diagnostic::new(Kind::NotAPolynomial, span, message, help))
}

impl Reader {
    /// Reads the right-hand sides. Fails at the first expression that cannot be lifted.
    pub(crate) fn field(
        &mut self,
        sides: &[&Expr<FormulaSyntax>],
        constants: &[Constant<FormulaSyntax>],
    ) -> ReadResult<()> {
        loop {
            let before = self.units.clone();
            self.constants.clear();
            self.ring = Ring::default();
            self.ring.parameters = self.parameters.len();
            for state in 0..self.states.len() {
                self.ring.add(CoordinateDefinition::State(state), Laurent::number(Rational::one()));
            }
            for constant in constants {
                let value =
                    constant.value.as_ref().map_or_else(|| Ok(Laurent::zero()), |value| self.expr(value))?;
                self.constants.push((constant.name.text.clone(), value));
            }
            let mut field = sides.iter().map(|side| self.expr(side)).collect::<ReadResult<Vec<_>>>()?;
            if field.len() < self.states.len() {
                field.push(Laurent::number(Rational::one()));
            }
            if self.units == before {
                let field = field.iter().map(|side| self.ring.normalised(side)).collect();
                self.ring.set_field(field);
                return Ok(());
            }
        }
    }

    pub(crate) fn expr(&mut self, expr: &Expr<FormulaSyntax>) -> ReadResult<Laurent> {
        self.expr_with_sign(expr, 1)
    }

    /// Reads an expression if `sign` is 1, or its reciprocal if `sign` is −1. Factors of products
    /// are inverted one by one, so 1/P² and 1/P³ are powers of one coordinate 1/P.
    fn expr_with_sign(&mut self, expr: &Expr<FormulaSyntax>, sign: i64) -> ReadResult<Laurent> {
        let value = match &expr.kind {
            ExprKind::Product(factors) => {
                let mut product = Laurent::number(Rational::one());
                for Factor { expr: inner, divides } in factors {
                    let value = self.expr_with_sign(inner, if *divides { -sign } else { sign })?;
                    product = self.product(&product, &value, expr.span)?;
                }
                product
            }
            ExprKind::Power(base, exponent) => {
                let base = self.expr(base)?;
                self.power(&base, &(&Rational::from(*exponent) * &Rational::from(sign)), expr.span)?
            }
            ExprKind::Special(FormulaSyntax::Power(parts)) => {
                let is_e = matches!(&parts[0].kind, ExprKind::Name(name) if name == "e");
                if is_e && !self.is_declared && !self.states.iter().any(|state| state == "e") {
                    let help = "write `exp(…)` for the exponential; a parameter needs another name here";
                    return refuse(expr.span, "`e` is read as a name, not as the number 2.718…", help);
                }
                let (base, exponent) = (self.expr(&parts[0])?, self.expr(&parts[1])?);
                self.general_power(&base, &exponent.scale(&integer_constant(sign)), expr.span)?
            }
            _ if sign < 0 => {
                let value = self.expr(expr)?;
                self.power(&value, &Rational::from(-1), expr.span)?
            }
            ExprKind::Number(value) => Laurent::number(value.clone()),
            ExprKind::Name(name) => self.name(name, expr.span)?,
            ExprKind::Negation(inner) => self.expr(inner)?.scale(&integer_constant(-1)),
            ExprKind::Sum(terms) => {
                let mut sum = Laurent::zero();
                for term in terms {
                    sum.add_scaled(
                        &self.expr(&term.expr)?,
                        &integer_constant(if term.negative { -1 } else { 1 }),
                    );
                }
                sum
            }
            ExprKind::Special(FormulaSyntax::Call { function, arguments }) => match &arguments[..] {
                [_] if self.states.contains(function) => {
                    let help = format!(
                        "write `{function}` for the state, `{function}*(…)` for a product; for a delay a chain of \
                         states can stand: docs/how-to/texts.md shows how"
                    );
                    return refuse(expr.span, format!("`{function}(…)` is a state at another time"), help);
                }
                _ if let Some((message, help)) = reason_not_lifted(function) => {
                    return refuse(expr.span, message, help);
                }
                [argument] => {
                    let argument = self.expr(argument)?;
                    self.call(function, &argument, expr.span)?
                }
                [base, exponent] if function == "pow" => {
                    let (base, exponent) = (self.expr(base)?, self.expr(exponent)?);
                    self.general_power(&base, &exponent, expr.span)?
                }
                [time, ..] if matches!(&time.kind, ExprKind::Name(name) if name == "t") => {
                    let help = "a chain of states can stand for it: docs/how-to/texts.md shows how";
                    return refuse(expr.span, format!("`{function}(t …)` is a delay"), help);
                }
                _ => return refuse(expr.span, unknown(function), KNOWN_FUNCTIONS_HELP),
            },
        };
        if value.len() > MOST_TERMS {
            let message = format!("the expression has more than {MOST_TERMS} terms once it is expanded");
            return refuse(expr.span, message, "name a part of it as a parameter or a state");
        }
        Ok(value)
    }

    fn name(&self, name: &str, span: Span) -> ReadResult<Laurent> {
        if matches!(name, "eps" | "ε") {
            let help =
                "write a parameter for the coefficient; a quadratic field without a lift may have `eps^2`";
            return refuse(span, "the equations of a lift are free of `eps`", help);
        }
        if let Some(state) = self.states.iter().position(|known| known == name) {
            return Ok(Laurent::coordinate(state));
        }
        if let Some((_, value)) = self.constants.iter().find(|(known, _)| known == name) {
            return Ok(value.clone());
        }
        match self.parameters.iter().position(|known| known == name) {
            Some(index) => {
                let variable = Variable(u16::try_from(index).expect("fewer names than 16 bits number"));
                Ok(Laurent::constant(RationalFunction::variable(variable)))
            }
            None => Err(Diagnostic::new(
                Kind::Name,
                span,
                format!("`{name}` is neither a state nor a parameter"),
                match number(name) {
                    Some(number) => number,
                    None => format!("write its equation `{name}dot = …;`, or name it in the header"),
                },
            )),
        }
    }

    fn product(&self, left: &Laurent, right: &Laurent, span: Span) -> ReadResult<Laurent> {
        if left.len().saturating_mul(right.len()) > 50 * MOST_TERMS {
            return refuse(span, "the product has too many terms once it is expanded", "name a factor");
        }
        Ok(self.ring.product(left, right))
    }

    fn integer_power(&self, base: &Laurent, exponent: i64, span: Span) -> ReadResult<Laurent> {
        let mut power = Laurent::number(Rational::one());
        for _ in 0..exponent {
            power = self.product(&power, base, span)?;
        }
        Ok(power)
    }

    fn power(&mut self, base: &Laurent, exponent: &Rational, span: Span) -> ReadResult<Laurent> {
        let Some((numerator, denominator)) = exponent
            .as_small_ratio()
            .filter(|(above, below)| above.abs() <= LARGEST_POWER && *below <= LARGEST_POWER)
        else {
            let help = format!("powers up to {LARGEST_POWER} are read; name the power as a state");
            return refuse(span, format!("the exponent {exponent} is too large"), help);
        };
        if base.is_zero() {
            return match numerator {
                1.. => Ok(Laurent::zero()),
                0 => Ok(Laurent::number(Rational::one())),
                _ => refuse(span, "this divides by zero", "remove the divisor, or the term"),
            };
        }
        if denominator == 1 {
            if numerator >= 0 {
                return self.integer_power(base, numerator, span);
            }
            let content = base.monomial_content();
            let rest = base.shifted(&content.pow(-1));
            let (factor, rest) = rest.primitive();
            let inverse = RationalFunction::constant(factor.recip().expect("a coefficient is not 0"));
            let outer = Laurent::term(content.pow(-1), inverse);
            let one = match rest.as_constant() {
                Some(rest) => outer.scale(&RationalFunction::one().checked_div(&rest).expect("not 0")),
                None => outer.shifted(&self.root(&rest, 1, -1)),
            };
            return self.integer_power(&one, -numerator, span);
        }
        let (above, below) = (to_exponent(numerator), to_exponent(denominator));
        let power = self.root(base, below, above);
        Ok(self.ring.normal_form(&power))
    }

    fn root(&mut self, base: &Laurent, index: i16, exponent: i16) -> Monomial {
        let unit = self.common_unit(FunctionFamily::Root, base, &Rational::new(1, i64::from(index)));
        let finest =
            to_exponent(unit.recip().and_then(|unit| unit.as_i64()).expect("the inverse of an index"));
        let meaning = CoordinateDefinition::Root(base.clone(), finest);
        let coordinate = self.ring.find(&meaning).unwrap_or_else(|| {
            let coordinate = self.ring.coordinates.len();
            let factor = RationalFunction::constant(Rational::new(1, i64::from(finest)));
            let slope = Laurent::term(Monomial::power(coordinate, 1 - finest), factor);
            self.ring.add(meaning, slope);
            self.ring.relate_root(coordinate, finest, base);
            coordinate
        });
        Monomial::power(coordinate, exponent.saturating_mul(finest / index))
    }

    /// Returns the greatest common divisor of all multiples of `argument` so far, with `multiple`.
    fn common_unit(&mut self, family: FunctionFamily, argument: &Laurent, multiple: &Rational) -> Rational {
        let known = self.units.iter_mut().find(|(of, known, _)| *of == family && known == argument);
        match known {
            Some((_, _, unit)) => {
                *unit = unit.gcd(multiple);
                unit.clone()
            }
            None => {
                let unit = multiple.abs();
                self.units.push((family, argument.clone(), unit.clone()));
                unit
            }
        }
    }

    fn general_power(&mut self, base: &Laurent, exponent: &Laurent, span: Span) -> ReadResult<Laurent> {
        if let Some(number) = exponent.as_number() {
            return self.power(base, &number, span);
        }
        let Some(exponent) = exponent.as_constant() else {
            let logarithm = self.call("log", base, span)?;
            let argument = self.product(&logarithm, exponent, span)?;
            return self.call("exp", &argument, span);
        };
        if base.is_zero() {
            return refuse(span, "a power of 0 whose exponent is a parameter", "write a number");
        }
        // The constant part of an exponent is split off, as in b^(n + 2) = b^n b².
        let constant = exponent.as_polynomial().map_or_else(Rational::zero, |sum| {
            sum.terms().find(|(one, _)| one.is_one()).map_or_else(Rational::zero, |(_, value)| value.clone())
        });
        let symbolic = &exponent - &RationalFunction::constant(constant.clone());
        let (content, primitive) = signed_content(&symbolic);
        let meaning = CoordinateDefinition::Power(base.clone(), primitive.clone());
        let inverse = self.power(base, &Rational::from(-1), span)?.scale(&primitive);
        let slope = |own| inverse.shifted(&Monomial::power(own, 1));
        let coordinate = self.ring.coordinate(meaning, slope);
        let Some(times) = content.as_i64().filter(|times| times.abs() <= LARGEST_POWER) else {
            let help = "write the exponent as an integer multiple of a parameter";
            return refuse(span, "this exponent is a fraction of a parameter", help);
        };
        let symbolic = Laurent::from(Monomial::power(coordinate, to_exponent(times)));
        let number = self.power(base, &constant, span)?;
        self.product(&symbolic, &number, span)
    }

    fn call(&mut self, function: &str, argument: &Laurent, span: Span) -> ReadResult<Laurent> {
        let inverse = |reader: &mut Self, value: &Laurent| reader.power(value, &Rational::from(-1), span);
        if let Some((_, above, below)) = QUOTIENTS.iter().find(|(name, ..)| *name == function) {
            let below = self.call(below, argument, span)?;
            let below = inverse(self, &below)?;
            let Some(above) = above else { return Ok(below) };
            let above = self.call(above, argument, span)?;
            return self.product(&above, &below, span);
        }
        match function {
            "exp" => self.exponential(argument, span),
            "sin" => self.circular(FunctionFamily::Circular, argument, span).map(|[sine, _]| sine),
            "cos" => self.circular(FunctionFamily::Circular, argument, span).map(|[_, cosine]| cosine),
            "sinh" => self.circular(FunctionFamily::Hyperbolic, argument, span).map(|[sine, _]| sine),
            "cosh" => self.circular(FunctionFamily::Hyperbolic, argument, span).map(|[_, cosine]| cosine),
            // Since tan′ = 1 + tan² and tanh′ = 1 − tanh², derivatives need no further functions.
            "tan" => Ok(self.tangent(Function::Tan, argument, 1)),
            "tanh" => Ok(self.tangent(Function::Tanh, argument, -1)),
            "sqrt" => self.power(argument, &Rational::new(1, 2), span),
            "cbrt" => self.power(argument, &Rational::new(1, 3), span),
            "log" | "ln" => {
                let slope = inverse(self, argument)?;
                Ok(self.function(Function::Log, argument, slope))
            }
            _ => {
                // The name `arctan` means `atan`.
                let name = function.replace("arc", "a");
                let found = INVERSE_FUNCTIONS.iter().find(|(one, ..)| one.name() == name);
                let Some(&(function, [constant, square], [above, below])) = found else {
                    return refuse(span, unknown(function), KNOWN_FUNCTIONS_HELP);
                };
                let mut radicand = self.product(argument, argument, span)?.scale(&integer_constant(square));
                radicand.add_term(Monomial::one(), &integer_constant(constant));
                let slope = self.power(&radicand, &Rational::new(above, below), span)?;
                Ok(self.function(function, argument, slope))
            }
        }
    }

    fn function(&mut self, function: Function, argument: &Laurent, slope: Laurent) -> Laurent {
        let meaning = CoordinateDefinition::Function(function, argument.clone());
        Laurent::coordinate(self.ring.coordinate(meaning, |_| slope))
    }

    /// Returns the coordinate of a function T with T′ = 1 ± T².
    fn tangent(&mut self, function: Function, argument: &Laurent, sign: i64) -> Laurent {
        let own = Monomial::power(self.ring.coordinates.len(), 2);
        let mut slope = Laurent::number(Rational::one());
        slope.add_term(own, &integer_constant(sign));
        self.function(function, argument, slope)
    }

    /// Returns exp u as the product of the exponentials of the terms of u. If u has a constant term
    /// c, exp u is not split, because exp c would be an irrational coefficient.
    fn exponential(&mut self, argument: &Laurent, span: Span) -> ReadResult<Laurent> {
        if argument.is_zero() {
            return Ok(Laurent::number(Rational::one()));
        }
        let one_by_one = argument.coefficient(&Monomial::one()).is_zero();
        let parts: Vec<Laurent> = if one_by_one {
            argument.terms().map(|(one, value)| Laurent::term(one.clone(), value.clone())).collect()
        } else {
            vec![argument.clone()]
        };
        let mut product = Monomial::one();
        for part in parts {
            let (multiple, primitive) = part.primitive();
            let unit = self.common_unit(FunctionFamily::Exponential, &primitive, &multiple);
            let inner = primitive.scale(&RationalFunction::constant(unit.clone()));
            let meaning = CoordinateDefinition::Function(Function::Exp, inner);
            let coordinate = self.ring.coordinate(meaning, Laurent::coordinate);
            product = product.times(&Monomial::power(coordinate, self.times(&multiple, &unit, span)?));
        }
        Ok(Laurent::from(product))
    }

    fn times(&self, multiple: &Rational, unit: &Rational, span: Span) -> ReadResult<i16> {
        let times = multiple.checked_div(unit).and_then(|times| times.as_i64());
        match times.filter(|times| times.abs() <= LARGEST_POWER) {
            Some(times) => Ok(to_exponent(times)),
            None => {
                let message = "the arguments of these functions have no common measure that is near";
                refuse(span, message, "name one of the functions as a state")
            }
        }
    }

    fn circular(
        &mut self,
        family: FunctionFamily,
        argument: &Laurent,
        span: Span,
    ) -> ReadResult<[Laurent; 2]> {
        let one = Laurent::number(Rational::one());
        if argument.is_zero() {
            return Ok([Laurent::zero(), one]);
        }
        let (multiple, primitive) = argument.primitive();
        let unit = self.common_unit(family, &primitive, &multiple);
        let inner = primitive.scale(&RationalFunction::constant(unit.clone()));
        // `sign` is the sign in cos′ = −sin or cosh′ = sinh.
        let (functions, sign) = match family {
            FunctionFamily::Circular => ([Function::Sin, Function::Cos], -1),
            _ => ([Function::Sinh, Function::Cosh], 1),
        };
        let sign = integer_constant(sign);
        let sine = CoordinateDefinition::Function(functions[0], inner.clone());
        let at = self.ring.find(&sine).unwrap_or_else(|| {
            let at = self.ring.coordinates.len();
            self.ring.add(sine, Laurent::coordinate(at + 1));
            self.ring.add(
                CoordinateDefinition::Function(functions[1], inner),
                Laurent::coordinate(at).scale(&sign),
            );
            let [from, other] = if sign == RationalFunction::one() { [at + 1, at] } else { [at, at + 1] };
            let mut square = one.clone();
            square.add_term(Monomial::power(other, 2), &sign);
            self.ring.replace(Monomial::power(from, 2), square);
            at
        });
        let (base_sine, base_cosine) = (Laurent::coordinate(at), Laurent::coordinate(at + 1));
        let times = self.times(&multiple, &unit, span)?;
        let (mut sine, mut cosine) = (Laurent::zero(), one);
        for _ in 0..times.unsigned_abs() {
            let mut next = self.product(&sine, &base_cosine, span)?;
            next.add_scaled(&self.product(&cosine, &base_sine, span)?, &RationalFunction::one());
            let product = self.product(&sine, &base_sine, span)?;
            cosine = self.product(&cosine, &base_cosine, span)?;
            cosine.add_scaled(&product, &sign);
            sine = next;
        }
        if times < 0 {
            sine = sine.scale(&integer_constant(-1));
        }
        Ok([sine, cosine])
    }
}

const QUOTIENTS: [(&str, Option<&str>, &str); 6] = [
    ("cot", Some("cos"), "sin"),
    ("sec", None, "cos"),
    ("csc", None, "sin"),
    ("coth", Some("cosh"), "sinh"),
    ("sech", None, "cosh"),
    ("csch", None, "sinh"),
];

/// Functions of u with derivative (a + b·u²)^e, then \[a, b\], then \[p, q\] with e = p/q.
const INVERSE_FUNCTIONS: [(Function, [i64; 2], [i64; 2]); 5] = [
    (Function::Atan, [1, 1], [-1, 1]),
    (Function::Asin, [1, -1], [-1, 2]),
    (Function::Asinh, [1, 1], [-1, 2]),
    (Function::Acosh, [-1, 1], [-1, 2]),
    (Function::Atanh, [1, -1], [-1, 1]),
];

const KNOWN_FUNCTIONS_HELP: &str = "functions are sin, cos, tan, cot, sec, csc, sinh, cosh, tanh, coth, sech, csch, exp, log, sqrt, \
                     cbrt, asin, atan, asinh, acosh, atanh and pow; for a product write `f*(…)`";

/// Returns why a function is not lifted, and what to write instead; `None` for other functions.
fn reason_not_lifted(function: &str) -> Option<(String, &'static str)> {
    let help = match function {
        "acos" | "arccos" => "write `pi/2 - asin(u)` for `acos(u)`",
        "log2" => "write `c*log(u)`, with a parameter c = 1.4426950408889634",
        "log10" => "write `c*log(u)`, with a parameter c = 0.4342944819032518",
        "sigmoid" | "logistic" | "expit" => "write `1/(1 + exp(-u))`",
        "softplus" => "write `log(1 + exp(u))`",
        "sinc" => "write `sin(u)/u`, whose lift has a pole at u = 0",
        "sin2" | "sin3" | "cos2" | "cos3" => "write `sin(u)^2`",
        "erf" | "erfc" => {
            "write a state for it: E = erf(u) has Edot = c*exp(-u^2)*udot, with a parameter c = 1.1283791670955126, \
             and E = 0 where u = 0"
        }
        "gamma" | "Gamma" | "lgamma" | "zeta" => {
            return Some((
                format!("`{function}(…)` is not lifted: it solves no algebraic differential equation"),
                "approximate it by a rational function or by exponentials",
            ));
        }
        "atan2" | "arctan2" => "write `atan(y/x)` for `atan2(y, x)`, where x keeps its sign",
        "j0" | "J0" | "j1" | "J1" | "besselj" | "bessely" | "BesselJ" | "airy" => {
            "its linear equation in u can be written as two states, whose derivatives by u times udot stand in the field"
        }
        "abs" | "sign" | "sgn" | "max" | "min" | "floor" | "ceil" | "round" | "mod" | "fmod"
        | "heaviside" | "Heaviside" | "step" | "piecewise" | "Piecewise" | "relu" | "clip" | "if"
        | "where" => {
            return Some((
                format!("`{function}(…)` has a corner or a jump, and a lift needs an analytic field"),
                "write a smooth function, such as `sqrt(x^2 + d^2)` for |x| or `tanh(k*x)` for a sign, or study each \
                 side of the corner",
            ));
        }
        _ => return None,
    };
    Some((format!("`{function}(…)` is not lifted as it stands"), help))
}

fn unknown(function: &str) -> String {
    format!("`{function}(…)` is no function that can be lifted")
}

fn integer_constant(number: i64) -> RationalFunction {
    RationalFunction::constant(Rational::from(number))
}

fn to_exponent(number: i64) -> i16 {
    i16::try_from(number).expect("exponents are at most LARGEST_POWER, indices at most their multiple")
}

/// Writes a coefficient as a rational number times a primitive factor.
fn signed_content(value: &RationalFunction) -> (Rational, RationalFunction) {
    let content = value.numerator().content();
    let inverse = content.recip().expect("not 0");
    (content, value * &RationalFunction::from(Polynomial::constant(inverse)))
}
