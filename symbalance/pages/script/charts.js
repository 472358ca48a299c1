// Charts: redrawn when a slider moves; at each frame only their marks move.
// rows: {name, look, values} at even steps of `span` degrees; `now` gives their values at theta. A height has
// no need of 0 in its field.
function chart(id, rows, unitName, now, span = 360, least = 0) {
  const svg = picture(id);
  if (!svg) return;
  const width = 400, height = 230, all = rows.flatMap((row) => row.values);
  let low = Math.min(least, ...all), high = Math.max(least, ...all);
  if (high - low < 1e-9) { low = -1; high = 1; }
  const margin = 0.06*(high - low);
  low -= margin; high += margin;
  const y = (v) => -(v - low)*height/(high - low);
  const g = cleared(svg, -58, -height - 32, width + 76, height + 74);
  for (const v of steps(low, high)) {
    line(g, Math.abs(v) < 1e-9*(high - low) ? "ink" : "faint", 0, y(v), width, y(v));
    write(g, -8, y(v) + 4, figure(v), "end");
  }
  for (let t = 0; t <= span; t += span > 360 ? 180 : 90) write(g, t*width/span, 18, `${t}°`);
  write(g, width/2, 36, W.angle);
  write(g, -8, -height - 10, unitName, "end");
  let at = 0;
  const marks = rows.map((row) => {
    add(g, "polyline", {class: row.look, points: row.values.map((v, k) => `${(k*width/(row.values.length - 1)).toFixed(1)},${y(v).toFixed(2)}`).join(" ")});
    line(g, row.look, at, -height - 14, at + 26, -height - 14);
    write(g, at + 32, -height - 10, row.name, "start");
    at += 44 + (document.documentElement.lang === "ja" ? 13 : 7.2)*row.name.length;
    return row.still ? null : add(g, "circle", {class: `${row.look} opaque`, r: 4});
  });
  const cursor = line(g, "axis", 0, 0, 0, -height);
  say(svg, rows.map((row) => `${row.name}: ${figure(Math.min(...row.values))} … ${figure(Math.max(...row.values))} ${unitName}`).join("; "));
  FRAMES[id] = (theta) => {
    const x = turned(theta*360/TURN, span)*width/span, values = now(theta);
    set(cursor, {x1: x, x2: x});
    marks.forEach((mark, j) => mark && set(mark, {cx: x, cy: y(values[j])}));
  };
}
function forceChart(id, i, names) {
  const [factor, unitName] = scaleOf(i), rows = names.map((name, j) => ({name, look: ["force", "couple"][j], values: curves.map((v) => v[i + j]*factor)}));
  chart(id, rows, unitName, () => [NOW.values[i]*factor, NOW.values[i + 1]*factor]);
}

// The way of one piston, and what it would be on a rod without end: the difference is why engines shake.
function pistonChart() {
  const round = (t) => turned(Number((t*360/TURN).toFixed(3)), 360);
  const c = BY[S.cylinder], r = c.radius*(E.radius ? 1000*E.radius : 1), unitName = E.radius ? "mm" : "r";
  const simple = (t) => r*((c.highest + c.lowest)/2 + (c.highest - c.lowest)/2*Math.cos(t - c.top));
  const grid = Array.from({length: 181}, (_, k) => TURN*k/180);
  const rows = [
    {name: W.piston.replace("@", c.number), look: "force", values: grid.map((t) => r*motion(c, t).y)},
    {name: W.simple, look: "open", still: true, values: grid.map(simple)},
  ];
  chart("piston", rows, unitName, (t) => [r*motion(c, t).y], 360, r*c.lowest);
  const stroke = (c.highest - c.lowest)*r, at90 = (c.highest - motion(c, c.top + TURN/4).y)/(c.highest - c.lowest);
  const first = 2*Math.hypot(...ofCylinder(c, 1)) || 1, sizes = [2, 3, 4, 6].map((n) => [n, 100*2*Math.hypot(...ofCylinder(c, n))/first]).filter((row) => row[1] > 1e-7);
  const words = W.pistonNote.split("@"), told = [figure(stroke, 6), unitName, figure(round(c.top)), figure(round(c.bottom)), figure(100*at90)];
  note("piston", words.map((w, i) => w + (told[i] ?? "")).join("") + sizes.map(([n, v]) => `${n}: ${figure(v)}`).join(", ") + ".");
}

