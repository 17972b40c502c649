//! The page in a browser shows the motion that the solver gives.

use super::browser::{browse, chromium, probe};
use super::{BARS, BRIDGE, OSCILLATOR};
use serde_json::Value as Json;
use slipgap::animate::{Shown, animate};
use slipgap::problem::Solution;
use slipgap::study::{self, Study};
use std::fs;

fn page(study: &Study, cases: &[u64], exact: bool) -> String {
    let shown = Shown {
        cases: cases.to_vec(),
        exact,
    };
    animate(study, "s", &shown).unwrap()
}

/// A channel of the computed motion of a case.
fn channel(study: &Study, number: u64, solution: &Solution, name: &str) -> Vec<f64> {
    let case = study.case(number).unwrap();
    let columns = study.problem.history_columns(&case).into_iter();
    let column = { columns }
        .find(|channel| channel.column.name == name)
        .unwrap();
    solution.computed.channel(column.index).to_vec()
}

fn numbers(list: &Json) -> Vec<f64> {
    let list = list.as_array().unwrap().iter();
    list.map(|x| x.as_f64().unwrap()).collect()
}

/// Asks the page at every seventh step what it shows.
const PROBE: &str = r#"
const film = films[0], half = film.t.length ? data.films[0].half : 0;
const chip = name => film.contacts.find(own => own.name === name).chip;
probe.lit = { gap: [], bearing: [] };
probe.moves = [];
probe.force = [];
for (let step = 0; step <= STEPS; step += 7) {
  set(2 * step * half);
  for (const name in probe.lit) probe.lit[name].push(Number(chip(name).classList.contains("lit")));
  probe.moves.push(stateAt(film, now).moves[film.scene.masses[0].by[0]]);
  probe.force.push(valueAt(film.contacts[0].force, now));
}
const cursor = () => parseFloat(document.querySelector(".cursor").style.left);
set(0);
const start = cursor();
byId("play").click();
tick(0); tick(50); tick(100);
probe.played = [now, cursor() > start, byId("play").getAttribute("aria-label")];
document.body.dispatchEvent(new KeyboardEvent("keydown", { key: " ", bubbles: true }));
probe.paused = playing;
document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "End", bubbles: true }));
probe.end = now;
document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true }));
probe.back = now;
const box = document.querySelector(".plot").getBoundingClientRect();
const margin = MARGIN();
document.querySelector(".plot").dispatchEvent(new PointerEvent("pointerdown", { clientX: box.left + margin + (box.width - margin - 8) / 2, pointerId: 1, bubbles: true }));
probe.clicked = now;
const slider = byId("magnify");
slider.value = 1;
slider.dispatchEvent(new Event("input"));
probe.times = [magnify, byId("times").textContent];
slider.value = 0;
slider.dispatchEvent(new Event("input"));
probe.once = [magnify, byId("times").textContent, document.body.innerText.includes("magnified")];
slider.value = 1;
slider.dispatchEvent(new Event("input"));
byId("scrub").value = 0.25;
byId("scrub").dispatchEvent(new Event("input"));
probe.scrubbed = now;
probe.plots = plots.map(own => own.title);
"#;

