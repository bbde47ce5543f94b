//! OpenEXR files: the light itself, 32-bit floats, linear, primaries of sRGB (the format's
//! default), with named layers beside the picture and words about it.
//!
//! Scan lines, compressed by ZIP without loss. A crop keeps its place: the data window lies in
//! the display window. Layers are channels with a prefix, `normal.R`, as every reader knows them.

use std::io::{BufRead, BufReader, Seek};
use std::path::Path;

use ::exr::meta::attribute::{AttributeValue, IntegerBounds, Text};
use ::exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, ImageAttributes, Layer, LayerAttributes,
    ReadChannels, ReadLayers, Vec2, WritableImage,
};

use super::{Failure, Metadata, regular, whole};
use crate::math::{Picture, Rgb};

/// The longest file that is read, in bytes.
const LIMIT: u64 = 64_000_000_000;
/// Deflate shrinks nothing to less than one part in so many.
const STRONGEST_COMPRESSION: u64 = 1032;

/// What an EXR file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Layers {
    /// Width and height of the whole film, in pixels.
    pub film: [usize; 2],
    /// Column and row of the film where the pictures' top left pixel lies; zero without a crop.
    pub origin: [usize; 2],
    /// Linear radiance.
    pub main: Picture,
    /// Further pictures of the same size by name, sorted by it.
    pub named: Vec<(String, Picture)>,
    /// Further values, one a pixel row by row from the top left, by name, sorted by it; channels
    /// called `name.Y`.
    pub scalars: Vec<(String, Vec<f32>)>,
}

impl Layers {
    /// A whole film without further layers.
    pub fn new(main: Picture) -> Self {
        let film = [main.width, main.height];
        Self { film, origin: [0, 0], main, named: Vec::new(), scalars: Vec::new() }
    }
}

/// Writes pictures; a pixel that is infinite or not a number is refused.
pub fn write(path: &Path, layers: &Layers, metadata: &Metadata) -> Result<(), Failure> {
    let size = [layers.main.width, layers.main.height];
    let mut channels = channels("", &layers.main)?;
    for (name, picture) in &layers.named {
        assert_eq!([picture.width, picture.height], size, "layers are of one size");
        channels.extend(self::channels(&format!("{name}."), picture)?);
    }
    for (name, values) in &layers.scalars {
        assert_eq!(values.len(), size[0] * size[1], "layers are of one size");
        let name = format!("{name}.Y");
        let samples = FlatSamples::F32(values.clone());
        channels.push(AnyChannel::new(Text::from_slice_unchecked(name.as_bytes()), samples));
    }
    let [left, top] = window(layers.origin)?;
    let [width, height] = window(layers.film)?;
    if width == 0 || height == 0 || size.contains(&0) {
        return Err(Failure::new("would hold no pixel"));
    }
    let mut own = LayerAttributes { layer_position: Vec2(left, top), ..Default::default() };
    for (key, value) in metadata {
        let words = AttributeValue::Text(Text::from_slice_unchecked(value.as_bytes()));
        own.other.insert(Text::from_slice_unchecked(key.as_bytes()), words);
    }
    let channels = AnyChannels::sort(channels.into());
    let encoding = Encoding::SMALL_LOSSLESS;
    let layer = Layer::new(Vec2(size[0], size[1]), own, encoding, channels);
    let display = IntegerBounds::new((0, 0), (layers.film[0], layers.film[1]));
    let image = Image { attributes: ImageAttributes::new(display), layer_data: layer };
    whole::write(path, |file| image.write().to_buffered(file).map_err(unwritten))
}

/// Reads what [`write`] wrote, and what others write likewise: one part with channels R, G, B.
pub fn read(path: &Path) -> Result<(Layers, Metadata), Failure> {
    let (file, length) = regular::open(path, LIMIT)?;
    parse(BufReader::new(file), length)
}

