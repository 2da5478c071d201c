//! The field as the user wrote it. Sums that are factors, and reciprocals of divisors, are named
//! subexpressions.
//!
//! Expansion can lose digits. For example, `(p - q)*x*y` is accurate for p near q, but `p*x*y -
//! q*x*y` is not. An expanded product of divisors can also be rounded to 0 although no divisor is
//! 0. Steps in floats therefore usually keep subexpressions without states, and sums of states
//! whose expansion may lose digits. With all subexpressions inserted, the components are those of
//! the [`Field`].

use kahan_program::Numbered;
use kahan_syntax::rational::Rational;
use kahan_syntax::table::sorted_by_key;

use crate::field::Field;
use crate::kahan::SparseRows;
use crate::poly::{Monomial, Polynomial, Variable};
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;

/// A quantity with respect to which orbits are differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sensitivity {
    /// All coordinates of the first point.
    Start,
    /// The parameter with this index.
    Parameter(usize),
    /// The parameter ε, which is half the time step.
    Epsilon,
}

/// A named subexpression in states, parameters and earlier subexpressions.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Value {
    /// A sum that is a factor of a product.
    Sum(Polynomial),
    /// The reciprocal of a divisor without states.
    Reciprocal(Polynomial),
}

/// The named subexpressions of a field, as variables with numbers above those of all symbols.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Subexpressions {
    first: usize,
    epsilon: Variable,
    pub(crate) values: Numbered<Value>,
}

/// A field written with named subexpressions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FieldWithSubexpressions {
    pub(crate) values: Subexpressions,
    pub(crate) components: Vec<Polynomial>,
}

/// A field for step plans. Each subexpression without states is replaced by a new parameter.
#[derive(Clone, Debug)]
pub(crate) struct FieldWithConstants {
    pub(crate) field: Field,
    /// The field with sums of states as subexpressions. `None` if all sums are expanded.
    pub(crate) kept: Option<FieldWithSubexpressions>,
    /// For each new parameter, the index of the subexpression that it replaces.
    pub(crate) places: Vec<usize>,
    pub(crate) values: Subexpressions,
    pub(crate) symbols: Symbols,
}

impl Value {
    pub(crate) fn polynomial(&self) -> &Polynomial {
        let (Value::Sum(polynomial) | Value::Reciprocal(polynomial)) = self;
        polynomial
    }

    fn map(&self, change: impl Fn(&Polynomial) -> Polynomial) -> Self {
        match self {
            Value::Sum(sum) => Value::Sum(change(sum)),
            Value::Reciprocal(divisor) => Value::Reciprocal(change(divisor)),
        }
    }
}

impl Subexpressions {
    pub(crate) fn of(symbols: &Symbols) -> Self {
        Subexpressions { first: symbols.count(), epsilon: symbols.epsilon(), values: Numbered::default() }
    }

    /// Returns the index of the subexpression that a variable stands for.
    pub(crate) fn place(&self, variable: Variable) -> Option<usize> {
        usize::from(variable.0).checked_sub(self.first)
    }

    fn variable(&self, place: usize) -> Option<Variable> {
        u16::try_from(self.first + place).ok().map(Variable)
    }

    /// Returns the variable of a subexpression, which is added if new. Returns `None` if there are
    /// more than 2¹⁶ variables.
    fn intern(&mut self, value: Value) -> Option<Variable> {
        let place = self.values.number(value);
        self.variable(place)
    }

    fn with(mut self, values: impl IntoIterator<Item = Value>) -> Self {
        values.into_iter().for_each(|value| _ = self.values.number(value));
        self
    }

    /// Returns a single term itself, and a sum as a number times a named subexpression.
    pub(crate) fn factor(&mut self, polynomial: &Polynomial) -> Polynomial {
        if polynomial.len() < 2 {
            return polynomial.clone();
        }
        let (mut content, mut sum) = (polynomial.content(), polynomial.primitive_part());
        let other = Value::Sum(-&sum);
        if self.values.find(&other).is_some()
            || (content.is_negative() && self.values.find(&Value::Sum(sum.clone())).is_none())
        {
            (content, sum) = (-content, -&sum);
        }
        match self.intern(Value::Sum(sum)) {
            Some(value) => Polynomial::variable(value).scale(&content),
            None => polynomial.clone(),
        }
    }

