//! Scenes of other programs, known by how they begin. Some of them end in `.scn` too.

/// A program whose scenes are not ours.
pub struct Foreign {
    /// What people call it.
    pub program: &'static str,
    /// The bytes of the line by which its scenes are known.
    pub line: std::ops::Range<usize>,
}

/// How many lines are looked at.
const LINES: usize = 40;

/// Statements that begin a scene of pbrt.
const PBRT: [&str; 17] = [
    "Accelerator",
    "AttributeBegin",
    "Camera",
    "ColorSpace",
    "ConcatTransform",
    "Film",
    "Include",
    "Integrator",
    "LookAt",
    "MakeNamedMedium",
    "Option",
    "PixelFilter",
    "Rotate",
    "Sampler",
    "Scale",
    "Transform",
    "WorldBegin",
];

/// Properties of LuxCore.
const LUXCORE: [&str; 5] = ["film.", "opencl.", "path.", "renderengine.", "scene."];

/// Directives and blocks of POV-Ray.
const POV_RAY: [&str; 6] = ["#version", "#include", "#declare", "#default", "#macro", "#local"];
const POV_RAY_BLOCKS: [&str; 5] =
    ["background", "camera", "global_settings", "light_source", "plane"];

/// The program that a text without our first line is a scene of.
pub fn recognise(text: &str) -> Option<Foreign> {
    let mut at = 0;
    let mut block: Option<std::ops::Range<usize>> = None;
    for line in text.split_inclusive('\n').take(LINES) {
        let start = at + (line.len() - line.trim_start().len());
        let code = line.trim();
        at += line.len();
        let found = |program| Some(Foreign { program, line: start..start + code.len() });
        let word = code.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("");
        let rest = code[word.len()..].trim_start();
        if word == "scn" {
            return None;
        }
        if code.starts_with("[gd_scene") || code.starts_with("[gd_resource") {
            return found("Godot");
        }
        if code.starts_with("<scene") {
            return found("Mitsuba");
        }
        let directive = code.split_whitespace().next().unwrap_or("");
        if POV_RAY.contains(&directive) {
            return found("POV-Ray");
        }
        let numbers = |c: char| c.is_ascii_digit() || matches!(c, '"' | '[' | '-');
        if PBRT.contains(&word) && (rest.is_empty() || rest.starts_with(numbers)) {
            return found("pbrt");
        }
        let property = code.split('=').next().unwrap_or("").trim_end();
        let dotted = property.chars().all(|c| c.is_alphanumeric() || "._-".contains(c));
        let known = LUXCORE.iter().any(|word| property.starts_with(word));
        if known && dotted && code.contains('=') && property.matches('.').count() > 1 {
            return found("LuxCore");
        }
        // `camera { location <0, 1, 2>`: only POV-Ray has vectors in angles.
        if POV_RAY_BLOCKS.contains(&word) && rest.starts_with('{') {
            block.get_or_insert(start..start + code.len());
        }
        let vector = code.split_once('<').is_some_and(|(_, rest)| {
            rest.trim_start().starts_with(|c: char| c.is_ascii_digit() || "-+.".contains(c))
        });
        if let (Some(line), true) = (&block, vector) {
            return Some(Foreign { program: "POV-Ray", line: line.clone() });
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_of_other_programs_are_known_by_how_they_begin() {
        for (text, program, line) in [
            (
                "# Cornell\nscene.camera.type = \"perspective\"\n",
                "LuxCore",
                "scene.camera.type = \"perspective\"",
            ),
            ("renderengine.config.type = PATHCPU", "LuxCore", "renderengine.config.type = PATHCPU"),
            ("\n[gd_scene load_steps=4 format=3]\n", "Godot", "[gd_scene load_steps=4 format=3]"),
            ("# a\nLookAt 3 4 1.5  .5 .5 0  0 0 1\n", "pbrt", "LookAt 3 4 1.5  .5 .5 0  0 0 1"),
            ("Film \"rgb\"\n", "pbrt", "Film \"rgb\""),
            (
                "<?xml version=\"1.0\"?>\n<scene version=\"3.0.0\">",
                "Mitsuba",
                "<scene version=\"3.0.0\">",
            ),
            ("// POV\n#include \"colors.inc\"\n", "POV-Ray", "#include \"colors.inc\""),
            ("camera {\n  location <0, 1, -3>\n}\n", "POV-Ray", "camera {"),
        ] {
            let found = recognise(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!((found.program, &text[found.line]), (program, line));
        }
    }

    #[test]
    fn scenes_of_ours_are_ours_whatever_is_wrong_with_them() {
        for text in [
            "scn 1 in m\nscene.camera.lookat = 1\n",
            "// a\nscn 1\n#include \"a\"\n",
            "film.size = (8, 8)\n",
            "camera { eye: (0, 0, 1) }\n",
            "integrator: direct\n",
            "Camera: perspective\n",
            "",
        ] {
            assert!(recognise(text).is_none(), "{text}");
        }
    }
}
