//! Tests positions, labels and descriptions in drawings.

use kahan_algebra::prime_field::SplitMix64;

use super::label::width;
use super::{
    Canvas, Drawing, Frame, Grid, Mark, NumberLine, Plot, Series, SpacePlot, SpaceSeries, Theme, TickKind,
};

#[test]
fn a_description_and_labels_are_escaped() {
    let axis = NumberLine::around("one < two", [0.0, 1.0].into_iter());
    let series = Series::new("\"one\" & two", 1, Mark::Both, vec![(0.0, 0.0), (1.0, 1.0)]);
    let plot = Plot {
        description: "x<y".into(),
        sheet: Canvas::page(480, 320),
        x: axis.clone(),
        y: axis,
        series: vec![series],
        note: "1<2".into(),
    };
    let svg = plot.drawing().inline().into_string();
    assert!(svg.contains("aria-label=\"x&lt;y\"") && svg.contains("one &lt; two") && svg.contains("1&lt;2"));
    assert!(svg.contains("&quot;one&quot; &amp; two"), "{svg}");
}

#[test]
fn what_the_axes_do_not_show_is_left_out_and_lines_end_at_the_frame() {
    let axis = |low, high| NumberLine::new("x", low, high);
    let points = vec![(1.0, 1.0), (2.0, 2.0), (99.0, 1.0), (3.0, f64::NAN), (4.0, 4.0), (5.0, 5.0)];
    let series = Series::new("", 1, Mark::Line, points);
    let plot = Plot { x: axis(0.0, 10.0), y: axis(0.0, 10.0), ..Plot::around("", ["x", "y"], vec![series]) };
    assert_eq!(plot.outside(), 2);
    let svg = plot.drawing().inline().into_string();
    let (_, path) = svg.split_once(" d=\"").expect("a path");
    let path = path.split('"').next().expect("its end");
    assert_eq!((path.matches('M').count(), path.matches('L').count()), (2, 3), "{path}");
    assert!(path.contains("L466 "), "{path}");
}

fn receding(mark: Mark) -> String {
    let axis = |label: &str| NumberLine::new(label, -1.0, 1.0);
    let points = (0..=200).map(|i| [0.0, f64::from(i) / 100.0 - 1.0, 0.0]).collect();
    let axes = ["x", "y", "z"].map(axis);
    let space = SpacePlot {
        description: "a < b".to_owned(),
        sheet: Canvas::page(480, 320),
        axes,
        clouds: vec![SpaceSeries { colour: 2, mark, points }],
    };
    space.drawing().inline().into_string()
}

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
        let places: Vec<String> =
            path.trim_end_matches("h.01").split(['M', 'L']).skip(1).map(str::to_owned).collect();
        (places[0].clone(), places[places.len() - 1].clone())
    };
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
            let axis = || NumberLine::new("x", low, high);
            let plot = Plot {
                sheet: Canvas::page(width, height),
                x: axis(),
                y: axis(),
                ..Plot::around("", ["x", "y"], Vec::new())
            };
            let ticks = count(&plot.drawing().inline().into_string());
            assert!((least..=14).contains(&ticks), "{width}x{height}, {low}..{high}: {ticks}");
        }
    }
    let svg = receding(Mark::Dots);
    assert!((11..=21).contains(&count(&svg)), "{svg}");
}

#[test]
fn a_file_has_its_own_style_and_what_is_read_out() {
    let plot = Plot::around("one point", ["x", "y"], vec![Series::new("", 1, Mark::Dots, vec![(1.0, 1.0)])]);
    let on = |pixels, theme| Plot { sheet: Canvas::new(pixels, theme), ..plot.clone() }.drawing().svg();
    assert_eq!(Canvas::new((900, 600), Theme::Viewer).view_box, (480.0, 320.0));
    let svg = on((900, 600), Theme::Viewer);
    for part in
        ["width=\"900\"", "aria-label=\"one point\"", "prefers-color-scheme:dark", "stroke=\"#435bc6\""]
    {
        assert!(svg.contains(part), "{part}: {svg}");
    }
    let dark = on((900, 600), Theme::Dark);
    assert!(dark.contains("stroke=\"#2d8bb9\"") && dark.contains("fill=\"#14171b\""), "{dark}");
    assert!(["prefers-color-scheme", "var(", "#435bc6"].iter().all(|word| !dark.contains(word)), "{dark}");
    assert_eq!(Canvas::new((4000, 1000), Theme::Dark).view_box, (1040.0, 260.0));
}

