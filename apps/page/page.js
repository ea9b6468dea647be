// The page that `vesicle render --html` writes: the surface over time with vtk.js, its colours, and the
// run's diagnostics. What may be asked for in the address: #frame=3&array=Tension&view=iso&play=1.
'use strict';

const data = JSON.parse(document.getElementById('data').textContent);
const byId = (id) => document.getElementById(id);
const wanted = new URLSearchParams(location.hash.slice(1));

function trouble(text) {
  byId('trouble').textContent = text;
  byId('trouble').hidden = false;
  document.documentElement.dataset.error = text;
}
window.addEventListener('error', (event) => trouble(`This page can't be shown: ${event.message}`));

// ---- numbers from base64, little-endian

function bytes(text) {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
}
const floats = (text) => new Float32Array(bytes(text).buffer);
const integers = (text) => new Uint32Array(bytes(text).buffer);
const shorts = (text) => new Uint16Array(bytes(text).buffer);

/** Values of an array in a frame: 16-bit steps over the range of the whole series. */
function values(array, frame) {
  const steps = shorts(array.frames[frame]);
  const [low, high] = array.extent;
  return Float32Array.from(steps, (step) => low + ((high - low) * step) / 65535);
}

/** Normals at the points: of the triangles around them, weighted by area. */
function pointNormals(points, triangles) {
  const normals = new Float32Array(points.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const u = [0, 1, 2].map((k) => points[b + k] - points[a + k]);
    const v = [0, 1, 2].map((k) => points[c + k] - points[a + k]);
    for (let k = 0; k < 3; ++k) {
      const n = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
      for (const corner of [a, b, c]) {
        normals[corner + k] += n;
      }
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) {
      normals[i + k] /= length;
    }
  }
  return normals;
}

/** vtk.js wants the number of corners before each triangle. */
function cells(triangles) {
  const list = new Uint32Array((triangles.length / 3) * 4);
  for (let t = 0, k = 0; t < triangles.length; t += 3) {
    list.set([3, triangles[t], triangles[t + 1], triangles[t + 2]], k);
    k += 4;
  }
  return list;
}

// ---- the surface

const directions = { // towards the camera, and up
  front: [[0, -1, 0], [0, 0, 1]],
  side: [[1, 0, 0], [0, 0, 1]],
  top: [[0, 0, 1], [0, 1, 0]],
  iso: [[1, -1, 1], [0, 0, 1]],
};

const cross = (a, b) => [0, 1, 2].map(
  (k) => a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));

/** Unit vectors of the picture plane, and towards the camera. */
function frameOf(camera) {
  const toward = unit(camera.getDirectionOfProjection().map((x) => -x));
  const right = unit(cross(camera.getViewUp(), toward));
  return { right, up: cross(toward, right), toward };
}

class Surface {
  constructor(container) {
    this.window = vtk.Rendering.Misc.vtkGenericRenderWindow.newInstance({
      background: [1, 1, 1], listenWindowResize: false });
    this.window.setContainer(container);
    this.mesh = vtk.Common.DataModel.vtkPolyData.newInstance();
    this.colors = vtk.Rendering.Core.vtkColorTransferFunction.newInstance();
    this.mapper = vtk.Rendering.Core.vtkMapper.newInstance({
      interpolateScalarsBeforeMapping: true, useLookupTableScalarRange: true });
    this.mapper.setLookupTable(this.colors);
    this.mapper.setInputData(this.mesh);
    this.actor = vtk.Rendering.Core.vtkActor.newInstance();
    this.actor.setMapper(this.mapper);
    const look = this.actor.getProperty();
    look.setInterpolationToPhong();
    look.setAmbient(0.45);
    look.setDiffuse(0.62);
    look.setSpecular(0.07);
    look.setSpecularPower(25);
    look.setEdgeColor(0.2, 0.2, 0.2);
    const renderer = this.window.getRenderer();
    renderer.addActor(this.actor);
    renderer.removeAllLights(); // the window has made one of its own
    this.addLamp(renderer, [-0.5, 0.6, 1], 0.82);
    this.addLamp(renderer, [0.7, -0.6, 0.7], 0.38);
    renderer.getActiveCamera().setParallelProjection(true);
    new ResizeObserver(() => this.resize()).observe(container);
    this.shown = {};
  }

  /** At a place relative to the camera, as in the pictures of `vesicle render`. */
  addLamp(renderer, place, intensity) {
    const lamp = vtk.Rendering.Core.vtkLight.newInstance();
    lamp.setLightTypeToCameraLight();
    lamp.setPosition(...place);
    lamp.setFocalPoint(0, 0, 0);
    lamp.setIntensity(intensity);
    renderer.addLight(lamp);
  }

