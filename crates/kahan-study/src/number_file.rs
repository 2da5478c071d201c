//! Files of numbers: CSV and NumPy arrays (`.npy`).
//!
//! Arrays are parsed here, because `npyz` 0.9.1 panics on crafted files, and `ndarray-npy` requires
//! all sizes beforehand.

use csv::{ReaderBuilder, StringRecord, Trim};
use kahan_algebra::rational::Rational;

use crate::columns::ExpectedColumns;

/// A number type read from files.
pub trait FileNumber: Sized {
    /// Reads a cell of text, which may be empty; `None` if the cell is not a number.
    fn of_text(cell: &str) -> Option<Self>;

    /// Converts an entry of a NumPy array of floats.
    fn of_float(float: f64) -> Self;
}

/// An empty cell is read as NaN.
impl FileNumber for f64 {
    fn of_text(cell: &str) -> Option<Self> {
        if cell.is_empty() { Some(f64::NAN) } else { cell.parse().ok() }
    }

    fn of_float(float: f64) -> Self {
        float
    }
}

/// An exact number; `None` for an empty cell or a float that is not finite.
impl FileNumber for Option<Rational> {
    fn of_text(cell: &str) -> Option<Self> {
        if cell.is_empty() { Some(None) } else { Rational::parse(cell).map(Some) }
    }

    fn of_float(float: f64) -> Self {
        Rational::from_f64(float)
    }
}

/// The numbers of a file, with the names of its columns if it has them.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers<V = f64> {
    /// The names of the columns.
    pub names: Option<Vec<String>>,
    /// The size of each dimension, rows first.
    pub sizes: Vec<usize>,
    /// The values in row-major order.
    pub values: Vec<V>,
}

impl<V: FileNumber> Numbers<V> {
    /// Reads a NumPy array if `name` ends in `.npy`, otherwise CSV with or without a header. The
    /// cells of a CSV column `ended` count as empty, because tables of orbits hold words there.
    ///
    /// # Errors
    /// A sentence that describes the mistake.
    pub fn of(name: &str, bytes: &[u8]) -> Result<Self, String> {
        if name.ends_with(".npy") { array(bytes) } else { table(bytes) }
    }
}

impl Numbers<Option<Rational>> {
    /// Reads a point from each row. If the columns have names, they are matched with the state
    /// variables. Otherwise they are the state variables in order.
    ///
    /// The error text continues a sentence that begins with the file's name.
    pub fn points(&self, wanted: &ExpectedColumns<'_>) -> Result<Vec<Vec<Rational>>, String> {
        let Numbers { names, sizes, values } = self;
        let states = wanted.states;
        let width = sizes.get(1).copied().unwrap_or_default();
        let columns: Vec<usize> = match names {
            Some(names) => {
                let hidden =
                    usize::from(names.first().is_some_and(String::is_empty) && self.is_numbered(width));
                let places = wanted.places(&names[hidden..]).map_err(|error| error.to_string())?;
                places.states.into_iter().map(|place| place + hidden).collect()
            }
            None => (0..states.len()).collect(),
        };
        match sizes[..] {
            [] | [0, _] => return Err("has no rows; a row is a first point".to_owned()),
            [_, width] if names.is_some() || width == states.len() => {}
            _ => {
                let sizes: Vec<String> = sizes.iter().map(usize::to_string).collect();
                return Err(format!(
                    "has {} numbers, and first points are rows of {}: {}",
                    sizes.join(" x "),
                    states.len(),
                    states.join(",")
                ));
            }
        }
        let point = |(row, values): (usize, &[Option<Rational>])| {
            let coordinate = |(column, state): (&usize, &String)| {
                values[*column].clone().ok_or_else(|| {
                    format!("has no number for {state} in row {}, and a first point needs each", row + 1)
                })
            };
            columns.iter().zip(states).map(coordinate).collect()
        };
        values.chunks_exact(width).enumerate().map(point).collect()
    }

    fn is_numbered(&self, width: usize) -> bool {
        let mut first = self.values.iter().step_by(width.max(1)).zip(0_i64..);
        first.all(|(value, row)| *value == Some(Rational::from(row)))
    }
}

