//! What was found of the terminal, and why it is drawn on as it is.

use super::English;

catalogue! {
    /// What `krank --diagnose` tells.
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

        // What they say.
        not_set = "not set";
        a_terminal = "a terminal";
        no_terminal = "no terminal";
        no_screen = "there is none, and no /dev/tty either";
        no_size_told = "no size is told; 80 x 24 is assumed";
        size_in_characters(columns: u16, rows: u16) = "{columns} x {rows} characters";
        size_in_pixels(width: u16, height: u16) = "{width} x {height} pixels";
        no_pixels_told = "no pixels are told; twice as high as wide is assumed";
        serial_line(baud: u32, bytes: u32) = "serial, {baud} baud: at most {bytes} bytes a frame";
        console_here = "a console of this machine";
        pseudo_terminal = "a pseudo-terminal; its speed is measured while frames are sent";
        frames_none = "none: TERM=dumb cannot show the workbench";
        frames_whole = "whole at once (?2026), pasted text is marked (?2004)";
        frames_plain = "plain; pasted text cannot be told from keys";
        asked_for(wish: &str, else_what: &str, why: &str) = "{wish}: asked for; else {else_what}: {why}";
        nowhere_to_be(variable: &str) = "nowhere: neither {variable} nor HOME is set";
        there_is_none(path: &str) = "{path} (there is none)";

        // Why.
        locale_not_utf8 = "the locale is not UTF-8";
        term_not_set = "TERM is not set";
        term_has_no_others(term: &str) = "TERM={term} has no others";
        console_has_no_braille = "console fonts have lines, but no Braille";
        emulator_in_utf8 = "an emulator in a UTF-8 locale";
        no_color_set = "NO_COLOR is set";
        term_has_none(term: &str) = "TERM={term} has none";
        pictures_asked_for = "asked for";
        pictures_unwanted = "no pictures are wanted here: picture = \"none\"";
        no_pictures_there(term: &str) = "TERM={term} shows no pictures";
        pictures_behind_multiplexer =
            "multiplexers take sixels at most; --picture sixel sends them";
        pictures_unknown(term: &str) =
            "TERM={term} does not tell; --picture kitty, iterm or sixel does";
        row_pictures = "pictures";
        promises_no_more(what: &str) = "{what} promises no more";
    }
}
