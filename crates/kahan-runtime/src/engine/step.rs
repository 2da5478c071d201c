//! The step of a field at any ε, by a straight-line program or by elimination.
//!
//! In: a state, and registers that begin with the constants of the step. Out: the next state.

use kahan_algebra::derived::Derived;
use kahan_algebra::plan::StepPlan;
use kahan_core::__private::may_divide_by;
use kahan_core::Scalar;
use kahan_dynamics::Precision;

use crate::line::{Line, Results, has_value};
use crate::machine_code::StepKind;

use super::couplings::{EliminationPattern, Factors};
use super::elimination::solve;
use super::floats::RuntimeFloat;
use super::scratch::Workspace;

#[derive(Debug)]
pub(crate) struct StepForms {
    first: Step,
    /// A step that does not divide by ε, used if a division by ε loses accuracy.
    general: Option<Step>,
    divides_by_eps: bool,
}

impl StepForms {
    pub(super) fn of(derived: &Derived) -> Self {
        match derived.step() {
            Some(plan) => StepForms {
                first: Step::straight(plan, derived),
                general: plan.general.as_deref().map(|general| Step::straight(general, derived)),
                divides_by_eps: plan.has_inverse_step,
            },
            None => StepForms { first: Step::by_elimination(derived), general: None, divides_by_eps: false },
        }
    }

    pub(crate) fn are_general<V: Scalar>(&self, eps: &V) -> bool {
        self.divides_by_eps && !may_divide_by(eps)
    }

    /// Returns whether generated code rounds numerator·(1/denominator) before adding it to x.
    /// Otherwise it uses a multiply-add. An `is_general` step does not divide by ε.
    pub(crate) fn rounds<V: Scalar>(is_general: bool) -> bool {
        is_general && may_divide_by(&V::one())
    }

    pub(crate) fn form(&self, is_general: bool) -> &Step {
        self.general.as_ref().filter(|_| is_general).unwrap_or(&self.first)
    }

    pub(crate) fn of_duals(&self) -> &Step {
        self.form(self.divides_by_eps)
    }
}

#[derive(Debug)]
pub(crate) struct Step {
    /// The program that computes the constants of the step; `None` for a step by elimination.
    prepared: Option<Line>,
    /// The programs that read the state: one for the whole step, or, for elimination, one for f′
    /// and one for the field.
    lines: Vec<Line>,
    couplings: Option<EliminationPattern>,
    /// For each increment, the indices of its numerator and of 1/denominator in the program's
    /// results; `None` for an increment without a denominator.
    pub(crate) quotients: Vec<(usize, Option<usize>)>,
}

impl Step {
    fn straight(plan: &StepPlan, derived: &Derived) -> Self {
        let symbols = &derived.system.field.symbols;
        let kernel = &plan.kernel;
        let places: Vec<usize> = (0..kernel.plan.outputs.len()).collect();
        let quotients = kernel.factors(&places).map(|(numerator, by)| (*numerator, by.copied()));
        Step {
            prepared: Some(Line::of(&plan.constants, symbols)),
            lines: vec![Line::of_kernel(&kernel.plan, symbols, plan.constants.outputs.len())],
            couplings: None,
            quotients: quotients.collect(),
        }
    }

    fn by_elimination(derived: &Derived) -> Self {
        let symbols = &derived.system.field.symbols;
        let couplings = derived.couplings().unwrap_or_else(|| unreachable!("there is no straight line"));
        Step {
            prepared: None,
            lines: [&couplings.slopes, derived.field()].map(|plan| Line::of(plan, symbols)).into(),
            couplings: Some(EliminationPattern::of(couplings)),
            quotients: (0..symbols.dimension()).map(|i| (i, None)).collect(),
        }
    }

    pub(crate) fn lines(&self) -> Option<[&Line; 2]> {
        Some([self.prepared.as_ref()?, &self.lines[0]])
    }

    pub(crate) fn couplings(&self) -> Option<(&Line, &EliminationPattern)> {
        Some((&self.lines[0], self.couplings.as_ref()?))
    }

    /// Returns whether the step runs in SIMD lanes. Elimination does not, because it branches.
    pub(crate) fn has_lanes(&self) -> bool {
        self.prepared.is_some()
    }

