// Frames, sliders and the address, which holds all that was changed.
const NOW = {};
function redraw() {
  compute();
  // Newtons of another speed are not those that stand in the tables.
  document.body.classList.toggle("numeric", !isOwn() || (OWN.rpm > 0 && S.rpm !== OWN.rpm));
  NOW.values = value(S.theta*TURN/360);
  arrangeSection();
  plan();
  forceChart("forces", 0, [W.verticalForce, W.lateralForce]);
  forceChart("couples", 2, [W.verticalCouple, W.lateralCouple]);
  pistonChart();
  torqueChart();
  pathChart("path", 0, "force");
  pathChart("couple-path", 2, "couple");
  star();
  bankForces();
  strokes();
  phasors("phasors", 0, "force");
  phasors("couple-phasors", 2, "couple");
  bars();
  firing();
  frame();
  fitSection();
  fillEditor();
  remember();
}
function frame() {
  const theta = S.theta*TURN/360;
  NOW.theta = S.theta;
  NOW.values = value(theta);
  showSection(theta);
  showOblique(theta);
  for (const draw of Object.values(FRAMES)) draw(theta);
  if (FIRES) part("firing", "cursor")?.setAttribute("transform", `translate(${560/CYCLE*turned(S.theta - firesAt(lowest()), CYCLE)} 0) rotate(0)`);
  const words = [W.verticalForce, W.lateralForce, W.verticalCouple, W.lateralCouple].map((name, i) => `${name} ${figure(NOW.values[i]*scaleOf(i)[0])} ${scaleOf(i)[1]}`);
  $("now").textContent = `θ = ${figure(S.theta)}°: ${words.join(", ")}${isOwn() ? "" : ` (${W.numeric})`}`;
  for (const [key, input] of Object.entries(INPUTS)) {
    if (document.activeElement !== input || running) input.value = String(S[key]);
    const out = input.parentElement.querySelector("output");
    if (out) out.textContent = typeof S[key] === "number" ? figure(S[key]) + (input.dataset.unit ?? "") : "";
  }
  const angle = $("angle");
  if (document.activeElement !== angle) angle.value = String(Number(S.theta.toFixed(2)));
}
let running = false, last = null;
function step(time) {
  if (!running) return;
  const speed = Number($("speed").value);
  if (last !== null) S.theta = (S.theta + (time - last)/1000*speed)%CYCLE;
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
  take(ROWS.map((row) => ({...row})));
  for (const [key, text] of new URLSearchParams(location.hash.slice(1))) {
    if (key === "edit") { recallEdit(text); continue; }
    const input = INPUTS[key];
    if (!input) continue;
    if (key === "reading") { if (["crank", "firing"].includes(text)) S.reading = text; continue; }
    const x = Number(text);
    if (text === "" || !Number.isFinite(x)) continue;
    const low = input.min === undefined || input.min === "" ? -Infinity : Number(input.min);
    const high = input.max === undefined || input.max === "" ? Infinity : Number(input.max);
    if (input.options && ![...input.options].some((o) => Number(o.value) === x)) continue;
    S[key] = Math.min(Math.max(x, low), high);
  }
  if (EDITED) S.bank = OWN.bank;
}

buildEditor();
const KEYED = ["theta", "lambda", "bank", "reading", "share", "ahead", "back", "weights", "rpm", "order", "cylinder", "delta"];
const INPUTS = Object.fromEntries(KEYED.map((key) => [key, $(key)]).filter(([, node]) => node));
for (const [key, input] of Object.entries(INPUTS)) {
  input.addEventListener("input", () => {
    S[key] = key === "reading" ? input.value : Number(input.value);
    // The range's own step may not hit the engine's own value.
    if (input.type === "range" && Math.abs(S[key] - OWN[key]) < Number(input.step || 0)/2) S[key] = OWN[key];
    if (key === "theta") { frame(); remember(); } else redraw();
  });
}
$("angle").addEventListener("input", (e) => {
  const x = Number(e.target.value);
  e.target.toggleAttribute("aria-invalid", e.target.value === "" || !Number.isFinite(x));
  if (e.target.value === "" || !Number.isFinite(x)) return;
  run(false);
  S.theta = turned(x, CYCLE);
  frame();
  remember();
});
$("run").addEventListener("click", () => run(!running));
$("reset").addEventListener("click", () => {
  Object.assign(S, OWN, {theta: S.theta});
  refuse(null, "");
  take(ROWS.map((row) => ({...row})));
  redraw();
});
const oblique = picture("oblique");
if (oblique) {
  oblique.setAttribute("tabindex", "0");
  let from = null;
  const look = (turn, tilt) => {
    view.turn += turn;
    view.tilt = Math.max(-1.5, Math.min(1.5, view.tilt + tilt));
    showOblique(S.theta*TURN/360);
  };
  oblique.addEventListener("pointerdown", (e) => { from = [e.clientX, e.clientY]; oblique.setPointerCapture(e.pointerId); });
  oblique.addEventListener("pointermove", (e) => {
    if (!from) return;
    look((e.clientX - from[0])/150, (e.clientY - from[1])/150);
    from = [e.clientX, e.clientY];
  });
  oblique.addEventListener("pointerup", () => { from = null; });
  oblique.addEventListener("keydown", (e) => {
    const by = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[e.key];
    if (!by) return;
    e.preventDefault();
    look(...by);
  });
}
$("controls").addEventListener("submit", (e) => e.preventDefault());
window.addEventListener("hashchange", () => { Object.assign(S, OWN); recall(); redraw(); });
assemble();
if (check()) {  // at the engine's own values, before the address may change them
  for (const node of document.querySelectorAll("main [hidden]")) node.hidden = false;
  recall();
  redraw();
  // For programs that read the page: what it shows now.
  window.symbalance = {state: S, now: NOW, view, motion: (n, theta) => motion(BY[n], theta), gas: (theta) => gas(theta), show: (values) => { Object.assign(S, values); redraw(); }};
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches && !location.hash) run(true);
}
