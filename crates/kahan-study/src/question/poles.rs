//! What happens after a map sends a curve to infinity or blows it down.

use kahan_algebra::rational::Rational;
use kahan_discover::orbits::growth::GrowthVerdict;
use kahan_discover::poles::Pattern;
use kahan_discover::{Watch, poles};
use serde::{Deserialize, Serialize, Serializer};

use crate::error::StudyError;
use crate::numbers::exact;
use crate::study::Study;

use super::discover::options;
use super::seconds_since;

/// Asks what becomes of the curves that the map loses, in three variables of surfaces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Poles {
    /// ε, half the time step, where it is fixed; generic otherwise.
    #[serde(with = "exact")]
    pub eps: Option<Rational>,
    /// How many steps each curve is followed.
    pub steps: usize,
    /// The seconds that the search may take; what is not finished then is undecided.
    pub seconds: f64,
}

/// Twelve steps, a minute.
impl Default for Poles {
    fn default() -> Self {
        Poles { eps: None, steps: 12, seconds: 60.0 }
    }
}

/// The patterns of the curves.
#[derive(Clone, Debug)]
pub struct PolesFound {
    /// The name of the system.
    pub system: String,
    /// The patterns, and the degrees of iterates.
    pub found: kahan_discover::Poles,
    /// How the degrees grow.
    pub growth: GrowthVerdict,
    /// The seconds that it took; `None` without a clock.
    pub seconds: Option<f64>,
}

impl Poles {
    /// Follows the curves modulo two primes. Parameters that are not given are generic; claims are
    /// not looked at.
    ///
    /// # Errors
    /// [`StudyError::Discover`].
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<PolesFound, StudyError> {
        let begun = watch.now();
        let options = options(study, &self.eps, None, self.seconds)?;
        let found = poles(study.system(), &options, self.steps, watch);
        let found = found.map_err(|why| StudyError::Discover { system: study.name().to_owned(), why })?;
        Ok(PolesFound {
            system: study.name().to_owned(),
            growth: GrowthVerdict::of(&found.degrees),
            found,
            seconds: seconds_since(begun, watch),
        })
    }
}

#[derive(Serialize)]
struct Object<'a> {
    system: &'a str,
    patterns: Vec<Curve>,
    bound: usize,
    complete: bool,
    degrees: &'a [usize],
    implied_degrees: Option<&'a [usize]>,
    growth: &'static str,
    entropy: f64,
    seconds: Option<f64>,
}

#[derive(Serialize)]
struct Curve {
    curve: String,
    steps: usize,
    confined: Option<bool>,
    blown_down: bool,
    images: Vec<Image>,
}

#[derive(Serialize)]
struct Image {
    dimension: usize,
    infinite: bool,
}

impl Serialize for PolesFound {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let found = &self.found;
        let image = |image: &kahan_discover::poles::Image| Image {
            dimension: image.dimension,
            infinite: image.is_infinite,
        };
        let curve = |pattern: &Pattern| Curve {
            curve: pattern.name(&found.symbols),
            steps: pattern.steps,
            confined: pattern.confined,
            blown_down: pattern.is_blown_down(),
            images: pattern.images.iter().take(pattern.steps).map(image).collect(),
        };
        let object = Object {
            system: &self.system,
            patterns: found.patterns.iter().map(curve).collect(),
            bound: found.bound,
            complete: found.is_complete,
            degrees: &found.degrees,
            implied_degrees: found.implied_degrees.as_deref(),
            growth: self.growth.growth.word(),
            entropy: self.growth.growth.entropy(),
            seconds: self.seconds,
        };
        object.serialize(serializer)
    }
}
