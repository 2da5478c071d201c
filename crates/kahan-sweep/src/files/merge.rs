//! Merges all parts into one file by copying their row groups unchanged.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

use parquet::column::writer::ColumnCloseResult;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;

use super::part::{Part, files, fresh, into_io_error, writer};
use crate::plan::Plan;

const TEMPORARY_PREFIX: &str = ".results-";

pub(crate) const RESULTS_FILE: &str = "results.parquet";

/// Merges all parts of a folder into one file there, and returns the size of the file. If parts are
/// missing, damaged or from another plan, fails with a reason for each.
pub(crate) fn merge(plan: &Plan, folder: &Path, mut each: impl FnMut()) -> Result<u64, Vec<String>> {
    let parts = || (0..plan.parts()).map(|index| Part::of(plan, index, folder));
    let missing: Vec<u64> = parts().filter(|part| !part.exists()).map(|part| part.index).collect();
    if let Some(first) = missing.first() {
        return Err(vec![format!(
            "{} of {} parts are missing, the first is part {first}; run their shards first (--status lists them)",
            missing.len(),
            plan.parts()
        )]);
    }
    let mut file = fresh(folder, TEMPORARY_PREFIX, "").map_err(failed)?;
    let mut to = writer(plan, &mut file).map_err(failed)?;
    let mut reasons = Vec::new();
    for part in parts() {
        match part.open_checked() {
            // Once a part is unusable, no more is written. The other parts are only checked.
            Ok(_) if !reasons.is_empty() => {}
            Ok(reader) => copy(&part, &reader, &mut to).map_err(failed)?,
            Err(why) => reasons.push(why.to_string()),
        }
        each();
    }
    if !reasons.is_empty() {
        return Err(reasons);
    }
    to.close().map_err(failed)?;
    let bytes = file.as_file().metadata().map_err(failed)?.len();
    file.as_file().sync_all().map_err(failed)?;
    let results = folder.join(RESULTS_FILE);
    match file.persist(&results) {
        Ok(_) => {}
        // Another process has merged the same parts, and removed the temporary files.
        Err(error) if error.error.kind() == io::ErrorKind::NotFound && results.exists() => {}
        Err(error) => return Err(failed(error.error)),
    }
    // Removes all temporary files. Other processes that still merge the parts then accept the
    // results of this process.
    files(folder, TEMPORARY_PREFIX, "").into_iter().for_each(|path| drop(std::fs::remove_file(path)));
    Ok(bytes)
}

fn failed(error: impl Into<ParquetError>) -> Vec<String> {
    vec![format!("{RESULTS_FILE} cannot be written: {}", into_io_error(error.into()))]
}

fn copy(
    part: &Part<'_>,
    reader: &SerializedFileReader<File>,
    to: &mut SerializedFileWriter<impl Write + Send>,
) -> Result<(), ParquetError> {
    let source = File::open(&part.path)?;
    for group in reader.metadata().row_groups() {
        let mut target = to.next_row_group()?;
        for column in group.columns() {
            let result = ColumnCloseResult {
                bytes_written: column.compressed_size() as u64,
                rows_written: group.num_rows() as u64,
                metadata: column.clone(),
                bloom_filter: None,
                column_index: None,
                offset_index: None,
            };
            target.append_column(&source, result)?;
        }
        target.close()?;
    }
    Ok(())
}
