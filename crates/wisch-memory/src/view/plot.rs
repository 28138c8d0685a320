//! Diagrams of a query's results.

use super::{ViewError, text_of};
use crate::ask::Term;

/// Largest number of entries in a diagram.
const MAX_ENTRIES: usize = 20_000;

/// The kind of a diagram that a query plots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Diagram {
    /// Pie chart: shares of a whole.
    Pie,
    /// Bar chart: a bar per number.
    Bar,
    /// Timeline: intervals.
    Timeline,
    /// Line chart: points joined in their order.
    Line,
    /// Scatter plot: points.
    Scatter,
}

/// The data that a diagram shows.
#[derive(Debug, Clone, PartialEq)]
pub enum PlotData {
    /// Labelled numbers, for pie and bar charts.
    Amounts(Vec<(String, f64)>),
    /// Labelled intervals, for timelines.
    Spans(Vec<(String, [f64; 2])>),
    /// Points x, y, for line charts and scatter plots.
    Points(Vec<[f64; 2]>),
}

/// A diagram with its title, labels and data.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Kind of the diagram.
    pub diagram: Diagram,
    /// Its identifier: a later diagram replaces an earlier one of the same kind and identifier.
    pub id: String,
    /// Title; this and the labels may be empty.
    pub title: String,
    /// Label of the horizontal axis.
    pub x_label: String,
    /// Label of the vertical axis.
    pub y_label: String,
    /// Its data.
    pub data: PlotData,
}

impl Diagram {
    /// Name of the kind in queries.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Pie => "piechart",
            Self::Bar => "barchart",
            Self::Timeline => "timeline",
            Self::Line => "linechart",
            Self::Scatter => "scatter",
        }
    }

    fn of(name: &str) -> Option<Self> {
        let all = [
            Self::Pie,
            Self::Bar,
            Self::Timeline,
            Self::Line,
            Self::Scatter,
        ];
        all.into_iter().find(|diagram| diagram.as_str() == name)
    }
}

impl Plot {
    /// Parses `Diagram(Id)` and a list such as `[data: [Xs, Ys], title: T, xlabel: X, ylabel: Y]`. `data` may also be a
    /// list of pairs.
    ///
    /// # Errors
    /// If the terms are not a diagram with valid data.
    pub fn from_terms(diagram: &Term, properties: &Term) -> Result<Self, ViewError> {
        let refused = || ViewError::ViewCommand {
            found: diagram.to_string(),
        };
        let (name, arguments) = diagram.parts().ok_or_else(refused)?;
        let kind = Diagram::of(name).ok_or_else(refused)?;
        let mut plot = Self {
            diagram: kind,
            id: arguments.first().map(text_of).unwrap_or_default(),
            title: String::new(),
            x_label: String::new(),
            y_label: String::new(),
            data: PlotData::Points(Vec::new()),
        };
        let Term::List(properties) = properties else {
            return Err(fault(kind, "properties", properties, "a list"));
        };
        let mut data = None;
        for property in properties {
            match key_and_value(property) {
                Some(("title", text)) => plot.title = text_of(text),
                Some(("xlabel" | "x_label", text)) => plot.x_label = text_of(text),
                Some(("ylabel" | "y_label", text)) => plot.y_label = text_of(text),
                Some(("data", found)) => data = Some(found),
                // KnowRob allows further properties, for example sizes, which are ignored.
                Some(_) => {}
                None => {
                    return Err(fault(kind, "properties", property, "a property Key: Value"));
                }
            }
        }
        let data = data.ok_or_else(|| ViewError::NoData {
            diagram: kind.as_str(),
        })?;
        plot.data = entries(kind, &pairs(kind, data)?)?;
        Ok(plot)
    }
}

/// `Key: Value`, `Key = Value`, `Key - Value` or `Key(Value)`.
fn key_and_value(property: &Term) -> Option<(&str, &Term)> {
    match property.parts()? {
        (":" | "=" | "-", [key, value]) => Some((key.as_atom()?, value)),
        (key, [value]) => Some((key, value)),
        _ => None,
    }
}