#[test]
fn in_print_a_column_is_black_on_white_and_its_text_has_a_size_on_paper() {
    let plot = Plot::around("one", ["x", "y"], vec![Series::new("", 1, Mark::Line, vec![(1.0, 1.0); 2])]);
    let plot = Plot { sheet: Canvas::new(Canvas::COLUMN, Theme::Paper), ..plot };
    let svg = plot.drawing().svg();
    assert!(svg.contains("width=\"86.02mm\"") && !svg.contains("<style"), "{svg}");
    // A unit of the drawing is 0.01 inch: 86.02 mm are 338.67 units, and 12 units are 8.6 points.
    assert!((plot.sheet.view_box.0 - 338.67).abs() < 0.01 && svg.contains("font-size=\"12\""), "{svg}");
    assert!(svg.contains("fill=\"#ffffff\"") && svg.contains("stroke-width=\"1.2\""), "{svg}");
    let inked = svg.split("class=\"ticks\" fill=\"").nth(1).expect("ticks");
    assert!(inked.starts_with("#000000"), "{inked}");
}

type Box = [f64; 4];

fn words(svg: &str) -> Vec<(String, Box)> {
    let element = |part: &str| {
        let (attributes, rest) = part.split_once('>').expect("the end of a tag");
        let of = |name: &str| {
            let (_, value) = attributes.split_once(&format!(" {name}=\""))?;
            value.split('"').next().map(str::to_owned)
        };
        let number = |name: &str| of(name).expect(name).parse::<f64>().expect("a number");
        let inner = rest.split("</text>").next().expect("its end");
        let (mut shown, mut long) = (String::new(), 0.0);
        let (x, y, size) = (number("x"), number("y"), number("font-size"));
        for part in inner.split('<') {
            let (own, words) = part.rsplit_once('>').unwrap_or(("", part));
            let own =
                own.split_once("font-size=\"").and_then(|(_, size)| size.split('"').next()?.parse().ok());
            long += width(words, own.unwrap_or(size));
            shown += words;
        }
        let left = match of("text-anchor").as_deref() {
            Some("middle") => x - long / 2.0,
            Some("end") => x - long,
            _ => x,
        };
        let flat = [left, y - 0.75 * size, left + long, y + 0.2 * size];
        let Some(turned) = of("transform") else { return (shown, flat) };
        let numbers: Vec<f64> = turned.split([' ', '(', ')']).filter_map(|part| part.parse().ok()).collect();
        let [x, y, turn] = numbers[..] else { panic!("a place and a turn: {turned}") };
        let [from, to] = [flat[0], flat[2]].map(|along| y + turn.signum() * along);
        let [above, below] = [flat[1], flat[3]].map(|across| x - turn.signum() * across);
        (shown, [above.min(below), from.min(to), above.max(below), from.max(to)])
    };
    svg.split("<text").skip(1).map(element).collect()
}

