//! Places, and what is read out.

use super::{Cloud, Mark, NumberLine, Plot, Series, Sheet, Space, Theme};

#[test]
fn points_are_placed_by_both_axes() {
    let axis = |low, high| NumberLine { label: String::new(), low, high };
    let plot = Plot {
        description: String::new(),
        sheet: Sheet::page(480, 320),
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
        sheet: Sheet::page(480, 320),
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

/// A line or a cloud along y, away from the eye.
fn receding(mark: Mark) -> String {
    let axis = |label: &str| NumberLine { label: label.to_owned(), low: -1.0, high: 1.0 };
    let points = (0..=200).map(|i| [0.0, f64::from(i) / 100.0 - 1.0, 0.0]).collect();
    let axes = ["x", "y", "z"].map(axis);
    let space = Space {
        description: "a < b".to_owned(),
        sheet: Sheet::page(480, 320),
        axes,
        clouds: vec![Cloud { colour: 2, mark, points }],
    };
    space.drawing().inline().into_string()
}

/// The shapes of a class with their widths, in the order in which they are drawn.
fn shapes(svg: &str, class: &str) -> Vec<(String, f64)> {
    let opening = format!("class=\"{class}\" d=\"");
    let parts = svg.split(&opening).skip(1);
    let attribute = |part: &str, name: &str| {
        let (_, value) = part.split_once(name).expect("the attribute");
        value.split('"').next().expect("its end").to_owned()
    };
    parts
        .map(|part| {
            let width = attribute(part, "stroke-width=\"").parse().expect("a number");
            (part.split('"').next().expect("its end").to_owned(), width)
        })
        .collect()
}

#[test]
fn near_points_of_space_are_drawn_over_far_ones_and_no_width_jumps() {
    for (mark, class) in
        [(Mark::Dots, "dots"), (Mark::Points, "dots"), (Mark::Fine, "dots"), (Mark::Line, "line")]
    {
        let shapes = shapes(&receding(mark), class);
        assert!(shapes.len() > 10, "{mark:?}: {shapes:?}");
        for pair in shapes.windows(2) {
            // From the back to the front, by less than a tenth of a unit, which nobody sees.
            let grows = pair[1].1 - pair[0].1;
            assert!((0.0..=0.1001).contains(&grows), "{mark:?}: {pair:?}");
        }
        assert!(shapes[0].1 < 0.9 * shapes[shapes.len() - 1].1, "{mark:?}: {shapes:?}");
        assert!(!receding(mark).contains("opacity"));
    }
    let dots: usize =
        shapes(&receding(Mark::Dots), "dots").iter().map(|(path, _)| path.matches('h').count()).sum();
    assert_eq!(dots, 201);
}

#[test]
fn a_line_in_space_has_no_gaps() {
    let shapes = shapes(&receding(Mark::Line), "line");
    let ends = |path: &str| {
        let places: Vec<String> = path.split(['M', 'L']).skip(1).map(str::to_owned).collect();
        (places[0].clone(), places[places.len() - 1].clone())
    };
    // The line goes to the back, where drawing begins.
    for pair in shapes.windows(2) {
        assert_eq!(ends(&pair[0].0).0, ends(&pair[1].0).1, "{pair:?}");
    }
}

#[test]
fn axes_have_four_to_seven_values_where_there_is_room() {
    let count = |svg: &str| {
        svg.split("class=\"ticks\"")
            .nth(1)
            .and_then(|part| part.split("</g>").next())
            .expect("ticks")
            .matches("<text")
            .count()
    };
    for (width, height, least) in [(480, 320, 8), (360, 300, 8), (1040, 260, 8), (480, 1900, 8)] {
        for (low, high) in
            [(0.0, 1.0), (-3.2, 7.9), (0.0, 812_345.0), (1.59, 1.64), (-1e-9, 1e-9), (-0.013, 22.4)]
        {
            let axis = || NumberLine { label: "x".to_owned(), low, high };
            let plot = Plot {
                sheet: Sheet::page(width, height),
                x: axis(),
                y: axis(),
                ..Plot::around("", ["x", "y"], Vec::new())
            };
            let ticks = count(&plot.drawing().inline().into_string());
            assert!((least..=14).contains(&ticks), "{width}x{height}, {low}..{high}: {ticks}");
        }
    }
    let svg = receding(Mark::Dots);
    assert!((12..=21).contains(&count(&svg)), "{svg}");
}

#[test]
fn a_file_has_its_own_style_and_what_is_read_out() {
    let plot = Plot::around("one point", ["x", "y"], vec![Series::new("", 1, Mark::Dots, vec![(1.0, 1.0)])]);
    let on = |pixels, theme| Plot { sheet: Sheet::new(pixels, theme), ..plot.clone() }.drawing().svg();
    assert_eq!(Sheet::new((900, 600), Theme::Viewer).view_box, (480.0, 320.0));
    let svg = on((900, 600), Theme::Viewer);
    for part in
        ["width=\"900\"", "aria-label=\"one point\"", "prefers-color-scheme:dark", "stroke=\"#1f76bf\""]
    {
        assert!(svg.contains(part), "{part}: {svg}");
    }
    let dark = on((900, 600), Theme::Dark);
    assert!(dark.contains("stroke=\"#2d8cb5\"") && dark.contains("fill=\"#14171b\""), "{dark}");
    assert!(["prefers-color-scheme", "var(", "#1f76bf"].iter().all(|word| !dark.contains(word)), "{dark}");
    // A flat sheet is widened until there is room for both axes.
    assert_eq!(Sheet::new((4000, 1000), Theme::Dark).view_box, (1040.0, 260.0));
}

#[test]
fn in_print_a_column_is_black_on_white_and_its_text_has_a_size_on_paper() {
    let plot = Plot::around("one", ["x", "y"], vec![Series::new("", 1, Mark::Line, vec![(1.0, 1.0); 2])]);
    let plot = Plot { sheet: Sheet::new(Sheet::COLUMN, Theme::Paper), ..plot };
    let svg = plot.drawing().svg();
    assert!(svg.contains("width=\"86.02mm\"") && !svg.contains("<style"), "{svg}");
    // 12 units of 0.01 inch are 8.6 points.
    assert!((plot.sheet.view_box.0 - 338.67).abs() < 0.01 && svg.contains("font-size=\"12\""), "{svg}");
    assert!(svg.contains("fill=\"#ffffff\"") && svg.contains("stroke-width=\"1.2\""), "{svg}");
    let inked = svg.split("class=\"ticks\" fill=\"").nth(1).expect("ticks");
    assert!(inked.starts_with("#000000"), "{inked}");
}

#[test]
fn labels_that_would_cover_each_other_stand_below_each_other() {
    let series = ["x", "y", "z"].map(|name| Series::new(name, 1, Mark::Line, vec![(0.0, 0.0), (1.0, 1.0)]));
    let plot = Plot::around("", ["n", "h"], series.to_vec());
    let heights: Vec<f64> = plot.labels().iter().map(|(_, (_, y), ..)| *y).collect();
    assert!(heights.windows(2).all(|pair| pair[1] >= pair[0] + 16.0), "{heights:?}");
    assert!(heights[0] > 0.0);
}
