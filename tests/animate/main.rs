//! Animations: the page, the verb, and the page in a headless browser if there is a Chromium.

#[path = "../report/browser.rs"]
mod browser;
mod motion;
mod verb;

/// A girder on a pier with friction, which a second mass meets, under a pulse of the ground.
const BRIDGE: &str = r#"{
  "title": "A girder that meets a mass",
  "problem": "structure",
  "parameters": { "gamma": [1, 4], "gap": 0.01, "dt": 0.0005, "duration": 2 },
  "structure": {
    "units": "t, kN, m, s",
    "masses": { "pier": 100, "wall": 300 },
    "bars": { "girder": { "L": 40, "EA": 1.5e8, "mass": 500, "n": 4, "stiffness_damping": 1e-3 } },
    "springs": [
      { "between": ["ground", "pier"], "mass": 600, "period": 0.8, "ratio": 0.05 },
      { "between": ["ground", "wall"], "mass": 300, "period": 0.4, "ratio": 0.05 }
    ],
    "contacts": {
      "gap": { "law": "impact", "between": ["girder.right", "wall"], "gap": "gap", "k": "gamma*4*1.5e8/40" },
      "bearing": { "law": "displacement-control", "between": ["pier", "girder.left"], "nu": 0.2, "N": 2450, "rE": 0.0005 }
    },
    "ground": { "sine": { "amplitude": -4, "omega": 9 } }
  },
  "metrics": ["peak(gap.S)"],
  "figures": [{ "name": "history", "kind": "history", "y": ["gap.S"], "where": { "gamma": 4 } }]
}"#;

const OSCILLATOR: &str = r#"{ "problem": "friction-oscillator", "title": "A mass",
  "parameters": { "law": "displacement-control", "alpha": [0.1, 0.3], "dT": "pi/40", "duration": "8*pi" } }"#;

const BARS: &str = r#"{ "problem": "bar-impact", "title": "Two bars",
  "parameters": { "gamma": [1, 2], "n": 12, "dt": 0.01, "duration": 2, "gap": 0.4 } }"#;
