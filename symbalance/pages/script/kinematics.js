// The engine in motion: `evaluate` and OUTPUTS above are the library's emitted functions; everything here is
// computed from the numbers in the element #engine. Lengths count in crank radii of cylinder 1, forces in
// m r omega^2, points are [up, right], angles turn clockwise from straight up.
// No regular expression is written between slashes, no template within a template: the page is packed by rules
// that do not know them.
const E = JSON.parse(document.getElementById("engine").textContent);
const $ = (id) => document.getElementById(id);
const TURN = 2*Math.PI, N = 360, CYCLE = 180*E.strokes;
const W = E.words;
const mul = (a, b) => [a[0]*b[0] - a[1]*b[1], a[0]*b[1] + a[1]*b[0]];
const unit = (t) => [Math.cos(t), Math.sin(t)];
const turned = (x, by) => ((x%by) + by)%by;
const OWN = {
  theta: 0, lambda: E.lambda, bank: E.bankBetween, reading: "crank", share: 0, weights: 1, ahead: 0, back: 0,
  rpm: E.rpm, order: E.order, cylinder: E.cylinders[0].number, delta: E.delta, edit: "",
};
const S = {...OWN};
const ofEngine = ["lambda", "bank", "share", "weights", "ahead", "back", "edit"];
const isOwn = () => ofEngine.every((key) => S[key] === OWN[key]);

// The cylinders as the sliders and the table have them -------------------------------------------
let CYLINDERS = E.cylinders, BY = {}, planeShift = 0, FIRES = null;
function moved(c) {  // a cylinder with the sliders' bank angle and rod ratio
  const shift = S.bank === OWN.bank ? 0 : (S.bank - OWN.bank)*TURN/720*Math.sign(c.bank - E.bankMiddle);
  // "firing" turns each pin with its axis, so that the firing angles stay; "crank" leaves the crank.
  const throw_ = S.reading === "firing" ? c.throw + shift : c.throw;
  return {...c, bank: c.bank + shift, throw: throw_, length: S.lambda === OWN.lambda ? c.length : c.length*S.lambda/OWN.lambda};
}
const lowest = () => CYLINDERS.reduce((a, b) => a.number < b.number ? a : b);
function assemble() {
  CYLINDERS = E.cylinders.map((c) => moved(EDITED ? {...c, ...EDITED[c.number]} : c));
  planeShift = 0;
  if (EDITED) {
    const mean = CYLINDERS.reduce((sum, c) => sum + c.station, 0)/CYLINDERS.length;
    planeShift = mean - E.plane;
    for (const c of CYLINDERS) c.arm = c.station - mean;
  }
  BY = Object.fromEntries(CYLINDERS.map((c) => [c.number, c]));
  for (const c of CYLINDERS) Object.assign(c, travel(c));
  const first = lowest();
  FIRES = CYLINDERS.some((c) => c.fires === null) ? null : Object.fromEntries(CYLINDERS.map((c) => {
    // Of its dead centres the one nearest to the angle that the engine says.
    const at = (c.top - first.top)*360/TURN, said = c.fires - first.fires;
    return [c.number, turned(at + 360*Math.round((said - at)/360), CYCLE)];
  }));
}

// Kinematics -------------------------------------------------------------------------------------
// A cylinder at theta: its pins as points, and its piston's height with two derivatives by theta.
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
function motion(c, theta) {
  const p = theta + c.throw - c.bank, w = circle(p);
  if (c.link) {
    const m = BY[c.link.master];
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
    c, axis, y: x.y, y1: x.y1, y2: x.y2, f1: x.f1, f2: x.f2,
    pin: place(unit(p)), rod: place(w[0]), piston: place([x.y, c.offset]),
  };
}
// Where a piston reverses: theta of its top and its bottom, and its heights there.
function travel(c) {
  const ends = [0, TURN/2].map((after) => {
    let t = c.bank - c.throw + after;
    for (let i = 0; i < 9; i++) {
      const m = motion(c, t);
      t -= m.y1/m.y2;
    }
    return [t, motion(c, t).y];
  });
  return {top: ends[0][0], bottom: ends[1][0], highest: ends[0][1], lowest: ends[1][1]};
}