    /// Returns the quotient by a nonzero divisor without states. Common monomials are cancelled
    /// first.
    pub(crate) fn quotient(&mut self, dividend: &Polynomial, divisor: &Polynomial) -> Option<Polynomial> {
        let (dividend, divisor) = (self.factor(dividend), self.factor(divisor));
        let common = dividend.monomial_content().gcd(&divisor.monomial_content());
        let [dividend, divisor] =
            [dividend, divisor].map(|of| of.div_monomial(&common).expect("all terms have it in common"));
        Some(&dividend * &self.reciprocal(&divisor)?)
    }

    /// Returns whether every divisor in the polynomial and its subexpressions is a factor of
    /// `denominator`.
    pub(crate) fn divide_only_by(&self, polynomial: &Polynomial, denominator: &Polynomial) -> bool {
        let mut places = polynomial.variables().into_iter().filter_map(|variable| self.place(variable));
        places.all(|place| match &self.values[place] {
            Value::Reciprocal(divisor) => denominator.checked_div(&self.with_sums(divisor)).is_some(),
            Value::Sum(sum) => self.divide_only_by(sum, denominator),
        })
    }

    fn with_sums(&self, polynomial: &Polynomial) -> Polynomial {
        polynomial.variables().into_iter().fold(polynomial.clone(), |polynomial, variable| {
            match self.place(variable).map(|place| &self.values[place]) {
                Some(value) => polynomial.composed(variable, &self.with_sums(value.polynomial())),
                None => polynomial,
            }
        })
    }

    /// Returns the reciprocal of a nonzero polynomial without states. Returns `None` if there are
    /// more than 2¹⁶ variables.
    pub(crate) fn reciprocal(&mut self, divisor: &Polynomial) -> Option<Polynomial> {
        let inverse = divisor.content().recip().expect("a divisor is not zero");
        let primitive = divisor.scale(&inverse);
        if primitive.is_one() {
            return Some(Polynomial::constant(inverse));
        }
        self.intern(Value::Reciprocal(primitive)).map(|value| Polynomial::variable(value).scale(&inverse))
    }

    /// Returns the derivatives with respect to the wanted variables, by the chain rule. Derivatives
    /// that are sums become named subexpressions.
    fn gradient(
        &mut self,
        polynomial: &Polynomial,
        is_wanted: &dyn Fn(Variable) -> bool,
        of_values: &mut Vec<Option<Gradient>>,
    ) -> Gradient {
        let mut gradient = Gradient::default();
        let slopes = polynomial.gradient(|variable| is_wanted(variable) || self.place(variable).is_some());
        for (variable, slope) in slopes {
            if is_wanted(variable) {
                add_slope(&mut gradient, variable, slope);
            } else if let Some(place) = self.place(variable) {
                for (inner_variable, inner) in self.gradient_of_value(place, is_wanted, of_values) {
                    add_slope(&mut gradient, inner_variable, &slope * &inner);
                }
            }
        }
        gradient
    }

    fn gradient_of_value(
        &mut self,
        place: usize,
        is_wanted: &dyn Fn(Variable) -> bool,
        of_values: &mut Vec<Option<Gradient>>,
    ) -> Gradient {
        if of_values.len() <= place {
            of_values.resize(place + 1, None);
        }
        if let Some(known) = &of_values[place] {
            return known.clone();
        }
        let value = self.values[place].clone();
        let factor = match value {
            Value::Sum(_) => Polynomial::one(),
            // The derivative of 1/q is −q′·(1/q)².
            Value::Reciprocal(_) => {
                let own = self.variable(place).expect("it has a variable");
                Polynomial::term(Monomial::power(own, 2), -Rational::ONE)
            }
        };
        let slopes = self.gradient(value.polynomial(), is_wanted, of_values).into_iter();
        let times = |(variable, slope)| (variable, &self.factor(&slope) * &factor);
        let gradient: Gradient = slopes.map(times).collect();
        of_values[place] = Some(gradient.clone());
        gradient
    }
}

/// The nonzero derivatives of a polynomial with their variables, in any order.
type Gradient = Vec<(Variable, Polynomial)>;

fn add_slope(gradient: &mut Gradient, variable: Variable, slope: Polynomial) {
    match gradient.iter_mut().find(|(known, _)| *known == variable) {
        Some((_, sum)) => *sum = &*sum + &slope,
        None => gradient.push((variable, slope)),
    }
}

