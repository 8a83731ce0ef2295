//! Adds the copies of `[copies]` to the elements of a scene.

use super::placement::{Placement, times, within_a_turn};
use super::{DraftCopy, MAX_COUNT};
use crate::document::Diagnostic;
use crate::nearest::did_you_mean;
use crate::scene::elements::drawn::typed;
use crate::scene::elements::link::{DraftLink, Ends, MAX_LINKS};
use crate::scene::elements::link_points::{self, Sighted};
use crate::scene::elements::points::PlacedPoint;
use crate::scene::elements::slide::{DraftSlide, DraftSlider, Through};
use crate::scene::inputs::input::DraftDriver;
use crate::scene::inputs::timed_inputs::DraftTimed;
use crate::scene::numbers::reader::{MAX_SIZE, Name, Reader, quoted};
use crate::scene::raw_elements::SceneDraft;
use crate::wording::words;
use crate::{Double, Number, Vec2};
use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};

/// Maximum number of copied elements of a scene.
const MAX_COPIED: usize = 3 * MAX_LINKS;

/// The end of the name of a centre of mass.
const CENTRE: &str = ".com";

/// The names of the elements of one copy. They outlive the draft that refers to them.
pub(in crate::scene) type NameSlot = OnceCell<Vec<String>>;

/// Returns an empty slot for the names of each copy. More copies than allowed have none.
pub(in crate::scene) fn name_slots(draft: &SceneDraft<'_>) -> Vec<NameSlot> {
    let count: usize = draft.copies.iter().map(|copy| copy.count).sum();
    (0..count.min(MAX_COUNT)).map(|_| NameSlot::new()).collect()
}

/// Adds all copies to the draft, in the order of the file. `slots` receive their names. Returns the
/// original's name for the name of each copied element.
pub(in crate::scene) fn expand<'t>(
    reader: &mut Reader<'_>,
    draft: &mut SceneDraft<'t>,
    slots: &'t [NameSlot],
) -> HashMap<String, String> {
    let copies = std::mem::take(&mut draft.copies);
    let typed_links = draft.links.len();
    // Names of the group may be defined in an unreadable part.
    draft.unreadable |= draft.lost_points && !copies.is_empty();
    if draft.unreadable {
        return HashMap::new();
    }
    // The counts are added before any name is made, since names need memory.
    let mut count = 0;
    let excess = copies.iter().find(|copy| {
        count += copy.count;
        count > MAX_COUNT
    });
    if let Some(copy) = excess {
        let of = words().copy_called(&copy.name.to_string());
        let fault = Diagnostic::new(words().too_many_copies(&of, MAX_COUNT));
        reader.report(fault.at(copy.name.span.clone(), ""));
        draft.unreadable = true;
        return HashMap::new();
    }
    let mut copier = Copier {
        reader,
        draft,
        typed_links,
        originals: HashMap::new(),
    };
    let mut slots = slots.iter();
    for copy in &copies {
        let slots = slots.by_ref().take(copy.count);
        if !copier.copies(copy, slots) {
            // Further faults would follow from this one.
            copier.draft.unreadable = true;
            break;
        }
    }
    copier.originals
}

/// The elements of a group, as indices into the draft.
struct Group<'t> {
    links: Vec<usize>,
    slides: Vec<usize>,
    /// The points named in `of`.
    named: HashSet<&'t str>,
    /// All points of the links and slides, without duplicates, in the order of the file.
    points: Vec<&'t str>,
}

impl<'t> Group<'t> {
    /// Returns the names of its links and slides.
    fn elements<'d>(&self, draft: &'d SceneDraft<'t>) -> impl Iterator<Item = &'d Name<'t>> {
        let links = self.links.iter().map(|&link| &draft.links[link].name);
        links.chain(self.slides.iter().map(|&slide| &draft.slides[slide].name))
    }
}

