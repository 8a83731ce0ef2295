//! Imports mechanisms from the files of other linkage programs.
//!
//! A reader for each format converts the text to a drawing: points with coordinates, the links that
//! share them, slides and inputs. The drawing is simplified and written as a commented scene, which
//! opens in the pose of the drawing. What krank does not model is reported with its place in the
//! file, and the rest is kept.

mod address;
mod drawing;
mod joints;
mod linkage;
mod linkage_layout;
mod names;
mod pmks;
mod pmks_plus;
mod pylinkage;
mod pyslvs;
mod reduce;
mod writer;

use crate::LinkId;
use crate::scene::{MAX_FILE_SIZE, Scene, sanitized};
use crate::solver::{Condition, Fault, Order, Solver};
use crate::wording::words;
use drawing::{Drawing, DrawnLaw, Remarks};
use names::ElementNames;
use std::borrow::Cow;
use std::collections::HashMap;
use thiserror::Error;
use writer::{LimitStyle, LinkStyle, SceneStyle};

/// A scene opens as drawn if no point is farther from its place than this fraction of the size.
const AS_DRAWN: f64 = 1e-9;

/// The change of a length for a drawing at a dead point, in gaps by which it is out of reach.
const GAPS: f64 = 4.0;
/// The smallest such change, as a fraction of the size.
const MIN_CHANGE: f64 = 1e-14;
/// A drawing at a dead point opens within this fraction of the size: about the square root of the
/// change of lengths.
const AT_DEAD_POINT: f64 = 1e-6;

/// The format of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImportFormat {
    /// The text of PMKS, or its address.
    Pmks,
    /// An address of PMKS+.
    PmksPlus,
    /// The XML of Linkage.
    Linkage,
    /// An expression of Pyslvs.
    Pyslvs,
    /// The mechanism of pylinkage in JSON.
    Pylinkage,
}

impl ImportFormat {
    /// Returns the name of the program.
    #[must_use]
    pub fn program(self) -> &'static str {
        match self {
            ImportFormat::Pmks => "PMKS",
            ImportFormat::PmksPlus => "PMKS+",
            ImportFormat::Linkage => "Linkage",
            ImportFormat::Pyslvs => "Pyslvs",
            ImportFormat::Pylinkage => "pylinkage",
        }
    }
}

/// A scene that was made from another program's file.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The text of the scene, with comments.
    pub text: String,
    /// What was not taken over, or was decided on the way. Each sentence names its place.
    pub remarks: Vec<String>,
    /// The format of the file.
    pub format: ImportFormat,
}

/// The reason why a file cannot be imported at all.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{0}")]
pub struct ImportError(String);

impl ImportError {
    fn new(message: &str) -> ImportError {
        ImportError(sanitized(message, false))
    }

    fn too_large() -> ImportError {
        ImportError::new(&words().import_too_large(drawing::MAX_ELEMENTS))
    }
}

/// Returns the format of a file, recognised by its contents; `None` for a scene and for anything
/// that no other program wrote.
///
/// ```
/// use krank::import::{ImportFormat, recognize};
/// let text = "ground,input,R,0,0\ninput,coupler,R,10,20\n";
/// assert_eq!(recognize(text.as_bytes()), Some(ImportFormat::Pmks));
/// assert_eq!(recognize(b"[links]\n"), None);
/// ```
#[must_use]
pub fn recognize(bytes: &[u8]) -> Option<ImportFormat> {
    let text = decoded(bytes);
    let text = trimmed(&text);
    if linkage::is_linkage(text) {
        return Some(ImportFormat::Linkage);
    }
    if pyslvs::is_pyslvs(text) {
        return Some(ImportFormat::Pyslvs);
    }
    if pylinkage::is_pylinkage(text) {
        return Some(ImportFormat::Pylinkage);
    }
    if is_address(text) {
        let (address, _) = first_address(text);
        let parameters = address::parameters(address);
        if address::value(&parameters, "mech").is_some() {
            return Some(ImportFormat::Pmks);
        }
        let is_packed = is_of_pmks(address) && address.contains(['?', '#']);
        let is_plus = address::value(&parameters, "j").is_some() || is_packed;
        return is_plus.then_some(ImportFormat::PmksPlus);
    }
    pmks::is_pmks(text).then_some(ImportFormat::Pmks)
}