/// Returns pairs of two lists, or of a list of pairs.
fn pairs(kind: Diagram, data: &Term) -> Result<Vec<(&Term, &Term)>, ViewError> {
    let Term::List(items) = data else {
        return Err(fault(kind, "data", data, "[Xs, Ys] or a list of pairs"));
    };
    if let [Term::List(xs), Term::List(ys)] = items.as_slice()
        && !is_pair_of_labels(kind, xs, ys)
    {
        if xs.len() != ys.len() {
            return Err(ViewError::Lengths {
                diagram: kind.as_str(),
                xs: xs.len(),
                ys: ys.len(),
            });
        }
        return Ok(xs.iter().zip(ys).collect());
    }
    let pairs = items.iter().enumerate().map(|(place, item)| match item {
        Term::List(two) if two.len() == 2 => Ok((&two[0], &two[1])),
        Term::Compound(name, two) if name == "-" && two.len() == 2 => Ok((&two[0], &two[1])),
        other => Err(fault(kind, &format!("data[{place}]"), other, "a pair")),
    });
    pairs.collect()
}

/// Whether two lists of length two, such as `[[a, 1], [b, 2]]`, are pairs of a label and its value.
fn is_pair_of_labels(kind: Diagram, first: &[Term], second: &[Term]) -> bool {
    let labelled = |pair: &[Term]| match pair {
        [label, value] => label.as_number().is_none() && value.as_atom().is_none(),
        _ => false,
    };
    let is_list = |pair: &[Term]| matches!(pair.first(), Some(Term::List(_)));
    !matches!(kind, Diagram::Line | Diagram::Scatter)
        && [first, second]
            .iter()
            .all(|pair| labelled(pair) && !is_list(pair))
}

fn entries(kind: Diagram, pairs: &[(&Term, &Term)]) -> Result<PlotData, ViewError> {
    if pairs.len() > MAX_ENTRIES {
        return Err(ViewError::TooMany {
            diagram: kind.as_str(),
            count: pairs.len(),
            limit: MAX_ENTRIES,
        });
    }
    let number = |place: String, term: &Term| {
        let number = term.as_number().filter(|number| number.is_finite());
        number.ok_or_else(|| fault(kind, &place, term, "a number"))
    };
    let numbered = pairs.iter().enumerate();
    match kind {
        Diagram::Pie | Diagram::Bar => {
            let amounts = numbered.map(|(place, (label, value))| {
                let place = format!("Ys[{place}]");
                let amount = number(place.clone(), value)?;
                if kind == Diagram::Pie && amount < 0.0 {
                    return Err(fault(kind, &place, value, "a number from 0 on"));
                }
                Ok((text_of(label), amount))
            });
            Ok(PlotData::Amounts(
                amounts.collect::<Result<_, ViewError>>()?,
            ))
        }
        Diagram::Timeline => {
            let spans = numbered.map(|(place, (label, value))| {
                let span = span(value).ok_or_else(|| {
                    fault(
                        kind,
                        &format!("Ys[{place}]"),
                        value,
                        "a time or [Start, End]",
                    )
                })?;
                Ok((text_of(label), span))
            });
            Ok(PlotData::Spans(spans.collect::<Result<_, ViewError>>()?))
        }
        Diagram::Line | Diagram::Scatter => {
            let points = numbered.map(|(place, (x, y))| {
                Ok([
                    number(format!("Xs[{place}]"), x)?,
                    number(format!("Ys[{place}]"), y)?,
                ])
            });
            Ok(PlotData::Points(points.collect::<Result<_, ViewError>>()?))
        }
    }
}

fn span(term: &Term) -> Option<[f64; 2]> {
    let time = |term: &Term| term.as_number().filter(|time| time.is_finite());
    let ends = match term {
        Term::List(ends) => ends.as_slice(),
        Term::Compound(name, ends) if name == "interval" || name == "-" => ends.as_slice(),
        other => return time(other).map(|at| [at, at]),
    };
    match ends {
        [from, to] => Some([time(from)?, time(to)?]).filter(|[from, to]| from <= to),
        _ => None,
    }
}

fn fault(kind: Diagram, place: &str, found: &Term, expected: &'static str) -> ViewError {
    ViewError::Data {
        diagram: kind.as_str(),
        place: place.to_owned(),
        found: found.to_string(),
        expected,
    }
}
