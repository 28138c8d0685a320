//! Pictures as PNG, drawn with the embedded fonts.

use resvg::{tiny_skia, usvg};
use std::sync::Arc;
use thiserror::Error;

const REGULAR: &[u8] = include_bytes!("../../fonts/Inter-Regular.ttf");
const SEMI_BOLD: &[u8] = include_bytes!("../../fonts/Inter-SemiBold.ttf");
const FAMILY: &str = "Inter";

/// Maximum number of pixels along one side of a picture.
const MAX_SIDE: f32 = 16_384.0;

/// An error of rasterising a picture.
#[derive(Debug, Error)]
pub enum PictureError {
    /// The text is not SVG.
    #[error("the picture cannot be read: {0}")]
    Svg(#[from] usvg::Error),
    /// The picture would have no pixels, or too many.
    #[error(
        "a picture of {width} × {height} pixels cannot be drawn; each side must be 1 to {MAX_SIDE} pixels"
    )]
    Size {
        /// Pixels across.
        width: f32,
        /// Pixels down.
        height: f32,
    },
    /// The pixels could not be encoded.
    #[error("the picture cannot be encoded as PNG: {0}")]
    Png(String),
}

/// Draws an SVG as PNG, `scale` pixels per unit. No font of the system is used.
///
/// # Errors
/// If the text is not SVG, or a side is below 1 or above 16384 pixels.
pub fn rasterize(svg: &str, scale: f32) -> Result<Vec<u8>, PictureError> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(REGULAR.to_vec());
    fonts.load_font_data(SEMI_BOLD.to_vec());
    fonts.set_sans_serif_family(FAMILY);
    let options = usvg::Options {
        font_family: FAMILY.to_owned(),
        fontdb: Arc::new(fonts),
        ..usvg::Options::default()
    };
    let tree = usvg::Tree::from_str(svg, &options)?;
    let (width, height) = (
        (tree.size().width() * scale).round(),
        (tree.size().height() * scale).round(),
    );
    let drawable = |side: f32| (1.0..=MAX_SIDE).contains(&side);
    let mut pixels = (drawable(width) && drawable(height))
        .then(|| tiny_skia::Pixmap::new(width as u32, height as u32))
        .flatten()
        .ok_or(PictureError::Size { width, height })?;
    resvg::render(
        &tree,
        tiny_skia::Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    pixels
        .encode_png()
        .map_err(|error| PictureError::Png(error.to_string()))
}
