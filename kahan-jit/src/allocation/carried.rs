//! From the results of a round to the states of the next, all at once.

use crate::assembler::Vector;

use super::{Allocation, MachineInstruction, Operand, Place};

/// Moves result i, which stands in `sources[i]`, into register i, for all i. `registers` is how
/// many registers may be written to; where all of them are taken, a circle goes through a slot.
pub(super) fn carry(sources: Vec<Operand>, registers: usize, code: &mut Allocation) {
    let states = sources.len();
    let mut moves: Vec<(Vector, Operand)> =
        (0..).map(Vector).zip(sources).filter(|(to, source)| *source != Operand::Register(*to)).collect();
    while let Some(place) = next(&moves) {
        let (to, source) = moves[place];
        let still_read = moves.iter().any(|(_, source)| *source == Operand::Register(to));
        if still_read {
            // A circle: what is in the way goes elsewhere first.
            let elsewhere = match spare(&moves, states, registers) {
                Some(register) => {
                    code.round.push(MachineInstruction::Copy(register, to));
                    Operand::Register(register)
                }
                None => {
                    let slot = Place::Slot(code.slots);
                    code.round.push(MachineInstruction::Store(slot, to));
                    code.slots += 1;
                    Operand::Memory(slot)
                }
            };
            for (_, source) in moves.iter_mut().filter(|(_, source)| *source == Operand::Register(to)) {
                *source = elsewhere;
            }
            continue;
        }
        code.round.push(MachineInstruction::bring(to, source));
        moves.swap_remove(place);
    }
}

/// A move whose register nobody reads any more, or any other.
fn next(moves: &[(Vector, Operand)]) -> Option<usize> {
    let is_free =
        |(to, _): &(Vector, Operand)| !moves.iter().any(|(_, source)| *source == Operand::Register(*to));
    moves.iter().position(is_free).or(if moves.is_empty() { None } else { Some(0) })
}

/// A register that is neither written to nor read by a move.
fn spare(moves: &[(Vector, Operand)], states: usize, registers: usize) -> Option<Vector> {
    let is_read = |register: Vector| moves.iter().any(|(_, source)| *source == Operand::Register(register));
    (states..registers).map(|index| Vector(index as u8)).find(|register| !is_read(*register))
}
