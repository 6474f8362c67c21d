// The room that the arm stands in: camera, light, ground, and what draws them when something has changed.

import {
  Color,
  DirectionalLight,
  GridHelper,
  HemisphereLight,
  Mesh,
  PerspectiveCamera,
  PlaneGeometry,
  Quaternion,
  Scene,
  ShadowMaterial,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { add, cross, dot, length, scaled, subtract, turned, unit } from "./frames.js";

/** Two directions across a third one, which with it are a right-handed frame. */
export function across(up) {
  const start = Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const first = unit(subtract(start, scaled(up, dot(start, up))));
  return [first, cross(up, first)];
}

/** The room of a canvas, `up` away from the ground, for an arm of a length; null without WebGL. */
export function room(canvas, up, size) {
  let renderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  } catch {
    return null;
  }
  renderer.shadowMap.enabled = true;
  const scene = new Scene();
  const camera = new PerspectiveCamera(32, 1, size / 100, size * 60);
  camera.up.set(...up);
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = false;
  controls.minDistance = size / 10;
  controls.maxDistance = size * 20;

  const sky = new HemisphereLight(0xffffff, 0x8d99a8, 1.6);
  sky.position.set(...up);
  const [first, second] = across(up);
  const sun = new DirectionalLight(0xffffff, 2.2);
  const way = add(add(scaled(up, 2.2), scaled(first, 0.9)), scaled(second, -1.1));
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  sun.shadow.radius = 5;
  sun.shadow.bias = -0.0005;
  sun.shadow.normalBias = size / 200;
  Object.assign(sun.shadow.camera, {
    left: -1.6 * size,
    right: 1.6 * size,
    top: 1.6 * size,
    bottom: -1.6 * size,
    near: 0.1 * size,
    far: 8 * size,
  });
  scene.add(sky, sun, sun.target);

  const upright = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...up));
  const shadow = new Mesh(new PlaneGeometry(12 * size, 12 * size), new ShadowMaterial({ opacity: 0.16 }));
  shadow.quaternion.copy(upright);
  shadow.receiveShadow = true;
  scene.add(shadow);
  let grid = null;

  let isAsked = false;
  const onDraw = [];
  const draw = () => {
    isAsked = false;
    renderer.render(scene, camera);
    onDraw.forEach((called) => called());
  };
  const ask = () => {
    if (!isAsked) requestAnimationFrame(draw);
    isAsked = true;
  };
  controls.addEventListener("change", ask);

  const resize = () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0 || height === 0) return;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    ask();
  };
  new ResizeObserver(resize).observe(canvas);

  return {
    scene,
    camera,
    canvas,
    ask,
    onDraw: (called) => onDraw.push(called),

    /** The ground at a height below a place, with light from above it. */
    ground(place, height, lines, isSolid = true) {
      shadow.visible = isSolid;
      const below = add(place, scaled(up, height - dot(place, up)));
      shadow.position.set(...below);
      sun.target.position.set(...place);
      sun.position.set(...add(place, scaled(unit(way), 4 * size)));
      if (grid) scene.remove(grid);
      const cell = 10 ** Math.floor(Math.log10(size / 2));
      const step = [1, 2, 5, 10].map((k) => k * cell).find((width) => width >= size / 8);
      const count = 2 * Math.ceil((2 * size) / step);
      grid = new GridHelper(count * step, count, new Color(lines[0]), new Color(lines[1]));
      grid.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...up));
      grid.position.set(...add(below, scaled(up, -size / 500)));
      scene.add(grid);
      ask();
      return step;
    },

    /** Looks along a direction at points, so that all of them are seen. */
    look(direction, points) {
      resize();
      const corners = [0, 1, 2].map((k) => points.map((p) => p[k]));
      const center = corners.map((values) => (Math.min(...values) + Math.max(...values)) / 2);
      const radius = Math.max(...points.map((p) => length(subtract(p, center))), size / 8);
      const half = (camera.fov * Math.PI) / 360;
      const narrow = Math.min(half, Math.atan(Math.tan(half) * camera.aspect));
      const away = (1.12 * radius) / Math.sin(narrow);
      camera.position.set(...add(center, scaled(unit(direction), away)));
      controls.target.set(...center);
      controls.update();
      ask();
    },

    /** Goes by a way, with the light. */
    follow(way) {
      for (const { position } of [camera, sun, sun.target]) position.set(...add(position.toArray(), way));
      controls.target.set(...add(controls.target.toArray(), way));
      controls.update();
      ask();
    },

    /** Turns the view about what is looked at, by angles about the upright and the level axis. */
    turn(about, over) {
      const target = controls.target.toArray();
      const away = subtract(camera.position.toArray(), target);
      const side = unit(cross(up, away));
      const tilted = turned(turned(away, up, about), side, -over);
      // Not over the top.
      if (length(cross(unit(tilted), up)) < 0.05) return;
      camera.position.set(...add(target, tilted));
      controls.update();
      ask();
    },

    /** Comes nearer by a factor below 1. */
    zoom(factor) {
      const target = controls.target.toArray();
      const away = subtract(camera.position.toArray(), target);
      camera.position.set(...add(target, scaled(away, factor)));
      controls.update();
      ask();
    },

    /** The point under a place on the canvas that is as deep as `p`. */
    under([x, y], p) {
      const { clientWidth: width, clientHeight: height } = canvas;
      const { z } = new Vector3(...p).project(camera);
      return new Vector3((2 * x) / width - 1, 1 - (2 * y) / height, z).unproject(camera).toArray();
    },

    /** While something is dragged the view stays. */
    hold(isHeld) {
      controls.enabled = !isHeld;
    },

    /** Where a point is on the canvas, in pixels; null behind the camera. */
    onCanvas(p) {
      const seen = new Vector3(...p).project(camera);
      if (seen.z > 1) return null;
      const { clientWidth: width, clientHeight: height } = canvas;
      return [((seen.x + 1) / 2) * width, ((1 - seen.y) / 2) * height];
    },
  };
}
