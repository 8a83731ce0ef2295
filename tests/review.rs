#![allow(warnings)]
use krank::quantity::{Catalogue, Quantity};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Solver, Range, State, Indeterminate};
use krank::*;

fn cross(a: Vec2, b: Vec2) -> f64 { a.x * b.y - a.y * b.x }

struct Sys { n: usize, rows: Vec<(Vec<f64>, f64)> }

/// Full pivot elimination: particular solution, nullspace basis.
fn solve(mut a: Vec<Vec<f64>>, n: usize) -> (Vec<f64>, Vec<Vec<f64>>, f64) {
    let m = a.len();
    let mut cols: Vec<usize> = (0..n).collect();
    let mut r = 0;
    while r < m && r < n {
        let mut best = (0.0, r, r);
        for i in r..m { for j in r..n { if a[i][j].abs() > best.0 { best = (a[i][j].abs(), i, j); } } }
        if best.0 < 1e-8 { break; }
        a.swap(r, best.1);
        cols.swap(r, best.2);
        for row in a.iter_mut() { row.swap(r, best.2); }
        let p = a[r][r];
        for j in r..=n { a[r][j] /= p; }
        for i in 0..m { if i != r { let f = a[i][r]; if f != 0.0 { for j in r..=n { let v = a[r][j]; a[i][j] -= f * v; } } } }
        r += 1;
    }
    let incons = a[r..].iter().map(|row| row[n].abs()).fold(0.0, f64::max);
    let mut x = vec![0.0; n];
    for i in 0..r { x[cols[i]] = a[i][n]; }
    let mut null = vec![];
    for j in r..n {
        let mut v = vec![0.0; n];
        v[cols[j]] = 1.0;
        for i in 0..r { v[cols[i]] = -a[i][j]; }
        null.push(v);
    }
    (x, null, incons)
}

struct Reference { frame: Vec2, moment: f64, joints: Vec<(LinkId, PointId, [f64;2], bool)>, normals: Vec<(f64,bool)>, moments: Vec<(f64,bool)>, drive: (f64,bool), incons: f64 }