    /// Appends the numbers that depend only on parameters and ε to `given`.
    pub(crate) fn prepare<V: Scalar + Copy>(
        &self,
        constants: &[V],
        registers: &mut Vec<V>,
        given: &mut Vec<V>,
    ) {
        match self.prepared(constants, registers) {
            Some(prepared) => append_given(&self.lines[0], prepared.iter(), given),
            None => self.lines.iter().for_each(|line| append_given(line, constants.iter().copied(), given)),
        }
    }

    pub(crate) fn registers(&self) -> usize {
        self.lines.iter().map(Line::registers).sum()
    }

    pub(crate) fn open<V: Scalar + Copy>(&self, mut given: &[V], registers: &mut Vec<V>) {
        for line in &self.lines {
            let (own, rest) = given.split_at(line.given());
            registers.extend_from_slice(own);
            registers.resize(registers.len() + line.registers() - own.len(), V::zero());
            given = rest;
        }
    }

    /// Advances a state by one step.
    ///
    /// A nonempty `carry` holds the rounding errors of the state. If states are in single
    /// precision, but steps are computed in double precision, `single` rounds x̃. `factor` factors
    /// A(x,ε); if `factor` returns `false`, partial pivoting is used.
    pub(crate) fn advance<V: Scalar + Copy>(
        &self,
        kind: StepKind,
        [state, carry]: [&mut [V]; 2],
        registers: &mut [V],
        workspace: &mut Workspace<V>,
        single: impl Fn(V) -> V,
        factor: impl FnOnce(&EliminationPattern, &[V], &V, &mut Factors<V>) -> bool,
    ) {
        self.compute(state, registers, workspace, factor);
        for (i, x) in state.iter_mut().enumerate() {
            let quotient = self.quotient(i, kind.rounds_increments, workspace);
            add_quotient(kind, quotient, x, carry.get_mut(i), &single);
        }
    }

    pub(crate) fn has_divided_by_zero<V: Scalar>(&self, registers: &[V], workspace: &Workspace<V>) -> bool {
        if self.has_lanes() { self.lines[0].has_divided_by_zero(registers) } else { workspace.is_singular }
    }

    pub(crate) fn prepared<'a, V: Scalar + Copy>(
        &'a self,
        constants: &[V],
        registers: &'a mut Vec<V>,
    ) -> Option<Results<'a, V>> {
        Some(self.prepared.as_ref()?.values(constants, registers, &[]))
    }

    /// Replaces the row-major matrix B by A(x,ε)⁻¹B; returns `false` if sparse elimination fails.
    pub(super) fn solves_columns<T: RuntimeFloat>(&self, constants: &[T], state: &[T], b: &mut [T]) -> bool {
        let Some((tables, mut factors)) = self.factors(constants, state) else { return false };
        (0..state.len()).for_each(|column| tables.solve(&mut factors, b, state.len(), column));
        true
    }

    /// Returns whether det A(x,ε) < 0; `None` without sparse elimination, or if a pivot is small.
    pub(super) fn has_negative_determinant(&self, constants: &[f64], state: &[f64]) -> Option<bool> {
        let (tables, factors) = self.factors(constants, state)?;
        Some(tables.has_negative_determinant(&factors))
    }

    /// Factors A(x,ε) by sparse elimination; `None` for a dense field, or if a pivot is small.
    fn factors<T: RuntimeFloat>(
        &self,
        constants: &[T],
        state: &[T],
    ) -> Option<(&EliminationPattern, Factors<T>)> {
        let (slopes, tables) = self.couplings()?;
        let entries: Vec<T> = slopes.values(constants, &mut Vec::new(), state).iter().collect();
        let mut factors = Factors::default();
        let eps = &constants[constants.len() - 1];
        T::factor(tables, &entries, eps, &mut factors).then_some((tables, factors))
    }

    pub(super) fn increments<'a, V: Scalar + Copy>(
        &'a self,
        state: &[V],
        registers: &mut [V],
        workspace: &'a mut Workspace<V>,
    ) -> impl Iterator<Item = V> + use<'a, V> {
        self.compute(state, registers, workspace, EliminationPattern::factor);
        (0..self.quotients.len()).map(|i| self.quotient(i, true, workspace).0)
    }

    #[inline(always)]
    fn compute<V: Scalar + Copy>(
        &self,
        state: &[V],
        registers: &mut [V],
        workspace: &mut Workspace<V>,
        factor: impl FnOnce(&EliminationPattern, &[V], &V, &mut Factors<V>) -> bool,
    ) {
        let Workspace { outcome, matrix, slopes: entries, factors, is_singular } = workspace;
        outcome.clear();
        let Some(tables) = &self.couplings else {
            outcome.extend(has_value(self.lines[0].run(registers, state)).iter());
            return;
        };
        let [slopes, field] = &self.lines[..] else { unreachable!("they are two") };
        let (of_slopes, of_field) = registers.split_at_mut(slopes.registers());
        let eps = slopes.eps(of_slopes);
        outcome.extend(has_value(field.run(of_field, state)).iter());
        matrix.clear();
        if !tables.are_sparse() {
            // Partial pivoting in later steps must not allocate, so its memory is reserved.
            matrix.reserve(state.len() * state.len());
        }
        entries.clear();
        entries.extend(has_value(slopes.run(of_slopes, state)).iter());
        *is_singular = if factor(tables, entries, &eps, factors) {
            tables.solve(factors, outcome, 1, 0);
            false
        } else if tables.are_sparse() {
            tables.solve_by_pivoting(entries, eps, outcome, false)
        } else {
            tables.spread(entries, matrix);
            into_matrix(matrix, eps, state.len());
            solve(matrix, outcome, state.len())
        };
        let time_step = eps + eps;
        outcome.iter_mut().for_each(|velocity| *velocity = time_step * *velocity);
    }

    /// Returns the numerator and 1/denominator of increment i; if `rounds`, the product and `None`.
    #[inline(always)]
    fn quotient<V: Scalar + Copy>(&self, i: usize, rounds: bool, workspace: &Workspace<V>) -> (V, Option<V>) {
        let (numerator, reciprocal) = self.quotients[i];
        let outcome = &workspace.outcome;
        match reciprocal {
            Some(place) if rounds => (outcome[numerator] * outcome[place], None),
            _ => (outcome[numerator], reciprocal.map(|place| outcome[place])),
        }
    }
}

