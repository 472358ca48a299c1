// The cylinder table and the firing order, edited; the engine file that is saved from them.
// Angles and stations stay exact: [numerator, denominator] as whole numbers of any length.
const gcd = (a, b) => { while (b) [a, b] = [b, a%b]; return a < 0n ? -a : a; };
function ratio(n, d) {
  if (d < 0n) { n = -n; d = -d; }
  const by = gcd(n, d) || 1n;
  return [n/by, d/by];
}
const NUMBER = new RegExp("^([+-]?)(\\d+)(?:/(\\d+)|\\.(\\d+))?$");
function exact(text) {  // a decimal or a fraction, or null
  const m = NUMBER.exec(String(text).trim().replaceAll("−", "-"));
  if (!m || String(text).length > 40 || (m[3] && BigInt(m[3]) === 0n)) return null;
  const digits = m[4] ?? "", n = BigInt(m[2] + digits);
  return ratio(m[1] === "-" ? -n : n, m[3] ? BigInt(m[3]) : 10n**BigInt(digits.length));
}
const plus = (a, b, sign = 1n) => ratio(a[0]*b[1] + sign*b[0]*a[1], a[1]*b[1]);
const minus = (a, b) => plus(a, b, -1n);
const times = (a, b) => ratio(a[0]*b[0], a[1]*b[1]);
const modulo = (a, by) => { const m = BigInt(by)*a[1]; return ratio(((a[0]%m) + m)%m, a[1]); };
const real = (a) => Number(a[0])/Number(a[1]);
const halfTurn = (a) => { const x = modulo(a, 360); return real(x) > 180 ? minus(x, [360n, 1n]) : x; };
function written(a) {  // as people write it: a decimal where it is a short one, else a fraction
  const [n, d] = a;
  if (d === 1n) return String(n);
  if (1000000n%d) return `${n}/${d}`;
  const text = String((n < 0n ? -n : n)*(1000000n/d)).padStart(7, "0");
  return (n < 0n ? "-" : "") + text.slice(0, -6) + "." + text.slice(-6).replace(new RegExp("0+$"), "");
}
const inFile = (a) => { const text = written(a); return text.includes("/") ? `"${text}"` : text; };

// The file as it came: what stands before the cylinders, each cylinder's lines, what follows.
const KEYS = ["bank", "throw", "station", "fires"];
const lines = (text) => text.split("\n").filter((row) => row);
const keyOf = (row) => row.split(" = ")[0];
const valueOf = (row) => row.slice(row.indexOf(" = ") + 3).replaceAll('"', "");
const ROWS = E.file.rows.map((text) => {
  const all = Object.fromEntries(lines(text).map((row) => [keyOf(row), valueOf(row)]));
  const row = {number: Number(all.number), rest: lines(text).filter((r) => !["number", ...KEYS].includes(keyOf(r)))};
  for (const key of KEYS) row[key] = all[key] === undefined ? null : exact(all[key]);
  // How far its dead centre is shifted, which an edited pin or axis does not change.
  row.shift = row.fires && plus(minus(row.throw, row.bank), row.fires);
  return row;
});
let EDITED = null, TABLE = ROWS.map((row) => ({...row}));
const changedRow = (row, i) => KEYS.some((key) => row[key] && written(row[key]) !== written(ROWS[i][key]));
function take(table) {  // the table as the engine: what is computed from and what the address says
  TABLE = table;
  const changed = table.filter(changedRow);
  S.edit = changed.map((row) => [row.number, ...KEYS.map((key) => row[key] ? written(row[key]) : "")].join("_")).join("~");
  EDITED = changed.length ? Object.fromEntries(table.map((row) => [row.number, {
    bank: real(row.bank)*TURN/360, throw: real(row.throw)*TURN/360, station: real(row.station), fires: row.fires ? real(row.fires) : null,
  }])) : null;
  const bank = $("bank");
  if (bank) {  // two banks that are edited have no one angle
    bank.disabled = Boolean(EDITED);
    if (EDITED) S.bank = OWN.bank;
  }
}
// Of what the address says: rows that read as the table does, else nothing.
function recallEdit(text) {
  const table = ROWS.map((row) => ({...row}));
  for (const each of text.split("~")) {
    const [number, ...values] = each.split("_"), row = table.find((r) => r.number === Number(number));
    if (!row || values.length !== KEYS.length) return;
    for (const [i, key] of KEYS.entries()) {
      const x = values[i] === "" ? null : exact(values[i]);
      if (Boolean(x) !== Boolean(row[key]) || wrong(key, x)) return;
      row[key] = x;
    }
  }
  if (E.editable) take(table);
}
function wrong(key, x) {
  if (x === null) return "";
  if (x[1] > 100000n) return W.wrongFine;
  if (key === "fires" && (real(x) < 0 || real(x) >= CYCLE)) return W.wrongFires.replace("@", CYCLE);
  if (key === "station" && Math.abs(real(x)) > 1000) return W.wrongStation;
  return "";
}

