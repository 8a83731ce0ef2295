//! Exercises: sheets, files of answers and grades.

use super::English;

catalogue! {
    /// Texts of sheets, of graded answers, and of the two commands.
    trait ExercisesWords for English {
        // The scene of an exercise.
        exercise_called(name: &str, seed: u64) = "{name}: exercise {seed}";
        exercise_made_by(scene: &str, seed: u64) = "krank exercise {scene} --seed {seed}";
        made_by_chance = "lengths, speed and angle are random; the given values are exact";

        // The sheet.
        name_and_number = "Name: ______________________________   Number: ____________________";
        given_part = "Given";
        asked_part = "Asked";
        fixed_at(at: &str, unit: &str) = "fixed at {at} {unit}";
        link_from_to(from: &str, to: &str, length: &str, unit: &str) = "from {from} to {to}, {length} {unit}";
        point_on_link(name: &str, at: &str, unit: &str) = "{name} at {at} {unit} in its frame";
        point_seen_from(name: &str, base: &str, length: &str, unit: &str, angle: &str) =
            "{name} {length} {unit} from {base}, at {angle} deg to the axis of the link";
        the_origin = "the origin";
        the_frame = "the frame";
        slides_along(what: &str, on: &str, through: &str, angle: &str) =
            "{what} slides on {on} through {through}, at {angle} deg";
        lies_to_guide(what: &str, angle: &str) = "the axis of {what} stays at {angle} deg to the guide";
        driver_stands(name: &str, at: &str, speed: &str, acceleration: &str) =
            "{name} is at {at}, with {speed} and {acceleration}";
        what_is_asked =
            "Draw the vector polygon of every loop, write the loop equations in sines and cosines, \
             differentiate them twice, and fill in the tables. Keep all digits in intermediate results; round \
             your answers to four digits or more. The frame of a link has its origin at the first end of the \
             link and its x axis along it.";
        positions_asked = "Positions, with a question mark for each unknown:";
        velocities_asked = "Velocities, with a question mark for each unknown:";
        accelerations_asked = "Accelerations, with a question mark for each unknown:";
        points_are_asked = "Velocities and accelerations of the points, by magnitude and direction:";
        where_answers_belong(file: &str) =
            "Write the answers into the file {file} with a spreadsheet; it lists the names and units of the \
             values.";

        names_in_answers(names: &str) =
            "The file of answers contains: {names}. The angle of a link is the angle of its axis, from its \
             first end to its second; its other sides are at fixed angles to the axis.";

        names_of_a_point(point: &str, names: &str) = "For each point it contains, here for {point}: {names}.";

        // Verdicts.
        is_right = "right";
        rounded_by(figure: &str, written: &str) = "rounded early: {figure} as {written}";
        rounded_somewhere = "rounded early";
        cut_off = "cut off, not rounded";
        too_few_digits = "too few digits";
        right_by_own(figure: &str) = "right given {figure}";
        wrong_in_sign = "wrong sign";
        other_way_round = "opposite direction";
        in_other_unit(unit: &str) = "in {unit}";
        of_other_assembly = "other assembly";
        is_wrong = "wrong";
        is_unanswered = "empty";
        is_no_figure = "not a number";

        // Answers.
        answers_to(sheet: &str) = "Answers to {sheet}.";
        figure = "figure";
        answer = "answer";
        exact_figure = "exact";
        judged = "verdict";
        student = "student";
        points_head = "points";
        figures_head = "of";
        file_head = "file";
        first_mistake_head = "first mistake";
        points_of(points: usize, figures: usize, right: usize, nearly: usize) =
            "{points} points of {figures}: {right} values are right, {nearly} are right except for rounding or \
             an earlier mistake.";
        first_that_differs(figure: &str, verdict: &str) = "The first difference is {figure}: {verdict}.";
        first_mistake(figure: &str, verdict: &str) = "The first mistake is {figure}: {verdict}.";
        value_misread(name: &str, given: &str, read: &str) =
            "These answers are right for `{name}` = {read} instead of {given}: it may have been misread.";
        judged_besides = "These were not asked for and earn no points:";
        strange_units(cells: &str) =
            "Unknown units, or units of another quantity: {cells}. For an unknown unit the unit asked for is \
             used.";
        answers_unread(cells: &str) = "Answers that are not numbers: {cells}.";
        answered_again(cells: &str) = "Answers that a later row replaces: {cells}.";
        no_figures_of_scene(cells: &str) = "Rows that name no value of this scene: {cells}.";
        cell_of_line(line: u64, figure: &str, text: &str) = "{figure} [{text}] in line {line}";
        decoded_as(encoding: &str) =
            "The file is not UTF-8; it was read as {encoding}, which includes ISO 8859-9.";
        file_decoded_as(file: &str, encoding: &str) =
            "`{file}` is not UTF-8; it was read as {encoding}, which includes ISO 8859-9";

        // Errors of the commands.
        no_exercise(seed: u64) =
            "no exercise was found for seed {seed}: random lengths break relations that the mechanism needs";
        no_dimensions = "the scene has no lengths that could be random";
        no_figures_at(at: &str) = "no velocities and accelerations exist at {at}: choose another position";
        folder_for_many = "--count writes many files: name a folder with -o DIR";
        seeds_run_out = "--seed and --count exceed the largest seed";
        would_be_lost(file: &str) =
            "`{file}` is different from what this exercise writes, and would be lost: write to another folder";
        holds_no_answers(file: &str) = "`{file}` has no answers: no row names a value";
        names_no_figure(file: &str, sheet: &str) =
            "`{file}` has no answers: no row names a value of `{sheet}`";
        too_many_answers(file: &str) = "`{file}` is too large for a file of answers";
        names_no_sheet(file: &str, sheet: &str) = "`{file}` names `{sheet}`, which is not in the folder";
        answers_another_sheet(file: &str, named: &str, sheet: &str) =
            "`{file}` answers {named}, but it is graded by {sheet}";
        student_again(student: &str, files: &str) = "{student} appears in more than one file: {files}";
        some_not_graded(some: usize, files: usize) = "{some} of {files} files were not graded";

        // On the command line.
        does_exercise =
            "Make an exercise from a scene: a sheet with random dimensions, a file for answers, a solution";
        does_grade = "Grade answers: each value is right, rounded early, or wrong in sign, unit or value";
        seed_of_exercise = "Seed of the exercise: the same seed gives the same exercise on every machine";
        count_of_exercises = "Number of exercises, with consecutive seeds";
        format_of_sheet = "Format of sheet and solution [default: html into a folder, else text]";
        folder_of_exercises = "Write scene, sheet, answers and solution into this folder";
        sheet_to_grade =
            "The scene of the exercise, any scene or preset, or a folder of scenes named in the answers";
        files_of_answers = "The files of answers, CSV";
        how_to_write_grades = "Output format; CSV has one row per file";
        examples_of_exercise = "\
Examples:
  krank exercise four-bar --seed 7
  krank exercise slider-crank --seed 1 --count 100 -o class
  krank exercise press --seed 3 --decimal comma --format latex -o class

All lengths, the speed and the angle are random numbers of two digits; the scene
keeps its assembly and its kind of motion, and is not close to a dead point. For
each seed -o writes four-bar-7.toml (the scene), four-bar-7.html
(the sheet), four-bar-7.csv (to answer in) and four-bar-7-solution.html.";
        examples_of_grade = "\
Examples:
  krank grade class/four-bar-7.toml ayse.csv
  krank grade class answered/*.csv --format csv -o points.csv
  krank grade four-bar --at 60 notes.csv

An answer is right if it is the exact value rounded to its own digits, three or
more. Another answer may follow from earlier answers: then it was rounded early,
or it is right given an earlier wrong answer, which is named.";
    }
}
