//! A grid of numbers drawn in colours, with a colour bar.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};

use super::label::{SMALL_FONT_SIZE, text, width};
use super::legend::Legend;
use super::palette::Paint;
use super::path::{line, tenths};
use super::ramp::{Rgb, colour};
use super::{Canvas, Drawing, Frame, NumberLine, name, placed_labels};

/// A number for each cell of a rectangle.
#[derive(Clone, Debug)]
pub struct Grid {
    /// The description for screen readers.
    pub description: String,
    /// The canvas to draw on.
    pub sheet: Canvas,
    /// The horizontal axis. The axis ends at the edges of the outermost cells.
    pub x: NumberLine,
    /// The vertical axis. The axis ends at the edges of the outermost cells.
    pub y: NumberLine,
    /// The axis of the colour bar. Numbers beyond an end have the colour of the end.
    pub scale: NumberLine,
    /// The number of cells in a row.
    pub columns: usize,
    /// The numbers, row by row from below. Cells with NaN are empty.
    pub values: Vec<f64>,
    /// A note above the grid. An empty note is omitted.
    pub note: String,
}

/// The number of colours in the palette. A cell with the index `COLOURS` is transparent.
const COLOURS: usize = 255;
const COLUMN: [f64; 2] = [12.0, 26.0];
const NAME: f64 = 28.0;

impl Grid {
    /// Draws the grid. Panics if `values` cannot be split into rows of `columns` numbers.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let rows = self.values.len().checked_div(self.columns).unwrap_or(0);
        let (numbers, columns) = (self.values.len(), self.columns);
        assert!(rows > 0 && rows * columns == numbers, "{numbers} numbers are no rows of {columns} cells");
        // Numbers begin at the lower left, but images begin at the upper left.
        let cells: Vec<u8> = self.values.chunks(columns).rev().flatten().map(|v| self.index(*v)).collect();
        let note = Legend::of(&[], &self.note, self.sheet);
        let frame = |beside: f64| Frame::around(self.sheet, note.height(), beside, &self.x, &self.y);
        let values = frame(0.0).y_labels(&self.scale);
        let widest = values.iter().map(|(_, value)| width(value, SMALL_FONT_SIZE)).fold(0.0, f64::max);
        let frame = frame(COLUMN[1] + 7.0 + widest + NAME);
        let Frame { left, right, top, bottom, .. } = frame;
        let body = html! {
            (frame.grid_lines(&self.x, &self.y))
            (image([left, top, right, bottom], (columns, rows), &cells))
            (frame.axes(&self.x, &self.y))
            (self.colours(&frame))
            (note.drawn())
        };
        Drawing { description: self.description.clone(), sheet: self.sheet, body }
    }

    fn index(&self, value: f64) -> u8 {
        if value.is_nan() {
            return COLOURS as u8;
        }
        let part = self.scale.place(value, 0.0, 1.0).clamp(0.0, 1.0);
        (part * (COLOURS - 1) as f64).round() as u8
    }

    fn colours(&self, frame: &Frame) -> Markup {
        let [left, right] = COLUMN.map(|beside| frame.right + beside);
        let colours: Vec<u8> = (0..COLOURS as u8).rev().collect();
        let ticks =
            placed_labels(&self.scale, |value| (right, self.scale.place(value, frame.bottom, frame.top)));
        let marks = html! { @for ((_, y), _) in &ticks { (line((right, *y), (right + 4.0, *y))) } };
        let values = html! { @for ((_, y), value) in &ticks { (text((right + 7.0, y + 4.2), 0, "start", SMALL_FONT_SIZE, value)) } };
        let beside = (self.sheet.view_box.0 - 16.0, (frame.top + frame.bottom) / 2.0);
        html! {
            (image([left, frame.top, right, frame.bottom], (1, COLOURS), &colours))
            (Paint::AXES.group(self.sheet.theme, &marks))
            (Paint::TICKS.group(self.sheet.theme, &values))
            (name(self.sheet.theme, frame.height(), beside, 90, &self.scale.name()))
        }
    }
}

