//! English: the sentences by what they are about.

mod actions;
mod balance;
mod checking;
mod commands;
mod configuration;
mod editing;
mod examples;
mod faults;
mod figures;
mod files;
mod helping;
mod hints;
mod manual;
mod methods;
mod motion;
mod motors;
mod offering;
mod options;
mod picking;
mod plots;
mod reactions;
mod taking;
mod terminals;
mod tour;
mod views;
mod working;

pub(super) use actions::Actions;
pub(super) use balance::Balance;
pub(super) use checking::Checking;
pub(super) use commands::Commands;
pub(super) use configuration::Configuration;
pub(super) use editing::Editing;
pub(super) use examples::Examples;
pub(super) use faults::Faults;
pub(super) use figures::Figures;
pub(super) use files::Files;
pub(super) use helping::Helping;
pub(super) use hints::Hints;
pub(super) use manual::Manual;
pub(super) use methods::Methods;
pub(super) use motion::Motion;
pub(super) use motors::Motors;
pub(super) use offering::Offering;
pub(super) use options::Options;
pub(super) use picking::Picking;
pub(super) use plots::Plots;
pub(super) use reactions::Reactions;
pub(super) use taking::Taking;
pub(super) use terminals::Terminals;
pub(super) use tour::Tour;
pub(super) use views::Views;
pub(super) use working::Working;

/// The language that krank was written in.
#[derive(Debug)]
pub(super) struct English;

/// `1 link`, `3 links`.
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
