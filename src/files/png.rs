//! PNG files: eight bits a channel, encoded as sRGB, with words about the picture.

use std::fs::File;
use std::io::{BufRead, BufReader, Seek};
use std::path::Path;

use super::{Failure, Metadata, regular, whole};
use crate::math::{Picture, Rgb, srgb};

/// The longest PNG that is read, in bytes.
const LIMIT: u64 = 4_000_000_000;
/// Words of a picture take no more memory than this, in bytes.
const WORDS: usize = 16_000_000;
/// Deflate shrinks nothing to less than one part in so many.
const STRONGEST_COMPRESSION: u64 = 1032;

/// Writes linear colour times `exposure` as sRGB. Beyond [0, 1] it is clipped; a pixel that is
/// not a number is refused. Metadata keys are of 1 to 79 characters of Latin-1.
pub fn write(
    path: &Path,
    picture: &Picture,
    exposure: f64,
    metadata: &Metadata,
) -> Result<(), Failure> {
    let encoded = Encoded::new(picture, exposure)?;
    whole::write(path, |file| encoded.write(file, metadata))
}

/// The bytes of the file that [`write`] would write, without words.
pub(super) fn bytes(picture: &Picture) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    Encoded::new(picture, 1.0)?.write(&mut bytes, &Metadata::new())?;
    Ok(bytes)
}

/// A picture as it goes into a file.
struct Encoded {
    width: u32,
    height: u32,
    bytes: Vec<u8>,
}

impl Encoded {
    fn new(picture: &Picture, exposure: f64) -> Result<Self, Failure> {
        let side = |length: usize| {
            u32::try_from(length).map_err(|_| Failure::new("is too wide or too high for a PNG"))
        };
        let bytes = encoded(picture, exposure)?;
        Ok(Self { width: side(picture.width)?, height: side(picture.height)?, bytes })
    }

    fn write(&self, to: impl std::io::Write, metadata: &Metadata) -> Result<(), Failure> {
        let mut encoder = png::Encoder::new(to, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        // Noise does not shrink, however long one tries.
        encoder.set_compression(png::Compression::Fast);
        encoder.set_source_srgb(png::SrgbRenderingIntent::RelativeColorimetric);
        for (key, value) in metadata {
            encoder.add_itxt_chunk(key.clone(), value.clone()).map_err(unwritten)?;
        }
        let mut writer = encoder.write_header().map_err(unwritten)?;
        writer.write_image_data(&self.bytes).map_err(unwritten)?;
        writer.finish().map_err(unwritten)
    }
}

/// Reads a PNG of any kind as linear colour in [0, 1], taking what it holds for sRGB whatever it
/// says of its own colours. Transparent pixels are refused: they have no one colour.
pub fn read(path: &Path) -> Result<(Picture, Metadata), Failure> {
    let (mut decoder, length) = decoder(path)?;
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(unread)?;
    let bytes = reader.output_buffer_size().unwrap_or(usize::MAX);
    // A header may claim any size: memory is taken only for what a file of this length can hold.
    if bytes as u64 / STRONGEST_COMPRESSION > length {
        return Err(Failure::new("claims more pixels than a file of its length can hold"));
    }
    let mut bytes = vec![0; bytes];
    let frame = reader.next_frame(&mut bytes).map_err(unread)?;
    reader.finish().map_err(unread)?;
    let metadata = words(reader.info())?;
    let samples: Vec<f64> = match frame.bit_depth {
        png::BitDepth::Sixteen => bytes
            .chunks_exact(2)
            .map(|pair| f64::from(u16::from_be_bytes([pair[0], pair[1]])) / 65535.0)
            .collect(),
        _ => bytes.iter().map(|&byte| f64::from(byte) / 255.0).collect(),
    };
    let pixels: Option<Vec<Rgb>> =
        samples.chunks_exact(frame.color_type.samples()).map(opaque).collect();
    let pixels = pixels.ok_or_else(|| Failure::new("has transparent pixels"))?;
    let (width, height) = (frame.width as usize, frame.height as usize);
    Ok((Picture { width, height, pixels }, metadata))
}

/// Refuses a picture of a palette with a pixel beyond its end: decoders differ in what they make of
/// it. What is no such picture is not read further.
pub(super) fn check_palette(file: impl BufRead + Seek) -> Result<(), Failure> {
    let mut decoder = png::Decoder::new(file);
    decoder.set_limits(png::Limits { bytes: WORDS });
    decoder.set_transformations(png::Transformations::IDENTITY);
    let mut reader = decoder.read_info().map_err(unread)?;
    let info = reader.info();
    if info.color_type != png::ColorType::Indexed {
        return Ok(());
    }
    let (width, bits) = (info.width as usize, info.bit_depth as usize);
    let colours = info.palette.as_ref().map_or(0, |palette| palette.len() / 3);
    if colours >= 1 << bits {
        return Ok(());
    }
    let mut pixels = vec![0; reader.output_buffer_size().unwrap_or(usize::MAX)];
    let frame = reader.next_frame(&mut pixels).map_err(unread)?;
    for (y, row) in pixels.chunks_exact(frame.line_size).enumerate() {
        for x in 0..width {
            let byte = usize::from(row[x * bits / 8]);
            let index = byte >> (8 - bits - x * bits % 8) & ((1 << bits) - 1);
            if index >= colours {
                return Err(Failure::new(format!(
                    "has colour {index} in column {x} of row {y}, but its palette ends with \
                     colour {}",
                    colours.saturating_sub(1)
                )));
            }
        }
    }
    Ok(())
}

/// The linear colour of a pixel's encoded samples: grey or three colours, and perhaps how opaque
/// it is; none unless it is so wholly.
fn opaque(samples: &[f64]) -> Option<Rgb> {
    let (colour, opacity) = match *samples {
        [grey] => ([grey; 3], 1.0),
        [grey, opacity] => ([grey; 3], opacity),
        [r, g, b] => ([r, g, b], 1.0),
        [r, g, b, opacity] => ([r, g, b], opacity),
        _ => return None,
    };
    let [r, g, b] = colour.map(|sample| srgb::decode(sample) as f32);
    (opacity == 1.0).then_some(Rgb::new(r, g, b))
}

/// The words of a PNG, in the order they stand there.
pub fn read_metadata(path: &Path) -> Result<Metadata, Failure> {
    words(decoder(path)?.0.read_info().map_err(unread)?.info())
}

/// What reads the file, and the file's length.
fn decoder(path: &Path) -> Result<(png::Decoder<BufReader<File>>, u64), Failure> {
    let (file, length) = regular::open(path, LIMIT)?;
    let mut decoder = png::Decoder::new(BufReader::new(file));
    decoder.set_limits(png::Limits { bytes: WORDS });
    Ok((decoder, length))
}

fn words(info: &png::Info) -> Result<Metadata, Failure> {
    let word = |text: &png::text_metadata::ITXtChunk| {
        Ok((text.keyword.clone(), text.get_text().map_err(unread)?))
    };
    info.utf8_text.iter().map(word).collect()
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
    fn pictures_come_back_as_they_were_shown() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        let words: Metadata = vec![("scn:seed".into(), "7".into())];
        write(&path, &picture(), 1.0, &words).unwrap();
        let (shown, read_words) = read(&path).unwrap();
        assert_eq!((shown.width, shown.height, &read_words), (3, 2, &words));
        // 188/255 is 0.50289 when decoded, 3/255 is 0.00091; what was beyond is clipped.
        let [r, g, b] = shown.pixels[0].to_array();
        assert!((r - 0.502_886).abs() < 1e-5 && (g - 0.000_911).abs() < 1e-5 && b == 1.0);
        assert_eq!(shown.pixels[1].to_array()[..2], [0.0, 1.0]);
        // Written again it is the same: the eight bits are kept.
        write(&path, &shown, 1.0, &words).unwrap();
        assert_eq!(read(&path).unwrap().0, shown);
    }

