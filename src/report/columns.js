// A column stands in the page as base64 of little-endian numbers: doubles (width 8), or places in a list of the values
// that occur (width 2 or 1; 0 where all rows have one value). A block of rows is decoded when one of them is wanted.
const BLOCK = 6144;

function bytes(base64) {
  const text = atob(base64);
  const view = new DataView(new ArrayBuffer(text.length));
  for (let i = 0; i < text.length; i++) view.setUint8(i, text.charCodeAt(i));
  return view;
}

function doubles(base64) {
  const view = bytes(base64);
  return Float64Array.from({ length: view.byteLength / 8 }, (_, i) => view.getFloat64(8 * i, true));
}

// The numbers of a column by row; NaN where one is undefined.
function numbers({ width, list }, element) {
  const values = doubles(list);
  if (width === 0) return () => values[0];
  const place = { 1: (view, i) => view.getUint8(i), 2: (view, i) => view.getUint16(2 * i, true) }[width];
  const blocks = [];
  let text = null;
  const block = k => {
    text ??= element.textContent;
    const length = BLOCK * width / 3 * 4;
    const part = text.slice(k * length, (k + 1) * length);
    if (width === 8) return doubles(part);
    const view = bytes(part);
    return Float64Array.from({ length: view.byteLength / width }, (_, i) => values[place(view, i)]);
  };
  return row => (blocks[Math.floor(row / BLOCK)] ??= block(Math.floor(row / BLOCK)))[row % BLOCK];
}

// The columns of a table: `at` gives the number in a row, `shown` the text of a cell.
function columns(head, elements) {
  const all = head.columns.map((column, i) => {
    const at = numbers(column, elements[i]);
    const shown = row => Number.isNaN(at(row)) ? "" : column.names[at(row)] ?? String(at(row));
    return { ...column, at, shown };
  });
  const number = { name: "case", unit: "1", meaning: "number of the case, from 0", names: [], varies: head.cases > 1 };
  return [{ ...number, at: row => row, shown: String }, ...all];
}
