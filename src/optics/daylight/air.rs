//! What the air takes of the sun's light on its way [Preetham99, appendix A.1], after [Iqbal83].
//!
//! Every transmittance is exp(−m τ), with the air mass m beside the optical depth τ: to multiply
//! the power of λ by m instead, as is often copied, is wrong by powers of ten.

use std::f64::consts::FRAC_PI_2;

use crate::data::daylight;

/// A cloudless atmosphere over a place at sea level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Air {
    /// Optical depth of aerosol at 1 µm, Ångström's β.
    pub aerosol: f64,
    /// By which power of the wavelength aerosol thins: Ångström's α.
    pub aerosol_power: f64,
    /// Ozone, in cm at normal pressure.
    pub ozone: f64,
    /// Water vapour, in cm of liquid water.
    pub water: f64,
}

impl Air {
    /// The air of a turbidity, with the ozone, water and aerosol that [Preetham99] assumes.
    pub fn of_turbidity(turbidity: f64) -> Self {
        let [slope, offset] = daylight::AEROSOL;
        let aerosol = (slope * turbidity + offset).max(0.0);
        Self { aerosol, aerosol_power: 1.3, ozone: 0.35, water: 2.0 }
    }

    /// Optical depth of aerosol at a wavelength.
    pub fn aerosol_depth(&self, nm: f64) -> f64 {
        self.aerosol * (nm * 1e-3).powf(-self.aerosol_power)
    }

    /// What of the sun's light aerosol leaves over, at an air mass.
    pub fn past_aerosol(&self, nm: f64, mass: f64) -> f64 {
        (-self.aerosol_depth(nm) * mass).exp()
    }

    /// What water vapour leaves over, of an absorption in 1/cm [Leckner78].
    pub fn past_water(&self, absorption: f64, mass: f64) -> f64 {
        let path = absorption * self.water * mass;
        (-0.2385 * path / (1.0 + 20.07 * path).powf(0.45)).exp()
    }

    /// What ozone leaves over, of an absorption in 1/cm, at an air mass of its own layer.
    pub fn past_ozone(&self, absorption: f64, mass: f64) -> f64 {
        (-absorption * self.ozone * mass).exp()
    }
}

/// What mixed gases, oxygen above all, leave over [Leckner78].
pub fn past_gases(absorption: f64, mass: f64) -> f64 {
    let path = absorption * mass;
    (-1.41 * path / (1.0 + 118.93 * path).powf(0.45)).exp()
}

/// What scattering by pure air leaves over, by Rayleigh's law as [Preetham99] has it.
pub fn past_molecules(nm: f64, mass: f64) -> f64 {
    (-0.008735 * (nm * 1e-3).powf(-4.08) * mass).exp()
}

/// How much more air light passes from a zenith angle than from the zenith [Kasten65], for a sun
/// that is up: from 0.9995 in the zenith to 36.5 at the horizon. Infinite below the horizon: the
/// formula would go on to 93.885°, but turns over before it.
pub fn mass(zenith: f64) -> f64 {
    if zenith > FRAC_PI_2 {
        return f64::INFINITY;
    }
    1.0 / (zenith.cos() + 0.15 * (93.885 - zenith.to_degrees()).powf(-1.253))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn air_masses_are_known_and_end_at_the_horizon() {
        let at = |degrees: f64| mass(degrees.to_radians());
        for (degrees, expected) in
            [(0.0, 0.999494), (60.0, 1.992764), (75.0, 3.808134), (85.0, 10.3231), (90.0, 36.5103)]
        {
            let off = at(degrees) / expected - 1.0;
            assert!(off.abs() < 1e-5, "{degrees}: {}, not {expected}", at(degrees));
        }
        assert!(mass(FRAC_PI_2).is_finite() && mass(FRAC_PI_2.next_up()) == f64::INFINITY);
        // From 1° on: before, the fit dips by 1e-5.
        let growing = (100..9000).map(|i| at(f64::from(i) / 100.0));
        assert!(growing.clone().zip(growing.skip(1)).all(|(a, b)| a < b));
    }

    #[test]
    fn the_air_mass_multiplies_the_depth_and_not_the_power() {
        let m = mass(60_f64.to_radians());
        assert!((past_molecules(450.0, m) - 0.636).abs() < 1e-3, "{}", past_molecules(450.0, m));
        // One pass twice as long is two passes.
        let air = Air::of_turbidity(2.5);
        for past in [past_molecules, |nm, m| Air::of_turbidity(2.5).past_aerosol(nm, m)] {
            assert!((past(550.0, 2.0) - past(550.0, 1.0).powi(2)).abs() < 1e-12);
        }
        assert!((air.past_ozone(0.1, 2.0) - air.past_ozone(0.1, 1.0).powi(2)).abs() < 1e-12);
        // β = 0.0693 at turbidity 2.5: Ångström's law at 550 nm.
        assert!((air.aerosol - 0.069349).abs() < 1e-6);
        assert!((air.aerosol_depth(550.0) - 0.069349 * 0.55_f64.powf(-1.3)).abs() < 2e-6);
    }

    #[test]
    fn all_of_it_passes_where_nothing_absorbs() {
        let air = Air::of_turbidity(1.0);
        assert!(air.aerosol < 3e-4 && Air::of_turbidity(0.5).aerosol == 0.0);
        assert_eq!(
            [air.past_water(0.0, 2.0), air.past_ozone(0.0, 2.0), past_gases(0.0, 2.0)],
            [1.0; 3]
        );
        // Oxygen's band at 760 nm takes a quarter from the zenith; none of it all.
        assert!((past_gases(3.0, 1.0) - 0.741).abs() < 2e-3, "{}", past_gases(3.0, 1.0));
        assert_eq!(past_molecules(550.0, f64::INFINITY), 0.0);
    }
}
