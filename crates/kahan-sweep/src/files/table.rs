//! Reads Parquet files: results as CSV text, and columns as exact numbers.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use kahan_algebra::rational::Rational;
use kahan_study::csv_line;
use kahan_study::number_file::{FileNumber, Numbers};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use parquet::schema::types::Type;

/// The reason why a table could not be written.
#[derive(Debug)]
pub(crate) enum TableError {
    /// The file is invalid, or lacks a column.
    Unreadable(String),
    /// Writing the output failed.
    Unwritten(io::Error),
}

/// Writes the named columns as CSV; without names, all columns. Numbers have enough digits to be
/// read back exactly, undefined values are NaN, and text is in quotes.
pub(crate) fn table(path: &Path, columns: &[String], to: &mut impl Write) -> Result<(), TableError> {
    let unreadable = |why: String| TableError::Unreadable(format!("{} {why}", path.display()));
    let (names, rows) = rows(path, columns).map_err(unreadable)?;
    let mut line = String::new();
    csv_line(&mut line, &names);
    for row in rows {
        to.write_all(line.as_bytes()).map_err(TableError::Unwritten)?;
        line.clear();
        csv_line(&mut line, row.map_err(unreadable)?.iter().map(shown));
    }
    to.write_all(line.as_bytes()).map_err(TableError::Unwritten)
}

/// Reads columns as exact numbers. An error is a sentence about the file.
pub(crate) fn numbers(path: &Path, columns: &[String]) -> Result<Numbers<Option<Rational>>, String> {
    let (names, rows) = rows(path, columns)?;
    let mut values = Vec::new();
    for row in rows {
        values.extend(row?.iter().map(exactly));
    }
    let sizes = vec![values.len() / names.len(), names.len()];
    Ok(Numbers { names: Some(names), sizes, values })
}

type Row = Result<Vec<Field>, String>;

/// Returns the names of the columns, and an iterator over rows. An empty list selects all columns.
fn rows(path: &Path, columns: &[String]) -> Result<(Vec<String>, impl Iterator<Item = Row>), String> {
    let broken = |error: ParquetError| format!("cannot be read: {error}");
    let file = File::open(path).map_err(|error| format!("cannot be read: {error}"))?;
    let reader = SerializedFileReader::new(file).map_err(broken)?;
    let schema = reader.metadata().file_metadata().schema_descr().root_schema_ptr();
    let known: Vec<String> = schema.get_fields().iter().map(|field| field.name().to_owned()).collect();
    let names = if columns.is_empty() { &known } else { columns };
    if let Some(name) = names.iter().find(|name| !known.contains(name)) {
        return Err(format!("has no column `{name}`; it has {}", known.join(", ")));
    }
    // A row lists the selected columns in the file's order, so the order of `names` is restored.
    let read: Vec<_> =
        schema.get_fields().iter().filter(|field| names.iter().any(|name| name == field.name())).collect();
    let place = |name: &String| read.iter().position(|field| field.name() == name).unwrap_or_default();
    let order: Vec<usize> = names.iter().map(place).collect();
    let fields = read.iter().map(|field| Arc::clone(field)).collect();
    let projection = Type::group_type_builder(schema.name()).with_fields(fields).build().map_err(broken)?;
    let rows = reader.into_iter().project(Some(projection)).map_err(broken)?;
    let rows = rows.map(move |row| {
        let entries = row.map_err(broken)?.into_columns();
        Ok(order.iter().map(|place| entries[*place].1.clone()).collect())
    });
    Ok((names.to_vec(), rows))
}

fn exactly(entry: &Field) -> Option<Rational> {
    match entry {
        Field::Double(value) => FileNumber::of_float(*value),
        Field::Float(value) => FileNumber::of_float(f64::from(*value)),
        Field::Str(text) => FileNumber::of_text(text).flatten(),
        whole => Rational::parse(&whole.to_string()),
    }
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