/// The same from the beginning of what has so many bytes.
pub(super) fn parse(
    mut file: impl BufRead + Seek + Send,
    length: u64,
) -> Result<(Layers, Metadata), Failure> {
    check_size(&mut file, length)?;
    let image = ::exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(file)
        .map_err(unread)?;
    let display = image.attributes.display_window;
    let layer = image.layer_data;
    let metadata = words(&layer.attributes);
    let origin = layer.attributes.layer_position - display.position;
    let origin = [origin.x(), origin.y()].map(usize::try_from);
    let [Ok(left), Ok(top)] = origin else {
        return Err(Failure::new("holds pixels outside of its film"));
    };
    let (width, height) = (layer.size.x(), layer.size.y());
    let mut pictures = pictures(&layer.channel_data, width, height);
    let main = pictures.iter().position(|(name, _)| name.is_empty());
    let main = main.ok_or_else(|| Failure::new("has no channels called R, G and B"))?;
    let (_, main) = pictures.remove(main);
    let film = [display.size.x(), display.size.y()];
    let scalars = scalars(&layer.channel_data);
    Ok((Layers { film, origin: [left, top], main, named: pictures, scalars }, metadata))
}

/// The channels of a picture, named with a prefix.
fn channels(prefix: &str, picture: &Picture) -> Result<Vec<AnyChannel<FlatSamples>>, Failure> {
    if let Some(i) = picture.pixels.iter().position(|pixel| !pixel.is_finite()) {
        let (x, y) = (i % picture.width, i / picture.width);
        return Err(Failure::new(format!(
            "cannot hold pixel ({x}, {y}), which is no finite number"
        )));
    }
    let channel = |letter: &str, value: fn(&Rgb) -> f32| {
        let name = format!("{prefix}{letter}");
        let samples = FlatSamples::F32(picture.pixels.iter().map(value).collect());
        AnyChannel::new(Text::from_slice_unchecked(name.as_bytes()), samples)
    };
    Ok(vec![channel("R", |p| p.r), channel("G", |p| p.g), channel("B", |p| p.b)])
}

/// The pictures in channels that come in threes, by name.
fn pictures(
    channels: &AnyChannels<FlatSamples>,
    width: usize,
    height: usize,
) -> Vec<(String, Picture)> {
    let find = |name: &str| {
        let found = channels.list.iter().find(|c| c.name.as_slice() == name.as_bytes())?;
        (found.sampling == Vec2(1, 1)).then_some(&found.sample_data)
    };
    let mut pictures = Vec::new();
    for channel in &channels.list {
        let name = String::from_utf8_lossy(channel.name.as_slice()).into_owned();
        let Some(prefix) = name.strip_suffix('R').filter(|p| p.is_empty() || p.ends_with('.'))
        else {
            continue;
        };
        let others = (find(&name), find(&format!("{prefix}G")), find(&format!("{prefix}B")));
        let (Some(r), Some(g), Some(b)) = others else { continue };
        let pixels = r.values_as_f32().zip(g.values_as_f32()).zip(b.values_as_f32());
        let pixels = pixels.map(|((r, g), b)| Rgb::new(r, g, b)).collect();
        let name = prefix.trim_end_matches('.').to_string();
        pictures.push((name, Picture { width, height, pixels }));
    }
    pictures
}

/// The values of channels called `name.Y`, by name.
fn scalars(channels: &AnyChannels<FlatSamples>) -> Vec<(String, Vec<f32>)> {
    let whole = channels.list.iter().filter(|channel| channel.sampling == Vec2(1, 1));
    whole
        .filter_map(|channel| {
            let name = String::from_utf8_lossy(channel.name.as_slice()).into_owned();
            let name = name.strip_suffix(".Y")?.to_string();
            Some((name, channel.sample_data.values_as_f32().collect()))
        })
        .collect()
}

/// The text attributes, sorted by key.
fn words(attributes: &LayerAttributes) -> Metadata {
    let text = |text: &Text| String::from_utf8_lossy(text.as_slice()).into_owned();
    let mut words: Metadata = attributes
        .other
        .iter()
        .filter_map(|(key, value)| match value {
            AttributeValue::Text(value) => Some((text(key), text(value))),
            _ => None,
        })
        .collect();
    words.sort();
    words
}

