//! The facts of `check`, to be read.

use super::check::{
    Check, DECIMALS, DriverFacts, DriverKind, GroupFacts, JointFacts, RedundancyFacts, SlideFacts,
    SliderKind, TransmissionFacts,
};
use super::number::concise;
use crate::page::{Content, Facts, Page, TextStyle};

/// Columns of the names, and of what stands before the rest of a fact that takes several lines.
const NAMES: usize = 11;
const FURTHER: usize = 2;
/// Decimals of a transmission angle.
const MU_DECIMALS: usize = 4;
/// Decimals of where it is so, at most.
const PLACE_DECIMALS: usize = 6;
/// Significant digits of the driver's rates: as many as a table has where none are asked for.
const DIGITS: usize = 6;
/// Names in a list of what is repeated.
const MOST_NAMES: usize = 12;
/// Of a misfit.
const MISFIT_DIGITS: usize = 2;

impl Check {
    /// As text for a person; titles and notes in ASCII alone if asked, everything else always is.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// The facts by their names.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut facts = Facts {
            names: NAMES,
            hanging: FURTHER,
            list: Vec::new(),
        };
        facts.tell("source", self.source.clone());
        facts.tell("note", self.note.clone());
        facts.tell("unit", [self.unit.to_owned()]);
        facts.tell("parts", [self.counts()]);
        facts.tell("driver", [self.driver_text()]);
        facts.tell("links", [self.links.join(", ")]);
        facts.tell("joints", self.joints.iter().map(joint_text));
        facts.tell("slides", self.slides.iter().map(slide_text));
        let mobility = [self.mobility_text()].into_iter().chain(self.rank_notes());
        facts.tell("mobility", mobility);
        let redundant = self.redundancies.iter().map(|r| self.redundancy_text(r));
        facts.tell("redundant", redundant);
        let groups = self.groups.iter().enumerate();
        let groups = groups.map(|(i, group)| format!("{}. {}", i + 1, self.group_text(group)));
        facts.tell("groups", groups);
        facts.tell("choices", self.choices.group_lines());
        facts.tell("assemblies", self.choices.whole_text());
        if let Some(first) = &self.first_loop {
            facts.tell("loop", first.lines(self.unit));
        }
        facts.tell("range", [self.range_text.clone()]);
        if !self.change_points.is_empty() {
            facts.tell("change", [self.change_points_text(), self.tolerance_text()]);
        }
        let unit = self.driver_unit();
        facts.tell("near miss", self.near_misses.iter().map(|m| m.text(unit)));
        let mu = self.transmission.iter().map(|t| mu_text(t, unit));
        facts.tell("mu", mu);
        facts.tell("forces", self.acting_text());
        if !self.indeterminate.is_empty() {
            facts.tell("open", [self.open_text()]);
        }
        let mut page = Page::default();
        page.title(&self.scene);
        page.add_below(Content::Facts(facts));
        page
    }

    /// What acts, where anything does.
    fn acting_text(&self) -> Option<String> {
        let acting = &self.acting;
        let kinds = [
            (acting.forces, "force"),
            (acting.torques, "torque"),
            (acting.presses, "press"),
            (acting.springs, "spring"),
        ];
        let kinds = kinds.into_iter().filter(|(count, _)| *count > 0);
        let mut told: Vec<String> = kinds.map(|(count, what)| counted(count, what)).collect();
        match acting.masses {
            0 => {}
            1 => told.push("1 link with a mass".into()),
            n => told.push(format!("{n} links with a mass")),
        }
        if acting.gravity && acting.masses > 0 {
            told.push("gravity".into());
        }
        let told = (!told.is_empty()).then(|| told.join(", "))?;
        Some(match acting.period {
            Some(period) => format!("{told}; repeated after {period} deg"),
            None => told,
        })
    }

    fn open_text(&self) -> String {
        format!(
            "reactions that equilibrium does not settle: {}",
            self.indeterminate.join(", ")
        )
    }

    fn change_points_text(&self) -> String {
        let unit = self.driver_unit();
        let at = self
            .change_points
            .iter()
            .map(|at| format!("{at:.DECIMALS$}"));
        let at: Vec<String> = at.collect();
        format!("points at {} {unit}, passed smoothly", at.join(", "))
    }

    /// What makes the difference between a change point and a near miss.
    fn tolerance_text(&self) -> String {
        if self.tolerance == 0.0 {
            return "lengths count as equal where they are equal as typed".into();
        }
        let (tolerance, unit) = (self.tolerance, self.unit);
        format!(
            "lengths count as equal within {tolerance:.1e} {unit}: coordinates have been rounded"
        )
    }

    fn driver_unit(&self) -> &'static str {
        match self.driver.kind {
            DriverKind::Link => "deg",
            DriverKind::Slide => self.unit,
        }
    }

    fn counts(&self) -> String {
        format!(
            "{} and the ground, {}, {}",
            counted(self.links.len(), "link"),
            counted(self.pins(), "pin joint"),
            counted(self.slides.len(), "slide"),
        )
    }

    /// Where n bodies meet there are n - 1 joints.
    fn pins(&self) -> usize {
        self.joints.iter().map(|j| j.bodies.len() - 1).sum()
    }

    fn driver_text(&self) -> String {
        let DriverFacts {
            kind,
            start,
            speed,
            acceleration,
            ..
        } = &self.driver;
        let (coordinate, rate) = match kind {
            DriverKind::Link => ("deg", "rad"),
            DriverKind::Slide => (self.unit, self.unit),
        };
        let driven = self.driven();
        let start = concise(*start, usize::MAX);
        // Rates may come from rpm or deg/s, with digits of no use.
        let [speed, acceleration] = [speed, acceleration].map(|v| concise(*v, DIGITS));
        format!(
            "{driven}, opens at {start} {coordinate}, {speed} {rate}/s, \
             {acceleration} {rate}/s^2"
        )
    }

    fn driven(&self) -> String {
        let kind = match self.driver.kind {
            DriverKind::Link => "link",
            DriverKind::Slide => "slide",
        };
        format!("{kind} {}", self.driver.name)
    }

    fn group_text(&self, group: &GroupFacts) -> String {
        let at = group.point.as_ref().map(|p| format!(" at {p}"));
        let at = at.unwrap_or_default();
        let (what, how) = match (group.kind.class(), group.kind.unknowns()) {
            (Some(class), _) => (format!("dyad {class}{at}"), "closed form"),
            (None, Some(unknowns)) => {
                let unknowns = counted(unknowns, "unknown");
                (format!("coupled group{at}, {unknowns}"), "by Newton")
            }
            (None, None) => return format!("driver: {}", self.driven()),
        };
        match group.links.as_slice() {
            [] => format!("{what} ({how})"),
            [link] => format!("{what}: link {link} ({how})"),
            links => format!("{what}: links {} ({how})", links.join(", ")),
        }
    }

    fn mobility_text(&self) -> String {
        if self.redundant.is_empty() {
            return self.mobility.to_string();
        }
        let constraints = self.redundancies.iter().map(|r| r.constraints).sum();
        let count = counted(constraints, "redundant constraint");
        format!(
            "{}, with {count} set aside: {}",
            self.mobility,
            self.redundant.join(", ")
        )
    }

    fn rank_notes(&self) -> impl Iterator<Item = String> {
        let unclear = self.mobility_is_unclear.then_some(UNCLEAR);
        let lower = self.opens_at_change_point.then_some(LOWER);
        unclear.into_iter().chain(lower).map(str::to_owned)
    }

    fn redundancy_text(&self, facts: &RedundancyFacts) -> String {
        let RedundancyFacts {
            element,
            repeats,
            misfit,
            ..
        } = facts;
        let misfit = format!("{} {}", concise(*misfit, MISFIT_DIGITS), self.unit);
        let what = match repeats.as_slice() {
            [] => format!("{element} repeats others"),
            repeats if repeats.len() > MOST_NAMES => format!(
                "{element} repeats {} and {} more",
                repeats[..MOST_NAMES].join(", "),
                repeats.len() - MOST_NAMES
            ),
            repeats => format!("{element} repeats {}", repeats.join(", ")),
        };
        format!("{what}; they disagree by at most {misfit}")
    }
}

