//! Writes a drawing as the text of a scene.

use super::drawing::{
    Drawing, DrawnLaw, DrawnPart, DrawnSlider, InputElement, difference, wrapped,
};
use super::names::ElementNames;
use crate::scene::{key, toml_string};
use crate::wording::words;
use std::collections::HashSet;

/// How links are described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LinkStyle {
    /// By two ends and their distance, as in a textbook.
    Ends,
    /// By the drawing's coordinates, so that no length is rounded.
    Drawn,
}

/// How limits are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LimitStyle {
    /// As drawn.
    Exact,
    /// An end at which the scene opens is moved outwards by a rounding error.
    Loose,
    /// Without limits.
    Omitted,
}

/// How a scene is written.
#[derive(Clone, Copy, Debug)]
pub(super) struct SceneStyle {
    pub(super) links: LinkStyle,
    pub(super) limits: LimitStyle,
    /// A link whose length is changed, and by how much.
    pub(super) stretch: Option<(usize, f64)>,
    /// A point whose rough position differs from the drawing.
    pub(super) start: Option<(usize, [f64; 2])>,
}

/// A point is on a line if its distance from it is below this fraction of the drawing's size.
const ON_LINE: f64 = 1e-13;
/// Computed coordinates below this fraction of the size are rounding errors of zero.
const NOISE: f64 = 1e-15;
/// Ends of travel below this fraction of the size are rounding errors of zero.
const END_NOISE: f64 = 1e-14;
/// The fraction of the drawing's size by which a loose end is moved outwards.
const LOOSENESS: f64 = 1e-12;
/// The same for angles, in degrees.
const LOOSE_ANGLE: f64 = 1e-10;
/// Significant digits of computed numbers: those that a decimal of a double keeps.
const DIGITS: usize = 15;

/// The frame of a part in the drawing.
#[derive(Clone, Copy, Debug, Default)]
struct PartFrame {
    origin: [f64; 2],
    /// The direction of its x axis, in degrees.
    angle: f64,
    /// The ends of a link in [`LinkStyle::Ends`].
    ends: Option<[usize; 2]>,
}

impl PartFrame {
    /// Returns the coordinates of a place of the drawing in this frame.
    fn local(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = difference(at, self.origin);
        let [cos, sin] = unit(self.angle);
        if (cos, sin) == (1.0, 0.0) {
            return [x, y];
        }
        [x * cos + y * sin, y * cos - x * sin]
    }
}

/// Returns the cosine and the sine of an angle in degrees; exact for multiples of 90.
fn unit(angle: f64) -> [f64; 2] {
    match angle.rem_euclid(360.0) {
        0.0 => [1.0, 0.0],
        90.0 => [0.0, 1.0],
        180.0 => [-1.0, 0.0],
        270.0 => [0.0, -1.0],
        angle => {
            let (sin, cos) = angle.to_radians().sin_cos();
            [cos, sin]
        }
    }
}

/// Formats a number of the file: with the fewest digits that read back to the same double.
fn given(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// Formats a computed number, without the last digits, which are rounding errors.
fn computed(value: f64) -> String {
    let rounded: f64 = format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value);
    given(rounded)
}

fn pair([x, y]: [f64; 2], format: fn(f64) -> String) -> String {
    format!("[{}, {}]", format(x), format(y))
}

/// A scene under construction.
struct SceneWriter<'d> {
    drawing: &'d Drawing,
    names: &'d ElementNames,
    style: SceneStyle,
    frames: Vec<PartFrame>,
    size: f64,
    text: String,
}

/// Returns the text of a scene. `about` is the first comment, `source` is the origin of the
/// mechanism, and `remarks` become comments.
pub(super) fn scene_text(
    drawing: &Drawing,
    names: &ElementNames,
    style: SceneStyle,
    about: [&str; 3],
    remarks: &[String],
) -> String {
    let mut writer = SceneWriter {
        drawing,
        names,
        style,
        frames: Vec::new(),
        size: drawing.size(),
        text: String::new(),
    };
    writer.frames = (0..drawing.links.len())
        .map(|link| writer.frame(link))
        .collect();
    writer.head(about, remarks);
    writer.ground();
    writer.driver();
    writer.inputs();
    writer.links();
    writer.slides();
    writer.limits();
    writer.start();
    writer.loads();
    writer.text
}