impl FieldWithSubexpressions {
    /// Builds a field with only those subexpressions that its components need. If ε occurs only in
    /// even powers, these become powers of the first subexpression, which is ε².
    pub(crate) fn new(values: Subexpressions, components: Vec<Polynomial>) -> Self {
        let mut is_needed = vec![false; values.values.len()];
        let mark = |is_needed: &mut Vec<bool>, polynomial: &Polynomial| {
            for place in polynomial.variables().into_iter().filter_map(|variable| values.place(variable)) {
                is_needed[place] = true;
            }
        };
        components.iter().for_each(|component| mark(&mut is_needed, component));
        for place in (0..values.values.len()).rev() {
            if is_needed[place] {
                mark(&mut is_needed, values.values[place].polynomial());
            }
        }
        let needed = values.values.iter().enumerate().filter(|(place, _)| is_needed[*place]);
        let mut polynomials = needed.clone().map(|(_, value)| value.polynomial()).chain(&components);
        let epsilon = values.epsilon;
        let is_over_square = polynomials.clone().any(|of| of.contains(epsilon))
            && polynomials.all(|of| of.is_even_in(epsilon));
        if values.values.is_empty() && !is_over_square {
            return FieldWithSubexpressions { values, components };
        }
        let mut kept = Subexpressions { values: Numbered::default(), ..values };
        let square = Value::Sum(Polynomial::term(Monomial::power(epsilon, 2), Rational::ONE));
        let own = if is_over_square { kept.intern(square.clone()) } else { None };
        let mut renamed: Vec<Option<Variable>> = vec![None; values.values.len()];
        let changed = |polynomial: &Polynomial, renamed: &[Option<Variable>]| {
            let power = |&(variable, exponent): &(Variable, u32)| match (values.place(variable), own) {
                (Some(place), _) => {
                    (renamed[place].expect("values stand behind those that they are made of"), exponent)
                }
                (None, Some(square)) if variable == epsilon => (square, exponent / 2),
                (None, _) => (variable, exponent),
            };
            polynomial.map_monomials(|monomial| Some(monomial.powers().iter().map(power).collect()))
        };
        for (place, value) in needed {
            let is_square = is_over_square && *value == square;
            let value = if is_square { square.clone() } else { value.map(|of| changed(of, &renamed)) };
            renamed[place] = kept.intern(value);
        }
        let components = components.iter().map(|component| changed(component, &renamed)).collect();
        FieldWithSubexpressions { components, values: kept }
    }

    /// Returns the written form of an expanded field. Its divisors are the denominators.
    pub(crate) fn of(field: &Field) -> Self {
        let mut values = Subexpressions::of(&field.symbols);
        let components = field.components.iter().map(|component| {
            let reciprocal = values.reciprocal(component.denominator()).expect("a state has one divisor");
            component.numerator() * &reciprocal
        });
        let components = components.collect();
        FieldWithSubexpressions::new(values, components)
    }

    pub(crate) fn has_odd_powers_of_eps(&self) -> bool {
        let Subexpressions { epsilon, values, .. } = &self.values;
        let mut polynomials = values.iter().map(Value::polynomial).chain(&self.components);
        !polynomials.all(|polynomial| polynomial.is_even_in(*epsilon))
    }

    /// Returns the field at this ε, where divisors must be nonzero.
    pub(crate) fn at_eps(&self, symbols: &Symbols, eps: &Rational) -> Self {
        let mut values = Subexpressions::of(symbols);
        let put = |variable| match variable == symbols.epsilon() {
            true => Polynomial::constant(eps.clone()),
            false => Polynomial::variable(variable),
        };
        let components = self.with(&mut values, put);
        FieldWithSubexpressions::new(values, components)
    }

