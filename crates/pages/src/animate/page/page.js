// The page: controls, plots, and the time that they show.

const COLOURS = ["#0065a8", "#c9500a"];
// Height of a plot with times.
const FIRST_PLOT = 104;
const byId = id => document.getElementById(id);
const make = (name, parent, properties = {}) => parent.appendChild(Object.assign(document.createElement(name), properties));

byId("head").textContent = data.head;
let now = 0, magnify = 1, playing = false, speed = 1, drawnAt = 0, last = null;

// The films with their contacts.
const drawings = films.map(film => {
  const figure = make("figure", byId("films"));
  const caption = make("figcaption", figure);
  make("strong", caption, { textContent: film.label });
  const shown = film.contacts.length <= 12 ? film.contacts : shownContacts(film.contacts);
  for (const contact of shown) {
    contact.chip = make("span", caption, { className: "chip " + contact.kind });
  }
  const canvas = make("canvas", figure);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `Drawing of the structure in motion, ${film.label}`);
  return new Drawing(film, canvas);
});
const [left, top_, right, bottom] = data.bounds;
const isWide = (right - left) > 1.5 * (bottom - top_);
byId("films").classList.toggle("beside", films.length > 1 && !isWide);
byId("films").classList.toggle("two", films.length > 1);
document.querySelector("main").classList.toggle("narrow", films.length === 1 && !isWide);

// The contacts with the largest forces, in their own order.
function shownContacts(contacts) {
  const sizes = contacts.map(own => Math.abs(own.peak[1])).sort((a, b) => b - a);
  const least = sizes[Math.min(7, sizes.length - 1)];
  return contacts.filter(own => Math.abs(own.peak[1]) >= least).slice(0, 8);
}

// The plots, one for the ground and for each contact.
const plots = [];
const MARGIN = () => innerWidth < 720 ? 46 : 66;

function addPlot(title, unit, series) {
  const box = make("div", byId("plots"), { className: "plot" });
  const plot = { title, unit, series, hasTimes: false, box, canvas: make("canvas", box), cursor: make("div", box, { className: "cursor" }) };
  const seek = event => {
    const { left, width } = box.getBoundingClientRect();
    const margin = MARGIN();
    set(data.duration * (event.clientX - left - margin) / (width - margin - 8));
  };
  box.addEventListener("pointerdown", event => { box.setPointerCapture(event.pointerId); pause(); seek(event); });
  box.addEventListener("pointermove", event => { if (event.buttons) seek(event); });
  plots.push(plot);
}

// The ground is first: it is on the screen with the films.
if (ground) addPlot(`${ground.name}: acceleration`, units.acceleration, [{ ...ground, colour: "#5c6b80" }]);
const symbol = data.symbols.force;
const names = [];
for (const film of films) for (const own of shownContacts(film.contacts)) if (!names.includes(own.name)) names.push(own.name);
for (const name of names.slice(0, 8)) {
  const series = films.map((film, k) => ({ own: film.contacts.find(own => own.name === name), colour: COLOURS[k] })).filter(each => each.own);
  addPlot(`${name}: force ${symbol}`, units.force, series.map(({ own, colour }) => ({ ...own.force, peak: own.peak, spans: own.spans, kind: own.kind, colour })));
}
if (plots.length === 0) {
  films.forEach((film, k) => {
    const largest = film.moves.reduce((best, own) => Math.max(...own.map(Math.abs)) > Math.max(...best.map(Math.abs)) ? own : best, film.moves[0] ?? []);
    addPlot("largest displacement", units.length, [{ t: film.t, v: largest, colour: COLOURS[k] }]);
  });
}
for (const plot of [plots[0], plots[plots.length - 1]]) if (plot) plot.hasTimes = true;

