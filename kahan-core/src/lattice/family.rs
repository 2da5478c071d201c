//! The boundary condition of a chain, and the sizes of the equations of one site.

/// The boundary condition of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// Site 0 follows the last site.
    Periodic,
    /// States and parameters beyond the ends of the chain are 0.
    Open,
}

/// The sizes of the equations of one site of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// The number of arrays of the family, which is the number of unknowns per site.
    pub block: usize,
    /// The largest offset of a neighbour in the equations, at least 1.
    pub reach: usize,
    /// The number of parameters per site.
    pub parameters: usize,
    /// The lower bandwidth of the matrix A, counted in unknowns.
    pub lower: usize,
    /// The upper bandwidth of the matrix A, counted in unknowns.
    pub upper: usize,
    /// The number of scratch numbers that `LatticeMap::rows` needs for one site.
    pub registers: usize,
    /// The number of scratch SIMD registers that the equations of one site need.
    pub registers_abreast: usize,
}

/// The sizes of a family's equations as a type. Elimination is compiled once per such type.
///
/// | parameter | meaning |
/// |---|---|
/// | `B` | the number of arrays of the family |
/// | `R` | the largest offset of a neighbour, at least 1 |
/// | `P` | the number of parameters per site |
/// | `C` | the number of prepared constants |
/// | `LOWER` | the lower bandwidth of A, in unknowns |
/// | `UPPER` | the upper bandwidth of A, in unknowns |
/// | `SITES` | 2R + 1, the number of sites in the equations of one site |
/// | `WIDTH` | `LOWER` + 1 + `UPPER`, the number of entries in a row of the band |
///
/// Row (i, b) of A belongs to array b of site i. Its entry for array b′ of site i + d lies d·B +
/// b′ − b columns to the right of the diagonal. Wrong values of `SITES` or `WIDTH` do not compile.
#[derive(Clone, Copy, Debug)]
pub struct Stencil<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
>;

impl<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
> Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>
{
    /// The const parameters of this type as [`Sizes`].
    pub const SIZES: Sizes = {
        assert!(B > 0 && R > 0 && SITES == 2 * R + 1 && WIDTH == LOWER + 1 + UPPER);
        assert!(LOWER < (R + 1) * B && UPPER < (R + 1) * B);
        Sizes {
            block: B,
            reach: R,
            parameters: P,
            lower: LOWER,
            upper: UPPER,
            registers: 0,
            registers_abreast: 0,
        }
    };
}
