//! PNG files: eight bits a channel, encoded as sRGB, with words about the picture.

use std::io::BufReader;
use std::path::Path;

use super::{Failure, Metadata, regular, whole};
use crate::math::{Picture, srgb};

/// The longest PNG whose words are read, in bytes.
const LIMIT: u64 = 4_000_000_000;
/// Words of a picture take no more memory than this, in bytes.
const WORDS: usize = 16_000_000;

/// Writes linear colour times `exposure` as sRGB. Beyond [0, 1] it is clipped; a pixel that is
/// not a number is refused. Metadata keys are of 1 to 79 characters of Latin-1.
pub fn write(
    path: &Path,
    picture: &Picture,
    exposure: f64,
    metadata: &Metadata,
) -> Result<(), Failure> {
    let bytes = encoded(picture, exposure)?;
    let side = |length: usize| {
        u32::try_from(length).map_err(|_| Failure::new("is too wide or too high for a PNG"))
    };
    let (width, height) = (side(picture.width)?, side(picture.height)?);
    whole::write(path, |file| {
        let mut encoder = png::Encoder::new(file, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::RelativeColorimetric);
        for (key, value) in metadata {
            encoder.add_itxt_chunk(key.clone(), value.clone()).map_err(unwritten)?;
        }
        let mut writer = encoder.write_header().map_err(unwritten)?;
        writer.write_image_data(&bytes).map_err(unwritten)?;
        writer.finish().map_err(unwritten)
    })
}

/// The words of a PNG, in the order they stand there.
pub fn read_metadata(path: &Path) -> Result<Metadata, Failure> {
    let (file, _) = regular::open(path, LIMIT)?;
    let mut decoder = png::Decoder::new(BufReader::new(file));
    decoder.set_limits(png::Limits { bytes: WORDS });
    let reader = decoder.read_info().map_err(unread)?;
    let mut metadata = Metadata::new();
    for text in &reader.info().utf8_text {
        metadata.push((text.keyword.clone(), text.get_text().map_err(unread)?));
    }
    Ok(metadata)
}

/// Rows of sRGB, top row first.
fn encoded(picture: &Picture, exposure: f64) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::with_capacity(picture.pixels.len() * 3);
    for (i, pixel) in picture.pixels.iter().enumerate() {
        for linear in pixel.to_array() {
            if linear.is_nan() {
                let (x, y) = (i % picture.width, i / picture.width);
                return Err(Failure::new(format!(
                    "cannot show pixel ({x}, {y}), which is not a number"
                )));
            }
            bytes.push((srgb::encode(f64::from(linear) * exposure) * 255.0).round() as u8);
        }
    }
    Ok(bytes)
}

fn unwritten(error: png::EncodingError) -> Failure {
    match error {
        png::EncodingError::IoError(error) => error.into(),
        error => Failure::new(format!("cannot be written as PNG: {error}")),
    }
}

fn unread(error: png::DecodingError) -> Failure {
    match error {
        png::DecodingError::IoError(error) => error.into(),
        error => Failure::new(format!("is no whole PNG: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn picture() -> Picture {
        let mut picture = Picture::black(3, 2);
        picture.pixels[0] = Rgb::new(0.5, 0.001, 1.0);
        picture.pixels[1] = Rgb::new(-1.0, f32::INFINITY, 0.25);
        picture
    }

    #[test]
    fn colours_are_encoded_as_the_standard_says_and_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new/a.png");
        write(&path, &picture(), 1.0, &Metadata::new()).unwrap();
        let read = image::open(&path).unwrap().to_rgb8();
        assert_eq!(read.dimensions(), (3, 2));
        // 0.5 → 187.52, 0.001 → 3.29, 0.25 → 136.96 by the formula.
        assert_eq!(read.get_pixel(0, 0).0, [188, 3, 255]);
        assert_eq!(read.get_pixel(1, 0).0, [0, 255, 137]);
        assert_eq!(read.get_pixel(2, 1).0, [0, 0, 0]);
        write(&path, &picture(), 0.5, &Metadata::new()).unwrap();
        assert_eq!(image::open(&path).unwrap().to_rgb8().get_pixel(0, 0).0, [137, 2, 188]);
    }

    #[test]
    fn words_come_back_as_they_went() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        let metadata: Metadata = vec![
            ("scn:render".into(), "fig05".into()),
            ("scn:caption".into(), "Figur 5: ærlig\nto linjer, 光".into()),
            ("scn:empty".into(), String::new()),
        ];
        write(&path, &picture(), 1.0, &metadata).unwrap();
        assert_eq!(read_metadata(&path).unwrap(), metadata);
        assert!(std::fs::read(&path).unwrap().windows(4).any(|w| w == b"sRGB"));
    }

    #[test]
    fn a_picture_with_a_nan_leaves_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        write(&path, &picture(), 1.0, &Metadata::new()).unwrap();
        let before = std::fs::read(&path).unwrap();
        let mut bad = picture();
        bad.pixels[5].g = f32::NAN;
        let failure = write(&path, &bad, 1.0, &Metadata::new()).unwrap_err().to_string();
        assert_eq!(failure, "cannot show pixel (2, 1), which is not a number");
        assert_eq!(std::fs::read(&path).unwrap(), before);
    }

    #[test]
    fn what_is_no_png_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        std::fs::write(&path, "v 1 2 3").unwrap();
        assert!(read_metadata(&path).unwrap_err().to_string().starts_with("is no whole PNG: "));
        assert_eq!(read_metadata(folder.path()).unwrap_err().to_string(), "is a folder");
    }
}