// Firing order and intervals ----------------------------------------------------------------------
const zeroth = () => TABLE.reduce((a, b) => a.number < b.number ? a : b);
function firingOf(table) {
  const rows = [...table].sort((a, b) => real(a.fires) - real(b.fires) || a.number - b.number);
  const gaps = rows.map((row, i) => i + 1 < rows.length ? minus(rows[i + 1].fires, row.fires) : minus(plus(rows[0].fires, [BigInt(CYCLE), 1n]), row.fires));
  const words = gaps.map(written);
  return [rows.map((row) => row.number).join("-"), new Set(words).size === 1 ? words[0] : words.join(" ")];
}
function fromFiring(orderText, gapsText) {  // a table, or words on what is wrong
  const order = orderText.split(new RegExp("[-\\s,]+")).filter((x) => x).map(Number), numbers = TABLE.map((row) => row.number);
  if (order.length !== numbers.length || new Set(order).size !== order.length || order.some((n) => !numbers.includes(n))) {
    return W.wrongOrder.replace("@", [...numbers].sort((a, b) => a - b).join(", "));
  }
  const words = gapsText.split(new RegExp("[\\s,;]+")).filter((x) => x);
  if (words.length !== 1 && words.length !== order.length) return W.wrongCount.replace("@", order.length);
  const gaps = (words.length === 1 ? order.map(() => words[0]) : words).map(exact);
  const bad = gaps.findIndex((gap) => gap === null || real(gap) < 0);
  if (bad >= 0) return W.wrongInterval.replace("@", words[bad] ?? words[0]);
  const sum = gaps.reduce((a, b) => plus(a, b), [0n, 1n]);
  if (sum[1] !== 1n || sum[0] !== BigInt(CYCLE)) return W.wrongSum.replace("#", CYCLE).replace("@", written(sum));
  let at = [0n, 1n];
  const fires = new Map(order.map((n, i) => { const own = at; at = plus(at, gaps[i]); return [n, own]; }));
  const first = zeroth(), start = minus(first.fires, fires.get(first.number));
  return TABLE.map((row) => {
    const angle = modulo(plus(fires.get(row.number), start), CYCLE);
    return {...row, fires: angle, throw: halfTurn(minus(plus(row.bank, row.shift), angle))};
  });
}

// The file ---------------------------------------------------------------------------------------
function fileText() {
  const say_ = [], shift = S.bank === OWN.bank || S.bank === null ? null : times(minus(exact(S.bank), exact(E.bankText)), [1n, 2n]);
  const factor = S.lambda === OWN.lambda ? null : exact(String(S.lambda)), stroke = lines(E.file.head).find((row) => keyOf(row) === "stroke");
  const resized = (row) => {
    if (!factor || !["rod", "ratio"].includes(keyOf(row))) return row;
    if (keyOf(row) === "ratio") return `ratio = ${inFile(factor)}`;
    // Every rod by as much: of cylinders that share a stroke it is λ stroke/2.
    const rod = stroke ? times(times(factor, exact(valueOf(stroke))), [1n, 2n]) : null;
    return `rod = ${inFile(rod ?? exact(valueOf(row)))}`;
  };
  const changed = !isOwn();
  const head = lines(E.file.head).map((row) => keyOf(row) === "name" && changed ? `name = ${JSON.stringify([...E.name].slice(0, 51).join("") + " (edited)")}` : resized(row));
  const out = [];
  for (const row of head) out.push(...(row.startsWith("[") ? ["", row] : [row]));
  for (const row of TABLE) {
    const sign = shift && (E.cylinders.find((c) => c.number === row.number).bank > E.bankMiddle ? 1n : -1n), by = shift && [sign*shift[0], shift[1]];
    const bank = by ? plus(row.bank, by) : row.bank;
    const throw_ = by && S.reading === "firing" ? plus(row.throw, by) : row.throw;
    const fires = by && S.reading === "crank" && row.fires ? modulo(minus(plus(row.fires, by), firstShift(shift)), CYCLE) : row.fires;
    out.push("", "[[cylinder]]", `number = ${row.number}`);
    for (const [key, x] of [["throw", throw_], ["bank", bank], ["station", row.station], ["fires", fires]]) if (x) out.push(`${key} = ${inFile(x)}`);
    out.push(...row.rest.map(resized));
  }
  if (S.weights === 1) out.push("", ...E.file.tail.split("\n"));
  else if (S.weights !== 0) { out.push("", ...E.file.tail.split("\n")); say_.push(W.unsavedWeights); }
  if (S.share) {
    const known = E.hasWeights && S.weights !== 0;
    for (const c of E.cylinders) out.push("", "[[counterweight]]", `throw = ${c.number}`, known ? `share = ${Number((S.share*c.mass).toPrecision(12))}` : `overbalance = ${S.share}`);
  }
  if (S.ahead || S.back) say_.push(W.unsavedShafts);
  return [out.join("\n").trim().replace(new RegExp("\n{3,}", "g"), "\n\n") + "\n", say_.join(" ")];
}
// `fires` counts from cylinder 1's own dead centre, which moves with its bank.
function firstShift(shift) {
  const first = zeroth(), up = E.cylinders.find((c) => c.number === first.number).bank > E.bankMiddle;
  return up ? shift : [-shift[0], shift[1]];
}
function save() {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([fileText()[0]], {type: "application/toml"}));
  link.download = E.fileName;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// The form ---------------------------------------------------------------------------------------
