//! Machine-code functions that run a program once, repeatedly on a state, or on columns of states.

mod function;
mod orbit;
mod sweep;

pub use function::Function;
pub use orbit::{ComposedOrbit, Orbit};
pub use sweep::{Constants, Sweep};

use crate::allocation::{Allocation, MachineInstruction, RoundPlan, ValueLocation};
use crate::assembler::{Assembler, Element, FrameNeeds, GeneralRegister, Memory};
use crate::call::MemoryExtent;
use crate::instructions::Float;
use crate::lowering::{ResultDestination, lowered};
use crate::program::{Program, entries};
use crate::{CompileError, Shape};

/// The maximum number of instructions. Jumps and offsets of longer code might not fit.
const MOST_INSTRUCTIONS: usize = 50_000;
/// The maximum size of all stack slots in bytes, half of the default stack of a thread.
const MOST_STACK: usize = 1 << 20;

/// A function that returns the memory operand of a location; it may load the location's address.
type Addresses<'a> = &'a dyn Fn(&mut Assembler, ValueLocation) -> Memory;

struct Frame {
    assembler: Assembler,
    code: Allocation,
    extent: MemoryExtent,
    needs: FrameNeeds,
}

impl Frame {
    /// Begins a function over numbers of type `T`, with stack slots above the stack pointer. Panics
    /// if results become the next states, but a state that the program reads has no result.
    fn open<T: Float>(
        program: &Program,
        shape: Shape,
        plan: RoundPlan,
        uses_pointers: bool,
    ) -> Result<Self, CompileError> {
        let Shape { instructions: set, fuses, .. } = shape;
        set.may_run()?;
        if !set.is_available() || fuses && !set.has_fused() {
            return Err(CompileError::Unavailable(shape));
        }
        let results = program.outputs.len();
        let instructions = program.operations.len().max(results);
        if instructions > MOST_INSTRUCTIONS {
            return Err(CompileError::TooLong { instructions });
        }
        if !program.is_well_formed() {
            return Err(CompileError::Malformed);
        }
        let form = shape.form::<T>();
        let [read, constants] = entries(program);
        let entries = read.max(constants);
        if entries > i32::MAX as usize / form.bytes() {
            return Err(CompileError::OutOfReach { entries });
        }
        let states = if plan.ends == ResultDestination::Elsewhere { read } else { results };
        assert!(read <= states, "a state that is read has a result");
        let extent = MemoryExtent { width: shape.width::<T>(), states, constants, results };
        let code = Allocation::of(&lowered(program, fuses, plan.ends), set.registers(), plan);
        let stack = code.slots * form.bytes();
        if stack > MOST_STACK {
            return Err(CompileError::TooLong { instructions });
        }
        let (vectors, instructions) = (code.vectors(), code.instructions());
        let needs = FrameNeeds { stack, uses_pointers, vectors, instructions };
        let mut assembler = Assembler::new(form);
        assembler.open(&needs);
        Ok(Frame { assembler, code, extent, needs })
    }

    fn close(mut self) -> (Vec<u8>, MemoryExtent) {
        self.assembler.close(&self.needs);
        (self.assembler.finish(), self.extent)
    }

    fn before(&mut self, addresses: Addresses<'_>) {
        emit(&mut self.assembler, &self.code.before, addresses);
    }

    fn round(&mut self, addresses: Addresses<'_>) {
        emit(&mut self.assembler, &self.code.round, addresses);
    }

    fn after(&mut self, addresses: Addresses<'_>) {
        emit(&mut self.assembler, &self.code.after, addresses);
    }
}

fn emit(assembler: &mut Assembler, instructions: &[MachineInstruction], addresses: Addresses<'_>) {
    let address = |assembler: &mut Assembler, place: ValueLocation| match place {
        ValueLocation::Literal(number) => {
            let bits = match assembler.form().element {
                Element::Double => number.value().to_bits(),
                Element::Single => u64::from((number.value() as f32).to_bits()),
            };
            Memory::Pool(assembler.constant(bits))
        }
        ValueLocation::Slot(slot) => assembler.form().entry(GeneralRegister::STACK, slot),
        _ => addresses(assembler, place),
    };
    for instruction in instructions {
        match *instruction {
            MachineInstruction::Load(to, place) => {
                let from = address(assembler, place);
                assembler.load(to, from);
            }
            MachineInstruction::Store(place, from) => {
                let to = address(assembler, place);
                assembler.store(to, from);
            }
            MachineInstruction::Copy(to, from) => assembler.copy(to, from),
            MachineInstruction::Binary(operator, to, a, b) => {
                let b = b.map(|place| address(assembler, place));
                assembler.binary(operator, to, a, b);
            }
            MachineInstruction::Fused(operator, order, to, b, c) => {
                let c = c.map(|place| address(assembler, place));
                assembler.fused(operator, order, to, b, c);
            }
            MachineInstruction::RoundToSingle(to, from) => assembler.round_to_single(to, from),
        }
    }
}
