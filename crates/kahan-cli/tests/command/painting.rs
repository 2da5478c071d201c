//! Checks that every drawn element of an SVG has or inherits a colour.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

pub(crate) fn drawings(text: &str) -> Vec<&str> {
    let parts = text.match_indices("<svg").map(|(start, _)| &text[start..]);
    parts
        .map(|part| part.split_once("</svg>").map_or(part, |(svg, _)| &part[..svg.len() + "</svg>".len()]))
        .collect()
}

/// The inherited values of `fill` and `stroke`.
#[derive(Clone, Default)]
struct Paint {
    fill: Option<String>,
    stroke: Option<String>,
}

impl Paint {
    fn of(&self, element: &BytesStart<'_>) -> Self {
        let mut paint = self.clone();
        for attribute in element.attributes() {
            let attribute = attribute.expect("an attribute");
            let value = attribute.value.to_string();
            assert!(!value.contains("var("), "{element:?}");
            match attribute.key.as_ref() {
                "fill" => paint.fill = Some(value),
                "stroke" => paint.stroke = Some(value),
                _ => {}
            }
        }
        paint
    }

    fn is_seen(&self) -> bool {
        [&self.fill, &self.stroke].into_iter().flatten().any(|value| is_colour(value))
    }
}

fn is_colour(value: &str) -> bool {
    let is_code = value.strip_prefix('#').is_some_and(|code| code.chars().all(|c| c.is_ascii_hexdigit()));
    is_code || ["white", "black"].contains(&value)
}

/// Checks a drawing. Returns the number of drawn elements.
pub(crate) fn painted(svg: &str) -> usize {
    let mut reader = Reader::from_str(svg);
    let (mut around, mut count) = (vec![Paint::default()], 0);
    let mut look = |element: &BytesStart<'_>, paint: &Paint| {
        if ["line", "path", "text", "rect", "circle", "polygon", "polyline"]
            .contains(&element.name().as_ref())
        {
            count += 1;
            assert!(paint.is_seen(), "{element:?} has no plain colour");
            // Elements without `fill` are black. All but lines must set or inherit another colour.
            let is_said = paint.fill.is_some() || element.name().as_ref() == "line";
            assert!(is_said, "{element:?} is filled with black");
        }
    };
    loop {
        match reader.read_event().expect("well-formed XML") {
            Event::Start(element) => {
                let paint = around.last().expect("a root").of(&element);
                look(&element, &paint);
                around.push(paint);
            }
            Event::Empty(element) => look(&element, &around.last().expect("a root").of(&element)),
            Event::End(_) => {
                around.pop();
            }
            Event::Text(text) => {
                assert!(!text.contains("var("), "a style that not every program knows");
            }
            Event::Eof => return count,
            _ => {}
        }
    }
}