#[test]
fn contacts_are_lit_where_they_have_a_force_or_slide() {
    let Some(program) = chromium() else { return };
    let study = study::parse("s.json", BRIDGE).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &[]).unwrap();
    let steps = solution.computed.len() - 1;
    // A pointer that is not pressed cannot be captured.
    let script = format!("Element.prototype.setPointerCapture = () => {{}};{PROBE}")
        .replace("STEPS", &steps.to_string());
    let found = probe(&program, folder.path(), &page(&study, &[0], false), &script);
    let of = |name: &str| channel(&study, 0, &solution, name);
    let every = |values: Vec<f64>| -> Vec<f64> { values.into_iter().step_by(7).collect() };
    let touches: Vec<f64> = every(of("gap.S"))
        .iter()
        .map(|s| f64::from(*s != 0.0))
        .collect();
    assert!(touches.contains(&1.0) && touches.contains(&0.0));
    assert_eq!(numbers(&found["lit"]["gap"]), touches);
    // nu N = 490; the limit is reached exactly.
    let slides: Vec<f64> = every(of("bearing.S"))
        .iter()
        .map(|s| f64::from(s.abs() >= 0.99 * 490.0))
        .collect();
    assert!(slides.contains(&1.0) && slides.contains(&0.0));
    assert_eq!(numbers(&found["lit"]["bearing"]), slides);
    // A place on the page is as near as its lines between frames and its rounding: 0.2 % and 0.02 % of the largest displacement.
    let nodes = ["pier.u", "wall.u", "girder.left.u", "girder.right.u"];
    let largest = nodes
        .iter()
        .flat_map(|name| of(name))
        .fold(0.0, |most: f64, u| most.max(u.abs()));
    for (shown, u) in numbers(&found["moves"]).iter().zip(every(of("pier.u"))) {
        assert!((shown - u).abs() < 2.3e-3 * largest, "{shown} {u}");
    }
    // Forces are as near as 0.2 % and 0.05 % of the largest.
    let force = of("gap.S");
    let largest = force.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
    for (shown, s) in numbers(&found["force"]).iter().zip(every(force)) {
        assert!((shown - s).abs() < 2.6e-3 * largest, "{shown} {s}");
    }
    // 2 s in about 20 s: a tenth of a second is 0.01 s.
    assert_eq!(found["played"][1], true);
    assert!((found["played"][0].as_f64().unwrap() - 0.01).abs() < 1e-9);
    assert_eq!(found["played"][2], "Pause");
    assert_eq!(found["paused"], false);
    assert_eq!(found["end"], 2.0);
    assert!((found["back"].as_f64().unwrap() - 1.99).abs() < 1e-9);
    assert!((found["clicked"].as_f64().unwrap() - 1.0).abs() < 1e-6);
    assert_eq!(found["times"], serde_json::json!([2, "× 2.0"]));
    // What is not magnified is not called so.
    assert_eq!(found["once"], serde_json::json!([1, "", false]));
    assert_eq!(found["scrubbed"], 0.5);
    let titles = ["ground: acceleration", "gap: force S", "bearing: force S"];
    assert_eq!(found["plots"], serde_json::json!(titles));
}

/// Whether something is drawn on each canvas.
const DRAWN: &str = r#"
const inked = canvas => {
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 3; i < data.length; i += 4) if (data[i] > 0) count += 1;
  return count > 500;
};
set(0.3 * data.duration);
probe.drawn = [...document.querySelectorAll("canvas")].map(inked);
probe.labels = [...document.querySelectorAll("figcaption strong")].map(own => own.textContent);
probe.title = [document.title, document.querySelector("h1").textContent, window.bad === undefined];
probe.wide = document.documentElement.scrollWidth <= innerWidth;
"#;

#[test]
fn two_cases_or_the_exact_motion_are_side_by_side() {
    let Some(program) = chromium() else { return };
    for (text, title) in [(OSCILLATOR, "A mass"), (BARS, "Two bars")] {
        let study = study::parse("s.json", text).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let two = probe(
            &program,
            folder.path(),
            &page(&study, &[0, 1], false),
            DRAWN,
        );
        let name = if text == BARS { "gamma" } else { "alpha" };
        let values = if text == BARS {
            ["1", "2"]
        } else {
            ["0.1", "0.3"]
        };
        let labels = [0, 1].map(|i| format!("case {i}: {name} = {}", values[i]));
        assert_eq!(two["labels"], serde_json::json!(labels));
        assert_eq!(two["drawn"], serde_json::json!([true, true, true]));
        let both = probe(&program, folder.path(), &page(&study, &[1], true), DRAWN);
        assert_eq!(both["labels"], serde_json::json!(["computed", "exact"]));
        assert_eq!(both["drawn"], serde_json::json!([true, true, true]));
        assert_eq!(both["title"], serde_json::json!([title, title, true]));
        assert_eq!(both["wide"], true);
    }
}

