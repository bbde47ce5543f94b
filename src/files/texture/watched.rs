//! The bytes of a file as a decoder takes them: told how far it is, and ended when nobody wants it.

use std::io::{self, BufRead, Cursor, Read, Seek, SeekFrom};

use crate::math::Progress;

/// Bytes a decoder is given at once. Of a picture of one colour they make some million texels.
const PIECE: usize = 4096;

/// Bytes that are watched while they are taken.
pub(super) struct Watched<'a> {
    bytes: Cursor<&'a [u8]>,
    progress: &'a dyn Progress,
}

impl<'a> Watched<'a> {
    pub fn new(bytes: &'a [u8], progress: &'a dyn Progress) -> Self {
        Self { bytes: Cursor::new(bytes), progress }
    }
}

impl BufRead for Watched<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.progress.cancelled() {
            return Err(stopped());
        }
        self.progress.advance(self.bytes.position(), self.bytes.get_ref().len() as u64);
        let rest = self.bytes.fill_buf()?;
        Ok(&rest[..rest.len().min(PIECE)])
    }

    fn consume(&mut self, amount: usize) {
        self.bytes.consume(amount);
    }
}

impl Read for Watched<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

impl Seek for Watched<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.bytes.seek(to)
    }
}

/// Why there is no more.
pub(super) fn stopped() -> io::Error {
    io::Error::other("reading was stopped")
}
