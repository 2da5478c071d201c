//! Chooses the initial picture of a field: ε, parameters, first points, and two variables.

use kahan_algebra::rational::Rational;
use kahan_study::{ShownOrbit, Study, StudyError};
use serde_json::{Map, Value, json};

/// The largest number of orbits with which a picture begins.
const ORBITS: usize = 5;
/// The box around a drawn orbit must fill at least this fraction of the picture's area.
const SHARE: f64 = 0.25;
/// The factors by which a given initial point is multiplied to get further initial points.
const MULTIPLES: [(i64, i64); 11] =
    [(3, 4), (1, 2), (5, 4), (3, 2), (7, 8), (9, 8), (2, 1), (1, 4), (-1, 2), (-3, 4), (-1, 1)];
/// Rows of parameter values that are tried in order. A row is repeated for further parameters.
const VALUES: [&[(i64, i64)]; 4] = [
    &[(1, 1)],
    &[(1, 1), (1, 2), (1, 3), (2, 3), (1, 4)],
    &[(1, 1), (-2, 1), (1, 2), (-1, 3)],
    &[(1, 5), (3, 5), (2, 5), (4, 5)],
];

/// Chooses a scene for a picture. Costs some dozens of orbits of four thousand steps.
pub(crate) fn scene(study: &Study) -> Result<Value, StudyError> {
    let (values, study, shown) = with_values(study)?;
    let mut stay: Vec<ShownOrbit> = Vec::new();
    if shown.stays {
        stay.push(shown.clone());
        for start in starts(&shown.start) {
            // A function of a lift may be undefined at this initial point.
            let Ok(orbit) = study.shown_orbit(Some(&shown.eps), Some(&start)) else { continue };
            if orbit.stays && orbit.eps == shown.eps {
                stay.push(orbit);
            }
        }
    }
    let (axes, mut chosen) = plane(&stay, study.coordinates().len());
    if chosen.is_empty() {
        chosen =
            std::iter::once(shown.start.clone()).chain(starts(&shown.start).into_iter().take(2)).collect();
    }
    // If the text itself gives an initial point, this point comes first.
    if let Some(own) = study.start() {
        chosen.retain(|start| *start != own);
        chosen.insert(0, own);
        chosen.truncate(ORBITS);
    }
    let at: Vec<String> = chosen.iter().map(|start| joined(start)).collect();
    let axes: Vec<&String> = axes.iter().filter_map(|&k| study.coordinates().get(k)).collect();
    Ok(json!({"eps": shown.eps.to_string(), "at": at, "axes": axes, "values": values, "stays": shown.stays}))
}

fn joined(point: &[Rational]) -> String {
    point.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")
}

/// Chooses the missing parameter values, and returns the study and an orbit at these values.
/// Prefers the first values with a bounded orbit.
fn with_values(study: &Study) -> Result<(Map<String, Value>, Study, ShownOrbit), StudyError> {
    let valued = study.valued();
    let missing = study.parameters().iter().zip(valued).filter(|(_, value)| value.is_none());
    let missing: Vec<&String> = missing.map(|(name, _)| name).collect();
    let mut first = None;
    for values in VALUES {
        let values: Vec<(String, Rational)> = missing
            .iter()
            .zip(values.iter().cycle())
            .map(|(&name, &(above, below))| (name.clone(), Rational::new(above, below)))
            .collect();
        let given = study.parameters().iter().zip(study.given());
        let given = given.filter_map(|(name, value)| Some((name.clone(), value.clone()?)));
        let own = study.given_by_name(&given.chain(values.iter().cloned()).collect::<Vec<_>>())?;
        let shown = first_orbit(&own)?;
        let stays = shown.stays;
        let named = values.into_iter().map(|(name, value)| (name, Value::String(value.to_string())));
        let scene = (named.collect(), own, shown);
        if stays || missing.is_empty() {
            return Ok(scene);
        }
        first.get_or_insert(scene);
    }
    Ok(first.expect("some values were tried"))
}

