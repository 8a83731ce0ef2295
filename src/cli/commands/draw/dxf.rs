//! Writes a drawing for CAD.

use super::DrawFormat;
use crate::drawing::machine_drawing;
use crate::wording::Words;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "dxf",
    about: <dyn Words>::format_dxf,
    takes: &[],
    is_picture: false,
    is_binary: false,
    write: |drawn| {
        let text = machine_drawing(drawn.scene, &drawn.links, drawn.state, &drawn.overlay);
        Ok(text.into_bytes())
    },
};
