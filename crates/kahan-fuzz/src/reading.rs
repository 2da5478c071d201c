//! The command's readers of files. They are private there, so their source is compiled once more.

use std::fs;

use crate::words::text;

#[path = "../../kahan-cli/src/reading/number_file.rs"]
#[expect(dead_code, reason = "the command uses more of it")]
mod number_file;

/// What the header of an array is made of.
const WORDS: &[&str] = &[
    "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }",
    "{",
    "}",
    "'descr': ",
    "'<f8'",
    "'<f4'",
    "'>i2'",
    "'fortran_order': ",
    "False",
    "True",
    "'shape': ",
    "(",
    ")",
    ", ",
    "0",
    "1",
    "2",
    "4",
    "18446744073709551615",
    " ",
    "\n",
];

/// Reads an array of NumPy's: the bytes as they stand, and numbers behind a header of words.
pub fn read_npy(bytes: &[u8]) {
    read(bytes, ".npy");
    let (numbers, header) = bytes.split_at(bytes.len().min(32));
    if let Some(header) = text(header, WORDS)
        && let Ok(length) = u16::try_from(header.len())
    {
        let file = [b"\x93NUMPY\x01\x00", &length.to_le_bytes()[..], header.as_bytes(), numbers].concat();
        read(&file, ".npy");
    }
}

/// Reads a table.
pub fn read_csv(bytes: &[u8]) {
    read(bytes, ".csv");
}

/// Reads a file with these bytes and this ending; what is accepted has as many numbers and names as
/// its sizes say.
fn read(bytes: &[u8], ending: &str) {
    // One file, written over and over: to make a new one takes much longer than to read it.
    let path = std::env::temp_dir().join(format!("kahan-fuzz-{}{ending}", std::process::id()));
    fs::write(&path, bytes).expect("there is room for a file");
    match number_file::read::<f64>(path.to_str().expect("its name is text"), "--start") {
        Ok(number_file::Numbers { names, sizes, values }) => {
            let product: usize = sizes.iter().product();
            assert!(product == values.len() || sizes.is_empty() && values.is_empty(), "{sizes:?}");
            if let (Some(names), [_, columns]) = (names, &sizes[..]) {
                assert_eq!(names.len(), *columns, "each column has a name");
            }
        }
        Err(refusal) => assert!(refusal.0.contains("--start"), "{}", refusal.0),
    }
}