#[test]
fn a_title_is_text() {
    let Some(program) = chromium() else { return };
    let title = "<img src=x onerror='window.bad=1'></script><script>window.bad = 1</script>";
    let study = study::parse("s.json", &OSCILLATOR.replace("A mass", title)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let found = probe(&program, folder.path(), &page(&study, &[0], false), DRAWN);
    assert_eq!(found["title"], serde_json::json!([title, title, true]));
}

/// The bars are r apart on the page: the faces of the drawing are moved by what the history says.
#[test]
fn bars_are_as_far_apart_as_their_contact() {
    let Some(program) = chromium() else { return };
    let study = study::parse("s.json", BARS).unwrap();
    let solution = study.problem.solve(&study.case(0).unwrap(), &[]).unwrap();
    let script = r#"
const [left, right_] = films[0].scene.bars.map(own => own.nodes);
probe.apart = [];
for (let step = 0; step <= 200; step += 5) {
  const { moves } = stateAt(films[0], 2 * step * data.films[0].half);
  probe.apart.push(moves[right_[0]] - moves[left[left.length - 1]]);
}"#;
    let folder = tempfile::tempdir().unwrap();
    let script = format!("{{{script}}}");
    let found = probe(&program, folder.path(), &page(&study, &[0], false), &script);
    let r = solution.computed.displacement();
    for (shown, r) in numbers(&found["apart"]).iter().zip(r.iter().step_by(5)) {
        // Rounding, and lines between frames, of two ends that move by up to about 2.
        assert!((shown - r).abs() < 0.01, "{shown} {r}");
    }
}

/// Faces are as far apart as r at the scale of the displacements, that of the bar at the lower left; what has no room says so.
#[test]
fn gaps_have_the_scale_of_displacements() {
    let Some(program) = chromium() else { return };
    let script = r#"
const own = drawings[0], link = films[0].scene.links.find(own => own.kind === "impact");
const said = [];
own.word = text => said.push(text);
probe.apart = [];
probe.cut = [];
probe.room = [];
for (let step = 0; step <= 4000; step += 7) {
  said.length = 0;
  set(2 * step * data.films[0].half);
  const [a, b] = link.ends.map(([at, by]) => own.moved(at, by));
  const { apart, is_cut } = own.apart(link, a, b);
  probe.apart.push(apart / own.factor);
  probe.room.push(b[0] - a[0] - apart);
  probe.cut.push(is_cut ? parseFloat(said.find(text => text.startsWith("r = ")).slice(4)) : null);
}"#;
    for (gap, is_cut) in [("0.01", false), ("0.04", false), ("5", true)] {
        let text = BRIDGE.replace(r#""gap": 0.01"#, &format!(r#""gap": {gap}"#));
        let study = study::parse("s.json", &text).unwrap();
        let solution = study.problem.solve(&study.case(0).unwrap(), &[]).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let script = format!("{{{script}}}");
        let found = probe(&program, folder.path(), &page(&study, &[0], false), &script);
        let r = channel(&study, 0, &solution, "gap.r");
        let ends = ["girder.right.u", "wall.u"].map(|name| channel(&study, 0, &solution, name));
        let largest = ends
            .iter()
            .flatten()
            .fold(0.0_f64, |most, u| most.max(u.abs()));
        for (shown, r) in numbers(&found["apart"]).iter().zip(r.iter().step_by(7)) {
            // As near as places: 0.2 % and 0.02 % of the largest displacement.
            if !is_cut {
                assert!(
                    (shown - r.max(0.0)).abs() < 2.3e-3 * largest,
                    "{gap}: {shown} {r}"
                );
            }
        }
        for (said, r) in found["cut"]
            .as_array()
            .unwrap()
            .iter()
            .zip(r.iter().step_by(7))
        {
            // Two digits of about 5, and the place.
            let holds = |said: f64| (said - r).abs() < 0.05 + 2.3e-3 * largest;
            assert_eq!(
                said.as_f64().map(holds),
                is_cut.then_some(true),
                "{gap}: {said} {r}"
            );
        }
        // The faces are between the parts.
        assert!(
            numbers(&found["room"]).iter().all(|room| *room > 3.0),
            "{gap}"
        );
    }
}

/// The ground motion is on a screen of 1280 times 720 points together with the films.
#[test]
fn the_ground_is_on_the_screen() {
    let Some(program) = chromium() else { return };
    let study = study::parse("s.json", BRIDGE).unwrap();
    let script = r#"
Object.defineProperty(window, "innerHeight", { value: 720 });
layout();
const area = plots[0].canvas.getBoundingClientRect();
probe.ground = [plots[0].title, area.bottom <= 720, area.height > 70, drawings.every(own => own.height >= 100)];"#;
    for cases in [&[0][..], &[0, 1]] {
        let folder = tempfile::tempdir().unwrap();
        let page = page(&study, cases, false);
        let found = probe(&program, folder.path(), &page, script);
        let wanted = serde_json::json!(["ground: acceleration", true, true, true]);
        assert_eq!(found["ground"], wanted, "{cases:?}");
    }
}

/// Without help from the test, the page plays in the time of the browser.
#[test]
fn the_page_plays() {
    let Some(program) = chromium() else { return };
    let study = study::parse("s.json", OSCILLATOR).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let page = page(&study, &[0], false);
    // The time of the browser is virtual, for timers only.
    let frames = "<head><script>window.requestAnimationFrame = f => setTimeout(() => f(performance.now()), 16);</script>";
    let page = page.replacen("<head>", frames, 1);
    let start = "<script>byId('play').click();</script></body>";
    let file = folder.path().join("play.html");
    fs::write(&file, page.replace("</body>", start)).unwrap();
    let address = format!("file://{}", file.display());
    let words = ["--virtual-time-budget=3000", "--dump-dom", &address];
    let dom = browse(&program, folder.path(), &words);
    let rest = dom.split_once("data-time=\"").unwrap().1;
    let time: f64 = rest.split_once('"').unwrap().0.parse().unwrap();
    assert!(time > 0.5, "{time}");
}