/// Reads CSV with comments after `#`. A comment with a word for each column holds the names.
fn table<V: FileNumber>(text: &[u8]) -> Result<Numbers<V>, String> {
    let mut cells = ReaderBuilder::new().has_headers(false).flexible(true).trim(Trim::All).from_reader(text);
    let (mut row, mut comments, mut is_first) = (StringRecord::new(), Vec::new(), true);
    let mut numbers = Numbers { names: None, sizes: Vec::new(), values: Vec::new() };
    // Reading from memory cannot fail, so an error means that the bytes are not UTF-8.
    while cells.read_record(&mut row).map_err(|_| "it is no text".to_owned())? {
        if row.len() == 1 && row[0].is_empty() {
            continue;
        }
        if row[0].starts_with('#') {
            comments.push(row.iter().collect::<Vec<_>>().join(","));
            continue;
        }
        let line = || line(text, &row);
        if is_first {
            numbers.names = comments.iter().rev().find_map(|comment| names_in(comment, row.len()));
        }
        let words = numbers.names.iter().flatten().position(|name| name == "ended");
        let number = |(place, cell): (usize, _)| {
            V::of_text(if words == Some(place) { "" } else { cell }).ok_or((place, cell))
        };
        let values: Result<Vec<V>, (usize, &str)> = row.iter().enumerate().map(number).collect();
        match values {
            Ok(values) => {
                let (found, names) = (values.len(), numbers.names.as_ref().map(Vec::len));
                match (&mut numbers.sizes[..], names) {
                    ([_, columns], _) if *columns != found => {
                        let line = line();
                        return Err(format!(
                            "line {line} has {found} numbers, and those before it {columns}"
                        ));
                    }
                    ([rows, _], _) => *rows += 1,
                    (_, Some(names)) if names != found => {
                        let line = line();
                        return Err(format!(
                            "line {line} has {found} numbers, and above it are {names} names"
                        ));
                    }
                    _ => numbers.sizes = vec![1, found],
                }
                numbers.values.extend(values);
            }
            Err(_) if is_first => numbers.names = Some(row.iter().map(str::to_owned).collect()),
            Err((place, cell)) => {
                let name = numbers.names.as_ref().and_then(|names| names.get(place));
                let of = name.map_or_else(String::new, |name| format!(" of column `{name}`"));
                let commas =
                    if cell.contains(char::is_whitespace) { "; commas stand between numbers" } else { "" };
                return Err(format!("`{cell}`{of} in line {} is no number{commas}", line()));
            }
        }
        is_first = false;
    }
    Ok(numbers)
}

/// Reads a name for each column from a comment; `None` if the number of words differs.
fn names_in(comment: &str, columns: usize) -> Option<Vec<String>> {
    let comment = comment.trim_start_matches('#').trim();
    let between: [Vec<&str>; 2] = [comment.split(',').collect(), comment.split_whitespace().collect()];
    let is_name = !comment.is_empty() && (columns > 1 || !comment.contains(char::is_whitespace));
    let found = between.into_iter().find(|names| names.len() == columns && is_name)?;
    Some(found.into_iter().map(|name| name.trim().trim_matches('"').to_owned()).collect())
}

/// Returns the line in which a row begins. The crate `csv` does not count empty lines.
fn line(text: &[u8], row: &StringRecord) -> usize {
    let behind = row.position().map_or(0, |place| usize::try_from(place.byte()).unwrap_or(text.len()));
    let skipped = text[behind..].iter().take_while(|byte| b"\r\n".contains(byte)).count();
    1 + text[..behind + skipped].iter().filter(|byte| **byte == b'\n').count()
}

struct Array<'a> {
    header: &'a str,
    /// The type of the entries, in quotes.
    descr: &'a str,
    /// Whether the array is in column-major order.
    is_fortran: bool,
    sizes: Vec<usize>,
    count: usize,
    data: &'a [u8],
}

const INCOMPLETE_ARRAY: &str = "it is not a complete array of NumPy";