/// Asserts that labels lie on the canvas without overlap, and are at least six points high in
/// print.
fn has_room(drawing: &Drawing) {
    let svg = drawing.svg();
    let (across, upwards) = drawing.sheet.view_box;
    let words = words(&svg);
    for (i, (one, a)) in words.iter().enumerate() {
        assert!(
            a[0] >= 0.0 && a[1] >= 0.0 && a[2] <= across && a[3] <= upwards,
            "{one} at {a:?} leaves {svg}"
        );
        for (other, b) in &words[i + 1..] {
            let is_apart = (0..2).any(|i| a[i + 2] <= b[i] || b[i + 2] <= a[i]);
            assert!(is_apart, "{one} at {a:?} lies on {other} at {b:?}: {svg}");
        }
    }
    let sizes = svg.split("font-size=\"").skip(1);
    for size in sizes.map(|part| part.split('"').next().and_then(|size| size.parse::<f64>().ok())) {
        assert!(size.is_some_and(|size| 0.72 * size >= 6.0), "{size:?} hundredths of an inch: {svg}");
    }
}

#[test]
fn no_words_lie_on_others_or_leave_the_sheet() {
    const NAMES: [&str; 8] = [
        "x",
        "x₁₂",
        "ε",
        "t",
        "relative drift of integrals",
        "largest exponent per unit of t",
        "a_name_that_is_longer_than_any_side_of_a_small_picture",
        "W",
    ];
    const SHEETS: [(u32, u32); 7] =
        [(1016, 762), (700, 525), (960, 720), (720, 480), (2100, 900), (600, 600), (500, 1000)];
    let mut random = SplitMix64::new(11);
    for _ in 0..500 {
        let mut below = |count: usize| random.below(count as u64) as usize;
        let theme = [Theme::Paper, Theme::Viewer][below(2)];
        let sheet = Canvas::new(SHEETS[below(SHEETS.len())], theme);
        let mut line = || {
            let length = 10_f64.powi(below(30) as i32 - 15) * (1.0 + below(90) as f64 / 10.0);
            let low =
                [0.0, -0.3 * length, -2.0 * length, 1e3 * length, -1e7 * length, 1e11 * length][below(6)];
            let marks = [TickKind::Round, TickKind::Round, TickKind::Whole, TickKind::Powers][below(4)];
            let (low, length) = if marks == TickKind::Round {
                (low, length)
            } else {
                (below(20) as f64 - 18.2, 0.7 + below(30) as f64)
            };
            NumberLine { marks, ..NumberLine::new(NAMES[below(NAMES.len())], low, low + length) }
        };
        let [x, y, z] = [line(), line(), line()];
        let labels = below(8);
        let label =
            |i: usize| ["order 2", "order 8, dd", "other scalars, compensated", "x₁", NAMES[6]][i % 5];
        let series = (0..labels).map(|i| Series::new(label(i), i % 5 + 1, Mark::Both, Vec::new()));
        let note = ["", "not shown: 12 with errors above 10"][below(2)].to_owned();
        let plot = Plot { description: String::new(), sheet, x, y, series: series.collect(), note };
        has_room(&plot.drawing());
        let Plot { x, y, note, .. } = plot;
        if below(16) == 0 {
            let values = vec![z.low, z.high];
            let grid = Grid {
                description: String::new(),
                sheet,
                x: x.clone(),
                y: y.clone(),
                scale: z.clone(),
                columns: 2,
                values,
                note,
            };
            has_room(&grid.drawing());
        }
        has_room(
            &SpacePlot { description: String::new(), sheet, axes: [x, y, z], clouds: Vec::new() }.drawing(),
        );
    }
}

#[test]
fn points_are_placed_by_both_axes_within_the_room_that_words_leave() {
    let (x, y) = (NumberLine::new("x", 0.0, 10.0), NumberLine::new("y", -1.0, 1.0));
    let frame = Frame::around(Canvas::page(480, 320), 0.0, 0.0, &x, &y);
    assert_eq!(frame.place(&x, &y, (0.0, -1.0)), (frame.left, frame.bottom));
    assert_eq!(frame.place(&x, &y, (10.0, 1.0)), (frame.right, frame.top));
    let wide = NumberLine::new("y", -1000.0, 1000.0);
    assert!(Frame::around(frame.sheet, 20.0, 90.0, &x, &wide).left > frame.left + 10.0);
}
