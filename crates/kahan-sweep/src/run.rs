//! Computes a shard. The missing and damaged parts of the shard are computed one after another,
//! each on all threads of the process.

use std::io;
use std::ops::{ControlFlow, Range};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use kahan_runtime::threads::for_each;
use kahan_study::{Progress, Table, Watch};

use crate::files::{Journal, Part, UnusablePart};
use crate::plan::Plan;

/// The parts that one process computes: `index`, `index + of`, `index + 2 of`, ….
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shard {
    /// The index of the shard, counted from 0.
    pub(crate) index: u64,
    pub(crate) of: u64,
}

impl Shard {
    pub(crate) const WHOLE: Self = Shard { index: 0, of: 1 };

    pub(crate) fn parts(self, plan: &Plan) -> impl Iterator<Item = u64> + use<> {
        (self.index..plan.parts()).step_by(usize::try_from(self.of).unwrap_or(usize::MAX))
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RunEnd {
    Done,
    /// The process was told to stop; finished rows are in the journal.
    Interrupted,
}

/// The interval between journal entries, and the longest time for which a thread keeps its rows.
const JOURNAL_INTERVAL: Duration = Duration::from_secs(8);

/// The message of `expect` on locks. No lock is ever poisoned, because a panic ends the process.
const LOCK_MESSAGE: &str = "a thread that panics ends the process";

pub(crate) struct Run<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) folder: &'a Path,
    pub(crate) threads: Option<usize>,
    /// A flag that is set when the process is told to stop.
    pub(crate) stop: &'a AtomicBool,
    pub(crate) progress: &'a (dyn Fn(u64) + Sync),
    pub(crate) say: &'a (dyn Fn(&str) + Sync),
}

impl Run<'_> {
    /// Computes the missing parts of a shard.
    pub(crate) fn shard(&self, shard: Shard) -> Result<RunEnd, String> {
        for index in shard.parts(self.plan) {
            let part = Part::of(self.plan, index, self.folder);
            match part.exists().then(|| part.open_checked()) {
                None => {}
                Some(Ok(_)) => {
                    let rows = self.plan.part(index);
                    (self.progress)(rows.end - rows.start);
                    // If another process has finished the part, temporary files may remain.
                    part.remove_unfinished();
                    continue;
                }
                Some(Err(UnusablePart::Damaged(why))) => (self.say)(&format!("{why}; it is computed again")),
                Some(Err(foreign)) => return Err(foreign.to_string()),
            }
            let end = self.part(&part).map_err(|error| {
                let folder = self.folder.display();
                format!(
                    "{folder} cannot be written: {error}; what is done is kept, and the same command goes on"
                )
            })?;
            if end == RunEnd::Interrupted {
                return Ok(end);
            }
        }
        Ok(RunEnd::Done)
    }

    fn part(&self, part: &Part<'_>) -> io::Result<RunEnd> {
        let indices = self.plan.part(part.index);
        let done = noted_within(Journal::noted(part), &indices);
        (self.progress)(done.iter().map(|(_, rows)| rows.count() as u64).sum());
        let threads = self.threads.unwrap_or(1) as u64;
        let rows = indices.end - indices.start;
        let [least, most] = self.plan.at_once();
        let chunk = (rows / (8 * threads)).clamp(least, most);
        let chunks = missing_chunks(&done, &indices, chunk);
        let (journal, noted) = (Journal::of(part), Instant::now());
        let work = Mutex::new(PartWork { done, unnoted: 0, journal, noted, has_failed: false });
        for_each(chunks.len(), self.threads, &|chunk| self.chunk(chunks[chunk].clone(), &work));
        let mut work = work.into_inner().expect(LOCK_MESSAGE);
        if self.stop.load(Ordering::Relaxed) {
            work.note()?;
            return Ok(RunEnd::Interrupted);
        }
        work.done.sort_by_key(|(first, _)| *first);
        let mut all = Table::default();
        for (_, rows) in work.done {
            let _ = rows.pass_to(&mut all);
        }
        part.write(&all)?;
        part.remove_unfinished();
        Ok(RunEnd::Done)
    }

    /// Computes a range of rows piece by piece, and adds each finished piece to `work`.
    fn chunk(&self, indices: Range<u64>, work: &Mutex<PartWork>) {
        let mut next = indices.start;
        while next < indices.end && !self.stop.load(Ordering::Relaxed) {
            let turn = ThreadTurn { stop: self.stop, begun: Instant::now(), done: AtomicU64::new(0) };
            let made = self.plan.rows(next..indices.end, &turn);
            let count = made.count() as u64;
            if count == 0 {
                continue;
            }
            (self.progress)(count);
            if let Some(error) = work.lock().expect(LOCK_MESSAGE).take(next, made) {
                (self.say)(&format!(
                    "what is done cannot be noted in {}: {error}; it is kept in memory, and noted as soon as that works",
                    self.folder.display()
                ));
            }
            next += count;
        }
    }
}

