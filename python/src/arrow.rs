//! Tables as Arrow streams, in a capsule that other libraries can read.
//!
//! Exact rational numbers become text, because Arrow has no type for them.

use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::{Float32Type, Float64Type, Int64Type};
use arrow_array::{
    ArrayRef, ArrowPrimitiveType, PrimitiveArray, RecordBatch, RecordBatchIterator, StringArray,
};
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

/// Writes columns of equal lengths as a stream of one batch, in Arrow's capsule.
#[pyfunction]
pub(crate) fn arrow<'py>(
    py: Python<'py>,
    columns: Vec<(String, Bound<'py, PyAny>)>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let columns = columns.into_iter().map(|(name, values)| Ok((name, column(&values)?)));
    let columns = columns.collect::<PyResult<Vec<_>>>()?;
    let batch = RecordBatch::try_from_iter(columns)
        .map_err(|error| PyValueError::new_err(format!("columns that make no table: {error}")))?;
    let schema = batch.schema();
    let stream = FFI_ArrowArrayStream::new(Box::new(RecordBatchIterator::new([Ok(batch)], schema)));
    PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
}

fn column(values: &Bound<'_, PyAny>) -> PyResult<ArrayRef> {
    let floats = numbers::<Float64Type>(values).or_else(|| numbers::<Float32Type>(values));
    if let Some(column) = floats.or_else(|| numbers::<Int64Type>(values)) {
        return Ok(column);
    }
    let texts = values.try_iter()?.map(|value| {
        let value = value?;
        if value.is_none() { Ok(None) } else { Ok(Some(value.str()?.to_string())) }
    });
    Ok(Arc::new(StringArray::from(texts.collect::<PyResult<Vec<_>>>()?)))
}

/// Copies the numbers of an array; `None` if the array has another type.
fn numbers<T: ArrowPrimitiveType<Native: Element + Copy>>(values: &Bound<'_, PyAny>) -> Option<ArrayRef> {
    let values = values.cast::<PyArray1<T::Native>>().ok()?.try_readonly().ok()?;
    Some(Arc::new(PrimitiveArray::<T>::from_iter_values(values.as_array().iter().copied())))
}