impl<'a> Array<'a> {
    fn of(bytes: &'a [u8]) -> Option<Self> {
        let (header, data) = header(bytes)?;
        let value = |key: &str| {
            let rest = header.split_once(&format!("'{key}':"))?.1.trim_start();
            Some(rest.split_once([',', '}']).map_or(rest, |(value, _)| value).trim())
        };
        let shape = header.split_once("'shape': (")?.1.split_once(')')?.0;
        let sizes = shape.split(',').map(str::trim).filter(|size| !size.is_empty());
        let sizes: Vec<usize> = sizes.map(str::parse).collect::<Result<_, _>>().ok()?;
        let count = sizes.iter().try_fold(1, |product: usize, size| product.checked_mul(*size))?;
        let (descr, is_fortran) = (value("descr")?, value("fortran_order") != Some("False"));
        Some(Array { header, descr, is_fortran, sizes, count, data })
    }

    fn entries<const WIDTH: usize, V>(&self, read: impl Fn([u8; WIDTH]) -> V) -> Result<Vec<V>, String> {
        let (entries, rest) = self.data.as_chunks();
        if entries.len() != self.count || !rest.is_empty() {
            return Err(INCOMPLETE_ARRAY.to_owned());
        }
        Ok((0..self.count).map(|index| read(entries[self.stored_index(index)])).collect())
    }

    /// Converts a row-major index of an entry into the index at which the entry is stored.
    fn stored_index(&self, mut index: usize) -> usize {
        if !self.is_fortran {
            return index;
        }
        let (mut place, mut stride) = (0, self.count);
        for size in self.sizes.iter().rev() {
            stride /= size;
            place += index % size * stride;
            index /= size;
        }
        place
    }
}

fn array<V: FileNumber>(bytes: &[u8]) -> Result<Numbers<V>, String> {
    let array = Array::of(bytes).ok_or(INCOMPLETE_ARRAY)?;
    if array.descr.starts_with('[') {
        let (names, kinds): (Vec<_>, Vec<_>) =
            fields(array.header).ok_or(INCOMPLETE_ARRAY)?.into_iter().unzip();
        let values = records(array.data, &kinds).filter(|_| array.sizes.len() == 1);
        let values: Vec<V> = values.ok_or("its records are no rows of floats; save it with floats alone")?;
        let sizes = vec![array.count, names.len()];
        let is_whole = array.count.checked_mul(names.len()) == Some(values.len());
        return if is_whole {
            Ok(Numbers { names: Some(names), sizes, values })
        } else {
            Err(INCOMPLETE_ARRAY.to_owned())
        };
    }
    let values = match array.descr {
        "'<f8'" => array.entries(|bytes| V::of_float(f64::from_le_bytes(bytes))),
        "'<f4'" => array.entries(|bytes| V::of_float(f32::from_le_bytes(bytes).into())),
        "'<i4'" => array.entries(|bytes| V::of_float(i32::from_le_bytes(bytes).into())),
        // Integers of more than 53 bits are rounded, as NumPy's `astype(float)` does.
        "'<i8'" => array.entries(|bytes| V::of_float(i64::from_le_bytes(bytes) as f64)),
        _ => Err("its numbers are no floats; save it with .astype(float)".to_owned()),
    };
    values.map(|values| Numbers { names: None, sizes: array.sizes, values })
}

/// Reads an array of strings from `.npy`, or describes the mistake.
pub fn words(bytes: &[u8]) -> Result<Vec<String>, String> {
    let array = Array::of(bytes).ok_or(INCOMPLETE_ARRAY)?;
    let length: Option<usize> =
        array.descr.strip_prefix("'<U").and_then(|rest| rest.strip_suffix('\'')?.parse().ok());
    let length: usize = length.filter(|length| *length > 0).ok_or("its entries are no words")?;
    let (letters, rest) = array.data.as_chunks();
    if Some(letters.len()) != length.checked_mul(array.count) || !rest.is_empty() {
        return Err(INCOMPLETE_ARRAY.to_owned());
    }
    let letter = |bytes: &[u8; 4]| char::from_u32(u32::from_le_bytes(*bytes)).ok_or(INCOMPLETE_ARRAY);
    let word = |index: usize| {
        let letters = &letters[index * length..(index + 1) * length];
        let word: String = letters.iter().map(letter).collect::<Result<_, _>>()?;
        Ok(word.trim_end_matches('\0').to_owned())
    };
    (0..array.count).map(word).collect()
}

