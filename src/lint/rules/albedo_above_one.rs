//! A material that gives back more light than it gets. Those of .mtl files are told of where they
//! are read.

use crate::diag::{Code, Diagnostic, Span};
use crate::lint::Shot;
use crate::math::Spectrum;
use crate::optics::colour;
use crate::plan::largest_of;

pub(in crate::lint) fn look(shot: &Shot, found: &mut Vec<Diagnostic>) {
    // Those of .mtl files come after those of the scene.
    let textures = shot.stage.textures.iter().take(shot.stage.scene.textures.len());
    let images = textures.filter(|staged| staged.texels.is_some());
    let mut tints: Vec<Span> = Vec::new();
    for image in images {
        // A picture may be dark enough for a tint above 1.
        let said = &image.texture.value;
        tints.extend(said.value.colours().iter().map(|tint| tint.span));
        let (most, label) = channels(largest_of(image));
        if most > 1.0 {
            let label = format!("its brightest texels are {label}");
            found.push(above_one(&image.texture.name, most, label, said.span));
        }
    }
    for (name, albedo) in shot.reflectances().filter(|(_, albedo)| !tints.contains(&albedo.span)) {
        let (most, label) = match &albedo.0 {
            Spectrum::Table(table) => {
                let nodes = table.nodes().iter();
                let highest = nodes.copied().max_by(|a, b| a.1.total_cmp(&b.1));
                let (nm, most) = highest.unwrap_or_default();
                (most, format!("above 1, most of all at {nm} nm"))
            }
            other => channels(colour::reflected(other)),
        };
        if most > 1.0 {
            found.push(above_one(name, most, label, albedo.span));
        }
    }
}

/// The greatest of three channels, and which are too great.
fn channels(parts: [f64; 3]) -> (f64, String) {
    let named = ["red", "green", "blue"].into_iter().zip(parts);
    let over: Vec<&str> = named.filter(|(_, part)| *part > 1.0).map(|(name, _)| name).collect();
    let label = match over.len() {
        3 => "above 1".to_string(),
        _ => format!("above 1 in {}", over.join(" and ")),
    };
    (parts.into_iter().fold(0.0, f64::max), label)
}

fn above_one(name: &str, most: f64, label: String, at: Span) -> Diagnostic {
    let headline = format!("`{name}` gives back more light than it gets");
    Diagnostic::warning(Code::LINT_ALBEDO_ABOVE_ONE, headline)
        .label(at, label)
        .why("The albedo is the part of the light that is scattered back; no real surface has more than all of it.")
        .help(format!("divide it by {most}, or write `emission` if the surface shines of itself"))
}