impl SceneWriter<'_> {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn point(&self, point: usize) -> &str {
        &self.names.points[point]
    }

    fn is_kept(&self, link: usize) -> bool {
        !self.drawing.links[link].points.is_empty()
    }

    /// Chooses the frame of a link.
    fn frame(&self, link: usize) -> PartFrame {
        let drawing = self.drawing;
        let points = &drawing.links[link].points;
        let slides = &drawing.slides;
        let sliding = slides.iter().find_map(|slide| match slide.slider {
            DrawnSlider::Link { link: sliding, at } => (sliding == link).then_some(at),
            DrawnSlider::Pin(_) => None,
        });
        let Some(&first) = points.first() else {
            return PartFrame::default();
        };
        let fixed = points
            .iter()
            .copied()
            .find(|point| drawing.ground.contains(point));
        let from = sliding
            .filter(|at| points.contains(at))
            .or(fixed)
            .unwrap_or(first);
        let origin = drawing.points[from].at;
        let far = points
            .iter()
            .copied()
            .find(|&to| drawing.distance(from, to) > 0.0);
        match (self.style.links, far) {
            (LinkStyle::Ends, Some(to)) => PartFrame {
                origin,
                angle: drawing.direction(from, to),
                ends: Some([from, to]),
            },
            // A barrel points along the rod in it.
            (_, None) => {
                let carried = slides
                    .iter()
                    .find(|slide| slide.on == DrawnPart::Link(link));
                PartFrame {
                    origin,
                    angle: carried.map_or(0.0, |slide| slide.angle),
                    ends: None,
                }
            }
            (LinkStyle::Drawn, _) => PartFrame {
                // A sliding link has its origin on its guide.
                origin: sliding.map_or([0.0; 2], |at| drawing.points[at].at),
                ..PartFrame::default()
            },
        }
    }

    fn frame_of(&self, part: DrawnPart) -> PartFrame {
        match part {
            DrawnPart::Frame => PartFrame::default(),
            DrawnPart::Link(link) => self.frames[link],
        }
    }

    fn part(&self, part: DrawnPart) -> &str {
        match part {
            DrawnPart::Frame => "ground",
            DrawnPart::Link(link) => &self.names.links[link],
        }
    }

    /// Writes the comments, the title and the unit.
    fn head(&mut self, [about, title, source]: [&str; 3], remarks: &[String]) {
        self.line(&format!("# {about}"));
        for remark in remarks {
            self.line(&format!("# - {remark}"));
        }
        let title = self.drawing.title.as_deref().unwrap_or(title);
        self.line(&format!("name   = {}", toml_string(title)));
        self.line(&format!("source = {}", toml_string(source)));
        let unit = self.drawing.unit;
        let comment = match unit {
            Some(_) => String::new(),
            None => format!("   # {}", words().import_no_unit()),
        };
        let unit = unit.unwrap_or_default();
        self.line(&format!("unit   = \"{}\"{comment}", unit.symbol()));
        if let Some(gravity) = self.drawing.gravity {
            self.line(&format!("gravity = {}", pair(gravity, given)));
        }
    }

    /// Writes the fixed points: those that something refers to, and marks.
    fn ground(&mut self) {
        let drawing = self.drawing;
        let mut used: HashSet<usize> = HashSet::new();
        used.extend(drawing.links.iter().flat_map(|link| &link.points));
        used.extend((0..drawing.slides.len()).filter_map(|slide| self.guide(slide).named));
        for (section, is_used) in [("ground", true), ("marks", false)] {
            let points: Vec<usize> = drawing
                .ground
                .iter()
                .copied()
                .filter(|point| used.contains(point) == is_used)
                .collect();
            self.places(section, "", &points);
        }
    }

    /// Writes a section of places, if there are any.
    fn places(&mut self, section: &str, comment: &str, points: &[usize]) {
        if points.is_empty() {
            return;
        }
        let comment = match comment {
            "" => String::new(),
            comment => format!("   # {comment}"),
        };
        self.line(&format!("\n[{section}]{comment}"));
        for &point in points {
            let at = match self.style.start {
                Some((moved, at)) if moved == point => pair(at, computed),
                _ => pair(self.drawing.points[point].at, given),
            };
            let line = format!("{} = {at}", key(self.point(point)));
            self.line(&line);
        }
    }

    /// Returns the coordinate of an input in the opening pose.
    fn opening(&self, element: InputElement) -> f64 {
        match element {
            InputElement::Turn { link, from } => {
                wrapped(self.frames[link].angle - self.frame_of(from).angle)
            }
            InputElement::Slide(slide) => self.guide(slide).position,
        }
    }

    fn driver(&mut self) {
        let drawing = self.drawing;
        let Some(input) = drawing.inputs.first() else {
            return;
        };
        let opening = self.opening(input.element);
        self.line("\n[driver]");
        match input.element {
            InputElement::Turn { link, from } => {
                let line = format!("link  = {}", toml_string(&self.names.links[link]));
                self.line(&line);
                if from != DrawnPart::Frame {
                    let line = format!("from  = {}", toml_string(self.part(from)));
                    self.line(&line);
                }
                self.line(&format!("angle = {}", computed(opening)));
            }
            InputElement::Slide(slide) => {
                let line = format!("slide    = {}", toml_string(&self.names.slides[slide]));
                self.line(&line);
                self.line(&format!("position = {}", computed(opening)));
            }
        }
        let opening: f64 = computed(opening).parse().unwrap_or(opening);
        if let Some(range) = input.range {
            let ends = range.map(|end| opening + end);
            self.line(&format!("range = {}", pair(ends, computed)));
        }
        match &input.law {
            DrawnLaw::Unknown => {}
            DrawnLaw::Speed(speed, unit) => {
                self.line(&format!("speed = \"{} {unit}\"", given(*speed)));
            }
            DrawnLaw::Sine {
                amplitude,
                time,
                phase,
            } => {
                let [amplitude, time, phase] = [*amplitude, *time, *phase].map(computed);
                self.line(&format!(
                    "motion = [{{ law = \"sine\", amplitude = {amplitude}, phase = {phase}, time = {time} }}]"
                ));
            }
        }
    }

    /// Writes the inputs that follow the driver.
    fn inputs(&mut self) {
        let drawing = self.drawing;
        let [driver, others @ ..] = drawing.inputs.as_slice() else {
            return;
        };
        if others.is_empty() {
            return;
        }
        self.line(&format!("\n[inputs]   # {}", words().import_ratios()));
        let number = |value: f64| computed(value).parse().unwrap_or(value);
        let leading: f64 = number(self.opening(driver.element));
        for input in others {
            let opening = number(self.opening(input.element));
            let law = match ratio(&driver.law, &input.law).map(number) {
                Some(ratio) if ratio != 0.0 => {
                    let phase = computed(opening - ratio * leading);
                    format!("ratio = {}, phase = {phase}", given(ratio))
                }
                _ => format!("at = {}", computed(opening)),
            };
            let (name, from) = match input.element {
                InputElement::Turn { link, from } => (&self.names.links[link], from),
                InputElement::Slide(slide) => (&self.names.slides[slide], DrawnPart::Frame),
            };
            let from = match from {
                DrawnPart::Frame => String::new(),
                from => format!(", from = {}", toml_string(self.part(from))),
            };
            self.line(&format!("{} = {{ {law}{from} }}", key(name)));
        }
    }

    fn links(&mut self) {
        self.line("\n[links]");
        for link in 0..self.drawing.links.len() {
            if self.is_kept(link) {
                let line = self.link(link);
                self.line(&line);
            }
        }
    }

    fn link(&self, link: usize) -> String {
        let (drawn, frame) = (&self.drawing.links[link], self.frames[link]);
        let format = match frame.ends {
            Some(_) => computed,
            None => given,
        };
        let mut parts = Vec::new();
        let stretch = match self.style.stretch {
            Some((stretched, change)) if stretched == link => change,
            _ => 0.0,
        };
        if let Some([from, to]) = frame.ends {
            parts.push(format!(
                "from = {}, to = {}, length = {}",
                toml_string(self.point(from)),
                toml_string(self.point(to)),
                computed(self.drawing.distance(from, to) + stretch)
            ));
        }
        let place = |at: [f64; 2]| match frame.ends {
            Some(_) => self.local(DrawnPart::Link(link), at),
            None => frame.local(at),
        };
        let others = drawn.points.iter().filter(|&&point| {
            let ends = frame.ends.unwrap_or([usize::MAX; 2]);
            !ends.contains(&point)
        });
        let others: Vec<String> = others
            .map(|&point| {
                let at = pair(place(self.drawing.points[point].at), format);
                format!("{} = {at}", key(self.point(point)))
            })
            .collect();
        if !others.is_empty() {
            parts.push(format!("points = {{ {} }}", others.join(", ")));
        }
        if let Some(mass) = drawn.mass {
            parts.push(format!(
                "com = {}, mass = {}, inertia = {}",
                pair(place(mass.centre), format),
                given(mass.mass),
                computed(mass.inertia)
            ));
        }
        format!(
            "{} = {{ {} }}",
            key(&self.names.links[link]),
            parts.join(", ")
        )
    }

    /// Returns the named point of a guide, if its carrier has that point.
    fn through(&self, through: Option<usize>, on: DrawnPart) -> Option<usize> {
        through.filter(|point| match on {
            DrawnPart::Frame => self.drawing.ground.contains(point),
            DrawnPart::Link(link) => self.drawing.links[link].points.contains(point),
        })
    }

    /// Computes where a guide passes, and the position on it in the opening pose.
    fn guide(&self, slide: usize) -> GuidePlace {
        let drawing = self.drawing;
        let drawn = &drawing.slides[slide];
        let at = match drawn.slider {
            DrawnSlider::Pin(pin) => drawing.points[pin].at,
            DrawnSlider::Link { link, .. } => self.frames[link].origin,
        };
        let through = self.through(drawn.through, drawn.on);
        let Some(through) = through else {
            return GuidePlace {
                named: None,
                at: self.local(drawn.on, at),
                position: 0.0,
            };
        };
        let [cos, sin] = unit(drawn.angle);
        let [dx, dy] = difference(at, drawing.points[through].at);
        let position = dx * cos + dy * sin;
        // The pin may be drawn next to the point's line: the guide passes through the pin.
        let is_on_line = (dx * sin - dy * cos).abs() <= ON_LINE * self.size;
        let foot = difference(at, [position * cos, position * sin]);
        GuidePlace {
            named: is_on_line.then_some(through),
            at: self.local(drawn.on, foot),
            position,
        }
    }

    /// Returns the coordinates of a place in the frame of a part, without rounding errors next to
    /// zero.
    fn local(&self, part: DrawnPart, at: [f64; 2]) -> [f64; 2] {
        let local = self.frame_of(part).local(at);
        local.map(|x| if x.abs() <= NOISE * self.size { 0.0 } else { x })
    }

    /// Returns the place of a guide as written: a name in quotes, or coordinates.
    fn through_text(&self, slide: usize) -> String {
        let guide = self.guide(slide);
        match guide.named {
            Some(point) => toml_string(self.point(point)),
            None => pair(guide.at, computed),
        }
    }

    fn slides(&mut self) {
        if self.drawing.slides.is_empty() {
            return;
        }
        self.line("\n[slides]");
        for slide in 0..self.drawing.slides.len() {
            let drawn = &self.drawing.slides[slide];
            let carrier = self.frame_of(drawn.on);
            let (slider, turn) = match drawn.slider {
                DrawnSlider::Pin(pin) => {
                    (format!("point = {}", toml_string(self.point(pin))), None)
                }
                DrawnSlider::Link { link, .. } => (
                    format!("link = {}", toml_string(&self.names.links[link])),
                    Some(wrapped(self.frames[link].angle - drawn.angle)),
                ),
            };
            let turn = turn.map_or(String::new(), |turn| format!(", turn = {}", computed(turn)));
            let line = format!(
                "{} = {{ {slider}, on = {}, through = {}, angle = {}{turn} }}",
                key(&self.names.slides[slide]),
                toml_string(self.part(drawn.on)),
                self.through_text(slide),
                computed(wrapped(drawn.angle - carrier.angle)),
            );
            self.line(&line);
        }
    }

    /// Writes the ends of the travel of slides and links.
    fn limits(&mut self) {
        let drawing = self.drawing;
        let style = self.style.limits;
        if style == LimitStyle::Omitted {
            return;
        }
        let ends = |opening: f64, [low, high]: [f64; 2], looseness: f64| {
            // The opening is rounded as written, so that a driver at an end is exactly there.
            let opening: f64 = computed(opening).parse().unwrap_or(opening);
            let loosened = |end: f64, by: f64| match style == LimitStyle::Loose && end == 0.0 {
                true => opening + by,
                false => opening + end,
            };
            let ends = [loosened(low, -looseness), loosened(high, looseness)];
            // The difference of an opening and a travel that cancel is a rounding error.
            let noise = END_NOISE * self.size;
            pair(
                ends.map(|end| if end.abs() <= noise { 0.0 } else { end }),
                computed,
            )
        };
        let mut lines = Vec::new();
        let slides = drawing.slides.iter().zip(&self.names.slides);
        for (number, (slide, name)) in slides.enumerate() {
            if let Some(travel) = slide.travel {
                let ends = ends(self.guide(number).position, travel, LOOSENESS * self.size);
                lines.push(format!("{} = {ends}", key(name)));
            }
        }
        for (limit, name) in drawing.angle_limits.iter().zip(&self.names.angle_limits) {
            let (link, from) = (limit.link, limit.from);
            let opening = self.opening(InputElement::Turn { link, from });
            let ends = ends(opening, limit.travel, LOOSE_ANGLE);
            lines.push(match from {
                DrawnPart::Frame => format!("{} = {ends}", key(name)),
                from => format!(
                    "{} = {{ link = {}, from = {}, angle = {ends} }}",
                    key(name),
                    toml_string(&self.names.links[link]),
                    toml_string(self.part(from)),
                ),
            });
        }
        if !lines.is_empty() {
            self.line(&format!("\n[limits]   # {}", words().import_limits()));
            for line in lines {
                self.line(&line);
            }
        }
    }

    /// Writes the positions of the moving points, which are those of the drawing.
    fn start(&mut self) {
        let drawing = self.drawing;
        let ground: HashSet<usize> = drawing.ground.iter().copied().collect();
        let pins = drawing
            .slides
            .iter()
            .filter_map(|slide| match slide.slider {
                DrawnSlider::Pin(pin) => Some(pin),
                DrawnSlider::Link { .. } => None,
            });
        let links = drawing
            .links
            .iter()
            .flat_map(|link| link.points.iter().copied());
        let named: HashSet<usize> = links.chain(pins).collect();
        let moving: Vec<usize> = (0..drawing.points.len())
            .filter(|point| named.contains(point) && !ground.contains(point))
            .collect();
        self.places("start", words().import_start(), &moving);
    }

    fn loads(&mut self) {
        for load in &self.drawing.loads {
            let frame = load.turns_with.filter(|&link| self.is_kept(link));
            let force = match frame {
                Some(link) => {
                    let [cos, sin] = unit(self.frames[link].angle);
                    let [x, y] = load.force;
                    pair([x * cos + y * sin, y * cos - x * sin], computed)
                }
                None => pair(load.force, computed),
            };
            let point = toml_string(self.point(load.point));
            self.line(&format!("\n[[loads]]\npoint = {point}\nforce = {force}"));
            if let Some(link) = frame {
                let line = format!("frame = {}", toml_string(&self.names.links[link]));
                self.line(&line);
            }
        }
    }
}

/// Where a guide passes.
struct GuidePlace {
    /// A point of the carrier on the guide.
    named: Option<usize>,
    /// Coordinates in the frame of the carrier.
    at: [f64; 2],
    /// The position in the opening pose, measured from there.
    position: f64,
}

/// Returns the ratio of two inputs; `None` if one does not follow the other linearly.
pub(super) fn ratio(driver: &DrawnLaw, input: &DrawnLaw) -> Option<f64> {
    match (driver, input) {
        (DrawnLaw::Unknown, DrawnLaw::Unknown) => Some(1.0),
        (DrawnLaw::Speed(leading, _), DrawnLaw::Speed(speed, _)) if *leading != 0.0 => {
            Some(speed / leading)
        }
        (DrawnLaw::Speed(..), DrawnLaw::Speed(..)) => Some(0.0),
        (
            DrawnLaw::Sine {
                amplitude: leading,
                time,
                phase,
            },
            DrawnLaw::Sine {
                amplitude,
                time: same_time,
                phase: other,
            },
        ) if time == same_time && *leading != 0.0 => match (other - phase).rem_euclid(360.0) {
            0.0 => Some(amplitude / leading),
            180.0 => Some(-amplitude / leading),
            _ => None,
        },
        _ => None,
    }
}