/// Draws cells from the upper left as an image. Cells are enlarged so that the image has about 1024
/// pixels a side, because some programs blur images that they enlarge.
fn image([left, top, right, bottom]: [f64; 4], (columns, rows): (usize, usize), cells: &[u8]) -> Markup {
    const SIDE: usize = 1024;

    let (across, upwards) = (SIDE.div_ceil(columns), SIDE.div_ceil(rows));
    let row = |cells: &[u8]| cells.iter().map(|cell| vec![*cell; across]).collect::<Vec<_>>().concat();
    let pixels = cells.chunks(columns).map(|cells| row(cells).repeat(upwards)).collect::<Vec<_>>().concat();
    let png = png(across * columns, upwards * rows, &pixels)
        .expect("there are cells, and memory takes what is written");
    // Inkscape reads only `xlink:href`, the old name of `href`.
    html! {
        image x=(tenths(left)) y=(tenths(top)) width=(tenths(right - left)) height=(tenths(bottom - top))
            preserveAspectRatio="none" style="image-rendering:pixelated"
            xlink:href=(format!("data:image/png;base64,{}", STANDARD.encode(png))) {}
    }
}

fn png(columns: usize, rows: usize, cells: &[u8]) -> Result<Vec<u8>, png::EncodingError> {
    let palette = (0..COLOURS).flat_map(|i| colour(i as f64 / (COLOURS - 1) as f64));
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, columns as u32, rows as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    // Rows are repeated to enlarge cells, so most differences from the row above are zero.
    encoder.set_filter(png::Filter::Up);
    encoder.set_palette(palette.chain(Rgb::default()).collect::<Vec<u8>>());
    encoder.set_trns([vec![255; COLOURS], vec![0]].concat());
    let mut writer = encoder.write_header()?;
    writer.write_image_data(cells)?;
    writer.finish()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::{COLOURS, Canvas, Grid, NumberLine, STANDARD};
    use base64::Engine as _;
    use kahan_algebra::prime_field::SplitMix64;

    fn grid(columns: usize, values: Vec<f64>) -> Grid {
        let line = |label: &str| NumberLine::new(label, 0.0, 1.0);
        Grid {
            description: "a < b".to_owned(),
            sheet: Canvas::page(480, 400),
            x: line("x"),
            y: line("y"),
            scale: line("largest exponent"),
            columns,
            values,
            note: String::new(),
        }
    }

    #[test]
    fn cells_become_pixels_from_below_and_what_is_no_number_stays_empty() {
        let values = vec![0.0, 0.5, 1.0, f64::NAN, 7.0, -7.0];
        let drawing = grid(3, values).drawing();
        let svg = drawing.inline().into_string();
        let (_, image) = svg.split_once("base64,").expect("an image");
        let bytes = STANDARD.decode(image.split('"').next().expect("a quote")).expect("base64");
        let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        let mut reader = decoder.read_info().expect("a PNG");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        let info = reader.next_frame(&mut pixels).expect("pixels");
        let (across, upwards) = (info.width as usize / 3, info.height as usize / 2);
        assert_eq!((across * 3, upwards * 2), (1026, 1024));
        for (cell, index) in [COLOURS as u8, 254, 0, 0, 127, 254].into_iter().enumerate() {
            let (column, row) = (cell % 3, cell / 3);
            for pixel in
                [(row * upwards, column * across), ((row + 1) * upwards - 1, (column + 1) * across - 1)]
            {
                assert_eq!(pixels[pixel.0 * info.width as usize + pixel.1], index, "{pixel:?}");
            }
        }
        assert!(svg.contains("largest exponent") && svg.contains("a &lt; b"));
    }

    #[test]
    fn half_a_thousand_cells_a_side_stay_below_a_megabyte_even_as_noise() {
        let mut random = SplitMix64::new(7);
        let noise = (0..512 * 512).map(|_| random.below(1000) as f64 / 1000.0).collect();
        let svg = grid(512, noise).drawing().inline().into_string();
        assert!(svg.len() < 1_000_000, "{} bytes", svg.len());
    }

    #[test]
    fn numbers_that_are_no_rows_are_refused() {
        for (columns, count) in [(0, 4), (3, 4), (2, 0)] {
            let grid = grid(columns, vec![0.0; count]);
            assert!(std::panic::catch_unwind(|| grid.drawing()).is_err());
        }
    }
}
