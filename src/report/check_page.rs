//! Formats the facts of `check` as a page.

use super::check::{
    Check, ConditionFacts, DriverFacts, DriverKind, GroupFacts, JointFacts, ParameterFacts,
    RedundancyFacts, TransmissionFacts,
};
use super::motion_facts::MotionFacts;
use super::number::concise;
use super::range_text::{DECIMALS, errors_text, limit_text};
use super::slide_facts::SlideFacts;
use super::stop_facts::UnmetLimit;
use crate::page::{Content, Facts, Page, TextStyle};
use crate::scene::from_seat;
use crate::wording::words;

/// Widths of the names, and of the indent of further lines of a fact.
const NAMES: usize = 11;
const FURTHER: usize = 2;
/// Decimals of a transmission angle.
const MU_DECIMALS: usize = 4;
/// Maximum number of decimals of a place.
const PLACE_DECIMALS: usize = 6;
/// Significant digits of the driver's rates: the default of tables.
const DIGITS: usize = 6;
/// Maximum number of names in a list of repeated elements.
const MAX_NAMES: usize = 12;
/// Significant digits of a condition.
const CONDITION_DIGITS: usize = 3;
/// Significant digits of a misfit.
const MISFIT_DIGITS: usize = 2;

impl Check {
    /// Formats the facts as text. `ascii` restricts titles and notes to ASCII; the rest always is.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the facts as a page of names and values.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut facts = Facts {
            names: NAMES,
            hanging: FURTHER,
            list: Vec::new(),
        };
        let told =
            |text: &Option<String>| text.as_deref().map(|it| words().translated_scene_text(it));
        facts.tell(words().fact_source(), told(&self.source));
        facts.tell(words().fact_note(), told(&self.note));
        facts.tell(words().fact_unit(), [self.unit.to_owned()]);
        let parameters = self.parameters.iter().map(ParameterFacts::text);
        facts.tell(words().fact_parameters(), parameters);
        facts.tell(words().fact_parts(), [self.counts()]);
        let inputs = self
            .inputs
            .iter()
            .map(|input| input.text(self.driver.kind, self.unit));
        facts.tell(
            words().fact_driver(),
            [self.driver_text()].into_iter().chain(inputs),
        );
        facts.tell(
            words().fact_motion(),
            self.motion.iter().flat_map(MotionFacts::texts),
        );
        facts.tell(words().fact_links(), [self.links.join(", ")]);
        facts.tell(words().fact_joints(), self.joints.iter().map(joint_text));
        facts.tell(
            words().fact_slides(),
            self.slides.iter().flat_map(SlideFacts::texts),
        );
        let mobility = [self.mobility_text()].into_iter().chain(self.rank_notes());
        facts.tell(words().fact_mobility(), mobility);
        let redundant = self.redundancies.iter().map(|r| self.redundancy_text(r));
        facts.tell(words().fact_redundant(), redundant);
        let groups = self.groups.iter().enumerate();
        let groups = groups.map(|(i, group)| format!("{}. {}", i + 1, self.group_text(group)));
        facts.tell(words().fact_groups(), groups);
        facts.tell(words().fact_choices(), self.choices.group_lines());
        facts.tell(words().fact_assemblies(), self.choices.whole_text());
        if let Some(first) = &self.first_loop {
            facts.tell(words().fact_loop(), first.lines(self.unit));
        }
        let unit = self.driver_unit();
        let errors = (self.period.is_none()).then(|| errors_text(self.range_bounds, unit));
        let range = [self.range_text.clone()].into_iter().chain(errors);
        facts.tell(words().fact_range(), range);
        let stops = self.stops.iter();
        let stops = stops.map(|stop| stop.text(&limit_text(stop.at), unit));
        let unmet = self.unmet.iter().map(UnmetLimit::text);
        facts.tell(words().fact_stops(), stops.chain(unmet));
        if !self.change_points.is_empty() {
            facts.tell(
                words().fact_change(),
                [self.change_points_text(), self.tolerance_text()],
            );
        }
        facts.tell(
            words().fact_change(),
            self.lined_up.iter().map(|end| end.text(unit)),
        );
        facts.tell(
            words().fact_near_miss(),
            self.near_misses.iter().map(|m| m.text(unit)),
        );
        let angles = self.transmission.iter().map(|t| transmission_text(t, unit));
        facts.tell(words().fact_transmission(), angles);
        let conditions = self.condition.iter().map(|c| condition_text(c, unit));
        facts.tell(words().fact_condition(), conditions);
        facts.tell(words().fact_figures(), self.figure_lines.iter().cloned());
        let dead = self.dead_knots.iter().map(|dead| {
            let unit = self.driver_unit();
            let at: Vec<String> = dead.at.iter().map(|at| place_text(*at, unit)).collect();
            words().knots_outside(&dead.on, &at.join(", "))
        });
        facts.tell(
            words().fact_forces(),
            self.acting_text().into_iter().chain(dead),
        );
        if !self.indeterminate.is_empty() {
            facts.tell(words().fact_open(), [self.open_text()]);
        }
        let mut page = Page::default();
        page.title(&words().translated_scene_text(&self.scene));
        page.add_below(Content::Facts(facts));
        page
    }

    /// Describes the loads, if there are any.
    fn acting_text(&self) -> Option<String> {
        let acting = &self.acting;
        let kinds = [
            (acting.forces, words().count_of_forces(acting.forces)),
            (acting.torques, words().count_of_torques(acting.torques)),
            (acting.presses, words().count_of_presses(acting.presses)),
            (acting.springs, words().count_of_springs(acting.springs)),
            (acting.masses, words().count_of_masses(acting.masses)),
        ];
        let kinds = kinds.into_iter().filter(|(count, _)| *count > 0);
        let mut told: Vec<String> = kinds.map(|(_, told)| told).collect();
        if acting.gravity && acting.masses > 0 {
            told.push(words().gravity().into());
        }
        let told = (!told.is_empty()).then(|| told.join(", "))?;
        Some(match acting.period {
            Some(period) => words().repeated_after(&told, &period),
            None => told,
        })
    }

    fn open_text(&self) -> String {
        words().not_settled(&self.indeterminate.join(", "))
    }

    fn change_points_text(&self) -> String {
        let unit = self.driver_unit();
        let at = self
            .change_points
            .iter()
            .map(|at| format!("{at:.DECIMALS$}"));
        let at: Vec<String> = at.collect();
        words().change_points_at(&at.join(", "), unit)
    }

    /// Explains the tolerance that distinguishes a change point from a near miss.
    fn tolerance_text(&self) -> String {
        if self.tolerance == 0.0 {
            return words().equal_as_typed().into();
        }
        words().equal_within(&format!("{:.1e}", self.tolerance), self.unit)
    }

    fn driver_unit(&self) -> &'static str {
        match self.driver.kind {
            DriverKind::Link => "deg",
            DriverKind::Slide => self.unit,
        }
    }

    fn counts(&self) -> String {
        words().parts_and_ground(self.links.len(), self.pins(), self.slides.len())
    }

    /// Returns the number of pin joints: a point shared by n bodies counts as n - 1.
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
        let start = format!("{} {coordinate}", concise(*start, usize::MAX));
        if self.motion.is_some() {
            return words().driver_opens_at(&driven, &start);
        }
        // Rates converted from rpm or deg/s may have meaningless digits.
        let [speed, acceleration] = [speed, acceleration].map(|v| concise(*v, DIGITS));
        words().driver_opens(
            &driven,
            &start,
            &format!("{speed} {rate}/s"),
            &format!("{acceleration} {rate}/s^2"),
        )
    }

    fn driven(&self) -> String {
        let name = from_seat(&self.driver.name, self.driver.from.as_deref());
        self.driver.kind.named(&name)
    }

    fn group_text(&self, group: &GroupFacts) -> String {
        let at = group.point.as_deref();
        let (what, how) = match (group.kind.class(), group.kind.unknowns()) {
            (Some(class), _) => {
                let dyad = match at {
                    Some(point) => words().dyad_at(class, point),
                    None => words().dyad(class),
                };
                (dyad, words().closed_form())
            }
            (None, Some(unknowns)) => {
                let coupled = match at {
                    Some(point) => words().coupled_group_at(point, unknowns),
                    None => words().coupled_group(unknowns),
                };
                (coupled, words().by_newton())
            }
            (None, None) => return words().group_of_driver(&self.driven()),
        };
        match group.links.as_slice() {
            [] => words().group_of_nothing(&what, how),
            [link] => words().group_of_link(&what, link, how),
            links => words().group_of_links(&what, &links.join(", "), how),
        }
    }

    fn mobility_text(&self) -> String {
        if self.redundant.is_empty() {
            return self.mobility.to_string();
        }
        let constraints = self.redundancies.iter().map(|r| r.constraints).sum();
        let which = self.redundant.join(", ");
        words().mobility_set_aside(&self.mobility, constraints, &which)
    }

    fn rank_notes(&self) -> impl Iterator<Item = String> {
        let unclear = self
            .mobility_is_unclear
            .then(|| words().mobility_not_certain());
        let lower = self
            .opens_at_change_point
            .then(|| words().mobility_more_at_opening());
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
            [] => words().repeats_others(element),
            repeats if repeats.len() > MAX_NAMES => {
                let some = repeats[..MAX_NAMES].join(", ");
                let more = repeats.len() - MAX_NAMES;
                words().repeats(element, &words().some_and_more(&some, more))
            }
            repeats => words().repeats(element, &repeats.join(", ")),
        };
        words().disagree_by(&what, &misfit)
    }
}

