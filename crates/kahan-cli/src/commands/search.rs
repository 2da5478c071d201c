//! What `discover` and `scan` are asked: of which field, with what fixed, how far and for how long.

use clap::Args;

use crate::reading::{Source, seconds, whole};

/// A field, and the bounds of a search.
#[derive(Args, Debug)]
pub(crate) struct Search {
    #[command(flatten)]
    pub(crate) source: Source,

    /// Half the time step, where it is fixed; generic otherwise. `scan` takes a range, too.
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub(crate) eps: Option<String>,

    /// The degree up to which relations on orbits are looked for.
    ///
    /// Where it is not given, the number of variables chooses: as high as some 200 monomials allow,
    /// in `scan` some 80; and `discover` goes on to higher degrees while integrals may be missing
    /// and there is time.
    #[arg(long, value_name = "D", allow_hyphen_values = true, value_parser = whole(1, u32::MAX))]
    pub(crate) degree: Option<u32>,

    /// The time that the search may take.
    ///
    /// Each stage has its share, orbits and their relations up to two fifths. What is not finished
    /// then is left out, and the answer says so. `discover` takes all of it only where integrals
    /// may be missing; --degree ends it earlier, with the same answer on every machine.
    #[arg(long, value_name = "S", default_value = "60", allow_hyphen_values = true, value_parser = seconds)]
    pub(crate) seconds: f64,

    /// Print one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}