function drawPlot(plot) {
  const width = plot.box.clientWidth, height = plot.hasTimes ? FIRST_PLOT : 78, foot = plot.hasTimes ? 26 : 2, head = 20;
  const ratio = Math.min(devicePixelRatio || 1, 3);
  plot.canvas.width = Math.round(width * ratio);
  plot.canvas.height = Math.round(height * ratio);
  plot.canvas.style.height = height + "px";
  const c = plot.canvas.getContext("2d");
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  const margin = MARGIN(), inner = width - margin - 8;
  let low = 0, high = 0;
  for (const own of plot.series) for (const v of own.v) { if (v < low) low = v; if (v > high) high = v; }
  if (low === high) high = low + 1;
  const x = t => margin + inner * t / data.duration;
  const y = v => head + (height - head - foot - 4) * (high - v) / (high - low);
  c.font = "11px system-ui, sans-serif";
  // Frame, zero, and times of touching or sliding.
  c.fillStyle = "#f7f9fb";
  c.fillRect(margin, head, inner, height - head - foot - 2);
  plot.series.forEach((own, k) => {
    if (!own.spans) return;
    c.fillStyle = plot.series.length > 1 ? own.colour + "55" : own.kind === "impact" ? "#f06a0038" : "#008f6a26";
    const [from, size] = plot.series.length > 1 ? [height - foot - 8 + 4 * k, 3] : [head, height - head - foot - 2];
    for (let i = 0; i + 1 < own.spans.length; i += 2) {
      c.fillRect(x(Math.max(0, own.spans[i])), from, Math.max(0.6, x(own.spans[i + 1]) - x(own.spans[i])), size);
    }
  });
  c.strokeStyle = "#c4ccd8";
  c.lineWidth = 1;
  c.beginPath();
  c.moveTo(margin, y(0));
  c.lineTo(margin + inner, y(0));
  c.stroke();
  c.fillStyle = "#5c6b80";
  c.textAlign = "right";
  c.textBaseline = "middle";
  for (const v of low < 0 && high > 0 ? [low, 0, high] : [low, high]) c.fillText(words(v, 2), margin - 6, Math.min(y(v), height - foot - 6));
  c.textAlign = "left";
  c.textBaseline = "alphabetic";
  c.save();
  c.beginPath();
  c.rect(margin, head - 2, inner + 2, height - head - foot + 2);
  c.clip();
  for (const own of plot.series) {
    c.beginPath();
    own.t.forEach((t, i) => i ? c.lineTo(x(t), y(own.v[i])) : c.moveTo(x(t), y(own.v[i])));
    c.strokeStyle = own.colour;
    c.lineWidth = 1.1;
    c.lineJoin = "round";
    c.stroke();
  }
  c.restore();
  // The title with the largest values.
  c.fillStyle = "#1d2736";
  c.font = "600 12px system-ui, sans-serif";
  const title = withUnit(plot.title + (plot.unit ? "," : ""), plot.unit);
  c.fillText(title, margin, 13);
  let place = margin + c.measureText(title).width + 14;
  c.font = "12px system-ui, sans-serif";
  for (const own of plot.series.filter(own => own.peak)) {
    c.fillStyle = own.colour;
    const text = own.peak[1] === 0 ? "no force" : `peak ${words(own.peak[1])} at ${withUnit(words(own.peak[0], 4), units.time)}`;
    if (place + c.measureText(text).width > width) break;
    c.fillText(text, place, 13);
    place += c.measureText(text).width + 14;
  }
  if (plot.hasTimes) {
    c.fillStyle = "#5c6b80";
    c.textAlign = "center";
    c.font = "11px system-ui, sans-serif";
    const step = nice(data.duration / Math.max(2, inner / 110));
    for (let t = 0; t <= data.duration * 1.0001; t += step) {
      c.fillRect(x(t), height - foot - 2, 1, 4);
      c.fillText(words(Math.round(t / step) * step, 3).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, ""), Math.min(x(t), width - 12), height - foot + 14);
    }
    c.textAlign = "right";
    c.fillText(withUnit(data.symbols.time + (units.time ? "," : ""), units.time), margin + inner, height - foot - 6);
  }
}

// Everything at the time `now`.
function draw() {
  for (const { film } of drawings) {
    for (const contact of film.contacts) {
      const force = valueAt(contact.force, now);
      const lit = isLit(contact, now, now);
      if (contact.chip) {
        contact.chip.classList.toggle("lit", lit || contact.glow > 0.5);
        const text = `${contact.name} ${withUnit(words(lit || contact.kind !== "impact" ? force : 0, 3), units.force)}`;
        if (contact.chip.textContent !== text) contact.chip.textContent = text;
      }
    }
  }
  for (const drawing of drawings) drawing.draw(now, magnify);
  for (const plot of plots) {
    const margin = MARGIN();
    plot.cursor.style.left = margin + (plot.box.clientWidth - margin - 8) * now / data.duration + "px";
  }
  const digits = data.duration < 0.1 ? 5 : data.duration < 1 ? 4 : data.duration < 100 ? 3 : 1;
  byId("time").textContent = withUnit(now.toFixed(digits), units.time);
  byId("scrub").value = now / data.duration;
  document.body.dataset.time = now;
}

// Contacts stay lit for a moment, or short touches would be between two pictures.
function glow(from, to, seconds) {
  for (const film of films) for (const contact of film.contacts) {
    const strong = contact.kind === "impact" ? Math.sqrt(Math.abs(strongest(contact, from, to) / (contact.peak[1] || 1))) : 1;
    const fresh = isLit(contact, from, to) ? Math.max(0.3, Math.min(1, strong)) : 0;
    contact.glow = Math.max(fresh, seconds === null ? 0 : contact.glow * Math.exp(-seconds / 0.16));
  }
}

