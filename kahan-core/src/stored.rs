//! Values as data, with the feature `serde`, where deriving is not enough.
//!
//! In: a double-double number, a composition. Out: its two parts, and the name of its constant, and
//! back. Other types derive what they need where they stand. No format is chosen here; for
//! `serde_json` to read back every bit of a float takes its feature `float_roundtrip`.

use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::{Composition, Dd};

/// As \[high, low\], of which no bit is lost.
impl Serialize for Dd {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.high(), self.low()).serialize(serializer)
    }
}

/// The sum of any two floats.
impl<'a> Deserialize<'a> for Dd {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        let (high, low) = Deserialize::deserialize(deserializer)?;
        Ok(Dd::new(high, low))
    }
}

/// As the [name](Composition::name) of its constant.
impl Serialize for Composition {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// Refuses names that are not those of [`Composition::ALL`].
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
