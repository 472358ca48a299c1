// What moves on the page of an engine. `evaluate` and OUTPUTS above are the library's emitted functions;
// everything here is drawn from the numbers in the element #engine. Lengths count in crank radii of
// cylinder 1, forces in m r omega^2, points are [up, right], angles turn clockwise from straight up.
const E = JSON.parse(document.getElementById("engine").textContent);
const $ = (id) => document.getElementById(id);
const SVG = "http://www.w3.org/2000/svg", TURN = 2*Math.PI, N = 360;
const W = E.words;
const mul = (a, b) => [a[0]*b[0] - a[1]*b[1], a[0]*b[1] + a[1]*b[0]];
const unit = (t) => [Math.cos(t), Math.sin(t)];
const byNumber = Object.fromEntries(E.cylinders.map((c) => [c.number, c]));
const OWN = {theta: 0, lambda: E.lambda, bank: E.bankBetween, reading: "crank", share: 0, weights: 1, rpm: E.rpm, order: E.order};
const S = {...OWN};
let running = false, last = null;
const isOwn = () => S.lambda === OWN.lambda && S.bank === OWN.bank && S.share === 0 && S.weights === 1;

// Kinematics -------------------------------------------------------------------------------------
// A cylinder at theta: its pins as points, and its piston's height with two derivatives by theta.
function moved(c) {  // the cylinder with the sliders' bank angle and rod ratio
  if (S.bank === OWN.bank && S.lambda === OWN.lambda) return c;
  const shift = (S.bank - OWN.bank)*TURN/720*Math.sign(c.bank - E.bankMiddle);
  // "firing" turns each pin with its axis, so that the firing angles stay; "crank" leaves the crank.
  const throw_ = S.reading === "firing" ? c.throw + shift : c.throw;
  return {...c, bank: c.bank + shift, throw: throw_, length: c.length*S.lambda/OWN.lambda};
}

function slide(c, w) {  // w: the rod's pin with two derivatives, in the axis' frame, over the own radius
  const s = (w[0][1] - c.offset)/c.length, k = Math.sqrt((1 - s)*(1 + s));
  const f1 = w[1][1]/(c.length*k), f2 = (w[2][1]/c.length + s*f1*f1)/k;
  return {
    phi: Math.asin(s), f1, f2, y: w[0][0] + c.length*k, y1: w[1][0] - c.length*s*f1,
    y2: w[2][0] - c.length*(s*f2 + k*f1*f1),
  };
}

function circle(p) {
  const w = unit(p);
  return [w, [-w[1], w[0]], [-w[0], -w[1]]];
}

function motion(cylinder, theta) {
  const c = moved(cylinder);
  const p = theta + c.throw - c.bank, w = circle(p);
  if (c.link) {
    const m = moved(byNumber[c.link.master]);
    const over = slide(m, circle(theta + m.throw - m.bank));
    const a = mul(unit(c.link.direction - over.phi), [c.link.radius, 0]);
    const ia = [-a[1], a[0]], f1 = over.f1, f2 = over.f2;  // a e^(-i phi), differentiated
    w[0] = [w[0][0] + a[0], w[0][1] + a[1]];
    w[1] = [w[1][0] - ia[0]*f1, w[1][1] - ia[1]*f1];
    w[2] = [w[2][0] - a[0]*f1*f1 - ia[0]*f2, w[2][1] - a[1]*f1*f1 - ia[1]*f2];
  }
  const x = slide(c, w), axis = unit(c.bank), r = c.radius;
  const place = (point) => mul([r*point[0], r*point[1]], axis);
  return {
    c, axis, y: x.y, y1: x.y1, y2: x.y2, pin: place(unit(p)), rod: place(w[0]), piston: place([x.y, c.offset]),
  };
}

