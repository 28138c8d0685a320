//! Height fields in Esri's ASCII raster format (`.asc`), the text format to which GDAL converts any raster.

use super::{MAX_COORDINATE, MAX_TRIANGLES, Mesh, MeshError, Point3};

/// Height of a cell without data, unless the header states another.
const NO_DATA: f64 = -9999.0;

/// Header of a file, before the heights.
#[derive(Default)]
struct Header {
    columns: Option<usize>,
    rows: Option<usize>,
    /// Middle or corner of the lower left cell, by axis.
    origin: [Option<Origin>; 2],
    /// Numbers of their lines, by axis.
    origin_lines: [usize; 2],
    cell: [Option<f64>; 2],
    no_data: Option<f64>,
}

#[derive(Clone, Copy)]
enum Origin {
    Middle(f64),
    Corner(f64),
}

/// Reads a height field as a mesh: a vertex in the middle of each cell, and two triangles between four neighbours. Cells
/// without data are holes.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let text = std::str::from_utf8(bytes).map_err(|_| MeshError::Syntax {
        reason: "the file is not text".to_owned(),
    })?;
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = text.lines().zip(1..).peekable();
    let mut header = Header::default();
    while let Some(&(line, number)) = lines.peek() {
        let mut words = line.split_ascii_whitespace();
        let key = words.next().unwrap_or_default().to_ascii_lowercase();
        if key.is_empty() {
            lines.next();
            continue;
        }
        if !key.starts_with(|c: char| c.is_ascii_alphabetic()) || key == "nan" {
            if number == 1 {
                let reason = "it begins with numbers and not with the header of an Esri ASCII raster (ncols, nrows, …); a point cloud has to be meshed first";
                return Err(MeshError::Syntax {
                    reason: reason.to_owned(),
                });
            }
            break;
        }
        header
            .read(&key, words.next())
            .map_err(|reason| MeshError::SyntaxAt {
                line: number,
                reason,
            })?;
        if let Some(axis) = ["xll", "yll"]
            .iter()
            .position(|begin| key.starts_with(begin))
        {
            header.origin_lines[axis] = number;
        }
        lines.next();
    }
    let grid = header
        .grid()
        .map_err(|reason| MeshError::Syntax { reason })?;
    let expected = grid.columns * grid.rows;
    let mut heights: Vec<Option<f64>> = Vec::new();
    for (line, number) in lines {
        for word in line.split_ascii_whitespace() {
            let fault = |reason| MeshError::SyntaxAt {
                line: number,
                reason,
            };
            let height: f64 =
                (word.parse()).map_err(|_| fault(format!("{word:?} is not a height")))?;
            if heights.len() == expected {
                return Err(fault(format!(
                    "more than {} x {} heights",
                    grid.columns, grid.rows
                )));
            }
            heights.push((!height.is_nan() && height != grid.no_data).then_some(height));
        }
    }
    if heights.len() < expected {
        let reason = format!(
            "{} heights, but its header announces {} x {}",
            heights.len(),
            grid.columns,
            grid.rows
        );
        return Err(MeshError::Syntax { reason });
    }
    grid.mesh(&heights)
}

impl Header {
    /// Reads a line; the key is in lower case.
    fn read(&mut self, key: &str, value: Option<&str>) -> Result<(), String> {
        let word = value.ok_or_else(|| format!("{key} has no value"))?;
        let number = || {
            let value = word.parse().ok().filter(|value: &f64| value.is_finite());
            value.ok_or_else(|| format!("{key} = {word:?} is not a number"))
        };
        let count = || {
            let count = word.parse().ok().filter(|&count: &usize| count >= 2);
            count.ok_or_else(|| format!("{key} = {word:?} is not a whole number of at least 2"))
        };
        let size = || {
            let size = number()?;
            if size > 0.0 {
                Ok(size)
            } else {
                Err(format!("{key} = {word} is not above 0"))
            }
        };
        match key {
            "ncols" => self.columns = Some(count()?),
            "nrows" => self.rows = Some(count()?),
            "xllcenter" => self.origin[0] = Some(Origin::Middle(number()?)),
            "yllcenter" => self.origin[1] = Some(Origin::Middle(number()?)),
            "xllcorner" => self.origin[0] = Some(Origin::Corner(number()?)),
            "yllcorner" => self.origin[1] = Some(Origin::Corner(number()?)),
            "cellsize" => self.cell = [Some(size()?); 2],
            "dx" => self.cell[0] = Some(size()?),
            "dy" => self.cell[1] = Some(size()?),
            "nodata_value" => {
                // `nan` is a common value; cells with such heights have no data in any case.
                self.no_data = Some(
                    word.parse()
                        .map_err(|_| format!("{key} = {word:?} is not a number"))?,
                )
            }
            _ => return Err(format!("{key:?} is not a line of a header")),
        }
        Ok(())
    }

