// Solids and lines that are put between points.

import { Mesh, MeshStandardMaterial, SphereGeometry, Vector3 } from "three";
import {
  BoxGeometry,
  CanvasTexture,
  ConeGeometry,
  CylinderGeometry,
  Matrix4,
  NearestFilter,
  SRGBColorSpace,
} from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";

import { add, length, scaled, subtract } from "./frames.js";

const Y = new Vector3(0, 1, 0);
const CYLINDER = new CylinderGeometry(1, 1, 1, 40);
const SPHERE = new SphereGeometry(1, 32, 20);
const BOX = new BoxGeometry(1, 1, 1);
const CONE = new ConeGeometry(1, 1, 24);

export function material(color) {
  return new MeshStandardMaterial({ color, roughness: 0.55, metalness: 0.08 });
}

function solid(geometry, of, hasShadow = true) {
  const mesh = new Mesh(geometry, of);
  mesh.castShadow = hasShadow;
  mesh.receiveShadow = hasShadow;
  return mesh;
}

export const cylinder = (of, hasShadow) => solid(CYLINDER, of, hasShadow);
export const sphere = (of) => solid(SPHERE, of);
export const box = (of) => solid(BOX, of);
export const cone = (of) => solid(CONE, of, false);

/** Puts a solid whose length is along its y from one point to another; nothing where they are the same. */
export function span(mesh, from, to, radius) {
  const way = subtract(to, from);
  const size = length(way);
  mesh.visible = size > 1e-9;
  if (!mesh.visible) return;
  mesh.position.set(...add(from, scaled(way, 0.5)));
  mesh.quaternion.setFromUnitVectors(Y, new Vector3(...scaled(way, 1 / size)));
  mesh.scale.set(radius, size, radius);
}

/** Puts a solid at a point, its y along an axis. */
export function center(mesh, at, axis, height, radius) {
  const half = scaled(axis, height / 2);
  span(mesh, subtract(at, half), add(at, half), radius);
}

/** Puts a box at a point, by the axes of a frame. */
export function align(mesh, at, frame, [x, y, z]) {
  mesh.position.set(...at);
  const basis = [...frame.x, 0, ...frame.y, 0, ...frame.z, 0, 0, 0, 0, 1];
  mesh.quaternion.setFromRotationMatrix(new Matrix4().fromArray(basis));
  mesh.scale.set(x, y, z);
}

/** A line of some pixels' width, seen through what is in front of it where `isOnTop`. */
export function line(color, width, isOnTop = false) {
  const drawn = new Line2(new LineGeometry(), new LineMaterial({ color, linewidth: width }));
  drawn.frustumCulled = false;
  if (isOnTop) {
    drawn.material.depthTest = false;
    drawn.material.transparent = true;
    drawn.renderOrder = 2;
  }
  return drawn;
}

/** The points of a line; it is hidden where there are fewer than two. */
export function points(drawn, through) {
  drawn.visible = through.length > 1;
  if (!drawn.visible) return;
  drawn.geometry.dispose();
  drawn.geometry = new LineGeometry();
  drawn.geometry.setPositions(through.flat());
}

/** The sign of a centre of mass: a ball of quarters, black and white. */
export function massMaterial() {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [8, 4];
  const context = canvas.getContext("2d");
  for (let x = 0; x < 4; x++) {
    for (let y = 0; y < 2; y++) {
      context.fillStyle = (x + y) % 2 === 0 ? "#111418" : "#ffffff";
      context.fillRect(2 * x, 2 * y, 2, 2);
    }
  }
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  map.magFilter = NearestFilter;
  return new MeshStandardMaterial({ map, roughness: 0.6 });
}

