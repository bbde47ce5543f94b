//! The index of refraction of water [Quan95].

use crate::data::water::INDEX;

/// Index at a wavelength in nm (400 to 700, used to 800), a temperature in °C (0 to 30) and a
/// salinity in parts of a thousand (0 to 35); within 1.5e-4 of the measurements behind it.
pub fn index(nm: f64, celsius: f64, salinity: f64) -> f64 {
    let [n0, n1, n2, n3, n4, n5, n6, n7, n8, n9] = INDEX;
    n0 + (n1 + n2 * celsius + n3 * celsius * celsius) * salinity
        + n4 * celsius * celsius
        + (n5 + n6 * salinity + n7 * celsius) / nm
        + n8 / (nm * nm)
        + n9 / (nm * nm * nm)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn water_at_the_line_of_sodium() {
        assert!((index(589.26, 20.0, 0.0) - 1.33301).abs() < 5e-6);
        assert!((index(589.26, 20.0, 35.0) - 1.33941).abs() < 5e-6);
        // Warmer water is thinner.
        assert!(index(560.0, 30.0, 0.0) < index(560.0, 10.0, 0.0));
    }
}
