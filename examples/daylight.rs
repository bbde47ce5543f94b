//! The sun of figures 7 to 10 by two models: the table in docs/worksheets.md.
//!
//! `cargo run --example daylight`

use scn::optics::daylight::{Air, Sun, bird_riordan, sun};

const LATITUDE: f64 = 55.77;
const DAY: f64 = 255.0;
const TURBIDITY: f64 = 2.4;
/// Of the grass, about: what Bird and Riordan's sky light depends on a little.
const ALBEDO: f64 = 0.2;

fn main() {
    let air = Air::of_turbidity(TURBIDITY);
    println!("hour  height  radiance (Preetham)         E (Preetham)          E (Bird, Riordan)");
    for hour in [7.0, 9.0, 11.0, 12.0, 13.0, 15.0, 17.0] {
        let place = Sun::at(LATITUDE.to_radians(), DAY, hour);
        let height = 90.0 - place.zenith.to_degrees();
        let radiance = sun::radiance(&air, place.zenith).map(|channel| channel / 1e6);
        let ours = sun::irradiance(&air, place.zenith);
        let theirs = bird_riordan::Irradiance::new(&air, ALBEDO, DAY, place.zenith);
        println!(
            "{hour:4}  {height:5.1}°  {:.3?} MW/m²/sr  {:.1?}  {:.1?} W/m²",
            radiance,
            ours,
            theirs.direct_channels()
        );
    }
}
