//! Fresnel's formulas [Born99, ch. 1.5 and 14.2]: the part of unpolarised light that a smooth
//! surface reflects. Cosines are to the normal, on the side from which light comes, 0 to 1.
//!
//! Each reflection is taken for one of unpolarised light, as all three-channel renderers do: light
//! that meets several surfaces is polarised in truth, and a window at 60° lets 7.8 % less through.

/// What becomes of light that comes to the boundary of two clear media.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// The part that is reflected, 0 to 1; 1 where all of it is.
    pub reflectance: f64,
    /// How the rest goes on: along −(wo + `bend` · normal), where `wo` and the normal are on the
    /// side light comes from; that vector has the length of the index beyond over the index here.
    pub bend: f64,
}

/// The boundary of two clear media. `excess` is the index beyond less the index here, over the
/// index here: of indices that are nearly the same the difference is exact, the quotient is not.
///
/// Without jumps, so that a loop over it becomes vectors.
#[inline(always)]
pub fn dielectric(excess: f64, cos: f64) -> Boundary {
    let rest = excess * (excess + 2.0);
    let g_2 = rest + cos * cos;
    let (same, total) = (rest == 0.0, g_2 <= 0.0);
    // g is the cosine beyond times the relative index; bend is g − cos without cancellation.
    let g = g_2.sqrt();
    let sum = g + cos;
    let bend = rest / sum;
    let parallel = (cos * sum - 1.0) / (cos * bend + 1.0);
    let across = bend / sum;
    let reflectance = (0.5 * (across * across) * (1.0 + parallel * parallel)).clamp(0.0, 1.0);
    let reflectance = if total { 1.0 } else { reflectance };
    Boundary {
        reflectance: if same { 0.0 } else { reflectance },
        bend: if same | total { 0.0 } else { bend },
    }
}

/// The part of light from a vacuum that matter of index n + ik reflects. Without jumps, as above.
#[inline(always)]
pub fn conductor(n: f64, k: f64, cos: f64) -> f64 {
    // Their fourth powers stay numbers; beyond, all light is reflected.
    const MOST: f64 = 1e60;
    let (n, k) = (n.min(MOST), k.min(MOST));
    let (n_2, k_2) = (n * n, k * k);
    let (cos_2, sin_2) = (cos * cos, 1.0 - cos * cos);
    // (a + ib)² is the square of the index less the square of the sine.
    let t = n_2 - k_2 - sin_2;
    let length = (t * t + 4.0 * (n_2 * k_2)).sqrt();
    // The larger of a² and b² first: the smaller would cancel.
    let larger = 0.5 * (length + t.abs());
    let a = (if t < 0.0 { n_2 * k_2 / larger } else { larger }).sqrt();
    let a = if larger == 0.0 { 0.0 } else { a };
    let across = part(length + cos_2, 2.0 * a * cos);
    let along = across * part(cos_2 * length + sin_2 * sin_2, 2.0 * a * cos * sin_2);
    (0.5 * (across + along)).clamp(0.0, 1.0)
}

