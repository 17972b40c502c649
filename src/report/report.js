"use strict";
// Tables are drawn from the data beside them: sorted, filtered and a hundred rows at a time.
const ROWS = 100;
const WORD = /^([^<>=!]+?)(<=|>=|!=|=|<|>)(.+)$/;
const shown = value => value === null ? "" : String(value);

// "gamma>0.5 n=10 lumped": every word must hold; one without a sign may stand in any cell.
function filter(text, columns) {
  const tests = text.trim().split(/\s+/).filter(Boolean).map(word => {
    const found = WORD.exec(word);
    const place = found ? columns.findIndex(c => c.name === found[1]) : -1;
    if (place < 0) {
      const part = word.toLowerCase();
      return row => row.some(cell => shown(cell).toLowerCase().includes(part));
    }
    const [, , sign, wanted] = found;
    const number = Number(wanted);
    return row => {
      const cell = row[place];
      if (cell === null) return false;
      const a = typeof cell === "number" ? cell : cell.toLowerCase();
      const b = typeof cell === "number" ? number : wanted.toLowerCase();
      const near = typeof cell === "number" ? Math.abs(a - b) <= 1e-9 * Math.max(Math.abs(a), Math.abs(b)) : a === b;
      return { "=": near, "!=": !near, "<": a < b, ">": a > b, "<=": a < b || near, ">=": a > b || near }[sign];
    };
  });
  return row => tests.every(test => test(row));
}

function table(root) {
  const data = JSON.parse(root.querySelector("script").textContent);
  const constant = data.columns.map((_, i) => data.rows.length > 1 && data.rows.every(row => row[i] === data.rows[0][i]));
  const state = { by: -1, down: false, page: 0, text: "", all: false };
  const [search, all, back, next] = ["[type=search]", "[type=checkbox]", ".back", ".next"].map(s => root.querySelector(s));
  const [head, body, count] = ["thead tr", "tbody", "output"].map(s => root.querySelector(s));

  function draw() {
    const places = data.columns.map((_, i) => i).filter(i => state.all || !constant[i]);
    const rows = data.rows.filter(filter(state.text, data.columns));
    if (state.by >= 0) {
      const order = (a, b) => {
        const [x, y] = [a[state.by], b[state.by]];
        if (x === null || y === null) return (x === null) - (y === null);
        const sign = x < y ? -1 : x > y ? 1 : 0;
        return state.down ? -sign : sign;
      };
      rows.sort(order);
    }
    const pages = Math.max(1, Math.ceil(rows.length / ROWS));
    state.page = Math.min(state.page, pages - 1);
    head.replaceChildren(...places.map(i => {
      const cell = document.createElement("th");
      cell.scope = "col";
      cell.setAttribute("aria-sort", state.by === i ? (state.down ? "descending" : "ascending") : "none");
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = data.columns[i].name;
      button.title = `${data.columns[i].meaning} [${data.columns[i].unit}]`;
      button.addEventListener("click", () => {
        Object.assign(state, { by: i, down: state.by === i && !state.down });
        draw();
        head.querySelectorAll("button")[places.indexOf(i)].focus();
      });
      cell.append(button);
      return cell;
    }));
    const from = state.page * ROWS;
    body.replaceChildren(...rows.slice(from, from + ROWS).map(row => {
      const line = document.createElement("tr");
      for (const i of places) {
        const cell = line.insertCell();
        const value = row[i];
        cell.textContent = typeof value === "number" && !Number.isInteger(value) ? String(Number(value.toPrecision(6))) : shown(value);
        cell.title = shown(value);
      }
      return line;
    }));
    const last = Math.min(from + ROWS, rows.length);
    count.textContent = rows.length ? `${from + 1} to ${last} of ${rows.length} cases` : "no case";
    back.disabled = state.page === 0;
    next.disabled = state.page + 1 >= pages;
  }

  search.addEventListener("input", () => { Object.assign(state, { text: search.value, page: 0 }); draw(); });
  all.addEventListener("change", () => { state.all = all.checked; draw(); });
  back.addEventListener("click", () => { state.page -= 1; draw(); });
  next.addEventListener("click", () => { state.page += 1; draw(); });
  draw();
}

// The title of a point, shown at once, also to those who come by keyboard.
function tips() {
  const tip = document.createElement("div");
  tip.id = "tip";
  tip.hidden = true;
  document.body.append(tip);
  const show = event => {
    const point = event.target.closest?.(".hover circle");
    tip.hidden = !point;
    if (!point) return;
    tip.textContent = point.getAttribute("aria-label");
    const place = point.getBoundingClientRect();
    tip.style.left = `${Math.min(place.right + 8, innerWidth - 320)}px`;
    tip.style.top = `${place.bottom + 8}px`;
  };
  document.addEventListener("mouseover", show);
  document.addEventListener("focusin", show);
  // One stop of the tab key for a figure, the arrows from point to point.
  for (const group of document.querySelectorAll(".hover")) {
    const points = [...group.children];
    points.forEach((point, i) => point.setAttribute("tabindex", i ? -1 : 0));
    group.addEventListener("keydown", event => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      const to = points[points.indexOf(document.activeElement) + step];
      if (to) { event.preventDefault(); to.focus(); }
    });
  }
}

document.querySelectorAll(".results").forEach(table);
tips();
