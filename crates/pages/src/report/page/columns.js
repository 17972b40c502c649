// A column stands in the data as numbers and then, if the numbers are a list of the values that occur, the place of each row in this
// list (width 2 or 1; 0 where all rows have one value).
function doubles(view, from, length) {
  return Float64Array.from({ length }, (_, i) => view.getFloat64(from + 8 * i, true));
}

// Numbers of six digits: three bytes of digits with the sign in the highest bit, two of the power of ten; byte by byte.
function decimals(view, from, length) {
  const byte = (k, i) => view.getUint8(from + k * length + i);
  return Float64Array.from({ length }, (_, i) => {
    const digits = byte(0, i) | byte(1, i) << 8 | (byte(2, i) & 127) << 16;
    const power = (byte(3, i) | byte(4, i) << 8) << 16 >> 16;
    const size = power === 32767 ? (digits ? NaN : Infinity) : Number(`${digits}e${power}`);
    return byte(2, i) > 127 ? -size : size;
  });
}

// The numbers of a column by row, NaN where one is undefined, and the place after the column.
function numbers({ width, listed, rounded }, rows, view, from) {
  const length = width === 8 ? rows : listed;
  const values = (rounded ? decimals : doubles)(view, from, length);
  const codes = from + length * (rounded ? 5 : 8);
  const at = {
    8: row => values[row],
    0: () => values[0],
    1: row => values[view.getUint8(codes + row)],
    2: row => values[view.getUint16(codes + 2 * row, true)],
  }[width];
  return [at, codes + (width === 8 ? 0 : width * rows)];
}

// The columns of a table: `at` gives the number in a row, `shown` the text of a cell.
function columns(head, data) {
  const view = new DataView(data);
  let from = 0;
  const all = head.columns.map(column => {
    let at;
    [at, from] = numbers(column, head.rows, view, from);
    const shown = row => Number.isNaN(at(row)) ? "" : column.names[at(row)] ?? String(at(row));
    return { ...column, at, shown };
  });
  const number = { name: "case", unit: "1", meaning: "number of the case, from 0", names: [], varies: head.cases > 1 };
  return [{ ...number, at: row => row, shown: String }, ...all];
}
