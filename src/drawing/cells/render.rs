//! Renders a figure into cells.

use super::arrow;
use super::blocks::{self, Blocks};
use super::labels::Labels;
use super::raster::Raster;
use super::symbol::Symbols;
use super::trace;
use crate::Vec2;
use crate::drawing::figure::{Figure, Role, Shape};
use crate::drawing::view::WorldView;

/// The set of glyphs of a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Glyphs {
    /// Line art in 7-bit characters.
    #[default]
    Ascii,
    /// Box-drawing characters that console fonts have.
    Line,
    /// Braille dots, 2 x 4 per cell, with characters for the joints.
    Braille,
    /// Block characters without gaps between them. The font must have them, which cannot be
    /// detected.
    Blocks(Blocks),
}

impl Glyphs {
    /// All sets of glyphs.
    pub(crate) const ALL: [Glyphs; 6] = [
        Glyphs::Ascii,
        Glyphs::Line,
        Glyphs::Braille,
        Glyphs::Blocks(Blocks::Quadrants),
        Glyphs::Blocks(Blocks::Sextants),
        Glyphs::Blocks(Blocks::Octants),
    ];

    /// Returns the name in options and in the configuration.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Glyphs::Ascii => "ascii",
            Glyphs::Line => "line",
            Glyphs::Braille => "braille",
            Glyphs::Blocks(Blocks::Quadrants) => "quadrants",
            Glyphs::Blocks(Blocks::Sextants) => "sextants",
            Glyphs::Blocks(Blocks::Octants) => "octants",
        }
    }

    /// Returns `true` if lines consist of dots finer than cells.
    pub(crate) fn is_dotted(self) -> bool {
        matches!(self, Glyphs::Braille | Glyphs::Blocks(_))
    }
}

/// The layers from bottom to top.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PaintLayer {
    Ghosts,
    Traces,
    Ground,
    Guides,
    Plates,
    Springs,
    Links,
    Driver,
    Lit,
    Blocks,
    Arrows,
    Marks,
    Labels,
}

const LAYERS: [PaintLayer; 12] = [
    PaintLayer::Ghosts,
    PaintLayer::Traces,
    PaintLayer::Ground,
    PaintLayer::Guides,
    PaintLayer::Plates,
    PaintLayer::Springs,
    PaintLayer::Links,
    PaintLayer::Driver,
    PaintLayer::Lit,
    PaintLayer::Blocks,
    PaintLayer::Arrows,
    PaintLayer::Marks,
];

fn layer(shape: &Shape) -> PaintLayer {
    match shape {
        Shape::Support { .. } | Shape::Hatching { .. } => PaintLayer::Ground,
        Shape::Line { role, .. } | Shape::Outline { role, .. } => match role {
            Role::Guide => PaintLayer::Guides,
            Role::Ghost | Role::Echo => PaintLayer::Ghosts,
            Role::Driver => PaintLayer::Driver,
            Role::Lit => PaintLayer::Lit,
            _ => PaintLayer::Links,
        },
        Shape::Guide {
            role: Role::Lit, ..
        } => PaintLayer::Lit,
        Shape::Guide { .. } => PaintLayer::Guides,
        Shape::Barrel { .. } | Shape::Rod { .. } => PaintLayer::Driver,
        Shape::Plate { .. } => PaintLayer::Plates,
        Shape::Spring { .. } => PaintLayer::Springs,
        Shape::Block { .. } => PaintLayer::Blocks,
        Shape::Trace { .. } => PaintLayer::Traces,
        Shape::Arrow { .. } | Shape::Moment { .. } => PaintLayer::Arrows,
        Shape::Mark { .. } => PaintLayer::Marks,
        Shape::Label { .. } => PaintLayer::Labels,
    }
}

/// Renders a figure into a raster of the view's size. The raster's memory is reused.
///
/// `labels` stores the place of each label, so that it changes sides from frame to frame only if
/// necessary. A single picture needs a new one.
pub fn render_into(
    figure: &Figure,
    view: &WorldView,
    glyphs: Glyphs,
    labels: &mut Labels,
    raster: &mut Raster,
) {
    render_bare(figure, view, glyphs, raster);
    labels.place(figure, view, raster);
}

/// Renders a figure without its names.
pub(in crate::drawing) fn render_bare(
    figure: &Figure,
    view: &WorldView,
    glyphs: Glyphs,
    raster: &mut Raster,
) {
    raster.reset(view.cols(), view.rows());
    let mut symbols = Symbols {
        view,
        glyphs,
        raster,
    };
    for shape in draw_order(figure) {
        draw(&mut symbols, shape);
    }
    blocks::settle(raster, glyphs);
}

