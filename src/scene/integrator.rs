//! Integrators: how light is followed.

use super::schema::Range;
use super::vocabulary::vocabulary;
use super::{At, Count, Depth, Length, LightCount, Paths, Switch};
use crate::diag::Span;

vocabulary! {
    /// How the light that reaches the camera is computed.
    pub enum Integrator: "integrator" {
        /// Direct light, and beside it the light that surrounds the scene: at each surface that
        /// scatters, rays of a random direction that meet nothing bring the light of `constant`
        /// lights and skies (ambient occlusion). Mirrors, glass and metal are followed as by
        /// `direct`.
        "ambient" => Ambient {
            /// Rays from each point towards what surrounds the scene.
            rays: Count = "16", Range::between(1.0, 65_536.0);
            /// How far a surface may be to hide what is behind it. Left out: however far.
            distance: Option<Length>, Range::above(0.0);
            /// Whether lamps and other lights shine as well.
            direct: Switch = "on";
            /// How many lights are asked at each point: all, or so many, chosen by importance.
            lights: LightCount = "all", Range::between(1.0, 65_536.0);
            /// Points of each of these lights.
            light_samples: Count = "1", Range::between(1.0, 65_536.0);
            /// How often light may be reflected or refracted by mirrors, glass and metal.
            specular_depth: Depth = "10", Range::between(0.0, 1e6);
            /// Where a ray goes on as several.
            splits: Splits = "{}";
            /// By what chance a ray is ended at mirrors, glass and metal.
            roulette: Roulette = "throughput";
            /// Which paths of light the picture shows, such as `"L S+ D E"`, caustics. Left out: all
            /// that are followed.
            paths: Option<Paths>;
        }
        /// Light that went from a lamp or another light to a surface that scatters it, and from
        /// there to the camera, straight or by mirrors, glass and metal; and no further.
        "direct" => Direct {
            /// Whether surfaces hide lamps from each other.
            shadows: Switch = "on";
            /// Which points of a lamp with an area shine.
            area_lights: AreaLights = "random";
            /// Whether what surrounds the scene lights surfaces, `constant` lights and skies; if
            /// not, it is seen behind the scene, and lights nothing.
            environment: Switch = "off";
            /// How many lights are asked at each point: all, or so many, chosen by importance.
            lights: LightCount = "all", Range::between(1.0, 65_536.0);
            /// Points of each of these lights.
            light_samples: Count = "1", Range::between(1.0, 65_536.0);
            /// How often light may be reflected or refracted by mirrors, glass and metal.
            specular_depth: Depth = "10", Range::between(0.0, 1e6);
            /// Where a ray goes on as several.
            splits: Splits = "{}";
            /// By what chance a ray is ended at mirrors, glass and metal.
            roulette: Roulette = "throughput";
            /// Which paths of light the picture shows, such as `"L S+ D E"`, caustics. Left out: all
            /// that are followed.
            paths: Option<Paths>;
        }
        /// All light, however often it was scattered: paths from the camera.
        "path" => Path {
            /// Whether lights are asked at each point; if not, paths find lamps by chance alone.
            next_event: Switch = "on";
            /// Whether both ways to find a lamp are weighed against each other (multiple
            /// importance sampling); if not, lights that are asked count by that alone.
            mis: Switch = "on";
            /// How many lights are asked at each point: all, or so many, chosen by importance. Left
            /// out: both of two; of more, one.
            lights: Option<LightCount>, Range::between(1.0, 65_536.0);
            /// Points of each of these lights.
            light_samples: Count = "1", Range::between(1.0, 65_536.0);
            /// Where a path goes on as several.
            splits: Splits = "{}";
            /// By what chance a path is ended.
            roulette: Roulette = "throughput";
            /// Scatterings before paths may be ended by `roulette`.
            roulette_after: Count = "3", Range::between(0.0, 1e6);
            /// Where paths look for light beside the directions that surfaces scatter it from: the
            /// noise changes, the picture does not.
            guide: Guide = "off";
            /// How many pixels share what each of them finds of the light that comes from surface to
            /// surface: the noise changes, the picture does not. At 1 none do.
            reuse: Count = "1", Range::between(1.0, 64.0);
            /// How often light may be scattered. Light from a lamp to a surface to the camera was
            /// scattered once.
            depth: Depth = "unlimited", Range::between(0.0, 1e6);
            /// Which paths of light the picture shows, such as `"L S+ D E"`, caustics. Left out: all
            /// that are followed.
            paths: Option<Paths>;
        }
        /// What is where: colours, shaded by a light at the camera. No lamps, no shadows.
        "preview" => Preview {}
    }
}

