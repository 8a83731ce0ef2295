//! Detected properties of the terminal, and the reasons for the chosen output.

use super::English;

catalogue! {
    /// The output of `krank --diagnose`.
    trait TerminalsWords for English {
        // Rows.
        row_configuration = "configuration";
        row_state = "state";
        standard_output = "standard output";
        standard_error = "standard error";
        row_screen = "screen";
        row_cells = "cells";
        row_line = "line";
        row_theme = "theme";
        row_frames = "frames";
        row_locale = "locale";
        row_language = "language";

        // Values.
        not_set = "not set";
        a_terminal = "a terminal";
        no_terminal = "no terminal";
        no_screen = "none, and no /dev/tty";
        no_size_told = "unknown size; 80 x 24 is assumed";
        size_in_characters(columns: u16, rows: u16) = "{columns} x {rows} characters";
        size_in_pixels(width: u16, height: u16) = "{width} x {height} pixels";
        no_pixels_told = "unknown pixel size; twice as high as wide is assumed";
        serial_line(baud: u32, bytes: u32) = "serial, {baud} baud: at most {bytes} bytes a frame";
        console_here = "a local console";
        pseudo_terminal = "a pseudo-terminal; its speed is measured while frames are sent";
        frames_none = "none: TERM=dumb cannot show the workbench";
        frames_whole = "synchronized (?2026), with bracketed paste (?2004)";
        frames_plain = "plain; pasted text looks like typed keys";
        asked_for(wish: &str, else_what: &str, why: &str) = "{wish}: requested; otherwise {else_what}: {why}";
        nowhere_to_be(variable: &str) = "none: neither {variable} nor HOME is set";
        there_is_none(path: &str) = "{path} (does not exist)";

        // Reasons.
        locale_not_utf8 = "the locale is not UTF-8";
        term_not_set = "TERM is not set";
        term_has_no_others(term: &str) = "TERM={term} supports no others";
        console_has_no_braille = "console fonts have lines, but no Braille";
        emulator_in_utf8 = "an emulator in a UTF-8 locale";
        no_color_set = "NO_COLOR is set";
        term_has_none(term: &str) = "TERM={term} supports none";
        pictures_asked_for = "requested";
        pictures_unwanted = "pictures are disabled: picture = \"none\"";
        no_pictures_there(term: &str) = "TERM={term} supports no pictures";
        pictures_behind_multiplexer = "multiplexers support at most sixels: use --picture sixel";
        pictures_unknown(term: &str) = "not known from TERM={term}: use --picture kitty, iterm or sixel";
        row_pictures = "pictures";
        promises_no_more(what: &str) = "{what} does not imply more";
    }
}
