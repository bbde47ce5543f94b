//! Direct and diffuse light of a clear day by the simple spectral model of Bird and Riordan
//! [Bird86]: irradiance alone, not where in the sky it comes from. Beside [`super::sky`] it says
//! how much of a picture's light is a matter of the model.
//!
//! Equation numbers are those of section 2 (direct) and 3 (diffuse) of the report it came from,
//! which the paper repeats. Level ground at sea level; tilted surfaces and other pressures were
//! left out.

use super::air::{self, Air};
use super::position::distance_factor;
use super::sun;
use crate::data::daylight;
use crate::math::Table;

/// Spectral irradiance in W/m²/nm, from 300 to 4000 nm.
#[derive(Clone, Debug)]
pub struct Irradiance {
    /// From the sun, on a surface square to it.
    pub direct: Table,
    /// From the sky, on level ground.
    pub diffuse: Table,
}

impl Irradiance {
    /// Of air over ground of an albedo, on a day of the year, with the sun at a zenith angle of at
    /// most π/2.
    pub fn new(air: &Air, albedo: f64, day: f64, zenith: f64) -> Self {
        let outside = daylight::bird_riordan();
        let distance = distance_factor(day);
        let lines: Vec<_> =
            outside.iter().map(|row| line(air, albedo, distance, zenith, row)).collect();
        let table = |part: usize| {
            let nodes = outside.iter().zip(&lines).map(|(row, line)| (row[0], line[part]));
            Table::new(nodes.collect()).expect("wavelengths rise")
        };
        Self { direct: table(0), diffuse: table(1) }
    }

    /// The sun's part as three channels, in W/m².
    pub fn direct_channels(&self) -> [f64; 3] {
        sun::channels(self.direct.clone())
    }

    /// The sky's part as three channels, in W/m².
    pub fn diffuse_channels(&self) -> [f64; 3] {
        sun::channels(self.diffuse.clone())
    }
}

/// Of light on its way, what each thing in the air leaves over.
struct Past {
    molecules: f64,
    water: f64,
    ozone: f64,
    gases: f64,
    /// Aerosol scatters some light [eq. 3-9] and absorbs some [eq. 3-10].
    scattered: f64,
    absorbed: f64,
}

impl Past {
    /// At an air mass, and that of the ozone layer.
    fn new(air: &Air, row: &[f64; 5], mass: f64, ozone_mass: f64) -> Self {
        let [nm, _, water, ozone, gases] = *row;
        // Single scattering albedo of rural aerosol [eq. 3-16].
        let albedo = 0.945 * (-0.095 * (nm / 400.0).ln().powi(2)).exp();
        let depth = air.aerosol_depth(nm) * mass;
        Self {
            molecules: past_molecules(nm, mass),
            water: air.past_water(water, mass),
            ozone: air.past_ozone(ozone, ozone_mass),
            gases: air::past_gases(gases, mass),
            scattered: (-albedo * depth).exp(),
            absorbed: ((albedo - 1.0) * depth).exp(),
        }
    }
}

/// What Rayleigh scattering leaves over [eq. 2-4].
fn past_molecules(nm: f64, mass: f64) -> f64 {
    let squared = (nm * 1e-3).powi(2);
    (-mass / (squared * (115.6406 * squared - 1.335))).exp()
}

/// Air masses through the ozone layer, 22 km up [eq. 2-10].
fn ozone_mass(zenith: f64) -> f64 {
    const HEIGHT: f64 = 22.0 / 6370.0;
    (1.0 + HEIGHT) / (zenith.cos().powi(2) + 2.0 * HEIGHT).sqrt()
}

/// How much of what aerosol scatters goes on forwards, by the cosine of the sun's zenith angle
/// [eq. 3-11 to 3-15]; aerosol of asymmetry 0.65.
fn forwards(cos: f64) -> f64 {
    let log = (1.0 - 0.65_f64).ln();
    let a = log * (1.459 + log * (0.1595 + log * 0.4129));
    let b = log * (0.0783 + log * (-0.3824 - log * 0.5874));
    1.0 - 0.5 * ((a + b * cos) * cos).exp()
}

