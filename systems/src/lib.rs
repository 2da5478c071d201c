//! The catalog: the Euler top, Lotka-Volterra and the systems E1 to E9 of Hone and Petrera, and further systems whose claims
//! were found by `kahan discover`, one file each.
//!
//! In: nothing but the equations. Out: the systems as types with their proved claims, their closed solutions, and a registry
//! to find them by name. It must not know the command, nor the paper's claims.
//!
//! A file holds the `kahan!` block with every rational claim that holds, and names what no rational claim can hold. The
//! macro proves the claims while it compiles the block. An [`entry`] offers the same block as text with the place of each
//! claim in the paper, [`registry`] lists the entries, and the `kahan` command proves them again from there. The half step ε is written `eps`.

pub mod entry;
pub mod registry;
pub mod solution;
pub mod special;

pub mod e1;
pub mod e2;
pub mod e3;
pub mod e4;
pub mod e5;
pub mod e6;
pub mod e7;
pub mod e8;
pub mod e9;
pub mod euler;
pub mod henon_heiles;
pub mod lagrange;
pub mod lorenz;
pub mod lotka_volterra;
pub mod volterra;
pub mod volterra4;
pub mod weierstrass;
pub mod zhukovsky;

pub use e1::E1;
pub use e2::E2;
pub use e3::E3;
pub use e4::E4;
pub use e5::E5;
pub use e6::E6;
pub use e7::E7;
pub use e8::E8;
pub use e9::E9;
pub use euler::EulerTop;
pub use henon_heiles::HenonHeiles;
pub use lagrange::LagrangeTop;
pub use lorenz::Lorenz;
pub use lotka_volterra::LotkaVolterra;
pub use volterra::VolterraLattice;
pub use volterra4::VolterraFour;
pub use weierstrass::Weierstrass;
pub use zhukovsky::ZhukovskyVolterra;
