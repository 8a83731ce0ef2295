//! The elements and attributes of Linkage's files, and what krank does with each of them.

use roxmltree::Node;

/// What krank does with an attribute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum AttributeUse {
    /// Text or an id that a reader checks.
    Text,
    /// `true` or `false`.
    Flag,
    /// A number.
    Number,
    /// Says how the program shows the element.
    Display,
}

use AttributeUse::{Display, Flag, Number, Text};

const PROGRAM: &[(&str, AttributeUse)] = &[
    ("units", Text),
    ("scalefactor", Number),
    ("zoom", Display),
    ("xoffset", Display),
    ("yoffset", Display),
    ("viewlayers", Display),
    ("editlayers", Display),
];

const CONNECTOR: &[(&str, AttributeUse)] = &[
    ("id", Text),
    ("name", Text),
    ("layer", Number),
    ("x", Text),
    ("y", Text),
    ("anchor", Flag),
    ("input", Flag),
    ("rpm", Number),
    ("limitangle", Number),
    ("alwaysmanual", Flag),
    ("slider", Flag),
    ("slideradius", Number),
    ("measurementelement", Flag),
    ("fasten", Text),
    ("fastenlink", Text),
    ("fastenconnector", Text),
    ("selected", Display),
    ("draw", Display),
    ("drawcircle", Display),
    ("color", Display),
];

const LINK: &[(&str, AttributeUse)] = &[
    ("id", Text),
    ("name", Text),
    ("layer", Number),
    ("actuator", Flag),
    ("throw", Number),
    ("cpm", Number),
    ("alwaysmanual", Flag),
    ("gear", Flag),
    ("measurementelement", Flag),
    ("fastenlink", Text),
    ("fastenconnector", Text),
    ("selected", Display),
    ("linesize", Display),
    ("solid", Display),
    ("locked", Display),
    ("color", Display),
];

/// What an element can have.
pub(super) struct ElementLayout {
    pub(super) attributes: &'static [(&'static str, AttributeUse)],
    pub(super) children: &'static [&'static str],
}

/// Returns the layout of an element; `None` for an unknown one, and for one that krank does not read
/// further.
pub(super) fn layout(node: Node<'_, '_>) -> Option<ElementLayout> {
    let (attributes, children): (_, &[&str]) = match node.tag_name().name() {
        "program" => (PROGRAM, &[]),
        "connector" => (CONNECTOR, &["slidelimit", "fastenlink"]),
        "element" => (LINK, &["connector", "fastenconnector", "fastenlink"]),
        name if names_link(name) => (LINK, &["connector", "fastenconnector", "fastenlink"]),
        _ => return None,
    };
    Some(ElementLayout {
        attributes,
        children,
    })
}

/// Returns `true` for an element that needs no remark: krank reads it elsewhere, or it is for the
/// display.
pub(super) fn is_read_elsewhere(name: &str) -> bool {
    ["selected", "ratios", "background"].contains(&name)
}

/// Returns `true` for the name of a link.
pub(super) fn names_link(name: &str) -> bool {
    name.eq_ignore_ascii_case("link") || name == "element"
}
