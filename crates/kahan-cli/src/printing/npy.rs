//! Writes NumPy arrays (numpy.lib.format, version 1.0) row by row.

use super::output_stream::{OutputStream, WriteError};

pub(crate) struct Npy {
    sink: OutputStream,
    row: Vec<usize>,
    rows: u64,
}

impl Npy {
    pub(crate) fn new(mut sink: OutputStream, row: Vec<usize>) -> Result<Self, WriteError> {
        sink.write(header(0, &row))?;
        Ok(Npy { sink, row, rows: 0 })
    }

    pub(crate) fn row(&mut self, numbers: &[f64]) -> Result<(), WriteError> {
        self.rows += 1;
        numbers.iter().try_for_each(|number| self.sink.write(number.to_le_bytes()))
    }

    pub(crate) fn finish(mut self) -> Result<(), WriteError> {
        self.sink.overwrite_beginning(&header(self.rows, &self.row))?;
        self.sink.finish()
    }
}

/// Returns a header of 128 bytes, so that the number of rows can be replaced at the end.
fn header(rows: u64, row: &[usize]) -> Vec<u8> {
    let sizes: String = row.iter().map(|size| format!(", {size}")).collect();
    let dictionary = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}{sizes}), }}");
    [b"\x93NUMPY\x01\x00\x76\x00".as_slice(), format!("{dictionary:<117}\n").as_bytes()].concat()
}

#[cfg(test)]
mod tests {
    use super::header;

    #[test]
    fn headers_have_one_length() {
        for (rows, row) in [(0, vec![3]), (u64::MAX, vec![1 << 28, 1 << 28])] {
            let header = header(rows, &row);
            assert_eq!((header.len(), header[127]), (128, b'\n'));
            assert_eq!(usize::from(u16::from_le_bytes([header[8], header[9]])), 118);
        }
    }
}
