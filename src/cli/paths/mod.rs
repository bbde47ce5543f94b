//! `scn paths`: the paths of light through a pixel, drawn over the picture and listed.

mod options;
mod gathered;
mod drawing;
mod report;

use crate::cli::words::NAMES;
use crate::diag::words::few;
use std::ffi::OsStr;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};
use std::time::Instant;

pub use options::Paths;

use super::about::VERSION;
use super::clock::Clock;
use super::log::shown;
use super::options::Form;
use super::{End, failed, scene_file, terminal, whose};
use crate::diag::{Sources, harmless_text};
use crate::files::{self, Failure, Metadata};
use crate::load::{Loader, Stage};
use crate::math::{Lines, NoProgress, Picture};
use crate::prepare::{self, Prepared, Settings};
use crate::run::{self, Begin};
use gathered::Gathered;

/// Samples of each pixel of the picture below the lines, if none is given.
const ROUGH: u64 = 8;
/// Of the words in a PNG the one that no other picture has, without `scn:`.
pub const DRAWING: &str = "paths";

pub fn run(options: &Paths) -> End {
    paths(options).err().unwrap_or(End::Well)
}

fn paths(options: &Paths) -> Result<(), End> {
    let mut sources = Sources::new();
    let scene = shown(&options.file);
    let (name, stage) = stage(options, &mut sources)?;
    if !stage.scene.integrator.follows_light() {
        return Err(failed(&format!(
            "render `{name}`: `preview` follows no light, and so has no paths\n  ask for another \
             integrator: --set 'integrator=path {{}}'"
        )));
    }
    let settings = settings(options);
    if let Some(unfit) = settings.unfit(&stage) {
        return Err(failed(&format!("render `{name}`: {unfit}")));
    }
    let (prepared, found) = prepare::prepare(&stage, &settings, &NoProgress);
    let Some(prepared) = prepared else {
        scene_file::no_errors(found, &sources, &scene)?;
        return Err(End::SceneErrors);
    };
    let ([x, y], [width, height]) = (options.pixel, prepared.world.film.size);
    if x >= width || y >= height {
        return Err(failed(&format!(
            "there is no pixel {x},{y} in a picture of {width} × {height}\n  columns are counted \
             from 0 to {}, rows from 0 to {}",
            width - 1,
            height - 1
        )));
    }
    let files = Files::new(options, &name).map_err(|text| failed(&text))?;
    for path in files.all() {
        files::whole::ready(path).map_err(|why| failed(&told(path, &why)))?;
    }
    let picture = picture(options, &prepared)?;

    let kept = options.lines.max(options.top) as usize;
    let all = Gathered::new(&prepared, options.seed, options.pixel, options.samples, kept);
    let exposure = match options.over.as_deref().is_some_and(|path| has_ending(path, "png")) {
        true => 1.0,
        false => stage.scene.film.exposure.0.exp2(),
    };
    let below = drawing::background(&picture, exposure);
    let most = options.lines as usize;
    let lines = drawing::lines(&prepared.world, &all, options.pixel, options.by, most);
    let words = words(options, &name, &stage);
    files.write(words, below, &lines).map_err(|text| failed(&text))?;

    let about = report::About { scene: &scene, render: &name, options, prepared: &prepared };
    let files: Vec<String> = files.all().map(|path| shown(path)).collect();
    match options.format {
        Form::Human => terminal::say(&harmless_text(&report::human(&about, &all, &files))),
        Form::Json => terminal::say(&format!("{:#}\n", report::json(&about, &all, &files))),
    }
    Ok(())
}

/// What a drawing shows, and what it was made of.
fn words(options: &Paths, render: &str, stage: &Stage) -> Metadata {
    let scene = options.file.file_name().unwrap_or_default().to_string_lossy();
    let [x, y] = options.pixel;
    let mut all: Metadata = Vec::new();
    let mut put = |key: &str, value: String| all.push((format!("scn:{key}"), value));
    put(DRAWING, format!("{render}, pixel {x},{y}"));
    put("scene", scene.into_owned());
    put("hash", stage.hash.to_string());
    put("render", render.to_string());
    put("seed", options.seed.to_string());
    put("samples", options.samples.to_string());
    put("version", VERSION.to_string());
    if options.scale != 1.0 {
        put("scale", options.scale.to_string());
    }
    if !options.set.is_empty() {
        put("set", options.set.join("\n"));
    }
    all
}

fn settings(options: &Paths) -> Settings {
    Settings { scale: options.scale, crop: None, portable: terminal::portable() }
}

