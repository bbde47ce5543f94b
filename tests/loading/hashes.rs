//! The hashes of a scene: what changes them.

use std::sync::Arc;

use scn::diag::{FileId, Span};
use scn::load::Loader;
use scn::math::NoProgress;
use scn::scene::{At, Length, Ref};

use crate::{FACE, Folder, at, common, scene, sources, stage};

#[test]
fn the_hash_is_that_of_scene_and_files_wherever_they_are() {
    let hash = |obj: &str, unit: f64, name: &str| {
        let folder = Folder::with(&[(name, obj)]);
        let mut mesh = folder.mesh(name);
        mesh.material = at(Some(Ref::new("grey")));
        mesh.unit = At::new(Length(unit), Span::new(FileId(0), 2, 3));
        stage(mesh).0.unwrap().hash
    };
    let first = hash(FACE, 1.0, "a.obj");
    assert_eq!(hash(FACE, 1.0, "a.obj"), first);
    assert_ne!(hash(FACE, 2.0, "a.obj"), first);
    assert_ne!(hash(FACE, 1.0, "b.obj"), first);
    assert_ne!(hash(&format!("{FACE}# a word\n"), 1.0, "a.obj"), first);
    assert_eq!(first.to_string().len(), 64);
}

#[test]
fn limits_caption_and_exposure_change_the_hash_but_not_that_of_the_light() {
    let hashes = |change: fn(&mut scn::scene::Scene)| {
        let mut scene = Arc::unwrap_or_clone(scene(vec![]));
        change(&mut scene);
        let (stage, _) = Loader::new(&NoProgress).stage(&Arc::new(scene), &mut sources());
        let stage = stage.unwrap();
        (stage.hash, stage.light_hash)
    };
    let plain = hashes(|_| ());
    let changes: [fn(&mut scn::scene::Scene); 6] = [
        |scene| scene.stop.value.samples = at(Some(scn::scene::Count(7))),
        |scene| scene.stop.value.time = at(Some(scn::scene::Time(7.0))),
        |scene| scene.stop.value.error = at(Some(scn::scene::Number(0.1))),
        |scene| scene.stop.value.adaptive.value.0 = true,
        |scene| scene.caption.value.0.push_str("Light."),
        |scene| scene.film.value.exposure.value.0 = 1.0,
    ];
    for (i, change) in changes.into_iter().enumerate() {
        let changed = hashes(change);
        assert!(changed.0 != plain.0 && changed.1 == plain.1, "{i}");
    }
    let film = hashes(|scene| scene.film.value.size.value.0[0] += 1);
    assert!(film.0 != plain.0 && film.1 != plain.1);
}

#[test]
fn a_default_that_is_said_leaves_the_hash_as_it_is() {
    let hashes = |items: &str| {
        let text = format!(
            "scn 1 in m\nobject ball: sphere {{ center: (0, 0, 0), radius: 1 m, material: white }}\n\
             material white: diffuse {{ albedo: 0.5 }}\n{items}\n"
        );
        let (compiled, mut sources) = common::compile(&text);
        let render =
            compiled.renders.first().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let (stage, _) = Loader::new(&NoProgress).stage(&render.scene, &mut sources);
        let stage = stage.unwrap();
        (stage.hash, stage.light_hash)
    };
    let usual = hashes("integrator: path {}");
    assert_eq!(hashes("integrator: path { splits: { diffuse: 0 } }"), usual);
    assert_eq!(hashes("integrator: path {}\ncamera: overview { look: -z }"), usual);
    assert_ne!(hashes("integrator: path { splits: { diffuse: 1 } }"), usual);
    // How long it takes is not what it shows.
    let longer = hashes("integrator: path {}\nstop: { samples: 1024 }");
    assert_ne!(longer.0, usual.0);
    assert_eq!(longer.1, usual.1);
    let said = hashes("integrator: path {}\nfilm: { exposure: 0 ev }");
    assert_eq!(said, usual);
    let brighter = hashes("integrator: path {}\nfilm: { exposure: 1 ev }");
    assert!(brighter.0 != usual.0 && brighter.1 == usual.1);
}
