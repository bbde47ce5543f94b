//! Dimensions of quantities and the units a scene file may write them in.
//!
//! Dimensions are kept as a person thinks of them: a watt and a lumen never meet, an angle is no
//! plain number. Below the scene everything is in the base units named here.

use serde::Serialize;

/// Exponents of the base dimensions, in this order: length (m), angle (rad), solid angle (sr),
/// time (s), temperature (K), power (W), luminous flux (lm), exposure (ev).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
pub struct Dimension(pub [i8; 8]);

/// Base units, in the order of [`Dimension`]'s exponents.
pub const BASES: [&str; 8] = ["m", "rad", "sr", "s", "K", "W", "lm", "ev"];

impl Dimension {
    /// A plain number.
    pub const NONE: Self = Self([0; 8]);
    /// Length, in metres.
    pub const LENGTH: Self = Self([1, 0, 0, 0, 0, 0, 0, 0]);
    /// Plane angle, in radians.
    pub const ANGLE: Self = Self([0, 1, 0, 0, 0, 0, 0, 0]);
    /// Solid angle, in steradians.
    pub const SOLID_ANGLE: Self = Self([0, 0, 1, 0, 0, 0, 0, 0]);
    /// Time, in seconds.
    pub const TIME: Self = Self([0, 0, 0, 1, 0, 0, 0, 0]);
    /// Temperature, in kelvin.
    pub const TEMPERATURE: Self = Self([0, 0, 0, 0, 1, 0, 0, 0]);
    /// Radiant flux, in watts.
    pub const POWER: Self = Self([0, 0, 0, 0, 0, 1, 0, 0]);
    /// Luminous flux, in lumens.
    pub const LUMINOUS_FLUX: Self = Self([0, 0, 0, 0, 0, 0, 1, 0]);
    /// Luminous intensity, in candelas.
    pub const LUMINOUS_INTENSITY: Self = Self([0, 0, -1, 0, 0, 0, 1, 0]);
    /// Illuminance, in lux.
    pub const ILLUMINANCE: Self = Self([-2, 0, 0, 0, 0, 0, 1, 0]);
    /// Luminance, in cd/m².
    pub const LUMINANCE: Self = Self([-2, 0, -1, 0, 0, 0, 1, 0]);
    /// Exposure, in stops: +1 doubles.
    pub const EXPOSURE: Self = Self([0, 0, 0, 0, 0, 0, 0, 1]);
    /// Irradiance, in W/m².
    pub const IRRADIANCE: Self = Self([-2, 0, 0, 0, 0, 1, 0, 0]);
    /// Radiant intensity, in W/sr.
    pub const INTENSITY: Self = Self([0, 0, -1, 0, 0, 1, 0, 0]);
    /// Radiance, in W/m²/sr.
    pub const RADIANCE: Self = Self([-2, 0, -1, 0, 0, 1, 0, 0]);
    /// Area, in m².
    pub const AREA: Self = Self([2, 0, 0, 0, 0, 0, 0, 0]);
    /// The square of an area, in m⁴.
    pub const SQUARED_AREA: Self = Self([4, 0, 0, 0, 0, 0, 0, 0]);
    /// What happens along a length, in 1/m.
    pub const COEFFICIENT: Self = Self([-1, 0, 0, 0, 0, 0, 0, 0]);
    /// Radiance for each length of wavelength, in W/m²/sr/m.
    pub const SPECTRAL_RADIANCE: Self = Self([-3, 0, -1, 0, 0, 1, 0, 0]);
    /// Irradiance for each length of wavelength, in W/m²/m.
    pub const SPECTRAL_IRRADIANCE: Self = Self([-3, 0, 0, 0, 0, 1, 0, 0]);
    /// Intensity for each length of wavelength, in W/sr/m.
    pub const SPECTRAL_INTENSITY: Self = Self([-1, 0, -1, 0, 0, 1, 0, 0]);
    /// Power for each length of wavelength, in W/m.
    pub const SPECTRAL_POWER: Self = Self([-1, 0, 0, 0, 0, 1, 0, 0]);

