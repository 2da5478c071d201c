//! Writes a part atomically, and checks a part before it is used.

use std::collections::BTreeMap;
use std::fmt::{self, Display};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use kahan_study::{StoredColumn, Table};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use tempfile::{Builder, NamedTempFile};

use crate::plan::Plan;

mod keys {
    pub(super) const PLAN: &str = "kahan.plan";
    pub(super) const HASH: &str = "kahan.plan.sha256";
    pub(super) const VERSION: &str = "kahan.version";
    pub(super) const FLOATS: &str = "kahan.floats";
    pub(super) const COLUMNS: &str = "kahan.columns";
    pub(super) const SEED: &str = "kahan.seed";
    /// The metadata key of a part's index. A merged file has no index and no checksum.
    pub(super) const PART: &str = "kahan.part";
    pub(super) const CHECKSUM: &str = "kahan.crc32";
}

/// The version of this program; results of different versions are never mixed.
pub(super) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The floating-point mode of this program, which may change the last digits of results.
pub(super) const FLOATS: &str = match (cfg!(target_arch = "x86_64"), cfg!(target_feature = "fma")) {
    (true, false) => "x86-64, products rounded",
    (true, true) => "x86-64, products fused",
    (false, _) => "on another processor",
};

/// The reason why an existing part cannot be used.
#[derive(Clone, Debug)]
pub(crate) enum UnusablePart {
    /// The file is incomplete or altered, or it holds another part.
    Damaged(String),
    /// The file was written for another plan, version or floating-point mode.
    Foreign(String),
}

impl Display for UnusablePart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            UnusablePart::Damaged(reason) => write!(f, "{reason}; delete it, and run its shard again"),
            UnusablePart::Foreign(reason) => f.write_str(reason),
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Part<'a> {
    pub(super) plan: &'a Plan,
    pub(crate) index: u64,
    pub(crate) path: PathBuf,
}

impl<'a> Part<'a> {
    /// Returns the part with this index in a folder. The file of the part need not exist yet.
    pub(crate) fn of(plan: &'a Plan, index: u64, folder: &Path) -> Self {
        Part { plan, index, path: folder.join(format!("part-{index:012}.parquet")) }
    }

    pub(crate) fn write(&self, rows: &Table) -> io::Result<()> {
        match self.written(rows).map_err(into_io_error) {
            // Another process has written the part, and removed the temporary file of this process.
            Err(error) if error.kind() == io::ErrorKind::NotFound && self.exists() => Ok(()),
            result => result,
        }
    }

