//! Tests of `krank draw --format png|gif`: decodes the pictures and checks the pixels of the crank.

use super::readme::MOVING;
use super::{command, folder};
use resvg::tiny_skia::Pixmap;
use std::fs::File;

const PAPER: [u8; 3] = [0xff; 3];

fn written(name: &str, arguments: &[&str]) -> std::path::PathBuf {
    let file = folder("pixels").join(name);
    let mut command = command(&["draw"]);
    command.args(arguments).arg("-o").arg(&file);
    command.assert().success();
    file
}

/// Returns the stroke colour of a class in the SVG's style for light backgrounds, which comes first.
fn stroke(svg: &str, class: &str) -> [u8; 3] {
    let rule = svg.lines().find(|line| line.starts_with(class)).unwrap();
    let (_, hex) = rule.split_once("stroke:#").unwrap();
    let hex = u32::from_str_radix(&hex[..6], 16).unwrap();
    [hex >> 16, hex >> 8, hex].map(|channel| (channel & 0xff) as u8)
}

/// At 60 degrees, the crank of 100 mm leads from A to B; its pixels are found by colour.
#[test]
fn png_pixels_have_the_colours_of_the_links() {
    let file = written(
        "four-bar.png",
        &["four-bar", "--format", "png", "--width", "400"],
    );
    let picture = Pixmap::decode_png(&std::fs::read(file).unwrap()).unwrap();
    assert_eq!(picture.width(), 400);
    assert!(
        (150..400).contains(&picture.height()),
        "{}",
        picture.height()
    );
    let at = |x: u32, y: u32| {
        let pixel = picture.pixel(x, y).unwrap();
        [pixel.red(), pixel.green(), pixel.blue()]
    };
    let of = |hue: [u8; 3]| -> Vec<(u32, u32)> {
        let all = (0..picture.height()).flat_map(|y| (0..400).map(move |x| (x, y)));
        all.filter(|&(x, y)| at(x, y) == hue).collect()
    };
    let svg = command(&["draw", "four-bar", "--format", "svg"]).output();
    let svg = String::from_utf8(svg.unwrap().stdout).unwrap();
    let driver = of(stroke(&svg, ".driver"));
    let link = of(stroke(&svg, ".hue0"));
    // The coupler is three times as long as the crank; edge pixels are blended with the background.
    let lengths = (driver.len(), link.len());
    assert!(lengths.0 > 50 && lengths.1 > 2 * lengths.0, "{lengths:?}");
    assert_eq!([at(0, 0), at(399, picture.height() - 1)], [PAPER; 2]);
    // The crank rises to the right at 60 degrees: 1.73 up for 1 to the right.
    let (low, high) = (driver.iter().max_by_key(|p| p.1).unwrap(), driver[0]);
    let slope = f64::from(low.1 - high.1) / f64::from(high.0 - low.0);
    assert!((1.3..2.3).contains(&slope), "{slope}");
    // Labels need no system font: right of the last support there is only a label.
    let dark = |x: u32, y: u32| at(x, y).iter().all(|channel| *channel < 0x80);
    let mut nearby = (385..400).flat_map(|x| (0..picture.height()).map(move |y| (x, y)));
    assert!(
        nearby.any(|(x, y)| dark(x, y)),
        "no name of the rightmost point"
    );
}

#[test]
fn gif_pixels_loop_forever_with_requested_duration() {
    let arguments = [
        "four-bar",
        "--format",
        "gif",
        "--width",
        "120",
        "--seconds",
        "2",
    ];
    let file = written("four-bar.gif", &arguments);
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(File::open(file).unwrap()).unwrap();
    assert_eq!(decoder.width(), 120);
    let (mut frames, mut hundredths, mut changed) = (0, 0, 0);
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        frames += 1;
        hundredths += u32::from(frame.delay);
        let opaque = frame.buffer.chunks(4).filter(|pixel| pixel[3] > 0).count();
        match frames {
            1 => assert_eq!(opaque, usize::from(frame.width) * usize::from(frame.height)),
            _ => changed += usize::from(opaque > 0),
        }
    }
    assert_eq!((frames, hundredths, changed), (30, 200, 29));
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
}

/// The moving picture of the README is what its command writes today.
#[test]
fn pixels_of_readme_gif_match_draw_output() {
    let arguments = MOVING.split(' ').skip(1);
    let arguments: Vec<&str> = arguments.take_while(|word| *word != "-o").collect();
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, ground) in [("four-bar", None), ("four-bar-dark", Some("--dark"))] {
        let arguments: Vec<&str> = arguments.iter().copied().chain(ground).collect();
        let drawn = std::fs::read(written("readme.gif", &arguments)).unwrap();
        let kept = root.join(format!("src/manual/pictures/{name}.gif"));
        assert!(std::fs::read(kept).unwrap() == drawn, "another: {name}");
    }
}

/// Programs that render an SVG do not know the reader's preference for dark slides.
#[test]
fn dark_option_gives_pixels_a_dark_background() {
    let arguments = ["four-bar", "--format", "png", "--width", "63", "--dark"];
    let file = written("dark.png", &arguments);
    let picture = Pixmap::decode_png(&std::fs::read(file).unwrap()).unwrap();
    // The background covers the last row, although the document's height is not a whole number of pixels.
    for y in [0, picture.height() - 1] {
        let paper = picture.pixel(0, y).unwrap();
        let channels = [paper.red(), paper.green(), paper.blue(), paper.alpha()];
        assert_eq!(channels, [0x18, 0x18, 0x18, 0xff]);
    }
}

#[test]
fn too_many_pixels_are_rejected() {
    let arguments = [
        "four-bar", "--format", "png", "--width", "8192", "--size", "10x2000",
    ];
    let mut command = command(&["draw"]);
    let output = command.args(arguments).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(error.contains("is too large"), "{error}");
}