/// Converts another program's file to a scene. `name` is the file's name without folder, or the
/// address.
///
/// # Errors
/// Returns why the file has no mechanism that can be read.
pub fn import(bytes: &[u8], name: &str) -> Result<Imported, ImportError> {
    if bytes.len() > MAX_FILE_SIZE {
        return Err(ImportError::too_large());
    }
    let text = decoded(bytes);
    let text = trimmed(&text);
    // Other JSON gets an error that says what it lacks.
    let is_json = text.starts_with('{');
    let format = recognize(bytes).or(is_json.then_some(ImportFormat::Pylinkage));
    let format = format.ok_or_else(|| {
        ImportError::new(match is_address_argument(text) {
            true => words().is_a_pmks_address(),
            false => words().import_unknown_format(),
        })
    })?;
    let mut drawing = match format {
        ImportFormat::Linkage => linkage::read_linkage(text)?,
        ImportFormat::Pyslvs => pyslvs::read_pyslvs(text)?,
        ImportFormat::Pylinkage => pylinkage::read_pylinkage(text)?,
        ImportFormat::Pmks if is_address(text) => {
            let (address, joints) = first_address(text);
            let parameters = address::parameters(address);
            let mechanism = address::value(&parameters, "mech").unwrap_or_default();
            // The joints may follow in lines of their own.
            let joints = format!("{mechanism}\n{joints}");
            pmks::read_pmks(&joints, Some(&parameters))?
        }
        ImportFormat::Pmks => pmks::read_pmks(text, None)?,
        ImportFormat::PmksPlus => {
            let (address, _) = first_address(text);
            let parameters = address::parameters(address);
            match address::value(&parameters, "j") {
                Some(_) => pmks_plus::read_pmks_plus(&parameters)?,
                None => return Err(packed(address)),
            }
        }
    };
    if is_address(text) && text.lines().skip(1).any(address::has_scheme) {
        drawing.remark("", words().import_other_addresses());
    }
    reduce::settle(&mut drawing);
    let mut remarks = std::mem::take(&mut drawing.remarks);
    hold_inputs(&drawing, &mut remarks);
    let names = names::assign(&drawing, &mut remarks);
    let mut remarks: Vec<String> = remarks
        .into_list()
        .iter()
        .map(|remark| sanitized(remark, false))
        .collect();
    let writer = ImportWriter {
        drawing: &drawing,
        names: &names,
        format,
        file: name,
    };
    let text = writer.text(&mut remarks);
    Ok(Imported {
        text,
        remarks,
        format,
    })
}

/// Reports inputs that cannot follow the driver linearly: they stay as drawn.
fn hold_inputs(drawing: &Drawing, remarks: &mut Remarks) {
    let [driver, others @ ..] = drawing.inputs.as_slice() else {
        return;
    };
    for input in others {
        let ratio = writer::ratio(&driver.law, &input.law);
        match ratio {
            None => remarks.add(&input.place, words().import_input_is_held()),
            Some(_) if input.law == DrawnLaw::Unknown => {
                remarks.add(&input.place, words().import_same_speed());
            }
            Some(_) => {}
        }
    }
}

/// How a scene opens, compared with its drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum OpeningPose {
    AsDrawn,
    /// The largest distance of a point from its place, as a fraction of the size.
    Elsewhere(f64),
    /// The scene does not open.
    Nowhere,
}

/// Writes a drawing as a scene, and checks how the scene opens.
struct ImportWriter<'d> {
    drawing: &'d Drawing,
    names: &'d ElementNames,
    format: ImportFormat,
    /// The name of the file, or the address.
    file: &'d str,
}

