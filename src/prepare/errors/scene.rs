//! Family `scene`: each part of a scene is well written, and together they cannot be rendered.

use crate::diag::{Code, Diagnostic, Span};
use crate::plan::daylight::SunHours;
use crate::scene::{At, Material, Named};

/// A camera whose eye is the point it looks at.
pub fn looks_nowhere(eye: Span, look_at: Span) -> Diagnostic {
    Diagnostic::error(Code::SCENE_CAMERA_LOOKS_NOWHERE, "the camera looks at the point where it stands")
        .label(look_at, "this point is in the middle of the picture")
        .label(eye, "and this is the same point")
        .why("The direction of view goes from `eye` to `look_at`; between a point and itself there is none.")
        .help("move `look_at` to something that is to be seen, or the `eye` away from it")
}

/// A camera that looks along its own up.
pub fn looks_along_up(up: Span, look: Span) -> Diagnostic {
    let fault =
        Diagnostic::error(Code::SCENE_CAMERA_LOOKS_ALONG_UP, "the camera looks along its own `up`");
    // A default's place is the record that left it out.
    let by_default = up.file == look.file && up.start <= look.start && look.end <= up.end;
    let fault = if by_default {
        fault.label(look, "seen from `eye`, this is along `y`, the default of `up`")
    } else {
        fault
            .label(up, "up in the picture …")
            .label(look, "… is the direction the camera looks in, or its opposite")
    };
    fault
        .why("`up` says how the camera is turned about the direction of view; along it, it says nothing.")
        .help("choose an `up` across the direction of view: `z` or `x` for a camera that looks down or up the y axis")
}

/// A camera too far away for its rays to aim.
pub fn too_far_away(eye: Span, radii: f64) -> Diagnostic {
    Diagnostic::error(Code::SCENE_CAMERA_TOO_FAR, "the camera is too far away to aim at the scene")
        .label(eye, format!("more than {radii:e} radii of the scene away"))
        .why("Over such a distance the rounding of directions is as large as what is looked at.")
        .help("check the unit of these coordinates, or bring the camera closer and widen its field of view")
}

/// An overview of nothing.
pub fn nothing_to_see(camera: Span) -> Diagnostic {
    Diagnostic::error(Code::SCENE_NOTHING_TO_SEE, "the camera `overview` has nothing to look at")
        .label(camera, "is placed by the box around the bounded objects")
        .why("There are no bounded objects, and planes without end have no box.")
        .help("add an object, or place a camera yourself: `camera: perspective { eye: …, look_at: …, fov_y: … }`")
}

/// A plane that lies out of sight.
pub fn beyond_scene(name: &At<String>, most: f64) -> Diagnostic {
    let headline = format!("the plane `{}` is too far from the scene", **name);
    Diagnostic::error(Code::SCENE_BEYOND_NUMBERS, headline)
        .label(name.span, format!("more than {most:e} times the size of the scene away"))
        .why("Everything is rendered in units of the scene's size, in single precision; so far away a plane is out of its reach.")
        .help("check the unit of the plane's `point`, or leave it out: so far away, nothing of it is seen but its horizon")
}

/// More triangles than fit the memory.
pub fn too_many_triangles(count: usize, most: usize) -> Diagnostic {
    let headline = format!("the scene has {count} triangles, and {most} are too many");
    Diagnostic::error(Code::SCENE_TOO_MUCH_MEMORY, headline)
        .why("A mesh is stored once for every object that shows it; so many triangles need more than 20 GB.")
        .help("use coarser meshes, or fewer objects")
}

/// A film that would fill the memory.
pub fn film_too_large(size_at: Span, size: [u64; 2], bytes: u64, most: u64) -> Diagnostic {
    let [width, height] = size;
    let gib = |bytes: u64| bytes.div_ceil(1 << 30);
    let headline =
        format!("a picture of {width} × {height} pixels needs {} GiB of memory", gib(bytes));
    Diagnostic::error(Code::SCENE_TOO_MUCH_MEMORY, headline)
        .label(size_at, format!("more than {} GiB", gib(most)))
        .why("Samples are summed up in double precision, and kept in blocks so that a sum never depends on how the work was shared out.")
        .help("make the film smaller, or render it in parts: `scn render --crop x0,y0,x1,y1` needs memory for that part alone")
}

