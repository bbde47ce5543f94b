//! The pictures in docs/: each is shown by a page, and is still what its scene says.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use scn::files::png;

mod shots;

/// Where the scenes of pictures are.
const FOLDERS: [&str; 2] = ["scenes", "scenes/tour"];

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
    found
}

/// The pictures a page shows, `![words](path)`, as paths in the project.
fn shown(page: &Path) -> Vec<PathBuf> {
    let text = fs::read_to_string(page).unwrap();
    let links = text.split("![").skip(1).filter_map(|rest| {
        let (_, rest) = rest.split_once("](")?;
        Some(rest.split_once(')')?.0.to_string())
    });
    links.map(|link| page.parent().unwrap().join(link)).collect()
}

#[test]
fn every_picture_is_shown_and_every_picture_shown_is_there() {
    let mut pages = files(&shots::path("docs"), "md");
    pages.push(shots::path("README.md"));
    let mut all = Vec::new();
    for page in &pages {
        for picture in shown(page) {
            let found = picture.canonicalize();
            let found = found.unwrap_or_else(|_| panic!("{} is not there", picture.display()));
            all.push(found);
        }
    }
    for picture in files(&shots::path("docs"), "png") {
        let shown = all.contains(&picture.canonicalize().unwrap());
        assert!(shown, "no page shows {}", picture.display());
    }
}

#[test]
fn every_picture_is_what_its_scene_says_now() {
    let mut scenes = HashMap::new();
    let mut stale = Vec::new();
    let pictures = files(&shots::path("docs"), "png");
    assert!(!pictures.is_empty());
    for picture in pictures {
        if let Err(reason) = up_to_date(&picture, &mut scenes) {
            stale.push(format!("{}: {reason}", picture.display()));
        }
    }
    assert!(
        stale.is_empty(),
        "render these anew, as docs/worksheets.md and docs/tour.md say:\n{}",
        stale.join("\n")
    );
}

/// Holds the words in a picture against the scene it was made of.
fn up_to_date(
    picture: &Path,
    scenes: &mut HashMap<(String, String), Vec<shots::Shot>>,
) -> Result<(), String> {
    let words = png::read_metadata(picture).map_err(|failure| failure.to_string())?;
    let word = |key: &str| {
        let found = words.iter().find(|(name, _)| name == key).map(|(_, value)| value.clone());
        found.ok_or(format!("has no {key}"))
    };
    let (scene, render) = (word("scn:scene")?, word("scn:render")?);
    word("scn:seed")?.parse::<u64>().map_err(|_| "its scn:seed is no number")?;

    let sets = word("scn:set").unwrap_or_default();
    let shots = scenes.entry((scene.clone(), sets.clone())).or_insert_with(|| {
        let mut places = FOLDERS.iter().map(|folder| format!("{folder}/{scene}"));
        let file = places.find(|file| shots::path(file).exists());
        let file = file.unwrap_or_else(|| panic!("there is no scene {scene}"));
        let sets: Vec<String> = sets.lines().map(str::to_string).collect();
        shots::open_with(&file, &sets)
    });
    let shot = shots.iter().find(|shot| shot.name == render);
    let shot = shot.ok_or(format!("{scene} has no render {render}"))?;
    if word("scn:hash")? != shot.stage.hash.to_string() {
        return Err(format!("{scene} or its files have changed since {render} was made"));
    }
    // A drawing has samples of its own.
    if word("scn:paths").is_ok() {
        return Ok(());
    }
    let samples = shot.stage.scene.stop.most_samples().unwrap().to_string();
    if word("scn:samples")? != samples {
        return Err(format!("{render} has {samples} samples a pixel"));
    }
    Ok(())
}
