//! The coefficients of a field, and their derivatives with respect to parameters, as numbers.
//!
//! In: a field and exact parameter values. Out: lists of terms; each coefficient is rounded once.

use std::collections::BTreeMap;

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::{Symbol, Symbols};

use crate::interpreted::round;
use crate::{Map, RuntimeFloat};

/// The indices of the states in a constant, linear or quadratic term.
type States = [Option<usize>; 2];

#[derive(Debug)]
pub(super) struct Terms<T> {
    entries: Vec<(T, usize)>,
    /// The linear terms k·x of the entries of f′, entry by entry: the index of x, and k.
    slopes: Vec<(usize, T)>,
    /// The constant and linear terms of f: component, state if any, and coefficient.
    linear: Vec<(usize, Option<usize>, T)>,
    /// The terms whose coefficients depend on parameters: component, states, and the end of the
    /// term's range in `by_parameters`.
    varying: Vec<(usize, States, usize)>,
    /// The derivatives of the coefficients in `varying`: the index of the parameter, and the
    /// number.
    by_parameters: Vec<(usize, T)>,
}

/// A coefficient, and its derivatives with respect to the parameters that occur in it.
#[derive(Default)]
struct Coefficient {
    value: Rational,
    slopes: BTreeMap<usize, Rational>,
}

impl Coefficient {
    fn add(&mut self, number: &Rational, powers: &[(usize, u32)], values: &[Rational]) {
        // `number` times all parameter powers. `Some(i)` lowers exponent i by 1, for a derivative.
        let product = |lowered: Option<usize>| {
            powers.iter().enumerate().fold(number.clone(), |product, (place, (k, power))| {
                let power = power - u32::from(lowered == Some(place));
                &product * &values[*k].pow(power.cast_signed()).expect("no exponent is negative")
            })
        };
        self.value = &self.value + &product(None);
        for (place, (k, power)) in powers.iter().enumerate() {
            let slope = self.slopes.entry(*k).or_default();
            *slope = &*slope + &(&product(Some(place)) * &Rational::from(i64::from(*power)));
        }
    }

    /// Divides by a nonzero divisor that may depend on parameters, by the quotient rule.
    fn divide_by(&mut self, divisor: &Coefficient) {
        if divisor.value.is_one() && divisor.slopes.is_empty() {
            return;
        }
        let reciprocal = divisor.value.recip().expect("the field is defined at its parameters");
        self.value = &self.value * &reciprocal;
        for (k, slope) in &divisor.slopes {
            let own = self.slopes.entry(*k).or_default();
            *own = &*own - &(&self.value * slope);
        }
        self.slopes.values_mut().for_each(|slope| *slope = &*slope * &reciprocal);
    }
}

/// Returns the coefficients of a polynomial, keyed by the states that they multiply.
fn coefficients(
    polynomial: &Polynomial,
    symbols: &Symbols,
    values: &[Rational],
) -> BTreeMap<States, Coefficient> {
    let mut all = BTreeMap::<States, Coefficient>::new();
    for (monomial, number) in polynomial.terms() {
        let (mut states, mut powers) = (Vec::new(), Vec::new());
        for (variable, power) in monomial.powers() {
            match symbols.symbol(*variable) {
                Symbol::Parameter(k) => powers.push((k, *power)),
                Symbol::State(i) => states.extend((0..*power).map(|_| i)),
                Symbol::Epsilon | Symbol::SecondState(_) => unreachable!("a field depends on neither"),
            }
        }
        let states = [states.first().copied(), states.get(1).copied()];
        all.entry(states).or_default().add(number, &powers, values);
    }
    all
}

impl<T: RuntimeFloat> Terms<T> {
    pub(super) fn of(map: &Map, count: usize, place: impl Fn(usize, usize) -> usize) -> Self {
        let (field, values) = (&map.field().system().field, map.parameters());
        let (mut entries, mut slopes) = (vec![(T::zero(), 0); count], Vec::new());
        let mut linear = Vec::new();
        let (mut varying, mut by_parameters) = (Vec::new(), Vec::new());
        for (i, component) in field.components.iter().enumerate() {
            let divisor = coefficients(component.denominator(), &field.symbols, values);
            let divisor = divisor.get(&[None, None]).expect("a divisor is not 0");
            for (states, mut coefficient) in coefficients(component.numerator(), &field.symbols, values) {
                coefficient.divide_by(divisor);
                let value: T = round(&coefficient.value);
                match states {
                    [Some(j), Some(k)] => slopes.extend([(place(i, j), k, value), (place(i, k), j, value)]),
                    [Some(j), None] => entries[place(i, j)].0 = value,
                    _ => {}
                }
                if states[1].is_none() {
                    linear.push((i, states[0], value));
                }
                if !coefficient.slopes.is_empty() {
                    by_parameters.extend(coefficient.slopes.iter().map(|(k, slope)| (*k, round(slope))));
                    varying.push((i, states, by_parameters.len()));
                }
            }
        }
        slopes.sort_by_key(|(place, _, _)| *place);
        let mut end = 0;
        for (place, (_, own)) in entries.iter_mut().enumerate() {
            end += slopes[end..].iter().take_while(|slope| slope.0 == place).count();
            *own = end;
        }
        let slopes = slopes.into_iter().map(|(_, state, coefficient)| (state, coefficient)).collect();
        Terms { entries, slopes, linear, varying, by_parameters }
    }

    pub(super) fn slopes(&self, x: &[T], slopes: &mut [T]) {
        // Four independent sums hide the latency of additions in the processor.
        const SUMS: usize = 4;
        let mut first = 0;
        for (slope, (constant, end)) in slopes.iter_mut().zip(&self.entries) {
            let (many, few) = self.slopes[first..*end].as_chunks::<SUMS>();
            let mut sums = [T::zero(); SUMS];
            for terms in many {
                for (sum, (state, coefficient)) in sums.iter_mut().zip(terms) {
                    *sum += *coefficient * x[*state];
                }
            }
            let few = few.iter().map(|(state, coefficient)| *coefficient * x[*state]);
            *slope = sums.into_iter().chain(few).fold(*constant, |sum, term| sum + term);
            first = *end;
        }
    }

    /// Returns μ·(c + ½Bx) for the vector μ = `mu` and the field ẋ = c + Bx + Q(x,x).
    pub(super) fn along_linear(&self, x: &[T], mu: &[T]) -> T {
        let half = T::one() / (T::one() + T::one());
        self.linear.iter().fold(T::zero(), |sum, (i, state, coefficient)| {
            sum + mu[*i] * *coefficient * state.map_or(T::one(), |state| half * x[state])
        })
    }

    /// For each parameter a, adds 2·`scale`·(`mu` · ∂q(x,y)/∂a) to its entry of `sums`, where q is
    /// the polarised field in Kahan's step (x̃ − x)/2ε = q(x,x̃).
    pub(super) fn add_by_parameters(&self, scale: T, [x, y]: [&[T]; 2], mu: &[T], sums: &mut [T]) {
        let mut first = 0;
        for (i, states, end) in &self.varying {
            let twice = match *states {
                [Some(j), Some(k)] => x[j] * y[k] + x[k] * y[j],
                [Some(j), None] => x[j] + y[j],
                _ => T::one() + T::one(),
            };
            let factor = scale * mu[*i] * twice;
            for (parameter, slope) in &self.by_parameters[first..*end] {
                sums[*parameter] += factor * *slope;
            }
            first = *end;
        }
    }
}
