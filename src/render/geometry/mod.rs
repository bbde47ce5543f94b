//! What a ray can meet.
