//! Reads a field ẋ = c + Bx + Q(x, x) from the arrays c, B and Q of a file of `np.savez`.
//!
//! `kahan._coefficients` of the Python package reads the same files.

use std::collections::BTreeMap;
use std::io::Read;

use flate2::bufread::DeflateDecoder;
use kahan_runtime::{Coefficients, Diagnostics};
use kahan_study::number_file::{Numbers, words};
use rawzip::{CompressionMethod, ZipArchive};

use crate::printing::joined;

/// The files of an archive by name, without `.npy`.
type Files = BTreeMap<String, Vec<u8>>;

/// The states that a coefficient multiplies: `[None; 2]` in c, `[Some(j), None]` in B, two in Q.
type States = [Option<usize>; 2];

/// An array with its `entries` (row, column, value). A row belongs to a component of the field.
struct ArrayPart {
    name: &'static str,
    sizes: Vec<usize>,
    entries: Vec<(usize, usize, f64)>,
}

pub(super) fn coefficients(bytes: &[u8]) -> Result<Coefficients, String> {
    let mut files = files(bytes).map_err(|error| format!("is no file of np.savez: {error}"))?;
    let parts: Vec<ArrayPart> = ["c", "B", "Q"]
        .into_iter()
        .filter_map(|name| part(&mut files, name).transpose())
        .collect::<Result<_, _>>()?;
    let n = parts.first().and_then(|part| part.sizes.first().copied()).filter(|n| *n > 0);
    let n = n.ok_or_else(|| {
        files.retain(|name, _| name != "names" && name != "order");
        let lacks = "lacks arrays c, B and Q, or has an empty one";
        if files.is_empty() { lacks.to_owned() } else { other_files(&files) }
    })?;
    let [names, order] = ["names", "order"].map(|name| {
        let file = files.remove(name);
        file.map(|file| words(&file).map_err(|why| format!("has an array {name}, and {why}"))).transpose()
    });
    let names = names?.unwrap_or_else(|| (1..=n).map(|i| format!("x{i}")).collect());
    if names.len() != n {
        return Err(format!("has {} names and {n} variables", names.len()));
    }
    let is_lower = match order?.unwrap_or_default().first().map_or("tril", String::as_str) {
        "tril" => true,
        "triu" => false,
        other => {
            return Err(format!(
                "has the order `{other}`; columns of Q stand as tril (j <= i) or triu (j >= i)"
            ));
        }
    };
    if !files.is_empty() {
        return Err(other_files(&files));
    }
    let triangle: Vec<States> = match is_lower {
        true => (0..n).flat_map(|j| (0..=j).map(move |k| [Some(j), Some(k)])).collect(),
        false => (0..n).flat_map(|j| (j..n).map(move |k| [Some(j), Some(k)])).collect(),
    };
    let mut field = Coefficients::new(names, Vec::new()).map_err(|mistakes| wrong_names(&mistakes))?;
    for ArrayPart { name, sizes, entries } in parts {
        let states: &dyn Fn(usize) -> States = match (name, &sizes[..]) {
            ("c", [m]) if *m == n => &|_| [None, None],
            ("B", [m, k]) if [*m, *k] == [n, n] => &|column| [Some(column), None],
            ("Q", [m, j, k]) if [*m, *j, *k] == [n; 3] => &|column| [Some(column / n), Some(column % n)],
            ("Q", [m, k]) if [*m, *k] == [n, n * n] => &|column| [Some(column / n), Some(column % n)],
            ("Q", [m, k]) if [*m, *k] == [n, triangle.len()] => &|column| triangle[column],
            _ => {
                let fitting = match name {
                    "c" => format!("({n},)"),
                    "B" => format!("({n}, {n})"),
                    _ => format!("({n}, {n}, {n}), ({n}, {}) or ({n}, {})", n * n, triangle.len()),
                };
                let sizes: Vec<String> = sizes.iter().map(usize::to_string).collect();
                return Err(format!(
                    "has an array {name} of {}, and with {n} variables it is {fitting}",
                    sizes.join(" x ")
                ));
            }
        };
        for (row, column, value) in entries {
            field
                .add(row, states(column), None, value)
                .map_err(|error| format!("has an array {name}, and {error}"))?;
        }
    }
    Ok(field)
}

