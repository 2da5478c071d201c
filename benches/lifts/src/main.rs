//! Measures lifted fields. The command is `cargo run --release -p kahan-bench-lifts -- TABLE`,
//! where TABLE is race, stability, orders, energy or projection.

mod energy;
mod orders;
mod race;
mod stability;
mod systems;

fn main() {
    match std::env::args().nth(1).as_deref() {
        None | Some("race") => race::race(),
        Some("stability") => stability::stability(),
        Some("orders") => orders::orders(),
        Some("energy") => energy::energy(),
        Some("projection") => energy::projection(),
        Some(other) => panic!("{other}: race, stability, orders, energy and projection are tables"),
    }
}
