// Crank stars, forces bank by bank, and the firing diagram: they follow the order and the angles.
const orderName = (n) => n === Math.round(n) ? String(n) : `${2*n}/2`;
const short = (numbers) => numbers.length > 6 ? `${numbers[0]} ${numbers[1]} … ${numbers[numbers.length - 1]}` : numbers.join(" ");
// Stars as lists: arrows of cylinders, as complex numbers; what they are of; whether a proof says they close.
function starsOf(n) {
  const own = isOwn(), first = lowest();
  if (n !== Math.round(n)) {  // half orders, of the torque: one star, by the angles at which cylinders fire
    const arrows = CYLINDERS.map((c) => [c.number, unit(-n*(own ? c.fires : FIRES[c.number])*TURN/360)]);
    return [{name: W.starTorque, arrows, closed: own ? E.stars.closed[orderName(n)]?.[0] : null}];
  }
  if (E.stars.turning) {  // unlike, or in too many directions: what turns with the crank, and against it
    const sizes = CYLINDERS.map((c) => ofCylinder(c, n)), most = Math.max(...sizes.map((v) => Math.hypot(...v))) || 1;
    return [1, -1].map((way, j) => ({
      name: way > 0 ? W.forward : W.backward,
      arrows: CYLINDERS.map((c, i) => [c.number, mul([sizes[i][0]/most, way*sizes[i][1]/most], unit(c.bank))]),
      closed: own ? E.stars.closed[n]?.[j] : null, unit: most,
    }));
  }
  const banks = new Map();
  for (const c of CYLINDERS) { const key = turned(c.bank, TURN).toFixed(9); banks.set(key, [...(banks.get(key) ?? []), c]); }
  const unlike = new Set(CYLINDERS.map((c) => [c.length, c.offset, c.mass, c.link?.radius, c.link?.direction].join())).size > 1 && E.stars.unlike;
  const sizes = unlike ? new Map(CYLINDERS.map((c) => [c.number, ofCylinder(c, n)])) : null;
  const most = unlike ? Math.max(...[...sizes.values()].map((v) => Math.hypot(...v))) || 1 : 1;
  // Unlike ones stand as cylinder 1's arrow does for a piston without offset, so that stars compare.
  const zero = unlike ? sizes.get(first.number) : null, back = unlike ? mul([zero[0], -zero[1]], unit(n*(first.throw - first.bank))).map((v) => v/(Math.hypot(...zero) || 1)) : null;
  return [...banks.values()].map((group, j) => ({
    name: banks.size > 1 ? W.starAxis.replace("@", figure(Number((((turned(group[0].bank, TURN)*360/TURN + 180)%360) - 180).toFixed(3)))) : "",
    arrows: group.map((c) => [c.number, unlike ? mul(sizes.get(c.number), back).map((v) => v/most) : unit(TURN*turned(n*(c.throw - c.bank)/TURN, 1))]),
    closed: own ? E.stars.closed[n]?.[j] : null,
  }));
}
function star() {
  const svg = picture("star");
  if (!svg) return;
  const n = S.order, R = 78, stars = starsOf(n), cell = stars.some((each) => each.unit) ? 320 : 250;
  const across = stars.length === 4 ? 2 : Math.min(stars.length, 3), deep = Math.ceil(stars.length/across);
  const g = cleared(svg, -cell*across/2 - 16, -cell/2, cell*across + 32, cell*deep), said = [];
  stars.forEach(({name, arrows, closed, unit: scale}, j) => {
    const h = add(g, "g", {transform: `translate(${cell*(j%across - (across - 1)/2)} ${cell*Math.floor(j/across)})`}), ends = new Map();
    let sum = [0, 0];
    for (const [number, v] of arrows) {
      const key = v.map((x) => Math.round(x*1e6)).join();
      sum = [sum[0] + v[0], sum[1] + v[1]];
      ends.set(key, {v, numbers: [...(ends.get(key)?.numbers ?? []), number].sort((a, b) => a - b)});
    }
    add(h, "circle", {class: "faint", r: R});
    const placed = [];
    for (const {v, numbers} of ends.values()) {
      const long = Math.hypot(...v), text = short(numbers);
      arrow(h, [0, 0], [v[1]*R, -v[0]*R], "ink");
      if (long < 1e-6) continue;
      const away = R*long + 12 + 3*(text.length - 1)*Math.abs(v[1]/long), wide = 3.5*text.length + 2;
      const at = [away*v[1]/long, -away*v[0]/long + 4];
      // Where another label stands it goes further out.
      for (let i = 0; i < 4 && placed.some((p) => Math.abs(p[0] - at[0]) < p[2] + wide && Math.abs(p[1] - at[1]) < 12); i++) {
        at[0] += 13*v[1]/long; at[1] -= 13*v[0]/long;
      }
      placed.push([...at, wide]);
      write(h, at[0], at[1], text);
    }
    const size = Math.hypot(...sum), zero = closed ?? size < 1e-9*arrows.length;
    if (!zero) arrow(h, [0, 0], [R*sum[1]/arrows.length, -R*sum[0]/arrows.length], "force");
    const angle = figure(Number(turned(degrees(sum), 360).toFixed(4))%360);
    const shown = scale ? `${figure(size*scale/2)}` : figure(size);
    const words = zero ? (closed ? W.starCloses : W.starRounding) : (scale ? W.starSum : Math.abs(size - 1) < 1e-9 ? W.starLeavesOne : W.starLeaves).replace("#", shown).replace("@", angle);
    add(h, "text", {class: "ink", y: cell/2 - 12, "text-anchor": "middle", "font-weight": "bold", "data-verdict": j}, words);
    if (name) add(h, "text", {class: "ink", y: 14 - cell/2, "text-anchor": "middle"}, name);
    said.push(name ? `${name}: ${words}` : words);
  });
  document.querySelector("#star figcaption").textContent = `${W.star} ${orderName(n)}`;
  say(svg, `${W.star} ${orderName(n)}: ${said.join("; ")}.`);
}

