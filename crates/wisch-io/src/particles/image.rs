//! Particles from a mask or photo, registered to the surface by its four corners.

use super::ParticleSourceError;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use png::BitDepth;
use rand::RngExt;
use std::io::Cursor;
use wisch::geometry::{Bounds2, Point2, Vector2};
use wisch::represent::{
    DirtArea, Observation, ParticleDistribution, SourceError, particle_generator,
};
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::{bytestream::ZCursor, options::DecoderOptions};

/// Maximum number of pixels of an image: a large photo, which takes 200 MB when decoded.
const MAX_PIXELS: u64 = 64_000_000;
/// Memory that decoding may take: MAX_PIXELS at 16 bits in four channels [bytes].
const MAX_DECODER_MEMORY: usize = MAX_PIXELS as usize * 8;
const PNG_MAGIC: [u8; 8] = *b"\x89PNG\r\n\x1a\n";
const JPEG_MAGIC: [u8; 3] = [0xff, 0xd8, 0xff];
/// Number of draws within a pixel on the border before its centre is taken.
const DRAWS_PER_PIXEL: usize = 64;
/// Minimum sine of a corner's angle; smaller corners count as collinear [1].
const MIN_CORNER_SINE: f64 = 1e-3;

/// Dirt as the pixels of an image near a colour.
#[derive(Debug, Clone, PartialEq)]
pub struct MaskSource {
    /// Path of a PNG or JPEG, relative to the task file.
    pub file: String,
    /// Pixels of the corners of the surface's bounding box, at (min x, min y), (max x, min y), (max x, max y),
    /// (min x, max y) [pixels, x right, y down, (0, 0) = outer corner of the first pixel].
    pub corners_px: [Point2; 4],
    /// Colour of the dirt: red, green, blue.
    pub color: [u8; 3],
    /// Maximum Euclidean distance from that colour in RGB [0..442].
    pub tolerance: f64,
    /// Number of particles to draw.
    pub count: usize,
}

/// Draws particles uniformly from the pixels near the mask's colour, on the free surface.
///
/// `bytes`: PNG or JPEG. The position of a particle within its pixel is random.
///
/// # Errors
/// If the bytes are not a valid image or exceed 64 megapixels; if corners are outside the image, collinear or in the wrong
/// order; if no pixel on the free surface has the colour; or if the count is outside its limits.
pub fn mask_particles(
    source: &MaskSource,
    bytes: &[u8],
    area: DirtArea<'_>,
    seed: u64,
) -> Result<ParticleDistribution, ParticleSourceError> {
    SourceError::check_count(source.count)?;
    let mask = Mask::read(source, &source.file, bytes, area)?;
    if mask.pixels.is_empty() {
        let ([r, g, b], tolerance) = (source.color, source.tolerance);
        return Err(ParticleSourceError::Image {
            file: source.file.clone(),
            problem: format!(
                "no pixel on the free surface is within {tolerance} of the colour [{r}, {g}, {b}]; check color and corners_px, or raise tolerance"
            ),
        });
    }
    Ok(ParticleDistribution::new(&mask.draw(
        source.count,
        area,
        seed,
    ))?)
}

/// Makes an observation from a later image of the same camera. The number of detections is the number of the task's
/// particles times the ratio of dirt pixels in this image to those in the task's own image `before`.
///
/// # Errors
/// Those of [`mask_particles`], except that an image without dirt is valid.
pub fn read_observed_image(
    source: &MaskSource,
    before: &[u8],
    file: &str,
    bytes: &[u8],
    area: DirtArea<'_>,
    seed: u64,
) -> Result<Observation, ParticleSourceError> {
    SourceError::check_count(source.count)?;
    let first = Mask::read(source, &source.file, before, area)?;
    let later = Mask::read(source, file, bytes, area)?;
    let share = later.pixels.len() as f64 / first.pixels.len().max(1) as f64;
    let count = (share * source.count as f64).round() as usize;
    SourceError::check_count(count.max(1))?;
    Ok(Observation {
        detections: later.draw(count, area, seed),
        ..Observation::default()
    })
}

/// The dirt pixels on the free surface.
struct Mask {
    surface_from_pixel: Matrix3<f64>,
    pixels: Vec<(u32, u32)>,
}