    /// Returns the field extended by a vector of derivatives for each quantity in `by`. `tangent`
    /// contains the names of the extended field.
    pub(crate) fn sensitivities(&self, symbols: &Symbols, tangent: &Symbols, by: &[Sensitivity]) -> Self {
        let (mut values, rows) = self.jacobian(symbols);
        let sources: Vec<Vec<Polynomial>> =
            by.iter().map(|by| self.parameter_derivatives(symbols, &mut values, *by)).collect();
        let moved = Subexpressions::of(tangent);
        let rename = |variable: Variable| match values.place(variable) {
            Some(place) => moved.variable(place).expect("values are fewer than 16 bits can number"),
            None => tangent.variable(symbols.symbol(variable)),
        };
        let mut components: Vec<Polynomial> =
            self.components.iter().map(|component| component.map_variables(rename)).collect();
        for (vector, (by, sources)) in by.iter().zip(sources).enumerate() {
            let first = (vector + 1) * symbols.dimension();
            for (row, source) in rows.iter().zip(sources) {
                let mut source = source.map_variables(rename);
                if *by == Sensitivity::Epsilon {
                    let inverse = tangent.parameter(tangent.parameters.len() - 1);
                    source = &source * &Polynomial::variable(inverse);
                }
                components.push(row.iter().fold(source, |sum, (k, slope)| {
                    let entry = Polynomial::variable(tangent.state(first + k));
                    &sum + &(&slope.map_variables(rename) * &entry)
                }));
            }
        }
        let renamed = values.values.iter().map(|value| value.map(|of| of.map_variables(rename)));
        FieldWithSubexpressions::new(Subexpressions::of(tangent).with(renamed), components)
    }

    /// Returns ∂f/∂a for a parameter a. For ε, returns ∂(εf)/∂ε, which the caller divides by ε.
    fn parameter_derivatives(
        &self,
        symbols: &Symbols,
        values: &mut Subexpressions,
        by: Sensitivity,
    ) -> Vec<Polynomial> {
        let name = match by {
            Sensitivity::Start => return vec![Polynomial::zero(); self.components.len()],
            Sensitivity::Parameter(k) => symbols.parameter(k),
            Sensitivity::Epsilon => symbols.epsilon(),
        };
        let mut of_values = Vec::new();
        let source = |component: &Polynomial| {
            let slopes = values.gradient(component, &|variable| variable == name, &mut of_values);
            let slope = slopes.into_iter().next().map_or_else(Polynomial::zero, |(_, slope)| slope);
            if by == Sensitivity::Epsilon {
                component + &(&slope * &Polynomial::variable(name))
            } else {
                slope
            }
        };
        self.components.iter().map(source).collect()
    }

    /// Returns the nonzero entries of f′(x) by rows, and their subexpressions.
    pub(crate) fn jacobian(&self, symbols: &Symbols) -> (Subexpressions, SparseRows) {
        let mut values = self.values.clone();
        let mut of_values = Vec::new();
        let row = |component: &Polynomial| {
            let is_state = |variable| symbols.is_state(variable);
            let slopes = values.gradient(component, &is_state, &mut of_values);
            let slopes = slopes.into_iter().filter(|(_, slope)| !slope.is_zero());
            sorted_by_key(slopes.map(|(state, slope)| (usize::from(state.0), slope)), |(state, _)| *state)
        };
        let rows = self.components.iter().map(row).collect();
        (values, rows)
    }

    /// Replaces subexpressions without states by parameters. Returns `field` unchanged if the
    /// result would have monomials in the states that `field` lacks.
    pub(crate) fn with_constants(&self, field: &Field) -> FieldWithConstants {
        self.with_values_free_of(field, |variable| field.symbols.is_state(variable))
    }