// Each direction's force of the order along its axis, resolved into vertical and lateral, and their sum.
function bankForces() {
  const svg = picture("banks");
  if (!svg) return;
  const n = S.order, g = cleared(svg, -210, -190, 420, 390), groups = new Map();
  document.querySelector("#banks figcaption").textContent = W.banks.replace("@", orderName(n));
  FRAMES.banks = () => {};
  if (n !== Math.round(n)) { write(g, 0, 4, W.noHalves, "middle", 16); return; }
  for (const c of CYLINDERS) {
    const key = turned(c.bank, TURN).toFixed(9), z = ofCylinder(c, n), group = groups.get(key) ?? {bank: c.bank, z: [0, 0], numbers: []};
    groups.set(key, {...group, z: [group.z[0] + z[0], group.z[1] + z[1]], numbers: [...group.numbers, c.number]});
  }
  const list = [...groups.values()], size = Math.max(...list.map((b) => Math.hypot(...b.z)), 1e-12);
  const [factor, unitName] = scaleOf(0), k = 130/Math.max(size, 1e-12), gone = size < 1e-9;
  const amplitudes = list.map((b) => figure(Math.hypot(...b.z)*factor)), alike = new Set(amplitudes).size === 1;
  const words = gone ? W.banksZero : (alike ? `${W.each} ${amplitudes[0]}` : list.map((b, i) => `${short(b.numbers)}: ${amplitudes[i]}`).join("; ")) + ` ${unitName}`;
  note("banks", words);
  say(svg, words);
  for (const b of list) {
    const u = unit(b.bank);
    line(g, "axis", 0, 0, 165*u[1], -165*u[0]);
    write(g, 180*u[1], -180*u[0] + 4, short(b.numbers));
  }
  if (gone) { write(g, 0, 40, W.banksZero, "middle", 14); return; }
  const h = add(g, "g", {});
  FRAMES.banks = (theta) => {
    h.replaceChildren();
    let sum = [0, 0];
    list.forEach((b) => {
      const f = k*mul(b.z, unit(n*theta))[0], u = unit(b.bank), p = [f*u[0], f*u[1]];
      sum = [sum[0] + p[0], sum[1] + p[1]];
      line(h, "path", p[1], -p[0], p[1], 0);
      line(h, "path", p[1], -p[0], 0, -p[0]);
      arrow(h, [0, 0], [p[1], -p[0]], "couple");
    });
    const long = Math.hypot(...sum), fit = long > 185 ? 185/long : 1;
    arrow(h, [0, 0], [sum[1]*fit, -sum[0]*fit], "force");
  };
}

