//! Orbits of one map, followed one by one or side by side.
//!
//! Side by side they go through the map's step for columns, which is faster, and whose last digits
//! differ from those of single steps; so the plan chooses, and not what happens to stand together.

use kahan_runtime::MapAt;

use super::orbit::Machine;

/// How orbits are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gait {
    OneByOne,
    Abreast,
}

/// Where an orbit ended.
pub(super) struct Walked<T> {
    /// The last point whose numbers are finite.
    pub(super) last: Vec<T>,
    /// The steps up to there.
    pub(super) steps: u64,
}

/// The points of some orbits after a step.
pub(super) struct Seen<'a, T> {
    pub(super) step: u64,
    /// The point of each orbit, one behind the other.
    points: &'a [T],
    variables: usize,
    /// The orbits that are shown: the others have ended.
    left: &'a [usize],
}

impl<T> Seen<'_, T> {
    /// The orbits that are shown, with their points.
    #[inline]
    pub(super) fn each(&self) -> impl Iterator<Item = (usize, &[T])> {
        self.left.iter().map(|&orbit| (orbit, &self.points[orbit * self.variables..][..self.variables]))
    }
}

impl Gait {
    /// Follows orbits for at most so many steps each, as long as their numbers are finite, and
    /// shows the points of every step.
    pub(super) fn walk<T: Machine>(
        self,
        at: &MapAt<T>,
        starts: &[Vec<T>],
        steps: &[u64],
        mut show: impl FnMut(&Seen<'_, T>),
    ) -> Vec<Walked<T>> {
        let mut points = starts.concat();
        let variables = starts.first().map_or(0, Vec::len);
        match self {
            Gait::OneByOne => {
                let orbits = starts.iter().zip(steps).enumerate();
                let walked = orbits.map(|(orbit, (start, &steps))| {
                    let place = orbit * variables..(orbit + 1) * variables;
                    alone(at, start, steps, |step, x| {
                        points[place.clone()].copy_from_slice(x);
                        show(&Seen { step, points: &points, variables, left: &[orbit] });
                    })
                });
                walked.collect()
            }
            Gait::Abreast => abreast(at, starts, steps, &mut show),
        }
    }

    /// The points after so many steps, and without a look at those on the way where all is well.
    pub(super) fn advance<T: Machine>(self, at: &MapAt<T>, starts: &[Vec<T>], steps: u64) -> Vec<Walked<T>> {
        let ends = self.ends(at, starts, steps);
        let walked = starts.iter().zip(ends).map(|(start, last)| {
            if is_finite(&last) {
                return Walked { last, steps };
            }
            // Somewhere on the way numbers left their range: that step is looked for.
            let mut walked = self.walk(at, std::slice::from_ref(start), &[steps], |_| ());
            walked.pop().unwrap_or(Walked { last, steps: 0 })
        });
        walked.collect()
    }

    fn ends<T: Machine>(self, at: &MapAt<T>, starts: &[Vec<T>], steps: u64) -> Vec<Vec<T>> {
        match self {
            Gait::OneByOne => {
                let mut ends = starts.to_vec();
                for end in &mut ends {
                    // A state is as long as the field has variables.
                    let _ = at.advance(end, steps);
                }
                ends
            }
            Gait::Abreast => {
                let mut columns = columns(starts);
                advance(at, &mut columns, steps);
                (0..starts.len()).map(|orbit| columns.iter().map(|column| column[orbit]).collect()).collect()
            }
        }
    }
}

fn alone<T: Machine>(at: &MapAt<T>, start: &[T], steps: u64, mut show: impl FnMut(u64, &[T])) -> Walked<T> {
    let mut x = start.to_vec();
    show(0, &x);
    for step in 1..=steps {
        // A state is as long as the field has variables.
        let _ = at.advance(&mut x, 1);
        if !is_finite(&x) {
            // The point before is found again, so that no other orbit pays for keeping it.
            x.copy_from_slice(start);
            let _ = at.advance(&mut x, step - 1);
            return Walked { last: x, steps: step - 1 };
        }
        show(step, &x);
    }
    Walked { last: x, steps }
}

fn abreast<T: Machine>(
    at: &MapAt<T>,
    starts: &[Vec<T>],
    steps: &[u64],
    show: &mut impl FnMut(&Seen<'_, T>),
) -> Vec<Walked<T>> {
    let (mut columns, mut points) = (columns(starts), starts.concat());
    let variables = columns.len();
    let all: Vec<usize> = (0..starts.len()).collect();
    show(&Seen { step: 0, points: &points, variables, left: &all });
    let mut left: Vec<usize> = all.into_iter().filter(|&orbit| steps[orbit] > 0).collect();
    let mut made = vec![0; starts.len()];
    let mut step = 0;
    while !left.is_empty() {
        step += 1;
        advance(at, &mut columns, 1);
        for (k, column) in columns.iter().enumerate() {
            for (point, x) in points.chunks_exact_mut(variables).zip(column) {
                point[k] = *x;
            }
        }
        left.retain(|&orbit| is_finite(&points[orbit * variables..][..variables]));
        left.iter().for_each(|&orbit| made[orbit] = step);
        show(&Seen { step, points: &points, variables, left: &left });
        left.retain(|&orbit| step < steps[orbit]);
    }
    let walked = starts.iter().enumerate().map(|(orbit, start)| {
        let last = if made[orbit] == step {
            columns.iter().map(|column| column[orbit]).collect()
        } else {
            // The others went on, and took it beyond its last point.
            Gait::Abreast.ends(at, std::slice::from_ref(start), made[orbit]).pop().unwrap_or_default()
        };
        Walked { last, steps: made[orbit] }
    });
    walked.collect()
}

fn columns<T: Machine>(starts: &[Vec<T>]) -> Vec<Vec<T>> {
    let variables = starts.first().map_or(0, Vec::len);
    (0..variables).map(|k| starts.iter().map(|start| start[k]).collect()).collect()
}

fn advance<T: Machine>(at: &MapAt<T>, columns: &mut [Vec<T>], steps: u64) {
    let mut columns: Vec<&mut [T]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    // There are as many columns as the field has variables, all of one length.
    let _ = at.advance_columns(&mut columns, &[], &[], steps);
}

fn is_finite<T: Machine>(x: &[T]) -> bool {
    x.iter().all(|&x| x.into().is_finite())
}
