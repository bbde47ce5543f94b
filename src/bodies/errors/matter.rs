//! Family `matter`: surfaces that bound no body, and bodies that cannot be told apart.

use glam::DVec3;

use crate::bodies::closing::Wide;
use crate::bodies::thin::{LEAST, Thin};
use crate::diag::{Code, Diagnostic, Span};
use crate::scene::At;

const CLOSED: &str = "What is inside of a medium is told by its surface: all surfaces that name \
                      it, of all objects, must close together.";

/// A disk on whose side there is a medium.
pub fn disk(name: &At<String>) -> Diagnostic {
    let headline = format!("the disk `{}` cannot bound a medium", **name);
    Diagnostic::error(Code::MATTER_OPEN, headline)
        .label(name.span, "light that goes in never comes out")
        .why(CLOSED)
        .help("use a closed mesh, or a `sphere`; a disk may be of any opaque material")
}

/// A surface around a medium that is open at `edges` edges, the first of them at a place. `wall`:
/// a material at these edges that does not name the medium, and what is inside of it. `scanned`: all
/// of it is one mesh.
pub fn open(
    medium: &str,
    objects: &[&At<String>],
    edges: usize,
    (at, scanned): (DVec3, bool),
    wall: Option<(&str, &str)>,
) -> Diagnostic {
    let headline = format!("the surface around `{medium}` is open");
    let label = match edges {
        1 => format!("does not go on at an edge near {}", place(at)),
        _ => format!("does not go on at {edges} edges, the first near {}", place(at)),
    };
    let help = match wall {
        Some((name, inside)) => format!(
            "where `{name}` is the wall that holds it, let that name both, by its front: `dielectric \
             {{ inside: {inside}, outside: {medium} }}`; else close its holes in the program that \
             made it"
        ),
        None if scanned => format!(
            "close its holes in the program that made it: scanned models are often open below, and \
             `mend` joins cracks, no holes. Or take a closed model, or give this one a material \
             that lets no light through. What closes it may be an object of its own, of \
             `dielectric {{ inside: {medium} }}`"
        ),
        None => format!(
            "give what closes it the same medium, `dielectric {{ inside: {medium} }}`. A pane is a \
             box with six sides"
        ),
    };
    labelled(Diagnostic::error(Code::MATTER_OPEN, headline), objects, label).why(CLOSED).help(help)
}

/// Faces that end at others, where the surface around a medium goes on already: at the first of
/// `edges` edges so many `faces` meet.
pub fn wall_within(
    medium: &str,
    objects: &[&At<String>],
    (faces, edges): (u32, usize),
    at: DVec3,
) -> Diagnostic {
    let headline = format!("the surface around `{medium}` has a wall within it");
    let label = match edges {
        1 => format!("{faces} of its faces meet at an edge near {}", place(at)),
        _ => format!("{faces} of its faces meet at an edge near {}, and so at {edges}", place(at)),
    };
    labelled(Diagnostic::error(Code::MATTER_OPEN, headline), objects, label)
        .why("A closed surface goes over each of its edges from one face to one other: what is odd there has the medium on neither side, or on both.")
        .help(
            "in the program that made it take away the faces within, such as the one at which two \
             parts touch; triangles that repeat earlier ones are left out already",
        )
}

/// Two parts of a surface with a gap between them, `width` metres wide.
pub fn gap(medium: &str, objects: &[&At<String>], width: f64, at: DVec3) -> Diagnostic {
    let headline =
        format!("the surface around `{medium}` has a gap {} wide", length(width, Round::Near));
    let label = format!("the gap begins near {}", place(at));
    labelled(Diagnostic::error(Code::MATTER_GAP, headline), objects, label).why(CLOSED).help(
        format!(
            "write `mend: {}` in the mesh to close it, or move the points together",
            length(width, Round::Up)
        ),
    )
}

/// A mesh that would lose its form by what it says that may be mended, at `said`.
pub fn wide_mend(object: &At<String>, said: Option<Span>, wide: Wide) -> Diagnostic {
    let (headline, why, help) = match wide {
        Wide::Than { mend, size, most } => (
            format!(
                "`mend: {}` is wider than a gap of `{}`, which is {} across",
                length(mend, Round::Near),
                **object,
                length(size, Round::Near)
            ),
            "All points of open edges that are so near to each other become one: more than a crack \
             would be drawn together."
                .to_string(),
            format!(
                "write at most `mend: {}`, a fiftieth of it; close holes in the program that made \
                 the mesh",
                length(0.9 * most, Round::Near)
            ),
        ),
        Wide::Loses { mend, lost, of } => (
            format!(
                "`mend: {}` is wider than triangles of `{}`: it would lose {lost} of {of}",
                length(mend, Round::Near),
                **object
            ),
            "All points of open edges that are so near to each other become one, along an edge as \
             well as across a gap."
                .to_string(),
            "write a `mend` as wide as the gap, and no wider: without it the gap is told with its \
             width"
                .to_string(),
        ),
    };
    let fault = Diagnostic::error(Code::MATTER_WIDE_MEND, headline);
    let fault = match said {
        Some(said) => fault.label(said, "joins what is not meant to be joined"),
        None => fault.label(object.span, "joins what is not meant to be joined"),
    };
    fault.why(why).help(help)
}

