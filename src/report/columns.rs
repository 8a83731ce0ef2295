//! The columns of a sweep: figures, and behind each what is known of its errors.

use super::answers::per;
use crate::quantity::Quantity;

/// What a sweep says of each figure beside its value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Beside {
    /// What its error does not exceed: `C.x.bound`.
    pub bounds: bool,
    /// By how much it is off at the worst where every given length is off by one unit:
    /// `C.x.sensitivity`.
    pub sensitivity: bool,
}

/// Where the cells of a column come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CellSource {
    /// The figure itself.
    Figure,
    /// What its error does not exceed.
    Bound,
    /// What the given lengths do to the figure with this number among the figures of the sweep.
    Sensitivity(usize),
    /// By how much a measured figure is more.
    Difference,
}

/// The columns of a sweep: the driver's coordinate, the figures asked for, what is said beside them, and
/// the state.
#[derive(Clone, Debug)]
pub struct Columns {
    /// The driver's coordinate first. Beside a figure there is the same again under another name.
    pub(super) quantities: Vec<Quantity>,
    /// For each where its cells come from.
    pub(super) sources: Vec<CellSource>,
    /// The figures alone, without the driver's coordinate.
    pub(super) figures: Vec<Quantity>,
    pub(super) beside: Beside,
    pub(super) units: bool,
}

impl Columns {
    /// The driver's coordinate and these figures; the headers bear units if asked.
    #[must_use]
    pub fn new(driver: &Quantity, figures: &[Quantity], units: bool) -> Self {
        let figures = figures.iter().filter(|q| !q.is_driver());
        let figures: Vec<Quantity> = figures.cloned().collect();
        let quantities: Vec<Quantity> = std::iter::once(driver).chain(&figures).cloned().collect();
        Columns {
            sources: vec![CellSource::Figure; quantities.len()],
            quantities,
            figures,
            beside: Beside::default(),
            units,
        }
    }

    /// The same, with more said of each figure; `length` is the symbol of the length unit. The driver's
    /// coordinate is as it was asked.
    #[must_use]
    pub fn with(mut self, beside: Beside, length: &str) -> Self {
        self.beside = beside;
        self.quantities.truncate(1);
        self.sources.truncate(1);
        for (number, figure) in self.figures.iter().enumerate() {
            let named = |ending: &str, unit: String| Quantity {
                name: format!("{}.{ending}", figure.name),
                unit,
                ..figure.clone()
            };
            self.quantities.push(figure.clone());
            self.sources.push(CellSource::Figure);
            if beside.bounds {
                self.quantities.push(named("bound", figure.unit.clone()));
                self.sources.push(CellSource::Bound);
            }
            if beside.sensitivity {
                let unit = per(&figure.unit, length);
                self.quantities.push(named("sensitivity", unit));
                self.sources.push(CellSource::Sensitivity(number));
            }
        }
        self
    }

    /// The same with time first.
    #[must_use]
    pub fn over_time(mut self) -> Self {
        let time = self.quantities.first().map(|driver| Quantity {
            name: "time".to_owned(),
            unit: "s".to_owned(),
            ..driver.clone()
        });
        self.quantities.splice(0..0, time);
        self.sources.insert(0, CellSource::Figure);
        self
    }

    /// What stands above each column but the last, the state.
    pub(super) fn headers(&self) -> impl Iterator<Item = String> {
        let header = |q: &Quantity| match self.units {
            true => q.header(),
            false => q.name.clone(),
        };
        self.quantities.iter().map(header)
    }
}
