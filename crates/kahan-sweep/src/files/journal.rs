//! What is done of a part that is under way, so that a process that ends loses little.
//!
//! Records are appended, each with its checksum; what a killed process wrote by halves is passed
//! over. Each process has files of its own, and all go when the part is there.
//! Records of another plan, version or kind of floats are passed over, too.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::PathBuf;

use kahan_study::{Kept, Table};
use sha2::{Digest, Sha256};

use super::Part;
use super::part::{files, floats, fresh};

/// The record file of one process for one part.
pub(crate) struct Journal {
    folder: PathBuf,
    file: Option<File>,
    kind: [u8; 8],
}

/// How the names of such files begin and end.
const BEGIN: &str = "notes-";
const END: &str = ".bin";

/// The beginning of every record: kind, first row, rows, bytes, checksum.
const HEAD: usize = 8 + 8 + 8 + 8 + 4;

impl Journal {
    /// For a part.
    pub(crate) fn of(part: &Part<'_>, hash: &str) -> Self {
        Self { folder: part.under_way(), file: None, kind: kind(hash) }
    }

    /// What processes before have noted of a part: first rows and rows, in no order.
    pub(crate) fn noted(part: &Part<'_>, hash: &str, empty: &Table) -> Vec<(u64, Table)> {
        let mut noted = Vec::new();
        for path in files(&part.under_way(), BEGIN, END) {
            let mut bytes = Vec::new();
            // What cannot be read is computed again.
            if File::open(&path).and_then(|mut file| file.read_to_end(&mut bytes)).is_ok() {
                read(&bytes, kind(hash), empty, &mut noted);
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
            let mut record = Vec::with_capacity(HEAD + body.len());
            record.extend(self.kind);
            record.extend(first.to_le_bytes());
            record.extend((rows.count() as u64).to_le_bytes());
            record.extend((body.len() as u64).to_le_bytes());
            let mut hasher = crc32fast::Hasher::new();
            hasher.update(&record);
            hasher.update(&body);
            record.extend(hasher.finalize().to_le_bytes());
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
fn kind(hash: &str) -> [u8; 8] {
    let digest = Sha256::digest([hash, env!("CARGO_PKG_VERSION"), floats()].join("\n"));
    std::array::from_fn(|place| digest[place])
}

/// The records of a file, up to the first that is not whole.
fn read(mut bytes: &[u8], kind: [u8; 8], empty: &Table, noted: &mut Vec<(u64, Table)>) {
    while let Some((head, rest)) = bytes.split_at_checked(HEAD) {
        let number = |at: usize| u64::from_le_bytes(head[at..at + 8].try_into().unwrap_or_default());
        let (first, count, length) = (number(8), number(16), number(24));
        let stated = u32::from_le_bytes(head[32..].try_into().unwrap_or_default());
        let Some((body, rest)) =
            usize::try_from(length).ok().and_then(|length| rest.split_at_checked(length))
        else {
            return;
        };
        let mut hasher = crc32fast::Hasher::new();
        hasher.update(&head[..32]);
        hasher.update(body);
        if hasher.finalize() != stated {
            return;
        }
        if head[..8] == kind
            && let Some(rows) = decode(body, count as usize, empty)
        {
            noted.push((first, rows));
        }
        bytes = rest;
    }
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

fn decode(mut bytes: &[u8], count: usize, empty: &Table) -> Option<Table> {
    let mut take = |length: usize| {
        let (taken, rest) = bytes.split_at_checked(length)?;
        bytes = rest;
        Some(taken)
    };
    let mut values = Vec::new();
    for kept in &empty.values {
        values.push(match kept {
            Kept::Integer(_) => {
                let words = take(8 * count)?.as_chunks().0;
                Kept::Integer(words.iter().map(|word| i64::from_le_bytes(*word)).collect())
            }
            Kept::F64(_) => {
                let words = take(8 * count)?.as_chunks().0;
                Kept::F64(words.iter().map(|word| f64::from_le_bytes(*word)).collect())
            }
            Kept::Text(_) => {
                let mut list = Vec::new();
                for _ in 0..count {
                    let length = u64::from_le_bytes(take(8)?.try_into().ok()?);
                    list.push(String::from_utf8(take(usize::try_from(length).ok()?)?.to_vec()).ok()?);
                }
                Kept::Text(list)
            }
            other => unreachable!("no sweep has a column of {other:?}"),
        });
    }
    bytes.is_empty().then(|| Table { columns: empty.columns.clone(), values })
}
