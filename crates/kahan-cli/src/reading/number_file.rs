//! Files of numbers: CSV, and NumPy's arrays (`.npy`, numpy.lib.format).

use std::fs;
use std::io::{self, BufRead};
use std::path::Path;

use crate::printing::Refusal;

/// The numbers of a file, and the names of its columns where it has them.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Numbers {
    pub(super) names: Option<Vec<String>>,
    /// How many there are in each direction, rows first.
    pub(super) sizes: Vec<usize>,
    /// Row by row.
    pub(super) values: Vec<f64>,
}

/// Whether a text names such a file.
pub(super) fn is_file(text: &str) -> bool {
    let ending = Path::new(text).extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| ending == "npy" || ending == "csv")
}

/// Reads a file; `option` names it in the refusal.
pub(super) fn read(path: &str, option: &str) -> Result<Numbers, Refusal> {
    let refused = |why: String| Refusal::new(format!("{option}: cannot read the file {path}: {why}"));
    let bytes = fs::read(path).map_err(|error| refused(error.to_string()))?;
    let numbers = if path.ends_with(".npy") { array(&bytes) } else { table(&bytes[..]) };
    numbers.map_err(refused)
}

/// Rows of numbers with commas, behind a row of names or not; what is left out is not a number.
pub(super) fn table(text: impl BufRead) -> Result<Numbers, String> {
    let (mut numbers, mut index) = (Numbers::default(), 0);
    for (line, row) in text.lines().enumerate() {
        let row = row.map_err(|error| match error.kind() {
            io::ErrorKind::InvalidData => "it is no text".to_owned(),
            _ => error.to_string(),
        })?;
        if row.trim().is_empty() {
            continue;
        }
        index += 1;
        let cells: Vec<&str> = row.split(',').map(str::trim).collect();
        let value = |cell: &&'_ str| if cell.is_empty() { Ok(f64::NAN) } else { cell.parse() };
        let values: Result<Vec<f64>, &str> =
            cells.iter().map(|cell| value(cell).map_err(|_| *cell)).collect();
        match values {
            Ok(values) => {
                let [rows, columns] = numbers.sizes[..] else {
                    if let Some(names) = numbers.names.as_ref().filter(|names| names.len() != values.len()) {
                        let (line, found, names) = (line + 1, values.len(), names.len());
                        return Err(format!(
                            "line {line} has {found} numbers, and above it are {names} names"
                        ));
                    }
                    numbers.sizes = vec![1, values.len()];
                    numbers.values = values;
                    continue;
                };
                if values.len() != columns {
                    let found = values.len();
                    return Err(format!(
                        "line {} has {found} numbers, and those before it {columns}",
                        line + 1
                    ));
                }
                numbers.sizes[0] = rows + 1;
                numbers.values.extend(values);
            }
            Err(_) if index == 1 => numbers.names = Some(cells.into_iter().map(str::to_owned).collect()),
            Err(cell) => return Err(format!("`{cell}` in line {} is no number", line + 1)),
        }
    }
    Ok(numbers)
}

/// An array of NumPy's, in the order in which rows lie one behind the other.
fn array(bytes: &[u8]) -> Result<Numbers, String> {
    let broken = || "it is no array of NumPy's, or not a whole one".to_owned();
    let (header, data) = header(bytes).ok_or_else(broken)?;
    let value = |key: &str| {
        let rest = header.split_once(&format!("'{key}':"))?.1.trim_start();
        Some(rest.split_once([',', '}']).map_or(rest, |(value, _)| value).trim())
    };
    let shape = header.split_once('(').and_then(|(_, rest)| rest.split_once(')')).ok_or_else(broken)?.0;
    let sizes = shape.split(',').map(str::trim).filter(|size| !size.is_empty());
    let sizes: Vec<usize> = sizes.map(str::parse).collect::<Result<_, _>>().map_err(|_| broken())?;
    if value("fortran_order") != Some("False") && sizes.iter().filter(|size| **size > 1).count() > 1 {
        return Err("its columns lie one behind the other; save it with np.ascontiguousarray".to_owned());
    }
    let values: Vec<f64> = match value("descr") {
        Some("'<f8'") => data.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect(),
        Some("'<f4'") => data.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes).into()).collect(),
        _ => return Err("its numbers are no floats; save it with .astype(float)".to_owned()),
    };
    let count = sizes.iter().try_fold(1, |product: usize, size| product.checked_mul(*size));
    if count == Some(values.len()) { Ok(Numbers { names: None, sizes, values }) } else { Err(broken()) }
}

