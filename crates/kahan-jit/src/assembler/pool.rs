//! Numbers that stand behind the code.

use super::operands::{Element, Form};

/// A number of the pool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Entry(usize);

/// The numbers, and where the code refers to them.
#[derive(Debug)]
pub(super) struct Pool {
    form: Form,
    /// The bits of one lane each.
    entries: Vec<u64>,
    /// Where an offset stands, and of which entry it is.
    uses: Vec<(usize, Entry)>,
}

/// Entries begin with cache lines, and are no shorter than what operations on bits read.
const LINE: usize = 64;
const SHORTEST: usize = 16;

impl Pool {
    pub(super) fn new(form: Form) -> Self {
        Pool { form, entries: Vec::new(), uses: Vec::new() }
    }

    /// The entry of a number, of which there is one; `bits` are those of a lane.
    pub(super) fn entry(&mut self, bits: u64) -> Entry {
        let known = self.entries.iter().position(|known| *known == bits);
        Entry(known.unwrap_or_else(|| {
            self.entries.push(bits);
            self.entries.len() - 1
        }))
    }

    /// The code refers to an entry at `place`.
    pub(super) fn note_use(&mut self, place: usize, entry: Entry) {
        self.uses.push((place, entry));
    }

    /// Appends the numbers to the code, behind the byte `filler` as often as it takes, which stops
    /// whoever runs it; `refer` writes into the code at a place where an entry stands.
    pub(super) fn append_to(
        self,
        mut code: Vec<u8>,
        filler: u8,
        refer: impl Fn(&mut [u8], usize, usize),
    ) -> Vec<u8> {
        code.resize(code.len().next_multiple_of(LINE), filler);
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