// Force and couple [up, right, up, right] and torque, by differentiated geometry; bare of weights, or not.
function numeric(theta, bare = false) {
  const z = [0, 0, 0, 0, 0];
  for (const c of CYLINDERS) {
    const m = motion(c, theta), f = -m.y2*c.mass;
    z[0] += f*m.axis[0]; z[1] += f*m.axis[1];
    z[2] += f*m.axis[0]*c.arm; z[3] += f*m.axis[1]*c.arm;
    z[4] += -m.y1*m.y2*c.mass*c.radius;
  }
  for (const t of E.turning) {  // c e^(i n theta) of weights and shafts
    const by = t.weight ? (bare ? 0 : S.weights) : 1, v = mul([by*t.value[0], by*t.value[1]], unit(t.order*theta));
    if (t.of === "force") {
      z[0] += v[0]; z[1] += v[1];
      // A moved reference plane gives a force another arm.
      z[2] -= planeShift*v[0]; z[3] -= planeShift*v[1];
    } else {
      z[2] += v[0]; z[3] += v[1];
    }
  }
  if (S.share && !bare) {  // counterweights opposite each pin, a share of the cylinder's own mass
    for (const c of CYLINDERS) {
      const v = mul([-S.share*c.mass, 0], unit(theta + c.throw));
      z[0] += v[0]; z[1] += v[1]; z[2] += v[0]*c.arm; z[3] += v[1]*c.arm;
    }
  }
  if (!bare) {
    for (const t of SHAFTS) {
      const v = mul(t.value, unit(t.order*theta));
      z[t.at] -= v[0]; z[t.at + 1] -= v[1];
    }
  }
  return z;
}
// What the rods' own inertia adds to the torque, in m r^2 omega^2: -J phi' phi''.
function ofRods(theta) {
  if (!E.hasRods) return 0;
  return CYLINDERS.reduce((sum, c) => {
    const m = motion(c, theta);
    return sum - c.excess*m.f1*m.f2;
  }, 0);
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

// Over a turn ------------------------------------------------------------------------------------
let curves = null, bare = null, SHAFTS = [];
// c_n and c_-n of force (i = 0) or couple (i = 2), vertical + i lateral, by DFT over the turn.
function harmonic(i, n, rows = curves) {
  const z = [[0, 0], [0, 0]];
  for (let k = 0; k < N; k++) {
    const v = [rows[k][i], rows[k][i + 1]];
    [n, -n].forEach((m, j) => { const t = mul(v, unit(-m*TURN*k/N)); z[j][0] += t[0]/N; z[j][1] += t[1]/N; });
  }
  return z;
}
// The amplitude C - iS, as a complex number, of what a cylinder pushes along its own axis in an order.
function ofCylinder(c, n) {
  const z = [0, 0];
  for (let k = 0; k < N; k++) {
    const v = unit(-n*TURN*k/N), f = -2*motion(c, TURN*k/N).y2*c.mass/N;
    z[0] += f*v[0]; z[1] += f*v[1];
  }
  return z;
}
function compute() {
  assemble();
  SHAFTS = [];
  const around = (of) => Array.from({length: N + 1}, (_, k) => of(TURN*k/N));
  const whole = S.order === Math.round(S.order);
  if (whole && (S.ahead || S.back)) {  // shafts that take a share of what the order leaves
    const rows = around(numeric);
    SHAFTS = [0, 2].flatMap((at) => {
      const [forward, backward] = harmonic(at, S.order, rows);
      const by = (share, v) => [share*v[0], share*v[1]];
      return [{at, order: S.order, value: by(S.ahead, forward)}, {at, order: -S.order, value: by(S.back, backward)}];
    });
  }
  curves = around(value);
  bare = E.hasWeights || S.share || SHAFTS.length ? around((t) => numeric(t, true)) : null;
}

// Gas --------------------------------------------------------------------------------------------
// Torque in N m of pressures over the cycle, straight lines between the trace's points.
function gas(theta) {
  let sum = 0;
  for (const c of CYLINDERS) {
    const {degrees, bar} = E.gas.traces[E.gas.of[c.number]];
    const at = turned(theta*360/TURN - firesAt(c), CYCLE);
    let low = 0, high = degrees.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (degrees[middle] <= at) low = middle; else high = middle;
    }
    const long = degrees[high] - degrees[low];
    const p = bar[low] + (long ? (at - degrees[low])/long*(bar[high] - bar[low]) : 0);
    sum -= p*E.gas.area*1e5*c.radius*E.sizes.radius*motion(c, theta).y1;
  }
  return sum;
}
// Degrees of theta at which a cylinder fires: cylinder 1's own dead centre, and what it is after that.
function firesAt(c) {
  return lowest().top*360/TURN + FIRES[c.number];
}
