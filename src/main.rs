//! The program `krank`.

fn main() {
    let name = std::env::args().nth(1).unwrap_or("four-bar".into());
    let preset = krank::scene::presets::find(&name).unwrap();
    let scene = krank::scene::Scene::parse(preset.text, preset.name).unwrap();
    let solver = krank::solver::Solver::new(&scene.mechanism).unwrap();
    let opened = krank::tui::Opened { scene, solver, origin: krank::tui::Origin::Preset(name) };
    if let Err(e) = krank::tui::run(opened, &Default::default()) { eprintln!("error: {e}"); std::process::exit(if e.is_usage() {2} else {1}); }
}
