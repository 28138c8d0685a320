// Dots of one size on the screen, and their textures.
import { BufferGeometry, CanvasTexture, Float32BufferAttribute, Points, PointsMaterial } from "three";
import { shiftDepth } from "./solids.ts";

/** Draws a square picture, at first in white, which colours tint. `look`: properties of its texture. */
export function drawTexture(draw: (pen: CanvasRenderingContext2D) => void, pixels = 64, look: Partial<CanvasTexture> = {}): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = pixels;
  const pen = canvas.getContext("2d")!;
  pen.fillStyle = pen.strokeStyle = "#fff";
  draw(pen);
  return Object.assign(new CanvasTexture(canvas), look);
}

/** Draws a dot with a dark rim. */
export const dotTexture = (): CanvasTexture => drawTexture((pen) => {
  pen.arc(32, 32, 24, 0, 2 * Math.PI);
  pen.fill();
  pen.lineWidth = 5;
  pen.strokeStyle = "#000";
  pen.stroke();
});

export type Dots = Points<BufferGeometry, PointsMaterial>;

/** Makes dots at points. `nearer`: factor of their depth, without which a surface would cut them in half. */
export function makeDots(points: number[], map: CanvasTexture, size: number, { nearer = 0.98, alphaTest = 0.3, renderOrder = 7, vertexColors = false } = {}): Dots {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  const dots = new Points(geometry, shiftDepth(new PointsMaterial({ size, sizeAttenuation: false, map, alphaTest, transparent: true, vertexColors }), nearer));
  dots.frustumCulled = false;
  dots.renderOrder = renderOrder;
  return dots;
}
