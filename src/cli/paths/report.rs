//! What `scn paths` tells: for people, and as JSON.

use glam::{DVec3, Vec3};
use serde_json::{Value, json};

use super::drawing::{self, Named};
use super::gathered::{Bright, Caustic, DIRECT, Gathered, INDIRECT, add, letter};
use super::options::{By, Paths};
use crate::diag::words::{counted, grouped};
use crate::prepare::Prepared;
use crate::render::integrators::Source;

/// Classes that people are told of one by one.
const MOST_CLASSES: usize = 12;
/// Words of classes longer than this, in characters, lose their middle.
const LONGEST_WORD: usize = 21;

/// What was asked for.
pub struct About<'a> {
    pub scene: &'a str,
    pub render: &'a str,
    pub options: &'a Paths,
    pub prepared: &'a Prepared,
}

impl About<'_> {
    /// A place of the world, in metres.
    fn metres(&self, place: Vec3) -> DVec3 {
        place.as_dvec3() / self.prepared.scale + self.prepared.centre
    }
}

/// For people, in 80 columns.
pub fn human(about: &About, all: &Gathered, files: &[String]) -> String {
    let [x, y] = about.options.pixel;
    let [width, height] = about.prepared.world.film.size;
    let mut text = format!(
        "{}, {}: pixel {x},{y} of {width} × {height}, {}\n",
        about.scene,
        about.render,
        counted(all.samples, "sample")
    );
    if all.paths == 0 {
        text.push_str("\n  no path brings light\n");
    } else {
        text.push_str(&classes(about, all));
        text.push_str(&brightest(about, all));
        text.push_str(&colours(about.options.by));
    }
    text + &format!("\n  wrote  {}\n", files.join("\n         "))
}

fn classes(about: &About, all: &Gathered) -> String {
    let mut text = format!(
        "\n  {:<LONGEST_WORD$} {:>7} {:>7}  {}\n",
        "light to eye", "part", "paths", "red, green, blue in W/m²/sr"
    );
    let mut row = |name: &str, radiance: [f64; 3], paths: u64, colour: Option<Named>| {
        let part = format!("{:.1} %", 100.0 * all.part(radiance));
        let colour = colour.map_or(String::new(), |(name, _)| format!("  {name}"));
        let (name, paths) = (short(name), grouped(paths));
        let [r, g, b] = radiance.map(figures);
        text.push_str(&format!(
            "  {name:<LONGEST_WORD$} {part:>7} {paths:>7}  {r} {g} {b}{colour}\n"
        ));
    };
    let by_class = about.options.by == By::Class;
    let told = all.classes.iter().take(MOST_CLASSES).enumerate();
    for (number, class) in told {
        let colour = drawing::colour(all, number, about.options.by);
        let colour = (by_class || class.caustic != Caustic::No).then_some(colour);
        row(&class.word, class.radiance, class.paths, colour);
    }
    let rest = &all.classes[all.classes.len().min(MOST_CLASSES)..];
    if !rest.is_empty() {
        let mut sum = [0.0; 3];
        rest.iter().for_each(|class| add(&mut sum, class.radiance));
        let paths = rest.iter().map(|class| class.paths).sum();
        row(&format!("{} more kinds", rest.len()), sum, paths, None);
    }
    row("all", all.radiance, all.paths, None);
    text
}

fn brightest(about: &About, all: &Gathered) -> String {
    let mut text = String::new();
    let top = all.brightest(about.options.top as usize);
    for (number, (class, path)) in top.into_iter().enumerate() {
        if number == 0 {
            text.push_str("\n  the paths that bring most; places in metres\n");
        }
        let [r, g, b] = path.radiance.map(figures);
        let word = &all.classes[class].word;
        text.push_str(&format!(
            "  {}. {}: {r} {g} {b}, in sample {}\n",
            number + 1,
            short(word),
            grouped(path.sample)
        ));
        let light = match path.traced.source {
            Source::Point(place) => shown(about.metres(place)),
            Source::Direction(towards) => format!("towards {}", shown(towards.as_dvec3())),
        };
        text.push_str(&format!("     L    {light}\n"));
        for (event, place) in path.traced.surfaces.iter().rev() {
            text.push_str(&format!("     {:<4} {}\n", letter(*event), shown(about.metres(*place))));
        }
    }
    text
}

fn colours(by: By) -> String {
    match by {
        By::Class => String::new(),
        By::Caustic => format!(
            "\n  pink   caustics straight from the light: {DIRECT}\n  blue   caustics of light \
             scattered before: {INDIRECT}\n  grey   all other paths\n"
        ),
    }
}

/// A number of four figures.
fn figures(x: f64) -> String {
    let text = if x == 0.0 || (1e-3..1e5).contains(&x.abs()) {
        let whole = x.abs().max(1.0).log10().floor() as usize + 1;
        format!("{x:.*}", 6_usize.saturating_sub(whole))
    } else {
        format!("{x:.3e}")
    };
    format!("{text:>9}")
}

/// `(0.1, 2, 0)`, of at most five digits behind the point.
fn shown(place: DVec3) -> String {
    let [x, y, z] = place.to_array().map(|x| {
        let rounded = (x * 1e5).round() / 1e5;
        // No minus before nothing.
        (rounded + 0.0).to_string()
    });
    format!("({x}, {y}, {z})")
}

/// A word without its middle, if it is long.
fn short(word: &str) -> String {
    if word.chars().count() <= LONGEST_WORD {
        return word.to_string();
    }
    let half = (LONGEST_WORD - 3) / 2;
    // Words are of ASCII. What a cut leaves of a letter goes too.
    let (start, end) = (&word[..half], &word[word.len() - half..]);
    let start = start.rsplit_once(' ').map_or(start, |(whole, _)| whole);
    let end = end.split_once(' ').map_or(end, |(_, whole)| whole);
    format!("{start} … {end}")
}

/// For programs; described in docs/paths.md.
pub fn json(about: &About, all: &Gathered, files: &[String]) -> Value {
    let classes = all.classes.iter().map(|class| {
        json!({
            "class": class.word,
            "caustic": caustic(class.caustic),
            "paths": class.paths,
            "radiance": class.radiance,
            "part": all.part(class.radiance),
        })
    });
    let top = all.brightest(about.options.top as usize).into_iter();
    json!({
        "scene": about.scene,
        "render": about.render,
        "film": about.prepared.world.film.size,
        "pixel": about.options.pixel,
        "seed": about.options.seed,
        "samples": all.samples,
        "paths": all.paths,
        "radiance": all.radiance,
        "classes": classes.collect::<Vec<_>>(),
        "brightest": top.map(|(class, path)| one(about, &all.classes[class].word, path)).collect::<Vec<_>>(),
        "files": files,
    })
}

fn one(about: &About, class: &str, path: &Bright) -> Value {
    let light = match path.traced.source {
        Source::Point(place) => json!({ "event": "L", "place": about.metres(place).to_array() }),
        Source::Direction(towards) => json!({ "event": "L", "towards": towards.to_array() }),
    };
    let surfaces = path.traced.surfaces.iter().rev();
    let surfaces = surfaces.map(|(event, place)| {
        json!({ "event": event.letter(), "place": about.metres(*place).to_array() })
    });
    json!({
        "class": class,
        "sample": path.sample,
        "radiance": path.radiance,
        "vertices": std::iter::once(light).chain(surfaces).collect::<Vec<_>>(),
    })
}

fn caustic(caustic: Caustic) -> Option<&'static str> {
    match caustic {
        Caustic::Direct => Some("direct"),
        Caustic::Indirect => Some("indirect"),
        Caustic::No => None,
    }
}
