//! Orders the equations: which equation determines which unknown (matching), and in which order
//! (strong components).

use crate::solver::fault::Fault;
use crate::solver::plan::network::{Network, ScalarEquation, ScalarUnknown};
use crate::{ElementId, LinkId};
use petgraph::algo::{kosaraju_scc, maximum_matching};
use petgraph::graph::{DiGraph, NodeIndex, UnGraph};
use std::collections::{HashMap, HashSet};

/// A minimal set of unknowns that must be solved together, with its equations.
#[derive(Clone, Debug, Default)]
pub(in crate::solver) struct CoupledBlock {
    pub unknowns: Vec<ScalarUnknown>,
    pub rows: Vec<ScalarEquation>,
}

/// The blocks in solving order.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Ordering {
    pub blocks: Vec<CoupledBlock>,
    /// Equations that repeat others.
    pub set_aside: Vec<ScalarEquation>,
    /// The equations set aside and those that could replace them: the over-determined part.
    pub over: Vec<ScalarEquation>,
}

/// The unknowns as scalars: two for a point, one for a class.
struct Scalars {
    list: Vec<ScalarUnknown>,
    /// The scalars of each equation.
    of_row: Vec<Vec<usize>>,
}

impl Scalars {
    fn of(network: &Network<'_>) -> Scalars {
        let mut scalars = Scalars {
            list: Vec::new(),
            of_row: Vec::new(),
        };
        let mut first = HashMap::new();
        for link in network.mechanism.link_ids() {
            // A class is an unknown even if no equation contains its direction.
            let class = network.class(link);
            if !network.is_given(class) {
                scalars.number(ScalarUnknown::Class(class), &mut first);
            }
        }
        for point in network.mechanism.point_ids() {
            if network.is_joint(point) && !network.is_ground(point) {
                scalars.number(ScalarUnknown::Point(point), &mut first);
            }
        }
        for &row in &network.rows {
            let mut of_row = Vec::new();
            for unknown in network.unknowns(row) {
                let at = scalars.number(unknown, &mut first);
                of_row.extend(at..at + width(unknown));
            }
            scalars.of_row.push(of_row);
        }
        scalars
    }

    fn number(&mut self, unknown: ScalarUnknown, first: &mut HashMap<UnknownKey, usize>) -> usize {
        *first.entry(key(unknown)).or_insert_with(|| {
            let at = self.list.len();
            self.list
                .extend(std::iter::repeat_n(unknown, width(unknown)));
            at
        })
    }
}

type UnknownKey = (bool, usize);

fn key(unknown: ScalarUnknown) -> UnknownKey {
    match unknown {
        ScalarUnknown::Point(point) => (false, point.index()),
        ScalarUnknown::Class(class) => (true, class.0),
    }
}

fn width(unknown: ScalarUnknown) -> usize {
    match unknown {
        ScalarUnknown::Point(_) => 2,
        ScalarUnknown::Class(_) => 1,
    }
}

/// A matching: for each scalar the equation that determines it, for each equation its scalar.
struct Matching {
    row_of: Vec<Option<usize>>,
    scalar_of: Vec<Option<usize>>,
}

impl Matching {
    /// Shifts the matching along the alternating path to `gone`: each equation takes the scalar of
    /// the next one. The free equation at the start becomes matched, and `gone` becomes free.
    fn shift_matching(&mut self, part: &[ReachedEquation], gone: usize) {
        self.scalar_of[part[gone].row] = None;
        let mut taken = part[gone];
        while let Some((from, scalar)) = taken.by {
            let giver = part[from];
            self.row_of[scalar] = Some(giver.row);
            self.scalar_of[giver.row] = Some(scalar);
            taken = giver;
        }
    }
}

/// An equation on an alternating path from a free one.
#[derive(Clone, Copy, Debug)]
struct ReachedEquation {
    row: usize,
    /// The index of the preceding equation in the list, and the scalar between the two.
    by: Option<(usize, usize)>,
}

fn matching(scalars: &Scalars) -> Matching {
    let mut graph = UnGraph::<(), ()>::default();
    let columns: Vec<NodeIndex> = scalars.list.iter().map(|_| graph.add_node(())).collect();
    let rows: Vec<NodeIndex> = scalars.of_row.iter().map(|_| graph.add_node(())).collect();
    for (r, of_row) in scalars.of_row.iter().enumerate() {
        for &s in of_row {
            graph.add_edge(rows[r], columns[s], ());
        }
    }
    let found = maximum_matching(&graph);
    let offset = columns.len();
    Matching {
        row_of: columns
            .iter()
            .map(|&c| found.mate(c).map(|r| r.index() - offset))
            .collect(),
        scalar_of: rows
            .iter()
            .map(|&r| found.mate(r).map(NodeIndex::index))
            .collect(),
    }
}

