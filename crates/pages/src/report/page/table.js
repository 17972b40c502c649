// Tables are drawn from the packed data after them: filtered, sorted and a hundred rows at a time. Where the page does not hold
// all cases it says so and neither filters nor sorts.
const ROWS = 100;

async function table(root) {
  const [head_text, numbers_of_all] = await Promise.all([...root.querySelectorAll("script")].map(unpack));
  const data = JSON.parse(new TextDecoder().decode(head_text));
  const all = columns(data, numbers_of_all);
  const state = { by: -1, down: false, page: 0, text: "", constant: false, refused: false };
  const [search, check, back, next] = ["[type=search]", "[type=checkbox]", ".back", ".next"].map(s => root.querySelector(s));
  const [head, body, count] = ["thead tr", "tbody", "output"].map(s => root.querySelector(s));
  let rows = [], fault = "";
  search.placeholder = example(all);

  // The rows that the filter chooses, in order.
  function choose() {
    [rows, fault] = [[], ""];
    try {
      const wanted = tests(state.text, all);
      if (data.limit && wanted.length) throw data.limit;
      for (let row = 0; row < data.rows; row++) if (wanted.every(test => test(row))) rows.push(row);
    } catch (said) {
      if (typeof said !== "string") throw said;
      fault = said;
    }
    if (state.by < 0) return;
    // Names by the alphabet, undefined values last, equal ones by case.
    const { at, names } = all[state.by];
    const alphabet = [...names].sort();
    const ranks = names.map(name => alphabet.indexOf(name));
    const key = names.length ? row => ranks[at(row)] : at;
    const sign = state.down ? -1 : 1;
    const order = (a, b) => sign * ((key(a) > key(b)) - (key(a) < key(b))) || a - b;
    const defined = rows.filter(row => !Number.isNaN(at(row))).sort(order);
    rows = [...defined, ...rows.filter(row => Number.isNaN(at(row)))];
  }

  function sort(i) {
    if (data.limit) state.refused = true;
    else Object.assign(state, { by: i, down: state.by === i && !state.down, page: 0 });
    choose();
    draw();
    [...head.cells].find(cell => cell.dataset.column === String(i))?.querySelector("button").focus();
  }

  function heading(i) {
    const cell = document.createElement("th");
    cell.scope = "col";
    cell.dataset.column = i;
    cell.setAttribute("aria-sort", state.by === i ? (state.down ? "descending" : "ascending") : "none");
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = all[i].name;
    button.title = `${all[i].meaning} [${all[i].unit}]`;
    button.addEventListener("click", () => sort(i));
    cell.append(button);
    return cell;
  }

  function line(row, places) {
    const line = document.createElement("tr");
    for (const i of places) {
      const cell = line.insertCell();
      const [text, value] = [all[i].shown(row), all[i].at(row)];
      const short = all[i].names.length || Number.isInteger(value) || !Number.isFinite(value);
      cell.textContent = short ? text : String(Number(value.toPrecision(6)));
      cell.title = text;
    }
    return line;
  }

  function draw() {
    const places = all.map((_, i) => i).filter(i => state.constant || data.cases < 2 || all[i].varies);
    const pages = Math.max(1, Math.ceil(rows.length / ROWS));
    state.page = Math.min(state.page, pages - 1);
    const from = state.page * ROWS;
    const last = Math.min(from + ROWS, rows.length);
    head.replaceChildren(...places.map(heading));
    body.replaceChildren(...rows.slice(from, last).map(row => line(row, places)));
    const of = data.limit ? `the first ${data.rows} of ${data.cases}` : String(rows.length);
    const range = rows.length ? `${from + 1} to ${last} of ${of} cases` : "no case";
    count.textContent = fault || (state.refused ? data.limit : range);
    count.className = fault || state.refused ? "fault" : "";
    search.setAttribute("aria-invalid", String(Boolean(fault)));
    back.disabled = state.page === 0;
    next.disabled = state.page + 1 >= pages;
  }

  search.addEventListener("input", () => {
    Object.assign(state, { text: search.value, page: 0, refused: false });
    choose();
    draw();
  });
  check.addEventListener("change", () => { state.constant = check.checked; draw(); });
  back.addEventListener("click", () => { state.page -= 1; draw(); });
  next.addEventListener("click", () => { state.page += 1; draw(); });
  choose();
  draw();
}
