//! Recordings of stored episodes, sent in chunks: none is held in memory as a whole.

use crate::library::Library;
use crate::refusal::Refusal;
use axum::body::{Body, Bytes};
use flate2::read::GzDecoder;
use futures_util::stream;
use std::fs::File;
use std::io::{self, Read};
use std::sync::Arc;
use wisch_memory::RECORDING_FILE;

/// Largest size of a chunk [bytes].
const PIECE: usize = 1 << 16;

/// Opens the recording of an episode after verifying it against its check sum. It is compressed by gzip.
///
/// # Errors
/// If the episode does not exist, has no recording, or its recording differs from what was written.
pub async fn open_recording(library: Arc<Library>, id: String) -> Result<File, Refusal> {
    let opened = tokio::task::spawn_blocking(move || -> Result<File, Refusal> {
        let episode = library.memory().episode(&id)?;
        if !episode.folder().join(RECORDING_FILE).is_file() {
            return Err(Refusal::unknown(format!(
                "episode {id} has no recording: it was stored by an earlier version, imported, or run without a recording"
            )));
        }
        Ok(episode.open_checked(RECORDING_FILE)?)
    });
    opened.await?
}

/// Returns a body with the contents of a file.
pub fn body_of_file(file: File) -> Body {
    body_of(Ok(Bytes::new()), file)
}

/// Returns a body with the decompressed contents of a gzip file.
///
/// # Errors
/// If the file's first chunk cannot be decompressed. If a later one fails, the answer breaks off.
pub async fn body_of_unpacked(file: File) -> io::Result<Body> {
    let (first, unpacked) = read_on(GzDecoder::new(file)).await?;
    Ok(body_of(Ok(first), unpacked))
}

/// Returns a body with a first chunk and the reader's remaining contents, read as fast as the client takes them.
fn body_of(first: io::Result<Bytes>, reader: impl Read + Send + 'static) -> Body {
    let rest = stream::try_unfold(reader, |reader| async move {
        let (piece, reader) = read_on(reader).await?;
        Ok::<_, io::Error>((!piece.is_empty()).then_some((piece, reader)))
    });
    let all = futures_util::StreamExt::chain(stream::iter([first]), rest);
    Body::from_stream(all)
}

/// Reads the next chunk; empty at the end.
async fn read_on<R: Read + Send + 'static>(mut reader: R) -> io::Result<(Bytes, R)> {
    let read = tokio::task::spawn_blocking(move || {
        let mut piece = vec![0; PIECE];
        let len = reader.read(&mut piece)?;
        piece.truncate(len);
        Ok((Bytes::from(piece), reader))
    });
    read.await.map_err(io::Error::other)?
}