/// Returns the names and types of the columns of a structured array, `[('x', '<f8'), …]`.
fn fields(header: &str) -> Option<Vec<(String, &str)>> {
    let (_, list) = header.split_once('[')?;
    let (list, _) = list.split_once(']')?;
    let fields = list.split(')').filter(|field| field.contains('('));
    let named = fields.map(|field| match field.split('\'').collect::<Vec<_>>()[..] {
        [_, name, _, kind, ""] => Some((name.to_owned(), kind)),
        _ => None,
    });
    named.collect()
}

fn records<V: FileNumber>(mut data: &[u8], kinds: &[&str]) -> Option<Vec<V>> {
    let mut values = Vec::new();
    if kinds.is_empty() {
        return None;
    }
    while !data.is_empty() {
        for kind in kinds {
            let float = match *kind {
                "<f8" => f64::from_le_bytes(*data.split_off(..8)?.first_chunk()?),
                "<f4" => f32::from_le_bytes(*data.split_off(..4)?.first_chunk()?).into(),
                _ => return None,
            };
            values.push(V::of_float(float));
        }
    }
    Some(values)
}

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
    use super::{Numbers, array, table, words};

    #[test]
    fn tables_have_names_or_not() {
        let numbers = |names: Option<&[&str]>, values: &[f64]| {
            let names = names.map(|names| names.iter().map(|name| (*name).to_owned()).collect());
            let columns = names.as_ref().map_or(1, Vec::len);
            let sizes = if values.is_empty() { Vec::new() } else { vec![values.len() / columns, columns] };
            Ok(Numbers { names, sizes, values: values.to_vec() })
        };
        let table = |text: &str| table::<f64>(text.as_bytes());
        assert_eq!(table("a, b\n1, 2\n\n-3,4e-1\n"), numbers(Some(&["a", "b"]), &[1.0, 2.0, -3.0, 0.4]));
        assert_eq!(table("1\n2"), numbers(None, &[1.0, 2.0]));
        assert_eq!(table(""), numbers(None, &[]));
        assert_eq!(table("1,2\n3,x"), Err("`x` in line 2 is no number".to_owned()));
        assert_eq!(
            table("a,b\n1,2\n3,4,5\n6\n"),
            Err("line 3 has 3 numbers, and those before it 2".to_owned())
        );
        assert_eq!(table("a,b\n1,2,3\n"), Err("line 2 has 3 numbers, and above it are 2 names".to_owned()));
        assert_eq!(table("\u{feff}\"a\",b\r\n\r\n1,\"2\"\r\n"), numbers(Some(&["a", "b"]), &[1.0, 2.0]));
        for text in ["1\r\n\r\n \r\nx\r\n", "1\n\n \nx"] {
            assert_eq!(table(text), Err("`x` in line 4 is no number".to_owned()), "{text:?}");
        }
        for text in [
            "# a,b\n1,2",
            "#a, b\n1,2",
            "# \"a\",\"b\"\n1,2",
            "# a b\n1,2",
            "# a, b\n# more than two words\n1,2\n# end",
        ] {
            assert_eq!(table(text), numbers(Some(&["a", "b"]), &[1.0, 2.0]), "{text:?}");
        }
        assert_eq!(table("# of c and d\na,b\n1,2"), numbers(Some(&["a", "b"]), &[1.0, 2.0]));
        for text in ["#\n1\n2", "# of two rows\n1\n2"] {
            assert_eq!(table(text), numbers(None, &[1.0, 2.0]), "{text:?}");
        }
        assert_eq!(table("a,b\n1,x"), Err("`x` of column `b` in line 2 is no number".to_owned()));
        assert_eq!(
            table("# a b\n1 2\n3 4"),
            Err("`3 4` of column `1 2` in line 3 is no number; commas stand between numbers".to_owned())
        );
        let left_out = table("a,b\n1,\n").expect("a table").values;
        assert!(left_out[0] == 1.0 && left_out[1].is_nan());
    }

    /// The bytes in this test follow the documentation of numpy.lib.format.
    #[test]
    fn arrays_are_read_as_numpy_writes_them() {
        let file = |version: u8, descr: &str, fortran: &str, shape: &str, data: &[u8]| {
            let header =
                format!("{{'descr': {descr}, 'fortran_order': {fortran}, 'shape': {shape}, }}          \n");
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
        assert_eq!(array(&file(1, "'<f8'", "False", "(4,)", &doubles)), numbers(&[4], &four));
        assert_eq!(array(&file(2, "'<f8'", "False", "(2, 2)", &doubles)), numbers(&[2, 2], &four));
        assert_eq!(array(&file(3, "'<f8'", "True", "(1, 4)", &doubles)), numbers(&[1, 4], &four));
        assert_eq!(array(&file(1, "'<f4'", "False", "(2,)", &singles)), numbers(&[2], &[0.5, 8.0]));
        assert_eq!(
            array(&file(1, "'<f8'", "True", "(2, 2)", &doubles)),
            numbers(&[2, 2], &[1.0, 3.0, -2.5, 4.0])
        );
        let six: Vec<u8> = (0..6_i32).flat_map(i32::to_le_bytes).collect();
        let turned = numbers(&[1, 3, 2], &[0.0, 3.0, 1.0, 4.0, 2.0, 5.0]);
        assert_eq!(array(&file(1, "'<i4'", "True", "(1, 3, 2)", &six)), turned);
        let wide: Vec<u8> = [-7_i64, 1 << 40].iter().flat_map(|x| x.to_le_bytes()).collect();
        assert_eq!(
            array(&file(1, "'<i8'", "False", "(2,)", &wide)),
            numbers(&[2], &[-7.0, 1_099_511_627_776.0])
        );
        assert_eq!(array(&file(1, "'<f8'", "True", "(0, 2)", &[])), numbers(&[0, 2], &[]));
        let letters: Vec<u8> = "xαu\0".chars().flat_map(|letter| u32::from(letter).to_le_bytes()).collect();
        assert_eq!(
            words(&file(1, "'<U2'", "False", "(2,)", &letters)),
            Ok(vec!["xα".to_owned(), "u".to_owned()])
        );
        let records = |descr, data: &[u8]| array::<f64>(&file(1, descr, "False", "(2,)", data));
        let named = Numbers {
            names: Some(vec!["y".to_owned(), "x".to_owned()]),
            sizes: vec![2, 2],
            values: four.to_vec(),
        };
        assert_eq!(records("[('y', '<f8'), ('x', '<f8')]", &doubles), Ok(named));
        assert!(records("[('y', '<i8'), ('x', '<f8')]", &doubles).is_err());
        assert!(records("[('y', '<f8'), ('x', '<f8')]", &doubles[..31]).is_err());
        assert!(records("[('y', '<f8')]", &doubles).is_err());
        assert!(records("[]", &doubles).is_err());
        for wrong in [
            file(1, "'<U2'", "False", "(3,)", &letters),
            file(1, "'<U9999999999999999999'", "False", "(2,)", &letters),
            file(1, "'<U0'", "False", "(9999999999999999999,)", &[]),
            file(1, "'<f8'", "False", "(2,)", &letters),
            file(1, "'<U1'", "False", "(1,)", &[255; 4]),
        ] {
            assert!(words(&wrong).is_err(), "{}", String::from_utf8_lossy(&wrong));
        }
        for wrong in [
            file(1, "'<c16'", "False", "(2,)", &doubles),
            file(1, "'|O'", "False", "(4,)", &doubles),
            file(1, "'<f8'", "False", "(5,)", &doubles),
            file(1, "'<f8'", "False", "(4,)", &doubles[..31]),
            file(1, "'<f8'", "False", "(18446744073709551615, 2)", &doubles),
            b"\x93NUMPY\x01\x00\xff\xff{".to_vec(),
            b"x,y".to_vec(),
        ] {
            assert!(array::<f64>(&wrong).is_err(), "{}", String::from_utf8_lossy(&wrong));
        }
    }
}
