//! Solves a closed tour: `tour POINTS.csv [KICKS_PER_NODE] [SEED]`, with `x,y` [m] on each line.
//!
//! Prints the tour's length [m], the number of nodes and the milliseconds taken, comma-separated.

mod points;

use std::time::Instant;
use wisch::plan::{CostMatrix, TourConfig, shortest_tour};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments
        .next()
        .ok_or("usage: tour POINTS.csv [KICKS_PER_NODE] [SEED]")?;
    let mut config = TourConfig::default();
    if let Some(kicks) = arguments.next() {
        config.kicks_per_node = kicks.parse()?;
    }
    if let Some(seed) = arguments.next() {
        config.seed = seed.parse()?;
    }

    let points = points::read(&path)?;
    let begin = Instant::now();
    let costs = CostMatrix::euclidean(&points)?;
    let tour = shortest_tour(&costs, &config);
    let milliseconds = begin.elapsed().as_secs_f64() * 1e3;
    println!(
        "{:.9},{},{milliseconds:.3}",
        costs.tour_cost(&tour),
        points.len()
    );
    Ok(())
}
