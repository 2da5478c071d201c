//! One part: written whole or not at all, and checked before it is used.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use kahan_study::{Kept, Table};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use tempfile::{Builder, NamedTempFile};

use crate::plan::Plan;

/// What stands in the metadata of every file of a sweep.
pub(super) mod keys {
    pub(in crate::files) const PLAN: &str = "kahan.plan";
    pub(in crate::files) const HASH: &str = "kahan.plan.sha256";
    pub(in crate::files) const VERSION: &str = "kahan.version";
    pub(in crate::files) const FLOATS: &str = "kahan.floats";
    pub(in crate::files) const COLUMNS: &str = "kahan.columns";
    pub(in crate::files) const SEED: &str = "kahan.seed";
    pub(in crate::files) const PART: &str = "kahan.part";
    pub(in crate::files) const CHECKSUM: &str = "kahan.crc32";
}

/// How this program computes with floats, where that may differ from machine to machine: results
/// with other words differ in last digits.
pub(super) fn floats() -> &'static str {
    match (cfg!(target_arch = "x86_64"), cfg!(target_feature = "fma")) {
        (true, false) => "x86-64, products rounded",
        (true, true) => "x86-64, products fused",
        (false, _) => "interpreted, on another processor",
    }
}

/// Why a part that is there cannot be used.
#[derive(Clone, Debug)]
pub(crate) enum Unusable {
    /// It is not whole: its shard can write it anew.
    Damaged(String),
    /// It is of another plan, version or kind of machine, and in its place here by mistake.
    Foreign(String),
}

impl Unusable {
    /// The reason in words.
    pub(crate) fn reason(self) -> String {
        match self {
            Unusable::Damaged(reason) | Unusable::Foreign(reason) => reason,
        }
    }
}

/// A part of a sweep.
#[derive(Clone, Debug)]
pub(crate) struct Part<'a> {
    pub(super) plan: &'a Plan,
    hash: String,
    pub(crate) index: u64,
    pub(crate) path: PathBuf,
}

impl<'a> Part<'a> {
    /// The part with this index, in a folder.
    pub(crate) fn of(plan: &'a Plan, hash: &str, index: u64, folder: &Path) -> Self {
        Part { plan, hash: hash.to_owned(), index, path: folder.join(format!("part-{index:012}.parquet")) }
    }

    /// Writes all its rows; the file appears when it is complete.
    pub(crate) fn write(&self, rows: &Table) -> io::Result<()> {
        match self.written(rows) {
            // Another process wrote the part meanwhile, and tidied up.
            Err(error) if error.kind() == io::ErrorKind::NotFound && self.exists() => Ok(()),
            result => result,
        }
    }