/// A light, an emission or an albedo whose products overflow.
pub fn too_bright(name: &At<String>, at: Span, what: &str, most: f64) -> Diagnostic {
    let headline = format!("the {what} `{}` is too large for a picture", **name);
    Diagnostic::error(Code::SCENE_TOO_BRIGHT, headline)
        .label(at, format!("more than {most:e}"))
        .why("A picture holds single-precision numbers, the largest of which is 3.4e38.")
        .help(
            "check its unit and its exponent; only ratios of lights matter to how a picture looks",
        )
}

/// A point or a spot that lies out of reach.
pub fn light_beyond_scene(name: &At<String>, position: Span, most: f64) -> Diagnostic {
    let headline = format!("the light `{}` is too far from the scene", **name);
    Diagnostic::error(Code::SCENE_BEYOND_NUMBERS, headline)
        .label(position, format!("more than {most:e} times the size of the scene away"))
        .why("Everything is rendered in units of the scene's size, in single precision; so far away a light is out of its reach.")
        .help("check the unit of this point, or make the light `directional`: over such a distance its light is parallel")
}

/// A spot that would begin to fade before its axis.
pub fn wide_falloff(name: &At<String>, falloff: Span, cone: Span) -> Diagnostic {
    let headline = format!("the spot `{}` fades over more than its cone", **name);
    Diagnostic::error(Code::SCENE_WIDE_FALLOFF, headline)
        .label(falloff, "the outer part of the cone, in which the light fades")
        .label(cone, "the angle from the axis to the edge of the cone")
        .why("Both are angles from one place: the edge is `cone` away from the axis, and the light is whole up to `cone - falloff`.")
        .help("write a `falloff` between 0 deg and the angle of the cone: the same angle fades from the axis on")
}

/// A lamp that faces every way and is to shine from its centre.
pub fn closed_lamp(name: &At<String>, area_lights: Span) -> Diagnostic {
    let headline = format!("the lamp `{}` has no side from which its centre could shine", **name);
    Diagnostic::error(Code::SCENE_CLOSED_LAMP, headline)
        .label(name.span, "faces every way: its normals cancel")
        .label(area_lights, "lets it shine from its centre alone, to the side it faces")
        .why("As one point a lamp shines by the cosine to its mean normal; a closed surface has none, and its centre lies inside.")
        .help("write `area_lights: random`, or use a lamp that is open, such as a `quad` or a `disk`")
}

/// A plane without end that shines.
pub fn endless_lamp(name: &At<String>) -> Diagnostic {
    let headline = format!("the plane `{}` shines, and has no end", **name);
    Diagnostic::error(Code::SCENE_ENDLESS_LAMP, headline)
        .label(name.span, "a lamp of endless area")
        .why("`direct` chooses points of a lamp evenly over its area; over an endless one it cannot.")
        .help("use a `quad` or a `disk` as large as it has to be")
}

/// A sky whose north is its zenith.
pub fn north_is_up(north: Span, up: Span) -> Diagnostic {
    let fault = Diagnostic::error(Code::SCENE_NORTH_IS_UP, "the sky's north points along its up");
    // A default's place is the record that left it out.
    let fault = if up.start <= north.start && north.end <= up.end {
        fault.label(north, "`up` is `y` where nothing else is said")
    } else if north.start <= up.start && up.end <= north.end {
        fault.label(up, "`north` is `-z` where nothing else is said")
    } else {
        fault.label(north, "north …").label(up, "… and the zenith, or its opposite")
    };
    fault
        .why("North is a direction on the ground, across what is up.")
        .help("choose a `north` across `up`, such as `-z` or `x` where `y` is up, `y` where `z` is")
}

/// A place without a clock, or a clock without a place.
pub fn half_a_clock(given: &str, at: Span) -> Diagnostic {
    let lacking = if given == "longitude" { "zone" } else { "longitude" };
    let headline = format!("the sky's `{given}` needs a `{lacking}` beside it");
    Diagnostic::error(Code::SCENE_HALF_A_CLOCK, headline)
        .label(at, format!("says nothing without a `{lacking}`"))
        .why("Where the sun stands at a clock's time follows from both; without them `time` is solar time.")
        .help(match given {
            "longitude" => "write what the clock is ahead of Greenwich, such as `zone: 1 h`; or leave `longitude` out",
            _ => "write how far east the place is, such as `longitude: 12.5 deg`; or leave `zone` out",
        })
}