/// The role of a point of the group in a copy.
enum PointRole {
    /// The copy has the original's point.
    Shared,
    /// The copy has a point of its own.
    Own,
    /// The copy's point is on the link with this index, which is not in the group.
    Carried(usize),
}

/// A copy being added.
struct Instance<'c, 't> {
    copy: &'c DraftCopy<'t>,
    /// 1 for the first copy.
    number: usize,
    placement: Placement,
    /// The name in the copy for each name of the original that differs.
    renamed: HashMap<&'t str, &'t str>,
}

impl<'t> Instance<'_, 't> {
    /// Returns the copy's name for a name of the original; its place is that of the copy.
    fn name(&self, original: &Name<'t>) -> Name<'t> {
        let text = self.renamed.get(original.text).copied();
        Name {
            text: text.unwrap_or(original.text),
            span: self.copy.name.span.clone(),
        }
    }

    /// Returns the angle by which points on other links are ahead of the original's, in degrees.
    fn phase(&self) -> Double {
        times(self.copy.phase, self.number)
    }
}

/// Adds copies to a draft.
struct Copier<'r, 's, 't> {
    reader: &'r mut Reader<'s>,
    draft: &'r mut SceneDraft<'t>,
    /// The number of links that are no copies.
    typed_links: usize,
    originals: HashMap<String, String>,
}

impl<'t> Copier<'_, '_, 't> {
    /// Adds the copies of a group; returns `false` after a fault.
    fn copies(&mut self, copy: &DraftCopy<'t>, slots: impl Iterator<Item = &'t NameSlot>) -> bool {
        let before = self.reader.found.len();
        let Some(group) = self.group(copy) else {
            return false;
        };
        self.check_joined(copy, &group);
        if copy.phase != 0.0 && !self.check_turned(copy, &group) {
            return false;
        }
        let size = group.links.len() * copy.count;
        if self.draft.links.len() + size > MAX_LINKS {
            let message = words().links_above_most(self.draft.links.len() + size, MAX_LINKS);
            let fault = Diagnostic::new(message);
            self.reader
                .report(fault.at(copy.name.span.clone(), words().are_too_many_links()));
            return false;
        }
        let mut placement = Placement::IDENTITY;
        let mut last = HashMap::new();
        let mut turns_something = false;
        // `phase` does not turn points on links that are copies themselves.
        let on_a_copy = group.points.iter().find_map(|point| {
            let (index, link) = self.other_links(&group, point).next()?;
            let is_fixed = self.draft.ground.iter().any(|p| p.name.text == *point);
            let is_joined = copy.join.iter().any(|(from, _)| from.text == *point);
            let is_own = !is_fixed && !is_joined && index >= self.typed_links;
            is_own.then(|| (quoted(point), link.to_string()))
        });
        for (number, slot) in (1..).zip(slots) {
            placement = placement.then(copy.step);
            let mut instance = Instance {
                copy,
                number,
                placement,
                renamed: HashMap::new(),
            };
            // Each copy is joined to the one before.
            for (from, to) in &copy.join {
                let to = last.get(to.text).copied().unwrap_or(to.text);
                instance.renamed.insert(from.text, to);
            }
            let roles = self.roles(&instance, &group);
            if !self.name(&mut instance, &group, &roles, slot) {
                return false;
            }
            turns_something |= self.add(&instance, &group, &roles);
            last = instance.renamed;
        }
        if let (false, true, Some(phase)) = (turns_something, copy.phase != 0.0, &copy.phase_key) {
            let of = words().copy_called(&copy.name.to_string());
            let fault = match on_a_copy {
                Some((point, link)) => Diagnostic::new(words().phase_on_a_copy(&of, &point, &link))
                    .at(phase.clone(), words().crank_is_a_copy())
                    .help(words().copy_the_original()),
                None => Diagnostic::new(words().phase_turns_nothing(&of))
                    .at(phase.clone(), words().no_point_on_another_link())
                    .help(words().phase_is_for_cranks()),
            };
            self.reader.report(fault);
        }
        self.reader.found.len() == before
    }

