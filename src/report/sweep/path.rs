//! Rows at given coordinates of all inputs, or of points that the inputs follow, from a file.

use super::{Columns, SweepOutcome};
use crate::quantity::{Aspect, Catalogue, demand};
use crate::report::text::cells::ReadCells;
use crate::report::text::rows::{RowFormat, RowWriter};
use crate::scene::{Scene, with_point};
use crate::solver::{Condition, FreeInputs, PointLeader, Solver};
use crate::wording::words;
use crate::{CoordinateAxis, Input, PointId, PointLead};
use std::io::{self, Write};

/// Maximum number of rows.
const MAX_ROWS: usize = 100_000;

/// The coordinates of all inputs row by row, or those of points that inputs follow.
#[derive(Clone, Debug, PartialEq)]
pub struct InputPath {
    rows: Vec<PathRow>,
    /// The leading coordinates; `None` if every row gives the inputs.
    lead: Option<PointLead>,
}

/// A row of a path.
#[derive(Clone, Debug, PartialEq)]
struct PathRow {
    /// The coordinates of all inputs, the driver's first; placeholders for those that follow a point.
    inputs: Vec<f64>,
    /// The leading coordinates.
    targets: Vec<f64>,
}

/// The meaning of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
enum PathColumn {
    /// The coordinate of the input with this index.
    Input(usize),
    /// A coordinate of a point.
    Point(PointId, CoordinateAxis),
}

impl PathColumn {
    /// Returns the meaning of a header: the name of an input, a coordinate of a point such as `P.x`,
    /// or the header of an input's coordinate in a sweep, such as `r5.angle [deg]`.
    fn of(scene: &Scene, header: &str) -> Result<PathColumn, String> {
        let (name, unit) = match header
            .strip_suffix(']')
            .and_then(|head| head.split_once('['))
        {
            Some((name, unit)) => (name.trim(), Some(unit.trim())),
            None => (header, None),
        };
        let mechanism = &scene.mechanism;
        let (column, own) = match leading_coordinate(scene, name) {
            Some((point, axis)) => (PathColumn::Point(point, axis), scene.unit.symbol()),
            None => {
                let input = input_of_header(scene, name)?;
                let index = mechanism.inputs().position(|other| other == input);
                let own = scene.input_unit(input);
                (PathColumn::Input(index.unwrap_or_default()), own)
            }
        };
        match unit.filter(|unit| *unit != own) {
            Some(unit) => Err(words().path_has_other_unit(name, unit, own)),
            None => Ok(column),
        }
    }
}

/// Returns the moving point and the axis of a column such as `P.x`.
fn leading_coordinate(scene: &Scene, name: &str) -> Option<(PointId, CoordinateAxis)> {
    let (name, axis) = name.rsplit_once('.')?;
    let axis = match axis {
        "x" => CoordinateAxis::X,
        "y" => CoordinateAxis::Y,
        _ => return None,
    };
    let mut moving = scene.mechanism.point_ids();
    let point = moving.find(|&point| {
        scene.point_name(point) == Some(name) && scene.mechanism.point(point).ground.is_none()
    })?;
    Some((point, axis))
}

/// Returns the input of a column: its name, or the name of its coordinate in a sweep.
fn input_of_header(scene: &Scene, name: &str) -> Result<Input, String> {
    let (mechanism, catalogue) = (&scene.mechanism, Catalogue::new(scene));
    let is_headed = |input: Input| match input {
        _ if input == mechanism.driver().input => catalogue.driver().name == name,
        // The angle of another link is not its coordinate: that is relative to its motor's link.
        Input::Turn(link) => {
            let angle = format!("{}.{}", scene.link_name(link), Aspect::Angle.name());
            mechanism.is_directed(link) && angle == name
        }
        Input::Push(slide) => {
            format!("{}.{}", scene.slide_name(slide), Aspect::Length.name()) == name
        }
    };
    match mechanism.inputs().find(|&input| is_headed(input)) {
        Some(input) => Ok(input),
        None => scene.input_named(name),
    }
}

