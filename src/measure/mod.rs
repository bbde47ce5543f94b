//! Images and estimates judged: error metrics, variance, confidence, statistical tests.
//!
//! Knows numbers and pictures, not where they come from. Everything is public: the test suite
//! decides with it whether a renderer is right.

pub mod statistics;
