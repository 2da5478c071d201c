//! The journal of an unfinished part. After an interruption, recorded rows are not computed again,
//! except in overlapping records.
//!
//! Each process appends records of finished rows to its own file. Readers stop at an incomplete or
//! damaged record, and skip records of another plan, version or floating-point mode. The files are
//! deleted once the part exists.

use std::fs::File;
use std::io::{self, Write};
use std::path::PathBuf;

use kahan_study::{StoredColumn, Table};
use sha2::{Digest, Sha256};

use super::Part;
use super::part::{FLOATS, VERSION, files, fresh};

pub(crate) struct Journal {
    folder: PathBuf,
    file: Option<File>,
    kind: [u8; 8],
}

/// The prefix and suffix of the names of journal files.
const JOURNAL_PREFIX: &str = "notes-";
const JOURNAL_SUFFIX: &str = ".bin";

impl Journal {
    pub(crate) fn of(part: &Part<'_>) -> Self {
        Self { folder: part.unfinished_folder(), file: None, kind: record_kind(part) }
    }

    /// Returns the tables that earlier processes wrote, in any order, with the numbers of their
    /// first rows.
    pub(crate) fn noted(part: &Part<'_>) -> Vec<(u64, Table)> {
        let mut noted = Vec::new();
        for path in files(&part.unfinished_folder(), JOURNAL_PREFIX, JOURNAL_SUFFIX) {
            // If a file is unreadable, its rows are computed again.
            let bytes = std::fs::read(path).unwrap_or_default();
            let mut rest = Bytes(&bytes);
            while let Some(record) = rest.record(record_kind(part), &part.plan.empty) {
                noted.extend(record);
            }
        }
        noted
    }

    /// Appends tables, each with the number of its first row, and syncs the file. The call may be
    /// repeated after an error.
    pub(crate) fn note(&mut self, done: &[(u64, Table)]) -> io::Result<()> {
        // Readers stop at an incomplete record, so a new file is begun after a failure.
        let mut file = match self.file.take() {
            Some(file) => file,
            // The name of the file is random, because processes in containers may have equal ids.
            None => fresh(&self.folder, JOURNAL_PREFIX, JOURNAL_SUFFIX)?.keep()?.0,
        };
        for (first, rows) in done {
            let body = encode(rows);
            let mut record = self.kind.to_vec();
            let numbers = [*first, rows.count() as u64, body.len() as u64];
            record.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
            record.extend(checksum(&record, &body).to_le_bytes());
            record.extend(body);
            file.write_all(&record)?;
        }
        file.sync_data()?;
        self.file = Some(file);
        Ok(())
    }
}

/// Returns a hash of plan, version and floating-point mode. Records with another hash are skipped.
fn record_kind(part: &Part<'_>) -> [u8; 8] {
    let digest = Sha256::digest([&part.plan.hash(), VERSION, FLOATS].join("\n"));
    std::array::from_fn(|place| digest[place])
}

fn checksum(head: &[u8], body: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(head);
    hasher.update(body);
    hasher.finalize()
}

fn encode(rows: &Table) -> Vec<u8> {
    let mut bytes = Vec::new();
    for kept in &rows.values {
        match kept {
            StoredColumn::Integer(list) => bytes.extend(list.iter().flat_map(|entry| entry.to_le_bytes())),
            StoredColumn::F64(list) => bytes.extend(list.iter().flat_map(|entry| entry.to_le_bytes())),
            StoredColumn::Text(list) => {
                for entry in list {
                    bytes.extend((entry.len() as u64).to_le_bytes());
                    bytes.extend(entry.as_bytes());
                }
            }
            other => unreachable!("no sweep has a column of {other:?}"),
        }
    }
    bytes
}

struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take(&mut self, length: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        Some(taken)
    }

    fn words<T>(&mut self, count: usize, of: fn([u8; 8]) -> T) -> Option<Vec<T>> {
        (0..count).map(|_| Some(of(self.take(8)?.try_into().ok()?))).collect()
    }

    fn number(&mut self) -> Option<u64> {
        self.words(1, u64::from_le_bytes)?.pop()
    }

    fn text(&mut self) -> Option<String> {
        let length = self.number()?.try_into().ok()?;
        String::from_utf8(self.take(length)?.to_vec()).ok()
    }

    /// Reads the next record; `None` if it is damaged, `Some(None)` for other columns or kinds.
    fn record(&mut self, kind: [u8; 8], empty: &Table) -> Option<Option<(u64, Table)>> {
        let record = self.0;
        let is_of_kind = self.take(8)? == kind;
        let (first, count, length) = (self.number()?, self.number()?, self.number()?);
        let stated = self.take(4)?;
        let body = self.take(length.try_into().ok()?)?;
        let is_whole = checksum(&record[..32], body).to_le_bytes() == stated;
        let rows = || Some((first, Bytes(body).table(count as usize, empty)?));
        is_whole.then(|| if is_of_kind { rows() } else { None })
    }

    /// Decodes a table with the columns of `empty`; fails unless the table uses all bytes.
    fn table(mut self, count: usize, empty: &Table) -> Option<Table> {
        let mut values = Vec::new();
        for kept in &empty.values {
            values.push(match kept {
                StoredColumn::Integer(_) => StoredColumn::Integer(self.words(count, i64::from_le_bytes)?),
                StoredColumn::F64(_) => StoredColumn::F64(self.words(count, f64::from_le_bytes)?),
                StoredColumn::Text(_) => {
                    StoredColumn::Text((0..count).map(|_| self.text()).collect::<Option<_>>()?)
                }
                other => unreachable!("no sweep has a column of {other:?}"),
            });
        }
        self.0.is_empty().then(|| Table { columns: empty.columns.clone(), values })
    }
}
