//! Several materials in one surface, too fine to be told apart: each does its part.

use glam::{DVec2, Vec3};

use super::{Bsdf, Event, Facing, Interface, Lambert, Part, Scattered, Surface};
use crate::math::Rgb;

/// Materials and the part of each.
#[derive(Clone, Debug, PartialEq)]
pub struct Mixture {
    /// The parts sum to 1. At most one of them lets light through.
    pub parts: Vec<(f32, Surface)>,
}

impl Mixture {
    pub(super) fn at(&self, uv: DVec2, facing: &Facing) -> Mixed {
        let mut mixed = Mixed {
            lambert: Lambert::black(facing),
            wi: Vec3::ZERO,
            reflected: Rgb::BLACK,
            refracted: None,
        };
        for (part, surface) in &self.parts {
            mixed.add(*part, &surface.at(uv, facing));
        }
        mixed
    }

    pub(super) fn colour(&self, uv: DVec2) -> Rgb {
        let parts = self.parts.iter();
        parts.fold(Rgb::BLACK, |sum, (part, surface)| sum + surface.colour(uv) * *part)
    }
}

/// A mixture at a hit. What is diffuse is so together; what is reflected in one direction has the
/// same one.
#[derive(Clone, Copy, Debug)]
pub struct Mixed {
    /// All that is scattered to all sides.
    lambert: Lambert,
    /// Where light comes from that is reflected in one direction; zero before there is any.
    wi: Vec3,
    /// The part of it that is given back.
    reflected: Rgb,
    /// Light that goes through: the part of the surface that lets it.
    refracted: Option<(f32, Interface)>,
}

/// With which chance each of the three is sampled.
struct Chances {
    scattered: f32,
    reflected: f32,
    refracted: f32,
}

impl Mixed {
    fn add(&mut self, part: f32, bsdf: &Bsdf) {
        match bsdf {
            Bsdf::Lambert(lambert) => self.lambert.albedo += lambert.albedo * part,
            Bsdf::Reflector(reflector) => {
                self.wi = reflector.wi;
                self.reflected += reflector.reflectance * part;
            }
            Bsdf::Interface(interface) => {
                self.wi = interface.wi();
                self.reflected += Rgb::grey(interface.reflectance() * part);
                self.refracted = Some((part, *interface));
            }
            Bsdf::Mixed(mixed) => {
                self.lambert.albedo += mixed.lambert.albedo * part;
                self.reflected += mixed.reflected * part;
                if mixed.wi != Vec3::ZERO {
                    self.wi = mixed.wi;
                }
                if let Some((within, interface)) = mixed.refracted {
                    self.refracted = Some((part * within, interface));
                }
            }
        }
    }

    pub(super) fn lambert(&self) -> &Lambert {
        &self.lambert
    }

    pub(super) fn scatters(&self) -> bool {
        !self.lambert.albedo.is_black()
    }

    pub(super) fn is_specular(&self) -> bool {
        self.wi != Vec3::ZERO
    }

    /// All directions that are the only ones.
    pub(super) fn specular(&self) -> [Option<Scattered>; 2] {
        let reflected = (!self.reflected.is_black()).then_some(Scattered {
            wi: self.wi,
            weight: self.reflected,
            squeeze: 1.0,
            pdf_w: 0.0,
            event: Event::SpecularReflection,
        });
        let refracted = self.refracted.and_then(|(part, interface)| {
            interface.refracted().map(|way| Scattered { weight: way.weight * part, ..way })
        });
        [reflected, refracted]
    }

    /// By how much light comes by each, on average over the channels.
    fn chances(&self, part: Part) -> Chances {
        let (specular, scattering) = (part != Part::Scattering, part != Part::Specular);
        let of = |asked: bool, light: f32| if asked { light.max(0.0) } else { 0.0 };
        let through = |(part, interface): (f32, Interface)| part * interface.transmittance();
        let scattered = of(scattering, self.lambert.albedo.mean());
        let reflected = of(specular, self.reflected.mean());
        let refracted = of(specular, self.refracted.map_or(0.0, through));
        let sum = (scattered + reflected + refracted).max(f32::MIN_POSITIVE);
        Chances {
            scattered: scattered / sum,
            reflected: reflected / sum,
            refracted: refracted / sum,
        }
    }

