//! Stage → what bounds what: objects where they stand, in metres and f64, and the media on both
//! sides of their surfaces.
//!
//! All surfaces that name a medium bound it together, whichever objects they belong to. In order:
//! their corners are counted once a place (surfaces), edges tell whether they close and which hang
//! together (seams), what is nearly closed is joined (closing); the closed surfaces are solids, and
//! how often each goes round a point tells what is where (solids, layers for planes). Surfaces of
//! bodies must not cross (crossing), and where one ends at another they are parted
//! (flush), nor be too thin (thin). What they say against it is told apart (contradicted).

mod asked;
mod charts;
mod closing;
mod contradicted;
mod crossing;
mod errors;
mod flat;
mod flush;
mod layers;
mod matter;
mod needless;
mod overlaps;
mod placed;
mod seams;
mod solids;
mod straddling;
mod surfaces;
mod thin;
mod tree;
mod triangles;
mod view;
mod yields;

pub use contradicted::{Contradicted, contradicted};
pub use errors::matter::place as place_in_words;
pub use flat::Flat;
pub use matter::Matter;
pub use needless::{Because, Needless, needless, unseen};
pub use overlaps::Overlaps;
pub use placed::{Body, Placed, place};
pub use seams::Sets;
pub use view::{extent, eye, is_on, together};