fn reference(mech: &Mechanism, state: &State, bottoms: &dyn Fn(SlideId, StrokeEnd)->f64) -> Reference {
    let metres = mech.metres();
    let pos = |p: PointId| state.position(p) * metres;
    let np = mech.points().len();
    let mut force = vec![Vec2::new(0.0,0.0); np];
    let mut couple = vec![0.0; mech.links().len()];
    let prof = |over: &Profile, x: f64| -> f64 {
        let k = over.knots();
        if k.is_empty() { return 1.0; }
        let span = k[k.len()-1][0]-k[0][0];
        let mut x = x;
        if matches!(mech.driver().input, Input::Turn(_)) && span > 0.0 && span % 360.0 == 0.0 { x = k[0][0] + (x - k[0][0]).rem_euclid(span); }
        if x <= k[0][0] { return k[0][1]; }
        for w in k.windows(2) { if x <= w[1][0] { return w[0][1] + (w[1][1]-w[0][1])*(x-w[0][0])/(w[1][0]-w[0][0]); } }
        k[k.len()-1][1]
    };
    for load in mech.loads() { match load {
        Load::Force { point, force: f, frame, over } => {
            let f = match frame { Body::Ground => *f, Body::Link(l) => { let d = state.direction(*l); Vec2::new(f.x*d.x - f.y*d.y, f.x*d.y + f.y*d.x) } };
            force[point.index()] += f * prof(over, state.at());
        }
        Load::Torque { link, torque, over } => couple[link.index()] += torque * prof(over, state.at()),
        Load::Press { slide, end, curve } => {
            let t = state.travel(*slide);
            let b = bottoms(*slide, *end);
            let (d, tow, dir) = match end { StrokeEnd::Least => (t.position - b, -t.rate, 1.0), StrokeEnd::Greatest => (b - t.position, t.rate, -1.0) };
            let k = curve.knots();
            if d <= k[k.len()-1][0] && tow > 0.0 {
                let mut v = k[0][1];
                if d > k[0][0] { for w in k.windows(2) { if d <= w[1][0] && d > w[0][0] { v = w[0][1] + (w[1][1]-w[0][1])*(d-w[0][0])/(w[1][0]-w[0][0]); } } }
                force[mech.slide(*slide).slider.point().index()] += t.guide * (dir * v);
            }
        }
        Load::Spring { from, to, stiffness, length, damping } => {
            let e = (state.position(*to) - state.position(*from)) * metres;
            let n = e.norm();
            let rate = (e * (1.0/n)).dot((state.velocity(*to) - state.velocity(*from)) * metres);
            let f = e * ((stiffness * (n - length*metres) + damping * rate) / n);
            force[from.index()] += f; force[to.index()] += -f;
        }
    }}
    for l in mech.link_ids() {
        let link = mech.link(l);
        if let Some(c) = link.com {
            force[c.index()] += mech.gravity() * link.mass - state.acceleration(c) * (metres * link.mass);
            couple[l.index()] -= link.inertia * state.alpha(l);
        }
    }
    // unknowns
    let mut joints = vec![];
    let mut idx = 0;
    let mut jmap = std::collections::HashMap::new();
    for l in mech.link_ids() { for m in &mech.link(l).members { jmap.insert((l, m.point), idx); joints.push((l, m.point, idx)); idx += 2; } }
    let nslides = mech.slides().len();
    let n0 = idx; idx += nslides; // normals
    let m0 = idx; idx += nslides; // moments (pin: zero rows)
    let d0 = idx; idx += 1;
    let n = idx;
    let mut rows: Vec<Vec<f64>> = vec![];
    let new = || vec![0.0; n + 1];
    // scale of lengths
    let scale = mech.point_ids().map(|p| pos(p).norm()).fold(0.0, f64::max);
    let guides: Vec<(Vec2, Vec2, bool)> = mech.slide_ids().map(|s| (state.travel(s).guide, pos(mech.slide(s).slider.point())*(1.0/scale), mech.driver().input == Input::Push(s))).collect();
    for l in mech.link_ids() {
        let (mut fx, mut fy, mut mo) = (new(), new(), new());
        for m in &mech.link(l).members {
            let i = jmap[&(l, m.point)];
            fx[i] += 1.0; fy[i+1] += 1.0;
            let r = pos(m.point)*(1.0/scale);
            mo[i] += -r.y; mo[i+1] += r.x;
        }
        for s in mech.slide_ids() {
            let g = mech.slide(s);
            let mut sign = 0.0;
            if let Slider::Link { link, .. } = g.slider { if link == l { sign += 1.0; } }
            if g.on == Body::Link(l) { sign -= 1.0; }
            if sign == 0.0 { continue; }
            let (t, r, driven) = guides[s.index()];
            let nn = Vec2::new(-t.y, t.x);
            fx[n0+s.index()] += sign*nn.x; fy[n0+s.index()] += sign*nn.y; mo[n0+s.index()] += sign*cross(r, nn);
            if driven { fx[d0] += sign*t.x; fy[d0] += sign*t.y; mo[d0] += sign*cross(r,t); }
            if matches!(g.slider, Slider::Link{..}) { mo[m0+s.index()] += sign; }
        }
        if mech.driver().input == Input::Turn(l) { mo[d0] += 1.0; }
        mo[n] = -couple[l.index()]/scale;
        rows.push(fx); rows.push(fy); rows.push(mo);
    }
    for p in mech.point_ids() {
        if mech.point(p).ground.is_some() { continue; }
        let (mut fx, mut fy) = (new(), new());
        for &l in &mech.point(p).links { let i = jmap[&(l,p)]; fx[i] -= 1.0; fy[i+1] -= 1.0; }
        for s in mech.slide_ids() { if mech.slide(s).slider == Slider::Pin(p) {
            let (t, _, driven) = guides[s.index()];
            fx[n0+s.index()] += -t.y; fy[n0+s.index()] += t.x;
            if driven { fx[d0] += t.x; fy[d0] += t.y; }
        }}
        fx[n] = -force[p.index()].x; fy[n] = -force[p.index()].y;
        rows.push(fx); rows.push(fy);
    }
    for s in mech.slide_ids() { if matches!(mech.slide(s).slider, Slider::Pin(_)) { let mut r = new(); r[m0+s.index()] = 1.0; rows.push(r); } }
    let (x, null, incons) = solve(rows, n);
    let open = |i: usize| null.iter().any(|v| v[i].abs() > 1e-7);
    let turn = matches!(mech.driver().input, Input::Turn(_));
    let mut fm = Vec2::new(0.0,0.0); let mut mm = 0.0; for p in mech.point_ids() { fm += force[p.index()]; mm += cross(pos(p), force[p.index()]); } mm += couple.iter().sum::<f64>();
    Reference { frame: fm, moment: mm,
        joints: joints.iter().map(|&(l,p,i)| (l,p,[x[i],x[i+1]], open(i)||open(i+1))).collect(),
        normals: (0..nslides).map(|s| (x[n0+s], open(n0+s))).collect(),
        moments: (0..nslides).map(|s| (x[m0+s]*scale, open(m0+s))).collect(),
        drive: (if turn { x[d0]*scale } else { x[d0] }, open(d0)),
        incons,
    }
}