fn append_given<V: Scalar>(line: &Line, constants: impl IntoIterator<Item = V>, given: &mut Vec<V>) {
    let start = given.len();
    given.resize(start + line.given(), V::zero());
    line.give(constants, &mut given[start..]);
}

#[inline(always)]
fn added<V: Scalar>((numerator, reciprocal): (V, Option<V>), x: V) -> V {
    match reciprocal {
        Some(reciprocal) => numerator.multiply_add(reciprocal, x),
        None => x + numerator,
    }
}

/// Adds an increment to x by compensated summation; `carry` holds the rounding error.
#[inline(always)]
fn add_with_carry<V: Scalar + Copy>(quotient: (V, Option<V>), x: &mut V, carry: &mut V) {
    let base = *x + *carry;
    let rest = *carry - (base - *x);
    let next = added(quotient, base);
    let distance = next - base;
    let lacks = match quotient {
        (numerator, Some(reciprocal)) => numerator.multiply_subtract(reciprocal, distance),
        (increment, None) => increment - distance,
    };
    (*x, *carry) = (next, rest + lacks);
}

/// Adds an increment in double precision to an x of single precision.
#[inline(always)]
fn add_through_double<V: Scalar + Copy>(
    quotient: (V, Option<V>),
    x: &mut V,
    carry: Option<&mut V>,
    single: impl Fn(V) -> V,
) {
    let base = carry.as_ref().map_or(*x, |carry| *x + **carry);
    let next = added(quotient, base);
    *x = single(next);
    if let Some(carry) = carry {
        *carry = single(next - *x);
    }
}

/// Adds an increment to x as steps of this `kind` do; `carry` receives the rounding error.
#[inline(always)]
pub(super) fn add_quotient<V: Scalar + Copy>(
    kind: StepKind,
    quotient: (V, Option<V>),
    x: &mut V,
    carry: Option<&mut V>,
    single: impl Fn(V) -> V,
) {
    match carry {
        carry if kind.precision == Precision::SingleThroughDouble => {
            add_through_double(quotient, x, carry, single);
        }
        Some(carry) => add_with_carry(quotient, x, carry),
        None => *x = added(quotient, *x),
    }
}

/// Replaces f′(x) by A(x,ε) = I − εf′(x), row by row.
pub(crate) fn into_matrix<V: Scalar + Copy>(slopes: &mut [V], eps: V, n: usize) {
    for (place, entry) in slopes.iter_mut().enumerate() {
        let scaled = -(eps * *entry);
        *entry = if place / n == place % n { V::one() + scaled } else { scaled };
    }
}
