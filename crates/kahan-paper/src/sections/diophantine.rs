//! Claims of section 7, on the Diophantine test, with measurements on exact orbits.

use kahan_systems::registry::find;

use super::super::claim::Claim;
use super::super::figures::Figure;
use super::super::section::Section;
use super::text::read;

/// The growth of heights along the orbits of the maps.
const GROWTH: &str = "
DE1 growth | growth of the heights, Theorem 4 | growth(x) = logarithmic; growth(z) = logarithmic
DE2 growth | growth of the heights, Theorem 4 | growth(x) = logarithmic; growth(z) = logarithmic
DE3 growth | growth of the heights, Theorem 4 | growth(x) = linear
DE4 growth | growth of the heights, Theorem 4 | growth(x) = quadratic
DE5 growth | growth of the heights, Theorem 4 | growth(x) = linear
DE6 growth | growth of the heights, Theorem 4 | growth(x) = quadratic
DE7 growth | growth of the heights, Theorem 4 | growth(y) = linear; growth(z) = linear
DE8 growth | growth of the heights, Theorem 4 | growth(y) = linear; growth(z) = linear
DE9 growth | growth of the heights | growth(x) = exponential
LV growth | growth of the heights | growth(x) = exponential
";

const INTEGRABLE_MAPS: &str = "
DE1 log_height_x | dE1: h(x_n) = log n + O(1) | logslope(x, 500, 1000) ~ 1.0
DE1 log_height_z | dE1: h(z_n) = 2 log n + O(1) | logslope(z, 100, 1000) ~ 2.0
    misprint B2: logslope(z, 100, 1000) ~ 1.0
DE2 log_height_z | dE2: h(z_n) = 4 log n + O(1) | logslope(z, 100, 1000) ~ 4.0
    misprint B2: logslope(z, 100, 1000) ~ 1.0
DE1 log_height_y | dE1: h(y_n) = log n + O(1) | logslope(y, 500, 1000) ~ 1.0
DE2 log_height_x | dE2: h(x_n) = log n + O(1) | logslope(x, 500, 1000) ~ 1.0
DE3 height | figure dE3 | h(x, 200) ~ 3814.6
DE3 slope | figure dE3: h(x_n)/n tends to log 68790267 + 2 delta |
    K := 1/2*((3/7)^2 + (11/13)^2 + (23/47)^2)/(1 + 1/4*((3/7)^2 + (11/13)^2));
    slope(x, 100, 200) ~ 19.098; log(68790267) + 2*atanh(1/2*sqrt(2*K)) ~ 19.098
DE4 digits | figure dE4 | digits(x, 125) = 95282
DE4 limit | figure dE4: h(x_n)/n^2 | (h(x, 125) - 2*h(x, 75) + h(x, 25))/(2*50^2) ~ 14.05
DE6 digits | dE6, addition | digits(x, 125) = 114682
DE6 limit | dE6: h(x_n)/n^2, addition | (h(x, 125) - 2*h(x, 75) + h(x, 25))/(2*50^2) ~ 16.89
";

/// Claims about the heights h of coordinates after n steps: slopes, and limits of h(y_n)/n.
const TRANSCENDENTAL_MAPS: &str = "
DE7 height_x | figure of 400 iterates: h(x_n) grows like log n only | logslope(x, 500, 1000) ~ 1.0
    explains B5
DE7 slope_y | figure dE7, slope of h(y_n) | slope(y, 1, 2000) ~ 4.955
DE7 slope_z | figure dE7, slope of h(z_n) | slope(z, 1, 2000) ~ 13.470; log(slope(z, 1, 2000)) ~ 2.600
    misprint B1: log(slope(z, 1, 2000)) ~ 2.64
DE7 mean | 1.64 is the mean over 200 iterates, not a limit | mean(y, 1, 200) ~ 1.6406
    explains B1
e7 C1 | the limit C1 of h(y_n)/n | C1_e7(19/17, 7/3) ~ 4.923275; log(C1_e7(19/17, 7/3)) ~ 1.5940
    misprint B1: log(C1_e7(19/17, 7/3)) ~ 1.64
e7 C1.dependence | the limit C1 from x0 = 1/5 and 2/9: it depends on the initial point |
    C1_e7(19/17, 5) ~ 3.8767; C1_e7(19/17, 9/2) ~ 2.4098
    misprint B1: C1_e7(19/17, 5) - C1_e7(19/17, 7/3) ~ 0.00; C1_e7(19/17, 9/2) - C1_e7(19/17, 7/3) ~ 0.00
DE7_1_5 dependence.1_5 | the slopes from x0 = 1/5: their ratio is not e |
    slope(y, 1, 2000) ~ 3.87; slope(z, 1, 2000) ~ 9.62; slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.49
    misprint B1: slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.718
DE7_2_9 dependence.2_9 | the slopes from x0 = 2/9: their ratio is not e |
    slope(y, 1, 2000) ~ 2.40; slope(z, 1, 2000) ~ 5.77; slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.40
    misprint B1: slope(z, 1, 2000)/slope(y, 1, 2000) ~ 2.718
DE8 slope_y | dE8, slope of h(y_n), addition | slope(y, 1, 2000) ~ 3.596
DE8 slope_z | dE8, slope of h(z_n), addition | slope(z, 1, 2000) ~ 10.781
DE8 ratio | dE8: h(z_n) grows three times as fast as h(y_n), addition |
    slope(z, 1, 2000)/slope(y, 1, 2000) ~ 3.00
e8 C1 | the limit C1 of h(y_n)/n for dE8, addition | C1_e8(7/3) = 18/5; C1_e8(1/2) = 1
";

const CHAOTIC_MAPS: &str = "
LV height | figure of the Lotka-Volterra map | h(x, 17) ~ 748359.97; digits(x, 17) = 325009
    misprint A10: log(h(x, 17))/log(10) ~ 325009
LV ratio | the Lotka-Volterra map: h doubles, entropy log 2 |
    h(x, 16)/h(x, 15) ~ 2.000; h(x, 17)/h(x, 16) ~ 2.000; log(h(x, 17)/h(x, 16)) ~ 0.693
DE9 height | figure of dE9 | h(x, 11) ~ 934584.8; digits(x, 11) = 405886
DE9 ratio | dE9: h is multiplied by 3, entropy log 3 |
    h(x, 10)/h(x, 9) ~ 3.00; h(x, 11)/h(x, 10) ~ 3.00; log(h(x, 11)/h(x, 10)) ~ 1.099
";

pub(super) fn claims() -> Vec<Claim> {
    [GROWTH, INTEGRABLE_MAPS, TRANSCENDENTAL_MAPS, CHAOTIC_MAPS].map(|text| read(text, claim)).concat()
}

fn claim(subject_and_id: &str, place: &str, statement: &str) -> Claim {
    let (subject, id) = subject_and_id.split_once(' ').expect("an orbit or a system, and a name");
    let figure = Figure::all().find(|figure| figure.name == subject);
    let system = figure.map_or_else(|| find(subject).expect("a system").command, |figure| figure.system);
    let place = format!("Section 7, {place}");
    let claim = Claim::new(Section::Diophantine, ["section7", system, id], system, place, statement);
    figure.map_or(claim.clone(), |figure| claim.on(figure))
}
