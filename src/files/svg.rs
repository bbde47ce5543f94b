//! SVG files: a picture with lines over it, which stay sharp however large they are shown.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use base64::prelude::{BASE64_STANDARD, Engine};

use super::{Failure, png, whole};
use crate::math::{Lines, Picture, Rgb, srgb};

/// Writes a picture of linear colour in [0, 1], and lines over it, each group with its title.
pub fn write(path: &Path, title: &str, picture: &Picture, lines: &[Lines]) -> Result<(), Failure> {
    let (width, height) = (picture.width, picture.height);
    let background = BASE64_STANDARD.encode(png::bytes(picture)?);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">\n<title>{}</title>\n<image width=\"{width}\" \
         height=\"{height}\" href=\"data:image/png;base64,{background}\"/>\n\
         <g fill=\"none\" stroke-linecap=\"round\">\n",
        escaped(title)
    );
    for group in lines.iter().filter(|lines| !lines.pieces.is_empty()) {
        let _ = write!(
            text,
            "<path stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{:.3}\" d=\"",
            hex(group.colour),
            group.width,
            group.opacity
        );
        let mut end = None;
        for [from, to] in &group.pieces {
            if end != Some(*from) {
                let _ = write!(text, "M{:.2} {:.2}", from[0], from[1]);
            }
            let _ = write!(text, "L{:.2} {:.2}", to[0], to[1]);
            end = Some(*to);
        }
        let _ = writeln!(text, "\"><title>{}</title></path>", escaped(&group.title));
    }
    text.push_str("</g>\n</svg>\n");
    whole::write(path, |file| Ok(file.write_all(text.as_bytes())?))
}

/// `#ff80c0`
fn hex(colour: Rgb) -> String {
    let byte = |linear: f32| (srgb::encode(f64::from(linear)) * 255.0).round() as u8;
    let [r, g, b] = colour.to_array().map(byte);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Text as it stands in XML.
fn escaped(text: &str) -> String {
    let mut all = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => all.push_str("&lt;"),
            '>' => all.push_str("&gt;"),
            '&' => all.push_str("&amp;"),
            '"' => all.push_str("&quot;"),
            // XML 1.0 has no place for control characters.
            c if c.is_control() => all.push(' '),
            c => all.push(c),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_written_with_their_titles() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.svg");
        let lines = Lines {
            pieces: vec![
                [[0.0, 1.0], [2.5, 1.0]],
                [[2.5, 1.0], [3.0, 0.0]],
                [[0.0, 0.0], [1.0, 1.0]],
            ],
            colour: Rgb::new(1.0, 0.0, 0.214_041_14),
            width: 1.0,
            opacity: 0.5,
            title: "L S+ <D> & \"E\"\u{7}".into(),
        };
        write(&path, "a < b", &Picture::black(3, 2), &[lines]).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.starts_with("<svg "), "{text}");
        for part in [
            "viewBox=\"0 0 3 2\"",
            "<title>a &lt; b</title>",
            "href=\"data:image/png;base64,iVBORw0KGgo",
            "stroke=\"#ff0080\" stroke-width=\"1\" stroke-opacity=\"0.500\"",
            "d=\"M0.00 1.00L2.50 1.00L3.00 0.00M0.00 0.00L1.00 1.00\"",
            "<title>L S+ &lt;D&gt; &amp; &quot;E&quot; </title>",
            "</svg>\n",
        ] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }
}
