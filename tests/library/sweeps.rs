//! Checks that rows solved several at a time equal rows solved one by one.

use krank::quantity::{Catalogue, Quantity, state_word};
use krank::report::{Columns, CsvDialect, RowFormat, Steps, Sweep, WrittenDecimal};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver};

fn decimal(value: f64) -> WrittenDecimal {
    WrittenDecimal::of(value).unwrap()
}

/// Returns the cells of a sweep over all values; the last cell of a row is the state.
fn swept(
    scene: &Scene,
    solver: &Solver,
    quantities: &[Quantity],
    steps: &Steps,
) -> Vec<Vec<String>> {
    let catalogue = Catalogue::new(scene);
    let columns = Columns::new(catalogue.driver(), quantities, false);
    let sweep = Sweep {
        scene,
        solver,
        columns: &columns,
        steps,
        clock: None,
        format: RowFormat::Csv(CsvDialect::default()),
    };
    let mut csv = Vec::new();
    let mut count = 0;
    let outcome = sweep.write(&mut csv, &mut |rows| count = rows).unwrap();
    assert_eq!(outcome.rows, steps.count());
    assert!(count <= outcome.rows && outcome.rows - count < 2048);
    let csv = String::from_utf8(csv).unwrap();
    let rows = csv.lines().skip(1);
    rows.map(|row| row.split(',').map(str::to_owned).collect())
        .collect()
}

/// Compares every row with the same state, solved alone.
fn agree(scene: &Scene, steps: &Steps) {
    let solver = Solver::new(&scene.mechanism).unwrap();
    let catalogue = Catalogue::new(scene);
    let unlisted = catalogue.unlisted();
    let quantities: Vec<Quantity> = catalogue.all().iter().chain(&unlisted).cloned().collect();
    let rows = swept(scene, &solver, &quantities, steps);
    assert_eq!(rows.len() as u64, steps.count());
    let mut state = solver.state();
    for (at, row) in steps.iter().zip(rows) {
        let condition = solver.solve(at, Order::Force, &mut state);
        assert_eq!(
            row.last().unwrap(),
            state_word(condition),
            "{} at {at}",
            scene.name
        );
        for (quantity, cell) in quantities.iter().zip(row) {
            let bits = |v: f64| (v + 0.0).to_bits();
            let value = quantity.value(&state).map(bits);
            let written = cell.parse().ok().map(bits);
            assert_eq!(written, value, "{}: {} at {at}", scene.name, quantity.name);
        }
    }
}

/// Covers the motion, its limits and change points, and a little beyond.
#[test]
fn swept_rows_equal_single_solutions_bit_for_bit() {
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let (low, high) = match Solver::new(&scene.mechanism).unwrap().motion().range {
            Range::Full { period } => (-30.0, period),
            Range::Limited { low, high } => (low, high),
        };
        let step = (high - low) / 777.0;
        let [from, to] = [low - 3.0 * step, high + 3.0 * step];
        agree(
            &scene,
            &Steps::new(decimal(from), decimal(to), decimal(step)).unwrap(),
        );
        agree(
            &scene,
            &Steps::new(decimal(low), decimal(high), decimal(step))
                .unwrap()
                .ending_on(high),
        );
    }
}

/// Covers fewer rows than are solved at a time, and multiples of ten degrees through the change
/// points.
#[test]
fn short_sweeps_and_round_angles_equal_single_solutions() {
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let start = scene.mechanism.driver().start;
        for rows in 0..20 {
            let to = decimal(start + 1e-3 * f64::from(rows));
            agree(
                &scene,
                &Steps::new(decimal(start), to, decimal(1e-3)).unwrap(),
            );
        }
        let complete = Steps::new(decimal(-200.0), decimal(800.0), decimal(10.0));
        agree(&scene, &complete.unwrap());
    }
}

#[test]
fn solving_lanes_allocates_nothing() {
    let preset = presets::find("jansen-leg").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut lanes = solver.lanes();
    let at = std::array::from_fn(|lane| 10.0 * lane as f64);
    let mut catalogue = Catalogue::new(&scene);
    catalogue.define("sum = hypot(T.vx, T.vy) + T.v").unwrap();
    let quantities = ["T.a.t", "sum.rate"].map(|name| catalogue.find(name).unwrap());
    let info = allocation_counter::measure(|| {
        assert!(solver.solve_lanes(at, Order::Acceleration, &mut lanes));
        assert!(
            quantities
                .iter()
                .all(|quantity| quantity.value(&lanes).is_some())
        );
    });
    assert_eq!(info.count_total, 0);
}

/// A vector between two coincident points has no direction there, but has one in the neighbouring
/// rows.
#[test]
fn missing_value_in_one_row_leaves_neighbours_intact() {
    let text = r#"
name = "A crank that meets a post"
[ground]
A = [0, 0]
P = [1, 0]
[driver]
link = "r2"
angle = 60
[links]
r2 = { from = "A", to = "B", length = 1 }
r3 = { from = "B", to = "C", length = 3 }
[slides]
r4 = { point = "C", on = "ground", through = "A" }
[start]
C = [3, 0]
[vectors]
gap = ["P", "B"]
"#;
    let scene = Scene::parse(text, "post").unwrap();
    let steps = Steps::new(decimal(-4.0), decimal(4.0), decimal(1.0)).unwrap();
    agree(&scene, &steps);
    let solver = Solver::new(&scene.mechanism).unwrap();
    let quantities = Catalogue::new(&scene).select(&["gap.omega"]).unwrap();
    let rows = swept(&scene, &solver, &quantities, &steps);
    let empty: Vec<bool> = rows.iter().map(|row| row[1].is_empty()).collect();
    assert_eq!(
        empty,
        [false, false, false, false, true, false, false, false, false]
    );
    assert!(rows.iter().all(|row| row[2] == state_word(Condition::Ok)));
}
