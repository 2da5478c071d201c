//! Reads files of numbers, whose content is made from bytes.

use kahan_study::number_file::Numbers;

use crate::words::text;

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

/// Reads two NumPy files: the bytes, and a file whose header consists of words chosen by the bytes.
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

/// Reads a table of numbers.
pub fn read_csv(bytes: &[u8]) {
    read(bytes, ".csv");
}

/// Reads a file, and checks that its numbers and names agree with the shape.
fn read(bytes: &[u8], ending: &str) {
    match Numbers::<f64>::of(ending, bytes) {
        Ok(Numbers { names, sizes, values }) => {
            let product: usize = sizes.iter().product();
            assert!(product == values.len() || sizes.is_empty() && values.is_empty(), "{sizes:?}");
            if let (Some(names), [_, columns]) = (names, &sizes[..]) {
                assert_eq!(names.len(), *columns, "each column has a name");
            }
        }
        Err(why) => assert!(!why.is_empty()),
    }
}