/// The render asked for, and its stage; without errors.
fn stage(options: &Paths, sources: &mut Sources) -> Result<(String, Stage), End> {
    let scene = shown(&options.file);
    let only: Vec<String> = options.render.iter().cloned().collect();
    let compiled =
        scene_file::compile(&options.file, &options.set, &only, sources).ok_or(End::NotDone)?;
    scene_file::no_errors(compiled.diagnostics, sources, &scene)?;
    let chosen = scene_file::chosen(compiled.renders, &compiled.setups, &only, &options.file);
    let mut renders = chosen.map_err(|text| failed(&text))?;
    if renders.len() > 1 {
        let names: Vec<&str> = renders.iter().map(|render| render.name.value.as_str()).collect();
        return Err(failed(&format!(
            "`{scene}` has {} renders\n  write which one after the file: {}",
            names.len(),
            few(names, NAMES)
        )));
    }
    let Some(render) = renders.pop() else { return Err(End::NotDone) };
    let (stage, mut found) = Loader::new(&NoProgress).stage(&render.scene, sources);
    let name = render.name.value;
    if let Some(stage) = &stage {
        let faults = prepare::check(stage, &settings(options));
        found.extend(whose::told(vec![(name.clone(), faults)]));
    }
    scene_file::no_errors(found, sources, &scene)?;
    stage.map(|stage| (name, stage)).ok_or(End::SceneErrors)
}

/// What the lines are drawn over: the picture given, or a rough one.
fn picture(options: &Paths, prepared: &Prepared) -> Result<Picture, End> {
    let Some(path) = &options.over else {
        let Prepared { world, integrator, .. } = prepared;
        let settings = run::Settings::samples(options.seed, ROUGH);
        let watch = Clock(Instant::now());
        return Ok(run::render(world, integrator, &settings, Begin::new(world), &watch).picture);
    };
    let read = match () {
        () if has_ending(path, "exr") => files::exr::read(path).map(|(layers, _)| layers.main),
        () if has_ending(path, "png") => files::png::read(path).map(|(picture, _)| picture),
        () => Err(Failure::new("is neither .exr nor .png")),
    };
    let picture = read.map_err(|why| failed(&told(path, &why)))?;
    let [width, height] = prepared.world.film.size;
    if [picture.width as u64, picture.height as u64] == [width, height] {
        return Ok(picture);
    }
    Err(failed(&format!(
        "the picture `{}` is of {} × {}, and the film of {width} × {height}",
        shown(path),
        picture.width,
        picture.height
    )))
}

fn told(path: &Path, why: &Failure) -> String {
    format!("the picture `{}` {why}", shown(path))
}

fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|it| it.eq_ignore_ascii_case(ending))
}

/// Where drawings go.
struct Files {
    png: Option<PathBuf>,
    svg: Option<PathBuf>,
}

impl Files {
    fn new(options: &Paths, render: &str) -> Result<Self, String> {
        let both = |name: PathBuf| {
            let with = |ending: &str| {
                let mut file = name.clone().into_os_string();
                file.push(ending);
                Some(PathBuf::from(file))
            };
            Self { png: with(".png"), svg: with(".svg") }
        };
        let Some(path) = &options.output else {
            let stem = options.file.file_stem().unwrap_or(OsStr::new("scene"));
            return Ok(both(Path::new("out").join(stem).join(format!("{render}.paths"))));
        };
        let shown = shown(path);
        if path.as_os_str().is_empty() {
            return Err("-o needs a name, of a file or of a folder".to_string());
        }
        if files::whole::is_folder(path) || shown.ends_with(['/', MAIN_SEPARATOR]) {
            return Ok(both(path.join(format!("{render}.paths"))));
        }
        let bare = path.file_name().and_then(OsStr::to_str);
        if let Some(ending @ (".png" | ".svg")) = bare.map(str::to_lowercase).as_deref() {
            return Err(format!("-o {shown}: a drawing needs a name before {ending}"));
        }
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("png") => Ok(Self { png: Some(path.clone()), svg: None }),
            Some("svg") => Ok(Self { png: None, svg: Some(path.clone()) }),
            Some(ending) => Err(format!(
                "-o {shown}: drawings are written as .png and .svg, not as .{ending}\n  if it is \
                 the name of a folder, write it as `{shown}/`"
            )),
            None if path.exists() => Err(format!(
                "-o {shown}: there is something of this name that is no folder\n  write \
                 `{shown}.png` or `{shown}.svg` for a drawing beside it"
            )),
            None => Ok(both(path.clone())),
        }
    }

    fn all(&self) -> impl Iterator<Item = &PathBuf> {
        self.png.iter().chain(&self.svg)
    }

    fn write(&self, words: Metadata, mut picture: Picture, lines: &[Lines]) -> Result<(), String> {
        if let Some(path) = &self.svg {
            let title = words.first().map_or("", |(_, title)| title);
            files::svg::write(path, title, &picture, lines).map_err(|why| told(path, &why))?;
        }
        if let Some(path) = &self.png {
            lines.iter().for_each(|lines| lines.draw(&mut picture));
            files::png::write(path, &picture, 1.0, &words).map_err(|why| told(path, &why))?;
        }
        Ok(())
    }
}
