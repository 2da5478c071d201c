//! Finds states whose next value is a function of the state itself and of earlier drifts.
//!
//! If a drift or integral F is a Möbius function of a single state xᵢ, then xᵢ is a function of F.
//! If the next value of another state w contains no states except w and such xᵢ, w is a drift. The
//! product of w with a power of an earlier drift may have a shorter text.

use std::slice::from_ref;

use kahan_algebra::poly::{Budget, Polynomial, Variable};
use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::symbols::{Symbol, Symbols};

use crate::claims::proved::Formula;
use crate::claims::writing::{is_product, quotient};

use super::normal::NextValue;
use super::{Constant, DriftKind};

const MOST_TERMS: usize = 2_000;
const MOST_WORK: u64 = 200_000;

/// The exponents k to try in products w·F^k of a state w and an earlier drift F.
const TRIED_POWERS: [i32; 5] = [0, 1, -1, 2, -2];

pub(super) struct TriangularSystem {
    /// The names of the states, followed by the names of drifts and integrals.
    symbols: Symbols,
    own: Symbols,
    components: Vec<Polynomial>,
    /// Each state as a function of drifts, if known.
    values: Vec<Option<RationalFunction>>,
    /// For each drift F: the symbol for F, F as a function of the states, and the next value of F
    /// as a function of the symbols of the drifts.
    steps: Vec<[RationalFunction; 3]>,
}

/// A candidate for a drift w·F^k, where w is a state and F an earlier drift.
pub(super) struct DriftCandidate {
    state: usize,
    pub(super) value: RationalFunction,
    pub(super) value_text: String,
    pub(super) next_text: String,
    next: RationalFunction,
    /// The state w as a function of the drift and of earlier drifts.
    solved: RationalFunction,
}

impl TriangularSystem {
    /// Starts without drifts. `names` are the names that drifts and integrals may get.
    pub(super) fn new(symbols: &Symbols, components: &[Polynomial], names: Vec<String>) -> Self {
        let states = [symbols.states.clone(), names].concat();
        let joint = Symbols { states, parameters: symbols.parameters.clone() };
        let components = components.iter().map(|component| moved(component, symbols, &joint)).collect();
        let values = vec![None; symbols.dimension()];
        TriangularSystem { symbols: joint, own: symbols.clone(), components, values, steps: Vec::new() }
    }

    fn variable(&self, name: &str) -> Option<Variable> {
        self.symbols.states.iter().position(|known| known == name).map(|index| self.symbols.state(index))
    }

    pub(super) fn written(
        &self,
        name: &str,
        next: &NextValue,
    ) -> Option<(RationalFunction, RationalFunction, DriftKind, String)> {
        let drift = RationalFunction::variable(self.variable(name)?);
        let next = next.mapped(|constant| self.moved(constant));
        let image = next.of(&drift)?;
        let (kind, text) = match &next {
            NextValue::Sum(step) => (DriftKind::Sum(self.constant(step)), self.sum(name.to_owned(), step)),
            NextValue::Multiple(factor) => (DriftKind::Multiple(self.constant(factor)), self.text(&image)),
            NextValue::Image(_) => (DriftKind::Image, self.text(&image)),
        };
        Some((drift, image, kind, text))
    }

    fn sum(&self, first: String, step: &RationalFunction) -> String {
        let size = self.text(step);
        match size.strip_prefix('-') {
            _ if step.is_zero() => first,
            Some(rest) if is_product(&size) => format!("{first} - {rest}"),
            Some(_) => format!("{first} + ({size})"),
            None => format!("{first} + {size}"),
        }
    }

    /// Writes the next value of a drift F in the form a·F + b.
    fn affine(&self, next: &RationalFunction, drift: Variable) -> Option<String> {
        let (above, below) = (next.numerator(), next.denominator());
        let is_affine = above.degree_where(|one| one == drift) == 1 && !below.contains(drift);
        let parts = above.coefficients_in(drift);
        let [free, linear] = [0, 1].map(|power| parts.get(&power).cloned().unwrap_or_default());
        let over = |part: Polynomial| RationalFunction::new(part, below.clone()).filter(|_| is_affine);
        let multiple = self.text(&over(&linear * &Polynomial::variable(drift))?);
        Some(self.sum(multiple, &over(free)?))
    }

    fn constant(&self, value: &RationalFunction) -> Constant {
        Constant { value: value.clone(), text: self.text(value) }
    }

    fn text(&self, function: &RationalFunction) -> String {
        quotient(&self.symbols, from_ref(function.numerator()), from_ref(function.denominator()), &[])
    }

    fn moved(&self, function: &RationalFunction) -> RationalFunction {
        let [above, below] =
            [function.numerator(), function.denominator()].map(|side| moved(side, &self.own, &self.symbols));
        RationalFunction::new(above, below).expect("a denominator is not zero")
    }

    pub(super) fn take_integral(&mut self, formula: &Formula) {
        if let Some(variable) = self.variable(formula.name()) {
            let value = RationalFunction::variable(variable);
            self.add_drift(value.clone(), [&formula.numerator, &formula.denominator], value);
        }
    }