impl Mask {
    fn read(
        source: &MaskSource,
        file: &str,
        bytes: &[u8],
        area: DirtArea<'_>,
    ) -> Result<Self, ParticleSourceError> {
        let fault = |problem: String| ParticleSourceError::Image {
            file: file.to_owned(),
            problem,
        };
        let photo = Photo::read(bytes).map_err(fault)?;
        let (width, height) = (photo.width, photo.height);
        let surface_from_pixel = source.homography(area, width, height).map_err(fault)?;
        let pixels = (0..height)
            .flat_map(|row| (0..width).map(move |column| (column, row)))
            .zip(&photo.colors)
            .filter(|&(_, &color)| source.matches(color))
            .map(|(pixel, _)| pixel)
            .filter(|&(column, row)| {
                let middle = Point2::new(f64::from(column) + 0.5, f64::from(row) + 0.5);
                mapped(&surface_from_pixel, middle).is_some_and(|point| area.contains(point))
            })
            .collect();
        Ok(Self {
            surface_from_pixel,
            pixels,
        })
    }

    /// Draws positions uniformly from the pixels, at random within each pixel; empty without pixels.
    fn draw(&self, count: usize, area: DirtArea<'_>, seed: u64) -> Vec<Point2> {
        if self.pixels.is_empty() {
            return Vec::new();
        }
        let mut random = particle_generator(seed);
        let place = |pixel: Point2| mapped(&self.surface_from_pixel, pixel);
        (0..count)
            .map(|_| {
                let (column, row) = self.pixels[random.random_range(0..self.pixels.len())];
                let corner = Point2::new(f64::from(column), f64::from(row));
                (0..DRAWS_PER_PIXEL)
                    .find_map(|_| {
                        let within = Vector2::new(random.random(), random.random());
                        place(corner + within).filter(|&p| area.contains(p))
                    })
                    .or_else(|| place(corner + Vector2::new(0.5, 0.5)))
                    .unwrap_or_else(Point2::origin)
            })
            .collect()
    }
}

impl MaskSource {
    fn matches(&self, color: [u8; 3]) -> bool {
        let squared: f64 = (color.iter().zip(self.color))
            .map(|(&a, b)| (f64::from(a) - f64::from(b)).powi(2))
            .sum();
        squared <= self.tolerance * self.tolerance
    }

    /// Computes the projective map (homography) from the four corners in the image to those of the outline's bounds.
    fn homography(
        &self,
        area: DirtArea<'_>,
        width: u32,
        height: u32,
    ) -> Result<Matrix3<f64>, String> {
        for (corner, p) in self.corners_px.iter().enumerate() {
            let (width, height) = (f64::from(width), f64::from(height));
            if !((0.0..=width).contains(&p.x) && (0.0..=height).contains(&p.y)) {
                return Err(format!(
                    "corners_px[{corner}] = [{}, {}] is outside the image of {width} x {height} pixels",
                    p.x, p.y
                ));
            }
        }
        for corner in 0..4 {
            let [before, here, after] = [3, 4, 5].map(|step| self.corners_px[(corner + step) % 4]);
            let (one, other) = (here - before, after - here);
            let turn = one.perp(&other);
            if turn.abs() <= MIN_CORNER_SINE * one.norm() * other.norm() {
                return Err(format!(
                    "corners_px[{corner}] is collinear with its neighbours"
                ));
            }
            // y points down in an image, so counter-clockwise on the surface is clockwise in the image.
            if turn > 0.0 {
                return Err(
                    "corners_px are not counter-clockwise around the surface in the image: \
                     give the corners at (min x, min y), (max x, min y), (max x, max y), (min x, max y)"
                        .to_owned(),
                );
            }
        }
        let bounds = Bounds2::from_points(area.outline.outer().iter().copied())
            .ok_or_else(|| "the surface has no outline".to_owned())?;
        let (min, max) = (bounds.min, bounds.max);
        let corners = [
            min,
            Point2::new(max.x, min.y),
            max,
            Point2::new(min.x, max.y),
        ];
        // Eight linear equations for h0..h7 with h8 = 1, the weight at the origin, which must not be on the horizon.
        // Coordinates are relative to the corners' mean and scaled by the image size, for good conditioning.
        let scale = 1.0 / f64::from(width.max(height));
        let middle = self.corners_px.iter().map(|p| p.coords).sum::<Vector2>() / 4.0;
        let mut rows = SMatrix::<f64, 8, 8>::zeros();
        let mut right = SVector::<f64, 8>::zeros();
        for (i, (pixel, point)) in self.corners_px.iter().zip(corners).enumerate() {
            let [u, v] = ((pixel.coords - middle) * scale).into();
            let x = [u, v, 1.0, 0.0, 0.0, 0.0, -point.x * u, -point.x * v];
            let y = [0.0, 0.0, 0.0, u, v, 1.0, -point.y * u, -point.y * v];
            rows.row_mut(2 * i).copy_from_slice(&x);
            rows.row_mut(2 * i + 1).copy_from_slice(&y);
            right[2 * i] = point.x;
            right[2 * i + 1] = point.y;
        }
        let h = rows
            .lu()
            .solve(&right)
            .ok_or_else(|| "corners_px are not the corners of a quadrilateral".to_owned())?;
        let from_scaled = Matrix3::new(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1.0);
        let mut scaled_from_pixel = Matrix3::from_diagonal(&Vector3::new(scale, scale, 1.0));
        scaled_from_pixel.set_column(2, &(-middle * scale).push(1.0));
        Ok(from_scaled * scaled_from_pixel)
    }
}