/// Direct and diffuse light of one wavelength.
fn line(air: &Air, ground: f64, distance: f64, zenith: f64, row: &[f64; 5]) -> [f64; 2] {
    let cos = zenith.cos();
    let outside = row[1] * distance;
    let past = Past::new(air, row, air::mass(zenith), ozone_mass(zenith));
    let taken = past.water * past.ozone * past.gases * past.absorbed;
    let direct = outside * taken * past.molecules * past.scattered; // eq. 2-1
    // Scattered once, by molecules and by aerosol [eq. 3-5, 3-6].
    let level = outside * cos * taken;
    let by_molecules = level * (1.0 - past.molecules.powf(0.95)) * 0.5;
    let by_aerosol = level * past.molecules.powf(1.5) * (1.0 - past.scattered) * forwards(cos);
    // To and fro between ground and sky [eq. 3-7, 3-8]: the sky as diffuse light has it, 1.8 air
    // masses long.
    let slant = Past::new(air, row, 1.8, 1.8);
    let back = 0.5 * (1.0 - slant.molecules)
        + (1.0 - forwards(1.0 / 1.8)) * slant.molecules * (1.0 - slant.scattered);
    let sky = slant.ozone * slant.water * slant.absorbed * back;
    let first = by_molecules + by_aerosol;
    let between = (direct * cos + first) * sky * ground / (1.0 - sky * ground);
    // A correction at short wavelengths [eq. 3-17].
    let um = row[0] * 1e-3;
    let correction = if um <= 0.45 { (um + 0.55).powf(1.8) } else { 1.0 };
    [direct, (first + between) * correction]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::colour;
    use crate::optics::daylight::Sky;

    /// By the program of Anderson and others (pvlib 0.16.1), which follows a later program of the
    /// same authors: constants that differ by up to 1 % of the diffuse light.
    #[test]
    fn spectra_are_those_of_another_program() {
        // Optical depth 0.1 at 500 nm, thinning by 1.14.
        let air = Air {
            aerosol: 0.1 * 0.5_f64.powf(1.14),
            aerosol_power: 1.14,
            ozone: 0.344,
            water: 1.42,
        };
        let found = Irradiance::new(&air, 0.2, 80.0, 60_f64.to_radians());
        for (nm, direct, diffuse) in [
            (400.0, 0.55808119, 0.23024685),
            (450.0, 1.03157336, 0.27849799),
            (500.0, 1.15680023, 0.2151099),
            (550.0, 1.23745398, 0.17253161),
            (593.0, 1.17885401, 0.13391498),
            (690.0, 1.03229083, 0.08146806),
            (757.5, 1.0456644, 0.06818554),
        ] {
            let [seen_direct, seen_diffuse] = [found.direct.at(nm), found.diffuse.at(nm)];
            assert!((seen_direct / direct - 1.0).abs() < 2e-3, "{nm}: {seen_direct}");
            assert!((seen_diffuse / diffuse - 1.0).abs() < 1e-2, "{nm}: {seen_diffuse}");
        }
    }

    /// Two models of one day: the sun within 6 %; Preetham's sky is brighter by a third to a half.
    #[test]
    fn it_agrees_with_preethams_day_as_far_as_models_do() {
        for (turbidity, degrees) in [(2.4, 45.0), (3.0, 60.0), (5.0, 30.0)] {
            let zenith = f64::to_radians(degrees);
            let air = Air::of_turbidity(turbidity);
            let bird = Irradiance::new(&air, 0.2, 94.0, zenith);
            let ratio = |bird: [f64; 3], preetham: [f64; 3]| {
                colour::luminance(bird) / colour::luminance(preetham)
            };
            let direct = ratio(bird.direct_channels(), sun::irradiance(&air, zenith));
            assert!((1.03..1.06).contains(&direct), "{turbidity} {degrees}: {direct}");
            let sky = Sky::new(turbidity, zenith).irradiance(zenith);
            let diffuse = ratio(bird.diffuse_channels(), sky);
            assert!((0.65..0.8).contains(&diffuse), "{turbidity} {degrees}: {diffuse}");
        }
    }

    #[test]
    fn a_sun_at_the_horizon_gives_numbers() {
        let last = Irradiance::new(&Air::of_turbidity(2.0), 0.2, 1.0, std::f64::consts::FRAC_PI_2);
        for table in [&last.direct, &last.diffuse] {
            assert!(table.nodes().iter().all(|(_, value)| value.is_finite() && *value >= 0.0));
        }
    }
}