function torqueChart() {
  const svg = picture("torque");
  if (!svg) return;
  const [factor, unitName] = scaleOf(4), gasToo = E.gas && FIRES && S.rpm > 0, span = gasToo ? CYCLE : 360, count = gasToo ? CYCLE : N;
  const inertia = (theta) => (value(theta)[4] + ofRods(theta))*factor;
  const grid = Array.from({length: count + 1}, (_, k) => k*span/count*TURN/360);
  const rows = [{name: W.torque, look: "third", values: grid.map(inertia)}];
  if (gasToo) {
    rows.push({name: W.gasTorque, look: "couple", values: grid.map(gas)});
    rows.push({name: W.totalTorque, look: "force", values: grid.map((_, k) => rows[0].values[k] + rows[1].values[k])});
  }
  chart("torque", rows, unitName, (theta) => {
    const a = inertia(theta), b = gasToo ? gas(theta) : 0;
    return [a, b, a + b];
  }, span);
  const whole = rows[rows.length - 1].values, step = span/count*TURN/360;
  const mean = whole.slice(1).reduce((sum, v) => sum + v, 0)/count;
  let energy = 0, low = 0, high = 0;
  for (let k = 0; k < count; k++) {
    energy += ((whole[k] + whole[k + 1])/2 - mean)*step;
    low = Math.min(low, energy); high = Math.max(high, energy);
  }
  const omega = S.rpm*TURN/60, wheel = (high - low)/S.delta/(unitName === "N m" ? omega*omega : 1);
  NOW.wheel = wheel; NOW.mean = mean; NOW.energy = high - low;
  const words = (gasToo ? W.flywheelGas : W.flywheel).split("@");
  const told = gasToo ? [figure(mean), figure(high - low), figure(S.delta), figure(wheel)] : [figure(S.delta), `${figure(wheel)} ${unitName === "N m" ? "kg m²" : "m r²"}`];
  note("torque", words.map((w, i) => w + (told[i] ?? "")).join(""));
}

function pathChart(id, i, look) {
  const svg = picture(id);
  if (!svg) return;
  const [factor, unitName] = scaleOf(i), ends = (rows) => rows.map((v) => [v[i]*factor, v[i + 1]*factor]), points = ends(curves);
  const before = bare ? ends(bare) : [];
  let size = Math.max(...[...points, ...before].map((p) => Math.hypot(...p)));
  if (size < 1e-9*factor) size = factor;
  const half = 170, k = half/size;
  const g = cleared(svg, -250, -212, 460, 442);
  for (const v of steps(-size, size, 5)) {
    line(g, "faint", v*k, -184, v*k, 184);
    line(g, "faint", -184, v*k, 184, v*k);
    write(g, v*k, 202, figure(v), "middle", 14);
    write(g, -190, -v*k + 5, figure(v), "end", 14);
  }
  write(g, 0, -194, `${W.vertical}, ${unitName}`, "middle", 14);
  write(g, 0, 222, `${W.lateral}, ${unitName}`, "middle", 14);
  const shape = (look_, list) => add(g, "polygon", {class: look_, points: list.map((p) => xy(p, k)).join(" ")});
  if (before.length) shape("open", before);
  shape(look, points);
  const most = (list) => Math.max(...list.map((p) => Math.hypot(...p)));
  const words = before.length ? W.takenAway.replace("#", figure(most(before))).replace("@", `${figure(most(points))} ${unitName}`) : `${W.most} ${figure(most(points))} ${unitName}`;
  note(id, words);
  say(svg, words);
  const hand = line(g, look, 0, 0, 0, 0), tip = add(g, "circle", {class: `${look} opaque`, r: 4});
  FRAMES[id] = () => {
    const up = NOW.values[i]*factor*k, right = NOW.values[i + 1]*factor*k;
    set(hand, {x2: right, y2: -up});
    set(tip, {cx: right, cy: -up});
  };
}