    fn grid(&self) -> Result<Grid, String> {
        let missing = |key: &str| format!("the header has no line {key:?}");
        let columns = self.columns.ok_or_else(|| missing("ncols"))?;
        let rows = self.rows.ok_or_else(|| missing("nrows"))?;
        let of_axis = |axis: usize| {
            let cell = self.cell[axis].ok_or_else(|| missing("cellsize"))?;
            let first = match self.origin[axis] {
                Some(Origin::Middle(at)) => at,
                Some(Origin::Corner(at)) => at + 0.5 * cell,
                None => return Err(missing(["xllcorner", "yllcorner"][axis])),
            };
            let count = [columns, rows][axis];
            let last = first + cell * (count - 1) as f64;
            let farthest = first.abs().max(last.abs());
            if farthest > MAX_COORDINATE {
                let fault = too_far(axis, self.origin[axis], farthest, cell * count as f64);
                return Err(format!("line {}: {fault}", self.origin_lines[axis]));
            }
            Ok((first, cell))
        };
        let ((x, dx), (y, dy)) = (of_axis(0)?, of_axis(1)?);
        let triangles = (columns - 1).saturating_mul(rows - 1).saturating_mul(2);
        if triangles > MAX_TRIANGLES {
            return Err(format!(
                "ncols x nrows = {columns} x {rows} give {triangles} triangles, more than the limit of {MAX_TRIANGLES}"
            ));
        }
        Ok(Grid {
            columns,
            rows,
            first: [x, y],
            cell: [dx, dy],
            no_data: self.no_data.unwrap_or(NO_DATA),
        })
    }
}

/// Why a raster reaches beyond the largest coordinate: it lies far away, as in a map, or it is too large itself.
fn too_far(axis: usize, origin: Option<Origin>, farthest: f64, extent: f64) -> String {
    let name = ["x", "y"][axis];
    let (key, at) = match origin {
        Some(Origin::Middle(at)) => ("llcenter", at),
        Some(Origin::Corner(at)) => ("llcorner", at),
        None => ("llcorner", 0.0),
    };
    let advice = if extent <= MAX_COORDINATE {
        format!(
            "coordinates of a map are too large; set {name}{key} to 0 in the file, and the place in the world with position_m of the surface or object"
        )
    } else {
        format!("the raster is {extent} m long; state cellsize in metres, or cut the raster")
    };
    format!(
        "{name}{key} = {at} puts cells {farthest:.2} m from 0 along {name}, beyond the limit of {MAX_COORDINATE} m: {advice}"
    )
}

struct Grid {
    columns: usize,
    rows: usize,
    /// Middle of the lower left cell \[m\].
    first: [f64; 2],
    /// Size of a cell \[m\].
    cell: [f64; 2],
    no_data: f64,
}