    /// The dimension of a product.
    pub fn times(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].saturating_add(other.0[i])))
    }

    /// The dimension of a quotient.
    pub fn over(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].saturating_sub(other.0[i])))
    }

    /// Whether it measures light: a power is part of it.
    pub fn is_light(self) -> bool {
        self.0[5] > 0
    }

    /// Whether it measures light as the eye does: a luminous flux is part of it.
    pub fn is_luminous(self) -> bool {
        self.0[6] > 0
    }

    /// The same with a power in place of the luminous flux: a radiance for a luminance.
    pub fn radiant(self) -> Self {
        let [m, rad, sr, s, k, w, lm, ev] = self.0;
        Self([m, rad, sr, s, k, w.saturating_add(lm), 0, ev])
    }

    /// The dimension of a power.
    pub fn power(self, exponent: i8) -> Self {
        Self(self.0.map(|e| e.saturating_mul(exponent)))
    }

    /// What a person calls it, with its article: "a length", "an irradiance"; dimensions without
    /// a name of their own by their unit: "a quantity in m W".
    pub fn name(self) -> String {
        let named = [
            (Self::NONE, "a plain number"),
            (Self::LENGTH, "a length"),
            (Self::ANGLE, "an angle"),
            (Self::SOLID_ANGLE, "a solid angle"),
            (Self::TIME, "a time"),
            (Self::TEMPERATURE, "a temperature"),
            (Self::POWER, "a power"),
            (Self::LUMINOUS_FLUX, "a luminous flux"),
            (Self::LUMINOUS_INTENSITY, "a luminous intensity"),
            (Self::ILLUMINANCE, "an illuminance"),
            (Self::LUMINANCE, "a luminance"),
            (Self::EXPOSURE, "an exposure"),
            (Self::IRRADIANCE, "an irradiance"),
            (Self::RADIANCE, "a radiance"),
            (Self::INTENSITY, "an intensity"),
            (Self::SPECTRAL_RADIANCE, "a spectral radiance"),
            (Self::SPECTRAL_IRRADIANCE, "a spectral irradiance"),
            (Self::SPECTRAL_INTENSITY, "a spectral intensity"),
            (Self::SPECTRAL_POWER, "a spectral power"),
            (Self::AREA, "an area"),
            (Self::SQUARED_AREA, "the square of an area"),
            (Self::COEFFICIENT, "a coefficient per length"),
        ];
        match named.iter().find(|(dimension, _)| *dimension == self) {
            Some((_, name)) => (*name).to_string(),
            None => format!("a quantity in {}", self.unit()),
        }
    }

    /// Its unit written with base units: "W/m^2/sr", "" for a plain number.
    pub fn unit(self) -> String {
        let part = |base: &str, e: i8| {
            if e == 1 { base.to_string() } else { format!("{base}^{e}") }
        };
        let bases = || BASES.iter().zip(self.0);
        let above: Vec<_> = bases().filter(|(_, e)| *e > 0).map(|(b, e)| part(b, e)).collect();
        let below: Vec<_> = bases().filter(|(_, e)| *e < 0).map(|(b, e)| part(b, -e)).collect();
        let mut text = above.join(" ");
        if text.is_empty() && !below.is_empty() {
            text.push('1');
        }
        for unit in below {
            text.push('/');
            text.push_str(&unit);
        }
        text
    }
}

/// A unit that may follow a number, or stand in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// As written.
    pub word: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// Its size in base units.
    pub scale: f64,
}

/// Every unit, those of one dimension together, the most usual first.
pub static UNITS: &[Unit] = &[
    unit("m", Dimension::LENGTH, 1.0),
    unit("cm", Dimension::LENGTH, 1e-2),
    unit("mm", Dimension::LENGTH, 1e-3),
    unit("um", Dimension::LENGTH, 1e-6),
    unit("nm", Dimension::LENGTH, 1e-9),
    unit("km", Dimension::LENGTH, 1e3),
    unit("deg", Dimension::ANGLE, std::f64::consts::PI / 180.0),
    unit("rad", Dimension::ANGLE, 1.0),
    unit("sr", Dimension::SOLID_ANGLE, 1.0),
    unit("s", Dimension::TIME, 1.0),
    unit("ms", Dimension::TIME, 1e-3),
    unit("min", Dimension::TIME, 60.0),
    unit("h", Dimension::TIME, 3600.0),
    unit("K", Dimension::TEMPERATURE, 1.0),
    unit("W", Dimension::POWER, 1.0),
    unit("mW", Dimension::POWER, 1e-3),
    unit("kW", Dimension::POWER, 1e3),
    unit("lm", Dimension::LUMINOUS_FLUX, 1.0),
    unit("cd", Dimension::LUMINOUS_INTENSITY, 1.0),
    unit("lx", Dimension::ILLUMINANCE, 1.0),
    unit("nit", Dimension::LUMINANCE, 1.0),
    unit("ev", Dimension::EXPOSURE, 1.0),
    unit("%", Dimension::NONE, 0.01),
];

const fn unit(word: &'static str, dimension: Dimension, scale: f64) -> Unit {
    Unit { word, dimension, scale }
}

/// Looks a unit up as written.
pub fn find(word: &str) -> Option<&'static Unit> {
    UNITS.iter().find(|unit| unit.word == word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dimensions_read_as_people_write_them() {
        assert_eq!(Dimension::RADIANCE.unit(), "W/m^2/sr");
        assert_eq!(Dimension::LENGTH.power(-1).unit(), "1/m");
        assert_eq!(Dimension::NONE.unit(), "");
        assert_eq!(Dimension::POWER.over(Dimension::LENGTH.power(2)), Dimension::IRRADIANCE);
        assert_eq!(Dimension::IRRADIANCE.name(), "an irradiance");
        assert_eq!(Dimension::POWER.times(Dimension::LENGTH).name(), "a quantity in m W");
        let spectral = Dimension::RADIANCE.over(Dimension::LENGTH);
        assert_eq!(spectral.name(), "a spectral radiance");
    }
}
