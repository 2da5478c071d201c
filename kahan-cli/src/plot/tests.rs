//! Places, and what is read out.

use super::{Mark, NumberLine, Plot, SIZE, Series, polyline};

#[test]
fn points_are_placed_by_both_axes_and_repeated_places_are_dropped() {
    let axis = |low, high| NumberLine { label: String::new(), low, high };
    let plot = Plot {
        description: String::new(),
        size: SIZE,
        x: axis(0.0, 10.0),
        y: axis(-1.0, 1.0),
        levels: Vec::new(),
        series: Vec::new(),
    };
    assert_eq!(plot.place((0.0, -1.0)), (66.0, 270.0));
    assert_eq!(plot.place((10.0, 1.0)), (462.0, 16.0));
    assert_eq!(polyline(&[(1.0, 2.0), (1.01, 2.04), (3.25, 4.0)]), "M1 2L3.2 4");
}

#[test]
fn a_description_and_labels_are_escaped() {
    let axis = NumberLine::around("a < b", [0.0, 1.0].into_iter());
    let series = Series::new("\"x\" & y", 1, Mark::Both, vec![(0.0, 0.0), (1.0, 1.0)]);
    let plot = Plot {
        description: "x<y".into(),
        size: SIZE,
        x: axis.clone(),
        y: axis,
        levels: vec![(0.5, "1<2".into())],
        series: vec![series],
    };
    let svg = plot.svg().into_string();
    assert!(svg.contains("aria-label=\"x&lt;y\"") && svg.contains("a &lt; b") && svg.contains("1&lt;2"));
    assert!(svg.contains("&quot;x&quot; &amp; y"), "{svg}");
}
