//! Tables as text: comments, a line of names, and separated values.

use super::cell::{Cell, TakeRow};
use crate::error::ReadFault;
use std::borrow::Cow;
use std::cell::Cell as Shared;

/// Separator of values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Separator {
    Character(u8),
    /// Any number of spaces and tabs.
    Space,
}

/// Separators in the order in which they are tried; a comma may also be a decimal separator.
const SEPARATORS: [Separator; 4] = [
    Separator::Character(b';'),
    Separator::Character(b'\t'),
    Separator::Character(b','),
    Separator::Space,
];

/// Largest number of lines before the names.
const MOST_LINES_BEFORE: usize = 200;

/// The search for names ends at a line with at least this many values that are all numbers.
const LEAST_NUMBERS: usize = 3;

/// Words for a missing value, in any case. NaN is a number that is not finite.
const MISSING: [&str; 6] = ["none", "null", "na", "n/a", "#n/a", "nil"];

/// A table as text.
#[derive(Debug)]
pub(super) struct Delimited<'a> {
    separator: Separator,
    names: Vec<String>,
    /// The text after the line of names, and the number of its first line.
    body: &'a str,
    first_line: usize,
    decimal_commas: Shared<bool>,
    decimal_points: Shared<bool>,
    cut_off: Shared<bool>,
}

