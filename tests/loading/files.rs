//! Files that are read: their faults, told once and where they are.

use std::fs;
use std::sync::Arc;

use scn::diag::Code;
use scn::load::{Loader, Stage};
use scn::math::NoProgress;
use scn::scene::Ref;

use crate::{FACE, Folder, PAINTED, at, one, said, scene, sources, stage, told};

#[test]
fn files_that_cannot_be_read_are_told_on_the_field() {
    let folder = Folder::with(&[("bunny.obj", FACE)]);
    let (_, found, _) = stage(folder.mesh("buny.obj"));
    assert_eq!(found[0].code, Code::FILE_UNREADABLE);
    assert_eq!(found[0].headline, "the file `buny.obj` does not exist");
    assert!(found[0].help.as_ref().unwrap().contains("`bunny.obj`"));
    assert_eq!(one(folder.mesh(".")).0, Code::FILE_UNREADABLE);
    #[cfg(unix)]
    for device in ["/dev/zero", "/dev/null"] {
        let mut mesh = folder.mesh("x");
        mesh.file.value.path = device.into();
        assert_eq!(one(mesh), said(Code::FILE_UNREADABLE, "a.scn", 1, "mesh"));
    }
}

#[test]
fn mtllib_stays_in_its_folder() {
    for name in ["../a.mtl", "/etc/passwd", "C:\\a.mtl", "x\\..\\..\\a.mtl"] {
        let folder = Folder::with(&[("a.obj", &PAINTED.replace("a.mtl", name))]);
        let words = format!("mtllib {name}");
        assert_eq!(one(folder.mesh("a.obj")), said(Code::FILE_OUTSIDE_FOLDER, "a.obj", 1, &words));
    }
    let folder = Folder::with(&[("a.obj", PAINTED)]);
    let wanted = said(Code::FILE_UNREADABLE, "a.obj", 1, "mtllib a.mtl");
    assert_eq!(one(folder.mesh("a.obj")), wanted);
    let folder = Folder::with(&[("a.obj", &PAINTED.replace("a.mtl", "."))]);
    assert_eq!(one(folder.mesh("a.obj")).0, Code::FILE_UNREADABLE);
}

#[test]
fn faults_of_the_mesh_are_told_in_it() {
    let folder = Folder::with(&[("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n")]);
    assert_eq!(one(folder.mesh("a.obj")), said(Code::MESH_BAD_INDEX, "a.obj", 5, "9"));
    let (_, found, _) = stage(folder.mesh("a.obj"));
    assert_eq!(found[0].headline, "the face in line 5 of `a.obj` uses vertex 9; the file has 3");
    assert_eq!(found[0].labels[1].span, at(()).span);

    let many = Folder::with(&[("a.obj", &"v 1 2\n".repeat(100))]);
    let (_, found, _) = stage(many.mesh("a.obj"));
    assert_eq!(found.len(), 20);
    let why = found[19].why.as_ref().unwrap();
    assert_eq!(why, "`a.obj` has 80 further faults, often of the same kinds.");
}

#[test]
fn meshes_without_a_surface_are_told() {
    let folder = Folder::with(&[
        ("empty.obj", ""),
        ("points.obj", "v 0 0 0\np 1\n"),
        ("flat.obj", "v 0 0 0\nv 1 1 1\nf 1 2 2\n"),
        ("ply.obj", "ply\n"),
    ]);
    assert_eq!(one(folder.mesh("empty.obj")), said(Code::MESH_NO_FACES, "a.scn", 1, "mesh"));
    let codes = |file| told(folder.mesh(file)).iter().map(|t| t.0).collect::<Vec<_>>();
    assert_eq!(codes("points.obj"), [Code::MESH_NOT_RENDERED, Code::MESH_NO_FACES]);
    assert_eq!(codes("flat.obj"), [Code::MESH_DEGENERATE_TRIANGLES, Code::MESH_NO_FACES]);
    assert_eq!(codes("ply.obj"), [Code::MESH_NOT_WAVEFRONT]);
}

#[test]
fn triangles_left_out_are_counted_and_shown() {
    let text = format!("{FACE}f 1 1 2\nf 2 2 3\nf 3 2 1\n");
    let folder = Folder::with(&[("a.obj", &text)]);
    let mut mesh = folder.mesh("a.obj");
    mesh.material = at(Some(Ref::new("grey")));
    let wanted = [
        said(Code::MESH_DEGENERATE_TRIANGLES, "a.obj", 5, "f 1 1 2"),
        said(Code::MESH_REPEATED_TRIANGLES, "a.obj", 7, "f 3 2 1"),
    ];
    assert_eq!(told(mesh.clone()), wanted);
    let (stage, found, _) = stage(mesh);
    assert_eq!(found[0].headline, "2 triangles of `a.obj` have no area and are left out");
    assert_eq!(stage.unwrap().files[0].triangles, Some(1));
}

#[test]
fn a_file_is_read_once_and_its_faults_are_told_once() {
    let folder = Folder::with(&[("a.obj", &format!("{FACE}f 1 1 2\n"))]);
    let mut mesh = folder.mesh("a.obj");
    mesh.material = at(Some(Ref::new("grey")));
    let scene = scene(vec![("one", mesh.clone()), ("two", mesh)]);
    let (mut loader, mut sources) = (Loader::new(&NoProgress), sources());
    let (first, found) = loader.stage(&scene, &mut sources);
    assert_eq!(found.len(), 1);
    // What is gone from the disk is still there.
    fs::remove_file(folder.0.path().join("a.obj")).unwrap();
    let known = loader.stage(&scene, &mut sources);
    assert!(known.1.is_empty());
    let (first, second) = (first.unwrap(), known.0.unwrap());
    let mesh = |stage: &Stage, i: usize| stage.meshes[i].as_ref().unwrap().mesh.clone();
    assert!(Arc::ptr_eq(&mesh(&first, 0), &mesh(&second, 1)));
    assert_eq!((first.files.len(), first.hash), (1, second.hash));
}

#[test]
fn what_renders_share_is_told_for_the_first() {
    let folder = Folder::with(&[("a.obj", PAINTED), ("a.mtl", "newmtl red\nKd 1\n")]);
    let scene = scene(vec![("thing", folder.mesh("a.obj"))]);
    let (mut loader, mut sources) = (Loader::new(&NoProgress), sources());
    let (first, found) = loader.stage(&scene, &mut sources);
    assert_eq!((first.is_none(), found.len()), (true, 1));
    let (second, found) = loader.stage(&scene, &mut sources);
    assert!(second.is_none() && found.is_empty());
}
