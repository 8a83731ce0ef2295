//! Tests of input and output files of every kind: existing data is never lost, and partial output
//! never looks complete.

#[cfg(feature = "tui")]
use super::krank;
use super::{Run, command, folder, refused, run, run_ok};
use std::fs::{self, File};
use std::io::{Read, Write};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

const FOUR_BAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/presets/four-bar.toml");

/// Creates an empty folder.
fn fresh(test: &str) -> PathBuf {
    let folder = folder(&format!("files-{test}"));
    fs::remove_dir_all(&folder).unwrap();
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Creates a folder with a scene, and returns both paths.
fn scene(test: &str) -> (PathBuf, PathBuf) {
    let folder = fresh(test);
    let scene = folder.join("scene.toml");
    fs::copy(FOUR_BAR, &scene).unwrap();
    (folder, scene)
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let name = |entry: fs::DirEntry| entry.file_name().into_string().unwrap();
    let mut names: Vec<String> = entries.map(|entry| name(entry.unwrap())).collect();
    names.sort();
    names
}

/// Runs a shell line in which `$KRANK` is the program.
fn shell(folder: &Path, line: &str) -> Run {
    let output = Command::new("/bin/sh")
        .args(["-c", line])
        .env("KRANK", env!("CARGO_BIN_EXE_krank"))
        .env("XDG_STATE_HOME", folder.join("state"))
        .env("LC_ALL", "C")
        .current_dir(folder)
        .output()
        .unwrap();
    Run {
        code: output.status.code().unwrap_or(-1),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Regression test: `krank sweep scene.toml -o scene.toml` replaced the scene by the table.
#[test]
fn output_does_not_overwrite_the_input_scene() {
    let (folder, scene) = scene("input-is-output");
    symlink("scene.toml", folder.join("soft.toml")).unwrap();
    fs::hard_link(&scene, folder.join("hard.toml")).unwrap();
    let before = fs::read_to_string(&scene).unwrap();
    for name in [
        "scene.toml",
        "./soft.toml",
        "hard.toml",
        "../files-input-is-output/scene.toml",
    ] {
        for command in [
            "sweep",
            "table",
            "check",
            "explain",
            "report",
            "draw --format text",
            "motor",
            "cycle",
            "accuracy",
        ] {
            let run_output = shell(&folder, &format!("$KRANK {command} scene.toml -o {name}"));
            assert_eq!(run_output.code, 2, "{command} {name}: {}", run_output.err);
            assert!(
                run_output
                    .err
                    .contains("the output file is the input scene"),
                "{}",
                run_output.err
            );
        }
        let run_output = shell(&folder, &format!("$KRANK sweep - -o {name} < scene.toml"));
        assert_eq!(run_output.code, 2, "{name}: {}", run_output.err);
    }
    let run_output = shell(
        &folder,
        "$KRANK plot scene.toml --columns C.x -o scene.toml",
    );
    assert_eq!(run_output.code, 2, "{}", run_output.err);
    let run_output = shell(&folder, "$KRANK table scene.toml >> scene.toml");
    assert_eq!(run_output.code, 2, "{}", run_output.err);
    assert_eq!(fs::read_to_string(&scene).unwrap(), before);
    // `start` writes a scene and may overwrite its input; both hard links remain.
    let run_output = shell(
        &folder,
        "$KRANK start scene.toml --assembly C=- -o scene.toml",
    );
    assert_eq!(run_output.code, 0, "{}", run_output.err);
    assert_ne!(fs::read_to_string(&scene).unwrap(), before);
    assert_eq!(fs::metadata(&scene).unwrap().nlink(), 2);
}

#[test]
fn pipes_and_descriptors_work_as_input_and_output() {
    let (folder, scene) = scene("pipes");
    let expected = run_ok(&["table", text(&scene)]);
    for line in [
        "$KRANK table /dev/stdin < scene.toml",
        "cat scene.toml | $KRANK table -",
        "cat scene.toml | $KRANK table /dev/stdin",
        "$KRANK table /dev/fd/3 3< scene.toml",
        "mkfifo in && { cat scene.toml > in & $KRANK table in; }",
        "$KRANK table scene.toml -o /dev/stdout",
        "$KRANK table scene.toml -o /dev/stdout | cat",
        "$KRANK table scene.toml -o /dev/fd/3 3>&1",
        "mkfifo out && { cat out & $KRANK table scene.toml -o out; wait; }",
    ] {
        let run_output = shell(&folder, line);
        assert_eq!(
            (run_output.code, run_output.out.as_str()),
            (0, expected.as_str()),
            "{line}"
        );
    }
    // Output to a descriptor opened for appending is appended.
    let run_output = shell(
        &folder,
        "echo first > log; $KRANK table scene.toml -o /dev/fd/3 3>> log; cat log",
    );
    assert_eq!(run_output.out, format!("first\n{expected}"));
    let run_output = shell(
        &folder,
        "echo first > log; $KRANK table scene.toml -o /dev/stdout >> log",
    );
    assert_eq!(run_output.code, 0, "{}", run_output.err);
    let log = fs::read_to_string(folder.join("log")).unwrap();
    assert_eq!(log, format!("first\n{expected}"));
    assert_eq!(names(&folder), ["in", "log", "out", "scene.toml"]);
}

#[test]
fn endless_input_is_rejected_and_blocked_read_is_interruptible() {
    for name in ["/dev/zero", "/dev/urandom"] {
        refused(2, &["check", name]);
    }
    let folder = fresh("endless");
    let pipe = folder.join("pipe");
    assert!(
        Command::new("mkfifo")
            .arg(&pipe)
            .status()
            .unwrap()
            .success()
    );
    let mut waiting = Command::new(env!("CARGO_BIN_EXE_krank"))
        .args(["check", text(&pipe)])
        .spawn()
        .unwrap();
    thread::sleep(Duration::from_millis(200));
    assert!(waiting.try_wait().unwrap().is_none(), "it waits");
    let pid = rustix::process::Pid::from_child(&waiting);
    rustix::process::kill_process(pid, rustix::process::Signal::INT).unwrap();
    assert_eq!(waiting.wait().unwrap().signal(), Some(2));
    // A configuration must be a regular file.
    #[cfg(feature = "tui")]
    {
        let run_output = krank(&["four-bar", "--print", "--config", text(&pipe)]);
        assert_eq!(run_output.code, 2);
        assert!(
            run_output.err.contains("it is a pipe, not a file"),
            "{}",
            run_output.err
        );
    }
}

#[test]
fn overwriting_keeps_mode_owner_and_symlinks() {
    let folder = fresh("kept-rights");
    let file = folder.join("out.txt");
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    let is_given = std::os::unix::fs::chown(&file, Some(4321), Some(1234)).is_ok();
    let link = folder.join("link.txt");
    symlink("out.txt", &link).unwrap();
    let dangling = folder.join("dangling.txt");
    symlink("made.txt", &dangling).unwrap();
    let expected = run_ok(&["table", "press"]);
    for name in [&link, &dangling] {
        run_ok(&["table", "press", "-o", text(name)]);
        assert_eq!(fs::read_to_string(name).unwrap(), expected);
        assert!(fs::symlink_metadata(name).unwrap().is_symlink());
    }
    let found = fs::metadata(&file).unwrap();
    assert_eq!(found.mode() & 0o7777, 0o640);
    if is_given {
        assert_eq!((found.uid(), found.gid()), (4321, 1234));
    } else {
        eprintln!("skipped: only root may give files away");
    }
    assert_eq!(
        names(&folder),
        ["dangling.txt", "link.txt", "made.txt", "out.txt"]
    );
}

#[test]
fn read_only_output_file_is_rejected() {
    let file = fresh("read-only").join("out.csv");
    fs::write(&file, "kept").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
    let output = refused(1, &["table", "press", "-o", text(&file)]);
    assert!(output.contains("it is read-only"), "{output}");
    assert_eq!(fs::read_to_string(&file).unwrap(), "kept");
}

/// In folders where no file can be created: one owned by another user, where only this file is
/// writable, and a sticky one.
#[test]
fn file_in_unwritable_folder_is_written_in_place() {
    let as_nobody = |folder: &Path, line: &str| {
        let krank = env!("CARGO_BIN_EXE_krank");
        let line = format!("setpriv --reuid 65534 --regid 65534 --clear-groups -- {line}");
        shell(folder, &line.replace("$KRANK", krank))
    };
    let folder = fresh("foreign");
    if as_nobody(&folder, "$KRANK list").code != 0 {
        eprintln!("skipped: nobody else can be");
        return;
    }
    let state = folder.join("state");
    fs::create_dir(&state).unwrap();
    fs::set_permissions(&state, fs::Permissions::from_mode(0o777)).unwrap();
    for mode in [0o755, 0o1777] {
        let place = folder.join(format!("{mode:o}"));
        fs::create_dir(&place).unwrap();
        fs::set_permissions(&place, fs::Permissions::from_mode(mode)).unwrap();
        let file = place.join("out.txt");
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o666)).unwrap();
        let name = text(&file);
        let run_output = as_nobody(&folder, &format!("$KRANK table press -o {name}"));
        assert_eq!(run_output.code, 0, "{mode:o}: {}", run_output.err);
        assert_eq!(
            fs::read_to_string(&file).unwrap(),
            run_ok(&["table", "press"])
        );
        let found = fs::metadata(&file).unwrap();
        assert_eq!((found.uid(), found.mode() & 0o777), (0, 0o666));
        assert_eq!(names(&place), ["out.txt"]);
        // A file of another user without write permission stays unchanged.
        fs::set_permissions(&file, fs::Permissions::from_mode(0o644)).unwrap();
        let run_output = as_nobody(&folder, &format!("$KRANK check press -o {name}"));
        assert_eq!(run_output.code, 1, "{}", run_output.err);
        assert_eq!(
            fs::read_to_string(&file).unwrap(),
            run_ok(&["table", "press"])
        );
    }
}

/// The limit on the file size acts like a disk that fills up during the write.
#[test]
fn file_size_limit_keeps_the_old_file() {
    let folder = fresh("no-room");
    let (one, two) = (folder.join("one.csv"), folder.join("two.csv"));
    for is_linked in [false, true] {
        fs::write(&one, "kept").unwrap();
        let _ = fs::remove_file(&two);
        if is_linked {
            fs::hard_link(&one, &two).unwrap();
        }
        let run_output = shell(
            &folder,
            "trap '' XFSZ; ulimit -f 8; exec $KRANK sweep press -o one.csv",
        );
        assert_eq!(run_output.code, 1, "{}", run_output.err);
        assert_eq!(fs::read_to_string(&one).unwrap(), "kept");
        let left: Vec<String> = names(&folder)
            .into_iter()
            .filter(|n| n.contains("part"))
            .collect();
        assert!(left.is_empty(), "{left:?}");
    }
}

/// Fills a real small disk, if one can be mounted.
#[test]
fn full_disk_keeps_the_old_file() {
    let folder = fresh("small-disk");
    let disk = folder.join("disk");
    fs::create_dir(&disk).unwrap();
    let mount = Command::new("mount")
        .args(["-t", "tmpfs", "-o", "size=64k", "none", text(&disk)])
        .stderr(Stdio::null())
        .status();
    if !mount.is_ok_and(|status| status.success()) {
        eprintln!("skipped: nothing may be mounted here");
        return;
    }
    let output = ["one", "linked"].map(|name| {
        fs::write(disk.join(name), "kept").unwrap();
        if name == "linked" {
            fs::hard_link(disk.join(name), disk.join("second")).unwrap();
        }
        shell(&folder, &format!("$KRANK sweep press -o disk/{name}"))
    });
    let kept: Vec<String> = ["one", "linked"]
        .iter()
        .map(|name| fs::read_to_string(disk.join(name)).unwrap())
        .collect();
    let left = names(&disk);
    let unmounted = Command::new("umount").arg(&disk).status().unwrap();
    assert!(unmounted.success());
    for output in output {
        assert_eq!(output.code, 1, "{}", output.err);
        assert!(output.err.contains("No space"), "{}", output.err);
    }
    assert_eq!(kept, ["kept", "kept"]);
    assert_eq!(left, ["linked", "one", "second"]);
}

/// After a kill at any time, the file has its old or its new content. The next run removes temporary files.
#[test]
fn killed_process_leaves_old_or_new_file() {
    let folder = fresh("killed");
    let (one, two) = (folder.join("one.csv"), folder.join("two.csv"));
    let sweep = |column: &str| {
        ["sweep", "four-bar", "--step", "0.02", "--columns", column].map(str::to_owned)
    };
    let texts = ["C.x", "C.y"].map(|column| {
        let arguments = sweep(column);
        run_ok(&arguments.each_ref().map(String::as_str))
    });
    fs::write(&one, &texts[0]).unwrap();
    // From round 20 on, the file has two names, so it is written in place.
    for round in 0..40_u64 {
        if round == 20 {
            fs::hard_link(&one, &two).unwrap();
        }
        let column = ["C.y", "C.x"][round as usize % 2];
        let mut child = Command::new(env!("CARGO_BIN_EXE_krank"))
            .args(sweep(column))
            .args(["-o", text(&one)])
            .env("XDG_STATE_HOME", folder.join("state"))
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        thread::sleep(Duration::from_millis(round * 37 % 120));
        child.kill().unwrap();
        child.wait().unwrap();
        let next = shell(&folder, "$KRANK list > /dev/null");
        assert_eq!(next.code, 0, "{}", next.err);
        let now = fs::read_to_string(&one).unwrap();
        assert!(texts.contains(&now), "round {round}: torn");
    }
    assert_eq!(fs::metadata(&one).unwrap().nlink(), 2);
    let run_output = shell(&folder, "$KRANK table press -o three.txt");
    assert_eq!(run_output.code, 0, "{}", run_output.err);
    assert_eq!(names(&folder), ["one.csv", "state", "three.txt", "two.csv"]);
    let records = folder.join("state/krank/recovery/writing");
    let run_output = shell(&folder, "$KRANK table press -o one.csv");
    assert_eq!(run_output.code, 0, "{}", run_output.err);
    assert!(names(&records).is_empty(), "{:?}", names(&records));
}

/// A temporary file must not be readable by users who cannot read the output file.
#[test]
fn temp_file_has_the_mode_of_a_private_file() {
    let folder = fresh("private").canonicalize().unwrap();
    let file = folder.join("out.csv");
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    // More rows than can ever be written.
    let mut child = Command::new(env!("CARGO_BIN_EXE_krank"))
        .args(["sweep", "press", "--step", "1e-6", "-o", text(&file)])
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    // Finds the open file in the folder other than the old file, with or without a name.
    let opened = format!("/proc/{}/fd", child.id());
    let draft = || {
        let opened = fs::read_dir(&opened);
        let mut opened = opened.into_iter().flatten().flatten();
        let is_draft = |fd: &fs::DirEntry| {
            let to = fs::read_link(fd.path()).unwrap_or_default();
            to.starts_with(&folder) && to != file
        };
        let draft = opened.find(is_draft)?;
        fs::metadata(draft.path()).ok().filter(|it| it.is_file())
    };
    let draft = loop {
        match draft() {
            Some(draft) if draft.len() > 0 => break draft,
            _ => assert!(
                child.try_wait().unwrap().is_none(),
                "no draft was ever there"
            ),
        }
    };
    assert_eq!(draft.mode() & 0o777, 0o600);
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
}

/// A locked file of another program with the name of a temporary file stays.
#[test]
fn foreign_temp_file_is_not_changed() {
    let (folder, _) = scene("in-the-way");
    let foreign = folder.join(".krank-1-0.part");
    let mut held = File::create(&foreign).unwrap();
    held.write_all(b"somebody's").unwrap();
    held.lock().unwrap();
    let mut run_it = command(&["table", "press", "-o", text(&folder.join("out"))]);
    assert_eq!(run(&mut run_it).code, 0);
    let mut kept = String::new();
    File::open(&foreign)
        .unwrap()
        .read_to_string(&mut kept)
        .unwrap();
    assert_eq!(kept, "somebody's");
}

const STUDY: &str = "$KRANK study four-bar --columns r4.angle.swing --vary r2.length=90..110/3 -o";

/// Regression test: two studies wrote to the same file, and both exited with 0.
#[test]
fn file_locked_by_another_process_is_not_written() {
    let folder = fresh("held");
    let file = folder.join("rows.csv");
    fs::write(&file, "kept").unwrap();
    symlink("rows.csv", folder.join("link.csv")).unwrap();
    let held = File::open(&file).unwrap();
    held.lock().unwrap();
    for name in ["rows.csv", "link.csv"] {
        for line in [
            format!("{STUDY} {name}"),
            format!("{STUDY} {name} --resume"),
            format!("$KRANK sweep press -o {name}"),
            format!("$KRANK solve four-bar --goal r4.angle.swing=60 --vary r2.length -o {name}"),
        ] {
            let run_output = shell(&folder, &line);
            assert_eq!(run_output.code, 1, "{line}: {}", run_output.err);
            let busy = format!("cannot write `{name}`: another program is writing to it");
            assert!(run_output.err.contains(&busy), "{line}: {}", run_output.err);
            assert_eq!(fs::read_to_string(&file).unwrap(), "kept", "{line}");
        }
    }
    drop(held);
    let run_output = shell(&folder, &format!("{STUDY} link.csv"));
    assert_eq!(run_output.code, 0, "{}", run_output.err);
    let rows = fs::read_to_string(&file).unwrap();
    assert_eq!(rows.lines().count(), 4, "{rows}");
    assert_eq!(names(&folder), ["link.csv", "rows.csv"]);
}

/// Rows are written to pipes and devices, and a failed write keeps the older file.
#[test]
fn study_rows_can_go_to_pipes_and_devices() {
    let folder = fresh("study-places");
    let run_output = shell(&folder, &format!("{STUDY} rows.csv"));
    assert_eq!(run_output.code, 0, "{}", run_output.err);
    let rows = fs::read_to_string(folder.join("rows.csv")).unwrap();
    for line in [
        format!("{STUDY} /dev/stdout | cat"),
        format!("echo first > log; {STUDY} /dev/stdout >> log; tail -n +2 log"),
        format!("mkfifo out && {{ cat out & {STUDY} out; wait; }}"),
    ] {
        let run_output = shell(&folder, &line);
        assert_eq!(
            (run_output.code, run_output.out.as_str()),
            (0, rows.as_str()),
            "{line}"
        );
    }
    let run_output = shell(&folder, &format!("{STUDY} /dev/full"));
    assert_eq!(run_output.code, 1, "{}", run_output.err);
    assert!(run_output.err.contains("No space"), "{}", run_output.err);
    let run_output = shell(&folder, &format!("{STUDY} missing/rows.csv"));
    assert_eq!(run_output.code, 1, "{}", run_output.err);
    // If the write fails because the disk is full, the older file stays: before the header, and within the first rows.
    fs::write(folder.join("rows.csv"), "kept").unwrap();
    let many = STUDY.replace("/3", "/300");
    assert_ne!(many, STUDY);
    for (blocks, study) in [(0, STUDY), (1, &many)] {
        let run_output = shell(
            &folder,
            &format!("trap '' XFSZ; ulimit -f {blocks}; exec {study} rows.csv"),
        );
        assert_eq!(run_output.code, 1, "{}", run_output.err);
        assert_eq!(fs::read_to_string(folder.join("rows.csv")).unwrap(), "kept");
    }
}

/// Threads with such a stack size cannot be created, so the calling thread does the work.
#[test]
fn commands_work_if_threads_cannot_be_created() {
    let folder = fresh("no-threads");
    for line in [
        "$KRANK study four-bar --columns r4.angle.swing --vary r2.length=90..110/70",
        "$KRANK solve four-bar --goal r4.angle.swing=60 --vary r2.length --format json",
        "$KRANK solve four-bar --maximize r4.angle.swing --vary r2.length=80..110 --generations 3",
        "$KRANK synthesize wiper --format csv",
    ] {
        let with = shell(&folder, line);
        let without = shell(
            &folder,
            &format!("export RUST_MIN_STACK=281474976710656; {line}"),
        );
        assert!(!with.out.is_empty(), "{line}: {}", with.err);
        assert_eq!(without.out, with.out, "{line}: {}", without.err);
        assert_eq!(without.code, with.code, "{line}: {}", without.err);
    }
}
