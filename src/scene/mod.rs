//! The contract between language and light: what an author said, as plain data.
//!
//! SI units, radians, linear colour, f64. Every word of the language is declared once, here, by
//! [`vocabulary!`](schema): the struct, what the checker knows, `scn list` and the reference all
//! come from that one entry. Nothing here knows syntax, disk or rendering.

mod at;
mod camera;
pub mod elsewhere;
pub mod examples;
mod film;
mod integrator;
mod layer;
mod light;
mod material;
mod medium;
mod object;
mod paths;
mod sampler;
pub mod schema;
pub mod spectral;
mod stop;
mod texture;
mod values;
mod vocabulary;
mod whole;

pub use at::At;
pub use camera::{Camera, Overview, Perspective};
pub use film::{BoxFilter, Film, Filter, Gaussian, Mitchell, Tent};
pub use integrator::{
    Ambient, AreaLights, Direct, Guide, Integrator, Path, Preview, Roulette, Splits,
};
pub use layer::{Layer, PathsLayer};
pub use light::{
    Constant, Directional, Light, NoSun, PointLight, Preetham, Shine, SpotLight, SunDirection,
    SunDisc, SunForm,
};
pub use material::{Conductor, Dielectric, Diffuse, Material, Mirror, Mix, Sides};
pub use medium::{HenyeyGreenstein, Homogeneous, Isotropic, MEASURED, Medium, Phase};
pub use object::{Disk, KaMeans, Mesh, Object, Plane, Quad, Sphere, Triangle};
pub use paths::{Only, Paths};
pub use sampler::{Independent, Sampler, Sobol, Stratified};
pub use stop::Stop;
pub use texture::{Checker, Encoding, Image, Texture, TextureFilter, Textured, Wrap};
pub use values::{
    Angle, Coefficient, Count, Depth, Direction, Exposure, FileName, Flux, Index, Intensity,
    Irradiance, Length, LightCount, NameOf, Number, Pair, Place, Point, Radiance, Ref, Reflectance,
    Size, Step, Switch, Text, Time,
};
pub use whole::{Items, KINDS, KindOf, NAMED_BY_FILES, Named, SEEN, Scene};