/// Faces side by side of which one looks outward and one inward. `swap`: a material there that names
/// both media.
pub fn turned(
    medium: &str,
    objects: &[&At<String>],
    edges: usize,
    at: DVec3,
    swap: Option<&str>,
) -> Diagnostic {
    let headline = format!("faces around `{medium}` look different ways");
    let label = match edges {
        1 => format!("on the two sides of an edge near {}", place(at)),
        _ => format!("on the two sides of {edges} edges, the first near {}", place(at)),
    };
    labelled(Diagnostic::error(Code::MATTER_TURNED, headline), objects, label)
        .why("A medium is behind faces, from whose front their corners are counter-clockwise. Here some have it on the other side.")
        .help(match swap {
            Some(material) => format!(
                "let the program that made the mesh turn its faces outward, all of them; or swap \
                 `inside` and `outside` of `{material}`"
            ),
            None => "let the program that made the mesh turn its faces outward, all of them".to_string(),
        })
}

/// Two bodies whose surfaces go through each other.
pub fn cross([one, other]: [&At<String>; 2], at: DVec3) -> Diagnostic {
    const WHY: &str = "Bodies are apart, or one is inside of the other. Where they overlap, either \
                       could be meant.";
    if one.span == other.span {
        let headline = format!("two bodies of `{}` cross", **one);
        return Diagnostic::error(Code::MATTER_CROSS, headline)
            .label(one.span, format!("near {}", place(at)))
            .why(WHY)
            .help(JOIN);
    }
    let headline = format!("the surfaces of `{}` and `{}` cross", **one, **other);
    met(Diagnostic::error(Code::MATTER_CROSS, headline), [one, other], at).why(WHY).help(format!(
        "move them apart; or say which one ends where the other begins: `yields_to: {}` in `{}`, \
         or the other way round",
        **other, **one
    ))
}

/// Two bodies whose surfaces are nearer to each other than `together`, in metres: the first is of
/// the medium `inside`. `flat`: one of them can end where the other begins.
pub fn coincide(
    [one, other]: [&At<String>; 2],
    (inside, flat): (&str, bool),
    at: DVec3,
    together: f64,
) -> Diagnostic {
    let why = format!(
        "Of surfaces nearer to each other than {}, in a scene of this size, rounding would decide \
         which one a ray meets.",
        length(together, Round::Up)
    );
    if one.span == other.span {
        let headline = format!("two bodies of `{}` lie on each other", **one);
        return Diagnostic::error(Code::MATTER_COINCIDE, headline)
            .label(one.span, format!("near {}", place(at)))
            .why(why)
            .help(JOIN);
    }
    let headline = format!("the surfaces of `{}` and `{}` lie on each other", **one, **other);
    let both = format!(
        "let one surface name both media, such as `dielectric {{ inside: {inside}, outside: … }}`"
    );
    met(Diagnostic::error(Code::MATTER_COINCIDE, headline), [one, other], at).why(why).help(
        match flat {
            true => format!(
                "say which one ends where the other begins: `yields_to: {}` in `{}`, or the other \
                 way round; or {both}; or move them apart",
                **other, **one
            ),
            false => format!("{both}; or move them apart"),
        },
    )
}

/// The first of two bodies ends where the other begins, and its surface cannot be told from the
/// other's.
pub fn flush([one, to]: [&At<String>; 2], at: DVec3) -> Diagnostic {
    let headline = format!("`{}` lies on `{}`, and cannot yield to it there", **one, **to);
    met(Diagnostic::error(Code::MATTER_COINCIDE, headline), [one, to], at)
        .why("What yields is pushed a little into the other, by more than rounding. Here there is no such way.")
        .help(format!("let `{}` reach clearly into `{}`, or end clearly before it", **one, **to))
}

const JOIN: &str = "move them apart, or join them to one body, in the program that made the mesh";

fn met(fault: Diagnostic, [one, other]: [&At<String>; 2], at: DVec3) -> Diagnostic {
    fault
        .label(one.span, format!("meets the other near {}", place(at)))
        .label(other.span, "the other")
}

