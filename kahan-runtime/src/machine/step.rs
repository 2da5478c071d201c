//! The step of a map as a program from a state to the next, in every precision and with or without
//! compensation: what generated code does, operation by operation.

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::plan::{Plan, StepPlan};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::Precision;
use kahan_jit::Instruction::*;
use kahan_jit::Program;

use super::StepKind;
use super::double_double::{DoubleDouble, Pair};
use super::recorder::Recorder;

/// A component's increment: a numerator, by a reciprocal or as it is.
pub(super) type Quotient<V> = (V, Option<V>);

/// The increments of a kernel in an arithmetic; `state` and `constant` are its inputs.
pub(super) fn quotients<A: Arithmetic>(
    step: &StepPlan,
    symbols: &Symbols,
    arithmetic: &A,
    state: impl Fn(usize) -> A::Value,
    constant: impl Fn(usize) -> A::Value,
) -> Vec<Quotient<A::Value>> {
    let prepared: Vec<_> = (0..step.constants.outputs.len()).map(|k| Some(constant(k))).collect();
    let results = evaluate(&step.kernel, symbols, arithmetic, &prepared, |symbol| match symbol {
        Symbol::State(i) => Some(state(i)),
        _ => None,
    });
    let (numerators, reciprocals) = results.split_at(step.reciprocals.len());
    let reciprocal = |place: &Option<usize>| place.map(|place| reciprocals[place].clone());
    numerators.iter().cloned().zip(step.reciprocals.iter().map(reciprocal)).collect()
}

/// The results of a plan in an arithmetic that divides by everything.
pub(super) fn evaluate<A: Arithmetic>(
    plan: &Plan,
    symbols: &Symbols,
    arithmetic: &A,
    prepared: &[Option<A::Value>],
    input: impl Fn(Symbol) -> Option<A::Value>,
) -> Vec<A::Value> {
    let results = plan.evaluate_prepared(arithmetic, prepared, |variable| input(symbols.symbol(variable)));
    results
        .into_iter()
        .map(|result| result.unwrap_or_else(|| unreachable!("every input has a value")))
        .collect()
}

impl StepKind {
    /// The program from the numbers of a state to those of the next, for a map of n variables and
    /// the prepared constants of `step`.
    ///
    /// The numbers are x₁, …, xₙ; compensated, what each of them lacks comes behind. In
    /// double-double each is two numbers, the high one first, and the guard comes last.
    pub(super) fn program(self, step: &StepPlan, symbols: &Symbols) -> Program {
        match self.precision {
            Precision::Single | Precision::Double => self.rounded(step, symbols),
            Precision::SingleThroughDouble => self.through_double(step, symbols),
            Precision::DoubleDouble => self.double_double(step, symbols),
        }
    }

    /// The number of its precision that is nearest to another.
    fn nearest(self) -> fn(&Rational) -> f64 {
        if self.precision == Precision::Single { |number| number.to_f32().into() } else { Rational::to_f64 }
    }

    fn rounded(self, step: &StepPlan, symbols: &Symbols) -> Program {
        let recorder = Recorder::new(self.nearest());
        let state = states(&recorder, 0..symbols.dimension());
        let quotients = self.quotients(&recorder, step, symbols, &state);
        let mut results: Vec<usize> = Vec::new();
        if !self.compensated {
            results.extend(next(&recorder, &quotients, &state));
            return recorder.finish(results);
        }
        let mut lacking = Vec::new();
        for (i, (&x, &quotient)) in state.iter().zip(&quotients).enumerate() {
            let carry = recorder.push(State(state.len() + i));
            let base = recorder.push(Add(x, carry));
            let moved = recorder.push(Subtract(base, x));
            let rest = recorder.push(Subtract(carry, moved));
            let next = added(&recorder, quotient, base);
            let distance = recorder.push(Subtract(next, base));
            let lacks = recorder.push(match quotient {
                (numerator, Some(reciprocal)) => MultiplySubtract(numerator, reciprocal, distance),
                (increment, None) => Subtract(increment, distance),
            });
            results.push(next);
            lacking.push(recorder.push(Add(rest, lacks)));
        }
        results.extend(lacking);
        recorder.finish(results)
    }