    /// Replaces a subexpression by a parameter unless `varies` is true for a variable in it. Leaves
    /// `field` unchanged if a variable in a divisor varies, or if monomials would be added.
    pub(crate) fn with_values_free_of(
        &self,
        field: &Field,
        varies: impl Fn(Variable) -> bool,
    ) -> FieldWithConstants {
        let symbols = &field.symbols;
        let mut over = symbols.clone();
        let (mut places, mut moving) = (Vec::new(), Vec::new());
        for (place, value) in self.values.values.iter().enumerate() {
            let is_moving = |variable: &Variable| match self.values.place(*variable) {
                Some(place) => moving.binary_search(&place).is_ok(),
                None => varies(*variable),
            };
            if value.polynomial().variables().iter().any(is_moving) {
                if matches!(value, Value::Reciprocal(_)) {
                    return FieldWithConstants::plain(field);
                }
                moving.push(place);
            } else {
                over.parameters.push(format!("value {place}"));
                places.push(place);
            }
        }
        let sums = Subexpressions::of(&over);
        let rename = |variable: Variable| match self.values.place(variable) {
            Some(place) => match places.binary_search(&place) {
                Ok(index) => over.parameter(symbols.parameters.len() + index),
                Err(before) => {
                    sums.variable(place - before).expect("values are fewer than 16 bits can number")
                }
            },
            None => over.variable(symbols.symbol(variable)),
        };
        let values = moving.iter().map(|&place| self.values.values[place].map(|of| of.map_variables(rename)));
        let values = Subexpressions::of(&over).with(values);
        let components = self.components.iter().map(|component| component.map_variables(rename)).collect();
        let kept = FieldWithSubexpressions { values, components };
        let states = |polynomial: &Polynomial| -> Vec<_> {
            let by_states = polynomial.group(|variable| symbols.is_state(variable));
            by_states.into_iter().map(|(states, _)| states).collect()
        };
        let expanded: Vec<RationalFunction> =
            kept.components.iter().map(|of| kept.values.with_sums(of).into()).collect();
        let mut pairs = expanded.iter().zip(&field.components);
        let is_as_sparse = pairs.all(|(over, own)| states(over.numerator()) == states(own.numerator()));
        if !is_as_sparse {
            return FieldWithConstants::plain(field);
        }
        let field = Field { components: expanded, symbols: over };
        let (values, symbols) = (self.values.clone(), symbols.clone());
        FieldWithConstants { field, kept: Some(kept), places, values, symbols }
    }

    /// Returns whether a step that is planned from expanded sums may lose digits.
    ///
    /// This may happen if a term contains two written sums, or a constant and a sum as in
    /// `(y - 1)/s`. In ẋᵢ, a constant times a sum with xᵢ is harmless, because the constant is also
    /// on the diagonal of A. The caller ensures that all subexpressions are sums.
    pub(crate) fn needs_sums(&self, symbols: &Symbols) -> bool {
        let is_sum = |variable: Variable| self.values.place(variable).is_some();
        let is_constant = |variable: Variable| !is_sum(variable) && !symbols.is_state(variable);
        self.components.iter().enumerate().any(|(i, component)| {
            let own = symbols.state(i);
            let has_own = |variable: Variable| {
                is_sum(variable) && self.values.with_sums(&Polynomial::variable(variable)).contains(own)
            };
            component.terms().any(|(monomial, _)| match monomial.degree_where(is_sum) {
                0 => false,
                1 => monomial.degree_where(is_constant) > 0 && monomial.degree_where(has_own) == 0,
                _ => true,
            })
        })
    }

    /// Replaces each variable of the components by the result of `put`. New subexpressions are
    /// added to `others`.
    pub(crate) fn with(
        &self,
        others: &mut Subexpressions,
        put: impl Fn(Variable) -> Polynomial,
    ) -> Vec<Polynomial> {
        let mut moved: Vec<Polynomial> = Vec::with_capacity(self.values.values.len());
        let in_others = |polynomial: &Polynomial, moved: &[Polynomial]| {
            let term = |(monomial, coefficient): (&Monomial, &Rational)| {
                let one = Polynomial::constant(coefficient.clone());
                monomial.powers().iter().fold(one, |product, &(variable, exponent)| {
                    let factor = match self.values.place(variable) {
                        Some(place) => moved[place].clone(),
                        None => put(variable),
                    };
                    (0..exponent).fold(product, |product, _| &product * &factor)
                })
            };
            let terms: Vec<Polynomial> = polynomial.terms().map(term).collect();
            Polynomial::sum_of(terms.iter().map(|term| (false, term)))
        };
        for value in self.values.values.iter() {
            let polynomial = in_others(value.polynomial(), &moved);
            moved.push(match value {
                Value::Sum(_) => others.factor(&polynomial),
                Value::Reciprocal(_) => {
                    others.reciprocal(&polynomial).expect("values are fewer than 16 bits can number")
                }
            });
        }
        self.components.iter().map(|component| in_others(component, &moved)).collect()
    }
}

impl FieldWithConstants {
    /// Returns the expanded field without new parameters.
    pub(crate) fn plain(field: &Field) -> Self {
        let symbols = field.symbols.clone();
        let values = Subexpressions::of(&symbols);
        FieldWithConstants { field: field.clone(), kept: None, places: Vec::new(), values, symbols }
    }

    pub(crate) fn is_plain(&self) -> bool {
        self.places.is_empty()
    }
}