    fn written(&self, rows: &Table) -> Result<(), ParquetError> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        let mut file = fresh(&self.unfinished_folder(), "rows-", ".parquet")?;
        let mut writer = writer(self.plan, &mut file)?;
        let mut group = writer.next_row_group()?;
        for column in &rows.values {
            put(&mut group, column)?;
        }
        group.close()?;
        writer.append_key_value_metadata(key_value(keys::PART, self.index.to_string()));
        writer.append_key_value_metadata(key_value(keys::CHECKSUM, NO_DIGITS));
        writer.close()?;
        let sum = Checksum::of(file.as_file_mut())?;
        file.seek(SeekFrom::Start(sum.place))?;
        file.write_all(sum.found.as_bytes())?;
        file.as_file().sync_all()?;
        file.persist(&self.path).map_err(io::Error::from)?.sync_all()?;
        // Syncs the name of the file to the disk, if the folder can be opened.
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
        Ok(())
    }

    /// Returns the folder for the unfinished files of this part.
    pub(super) fn unfinished_folder(&self) -> PathBuf {
        self.path.with_extension("under-way")
    }

    pub(crate) fn remove_unfinished(&self) {
        // Errors are ignored, since remaining files do no harm.
        let _ = std::fs::remove_dir_all(self.unfinished_folder());
    }

    pub(crate) fn exists(&self) -> bool {
        self.path.exists()
    }

    /// Opens the file after checking its checksum, plan, version and index.
    pub(crate) fn open_checked(&self) -> Result<SerializedFileReader<File>, UnusablePart> {
        let name = self.path.file_name().unwrap_or_default().display();
        let damaged = |why: &dyn Display| UnusablePart::Damaged(format!("{name} is damaged ({why})"));
        // The checksum is verified before any metadata are trusted.
        let summed = File::open(&self.path).and_then(|mut file| Ok((Checksum::of(&mut file)?, file)));
        let (sum, file) = summed.map_err(|error| damaged(&error))?;
        if sum.found.as_bytes() != sum.stated {
            return Err(damaged(&"its checksum is another"));
        }
        let reader = SerializedFileReader::new(file).map_err(|error| damaged(&error))?;
        let metadata = reader.metadata().file_metadata();
        let all = metadata.key_value_metadata();
        let said = |key: &str| {
            let found = all.into_iter().flatten().find(|one| one.key == key);
            found.and_then(|one| one.value.as_deref()).unwrap_or("unknown")
        };
        let (version, floats) = (said(keys::VERSION), said(keys::FLOATS));
        let why = if said(keys::HASH) != self.plan.hash() {
            "belongs to another plan; use a folder for each plan".to_owned()
        } else if version != VERSION {
            format!(
                "was written by kahan-sweep {version}, and this is {VERSION}; use a folder for each version"
            )
        } else if floats != FLOATS {
            format!(
                "was computed with other floats ({floats}; here: {FLOATS}), whose last digits differ; compute all parts on machines of one kind"
            )
        } else {
            let rows = self.plan.part(self.index);
            let is_this = said(keys::PART) == self.index.to_string();
            if is_this && metadata.num_rows() == (rows.end - rows.start) as i64 {
                return Ok(reader);
            }
            return Err(damaged(&"it is another part under this name"));
        };
        Err(UnusablePart::Foreign(format!("{name} {why}")))
    }
}

fn key_value(key: &str, value: impl Into<String>) -> KeyValue {
    KeyValue::new(key.to_owned(), value.into())
}

/// Makes a writer that sets the metadata common to all files of a plan.
pub(super) fn writer<W: Write + Send>(plan: &Plan, to: W) -> Result<SerializedFileWriter<W>, ParquetError> {
    let meanings = plan.empty.columns.iter().map(|column| (&*column.name, &*column.meaning));
    let meanings: BTreeMap<&str, &str> = meanings.collect();
    let said = vec![
        key_value(keys::PLAN, plan.canonical()),
        key_value(keys::HASH, plan.hash()),
        key_value(keys::VERSION, VERSION),
        key_value(keys::FLOATS, FLOATS),
        key_value(keys::SEED, plan.seed().to_string()),
        key_value(keys::COLUMNS, serde_json::json!(meanings).to_string()),
    ];
    let properties = WriterProperties::builder()
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true)
        .set_max_row_group_row_count(None)
        .set_created_by(format!("kahan-sweep {VERSION}"))
        .set_key_value_metadata(Some(said))
        .build();
    SerializedFileWriter::new(to, schema(&plan.empty)?.into(), Arc::new(properties))
}

fn schema(empty: &Table) -> Result<Type, ParquetError> {
    let fields = empty.columns.iter().zip(&empty.values).map(|(column, kept)| {
        let (physical, logical) = match kept {
            StoredColumn::Integer(_) => (Physical::INT64, None),
            StoredColumn::F64(_) => (Physical::DOUBLE, None),
            StoredColumn::Text(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            other => unreachable!("no sweep has a column of {other:?}"),
        };
        let field =
            Type::primitive_type_builder(&column.name, physical).with_repetition(Repetition::REQUIRED);
        Ok(Arc::new(field.with_logical_type(logical).build()?))
    });
    Type::group_type_builder("sweep").with_fields(fields.collect::<Result<_, ParquetError>>()?).build()
}

fn put<W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    column: &StoredColumn,
) -> Result<(), ParquetError> {
    let mut writer = group.next_column()?.expect("the schema has a column for each of the table");
    match column {
        StoredColumn::Integer(entries) => writer.typed::<Int64Type>().write_batch(entries, None, None)?,
        StoredColumn::F64(entries) => writer.typed::<DoubleType>().write_batch(entries, None, None)?,
        StoredColumn::Text(entries) => {
            let entries: Vec<ByteArray> = entries.iter().map(|text| ByteArray::from(text.as_str())).collect();
            writer.typed::<ByteArrayType>().write_batch(&entries, None, None)?
        }
        other => unreachable!("no sweep has a column of {other:?}"),
    };
    writer.close()
}

