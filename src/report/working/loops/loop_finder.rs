//! Finds the vector polygons from the structure of a scene.
//!
//! Bodies and points are the nodes of a graph. Edges join a body to every point that it carries,
//! and a guide's body to the point that slides on it. The edges are added in the order in which the
//! solver places them. An edge between nodes that are already connected closes a loop, the shortest
//! one at that time. So every group of the plan has the loops from which it is solved.

use super::polygon::{Loop, Polygon, Term, diagonal};
use super::sides::{Locks, Side, SideShape, Turns};
use crate::scene::{Scene, VectorKind};
use crate::solver::Plan;
use crate::{Body, LinkId, PointId, SlideId, Vec2, angle};
use std::collections::{HashMap, HashSet, VecDeque};

/// The place at which a loop enters or leaves a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Port {
    Point(PointId),
    Through(SlideId),
}

/// An edge between a body and a point.
#[derive(Clone, Copy, Debug)]
struct Edge {
    body: usize,
    point: usize,
    slide: Option<SlideId>,
    /// The group that places both.
    order: usize,
}

/// Builds the polygons of a scene.
struct LoopBuilder<'a> {
    scene: &'a Scene,
    locks: Locks,
    sides: Vec<Side>,
    /// The sides between two ports of a body, in both directions.
    known: HashMap<(usize, Port, Port), Term>,
    /// The invented names of unnamed points of guides.
    guides: HashMap<SlideId, String>,
    /// The names of the scene and all invented ones.
    taken: HashSet<String>,
    /// The indices of the edges at every node.
    ends: Vec<Vec<usize>>,
    edges: Vec<Edge>,
}

impl Polygon {
    /// Finds the polygons of a scene.
    pub(crate) fn of(scene: &Scene, plan: &Plan) -> Polygon {
        let mut loop_builder = LoopBuilder::new(scene);
        let mut loops = Vec::new();
        for edge in loop_builder.ordered_edges(plan) {
            if let Some(path) = loop_builder.path(edge.point, edge.body) {
                let terms = loop_builder.terms(&path, Some(edge));
                loops.push((terms, Some(edge.order)));
            }
            loop_builder.join(edge);
        }
        for (terms, _) in &mut loops {
            loop_builder.orient(terms);
        }
        loop_builder.turn_unnamed(&mut loops);
        for (terms, _) in &mut loops {
            loop_builder.rotate_to_frame(terms);
        }
        loops.extend(loop_builder.free_loops());
        let loops = loops.into_iter().filter(|(terms, _)| terms.len() > 1);
        Polygon {
            loops: loops.map(|(terms, group)| Loop { terms, group }).collect(),
            diagonal: diagonal(scene, &loop_builder.sides),
            sides: loop_builder.sides,
            locks: loop_builder.locks,
        }
    }
}

impl<'a> LoopBuilder<'a> {
    fn new(scene: &'a Scene) -> Self {
        let mechanism = &scene.mechanism;
        let nodes = mechanism.links().len() + 1 + mechanism.points().len();
        let mut loop_builder = LoopBuilder {
            scene,
            locks: Locks::of(mechanism),
            sides: Vec::new(),
            known: HashMap::new(),
            guides: HashMap::new(),
            taken: taken(scene),
            ends: vec![Vec::new(); nodes],
            edges: Vec::new(),
        };
        loop_builder.name_guides();
        loop_builder.list_sides();
        loop_builder
    }

    // ---- names

    /// Invents names for the unnamed points of guides: Q, or Q1, Q2 and so on.
    fn name_guides(&mut self) {
        let mechanism = &self.scene.mechanism;
        let unnamed: Vec<SlideId> = mechanism
            .slide_ids()
            .filter(|&slide| mechanism.slide(slide).named.is_none())
            .collect();
        for (i, &slide) in unnamed.iter().enumerate() {
            let mut name = if unnamed.len() == 1 {
                "Q".to_owned()
            } else {
                format!("Q{}", i + 1)
            };
            while !self.taken.insert(name.clone()) {
                name.push('\'');
            }
            self.guides.insert(slide, name);
        }
    }