impl<'a> Delimited<'a> {
    /// Finds the line of names: the first line that `layout` accepts. It may begin with a hash.
    pub fn open<L>(
        text: &'a str,
        layout: impl Fn(&[String]) -> Result<L, ReadFault>,
    ) -> Result<(Self, L), ReadFault> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        // Fault of the line that most likely holds the names: not a comment, and with the most values.
        let mut likeliest: Option<((bool, usize), ReadFault)> = None;
        let mut rest = text;
        for line in 1..=MOST_LINES_BEFORE {
            let Some((text, after)) = split_line(rest) else {
                break;
            };
            rest = after;
            let text = text.trim();
            if text.is_empty() || text.to_ascii_lowercase().starts_with("sep=") {
                continue;
            }
            let plain = text.trim_start_matches(['#', '%']);
            let is_comment = plain.len() < text.len();
            let mut has_numbers = false;
            for separator in SEPARATORS {
                let names = separator.split(plain);
                if names.len() < 2 && separator != Separator::Space {
                    continue;
                }
                has_numbers |= names.len() >= LEAST_NUMBERS
                    && names
                        .iter()
                        .all(|name| name.replace(',', ".").parse::<f64>().is_ok());
                match layout(&names) {
                    Ok(layout) => {
                        let table = Self {
                            separator,
                            names,
                            body: rest,
                            first_line: line + 1,
                            decimal_commas: Shared::new(false),
                            decimal_points: Shared::new(false),
                            cut_off: Shared::new(false),
                        };
                        return Ok((table, layout));
                    }
                    Err(fault) => {
                        let rank = (!is_comment, names.len());
                        if likeliest.as_ref().is_none_or(|(best, _)| *best < rank) {
                            likeliest = Some((rank, fault));
                        }
                    }
                }
            }
            if has_numbers && !is_comment {
                break;
            }
        }
        Err(likeliest.map_or(ReadFault::Empty, |(_, fault)| fault))
    }

    /// Names of all columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Whether commas were read as decimal separators.
    pub fn has_decimal_commas(&self) -> bool {
        self.decimal_commas.get()
    }

    /// Whether the last line is incomplete.
    pub fn is_cut_off(&self) -> bool {
        self.cut_off.get()
    }

    /// Calls `take` with the requested values of each line and the line's number.
    pub fn visit_rows(&self, wanted: &[usize], take: &mut TakeRow<'_>) -> Result<(), ReadFault> {
        match self.separator {
            Separator::Space => self.each_by_spaces(wanted, take),
            Separator::Character(separator) => self.each_by_character(separator, wanted, take),
        }
    }

    fn each_by_spaces(&self, wanted: &[usize], take: &mut TakeRow<'_>) -> Result<(), ReadFault> {
        let mut rest = self.body;
        let mut line = self.first_line;
        while let Some((text, after)) = split_line(rest) {
            rest = after;
            let values: Vec<&str> = text.split_whitespace().collect();
            let is_data = values
                .first()
                .is_some_and(|first| !first.starts_with(['#', '%']));
            if is_data && !self.row(line, &values, rest.is_empty(), wanted, take)? {
                break;
            }
            line += 1;
        }
        Ok(())
    }

    fn each_by_character(
        &self,
        separator: u8,
        wanted: &[usize],
        take: &mut TakeRow<'_>,
    ) -> Result<(), ReadFault> {
        let mut reader = csv::ReaderBuilder::new()
            .delimiter(separator)
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(self.body.as_bytes());
        let mut record = csv::StringRecord::new();
        let (mut line, mut counted) = (self.first_line, 0);
        loop {
            let is_there = reader
                .read_record(&mut record)
                .map_err(|error| ReadFault::Csv(error.to_string()))?;
            if !is_there {
                return Ok(());
            }
            // The reader's own position is before the comments and empty lines that it skips.
            let start = record
                .position()
                .map_or(0, |position| position.byte() as usize);
            let start = start + skipped_len(&self.body[start..]);
            line += newlines(&self.body[counted..start]);
            counted = start;
            let first = record.get(0).unwrap_or_default();
            if first.starts_with(['#', '%']) || (record.len() == 1 && first.is_empty()) {
                continue;
            }
            let values: Vec<&str> = record.iter().collect();
            let is_last = reader.position().byte() as usize >= self.body.len();
            if !self.row(line, &values, is_last, wanted, take)? {
                return Ok(());
            }
        }
    }

    /// Calls `take` with the requested values of a line.
    fn row(
        &self,
        line: usize,
        values: &[&str],
        is_last: bool,
        wanted: &[usize],
        take: &mut TakeRow<'_>,
    ) -> Result<bool, ReadFault> {
        // A line may end with separators and empty values.
        let filled = |count: usize, is_empty: &dyn Fn(usize) -> bool, least: usize| {
            (least..count)
                .rev()
                .find(|&k| !is_empty(k))
                .map_or(count.min(least), |k| k + 1)
        };
        let needed = filled(self.names.len(), &|k| self.names[k].is_empty(), 0);
        let count = filled(values.len(), &|k| values[k].is_empty(), needed);
        if count != needed {
            if is_last && count < needed && !self.body.ends_with(['\n', '\r']) {
                self.cut_off.set(true);
                return Ok(false);
            }
            return Err(ReadFault::ValueCount {
                line,
                count,
                names: needed,
            });
        }
        let cell = |&index: &usize| match values.get(index) {
            None | Some(&"") => Ok(Cell::Empty),
            Some(text) if MISSING.iter().any(|word| text.eq_ignore_ascii_case(word)) => {
                Ok(Cell::Empty)
            }
            Some(text) => self.cell(line, text).map(Cell::Text),
        };
        let cells = wanted
            .iter()
            .map(cell)
            .collect::<Result<Vec<_>, ReadFault>>()?;
        take(line, &cells)
    }

    /// Returns a value with a point as decimal separator. A comma is a decimal separator only if no comma separates
    /// values, and then no value has a decimal point: "1,870" may be 1870 in such a table.
    fn cell<'b>(&self, line: usize, text: &'b str) -> Result<Cow<'b, str>, ReadFault> {
        if self.separator == Separator::Character(b',') {
            return Ok(text.into());
        }
        let mut value = Cow::from(text);
        if text.contains(',') && !text.contains('.') {
            let pointed = text.replacen(',', ".", 1);
            if pointed.parse::<f64>().is_ok() {
                self.decimal_commas.set(true);
                value = pointed.into();
            }
        } else if text.contains('.') && text.parse::<f64>().is_ok() {
            self.decimal_points.set(true);
        }
        if self.decimal_commas.get() && self.decimal_points.get() {
            let text = text.to_owned();
            return Err(ReadFault::DecimalMarks { line, text });
        }
        Ok(value)
    }
}

