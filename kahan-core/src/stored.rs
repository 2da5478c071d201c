//! Serialisation of double-doubles and compositions, with the feature `serde`.

use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::{Composition, Dd};

/// Writes the two parts \[high, low\] without loss.
impl Serialize for Dd {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.high(), self.low()).serialize(serializer)
    }
}

/// Reads any two floats and adds them.
impl<'a> Deserialize<'a> for Dd {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        let (high, low) = Deserialize::deserialize(deserializer)?;
        Ok(Dd::new(high, low))
    }
}

impl Serialize for Composition {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// Reads a name, and refuses names that are not in [`Composition::ALL`].
impl<'a> Deserialize<'a> for Composition {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        struct Name;

        impl Visitor<'_> for Name {
            type Value = Composition;

            fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str("the name of a composition, such as \"KAHAN_LI_8\"")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<Composition, E> {
                let known = Composition::ALL.into_iter().find(|known| known.name() == name);
                known.ok_or_else(|| E::invalid_value(serde::de::Unexpected::Str(name), &self))
            }
        }

        deserializer.deserialize_str(Name)
    }
}