// The largest force from one time to another.
function strongest({ force }, from, to) {
  let most = Math.abs(valueAt(force, to));
  for (let i = before(force.t, from); i < force.t.length && force.t[i] <= to; i++) {
    if (force.t[i] >= from) most = Math.max(most, Math.abs(force.v[i]));
  }
  return most;
}

function set(time) {
  now = Math.min(data.duration, Math.max(0, time || 0));
  glow(now, now, null);
  draw();
}

function pause() {
  playing = false;
  last = null;
  byId("sign").setAttribute("d", "M7 4v16l13-8z");
  byId("play").setAttribute("aria-label", "Play");
}

function play() {
  if (now >= data.duration) now = 0;
  playing = true;
  byId("sign").setAttribute("d", "M6 4h4v16H6zM14 4h4v16h-4z");
  byId("play").setAttribute("aria-label", "Pause");
  requestAnimationFrame(tick);
}

function tick(time) {
  if (!playing) return;
  // A page in the background does not jump.
  const seconds = last === null ? 0 : Math.min(0.1, (time - last) / 1000);
  last = time;
  const from = now;
  now = Math.min(data.duration, now + seconds * speed);
  glow(from, now, seconds);
  draw();
  if (now >= data.duration) pause(); else requestAnimationFrame(tick);
}

// Speeds around the one that shows all in about 20 s.
const isSeconds = units.time === "s";
const usual = isSeconds && data.duration >= 5 && data.duration <= 60 ? 1 : nice(data.duration / 15);
for (const times of [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5]) {
  const text = isSeconds ? `${words(times * usual, 1)} × real time` : `${withUnit(words(times * usual, 1), units.time)} per second`;
  make("option", byId("speed"), { textContent: text, value: times * usual, selected: times === 1 });
}
speed = usual;
byId("speed").addEventListener("change", event => { speed = Number(event.target.value); });
byId("play").addEventListener("click", () => playing ? pause() : play());
byId("scrub").addEventListener("input", event => { pause(); set(Number(event.target.value) * data.duration); });
byId("magnify").addEventListener("input", event => {
  magnify = 2 ** Number(event.target.value);
  // Displacements of their usual size are not magnified.
  const text = words(magnify, 2);
  byId("times").textContent = text === "1.0" ? "" : "× " + text;
  draw();
});

addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") return;
  const step = data.duration / (event.shiftKey ? 4000 : 200);
  const own = event.target.tagName === "INPUT" && event.key.startsWith("Arrow");
  if (event.key === " ") { if (event.target.id !== "play") playing ? pause() : play(); else return; }
  else if (own) return;
  else if (event.key === "ArrowRight") { pause(); set(now + step); }
  else if (event.key === "ArrowLeft") { pause(); set(now - step); }
  else if (event.key === "Home") { pause(); set(0); }
  else if (event.key === "End") { pause(); set(data.duration); }
  else return;
  event.preventDefault();
});

const kinds = new Set(films.flatMap(film => film.contacts.map(own => own.kind)));
const has = { impact: kinds.has("impact"), friction: kinds.has("friction"), bars: films.some(film => film.scene.bars.some(bar => bar.stresses.length)) };
const legend = byId("legend");
const mark = (colour, text) => { make("i", legend).style.background = colour; legend.append(text + " \u2002"); };
if (has.impact) mark("#f06a00", "touches");
if (has.friction) mark("#008f6a", "slides");
if (has.bars) { make("i", legend, { className: "shade" }); legend.append("bars: compression to tension, up to the largest of each bar. \u2002"); }
const gaps = films.some(film => film.scene.links.some(link => link.opening !== null)) ? [" and gaps", "; a gap with // is wider than drawn"] : ["", ""];
const from = ground && ground.name === "ground" ? ", as seen from the ground" : "";
legend.append(`The bar at the lower left is the scale of ${data.symbols.length}${gaps[0]}${from}${gaps[1]}.`);

if (films.some(film => film.scene.left_out.length)) legend.append(" Nodes that a reduction left out are drawn between the others.");

function layout() {
  for (const drawing of drawings) drawing.fit();
  for (const plot of plots) drawPlot(plot);
  draw();
}
addEventListener("resize", layout);
// A time in the address, as in #t=4.2, is where the page begins.
const begin = /[#&]t=([0-9.eE+-]+)/.exec(location.hash);
layout();
set(begin ? Number(begin[1]) : 0);