impl ImportWriter<'_> {
    /// Returns the scene in the form of a textbook, or in the drawing's coordinates where only
    /// these open as drawn.
    fn text(&self, remarks: &mut Vec<String>) -> String {
        let style = |links, limits| SceneStyle {
            links,
            limits,
            stretch: None,
            start: None,
        };
        // Lengths in coordinates have no rounding error, which may lead beyond a limit.
        let styles = [
            style(LinkStyle::Ends, LimitStyle::Exact),
            style(LinkStyle::Drawn, LimitStyle::Exact),
            style(LinkStyle::Drawn, LimitStyle::Loose),
        ];
        let mut elsewhere = None;
        for style in styles {
            match self.pose(style, remarks) {
                OpeningPose::AsDrawn => return self.written(style, remarks, true),
                OpeningPose::Elsewhere(off) => elsewhere = elsewhere.or(Some((style, off))),
                OpeningPose::Nowhere => {}
            }
            if !self.drawing.has_limits() && style.links == LinkStyle::Drawn {
                break;
            }
        }
        if let Some((style, off)) = elsewhere {
            let text = match off <= AT_DEAD_POINT {
                true => words().import_at_dead_point(),
                false => words().import_not_as_drawn(),
            };
            remarks.push(text.to_owned());
            return self.written(style, remarks, false);
        }
        if let Some(style) = self.at_dead_point(remarks) {
            remarks.push(words().import_at_dead_point().to_owned());
            return self.written(style, remarks, false);
        }
        if self.drawing.has_limits() {
            // Limits that the scene contradicts are left out.
            let free = [LinkStyle::Ends, LinkStyle::Drawn];
            let free = free.map(|links| style(links, LimitStyle::Omitted));
            let poses = free.map(|style| self.pose(style, remarks));
            let is_drawn = |pose: &OpeningPose| *pose == OpeningPose::AsDrawn;
            let opens = |pose: &OpeningPose| *pose != OpeningPose::Nowhere;
            let chosen = poses.iter().position(is_drawn);
            if let Some(chosen) = chosen.or_else(|| poses.iter().position(opens)) {
                remarks.push(words().import_limits_contradict().to_owned());
                let is_drawn = is_drawn(&poses[chosen]);
                if !is_drawn {
                    remarks.push(words().import_not_as_drawn().to_owned());
                }
                return self.written(free[chosen], remarks, is_drawn);
            }
        }
        self.written(styles[0], remarks, false)
    }

    /// Returns how to write a drawing at a dead point, where the rounding of lengths decides whether
    /// the scene has no assembly or two: one length is changed by a few roundings if necessary.
    fn at_dead_point(&self, remarks: &[String]) -> Option<SceneStyle> {
        let unchanged = SceneStyle {
            links: LinkStyle::Ends,
            limits: LimitStyle::Loose,
            stretch: None,
            start: None,
        };
        let is_near = |style: SceneStyle| match self.pose(style, remarks) {
            OpeningPose::AsDrawn => true,
            OpeningPose::Elsewhere(off) => off <= AT_DEAD_POINT,
            OpeningPose::Nowhere => false,
        };
        let scene = Scene::parse(&self.written(unchanged, remarks, true), "").ok()?;
        let (links, gap) = match Solver::new(&scene.mechanism) {
            Err(Fault::Open { links, gap, .. }) => (links, gap),
            Err(Fault::Vague { point, .. }) => {
                let decided = self.decided(unchanged, remarks);
                if is_near(decided) {
                    return Some(decided);
                }
                // Both assemblies are the same in doubles.
                let links = scene.mechanism.link_ids();
                let meets = |link: &LinkId| scene.mechanism.link(*link).member(point).is_some();
                (links.filter(meets).collect(), 0.0)
            }
            _ => return None,
        };
        if gap > AS_DRAWN * self.drawing.size() {
            return None;
        }
        // A change of less than the last written digit would be rounded away.
        let change = (GAPS * gap).max(MIN_CHANGE * self.drawing.size());
        let names = links.iter().map(|&link| scene.link_name(link));
        let links = names.filter_map(|name| self.names.links.iter().position(|own| own == name));
        let mut changes = links.flat_map(|link| [(link, change), (link, -change)]);
        changes.find_map(|stretch| {
            let style = SceneStyle {
                stretch: Some(stretch),
                ..unchanged
            };
            Some(self.decided(style, remarks)).filter(|&style| is_near(style))
        })
    }

    /// Returns a style whose rough positions choose the first of two assemblies that are equally near
    /// to the drawing.
    fn decided(&self, style: SceneStyle, remarks: &[String]) -> SceneStyle {
        let start = || {
            let scene = Scene::parse(&self.written(style, remarks, true), "").ok()?;
            let Err(Fault::Vague { point, choices, .. }) = Solver::new(&scene.mechanism) else {
                return None;
            };
            let name = scene.point_name(point)?;
            let point = self.names.points.iter().position(|own| own == name)?;
            let at = choices.first()?;
            Some((point, [at.x, at.y]))
        };
        SceneStyle {
            start: start(),
            ..style
        }
    }

    /// Writes the scene. `is_as_drawn` says whether it opens in the pose of the drawing.
    fn written(&self, style: SceneStyle, remarks: &[String], is_as_drawn: bool) -> String {
        let program = self.format.program();
        let shown = match is_address(self.file) {
            true => words().import_an_address(program),
            false => words().import_a_file(program, &sanitized(self.file, false)),
        };
        let title = match is_address(self.file) {
            true => program.to_owned(),
            false => crate::scene::stem(self.file),
        };
        let about = match is_as_drawn {
            true => words().import_about(program),
            false => words().import_about_elsewhere(program),
        };
        let about = [about, title, shown];
        let about = about.each_ref().map(String::as_str);
        writer::scene_text(self.drawing, self.names, style, about, remarks)
    }

    /// Opens the scene and compares every point with its place in the drawing.
    fn pose(&self, style: SceneStyle, remarks: &[String]) -> OpeningPose {
        let text = self.written(style, remarks, true);
        let Ok(scene) = Scene::parse(&text, "") else {
            return OpeningPose::Nowhere;
        };
        let Ok(solver) = Solver::new(&scene.mechanism) else {
            return OpeningPose::Nowhere;
        };
        let mut state = solver.state();
        let start = scene.mechanism.driver().start;
        if solver.solve(start, Order::Position, &mut state) == Condition::NoAssembly {
            return OpeningPose::Nowhere;
        }
        let names = self.names.points.iter().map(String::as_str);
        let drawn: HashMap<&str, [f64; 2]> = names
            .zip(self.drawing.points.iter().map(|point| point.at))
            .collect();
        let distances = scene.mechanism.point_ids().filter_map(|point| {
            let [x, y] = drawn.get(scene.point_name(point)?)?;
            let found = state.position(point)?;
            Some((found.x - x).hypot(found.y - y))
        });
        let farthest = distances.fold(0.0, f64::max);
        let size = self.drawing.size();
        match farthest <= AS_DRAWN * size {
            true => OpeningPose::AsDrawn,
            false => OpeningPose::Elsewhere(farthest / size),
        }
    }
}

