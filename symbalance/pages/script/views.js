// The engine seen from the front, from above and obliquely.
const FRONT = new Map();
const groupKey = (c) => `${turned(c.bank, TURN).toFixed(6)} ${(c.offset*c.radius).toFixed(6)}`;
// Of each direction of an axis the front cylinder; front first, and in order of number where they stand together.
function frontToRear() {
  return [...CYLINDERS].sort((a, b) => b.station - a.station || a.number - b.number);
}
function arrangeSection() {
  const svg = picture("section"), groups = new Map();
  for (const c of frontToRear()) groups.set(groupKey(c), [...(groups.get(groupKey(c)) ?? []), c.number]);
  const front = new Set([...groups.values()].map((numbers) => numbers[0]));
  if (!FRONT.size) for (const numbers of groups.values()) for (const n of numbers) FRONT.set(n, numbers[0]);
  const copied = (kind, of, number) => {  // what a new direction lacks it gets from where the cylinder stood
    const own = part("section", `${kind}-${number}`);
    if (own) return own;
    const from = part("section", `${kind}-${of}`), copy = from.cloneNode(true);
    for (const key of ["out", "at"]) if (from.dataset[key]) copy.dataset[key] = from.dataset[key];
    copy.dataset.part = `${kind}-${number}`;
    from.before(copy);
    return copy;
  };
  for (const node of svg.querySelectorAll('[data-part^="axis-"],[data-part^="numbers-"],[data-part^="throw-"]')) {
    node.style.display = "none";
  }
  for (const numbers of groups.values()) {
    const of = FRONT.get(numbers[0]);
    copied("axis", of, numbers[0]).style.display = "";
    const label = copied("numbers", of, numbers[0]);
    label.style.display = "";
    label.dataset.at ??= String(E.cylinders.find((c) => c.number === of).bank);
    label.firstChild.textContent = numbers.length > 6 ? `${numbers[0]} ${numbers[1]} … ${numbers[numbers.length - 1]}` : numbers.join(" ");
  }
  const throws = new Set();
  frontToRear().forEach((c, place) => {
    const angle = turned(BY[c.link ? c.link.master : c.number].throw, TURN).toFixed(6);
    if (throws.has(angle)) return;
    throws.add(angle);
    const node = copied("throw", E.throws[0].cylinder, c.number);
    node.style.display = "";
    node.dataset.at ??= String((E.throws.find((t) => t.cylinder === c.number) ?? E.throws[0]).angle);
    node.classList.toggle("faded", place > 0);
  });
  for (const c of CYLINDERS) {
    for (const kind of ["piston", "rod", "master"]) {
      part("section", `${kind}-${c.number}`)?.classList.toggle("faded", !front.has(c.number) && c.number !== S.cylinder);
    }
  }
  svg.querySelectorAll(".knuckle").forEach((node) => node.remove());
  for (const c of CYLINDERS) {  // the way of each knuckle pin
    if (!c.link || CYLINDERS.length > 16) continue;
    const way = Array.from({length: 72}, (_, k) => xy(motion(c, TURN*k/72).rod, E.scales.section));
    svg.insertBefore(set(document.createElementNS(SVG, "polygon"), {class: "path knuckle", points: way.join(" ")}), svg.querySelector("g"));
  }
}
function showSection(theta) {
  const k = E.scales.section;
  for (const own of E.cylinders) {
    const c = BY[own.number], m = motion(c, theta), rod = [m.piston[0] - m.rod[0], m.piston[1] - m.rod[1]];
    const name = c.number, more = k*c.radius*(c.length - own.length), long = c.length/own.length;
    put(part("section", `piston-${name}`), m.piston.map((v) => k*v), c.bank*360/TURN);
    put(part("section", `rod-${name}`), m.rod.map((v) => k*v), degrees(rod), long === 1 ? "" : ` scale(1 ${long})`);
    put(part("section", `master-${name}`), m.pin.map((v) => k*v), degrees(rod));
    part("section", `axis-${name}`)?.setAttribute("transform", `translate(0 0) rotate(${c.bank*360/TURN}) translate(0 ${-more})`);
    const label = part("section", `numbers-${name}`);
    if (label) {
      label.dataset.out ??= label.getAttribute("transform").slice(10).split(")")[0];
      const [x, y] = label.dataset.out.split(" ").map(Number), at = mul([-y, x], unit(c.bank - Number(label.dataset.at)));
      put(label, [at[0] + more*m.axis[0], at[1] + more*m.axis[1]], 0);
    }
    const pin = part("section", `throw-${name}`);
    if (pin) pin.setAttribute("transform", `rotate(${(BY[c.link ? c.link.master : name].throw - Number(pin.dataset.at))*360/TURN})`);
  }
  part("section", "crank")?.setAttribute("transform", `translate(0 0) rotate(${theta*360/TURN})`);
}

