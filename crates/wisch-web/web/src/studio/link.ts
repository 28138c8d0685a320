// Cameras that move together: each looks at its surface from the same direction and distance.
import { Vector3 } from "three";
import type { Camera } from "../scene/camera.ts";
import type { Recording } from "../store.ts";

interface Linked {
  camera: Camera | null;
  recording: Recording;
}

/** Position of the surface, relative to which the camera moves. */
const anchorOf = ({ rounds }: Recording): Vector3 => new Vector3(...(rounds[0]?.plan.surface.pose.slice(0, 3) ?? []));

/** Lets every move of a camera move the others; returns a function that stops this. */
export function linkCameras(list: readonly Linked[]): () => void {
  let copying = false;
  const stops = list.map(({ camera, recording }) => {
    const moved = () => {
      if (copying || !camera) return;
      copying = true;
      for (const other of list) {
        if (!other.camera || other.camera === camera) continue;
        const shift = anchorOf(other.recording).sub(anchorOf(recording));
        other.camera.controls.target.copy(camera.controls.target).add(shift);
        other.camera.lens.position.copy(camera.lens.position).add(shift);
        other.camera.controls.update();
      }
      copying = false;
    };
    camera?.controls.addEventListener("change", moved);
    return () => camera?.controls.removeEventListener("change", moved);
  });
  return () => { for (const stop of stops) stop(); };
}