  resize() {
    this.window.resize();
    this.render();
  }

  render() {
    this.window.getRenderWindow().render();
  }

  camera() {
    return this.window.getRenderer().getActiveCamera();
  }

  look(name) {
    const [toward, up] = directions[name] || directions.front;
    const length = Math.hypot(...toward);
    const camera = this.camera();
    camera.setFocalPoint(0, 0, 0);
    camera.setPosition(...toward.map((x) => (4 * data.radius * x) / length));
    camera.setViewUp(...up);
    camera.setParallelScale(1.3 * data.radius);
    this.window.getRenderer().resetCameraClippingRange();
    this.render();
  }

  setEdges(visible) {
    this.actor.getProperty().setEdgeVisibility(visible);
    this.render();
  }

  setColors(array) {
    this.colors.removeAllPoints();
    const table = bytes(array.colors);
    const [low, high] = array.range;
    const count = table.length / 3;
    for (let i = 0; i < count; ++i) {
      const rgb = [0, 1, 2].map((k) => table[3 * i + k] / 255);
      this.colors.addRGBPoint(low + ((high - low) * i) / (count - 1), ...rgb);
    }
    this.colors.setMappingRange(low, high);
  }

  show(frame, array) {
    const { points, triangles } = data.frames[frame];
    if (this.shown.frame !== frame) {
      const xyz = floats(points);
      const corners = integers(data.triangles[triangles]);
      this.mesh.getPoints().setData(xyz, 3);
      if (this.shown.triangles !== triangles) {
        this.mesh.getPolys().setData(cells(corners));
        this.shown.triangles = triangles;
      }
      this.mesh.getPointData().setNormals(vtk.Common.Core.vtkDataArray.newInstance({
        name: 'Normals', numberOfComponents: 3, values: pointNormals(xyz, corners) }));
      this.shown.frame = frame;
    }
    if (array) {
      this.mesh.getPointData().setScalars(vtk.Common.Core.vtkDataArray.newInstance({
        name: array.name, numberOfComponents: 1, values: values(array, frame) }));
    }
    this.mesh.modified();
    this.render();
  }
}

// ---- colour bar and axes

/** A canvas's drawing context in CSS pixels. */
function context(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const { clientWidth: width, clientHeight: height } = canvas;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const pen = canvas.getContext('2d');
  pen.scale(ratio, ratio);
  return { pen, width, height };
}

function drawBar(array) {
  byId('bar-title').textContent = array.title;
  const canvas = byId('bar-colors');
  const table = bytes(array.colors);
  const count = table.length / 3;
  canvas.width = 1;
  canvas.height = count;
  const pen = canvas.getContext('2d');
  for (let i = 0; i < count; ++i) {
    pen.fillStyle = `rgb(${table[3 * i]}, ${table[3 * i + 1]}, ${table[3 * i + 2]})`;
    pen.fillRect(0, count - 1 - i, 1, 1);
  }
  canvas.style.height = 'calc(100% - 44px)';
  byId('ticks').replaceChildren(...array.ticks.map(({ at, label }) => {
    const tick = document.createElement('div');
    tick.className = 'tick';
    tick.textContent = label;
    tick.style.top = `calc(44px + (100% - 44px) * ${1 - at})`;
    return tick;
  }));
}

function drawAxes(camera) {
  const { pen, width, height } = context(byId('axes'));
  pen.clearRect(0, 0, width, height);
  const { right, up, toward } = frameOf(camera);
  const axes = [0, 1, 2].map((k) => ({ name: 'xyz'[k], color: ['#bf3333', '#338c40', '#334dbf'][k],
    x: right[k], y: up[k], depth: toward[k] }));
  axes.sort((a, b) => a.depth - b.depth);
  pen.font = '15px system-ui, Arial, sans-serif';
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.lineWidth = 3;
  const middle = [width / 2, height / 2];
  const length = 0.26 * width;
  for (const axis of axes) {
    if (Math.hypot(axis.x, axis.y) < 0.2) {
      continue;
    }
    const end = [middle[0] + length * axis.x, middle[1] - length * axis.y];
    pen.strokeStyle = pen.fillStyle = axis.color;
    pen.beginPath();
    pen.moveTo(...middle);
    pen.lineTo(...end);
    pen.stroke();
    pen.beginPath();
    const d = unit([axis.x, -axis.y]);
    pen.moveTo(end[0] + 9 * d[0], end[1] + 9 * d[1]);
    pen.lineTo(end[0] + 5 * d[1], end[1] - 5 * d[0]);
    pen.lineTo(end[0] - 5 * d[1], end[1] + 5 * d[0]);
    pen.fill();
    pen.fillStyle = '#222';
    pen.fillText(axis.name, middle[0] + 1.45 * length * axis.x + 3 * d[0],
      middle[1] - 1.45 * length * axis.y + 3 * d[1]);
  }
}