impl Separator {
    /// Splits a line into its values.
    fn split(self, line: &str) -> Vec<String> {
        match self {
            Self::Space => {
                let words = line.split_whitespace();
                words
                    .map(|word| word.trim_matches('"').to_owned())
                    .collect()
            }
            Self::Character(separator) => {
                let mut reader = csv::ReaderBuilder::new()
                    .delimiter(separator)
                    .has_headers(false)
                    .trim(csv::Trim::All)
                    .from_reader(line.as_bytes());
                let mut record = csv::StringRecord::new();
                // A single line of text cannot fail.
                let _ = reader.read_record(&mut record);
                record.iter().map(str::to_owned).collect()
            }
        }
    }
}

/// Splits off the first line; `None` at the end.
fn split_line(text: &str) -> Option<(&str, &str)> {
    if text.is_empty() {
        return None;
    }
    Some(text.split_once('\n').unwrap_or((text, "")))
}

/// Returns the number of bytes that the reader skips before a record: line ends and comments.
fn skipped_len(text: &str) -> usize {
    let mut rest = text;
    loop {
        rest = rest.trim_start_matches(['\r', '\n']);
        if !rest.starts_with('#') {
            return text.len() - rest.len();
        }
        rest = split_line(rest).map_or("", |(_, after)| after);
    }
}

fn newlines(text: &str) -> usize {
    text.bytes().filter(|&byte| byte == b'\n').count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> Result<Vec<(usize, Vec<String>)>, ReadFault> {
        let (table, ()) =
            Delimited::open(text, |names| match names.iter().any(|name| name == "t") {
                true => Ok(()),
                false => Err(ReadFault::Empty),
            })?;
        let wanted: Vec<usize> = (0..table.names().len()).collect();
        let mut rows = Vec::new();
        table.visit_rows(&wanted, &mut |line, cells| {
            rows.push((
                line,
                cells.iter().map(|cell| cell.text().into_owned()).collect(),
            ));
            Ok(true)
        })?;
        Ok(rows)
    }

    fn row(line: usize, values: [&str; 2]) -> (usize, Vec<String>) {
        (line, values.map(str::to_owned).to_vec())
    }

    #[test]
    fn all_dialects_give_the_same_rows() {
        for text in [
            "t,x\n0,1.5\n",
            "t;x\r\n0;1,5\r\n",
            "\u{feff}t\tx\n0\t1,5",
            "  t   x\n  0   1.5\n",
            "\"t\",\"x\"\n\"0\",\"1.5\"\n",
            "t, x,\n0, 1.5,\n",
            "# t x\n0 1.5\n",
        ] {
            let mut rows = rows(text).unwrap();
            rows[0].1.truncate(2);
            assert_eq!(rows, [row(2, ["0", "1.5"])], "{text:?}");
        }
    }

    #[test]
    fn lines_are_counted_through_comments_empty_lines_and_quotes() {
        let text = "# made by, a robot\nsep=,\n\nt,x\n# one\n\n0,1\n\r\n  # two\n1,\"a\nb\"\n# three\n2,3\n";
        let expected = [
            row(7, ["0", "1"]),
            row(10, ["1", "a\nb"]),
            row(13, ["2", "3"]),
        ];
        assert_eq!(rows(text).unwrap(), expected);
    }

    #[test]
    fn a_line_of_another_length_is_reported() {
        let shown = |text: &str| rows(text).unwrap_err().to_string();
        assert_eq!(
            shown("t,x\n0,1\n\n1,2,3\n"),
            "line 4: it has 3 values, but the table has 2 names"
        );
        assert_eq!(
            shown("t x\n0 1\n# -\n1\n2 2\n"),
            "line 4: it has 1 values, but the table has 2 names"
        );
        // A writer that was stopped leaves an incomplete line.
        assert_eq!(rows("t,x\n0,1\n1").unwrap(), [row(2, ["0", "1"])]);
    }
}
