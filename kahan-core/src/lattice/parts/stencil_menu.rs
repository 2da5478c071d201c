//! Kernels for families read at run time, which use the first listed stencil of equal block and
//! reach with sufficient bandwidths, if any.

use crate::ensemble::Level;
use crate::ensemble::lanes::InLanes;
use crate::lattice::{LatticeMap, LatticeScalar, Sizes, Stencil};

use super::first_pass::FirstPass;
use super::kernels::{Kernels, Pass};
use super::second_pass::SecondPass;

/// Kernels for a short list of stencil sizes.
#[derive(Clone, Copy, Debug)]
pub enum StencilMenu {}

/// Declares stencils, one per line, by numbers that the documentation of `Stencil` explains.
macro_rules! menu {
    ($($block:literal, $reach:literal, $lower:literal, $upper:literal, $sites:literal, $width:literal;)*) => {
        impl StencilMenu {
            /// Widens the bandwidths in `sizes` to those of the first sufficient stencil, if any.
            pub fn widened(sizes: Sizes) -> Sizes {
                let Sizes { block, reach, lower, upper, .. } = sizes;
                $(if (block, reach) == ($block, $reach) && lower <= $lower && upper <= $upper {
                    return Sizes { lower: $lower, upper: $upper, ..sizes };
                })*
                sizes
            }
        }

        impl Kernels for StencilMenu {
            fn supports(Sizes { block, reach, lower, upper, .. }: Sizes) -> bool {
                [$(($block, $reach, $lower, $upper)),*].contains(&(block, reach, lower, upper))
            }

            fn run<M: LatticeMap<T>, T: LatticeScalar + InLanes>(pass: Pass<'_, M, T>, level: Level) {
                let (Pass::First(FirstPass { map, .. }) | Pass::Second(SecondPass { map, .. })) = &pass;
                let Sizes { block, reach, lower, upper, .. } = map.sizes();
                match (block, reach, lower, upper) {
                    $(($block, $reach, $lower, $upper) => {
                        Stencil::<$block, $reach, 0, 0, $lower, $upper, $sites, $width>::run(pass, level);
                    })*
                    _ => unreachable!("parts are made where there is a kernel"),
                }
            }
        }
    };
}

menu! {
    1, 1, 1, 1, 3, 3;
    1, 2, 2, 2, 5, 5;
    2, 1, 2, 2, 3, 5;
    2, 1, 3, 1, 3, 5;
    2, 1, 3, 3, 3, 7;
}
