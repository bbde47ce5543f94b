//! Stage → World: the last place that can fail. The only room that knows scene and render.