// Strokes of link rods, which are unlike: their lengths and where their pistons stand highest.
function strokes() {
  const svg = picture("strokes");
  if (!svg) return;
  const r = E.radius ? 1000*E.radius : 1, unitName = E.radius ? "mm" : "r";
  const rows = [...CYLINDERS].sort((a, b) => a.number - b.number).map((c) => [c.number, (c.highest - c.lowest)*c.radius*r, turned((c.top + c.throw - c.bank)*360/TURN + 180, 360) - 180]);
  const low = Math.min(...rows.map((row) => row[1])), high = Math.max(...rows.map((row) => row[1])), wide = high - low || 1;
  const g = cleared(svg, -60, -34, 470, 20*rows.length + 52);
  write(g, 110, -16, `${W.strokes}, ${unitName}`, "middle", 11);
  write(g, 310, -16, W.topAt, "middle", 11);
  rows.forEach(([number, stroke, top], j) => {
    const y = 20*j + 6, x = 8 + 130*(stroke - low)/wide;
    write(g, -12, y + 4, number, "end");
    line(g, "faint", 0, y, 220, y);
    line(g, "crank", 0, y, x, y);
    add(g, "circle", {class: "ink", cx: x, cy: y, r: 3});
    write(g, x + 10, y + 4, figure(stroke, 6), "start", 11);
    write(g, 310, y + 4, `${figure(Number(top.toFixed(3)), 5)}°`, "middle", 11);
  });
  say(svg, rows.map((row) => `${row[0]}: ${figure(row[1], 6)} ${unitName}, ${figure(row[2])}°`).join("; "));
}

function firing() {
  const svg = picture("firing");
  // The library's own drawing stands until something is changed.
  if (!svg || !FIRES || (isOwn() && !firing.drawn && svg.querySelector("path"))) return;
  firing.drawn = true;
  const wide = 560, left = 44, row = 24, k = wide/CYCLE;
  const rows = Object.entries(FIRES).map(([n, at]) => [Number(n), at]).sort((a, b) => a[1] - b[1] || a[0] - b[0]);
  const gaps = rows.map(([, at], i) => (i + 1 < rows.length ? rows[i + 1][1] : rows[0][1] + CYCLE) - at);
  const near = (a, b) => Math.abs(a - b) <= 0.05, usual = gaps.reduce((best, gap) => {
    const count = gaps.filter((other) => near(gap, other)).length;
    return count > best[1] ? [gap, count] : best;
  }, [0, 0])[0];
  const uneven = gaps.some((gap) => !near(gap, usual)), low = row*(rows.length + 0.6);
  const g = cleared(svg, 0, -34, left + wide + 24, low + 90);
  const names = E.strokes === 4 ? ["power", "exhaust", "intake", "compression"] : ["power", "compression"];
  const looks = {power: "solid", exhaust: "open", intake: "faint", compression: "shade"};
  const box = (look, a, b, y) => b > a && add(g, "rect", {class: look, x: left + a*k, width: (b - a)*k, y: y - 0.32*row, height: 0.64*row});
  rows.forEach(([number, at], i) => {
    const y = row*(i + 1);
    add(g, "text", {class: "ink", x: left - 12, y: y + 4, "text-anchor": "end", "font-weight": "bold"}, number);
    names.forEach((name, j) => {
      const from = turned(at + 180*j, CYCLE);
      box(looks[name], from, Math.min(from + 180, CYCLE), y);
      box(looks[name], 0, from + 180 - CYCLE, y);
    });
    line(g, "path", left + at*k, -2, left + at*k, y - 0.4*row);
    if (rows.length < 17) write(g, left + turned(at + gaps[i]/2, CYCLE)*k, -5 - (rows.length > 8 ? 11*(i%2) : 0), `${figure(Number(gaps[i].toFixed(3)), 5)}°${near(gaps[i], usual) ? "" : "*"}`, "middle", 11);
  });
  for (let t = 0; t <= CYCLE; t += E.strokes === 4 ? 180 : 90) {
    line(g, "ink", left + t*k, low, left + t*k, low + 5);
    write(g, left + t*k, low + 17, `${t}°`, "middle", 11);
  }
  line(g, "ink", left, low, left + wide, low);
  names.forEach((name, j) => {
    add(g, "rect", {class: looks[name], x: left + 104*j, width: 22, y: low + 28, height: 16});
    write(g, left + 104*j + 28, low + 40, W[name], "start", 11);
  });
  if (uneven) write(g, left + 104*names.length, low + 40, W.unlikeOthers, "start", 11);
  line(add(g, "g", {"data-part": "cursor"}), "ink", left, -2, left, low);
  say(svg, rows.map((r) => r[0]).join("-") + ": " + gaps.map((gap) => figure(gap) + "°").join(", "));
}
