//! The objects of a field as programs from a state, and the parameters with ε behind them.

use kahan_algebra::Derived;
use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::plan::Plan;
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbol;
use kahan_jit::Instruction::{Constant, State};
use kahan_jit::Program;

use crate::engine::Object;

use super::dual::Duals;
use super::recorder::Recorder;
use super::step::{evaluate, quotients};

/// The program of an object; `None` where the field has none, or no straight line for it.
pub(super) fn program(object: Object, derived: &Derived, nearest: fn(&Rational) -> f64) -> Option<Program> {
    let recorder = Recorder::new(nearest);
    let results = match object {
        Object::Field => of_plan(&derived.field, derived, &recorder),
        Object::FieldJacobian => of_plan(&derived.field_jacobian, derived, &recorder),
        Object::Integrals => of_plan(&derived.integrals, derived, &recorder),
        Object::Density => of_plan(derived.density.as_ref()?, derived, &recorder),
        Object::Bracket(index) => of_plan(&derived.brackets.get(index)?.1, derived, &recorder),
        Object::Matrix => matrix(derived, &recorder),
        Object::Jacobian => jacobian(derived, &recorder)?,
    };
    Some(recorder.finish(results))
}

/// The program of the constants that a form of the step is prepared with.
pub(super) fn constants(plan: &Plan, derived: &Derived, nearest: fn(&Rational) -> f64) -> Program {
    let recorder = Recorder::new(nearest);
    let results = of_plan(plan, derived, &recorder);
    recorder.finish(results)
}

/// The program of a state that stays as it is, and the results of a plan behind it.
pub(super) fn behind_the_state(plan: &Plan, derived: &Derived, nearest: fn(&Rational) -> f64) -> Program {
    let recorder = Recorder::new(nearest);
    let state = 0..derived.system.field.dimension();
    let mut results: Vec<usize> = state.map(|i| recorder.push(State(i))).collect();
    results.extend(of_plan(plan, derived, &recorder));
    recorder.finish(results)
}

/// Where an input is found; ε stands behind the parameters.
fn input(symbol: Symbol, derived: &Derived, recorder: &Recorder) -> usize {
    let symbols = &derived.system.field.symbols;
    recorder.push(match symbol {
        Symbol::State(i) => State(i),
        Symbol::SecondState(i) => State(symbols.dimension() + i),
        Symbol::Parameter(k) => Constant(k),
        Symbol::Epsilon => Constant(symbols.parameters.len()),
    })
}

fn of_plan(plan: &Plan, derived: &Derived, recorder: &Recorder) -> Vec<usize> {
    let symbols = &derived.system.field.symbols;
    evaluate(plan, symbols, recorder, &[], |symbol| Some(input(symbol, derived, recorder)))
}

/// A(x,ε) = I − εf′(x), row by row.
fn matrix(derived: &Derived, recorder: &Recorder) -> Vec<usize> {
    let n = derived.system.field.dimension();
    let eps = input(Symbol::Epsilon, derived, recorder);
    let one = recorder.constant(&Rational::one());
    let slopes = of_plan(&derived.field_jacobian, derived, recorder).into_iter().enumerate();
    let entry = |(place, slope): (usize, usize)| {
        let scaled = recorder.negate(&recorder.multiply(&eps, &slope));
        let diagonal = one.filter(|_| place / n == place % n);
        diagonal.map_or(scaled, |one| recorder.add(&one, &scaled))
    };
    slopes.map(entry).collect()
}

/// ∂x̃/∂x, row by row: the step over dual numbers.
fn jacobian(derived: &Derived, recorder: &Recorder) -> Option<Vec<usize>> {
    let (symbols, n) = (&derived.system.field.symbols, derived.system.field.dimension());
    let step = derived.step()?.for_any_step();
    let duals = Duals::new(recorder, n);
    let fixed = |symbol| Some(duals.fixed(input(symbol, derived, recorder)));
    let prepared = evaluate(&step.constants, symbols, &duals, &[], fixed);
    duals.begin_kernel();
    let state = |i| duals.coordinate(recorder.push(State(i)), i);
    let quotients = quotients(step, symbols, &duals, state, |k| prepared[k].clone());
    let one = recorder.constant(&Rational::one())?;
    let mut entries = Vec::with_capacity(n * n);
    for (i, (numerator, reciprocal)) in quotients.iter().enumerate() {
        let increment = match reciprocal {
            Some(reciprocal) => duals.multiply(numerator, reciprocal),
            None => numerator.clone(),
        };
        let slopes = increment.gradient.iter().enumerate();
        entries.extend(slopes.map(|(j, slope)| if i == j { recorder.add(&one, slope) } else { *slope }));
    }
    Some(entries)
}
