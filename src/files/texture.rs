//! Pictures that are textures: PNG, JPEG, PNM, Radiance HDR and OpenEXR, known by how they begin.
//!
//! What a file says of its colours (gamma, profiles) and of its orientation is left out: values are
//! taken as they are, and the scene says how they are encoded.

mod watched;

use std::io::Cursor;

use image::codecs::pnm::{PnmDecoder, PnmSubtype};
use image::{DynamicImage, ImageError, ImageFormat, ImageReader, Limits};

use super::{Failure, exr, png};
use crate::math::{Picture, Progress, Texels, Values};

use watched::Watched;

/// The longest file that is read, in bytes.
pub const LIMIT: u64 = 1_000_000_000;
/// The most memory that decoding may take, in bytes.
const MOST_MEMORY: u64 = 2_000_000_000;
/// The most texels a row, and rows.
const MOST_SIDE: u32 = 1 << 16;
/// How an OpenEXR file begins.
const EXR: [u8; 4] = [0x76, 0x2f, 0x31, 0x01];

/// What a file holds.
#[derive(Debug, PartialEq)]
pub struct Reading {
    /// Its texels, without their opacity.
    pub texels: Texels,
    /// Whether some of them are not opaque.
    pub transparent: bool,
}

/// Reads the bytes of a file. `progress` is told how many of them are taken; when it cancels, the
/// file counts as one that cannot be read.
pub fn parse(bytes: &[u8], progress: &dyn Progress) -> Result<Reading, Failure> {
    let watched = || Watched::new(bytes, progress);
    if bytes.starts_with(&EXR) {
        let (layers, _) = exr::parse(watched(), bytes.len() as u64)?;
        return Ok(Reading { texels: linear(layers.main)?, transparent: false });
    }
    let mut reader = ImageReader::new(watched()).with_guessed_format()?;
    let format = reader.format();
    if format.is_none() {
        return Err(Failure::new("is no PNG, JPEG, PNM, HDR or EXR file"));
    }
    if format == Some(ImageFormat::Pnm) {
        check_scale(bytes)?;
    }
    let mut limits = Limits::default();
    limits.max_image_width = Some(MOST_SIDE);
    limits.max_image_height = Some(MOST_SIDE);
    limits.max_alloc = Some(MOST_MEMORY);
    reader.limits(limits);
    let image = reader.decode().map_err(undecoded)?;
    if format == Some(ImageFormat::Png) {
        // Once more, but for pictures of a palette alone, and within the limits by now.
        png::check_palette(watched())?;
    }
    // What is left is done at once, and takes a while of a large picture.
    match progress.cancelled() {
        true => Err(watched::stopped().into()),
        false => taken(image),
    }
}

/// Refuses PNM files whose values count up to other numbers than eight or sixteen bits do: the
/// crate does not scale them.
fn check_scale(bytes: &[u8]) -> Result<(), Failure> {
    let (_, header) = PnmDecoder::new(Cursor::new(bytes)).map_err(undecoded)?.into_inner();
    match (header.subtype(), header.maximal_sample()) {
        (PnmSubtype::Bitmap(_), _) | (_, 255 | 65535) => Ok(()),
        (_, most) => Err(Failure::new(format!(
            "has values up to {most}; only those up to 255 and 65535 are read"
        ))),
    }
}

fn undecoded(error: ImageError) -> Failure {
    match error {
        ImageError::Limits(_) => Failure::new(format!(
            "is too large: more than {MOST_SIDE} texels a side, or more than 2 GB of memory"
        )),
        ImageError::Unsupported(_) => Failure::new("is of a kind of picture that is not read"),
        ImageError::IoError(error) => error.into(),
        _ => Failure::new("is damaged, or not what it begins as"),
    }
}

fn taken(image: DynamicImage) -> Result<Reading, Failure> {
    let (width, height) = (image.width(), image.height());
    if width == 0 || height == 0 {
        return Err(Failure::new("holds no texel"));
    }
    let mut transparent = false;
    let values = match image {
        DynamicImage::ImageLuma8(all) => Values::Grey8(all.into_raw()),
        DynamicImage::ImageLumaA8(all) => {
            transparent = all.pixels().any(|texel| texel.0[1] < u8::MAX);
            Values::Grey8(all.pixels().map(|texel| texel.0[0]).collect())
        }
        DynamicImage::ImageRgb8(all) => Values::Rgb8(all.pixels().map(|texel| texel.0).collect()),
        DynamicImage::ImageRgba8(all) => {
            transparent = all.pixels().any(|texel| texel.0[3] < u8::MAX);
            Values::Rgb8(all.pixels().map(|texel| colour(texel.0)).collect())
        }
        DynamicImage::ImageLuma16(all) => Values::Grey16(all.into_raw()),
        DynamicImage::ImageLumaA16(all) => {
            transparent = all.pixels().any(|texel| texel.0[1] < u16::MAX);
            Values::Grey16(all.pixels().map(|texel| texel.0[0]).collect())
        }
        DynamicImage::ImageRgb16(all) => Values::Rgb16(all.pixels().map(|texel| texel.0).collect()),
        DynamicImage::ImageRgba16(all) => {
            transparent = all.pixels().any(|texel| texel.0[3] < u16::MAX);
            Values::Rgb16(all.pixels().map(|texel| colour(texel.0)).collect())
        }
        DynamicImage::ImageRgb32F(all) => {
            floats(width, all.pixels().map(|texel| texel.0).collect())?
        }
        DynamicImage::ImageRgba32F(all) => {
            transparent = all.pixels().any(|texel| texel.0[3] < 1.0);
            floats(width, all.pixels().map(|texel| colour(texel.0)).collect())?
        }
        _ => return Err(Failure::new("is of a kind of picture that is not read")),
    };
    Ok(Reading { texels: Texels { width, height, values }, transparent })
}