// ---- the diagnostics

const lineColors = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00', '#3c3c3c'];

/** About `count` round numbers within an interval. */
function ticks(low, high, count) {
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((d) => d * power).find((s) => s >= raw * (1 - 1e-9));
  const found = [];
  for (let k = Math.ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; ++k) {
    found.push(k * step);
  }
  return { found, step };
}

function tickText(value, step) {
  const largest = Math.abs(value);
  if (largest >= 1e5 || (largest > 0 && step < 1e-4)) {
    return value.toExponential(Math.max(0, Math.min(4, Math.ceil(Math.log10(largest / step)))));
  }
  const digits = step >= 1 && Number.isInteger(step) ? 0 : Math.ceil(-Math.log10(step) + 0.3);
  return (value || 0).toFixed(Math.max(0, digits));
}

class Chart {
  constructor(canvas, table) {
    this.canvas = canvas;
    this.table = table;
    this.time = table.values[table.columns.indexOf('time')];
    this.chosen = table.chosen;
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  /** Only what is there and finite. */
  line(name) {
    const y = this.table.values[this.table.columns.indexOf(name)];
    return this.time.map((t, i) => [t, y[i]]).filter(([, value]) => value !== null);
  }

  draw(now = this.now) {
    this.now = now;
    const { pen, width, height } = context(this.canvas);
    const lines = this.chosen.map((name) => ({ name, points: this.line(name) }));
    const all = lines.flatMap(({ points }) => points.map(([, y]) => y));
    let low = all.reduce((a, b) => Math.min(a, b), Infinity);
    let high = all.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!(low <= high)) {
      [low, high] = [0, 1];
    }
    const pad = high > low ? 0.05 * (high - low) : 0.1 * Math.abs(high) || 1;
    [low, high] = [low - pad, high + pad];
    const first = this.time[0];
    const last = this.time[this.time.length - 1];
    const end = last > first ? last : first + 1;
    const box = { left: 66, right: width - 12, top: 14 + 20 * Math.max(1, lines.length), bottom: height - 40 };
    this.box = { ...box, first, end };
    const x = (t) => box.left + ((box.right - box.left) * (t - first)) / (end - first);
    const y = (v) => box.bottom - ((box.bottom - box.top) * (v - low)) / (high - low);
    pen.font = '13px system-ui, Arial, sans-serif';
    pen.lineWidth = 1;
    this.grid(pen, box, x, y, [first, end], [low, high]);
    lines.forEach(({ name, points }, k) => this.plot(pen, box, x, y, name, points, k));
  }

  grid(pen, box, x, y, [first, end], [low, high]) {
    pen.strokeStyle = '#e3e3e6';
    pen.fillStyle = '#222';
    const path = (points) => {
      pen.beginPath();
      points.forEach((p) => pen.lineTo(...p));
      pen.stroke();
    };
    const across = ticks(first, end, 5);
    pen.textAlign = 'center';
    pen.textBaseline = 'top';
    for (const t of across.found) {
      path([[x(t), box.top], [x(t), box.bottom]]);
      pen.fillText(tickText(t, across.step), x(t), box.bottom + 6);
    }
    pen.fillText('time', (box.left + box.right) / 2, box.bottom + 22);
    const upward = ticks(low, high, Math.max(2, Math.round((box.bottom - box.top) / 48)));
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    for (const v of upward.found) {
      path([[box.left, y(v)], [box.right, y(v)]]);
      pen.fillText(tickText(v, upward.step), box.left - 7, y(v));
    }
    pen.strokeStyle = '#222';
    path([[box.left, box.top], [box.left, box.bottom], [box.right, box.bottom]]);
  }

  plot(pen, box, x, y, name, points, k) {
    const color = lineColors[k % lineColors.length];
    const draw = (part, alpha) => {
      pen.globalAlpha = alpha;
      pen.beginPath();
      part.forEach(([t, v]) => pen.lineTo(x(t), y(v)));
      pen.stroke();
      pen.globalAlpha = 1;
    };
    pen.strokeStyle = pen.fillStyle = color;
    pen.lineWidth = 2.2;
    const until = points.findIndex(([t]) => t > this.now);
    const past = until < 0 ? points : points.slice(0, until);
    draw(points, 0.3);
    if (until > 0) {
      const [[t0, v0], [t1, v1]] = [points[until - 1], points[until]];
      past.push([this.now, v0 + ((v1 - v0) * (this.now - t0)) / (t1 - t0)]);
    }
    draw(past, 1);
    if (past.length > 0) {
      const [t, v] = past[past.length - 1];
      pen.beginPath();
      pen.arc(x(t), y(v), 5, 0, 2 * Math.PI);
      pen.fill();
    }
    const line = 10 + 20 * k + 6;
    pen.fillRect(box.left, line - 1, 22, 3);
    pen.fillStyle = '#222';
    pen.textAlign = 'left';
    pen.textBaseline = 'middle';
    pen.fillText(name, box.left + 30, line);
  }

