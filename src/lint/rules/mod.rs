//! The rules: one a file, with its tests; what each finds stands on its page, docs/errors/lint.

mod albedo_above_one;
mod camera_inside;
mod camera_on_surface;
mod camera_sees_nothing;
mod clear_metal;
mod coincident_surfaces;
mod colour_cut;
mod dark_light;
mod empty_layer;
mod empty_picture;
mod enclosed;
mod exposure;
mod hidden_by_plane;
mod ignored_field;
mod impossible_path;
mod index_below_one;
mod inward_lamp;
mod lamp_faces_away;
mod large_error;
mod light_behind_plane;
mod light_inside;
mod many_turns;
mod missing_caption;
mod mixed_scale;
mod names_by_case;
mod needless_yield;
mod noisy_filter;
mod non_manifold;
mod outside_contradicted;
mod rare_caustics;
mod same_around;
mod same_caption;
mod same_medium;
mod same_picture;
mod scale_after_move;
mod shallow_depth;
mod sky_on_its_side;
mod suspicious_unit;
mod thin_air;
mod twin_lights;
mod unfinished_round;
mod unreachable_error;
mod unseen_light;
mod unused_let;
mod unused_material;
mod unused_parameter;
mod unused_setup;
mod unused_texture;
mod unused_variable;

use super::{Look, Rule};
use crate::diag::Code;

/// Every rule, one a line, in the order of their codes.
pub(super) static RULES: &[Rule] = &[
    Rule { code: Code::LINT_ALBEDO_ABOVE_ONE, look: Look::Render(albedo_above_one::look) },
    Rule { code: Code::LINT_CAMERA_INSIDE, look: Look::Render(camera_inside::look) },
    Rule { code: Code::LINT_CAMERA_ON_SURFACE, look: Look::Render(camera_on_surface::look) },
    Rule { code: Code::LINT_CAMERA_SEES_NOTHING, look: Look::Render(camera_sees_nothing::look) },
    Rule { code: Code::LINT_CLEAR_METAL, look: Look::Render(clear_metal::look) },
    Rule { code: Code::LINT_COINCIDENT_SURFACES, look: Look::Render(coincident_surfaces::look) },
    Rule { code: Code::LINT_COLOUR_CUT, look: Look::Render(colour_cut::look) },
    Rule { code: Code::LINT_DARK_LIGHT, look: Look::All(dark_light::look) },
    Rule { code: Code::LINT_EMPTY_LAYER, look: Look::Together(empty_layer::look) },
    Rule { code: Code::LINT_EMPTY_PICTURE, look: Look::Together(empty_picture::look) },
    Rule { code: Code::LINT_ENCLOSED, look: Look::Render(enclosed::look) },
    Rule { code: Code::LINT_EXPOSURE, look: Look::Render(exposure::look) },
    Rule { code: Code::LINT_HIDDEN_BY_PLANE, look: Look::Render(hidden_by_plane::look) },
    Rule { code: Code::LINT_IGNORED_FIELD, look: Look::All(ignored_field::look) },
    Rule { code: Code::LINT_IMPOSSIBLE_PATH, look: Look::Render(impossible_path::look) },
    Rule { code: Code::LINT_INDEX_BELOW_ONE, look: Look::Render(index_below_one::look) },
    Rule { code: Code::LINT_INWARD_LAMP, look: Look::Render(inward_lamp::look) },
    Rule { code: Code::LINT_LAMP_FACES_AWAY, look: Look::Render(lamp_faces_away::look) },
    Rule { code: Code::LINT_LARGE_ERROR, look: Look::Render(large_error::look) },
    Rule { code: Code::LINT_LIGHT_BEHIND_PLANE, look: Look::Together(light_behind_plane::look) },
    Rule { code: Code::LINT_LIGHT_INSIDE, look: Look::Render(light_inside::look) },
    Rule { code: Code::LINT_MANY_TURNS, look: Look::Render(many_turns::look) },
    Rule { code: Code::LINT_MISSING_CAPTION, look: Look::All(missing_caption::look) },
    Rule { code: Code::LINT_MIXED_SCALE, look: Look::Render(mixed_scale::look) },
    Rule { code: Code::LINT_NAMES_BY_CASE, look: Look::Text(names_by_case::look) },
    Rule { code: Code::LINT_NEEDLESS_YIELD, look: Look::Render(needless_yield::look) },
    Rule { code: Code::LINT_NOISY_FILTER, look: Look::Render(noisy_filter::look) },
    Rule { code: Code::LINT_NON_MANIFOLD, look: Look::Render(non_manifold::look) },
    Rule { code: Code::LINT_OUTSIDE_CONTRADICTED, look: Look::Render(outside_contradicted::look) },
    Rule { code: Code::LINT_RARE_CAUSTICS, look: Look::Render(rare_caustics::look) },
    Rule { code: Code::LINT_SAME_AROUND, look: Look::Render(same_around::look) },
    Rule { code: Code::LINT_SAME_CAPTION, look: Look::Together(same_caption::look) },
    Rule { code: Code::LINT_SAME_MEDIUM, look: Look::Render(same_medium::look) },
    Rule { code: Code::LINT_SAME_PICTURE, look: Look::Together(same_picture::look) },
    Rule { code: Code::LINT_SCALE_AFTER_MOVE, look: Look::Render(scale_after_move::look) },
    Rule { code: Code::LINT_SHALLOW_DEPTH, look: Look::Render(shallow_depth::look) },
    Rule { code: Code::LINT_SKY_ON_ITS_SIDE, look: Look::Render(sky_on_its_side::look) },
    Rule { code: Code::LINT_SUSPICIOUS_UNIT, look: Look::Render(suspicious_unit::look) },
    Rule { code: Code::LINT_THIN_AIR, look: Look::Render(thin_air::look) },
    Rule { code: Code::LINT_TWIN_LIGHTS, look: Look::Render(twin_lights::look) },
    Rule { code: Code::LINT_UNFINISHED_ROUND, look: Look::Render(unfinished_round::look) },
    Rule { code: Code::LINT_UNREACHABLE_ERROR, look: Look::Render(unreachable_error::look) },
    Rule { code: Code::LINT_UNSEEN_LIGHT, look: Look::All(unseen_light::look) },
    Rule { code: Code::LINT_UNUSED_LET, look: Look::Text(unused_let::look) },
    Rule { code: Code::LINT_UNUSED_MATERIAL, look: Look::Text(unused_material::look) },
    Rule { code: Code::LINT_UNUSED_PARAMETER, look: Look::Text(unused_parameter::look) },
    Rule { code: Code::LINT_UNUSED_SETUP, look: Look::Text(unused_setup::look) },
    Rule { code: Code::LINT_UNUSED_TEXTURE, look: Look::Text(unused_texture::look) },
    Rule { code: Code::LINT_UNUSED_VARIABLE, look: Look::Text(unused_variable::look) },
];
