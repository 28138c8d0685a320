//! The page of Table 1: tasks by several strategies, with the paper's figures, and pictures of the wiped surfaces as in the
//! paper's Fig. 7.

mod snapshot;

use crate::draw::legend;
use crate::page::document::document;
use maud::{Markup, html};
pub use snapshot::WipedSurface;

const STYLE: &str = include_str!("table1.css");

/// Input of the page of Table 1.
#[derive(Debug, Clone)]
pub struct Table1Input<'a> {
    /// Seeds, commit and extent of the runs.
    pub lead: String,
    /// Main result, as a number and a sentence.
    pub headline: Option<(String, String)>,
    /// Names of the quantities with their units, in order.
    pub quantities: Vec<String>,
    /// The table, action by action.
    pub actions: Vec<ActionRows<'a>>,
    /// Description of the pictures.
    pub pictured: String,
    /// Notes on the figures.
    pub notes: Vec<String>,
}

/// The results of one action on each surface.
#[derive(Debug, Clone)]
pub struct ActionRows<'a> {
    /// Its name.
    pub action: String,
    /// The surfaces.
    pub surfaces: Vec<SurfaceColumns<'a>>,
}

/// The results on one surface, by each strategy.
#[derive(Debug, Clone)]
pub struct SurfaceColumns<'a> {
    /// Its name.
    pub surface: String,
    /// The strategies.
    pub columns: Vec<StrategyColumn<'a>>,
}

/// The results of one strategy on one surface.
#[derive(Debug, Clone)]
pub struct StrategyColumn<'a> {
    /// Its name.
    pub strategy: String,
    /// Its figures, one for each quantity.
    pub figures: Vec<ComparedFigure>,
    /// The wiped surface, with a caption of two lines: result, and costs.
    pub picture: Option<(WipedSurface<'a>, [String; 2])>,
}

/// A figure of wisch with the paper's.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ComparedFigure {
    /// The figure of wisch.
    pub ours: String,
    /// The paper's, if it has one.
    pub paper: Option<String>,
    /// Whether to highlight the figure of wisch.
    pub is_strong: bool,
}

/// Returns one self-contained HTML file, which loads nothing from the network.
pub fn table1_page(input: &Table1Input) -> String {
    let main = html! {
        h1 { "Table 1: wisch and the paper" }
        p class="lead" { (input.lead) }
        @if let Some((number, sentence)) = &input.headline {
            section class="result" {
                span class="number-large" { (number) }
                div { p class="verdict" { (sentence) } }
            }
        }
        h2 { "Figures" }
        p { "Each cell shows the figure of wisch, with the paper's figure below it." }
        @for action in &input.actions { (build_figure_table(input, action)) }
        @for note in &input.notes { p class="note" { (note) } }
        @if input.actions.iter().any(|action| action.surfaces.iter().any(has_pictures)) {
            h2 { "Surfaces, as in Fig. 7" }
            p { (input.pictured) }
            (legend::list(&snapshot::entries()))
            @for action in &input.actions {
                @for surface in action.surfaces.iter().filter(|surface| has_pictures(surface)) {
                    h3 { (action.action) " · " (surface.surface) }
                    (draw_pictures(surface))
                }
            }
        }
        footer class="note" {
            "The paper's figures are from Table 1 of Leidner et al., "
            cite { "Cognition-enabled robotic wiping" }
            ", Robotics and Autonomous Systems 114 (2019)."
        }
    };
    document("Table 1: wisch and the paper", STYLE, &main)
}

fn has_pictures(surface: &SurfaceColumns) -> bool {
    surface
        .columns
        .iter()
        .any(|column| column.picture.is_some())
}

