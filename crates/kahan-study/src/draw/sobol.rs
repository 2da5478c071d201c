//! Sobol's sequence with the direction numbers of Joe and Kuo, in Gray code order.

const BITS: usize = 32;

/// The number of points after which the sequence repeats.
const PERIOD: u64 = 1 << BITS;

const DIMENSIONS: usize = 512;

/// The primitive polynomials and initial direction integers of all dimensions but the first.
const DIRECTION_NUMBERS: &str = include_str!("joe_kuo.txt");

#[derive(Clone, Debug)]
pub(crate) struct Sobol {
    directions: [u32; BITS],
}

impl Sobol {
    /// Returns the sequence in the dimension with this index. Fails if the sequence is too short or
    /// has too few dimensions.
    pub(crate) fn dimension(index: usize, points: u64) -> Result<Self, String> {
        if points > PERIOD {
            return Err(format!(
                "Sobol's sequence has {PERIOD} points and then repeats itself; draw {points} with \"uniform\""
            ));
        }
        let mut m = [1u32; BITS];
        if index > 0 {
            let line = DIRECTION_NUMBERS.lines().filter(|line| !line.starts_with('#')).nth(index - 1);
            let line = line.ok_or_else(|| {
                format!("Sobol points have at most {DIMENSIONS} dimensions; draw it with \"uniform\"")
            })?;
            let mut numbers = line.split(' ').filter_map(|number| number.parse::<u32>().ok());
            let polynomial = numbers.next().expect("a line has numbers");
            let degree = polynomial.ilog2() as usize;
            for (m, first) in m.iter_mut().zip(numbers) {
                *m = first;
            }
            // For a primitive polynomial of degree s with coefficients aₖ, the entries of `m`
            // satisfy mᵢ = mᵢ₋ₛ ⊕ 2a₁mᵢ₋₁ ⊕ … ⊕ 2ˢaₛmᵢ₋ₛ, where ⊕ is XOR.
            for i in degree..BITS {
                m[i] = m[i - degree];
                for k in 1..=degree {
                    if polynomial >> (degree - k) & 1 == 1 {
                        m[i] ^= m[i - k] << k;
                    }
                }
            }
        }
        Ok(Self { directions: std::array::from_fn(|i| m[i] << (BITS - 1 - i)) })
    }

    /// Returns the number at `index`, which must be below [`PERIOD`].
    pub(crate) fn at(&self, index: u64) -> f64 {
        let gray = index ^ (index >> 1);
        let chosen = self.directions.iter().enumerate().filter(|(bit, _)| gray >> bit & 1 == 1);
        let sum = chosen.fold(0, |sum, (_, direction)| sum ^ direction);
        f64::from(sum) / PERIOD as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_those_of_the_literature() {
        // The first eight points of five dimensions, from SciPy's unscrambled sequence.
        let expected: [[f64; 5]; 8] = [
            [0.0, 0.0, 0.0, 0.0, 0.0],
            [0.5, 0.5, 0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25, 0.25, 0.75],
            [0.25, 0.75, 0.75, 0.75, 0.25],
            [0.375, 0.375, 0.625, 0.875, 0.375],
            [0.875, 0.875, 0.125, 0.375, 0.875],
            [0.625, 0.125, 0.875, 0.625, 0.625],
            [0.125, 0.625, 0.375, 0.125, 0.125],
        ];
        for (index, point) in expected.iter().enumerate() {
            for (dimension, value) in point.iter().enumerate() {
                assert_eq!(
                    Sobol::dimension(dimension, 8).unwrap().at(index as u64),
                    *value,
                    "{index} {dimension}"
                );
            }
        }
    }

    #[test]
    fn each_dimension_takes_every_dyadic_cell_once() {
        for dimension in [0, 1, 2, 17, 100, DIMENSIONS - 1] {
            let sobol = Sobol::dimension(dimension, 1024).unwrap();
            let mut cells: Vec<u32> = (0..1024).map(|index| (sobol.at(index) * 1024.0) as u32).collect();
            cells.sort_unstable();
            assert!(cells.into_iter().eq(0..1024), "{dimension}");
        }
        assert!(Sobol::dimension(DIMENSIONS, 1).is_err());
    }

    #[test]
    fn no_point_comes_twice() {
        assert!(Sobol::dimension(0, PERIOD).is_ok());
        assert!(Sobol::dimension(0, PERIOD + 1).is_err());
    }
}