/// A sky after sunset or before sunrise.
pub fn night(name: &At<String>, time: Span, degrees_below: f64, hours: SunHours) -> Diagnostic {
    let headline = format!("the sun of `{}` is {degrees_below:.1}° below the horizon", **name);
    let fault = Diagnostic::warning(Code::SCENE_NIGHT, headline)
        .label(time, "neither sun nor sky gives light at this time")
        .why("The model is one of days: it has no twilight, no moon and no stars.");
    // To the minute, inwards: there the sun is up.
    let clock = |minutes: f64| {
        let minutes = (minutes as i64).rem_euclid(24 * 60);
        format!("{}:{:02}", minutes / 60, minutes % 60)
    };
    fault.help(match hours {
        SunHours::Between(rise, set) => format!(
            "on this day and at this place the sun is up from {} to {}",
            clock((60.0 * rise).ceil()),
            clock((60.0 * set).floor())
        ),
        SunHours::Always => "choose another time".to_string(),
        SunHours::Never => {
            "the sun stays down on this day at this place: choose another `day` or `latitude`"
                .to_string()
        }
    })
}

/// Triangles that single precision cannot tell from lines.
pub fn lost_triangles(name: &At<String>, lost: u64, of: usize) -> Diagnostic {
    let headline = format!("`{}` loses {lost} of {of} triangles to rounding", **name);
    Diagnostic::warning(Code::SCENE_LOST_TRIANGLES, headline)
        .label(name.span, "is rendered without them")
        .why("Beside the size of the whole scene their corners coincide, or lie on a line, in single precision.")
        .help("if they matter, leave out what makes the scene so large, or render them in a scene of their own")
}

/// An object that is a few steps of single precision wide. `clear`: light goes through it.
pub fn too_small(name: &At<String>, steps: f64, clear: bool) -> Diagnostic {
    let headline =
        format!("`{}` is too small beside the rest of the scene to keep its form", **name);
    let label = format!(
        "{steps:.0} steps of single precision across: places on it are off by {:.1} % of its size",
        50.0 / steps.max(0.5)
    );
    let lost = if clear { " Some of the light that goes through it is lost." } else { "" };
    Diagnostic::warning(Code::SCENE_TOO_SMALL, headline)
        .label(name.span, label)
        .why(format!("Single precision tells positions apart to one part in 16 million of the distance from the middle of the scene.{lost}"))
        .help("check its unit; or leave out what makes the scene so large")
}

/// Direct light, and nothing that gives any.
pub fn nothing_shines(integrator: Span) -> Diagnostic {
    Diagnostic::warning(
        Code::SCENE_NOTHING_SHINES,
        "nothing shines on the scene: all surfaces will be black",
    )
    .label(integrator, "follows light to surfaces, and there is none to follow")
    .why(
        "What surrounds the scene, a `constant` light or a sky, lights surfaces under `path`, \
         `ambient`, and `direct { environment: on }`; under plain `direct` it is only seen.",
    )
    .help(
        "add a light or an object whose material has an `emission`, or let the surroundings shine",
    )
}

/// A path that neither a depth nor a chance ends.
pub fn endless_paths(depth: Span, roulette: Span) -> Diagnostic {
    Diagnostic::error(Code::SCENE_ENDLESS_PATHS, "nothing ends the paths of light")
        .label(depth, "as far as they go …")
        .label(roulette, "… and none is ended by chance")
        .why("Between surfaces that give light back, a path goes on for ever.")
        .help("choose a `roulette`, which changes no picture but for its noise; or a depth")
}

/// A mixture whose parts have different matter behind them.
pub fn mixed_insides(
    mixture: &Named<Material>,
    first: &Named<Material>,
    other: &Named<Material>,
) -> Diagnostic {
    let name = &*mixture.name;
    Diagnostic::error(
        Code::SCENE_MIXED_INSIDES,
        format!("the mixture `{name}` has two different media on one side"),
    )
    .label(mixture.value.span, format!("mixes `{}` and `{}`", *first.name, *other.name))
    .label(first.value.span, "lets light into one medium")
    .label(other.value.span, "and this into another, or out of another")
    .why("A surface has one medium behind its face and one before it.")
    .help("give both the same `inside` and `outside`, or mix with an opaque material")
}

/// A mixture whose parts shine on different sides.
pub fn mixed_sides(
    mixture: &Named<Material>,
    first: &Named<Material>,
    other: &Named<Material>,
) -> Diagnostic {
    let name = &*mixture.name;
    Diagnostic::error(
        Code::SCENE_MIXED_SIDES,
        format!("the parts of the mixture `{name}` shine on different sides"),
    )
    .label(mixture.value.span, format!("mixes `{}` and `{}`", *first.name, *other.name))
    .label(first.value.span, "shines on other sides …")
    .label(other.value.span, "… than this does")
    .why("A lamp shines with the same radiance on its front alone, or on both of its sides.")
    .help("write the same `emits` for both")
}
