//! Glass at its ends: of index one, of slivers, in the same place twice.

use glam::{DVec3, dvec3};
use scn::math::Mesh;
use scn::scene::{self, Depth, Integrator, Roulette};

use crate::by_hand::{Hand, at, path, splits};
use crate::{direct, made_of, tracer};

#[test]
fn glass_of_index_one_is_not_there() {
    let scene = |material: &str| {
        let hand = Hand::new(without_lamps()).glass("nothing", 1.0).material("paint", 0.0, 0.2);
        let hand = hand.background(0.3);
        let hand = hand.quad(DVec3::NEG_Z * 3.0, DVec3::X * 9.0, DVec3::Y * 0.2, "paint");
        let hand = match material {
            "nothing" => hand.sphere(DVec3::ZERO, 1.0, "nothing"),
            _ => hand,
        };
        hand.camera(DVec3::Z * 4.0, DVec3::ZERO, 40.0).size(32, 32).picture()
    };
    // Emission and background alone: what is seen is where it was, but for edges.
    let (with, without) = (scene("nothing"), scene("none"));
    let apart = with.pixels.iter().zip(&without.pixels).filter(|(a, b)| (a.g - b.g).abs() > 1e-5);
    assert!(apart.count() <= 4, "things were moved");
}

/// Light that no surface scatters.
fn without_lamps() -> Integrator {
    let mut glass_only = path();
    glass_only.next_event = at(scene::Switch(false));
    glass_only.depth = at(Depth::Most(2));
    glass_only.roulette = at(Roulette::Off);
    glass_only.splits = at(splits(4, 0, 1));
    Integrator::Path(glass_only)
}

/// A prism whose sides are of strips a millionth of its length wide, between two wide ones, and
/// whose ends are of needles.
fn sliver_prism(strips: u32) -> Mesh {
    let mut mesh = Mesh { material_names: vec!["glass".into()], ..Mesh::default() };
    let corner = |i: u32| {
        let turn = std::f64::consts::TAU * f64::from(i % 3) / 3.0 + 0.5;
        dvec3(turn.cos(), turn.sin(), 0.0)
    };
    // Around the outline; each point at the front end, then at the back.
    for side in 0..3 {
        for strip in 0..strips {
            let part = match strip {
                0 => 0.0,
                n => 0.5 + 1e-6 * f64::from(n),
            };
            let point = corner(side).lerp(corner(side + 1), part);
            mesh.positions.extend([point + 0.5 * DVec3::Z, point - 0.5 * DVec3::Z]);
        }
    }
    let around = 3 * strips;
    for i in 0..around {
        let (a, b) = (2 * i, 2 * ((i + 1) % around));
        mesh.triangles.extend([[a, a + 1, b], [b, a + 1, b + 1]]);
        if i + 2 < around {
            // Fans of needles from the first point.
            mesh.triangles.extend([[0, 2 * i + 2, 2 * i + 4], [1, 2 * i + 5, 2 * i + 3]]);
        }
    }
    mesh.slots = vec![0; mesh.triangles.len()];
    mesh
}

#[test]
fn a_prism_of_slivers_loses_no_light() {
    let strips = 200;
    for (scale, tilt) in [(1.0, 0.0), (1e-4, 0.3), (1e5, -0.2)] {
        for integrator in [tracer(0), direct(0)] {
            let hand = Hand::new(integrator).glass("glass", 1.5).background(1.0);
            let hand = made_of(hand.mesh(sliver_prism(strips), scale, 0.0), "glass");
            // Towards the middle of the slivers of a side, so near that they fill the view.
            let angle = f64::to_radians(60.0) + 0.5;
            let middle = 0.5 * dvec3(angle.cos(), angle.sin(), tilt);
            let out = dvec3(angle.cos(), angle.sin(), 0.4).normalize();
            let hand = hand
                .camera(scale * (middle + 0.05 * out), scale * middle, 0.4)
                .size(24, 24)
                .samples(16);
            for pixel in hand.picture().pixels {
                assert!((pixel.g - 1.0).abs() < 1e-3, "{scale}: {pixel:?}");
            }
        }
    }
}

/// Twice the same surface, or glass upon paint: the one that was said first is met, whichever way
/// and however many threads look.
#[test]
fn of_surfaces_in_one_place_the_first_is_met() {
    let quad = |hand: Hand, material: &str| {
        let hand = hand.quad(DVec3::ZERO, DVec3::X, DVec3::Y, material);
        if material != "glass" {
            return hand;
        }
        // The other sides of a box: glass has a closed surface.
        let half = DVec3::Z * 0.5;
        hand.quad(-2.0 * half, -DVec3::X, DVec3::Y, material)
            .quad(-DVec3::X - half, half, DVec3::Y, material)
            .quad(DVec3::X - half, -half, DVec3::Y, material)
            .quad(DVec3::Y - half, DVec3::X, -half, material)
            .quad(-DVec3::Y - half, DVec3::X, half, material)
    };
    let start = || {
        Hand::new(tracer(0))
            .glass("glass", 1.5)
            .mirror("mirror", 0.5)
            .material("paint", 0.6, 0.0)
            .material("lamp", 0.0, 3.0)
            .background(1.0)
            .camera(dvec3(0.2, 0.3, 2.0), DVec3::ZERO, 10.0)
            .size(8, 8)
            .samples(16)
    };
    let all = ["glass", "mirror", "paint", "lamp"];
    for first in all {
        let alone = quad(start(), first).picture();
        // Two bodies of glass in one place are refused.
        for second in all.into_iter().filter(|second| [first, *second] != ["glass"; 2]) {
            let mut hand = quad(quad(start(), first), second);
            if first == "glass" {
                // What is behind the glass is in its place too: it is met by no ray that leaves it.
                hand = hand.quad(DVec3::Z * -0.5, DVec3::X, DVec3::Y, "paint");
            }
            let picture = hand.picture();
            assert!(picture.pixels.iter().all(|it| it.is_finite() && it.g >= 0.0));
            if first != "glass" && second != "lamp" && first != "lamp" {
                assert!(picture == alone, "{first} before {second}");
            }
        }
    }
}