  timeAt(pixel) {
    const { left, right, first, end } = this.box;
    return first + ((end - first) * (pixel - left)) / (right - left);
  }
}

// ---- all together

class Page {
  constructor() {
    document.title = data.title;
    byId('title').textContent = data.title;
    this.frame = 0;
    this.array = data.arrays.find(({ name }) => name === data.color) || data.arrays[0];
    this.surface = new Surface(byId('scene'));
    this.surface.camera().onModified(() => drawAxes(this.surface.camera()));
    this.setUpArrays();
    this.setUpChart();
    this.setUpTime();
    for (const button of document.querySelectorAll('#views button')) {
      button.onclick = () => this.surface.look(button.dataset.view);
    }
    byId('mesh').hidden = data.smooth; // its edges would be those of the display
    byId('edges').onchange = (event) => this.surface.setEdges(event.target.checked);
    this.chooseArray(wanted.get('array') || (this.array && this.array.name));
    this.show(Number(wanted.get('frame')) || 0);
    this.surface.look(wanted.get('view') || data.view);
    drawAxes(this.surface.camera());
    if (wanted.has('play')) {
      this.play();
    }
  }

  setUpArrays() {
    byId('bar').hidden = !this.array;
    byId('array').replaceChildren(...data.arrays.map(({ name, title }) => new Option(title, name)));
    byId('array').onchange = (event) => this.chooseArray(event.target.value);
  }

  setUpChart() {
    byId('diagnostics').hidden = !data.table;
    if (!data.table) {
      return;
    }
    this.chart = new Chart(byId('chart'), data.table);
    byId('columns').replaceChildren(...data.table.columns.filter((c) => c !== 'time').map((name) => {
      const label = document.createElement('label');
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.checked = this.chart.chosen.includes(name);
      box.onchange = () => {
        this.chart.chosen = box.checked ? [...this.chart.chosen, name]
          : this.chart.chosen.filter((other) => other !== name);
        this.chart.draw();
      };
      label.append(box, name);
      return label;
    }));
    byId('chart').onclick = (event) => this.goTo(this.chart.timeAt(event.offsetX));
  }

  setUpTime() {
    byId('slider').max = data.frames.length - 1;
    byId('slider').oninput = (event) => {
      this.stop();
      this.show(Number(event.target.value));
    };
    byId('play').onclick = () => (this.timer ? this.stop() : this.play());
    byId('play').disabled = data.frames.length < 2;
    document.addEventListener('keydown', (event) => {
      if (event.key === ' ' && event.target === document.body) {
        event.preventDefault();
        byId('play').click();
      }
    });
  }

  chooseArray(name) {
    this.array = data.arrays.find((array) => array.name === name) || this.array;
    if (this.array) {
      document.documentElement.dataset.array = this.array.name;
      byId('array').value = this.array.name;
      this.surface.setColors(this.array);
      drawBar(this.array);
      this.surface.show(this.frame, this.array);
    }
  }

  show(frame) {
    this.frame = Math.max(0, Math.min(data.frames.length - 1, frame));
    byId('slider').value = this.frame;
    document.documentElement.dataset.frame = this.frame;
    byId('time').textContent = data.frames[this.frame].label;
    byId('frame').textContent = `${this.frame + 1} of ${data.frames.length}`;
    this.surface.show(this.frame, this.array);
    if (this.chart) {
      this.chart.draw(data.frames[this.frame].time);
    }
  }

  goTo(time) {
    this.stop();
    const away = data.frames.map((frame) => Math.abs(frame.time - time));
    this.show(away.indexOf(Math.min(...away)));
  }

  play() {
    const seconds = Math.min(15, Math.max(5, data.frames.length / 25));
    byId('play').textContent = 'pause';
    if (this.frame === data.frames.length - 1) {
      this.show(0);
    }
    this.timer = setInterval(() => {
      this.show((this.frame + 1) % data.frames.length);
    }, (1000 * seconds) / data.frames.length);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = 0;
    byId('play').textContent = 'play';
  }
}

try {
  new Page();
} catch (error) {
  trouble(`This page can't be shown (does the browser have WebGL?): ${error.message}`);
}
