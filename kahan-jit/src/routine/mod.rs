//! Whole functions around straight-line code: what is loaded before it, how often it runs, what is
//! stored after it.

mod function;
mod orbit;
mod sweep;

pub use function::Function;
pub use orbit::{ComposedOrbit, Orbit};
pub use sweep::{Constants, Sweep};

use crate::allocation::{Allocation, Operand, Operation, Place, RoundPlan};
use crate::assembler::{Assembler, Element, Form, General, Memory, Source};
use crate::lines::{Ends, Given, Lines};
use crate::{Program, Refusal, Shape};

/// Longer programs are no better than a loop. So few operations keep too few numbers at once to
/// fill the stack of a thread, and their code is short enough for all jumps and distances.
const MOST_INSTRUCTIONS: usize = 20_000;

/// Where a number lies; what stands between a place and its address may take an instruction.
type Addresses<'a> = &'a dyn Fn(&mut Assembler, Place) -> Memory;

/// A routine that is being written.
struct Writer {
    assembler: Assembler,
    form: Form,
    code: Allocation,
    saved: &'static [General],
}

impl Writer {
    /// Begins a function: its registers are saved, and its slots lie above the stack pointer.
    ///
    /// # Panics
    /// If results become states, and a state that is read has no result.
    fn begin(
        program: &Program,
        shape: Shape,
        form: Form,
        plan: RoundPlan,
        saved: &'static [General],
    ) -> Result<Self, Refusal> {
        let Shape { instructions: set, fuses, .. } = shape;
        if !set.is_available() || fuses && !set.has_fused() {
            return Err(Refusal::Unavailable(shape));
        }
        let instructions = program.instructions.len().max(program.results.len());
        if instructions > MOST_INSTRUCTIONS {
            return Err(Refusal::TooLong { instructions });
        }
        let entries = program.states().max(program.constants());
        if entries > i32::MAX as usize / form.bytes() {
            return Err(Refusal::OutOfReach { entries });
        }
        if plan.ends != Ends::Elsewhere {
            assert!(program.states() <= program.results.len(), "a state that is read has a result");
        }
        let code = Allocation::of(&Lines::of(program, fuses, plan.ends), set.registers(), plan);
        let mut writer = Writer { assembler: Assembler::new(form), form, code, saved };
        writer.enter();
        Ok(writer)
    }

    fn enter(&mut self) {
        /// The system enlarges a stack page by page.
        const PAGE: usize = 4096;
        /// Slots of any width begin with cache lines.
        const LINE: i32 = 64;

        let assembler = &mut self.assembler;
        assembler.push(General::Rbp);
        assembler.move_general(General::Rbp, General::Rsp);
        self.saved.iter().for_each(|register| assembler.push(*register));
        let bytes = self.code.slots * self.form.bytes();
        if bytes > 0 {
            assembler.and_immediate(General::Rsp, -LINE);
            for touched in (0..bytes).step_by(PAGE) {
                assembler.add_immediate(General::Rsp, -(PAGE.min(bytes - touched) as i32));
                assembler.touch_stack();
            }
            assembler.and_immediate(General::Rsp, -LINE);
        }
    }

    /// Ends the function.
    fn leave(mut self) -> Vec<u8> {
        let assembler = &mut self.assembler;
        for (index, register) in self.saved.iter().enumerate() {
            assembler.load_general(*register, General::Rbp, -8 * (index as i32 + 1));
        }
        assembler.move_general(General::Rsp, General::Rbp);
        assembler.pop(General::Rbp);
        assembler.zero_upper();
        assembler.ret();
        self.assembler.finish()
    }

    fn before(&mut self, addresses: Addresses<'_>) {
        emit(&mut self.assembler, &self.code.before, self.form, addresses);
    }

    fn round(&mut self, addresses: Addresses<'_>) {
        emit(&mut self.assembler, &self.code.round, self.form, addresses);
    }

    fn after(&mut self, addresses: Addresses<'_>) {
        emit(&mut self.assembler, &self.code.after, self.form, addresses);
    }
}

/// Writes the operations.
fn emit(assembler: &mut Assembler, operations: &[Operation], form: Form, addresses: Addresses<'_>) {
    let address = |assembler: &mut Assembler, place: Place| match place {
        Place::Given(Given::Literal(bits)) => {
            let bits = match form.element {
                Element::Double => bits,
                Element::Single => u64::from((f64::from_bits(bits) as f32).to_bits()),
            };
            Memory::Pool(assembler.constant(bits))
        }
        Place::Slot(slot) => Memory::At { base: General::Rsp, offset: entry(form, slot) },
        _ => addresses(assembler, place),
    };
    let source = |assembler: &mut Assembler, operand: Operand| match operand {
        Operand::Register(register) => Source::Register(register),
        Operand::Memory(place) => Source::Memory(address(assembler, place)),
    };
    for operation in operations {
        match *operation {
            Operation::Load(to, place) => {
                let from = address(assembler, place);
                assembler.load(to, from);
            }
            Operation::Store(place, from) => {
                let to = address(assembler, place);
                assembler.store(to, from);
            }
            Operation::Copy(to, from) => assembler.copy(to, from),
            Operation::Binary(operator, to, a, b) => {
                let b = source(assembler, b);
                assembler.binary(operator, to, a, b);
            }
            Operation::Fused(operator, order, to, b, c) => {
                let c = source(assembler, c);
                assembler.fused(operator, order, to, b, c);
            }
            Operation::RoundToSingle(to, from) => assembler.round_to_single(to, from),
        }
    }
}

/// The offset of an entry of an array of operands.
fn entry(form: Form, index: usize) -> i32 {
    i32::try_from(index * form.bytes()).expect("programs are short, and their arrays within reach")
}
