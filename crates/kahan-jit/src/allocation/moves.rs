//! Moves a round's results to the states of the next round, as if all moves happened at once.

use crate::assembler::{Source, Vector};

use super::{Allocation, MachineInstruction, ValueLocation};

/// Moves `sources[i]` into register i for all i. If these moves form a cycle, one value is first
/// saved in a free register or a stack slot.
pub(super) fn move_results(sources: Vec<Source<ValueLocation>>, registers: usize, code: &mut Allocation) {
    let states = sources.len();
    let mut moves: Vec<(Vector, Source<ValueLocation>)> =
        (0..).map(Vector).zip(sources).filter(|(to, source)| *source != Source::Register(*to)).collect();
    while let Some(place) = next(&moves) {
        let (to, source) = moves[place];
        let still_read = moves.iter().any(|(_, source)| *source == Source::Register(to));
        if still_read {
            let elsewhere = match free_register(&moves, states, registers) {
                Some(register) => {
                    code.round.push(MachineInstruction::Copy(register, to));
                    Source::Register(register)
                }
                None => {
                    let slot = ValueLocation::Slot(code.slots);
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
        code.round.push(MachineInstruction::load_into(to, source));
        moves.swap_remove(place);
    }
}

/// Returns the index of a move whose target no move reads. If the moves form cycles only, returns
/// 0. If there are no moves, returns `None`.
fn next(moves: &[(Vector, Source<ValueLocation>)]) -> Option<usize> {
    let is_free = |(to, _): &(Vector, Source<ValueLocation>)| {
        !moves.iter().any(|(_, source)| *source == Source::Register(*to))
    };
    moves.iter().position(is_free).or(if moves.is_empty() { None } else { Some(0) })
}

fn free_register(
    moves: &[(Vector, Source<ValueLocation>)],
    states: usize,
    registers: usize,
) -> Option<Vector> {
    let is_read = |register: Vector| moves.iter().any(|(_, source)| *source == Source::Register(register));
    (states..registers).map(|index| Vector(index as u8)).find(|register| !is_read(*register))
}