/// Refuses a header that claims more pixels than its file can hold, before they are allocated.
fn check_size(file: &mut (impl BufRead + Seek), length: u64) -> Result<(), Failure> {
    let meta = ::exr::meta::MetaData::read_from_buffered(&mut *file, false).map_err(unread)?;
    file.rewind()?;
    for header in &meta.headers {
        let mut bytes = 0_u64;
        for channel in &header.channels.list {
            let pixels = (header.layer_size.x() as u64).checked_mul(header.layer_size.y() as u64);
            let sample = channel.sample_type.bytes_per_sample() as u64;
            let more = pixels.and_then(|pixels| pixels.checked_mul(sample));
            bytes = bytes.saturating_add(more.unwrap_or(u64::MAX));
        }
        if bytes / STRONGEST_COMPRESSION > length {
            return Err(Failure::new("claims more pixels than a file of its length can hold"));
        }
    }
    Ok(())
}

/// Columns and rows as the format counts them.
fn window(sides: [usize; 2]) -> Result<[i32; 2], Failure> {
    let fits = |side: usize| i32::try_from(side).ok().filter(|side| *side < i32::MAX / 2);
    match sides.map(fits) {
        [Some(x), Some(y)] => Ok([x, y]),
        _ => Err(Failure::new("is too wide or too high for an EXR")),
    }
}

fn unwritten(error: ::exr::error::Error) -> Failure {
    match error {
        ::exr::error::Error::Io(error) => error.into(),
        error => Failure::new(format!("cannot be written as EXR: {error}")),
    }
}

fn unread(error: ::exr::error::Error) -> Failure {
    match error {
        ::exr::error::Error::Io(error) => error.into(),
        error => Failure::new(format!("is no whole EXR: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp(width: usize, height: usize, offset: f32) -> Picture {
        let pixel = |i: usize| Rgb::new(i as f32 + offset, -(i as f32), 1e-30 * i as f32);
        Picture { width, height, pixels: (0..width * height).map(pixel).collect() }
    }

    #[test]
    fn pictures_crops_layers_and_words_come_back_as_they_went() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.exr");
        // Brighter than half floats can hold: a sun, and all that there is.
        let mut main = ramp(37, 41, 0.1);
        main.pixels[7] = Rgb::new(1e9, 65_505.0, f32::MAX);
        let layers = Layers {
            film: [100, 60],
            origin: [30, 7],
            main,
            named: vec![("albedo".into(), ramp(37, 41, 0.2)), ("normal".into(), ramp(37, 41, 3.0))],
            scalars: vec![("samples".into(), (0..37 * 41).map(|i| i as f32).collect())],
        };
        let metadata: Metadata = vec![
            (
                "scn:caption".into(),
                "Figur 5: ærlig\nlys, 光, and more than twenty-four bytes".into(),
            ),
            ("scn:empty".into(), String::new()),
            ("scn:seed".into(), "0".into()),
        ];
        write(&path, &layers, &metadata).unwrap();
        assert_eq!(read(&path).unwrap(), (layers, metadata));
    }

    #[test]
    fn a_nan_is_refused_and_the_old_file_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.exr");
        let good = Layers::new(ramp(3, 2, 0.0));
        write(&path, &good, &Metadata::new()).unwrap();
        let mut bad = good.clone();
        bad.main.pixels[4].b = f32::NAN;
        let failure = write(&path, &bad, &Metadata::new()).unwrap_err().to_string();
        assert_eq!(failure, "cannot hold pixel (1, 1), which is no finite number");
        assert_eq!(read(&path).unwrap().0, good);
    }

    #[test]
    fn truncated_and_forged_files_are_told_not_trusted() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.exr");
        write(&path, &Layers::new(ramp(20, 30, 0.5)), &Metadata::new()).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        for end in (0..bytes.len()).step_by(7) {
            std::fs::write(&path, &bytes[..end]).unwrap();
            read(&path).unwrap_err();
        }
        // Every byte of the header turned over: an answer either way, never a panic.
        for at in 0..400.min(bytes.len()) {
            let mut forged = bytes.clone();
            forged[at] ^= 0x7f;
            std::fs::write(&path, &forged).unwrap();
            let _ = read(&path);
        }
        let at = bytes.windows(10).position(|w| w == b"dataWindow").unwrap() + 10 + 1 + 6 + 4;
        let mut huge = bytes.clone();
        huge[at + 8..at + 16].copy_from_slice(&[0xff, 0xff, 0xff, 0x0f, 0xff, 0xff, 0xff, 0x0f]);
        std::fs::write(&path, &huge).unwrap();
        let failure = read(&path).unwrap_err().to_string();
        assert_eq!(failure, "claims more pixels than a file of its length can hold");
    }
}