    /// Finds the elements of a group; reports unknown names.
    fn group(&mut self, copy: &DraftCopy<'t>) -> Option<Group<'t>> {
        let draft = &*self.draft;
        let mut group = Group {
            links: Vec::new(),
            slides: Vec::new(),
            named: HashSet::new(),
            points: Vec::new(),
        };
        let link_names = draft.links.iter().map(|link| link.name.text);
        let links: HashMap<&str, usize> = link_names.clone().zip(0..).collect();
        let slide_names = draft.slides.iter().map(|slide| slide.name.text);
        let slides: HashMap<&str, usize> = slide_names.clone().zip(0..).collect();
        let points: HashSet<&str> = all_points(draft).map(|name| name.text).collect();
        let mut is_known = true;
        for name in &copy.of {
            if let Some(&link) = links.get(name.text) {
                group.links.push(link);
            } else if let Some(&slide) = slides.get(name.text) {
                group.slides.push(slide);
            } else if points.contains(name.text) {
                group.named.insert(name.text);
            } else {
                let of = words().copy_called(&copy.name.to_string());
                let what = words().key_of("of", &of);
                // In the order of the file, so that each run suggests the same name.
                let point_names = all_points(draft).map(|name| name.text);
                let known = link_names.clone().chain(slide_names.clone());
                let known = known.chain(point_names);
                let near = (!self.reader.is_full()).then(|| did_you_mean(name.text, known));
                self.reader.report(
                    Diagnostic::new(words().no_element_called(&what, &name.to_string()))
                        .at(name.span.clone(), words().no_such_element())
                        .maybe_help(near.flatten()),
                );
                is_known = false;
            }
        }
        for members in [&mut group.links, &mut group.slides] {
            members.sort_unstable();
            members.dedup();
        }
        let mut met = HashSet::new();
        let of_links = group.links.iter().map(|&link| &draft.links[link]);
        let of_slides = group.slides.iter().map(|&slide| &draft.slides[slide]);
        let points = of_links.flat_map(DraftLink::point_names);
        let points = points.chain(of_slides.flat_map(DraftSlide::point_names));
        let named = copy
            .of
            .iter()
            .filter(|name| group.named.contains(name.text));
        let points = points.chain(named).map(|name| name.text);
        group.points = points.filter(|name| met.insert(*name)).collect();
        is_known.then_some(group)
    }

    /// Reports names in `join` that are not points of the group.
    fn check_joined(&mut self, copy: &DraftCopy<'t>, group: &Group<'t>) {
        let of = words().copy_called(&copy.name.to_string());
        for (from, _) in &copy.join {
            if !group.points.contains(&from.text) {
                self.reader.report(
                    Diagnostic::new(words().joins_no_point(&of, &from.to_string()))
                        .at(from.span.clone(), words().not_in_the_group())
                        .maybe_help(did_you_mean(from.text, group.points.iter().copied())),
                );
            }
        }
    }

    /// Reports the first point of the group that `phase` cannot turn, since it is on several links
    /// outside the group and none of them is driven. Returns `false` then.
    fn check_turned(&mut self, copy: &DraftCopy<'t>, group: &Group<'t>) -> bool {
        let draft = &*self.draft;
        let driven = self.driven_link();
        let unturned = group.points.iter().find_map(|point| {
            let is_fixed = draft.ground.iter().any(|fixed| fixed.name.text == *point);
            if is_fixed || copy.join.iter().any(|(from, _)| from.text == *point) {
                return None;
            }
            let links = self.other_links(group, point);
            let links: Vec<_> = links
                .filter(|(index, _)| *index < self.typed_links)
                .collect();
            let is_driven = links.iter().any(|(_, name)| driven == Some(name.text));
            match links[..] {
                [(_, first), (_, second), ..] if !is_driven => Some((point, first, second)),
                _ => None,
            }
        });
        let Some((point, first, second)) = unturned else {
            return true;
        };
        let (of, point) = (words().copy_called(&copy.name.to_string()), quoted(point));
        let [first, second] = [first, second].map(Name::to_string);
        let fault = Diagnostic::new(words().phase_on_two_links(&of, &point, &first, &second));
        let fault = fault.at(copy.phase_place(), words().two_links_could_turn());
        self.reader.report(fault.help(words().copy_one_link_too()));
        false
    }

    /// Returns the links outside the group that have a point, with their indices.
    fn other_links<'d>(
        &'d self,
        group: &'d Group<'t>,
        point: &'d str,
    ) -> impl Iterator<Item = (usize, &'d Name<'t>)> {
        let links = self.draft.links.iter().enumerate();
        let links = links.filter(move |(index, link)| {
            let mut points = link.point_names();
            group.links.binary_search(index).is_err() && points.any(|own| own.text == point)
        });
        links.map(|(index, link)| (index, &link.name))
    }

