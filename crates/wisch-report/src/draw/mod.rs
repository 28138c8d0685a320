//! Shared parts of all pictures: views, panels, legends, colours and marks on a surface.

pub(crate) mod axes;
mod contour;
mod figure;
mod hull;
pub(crate) mod legend;
mod numbers;
mod palette;
mod panel;
#[cfg(any(test, feature = "png"))]
mod png;
pub(crate) mod surface;
mod view;

pub(crate) use contour::Contours;
pub(crate) use figure::Figure;
pub(crate) use hull::{hull, outline};
pub(crate) use legend::Entry;
pub(crate) use numbers::{
    count_decimals, find_range, find_tick_step, format_decimal, format_percent, group_thousands, px,
};
pub(crate) use palette::{BANDS, page_rules};
pub(crate) use panel::{GAP, Panel, WIDTH, inset, shorten};
#[cfg(any(test, feature = "png"))]
pub use png::{PictureError, rasterize};
pub(crate) use view::{Pen, View};