    fn through_double(self, step: &StepPlan, symbols: &Symbols) -> Program {
        let recorder = Recorder::new(Rational::to_f64);
        let state = states(&recorder, 0..symbols.dimension());
        let quotients = self.quotients(&recorder, step, symbols, &state);
        let (mut results, mut lacking) = (Vec::new(), Vec::new());
        for (i, (&x, &quotient)) in state.iter().zip(&quotients).enumerate() {
            if self.compensated {
                let base = recorder.push(Add(x, recorder.push(State(state.len() + i))));
                let next = added(&recorder, quotient, base);
                let point = recorder.push(RoundToSingle(next));
                lacking.push(recorder.push(RoundToSingle(recorder.push(Subtract(next, point)))));
                results.push(point);
            } else {
                results.push(recorder.push(RoundToSingle(added(&recorder, quotient, x))));
            }
        }
        results.extend(lacking);
        recorder.finish(results)
    }

    fn double_double(self, step: &StepPlan, symbols: &Symbols) -> Program {
        let recorder = Recorder::new(Rational::to_f64);
        let wide = DoubleDouble::new(&recorder, self.fuses);
        let pair = |entry: fn(usize) -> kahan_jit::Instruction, i: usize| Pair {
            high: recorder.push(entry(2 * i)),
            low: recorder.push(entry(2 * i + 1)),
        };
        let state: Vec<Pair> = (0..symbols.dimension()).map(|i| pair(State, i)).collect();
        let quotients = quotients(step, symbols, &wide, |i| state[i], |k| pair(Constant, k));
        let mut results: Vec<usize> = Vec::new();
        for (x, (numerator, reciprocal)) in state.iter().zip(&quotients) {
            let next = match reciprocal {
                Some(reciprocal) => wide.multiply_add(numerator, reciprocal, x),
                None => Arithmetic::add(&wide, x, numerator),
            };
            results.extend([next.high, next.low]);
        }
        results.push(wide.guarded(recorder.push(State(2 * state.len()))));
        drop(wide);
        recorder.finish(results)
    }

    /// The program of a point that carries so many tangent vectors, each as many numbers as the
    /// point; `step` is that of the variational field. The squares of the vectors' lengths are
    /// results behind them, of states that nothing reads.
    pub(super) fn carrying(self, step: &StepPlan, symbols: &Symbols, vectors: usize) -> Program {
        let recorder = Recorder::new(self.nearest());
        let n = symbols.dimension() / 2;
        let (mut results, mut squares) = (Vec::new(), Vec::new());
        for k in 0..vectors {
            let state = states(&recorder, (0..n).chain((k + 1) * n..(k + 2) * n));
            let quotients = self.quotients(&recorder, step, symbols, &state);
            let next: Vec<usize> = next(&recorder, &quotients, &state).collect();
            // All vectors have the same point; equal operations are compiled once.
            results.extend(&next[if k == 0 { 0 } else { n }..]);
            let entries = next[n..].iter().map(|entry| recorder.push(Multiply(*entry, *entry)));
            squares.extend(entries.reduce(|sum, square| recorder.push(Add(sum, square))));
        }
        results.extend(squares);
        recorder.finish(results)
    }

    /// The increments of these states.
    fn quotients(
        self,
        recorder: &Recorder,
        step: &StepPlan,
        symbols: &Symbols,
        state: &[usize],
    ) -> Vec<Quotient<usize>> {
        let constant = |k| recorder.push(Constant(k));
        let mut quotients = quotients(step, symbols, recorder, |i| state[i], constant);
        if self.rounds_increments {
            for (numerator, reciprocal) in &mut quotients {
                if let Some(reciprocal) = reciprocal.take() {
                    *numerator = recorder.push(Multiply(*numerator, reciprocal));
                }
            }
        }
        quotients
    }
}

fn states(recorder: &Recorder, places: impl Iterator<Item = usize>) -> Vec<usize> {
    places.map(|place| recorder.push(State(place))).collect()
}

/// The next state.
fn next(recorder: &Recorder, quotients: &[Quotient<usize>], state: &[usize]) -> impl Iterator<Item = usize> {
    quotients.iter().zip(state).map(|(quotient, x)| added(recorder, *quotient, *x))
}

/// A component of the next state: one multiply-add or addition.
fn added(recorder: &Recorder, (numerator, reciprocal): Quotient<usize>, x: usize) -> usize {
    // A change of sign becomes a subtraction, with the same bits.
    recorder.push(match (recorder.negated(numerator), reciprocal) {
        (Some(inner), Some(reciprocal)) => SubtractProduct(x, inner, reciprocal),
        (Some(inner), None) => Subtract(x, inner),
        (None, Some(reciprocal)) => MultiplyAdd(numerator, reciprocal, x),
        (None, None) => Add(x, numerator),
    })
}