    /// Returns the name of the driven link.
    fn driven_link(&self) -> Option<&'t str> {
        let driver = self.draft.driver.as_ref()?;
        driver.driven_link().map(|link| link.text)
    }

    /// Returns the role of each point of the group.
    fn roles(&self, instance: &Instance<'_, 't>, group: &Group<'t>) -> Vec<PointRole> {
        // The driven link if it has the point, or else the first link outside the group that does.
        // Other copies do not count: they may be joined to the group, like the stages of a lift.
        let driven = self.driven_link();
        let mut carriers: HashMap<&str, usize> = HashMap::new();
        for (index, link) in self.draft.links[..self.typed_links].iter().enumerate() {
            if group.links.binary_search(&index).is_err() {
                for point in link.point_names() {
                    if driven == Some(link.name.text) {
                        carriers.insert(point.text, index);
                    }
                    carriers.entry(point.text).or_insert(index);
                }
            }
        }
        let ground = self.draft.ground.iter();
        let ground: HashMap<&str, Vec2> = ground.map(|p| (p.name.text, p.at())).collect();
        let role = |point: &&'t str| {
            let is_named = group.named.contains(point);
            if instance.renamed.contains_key(point) {
                return PointRole::Shared;
            }
            match (ground.get(point), carriers.get(point)) {
                (Some(&at), _) if !is_named && instance.placement.keeps(at) => PointRole::Shared,
                (Some(_), _) | (None, None) => PointRole::Own,
                (None, Some(&link)) if instance.phase().hi != 0.0 => PointRole::Carried(link),
                (None, Some(_)) if is_named => PointRole::Own,
                (None, Some(_)) => PointRole::Shared,
            }
        };
        group.points.iter().map(role).collect()
    }

    /// Names all elements of a copy; returns `false` if a name is in use.
    fn name(
        &mut self,
        instance: &mut Instance<'_, 't>,
        group: &Group<'t>,
        roles: &[PointRole],
        slot: &'t NameSlot,
    ) -> bool {
        let draft = &*self.draft;
        let points = group.points.iter().zip(roles);
        let points = points.filter(|(_, role)| !matches!(role, PointRole::Shared));
        let elements = group.elements(draft).map(|name| name.text);
        let elements = elements.chain(points.map(|(point, _)| *point));
        // The start of a centre of mass has the name of its link.
        let centres = draft.start.iter().map(|place| place.name.text);
        let centres = centres.filter(|name| {
            let link = name.strip_suffix(CENTRE);
            link.is_some_and(|link| {
                let mut links = group.links.iter();
                links.any(|&own| draft.links[own].name.text == link)
            })
        });
        let originals: Vec<&'t str> = elements.chain(centres).collect();
        let suffix = Suffix::of(instance.copy, instance.number);
        let names =
            slot.get_or_init(|| originals.iter().map(|name| suffix.applied(name)).collect());
        let of = words().copy_called(&instance.copy.name.to_string());
        if self.originals.len() + names.len() > MAX_COPIED {
            self.reader.report(
                Diagnostic::new(words().too_many_copied(&of, MAX_COPIED))
                    .at(instance.copy.name.span.clone(), words().too_many_elements()),
            );
            return false;
        }
        let links = draft.links.iter().map(|link| &link.name);
        let slides = draft.slides.iter().map(|slide| &slide.name);
        let ground = draft.ground.iter().map(|point| &point.name);
        let taken = links.chain(slides).chain(ground);
        let taken: HashMap<&str, &Name<'_>> = taken.map(|name| (name.text, name)).collect();
        for (original, name) in originals.into_iter().zip(names) {
            let before = taken.get(&**name);
            if before.is_some() || self.originals.contains_key(name) {
                let message = words().name_of_copy_is_taken(&of, &quoted(original), &quoted(name));
                let fault = Diagnostic::new(message).at(instance.copy.name.span.clone(), "");
                let fault = match before {
                    Some(before) => fault.and(before.span.clone(), words().once_here()),
                    None => fault,
                };
                self.reader
                    .report(fault.help(words().choose_another_suffix()));
                return false;
            }
            instance.renamed.insert(original, name);
            self.originals.insert(name.clone(), original.to_owned());
        }
        true
    }

    /// Adds the elements of a copy. Returns `true` if its phase has an effect.
    fn add(&mut self, instance: &Instance<'_, 't>, group: &Group<'t>, roles: &[PointRole]) -> bool {
        let mut turns_something = false;
        for (point, role) in group.points.iter().zip(roles) {
            match *role {
                PointRole::Shared | PointRole::Own => {}
                PointRole::Carried(link) => {
                    self.carried_point(instance, point, link);
                    turns_something = true;
                }
            }
        }
        self.placed_points(instance, group, roles);
        for &link in &group.links {
            let link = copied_link(instance, &self.draft.links[link]);
            self.draft.links.push(link);
        }
        for &slide in &group.slides {
            let (slide, is_turned) = self.copied_slide(instance, group, slide);
            self.draft.slides.push(slide);
            turns_something |= is_turned;
        }
        self.check_inputs(instance, group);
        turns_something | self.copied_input(instance, group)
    }

    /// Reports inputs of the group whose copies follow nothing: those of `[inputs]`, and a driver
    /// with `from`.
    fn check_inputs(&mut self, instance: &Instance<'_, 't>, group: &Group<'t>) {
        let draft = &*self.draft;
        let relative = draft.driver.iter().filter(|driver| driver.from.is_some());
        let relative = relative.map(DraftDriver::driven);
        let inputs = relative.chain(draft.timed.iter().map(|timed| &timed.name));
        let elements: HashSet<&str> = group.elements(draft).map(|name| name.text).collect();
        let followed = |name: &Name<'_>| {
            let copied = instance.name(name);
            draft
                .timed
                .iter()
                .any(|timed| timed.name.text == copied.text)
        };
        let mut inputs = inputs.filter(|name| elements.contains(name.text));
        let Some(name) = inputs.find(|name| !followed(name)) else {
            return;
        };
        let of = words().copy_called(&instance.copy.name.to_string());
        let copied = instance.name(name).to_string();
        let fault = Diagnostic::new(words().copied_input_has_no_motion(&of, &copied));
        self.reader.report(
            fault
                .at(instance.copy.name.span.clone(), words().copies_an_input())
                .help(words().give_the_copy_an_input(&copied)),
        );
    }

    /// Rounds a position in a copy; reports one that is too far away.
    fn rounded(&mut self, instance: &Instance<'_, 't>, at: Vec2<Double>) -> Vec2 {
        let at = at.map(|v| self.reader.rounded(v));
        // A comparison that also rejects NaN.
        if !(at.x.abs() <= MAX_SIZE && at.y.abs() <= MAX_SIZE) {
            let of = words().copy_called(&instance.copy.name.to_string());
            let fault = Diagnostic::new(words().copy_is_too_far(&of));
            self.reader
                .report(fault.at(instance.copy.name.span.clone(), words().is_too_large()));
            return Vec2::ZERO;
        }
        at
    }

    /// Adds a point on a link outside the group, turned about the link's origin by the phase.
    fn carried_point(&mut self, instance: &Instance<'_, 't>, point: &'t str, index: usize) {
        let link = &self.draft.links[index];
        let origin = link.ends.as_ref().map(|ends| ends.from.text);
        let own = link.points.iter().find(|own| own.name.text == point);
        let name = Name {
            text: instance.renamed.get(point).copied().unwrap_or(point),
            span: instance.copy.name.span.clone(),
        };
        let mut copied = PlacedPoint::new(name, None);
        let turned = |reader: &mut Reader<'_>, length: f64, angle: f64| Sighted {
            from: None,
            length,
            angle: reader.rounded(within_a_turn(decimal(angle) + instance.phase())),
        };
        match (own, &link.ends) {
            _ if origin == Some(point) => return self.phase_at_origin(instance, point),
            (None, Some(ends)) => copied.sighted = Some(turned(self.reader, ends.length, 0.0)),
            (None, None) => {}
            (Some(own), _) => match &own.sighted {
                Some(polar) if polar.from.as_ref().is_none_or(|f| Some(f.text) == origin) => {
                    copied.sighted = Some(turned(self.reader, polar.length, polar.angle));
                }
                _ if own.read == Some(Vec2::ZERO) => {
                    return self.phase_at_origin(instance, point);
                }
                _ => {
                    let at = own
                        .read
                        .map(|at| typed(at).turned(Number::unit(instance.phase())));
                    copied.read = at.map(|at| self.rounded(instance, at));
                }
            },
        }
        let link = &mut self.draft.links[index];
        if !link.broken {
            link.points.push(copied);
            let of = words().link_called(&link.name.to_string());
            link_points::compute_places(self.reader, &of, link);
        }
    }

    fn phase_at_origin(&mut self, instance: &Instance<'_, 't>, point: &str) {
        let of = words().copy_called(&instance.copy.name.to_string());
        self.reader.report(
            Diagnostic::new(words().phase_at_origin(&of, &quoted(point)))
                .at(
                    instance.copy.phase_place(),
                    words().turns_about_the_origin(),
                )
                .help(words().begin_crank_at_pivot()),
        );
    }

    /// Returns `true` if the whole copy opens as the placed original. It does not with a phase or an
    /// input of its own, or if it shares a moving point, such as a crank pin. Points of `join` are
    /// where the file wants them.
    fn is_rigid(
        &self,
        instance: &Instance<'_, 't>,
        group: &Group<'t>,
        roles: &[PointRole],
    ) -> bool {
        let draft = &*self.draft;
        let is_fixed = |point: &str| draft.ground.iter().any(|p| p.name.text == point);
        let has_input = |name: &Name<'t>| {
            let name = instance.name(name);
            draft.timed.iter().any(|own| own.name.text == name.text)
        };
        let stays = |(point, role): (&&str, &PointRole)| match role {
            PointRole::Own => true,
            PointRole::Shared => instance.renamed.contains_key(point) || is_fixed(point),
            PointRole::Carried(_) => false,
        };
        instance.phase().hi == 0.0
            && !group.elements(draft).any(has_input)
            && group.points.iter().zip(roles).all(stays)
    }

    /// Adds the points of the ground, and the positions in `[start]` except those that the file has.
    ///
    /// The original's positions do not tell the assembly of a copy that is not rigid: krank then asks
    /// for positions in the file, as for any group with two assemblies.
    fn placed_points(
        &mut self,
        instance: &Instance<'_, 't>,
        group: &Group<'t>,
        roles: &[PointRole],
    ) {
        let points = group.points.iter().zip(roles);
        let points = points.filter(|(_, role)| matches!(role, PointRole::Own));
        let own: HashSet<&str> = points.map(|(point, _)| *point).collect();
        let is_own = |place: &&PlacedPoint<'t>| own.contains(place.name.text);
        let fixed: Vec<_> = self.draft.ground.iter().filter(is_own).cloned().collect();
        for original in fixed {
            let copied = self.placed(instance, &original);
            if self.draft.marks.contains(original.name.text) {
                self.draft.marks.insert(copied.name.text);
            }
            self.draft.ground.push(copied);
        }
        if !self.is_rigid(instance, group, roles) {
            return;
        }
        let given = self.draft.start.iter();
        let given: HashSet<&str> = given.map(|place| place.name.text).collect();
        let is_copied = |place: &&PlacedPoint<'t>| {
            let name = place.name.text;
            let is_centre = name.ends_with(CENTRE) && instance.renamed.contains_key(name);
            (is_own(place) || is_centre) && !given.contains(instance.name(&place.name).text)
        };
        let rough: Vec<_> = self.draft.start.iter().filter(is_copied).cloned().collect();
        for original in rough {
            let copied = self.placed(instance, &original);
            self.draft.start.push(copied);
        }
    }

    /// Returns the copy of a point with a position in the ground's frame.
    fn placed(
        &mut self,
        instance: &Instance<'_, 't>,
        original: &PlacedPoint<'t>,
    ) -> PlacedPoint<'t> {
        let position = |at| instance.placement.position(at);
        let read = original.read.map(|at| self.rounded(instance, position(at)));
        PlacedPoint::new(instance.name(&original.name), read)
    }

    /// Copies a slide. Returns `true` if its guide is turned by the phase.
    fn copied_slide(
        &mut self,
        instance: &Instance<'_, 't>,
        group: &Group<'t>,
        slide: usize,
    ) -> (DraftSlide<'t>, bool) {
        let draft = &*self.draft;
        let in_group = |name: &Name<'_>| {
            let mut links = group.links.iter();
            links.any(|&link| draft.links[link].name.text == name.text)
        };
        let original = &draft.slides[slide];
        let slider = original.slider.as_ref().map(|slider| match slider {
            DraftSlider::Pin(point) => DraftSlider::Pin(instance.name(point)),
            DraftSlider::Link { link, turn } => DraftSlider::Link {
                turn: match in_group(link) {
                    true => instance.placement.local_angle(*turn),
                    false => *turn,
                },
                link: instance.name(link),
            },
        });
        let on = original.on.as_ref();
        let is_on_group = on.is_some_and(in_group);
        let is_on_ground = on.is_some_and(|on| on.text == "ground");
        let is_turned = !is_on_group && !is_on_ground && instance.phase().hi != 0.0;
        let angle = if is_on_ground {
            instance.placement.direction(decimal(original.angle))
        } else if is_on_group {
            Double::exactly(instance.placement.local_angle(original.angle))
        } else {
            decimal(original.angle) + instance.phase()
        };
        let (through, on) = (original.through.clone(), on.map(|on| instance.name(on)));
        let (name, tolerance) = (instance.name(&original.name), original.tolerance.clone());
        let through = through.map(|through| match through {
            Through::Point(point) => Through::Point(instance.name(&point)),
            Through::At(at) if is_on_ground => {
                Through::At(self.rounded(instance, instance.placement.position(at)))
            }
            Through::At(at) if is_on_group => Through::At(instance.placement.reflected(at)),
            Through::At(at) if is_turned => {
                let turned = typed(at).turned(Number::unit(instance.phase()));
                Through::At(self.rounded(instance, turned))
            }
            Through::At(at) => Through::At(at),
        });
        let copied = DraftSlide {
            name,
            slider,
            on,
            through,
            angle: self.reader.rounded(within_a_turn(angle)),
            tolerance,
        };
        (copied, is_turned)
    }

    /// Lets the copy of the driven link or slide follow the driver, unless the file has an input for
    /// it. Returns `true` if the copy has the driven link.
    fn copied_input(&mut self, instance: &Instance<'_, 't>, group: &Group<'t>) -> bool {
        let Some(driver) = &self.draft.driver else {
            return false;
        };
        let (driven, is_link) = (driver.driven(), driver.driven_link().is_some());
        let is_copied = group
            .elements(self.draft)
            .any(|name| name.text == driven.text);
        if !is_copied || driver.from.is_some() {
            return false;
        }
        let name = instance.name(driven);
        let mut timed = self.draft.timed.iter();
        if timed.any(|timed| timed.name.text == name.text) {
            return is_link;
        }
        let (ratio, phase) = match is_link {
            true => {
                let zero = instance.placement.direction(Double::ZERO);
                (
                    instance.placement.local_angle(1.0),
                    within_a_turn(zero + instance.phase()),
                )
            }
            false => (1.0, Double::ZERO),
        };
        let phase = self.reader.rounded(phase);
        let timed = DraftTimed::following(name, ratio, phase);
        self.draft.timed.push(timed);
        is_link
    }
}

