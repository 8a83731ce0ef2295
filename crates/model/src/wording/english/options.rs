//! The help of the command line: commands, options and their values.

use super::English;

catalogue! {
    /// The descriptions of commands and options.
    trait OptionsWords for English {
        what_krank_is = "A terminal workbench for planar linkages";
        what_krank_does =
            "A terminal workbench for planar linkages: position, velocity and acceleration of any mechanism with \
             one input, and forces where loads act, as drawings and tables.";
        name_of_scene = "A file, a preset's name, or - for standard input";
        name_of_scene_or(usual: &str) =
            "A file, a preset's name, or - for standard input [default: {usual}]";

        // Commands.
        does_list = "List the presets";
        does_check = "Check a scene and describe it: parts, mobility, groups, range";
        does_table =
            "Print the position, velocity and acceleration tables at one angle, and the forces where loads act";
        does_explain = "Show the working at one angle: loops, equations and every intermediate value";
        does_draw = "Draw the linkage at one angle: in characters, as SVG, or as DXF for CAD";
        does_sweep = "Write values over the driver's angle, one row per position";
        does_plot = "Plot values over the motion: in characters, or as SVG";
        does_cycle = "Summarize the whole motion: stroke, swing, time ratio, dwells, rates";
        does_import = "Convert a file of PMKS, PMKS+, Linkage, Pyslvs or pylinkage to a scene";
        file_to_import = "A file, an address in quotes, or - for standard input";
        does_export = "Write a Python or MATLAB script that computes the positions on its own";
        does_study = "Evaluate many designs: a grid or a sample of numbers, one row each";
        does_motor = "Compute the motor's torque or force over one cycle, and the motion of a ram";
        does_tolerance =
            "Compute the effects of tolerances and clearances: worst case, root sum square, samples, contributions";
        does_start = "Print a scene with the [start] of another assembly";
        does_accuracy = "Measure speed against error of every method for a scene, in a table and a chart";
        does_config = "Print a configuration to start from: every key with its default";
        does_help = "Show a topic of the manual or the help of a command, or search for a word";
        does_completions = "Print a completion script for a shell";
        does_man = "Print the manual page";

        // Options and their values.
        language_to_speak = "Language of screens, tables, messages and help";
        language_auto = "From the configuration, or LC_ALL, LC_MESSAGES, LANG";
        language_turkish = "Turkish";
        language_english = "English";
        decimal_of_csv = "The decimal mark in CSV [default: point]";
        decimal_point = "15.5";
        decimal_comma = "15,5, as in Turkish spreadsheets";
        separator_of_csv = "The separator of CSV cells [default: comma, or semicolon with --decimal comma]";
        separator_comma = "A comma";
        separator_semicolon = "A semicolon";
        separator_tab = "A tab";
        format_text = "Aligned text columns";
        format_csv = "Comma-separated values";
        format_json = "One object";
        format_plain = "Plain text of 80 columns";
        format_markdown = "Markdown";
        format_for_person = "Readable text";
        format_characters = "Characters";
        format_svg = "Scalable vector graphics, for a browser or a report";
        format_python = "Python 3, without any package";
        format_matlab = "MATLAB, or Octave";
        format_dxf = "A drawing for CAD: a layer for each link, in millimetres";
        format_cast = "One turn in colour, as an asciinema recording";
        format_png = "A pixel image, for slides";
        format_gif = "An animated turn";
        scale_on_paper = "The print scale of an SVG, such as 1:2 [default: sized for a screen]";
        scale_is_meant(most: f64) = "expected a scale such as 1:2 or 5:1, between 1:{most} and {most}:1";
        width_in_pixels = "Width in pixels of a PNG or GIF [default: 1600, or 800 for GIF]";
        on_a_dark_ground = "A dark background for SVG, PNG or GIF, also for readers with light screens";
        seconds_of_turn = "Duration of a turn, or of the motion back and forth, in a cast or GIF, in seconds [default: 6]";
        how_to_write = "The output format";
        format_of_output = "The output format; without it, the extension of the output file selects one";
        columns_of_cycle =
            "Columns to follow, by name or `name = formula`, separated by commas; * is a wildcard [default: the \
             scene's own, slides, links on the ground]";
        bounds_of_cycle = "Add the error bound of each stroke, and of each value at a turning point";
        dwell_of_cycle =
            "The range within which a value counts as dwelling, in its own unit [default: a hundredth of the \
             stroke]";
        how_to_write_cycle = "The output format; CSV has one line per value and property";
        values_of_study =
            "Numbers to vary, separated by commas: NAME=FROM..TO/COUNT, such as r3.length=280..320/9 [default: 11 \
             places]";
        columns_of_study =
            "Values of the whole motion, separated by commas: C.x.stroke, r4.angle.swing, C.x@60, transmission; \
             directions are measured from those of the scene, also beyond a turn";
        designs_of_hypercube = "Use a Latin hypercube of N designs instead of the grid";
        seed_of_hypercube = "The seed of the hypercube; the same seed gives the same designs";
        part_of_study = "Only part k of n of the designs: 3/64";
        resume_study = "Resume the file of -o where it stopped";
        threads_of_study = "Number of threads; the rows do not depend on it [default: all cores]";
        how_to_write_study = "The output format; chart and svg draw one value as curves and two as a map";
        format_chart = "A chart in characters";
        size_of_chart = "Columns by rows of a chart, such as 100x40";
        how_to_write_motor = "The output format; CSV has the cycle step by step";
        digits_of_tables = "Significant digits of text tables; CSV and JSON always have all";
        digits = "Significant digits";
        method_of_positions = "The method that finds the positions";
        method_closed = "The closed form, then velocities, accelerations and forces";
        method_newton = "Newton-Raphson on the loop equations, iteration by iteration";
        method_bisection = "Bisection of one unknown";
        method_graphical = "Compass and ruler, step by step";
        against_figures =
            "Values from notes or another program to compare: CSV with one value per row, or with columns over \
             driver.angle";
        measured_figures =
            "Measurements to compare: CSV with a column per value over driver.angle or driver.position, its name \
             followed by its unit in brackets";
        no_measurements(file: &str) =
            "`{file}` has no measurements of these columns: name the driver's coordinate and the columns in its \
             first line, and give their numbers in each row";
        measured_over_driver = "measurements need the driver as x axis: remove `--against`";
        holds_no_figures(file: &str) =
            "`{file}` has no values: write rows of `figure,unit,value`, or a header with the driver's column and a \
             number for each column";
        too_many_figures(file: &str) = "`{file}` is too large to compare";
        guess_of_vectors =
            "The initial guess: r3=20,r4=280 in deg or the scene's unit, for bisection r3=0..90 [default: a sketch \
             of the opening position]";
        leave_units_out = "Omit the units";
        add_bounds = "Add an error bound to each value; none where no bound can be proved";
        add_sensitivity = "Add the sensitivity of each value to the given lengths: its change per unit of length";
        first_row = "The first row [default: the beginning of the motion range]";
        last_row = "The last row, if a step falls on it [default: the end of the motion range]";
        row_to_row = "The step between rows, negative to go down [default: 1 deg; for a slide, 100 to 250 rows]";
        columns_of_table =
            "Only these columns, one line each: names, * as a wildcard, or NAME = FORMULA; separated by commas";
        columns_or_all =
            "Column names, * as a wildcard, or NAME = FORMULA; separated by commas [default: all vectors and \
             points]";
        columns_of_tolerances =
            "Column names, * as a wildcard, or NAME = FORMULA; separated by commas [default: places and directions]";
        place_of_tolerances = "Only at this coordinate, with contributions and samples [default: over the motion]";
        row_to_row_of_tolerances =
            "The step between rows, negative to go down [default: 5 deg; for a slide, 100 to 250 rows]";
        tolerance_of_all =
            "The tolerance of every length and coordinate, instead of the scene's: 0.1, '0.004 in' or 'ISO 2768-m'";
        machines_by_chance =
            "Number of random machines [default: 100000 at one place, 2000 for values of the whole motion, none in \
             rows]";
        seed_of_samples = "The seed of the random machines; the same seed gives the same ones";
        spread_of_lengths = "The distribution of lengths within their tolerances";
        spread_choice_normal = "Normal; the tolerance is three standard deviations";
        spread_choice_even = "Uniform within the tolerance";
        band_of_tolerances = "Draw the tolerance band of each curve";
        band_worst = "The worst case, as in krank tolerance";
        band_root_sum_square = "The root sum square";
        columns_to_plot = "Column names, * as a wildcard, or NAME = FORMULA; separated by commas";
        positions_to_compare = "Number of positions in 360 deg or the range, rounded up to a multiple of 360";
        topic_or_command = "A topic, a command, or words to search for [default: list topics and commands]";
        write_at_once = "Print everything, without a pager";
        format_web = "The manual as a web site: a page for each topic";
        folder_of_manual = "The folder of the web site; files of the same names are replaced";
        place_of_driver =
            "The driver's angle in deg, or the position of a driven slide [default: where the scene opens]";
        path_of_inputs =
            "A CSV file with the coordinates of the inputs, a column for each, named after its link or slide, or of \
             points that the inputs follow, such as `P.x,P.y`; writes a row for each";
        input_that_moves =
            "The input that moves, by the name of its link or slide; all other inputs are held [default: the driver]";
        assembly_of_group = "The assembly of a group where the scene opens, as check lists them; separated by commas";
        write_to_a_file = "Write to a file instead of standard output, completely or not at all";
        add_to_version = "With --version: also print the features, target, profile and licence of this build";
        the_shell = "The shell";
        command_of_page = "The command of the page [default: krank itself]";
        rated_effort = "The motor's rated torque in N m, or force in N";
        peak_effort = "The motor's peak torque in N m, or force in N";
        motor_speed = "The motor's speed with a unit: '1500 rpm', '0.2 m/s'";
        flywheel_on_shaft = "A flywheel on the driver's shaft, in kg m^2";
        wished_fluctuation = "The desired speed fluctuation: (maximum - minimum) / mean";
        slide_of_ram = "The slide that is the ram [default: the one with a press, or the only one]";
        height_of_ram = "A height above the bottom of the ram, in the scene's unit";
        effort_for_ram = "The torque in N m, or force in N, for the force of the ram [default: the rated one]";
        tolerance_of_rest = "How far from its bottom a ram counts as at rest, in the scene's unit";
        there_and_back_from = "Move there and back from this driver coordinate [default: the whole motion]";
        there_and_back_to = "To this coordinate; for a rotating driver, a lower value means one turn further";
        glyphs_as_allowed = "Chosen from the locale and the terminal";
        glyphs_of_seven_bits = "7-bit characters";
        glyphs_of_boxes = "Box-drawing characters, also in console fonts";
        glyphs_of_braille = "Braille patterns";
        glyphs_of_quadrants = "Quadrant blocks, in most fonts";
        glyphs_of_sextants = "Sextant blocks, in some fonts";
        glyphs_of_octants = "Octant blocks, in few fonts";
        trace_points = "Trace points over the whole motion; none hides those that the scene names";
        draw_velocities = "Draw velocity arrows";
        draw_accelerations = "Draw acceleration arrows";
        draw_forces = "Draw loads, joint and guide forces, with their magnitudes";
        draw_ghosts = "Show the linkage at this many positions of its motion";
        names_to_write = "Which names to write";
        mark_centres = "Mark centres of mass";
        leave_guides_out = "Omit guides and supports";
        characters_to_draw_with = "The characters to draw with";
        size_of_drawing =
            "The size; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100 wide for \
             an SVG]";
        size_of_plot =
            "The size; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100x40 for \
             an SVG]";
        names_none = "None";
        names_of_points_alone = "Points";
        names_all = "Points and links";
        plot_against = "The x axis: driver, time, or a column name";
        driver_begins = "The first driver coordinate [default: the beginning of the motion range]";
        driver_ends = "The last driver coordinate [default: the end of the motion range]";
        leave_extrema_out = "Do not mark maxima and minima";
        where_to_open = "Where to open: deg of the driven link, or the position of the driven slide";
        colours_to_draw_with = "The colours to draw with";
        theme_to_draw_with = "The colours of the palette [default: auto]";
        way_of_pictures = "The terminal protocol for still pictures [default: auto]";
        pictures_as_told = "From TERM, TERM_PROGRAM or KITTY_WINDOW_ID";
        pictures_of_kitty = "The kitty protocol";
        pictures_of_iterm = "The iTerm2 protocol";
        pictures_of_sixels = "Sixels";
        pictures_never = "No pictures";
        view_to_open_with = "The view to open with";
        print_and_leave = "Print the opening screen as text and exit; needs no terminal";
        size_of_print = "The size of the printed screen [default: 80x24]";
        tell_of_terminal = "Print what was detected of the terminal, and why";
        configuration_file = "The configuration [default: ~/.config/krank/config.toml]";
        colours_as_allowed = "Chosen from the terminal and NO_COLOR";
        colours_none = "No colours, but bold and reversed text";
        colours_of_palette = "The terminal's 16 colours";
        colours_fixed = "The fixed 256-colour palette";
        colours_any = "24-bit colours";
        theme_auto = "The palette's own, or colours readable on any background";
        theme_light = "For a light background";
        theme_dark = "For a dark background";
        theme_plain = "No colours";
    }
}
