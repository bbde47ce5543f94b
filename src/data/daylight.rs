//! The sky in daylight, the sun above it, and the air between.

super::tables! {
    /// The sun outside the atmosphere, and what air takes of it [Preetham99, table 2]: wavelength
    /// in nm, radiance in W/m²/sr/nm (0 beyond 750 nm, where the table has none), absorption of
    /// ozone and of water vapour in 1/cm, and of mixed gases.
    pub fn preetham_sun() -> [f64; 5] in "preetham_sun.csv";
    /// The same as Bird and Riordan have it [Bird86], and beyond what eyes see: wavelength in nm,
    /// irradiance outside the atmosphere in W/m²/nm, absorption of water vapour and of ozone in
    /// 1/cm, and of mixed gases.
    pub fn bird_riordan() -> [f64; 5] in "bird_riordan.csv";
}

/// How the sky's luminance spreads: coefficients A to E of Perez's formula, each a slope by
/// turbidity and an offset [Preetham99, appendix A.2]. Five digits, as the authors' own program has
/// them; the paper prints four.
pub const LUMINANCE: [[f64; 2]; 5] = [
    [0.17872, -1.46303],
    [-0.35540, 0.42749],
    [-0.02266, 5.32505],
    [0.12064, -2.57705],
    [-0.06696, 0.37027],
];

/// The same of the chromaticity x.
pub const CHROMATICITY_X: [[f64; 2]; 5] = [
    [-0.01925, -0.25922],
    [-0.06651, 0.00081],
    [-0.00041, 0.21247],
    [-0.06409, -0.89887],
    [-0.00325, 0.04517],
];

/// The same of the chromaticity y.
pub const CHROMATICITY_Y: [[f64; 2]; 5] = [
    [-0.01669, -0.26078],
    [-0.09495, 0.00921],
    [-0.00792, 0.21023],
    [-0.04405, -1.65369],
    [-0.01092, 0.05291],
];

/// The luminance at the zenith in kcd/m²: (a T + b) tan χ + c T + d [Preetham99, appendix A.2].
pub const ZENITH_LUMINANCE: [f64; 4] = [4.0453, -4.9710, -0.2155, 2.4192];

/// The chromaticity x at the zenith: rows by T², T and 1, columns by powers 3 to 0 of the sun's
/// zenith angle in radians [Preetham99, appendix A.2].
pub const ZENITH_X: [[f64; 4]; 3] = [
    [0.00166, -0.00375, 0.00209, 0.0],
    [-0.02903, 0.06377, -0.03202, 0.00394],
    [0.11693, -0.21196, 0.06052, 0.25886],
];

/// The chromaticity y at the zenith, likewise.
pub const ZENITH_Y: [[f64; 4]; 3] = [
    [0.00275, -0.00610, 0.00317, 0.0],
    [-0.04214, 0.08970, -0.04153, 0.00516],
    [0.15346, -0.26756, 0.06670, 0.26688],
];

/// Ångström's coefficient of aerosol by turbidity: a slope and an offset [Preetham99, appendix A.1].
pub const AEROSOL: [f64; 2] = [0.046_083_658_222_05, -0.045_860_259_285_22];

#[cfg(test)]
mod tests {
    use super::*;

    /// The paper's own digits.
    #[test]
    fn coefficients_round_to_those_the_paper_prints() {
        let printed = [
            (LUMINANCE, [0.1787, -1.4630, -0.3554, 0.4275, -0.0227, 5.3251, 0.1206, -2.5771]),
            (
                CHROMATICITY_X,
                [-0.0193, -0.2592, -0.0665, 0.0008, -0.0004, 0.2125, -0.0641, -0.8989],
            ),
            (
                CHROMATICITY_Y,
                [-0.0167, -0.2608, -0.0950, 0.0092, -0.0079, 0.2102, -0.0441, -1.6537],
            ),
        ];
        for (ours, printed) in printed {
            for (ours, printed) in ours.iter().flatten().zip(printed) {
                assert!((ours - printed).abs() <= 0.5001e-4, "{ours}, printed {printed}");
            }
        }
        let last = [LUMINANCE[4], CHROMATICITY_X[4], CHROMATICITY_Y[4]];
        let printed = [[-0.0670, 0.3703], [-0.0033, 0.0452], [-0.0109, 0.0529]];
        for (ours, printed) in last.as_flattened().iter().zip(printed.as_flattened()) {
            assert!((ours - printed).abs() <= 0.5001e-4, "{ours}, printed {printed}");
        }
    }
}