    fn point_label(&self, point: PointId) -> String {
        let name = self.scene.point_name(point);
        name.map_or_else(|| format!("P{}", point.index() + 1), str::to_owned)
    }

    fn label(&self, port: Port) -> String {
        match port {
            Port::Point(point) => self.point_label(point),
            Port::Through(slide) => self.guides.get(&slide).cloned().unwrap_or_default(),
        }
    }

    // ---- sides

    fn list_sides(&mut self) {
        let scene = self.scene;
        for vector in &scene.vectors {
            let [tail, head] = self.vector_ends(vector.kind);
            let labels = [tail, head].map(|port| self.label(port));
            let [from, to] = labels;
            let side = Side::of(scene, vector, &self.locks, from, to);
            let number = self.sides.len();
            if let Some(body) = self.body_of(side.shape) {
                self.remember(body, tail, head, number);
            }
            self.sides.push(side);
        }
    }

    fn vector_ends(&self, kind: VectorKind) -> [Port; 2] {
        let mechanism = &self.scene.mechanism;
        match kind {
            VectorKind::Link(link) => {
                let ends = mechanism.link(link).ends;
                // Vectors are listed only for links with two ends.
                let (from, to) = ends.unwrap_or((PointId::new(0), PointId::new(0)));
                [from, to].map(Port::Point)
            }
            VectorKind::Slide(slide) => {
                let point = mechanism.slide(slide).slider.point();
                [Port::Point(point), self.through(slide)]
            }
            VectorKind::Between(tail, head) => [tail, head].map(Port::Point),
        }
    }

    /// Returns the body that carries both ends of a side; `None` for slides and vectors between two
    /// bodies.
    fn body_of(&self, shape: SideShape) -> Option<usize> {
        match shape {
            SideShape::Link(link) => Some(link.index()),
            SideShape::Rigid(body, _) => Some(self.body(body)),
            SideShape::Slide(_) | SideShape::Free(..) => None,
        }
    }

    fn remember(&mut self, body: usize, tail: Port, head: Port, side: usize) {
        for (from, to, reversed) in [(tail, head, false), (head, tail, true)] {
            let term = Term { side, reversed };
            self.known.entry((body, from, to)).or_insert(term);
        }
    }

    /// Returns the origin of a guide: a named point, or its own.
    fn through(&self, slide: SlideId) -> Port {
        let named = self.scene.mechanism.slide(slide).named;
        named.map_or(Port::Through(slide), Port::Point)
    }

    fn ground(&self) -> usize {
        self.scene.mechanism.links().len()
    }

    fn body(&self, body: Body) -> usize {
        match body {
            Body::Ground => self.ground(),
            Body::Link(link) => link.index(),
        }
    }

    fn point_node(&self, point: PointId) -> usize {
        self.ground() + 1 + point.index()
    }

    /// Returns the coordinates of a port in the frame of its body.
    fn local(&self, body: usize, port: Port) -> Option<Vec2> {
        let mechanism = &self.scene.mechanism;
        match port {
            Port::Through(slide) => Some(mechanism.slide(slide).through),
            Port::Point(point) if body == self.ground() => mechanism.point(point).ground,
            Port::Point(point) => mechanism.links().get(body)?.local(point),
        }
    }

    /// Returns the side inside a body from one port to the other; `None` if both coincide.
    fn inside(&mut self, body: usize, from: Port, to: Port) -> Option<Term> {
        if from == to {
            return None;
        }
        if let Some(&term) = self.known.get(&(body, from, to)) {
            return Some(term);
        }
        let local = self.local(body, to)? - self.local(body, from)?;
        if local == Vec2::ZERO {
            return None;
        }
        let on = if body == self.ground() {
            Body::Ground
        } else {
            Body::Link(LinkId::new(body))
        };
        let (tail, head) = (self.label(from), self.label(to));
        let side = Side {
            name: self.take_name(&tail, &head),
            tail,
            head,
            shape: SideShape::Rigid(on, local),
            turns: self.locks.turns(on, angle::degrees(local)),
            named: false,
        };
        self.remember(body, from, to, self.sides.len());
        self.sides.push(side);
        self.known.get(&(body, from, to)).copied()
    }