// Force and couple [up, right, up, right] and torque, by differentiated geometry.
function numeric(theta) {
  const z = [0, 0, 0, 0, 0];
  for (const c of E.cylinders) {
    const m = motion(c, theta), f = -m.y2*c.mass;
    z[0] += f*m.axis[0]; z[1] += f*m.axis[1];
    z[2] += f*m.axis[0]*c.arm; z[3] += f*m.axis[1]*c.arm;
    z[4] += -m.y1*m.y2*c.mass*c.radius;
  }
  for (const t of E.turning) {  // c e^(i n theta) of weights and shafts
    const by = t.weight ? S.weights : 1, v = mul([by*t.value[0], by*t.value[1]], unit(t.order*theta)), i = t.of === "force" ? 0 : 2;
    z[i] += v[0]; z[i + 1] += v[1];
  }
  if (S.share) {  // counterweights opposite each pin, a share of the cylinder's own mass
    for (const c of E.cylinders) {
      const v = mul([-S.share*c.mass, 0], unit(theta + moved(c).throw));
      z[0] += v[0]; z[1] += v[1]; z[2] += v[0]*c.arm; z[3] += v[1]*c.arm;
    }
  }
  return z;
}

const NAMES = ["force.vertical", "force.lateral", "couple.vertical", "couple.lateral", "torque.inertia"];
function emitted(theta) {
  const values = evaluate(theta);
  return NAMES.map((name) => OUTPUTS.length === 1 ? values : values[name] ?? 0);
}
const value = (theta) => isOwn() ? emitted(theta) : numeric(theta);

// At the file's own values both ways have to agree, at 64 angles.
function check() {
  let most = 0, largest = 1e-300;
  for (let k = 0; k < 64; k++) {
    const a = emitted(TURN*k/64), b = numeric(TURN*k/64);
    for (let i = 0; i < (E.comparesTorque ? 5 : 4); i++) {
      most = Math.max(most, Math.abs(a[i] - b[i]));
      largest = Math.max(largest, Math.abs(a[i]));
    }
  }
  const off = most/Math.max(1, largest), good = off < 1e-9;
  $("check").className = good ? "" : "bad";
  $("check").textContent = (good ? W.checked : W.differs).replace("@", off.toExponential(1));
  return good;
}

// Units and figures ------------------------------------------------------------------------------
function scaleOf(i) {  // what 1 of an output is, and its unit
  if (!S.rpm || !E.sizes) return [1, ["m r ω²", "m r ω²", "m r ω² a", "m r ω² a", "m r² ω²"][i]];
  const force = E.sizes.mass*E.sizes.radius*(S.rpm*TURN/60)**2;
  if (i === 4) return [force*E.sizes.radius, "N m"];
  if (i < 2) return [force, "N"];
  return E.sizes.pitch ? [force*E.sizes.pitch, "N m"] : [1, "m r ω² a"];
}
function figure(x) {
  if (Math.abs(x) < 1e-12) x = 0;
  return String(Number(x.toPrecision(4))).replace("-", "−").replace("e−", "e−");
}
const set = (node, values) => { for (const [k, v] of Object.entries(values)) node.setAttribute(k, v); return node; };
function add(parent, name, values, text) {
  const node = set(document.createElementNS(SVG, name), values);
  if (text !== undefined) node.textContent = text;
  parent.appendChild(node);
  return node;
}
// A drawing begun anew: empty, of this box.
function cleared(svg, x, y, width, height) {
  svg.querySelectorAll("g,line,polyline,polygon,path,circle,text,rect").forEach((node) => node.remove());
  set(svg, {viewBox: `${x} ${y} ${width} ${height}`, width, height});
  return add(svg, "g", {});
}
const xy = (point, scale) => `${(point[1]*scale).toFixed(3)},${(-point[0]*scale).toFixed(3)}`;
const part = (id, name) => document.querySelector(`#${id} [data-part="${name}"]`);
const degrees = (point) => Math.atan2(point[1], point[0])*360/TURN;
function put(node, point, turned, more = "") {
  node?.setAttribute("transform", `translate(${point[1].toFixed(6)} ${(-point[0]).toFixed(6)}) rotate(${turned.toFixed(6)})${more}`);
}

