// The view: decodes the scene (cpp/view/scene.hpp tells how it is packed) and
// draws what is left when whole tetrahedra are cut away on one side of a plane.
(function () {
"use strict";

const $ = (id) => document.getElementById(id);
const canvas = $("canvas");

function giveUp() {
  const sentence = document.createElement("p");
  sentence.className = "fallback";
  sentence.textContent = "This browser has no WebGL, so the mesh cannot be drawn here; " +
    "everything else on this page does without.";
  $("stage").replaceWith(sentence);
  $("panel").remove();
  document.querySelectorAll("#view .legend, #view .note").forEach((part) => part.remove());
}

function hasWebGL() {
  try {
    const trial = document.createElement("canvas");
    const context = trial.getContext("webgl");
    return Boolean(context && context.getExtension("OES_standard_derivatives"));
  } catch (error) {
    return false;
  }
}

if (!hasWebGL()) {
  giveUp();
  return;
}

// --- what is in the page ---------------------------------------------------

const about = JSON.parse($("about").textContent);

function decode(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  let at = 0;
  const byte = () => bytes[at++];
  const natural = () => {
    let value = 0, unit = 1, part;
    do {
      part = bytes[at++];
      value += (part & 127) * unit;
      unit *= 128;
    } while (part > 127);
    return value;
  };
  const integer = () => {
    const value = natural();
    return value % 2 ? -(value + 1) / 2 : value / 2;
  };

  const count = natural();
  const width = Math.max(...[0, 1, 2].map((i) => about.high[i] - about.low[i]));
  const points = new Float32Array(3 * count);
  const last = [0, 0, 0];
  for (let i = 0; i < count; ++i)
    for (let axis = 0; axis < 3; ++axis) {
      last[axis] += integer();
      // The box is centred, and its longest side is 2.
      points[3 * i + axis] =
        2 * last[axis] / 65535 - (about.high[axis] - about.low[axis]) / width;
    }

  // The points and the region of `size` triangles; rest(i, region) reads on.
  const triangles = (size, rest) => {
    const corners = new Uint32Array(3 * size);
    let point = 0, region = 0;
    for (let i = 0; i < size; ++i) {
      point += integer();
      corners[3 * i] = point;
      corners[3 * i + 1] = point + integer();
      corners[3 * i + 2] = point + integer();
      region += integer();
      rest(i, region);
    }
    return corners;
  };

  const size = natural();
  const surface = {
    size, region: new Uint16Array(size), behind: new Uint16Array(size),
    angle: new Uint8Array(size), sides: new Uint8Array(3 * size)
  };
  surface.corners = triangles(size, (i, region) => {
    surface.region[i] = region;
    surface.behind[i] = integer();
    surface.angle[i] = byte();
    for (let axis = 0; axis < 3; ++axis) surface.sides[3 * i + axis] = byte();
  });

  const cuts = about.places.map((places) => places.map(() => {
    const size = natural();
    const cut = {
      size, region: [new Uint16Array(size), new Uint16Array(size)],
      angle: [new Uint8Array(size), new Uint8Array(size)]
    };
    cut.corners = triangles(size, (i, below) => {
      cut.region[0][i] = below;
      cut.region[1][i] = below + integer();
      cut.angle[0][i] = byte();
      cut.angle[1][i] = byte();
    });
    return cut;
  }));
  return {points, surface, cuts};
}

const scene = decode($("scene").textContent);
$("scene").remove();

// Smooth, of triangles of the surface: a function of a point and of the unit normal of a triangle
// there that gives the mean, by area, of those with which that one is smooth (some 40 degrees), so
// that sharp edges look sharp.
function smoothNormals(chosen) {
  const p = scene.points, corners = scene.surface.corners;
  const normals = new Float32Array(3 * chosen.length), first = new Uint32Array(p.length / 3 + 1);
  for (const {triangle} of chosen)
    for (let k = 0; k < 3; ++k) ++first[corners[3 * triangle + k] + 1];
  for (let i = 1; i < first.length; ++i) first[i] += first[i - 1];
  const next = first.slice(), triangles = new Uint32Array(3 * chosen.length);
  chosen.forEach(({triangle, turned}, t) => {
    const i = 3 * triangle, flip = turned ? -1 : 1;
    const a = 3 * corners[i], b = 3 * corners[i + 1], c = 3 * corners[i + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    normals.set([flip * x, flip * y, flip * z], 3 * t);
    for (let k = 0; k < 3; ++k) triangles[next[corners[i + k]]++] = t;
  });
  return (point, flat) => {
    const sum = [0, 0, 0];
    for (let at = first[point]; at < first[point + 1]; ++at) {
      const n = normals.subarray(3 * triangles[at], 3 * triangles[at] + 3);
      const along = n[0] * flat[0] + n[1] * flat[1] + n[2] * flat[2];
      if (along > 0.766 * Math.hypot(...n)) sum[0] += n[0], sum[1] += n[1], sum[2] += n[2];
    }
    const length = Math.hypot(...sum) || 1;
    return sum.map((c) => c / length);
  };
}

const rgb = (list) => list.map((color) => [1, 3, 5].map((i) => parseInt(color.substr(i, 2), 16)));
const palettes = {region: rgb(about.regions), angle: rgb(about.angles)};

// --- what is drawn ---------------------------------------------------------

const most = scene.surface.size +
  scene.cuts.reduce((size, cuts) => Math.max(size, ...cuts.map((cut) => cut.size)), 0);
const drawn = {
  position: new Float32Array(9 * most), normal: new Float32Array(9 * most),
  tint: new Uint8Array(9 * most), corner: new Float32Array(3 * most), size: 0
};

// Edges of a surface that was made coarser are not those of the mesh.
const noEdge = 3;

function put(a, b, c, color, normals) {
  const p = scene.points, to = drawn.position, n = drawn.normal, at = 9 * drawn.size;
  let i = at;
  for (const corner of [a, b, c])
    for (let axis = 0; axis < 3; ++axis, ++i) {
      to[i] = p[3 * corner + axis];
      drawn.tint[i] = color[axis];
    }
  const ux = to[at + 3] - to[at], uy = to[at + 4] - to[at + 1], uz = to[at + 5] - to[at + 2];
  const vx = to[at + 6] - to[at], vy = to[at + 7] - to[at + 1], vz = to[at + 8] - to[at + 2];
  const flat = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const area = Math.hypot(...flat) || 1, own = flat.map((c) => c / area);
  [a, b, c].forEach((corner, k) => {
    const smooth = normals ? normals(corner, own) : own;
    // A little of the face's own normal shows what the surface is made of.
    for (let axis = 0; axis < 3; ++axis)
      n[at + 3 * k + axis] = normals ? smooth[axis] + 0.35 * own[axis] : own[axis];
    drawn.corner[3 * drawn.size + k] = normals && about.coarse ? noEdge : k;
  });
  ++drawn.size;
}

// Whether a triangle of the surface is of a part, and whether it is seen from behind; its
// colour is that of a region: of what touches the part, where one alone is seen.
const parts = {
  all: () => (region, behind) => behind === 0 && {region},
  interfaces: () => (region, behind) => behind > 0 && {region},
  r: (one) => (region, behind) =>
    region === one ? {region: behind > 0 ? behind - 1 : one} :
    behind === one + 1 && {region, turned: true},
  i: (one, other) => (region, behind) =>
    (region === one && behind === other + 1 && {region}) ||
    (region === other && behind === one + 1 && {region: one, turned: true})
};

function partOf(value) {
  if (value in parts && value.length > 1) return {of: parts[value](), cut: () => value === "all"};
  const places = value.slice(1).split(",").map(Number);
  return {of: parts[value[0]](...places),
          cut: (region) => value[0] === "r" && region === places[0]};
}

// wish: {axis: -1 to 2, plane, below, color, part}
function build(wish) {
  const {surface, cuts} = scene, palette = palettes[wish.color], part = partOf(wish.part);
  drawn.size = 0;
  const chosen = [];
  for (let i = 0; i < surface.size; ++i) {
    if (wish.axis >= 0 &&
        (surface.sides[3 * i + wish.axis] <= wish.plane) !== wish.below) continue;
    const seen = part.of(surface.region[i], surface.behind[i]);
    if (seen) chosen.push({triangle: i, turned: seen.turned, region: seen.region,
                           angle: surface.angle[i]});
  }
  const normals = smoothNormals(chosen);
  for (const one of chosen) {
    const i = 3 * one.triangle, c = surface.corners, b = one.turned ? 2 : 1;
    put(c[i], c[i + b], c[i + 3 - b], palette[one[wish.color]], normals);
  }
  if (wish.axis < 0) return;
  const cut = cuts[wish.axis][wish.plane], c = cut.corners;
  const side = wish.below ? 0 : 1;
  for (let i = 0; i < cut.size; ++i) {
    if (!part.cut(cut.region[side][i])) continue;
    const b = wish.below ? 1 : 2;
    put(c[3 * i], c[3 * i + b], c[3 * i + 3 - b], palette[cut[wish.color][side][i]], null);
  }
}

// --- drawing ---------------------------------------------------------------

const renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true,
                                          preserveDrawingBuffer: true});
renderer.setClearColor(0, 0);
const geometry = new THREE.BufferGeometry();
for (const [name, array, normalized] of [["position", drawn.position, false],
                                         ["normal", drawn.normal, false],
                                         ["tint", drawn.tint, true]])
  geometry.setAttribute(name, new THREE.BufferAttribute(array, 3, normalized));
geometry.setAttribute("corner", new THREE.BufferAttribute(drawn.corner, 1));

const material = new THREE.ShaderMaterial({
  side: THREE.DoubleSide,
  extensions: {derivatives: true},
  uniforms: {edges: {value: 1}},
  vertexShader: `
    attribute vec3 tint;
    attribute float corner;
    varying vec3 color, facing, share;
    void main() {
      color = pow(tint, vec3(2.2));
      facing = normalize(normalMatrix * normal);
      share = corner > 2.5 ? vec3(1.0) : vec3(equal(vec3(corner), vec3(0.0, 1.0, 2.0)));
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: `
    uniform float edges;
    varying vec3 color, facing, share;
    void main() {
      vec3 n = normalize(facing);
      if (n.z < 0.0) n = -n;
      float light = 0.22 + 0.10 * n.y
        + 0.76 * max(dot(n, normalize(vec3(-0.45, 0.65, 0.75))), 0.0)
        + 0.20 * max(dot(n, normalize(vec3(0.8, 0.05, 0.5))), 0.0);
      vec3 shown = light * color + 0.10 * pow(1.0 - n.z, 3.0);
      // Edges of small triangles would be all that is seen.
      vec3 width = fwidth(share);
      vec3 near = smoothstep(vec3(0.0), 1.3 * width + 1e-6, share);
      float room = 1.0 - smoothstep(0.10, 0.45, max(width.x, max(width.y, width.z)));
      shown *= 1.0 - 0.72 * edges * room * (1.0 - min(near.x, min(near.y, near.z)));
      gl_FragColor = vec4(pow(shown, vec3(1.0 / 2.2)), 1.0);
    }`
});
const mesh = new THREE.Mesh(geometry, material);
mesh.frustumCulled = false;
const world = new THREE.Scene();
world.add(mesh);
const camera = new THREE.PerspectiveCamera(28, 1, 0.01, 100);
camera.up.set(0, 0, 1);
const controls = new THREE.OrbitControls(camera, canvas);
controls.screenSpacePanning = true;

let waiting = false;
function draw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    renderer.render(world, camera);
  });
}

function resize() {
  const {clientWidth, clientHeight} = $("stage");
  renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
  renderer.setSize(clientWidth, clientHeight, false);
  camera.aspect = clientWidth / clientHeight;
  camera.updateProjectionMatrix();
  draw();
}

function reset() {
  let radius = 0;
  for (let i = 0; i < scene.points.length; i += 3)
    radius = Math.max(radius, Math.hypot(scene.points[i], scene.points[i + 1],
                                         scene.points[i + 2]));
  const half = Math.PI / 180 * camera.fov / 2;
  const distance = radius / Math.sin(Math.min(half, Math.atan(Math.tan(half) * camera.aspect)));
  controls.target.set(0, 0, 0);
  camera.position.set(0.84, -0.44, 0.32).setLength(1.02 * distance);
  controls.update();
  draw();
}

// --- the panel -------------------------------------------------------------

const chosen = (name) => document.querySelector(`input[name=${name}]:checked`).value;
// The side that is away from where the view begins.
const staysBelow = [true, false, true];

function wish() {
  const axis = chosen("axis") === "none" ? -1 : Number(chosen("axis"));
  return {axis, plane: Number($("plane").value), color: chosen("color"),
          part: $("part") ? $("part").value : "all",
          below: axis >= 0 && staysBelow[axis] !== $("flip").checked};
}

function apply() {
  const wished = wish();
  build(wished);
  geometry.setDrawRange(0, 3 * drawn.size);
  for (const name in geometry.attributes) geometry.attributes[name].needsUpdate = true;
  material.uniforms.edges.value = $("edges").checked ? 1 : 0;
  $("plane").disabled = $("flip").disabled = wished.axis < 0;
  $("place").textContent =
    wished.axis < 0 ? "" : "xyz"[wished.axis] + " = " +
      about.places[wished.axis][wished.plane].toPrecision(4);
  $("drawn").textContent = drawn.size.toLocaleString("en").replace(/,/g, "\u202f") +
    " triangles are drawn.";
  $("drawn").dataset.value = drawn.size;
  for (const color of ["region", "angle"]) $("legend-" + color).hidden = wished.color !== color;
  draw();
}

function chooseAxis() {
  const axis = wish().axis;
  if (axis >= 0) {
    const count = about.places[axis].length;
    $("plane").max = count - 1;
    $("plane").value = (count - 1) >> 1;
  }
  apply();
}

for (const input of document.querySelectorAll("input[name=axis]"))
  input.addEventListener("change", chooseAxis);
for (const input of document.querySelectorAll("input[name=color], #flip, #edges, #part"))
  input.addEventListener("change", apply);
$("plane").addEventListener("input", apply);
$("reset").addEventListener("click", reset);
controls.addEventListener("change", draw);
window.addEventListener("resize", resize);
resize();
reset();
apply();
}());