/// The header of an array, as text, and what follows.
fn header(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let (version, rest) = bytes.strip_prefix(b"\x93NUMPY")?.split_first_chunk::<2>()?;
    let (length, rest) = match version {
        [1, _] => {
            rest.split_first_chunk().map(|(length, rest)| (u16::from_le_bytes(*length).into(), rest))?
        }
        _ => rest.split_first_chunk().map(|(length, rest)| (u32::from_le_bytes(*length), rest))?,
    };
    let (header, data) = rest.split_at_checked(usize::try_from(length).ok()?)?;
    Some((str::from_utf8(header).ok()?, data))
}

#[cfg(test)]
mod tests {
    use super::{Numbers, array, table};

    #[test]
    fn tables_have_names_or_not() {
        let numbers = |names: Option<&[&str]>, values: &[f64]| {
            let names = names.map(|names| names.iter().map(|name| (*name).to_owned()).collect());
            let columns = names.as_ref().map_or(1, Vec::len);
            let sizes = if values.is_empty() { Vec::new() } else { vec![values.len() / columns, columns] };
            Ok(Numbers { names, sizes, values: values.to_vec() })
        };
        let table = |text: &str| table(text.as_bytes());
        assert_eq!(table("a, b\n1, 2\n\n-3,4e-1\n"), numbers(Some(&["a", "b"]), &[1.0, 2.0, -3.0, 0.4]));
        assert_eq!(table("1\n2"), numbers(None, &[1.0, 2.0]));
        assert_eq!(table(""), numbers(None, &[]));
        assert_eq!(table("1,2\n3,x"), Err("`x` in line 2 is no number".to_owned()));
        assert_eq!(
            table("a,b\n1,2\n3,4,5\n6\n"),
            Err("line 3 has 3 numbers, and those before it 2".to_owned())
        );
        assert_eq!(table("a,b\n1,2,3\n"), Err("line 2 has 3 numbers, and above it are 2 names".to_owned()));
        let left_out = table("a,b\n1,\n").expect("a table").values;
        assert!(left_out[0] == 1.0 && left_out[1].is_nan());
    }

    /// What NumPy writes, by the documentation of numpy.lib.format.
    #[test]
    fn arrays_are_read_as_numpy_writes_them() {
        let file = |version: u8, descr: &str, fortran: &str, shape: &str, data: &[u8]| {
            let header =
                format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}          \n");
            let length = u16::try_from(header.len()).expect("short").to_le_bytes();
            let wide: &[u8] = if version == 1 { &[] } else { &[0, 0] };
            [b"\x93NUMPY", &[version, 0][..], &length, wide, header.as_bytes(), data].concat()
        };
        let doubles: Vec<u8> = [1.0_f64, -2.5, 3.0, 4.0].iter().flat_map(|x| x.to_le_bytes()).collect();
        let singles: Vec<u8> = [0.5_f32, 8.0].iter().flat_map(|x| x.to_le_bytes()).collect();
        let numbers = |sizes: &[usize], values: &[f64]| {
            Ok(Numbers { names: None, sizes: sizes.to_vec(), values: values.to_vec() })
        };
        let four = [1.0, -2.5, 3.0, 4.0];
        assert_eq!(array(&file(1, "<f8", "False", "(4,)", &doubles)), numbers(&[4], &four));
        assert_eq!(array(&file(2, "<f8", "False", "(2, 2)", &doubles)), numbers(&[2, 2], &four));
        assert_eq!(array(&file(3, "<f8", "True", "(1, 4)", &doubles)), numbers(&[1, 4], &four));
        assert_eq!(array(&file(1, "<f4", "False", "(2,)", &singles)), numbers(&[2], &[0.5, 8.0]));
        for wrong in [
            file(1, "<f8", "True", "(2, 2)", &doubles),
            file(1, "<i8", "False", "(4,)", &doubles),
            file(1, "<f8", "False", "(5,)", &doubles),
            file(1, "<f8", "False", "(4,)", &doubles[..31]),
            file(1, "<f8", "False", "(18446744073709551615, 2)", &doubles),
            b"\x93NUMPY\x01\x00\xff\xff{".to_vec(),
            b"x,y".to_vec(),
        ] {
            assert!(array(&wrong).is_err(), "{}", String::from_utf8_lossy(&wrong));
        }
    }
}
