// The train in three dimensions. Where it cannot be shown the still picture stays, and a line says so.

const EDGE_ANGLE = 32;   // degrees between two faces, from which on their edge is drawn
const NEAR = 12;         // px beside a part that a click still hits
const LONGEST = 3600;    // s of a period that the slider covers
const STRETCH = 60;      // s that it covers where there is no such period
const LIT = 0x2a68e4, EDGE = 0x20242a;


// Blocks of whole four bytes, one after the other, as core/presentation/handout/page_scene.h has them.
const readSolids = (buffer, solids) => {
  let at = 0;
  const block = (Type, count) => {
    const values = new Type(buffer, at, count);
    at += Math.ceil(values.byteLength / 4) * 4;
    return values;
  };
  return solids.map(({vertices, triangles, low, high}) => {
    const steps = block(Uint16Array, 3 * vertices);
    const folded = block(Int8Array, 2 * vertices);
    const indices = block(vertices > 65536 ? Uint32Array : Uint16Array, 3 * triangles);
    const positions = new Float32Array(3 * vertices);
    for (let i = 0; i < positions.length; ++i) positions[i] = low[i % 3] + (high[i % 3] - low[i % 3]) * steps[i] / 65535;
    const normals = new Float32Array(3 * vertices);
    for (let i = 0; i < vertices; ++i) {
      let x = folded[2 * i] / 127, y = folded[2 * i + 1] / 127;
      const z = 1 - Math.abs(x) - Math.abs(y);
      if (z < 0) [x, y] = [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)];
      const length = Math.hypot(x, y, z) || 1;
      normals.set([x / length, y / length, z / length], 3 * i);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
    geometry.setIndex(new THREE.BufferAttribute(indices, 1));
    return geometry;
  });
};

const matrixOf = ({r, t}) =>
    new THREE.Matrix4().set(r[0], r[1], r[2], t[0], r[3], r[4], r[5], t[1], r[6], r[7], r[8], t[2], 0, 0, 0, 1);

