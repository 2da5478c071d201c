//! What is done of a part that is under way, so that a process that ends loses little.
//!
//! Records are appended, each with its checksum; what a killed process wrote by halves is passed
//! over. Each process has a file of its own beside the part, and all go when the part is there.
//! Records of another plan, version or kind of floats are passed over, too.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::columns::{Entries, Rows};

use super::Part;
use super::part::{floats, fresh};

/// The record file of one process for one part.
pub(crate) struct Journal {
    part: PathBuf,
    file: Option<File>,
    kind: [u8; 8],
}

/// The beginning of every record: kind, first row, rows, bytes, checksum.
const HEAD: usize = 8 + 8 + 8 + 8 + 4;

impl Journal {
    /// For a part.
    pub(crate) fn of(part: &Part<'_>, hash: &str) -> Self {
        Self { part: part.path.clone(), file: None, kind: kind(hash) }
    }

    /// What processes before have noted of a part: first rows and rows, in no order.
    pub(crate) fn noted(part: &Part<'_>, hash: &str, empty: &Rows) -> Vec<(u64, Rows)> {
        let mut noted = Vec::new();
        for path in files(part) {
            let mut bytes = Vec::new();
            // What cannot be read is computed again.
            if File::open(&path).and_then(|mut file| file.read_to_end(&mut bytes)).is_ok() {
                read(&bytes, kind(hash), empty, &mut noted);
            }
        }
        noted
    }

    /// Notes rows, each from a first one on, on the disk when this returns.
    pub(crate) fn note(&mut self, done: &[(u64, Rows)]) -> io::Result<()> {
        let file = match &mut self.file {
            Some(file) => file,
            // Its name is random: processes on other machines, or in containers, may share a number.
            none => {
                let folder = self.part.parent().unwrap_or(Path::new("."));
                none.insert(fresh(folder, &stem(&self.part), ".partial")?.keep()?.0)
            }
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
        file.sync_data()
    }

    /// Removes what was noted of a part, by whomever.
    pub(crate) fn remove(part: &Part<'_>) {
        for path in files(part) {
            // What stays is passed over, as the part is there.
            let _ = fs::remove_file(path);
        }
    }
}

/// What tells records that belong together from others: the plan's hash, the version of this program
/// and how it computes with floats.
fn kind(hash: &str) -> [u8; 8] {
    let digest = Sha256::digest([hash, env!("CARGO_PKG_VERSION"), floats()].join("\n"));
    std::array::from_fn(|place| digest[place])
}

/// What the names of a part's record files begin with.
fn stem(part: &Path) -> String {
    part.file_stem().unwrap_or_default().to_string_lossy().into_owned() + "."
}

/// The record files of a part.
fn files(part: &Part<'_>) -> Vec<PathBuf> {
    let folder = part.path.parent().unwrap_or(Path::new("."));
    let stem = stem(&part.path);
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let named = entries.filter(|entry| {
        let name = entry.file_name().to_string_lossy().into_owned();
        name.starts_with(&stem) && name.ends_with(".partial")
    });
    named.map(|entry| entry.path()).collect()
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
