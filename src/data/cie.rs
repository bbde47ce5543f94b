//! What the International Commission on Illumination has agreed on: an eye, and lights to see by.

super::tables! {
    /// The standard observer of 1931 for a field of 2°, every 5 nm from 380 to 780 nm [CIE06]:
    /// wavelength in nm, x̄, ȳ, z̄.
    pub fn observer() -> [f64; 4] in "cie_1931.csv";
    /// Illuminant A, a lamp of tungsten at 2856 K [CIE06]: wavelength in nm, relative power, 100
    /// at 560 nm.
    pub fn illuminant_a() -> [f64; 2] in "illuminant_a.csv";
    /// Illuminant D65, daylight of a correlated colour temperature of about 6500 K [CIE06]:
    /// wavelength in nm, relative power, 100 at 560 nm.
    pub fn illuminant_d65() -> [f64; 2] in "illuminant_d65.csv";
}

/// Illuminant E: the same power at every wavelength.
pub static ILLUMINANT_E: [[f64; 2]; 1] = [[560.0, 100.0]];

/// Chromaticities of the red, green and blue of sRGB: x, y [IEC99].
pub const SRGB_PRIMARIES: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_observer_sees_equal_energy_as_white() {
        let sum = |i: usize| observer().iter().map(|row| row[i] * 5.0).sum::<f64>();
        for (i, expected) in [(1, 106.8576), (2, 106.8566), (3, 106.8577)] {
            assert!((sum(i) - expected).abs() < 1e-4, "{}", sum(i));
        }
    }

    /// [CIE06] gives illuminant A this formula, with 2848 K and the second radiation constant of
    /// 1931; 2856 K is the same with today's constant.
    #[test]
    fn illuminant_a_is_a_black_body() {
        let of = |nm: f64| {
            let power = |nm: f64| nm.powi(-5) / (1.435e7 / (2848.0 * nm)).exp_m1();
            100.0 * power(nm) / power(560.0)
        };
        for [nm, power] in illuminant_a() {
            assert!((power / of(*nm) - 1.0).abs() < 1e-5, "{nm}: {power}, {}", of(*nm));
        }
    }
}