// What was moved to another place is in sight: the box that the library drew, or one about all that stands.
function fitSection() {
  const svg = picture("section");
  svg.dataset.box ??= svg.getAttribute("viewBox");
  let [x, y, width, height] = svg.dataset.box.split(" ").map(Number);
  if (!isOwn()) {
    const crank = E.scales.section*(1 + 0.2*E.bore), all = svg.getBBox();
    x = Math.min(-crank, all.x) - 14; y = Math.min(-crank, all.y) - 14;
    width = Math.max(crank, all.x + all.width) + 14 - x; height = Math.max(crank, all.y + all.height) + 14 - y;
  }
  svg.setAttribute("viewBox", [x, y, width, height].map((v) => v.toFixed(1)).join(" "));
}

// The plan: what moves is put where it stands; stations and lever arms are written once.
function plan() {
  const svg = picture("plan");
  if (!svg) return;
  const bore = E.bore, pitch = E.pitch, ordered = frontToRear(), front = ordered[0].station, rear = ordered[ordered.length - 1].station;
  const side = (c) => Math.abs(Math.sin(c.bank))*(c.highest*c.radius + 0.34*bore) + Math.abs(Math.cos(c.bank))*0.475*bore;
  const width = 2*Math.max(bore, 1.2*E.cylinders[0].radius, ...CYLINDERS.map(side)), long = pitch*(front - rear) + 1.2*bore;
  const k = Math.min(620/long, 420/width), x = (station) => k*pitch*(front - station), low = 0.5*width*k + 8;
  const left = -0.6*bore*k - 30, g = cleared(svg, left, -low - 36, x(rear) + 0.6*bore*k + 30 - left, 2*low + 66);
  const moves = [...ordered].reverse().map((c) => {
    const axis = unit(c.bank), half = 0.475*bore*k, ends = [-0.3, 0.34].map((h) => h*bore*k*axis[1]).sort((a, b) => a - b);
    const foot = ends[0] - Math.abs(axis[0])*half, head = ends[1] + Math.abs(axis[0])*half;
    const rod = line(g, "rod", x(c.station), 0, x(c.station), 0), h = add(g, "g", {"data-part": `piston-${c.number}`});
    add(h, "rect", {class: "piston", x: -half, width: 2*half, y: -head, height: head - foot});
    add(h, "circle", {class: "ink opaque", r: 9});
    write(h, 0, 4, c.number, "middle", 11);
    return [c, rod, h];
  });
  const crank = add(g, "polyline", {class: "crank"}), half = Math.min(0.25*pitch, 0.3*bore)*k, throws = [];
  for (const c of ordered) {
    const pin = motion(c, 0).pin;
    if (!throws.some((t) => t.station === c.station && Math.hypot(t.pin[0] - pin[0], t.pin[1] - pin[1]) < 1e-9)) throws.push({station: c.station, pin, c});
  }
  const mean = CYLINDERS.reduce((sum, c) => sum + c.station - c.arm, 0)/CYLINDERS.length;
  line(g, "axis", x(mean), -low, x(mean), low);
  write(g, x(mean), -low - 8, W.meanOfStations, "middle", 11);
  let last = -Infinity;  // lever arms, where they have room
  for (const c of ordered) {
    const at = x(c.station);
    if (at - last > 34) { write(g, at, low + 18, figure(c.arm, 3).replace(new RegExp("^(?=[1-9.])"), "+"), "middle", 11); last = at; }
  }
  say(svg, ordered.map((c) => `${c.number}: ${figure(c.arm)}`).join(", "));
  FRAMES.plan = (theta) => {
    for (const [c, rod, h] of moves) {
      const m = motion(c, theta);
      h.setAttribute("transform", `translate(${x(c.station)} ${-k*m.piston[1]})`);
      set(rod, {y1: -k*m.rod[1], y2: -k*m.piston[1]});
    }
    const points = [[-0.6*bore*k - 18, 0]];
    for (const t of throws) {
      const to = -k*motion(t.c, theta).pin[1], at = x(t.station);
      points.push([at - half, 0], [at - half, to], [at + half, to], [at + half, 0]);
    }
    points.push([x(rear) + 0.6*bore*k + 18, 0]);
    crank.setAttribute("points", points.map((p) => p.map((v) => v.toFixed(2)).join()).join(" "));
  };
}

