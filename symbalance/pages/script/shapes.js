// Figures, units and elements that drawings are made of.
const SVG = "http://www.w3.org/2000/svg";
function scaleOf(i) {  // what 1 of an output is, and its unit
  if (!S.rpm || !E.sizes) return [1, ["m r ω²", "m r ω²", "m r ω² a", "m r ω² a", "m r² ω²"][i]];
  const force = E.sizes.mass*E.sizes.radius*(S.rpm*TURN/60)**2;
  if (i === 4) return [force*E.sizes.radius, "N m"];
  if (i < 2) return [force, "N"];
  return E.sizes.pitch ? [force*E.sizes.pitch, "N m"] : [1, "m r ω² a"];
}
function figure(x, digits = 4) {
  if (Math.abs(x) < 1e-12) x = 0;
  return String(Number(x.toPrecision(digits))).replaceAll("-", "−");
}
const set = (node, values) => { for (const [k, v] of Object.entries(values)) node.setAttribute(k, v); return node; };
function add(parent, name, values, text) {
  const node = set(document.createElementNS(SVG, name), values);
  if (text !== undefined) node.textContent = text;
  parent.appendChild(node);
  return node;
}
const picture = (id) => document.querySelector(`#${id} svg`);
// A drawing begun anew: empty, of this box.
function cleared(svg, x, y, width, height) {
  svg.querySelectorAll("g,line,polyline,polygon,path,circle,text,rect,use").forEach((node) => node.remove());
  set(svg, {viewBox: `${x} ${y} ${width} ${height}`, width, height});
  return add(svg, "g", {});
}
function say(svg, words) { svg.querySelector("desc").textContent = words; }
function note(id, words) {
  const node = document.querySelector(`#${id} .note`);
  if (node) node.textContent = words;
}
const write = (parent, x, y, text, anchor = "middle", size = 12) => add(parent, "text", {class: "ink", x, y, "text-anchor": anchor, "font-size": size}, text);
const line = (parent, look, x1, y1, x2, y2) => add(parent, "line", {class: look, x1, y1, x2, y2});
const xy = (point, scale) => `${(point[1]*scale).toFixed(3)},${(-point[0]*scale).toFixed(3)}`;
const part = (id, name) => document.querySelector(`#${id} [data-part="${name}"]`);
const degrees = (point) => Math.atan2(point[1], point[0])*360/TURN;
function put(node, point, angle, more = "") {
  node?.setAttribute("transform", `translate(${point[1].toFixed(6)} ${(-point[0]).toFixed(6)}) rotate(${angle.toFixed(6)})${more}`);
}
function steps(low, high, most = 6) {
  const power = 10**Math.floor(Math.log10((high - low)/most));
  const step = [1, 2, 5, 10, 20].map((m) => m*power).find((s) => (high - low)/s <= most);
  const list = [];
  for (let k = Math.ceil(low/step - 1e-9); k*step <= high + 1e-9*step; k++) list.push(k*step);
  return list;
}
function arrow(parent, from, to, look) {  // points right, down
  const d = [to[0] - from[0], to[1] - from[1]], size = Math.hypot(...d);
  if (size < 1e-6) return;
  const u = [d[0]/size, d[1]/size], head = Math.min(9, size/2), base = [to[0] - head*u[0], to[1] - head*u[1]], side = 0.38*head;
  line(parent, look, from[0], from[1], base[0], base[1]);
  const corners = [to, [base[0] - side*u[1], base[1] + side*u[0]], [base[0] + side*u[1], base[1] - side*u[0]]];
  add(parent, "polygon", {class: `head ${look}`, points: corners.map((p) => p.map((c) => c.toFixed(3)).join()).join(" ")});
}
// What is drawn anew at each frame, by the figure's name.
const FRAMES = {};
