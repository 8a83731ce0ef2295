//! The help of the command line: commands, options and their values.

use super::English;

catalogue! {
    /// What stands beside each command and option.
    trait OptionsWords for English {
        what_krank_is = "A terminal workbench for planar linkages";
        what_krank_does =
            "A terminal workbench for planar linkages: position, velocity and acceleration of any \
             mechanism with one input, and the forces where anything acts, drawn and in tables.";
        name_of_scene = "A file, a preset's name, or - for standard input";
        name_of_scene_or(usual: &str) =
            "A file, a preset's name, or - for standard input [default: {usual}]";

        // Commands.
        does_list = "List the presets";
        does_check = "Tell what krank understands of a scene: parts, mobility, groups, range";
        does_table = "Print the position, velocity and acceleration tables at one angle, and the forces where anything acts";
        does_explain = "Show the working: loops, equations and every figure on the way to the tables of one angle";
        does_draw = "Draw the linkage at one angle: in characters, or as SVG";
        does_sweep = "Write figures over the driver's angle, row by row";
        does_plot = "Plot figures over the motion: in characters, or as SVG";
        does_motor = "What a scene asks of its motor over one cycle, and what a ram does";
        does_start = "Print a scene with the [start] of another assembly";
        does_accuracy = "Measure speed against error: every method that could solve a scene, in a table and a chart";
        does_config = "Print a configuration to begin with: every key, and what is built in";
        does_help = "Read a topic of the manual, or the help of a command";
        does_completions = "Print a completion script for a shell";
        does_man = "Print the manual page";

        // Options and their values.
        language_to_speak = "Language of screens, tables, messages and help";
        language_auto = "As the configuration says, or LC_ALL, LC_MESSAGES, LANG";
        language_turkish = "Turkish";
        language_english = "English";
        decimal_of_csv = "The decimal mark in CSV [default: point]";
        decimal_point = "15.5";
        decimal_comma = "15,5, as Turkish spreadsheets have it";
        separator_of_csv = "What stands between the cells of CSV [default: comma, or semicolon with --decimal comma]";
        separator_comma = "A comma";
        separator_semicolon = "A semicolon";
        separator_tab = "A tab";
        format_text = "Aligned columns, for a person";
        format_csv = "Comma separated values";
        format_json = "One object";
        format_plain = "Plain text of 80 columns";
        format_markdown = "Markdown";
        format_for_person = "For a person";
        format_characters = "Characters";
        format_svg = "Scalable vector graphics, for a browser or a report";
        format_cast = "A turn in colours, as asciinema plays it";
        format_png = "Pixels, for a slide";
        format_gif = "A turn in pixels";
        width_in_pixels = "Width in pixels of a PNG or GIF [default: 1600, or 800 for GIF]";
        on_a_dark_ground = "An SVG, PNG or GIF on a dark ground, whatever the reader prefers";
        seconds_of_turn = "How long a turn takes in a cast or GIF, or the way there and back [default: 6]";
        how_to_write = "How to write it";
        how_to_write_motor = "How to write it; CSV has the cycle step by step";
        digits_of_tables = "Significant digits of text tables; CSV and JSON always carry all";
        digits = "Significant digits";
        method_of_positions = "By which method positions are found";
        method_closed = "The closed form, then velocities, accelerations and forces";
        method_newton = "Newton-Raphson on the loop equations, iteration by iteration";
        method_bisection = "Halving an interval of one unknown";
        method_graphical = "Compass and ruler, step by step";
        against_figures = "Figures of notes or of another program, to stand beside krank's: CSV with a figure a row, or with columns over driver.angle";
        holds_no_figures(file: &str) =
            "`{file}` holds no figures: a row is `figure,unit,value`, or a number for each head, of which one is the driver's";
        too_many_figures(file: &str) = "`{file}` is too large to be compared";
        guess_of_vectors = "Where a method begins: r3=20,r4=280 in deg or the scene's unit, for bisection r3=0..90 [default: a sketch of the opening]";
        leave_units_out = "Leave the units out";
        add_bounds = "Add what the error of each figure does not exceed; nothing where no bound can be proved";
        add_sensitivity = "Add what the given lengths do to each figure: by how much it changes for one unit of length";
        first_row = "The first row [default: the beginning of the motion range]";
        last_row = "The last row, where the step hits it [default: the end of the motion range]";
        row_to_row = "From row to row, negative to go down [default: 1 deg; for a slide, 100 to 250 rows]";
        columns_of_table = "A line for each of these figures alone: names, * for any characters, or NAME = FORMULA; separated by commas";
        columns_or_all = "Names of figures, * for any characters, or NAME = FORMULA; separated by commas [default: all vectors and points]";
        columns_to_plot = "Names of figures, * for any characters, or NAME = FORMULA; separated by commas";
        positions_to_compare = "Positions to compare at, in 360 deg or over the range, by the 360";
        topic_or_command = "A topic or a command; what there is if left out";
        write_at_once = "Write it all at once";
        place_of_driver = "The driver's angle in deg, or its position if it is a slide [default: where the scene opens]";
        assembly_of_group = "The assembly of a group where the scene opens, as check lists them; separated by commas";
        write_to_a_file = "Write to a file instead of standard output, whole or not at all";
        the_shell = "The shell";
        command_of_page = "The command that the page is about; krank itself if left out";
        rated_effort = "The torque in N m, or force in N, that the motor can keep up";
        peak_effort = "The most that it can do for an instant";
        motor_speed = "Its speed with a unit: '1500 rpm', '0.2 m/s'";
        flywheel_on_shaft = "A flywheel on the driver's shaft, in kg m^2";
        wished_fluctuation = "The wished fluctuation of the speed: greatest less least, by the mean";
        slide_of_ram = "The slide that is the ram [default: the one a press works at, or the only one]";
        height_of_ram = "A height above the bottom of the ram, in the scene's unit";
        effort_for_ram = "The torque in N m, or force in N, for the force of the ram [default: the rated one]";
        tolerance_of_rest = "How far from its bottom a ram counts as at rest, in the scene's unit";
        there_and_back_from = "Go there and back from this coordinate of the driver [default: the whole motion]";
        there_and_back_to = "To this one; where a driver turns, a lower one lies a turn further";
        glyphs_as_allowed = "As the locale and the terminal allow";
        glyphs_of_seven_bits = "7-bit characters";
        glyphs_of_boxes = "Box-drawing characters, which console fonts have too";
        glyphs_of_braille = "Braille patterns";
        glyphs_of_quadrants = "Quarters of a character, which most fonts have";
        glyphs_of_sextants = "Sixths of a character, which some fonts have";
        glyphs_of_octants = "Eighths of a character, which few fonts have";
        trace_points = "Trace points over the whole motion";
        draw_velocities = "Arrows of velocity";
        draw_accelerations = "Arrows of acceleration";
        draw_forces = "Loads, and the forces at joints and guides, with their sizes";
        draw_ghosts = "Show the linkage at so many places of its motion";
        names_to_write = "Which names to write";
        mark_centres = "Mark centres of mass";
        leave_guides_out = "Leave out guides and supports";
        characters_to_draw_with = "The characters to draw with";
        size_of_drawing = "How large; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100 wide for an SVG]";
        size_of_plot = "How large; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100x40 for an SVG]";
        names_none = "None";
        names_of_points_alone = "Of points";
        names_all = "Of points and links";
        plot_against = "What stands along x: driver, time, or the name of a figure";
        driver_begins = "Where the driver begins [default: the beginning of the motion range]";
        driver_ends = "Where the driver ends [default: the end of the motion range]";
        leave_extrema_out = "Leave out the marks at maxima and minima";
        where_to_open = "Where to open: deg of the driven link, or the position of the driven slide";
        colours_to_draw_with = "The colours to draw with";
        theme_to_draw_with = "Which colours stand for the names of the palette [default: auto]";
        way_of_pictures = "How the terminal is sent still pictures [default: auto]";
        pictures_as_told = "As TERM, TERM_PROGRAM or KITTY_WINDOW_ID tell";
        pictures_of_kitty = "As kitty takes them";
        pictures_of_iterm = "As iTerm2 takes them";
        pictures_of_sixels = "As sixels";
        pictures_never = "Not at all";
        view_to_open_with = "The view to open with";
        print_and_leave = "Print the screen that opens as text, and leave: no terminal is needed";
        size_of_print = "The size of the screen that is printed [default: 80x24]";
        tell_of_terminal = "Tell what was found of the terminal, and why";
        configuration_file = "The configuration [default: ~/.config/krank/config.toml]";
        colours_as_allowed = "As the terminal and NO_COLOR allow";
        colours_none = "No colour, but bold and reversed";
        colours_of_palette = "The 16 of the terminal's palette";
        colours_fixed = "The fixed palette of 256";
        colours_any = "Any colour, in 24 bits";
        theme_auto = "The palette's own, or such as read on any ground";
        theme_light = "For a light ground";
        theme_dark = "For a dark ground";
        theme_plain = "No colours";
    }
}