/// Returns the typed decimal of an angle.
fn decimal(angle: f64) -> Double {
    times(angle, 1)
}

/// Returns the copy of a link: its shape is that of the original, or its mirror image.
fn copied_link<'t>(instance: &Instance<'_, 't>, link: &DraftLink<'t>) -> DraftLink<'t> {
    let placement = &instance.placement;
    let point = |point: &PlacedPoint<'t>| {
        let sighted = point.sighted.as_ref().map(|polar| Sighted {
            from: polar.from.as_ref().map(|from| instance.name(from)),
            length: polar.length,
            angle: placement.local_angle(polar.angle),
        });
        PlacedPoint {
            sighted,
            ..PlacedPoint::new(
                instance.name(&point.name),
                point.read.map(|at| placement.reflected(at)),
            )
        }
    };
    let ends = link.ends.as_ref().map(|ends| Ends {
        from: instance.name(&ends.from),
        to: instance.name(&ends.to),
        length: ends.length,
    });
    let direction = link
        .direction
        .map(|angle| placement.direction(decimal(angle)));
    DraftLink {
        name: instance.name(&link.name),
        ends,
        direction: direction.map(|angle| within_a_turn(angle).hi),
        points: link.points.iter().map(point).collect(),
        com: link.com.as_ref().map(point),
        has_lost_points: false,
        ..link.clone()
    }
}