    /// Records the drift above/below if a state is a function of the drift.
    pub(super) fn add_drift(
        &mut self,
        drift: RationalFunction,
        sides: [&Polynomial; 2],
        next: RationalFunction,
    ) {
        let [above, below] = sides.map(|side| moved(side, &self.own, &self.symbols));
        let mut states = (0..self.values.len()).filter(|&i| {
            let state = self.symbols.state(i);
            above.contains(state) || below.contains(state)
        });
        let (Some(state), None) = (states.next(), states.next()) else { return };
        let variable = self.symbols.state(state);
        if [&above, &below].iter().any(|side| side.degree_where(|one| one == variable) > 1) {
            return;
        }
        let part = |side: &Polynomial, power: u32| {
            let parts = side.coefficients_in(variable);
            RationalFunction::from(parts.get(&power).cloned().unwrap_or_default())
        };
        let ([a, b], [c, d]) =
            ([1, 0].map(|power| part(&above, power)), [1, 0].map(|power| part(&below, power)));
        // Solve F = (a·x + b)/(c·x + d) for the state x.
        self.values[state] = (&b - &(&d * &drift)).checked_div(&(&(&c * &drift) - &a));
        let in_states = RationalFunction::new(above, below).expect("a denominator is not zero");
        self.steps.push([drift, in_states, next]);
    }

    /// Returns the first state w that is a drift, or the shortest product w·F^k with a drift F.
    pub(super) fn link(&self, name: &str) -> Option<DriftCandidate> {
        if self.steps.is_empty() {
            return None;
        }
        let state = (0..self.values.len()).find(|&state| {
            let unknown = (0..self.values.len()).filter(|&i| i != state && self.values[i].is_none());
            let used = [&self.components[state], &self.components[self.values.len()]];
            self.values[state].is_none()
                && unknown.map(|i| self.symbols.state(i)).all(|i| used.iter().all(|side| !side.contains(i)))
        })?;
        let variable = self.variable(name)?;
        let drift = RationalFunction::variable(variable);
        let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
        let above = self.components[state].clone();
        let mut image = RationalFunction::new(above, self.components[self.values.len()].clone())?;
        for (i, value) in self.values.iter().enumerate() {
            if let Some(value) = value {
                image = image.compose_within(self.symbols.state(i), value, &mut budget).ok()??;
            }
        }
        let own = RationalFunction::variable(self.symbols.state(state));
        let link = |power: i32, step: Option<&[RationalFunction; 3]>| {
            let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
            let one = RationalFunction::one();
            let [factor, in_states, next_factor] = match step {
                Some(parts) => parts.each_ref().map(|part| raised(part, power)),
                None => [Some(one.clone()), Some(one.clone()), Some(one)],
            };
            let solved = drift.checked_div(&factor?)?;
            let moved = image.compose_within(self.symbols.state(state), &solved, &mut budget).ok()??;
            let next = moved.mul_within(&next_factor?, &mut budget).ok()?;
            let value = own.mul_within(&in_states?, &mut budget).ok()?;
            let texts = [self.affine(&next, variable), Some(self.text(&next))];
            let next_text = texts.into_iter().flatten().min_by_key(String::len)?;
            let value_text = self.text(&value);
            Some(DriftCandidate { state, value, value_text, next_text, next, solved })
        };
        let others = TRIED_POWERS[1..]
            .iter()
            .flat_map(|&power| self.steps.iter().map(move |step| (power, Some(step))));
        let links =
            [(TRIED_POWERS[0], None)].into_iter().chain(others).filter_map(|(power, step)| link(power, step));
        links.min_by_key(|link| link.value_text.len() + link.next_text.len())
    }

    pub(super) fn in_states(&self, link: &DriftCandidate) -> [Polynomial; 2] {
        [link.value.numerator(), link.value.denominator()].map(|side| moved(side, &self.symbols, &self.own))
    }

    pub(super) fn names(&self, link: &DriftCandidate) -> Vec<String> {
        let own = self.own.dimension();
        let is_used = |index: &usize| {
            let variable = self.symbols.state(*index);
            [link.next.numerator(), link.next.denominator()].iter().any(|side| side.contains(variable))
        };
        (own..self.symbols.dimension()).filter(is_used).map(|i| self.symbols.states[i].clone()).collect()
    }

    pub(super) fn keep(&mut self, name: &str, link: DriftCandidate) {
        let drift = self.variable(name).map(RationalFunction::variable);
        self.values[link.state] = Some(link.solved);
        self.steps.extend(drift.map(|drift| [drift, link.value, link.next]));
    }
}

fn raised(function: &RationalFunction, power: i32) -> Option<RationalFunction> {
    let base = if power < 0 { function.recip()? } else { function.clone() };
    Some((0..power.unsigned_abs()).fold(RationalFunction::one(), |product, _| &product * &base))
}

/// Rewrites the polynomial for another symbol table. States and parameters keep their indices.
fn moved(polynomial: &Polynomial, from: &Symbols, to: &Symbols) -> Polynomial {
    polynomial.map_variables(|variable| match from.symbol(variable) {
        Symbol::State(i) | Symbol::SecondState(i) => to.state(i),
        Symbol::Parameter(k) => to.parameter(k),
        Symbol::Epsilon => to.epsilon(),
    })
}
