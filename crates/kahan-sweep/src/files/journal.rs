//! What is done of a part that is under way, so that a process that ends loses little.
//!
//! Records are appended, each with its checksum; what a killed process wrote by halves is passed
//! over. Each process has files of its own, and all go when the part is there.
//! Records of another plan, version or kind of floats are passed over, too.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::PathBuf;

use sha2::{Digest, Sha256};

use crate::columns::{Entries, Rows};

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
    pub(crate) fn noted(part: &Part<'_>, hash: &str, empty: &Rows) -> Vec<(u64, Rows)> {
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
    pub(crate) fn note(&mut self, done: &[(u64, Rows)]) -> io::Result<()> {
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
            record.extend((rows.len() as u64).to_le_bytes());
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
fn read(mut bytes: &[u8], kind: [u8; 8], empty: &Rows, noted: &mut Vec<(u64, Rows)>) {
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

fn encode(rows: &Rows) -> Vec<u8> {
    let mut bytes = Vec::new();
    for column in &rows.columns {
        match column {
            Entries::Integers(entries) => bytes.extend(entries.iter().flat_map(|entry| entry.to_le_bytes())),
            Entries::Doubles(entries) => bytes.extend(entries.iter().flat_map(|entry| entry.to_le_bytes())),
            Entries::Texts(entries) => {
                for entry in entries {
                    bytes.extend((entry.len() as u64).to_le_bytes());
                    bytes.extend(entry.as_bytes());
                }
            }
        }
    }
    bytes
}

fn decode(mut bytes: &[u8], count: usize, empty: &Rows) -> Option<Rows> {
    let mut take = |length: usize| {
        let (taken, rest) = bytes.split_at_checked(length)?;
        bytes = rest;
        Some(taken)
    };
    let mut columns = Vec::new();
    for column in &empty.columns {
        columns.push(match column {
            Entries::Integers(_) => {
                let words = take(8 * count)?.chunks_exact(8);
                Entries::Integers(
                    words.map(|word| i64::from_le_bytes(word.try_into().unwrap_or_default())).collect(),
                )
            }
            Entries::Doubles(_) => {
                let words = take(8 * count)?.chunks_exact(8);
                Entries::Doubles(
                    words.map(|word| f64::from_le_bytes(word.try_into().unwrap_or_default())).collect(),
                )
            }
            Entries::Texts(_) => {
                let mut texts = Vec::with_capacity(count);
                for _ in 0..count {
                    let length = u64::from_le_bytes(take(8)?.try_into().ok()?);
                    texts.push(String::from_utf8(take(usize::try_from(length).ok()?)?.to_vec()).ok()?);
                }
                Entries::Texts(texts)
            }
        });
    }
    bytes.is_empty().then_some(Rows { columns })
}