/// Returns the shapes of a figure without its names, from bottom to top.
pub(in crate::drawing) fn draw_order(figure: &Figure) -> impl Iterator<Item = &Shape> {
    let of = |current| move |shape: &&Shape| layer(shape) == current;
    LAYERS
        .into_iter()
        .flat_map(move |current| figure.shapes().iter().filter(of(current)))
}

/// Renders a single picture.
#[must_use]
pub fn render(figure: &Figure, view: &WorldView, glyphs: Glyphs) -> Raster {
    let mut raster = Raster::new();
    render_into(figure, view, glyphs, &mut Labels::default(), &mut raster);
    raster
}

fn draw(symbols: &mut Symbols<'_>, shape: &Shape) {
    match *shape {
        Shape::Line { from, to, role } => {
            let (a, b) = (symbols.view.cell(from), symbols.view.cell(to));
            symbols.bar(a, b, role);
        }
        Shape::Outline { ref corners, role } => {
            let corners: Vec<Vec2> = corners.iter().map(|&c| symbols.view.cell(c)).collect();
            symbols.outline(&corners, role);
        }
        Shape::Plate { ref corners, role } => {
            let corners: Vec<Vec2> = corners.iter().map(|&c| symbols.view.cell(c)).collect();
            symbols.plate(&corners, role);
        }
        Shape::Spring { from, to } => symbols.spring(from, to),
        Shape::Barrel { from, to, role } => symbols.barrel(from, to, role),
        Shape::Rod { from, to, role } => symbols.rod(from, to, role),
        Shape::Guide { from, to, role } => symbols.guide(from, to, role),
        Shape::Mark { at, role } => symbols.mark(at, role),
        Shape::Support { at } => symbols.support(at),
        Shape::Hatching { from, to } => symbols.hatching(from, to),
        Shape::Block { at, along } => symbols.block(at, along),
        Shape::Trace { ref course, role } => {
            trace::draw(symbols.raster, symbols.glyphs, symbols.view, course, role);
        }
        Shape::Arrow {
            from,
            to,
            role,
            cut,
        } => {
            let ends = [from, to].map(|p| symbols.view.cell(p));
            arrow::draw(
                symbols.raster,
                symbols.glyphs,
                symbols.view.aspect(),
                ends,
                role,
                cut,
            );
        }
        Shape::Moment { at, is_left } => symbols.moment(at, is_left),
        // Names are drawn last, when everything that they must avoid is in place.
        Shape::Label { .. } => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Extents;
    use proptest::prelude::*;

    fn place() -> impl Strategy<Value = Vec2> {
        let coordinate = || {
            prop_oneof![
                8 => -20.0..20.0,
                1 => any::<f64>(),
                1 => prop::sample::select(vec![0.0, 1e300, -1e300, f64::NAN, f64::INFINITY]),
            ]
        };
        (coordinate(), coordinate()).prop_map(|(x, y)| Vec2::new(x, y))
    }

    fn shape() -> impl Strategy<Value = Shape> {
        let role = || {
            prop::sample::select(vec![
                Role::Ground,
                Role::Guide,
                Role::Link(2),
                Role::Driver,
                Role::Lit,
                Role::Ghost,
                Role::Plate(2),
                Role::DriverPin,
                Role::Joint,
                Role::Slider,
                Role::Label,
            ])
        };
        prop_oneof![
            (place(), place(), role()).prop_map(|(from, to, role)| Shape::Line { from, to, role }),
            (prop::collection::vec(place(), 0..5), role())
                .prop_map(|(corners, role)| Shape::Outline { corners, role }),
            (place(), place(), role()).prop_map(|(from, to, role)| Shape::Barrel {
                from,
                to,
                role
            }),
            (prop::collection::vec(place(), 0..5), role())
                .prop_map(|(corners, role)| Shape::Plate { corners, role }),
            (place(), place()).prop_map(|(from, to)| Shape::Spring { from, to }),
            (place(), role()).prop_map(|(at, role)| Shape::Mark { at, role }),
            place().prop_map(|at| Shape::Support { at }),
            (place(), place(), role()).prop_map(|(from, to, role)| Shape::Guide { from, to, role }),
            (place(), place()).prop_map(|(from, to)| Shape::Hatching { from, to }),
            (place(), place()).prop_map(|(at, along)| Shape::Block { at, along }),
            prop::collection::vec(place(), 0..9).prop_map(|course| Shape::Trace {
                course: course.into(),
                role: Role::Trace,
            }),
            (place(), place(), any::<[bool; 2]>()).prop_map(|(from, to, [twice, cut])| {
                let role = if twice {
                    Role::Acceleration
                } else {
                    Role::Velocity
                };
                Shape::Arrow {
                    from,
                    to,
                    role,
                    cut,
                }
            }),
            (place(), "[ -~]{0,12}", role()).prop_map(|(at, text, role)| Shape::Label {
                at,
                text,
                role
            }),
        ]
    }

    proptest! {
        #[test]
        fn any_figure_renders_at_any_size(
            shapes in prop::collection::vec(shape(), 0..30),
            points in prop::collection::vec(place(), 0..4),
            (cols, rows) in prop_oneof![(0_u16..12, 0_u16..6), (0_u16..400, 0_u16..200)],
            (at, centre) in (-400.0..400.0, place()),
            glyphs in prop::sample::select(Glyphs::ALL.to_vec()),
        ) {
            let mut figure = Figure::new();
            shapes.into_iter().for_each(|shape| figure.add(shape));
            let extents = Extents::of_places(&points, &points);
            let complete = WorldView::fit(&extents, cols, rows, 2.0);
            let views = [
                complete,
                WorldView::along(&extents, at, cols, rows, 2.0),
                WorldView::pose(&extents, at, cols, rows, 2.0),
                complete.centred_on(centre),
            ];
            let (mut labels, mut raster) = (Labels::default(), Raster::new());
            for view in views {
                render_into(&figure, &view, glyphs, &mut labels, &mut raster);
                prop_assert_eq!((raster.cols(), raster.rows()), (cols, rows));
                prop_assert_eq!(raster.lines().flatten().count(), usize::from(cols) * usize::from(rows));
            }
        }
    }

    /// Returns a view of 20 x 10 cells in which one unit of length is one column.
    fn view() -> WorldView {
        let corners = [Vec2::ZERO, Vec2::new(12.0, 10.0)];
        WorldView::fit(&Extents::of_places(&corners, &[]), 20, 10, 2.0)
    }

    fn line(from: Vec2, to: Vec2, role: Role) -> Shape {
        Shape::Line { from, to, role }
    }

    #[test]
    fn later_links_cover_earlier_ones_and_marks_cover_both() {
        let (low, high) = (Vec2::ZERO, Vec2::new(12.0, 10.0));
        let (left, right) = (Vec2::new(0.0, 10.0), Vec2::new(12.0, 0.0));
        let middle = Vec2::new(6.0, 5.0);
        let at_middle = |figure: &Figure, glyphs| {
            let at = view().cell(middle);
            let raster = render(figure, &view(), glyphs);
            raster
                .cell(at.x.floor() as i32, at.y.floor() as i32)
                .expect("the middle lies inside")
        };
        let mut figure = Figure::new();
        let (at, role) = (middle, Role::Joint);
        figure.add(line(low, high, Role::Link(1)));
        figure.add(line(left, right, Role::Link(0)));
        assert_eq!(at_middle(&figure, Glyphs::Ascii).role, Role::Link(0));
        figure.add(line(low, high, Role::Guide));
        assert_eq!(at_middle(&figure, Glyphs::Ascii).role, Role::Link(0));
        // The driver covers all links, in whatever order they are added.
        let mut driven = Figure::new();
        driven.add(line(low, high, Role::Driver));
        driven.add(line(left, right, Role::Link(0)));
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            assert_eq!(at_middle(&driven, glyphs).role, Role::Driver);
        }
        let mut marked = Figure::new();
        marked.add(Shape::Mark { at, role });
        figure.shapes().iter().for_each(|s| marked.add(s.clone()));
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            assert_eq!(at_middle(&marked, glyphs).glyph, 'o');
        }
    }

    #[test]
    fn crossing_lines_share_dots_of_a_cell() {
        let dots = |lines: &[(f64, f64, f64, f64)]| {
            let mut figure = Figure::new();
            for &(ax, ay, bx, by) in lines {
                figure.add(line(Vec2::new(ax, ay), Vec2::new(bx, by), Role::Link(0)));
            }
            let raster = render(&figure, &view(), Glyphs::Braille);
            raster
                .lines()
                .flatten()
                .map(|cell| (u32::from(cell.glyph) | 0x2800) & 0xff)
                .map(|pattern| {
                    if pattern == u32::from(' ') {
                        0
                    } else {
                        pattern
                    }
                })
                .collect::<Vec<_>>()
        };
        let (rising, falling) = ((0.0, 0.0, 12.0, 10.0), (0.0, 10.0, 12.0, 0.0));
        let both = dots(&[rising, falling]);
        let distance = dots(&[rising]).into_iter().zip(dots(&[falling]));
        assert_eq!(both, distance.map(|(a, b)| a | b).collect::<Vec<_>>());
    }
}
