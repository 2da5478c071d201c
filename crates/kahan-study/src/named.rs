//! Lists of named values. In JSON they are objects that keep the order of the list.

use serde::{Serialize, Serializer};

/// Values with their names.
pub type Names<T> = Vec<(String, T)>;

pub(crate) fn by_name<T: Serialize, S: Serializer>(
    values: &Names<T>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(values.iter().map(|(name, value)| (name, value)))
}
