//! Scenes staged from files made for each test.
