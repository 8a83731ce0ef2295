//! Exercises: sheets, files of answers, and what becomes of them.

use super::English;

catalogue! {
    /// What is said on a sheet, of answers, and by the two commands.
    trait ExercisesWords for English {
        // The scene of an exercise.
        exercise_called(name: &str, seed: u64) = "{name}: exercise {seed}";
        exercise_made_by(scene: &str, seed: u64) = "krank exercise {scene} --seed {seed}";
        made_by_chance = "lengths, speed and angle were drawn by chance; what is given is exact";

        // The sheet.
        name_and_number = "Name: ______________________________   Number: ____________________";
        given_part = "Given";
        asked_part = "Asked";
        fixed_at(at: &str, unit: &str) = "fixed at {at} {unit}";
        link_from_to(from: &str, to: &str, length: &str, unit: &str) = "from {from} to {to}, {length} {unit}";
        point_on_link(name: &str, at: &str, unit: &str) = "{name} at {at} {unit} in its frame";
        point_seen_from(name: &str, base: &str, length: &str, unit: &str, angle: &str) =
            "{name} {length} {unit} from {base}, at {angle} deg to the link's axis";
        the_origin = "the origin";
        the_frame = "the frame";
        slides_along(what: &str, on: &str, through: &str, angle: &str) =
            "{what} slides on {on} through {through}, at {angle} deg";
        lies_to_guide(what: &str, angle: &str) = "the axis of {what} stays at {angle} deg to the guide";
        driver_stands(name: &str, at: &str, speed: &str, acceleration: &str) =
            "{name} stands at {at}, with {speed} and {acceleration}";
        what_is_asked =
            "Draw the vector polygon of every loop, write the loop equations in sines and cosines, \
             differentiate them twice, and fill the tables. Carry all digits on; round what you write down to four \
             digits or more. A frame on a link has its origin at the link's first end and its x axis along it.";
        positions_asked = "Positions, given and with a question mark what is sought:";
        velocities_asked = "Velocities, given and with a question mark what is sought:";
        accelerations_asked = "Accelerations, given and with a question mark what is sought:";
        points_are_asked = "Velocities and accelerations of the points, by size and direction:";
        where_answers_belong(file: &str) =
            "The answers belong into the file {file}, which a spreadsheet opens; figures have the names and units \
             that stand there.";

        names_in_answers(names: &str) =
            "In the file of answers stand: {names}. The angle of a link is that of its axis, from its first end to \
             its second; another side of it lies at a fixed angle to that.";

        names_of_a_point(point: &str, names: &str) = "Of a point stand there, as of {point}: {names}.";

        // Verdicts.
        is_right = "right";
        rounded_by(figure: &str, written: &str) = "rounded early: {figure} as {written}";
        rounded_somewhere = "rounded early";
        cut_off = "cut off, not rounded";
        too_few_digits = "too few digits";
        right_by_own(figure: &str) = "right by {figure}";
        wrong_in_sign = "wrong in sign";
        other_way_round = "the other way round";
        in_other_unit(unit: &str) = "in {unit}";
        of_other_assembly = "of another assembly";
        is_wrong = "wrong";
        is_unanswered = "empty";
        is_no_figure = "no figure";

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
            "{points} points of {figures}: {right} figures are right, {nearly} but for rounding or for what \
             was wrong before.";
        first_that_differs(figure: &str, verdict: &str) = "The first that differs is {figure}: {verdict}.";
        first_mistake(figure: &str, verdict: &str) = "The first mistake is {figure}: {verdict}.";
        value_misread(name: &str, given: &str, read: &str) =
            "These answers are right for `{name}` = {read} in place of {given}: it may have been misread.";
        judged_besides = "These were not asked for, and are worth no point:";
        strange_units(cells: &str) =
            "Units that are not known, or measure something else: {cells}. An unknown unit counts as the one that was \
             asked for.";
        answers_unread(cells: &str) = "Answers that are no numbers: {cells}.";
        answered_again(cells: &str) = "Answers that do not count, since a later row answers the same: {cells}.";
        no_figures_of_scene(cells: &str) = "Rows that name no figure of this scene: {cells}.";
        cell_of_line(line: u64, figure: &str, text: &str) = "{figure} [{text}] in line {line}";
        decoded_as(encoding: &str) =
            "The file is not UTF-8; it was read as {encoding}, which includes ISO 8859-9.";
        file_decoded_as(file: &str, encoding: &str) =
            "`{file}` is not UTF-8; it was read as {encoding}, which includes ISO 8859-9";

        // What the commands cannot do.
        no_exercise(seed: u64) =
            "no exercise was found for seed {seed}: its lengths stand in relations that chance does not keep";
        no_dimensions = "the scene has no lengths that could be drawn by chance";
        no_figures_at(at: &str) = "there are no velocities and accelerations at {at}: nothing can be asked for";
        folder_for_many = "--count makes many files: -o DIR says where";
        seeds_run_out = "--seed and --count lead beyond the largest seed";
        would_be_lost(file: &str) =
            "`{file}` is not as this exercise writes it: what somebody wrote there would be lost; write to another folder";
        holds_no_answers(file: &str) = "`{file}` holds no answers: it has no row of a figure";
        names_no_figure(file: &str, sheet: &str) =
            "`{file}` holds no answers: none of its rows names a figure of `{sheet}`";
        too_many_answers(file: &str) = "`{file}` is no file of answers: it is too large";
        names_no_sheet(file: &str, sheet: &str) =
            "`{file}` names no sheet of the folder: `{sheet}`";
        answers_another_sheet(file: &str, named: &str, sheet: &str) =
            "`{file}` says that it answers {named}, and is graded by {sheet}";
        student_again(student: &str, files: &str) = "{student} is the student of more than one file: {files}";
        some_not_graded(some: usize, files: usize) = "{some} of {files} files were not graded";

        // On the command line.
        does_exercise = "Make an exercise of a scene: own dimensions by chance, a sheet, a file to answer in, a solution";
        does_grade = "Grade answers: each figure is right, rounded early, wrong in sign, in another unit or wrong";
        seed_of_exercise = "Which exercise: the same seed gives the same one on every machine";
        count_of_exercises = "How many exercises, with the seeds that follow";
        format_of_sheet = "How to write sheet and solution [default: html into a folder, else text]";
        folder_of_exercises = "Write scene, sheet, answers and solution into this folder";
        sheet_to_grade = "The exercise's scene, any scene or preset, or a folder of scenes that the answers name";
        files_of_answers = "The files of answers, CSV";
        how_to_write_grades = "How to write it; CSV has a row for each file";
        examples_of_exercise = "\
Examples:
  krank exercise four-bar --seed 7
  krank exercise slider-crank --seed 1 --count 100 -o class
  krank exercise press --seed 3 --decimal comma --format latex -o class

Every length, the speed and the angle are drawn by chance, to numbers of two
digits; the scene keeps its assembly, moves as it did, and stands away from dead
points. -o writes for each seed four-bar-7.toml (the scene), four-bar-7.html
(the sheet), four-bar-7.csv (to answer in) and four-bar-7-solution.html.";
        examples_of_grade = "\
Examples:
  krank grade class/four-bar-7.toml ayse.csv
  krank grade class answered/*.csv --format csv -o points.csv
  krank grade four-bar --at 60 notes.csv

An answer is right when it is the exact figure rounded to its own digits, three
or more. What is not right may follow from earlier answers as they were written:
then it was rounded early, or is right by one that is wrong, which is named.";
    }
}