/// What is said besides the number.
const UNCLEAR: &str = "all but 2 or more: dimensions that differ by little would leave a link free";
const LOWER: &str =
    "more where the scene opens: it is a change point or a dead point of a coupled group";

fn counted(count: usize, what: &str) -> String {
    match count {
        0 => format!("no {what}"),
        1 => format!("1 {what}"),
        n if what.ends_with('s') => format!("{n} {what}es"),
        n => format!("{n} {what}s"),
    }
}

fn joint_text(joint: &JointFacts) -> String {
    format!("{}: {}", joint.point, joint.bodies.join(", "))
}

fn slide_text(slide: &SlideFacts) -> String {
    let SlideFacts {
        name,
        kind,
        slider,
        on,
    } = slide;
    match kind {
        SliderKind::Pin => format!("{name}: pin {slider} in a slot of {on}"),
        SliderKind::Link => format!("{name}: link {slider} along {on}, without turning against it"),
    }
}

/// The transmission angle of a dyad: smallest and largest, or what it always is.
fn mu_text(facts: &TransmissionFacts, unit: &str) -> String {
    let TransmissionFacts {
        group,
        smallest,
        largest,
        ..
    } = facts;
    let angle = |angle: f64| format!("{angle:.MU_DECIMALS$}");
    let (least, most) = (angle(smallest.angle), angle(largest.angle));
    if least == most {
        return format!("transmission angle at {group}: {least} deg throughout");
    }
    let [at_least, at_most] = [smallest.at, largest.at].map(place);
    format!(
        "transmission angle at {group}: smallest {least} deg, at {at_least} {unit}; \
         largest {most} deg, at {at_most} {unit}"
    )
}

/// Where an extreme stands, as a reader looks for it: the limits have their digits elsewhere.
fn place(at: f64) -> String {
    let fixed = format!("{at:.PLACE_DECIMALS$}");
    let short = fixed.trim_end_matches('0').trim_end_matches('.');
    match short {
        "-0" => "0".into(),
        _ => short.into(),
    }
}
