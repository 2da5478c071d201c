//! When each line is used next: what decides which register is given up.

use crate::lines::Lines;

/// The uses of every line, in order.
pub(super) struct Uses {
    uses: Vec<Vec<usize>>,
    /// How many of them are over.
    over: Vec<usize>,
}

impl Uses {
    /// The uses as operands.
    pub(super) fn of(lines: &Lines) -> Self {
        let mut uses = vec![Vec::new(); lines.lines.len()];
        for (time, line) in lines.lines.iter().enumerate() {
            line.operands().for_each(|operand| uses[operand].push(time));
        }
        Uses { over: vec![0; uses.len()], uses }
    }

    /// Notes a use after all that are known.
    pub(super) fn add(&mut self, line: usize, time: usize) {
        self.uses[line].push(time);
    }

    /// The last use of a line.
    pub(super) fn last(&self, line: usize) -> Option<usize> {
        self.uses[line].last().copied()
    }

    /// How often a line is used.
    pub(super) fn count(&self, line: usize) -> usize {
        self.uses[line].len()
    }

    /// The next use of a line; `None` where there is none.
    pub(super) fn next(&self, line: usize) -> Option<usize> {
        self.uses[line].get(self.over[line]).copied()
    }

    /// The next use after `time`.
    pub(super) fn next_after(&self, line: usize, time: usize) -> Option<usize> {
        self.uses[line][self.over[line]..].iter().copied().find(|use_| *use_ > time)
    }

    /// Uses up to `time` are over.
    pub(super) fn end(&mut self, line: usize, time: usize) {
        while self.next(line).is_some_and(|next| next <= time) {
            self.over[line] += 1;
        }
    }
}