// A disc with a text that faces the viewer.
const discOf = ({text, colour}) => {
  const side = 128;
  const canvas = make('canvas');
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d');
  context.beginPath();
  context.arc(side / 2, side / 2, side / 2 - 8, 0, 2 * Math.PI);
  context.fillStyle = '#ffffff';
  context.fill();
  context.lineWidth = 12;
  context.strokeStyle = colour;
  context.stroke();
  context.fillStyle = '#1d2126';
  context.font = `bold ${text.length > 2 ? 46 : 64}px "DejaVu Sans", Helvetica, Arial, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(text, side / 2, side / 2 + 4);
  const disc = new THREE.Sprite(new THREE.SpriteMaterial(
      {map: new THREE.CanvasTexture(canvas), depthTest: false, sizeAttenuation: false}));
  disc.scale.setScalar(0.034);
  disc.renderOrder = 1;
  return disc;
};

const showScene = async place => {
  const {parts, labels, solids, unit} = data.scene;
  const geometries = readSolids(await unpacked(byId('geometry').textContent.trim()), solids);
  const edges = geometries.map(() => null);
  const canvas = make('canvas', {tabindex: '0', role: 'img',
    'aria-label': say('trainKeys')});
  const renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true});
  renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
  const scene = new THREE.Scene();
  scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8f98, 2.1));
  const sun = new THREE.DirectionalLight(0xffffff, 2.2);
  scene.add(sun);

  const box = new THREE.Box3();
  const corners = [];  // of the box of each part
  const meshes = parts.map(part => {
    const solid = geometries[part.solid];
    const mesh = new THREE.Mesh(solid, new THREE.MeshStandardMaterial(
        {color: part.colour, roughness: 0.55, metalness: 0.15, side: part.open ? THREE.DoubleSide : THREE.FrontSide}));
    edges[part.solid] ||= new THREE.EdgesGeometry(solid, EDGE_ANGLE);
    mesh.add(new THREE.LineSegments(edges[part.solid],
                                    new THREE.LineBasicMaterial({color: EDGE, transparent: true, opacity: 0.4})));
    mesh.matrixAutoUpdate = false;
    mesh.userData = part;
    mesh.userData.home = matrixOf({r: part.pose.slice(0, 9), t: part.pose.slice(9)});
    mesh.matrix.copy(mesh.userData.home);
    mesh.updateMatrixWorld(true);
    const own = new THREE.Box3().expandByObject(mesh);
    for (let i = 0; i < 8; ++i)
      corners.push(new THREE.Vector3(...[0, 1, 2].map(k => ((i >> k) & 1 ? own.max : own.min).getComponent(k))));
    box.union(own);
    scene.add(mesh);
    return mesh;
  });
  const discs = labels.map(label => {
    const disc = discOf(label);
    disc.userData = label;
    scene.add(disc);
    return disc;
  });

  const sphere = box.getBoundingSphere(new THREE.Sphere());
  const camera = new THREE.PerspectiveCamera(30, 1.5, sphere.radius / 50, sphere.radius * 60);
  camera.up.set(0, 0, 1);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.enablePan = true;
  const VIEWS = {'3D': [0.62, -0.66, 0.42], x: [1, 0, 0], y: [0, -1, 0], z: [0, -0.001, 1]};
  // As near as the corners of all parts' boxes are in view, in its middle, with room for what swings.
  const look = name => {
    const direction = new THREE.Vector3(...VIEWS[name]).normalize();
    const right = new THREE.Vector3().crossVectors(camera.up, direction).normalize();
    const above = new THREE.Vector3().crossVectors(direction, right);
    const half = Math.tan(camera.fov * Math.PI / 360);
    const target = sphere.center.clone();
    for (const axis of [right, above]) {
      const places = corners.map(corner => corner.clone().sub(sphere.center).dot(axis));
      target.addScaledVector(axis, (Math.min(...places) + Math.max(...places)) / 2);
    }
    let distance = 0;
    for (const each of corners) {
      const corner = each.clone().sub(target);
      const wide = Math.max(Math.abs(corner.dot(right)) / camera.aspect, Math.abs(corner.dot(above)));
      distance = Math.max(distance, corner.dot(direction) + 1.12 * wide / half);
    }
    controls.target.copy(target);
    camera.position.copy(target).addScaledVector(direction, distance);
    controls.update();
    render();
  };

  const offset = new THREE.Vector3();
  const render = () => {
    sun.position.copy(camera.position).add(offset.set(0, 0, sphere.radius));
    renderer.render(scene, camera);
  };
  const pose = () => {
    const links = motion && data.movers ? posesOf(data.movers, motion.angles()).map(matrixOf) : null;
    for (const mesh of meshes) {
      mesh.matrix.copy(mesh.userData.home);
      if (links) mesh.matrix.premultiply(links[mesh.userData.link]);
      mesh.matrixWorldNeedsUpdate = true;
    }
    for (const disc of discs)
      disc.position.set(...disc.userData.place).applyMatrix4(meshes[disc.userData.part].matrix);
    render();
  };
  // What is selected keeps its colour and gets blue edges; all others step back.
  const light = key => {
    const isIn = mesh => key !== null && mesh.userData.elements.includes(key);
    const isAny = meshes.some(isIn);
    const isDark = getComputedStyle(document.documentElement).colorScheme === 'dark';
    const pale = meshes[0].material.color.clone().setHex(isDark ? 0x39414b : 0xd5dae2);
    for (const mesh of meshes) {
      const [isLit, isPale] = [isIn(mesh), isAny && !isIn(mesh)];
      mesh.material.color.set(mesh.userData.colour);
      if (isPale) mesh.material.color.lerp(pale, 0.7);
      const edge = mesh.children[0].material;
      edge.color.setHex(isLit ? LIT : EDGE);
      edge.opacity = isLit ? 0.9 : isPale ? 0.15 : 0.4;
    }
    for (const disc of discs) disc.material.opacity = isAny && !isIn(meshes[disc.userData.part]) ? 0.35 : 1;
    render();
  };

  // ---- What is under the pointer ----
  const ray = new THREE.Raycaster();
  const hitAt = (x, y) => {
    const {left, top, width, height} = canvas.getBoundingClientRect();
    ray.setFromCamera(new THREE.Vector2(2 * (x - left) / width - 1, 1 - 2 * (y - top) / height), camera);
    const disc = ray.intersectObjects(discs.filter(each => each.visible))[0];
    if (disc) return disc.object.userData.element;
    const mesh = ray.intersectObjects(meshes, false)[0];
    return mesh ? mesh.object.userData.elements[0] : null;
  };
  let pressed = null;
  canvas.addEventListener('pointerdown', event => { pressed = [event.clientX, event.clientY]; });
  canvas.addEventListener('pointerup', event => {
    const [x, y] = pressed || [NaN, NaN];
    if (!(Math.hypot(event.clientX - x, event.clientY - y) < 5)) return;
    let key = hitAt(x, y);
    for (let i = 0; !key && i < 8; ++i) key = hitAt(x + NEAR * Math.cos(i * Math.PI / 4), y + NEAR * Math.sin(i * Math.PI / 4));
    select(key);
  });

  // ---- Time ----
  const status = make('p', {class: 'time', role: 'status'});
  const play = make('button', {type: 'button'}, '\u25b6 ' + say('play'));
  const scrub = make('input', {type: 'range', min: '0', max: '1000', step: '1', 'aria-label': say('time')});
  const toStart = make('button', {type: 'button', 'aria-label': say('toReference')}, '|\u25c0');
  const seconds = time => 2 * Math.PI * time;
  const hasPeriod = () => motion.period !== null && seconds(motion.period.toNumber()) <= LONGEST;
  const span = () => (hasPeriod() ? motion.period.toNumber() : STRETCH / (2 * Math.PI));
  const showTime = () => {
    const time = motion.time.toNumber();
    const along = ((time % span()) + span()) % span();
    scrub.value = String(Math.round(1000 * along / span()));
    const [passed, whole] = [along, span()].map(each => spoken(seconds(each).toFixed(1)));
    const text = hasPeriod() ? say('secondsOf', passed, whole) : say('seconds', passed);
    scrub.setAttribute('aria-valuetext', text);
    scrub.title = text;
  };
  let last = null;  // when the last frame of a playback was painted; null: it rests
  let direction = 1;  // of a playback, which turns round at the limits of joints
  const goTo = time => {
    const joint = motion.goTo(time);
    if (joint >= 0) {
      const {name, low, high} = data.joints[joint];
      const angle = ratesOf(gains, motion.inputTurns())[joint].toNumber() * 360;
      const limit = [low, high].filter(each => each !== undefined).map(each => each * 180 / Math.PI)
                        .sort((a, b) => Math.abs(a - angle) - Math.abs(b - angle))[0];
      const degrees = limit.toFixed(0);
      status.textContent = last === null ? say('atLimit', name, degrees) : say('turnsRound', name, degrees);
    } else if (last === null) {
      status.textContent = '';
    }
    pose();
    showTime();
    return joint < 0;
  };
  const rest = () => {
    last = null;
    play.textContent = '\u25b6 ' + say('play');
  };
  const frame = now => {
    if (last === null) return;
    const step = Math.min(100, now - last) / 1000;
    last = now;
    const isFree = goTo(motion.time.toNumber() + direction * step / (2 * Math.PI));
    if (!isFree) direction = -direction;
    requestAnimationFrame(frame);
  };
  const toggle = () => {
    if (last !== null) return rest();
    last = performance.now();
    direction = 1;
    play.textContent = '\u23f8 ' + say('pause');
    requestAnimationFrame(frame);
  };
  play.addEventListener('click', toggle);
  scrub.addEventListener('input', () => { rest(); goTo(Number(scrub.value) / 1000 * span()); });
  toStart.addEventListener('click', () => { rest(); motion.toReference(); goTo(0); });

  // ---- Keys ----
  const turn = (azimuth, polar) => {
    const at = new THREE.Spherical().setFromVector3(offset.copy(camera.position).sub(controls.target)
                                                        .applyQuaternion(new THREE.Quaternion().setFromUnitVectors(camera.up, new THREE.Vector3(0, 1, 0))));
    at.theta += azimuth;
    at.phi = Math.max(0.01, Math.min(Math.PI - 0.01, at.phi + polar));
    offset.setFromSpherical(at).applyQuaternion(new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), camera.up));
    camera.position.copy(controls.target).add(offset);
    controls.update();
    render();
  };
  const zoom = factor => {
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    controls.update();
    render();
  };
  const step = direction => { rest(); goTo(motion.time.toNumber() + direction * 0.02); };
  const keys = {ArrowLeft: () => turn(-0.15, 0), ArrowRight: () => turn(0.15, 0), ArrowUp: () => turn(0, -0.15),
                ArrowDown: () => turn(0, 0.15), '+': () => zoom(0.9), '=': () => zoom(0.9), '-': () => zoom(1 / 0.9)};
  if (motion) Object.assign(keys, {' ': toggle, ',': () => step(-1), '.': () => step(1)});
  canvas.addEventListener('keydown', event => {
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    action();
  });

  // ---- Into the page ----
  const still = place.querySelector('img');
  const fit = () => {
    const width = place.clientWidth;
    if (!width) return;
    const height = Math.min(Math.round(width / 1.5), Math.round(0.6 * window.innerHeight));  // as the style has it
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    render();
  };
  if (still) still.hidden = true;
  place.prepend(canvas);
  new ResizeObserver(fit).observe(place);
  window.addEventListener('resize', fit);
  fit();
  look('3D');
  pose();
  const views = Object.keys(VIEWS).map(name => {
    const button = make('button', {type: 'button', 'aria-label': name === '3D' ? say('wholeTrain') : say('alongAxis', name)},
                        name === '3D' ? say('view3d') : name);
    button.addEventListener('click', () => look(name));
    return button;
  });
  const named = make('button', {type: 'button', 'aria-pressed': 'true'}, say('labels'));
  named.addEventListener('click', () => {
    const on = named.getAttribute('aria-pressed') !== 'true';
    named.setAttribute('aria-pressed', String(on));
    for (const disc of discs) disc.visible = on;
    render();
  });
  const controlsOfTime = motion ? [make('div', {class: 'bar'}, toStart, play, scrub), status] : [];
  place.append(make('div', {class: 'bar views'}, make('span', {class: 'unit'}, say('unit', unit)), ...views, named));
  place.after(...controlsOfTime);
  controls.addEventListener('change', render);
  watchers.push(light);
  motionWatchers.push(() => { pose(); showTime(); });
  if (motion) showTime();

  canvas.addEventListener('webglcontextlost', event => {
    event.preventDefault();
    canvas.hidden = true;
    if (still) still.hidden = false;
  });
  canvas.addEventListener('webglcontextrestored', () => {
    canvas.hidden = false;
    if (still) still.hidden = true;
    render();
  });
  const printed = make('img', {alt: say('train'), class: 'printed', hidden: ''});
  place.append(printed);
  window.addEventListener('beforeprint', () => {
    render();
    printed.src = canvas.toDataURL();
    printed.hidden = false;
  });
  window.addEventListener('afterprint', () => { printed.hidden = true; });
};

if (data.scene) {
  const place = byId('scene');
  showScene(place).catch(error => {
    const still = place.querySelector('img');
    for (const canvas of place.querySelectorAll('canvas')) canvas.remove();
    if (still) still.hidden = false;
    place.after(make('p', {class: 'reason', role: 'status'},
                     say('noScene', error.message)));
  });
}