vocabulary! {
    /// Where one ray goes on as several: at the first surfaces of a kind that it meets. There no
    /// ray is ended by roulette.
    pub struct Splits {
        /// Surfaces of mirror, glass or metal, from the first that is met, where all ways on are
        /// followed, the reflected and the refracted one.
        specular: Count = "0", Range::between(0.0, 16.0);
        /// Surfaces that scatter, from the first that is met, where `rays` of them go on.
        diffuse: Count = "0", Range::between(0.0, 8.0);
        /// How many rays go on from a surface that scatters.
        rays: Count = "5", Range::between(1.0, 1024.0);
    }
}

vocabulary! {
    /// By what chance a path goes on; what is left of it is weighed up by that.
    pub words Roulette: "roulette" {
        /// None is ended before its depth.
        "off" => Off
        /// The mean of the three channels of what the surface gives back.
        "mean" => Mean
        /// The luminance of what the surface gives back.
        "luminance" => Luminance
        /// The largest channel of what the path would still bring of light, at most 1.
        "throughput" => Throughput
    }
}

vocabulary! {
    /// Where paths look for light beside what the surfaces say.
    pub words Guide: "guide" {
        /// Nowhere.
        "off" => Off
        /// Where the light of lamps and suns comes from that photons, sent from them beforehand, found
        /// to reach surfaces by way of mirrors, glass and metal.
        "photons" => Photons
    }
}

vocabulary! {
    /// Which points of a lamp with an area shine on a surface.
    pub words AreaLights: "choice of lamp points" {
        /// Its centre alone, with all its flux, as in Larsen's simplification: hard shadows, and
        /// wrong close to the lamp.
        "center" => Center
        /// A random point for every sample: right on average, soft shadows.
        "random" => Random
    }
}

impl Integrator {
    /// Whether photons are asked for, to tell paths where light comes from.
    pub fn is_guided(&self) -> bool {
        matches!(self, Self::Path(path) if path.guide.value == Guide::Photons)
    }

    /// Whether any light is followed.
    pub fn follows_light(&self) -> bool {
        !matches!(self, Self::Preview(_))
    }

    /// Which paths of light are shown, if not all; and where that is said.
    pub fn paths(&self) -> Option<At<&Paths>> {
        let paths = match self {
            Self::Ambient(ambient) => &ambient.paths,
            Self::Direct(direct) => &direct.paths,
            Self::Path(path) => &path.paths,
            Self::Preview(_) => return None,
        };
        paths.as_ref().map(|shown| At::new(shown, paths.span))
    }

    /// Whether lamps and other lights shine on surfaces, and where that is said if they do not.
    pub fn lit_by_lights(&self) -> Result<(), Span> {
        match self {
            Self::Ambient(ambient) if !ambient.direct.0 => Err(ambient.direct.span),
            _ => Ok(()),
        }
    }

    /// Whether what surrounds the scene lights surfaces.
    pub fn lit_by_surroundings(&self) -> bool {
        match self {
            Self::Ambient(_) | Self::Path(_) => true,
            Self::Direct(direct) => direct.environment.0,
            Self::Preview(_) => false,
        }
    }

    /// Whether surfaces ask lights for what they send, and where that is said if they do not.
    pub fn asks_lights(&self) -> Result<(), Span> {
        match self {
            Self::Path(path) if !path.next_event.0 => Err(path.next_event.span),
            _ => self.lit_by_lights(),
        }
    }

    /// Whether what surrounds the scene is among the lights that are asked.
    pub fn asks_surroundings(&self) -> bool {
        match self {
            Self::Direct(direct) => direct.environment.0,
            Self::Path(path) => path.next_event.0,
            Self::Ambient(_) | Self::Preview(_) => false,
        }
    }

    /// Whether surfaces hide lights, and where that is said if they do not.
    pub fn shadows(&self) -> Result<(), Span> {
        match self {
            Self::Direct(direct) if !direct.shadows.0 => Err(direct.shadows.span),
            _ => Ok(()),
        }
    }

    /// Whether points of lamps are chosen, and where that is said if they are not.
    pub fn lamp_points(&self) -> Result<(), Span> {
        match self {
            Self::Direct(direct) if direct.area_lights.value == AreaLights::Center => {
                Err(direct.area_lights.span)
            }
            _ => Ok(()),
        }
    }

    /// How often light may meet surfaces that scatter it; None: however often.
    pub fn scatterings(&self) -> Option<u64> {
        match self {
            Self::Ambient(_) | Self::Direct(_) => Some(1),
            Self::Path(path) => path.depth.most(),
            Self::Preview(_) => Some(0),
        }
    }
}
