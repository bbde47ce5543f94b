//! Lights: what shines without being the surface of an object.

use std::f64::consts::{FRAC_PI_2, PI};

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{
    Angle, Count, Direction, Intensity, Irradiance, Number, Point, Radiance, Reflectance, Time,
};
use crate::diag::Span;
use crate::math::Spectrum;

vocabulary! {
    /// Light that comes from no surface. Lamps with a surface are objects with an emission.
    pub enum Light: "light" {
        /// The same radiance from everywhere around the scene. Under plain `direct` it is seen
        /// behind the scene, and lights nothing; `environment: on` makes it shine.
        "constant" => Constant {
            /// What is seen of it.
            radiance: Radiance;
        }
        /// Parallel light from infinitely far away.
        "directional" => Directional {
            /// Where the light goes.
            direction: Direction;
            /// On a surface square to it.
            irradiance: Irradiance;
        }
        /// The clear sky of a place and a time, and the sun in it, by the model of Preetham,
        /// Shirley and Smits. By day only: with the sun below the horizon there is no light.
        "preetham" => Preetham {
            /// How much thicker the whole air is than pure air: 2 is very clear, 3 clear, 6 hazy.
            turbidity: Number, Range::between(1.7, 10.0).because(
                "The model holds for clear and hazy air. For thinner air parts of the sky would be \
                 darker than black, and for thicker air too, with a low sun.",
                "write 2 for very clear air, 3 for clear, 6 for hazy, at most 10",
            );
            /// How far north of the equator the place is.
            latitude: Angle, Range::between(-FRAC_PI_2, FRAC_PI_2);
            /// Day of the year: 1 is the first of January.
            day: Count, Range::between(1.0, 366.0);
            /// Time of the day: solar time, by which the sun is highest at 12:00; with `longitude`
            /// and `zone` what a clock shows.
            time: Time, Range::between(0.0, 86_400.0);
            /// How far east of Greenwich the place is, for the time of a clock.
            longitude: Option<Angle>, Range::between(-PI, PI);
            /// How far the clock is ahead of Greenwich: `1 h`, and `2 h` in summer, in Denmark.
            zone: Option<Time>, Range::between(-50_400.0, 50_400.0);
            /// Where north is. What of it points along `up` does not count.
            north: Direction = "-z";
            /// Where the zenith is.
            up: Direction = "y";
            /// What shines as the sun.
            sun: SunForm = "disc {}";
            /// How much light the ground gives back that is seen below the horizon, and lights
            /// things from below: it is lit by sun and sky. By default it is black, as ground is
            /// that the scene has itself.
            ground: Reflectance = "0";
        }
        /// Light of a point, the same in every direction; its flux is 4 pi sr times its intensity.
        /// It lights surfaces, and is not seen itself.
        "point" => PointLight {
            /// Where it is.
            position: Point;
            /// What it sends in every direction: at a distance of d, an irradiance of
            /// intensity / d^2.
            intensity: Intensity;
        }
        /// Light of a point within a cone. It lights surfaces, and is not seen itself.
        "spot" => SpotLight {
            /// Where it is.
            position: Point;
            /// Where its axis goes.
            direction: Direction;
            /// What it sends along its axis, and up to where it fades.
            intensity: Intensity;
            /// From the axis to the edge of the cone; beyond it there is no light.
            cone: Angle, Range::above(0.0).up_to(PI);
            /// The outer part of the cone, in which the light fades to nothing: by t^2 (3 - 2 t),
            /// where t is 0 at the edge, 1 where the light is whole, and goes with the cosine of
            /// the angle to the axis. At most `cone`.
            falloff: Angle = "0 deg", Range::between(0.0, PI);
        }
    }
}

vocabulary! {
    /// What shines as the sun of a sky: always with the light that the model's sun has.
    pub enum SunForm: "sun" {
        /// A round disc, bright all over: shadows have soft edges.
        "disc" => SunDisc {
            /// Half the angle that it fills. A larger disc is darker: its irradiance is the same.
            half_angle: Angle = "0.00465 rad",
                Range::between(0.01_f64.to_radians(), 30_f64.to_radians());
        }
        /// A single direction: shadows have hard edges, and the sun itself is not seen.
        "direction" => SunDirection {}
        /// Nothing: the light of the sky alone, as with the sun behind a hand.
        "none" => NoSun {}
    }
}

/// What a light shines with.
#[derive(Clone, Copy, Debug)]
pub struct Shine<'a> {
    /// The field's word.
    pub what: &'static str,
    /// Its value.
    pub spectrum: &'a Spectrum,
    /// Where that is said.
    pub at: Span,
}

impl Light {
    /// What it shines with; None of a sky, of which no field says it.
    pub fn shine(&self) -> Option<Shine<'_>> {
        let (what, spectrum, at) = match self {
            Self::Constant(it) => ("radiance", &it.radiance.value.0, it.radiance.span),
            Self::Directional(it) => ("irradiance", &it.irradiance.value.0, it.irradiance.span),
            Self::PointLight(it) => ("intensity", &it.intensity.value.0, it.intensity.span),
            Self::SpotLight(it) => ("intensity", &it.intensity.value.0, it.intensity.span),
            Self::Preetham(_) => return None,
        };
        Some(Shine { what, spectrum, at })
    }

    /// Whether it, or the sky it makes, has an extent: a ray that meets nothing sees it.
    pub fn has_extent(&self) -> bool {
        match self {
            Self::Constant(_) | Self::Preetham(_) => true,
            Self::Directional(_) | Self::PointLight(_) | Self::SpotLight(_) => false,
        }
    }
}