/// The coordinates of the first initial point that is tried, repeated for further variables.
const UNITS: [(i64, i64); 6] = [(1, 1), (1, 2), (1, 3), (2, 3), (1, 4), (3, 4)];

/// Returns the orbit from the initial point in the text. Without one, the coordinates in [`UNITS`]
/// are tried; if that orbit is too small or too large, the library chooses a start.
fn first_orbit(study: &Study) -> Result<ShownOrbit, StudyError> {
    if let Some(own) = study.start().or_else(|| study.lift_start()) {
        return study.shown_orbit(None, Some(&own));
    }
    let count = study.coordinates().len();
    let near = UNITS.iter().cycle().take(count).map(|&(above, below)| Rational::new(above, below));
    let near = study.shown_orbit(None, Some(&near.collect::<Vec<_>>()));
    let is_wide = |orbit: &ShownOrbit| {
        let wide = orbit.extremes.iter().filter(|[low, high]| high - low > 0.2 && high - low < 50.0);
        orbit.stays && wide.count() >= count.min(2)
    };
    match near {
        Ok(orbit) if is_wide(&orbit) => Ok(orbit),
        _ => study.shown_orbit(None, None),
    }
}

/// Returns further initial points: multiples of `start`, and points with one coordinate changed.
fn starts(start: &[Rational]) -> Vec<Vec<Rational>> {
    let multiples = MULTIPLES.iter().map(|&(above, below)| {
        let times = Rational::new(above, below);
        start.iter().map(|value| value * &times).collect()
    });
    let changed = (0..start.len()).flat_map(|k| {
        [Rational::new(3, 2), Rational::new(1, 2)].map(|times| {
            let mut start = start.to_vec();
            start[k] = &start[k] * &times;
            start
        })
    });
    multiples.chain(changed).collect()
}

/// Returns the two variables in which most orbits are wide, and the initial points of these orbits.
fn plane(orbits: &[ShownOrbit], variables: usize) -> (Vec<usize>, Vec<Vec<Rational>>) {
    if variables < 2 {
        return (Vec::new(), wide(orbits, &[0]));
    }
    let pairs = (0..variables).flat_map(|i| (i + 1..variables).map(move |j| [i, j]));
    let mut best = (vec![0, 1], Vec::new());
    for pair in pairs {
        let found = wide(orbits, &pair);
        if found.len() > best.1.len() {
            best = (pair.to_vec(), found);
        }
    }
    best
}

/// Chooses at most [`ORBITS`] orbits, and returns their initial points. The box around each chosen
/// orbit fills at least the fraction [`SHARE`] of the box around all chosen orbits.
fn wide(orbits: &[ShownOrbit], axes: &[usize]) -> Vec<Vec<Rational>> {
    let boxes: Vec<Vec<[f64; 2]>> =
        orbits.iter().map(|orbit| axes.iter().map(|&k| orbit.extremes[k]).collect()).collect();
    let area = |sides: &[[f64; 2]]| sides.iter().map(|[low, high]| high - low).product::<f64>();
    let around = |one: &[[f64; 2]], other: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let sides = one.iter().zip(other);
        sides.map(|(one, other)| [one[0].min(other[0]), one[1].max(other[1])]).collect()
    };
    let mut best: Vec<usize> = Vec::new();
    for first in 0..boxes.len() {
        let (mut chosen, mut whole) = (vec![first], boxes[first].clone());
        for (k, sides) in boxes.iter().enumerate() {
            let larger = around(&whole, sides);
            let least = chosen.iter().map(|&k| area(&boxes[k])).fold(area(sides), f64::min);
            if k != first && chosen.len() < ORBITS && least > 0.0 && least >= SHARE * area(&larger) {
                chosen.push(k);
                whole = larger;
            }
        }
        if chosen.len() > best.len() {
            best = chosen;
        }
    }
    best.into_iter().map(|k| orbits[k].start.clone()).collect()
}
