//! Does three tasks of `run.py` in Rust, which it reads from standard input. `each STEPS` asks for
//! all points of an orbit, `last STEPS` for the last point, `ensemble TRAJECTORIES STEPS THREADS`
//! for the last points of many orbits. The answer is the time in seconds, and the last coordinate
//! z.

use std::error::Error;
use std::io::stdin;
use std::num::NonZeroU64;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::Instant;

use kahan_runtime::{Field, Follow, MapAt, threads};

/// A thread computes this many trajectories together, so that they fit into the processor's cache.
const TOGETHER: usize = 1024;

fn main() -> Result<(), Box<dyn Error>> {
    let field = Field::parse("xdot = y*(2*z - x); ydot = x^2 - z^2; zdot = y*(z - 2*x);")?;
    let at: MapAt<f64> = field.map()?.at(0.005);
    for line in stdin().lines() {
        let line = line?;
        let mut words = line.split_whitespace();
        let task = words.next().ok_or("a task is needed")?;
        let counts = words.map(str::parse).collect::<Result<Vec<usize>, _>>()?;
        let begun = Instant::now();
        let found = match (task, &counts[..]) {
            ("each", [steps]) => each(&at, *steps)?,
            ("last", [steps]) => last(&at, *steps)?,
            ("ensemble", [trajectories, steps, threads]) => ensemble(&at, *trajectories, *steps, *threads)?,
            _ => return Err(format!("there is no task `{line}`").into()),
        };
        println!("{:e} {:e}", begun.elapsed().as_secs_f64(), found[found.len() - 1]);
    }
    Ok(())
}

/// Computes all points of an orbit, and writes them to newly allocated memory.
fn each(at: &MapAt<f64>, steps: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut x = [0.3, 0.8, 0.5];
    let mut rows = vec![0.0; 3 * steps];
    at.rows(&mut x, NonZeroU64::MIN, &mut rows, |_| ControlFlow::Continue(()))?;
    Ok(rows)
}

/// Computes only the last point of an orbit.
fn last(at: &MapAt<f64>, steps: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut x = [0.3, 0.8, 0.5];
    at.follow(&mut x, steps as u64, |_| ControlFlow::Continue(()))?;
    Ok(x.to_vec())
}

/// Allocates columns for many trajectories, and returns z of their last points.
fn ensemble(
    at: &MapAt<f64>,
    trajectories: usize,
    steps: usize,
    threads: usize,
) -> Result<Vec<f64>, Box<dyn Error>> {
    let [mut x, mut y, mut z] = [0.3, 0.8, 0.5].map(|first| vec![first; trajectories]);
    let pieces = x.chunks_mut(TOGETHER).zip(y.chunks_mut(TOGETHER)).zip(z.chunks_mut(TOGETHER));
    let pieces: Vec<_> = pieces.map(|((x, y), z)| Mutex::new([x, y, z])).collect();
    threads::for_each(pieces.len(), Some(threads), &|piece| {
        let mut columns = pieces[piece].lock().expect("a piece has one thread");
        at.advance_columns(&mut *columns, &[], &[], steps as u64).expect("there are three columns");
    });
    drop(pieces);
    Ok(z)
}