const EDIT = {error: null, fields: new Map(), order: null, gaps: null};
function make(name, values = {}, ...children) {
  const node = Object.assign(document.createElement(name), values);
  node.append(...children);
  return node;
}
function field(label, value, onInput) {
  const input = make("input", {type: "text", value, spellcheck: false, autocomplete: "off"});
  input.setAttribute("aria-label", label);
  input.disabled = !E.editable;
  input.addEventListener("input", () => onInput(input));
  return input;
}
function refuse(input, words) {
  for (const each of $("edit").querySelectorAll("[aria-invalid]")) each.removeAttribute("aria-invalid");
  $("edit-error").textContent = words;
  $("save").disabled = Boolean(words);
  if (words) {
    input.setAttribute("aria-invalid", "true");
    input.setAttribute("aria-describedby", "edit-error");
  }
}
function editCell(row, key, input) {
  const x = exact(input.value), place = `${W.cylinder} ${row.number}, ${W[`col-${key}`]} = ${input.value.slice(0, 40)}: `;
  const words = x === null ? W.wrongNumber : wrong(key, x);
  if (words) { refuse(input, place + words); return; }
  refuse(input, "");
  const now = TABLE.find((r) => r.number === row.number), next = {...now, [key]: x};
  if (key === "fires") next.throw = halfTurn(minus(plus(now.bank, now.shift), x));
  else if ((key === "bank" || key === "throw") && now.fires) {
    // Of the angles at which its pin is there, that nearest to where it fired.
    const at = modulo(minus(plus(next.bank, now.shift), next.throw), 360), turns = Math.round((real(now.fires) - real(at))/360);
    next.fires = modulo(plus(at, [BigInt(360*turns), 1n]), CYCLE);
  }
  take(TABLE.map((r) => r.number === row.number ? next : r));
  redraw();
}
function editFiring(input) {
  const table = fromFiring(EDIT.order.value, EDIT.gaps.value);
  if (typeof table === "string") { refuse(input, table); return; }
  refuse(input, "");
  take(table);
  redraw();
}
function fillEditor() {
  for (const row of TABLE) {
    for (const key of KEYS) {
      const input = EDIT.fields.get(`${key} ${row.number}`);
      if (input && document.activeElement !== input && !input.hasAttribute("aria-invalid")) input.value = row[key] ? written(row[key]) : "";
    }
  }
  if (EDIT.order && document.activeElement !== EDIT.order && document.activeElement !== EDIT.gaps && !$("edit-error").textContent) {
    [EDIT.order.value, EDIT.gaps.value] = firingOf(TABLE);
  }
  const [text, words] = fileText();
  $("file").textContent = text;
  $("unsaved").textContent = words;
}
function buildEditor() {
  const box = $("edit");
  const body = make("div");
  if (ROWS.every((row) => row.fires)) {
    const [order, gaps] = firingOf(TABLE);
    EDIT.order = field(W.firingOrder, order, editFiring);
    EDIT.gaps = field(W.firingIntervals, gaps, editFiring);
    EDIT.order.id = "firing-order";
    EDIT.gaps.id = "firing-intervals";
    body.append(make("label", {}, W.firingOrder, EDIT.order), make("label", {}, W.firingIntervals, EDIT.gaps));
  }
  const head = make("tr", {}, ...["number", ...KEYS].map((key) => make("th", {scope: "col", textContent: W[`col-${key}`]})));
  const rows = ROWS.map((row) => make("tr", {}, make("th", {scope: "row", textContent: row.number}), ...KEYS.map((key) => {
    if (!row[key]) return make("td");
    const input = field(`${W.cylinder} ${row.number}, ${W["col-" + key]}`, written(row[key]), (each) => editCell(row, key, each));
    EDIT.fields.set(`${key} ${row.number}`, input);
    return make("td", {}, input);
  })));
  const scroll = make("div", {className: "wide", tabIndex: 0}, make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows)));
  scroll.setAttribute("role", "region");
  scroll.setAttribute("aria-label", W.cylinderTable);
  const error = make("p", {id: "edit-error"});
  error.setAttribute("role", "alert");
  const button = make("button", {type: "button", id: "save", textContent: W.save});
  button.addEventListener("click", save);
  const file = make("pre", {id: "file", tabIndex: 0});
  file.setAttribute("role", "region");
  file.setAttribute("aria-label", E.fileName);
  body.append(scroll, make("p", {className: "quiet", textContent: E.editable ? W.editHelp : W.notEditable}));
  body.prepend(error);
  body.append(button, make("p", {id: "unsaved", className: "quiet"}), file);
  box.append(body);
}