// Views ------------------------------------------------------------------------------------------
function showSection(theta) {
  const k = E.scales.section;
  for (const own of E.cylinders) {
    const m = motion(own, theta), c = m.c, rod = [m.piston[0] - m.rod[0], m.piston[1] - m.rod[1]];
    put(part("section", `piston-${c.number}`), m.piston.map((v) => k*v), c.bank*360/TURN);
    const long = c.length/own.length;
    put(part("section", `rod-${c.number}`), m.rod.map((v) => k*v), degrees(rod), long === 1 ? "" : ` scale(1 ${long})`);
    put(part("section", `master-${c.number}`), m.pin.map((v) => k*v), degrees(rod));
    part("section", `axis-${c.number}`)?.setAttribute("transform", `translate(0 0) rotate(${c.bank*360/TURN}) translate(0 ${-k*c.radius*(c.length - own.length)})`);
    const label = part("section", `numbers-${c.number}`);
    if (label) {
      label.dataset.out ??= label.getAttribute("transform").match(/-?[\d.]+/g).slice(0, 2).join(" ");
      const [x, y] = label.dataset.out.split(" ").map(Number), at = mul([-y, x], unit(c.bank - own.bank));
      const more = k*c.radius*(c.length - own.length);
      put(label, [at[0] + more*m.axis[0], at[1] + more*m.axis[1]], 0);
    }
  }
  for (const throw_ of E.throws) {  // pins move where the bank angle is read as even firing
    const c = moved(byNumber[throw_.cylinder]);
    part("section", `throw-${throw_.cylinder}`)?.setAttribute("transform", `rotate(${(c.throw - throw_.angle)*360/TURN})`);
  }
  part("section", "crank")?.setAttribute("transform", `translate(0 0) rotate(${theta*360/TURN})`);
}

function showPlan(theta) {
  const k = E.scales.plan;
  if (!k) return;
  for (const own of E.cylinders) {
    const m = motion(own, theta), node = part("plan", `piston-${own.number}`);
    if (!node) continue;
    node.dataset.x ??= node.getAttribute("transform").match(/-?[\d.]+/)[0];
    node.setAttribute("transform", `translate(${node.dataset.x} ${-k*m.piston[1]}) rotate(0)`);
    const rod = part("plan", `rod-${own.number}`)?.firstChild;
    if (rod) set(rod, {y1: -k*m.rod[1], y2: -k*m.piston[1]});
  }
  const line = part("plan", "crank")?.firstChild;
  if (line) {
    line.dataset.xs ??= line.getAttribute("points").split(" ").map((p) => p.split(",")[0]).join(" ");
    const sides = [0];
    for (const t of E.plan) {
      const side = -k*motion(byNumber[t], theta).pin[1];
      sides.push(0, side, side, 0);
    }
    sides.push(0);
    line.setAttribute("points", line.dataset.xs.split(" ").map((x, i) => `${x},${sides[i].toFixed(3)}`).join(" "));
  }
}

