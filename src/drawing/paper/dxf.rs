//! Writes a drawing for CAD: lines, circles and texts on named layers, as the DXF of AutoCAD R12.
//!
//! CAD programs in general read R12: it has no handles and no objects, only codes and values in
//! turn. Numbers are written so that they read back to the same double; lengths are millimetres.

use crate::Vec2;
use std::fmt::Write as _;

/// The longest name that R12 allows, in characters.
const MAX_NAME_LEN: usize = 31;
/// The number of layer colours: red, yellow, green, cyan, blue, magenta.
const COLOURS: usize = 6;

/// A layer of a [`DxfDocument`].
#[derive(Clone, Copy, Debug)]
pub(in crate::drawing) struct DxfLayer(usize);

/// A DXF document, filled entity by entity.
#[derive(Debug, Default)]
pub(in crate::drawing) struct DxfDocument {
    layers: Vec<String>,
    entities: String,
}

impl DxfDocument {
    /// Adds a layer, with the requested name as far as DXF allows. Names differ in more than case.
    pub(in crate::drawing) fn layer(&mut self, requested: &str) -> DxfLayer {
        let allowed = |c: char| {
            if c.is_ascii_alphanumeric() || "_-$".contains(c) {
                c
            } else {
                '_'
            }
        };
        let requested: String = requested.chars().map(allowed).take(MAX_NAME_LEN).collect();
        let is_taken = |name: &String| {
            let mut others = self.layers.iter();
            others.any(|other| other.eq_ignore_ascii_case(name))
        };
        let mut name = requested.clone();
        let mut same = 1;
        while is_taken(&name) {
            let end = match same {
                1 => "_".to_owned(),
                same => format!("_{same}"),
            };
            let kept = requested.chars().take(MAX_NAME_LEN - end.len());
            name = kept.collect::<String>() + &end;
            same += 1;
        }
        self.layers.push(name);
        DxfLayer(self.layers.len() - 1)
    }

    pub(in crate::drawing) fn line(&mut self, layer: DxfLayer, from: Vec2, to: Vec2) {
        if from.is_finite() && to.is_finite() {
            self.start_entity("LINE", layer);
            self.place(0, from);
            self.place(1, to);
        }
    }

    /// Adds a chain of straight lines; points that are not finite break it.
    pub(in crate::drawing) fn chain(&mut self, layer: DxfLayer, course: &[Vec2]) {
        for run in course.split(|p| !p.is_finite()) {
            self.polyline(layer, run, false);
        }
    }

    /// Adds a closed outline.
    pub(in crate::drawing) fn outline(&mut self, layer: DxfLayer, corners: &[Vec2]) {
        self.polyline(layer, corners, true);
    }

    fn polyline(&mut self, layer: DxfLayer, corners: &[Vec2], is_closed: bool) {
        if corners.len() < 2 {
            return;
        }
        self.start_entity("POLYLINE", layer);
        self.pair(66, &1);
        self.place(0, Vec2::ZERO);
        self.pair(70, &i32::from(is_closed));
        for &corner in corners {
            self.start_entity("VERTEX", layer);
            self.place(0, corner);
        }
        self.start_entity("SEQEND", layer);
    }

    pub(in crate::drawing) fn circle(&mut self, layer: DxfLayer, at: Vec2, radius: f64) {
        if at.is_finite() {
            self.start_entity("CIRCLE", layer);
            self.place(0, at);
            self.pair(40, &decimal(radius));
        }
    }

    pub(in crate::drawing) fn point(&mut self, layer: DxfLayer, at: Vec2) {
        if at.is_finite() {
            self.start_entity("POINT", layer);
            self.place(0, at);
        }
    }

    /// Adds a text, such as a name; names are ASCII.
    pub(in crate::drawing) fn text(&mut self, layer: DxfLayer, at: Vec2, height: f64, text: &str) {
        if at.is_finite() {
            self.start_entity("TEXT", layer);
            self.place(0, at);
            self.pair(40, &decimal(height));
            self.pair(1, &text);
        }
    }

    fn start_entity(&mut self, kind: &str, layer: DxfLayer) {
        self.pair(0, &kind);
        let name = self.layers.get(layer.0).cloned().unwrap_or_default();
        self.pair(8, &name);
    }

    /// Writes a point: the first of an entity, or the other end of a line.
    fn place(&mut self, which: u8, at: Vec2) {
        for (k, coordinate) in [at.x, at.y, 0.0].into_iter().enumerate() {
            self.pair(10 * (k as u8 + 1) + which, &decimal(coordinate));
        }
    }

    fn pair(&mut self, code: u8, value: &dyn std::fmt::Display) {
        pair(&mut self.entities, code, value);
    }

    /// Returns the whole document; `low` and `high` are the corners of the drawing's extents.
    pub(in crate::drawing) fn text_of(&self, low: Vec2, high: Vec2) -> String {
        let mut text = String::new();
        let mut put = |code, value: &dyn std::fmt::Display| pair(&mut text, code, value);
        put(0, &"SECTION");
        put(2, &"HEADER");
        put(9, &"$ACADVER");
        put(1, &"AC1009");
        // Millimetres, and metric line patterns.
        put(9, &"$INSUNITS");
        put(70, &4);
        put(9, &"$MEASUREMENT");
        put(70, &1);
        for (name, corner) in [("$EXTMIN", low), ("$EXTMAX", high)] {
            put(9, &name);
            put(10, &decimal(corner.x));
            put(20, &decimal(corner.y));
            put(30, &"0.0");
        }
        put(0, &"ENDSEC");
        put(0, &"SECTION");
        put(2, &"TABLES");
        put(0, &"TABLE");
        put(2, &"LTYPE");
        put(70, &1);
        put(0, &"LTYPE");
        put(2, &"CONTINUOUS");
        put(70, &0);
        put(3, &"Solid line");
        put(72, &65);
        put(73, &0);
        put(40, &"0.0");
        put(0, &"ENDTAB");
        put(0, &"TABLE");
        put(2, &"LAYER");
        put(70, &self.layers.len());
        for (k, name) in self.layers.iter().enumerate() {
            put(0, &"LAYER");
            put(2, name);
            put(70, &0);
            put(62, &(k % COLOURS + 1));
            put(6, &"CONTINUOUS");
        }
        put(0, &"ENDTAB");
        put(0, &"ENDSEC");
        put(0, &"SECTION");
        put(2, &"ENTITIES");
        text.push_str(&self.entities);
        pair(&mut text, 0, &"ENDSEC");
        pair(&mut text, 0, &"EOF");
        text
    }
}

/// Appends a code and its value, one line each.
fn pair(text: &mut String, code: u8, value: &dyn std::fmt::Display) {
    let _ = writeln!(text, "{code:>3}\n{value}");
}

/// Returns the shortest decimal that reads back to the same double, without an exponent.
fn decimal(value: f64) -> String {
    let text = value.to_string();
    if text.contains('.') {
        text
    } else {
        text + ".0"
    }
}