/// Orders the equations of a mechanism.
///
/// If there are too many equations, those easiest to set aside are removed one by one, until all
/// others can be matched (the over-determined part of Dulmage and Mendelsohn, 1958). The structure
/// alone does not show which of them really are redundant. Therefore those in `preferred` are set
/// aside first.
///
/// # Errors
/// Returns [`Fault::Mobility`] if unknowns remain that no equation determines.
pub(in crate::solver) fn ordering(
    network: &Network<'_>,
    preferred: &[ScalarEquation],
) -> Result<Ordering, Fault> {
    let scalars = Scalars::of(network);
    let mut matched = matching(&scalars);
    let (mut set_aside, mut over) = (Vec::new(), Vec::new());
    let readiness = |row: ScalarEquation| (preferred.contains(&row), network.readiness(row));
    for free in 0..network.rows.len() {
        // An equation set aside for an earlier one occurs again here.
        if matched.scalar_of[free].is_some() || set_aside.contains(&network.rows[free]) {
            continue;
        }
        let part = over_determined(&scalars, &matched, free);
        let gone = (0..part.len())
            .max_by_key(|&i| (readiness(network.rows[part[i].row]), part[i].row))
            .unwrap_or(0);
        let gone_row = network.rows[part[gone].row];
        over.extend(part.iter().map(|reached| network.rows[reached.row]));
        set_aside.push(gone_row);
        matched.shift_matching(&part, gone);
    }
    let loose: Vec<usize> = (0..scalars.list.len())
        .filter(|&s| matched.row_of[s].is_none())
        .collect();
    if !loose.is_empty() {
        return Err(Fault::Mobility {
            mobility: network.mechanism.inputs().count() + loose.len(),
            redundant: set_aside.len() + network.repeated_locks.len(),
            repeating: elements(&set_aside),
            is_unclear: false,
            floating: floating(network, &scalars, &matched, loose),
        });
    }
    Ok(Ordering {
        blocks: blocks(network, &scalars, &matched),
        set_aside,
        over,
    })
}

/// Returns the equations that compete with a free one: all on alternating paths from it.
fn over_determined(scalars: &Scalars, matched: &Matching, free: usize) -> Vec<ReachedEquation> {
    let mut seen = HashSet::from([free]);
    let mut part = vec![ReachedEquation {
        row: free,
        by: None,
    }];
    let mut next = 0;
    while next < part.len() {
        for &s in &scalars.of_row[part[next].row] {
            if let Some(row) = matched.row_of[s].filter(|&r| seen.insert(r)) {
                let by = Some((next, s));
                part.push(ReachedEquation { row, by });
            }
        }
        next += 1;
    }
    part
}

/// Returns the links of the unknowns on alternating paths from the undetermined ones.
fn floating(
    network: &Network<'_>,
    scalars: &Scalars,
    matched: &Matching,
    loose: Vec<usize>,
) -> Vec<LinkId> {
    let mut rows_of = vec![Vec::new(); scalars.list.len()];
    for (r, of_row) in scalars.of_row.iter().enumerate() {
        for &s in of_row {
            rows_of[s].push(r);
        }
    }
    let mut seen = vec![false; scalars.list.len()];
    let mut part = loose;
    let mut next = 0;
    while next < part.len() {
        seen[part[next]] = true;
        for &r in &rows_of[part[next]] {
            if let Some(s) =
                matched.scalar_of[r].filter(|&s| !std::mem::replace(&mut seen[s], true))
            {
                part.push(s);
            }
        }
        next += 1;
    }
    let floats = |link: &LinkId| {
        part.iter().any(|&s| match scalars.list[s] {
            ScalarUnknown::Class(class) => network.class(*link) == class,
            ScalarUnknown::Point(_) => false,
        })
    };
    network.mechanism.link_ids().filter(floats).collect()
}

/// Returns the strong components of the dependencies, each before those that depend on it.
fn blocks(network: &Network<'_>, scalars: &Scalars, matched: &Matching) -> Vec<CoupledBlock> {
    let mut graph = DiGraph::<(), ()>::new();
    let nodes: Vec<NodeIndex> = scalars.list.iter().map(|_| graph.add_node(())).collect();
    for (s, row) in matched.row_of.iter().enumerate() {
        for &other in row.map_or(&[][..], |r| &scalars.of_row[r]) {
            graph.add_edge(nodes[s], nodes[other], ());
        }
    }
    // Kosaraju's algorithm needs no recursion here, so a chain of thousands of dyads does not
    // exhaust the stack. It lists the components in reverse topological order.
    let mut blocks = Vec::new();
    for component in kosaraju_scc(&graph) {
        let mut block = CoupledBlock::default();
        let mut scalars_in: Vec<usize> = component.iter().map(|n| n.index()).collect();
        scalars_in.sort_unstable();
        for s in scalars_in {
            if block.unknowns.last() != Some(&scalars.list[s]) {
                block.unknowns.push(scalars.list[s]);
            }
            block
                .rows
                .extend(matched.row_of[s].map(|r| network.rows[r]));
        }
        blocks.push(block);
    }
    blocks
}

/// Returns the elements of a list of equations, without duplicates.
pub(in crate::solver) fn elements(rows: &[ScalarEquation]) -> Vec<ElementId> {
    let mut elements = Vec::new();
    for row in rows {
        if !elements.contains(&row.element()) {
            elements.push(row.element());
        }
    }
    elements
}