/// Returns the error of an address whose contents are packed.
fn packed(address: &str) -> ImportError {
    let query = address.split_once('?').map_or("", |(_, query)| query);
    let version: String = query.chars().take_while(|&c| c != '.').take(8).collect();
    let is_version = version.starts_with(|c: char| c.is_ascii_digit());
    let version = if is_version { version.as_str() } else { "" };
    ImportError::new(&words().import_packed(version))
}

/// Returns the text of a file with line feeds. Files in an older encoding keep their ASCII
/// characters.
fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    let read: Option<fn([u8; 2]) -> u16> = match bytes {
        [0xff, 0xfe, ..] => Some(u16::from_le_bytes),
        [0xfe, 0xff, ..] => Some(u16::from_be_bytes),
        _ => None,
    };
    if let Some(read) = read {
        let units = bytes.chunks_exact(2).map(|pair| read([pair[0], pair[1]]));
        let units: Vec<u16> = units.collect();
        return String::from_utf16_lossy(&units).into();
    }
    let text = decoded_bytes(bytes);
    // Old files end their lines with a carriage return alone.
    match text.contains('\r') && !text.contains('\n') {
        true => text.replace('\r', "\n").into(),
        false => text,
    }
}

fn decoded_bytes(bytes: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => bytes
            .iter()
            .map(|&byte| char::from(byte))
            .collect::<String>()
            .into(),
    }
}

fn trimmed(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text).trim()
}

/// Returns `true` for an internet address, also without its scheme if it contains joints, and for
/// its part from `?` or `#` on.
///
/// ```
/// use krank::import::is_address;
/// assert!(is_address("app.pmksplus.com/?j=A,0,0,AB,R,t,0,t"));
/// assert!(is_address("?mech=ground,input,R,0,0|input,coupler,R,10,20"));
/// assert!(!is_address("four-bar.pmks.txt"));
/// ```
#[must_use]
pub fn is_address(text: &str) -> bool {
    let (line, _) = first_address(text);
    if address::has_scheme(line) {
        return true;
    }
    let joints = address::joints_without_scheme(line);
    joints.is_some_and(|(name, value)| match name {
        "j" => pmks_plus::has_joints(&value),
        _ => pmks::is_pmks(&value),
    })
}

/// Returns `true` for an argument of the command line that can only be an address, with or without a
/// mechanism.
#[must_use]
pub fn is_address_argument(text: &str) -> bool {
    let is_line = !text.trim().contains('\n');
    is_address(text) || is_line && address::is_part_of_address(text)
}

/// Returns the address in the first line of a file, and the lines up to the next one.
fn first_address(text: &str) -> (&str, &str) {
    let (address, rest) = text.split_once('\n').unwrap_or((text, ""));
    let mut offset = 0;
    let mut lines = rest.split_inclusive('\n');
    let end = lines.find_map(|line| {
        let start = offset;
        offset += line.len();
        address::has_scheme(line.trim_start()).then_some(start)
    });
    // Addresses in texts are often in quotes.
    let address = address.trim().trim_matches(['"', '\'', '<', '>']);
    (address, &rest[..end.unwrap_or(rest.len())])
}

fn is_of_pmks(text: &str) -> bool {
    text.to_ascii_lowercase().contains("pmks")
}