const view = {turn: -0.75, tilt: 0.38};
function showOblique(theta) {
  const svg = picture("oblique");
  if (!svg) return;
  const pitch = E.pitch, things = [];
  const rows = [...new Set(CYLINDERS.map((c) => c.arm))].sort((a, b) => a - b), half = 0.22;
  // However it is turned, nothing is farther from its middle than this.
  const heads = CYLINDERS.map((c) => mul([c.highest*c.radius, 0], unit(c.bank)));
  const middleOf = (i) => (Math.min(0, ...heads.map((p) => p[i])) + Math.max(0, ...heads.map((p) => p[i])))/2, [upwards, aside] = [middleOf(0), middleOf(1)];
  const reach = Math.hypot(Math.max(...[[0, 0], ...heads].map((p) => Math.hypot(p[0] - upwards, p[1] - aside))) + 0.5*E.bore, pitch*((rows[rows.length - 1] - rows[0])/2 + 0.5));
  const middleRow = (rows[0] + rows[rows.length - 1])/2, k = 205/reach;
  const ct = Math.cos(view.turn), st = Math.sin(view.turn), cl = Math.cos(view.tilt), sl = Math.sin(view.tilt);
  // x right, y up, z towards the front: turned about the vertical, then tilted.
  const eye = (up_, right_, front) => {
    const up = up_ - upwards, right = right_ - aside;
    const x = right*ct + front*st, z = front*ct - right*st;
    return [x, up*cl - z*sl, z*cl + up*sl];
  };
  const points = (list) => list.map((p) => `${(k*p[0]).toFixed(1)},${(-k*p[1]).toFixed(1)}`).join(" ");
  let before = rows[0] - 0.7;
  const along = (row) => pitch*(row - middleRow);
  const bar = (list, look) => things.push({depth: list.reduce((d, p) => d + p[2], 0)/list.length - 1e-3, points: points(list), look, open: true});
  for (const row of rows) {
    bar([eye(0, 0, along(before)), eye(0, 0, along(row - half))], "crank");
    const pins = new Map();
    for (const c of CYLINDERS) {
      if (c.arm !== row) continue;
      const m = motion(c, theta), f = along(row);
      pins.set(m.pin.map((v) => v.toFixed(6)).join(), m.pin);
      bar([eye(...m.rod, f), eye(...m.piston, f)], "rod");
      const side = mul(m.axis, [0, 0.475*E.bore]), rings = [-0.3, 0.34].map((h) => Array.from({length: 20}, (_, i) => {
        const t = TURN*i/20, a = Math.cos(t), at = [m.piston[0] + h*E.bore*m.axis[0] + a*side[0], m.piston[1] + h*E.bore*m.axis[1] + a*side[1]];
        return eye(...at, f + 0.475*E.bore*Math.sin(t));
      }));
      const middle = eye(...m.piston, f), tip = eye(m.piston[0] + m.axis[0], m.piston[1] + m.axis[1], f);
      const crown = rings[tip[2] >= middle[2] ? 1 : 0], at = [0, 1].map((i) => crown.reduce((sum, p) => sum + p[i], 0)/20);
      things.push({depth: middle[2], points: points(hull([...rings[0], ...rings[1]])), look: "piston", label: c.number, at, crown: points(crown)});
    }
    for (const pin of pins.values()) {
      bar([[0, 0], pin, pin, [0, 0]].map((p, i) => eye(...p, along(row + (i < 2 ? -half : half)))), "crank");
    }
    before = row + half;
  }
  bar([eye(0, 0, along(before)), eye(0, 0, along(rows[rows.length - 1] + 0.7))], "crank");
  things.sort((a, b) => a.depth - b.depth);
  const g = cleared(svg, -210, -210, 420, 420);
  for (const t of things) {
    add(g, t.open ? "polyline" : "polygon", {class: t.look, points: t.points});
    if (t.crown) add(g, "polygon", {class: "piston", points: t.crown});
    if (t.label) write(g, k*t.at[0], -k*t.at[1] + 4, t.label);
  }
}
function hull(points) {
  const sorted = points.slice().sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const chain = (list) => {
    const row = [];
    for (const p of list) {
      while (row.length > 1) {
        const [a, b] = row.slice(-2);
        if ((b[0] - a[0])*(p[1] - a[1]) - (b[1] - a[1])*(p[0] - a[0]) > 0) break;
        row.pop();
      }
      row.push(p);
    }
    return row.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}