impl InputPath {
    /// Parses a table with a column for each input, named after its link or slide. A driver
    /// without a column stays where the scene opens; any other input then follows the driver.
    ///
    /// Columns such as `P.x` and `P.y` lead: as many inputs, which have no column, follow the point.
    ///
    /// # Errors
    /// Returns a message with the line of the first fault.
    pub fn read(scene: &Scene, bytes: &[u8]) -> Result<InputPath, String> {
        let ReadCells { rows, lines, .. } =
            ReadCells::read(bytes, MAX_ROWS + 1).ok_or_else(|| words().path_too_long(MAX_ROWS))?;
        let mechanism = &scene.mechanism;
        let opening = mechanism.driver().start;
        let at = mechanism
            .inputs()
            .map(|input| mechanism.input_coordinate(input, opening));
        let at: Vec<f64> = at.map(Option::unwrap_or_default).collect();
        let mut rows = rows.into_iter().zip(lines);
        let names = rows.next().map_or(Vec::new(), |(names, _)| names);
        let mut columns = Vec::with_capacity(names.len());
        for name in &names {
            let column = PathColumn::of(scene, name)?;
            if columns.contains(&column) {
                return Err(words().path_names_twice(name));
            }
            columns.push(column);
        }
        let lead = lead(scene, &columns)?;
        let row = |(cells, line): (Vec<String>, u64)| {
            if cells.len() != names.len() {
                return Err(words().path_row_has_cells(line, cells.len(), names.len()));
            }
            let (mut inputs, mut targets) = (at.clone(), Vec::new());
            for ((cell, column), name) in cells.iter().zip(&columns).zip(&names) {
                let number = with_point(cell).and_then(|cell| cell.parse::<f64>().ok());
                let number = number.filter(|number| number.is_finite());
                let number = number.ok_or_else(|| words().path_cell(line, name, cell))?;
                match column {
                    PathColumn::Point(..) => targets.push(number),
                    PathColumn::Input(index) => {
                        if let Some(place) = inputs.get_mut(*index) {
                            *place = number;
                        }
                    }
                }
            }
            let driven = inputs.first().copied().unwrap_or(opening);
            for ((index, input), place) in mechanism.inputs().enumerate().zip(&mut inputs) {
                if lead.is_none() && !columns.contains(&PathColumn::Input(index)) {
                    *place = mechanism.input_coordinate(input, driven).unwrap_or(*place);
                }
            }
            Ok(PathRow { inputs, targets })
        };
        let rows: Vec<PathRow> = rows.map(row).collect::<Result<_, String>>()?;
        match rows.is_empty() {
            true => Err(words().path_is_empty().to_owned()),
            false => Ok(InputPath { rows, lead }),
        }
    }

    /// Solves and writes all rows. The inputs move from row to row, on a straight line of the leading
    /// coordinates or of their own. Each row keeps the assembly of the previous one, and continues
    /// from the last one before an edge of the workspace; a row that cannot be reached has no values.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(
        &self,
        (scene, solver): (&Scene, &Solver),
        columns: &Columns,
        format: RowFormat,
        to: impl Write,
    ) -> io::Result<SweepOutcome> {
        let table = columns.table(format);
        let head = table.head(&scene.name, "rows", columns.units);
        let mut rows = RowWriter::new(table, &head, to)?;
        let (_, order) = demand(&columns.quantities);
        let mut outcome = SweepOutcome::default();
        let mut moved = match &self.lead {
            Some(lead) => PointLeader::new(solver, lead.clone()).map(MovedInputs::ByPoint),
            None => solver.free_inputs().map(MovedInputs::Directly),
        };
        for row in &self.rows {
            outcome.rows += 1;
            let given = self.lead.is_none().then(|| row.inputs.first().copied());
            let mut cells = vec![given.flatten()];
            cells.resize(columns.quantities.len(), None);
            let mut condition = Condition::NoAssembly;
            match &mut moved {
                Some(MovedInputs::ByPoint(leader)) => {
                    if let Some(pose) = leader.move_to(&row.inputs, &row.targets) {
                        condition = pose.condition;
                        let quantities = columns.quantities.iter();
                        cells = quantities.map(|q| q.value(leader.state())).collect();
                        outcome.note_singular(pose.singularity);
                    }
                }
                Some(MovedInputs::Directly(free)) => {
                    condition = free.moved(&row.inputs, order);
                    if condition != Condition::NoAssembly {
                        free.keep(&row.inputs);
                        let quantities = columns.quantities.iter();
                        cells = quantities.map(|q| q.value(free.state())).collect();
                    }
                }
                None => {}
            }
            outcome.valued += u64::from(condition != Condition::NoAssembly);
            rows.state_row(&cells, condition)?;
        }
        rows.finish()?;
        Ok(outcome)
    }
}

/// The inputs that the rows move.
enum MovedInputs {
    Directly(FreeInputs),
    ByPoint(PointLeader),
}

/// Returns the leading coordinates of the columns, and the inputs without a column, which follow
/// them. There must be as many.
fn lead(scene: &Scene, columns: &[PathColumn]) -> Result<Option<PointLead>, String> {
    let leading = columns.iter().filter_map(|column| match *column {
        PathColumn::Point(point, axis) => Some((point, axis)),
        PathColumn::Input(_) => None,
    });
    let coordinates: Vec<(PointId, CoordinateAxis)> = leading.collect();
    if coordinates.is_empty() {
        return Ok(None);
    }
    let free = scene.mechanism.inputs().enumerate();
    let free = free.filter(|(index, _)| !columns.contains(&PathColumn::Input(*index)));
    let (inputs, names): (Vec<usize>, Vec<&str>) = free
        .map(|(index, input)| (index, scene.input_name(input)))
        .unzip();
    if inputs.len() != coordinates.len() {
        let (leading, free) = (coordinates.len(), inputs.len());
        return Err(words().path_leads_other_number(leading, free, &names.join(", ")));
    }
    Ok(Some(PointLead {
        coordinates,
        inputs,
    }))
}