    /// One of the three, and its direction.
    pub(super) fn sample(&self, part: Part, u: [f64; 4]) -> Option<Scattered> {
        let Chances { scattered, reflected, refracted } = self.chances(part);
        let choice = u[2] as f32;
        let (way, chance) = if choice < scattered {
            let way = self.lambert.sample([u[0], u[1]]);
            (way.map(|way| Scattered { pdf_w: way.pdf_w * scattered, ..way }), scattered)
        } else {
            let [mirrored, through] = self.specular();
            let is_reflected = choice < scattered + reflected || refracted == 0.0;
            if is_reflected { (mirrored, reflected) } else { (through, refracted) }
        };
        // What is left by rounding behind the last chance has none.
        way.filter(|_| chance > 0.0).map(|way| Scattered { weight: way.weight / chance, ..way })
    }

    /// With which chance what is scattered to all sides is sampled.
    pub(super) fn chance(&self, part: Part) -> f32 {
        self.chances(part).scattered
    }
}

#[cfg(test)]
mod tests {
    use super::super::facing::tests::{above, seen};
    use super::super::{Conductor, Dielectric, Diffuse, Mirror};
    use super::*;
    use crate::math::{chi_squared, random};
    use crate::render::textures::Colour;

    /// Paint, gold, a mirror and glass.
    fn everything() -> Mixture {
        let gold = Conductor::Channels { n: [0.14, 0.43, 1.38], k: [3.697, 2.455, 1.914] };
        let parts = vec![
            (0.4, Surface::Diffuse(Diffuse { albedo: Colour::Plain(Rgb::new(0.9, 0.3, 0.1)) })),
            (0.2, Surface::Conductor(gold)),
            (0.1, Surface::Mirror(Mirror { reflectance: Colour::Plain(Rgb::grey(0.8)) })),
            (0.3, Surface::Dielectric(Dielectric { inside: 1.5, outside: 1.0 })),
        ];
        Mixture { parts }
    }

    fn pdf_w(mixed: &Mixed, part: Part, wi: Vec3) -> f32 {
        mixed.chance(part) * mixed.lambert.pdf_w(wi)
    }

    fn numbers(place: u64) -> [f64; 4] {
        let [a, b] = random::unit_pair(random::at(8, 2 * place));
        let [c, d] = random::unit_pair(random::at(8, 2 * place + 1));
        [a, b, c, d]
    }

    #[test]
    fn a_mixture_does_what_its_parts_do_by_their_part() {
        for i in 0..1000 {
            let facing = seen(above(i), above(i + 1_000_000));
            let whole = everything().at(DVec2::ZERO, &facing);
            let mut nested = everything();
            let rest = nested.parts.split_off(2);
            let inner: Vec<_> = rest.into_iter().map(|(part, of)| (part / 0.4, of)).collect();
            nested.parts.push((0.4, Surface::Mixture(Mixture { parts: inner })));
            let nested = nested.at(DVec2::ZERO, &facing);
            for mixed in [&whole, &nested] {
                let [reflected, refracted] = mixed.specular();
                let (mut mirrored, mut through) = (Rgb::BLACK, Rgb::BLACK);
                for (part, surface) in &everything().parts {
                    for way in surface.at(DVec2::ZERO, &facing).specular().into_iter().flatten() {
                        match way.event {
                            Event::SpecularReflection => mirrored += way.weight * *part,
                            _ => through += way.weight * *part,
                        }
                        let other = if way.wi.z > 0.0 { reflected } else { refracted };
                        assert!((other.unwrap().wi - way.wi).length() < 1e-6);
                    }
                }
                let near = |a: Rgb, b: Rgb| (a - b).to_array().iter().all(|off| off.abs() < 1e-6);
                assert!(near(mirrored, reflected.unwrap().weight));
                assert!(near(through, refracted.map_or(Rgb::BLACK, |way| way.weight)));
                assert!(near(mixed.lambert.albedo, Rgb::new(0.36, 0.12, 0.04)));
            }
        }
    }

