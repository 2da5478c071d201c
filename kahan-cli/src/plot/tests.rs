//! Places, and what is read out.

use super::{Cloud, Mark, NumberLine, Plot, SIZE, Series, Sheet, Space, Theme};

#[test]
fn points_are_placed_by_both_axes() {
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
    let svg = plot.drawing().inline().into_string();
    assert!(svg.contains("aria-label=\"x&lt;y\"") && svg.contains("a &lt; b") && svg.contains("1&lt;2"));
    assert!(svg.contains("&quot;x&quot; &amp; y"), "{svg}");
}

#[test]
fn what_the_axes_do_not_show_is_left_out_and_no_line_leads_there() {
    let axis = |low, high| NumberLine { label: "x".to_owned(), low, high };
    let points = vec![(1.0, 1.0), (2.0, 2.0), (99.0, 1.0), (3.0, f64::NAN), (4.0, 4.0), (5.0, 5.0)];
    let series = Series::new("", 1, Mark::Line, points);
    let plot = Plot { x: axis(0.0, 10.0), y: axis(0.0, 10.0), ..Plot::around("", ["x", "y"], vec![series]) };
    assert_eq!(plot.outside(), 2);
    let svg = plot.drawing().inline().into_string();
    let (_, path) = svg.split_once(" d=\"").expect("a path");
    let path = path.split('"').next().expect("its end");
    assert_eq!((path.matches('M').count(), path.matches('L').count()), (2, 2), "{path}");
}

#[test]
fn near_points_of_space_are_drawn_over_far_ones_and_lines_have_no_gaps() {
    let axis = |label: &str| NumberLine { label: label.to_owned(), low: -1.0, high: 1.0 };
    // Along y, away from the eye.
    let points: Vec<[f64; 3]> = (0..=20).map(|i| [0.0, f64::from(i) / 10.0 - 1.0, 0.0]).collect();
    let space = |mark| Space {
        description: "a < b".to_owned(),
        size: SIZE,
        axes: ["x", "y", "z"].map(axis),
        clouds: vec![Cloud { colour: 2, mark, points: points.clone() }],
    };
    let drawn = |mark| space(mark).drawing().inline().into_string();
    let part = |svg: &str, class: &str| {
        let (_, path) = svg.split_once(&format!("class=\"{class}\" d=\"")).expect("a layer");
        path.split('"').next().expect("its end").to_owned()
    };
    let svg = drawn(Mark::Dots);
    let layers =
        ["dots far", "dots between", "dots near"].map(|class| part(&svg, class).matches("h0").count());
    assert!(layers.iter().all(|count| *count >= 3), "{layers:?}");
    assert_eq!(layers.iter().sum::<usize>(), points.len());
    assert!(svg.find("dots far") < svg.find("dots near"));
    let svg = drawn(Mark::Line);
    let ends = |class| {
        let path = part(&svg, class);
        let places: Vec<String> = path.split(['M', 'L']).skip(1).map(str::to_owned).collect();
        (places[0].clone(), places[places.len() - 1].clone())
    };
    let (near, between, far) = (ends("line near"), ends("line between"), ends("line far"));
    assert_eq!((near.1, between.1), (between.0, far.0));
}

#[test]
fn a_file_has_its_own_style_and_what_is_read_out() {
    let plot = Plot::around("one point", ["x", "y"], vec![Series::new("", 1, Mark::Dots, vec![(1.0, 1.0)])]);
    let sheet = Sheet { pixels: (900, 600), theme: Theme::Viewer };
    assert_eq!(sheet.view_box(), (480.0, 320.0));
    let svg = plot.drawing().svg(&sheet);
    for part in ["width=\"900\"", "aria-label=\"one point\"", "prefers-color-scheme:dark", "var(--c1)"] {
        assert!(svg.contains(part), "{part}: {svg}");
    }
    let dark = plot.drawing().svg(&Sheet { theme: Theme::Dark, ..sheet });
    assert!(!dark.contains("prefers-color-scheme") && !dark.contains("var("), "{dark}");
    // A flat sheet is widened until there is room for both axes.
    assert_eq!(Sheet { pixels: (4000, 1000), ..sheet }.view_box(), (1040.0, 260.0));
}

#[test]
fn labels_that_would_cover_each_other_stand_below_each_other() {
    let series = ["x", "y", "z"].map(|name| Series::new(name, 1, Mark::Line, vec![(0.0, 0.0), (1.0, 1.0)]));
    let plot = Plot::around("", ["n", "h"], series.to_vec());
    let heights: Vec<f64> = plot.labels().iter().map(|(_, (_, y), ..)| *y).collect();
    assert!(heights.windows(2).all(|pair| pair[1] >= pair[0] + 16.0), "{heights:?}");
    assert!(heights[0] > 0.0);
}
