//! A render as a sequence of passes: World and a stop rule → picture.