    #[test]
    fn samples_bring_what_there_is_and_no_more() {
        let facing = seen(Vec3::new(0.6, 0.0, 0.8), Vec3::Z);
        let mixed = everything().at(DVec2::ZERO, &facing);
        let [reflected, refracted] = mixed.specular().map(|way| way.unwrap().weight);
        let scattered = mixed.lambert.albedo;
        for (part, truth) in [
            (Part::All, scattered + reflected + refracted),
            (Part::Scattering, scattered),
            (Part::Specular, reflected + refracted),
        ] {
            let count = 200_000;
            let ways = (0..count).filter_map(|i| mixed.sample(part, numbers(i)));
            let mut sums = [0.0_f64; 3];
            for way in ways {
                for (sum, weight) in sums.iter_mut().zip(way.weight.to_array()) {
                    *sum += f64::from(weight) / count as f64;
                }
            }
            for (found, truth) in sums.into_iter().zip(truth.to_array()) {
                assert!((found - f64::from(truth)).abs() < 0.004, "{part:?}: {found}, {truth}");
            }
        }
        assert!(mixed.sample(Part::Scattering, numbers(0)).unwrap().pdf_w > 0.0);
    }

    #[test]
    fn directions_follow_their_density() {
        const RINGS: usize = 8;
        const SECTORS: usize = 12;
        let mixed = everything().at(DVec2::ZERO, &seen(Vec3::new(0.6, 0.0, 0.8), Vec3::Z));
        for part in [Part::All, Part::Scattering] {
            let mut counts = vec![0; RINGS * SECTORS + 1];
            for i in 0..100_000 {
                let way = mixed.sample(part, numbers(i)).filter(|way| way.pdf_w > 0.0);
                let Some(way) = way else {
                    counts[RINGS * SECTORS] += 1;
                    continue;
                };
                assert!((pdf_w(&mixed, part, way.wi) / way.pdf_w - 1.0).abs() < 1e-5);
                let turn = way.wi.y.atan2(way.wi.x) / std::f32::consts::TAU + 0.5;
                let ring = ((way.wi.z * RINGS as f32) as usize).min(RINGS - 1);
                counts[ring * SECTORS + ((turn * SECTORS as f32) as usize).min(SECTORS - 1)] += 1;
            }
            // The density integrated over each bin by its middle, where it is a straight line.
            let mut expected = Vec::new();
            for ring in 0..RINGS {
                let z = (ring as f32 + 0.5) / RINGS as f32;
                let pdf_w = pdf_w(&mixed, part, Vec3::new((1.0 - z * z).sqrt(), 0.0, z));
                let solid_angle = std::f64::consts::TAU / (RINGS * SECTORS) as f64;
                expected.extend([f64::from(pdf_w) * solid_angle; SECTORS]);
            }
            let rest = 1.0 - expected.iter().sum::<f64>();
            expected.push(if part == Part::All { rest } else { rest.max(0.0) });
            let sum: f64 = expected.iter().sum();
            expected.iter_mut().for_each(|part| *part /= sum);
            chi_squared::assert_fits(&counts, &expected);
        }
    }

    #[test]
    fn what_is_black_brings_nothing() {
        let parts = vec![
            (0.5, Surface::Diffuse(Diffuse { albedo: Colour::Plain(Rgb::BLACK) })),
            (0.5, Surface::Mirror(Mirror { reflectance: Colour::Plain(Rgb::BLACK) })),
        ];
        let mixed = Mixture { parts }.at(DVec2::ZERO, &seen(Vec3::Z, Vec3::Z));
        assert!(!mixed.scatters());
        for part in [Part::All, Part::Scattering, Part::Specular] {
            assert!((0..100).all(|i| mixed.sample(part, numbers(i)).is_none()));
            assert_eq!(pdf_w(&mixed, part, Vec3::Z), 0.0);
        }
    }
}