/// The work of a thread until it hands over its rows.
struct ThreadTurn<'a> {
    stop: &'a AtomicBool,
    begun: Instant,
    /// The number of finished rows at the last check.
    done: AtomicU64,
}

impl Watch for ThreadTurn<'_> {
    /// Ends the work at once on request, and after the time limit at the end of a block of rows.
    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        let are_made = self.done.swap(progress.done, Ordering::Relaxed) < progress.done;
        let is_over = are_made && self.begun.elapsed() > JOURNAL_INTERVAL;
        if is_over || self.stop.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}

struct PartWork {
    /// The finished tables in any order, each with the number of its first row.
    done: Vec<(u64, Table)>,
    /// The number of tables, at the end of `done`, that are not in the journal yet.
    unnoted: usize,
    journal: Journal,
    noted: Instant,
    /// Whether writing the last journal entry failed.
    has_failed: bool,
}

impl PartWork {
    /// Adds rows, and writes the journal when it is due. Returns the error of the write, unless the
    /// previous write also failed.
    fn take(&mut self, first: u64, rows: Table) -> Option<io::Error> {
        self.done.push((first, rows));
        self.unnoted += 1;
        if self.noted.elapsed() <= JOURNAL_INTERVAL {
            return None;
        }
        let was_told = self.has_failed;
        let error = self.note().err();
        self.has_failed = error.is_some();
        error.filter(|_| !was_told)
    }

    fn note(&mut self) -> io::Result<()> {
        self.noted = Instant::now();
        let from = self.done.len() - self.unnoted;
        self.journal.note(&self.done[from..])?;
        self.unnoted = 0;
        Ok(())
    }
}

/// Returns the recorded tables in the order of their rows, without overlaps.
fn noted_within(mut noted: Vec<(u64, Table)>, indices: &Range<u64>) -> Vec<(u64, Table)> {
    noted.sort_by_key(|(first, _)| *first);
    let mut next = indices.start;
    noted.retain(|(first, rows)| {
        let end = first.saturating_add(rows.count() as u64);
        let fits = *first >= next && end <= indices.end;
        if fits {
            next = end;
        }
        fits
    });
    noted
}

/// Divides the gaps between finished rows into chunks.
fn missing_chunks(done: &[(u64, Table)], indices: &Range<u64>, chunk: u64) -> Vec<Range<u64>> {
    let mut chunks = Vec::new();
    let mut next = indices.start;
    let ends = done.iter().map(|(first, rows)| (*first, first + rows.count() as u64));
    for (gap_end, after) in ends.chain([(indices.end, indices.end)]) {
        while next < gap_end {
            let end = gap_end.min(next + chunk);
            chunks.push(next..end);
            next = end;
        }
        next = after;
    }
    chunks
}

#[cfg(test)]
mod tests {
    use super::*;
    use kahan_study::StoredColumn;

    fn some(first: u64, count: u64) -> (u64, Table) {
        let indices = (first..first + count).map(|index| index as i64).collect();
        (first, Table { columns: Vec::new(), values: vec![StoredColumn::Integer(indices)] })
    }

    #[test]
    fn what_is_left_is_what_was_not_noted() {
        let noted = vec![some(300, 10), some(0, 100), some(305, 10), some(0, 50), some(990, 50)];
        let done = noted_within(noted, &(0..1000));
        assert_eq!(
            done.iter().map(|(first, rows)| (*first, rows.count())).collect::<Vec<_>>(),
            [(0, 100), (300, 10)]
        );
        assert_eq!(missing_chunks(&done, &(0..1000), 256), [100..300, 310..566, 566..822, 822..1000]);
    }
}
