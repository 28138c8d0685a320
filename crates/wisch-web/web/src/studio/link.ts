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
        const { target, eye } = camera.view;
        other.camera.followLinked({ target: target.add(shift), eye: eye.add(shift) }, camera.asked);
      }
      copying = false;
    };
    camera?.controls.addEventListener("change", moved);
    return () => camera?.controls.removeEventListener("change", moved);
  });
  return () => { for (const stop of stops) stop(); };
}
