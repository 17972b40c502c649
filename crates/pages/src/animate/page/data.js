// The data of the page: motions over time.

const data = JSON.parse(document.getElementById("data").textContent);
const units = data.units;

// Numbers from their differences, times a factor.
function sums(differences, factor) {
  const numbers = new Float64Array(differences.length);
  let sum = 0;
  for (let i = 0; i < differences.length; i++) {
    sum += differences[i];
    numbers[i] = sum * factor;
  }
  return numbers;
}

function curve(own, half) {
  return { t: sums(own.t, half), v: sums(own.v, own.unit) };
}

const films = data.films.map(own => ({
  label: own.label,
  scene: own.scene,
  t: sums(own.steps, own.half),
  moves: own.moves.map(list => sums(list, own.unit)),
  stresses: own.stresses.map(list => sums(list, 1 / own.shades)),
  contacts: own.contacts.map(contact => ({
    name: contact.name,
    kind: contact.kind,
    spans: sums(contact.spans, own.half),
    peak: [contact.peak[0] * own.half, contact.peak[1]],
    force: curve(contact.force, own.half),
    glow: 0,
  })),
}));

const ground = data.ground && { ...curve(data.ground.curve, data.ground.half), peak: data.ground.peak, name: data.ground.name };

// The last place with a time of at most t.
function before(times, t) {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle; else high = middle - 1;
  }
  return low;
}

// The value of a curve at a time; 0 after its end.
function valueAt(own, t) {
  const n = own.t.length;
  if (n === 0 || t < own.t[0] || t > own.t[n - 1]) return 0;
  const i = before(own.t, t);
  if (i + 1 >= n || own.t[i + 1] === own.t[i]) return own.v[i];
  const part = (t - own.t[i]) / (own.t[i + 1] - own.t[i]);
  return own.v[i] + part * (own.v[i + 1] - own.v[i]);
}

// Whether a contact touches or slides at some time from a to b.
function isLit(contact, a, b) {
  const spans = contact.spans;
  // Places of the ends: even ones are beginnings.
  let low = 0, high = spans.length / 2;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (spans[2 * middle + 1] < a) low = middle + 1; else high = middle;
  }
  return 2 * low < spans.length && spans[2 * low] <= b;
}

// Displacements and axial forces of a film at a time.
function stateAt(film, t) {
  const i = before(film.t, t);
  const next = Math.min(i + 1, film.t.length - 1);
  const length = film.t[next] - film.t[i];
  const part = length > 0 ? Math.min(1, Math.max(0, (t - film.t[i]) / length)) : 0;
  const at = list => list[i] + part * (list[next] - list[i]);
  return { moves: film.moves.map(at), stresses: film.stresses.map(at) };
}

// A number with few digits, such as 12 300 or 0.0042.
function words(x, digits = 3) {
  if (!isFinite(x) || x === 0) return "0";
  if (digits < 4) x = Number(x.toPrecision(digits));
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-4) return x.toExponential(digits - 1).replace("e+", "e").replace("-", "−");
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  const text = x.toFixed(Math.min(decimals, 8)).replace("-", "−");
  const [whole, rest] = text.split(".");
  const spaced = whole.replace(/\B(?=(\d{3})+(?!\d))/g, "\u202f");
  return rest === undefined ? spaced : spaced + "." + rest;
}

function withUnit(text, unit) {
  return unit ? text + "\u00a0" + unit : text;
}

// 1, 2 or 5 times a power of ten, at most x.
function nice(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [5, 2, 1].map(k => k * power).find(k => k <= x * 1.0000001) ?? power;
}
