//! Texts of .obj files, good and bad.