/// The digits with which a file's checksum is computed. The checksum then replaces them.
const NO_DIGITS: &str = "00000000";

/// The CRC-32 of a whole file, computed with zeros in place of the checksum's digits.
struct Checksum {
    found: String,
    stated: Vec<u8>,
    /// The offset of the checksum's digits in the file.
    place: u64,
}

impl Checksum {
    fn of(file: &mut File) -> io::Result<Self> {
        let broken = |what: &str| io::Error::new(io::ErrorKind::InvalidData, what);
        let length = file.seek(SeekFrom::End(0))?;
        // A Parquet file ends with its footer, the length of the footer, and four letters.
        let mut end = [0; 4];
        file.seek(SeekFrom::Start(length.saturating_sub(8)))?;
        file.read_exact(&mut end)?;
        let begin = length.checked_sub(8 + u64::from(u32::from_le_bytes(end)));
        let begin = begin.ok_or_else(|| broken("it is cut short"))?;

        file.seek(SeekFrom::Start(0))?;
        let mut hasher = crc32fast::Hasher::new();
        let mut body = BufReader::with_capacity(1 << 16, Read::take(&mut *file, begin));
        loop {
            let bytes = body.fill_buf()?;
            hasher.update(bytes);
            match bytes.len() {
                0 => break,
                read => body.consume(read),
            }
        }
        let mut footer = Vec::new();
        file.read_to_end(&mut footer)?;
        let key = keys::CHECKSUM.as_bytes();
        let key_at = footer.windows(key.len()).rposition(|window| window == key);
        // Between a key and its value, Thrift puts two bytes.
        let at = key_at.map(|at| at + key.len() + 2).filter(|at| at + NO_DIGITS.len() <= footer.len());
        let at = at.ok_or_else(|| broken("it has no checksum"))?;
        let digits = at..at + NO_DIGITS.len();
        let stated = footer[digits.clone()].to_vec();
        footer[digits].copy_from_slice(NO_DIGITS.as_bytes());
        hasher.update(&footer);
        Ok(Checksum { found: format!("{:08x}", hasher.finalize()), stated, place: begin + at as u64 })
    }
}

/// Creates the folder if it is missing, and checks that files can be written into it.
pub(crate) fn folder_is_writable(folder: &Path) -> io::Result<()> {
    // Removes test files that killed processes left in this folder.
    files(folder, PROBE_PREFIX, "").into_iter().for_each(|path| drop(std::fs::remove_file(path)));
    fresh(folder, PROBE_PREFIX, "").map(drop)
}

const PROBE_PREFIX: &str = ".probe-";

/// Lists the files of a folder whose names have this prefix and suffix.
pub(super) fn files(folder: &Path, begin: &str, end: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let named = entries.filter(|entry| {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        name.starts_with(begin) && name.ends_with(end)
    });
    named.map(|entry| entry.path()).collect()
}

/// Creates a file with a unique name and the user's default permissions.
pub(super) fn fresh(folder: &Path, prefix: &str, suffix: &str) -> io::Result<NamedTempFile> {
    std::fs::create_dir_all(folder)?;
    let open = |path: &Path| File::options().read(true).write(true).create_new(true).open(path);
    Builder::new().prefix(prefix).suffix(suffix).make_in(folder, open)
}

/// Returns the I/O error that a Parquet error contains; wraps any other error.
pub(super) fn into_io_error(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => inner.downcast().map_or_else(io::Error::other, |inner| *inner),
        error => io::Error::other(error),
    }
}
