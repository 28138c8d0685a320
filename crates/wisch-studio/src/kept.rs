//! Recordings that are kept in episodes, handed out piece by piece: none is held in memory as a whole.

use crate::library::Library;
use crate::refusal::Refusal;
use axum::body::{Body, Bytes};
use flate2::read::GzDecoder;
use futures_util::stream;
use std::fs::File;
use std::io::{self, Read};
use std::sync::Arc;
use wisch_memory::RECORDING_FILE;

/// Most bytes that are read at once.
const PIECE: usize = 1 << 16;

/// Opens the recording of an episode after holding it against its check sum. It is packed by gzip.
///
/// # Errors
/// If there is no such episode, it has no recording, or its recording is not what was written.
pub async fn open_recording(library: Arc<Library>, id: String) -> Result<File, Refusal> {
    let opened = tokio::task::spawn_blocking(move || -> Result<File, Refusal> {
        let episode = library.memory().episode(&id)?;
        if !episode.folder().join(RECORDING_FILE).is_file() {
            return Err(Refusal::unknown(format!(
                "episode {id} has no recording: it was kept by an earlier version, imported, or its run was not recorded"
            )));
        }
        Ok(episode.open_checked(RECORDING_FILE)?)
    });
    opened.await?
}

/// Returns the body of an answer that is a file as it is.
pub fn body_of_file(file: File) -> Body {
    body_of(Ok(Bytes::new()), file)
}

/// Returns the body of an answer that is the contents of a file that is packed by gzip.
///
/// # Errors
/// If the file's first piece cannot be unpacked. If a later one cannot, the answer breaks off.
pub async fn body_of_unpacked(file: File) -> io::Result<Body> {
    let (first, unpacked) = read_on(GzDecoder::new(file)).await?;
    Ok(body_of(Ok(first), unpacked))
}

/// Returns a body of what a reader gives after the first piece, read as fast as the client takes it.
fn body_of(first: io::Result<Bytes>, reader: impl Read + Send + 'static) -> Body {
    let rest = stream::try_unfold(reader, |reader| async move {
        let (piece, reader) = read_on(reader).await?;
        Ok::<_, io::Error>((!piece.is_empty()).then_some((piece, reader)))
    });
    let all = futures_util::StreamExt::chain(stream::iter([first]), rest);
    Body::from_stream(all)
}

/// Reads the next piece; it is empty at the end.
async fn read_on<R: Read + Send + 'static>(mut reader: R) -> io::Result<(Bytes, R)> {
    let read = tokio::task::spawn_blocking(move || {
        let mut piece = vec![0; PIECE];
        let len = reader.read(&mut piece)?;
        piece.truncate(len);
        Ok((Bytes::from(piece), reader))
    });
    read.await.map_err(io::Error::other)?
}
