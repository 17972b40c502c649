// The drawing of a film at a time.

const INK = "#27364b", TOUCH = "#f06a00", SLIDE = "#008f6a", GROUND = "#5c6b80";

// Length of the rods between the faces of a contact and its parts.
const RODS = 4;

// Links that are drawn over the parts.
const OVER = new Set(["impact", "friction", "faces"]);

// Blue for compression, white for none, red for tension.
function shade(x) {
  const part = Math.min(1, Math.abs(x)) ** 0.7;
  const end = x < 0 ? [33, 102, 172] : [178, 24, 43];
  return `rgb(${end.map(c => Math.round(255 + part * (c - 255))).join(",")})`;
}

// For nodes that a reduction left out, how much each of the others moves them: each is in the middle of its neighbours.
function between({ nodes, lines, left_out }) {
  if (left_out.length === 0) return [];
  const out = new Set(left_out);
  const beside = nodes.map(() => []);
  for (const [a, b] of lines) { beside[a].push(b); beside[b].push(a); }
  const kept = nodes.map((_, k) => k).filter(k => !out.has(k) && (nodes[k][2] !== null || nodes[k][3] !== null));
  return kept.map(k => {
    const part = nodes.map((_, i) => i === k ? 1 : 0);
    for (let sweep = 0; sweep < 2000; sweep++) {
      let change = 0;
      for (const i of left_out) {
        if (beside[i].length === 0) continue;
        const mean = beside[i].reduce((sum, j) => sum + part[j], 0) / beside[i].length;
        change = Math.max(change, Math.abs(mean - part[i]));
        part[i] = mean;
      }
      if (change < 1e-4) break;
    }
    return [k, part];
  });
}

class Drawing {
  constructor(film, canvas) {
    this.film = film;
    this.canvas = canvas;
    this.c = canvas.getContext("2d");
    this.weights = between(film.scene);
  }

  // The size of the canvas for its width on the page.
  fit() {
    const [left, top, right, bottom] = data.bounds;
    const side = Math.min(70, 10 + data.reach);
    const foot = ground ? 36 : 22;
    const width = this.canvas.parentElement.clientWidth;
    // All films, the controls and the first plot are on the screen, if the films do not become too small.
    const rows = document.querySelector(".beside") ? 1 : films.length;
    const others = [...document.querySelectorAll("figcaption")].slice(0, rows).reduce((sum, own) => sum + own.offsetHeight + 14, 0);
    const below = document.querySelector("main.narrow") ? 0 : byId("controls").offsetHeight + FIRST_PLOT;
    const free = innerHeight - byId("films").offsetTop - others - below;
    const most = Math.min(0.5 * innerHeight, Math.max(120, free / rows));
    const whole = [right - left + 2 * side, bottom - top + 16 + foot];
    this.scale = Math.min(width / whole[0], 3, most / whole[1]);
    const height = whole[1] * this.scale;
    const ratio = Math.min(devicePixelRatio || 1, 3);
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.canvas.style.height = height + "px";
    this.ratio = ratio;
    this.width = width;
    this.height = height;
    this.left = width / 2 - this.scale * (left + right) / 2;
    this.top = this.scale * (10 - top);
  }