// An order's parts that turn with and against the crank, their sum's ellipse, and what it was without weights.
function phasors(id, i, look) {
  const svg = picture(id);
  if (!svg) return;
  const n = S.order, whole = n === Math.round(n), g = cleared(svg, -210, -190, 420, 396);
  FRAMES[id] = () => {};
  const [forward, backward] = whole ? harmonic(i, n) : [[0, 0], [0, 0]], [factor, unitName] = scaleOf(i);
  const ghosts = whole && bare ? harmonic(i, n, bare) : null;
  const a = Math.hypot(...forward), b = Math.hypot(...backward), was = ghosts ? ghosts.map((v) => Math.hypot(...v)) : [0, 0];
  const size = Math.max(a + b, was[0] + was[1], 1e-12), k = 150/size;
  const tiny = 1e-9*Math.max(1, ...curves.map((v) => Math.abs(v[i]))), of = i ? "couple" : "force";
  // What is proved to be there is there, however small.
  const gone = isOwn() && whole ? !E.present[of].includes(n) : a + b < tiny;
  picture(id).closest("figure").querySelector("figcaption").textContent = W[id].replace("@", orderName(n));
  svg.closest("figure").classList.toggle("gone", gone && was[0] + was[1] < tiny);
  const zero = !whole ? W.noHalves : isOwn() ? W.zeroProved : W.zeroRounding;
  let words = gone ? zero : `${W.forward} ${figure(a*factor)}, ${W.backward} ${figure(b*factor)} ${unitName}`;
  if (ghosts && was[0] + was[1] > tiny) words += ` (${W.without} ${figure(was[0]*factor)}, ${figure(was[1]*factor)})`;
  note(id, words);
  say(svg, words);
  if (gone && was[0] + was[1] < tiny) {
    write(g, 0, 4, zero, "middle", 16);
    return;
  }
  line(g, "axis", -170, 0, 170, 0);
  line(g, "axis", 0, -170, 0, 170);
  const ellipse = (f, h, name) => add(g, "polygon", {class: name, points: Array.from({length: 120}, (_, j) => {
    const t = TURN*j/120, p = mul(f, unit(t)), q = mul(h, unit(-t));
    return xy([p[0] + q[0], p[1] + q[1]], k);
  }).join(" ")});
  if (ghosts) ellipse(...ghosts, "open");
  if (gone) return;
  add(g, "circle", {class: "faint", r: a*k});
  if (b*k > 1) add(g, "circle", {class: "faint", r: b*k});
  ellipse(forward, backward, look);
  const h = add(g, "g", {});
  [["ink", W.forward], ["open", W.backward]].forEach(([name, text], j) => {
    line(g, name, -195 + 200*j, 188, -165 + 200*j, 188);
    write(g, -158 + 200*j, 192, text, "start", 13);
  });
  FRAMES[id] = (theta) => {
    const p = mul(forward, unit(n*theta)).map((v) => v*k), q = mul(backward, unit(-n*theta)).map((v) => v*k);
    h.replaceChildren();
    arrow(h, [0, 0], [p[1], -p[0]], "ink");
    arrow(h, [0, 0], [q[1], -q[0]], "open");
    line(h, "path", p[1], -p[0], p[1] + q[1], -p[0] - q[0]);
    line(h, "path", q[1], -q[0], p[1] + q[1], -p[0] - q[0]);
    arrow(h, [0, 0], [p[1] + q[1], -p[0] - q[0]], look);
  };
}

function bars() {
  const svg = picture("orders");
  if (!svg) return;
  const rows = [];
  for (const [i, of] of [[0, "force"], [2, "couple"]]) {
    const tiny = 1e-9*Math.max(1, ...curves.map((v) => Math.hypot(v[i], v[i + 1])));
    for (const n of E.barOrders) {
      const [f, b] = harmonic(i, n), up = Math.hypot(f[0] + b[0], f[1] - b[1]), right = Math.hypot(f[1] + b[1], f[0] - b[0]);
      const most = Math.max(up, right), proved = isOwn() && !E.present[of].includes(n);
      rows.push({name: `${W[of]} ${n}`, value: proved ? 0 : most*scaleOf(i)[0], zero: proved ? W.zeroProved : !isOwn() && most < tiny ? W.zeroRounding : "", look: i ? "shade" : "solid"});
    }
  }
  const high = Math.ceil(Math.log10(Math.max(1e-30, ...rows.map((r) => r.value))) - 1e-9), low = high - 7, k = 380/7;
  const deep = 20*rows.length + 6;
  const g = cleared(svg, -120, -12, 570, deep + 56);
  for (let p = low; p <= high; p++) {
    line(g, "faint", (p - low)*k, -4, (p - low)*k, deep);
    write(g, (p - low)*k, deep + 16, p === 0 ? "1" : p === 1 ? "10" : `1e${p}`.replace("-", "−"), "middle", 11);
  }
  rows.forEach((r, j) => {
    const y = 20*j + 10, end = r.zero ? 0 : (Math.log10(r.value) - low)*k;
    write(g, -10, y + 4, r.name, "end");
    if (end > 0) add(g, "rect", {class: r.look, x: 0, y: y - 6.4, width: end, height: 12.8});
    write(g, Math.max(end, 0) + 6, y + 4, r.zero || figure(r.value), "start", 11);
  });
  const units = [...new Set([scaleOf(0)[1], scaleOf(2)[1]])].join(", ");
  write(g, 190, deep + 36, `${W.amplitude}, ${units}`, "middle", 11);
  say(svg, rows.map((r) => `${r.name}: ${r.zero || figure(r.value)}`).join("; "));
}
