// Dots of one size on the screen, and drawn textures: those of dots, and the grain of a wooden board.
import { BufferGeometry, CanvasTexture, Float32BufferAttribute, Points, PointsMaterial, RepeatWrapping, SRGBColorSpace, Vector2 } from "three";
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

/** Size of the picture [pixels], and of what it covers [m]. */
const SIZE_PX = 256;
const SIZE_M = 0.24;
/** Number of strips that the board is glued from, and their largest darkening and that of the grain [1]. */
const STRIPS = 4;
const STRIP_SHADE = 0.04;
const GRAIN_SHADE = 0.05;

let texture: CanvasTexture | null = null;

/** Returns shades of white, by which the colour of the board is multiplied; coordinates are in metres. */
export function woodTexture(): CanvasTexture {
  return (texture ??= drawTexture(drawWood, SIZE_PX, { wrapS: RepeatWrapping, wrapT: RepeatWrapping, colorSpace: SRGBColorSpace, anisotropy: 4, repeat: new Vector2(1 / SIZE_M, 1 / SIZE_M) }));
}

function drawWood(pen: CanvasRenderingContext2D): void {
  const picture = pen.createImageData(SIZE_PX, SIZE_PX);
  for (let y = 0; y < SIZE_PX; y++) for (let x = 0; x < SIZE_PX; x++) {
    const strip = Math.floor((STRIPS * y) / SIZE_PX);
    // Waves along x have whole periods, so that the picture repeats without a seam.
    const turn = (2 * Math.PI * x) / SIZE_PX;
    const across = y + 5 * Math.sin(turn + 2.1 * strip) + 2 * Math.sin(2 * turn + strip);
    const grain = 0.5 + 0.25 * Math.sin(0.55 * across + 3 * strip) + 0.25 * Math.sin(1.63 * across + strip);
    const seam = (STRIPS * y) % SIZE_PX < STRIPS ? 0.06 : 0;
    const shade = 255 * (1 - STRIP_SHADE * Math.abs(Math.sin(5.3 * strip + 1)) - GRAIN_SHADE * grain ** 3 - seam);
    picture.data.set([shade, shade, shade, 255], 4 * (SIZE_PX * y + x));
  }
  pen.putImageData(picture, 0, 0);
}