    /// Reserves a name for a side without a name in the scene, composed of its ends: BK.
    fn take_name(&mut self, tail: &str, head: &str) -> String {
        let between = if tail.len() + head.len() <= 4 {
            ""
        } else {
            "_"
        };
        let mut name = format!("{tail}{between}{head}");
        while !self.taken.insert(name.clone()) {
            name.push('\'');
        }
        name
    }

    // ---- the graph

    /// Returns all edges in the order of the groups that place them. Slides come last in their
    /// group, so that they close the loops.
    fn ordered_edges(&self, plan: &Plan) -> Vec<Edge> {
        let mechanism = &self.scene.mechanism;
        let mut order = vec![0; self.ends.len()];
        for (number, group) in plan.groups.iter().enumerate().rev() {
            for &link in &group.links {
                order[link.index()] = number;
            }
            for &point in &group.points {
                order[self.point_node(point)] = number;
            }
        }
        let mut edges = Vec::new();
        let mut add = |body: usize, point: usize, slide: Option<SlideId>| {
            let order = order[body].max(order[point]);
            edges.push(Edge {
                body,
                point,
                slide,
                order,
            });
        };
        for point in mechanism.point_ids() {
            if mechanism.point(point).ground.is_some() {
                add(self.ground(), self.point_node(point), None);
            }
        }
        for link in mechanism.link_ids() {
            for member in &mechanism.link(link).members {
                add(link.index(), self.point_node(member.point), None);
            }
        }
        for slide in mechanism.slide_ids() {
            let given = mechanism.slide(slide);
            let point = self.point_node(given.slider.point());
            add(self.body(given.on), point, Some(slide));
        }
        edges.sort_by_key(|edge| (edge.order, edge.slide.is_some()));
        edges
    }

    fn join(&mut self, edge: Edge) {
        let number = self.edges.len();
        self.ends[edge.body].push(number);
        self.ends[edge.point].push(number);
        self.edges.push(edge);
    }

    /// Returns the shortest path from one node to another, edge by edge; `None` if they are not
    /// connected.
    fn path(&self, from: usize, to: usize) -> Option<Vec<Edge>> {
        // An isolated end of the new edge cannot be reached.
        if self.ends[from].is_empty() || self.ends[to].is_empty() {
            return None;
        }
        let mut before: Vec<Option<usize>> = vec![None; self.ends.len()];
        let mut waiting = VecDeque::from([from]);
        while let Some(node) = waiting.pop_front() {
            for &number in &self.ends[node] {
                let next = self.edges[number].other(node);
                if next == from || before[next].is_some() {
                    continue;
                }
                before[next] = Some(number);
                if next == to {
                    return Some(self.traced(from, to, &before));
                }
                waiting.push_back(next);
            }
        }
        None
    }

    fn traced(&self, from: usize, to: usize, before: &[Option<usize>]) -> Vec<Edge> {
        let mut path = Vec::new();
        let mut node = to;
        while node != from {
            let Some(number) = before[node] else {
                break;
            };
            path.push(self.edges[number]);
            node = self.edges[number].other(node);
        }
        path.reverse();
        path
    }

    // ---- loops

    /// Returns the sides along a path from a point, and back over `closing` if given.
    fn terms(&mut self, path: &[Edge], closing: Option<Edge>) -> Vec<Term> {
        let paths: Vec<Edge> = path.iter().copied().chain(closing).collect();
        let mut terms = Vec::new();
        // From a point, edges alternately lead into a body and out of it.
        for pair in paths.chunks(2) {
            let &[into, out_of] = pair else { continue };
            terms.extend(self.slide_term(into, false));
            let ports = [into, out_of].map(|edge| self.port(edge));
            terms.extend(self.inside(into.body, ports[0], ports[1]));
            terms.extend(self.slide_term(out_of, true));
        }
        terms
    }

    fn slide_term(&self, edge: Edge, reversed: bool) -> Option<Term> {
        let shape = SideShape::Slide(edge.slide?);
        let side = self.sides.iter().position(|side| side.shape == shape)?;
        Some(Term { side, reversed })
    }