impl Grid {
    /// Makes the mesh of heights by row from the largest y, `None` where there is no data.
    fn mesh(&self, heights: &[Option<f64>]) -> Result<Mesh, MeshError> {
        let mut vertices = Vec::new();
        let index: Vec<Option<u32>> = (heights.iter().enumerate())
            .map(|(i, height)| {
                let (row, column) = (self.rows - 1 - i / self.columns, i % self.columns);
                vertices.push(Point3::new(
                    self.first[0] + self.cell[0] * column as f64,
                    self.first[1] + self.cell[1] * row as f64,
                    (*height)?,
                ));
                Some(vertices.len() as u32 - 1)
            })
            .collect();
        let mut triangles = Vec::new();
        for row in 1..self.rows {
            for column in 1..self.columns {
                let at = |up: usize, left: usize| index[(row - up) * self.columns + column - left];
                // Counter-clockwise as seen from above, from the lower left.
                let corners = [at(0, 1), at(0, 0), at(1, 0), at(1, 1)];
                let known: Vec<u32> = corners.iter().flatten().copied().collect();
                match known[..] {
                    [a, b, c] => triangles.push([a, b, c]),
                    [a, b, c, d] => {
                        let step = |from: u32, to: u32| {
                            (vertices[from as usize].z - vertices[to as usize].z).abs()
                        };
                        // Along the flatter diagonal, which follows ridges and valleys.
                        triangles.extend(if step(a, c) <= step(b, d) {
                            [[a, b, c], [a, c, d]]
                        } else {
                            [[a, b, d], [b, c, d]]
                        });
                    }
                    _ => {}
                }
            }
        }
        Mesh::new(vertices, triangles)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_lie_in_the_middles_of_cells_with_the_largest_y_first() {
        let text = "NCOLS 3\nnrows 2\nxllcorner 1.0\nyllcorner -2.0\ncellsize 0.5\nNODATA_value -1\n\n0 0.1 0.2\n1 1.1\n1.2\n";
        let mesh = parse(text.as_bytes()).unwrap();
        assert_eq!(mesh.vertices()[0], Point3::new(1.25, -1.25, 0.0));
        assert_eq!(mesh.vertices()[5], Point3::new(2.25, -1.75, 1.2));
        assert_eq!(mesh.triangles().len(), 4);
        for [a, b, c] in mesh.corners() {
            assert!((b - a).cross(&(c - a)).z > 0.0, "the tool is above");
        }
    }

    #[test]
    fn cells_without_data_are_holes() {
        let header = "ncols 3\nnrows 3\nxllcenter 0\nyllcenter 0\ndx 0.1\ndy 0.2\n";
        let mesh = parse(format!("{header}0 0 0\n0 -9999 0\n0 0 nan\n").as_bytes()).unwrap();
        assert_eq!(mesh.vertices().len(), 7);
        // Three cells keep a corner, and the fourth has two neighbours only.
        assert_eq!(mesh.triangles().len(), 3);
        assert_eq!(mesh.vertices()[0], Point3::new(0.0, 0.4, 0.0));
    }

    #[test]
    fn faults_are_named_with_their_lines() {
        let good = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.1\n1 2\n3 4\n";
        assert!(parse(good.as_bytes()).is_ok());
        for (from, to, expected) in [
            (
                "ncols 2",
                "ncols 1",
                "line 1: ncols = \"1\" is not a whole number of at least 2",
            ),
            ("ncols 2\n", "", "the header has no line \"ncols\""),
            ("cellsize 0.1\n", "", "the header has no line \"cellsize\""),
            ("yllcorner 0\n", "", "the header has no line \"yllcorner\""),
            (
                "cellsize 0.1",
                "cellsize 0",
                "line 5: cellsize = 0 is not above 0",
            ),
            ("cellsize 0.1", "cellsize", "line 5: cellsize has no value"),
            (
                "cellsize",
                "cell",
                "line 5: \"cell\" is not a line of a header",
            ),
            ("3 4", "3 4,5", "line 7: \"4,5\" is not a height"),
            ("3 4", "3 4 5", "line 7: more than 2 x 2 heights"),
            ("3 4", "3", "3 heights, but its header announces 2 x 2"),
            ("1 2\n3 4", "-9999 2\n-9999 4", "it has no triangle"),
            ("3 4", "3 inf", "z = inf m exceeds the limit"),
            (
                "xllcorner 0",
                "xllcorner 500000",
                "line 3: xllcorner = 500000 puts cells 500000.15 m from 0 along x, beyond the limit of 10000 m: coordinates of a map are too large; set xllcorner to 0",
            ),
            (
                "yllcorner 0",
                "yllcenter -20000",
                "line 4: yllcenter = -20000 puts cells 20000.00 m from 0 along y, beyond the limit",
            ),
            (
                "cellsize 0.1",
                "cellsize 9000",
                "xllcorner = 0 puts cells 13500.00 m from 0 along x, beyond the limit of 10000 m: the raster is 18000 m long; state cellsize in metres",
            ),
            (
                "ncols 2\nnrows 2",
                "ncols 100000\nnrows 100000",
                "give 19999600002 triangles, more than the limit of 5000000",
            ),
        ] {
            assert!(good.contains(from), "{from}");
            let error = parse(good.replace(from, to).as_bytes()).unwrap_err();
            assert!(error.to_string().contains(expected), "{error}");
        }
        assert!(parse(b"\xff\xfe").is_err() && parse(b"").is_err());
        let cloud = parse(b"0.1 0.2 0.3\n0.2 0.2 0.3\n").unwrap_err();
        assert!(
            cloud.to_string().contains("a point cloud has to be meshed"),
            "{cloud}"
        );
        assert!(parse(format!("\u{feff}{good}").as_bytes()).is_ok());
    }
}
