//! A file that is hashed while it is written: a small one on the way, a large one by a thread beside.

use std::fs::File;
use std::io::{self, Write};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::JoinHandle;

use ifs_compiler::outputs::names::hex;
use sha2::{Digest, Sha256};

/// From this many bytes on a thread does the hashing.
const LARGE: u64 = 1 << 20;

/// How many pieces may wait for the thread.
const WAITING: usize = 16;

/// A file being written.
pub(super) struct HashedFile {
    file: File,
    bytes: u64,
    hasher: Hasher,
    stop: fn() -> bool,
}

enum Hasher {
    Here(Sha256),
    Beside(SyncSender<Vec<u8>>, JoinHandle<Sha256>),
}

impl HashedFile {
    /// A file that fails to be written as soon as `stop` says yes.
    pub(super) fn new(file: File, stop: fn() -> bool) -> HashedFile {
        HashedFile { file, bytes: 0, hasher: Hasher::Here(Sha256::new()), stop }
    }

    /// The file, its length, and the hash of what was written as lower-case hexadecimal.
    pub(super) fn finish(self) -> io::Result<(File, u64, String)> {
        let hasher = match self.hasher {
            Hasher::Here(hasher) => hasher,
            Hasher::Beside(pieces, thread) => {
                drop(pieces);
                thread.join().map_err(|_| not_hashed())?
            }
        };
        Ok((self.file, self.bytes, hex(&hasher.finalize())))
    }

    fn hash(&mut self, piece: &[u8]) -> io::Result<()> {
        match &mut self.hasher {
            Hasher::Here(hasher) => {
                hasher.update(piece);
                if self.bytes >= LARGE {
                    self.hasher = beside(std::mem::take(hasher));
                }
                Ok(())
            }
            Hasher::Beside(pieces, _) => pieces.send(piece.to_vec()).map_err(|_| not_hashed()),
        }
    }
}

fn not_hashed() -> io::Error {
    io::Error::other("its hash could not be made")
}

fn beside(mut hasher: Sha256) -> Hasher {
    let (pieces, received) = sync_channel::<Vec<u8>>(WAITING);
    let thread = std::thread::spawn(move || {
        received.into_iter().for_each(|piece| hasher.update(&piece));
        hasher
    });
    Hasher::Beside(pieces, thread)
}

impl Write for HashedFile {
    fn write(&mut self, buffer: &[u8]) -> io::Result<usize> {
        if (self.stop)() {
            return Err(io::Error::other("it was stopped"));
        }
        let count = self.file.write(buffer)?;
        self.bytes += count as u64;
        self.hash(&buffer[..count])?;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_all_bytes_of_small_and_of_large_files() {
        let path = std::env::temp_dir().join(format!("ifs-hashed-{}", std::process::id()));
        for size in [0, 1000, LARGE as usize, 3 * LARGE as usize + 17] {
            let bytes: Vec<u8> = (0..size).map(|place| (place * 31 % 251) as u8).collect();
            let mut file = HashedFile::new(File::create(&path).unwrap(), || false);
            for piece in bytes.chunks(70_000) {
                file.write_all(piece).unwrap();
            }
            let (_, length, hash) = file.finish().unwrap();
            assert_eq!((length, hash), (size as u64, hex(&Sha256::digest(&bytes))));
            assert_eq!(std::fs::read(&path).unwrap(), bytes);
        }
        std::fs::remove_file(&path).unwrap();
    }
}
