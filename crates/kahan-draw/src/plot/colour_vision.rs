//! Simulates colour vision deficiency. The matrices are those of Machado, Oliveira and Fernandes,
//! "A physiologically-based model for simulation of color vision deficiency" (2009).

pub(super) type Linear = [f64; 3];

/// A kind of colour vision: with all cones, or without one of the three kinds of cones.
#[derive(Clone, Copy, Debug)]
pub(super) enum ColourVision {
    All,
    NoLong,
    NoMedium,
    NoShort,
}

pub(super) const KINDS: [ColourVision; 4] =
    [ColourVision::All, ColourVision::NoLong, ColourVision::NoMedium, ColourVision::NoShort];

pub(super) fn rgb(hex: &str) -> Linear {
    std::array::from_fn(|i| {
        let byte = u8::from_str_radix(&hex[1 + 2 * i..3 + 2 * i], 16).expect("two hexadecimal digits");
        linear(byte)
    })
}

pub(super) fn linear(byte: u8) -> f64 {
    let c = f64::from(byte) / 255.0;
    if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
}

pub(super) fn simulated(colour: Linear, kind: ColourVision) -> Linear {
    let rows = match kind {
        ColourVision::All => return colour,
        ColourVision::NoLong => [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        ColourVision::NoMedium => {
            [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
        }
        ColourVision::NoShort => [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    };
    rows.map(|row| row.iter().zip(colour).map(|(m, c)| m * c).sum::<f64>().clamp(0.0, 1.0))
}

fn luminance([r, g, b]: Linear) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Returns the contrast ratio of two colours, from 1 to 21, by the formula of WCAG 2.
pub(super) fn contrast(one: Linear, other: Linear) -> f64 {
    let (a, b) = (luminance(one) + 0.05, luminance(other) + 0.05);
    (a / b).max(b / a)
}

pub(super) fn lab([r, g, b]: Linear) -> [f64; 3] {
    let x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505;
    let z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089;
    let f = |t: f64| if t > 0.008856 { libm::cbrt(t) } else { 7.787 * t + 16.0 / 116.0 };
    let (x, y, z) = (f(x), f(luminance([r, g, b])), f(z));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Returns the distance of two colours in L*a*b*.
pub(super) fn distance(one: Linear, other: Linear) -> f64 {
    let (one, other) = (lab(one), lab(other));
    one.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}
