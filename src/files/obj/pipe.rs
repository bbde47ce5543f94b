//! The scan and tobj side by side: one thread checks statements while another reads the clean ones.

use std::io::{self, BufRead, Read};
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread;

use super::scan::{Found, Scan};

/// Pieces of clean text that may wait to be read.
const WAITING: usize = 16;

/// Clean text as it comes from the scan.
pub(super) struct Pieces {
    from: Receiver<Vec<u8>>,
    piece: Vec<u8>,
    taken: usize,
}

/// What a reader makes of the clean text, and what the scan found. Err: the system gives no thread.
pub(super) fn side_by_side<T>(
    mut scan: Scan,
    read: impl FnOnce(&mut Pieces) -> T,
) -> io::Result<(T, Found)> {
    let (to, from) = sync_channel(WAITING);
    thread::scope(|scope| {
        let scanning = thread::Builder::new().spawn_scoped(scope, move || {
            // A reader that has given up leaves the rest to the scan alone.
            while let Some(piece) = scan.next_piece()
                && to.send(piece).is_ok()
            {}
            drop(to);
            scan.finish()
        })?;
        let made = read(&mut Pieces { from, piece: Vec::new(), taken: 0 });
        let found = scanning.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        Ok((made, found))
    })
}

impl BufRead for Pieces {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        while self.taken == self.piece.len() {
            let Ok(next) = self.from.recv() else { break };
            (self.piece, self.taken) = (next, 0);
        }
        Ok(&self.piece[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken += amount;
    }
}

impl Read for Pieces {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}