    fn written(&self, rows: &Table) -> io::Result<()> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        let mut file = fresh(&self.under_way(), "rows-", ".parquet")?;
        let mut writer = writer(self.plan, &self.hash, &mut file).map_err(other)?;
        let mut group = writer.next_row_group().map_err(other)?;
        for column in &rows.values {
            put(&mut group, column).map_err(other)?;
        }
        group.close().map_err(other)?;
        for (key, value) in [(keys::PART, self.index.to_string()), (keys::CHECKSUM, NO_DIGITS.to_owned())] {
            writer.append_key_value_metadata(KeyValue::new(key.to_owned(), value));
        }
        writer.close().map_err(other)?;
        let sum = Checksum::of(file.as_file_mut())?;
        file.seek(SeekFrom::Start(sum.place))?;
        file.write_all(sum.found.as_bytes())?;
        file.as_file().sync_all()?;
        file.persist(&self.path)?.sync_all()?;
        // The name is on the disk when the folder is; where a folder cannot be opened, nothing more
        // can be done.
        File::open(folder).and_then(|folder| folder.sync_all()).or(Ok(()))
    }

    /// The folder of what processes leave before the part is there. It is the part's own, as
    /// folders of many parts take long to look through.
    pub(super) fn under_way(&self) -> PathBuf {
        self.path.with_extension("under-way")
    }

    /// Removes that folder, of whatever process.
    pub(crate) fn tidy(&self) {
        // What stays is passed over, as the part is there.
        let _ = std::fs::remove_dir_all(self.under_way());
    }

    /// Whether the file is there.
    pub(crate) fn exists(&self) -> bool {
        self.path.exists()
    }

    /// Opens the file if all of it is what this plan has there; else why not.
    pub(crate) fn checked(&self) -> Result<SerializedFileReader<File>, Unusable> {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let damaged = |why: &str| {
            Unusable::Damaged(format!("{name} is damaged ({why}); delete it, and run its shard again"))
        };
        let foreign = |why: String| Err(Unusable::Foreign(format!("{name} {why}")));
        let mut file = File::open(&self.path).map_err(|error| damaged(&error.to_string()))?;
        // Before anything is believed that stands in it.
        match Checksum::of(&mut file) {
            Ok(sum) if sum.found.as_bytes() == sum.stated => {}
            Ok(_) => return Err(damaged("its checksum is another")),
            Err(error) => return Err(damaged(&error.to_string())),
        }
        let reader = SerializedFileReader::new(file).map_err(|error| damaged(&error.to_string()))?;
        let metadata = reader.metadata();
        let said = |key: &str| said(metadata.file_metadata().key_value_metadata(), key).unwrap_or("unknown");
        if said(keys::HASH) != self.hash {
            return foreign("belongs to another plan; use a folder for each plan".to_owned());
        }
        let version = env!("CARGO_PKG_VERSION");
        if said(keys::VERSION) != version {
            let other = said(keys::VERSION);
            return foreign(format!(
                "was written by kahan-sweep {other}, and this is {version}; use a folder for each version"
            ));
        }
        if said(keys::FLOATS) != floats() {
            return foreign(format!(
                "was computed with other floats ({}; here: {}), whose last digits differ; compute all parts on machines of one kind",
                said(keys::FLOATS),
                floats()
            ));
        }
        let rows = self.plan.part(self.index);
        let is_this = said(keys::PART) == self.index.to_string();
        if !is_this || metadata.file_metadata().num_rows() != (rows.end - rows.start) as i64 {
            return Err(damaged("it is another part under this name"));
        }
        Ok(reader)
    }
}

/// The value of a key.
pub(super) fn said<'a>(metadata: Option<&'a Vec<KeyValue>>, key: &str) -> Option<&'a str> {
    metadata?.iter().find(|one| one.key == key)?.value.as_deref()
}

/// A writer of a file of the plan, whose metadata says what every file says.
pub(super) fn writer<W: Write + Send>(
    plan: &Plan,
    hash: &str,
    to: W,
) -> Result<SerializedFileWriter<W>, ParquetError> {
    let meanings = plan.empty.columns.iter().map(|column| (&*column.name, &*column.meaning));
    // In the order of the alphabet.
    let meanings: BTreeMap<&str, &str> = meanings.collect();
    let seed = plan.seed().to_string();
    let said = [
        (keys::PLAN, plan.canonical().to_owned()),
        (keys::HASH, hash.to_owned()),
        (keys::VERSION, env!("CARGO_PKG_VERSION").to_owned()),
        (keys::FLOATS, floats().to_owned()),
        (keys::SEED, seed),
        (keys::COLUMNS, serde_json::json!(meanings).to_string()),
    ];
    let properties = WriterProperties::builder()
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true)
        .set_max_row_group_row_count(None)
        .set_created_by(format!("kahan-sweep {}", env!("CARGO_PKG_VERSION")))
        .set_key_value_metadata(Some(
            said.into_iter().map(|(key, value)| KeyValue::new(key.to_owned(), value)).collect(),
        ))
        .build();
    SerializedFileWriter::new(to, schema(&plan.empty)?.into(), Arc::new(properties))
}

