//! The pool of constants that follows the code.

use super::operands::{Element, OperandForm};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Entry(usize);

/// The constants of a function, and the places in the code that refer to them.
#[derive(Debug)]
pub(super) struct Pool {
    form: OperandForm,
    /// For each constant, the bits that every lane holds.
    entries: Vec<u64>,
    /// For each reference, its position in the code and its constant.
    uses: Vec<(usize, Entry)>,
}

/// The alignment of the first entry, a cache line.
const ENTRY_ALIGNMENT: usize = 64;
const SHORTEST: usize = 16;

impl Pool {
    pub(super) fn new(form: OperandForm) -> Self {
        Pool { form, entries: Vec::new(), uses: Vec::new() }
    }

    /// Returns the entry of a constant, which is added at first use. `bits` encodes one lane.
    pub(super) fn entry(&mut self, bits: u64) -> Entry {
        let known = self.entries.iter().position(|known| *known == bits);
        Entry(known.unwrap_or_else(|| {
            self.entries.push(bits);
            self.entries.len() - 1
        }))
    }

    pub(super) fn note_use(&mut self, place: usize, entry: Entry) {
        self.uses.push((place, entry));
    }

    /// Appends the constants to the code, after a gap up to the next cache line. The gap consists
    /// of `filler` bytes, which trap. `refer` writes a constant's position into an instruction.
    pub(super) fn append_to(
        self,
        mut code: Vec<u8>,
        filler: u8,
        refer: impl Fn(&mut [u8], usize, usize),
    ) -> Vec<u8> {
        code.resize(code.len().next_multiple_of(ENTRY_ALIGNMENT), filler);
        let (start, length) = (code.len(), self.form.bytes().max(SHORTEST));
        for bits in &self.entries {
            match self.form.element {
                Element::Double => code.extend(bits.to_le_bytes().repeat(length / 8)),
                Element::Single => code.extend((*bits as u32).to_le_bytes().repeat(length / 4)),
            }
        }
        for (place, Entry(entry)) in self.uses {
            refer(&mut code, place, start + entry * length);
        }
        code
    }
}