fn joint_text(joint: &JointFacts) -> String {
    let bodies = joint.bodies.iter().map(|body| words().body_called(body));
    let bodies: Vec<String> = bodies.collect();
    format!("{}: {}", joint.point, bodies.join(", "))
}

/// Formats the transmission angle of a dyad: minimum and maximum, or its constant value.
fn transmission_text(facts: &TransmissionFacts, unit: &str) -> String {
    let TransmissionFacts {
        group,
        smallest,
        largest,
        ..
    } = facts;
    let angle = |angle: f64| format!("{angle:.MU_DECIMALS$}");
    let (least, most) = (angle(smallest.angle), angle(largest.angle));
    if least == most {
        return words().transmission_throughout(group, &least);
    }
    let [at_least, at_most] = [smallest.at, largest.at].map(place);
    words().transmission_between(group, [&least, &at_least, &most, &at_most], unit)
}

/// Formats the worst condition of a coupled group.
pub(super) fn condition_text(facts: &ConditionFacts, unit: &str) -> String {
    let magnified = concise(1.0 / facts.least, CONDITION_DIGITS);
    words().condition_at(&facts.group, &magnified, &place_text(facts.at, unit))
}

/// Formats a coordinate with its unit.
pub(super) fn place_text(at: f64, unit: &str) -> String {
    format!("{} {unit}", place(at))
}

/// Formats the place of an extremum with few digits; exact limits are shown elsewhere.
fn place(at: f64) -> String {
    let fixed = format!("{at:.PLACE_DECIMALS$}");
    let short = fixed.trim_end_matches('0').trim_end_matches('.');
    match short {
        "-0" => "0".into(),
        _ => short.into(),
    }
}