  draw(t, magnify) {
    const { c, film } = this;
    const state = stateAt(film, t);
    const factor = data.factor * magnify;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.width, this.height);
    c.translate(this.left, this.top);
    c.scale(this.scale, this.scale);
    c.lineCap = c.lineJoin = "round";
    this.shift = k => k === null || k === undefined ? 0 : factor * state.moves[k];
    this.moved = ([x, y], [right, down]) => [x + this.shift(right), y - this.shift(down)];
    this.factor = factor;
    const scene = film.scene;
    for (const own of scene.grounds) this.surface(own);
    this.mesh(scene);
    for (const link of scene.links) if (!OVER.has(link.kind)) this.link(link, state);
    for (const mass of scene.masses) this.mass(mass);
    for (const bar of scene.bars) this.bar(bar, state);
    for (const link of scene.links) if (OVER.has(link.kind)) this.link(link, state);
    for (const own of scene.forces) this.arrow(...own.arrow.map(end => this.moved(end, own.by)), "#8a3ffc");
    for (const own of scene.words) this.word(own.text, this.moved(own.at, own.by), own.align);
    if (ground) this.shaking(t);
    this.ruler();
  }

  line(points, width = 1, colour = INK) {
    const c = this.c;
    c.beginPath();
    points.forEach(([x, y], i) => i ? c.lineTo(x, y) : c.moveTo(x, y));
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.stroke();
  }

  word(text, [x, y], align = "center", colour = INK, size = 8) {
    if (align === "none" || !text) return;
    const c = this.c;
    // Letters are never smaller than on paper.
    const px = Math.max(size, 10.5 / this.scale);
    c.font = `${px}px system-ui, sans-serif`;
    c.textAlign = align;
    c.lineWidth = 0.3 * px;
    c.strokeStyle = "rgba(255,255,255,0.85)";
    c.strokeText(text, x, y);
    c.fillStyle = colour;
    c.fillText(text, x, y);
  }

  mass({ rect: [x, y, w, h], by, name }) {
    const [left, top] = this.moved([x, y], by);
    const c = this.c;
    c.beginPath();
    c.roundRect(left, top, w, h, 2);
    c.fillStyle = "#e4e9f0";
    c.fill();
    c.lineWidth = 1;
    c.strokeStyle = INK;
    c.stroke();
    this.word(name, [left + w / 2, top + h / 2 + 2.8]);
  }

  bar({ rect: [x, y, w, h], name, nodes, stresses }, state) {
    const last = nodes.length - 1;
    // A place of the bar by its part of the length.
    const at = part => {
      const i = Math.min(last - 1, Math.floor(part * last));
      const rest = part * last - i;
      return x + part * w + (1 - rest) * this.shift(nodes[i]) + rest * this.shift(nodes[i + 1]);
    };
    const c = this.c;
    const ends = [at(0), at(1)];
    c.fillStyle = "#fff";
    c.fillRect(ends[0], y, ends[1] - ends[0], h);
    stresses.forEach((k, i) => {
      const [from, to] = [at(i / stresses.length), at((i + 1) / stresses.length)];
      c.fillStyle = shade(state.stresses[k]);
      // Without seams between neighbours.
      c.fillRect(from, y, to - from + 0.4, h);
    });
    c.lineWidth = 1;
    c.strokeStyle = INK;
    c.strokeRect(ends[0], y, ends[1] - ends[0], h);
    this.word(name, [(ends[0] + ends[1]) / 2, y + h / 2 + 2.8]);
  }

  surface({ ends, away, by }) {
    const [from, to] = ends.map(end => this.moved(end, by));
    this.line([from, to], 1.3, GROUND);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const along = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const count = Math.max(1, Math.floor(length / 5));
    for (let i = 0; i < count; i++) {
      const part = length * (i + 0.5) / count;
      const [x, y] = [from[0] + part * along[0], from[1] + part * along[1]];
      this.line([[x, y], [x + 5 * (away[0] - 0.6 * Math.abs(along[0])), y + 5 * (away[1] + 0.6 * Math.abs(along[1]))]], 0.5, GROUND);
    }
  }

  mesh({ nodes, lines, left_out }) {
    if (nodes.length === 0) return;
    const places = nodes.map(([x, y, right, down]) => this.moved([x, y], [right, down]));
    for (const [k, part] of this.weights) {
      const by = [places[k][0] - nodes[k][0], places[k][1] - nodes[k][1]];
      for (const i of left_out) places[i] = [places[i][0] + part[i] * by[0], places[i][1] + part[i] * by[1]];
    }
    const many = lines.length > 100;
    for (const [a, b] of lines) this.line([places[a], places[b]], many ? 0.5 : 1);
    this.c.fillStyle = INK;
    for (const [x, y] of nodes.length > 600 ? [] : places) {
      this.c.beginPath();
      this.c.arc(x, y, many ? 0.8 : 1.6, 0, 7);
      this.c.fill();
    }
  }

  link(link, state) {
    const contact = link.contact === null ? null : this.film.contacts[link.contact];
    const [a, b] = link.ends.map(([at, by]) => this.moved(at, by));
    for (const [end, points] of link.rods) this.line(points.map(own => this.moved(own, link.ends[end][1])), 1);
    switch (link.kind) {
      case "impact": this.impact(link, contact, a, b); break;
      case "friction": this.friction(link, contact, a, b); break;
      case "surface": this.sliding(contact, b); break;
      case "faces": this.faces(contact, a, b); break;
      default: this.spring(link, a, b);
    }
    if (!link.name) return;
    const lit = contact !== null && contact.glow > 0.02;
    const colour = !lit ? "#5c6b80" : link.kind === "impact" ? "#a84a00" : "#00664c";
    const middle = link.ends.map(([at, by]) => this.moved(at, by)[0] - at[0]);
    // Plates that slide need room.
    const room = link.kind === "friction" ? { left: 4, right: -4 }[link.align] ?? 0 : 0;
    this.word(link.name, [link.at[0] + room + (middle[0] + middle[1]) / 2, link.at[1]], link.align, colour, 7.5);
  }

  // Two faces that are r apart, at the scale of the displacements; what has no room between its parts has a break and says r.
  impact(link, contact, a, b) {
    const [dx, dy] = link.direction;
    const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const { apart, is_cut } = this.apart(link, a, b);
    const face = side => [middle[0] + side * dx * apart / 2, middle[1] + side * dy * apart / 2];
    const { glow } = contact;
    if (glow > 0.02) this.halo(middle, glow, TOUCH);
    const colour = glow > 0.02 ? TOUCH : INK;
    for (const [end, side] of [[a, -1], [b, 1]]) {
      const [x, y] = face(side);
      this.line([end, [x, y]], 1);
      this.line([[x - 5 * dy, y + 5 * dx], [x + 5 * dy, y - 5 * dx]], glow > 0.02 ? 2.4 : 1.7, colour);
    }
    if (!is_cut) return;
    for (const by of [-1.2, 1.2]) {
      const [x, y] = [middle[0] + by * dx, middle[1] + by * dy];
      this.line([[x - 3 * dy - 1.5 * dx, y + 3 * dx - 1.5 * dy], [x + 3 * dy + 1.5 * dx, y - 3 * dx + 1.5 * dy]], 0.8, GROUND);
    }
    const r = withUnit(words(this.shift(link.opening) / this.factor, 2), units.length);
    this.word(`r = ${r}`, [middle[0], middle[1] + 14], "center", GROUND, 6.5);
  }

  // How far apart faces are drawn. Nodes of matrices may be at one place: they have all room.
  apart({ ends, direction: [dx, dy], opening }, a, b) {
    const along = ([from, to]) => (to[0] - from[0]) * dx + (to[1] - from[1]) * dy;
    const wanted = Math.max(0, this.shift(opening));
    const room = along(ends.map(own => own[0])) > RODS ? Math.max(0, along([a, b]) - RODS) : Infinity;
    // Half a point is what rounding and lines between frames may miss.
    const is_cut = wanted > room + 0.5;
    return { apart: is_cut ? room : wanted, is_cut };
  }

  halo([x, y], glow, colour) {
    const c = this.c, size = 7 + 15 * glow;
    const light = c.createRadialGradient(x, y, 0, x, y, size);
    light.addColorStop(0, colour + "cc");
    light.addColorStop(0.45, colour + "55");
    light.addColorStop(1, colour + "00");
    c.fillStyle = light;
    c.beginPath();
    c.arc(x, y, size, 0, 7);
    c.fill();
  }

  // Two plates, one for each end, that slide on one another.
  friction({ ends, direction: [dx, dy] }, contact, a, b) {
    const rest = [0, 1].map(k => (ends[0][0][k] + ends[1][0][k]) / 2);
    const across = (b[0] - a[0]) * dy - (b[1] - a[1]) * dx;
    const colour = contact.glow > 0.02 ? SLIDE : INK;
    if (contact.glow > 0.02) {
      const c = this.c;
      const x = rest[0] + (a[0] - ends[0][0][0] + b[0] - ends[1][0][0]) / 2;
      this.halo([x, rest[1]], 0.45 * contact.glow, SLIDE);
    }
    [a, b].forEach((end, k) => {
      const from = ends[k][0];
      const side = (k === 0 ? 1.9 : -1.9) * (across < 0 ? -1 : 1);
      const middle = [rest[0] + end[0] - from[0] - side * dy, rest[1] + end[1] - from[1] + side * dx];
      this.line([end, middle], 1);
      this.line([[middle[0] - 10 * dx, middle[1] - 10 * dy], [middle[0] + 10 * dx, middle[1] + 10 * dy]], 2, colour);
    });
  }

  // Faces of bars that meet.
  faces(contact, a, b) {
    if (contact.glow <= 0.02) return;
    const x = (a[0] + b[0]) / 2;
    this.halo([x, a[1]], contact.glow, TOUCH);
    this.line([[x, a[1] - 17], [x, a[1] + 17]], 3, TOUCH);
  }

  // The surface under a mass.
  sliding(contact, [x, y]) {
    this.line([[x - 34, y + 2], [x + 34, y + 2]], 3, contact.glow > 0.02 ? SLIDE : "#aab4c2");
  }

  spring({ kind, ends }, a, b) {
    const rest = Math.hypot(ends[1][0][0] - ends[0][0][0], ends[1][0][1] - ends[0][0][1]);
    const length = Math.max(1e-6, Math.hypot(b[0] - a[0], b[1] - a[1]));
    const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    const at = (along, across) => [a[0] + along * ux - across * uy, a[1] + along * uy + across * ux];
    const coil = Math.min(Math.max(0.55 * rest, 15), 70, rest);
    const from = Math.min((rest - coil) / 2, 0.3 * length), to = length - from;
    const apart = kind === "both" ? 5 : 0;
    if (kind !== "damper") {
      const teeth = [[from, -apart]];
      for (let i = 0; i < 8; i++) teeth.push([from + (to - from) * (i + 0.5) / 8, (i % 2 ? -3.4 : 3.4) - apart]);
      teeth.push([to, -apart]);
      this.line(teeth.map(own => at(...own)), 1);
    }
    if (kind !== "spring") {
      const cup = from + 0.35 * coil, piston = to - (to - from) * 0.4;
      this.line([[from, apart], [cup, apart]].map(own => at(...own)), 1);
      this.line([[cup + 8, apart - 3.2], [cup, apart - 3.2], [cup, apart + 3.2], [cup + 8, apart + 3.2]].map(own => at(...own)), 1);
      this.line([[piston, apart - 2.2], [piston, apart + 2.2]].map(own => at(...own)), 1);
      this.line([[piston, apart], [to, apart]].map(own => at(...own)), 1);
    }
    if (apart) for (const x of [from, to]) this.line([at(x, -apart), at(x, apart)], 1);
    this.line([a, at(from, 0)], 1);
    this.line([at(to, 0), b], 1);
  }

  arrow(from, to, colour, width = 1.4) {
    const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const head = turn => [to[0] - 5 * Math.cos(angle + turn), to[1] - 5 * Math.sin(angle + turn)];
    this.line([from, to], width, colour);
    this.line([head(0.5), to, head(-0.5)], width, colour);
  }

  // The acceleration of the ground as an arrow below.
  shaking(t) {
    const [left, , right, bottom] = data.bounds;
    const middle = (left + right) / 2, y = bottom + 13;
    const size = ground.peak[1] ? valueAt(ground, t) / Math.abs(ground.peak[1]) : 0;
    this.line([[middle - 44, y], [middle + 44, y]], 0.5, "#c4ccd8");
    if (Math.abs(size) > 0.02) {
      this.c.globalAlpha = Math.min(1, 0.35 + Math.abs(size));
      this.arrow([middle, y], [middle + 44 * size, y], GROUND, 2.4);
      this.c.globalAlpha = 1;
    }
    this.word(ground.name === "ground" ? "acceleration of the ground" : `acceleration of ${ground.name}`, [middle, y + 11], "center", GROUND, 7);
  }

  // What a length on the page is as a displacement.
  ruler() {
    if (!(this.factor > 0)) return;
    const points = 90 / this.scale;
    const length = nice(points / this.factor);
    const [left, , , bottom] = data.bounds;
    const x = (8 - this.left) / this.scale, y = (this.height - 8 - this.top) / this.scale;
    const end = x + length * this.factor;
    this.line([[x, y - 3], [x, y], [end, y], [end, y - 3]], 1 / Math.max(1, this.scale / 1.5), GROUND);
    this.word(withUnit(words(length, 1), units.length), [end + 5 / this.scale, y + 1], "left", GROUND, 7);
  }
}
