//! Says in the words of the file what the builder found wrong with an element.

use super::Places;
use super::diagnostic::Diagnostic;
use super::draft::Draft;
use super::reader::Reader;
use crate::Defect;

/// Reports defects; those of elements that were reported already are left out.
pub(super) fn report<'t>(
    reader: &mut Reader<'_>,
    _draft: &Draft<'t>,
    _places: &Places,
    _point_names: &[Option<String>],
    defects: &[Defect],
) {
    for defect in defects {
        reader.report(Diagnostic::new(defect.to_string()));
    }
}