/// A body that would be everywhere but within its surface.
pub fn inside_out(medium: &str, object: &At<String>) -> Diagnostic {
    let headline = format!("the surface of `{}` is inside out", **object);
    Diagnostic::error(Code::MATTER_INSIDE_OUT, headline)
        .label(object.span, format!("its faces look inward: `{medium}` would be all around it"))
        .why("A medium is behind faces, from whose front their corners are counter-clockwise.")
        .help(format!(
            "turn its faces round in the program that made it. If it is a bubble, let its faces look \
             outward, name the medium of the bubble as its inside, and write `surroundings: {medium}`"
        ))
}

/// A body of clear matter whose two sides, or those of a gap in it, are nearer than single precision
/// tells them apart; with some more steps between them it is rendered all the same.
pub fn thin(object: &At<String>, thin: &Thin) -> Diagnostic {
    let Thin { thickness, steps, .. } = *thin;
    let what =
        if thin.gap { format!("a gap in `{}`", **object) } else { format!("`{}`", **object) };
    let thick = match thickness {
        x if x < 1e-11 => "less than 0.01 nm".to_string(),
        x => length(x, Round::Near),
    };
    let size = format!("{thick} near {}: {steps:.1} steps of single precision", place(thin.at));
    let (fault, label, lost) = match steps < LEAST {
        true => {
            let headline =
                format!("{what} is too thin beside the rest of the scene to be rendered as clear");
            let fault = Diagnostic::error(Code::MATTER_TOO_SMALL, headline);
            (
                fault,
                format!("{size}; {LEAST} is least"),
                "Rays miss one of the two sides, and their light is wrong.",
            )
        }
        false => {
            let headline =
                format!("{what} is too thin beside the rest of the scene to keep its form");
            let fault = Diagnostic::warning(Code::SCENE_TOO_SMALL, headline);
            (fault, size, "Light that goes through it may be lost.")
        }
    };
    fault
        .label(object.span, label)
        .why(format!("Single precision tells positions apart to one part in 16 million of the distance from the middle of the scene. {lost}"))
        .help("check its unit, and the factors of `scale`; or leave out what makes the scene so large")
}

/// More bodies that overlap than can be told apart.
pub fn too_many(first: Span, most: usize) -> Diagnostic {
    let headline = format!("more than {most} bodies end where others begin");
    Diagnostic::error(Code::MATTER_TOO_MANY, headline)
        .label(first, "this is one of them")
        .why(format!("Each ray knows which of these it is inside of, and has room for {most}."))
        .help("let objects of one medium be one mesh, or do without `yields_to` where bodies do not meet")
}

fn labelled(fault: Diagnostic, objects: &[&At<String>], first: String) -> Diagnostic {
    let mut first = Some(first);
    objects.iter().fold(fault, |fault, name| {
        fault.label(name.span, first.take().unwrap_or_else(|| "so does this".to_string()))
    })
}

/// A place given in metres, in the unit that its numbers are short in.
pub fn place(at: DVec3) -> String {
    let (factor, unit) = unit(at.abs().max_element());
    let [x, y, z] = (at / factor).to_array().map(|x| {
        let x = format!("{x:.3}");
        let short = x.trim_end_matches('0').trim_end_matches('.').to_string();
        if short == "-0" { "0".to_string() } else { short }
    });
    format!("({x}, {y}, {z}) {unit}")
}

/// Which way digits go that are left out.
enum Round {
    Near,
    Up,
}

/// A length of two digits, as it is written in a scene.
fn length(metres: f64, round: Round) -> String {
    let (factor, unit) = unit(metres);
    let value = metres / factor;
    let step = 10.0_f64.powf(value.log10().floor() - 1.0);
    let digits = match round {
        Round::Near => (value / step).round(),
        Round::Up => (value / step).floor() + 1.0,
    };
    let places = (-step.log10()).ceil().max(0.0) as usize;
    let text = format!("{:.places$}", digits * step);
    let short = if places > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    format!("{short} {unit}")
}

fn unit(metres: f64) -> (f64, &'static str) {
    match metres {
        x if x >= 1.0 => (1.0, "m"),
        x if x >= 1e-2 => (1e-2, "cm"),
        x if x >= 1e-3 => (1e-3, "mm"),
        x if x >= 1e-6 => (1e-6, "um"),
        x if x > 0.0 => (1e-9, "nm"),
        _ => (1.0, "m"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_two_digits_and_never_too_little() {
        assert_eq!(length(1.1e-4, Round::Near), "110 um");
        assert_eq!(length(1.14e-3, Round::Near), "1.1 mm");
        assert_eq!(length(1.14e-3, Round::Up), "1.2 mm");
        assert_eq!(length(1.0e-3, Round::Up), "1.1 mm");
        assert_eq!(length(0.042, Round::Up), "4.3 cm");
        assert_eq!(place(DVec3::new(0.1, -1e-9, 0.05)), "(10, 0, 5) cm");
    }
}