fn report(name: &str, text: &str, verbose: bool) {
    let scene = match Scene::parse(text, name) { Ok(s) => s, Err(e) => { println!("== {name}: PARSE {e}"); return; } };
    let mech = &scene.mechanism;
    let solver = match Solver::new(mech) { Ok(s) => s, Err(e) => { println!("== {name}: SOLVER {e:?}"); return; } };
    println!("== {name}: groups {:?} redundant {:?} indeterminate {:?}", solver.plan().groups.iter().map(|g| g.kind).collect::<Vec<_>>(), solver.plan().redundant, solver.indeterminate());
    let (lo, hi) = match solver.motion().range { Range::Full{period} => (0.0, period), Range::Limited{low,high} => (low,high) };
    let mut state = solver.state();
    let mut balls = solver.enclosure();
    let mut truth = solver.twice();
    let cat = Catalogue::new(&scene);
    let mut lanes = solver.lanes();
    // bottoms by brute sampling of all slides
    let mut ext = vec![(f64::INFINITY, f64::NEG_INFINITY); mech.slides().len()];
    for k in 0..=20000 { let at = lo + (hi-lo)*k as f64/20000.0; if matches!(solver.solve(at, Order::Position, &mut state), Condition::Ok|Condition::ChangePoint|Condition::DeadPoint) { for s in mech.slide_ids() { let p = state.travel(s).position; let e = &mut ext[s.index()]; e.0 = e.0.min(p); e.1 = e.1.max(p); } } }
    let bottoms = |s: SlideId, e: StrokeEnd| match e { StrokeEnd::Least => ext[s.index()].0, StrokeEnd::Greatest => ext[s.index()].1 };
    let mut said = std::collections::HashSet::new();
    let (mut checked, mut laned) = (0, 0);
    for k in 0..41 {
        let at = lo + (hi - lo) * (k as f64 + 0.37) / 41.0;
        let c = solver.solve(at, Order::Force, &mut state);
        if c != Condition::Ok { if said.insert(format!("cond{c:?}")) { println!("  at {at}: {c:?} drive {:?} parts {:?}", state.drive(), state.drive_parts()); } continue; }
        checked += 1;
        let r = reference(mech, &state, &bottoms);
        let size = r.joints.iter().filter(|j| !j.3).map(|j| j.2[0].abs().max(j.2[1].abs())).chain(r.normals.iter().filter(|n| !n.1).map(|n| n.0.abs())).fold(1e-3, f64::max);
        let mut say = |key: String, msg: String| { if said.insert(key) { println!("  at {at}: {msg}"); } };
        if r.incons > 1e-6*size { say("incons".into(), format!("reference inconsistent {:e}", r.incons)); }
        for &(l,p,want,open) in &r.joints {
            if !mech.pins(l).any(|q| q == p) { continue; }
            let nm = format!("{}.{}", scene.link_name(l), scene.point_name(p).unwrap_or("?"));
            match (state.joint_force(l,p), open) {
                (Some(g), false) => { let miss = (g.x-want[0]).abs().max((g.y-want[1]).abs()); if !(miss < 1e-5*size) { say(nm.clone(), format!("JOINT {nm} got {g:?} want {want:?}")); } }
                (None, true) => {}
                (None, false) => say(nm.clone(), format!("JOINT {nm} named open but determinate {want:?}")),
                (Some(g), true) => say(nm.clone(), format!("JOINT {nm} open but given {g:?}")),
            }
        }
        for s in mech.slide_ids() {
            let nm = scene.slide_name(s).to_owned();
            let tests = [("normal", state.normal(s), r.normals[s.index()]), ("moment", if matches!(mech.slide(s).slider, Slider::Link{..}) { state.moment(s) } else { None }, r.moments[s.index()])];
            for (what, got, (want, open)) in tests {
                if what == "moment" && matches!(mech.slide(s).slider, Slider::Pin(_)) { continue; }
                let key = format!("{nm}.{what}");
                match (got, open) {
                    (Some(g), false) => if !((g-want).abs() < 1e-5*size) { say(key.clone(), format!("SLIDE {key} got {g} want {want}")); },
                    (None, true) => {}
                    (None,false) => say(key.clone(), format!("SLIDE {key} named open but determinate {want}")),
                    (Some(g), true) => say(key.clone(), format!("SLIDE {key} open but given {g}")),
                }
            }
        }
        match state.drive() { Some(d) => if !((d - r.drive.0).abs() < 1e-5*size.max(d.abs())) { say("drive".into(), format!("DRIVE got {d} want {} parts {:?}", r.drive.0, state.drive_parts())); }, None => say("drive".into(), format!("DRIVE none, want {}", r.drive.0)) }
        if let Some(res) = state.residual() { if res.drive.abs() > 1e-8*size || res.force.norm() > 1e-8*size || res.moment.abs() > 1e-8*size { say("res".into(), format!("RESIDUAL {res:?} size {size}")); } } else { say("nores".into(), "no residual".into()); }
        if let (Some(f), Some(m)) = (state.frame_force(), state.frame_moment()) { if !((f - r.frame).norm() < 1e-6*size && (m - r.moment).abs() < 1e-6*size.max(m.abs())) { say("frame".into(), format!("FRAME {f:?} {m} want {:?} {}", r.frame, r.moment)); } }
        if let (Some(p), Some(d)) = (state.power(), state.drive()) { let metres = if matches!(mech.driver().input, Input::Turn(_)) {1.0} else {mech.metres()}; let want = d*mech.driver().speed*metres; if (p-want).abs() > 1e-9*want.abs() { say("power".into(), format!("POWER {p} {want}")); } }
        // bounds
        let tw = solver.solve_twice(&state, Order::Force, &mut truth);
        solver.enclose(&state, Order::Force, &mut balls);
        for q in cat.all().iter().filter(|q| q.aspect.order() == Order::Force) {
            let Some(v) = q.value(&state) else { say(format!("nov{}", q.name), format!("no value {}", q.name)); continue };
            let b = q.bound(&state, &balls);
            if b.is_none() { say(format!("nob{}", q.name), format!("no bound {} = {v}", q.name)); }
            if tw { if let (Some(b), Some(e)) = (b, q.value(&truth)) { let miss = (e - Double::exactly(v)).abs().hi; if miss > b { say(format!("bound{}", q.name), format!("BOUND {} miss {miss:e} > {b:e}", q.name)); } } }
        }
        // lanes
        let ats: [f64; LANES] = std::array::from_fn(|i| at + i as f64 * 0.01 * (hi-lo)/41.0);
        if solver.solve_lanes(ats, Order::Force, &mut lanes) {
            laned += 1;
            for i in 0..LANES {
                solver.solve(ats[i], Order::Force, &mut state);
                for q in cat.all().iter().filter(|q| q.aspect.order() == Order::Force) {
                    let a = q.value(&state); let b = krank::quantity::value(q.subject, q.aspect, &lanes).map(|l: Lanes| l.0[i]);
                    if a.map(f64::to_bits) != b.map(f64::to_bits) { say(format!("lane{}", q.name), format!("LANE {} {a:?} {b:?}", q.name)); }
                }
            }
        }
        if verbose && k % 10 == 0 { solver.solve(at, Order::Force, &mut state); println!("   {at}: drive {:?} parts {:?} power {:?}", state.drive(), state.drive_parts(), state.power()); }
    }
    for line in text.lines().filter_map(|l| l.strip_prefix("#at ")) { for at in line.split_whitespace().map(|v| v.parse::<f64>().unwrap()) {
        let c = solver.solve(at, Order::Force, &mut state);
        solver.enclose(&state, Order::Force, &mut balls);
        let tw = solver.solve_twice(&state, Order::Force, &mut truth);
        println!("  at {at}: {c:?} drive {:?} parts {:?} sum {:?}", state.drive(), state.drive_parts(), state.drive_parts().map(|p| p[0]+p[1]+p[2]));
        for q in cat.all().iter().filter(|q| q.aspect.order() == Order::Force) {
            let v = q.value(&state); let b = q.bound(&state, &balls); let t = if tw { q.value(&truth).map(|d| d.hi) } else { None };
            if text.contains("#full") || v.is_none() || b.is_none() || (tw && v.is_some() && (q.value(&truth).unwrap() - Double::exactly(v.unwrap())).abs().hi > b.unwrap()) { println!("     {} = {v:?} +- {b:?} truth {t:?}", q.name); }
        }
        let ats: [f64; LANES] = std::array::from_fn(|i| at + i as f64);
        if solver.solve_lanes(ats, Order::Force, &mut lanes) { for i in 0..LANES { solver.solve(ats[i], Order::Force, &mut state); for q in cat.all().iter().filter(|q| q.aspect.order() == Order::Force) { let a = q.value(&state); let b = krank::quantity::value(q.subject, q.aspect, &lanes).map(|l: Lanes| l.0[i]); if a.map(f64::to_bits) != b.map(f64::to_bits) { println!("     LANE {} at {} {a:?} {b:?}", q.name, ats[i]); } } } }
    } }
    println!("  checked {checked} laned {laned}");
}

#[test]
fn scenes() {
    let dir = std::env::var("SCENES").unwrap_or("/tmp/rscenes".into());
    let mut files: Vec<_> = std::fs::read_dir(dir).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    for f in files { let text = std::fs::read_to_string(&f).unwrap(); let name = f.file_name().unwrap().to_string_lossy().into_owned();
        let v = text.contains("#verbose");
        let r = std::panic::catch_unwind(|| report(&name, &text, v));
        if r.is_err() { println!("== {name}: PANIC"); }
    }
}