    #[test]
    fn grey_deep_and_transparent_pictures_of_others() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        image::GrayImage::from_pixel(4, 5, image::Luma([188])).save(&path).unwrap();
        let grey = read(&path).unwrap().0;
        assert_eq!((grey.width, grey.height), (4, 5));
        assert!((grey.pixels[19].g - 0.502_886).abs() < 1e-5);
        let deep = image::Rgb([1000_u16, 30000, 65535]);
        image::ImageBuffer::from_pixel(2, 2, deep).save(&path).unwrap();
        let [r, g, b] = read(&path).unwrap().0.pixels[3].to_array();
        // decode(1000/65535), decode(30000/65535)
        assert!(
            (r - 0.001_181_1).abs() < 1e-6 && (g - 0.177_015).abs() < 1e-5 && b == 1.0,
            "{r} {g}"
        );
        let mut clear = image::RgbaImage::from_pixel(2, 2, image::Rgba([9, 9, 9, 255]));
        clear.save(&path).unwrap();
        assert!(read(&path).is_ok());
        clear.put_pixel(1, 0, image::Rgba([9, 9, 9, 254]));
        clear.save(&path).unwrap();
        assert_eq!(read(&path).unwrap_err().to_string(), "has transparent pixels");
    }

    #[test]
    fn truncated_and_forged_pictures_are_told_not_trusted() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        write(&path, &picture(), 1.0, &vec![("scn:seed".into(), "7".into())]).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        for end in 0..bytes.len() - 12 {
            std::fs::write(&path, &bytes[..end]).unwrap();
            assert!(read(&path).is_err(), "of {} bytes, {end}", bytes.len());
        }
        for at in 0..bytes.len() {
            let mut forged = bytes.clone();
            forged[at] ^= 0x7f;
            std::fs::write(&path, &forged).unwrap();
            let _ = read(&path);
        }
        // A height of 2³¹ − 1 under a right checksum.
        let mut header = b"IHDR".to_vec();
        header.extend([0x00, 0x00, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff, 8, 2, 0, 0, 0]);
        let mut huge = bytes.clone();
        huge[12..29].copy_from_slice(&header);
        huge[29..33].copy_from_slice(&crc32(&header).to_be_bytes());
        std::fs::write(&path, huge).unwrap();
        let failure = read(&path).unwrap_err().to_string();
        assert_eq!(failure, "claims more pixels than a file of its length can hold");
    }

    /// The checksum of a chunk's name and content.
    fn crc32(bytes: &[u8]) -> u32 {
        let step = |crc: u32, _| if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 };
        !bytes.iter().fold(!0, |crc, byte| (0..8).fold(crc ^ u32::from(*byte), step))
    }

    #[test]
    fn what_is_no_png_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        std::fs::write(&path, "v 1 2 3").unwrap();
        assert!(read_metadata(&path).unwrap_err().to_string().starts_with("is no whole PNG: "));
        assert!(read(&path).unwrap_err().to_string().starts_with("is no whole PNG: "));
        assert_eq!(read_metadata(folder.path()).unwrap_err().to_string(), "is a folder");
    }
}
