//! Memory in large pages, where the system has them: a ray jumps about in the tree, and each page of
//! the usual size that it comes to must be looked up.

/// Less than this is not worth a large page, in bytes.
const WORTH: usize = 4 << 20;

/// An empty vector with room for so many, in large pages if they are many.
pub(super) fn roomy<T>(count: usize) -> Vec<T> {
    let room = Vec::with_capacity(count);
    if count * size_of::<T>() >= WORTH {
        advise(&room);
    }
    room
}

/// A hint alone: whatever becomes of it, the memory is the same.
#[cfg(target_os = "linux")]
fn advise<T>(room: &Vec<T>) {
    use rustix::mm::{Advice, madvise};
    /// The largest that the usual pages are.
    const PAGE: usize = 1 << 16;
    let start = room.as_ptr().cast::<u8>();
    let before = start.align_offset(PAGE);
    let whole = (room.capacity() * size_of::<T>()).saturating_sub(before) / PAGE * PAGE;
    if whole > 0 {
        // SAFETY: these pages are the vector's own, and this advice changes nothing in them.
        let _ = unsafe { madvise(start.add(before) as *mut _, whole, Advice::LinuxHugepage) };
    }
}

#[cfg(not(target_os = "linux"))]
fn advise<T>(_: &Vec<T>) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_room_for_all() {
        for count in [0, 1, WORTH, 3 * WORTH + 5] {
            let mut room = roomy::<u16>(count);
            assert!(room.is_empty() && room.capacity() >= count);
            room.resize(count, 7);
            assert!(room.iter().all(|n| *n == 7));
        }
    }
}