fn other_files(files: &Files) -> String {
    let what = if files.len() == 1 { "an array" } else { "arrays" };
    let names = joined(files.keys().map(|name| format!("`{name}`")), ", ");
    format!(
        "has {what} {names}, and a field has c, B, Q, names and order: np.savez(\"F.npz\", c=c, B=B, Q=Q)"
    )
}

fn wrong_names(mistakes: &Diagnostics) -> String {
    let said = mistakes.mistakes().iter().map(|mistake| mistake.message.as_str());
    format!("has names that variables cannot have: {}", joined(said, "; "))
}

/// Reads the array `name`, and removes its one file (dense) or three files (sparse) from `files`.
fn part(files: &mut Files, name: &'static str) -> Result<Option<ArrayPart>, String> {
    let mut numbers = |name: &str| {
        let read = |file: Vec<u8>| {
            Numbers::of(".npy", &file).map_err(|why| format!("has an array {name}, and {why}"))
        };
        files.remove(name).map(read).transpose()
    };
    if let Some(Numbers { sizes, values, .. }) = numbers(name)? {
        let width = values.len() / sizes.first().map_or(1, |rows| (*rows).max(1));
        let entries = values.into_iter().enumerate().map(|(at, value)| (at / width, at % width, value));
        return Ok(Some(ArrayPart { name, entries: entries.collect(), sizes }));
    }
    let [data, indices, ends] = ["data", "indices", "indptr"].map(|of| numbers(&format!("{name}_{of}")));
    let (data, indices, ends) = match (data?, indices?, ends?) {
        (None, None, None) => return Ok(None),
        (Some(data), Some(indices), Some(ends)) => (data.values, indices.values, ends.values),
        _ => {
            return Err(format!(
                "has a sparse {name} without one of {name}_data, {name}_indices and {name}_indptr"
            ));
        }
    };
    let n = ends.len().saturating_sub(1);
    let width = if name == "B" { n } else { n * n };
    let is_whole =
        ends.is_sorted() && ends.first() == Some(&0.0) && ends.last() == Some(&(data.len() as f64));
    if !is_whole
        || indices.len() != data.len()
        || !indices.iter().all(|index| index.fract() == 0.0 && (0.0..width as f64).contains(index))
    {
        return Err(format!("has a sparse {name} that is not in row format (csr)"));
    }
    let row = |at: usize| ends.partition_point(|end| *end <= at as f64) - 1;
    let entries = data.into_iter().zip(indices).enumerate();
    let entries = entries.map(|(at, (value, index))| (row(at), index as usize, value)).collect();
    Ok(Some(ArrayPart { name, sizes: vec![n, width], entries }))
}

fn files(bytes: &[u8]) -> Result<Files, Box<dyn std::error::Error>> {
    let archive = ZipArchive::from_slice(bytes)?;
    let (mut entries, mut files) = (archive.entries(), Files::new());
    while let Some(entry) = entries.next_entry()? {
        let packed = archive.get_entry(entry.wayfinder())?;
        let mut file = Vec::new();
        match entry.compression_method() {
            CompressionMethod::STORE => packed.verifying_reader(packed.data()).read_to_end(&mut file)?,
            CompressionMethod::DEFLATE => {
                packed.verifying_reader(DeflateDecoder::new(packed.data())).read_to_end(&mut file)?
            }
            _ => return Err("it is compressed neither by `store` nor by `deflate`".into()),
        };
        let name = String::from_utf8_lossy(entry.file_path().as_ref()).trim_end_matches(".npy").to_owned();
        files.insert(name, file);
    }
    Ok(files)
}