/// Returns the point of the surface at a position in the image; `None` on or beyond the horizon.
fn mapped(surface_from_pixel: &Matrix3<f64>, pixel: Point2) -> Option<Point2> {
    let p = surface_from_pixel * pixel.to_homogeneous();
    (p.z > 1e-9).then(|| Point2::new(p.x / p.z, p.y / p.z))
}

/// An image: colours by rows from the upper left corner.
struct Photo {
    width: u32,
    height: u32,
    colors: Vec<[u8; 3]>,
}

impl Photo {
    fn read(bytes: &[u8]) -> Result<Self, String> {
        let refused = |error: String| format!("not a readable PNG or JPEG: {error}");
        if bytes.starts_with(&PNG_MAGIC) {
            let mut reader = png_reader(bytes).map_err(|error| refused(error.to_string()))?;
            let (width, height) = reader.info().size();
            check_pixels(width, height)?;
            let (kind, depth) = reader.output_color_type();
            let mut samples = vec![0; reader.output_buffer_size().unwrap_or_default()];
            let read = reader.next_frame(&mut samples);
            read.map_err(|error| refused(error.to_string()))?;
            if depth == BitDepth::Sixteen {
                // 0 to 65535 = 257 * 255 becomes 0 to 255, rounded.
                let nearest = |&pair| (u32::from(u16::from_be_bytes(pair)) + 128) / 257;
                let pairs = samples.as_chunks().0.iter();
                samples = pairs.map(|pair| nearest(pair) as u8).collect();
            }
            Ok(Self::of(width, height, &samples, kind.samples()))
        } else if bytes.starts_with(&JPEG_MAGIC) {
            let mut decoder = jpeg_decoder(bytes);
            let headers = decoder.decode_headers();
            headers.map_err(|error| refused(error.to_string()))?;
            let (width, height) = decoder.dimensions().unwrap_or_default();
            let (width, height) = (width as u32, height as u32);
            check_pixels(width, height)?;
            let samples = decoder.decode();
            let samples = samples.map_err(|error| refused(error.to_string()))?;
            Ok(Self::of(width, height, &samples, 3))
        } else {
            Err(refused("its first bytes match neither format".to_owned()))
        }
    }

    /// Converts samples to colours. Samples per pixel: grey or red, green and blue, with or without alpha.
    fn of(width: u32, height: u32, samples: &[u8], per_pixel: usize) -> Self {
        let color = |pixel: &[u8]| match *pixel {
            [r, g, b] | [r, g, b, _] => [r, g, b],
            _ => [pixel[0]; 3],
        };
        Self {
            width,
            height,
            colors: samples.chunks_exact(per_pixel).map(color).collect(),
        }
    }
}

fn png_reader(bytes: &[u8]) -> Result<png::Reader<Cursor<&[u8]>>, png::DecodingError> {
    let limits = png::Limits {
        bytes: MAX_DECODER_MEMORY,
    };
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
    // Palettes to colours, and less than eight bits to eight.
    decoder.set_transformations(png::Transformations::EXPAND);
    decoder.read_info()
}

/// Gives red, green and blue. The sides are limited by the product of theirs alone.
fn jpeg_decoder(bytes: &[u8]) -> JpegDecoder<ZCursor<&[u8]>> {
    let options = DecoderOptions::default()
        .set_max_width(usize::MAX)
        .set_max_height(usize::MAX)
        .set_strict_mode(false);
    JpegDecoder::new_with_options(ZCursor::new(bytes), options)
}

fn check_pixels(width: u32, height: u32) -> Result<(), String> {
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(format!(
            "{width} x {height} pixels exceed the limit of {MAX_PIXELS}"
        ));
    }
    Ok(())
}