#[inline(always)]
fn part(sum: f64, twice: f64) -> f64 {
    let ratio = (sum - twice) / (sum + twice);
    if sum + twice > 0.0 { ratio } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reflectance of a boundary at an angle in degrees.
    fn glass(here: f64, beyond: f64, degrees: f64) -> f64 {
        dielectric((beyond - here) / here, degrees.to_radians().cos()).reflectance
    }

    fn near(found: f64, truth: f64, most: f64, what: &str) {
        assert!((found - truth).abs() < most, "{what}: {found}, not {truth}");
    }

    #[test]
    fn glass_and_water_reflect_what_they_are_known_to() {
        let angles = [0.0, 45.0, 60.0, 75.0, 85.0, 89.0];
        let known: [(f64, &[f64]); 3] = [
            (1.5, &[0.04, 0.050240, 0.089187, 0.253061, 0.612800, 0.904185]),
            (1.33, &[0.020059, 0.027521, 0.059126, 0.211427, 0.582728]),
            (2.42, &[0.172395, 0.181521, 0.211598, 0.330627, 0.621622]),
        ];
        for (index, parts) in known {
            for (degrees, part) in angles.into_iter().zip(parts) {
                near(glass(1.0, index, degrees), *part, 1e-6, &format!("{index} at {degrees}"));
            }
        }
        for (degrees, part) in [(20.0, 0.041729), (40.0, 0.245291), (41.8, 0.890772)] {
            near(glass(1.5, 1.0, degrees), part, 1e-6, &format!("from glass at {degrees}"));
        }
        near(glass(1.0, 100.0, 0.0), 0.960788, 1e-6, "100");
    }

    #[test]
    fn indices_that_differ_by_an_ulp_reflect_next_to_nothing() {
        let ulp = 2.0_f64.powi(-23);
        let at = |degrees: f64| dielectric(ulp, degrees.to_radians().cos()).reflectance;
        near(at(0.0) / 3.5527e-15, 1.0, 1e-5, "0");
        near(at(89.0) / 3.82415e-8, 1.0, 1e-5, "89");
        near(at(89.99), 0.246361, 1e-6, "89.99");
        // No difference at all: nothing is reflected or bent, however grazing.
        for cos in [1.0, 0.5, 1e-4, 1e-9, f64::MIN_POSITIVE] {
            assert_eq!(dielectric(0.0, cos), Boundary { reflectance: 0.0, bend: 0.0 });
        }
    }

    #[test]
    fn polarising_and_critical_angles_are_where_they_are_known_to_be() {
        for (index, brewster) in [(1.5, 56.30993), (1.33, 53.06124)] {
            // There the light along the plane of incidence is not reflected at all.
            let cos = f64::to_radians(brewster).cos();
            let Boundary { reflectance, bend } = dielectric(index - 1.0, cos);
            let across = (bend / (bend + 2.0 * cos)).powi(2);
            near(reflectance / (0.5 * across), 1.0, 1e-9, "Brewster");
        }
        for (index, critical) in [(1.5, 41.81031), (1.33, 48.75347), (2.42, 24.40747)] {
            assert!(glass(index, 1.0, critical - 1e-5) < 1.0);
            assert_eq!(glass(index, 1.0, critical + 1e-5), 1.0);
        }
    }

    /// The mean over the hemisphere, by cosine.
    fn hemispherical(here: f64, beyond: f64) -> f64 {
        let steps = 400_000;
        let at = |i: i32| {
            let cos_2 = (f64::from(i) + 0.5) / f64::from(steps);
            dielectric((beyond - here) / here, cos_2.sqrt()).reflectance
        };
        (0..steps).map(at).sum::<f64>() / f64::from(steps)
    }

    #[test]
    fn diffuse_light_is_reflected_as_it_is_known_to() {
        near(hemispherical(1.0, 1.5), 0.0917780, 1e-6, "from air");
        for (index, part) in
            [(1.5, 0.5963458), (1.3, 0.4444567), (1.33, 0.4719491), (1.4, 0.5289855)]
        {
            near(hemispherical(index, 1.0), part, 1e-6, &format!("from {index}"));
        }
    }

    #[test]
    fn light_is_refracted_by_the_ratio_of_sines() {
        for (here, beyond) in [(1.0, 1.5), (1.5, 1.0), (1.0, 1.0 + 1e-7), (1.0, 100.0)] {
            for degrees in [0.0_f64, 1e-4, 10.0, 40.0, 80.0, 89.9, 89.9999] {
                let (sin, cos) = degrees.to_radians().sin_cos();
                if sin * here >= beyond {
                    continue;
                }
                let bend = dielectric((beyond - here) / here, cos).bend;
                // The way on is as long as the ratio of indices.
                let length = f64::hypot(sin, cos + bend);
                near(length * here / beyond, 1.0, 1e-12, &format!("{here} {beyond} {degrees}"));
            }
        }
    }

    #[test]
    fn metals_reflect_what_they_are_known_to() {
        let angles = [0.0, 45.0, 60.0, 75.0, 85.0, 89.0_f64];
        let known = [
            (
                "gold, 548.6 nm",
                (0.43, 2.455),
                [0.786916, 0.785459, 0.788132, 0.825029, 0.919646, 0.982462],
            ),
            (
                "gold, 659.5 nm",
                (0.14, 3.697),
                [0.962585, 0.961135, 0.958123, 0.956660, 0.975978, 0.994685],
            ),
            (
                "gold, 450.9 nm",
                (1.38, 1.914),
                [0.408220, 0.415468, 0.439799, 0.540234, 0.765842, 0.943683],
            ),
            ("silver", (0.06, 3.586), [0.982836, 0.982163, 0.980802, 0.980397, 0.989470, 0.997704]),
            ("copper", (1.02, 2.577), [0.619450, 0.618148, 0.621545, 0.670952, 0.829901, 0.960051]),
        ];
        for (name, (n, k), parts) in known {
            for (degrees, part) in angles.into_iter().zip(parts) {
                let found = conductor(n, k, degrees.to_radians().cos());
                near(found, part, 1e-6, &format!("{name} at {degrees}"));
            }
        }
    }

    #[test]
    fn a_metal_that_absorbs_nothing_is_glass() {
        for n in [0.2, 0.9, 1.0, 1.0 + 1e-7, 1.5, 100.0] {
            for i in 0..=1000 {
                let cos = f64::from(i) / 1000.0;
                let (metal, glass) = (conductor(n, 0.0, cos), dielectric(n - 1.0, cos).reflectance);
                assert!((metal - glass).abs() < 1e-6 || i == 0, "{n} at {cos}: {metal}, {glass}");
            }
        }
    }

    #[test]
    fn metals_at_the_ends_of_numbers_reflect_what_they_should() {
        near((1.0 - conductor(1e-3, 1e6, 1.0)) / 4e-15, 1.0, 0.1, "what is lost");
        for n in [0.0, 1e-300, 1e-3, 1.0, 1e20, 1e300] {
            for k in [1e6, 1e10, 1e20, 1e60, 1e300, f64::MAX] {
                for cos in [0.0, 1e-9, 0.3, 1.0] {
                    let found = conductor(n, k, cos);
                    assert!((0.0..=1.0).contains(&found), "{n} {k} {cos}: {found}");
                    // A perfect one at last, unless the index that slows light is as large.
                    assert!(found > 1.0 - 1e-5 || cos < 0.1, "{n} {k} {cos}: {found}");
                }
            }
        }
        for (n, k) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (f64::MIN_POSITIVE, 0.0)] {
            for cos in [0.0, 0.5, 1.0] {
                assert!((0.0..=1.0).contains(&conductor(n, k, cos)), "{n} {k} {cos}");
            }
        }
    }
}
