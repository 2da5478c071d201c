//! What is done of a part that is under way, so that a process that ends loses little.
//!
//! Records are appended: kind, first row, rows, bytes, checksum, and the bytes of the rows. What a
//! killed process wrote by halves is passed over. Each process has files of its own, and all go
//! when the part is there. Records of another plan, version or kind of floats are passed over, too.

use std::fs::File;
use std::io::{self, Write};
use std::path::PathBuf;

use kahan_study::{Kept, Table};
use sha2::{Digest, Sha256};

use super::Part;
use super::part::{FLOATS, VERSION, files, fresh};

/// The record file of one process for one part.
pub(crate) struct Journal {
    folder: PathBuf,
    file: Option<File>,
    kind: [u8; 8],
}

/// How the names of such files begin and end.
const BEGIN: &str = "notes-";
const END: &str = ".bin";

impl Journal {
    /// For a part.
    pub(crate) fn of(part: &Part<'_>) -> Self {
        Self { folder: part.under_way(), file: None, kind: kind(part) }
    }

    /// What processes before have noted of a part: first rows and rows, in no order.
    pub(crate) fn noted(part: &Part<'_>) -> Vec<(u64, Table)> {
        let mut noted = Vec::new();
        for path in files(&part.under_way(), BEGIN, END) {
            // What cannot be read is computed again.
            let bytes = std::fs::read(path).unwrap_or_default();
            let mut rest = Bytes(&bytes);
            while let Some(record) = rest.record(kind(part), &part.plan.empty) {
                noted.extend(record);
            }
        }
        noted
    }

    /// Notes rows, each from a first one on, on the disk when this returns. Where that fails,
    /// nothing of what was noted before is lost, and it can be tried again.
    pub(crate) fn note(&mut self, done: &[(u64, Table)]) -> io::Result<()> {
        // Behind half a record none is found: after a failure there is another file.
        let mut file = match self.file.take() {
            Some(file) => file,
            // Its name is random: processes on other machines, or in containers, may share a
            // number.
            None => fresh(&self.folder, BEGIN, END)?.keep()?.0,
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

/// What tells records that belong together from others: the plan's hash, the version of this
/// program and how it computes with floats.
fn kind(part: &Part<'_>) -> [u8; 8] {
    let digest = Sha256::digest([&part.plan.hash(), VERSION, FLOATS].join("\n"));
    std::array::from_fn(|place| digest[place])
}

/// The CRC-32 of a record: of what stands before it, and of the rows behind it.
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
            Kept::Integer(list) => bytes.extend(list.iter().flat_map(|entry| entry.to_le_bytes())),
            Kept::F64(list) => bytes.extend(list.iter().flat_map(|entry| entry.to_le_bytes())),
            Kept::Text(list) => {
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

/// What is left of bytes that are read from their beginning; `None` where there are not so many.
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

    /// The next record, if all of it is there: its rows, if they are of this kind.
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

    /// Rows of a table that has these columns, to the last byte.
    fn table(mut self, count: usize, empty: &Table) -> Option<Table> {
        let mut values = Vec::new();
        for kept in &empty.values {
            values.push(match kept {
                Kept::Integer(_) => Kept::Integer(self.words(count, i64::from_le_bytes)?),
                Kept::F64(_) => Kept::F64(self.words(count, f64::from_le_bytes)?),
                Kept::Text(_) => Kept::Text((0..count).map(|_| self.text()).collect::<Option<_>>()?),
                other => unreachable!("no sweep has a column of {other:?}"),
            });
        }
        self.0.is_empty().then(|| Table { columns: empty.columns.clone(), values })
    }
}
