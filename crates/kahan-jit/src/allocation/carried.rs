//! From the results of a round to the states of the next, all at once.

use crate::assembler::{Source, Vector};

use super::{Allocation, MachineInstruction, Place};

/// Moves result i, which stands in `sources[i]`, into register i, for all i. `registers` is how
/// many registers may be written to; where all of them are taken, a circle goes through a slot.
pub(super) fn carry(sources: Vec<Source<Place>>, registers: usize, code: &mut Allocation) {
    let states = sources.len();
    let mut moves: Vec<(Vector, Source<Place>)> =
        (0..).map(Vector).zip(sources).filter(|(to, source)| *source != Source::Register(*to)).collect();
    while let Some(place) = next(&moves) {
        let (to, source) = moves[place];
        let still_read = moves.iter().any(|(_, source)| *source == Source::Register(to));
        if still_read {
            // A circle: what is in the way goes elsewhere first.
            let elsewhere = match spare(&moves, states, registers) {
                Some(register) => {
                    code.round.push(MachineInstruction::Copy(register, to));
                    Source::Register(register)
                }
                None => {
                    let slot = Place::Slot(code.slots);
                    code.round.push(MachineInstruction::Store(slot, to));
                    code.slots += 1;
                    Source::Memory(slot)
                }
            };
            for (_, source) in moves.iter_mut().filter(|(_, source)| *source == Source::Register(to)) {
                *source = elsewhere;
            }
            continue;
        }
        code.round.push(MachineInstruction::bring(to, source));
        moves.swap_remove(place);
    }
}

/// A move whose register nobody reads any more, or any other.
fn next(moves: &[(Vector, Source<Place>)]) -> Option<usize> {
    let is_free =
        |(to, _): &(Vector, Source<Place>)| !moves.iter().any(|(_, source)| *source == Source::Register(*to));
    moves.iter().position(is_free).or(if moves.is_empty() { None } else { Some(0) })
}

/// A register that is neither written to nor read by a move.
fn spare(moves: &[(Vector, Source<Place>)], states: usize, registers: usize) -> Option<Vector> {
    let is_read = |register: Vector| moves.iter().any(|(_, source)| *source == Source::Register(register));
    (states..registers).map(|index| Vector(index as u8)).find(|register| !is_read(*register))
}