    fn port(&self, edge: Edge) -> Port {
        match edge.slide {
            Some(slide) => self.through(slide),
            None => Port::Point(PointId::new(edge.point - self.ground() - 1)),
        }
    }

    /// Chooses the direction of a loop that traverses as few of the scene's vectors as possible
    /// backwards.
    fn orient(&self, terms: &mut [Term]) {
        let named = terms.iter().filter(|term| self.sides[term.side].named);
        let (count, reversed) = named.fold((0, 0), |(count, reversed), term| {
            (count + 1, reversed + usize::from(term.reversed))
        });
        let moving = |term: &&Term| self.sides[term.side].turns != Turns::Never;
        let leans = 2 * reversed == count && terms.iter().find(moving).is_some_and(|t| t.reversed);
        if 2 * reversed > count || leans {
            terms.reverse();
            for term in terms.iter_mut() {
                term.reversed = !term.reversed;
            }
        }
    }

    /// Turns sides without a name in the scene to the direction of the first loop that contains
    /// them.
    fn turn_unnamed(&mut self, loops: &mut [(Vec<Term>, Option<usize>)]) {
        let mut is_first_reversed = vec![None; self.sides.len()];
        for term in loops.iter().flat_map(|(terms, _)| terms) {
            is_first_reversed[term.side].get_or_insert(term.reversed);
        }
        let is_turned: Vec<bool> = is_first_reversed
            .into_iter()
            .zip(&self.sides)
            .map(|(first, side)| !side.named && first == Some(true))
            .collect();
        for number in (0..self.sides.len()).filter(|&number| is_turned[number]) {
            let [tail, head] =
                [&self.sides[number].tail, &self.sides[number].head].map(String::clone);
            let name = self.take_name(&head, &tail);
            let side = &mut self.sides[number];
            self.taken.remove(&side.name);
            side.name = name;
            std::mem::swap(&mut side.tail, &mut side.head);
            if let SideShape::Rigid(body, local) = side.shape {
                side.shape = SideShape::Rigid(body, -local);
                side.turns = self.locks.turns(body, angle::degrees(-local));
            }
        }
        let terms = loops.iter_mut().flat_map(|(terms, _)| terms);
        for term in terms.chain(self.known.values_mut()) {
            term.reversed ^= is_turned[term.side];
        }
    }

    /// Rotates the terms so that the frame's vector comes first, or last if it is traversed
    /// backwards.
    fn rotate_to_frame(&self, terms: &mut [Term]) {
        let on_ground = |term: &Term| {
            matches!(
                self.sides[term.side].shape,
                SideShape::Rigid(Body::Ground, _)
            )
        };
        let Some(at) = terms.iter().position(on_ground) else {
            // Without a frame vector, the vector placed first comes first: the driver's.
            let first = terms.iter().enumerate().min_by_key(|(_, term)| term.side);
            return terms.rotate_left(first.map_or(0, |(at, _)| at));
        };
        terms.rotate_left(at);
        if terms.first().is_some_and(|term| term.reversed) {
            terms.rotate_left(1);
        }
    }

    /// Returns a loop for every vector between two bodies.
    fn free_loops(&mut self) -> Vec<(Vec<Term>, Option<usize>)> {
        let mut loops = Vec::new();
        for side in 0..self.sides.len() {
            let SideShape::Free(tail, head) = self.sides[side].shape else {
                continue;
            };
            let ends = [head, tail].map(|point| self.point_node(point));
            let Some(path) = self.path(ends[0], ends[1]) else {
                continue;
            };
            let mut terms = vec![Term {
                side,
                reversed: false,
            }];
            terms.extend(self.terms(&path, None));
            loops.push((terms, None));
        }
        loops
    }
}

/// Returns all names of a scene.
fn taken(scene: &Scene) -> HashSet<String> {
    let points = scene.point_names.iter().flatten();
    let elements = scene.link_names.iter().chain(&scene.slide_names);
    let vectors = scene.vectors.iter().map(|vector| &vector.name);
    points.chain(elements).chain(vectors).cloned().collect()
}

impl Edge {
    fn other(&self, node: usize) -> usize {
        if node == self.body {
            self.point
        } else {
            self.body
        }
    }
}
