// "gamma>0.5 n=10 lumped": every word must hold. A word that is not understood is a fault, never "no case".
const SIGN = /\s*(<=|>=|!=|==|=|<|>)\s*/g;
const COMPARISON = /^([^<>=!]+)(<=|>=|!=|==|=|<|>)([^<>=!]+)$/;
// As numbers match in the `where` of a study.
const near = (a, b) => Math.abs(a - b) <= 1e-12 * Math.max(Math.abs(a), Math.abs(b));
const SIGNS = {
  "=": (a, b) => a === b || near(a, b),
  "==": (a, b) => a === b || near(a, b),
  "!=": (a, b) => a !== b && !near(a, b),
  "<": (a, b) => a < b,
  ">": (a, b) => a > b,
  "<=": (a, b) => a <= b || near(a, b),
  ">=": (a, b) => a >= b || near(a, b),
};

// The tests that a text asks for, each true or false of a row; throws what is wrong with it.
function tests(text, all) {
  const words = text.replace(SIGN, "$1").split(/\s+/).filter(Boolean);
  return words.map(word => /[<>=!]/.test(word) ? comparison(word, all) : name(word, all));
}

function comparison(word, all) {
  const found = COMPARISON.exec(word);
  if (!found) throw `“${word}” is not a comparison: write column, sign, value, as in ${example(all)}`;
  const [, called, sign, wanted] = found;
  const column = all.find(c => c.name === called);
  if (!column) throw `No column is called “${called}”. The columns are ${all.map(c => c.name).join(", ")}`;
  const equal = sign === "=" || sign === "==";
  if (wanted === "undefined" && (equal || sign === "!=")) return row => Number.isNaN(column.at(row)) === equal;
  let value = Number(wanted);
  if (column.names.length) {
    if (!equal && sign !== "!=") throw `${column.name} has names for values: compare it by = or !=`;
    value = column.names.findIndex(known => known.toLowerCase() === wanted.toLowerCase());
    if (value < 0) throw `${column.name} is never “${wanted}”. Its values are ${column.names.join(", ")}`;
  }
  if (Number.isNaN(value)) throw `“${wanted}” is not a number, but ${column.name} has numbers as values`;
  const holds = SIGNS[sign];
  // An undefined value is neither equal, nor different, nor less, nor greater.
  return row => {
    const x = column.at(row);
    return !Number.isNaN(x) && holds(x, value);
  };
}

// A word by itself is a name, or a part of one, in any column of names.
function name(word, all) {
  const part = word.toLowerCase();
  const places = all.map(column => [column, column.names.map(known => known.toLowerCase().includes(part))]);
  const having = places.filter(([, found]) => found.includes(true));
  if (!having.length) {
    const known = all.some(c => c.name === word);
    throw known
      ? `${word} is a column: compare it with a value, as in ${example(all)}`
      : `“${word}” is neither a name in this table nor a comparison. The columns are ${all.map(c => c.name).join(", ")}`;
  }
  return row => having.some(([column, found]) => found[column.at(row)]);
}

// A comparison that this table understands.
function example(all) {
  const column = all.find(c => c.varies && !c.names.length && c.name !== "case") ?? all[0];
  return `${column.name}>0.1`;
}
