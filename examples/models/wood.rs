//! Floor boards of oak as a picture that tiles, painted by noise on a grid. Only whole
//! numbers and the four operations are used, so that every machine paints the same.

/// The side of the picture in pixels.
const SIDE: u32 = 512;
/// Rows of boards, a board a row: they run along x.
const ROWS: u32 = 4;
/// Shades between the darkest and the lightest: few, so that the file is small.
const SHADES: f64 = 80.0;
/// sRGB of the darkest and the lightest fibre.
const DARK: [f64; 3] = [74.0, 42.0, 22.0];
const LIGHT: [f64; 3] = [214.0, 164.0, 106.0];
/// Half the width of the gap between boards, in pixels.
const GAP: f64 = 1.2;

/// The pixels, row by row from the top, three bytes each.
pub fn pixels() -> Vec<u8> {
    let all = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    all.flat_map(|(x, y)| colour(f64::from(x) + 0.5, f64::from(y) + 0.5)).collect()
}

/// The picture as a PNG.
pub fn png() -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, SIDE, SIDE);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels())?;
    writer.finish()?;
    Ok(bytes)
}

fn colour(x: f64, y: f64) -> [u8; 3] {
    let height = f64::from(SIDE / ROWS);
    let row = (y / height) as u32;
    let across = y - f64::from(row) * height;
    // Each board ends somewhere else.
    let end = random(row, 0, 1) * f64::from(SIDE);
    let along = (x - end + f64::from(SIDE)) % f64::from(SIDE);
    let from_edge = across.min(height - across).min(along.min(f64::from(SIDE) - along));

    // Years of growth: bands along the board, bent by slow noise.
    let bend = noise(x, y, [4, 8], 10 + row) * 5.0 + noise(x, y, [8, 16], 20 + row) * 1.2;
    let years = across / height * 5.0 + bend;
    let year = years - years.floor();
    // Light early wood darkens slowly, and ends at once.
    let band = if year < 0.85 { year / 0.85 } else { (1.0 - year) / 0.15 };
    let fibres = noise(x, y, [16, 256], 30) * 0.6 + noise(x, y, [64, 512], 31) * 0.4;
    let board = random(row, 0, 2);
    let shade = 0.42 + 0.36 * board - 0.32 * band * band + 0.3 * (fibres - 0.5);
    let gap = (from_edge / GAP - 0.5).clamp(0.0, 1.0);
    let shade = (shade * (0.25 + 0.75 * gap)).clamp(0.0, 1.0);
    let shade = (shade * SHADES).round() / SHADES;
    [0, 1, 2].map(|i| (DARK[i] + (LIGHT[i] - DARK[i]) * shade).round() as u8)
}

/// Smooth noise from 0 to 1, with so many cells along x and y; it tiles.
fn noise(x: f64, y: f64, cells: [u32; 2], seed: u32) -> f64 {
    let side = f64::from(SIDE);
    let (u, v) = (x / side * f64::from(cells[0]), y / side * f64::from(cells[1]));
    let (i, j) = (u as u32, v as u32);
    let smooth = |t: f64| t * t * (3.0 - 2.0 * t);
    let (s, t) = (smooth(u - f64::from(i)), smooth(v - f64::from(j)));
    let at = |di: u32, dj: u32| random((i + di) % cells[0], (j + dj) % cells[1], seed);
    let low = at(0, 0) + (at(1, 0) - at(0, 0)) * s;
    let high = at(0, 1) + (at(1, 1) - at(0, 1)) * s;
    low + (high - low) * t
}

/// A number from 0 to 1 that follows from three others: rounds of multiplying and shifting.
fn random(x: u32, y: u32, seed: u32) -> f64 {
    let mut bits = x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77) ^ seed << 17;
    for factor in [0x7feb_352d, 0x846c_a68b, 0x9e37_79b1] {
        bits = (bits ^ bits >> 16).wrapping_mul(factor);
    }
    f64::from(bits ^ bits >> 15) / f64::from(u32::MAX)
}
