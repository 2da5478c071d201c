//! Runs hostile programs on slices between inaccessible pages. Each program that safe code can
//! build must be refused, or access only its slices.
//!
//! The fuzz target `program` compiles these files, too; therefore they use only public items.

mod guarded;
#[cfg(test)]
mod tests;

use std::fmt::Debug;

use kahan_program::Node;

use crate::{
    CalledFunction, CompileError, ComposedOrbit, Constants, Float, Function, Input, Instruction,
    InstructionSet, LaneCount, Orbit, Program, Shape, Sweep,
};

use super::draw::{Draw, constant, literal, push, state};
use super::run::{read, run_by, same};
use guarded::{Edge, Guarded};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Routine {
    Function,
    Orbit,
    ComposedOrbit,
    Sweep(Constants),
}

impl Routine {
    const ALL: [Self; 5] = [
        Self::Function,
        Self::Orbit,
        Self::ComposedOrbit,
        Self::Sweep(Constants::Shared),
        Self::Sweep(Constants::Own),
    ];
}

#[derive(Debug)]
pub(crate) struct Case {
    program: Program,
    pub(crate) routine: Routine,
    pub(crate) shape: Shape,
    is_double: bool,
    edge: Edge,
    seed: u64,
    /// Whether the compiler must accept the program.
    is_ordinary: bool,
}

/// Random bytes, from which choices are drawn. After the last byte, zeros are drawn.
#[derive(Clone, Copy)]
struct Source<'a>(&'a [u8]);

impl Source<'_> {
    fn byte(&mut self) -> usize {
        let (first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        usize::from(*first)
    }

    fn choice<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.byte() % of.len()]
    }

    fn entry(&mut self) -> usize {
        let near = self.byte();
        if near < 240 {
            return near % 24;
        }
        let bits = self.choice(&[12, 20, 24, 25, 26, 27, 28, 29, 30, 31, 32, 57, 58, 59, 60, 61, 62, 63, 64]);
        let edge = if bits == 64 { 0 } else { 1_usize << bits };
        edge.wrapping_sub(3).wrapping_add(self.byte() % 4)
    }

    fn number(&mut self) -> f64 {
        const KINDS: [f64; 8] = [0.0, -0.0, 1.0, f64::INFINITY, f64::NAN, 1e-310, 1e300, -1.5];
        match self.byte() {
            kind @ 0..8 => KINDS[kind],
            ordinary => ordinary as f64 / 64.0 - 2.0,
        }
    }

    fn instruction(&mut self, known: usize) -> Instruction {
        let kind = if known == 0 { self.byte() % 3 } else { self.byte() % 18 };
        match kind {
            0 => return state(self.entry()),
            1 => return constant(self.entry()),
            2 => return literal(self.number()),
            _ => {}
        }
        let mut operand = || Node(known - 1 - self.byte() % known);
        let call = |function, a| Instruction::Call(function, a, a);
        match kind {
            3 | 4 => Instruction::Add(operand(), operand()),
            5 => Instruction::Subtract(operand(), operand()),
            6 | 7 => Instruction::Multiply(operand(), operand()),
            8 => Instruction::Divide(operand(), operand()),
            9 => Instruction::Negate(operand()),
            10 | 11 => Instruction::MultiplyAdd(operand(), operand(), operand()),
            12 => Instruction::MultiplySubtract(operand(), operand(), operand()),
            13 => Instruction::SubtractProduct(operand(), operand(), operand()),
            14 => call(CalledFunction::Copy, operand()),
            15 => Instruction::Call(CalledFunction::Maximum, operand(), operand()),
            16 => Instruction::Call(CalledFunction::Minimum, operand(), operand()),
            _ => call(CalledFunction::RoundToSingle, operand()),
        }
    }

    /// Returns an arbitrary program, and whether the compiler must accept it.
    fn program(&mut self) -> (Program, bool) {
        const MANY: usize = 25_000;

        let mut program = Program::default();
        let results = match self.byte() {
            255 => MANY,
            results => results % 40,
        };
        let instructions = match self.byte() {
            255 => MANY,
            254 => 3000,
            _ => 0,
        };
        let is_broken = self.byte() > 248;
        let (beginning, mut known) = (*self, 0);
        let mut is_ordinary = results < MANY && instructions < MANY && !is_broken;
        while !self.0.is_empty() || known < instructions {
            if self.0.is_empty() {
                *self = beginning;
            }
            let instruction = self.instruction(known);
            is_ordinary &= match instruction {
                Instruction::Input(Input::State(entry) | Input::Constant(entry)) => entry < 24,
                _ => true,
            };
            push(&mut program, instruction);
            known = program.operations.len();
        }
        if known > 0 {
            let mut draw = Draw(results as u64);
            let near = known.min(results + 8);
            program.outputs = (0..results).map(|_| Node(known - 1 - draw.below(near))).collect();
            if is_broken {
                let place = draw.below(known);
                program.operations[place] = Instruction::Negate(Node(place + draw.below(3)));
            }
        }
        (program, is_ordinary)
    }
}

