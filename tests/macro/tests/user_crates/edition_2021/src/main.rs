//! A crate of the previous edition, with default features and only the prelude.

#![deny(missing_docs, unused, warnings)]
#![deny(clippy::pedantic)]

use kahan_core::KahanAt;
use kahan_core::prelude::*;

kahan! {
    /// A rotation with the speed `omega`.
    pub struct Rotation { omega }
    xdot = omega*y;
    ydot = -omega*x;
    integral H = x^2 + y^2;
    bracket P { {x,y} = 1; }
}

/// A user's struct that holds a prepared map and its state.
struct Spinning<M: KahanMap<f64, 2>> {
    map: KahanAt<M, f64, 2>,
    state: SVector<f64, 2>,
}

struct Wheel {
    inner: Spinning<Rotation<f64>>,
}

impl<M: KahanMap<f64, 2>> Spinning<M> {
    fn turn(&mut self) {
        self.state = self.map.step(&self.state);
    }
}

fn main() {
    let rotation = Rotation { omega: 2.0_f64 };
    let start = vector![0.6, 0.8];
    let end = rotation.orbit(start, 0.05).nth(100).expect("an orbit of floats does not end");
    assert!((rotation.integrals(&end, 0.05)[0] - 1.0).abs() < 1e-13);
    let mut wheel = Wheel { inner: Spinning { map: rotation.at(0.05), state: start } };
    for _ in 0..100 {
        wheel.inner.turn();
    }
    assert_eq!(wheel.inner.state, end);
    let omega = 2.0_f64;
    let value = kahan! { xdot = omega*y; ydot = -omega*x; };
    assert_eq!(value.step(&start, 0.05), rotation.step(&start, 0.05));
}