fn schema(empty: &Table) -> Result<Type, ParquetError> {
    let fields = empty.columns.iter().zip(&empty.values).map(|(column, kept)| {
        let (physical, logical) = match kept {
            Kept::Integer(_) => (Physical::INT64, None),
            Kept::F64(_) => (Physical::DOUBLE, None),
            Kept::Text(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            other => unreachable!("no sweep has a column of {other:?}"),
        };
        let field =
            Type::primitive_type_builder(&column.name, physical).with_repetition(Repetition::REQUIRED);
        Ok(Arc::new(field.with_logical_type(logical).build()?))
    });
    Type::group_type_builder("sweep").with_fields(fields.collect::<Result<_, ParquetError>>()?).build()
}

/// Writes a column of a row group.
fn put<W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    column: &Kept,
) -> Result<(), ParquetError> {
    let Some(mut writer) = group.next_column()? else {
        return Err(ParquetError::General("more columns than the schema has".to_owned()));
    };
    match (writer.untyped(), column) {
        (ColumnWriter::Int64ColumnWriter(writer), Kept::Integer(entries)) => {
            writer.write_batch(entries, None, None)?
        }
        (ColumnWriter::DoubleColumnWriter(writer), Kept::F64(entries)) => {
            writer.write_batch(entries, None, None)?
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Kept::Text(entries)) => {
            let entries: Vec<ByteArray> = entries.iter().map(|text| ByteArray::from(text.as_str())).collect();
            writer.write_batch(&entries, None, None)?
        }
        _ => return Err(ParquetError::General("a column of another kind than the schema says".to_owned())),
    };
    writer.close()
}

/// What stands for the checksum while it is computed.
const NO_DIGITS: &str = "00000000";

/// The CRC-32 of all of a file, footer and all; its own digits, which stand in the footer, count as
/// zeros.
struct Checksum {
    found: String,
    stated: Vec<u8>,
    /// Where its digits stand.
    place: u64,
}

impl Checksum {
    fn of(file: &mut File) -> io::Result<Self> {
        let broken = |what: &str| io::Error::new(io::ErrorKind::InvalidData, what);
        let length = file.seek(SeekFrom::End(0))?;
        // A file of Parquet ends with its footer, the footer's length and four letters.
        let mut end = [0; 4];
        file.seek(SeekFrom::Start(length.saturating_sub(8)))?;
        file.read_exact(&mut end)?;
        let begin = length.checked_sub(8 + u64::from(u32::from_le_bytes(end)));
        let begin = begin.ok_or_else(|| broken("it is cut short"))?;

        file.seek(SeekFrom::Start(0))?;
        let mut hasher = crc32fast::Hasher::new();
        let (mut left, mut buffer) = (begin, vec![0; 1 << 16]);
        while left > 0 {
            let now = left.min(buffer.len() as u64) as usize;
            file.read_exact(&mut buffer[..now])?;
            hasher.update(&buffer[..now]);
            left -= now as u64;
        }
        let mut footer = Vec::new();
        file.read_to_end(&mut footer)?;
        let key = keys::CHECKSUM.as_bytes();
        let key_at = footer.windows(key.len()).rposition(|window| window == key);
        // Between a key and its value stand two bytes, of Thrift: which field this is, and its
        // length.
        let at = key_at.map(|at| at + key.len() + 2).filter(|at| at + NO_DIGITS.len() <= footer.len());
        let at = at.ok_or_else(|| broken("it has no checksum"))?;
        let digits = at..at + NO_DIGITS.len();
        let stated = footer[digits.clone()].to_vec();
        footer[digits].copy_from_slice(NO_DIGITS.as_bytes());
        hasher.update(&footer);
        Ok(Checksum { found: format!("{:08x}", hasher.finalize()), stated, place: begin + at as u64 })
    }
}

/// Makes the folder where it is missing, and sees that files can be written into it.
pub(crate) fn folder_is_writable(folder: &Path) -> io::Result<()> {
    // Nobody needs the empty file, and who was killed here could not remove it.
    files(folder, PROBE, "").into_iter().for_each(|path| drop(std::fs::remove_file(path)));
    fresh(folder, PROBE, "").map(drop)
}

const PROBE: &str = ".probe-";

/// The files in a folder whose names begin and end so.
pub(super) fn files(folder: &Path, begin: &str, end: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let named = entries.filter(|entry| {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        name.starts_with(begin) && name.ends_with(end)
    });
    named.map(|entry| entry.path()).collect()
}

/// A new file with a name that no other has, and with the rights that this user's files have; its
/// folder is made where it is missing.
pub(super) fn fresh(folder: &Path, prefix: &str, suffix: &str) -> io::Result<NamedTempFile> {
    std::fs::create_dir_all(folder)?;
    let open = |path: &Path| File::options().read(true).write(true).create_new(true).open(path);
    Builder::new().prefix(prefix).suffix(suffix).make_in(folder, open)
}

pub(super) fn other(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => io::Error::other(inner),
        error => io::Error::other(error),
    }
}