impl Case {
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let mut source = Source(bytes);
        let routine = source.choice(&Routine::ALL);
        let instructions = source.choice(&InstructionSet::ALL);
        let lanes = source.choice(&[LaneCount::One, LaneCount::All]);
        let fuses = source.choice(&[true, false]);
        let shape = Shape { instructions, lanes, fuses };
        let is_double = source.choice(&[true, false]);
        let edge = source.choice(&[Edge::End, Edge::Begin]);
        let (program, is_ordinary) = source.program();
        let seed = bytes.iter().fold(0, |seed: u64, byte| seed.wrapping_mul(31) + u64::from(*byte));
        Case { program, routine, shape, is_double, edge, seed, is_ordinary }
    }

    fn states(&self) -> usize {
        read(&self.program)[0]
    }

    fn constants(&self) -> usize {
        read(&self.program)[1]
    }

    pub(crate) fn has_run(&self) -> bool {
        if self.routine != Routine::Function && self.states() > self.program.outputs.len() {
            return false;
        }
        let refusal = if self.is_double { self.run::<f64>() } else { self.run::<f32>() };
        let Err(refusal) = refusal else { return true };
        let Shape { instructions: set, fuses, .. } = self.shape;
        let has_set = set.is_available() && (set.has_fused() || !fuses);
        assert!(!(has_set && self.is_ordinary), "{refusal}: {self:?}");
        assert!(!refusal.to_string().is_empty());
        false
    }

    fn run<T: Float + num_traits::Float + Debug>(&self) -> Result<(), CompileError> {
        match self.routine {
            Routine::Function => self.function::<T>(),
            Routine::Orbit => self.orbit::<T>(),
            Routine::ComposedOrbit => self.composed_orbit::<T>(),
            Routine::Sweep(of) => self.sweep::<T>(of),
        }
    }

    /// Returns `count` numbers. Only the first and last thousand are not 0, to save time.
    fn numbers<T: num_traits::Float>(&self, draw: &mut Draw, count: usize) -> Guarded<T> {
        const FEW: usize = 1000;

        let mut numbers = Guarded::zeros(count, self.edge);
        for index in (0..count.min(FEW)).chain(count.saturating_sub(FEW).max(FEW)..count) {
            numbers[index] = T::from(draw.number(55)).expect("floats have every number");
        }
        numbers
    }

    fn expected<T: num_traits::Float>(
        &self,
        state: impl Fn(usize) -> T,
        constant: impl Fn(usize) -> T,
    ) -> Vec<T> {
        run_by(&self.program, state, constant, self.shape.fuses)
    }

    fn assert_same<T: num_traits::Float + Debug>(&self, found: impl Fn(usize) -> T, expected: &[T]) {
        for (i, expected) in expected.iter().enumerate() {
            assert!(same(found(i), *expected), "result {i} is {:?}, not {expected:?}: {self:?}", found(i));
        }
    }

    fn function<T: Float + num_traits::Float + Debug>(&self) -> Result<(), CompileError> {
        let function = Function::<T>::compile(&self.program, self.shape)?;
        let (mut draw, width) = (Draw(self.seed), self.shape.width::<T>());
        let states: Guarded<T> = self.numbers(&mut draw, self.states() * width);
        let constants: Guarded<T> = self.numbers(&mut draw, self.constants() * width);
        let mut results = Guarded::<T>::zeros(self.program.outputs.len() * width, self.edge);
        assert_eq!(function.results(), results.len());
        function.run(&states, &constants, &mut results);
        for lane in 0..width {
            let expected = self.expected(|i| states[i * width + lane], |k| constants[k * width + lane]);
            self.assert_same(|i| results[i * width + lane], &expected);
        }
        Ok(())
    }

    fn orbit<T: Float + num_traits::Float + Debug>(&self) -> Result<(), CompileError> {
        const STEPS: u64 = 3;

        let orbit = Orbit::<T>::compile(&self.program, self.shape)?;
        let (mut draw, width) = (Draw(self.seed), self.shape.width::<T>());
        let (states, constants) = (self.program.outputs.len(), self.constants());
        let mut state: Guarded<T> = self.numbers(&mut draw, states * width);
        let constants: Guarded<T> = self.numbers(&mut draw, constants * width);
        let mut next = Guarded::<T>::zeros(states * width, self.edge);
        let start = state.to_vec();
        orbit.step(&state, &constants, &mut next);
        orbit.run(&mut state, &constants, STEPS);
        for lane in 0..width {
            let constant = |k: usize| constants[k * width + lane];
            let mut expected: Vec<T> = start.iter().skip(lane).step_by(width).copied().collect();
            for step in 0..STEPS {
                expected = self.expected(|i| expected[i], constant);
                if step == 0 {
                    self.assert_same(|i| next[i * width + lane], &expected);
                }
            }
            self.assert_same(|i| state[i * width + lane], &expected);
        }
        Ok(())
    }

    fn composed_orbit<T: Float + num_traits::Float + Debug>(&self) -> Result<(), CompileError> {
        const STEPS: u64 = 2;

        let orbit = ComposedOrbit::<T>::compile(&self.program, self.shape)?;
        let (mut draw, width) = (Draw(self.seed), self.shape.width::<T>());
        let (states, constants) = (self.program.outputs.len(), self.constants());
        let mut state: Guarded<T> = self.numbers(&mut draw, states * width);
        let count = 1 + draw.below(3);
        let sets: Vec<Guarded<T>> = (0..count).map(|_| self.numbers(&mut draw, constants * width)).collect();
        let stages: Vec<&[T]> = sets.iter().map(|set| &set[..]).collect();
        let start = state.to_vec();
        orbit.run(&mut state, stages.iter().copied(), STEPS);
        for lane in 0..width {
            let mut expected: Vec<T> = start.iter().skip(lane).step_by(width).copied().collect();
            for constants in (0..STEPS).flat_map(|_| &stages) {
                expected = self.expected(|i| expected[i], |k| constants[k * width + lane]);
            }
            self.assert_same(|i| state[i * width + lane], &expected);
        }
        Ok(())
    }

    fn sweep<T: Float + num_traits::Float + Debug>(&self, of: Constants) -> Result<(), CompileError> {
        const STEPS: u64 = 2;
        const MOST_COLUMNS: usize = 256;

        let sweep = Sweep::<T>::compile(&self.program, self.shape, of)?;
        let (mut draw, width) = (Draw(self.seed), sweep.width());
        let states = self.program.outputs.len();
        if states > MOST_COLUMNS {
            return Ok(());
        }
        let registers = draw.below(4);
        let sets = if of == Constants::Own { registers } else { registers.min(1) };
        let mut columns: Vec<Guarded<T>> =
            (0..states).map(|_| self.numbers(&mut draw, registers * width)).collect();
        let constants: Guarded<T> = self.numbers(&mut draw, sets * sweep.constants());
        let starts: Vec<Vec<T>> = columns.iter().map(|column| column.to_vec()).collect();
        sweep.run(&mut columns, &constants, STEPS);
        for place in 0..registers * width {
            let set = if of == Constants::Own { place / width } else { 0 };
            let constant = |k: usize| constants[set * sweep.constants() + k * width + place % width];
            let mut expected: Vec<T> = starts.iter().map(|column| column[place]).collect();
            for _ in 0..STEPS {
                expected = self.expected(|i| expected[i], constant);
            }
            self.assert_same(|i| columns[i][place], &expected);
        }
        Ok(())
    }
}
