//! The driver's position, the assembly, and the drawing of the motion.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The motion and its drawing.
    trait MotionWords for English {
        // The driver's position.
        motion_ends = "the motion ends here";
        no_number_of(unit: &str, typed: &str) = "not a number in {unit}: {typed}";
        taken_as(at: &str, unit: &str) = "taken as {at} {unit}";
        out_of_reach(low: &str, high: &str, unit: &str) = "out of reach: {low} to {high} {unit}";
        no_longer_in_reach(at: &str, unit: &str) = "{at} {unit} is out of reach now";
        begins_a_frame(point: &str, link: &str) = {
            format!("{point} is the origin of {link}: change the length of {link} in the list")
        };
        whole_turns(turns: &str, is_one: bool) = {
            format!("{turns} turn{}", if is_one { "" } else { "s" })
        };

        // Playback.
        step_of(step: &str, unit: &str) = "step {step} {unit}";
        plays_in(turns: bool, seconds: &dyn Display, backwards: bool) = {
            let sweep = if turns { "turn" } else { "sweep" };
            format!("1 {sweep} in {seconds} s{}", if backwards { ", backwards" } else { "" })
        };
        plays_period_in(seconds: &dyn Display, backwards: bool) = {
            format!("the motion in {seconds} s{}", if backwards { ", backwards" } else { "" })
        };
        time_of_motion(time: &str) = "t {time} s";
        at_driver_speed(unit: &str) = "at 1 {unit}/s";
        driver_stands_still = "the driver stands still";
        slower_than_real(times: &str) = "1/{times} of real time";
        faster_than_real(times: &str) = "{times} times real time";

        // The state of the mechanism.
        ok = "ok";
        change_point = "change point";
        dead_point = "dead point";
        dead_point_without_rates = "dead point: no rates";
        stop_of(name: &str) = "stop of {name}";
        limit = "limit";
        no_assembly = "no assembly";
        no_assembly_here = "no assembly here";
        near_within(what: &str, distance: &str, unit: &str) = "{what} within {distance} {unit}";
        near_in(what: &str, distance: &str, unit: &str) = "{what} in {distance} {unit}";
        no_bound = "no bound";

        // Assemblies.
        no_other_assembly = "there is no other assembly here";
        rest_does_not_close(choice: &dyn Display) = "no assembly with {choice}";
        assembly_now(choice: &dyn Display) = "{choice} now";
        assembly_now_untold(choice: &dyn Display) = {
            format!("{choice} now; no [start] selects it, so it cannot be saved")
        };
        assembly_now_saved_by(choice: &dyn Display, key: &dyn Display) = "{choice} now; {key} saves it";
        shown_now = "now";
        does_not_close = "open";
        degrees(figure: &str) = "{figure} deg";

        // The drawing.
        drawn_with(glyphs: &str) = "drawn with {glyphs}";
        glyphs_ascii = "ASCII";
        glyphs_lines = "lines";
        glyphs_braille = "Braille";
        glyphs_quadrants = "quadrants";
        glyphs_sextants = "sextants, if the font has them";
        glyphs_octants = "octants, if the font has them";
        no_colours = "no colours";
        sixteen_colours = "the terminal's 16 colours";
        colours_of_256 = "256 colours";
        true_colours = "24-bit colours";
        switched_on(what: &str) = "{what} on";
        switched_off(what: &str) = "{what} off";
        the_whole_motion = "the whole motion";
        window_goes_along = "the view moves along";
        window_stays_with(point: &str) = "the view follows {point}";
        no_more_to_zoom = "zoom limit reached";
        zoomed(times: &str) = "zoom {times}";
        names_of_points = "names of points";
        names_of_points_and_links = "names of points and links";
        no_names = "no names";
        trace_of(names: &str) = "trace {names}";
        traces_of(count: usize) = "{count} traces";
        ghost_positions(count: u16) = "{count} positions";
        a_centre_of_mass = "x centre of mass";
        arrows_without_scale(letter: &str) = "{letter} 0: the driver stands still";
        drawing_of(scene: &str, at: &dyn Display, unit: &str) = "{scene} at {at} {unit}";
        language_is = "language: English";

        place_in_cycle(at: &str, whole: &str, unit: &str) = "{at} of {whole} {unit}";
        place_in_range(at: &str, low: &str, high: &str, unit: &str) = "{at} in {low}..{high} {unit}";

        // Lists, search and selection.
        nothing_at_the_side = "no other column here";
        no_further_part = "no further part";
        nothing_to_search = "nothing to search here";
        never_moves(name: &str) = "{name} never moves: nothing to follow";
        all_of(names: &[&str]) = { names.join(" and ") };
        no_longer_chosen(names: &str) = "{names} no longer chosen";
        chosen_for_motion(names: &str) = "{names} chosen for the motion view";
        no_row_named(typed: &str) = "no row is named {typed}";
    }
}
