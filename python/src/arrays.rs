//! Arrays of NumPy by its own functions and bytes: a crate for it would add many more, and compile parts of the library twice.

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyBytes;

/// `numpy.frombuffer`, and the types of its elements.
static FROM_BUFFER: PyOnceLock<[Py<PyAny>; 3]> = PyOnceLock::new();

fn functions(py: Python<'_>) -> PyResult<&[Py<PyAny>; 3]> {
    FROM_BUFFER.get_or_try_init(py, || {
        let numpy = py.import("numpy")?;
        let dtype = |name: &str| numpy.call_method1("dtype", (name,));
        let attributes = [numpy.getattr("frombuffer")?, dtype("f8")?, dtype("i8")?];
        Ok(attributes.map(Bound::unbind))
    })
}

/// An array of these bytes of elements, which cannot be written: objects that keep it hand it out several times.
fn array<'py>(
    py: Python<'py>,
    dtype: usize,
    words: impl ExactSizeIterator<Item = [u8; 8]>,
) -> PyResult<Bound<'py, PyAny>> {
    let functions = functions(py)?;
    let bytes = PyBytes::new_with(py, 8 * words.len(), |bytes| {
        for (target, word) in bytes.chunks_exact_mut(8).zip(words) {
            target.copy_from_slice(&word);
        }
        Ok(())
    })?;
    functions[0].bind(py).call1((bytes, &functions[dtype]))
}

/// An array of numbers.
pub fn numbers<'py>(
    py: Python<'py>,
    values: impl ExactSizeIterator<Item = f64>,
) -> PyResult<Bound<'py, PyAny>> {
    array(py, 1, values.map(f64::to_ne_bytes))
}

/// An array of whole numbers.
pub fn whole<'py>(
    py: Python<'py>,
    values: impl ExactSizeIterator<Item = i64>,
) -> PyResult<Bound<'py, PyAny>> {
    array(py, 2, values.map(i64::to_ne_bytes))
}

/// The numbers in the bytes of an array.
pub fn of_bytes(bytes: &[u8]) -> Vec<f64> {
    let words = bytes.chunks_exact(8).map(|word| {
        let mut native = [0; 8];
        native.copy_from_slice(word);
        f64::from_ne_bytes(native)
    });
    words.collect()
}