const view = {turn: -0.75, tilt: 0.38};
function showOblique(theta) {
  const svg = document.querySelector("#oblique svg");
  if (!svg || !E.drawsOblique) return;
  const ct = Math.cos(view.turn), st = Math.sin(view.turn), cl = Math.cos(view.tilt), sl = Math.sin(view.tilt);
  // x right, y up, z towards the front: turned about the vertical, then tilted.
  const eye = (up, right, front) => {
    const x = right*ct + front*st, z = front*ct - right*st;
    return [x, up*cl - z*sl, z*cl + up*sl];
  };
  const k = E.scales.oblique, pitch = E.pitch, things = [];
  const points = (list) => list.map((p) => `${(k*p[0]).toFixed(1)},${(-k*p[1]).toFixed(1)}`).join(" ");
  const rows = [...new Set(E.cylinders.map((c) => c.arm))].sort((a, b) => a - b), half = 0.22;
  let before = rows[0] - 0.7;
  const line = (list, look) => things.push({depth: list.reduce((d, p) => d + p[2], 0)/list.length - 1e-3, points: points(list), look, open: true});
  for (const row of rows) {
    line([eye(0, 0, pitch*before), eye(0, 0, pitch*(row - half))], "crank");
    const pins = new Map();
    for (const c of E.cylinders) {
      if (c.arm !== row) continue;
      const m = motion(c, theta), f = pitch*row;
      pins.set(m.pin.map((v) => v.toFixed(6)).join(), m.pin);
      line([eye(...m.rod, f), eye(...m.piston, f)], "rod");
      const side = mul(m.axis, [0, 0.475*E.bore]), rings = [-0.3, 0.34].map((h) => Array.from({length: 20}, (_, i) => {
        const t = TURN*i/20, a = Math.cos(t), at = [m.piston[0] + h*E.bore*m.axis[0] + a*side[0], m.piston[1] + h*E.bore*m.axis[1] + a*side[1]];
        return eye(...at, f + 0.475*E.bore*Math.sin(t));
      }));
      const middle = eye(...m.piston, f), up = eye(...m.axis, 0);
      things.push({depth: middle[2], points: points(hull([...rings[0], ...rings[1]])), look: "piston", label: c.number, at: middle, crown: points(rings[up[2] >= 0 ? 1 : 0])});
    }
    for (const pin of pins.values()) {
      line([[0, 0], pin, pin, [0, 0]].map((p, i) => eye(...p, pitch*(row + (i < 2 ? -half : half)))), "crank");
    }
    before = row + half;
  }
  line([eye(0, 0, pitch*before), eye(0, 0, pitch*(rows[rows.length - 1] + 0.7))], "crank");
  things.sort((a, b) => a.depth - b.depth);
  const g = cleared(svg, -210, -210, 420, 420);
  for (const t of things) {
    add(g, t.open ? "polyline" : "polygon", {class: t.look, points: t.points});
    if (t.crown) add(g, "polygon", {class: "piston", points: t.crown});
    if (t.label) add(g, "text", {class: "ink", x: k*t.at[0], y: -k*t.at[1] + 4, "text-anchor": "middle"}, t.label);
  }
}
function hull(points) {
  const sorted = points.slice().sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const chain = (list) => {
    const line = [];
    for (const p of list) {
      while (line.length > 1) {
        const [a, b] = line.slice(-2);
        if ((b[0] - a[0])*(p[1] - a[1]) - (b[1] - a[1])*(p[0] - a[0]) > 0) break;
        line.pop();
      }
      line.push(p);
    }
    return line.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}

// Charts: redrawn when a slider moves; at each frame only their marks move.
let curves = null;
function compute() {
  curves = Array.from({length: N + 1}, (_, k) => value(TURN*k/N));
}
function steps(low, high, most = 6) {
  const power = 10**Math.floor(Math.log10((high - low)/most));
  const step = [1, 2, 5, 10, 20].map((m) => m*power).find((s) => (high - low)/s <= most);
  const list = [];
  for (let k = Math.ceil(low/step - 1e-9); k*step <= high + 1e-9*step; k++) list.push(k*step);
  return list;
}
function chart(id, outputs, names, looks) {
  const svg = document.querySelector(`#${id} svg`);
  if (!svg) return;
  const width = 400, height = 230, [factor, unitName] = scaleOf(outputs[0]);
  const rows = outputs.map((i) => curves.map((v) => v[i]*factor));
  let low = Math.min(0, ...rows.flat()), high = Math.max(0, ...rows.flat());
  if (high - low < 1e-9*factor) { low = -factor; high = factor; }
  const margin = 0.06*(high - low);
  low -= margin; high += margin;
  const y = (v) => -(v - low)*height/(high - low), x = (k) => k*width/N;
  const g = cleared(svg, -58, -height - 32, width + 76, height + 74);
  for (const v of steps(low, high)) {
    add(g, "line", {class: Math.abs(v) < 1e-9*(high - low) ? "ink" : "faint", x1: 0, x2: width, y1: y(v), y2: y(v)});
    add(g, "text", {class: "ink", x: -8, y: y(v) + 4, "text-anchor": "end", "font-size": 12}, figure(v));
  }
  for (const t of [0, 90, 180, 270, 360]) add(g, "text", {class: "ink", x: x(t), y: 18, "text-anchor": "middle", "font-size": 12}, `${t}°`);
  add(g, "text", {class: "ink", x: width/2, y: 36, "text-anchor": "middle", "font-size": 12}, W.angle);
  add(g, "text", {class: "ink", x: -8, y: -height - 10, "text-anchor": "end", "font-size": 12}, unitName);
  let at = 0;
  rows.forEach((row, j) => {
    add(g, "polyline", {class: looks[j], points: row.map((v, k) => `${x(k).toFixed(1)},${y(v).toFixed(2)}`).join(" ")});
    add(g, "line", {class: looks[j], x1: at, x2: at + 26, y1: -height - 14, y2: -height - 14});
    add(g, "text", {class: "ink", x: at + 32, y: -height - 10, "font-size": 12}, names[j]);
    at += 44 + (document.documentElement.lang === "ja" ? 13 : 7.2)*names[j].length;
  });
  const marks = rows.map((_, j) => add(g, "circle", {class: `${looks[j]} opaque`, r: 4}));
  const cursor = add(g, "line", {class: "axis", y1: 0, y2: -height});
  CHARTS[id] = (theta) => {
    const k = ((theta/TURN*N)%N + N)%N, now = value(theta);
    set(cursor, {x1: x(k), x2: x(k)});
    marks.forEach((mark, j) => set(mark, {cx: x(k), cy: y(now[outputs[j]]*factor)}));
  };
}
const CHARTS = {};
function pathChart(id, i, look) {
  const svg = document.querySelector(`#${id} svg`);
  if (!svg) return;
  const [factor, unitName] = scaleOf(i), points = curves.map((v) => [v[i]*factor, v[i + 1]*factor]);
  let size = Math.max(...points.map((p) => Math.hypot(...p)));
  if (size < 1e-9*factor) size = factor;
  const half = 170, k = half/size;
  const g = cleared(svg, -250, -212, 460, 442);
  for (const v of steps(-size, size, 5)) {
    add(g, "line", {class: "faint", x1: v*k, x2: v*k, y1: -184, y2: 184});
    add(g, "line", {class: "faint", x1: -184, x2: 184, y1: v*k, y2: v*k});
    add(g, "text", {class: "ink", x: v*k, y: 202, "text-anchor": "middle", "font-size": 14}, figure(v));
    add(g, "text", {class: "ink", x: -190, y: -v*k + 5, "text-anchor": "end", "font-size": 14}, figure(v));
  }
  add(g, "text", {class: "ink", x: 0, y: -194, "text-anchor": "middle", "font-size": 14}, `${W.vertical}, ${unitName}`);
  add(g, "text", {class: "ink", x: 0, y: 222, "text-anchor": "middle", "font-size": 14}, `${W.lateral}, ${unitName}`);
  add(g, "polygon", {class: look, points: points.map((p) => xy(p, k)).join(" ")});
  const arrow = add(g, "line", {class: look, x1: 0, y1: 0}), tip = add(g, "circle", {class: `${look} opaque`, r: 4});
  CHARTS[id] = (theta) => {
    const now = value(theta), up = now[i]*factor*k, right = now[i + 1]*factor*k;
    set(arrow, {x2: right, y2: -up});
    set(tip, {cx: right, cy: -up});
  };
}

// The crank star of the order, one for each direction of an axis: it follows the order and the bank angle.
function star() {
  const svg = document.querySelector("#star svg");
  if (!svg) return;
  const {banks, arrows, closed} = E.stars, n = S.order, R = 78, cell = 250;
  const across = banks.length === 4 ? 2 : Math.min(banks.length, 3), deep = Math.ceil(banks.length/across);
  const g = cleared(svg, -cell*across/2, -cell/2, cell*across, cell*deep);
  const said = [];
  arrows.forEach((list, j) => {
    const x = cell*(j%across - (across - 1)/2), y = cell*Math.floor(j/across);
    const shift = (S.bank - OWN.bank)/720*Math.sign(banks[j] - E.bankMiddle) || 0, axis = banks[j]*360/TURN + 360*shift;
    const h = add(g, "g", {transform: `translate(${x} ${y})`}), ends = new Map();
    let sum = [0, 0];
    for (const [number, own] of list) {
      // "firing" turns pin and axis alike, which an arrow does not see.
      const turns = ((n*(own - (S.reading === "firing" ? 0 : shift)))%1 + 1)%1, v = unit(TURN*turns), key = (Math.round(turns*1e6)%1e6).toString();
      sum = [sum[0] + v[0], sum[1] + v[1]];
      ends.set(key, {v, numbers: [...(ends.get(key)?.numbers ?? []), number]});
    }
    add(h, "circle", {class: "faint", r: R});
    const arrow = (v, look) => {
      const tip = [v[1]*R, -v[0]*R], size = Math.hypot(...tip), u = [tip[0]/size, tip[1]/size], head = Math.min(9, size/2), base = [tip[0] - head*u[0], tip[1] - head*u[1]];
      add(h, "line", {class: look, x1: 0, y1: 0, x2: base[0], y2: base[1]});
      add(h, "polygon", {class: `head ${look}`, points: [tip, [base[0] - 0.38*head*u[1], base[1] + 0.38*head*u[0]], [base[0] + 0.38*head*u[1], base[1] - 0.38*head*u[0]]].map((p) => p.map((c) => c.toFixed(3)).join()).join(" ")});
    };
    for (const {v, numbers} of ends.values()) {
      arrow(v, "ink");
      const text = numbers.length > 5 ? `${numbers[0]} ${numbers[1]} … ${numbers[numbers.length - 1]}` : numbers.join(" "), away = R + 12 + 3*(text.length - 1)*Math.abs(v[1]);
      add(h, "text", {class: "ink", x: away*v[1], y: -away*v[0] + 4, "text-anchor": "middle"}, text);
    }
    const size = Math.hypot(...sum), own = S.bank === OWN.bank, zero = own ? closed[n][j] : size < 1e-9*list.length;
    if (!zero) arrow([sum[0]/list.length, sum[1]/list.length], "force");
    const turned = figure(Number((((degrees(sum)%360) + 360)%360).toFixed(4))%360);
    const words = zero ? (own ? W.starCloses : W.starRounding) : W.starLeaves.replace("#", figure(size)).replace("@", turned);
    add(h, "text", {class: "ink", y: cell/2 - 12, "text-anchor": "middle", "font-weight": "bold", "data-verdict": j}, words);
    const name = W.starAxis.replace("@", figure(Number(axis.toFixed(3))));
    if (banks.length > 1) add(h, "text", {class: "ink", y: 14 - cell/2, "text-anchor": "middle"}, name);
    said.push(banks.length > 1 ? `${name}: ${words}` : words);
  });
  const caption = document.querySelector("#star figcaption");
  caption.textContent = `${W.star} ${n}`;
  svg.querySelector("desc").textContent = `${W.star} ${n}: ${said.join("; ")}.`;
}

// c_n and c_-n of force (i = 0) or couple (i = 2), vertical + i lateral, by DFT over the turn.
function harmonic(i, n) {
  const z = [[0, 0], [0, 0]];
  for (let k = 0; k < N; k++) {
    const v = [curves[k][i], curves[k][i + 1]];
    [n, -n].forEach((m, j) => { const t = mul(v, unit(-m*TURN*k/N)); z[j][0] += t[0]/N; z[j][1] += t[1]/N; });
  }
  return z;
}

function phasors(id, i, look) {
  const svg = document.querySelector(`#${id} svg`);
  if (!svg) return;
  const n = S.order, [forward, backward] = harmonic(i, n), [factor, unitName] = scaleOf(i);
  const a = Math.hypot(...forward), b = Math.hypot(...backward), size = Math.max(a + b, 1e-12), k = 150/size;
  const tiny = 1e-9*Math.max(1, ...curves.map((v) => Math.abs(v[i])));
  const g = cleared(svg, -200, -190, 400, 385), gone = a + b < tiny;
  add(g, "line", {class: "axis", x1: -170, x2: 170, y1: 0, y2: 0});
  add(g, "line", {class: "axis", y1: -170, y2: 170, x1: 0, x2: 0});
  svg.closest("figure").classList.toggle("gone", gone);
  const words = gone ? (isOwn() ? W.zeroProved : W.zeroRounding) : `${W.forward} ${figure(a*factor)}, ${W.backward} ${figure(b*factor)} ${unitName}`;
  add(g, "text", {class: "ink", x: 0, y: 186, "text-anchor": "middle", "font-size": 14}, words);
  if (gone) { CHARTS[id] = () => {}; return; }
  const ends = Array.from({length: 120}, (_, j) => {
    const t = TURN*j/120, p = mul(forward, unit(t)), q = mul(backward, unit(-t));
    return [p[0] + q[0], p[1] + q[1]];
  });
  add(g, "circle", {class: "faint", r: a*k, cx: 0, cy: 0});
  add(g, "circle", {class: "faint", r: b*k, cx: 0, cy: 0});
  add(g, "polygon", {class: "path", points: ends.map((p) => xy(p, k)).join(" ")});
  const lines = ["ink", "open", look].map((name) => add(g, "line", {class: name, x1: 0, y1: 0}));
  CHARTS[id] = (theta) => {
    const p = mul(forward, unit(n*theta)), q = mul(backward, unit(-n*theta));
    set(lines[0], {x2: k*p[1], y2: -k*p[0]});
    set(lines[1], {x1: k*p[1], y1: -k*p[0], x2: k*(p[1] + q[1]), y2: -k*(p[0] + q[0])});
    set(lines[2], {x2: k*(p[1] + q[1]), y2: -k*(p[0] + q[0])});
  };
}

function bars() {
  const svg = document.querySelector("#orders svg");
  if (!svg) return;
  const rows = [];
  for (const [i, of] of [[0, W.force], [2, W.couple]]) {
    const tiny = 1e-9*Math.max(1, ...curves.map((v) => Math.hypot(v[i], v[i + 1])));
    for (const n of E.orders) {
      const [f, b] = harmonic(i, n), up = Math.hypot(f[0] + b[0], f[1] - b[1]), right = Math.hypot(f[1] + b[1], f[0] - b[0]);
      const most = Math.max(up, right);
      rows.push({name: `${of} ${n}`, value: most < tiny ? 0 : most*scaleOf(i)[0], look: i ? "shade" : "solid"});
    }
  }
  const high = Math.ceil(Math.log10(Math.max(1e-30, ...rows.map((r) => r.value))) - 1e-9), low = high - 7, k = 380/7;
  const deep = 20*rows.length + 6;
  const g = cleared(svg, -120, -12, 570, deep + 56);
  for (let p = low; p <= high; p++) {
    add(g, "line", {class: "faint", x1: (p - low)*k, x2: (p - low)*k, y1: -4, y2: deep});
    add(g, "text", {class: "ink", x: (p - low)*k, y: deep + 16, "text-anchor": "middle", "font-size": 11}, p === 0 ? "1" : p === 1 ? "10" : `1e${p}`.replace("-", "−"));
  }
  rows.forEach((r, j) => {
    const y = 20*j + 10, end = r.value ? (Math.log10(r.value) - low)*k : 0;
    add(g, "text", {class: "ink", x: -10, y: y + 4, "text-anchor": "end"}, r.name);
    if (end > 0) add(g, "rect", {class: r.look, x: 0, y: y - 6.4, width: end, height: 12.8});
    const words = end > 0 ? figure(r.value) : r.value ? `${figure(r.value)}` : W.zeroRounding;
    add(g, "text", {class: "ink", x: Math.max(end, 0) + 6, y: y + 4, "font-size": 11}, words);
  });
  const units = [...new Set([scaleOf(0)[1], scaleOf(2)[1]])].join(", ");
  add(g, "text", {class: "ink", x: 190, y: deep + 36, "text-anchor": "middle", "font-size": 11}, `${W.amplitude}, ${units}`);
}

// Frames -----------------------------------------------------------------------------------------
function redraw() {
  compute();
  document.body.classList.toggle("numeric", !isOwn());
  chart("forces", [0, 1], [W.verticalForce, W.lateralForce], ["force", "couple"]);
  chart("couples", [2, 3], [W.verticalCouple, W.lateralCouple], ["force", "couple"]);
  if (E.comparesTorque || isOwn()) chart("torque", [4], [W.torque], ["third"]);
  pathChart("path", 0, "force");
  pathChart("couple-path", 2, "couple");
  star();
  phasors("phasors", 0, "force");
  phasors("couple-phasors", 2, "couple");
  if (!isOwn() || S.rpm !== OWN.rpm) bars();
  frame();
  remember();
}
function frame() {
  const theta = S.theta*TURN/360;
  showSection(theta);
  showPlan(theta);
  showOblique(theta);
  for (const draw of Object.values(CHARTS)) draw(theta);
  const cycle = 180*E.strokes, cursor = part("firing", "cursor");
  cursor?.setAttribute("transform", `translate(${E.firingScale*(((S.theta%cycle) + cycle)%cycle)} 0) rotate(0)`);
  const now = value(theta);
  const words = [0, 1, 2, 3].map((i) => `${[W.verticalForce, W.lateralForce, W.verticalCouple, W.lateralCouple][i]} ${figure(now[i]*scaleOf(i)[0])} ${scaleOf(i)[1]}`);
  $("now").textContent = `θ = ${figure(S.theta)}°: ${words.join(", ")}${isOwn() ? "" : ` (${W.numeric})`}`;
  NOW.theta = S.theta; NOW.values = now;
  for (const [key, input] of Object.entries(INPUTS)) {
    if (document.activeElement !== input || running) input.value = String(S[key]);
    const out = input.parentElement.querySelector("output");
    if (out) out.textContent = typeof S[key] === "number" ? figure(S[key]) + (input.dataset.unit ?? "") : "";
  }
}
const NOW = {};
function step(time) {
  if (!running) return;
  const speed = Number($("speed").value);
  if (last !== null) S.theta = (S.theta + (time - last)/1000*speed)%(180*E.strokes);
  last = time;
  frame();
  requestAnimationFrame(step);
}
function run(on) {
  running = on; last = null;
  $("run").textContent = on ? W.stop : W.run;
  $("run").setAttribute("aria-pressed", String(on));
  if (on) requestAnimationFrame(step); else remember();
}
function remember() {
  const changed = Object.keys(S).filter((key) => S[key] !== OWN[key]);
  const hash = changed.map((key) => `${key}=${S[key]}`).join("&");
  // In a notebook the page is a frame without an address of its own.
  if (location.protocol !== "about:") history.replaceState(null, "", hash ? `#${hash}` : location.pathname + location.search);
}
function recall() {
  for (const [key, text] of new URLSearchParams(location.hash.slice(1))) {
    const input = INPUTS[key];
    if (!input) continue;
    if (key === "reading") { if (["crank", "firing"].includes(text)) S.reading = text; continue; }
    const x = Number(text);
    if (text !== "" && Number.isFinite(x)) {
      const low = input.min === undefined || input.min === "" ? -Infinity : Number(input.min);
      const high = input.max === undefined || input.max === "" ? Infinity : Number(input.max);
      if (key !== "order" || E.orders.includes(x)) S[key] = Math.min(Math.max(x, low), high);
    }
  }
}

const INPUTS = Object.fromEntries(["theta", "lambda", "bank", "reading", "share", "weights", "rpm", "order"].map((key) => [key, $(key)]).filter(([, node]) => node));
for (const [key, input] of Object.entries(INPUTS)) {
  input.addEventListener("input", () => {
    S[key] = key === "reading" ? input.value : Number(input.value);
    // The range's own step may not hit the engine's own value.
    if (typeof S[key] === "number" && Math.abs(S[key] - OWN[key]) < Number(input.step || 0)/2) S[key] = OWN[key];
    if (key === "theta") { frame(); remember(); } else redraw();
  });
}
$("run").addEventListener("click", () => run(!running));
$("reset").addEventListener("click", () => { Object.assign(S, OWN, {theta: S.theta}); redraw(); });
const oblique = document.querySelector("#oblique svg");
if (oblique && E.drawsOblique) {
  oblique.setAttribute("tabindex", "0");
  let from = null;
  oblique.addEventListener("pointerdown", (e) => { from = [e.clientX, e.clientY]; oblique.setPointerCapture(e.pointerId); });
  oblique.addEventListener("pointermove", (e) => {
    if (!from) return;
    view.turn += (e.clientX - from[0])/150;
    view.tilt = Math.max(-1.5, Math.min(1.5, view.tilt + (e.clientY - from[1])/150));
    from = [e.clientX, e.clientY];
    showOblique(S.theta*TURN/360);
  });
  oblique.addEventListener("pointerup", () => { from = null; });
  oblique.addEventListener("keydown", (e) => {
    const by = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[e.key];
    if (!by) return;
    e.preventDefault();
    view.turn += by[0]; view.tilt = Math.max(-1.5, Math.min(1.5, view.tilt + by[1]));
    showOblique(S.theta*TURN/360);
  });
}
$("controls").hidden = false;
$("controls").addEventListener("submit", (e) => e.preventDefault());
window.addEventListener("hashchange", () => { Object.assign(S, OWN); recall(); redraw(); });
if (check()) {  // at the engine's own values, before the address may change them
  recall();
  redraw();
  // For programs that read the page: what it shows now.
  window.symbalance = {state: S, now: NOW, motion: (n, theta) => motion(byNumber[n], theta), show: (values) => { Object.assign(S, values); redraw(); }};
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches && !location.hash) run(true);
} else {
  $("controls").hidden = true;
}
