//! A result as text: commas between the entries, names above them.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use parquet::schema::types::Type;

/// Why there is no table.
#[derive(Debug)]
pub(crate) enum NoTable {
    /// The file is no result, or has no such column.
    Unreadable(String),
    /// It could not be written.
    Unwritten(io::Error),
}

/// Writes columns of a file of Parquet in this order, all of them where none is named: numbers as
/// short as they can be read back, what is not a number as NaN, texts in quotes.
pub(crate) fn table(path: &Path, columns: &[String], to: &mut impl Write) -> Result<(), NoTable> {
    let unreadable = |why: String| NoTable::Unreadable(format!("{} {why}", path.display()));
    let broken = |error: ParquetError| unreadable(format!("cannot be read: {error}"));
    let file = File::open(path).map_err(|error| unreadable(format!("cannot be read: {error}")))?;
    let reader = SerializedFileReader::new(file).map_err(broken)?;
    let schema = reader.metadata().file_metadata().schema_descr().root_schema_ptr();
    let known: Vec<String> = schema.get_fields().iter().map(|field| field.name().to_owned()).collect();
    let names = if columns.is_empty() { &known } else { columns };
    if let Some(name) = names.iter().find(|name| !known.contains(name)) {
        return Err(unreadable(format!("has no column `{name}`; it has {}", known.join(", "))));
    }
    // Rows hold what is asked for, in the order of the file.
    let read: Vec<_> =
        schema.get_fields().iter().filter(|field| names.iter().any(|name| name == field.name())).collect();
    let place = |name: &String| read.iter().position(|field| field.name() == name).unwrap_or_default();
    let order: Vec<usize> = names.iter().map(place).collect();
    let fields = read.iter().map(|field| Arc::clone(field)).collect();
    let projection = Type::group_type_builder(schema.name()).with_fields(fields).build().map_err(broken)?;

    let mut write = |line: &str| writeln!(to, "{line}").map_err(NoTable::Unwritten);
    write(&names.join(","))?;
    for row in reader.get_row_iter(Some(projection)).map_err(broken)? {
        let row = row.map_err(broken)?;
        let entries: Vec<String> = row.get_column_iter().map(|(_, entry)| shown(entry)).collect();
        let entries: Vec<&str> = order.iter().map(|place| entries[*place].as_str()).collect();
        write(&entries.join(","))?;
    }
    Ok(())
}

fn shown(entry: &Field) -> String {
    match entry {
        Field::Double(value) => format!("{value:?}"),
        Field::Float(value) => format!("{value:?}"),
        Field::Null => "NaN".to_owned(),
        Field::Str(text) => format!("\"{}\"", text.replace('"', "\"\"")),
        other => other.to_string(),
    }
}