/// Returns the table of an action, with a row per quantity and a column per surface and strategy.
fn build_figure_table(input: &Table1Input, action: &ActionRows) -> Markup {
    let surfaces = || action.surfaces.iter();
    html! {
        div class="scroll" {
            table class="figures" {
                thead {
                    tr {
                        th rowspan="2" scope="col" class="action" { (action.action) }
                        @for surface in surfaces() {
                            th scope="colgroup" class="first" colspan=(surface.columns.len()) { (surface.surface) }
                        }
                    }
                    tr {
                        @for surface in surfaces() {
                            @for (i, column) in surface.columns.iter().enumerate() {
                                th scope="col" class=[(i == 0).then_some("first")] { (column.strategy) }
                            }
                        }
                    }
                }
                tbody {
                    @for (row, quantity) in input.quantities.iter().enumerate() {
                        tr {
                            th scope="row" { (quantity) }
                            @for surface in surfaces() {
                                @for (i, column) in surface.columns.iter().enumerate() {
                                    td class=[(i == 0).then_some("first")] {
                                        @if let Some(figure) = column.figures.get(row) { (draw_figure(figure)) }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn draw_figure(figure: &ComparedFigure) -> Markup {
    html! {
        @if figure.is_strong { b { (figure.ours) } } @else { (figure.ours) }
        @if let Some(paper) = &figure.paper { small { (paper) } }
    }
}

/// Draws the surface before, and after each strategy.
fn draw_pictures(surface: &SurfaceColumns) -> Markup {
    let pictured: Vec<_> = (surface.columns.iter())
        .filter_map(|column| Some((column, column.picture.as_ref()?)))
        .collect();
    html! {
        div class="surfaces" {
            @if let Some((_, (first, _))) = pictured.first() {
                figure {
                    (first.before().inline("before"))
                    figcaption { b { "before" } }
                }
            }
            @for (column, (picture, [outcome, effort])) in pictured {
                figure {
                    (picture.after().inline(&format!("after, by {}", column.strategy)))
                    figcaption { b { (column.strategy) } " · " (outcome) br; (effort) }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::Point2;
    use wisch::represent::GoalState;

    fn input<'a>(picture: Option<(WipedSurface<'a>, [String; 2])>) -> Table1Input<'a> {
        let figure = |ours: &str, paper: Option<&str>| ComparedFigure {
            ours: ours.to_owned(),
            paper: paper.map(str::to_owned),
            is_strong: paper.is_some(),
        };
        let column = StrategyColumn {
            strategy: "kde".to_owned(),
            figures: vec![figure("92.00", Some("90.50")), figure("3.0", None)],
            picture,
        };
        Table1Input {
            lead: "Seeds 1 to 5".to_owned(),
            headline: Some(("1 of 1".to_owned(), "cells".to_owned())),
            quantities: vec!["performance %".to_owned(), "lifts".to_owned()],
            actions: vec![ActionRows {
                action: "collect".to_owned(),
                surfaces: vec![SurfaceColumns {
                    surface: "board".to_owned(),
                    columns: vec![column],
                }],
            }],
            pictured: "Seed 1.".to_owned(),
            notes: Vec::new(),
        }
    }

    #[test]
    fn the_papers_figure_is_below_that_of_wisch() {
        let page = table1_page(&input(None));
        assert!(page.contains("<b>92.00</b><small>90.50</small>"), "{page}");
        assert!(page.contains("<td class=\"first\">3.0</td>"), "{page}");
        assert!(!page.contains("Fig. 7"), "nothing is pictured");
    }

    #[test]
    fn a_picture_shows_each_particle_once_before_and_after() {
        let loaded = wisch_io::load_task("chopping-board".as_ref(), &Default::default());
        let loaded = loaded.expect("it is shipped");
        let at = |x: f64| Point2::new(x, 0.0);
        let picture = WipedSurface {
            task: &loaded.task,
            goal: GoalState::Absorbed,
            collision_radius: 0.05,
            strokes: vec![vec![at(-0.1), at(0.1)]],
            before: vec![at(-0.1), at(0.0), at(0.1)],
            left: vec![at(0.1)],
            done: vec![],
            lost: vec![],
        };
        let page = table1_page(&input(Some((
            picture,
            ["2 of 3".to_owned(), "1 lift".to_owned()],
        ))));
        let dots = |class: &str| {
            let paths = page
                .split("<path ")
                .filter(|path| path.contains(&format!("class=\"{class}\"")));
            paths
                .map(|path| path.matches("h0").count())
                .max()
                .unwrap_or(0)
        };
        assert_eq!(page.matches("class=\"before\" d=").count(), 1);
        assert_eq!(dots("dots-left"), 1, "one is left after");
        assert!(page.contains("2 of 3") && page.contains("class=\"trail\""));
    }
}