/// Returns every name of a point.
fn all_points<'d, 't>(draft: &'d SceneDraft<'t>) -> impl Iterator<Item = &'d Name<'t>> {
    let links = draft.links.iter().flat_map(DraftLink::point_names);
    let slides = draft.slides.iter().flat_map(DraftSlide::point_names);
    let ground = draft.ground.iter().map(|point| &point.name);
    links.chain(slides).chain(ground)
}

/// Forms the names of a copy.
enum Suffix {
    /// A number, which replaces the number at the end of a name.
    Number(u64),
    /// A text, which is appended.
    Text(String),
}

impl Suffix {
    /// Returns the suffix of a copy by its key and its number in the group of copies.
    fn of(copy: &DraftCopy<'_>, number: usize) -> Suffix {
        let key = copy.name.text;
        let first = key.parse::<u32>().ok();
        let first = first.filter(|_| key.bytes().all(|byte| byte.is_ascii_digit()));
        match first {
            Some(first) => Suffix::Number(u64::from(first) + number as u64 - 1),
            None if number == 1 => Suffix::Text(format!("_{key}")),
            None => Suffix::Text(format!("_{key}{number}")),
        }
    }

    /// Returns the name in the copy; a centre of mass keeps its ending.
    fn applied(&self, name: &str) -> String {
        let (name, end) = match name.strip_suffix(CENTRE) {
            Some(name) => (name, CENTRE),
            None => (name, ""),
        };
        match self {
            Suffix::Number(number) => {
                let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
                format!("{stem}{number}{end}")
            }
            Suffix::Text(text) => format!("{name}{text}{end}"),
        }
    }
}
