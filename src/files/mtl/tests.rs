//! Texts of .mtl files, good and bad.