fn colour<T: Copy>([r, g, b, _]: [T; 4]) -> [T; 3] {
    [r, g, b]
}

fn linear(picture: Picture) -> Result<Texels, Failure> {
    let side = |side: usize| u32::try_from(side).ok().filter(|side| (1..=MOST_SIDE).contains(side));
    let (Some(width), Some(height)) = (side(picture.width), side(picture.height)) else {
        return Err(Failure::new(format!("is empty, or has more than {MOST_SIDE} texels a side")));
    };
    let values = floats(width, picture.pixels.iter().map(|rgb| [rgb.r, rgb.g, rgb.b]).collect())?;
    Ok(Texels { width, height, values })
}

/// Refuses what is no light.
fn floats(width: u32, all: Vec<[f32; 3]>) -> Result<Values, Failure> {
    let sound = |texel: &[f32; 3]| texel.iter().all(|x| x.is_finite() && *x >= 0.0);
    let Some(wrong) = all.iter().position(|texel| !sound(texel)) else {
        return Ok(Values::Float(all));
    };
    let (x, y) = (wrong % width as usize, wrong / width as usize);
    Err(Failure::new(format!(
        "has a value that is negative or not finite in column {x} of row {y}"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::NoProgress;
    use image::ExtendedColorType;

    fn unwatched(bytes: &[u8]) -> Result<Reading, Failure> {
        parse(bytes, &NoProgress)
    }

    fn written(image: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        image.into().write_to(&mut bytes, format).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn each_kind_is_read_as_it_was_written() {
        let grey = image::GrayImage::from_fn(3, 2, |x, y| image::Luma([(40 * x + 7 * y) as u8]));
        let read = unwatched(&written(grey.clone(), ImageFormat::Png)).unwrap();
        assert_eq!(read.texels.values, Values::Grey8(grey.into_raw()));
        assert_eq!((read.texels.width, read.texels.height, read.transparent), (3, 2, false));
        let deep = image::ImageBuffer::from_fn(2, 2, |x, y| image::Rgb([x as u16, 500, y as u16]));
        let read = unwatched(&written(deep, ImageFormat::Png)).unwrap();
        let expected = vec![[0, 500, 0], [1, 500, 0], [0, 500, 1], [1, 500, 1]];
        assert_eq!(read.texels.values, Values::Rgb16(expected));
        let clear = image::RgbaImage::from_pixel(1, 2, image::Rgba([9, 8, 7, 254]));
        let read = unwatched(&written(clear, ImageFormat::Png)).unwrap();
        assert_eq!(read.texels.values, Values::Rgb8(vec![[9, 8, 7]; 2]));
        assert!(read.transparent);
        let plain = unwatched(b"P3 2 1 255  255 0 0  0 9 255\n").unwrap();
        assert_eq!(plain.texels.values, Values::Rgb8(vec![[255, 0, 0], [0, 9, 255]]));
        // 2^(130 - 128) of 128/256.
        let light = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x40\x00\x82";
        assert_eq!(unwatched(light).unwrap().texels.values, Values::Float(vec![[2.0, 1.0, 0.0]]));
    }

    #[test]
    fn jpeg_is_read_too() {
        let grey = image::RgbImage::from_pixel(9, 5, image::Rgb([200, 100, 50]));
        let read = unwatched(&written(grey, ImageFormat::Jpeg)).unwrap();
        let Values::Rgb8(texels) = &read.texels.values else { panic!() };
        assert_eq!((texels.len(), read.texels.width), (45, 9));
        assert!(texels.iter().all(|t| t[0].abs_diff(200) < 4 && t[2].abs_diff(50) < 4));
        assert!((read.texels.largest()[0] - 200.0 / 255.0).abs() < 0.02);
    }

    #[test]
    fn a_reading_tells_how_far_it_is_and_ends_when_it_is_not_wanted() {
        use std::sync::atomic::{AtomicU64, Ordering};

        struct Watcher {
            patience: u64,
            told: AtomicU64,
        }
        impl Progress for Watcher {
            fn advance(&self, done: u64, total: u64) {
                assert!(done <= total);
                self.told.fetch_add(1, Ordering::Relaxed);
            }
            fn cancelled(&self) -> bool {
                self.told.load(Ordering::Relaxed) >= self.patience
            }
        }
        let noise = image::GrayImage::from_fn(200, 200, |x, y| {
            image::Luma([crate::math::random::mix(u64::from(x + 200 * y)) as u8])
        });
        let bytes = written(noise, ImageFormat::Png);
        let patient = Watcher { patience: u64::MAX, told: AtomicU64::new(0) };
        assert!(parse(&bytes, &patient).is_ok());
        let pieces = patient.told.into_inner();
        assert!(pieces >= bytes.len() as u64 / 4096, "{pieces}");
        for patience in [0, 1, pieces / 2] {
            let hasty = Watcher { patience, told: AtomicU64::new(0) };
            assert!(parse(&bytes, &hasty).is_err());
            assert_eq!(hasty.told.into_inner(), patience);
        }
    }

    #[test]
    fn a_colour_beyond_the_palette_is_refused() {
        let file = |colours: usize, depth, row: &[u8]| {
            let mut bytes = Vec::new();
            let mut encoder = ::png::Encoder::new(&mut bytes, 5, 2);
            encoder.set_color(::png::ColorType::Indexed);
            encoder.set_depth(depth);
            encoder.set_palette((0..3 * colours as u8).collect::<Vec<_>>());
            let mut writer = encoder.write_header().unwrap();
            writer.write_image_data(&row.repeat(2)).unwrap();
            writer.finish().unwrap();
            bytes
        };
        let failure = |bytes: &[u8]| unwatched(bytes).unwrap_err().to_string();
        // 0 1 2 1 3, and what fills up the byte.
        let row = [0b00_01_10_01, 0b11_11_11_11];
        let whole = unwatched(&file(4, ::png::BitDepth::Two, &row)).unwrap().texels;
        let Values::Rgb8(texels) = whole.values else { panic!() };
        assert_eq!(texels[..5], [[0, 1, 2], [3, 4, 5], [6, 7, 8], [3, 4, 5], [9, 10, 11]]);
        assert_eq!(
            failure(&file(3, ::png::BitDepth::Two, &row)),
            "has colour 3 in column 4 of row 0, but its palette ends with colour 2"
        );
        let padded = [0b00_01_10_01, 0b00_11_11_11];
        assert!(
            unwatched(&file(3, ::png::BitDepth::Two, &padded)).is_ok(),
            "what fills up is no pixel"
        );
        assert_eq!(
            failure(&file(2, ::png::BitDepth::Eight, &[0, 1, 0, 200, 1])),
            "has colour 200 in column 3 of row 0, but its palette ends with colour 1"
        );
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        let failure = |bytes: &[u8]| unwatched(bytes).unwrap_err().to_string();
        assert_eq!(failure(b"hello"), "is no PNG, JPEG, PNM, HDR or EXR file");
        assert_eq!(failure(b""), "is no PNG, JPEG, PNM, HDR or EXR file");
        assert_eq!(
            failure(b"P2 1 1 15 7"),
            "has values up to 15; only those up to 255 and 65535 are read"
        );
        // A header alone, of a picture of 65,535 texels a side.
        let bomb = format!("P6 65535 65535 255\n{}", "x".repeat(9));
        assert!(
            failure(bomb.as_bytes()).starts_with("is too large"),
            "{}",
            failure(bomb.as_bytes())
        );
    }

    #[test]
    fn files_broken_anywhere_do_no_harm() {
        let noise = |x: u32, y: u32| [(x * 37 + y * 91) as u8, (x * y) as u8, 255 - x as u8];
        let image = image::RgbImage::from_fn(16, 12, |x, y| image::Rgb(noise(x, y)));
        let float = DynamicImage::from(image.clone()).to_rgb32f();
        let mut hdr = Vec::new();
        let encoder = image::codecs::hdr::HdrEncoder::new(&mut hdr);
        let pixels: Vec<_> = float.pixels().copied().collect();
        encoder.encode(&pixels, 16, 12).unwrap();
        let mut pnm = Vec::new();
        let encoder = image::codecs::pnm::PnmEncoder::new(&mut pnm);
        image::ImageEncoder::write_image(encoder, image.as_raw(), 16, 12, ExtendedColorType::Rgb8)
            .unwrap();
        let files =
            [written(image.clone(), ImageFormat::Png), written(image, ImageFormat::Jpeg), hdr, pnm];
        let mut refused = 0;
        for file in &files {
            assert!(unwatched(file).is_ok());
            for end in 0..file.len().min(200) {
                refused += u32::from(unwatched(&file[..end]).is_err());
            }
            for round in 0..600_u64 {
                let mut broken = file.clone();
                let luck = crate::math::random::mix(round);
                let at = luck as usize % broken.len();
                broken[at] ^= (luck >> 32) as u8 | 1;
                refused += u32::from(unwatched(&broken).is_err());
            }
        }
        assert!(refused > 800, "{refused}");
    }
}
