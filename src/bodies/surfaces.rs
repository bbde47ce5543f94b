//! The surfaces that media end at: those whose material names a medium, corners at one place
//! counted once.

use std::collections::HashMap;

use glam::DVec3;

use super::placed::{Body, Placed};
use crate::load::Stage;
use crate::math::Bounds;
use crate::scene::{Material, Medium, Named, Ref};

/// The number of what surrounds everything.
pub const SURROUNDINGS: u32 = 0;

/// The media of a stage that fill some space, by number.
pub(super) struct Media<'a> {
    stage: &'a Stage,
    /// None: a vacuum.
    pub all: Vec<Option<&'a Named<Medium>>>,
}

impl<'a> Media<'a> {
    /// With what surrounds everything.
    pub fn of(stage: &'a Stage) -> Self {
        let around = stage.scene.surroundings.as_ref().map(|name| stage.medium(name));
        Self { stage, all: vec![around] }
    }

    pub fn number(&mut self, name: &Ref<Medium>) -> u32 {
        let medium = self.stage.medium(name);
        let same =
            |known: &Option<&Named<Medium>>| known.is_some_and(|it| std::ptr::eq(it, medium));
        let at = self.all.iter().position(same).unwrap_or_else(|| {
            self.all.push(Some(medium));
            self.all.len() - 1
        });
        at as u32
    }
}

/// The surfaces of one slot of an object, and what is said of their sides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Skin {
    /// Which of the placed objects.
    pub object: u32,
    pub slot: u32,
    /// Behind the faces.
    pub inside: u32,
    /// Before them, where it is said.
    pub outside: Option<u32>,
}

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// Counter-clockwise seen from its front.
    pub corners: [u32; 3],
    pub skin: u32,
    /// Which of its object's triangles.
    pub triangle: u32,
}

/// A sphere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub centre: DVec3,
    pub radius: f64,
    pub skin: u32,
}

/// A plane without end; the normal has unit length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wall {
    pub point: DVec3,
    pub normal: DVec3,
    pub skin: u32,
}

/// All of them.
pub(super) struct Surfaces<'a> {
    pub placed: &'a [Placed<'a>],
    pub skins: Vec<Skin>,
    /// In metres.
    pub points: Vec<DVec3>,
    pub faces: Vec<Face>,
    pub balls: Vec<Ball>,
    pub walls: Vec<Wall>,
    /// Skins of disks: nothing closes with one.
    pub disks: Vec<u32>,
    /// The point of each corner of an object's mesh; [`Surfaces::NONE`] of those that no such
    /// surface has.
    pub numbers: HashMap<u32, Vec<u32>>,
}

impl<'a> Surfaces<'a> {
    /// In the place of a point.
    pub const NONE: u32 = u32::MAX;

    pub fn of(placed: &'a [Placed<'a>], media: &mut Media) -> Self {
        let mut all = Self {
            placed,
            skins: Vec::new(),
            points: Vec::new(),
            faces: Vec::new(),
            balls: Vec::new(),
            walls: Vec::new(),
            disks: Vec::new(),
            numbers: HashMap::new(),
        };
        let mut known = HashMap::new();
        for (number, object) in placed.iter().enumerate() {
            let mut skins = Vec::with_capacity(object.parts.len());
            for (slot, parts) in object.parts.iter().enumerate() {
                let sides = parts.iter().find_map(|(_, part)| part.value.value.sides());
                let skin = sides.map(|(inside, outside)| Skin {
                    object: number as u32,
                    slot: slot as u32,
                    inside: media.number(inside),
                    outside: outside.map(|name| media.number(name)),
                });
                // With the same on both sides nothing ends there.
                let skin = skin.filter(|skin| skin.outside != Some(skin.inside));
                skins.push(skin.map(|skin| {
                    all.skins.push(skin);
                    (all.skins.len() - 1) as u32
                }));
            }
            if skins.iter().any(Option::is_some) {
                all.add(number as u32, &object.body, &skins, &mut known);
            }
        }
        all
    }

    fn add(
        &mut self,
        object: u32,
        body: &Body,
        skins: &[Option<u32>],
        known: &mut HashMap<[u64; 3], u32>,
    ) {
        match body {
            Body::Mesh { mesh, to_metres } => {
                let mut numbers = vec![Self::NONE; mesh.positions.len()];
                let mirrors = to_metres.mirrors();
                for (triangle, of) in mesh.triangles.iter().enumerate() {
                    let slot = mesh.slots.get(triangle).copied().unwrap_or(0) as usize;
                    let Some(skin) = skins[slot] else { continue };
                    let [a, b, c] = of.map(|i| {
                        let number = &mut numbers[i as usize];
                        if *number == Self::NONE {
                            let at = to_metres.point(mesh.positions[i as usize]);
                            *number = self.point(at, known);
                        }
                        *number
                    });
                    let corners = if mirrors { [a, c, b] } else { [a, b, c] };
                    self.faces.push(Face { corners, skin, triangle: triangle as u32 });
                }
                self.numbers.insert(object, numbers);
            }
            Body::Face { corners, .. } => {
                let Some(skin) = skins[0] else { return };
                let numbers: Vec<_> = corners.iter().map(|p| self.point(*p, known)).collect();
                for i in 1..numbers.len() - 1 {
                    let corners = [numbers[0], numbers[i], numbers[i + 1]];
                    self.faces.push(Face { corners, skin, triangle: i as u32 - 1 });
                }
                self.numbers.insert(object, numbers);
            }
            Body::Sphere { centre, radius, .. } => {
                self.balls.extend(skins[0].map(|skin| Ball {
                    centre: *centre,
                    radius: *radius,
                    skin,
                }));
            }
            Body::Plane { point, normal, .. } => {
                self.walls.extend(skins[0].map(|skin| Wall {
                    point: *point,
                    normal: *normal,
                    skin,
                }));
            }
            Body::Disk { .. } => self.disks.extend(skins[0]),
        }
    }

    /// The number of the point at a place.
    fn point(&mut self, at: DVec3, known: &mut HashMap<[u64; 3], u32>) -> u32 {
        // Adding zero turns -0 into 0.
        let place = at.to_array().map(|x| (x + 0.0).to_bits());
        *known.entry(place).or_insert_with(|| {
            self.points.push(at);
            (self.points.len() - 1) as u32
        })
    }

    pub fn is_empty(&self) -> bool {
        self.skins.is_empty()
    }

    /// Corners of a face.
    pub fn corners(&self, face: usize) -> [DVec3; 3] {
        self.faces[face].corners.map(|i| self.points[i as usize])
    }

    pub fn bounds_of(&self, face: usize) -> Bounds {
        Bounds::around(self.corners(face))
    }

    pub fn skin(&self, face: usize) -> &Skin {
        &self.skins[self.faces[face].skin as usize]
    }

    /// The material of a skin.
    pub fn material(&self, skin: &Skin) -> &'a Named<Material> {
        self.owner(skin).materials[skin.slot as usize]
    }

    /// The object that a skin belongs to.
    pub fn owner(&self, skin: &Skin) -> &'a Placed<'a> {
        &self.placed[skin.object as usize]
    }
}
