// Pointer and wheel on the timeline: drag to seek, or over the force to select an interval, wheel or two fingers to zoom, double-click to show the whole run.

/** Longest way of the pointer in a click [pixels]. */
const SLIP_PX = 4;

export interface Handlers {
  seek(x: number): void;
  /** Whether a drag that begins at a height selects an interval. */
  selectsAt(y: number): boolean;
  /** Selects the interval between two places; null ends the selection. */
  select(ends: [number, number] | null): void;
  hover(x: number | null): void;
  /** Zooms by a factor about x, then moves by `moved` [pixels]. */
  zoom(x: number, factor: number, moved: number): void;
  reset(): void;
}

export function listenPointer(element: HTMLElement, handlers: Handlers): void {
  const pointers = new Map<number, number>();
  let pinched = false;
  /** Where the drag of a selection began. */
  let begun: number | null = null;
  /** Pixels of the element, which the page may show magnified. */
  const xOf = (event: MouseEvent) => {
    const { left, width } = element.getBoundingClientRect();
    return (event.clientX - left) * (element.clientWidth / width || 1);
  };
  const measurePinch = () => {
    const [a = 0, b = 0] = [...pointers.values()];
    return { middle: (a + b) / 2, distance: Math.max(10, Math.abs(a - b)) };
  };

  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.target instanceof HTMLButtonElement) return;
    pointers.set(event.pointerId, xOf(event));
    element.setPointerCapture(event.pointerId);
    element.focus({ preventScroll: true });
    if (pointers.size === 1) {
      pinched = false;
      // A finger seeks everywhere, since the force has most of the room.
      const { top, height } = element.getBoundingClientRect();
      begun = event.pointerType !== "touch" && handlers.selectsAt((event.clientY - top) * (element.clientHeight / height || 1)) ? xOf(event) : null;
      handlers.select(null);
      handlers.seek(xOf(event));
    } else pinched = true;
  });
  element.addEventListener("pointermove", (event) => {
    if (!pointers.has(event.pointerId)) {
      handlers.hover(xOf(event));
      return;
    }
    const before = measurePinch();
    pointers.set(event.pointerId, xOf(event));
    if (pointers.size === 2) {
      const now = measurePinch();
      handlers.zoom(before.middle, before.distance / now.distance, now.middle - before.middle);
    } else if (!pinched) {
      if (begun === null) handlers.seek(xOf(event));
      else if (Math.abs(xOf(event) - begun) > SLIP_PX) handlers.select([begun, xOf(event)]);
      handlers.hover(xOf(event));
    }
  });
  const up = (event: PointerEvent) => {
    pointers.delete(event.pointerId);
    if (event.pointerType !== "mouse") handlers.hover(null);
  };
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  element.addEventListener("pointerleave", () => handlers.hover(null));
  element.addEventListener("dblclick", () => handlers.reset());
  element.addEventListener("wheel", (event) => {
    const { scrollHeight, clientHeight } = document.documentElement;
    const sideways = Math.abs(event.deltaX) > Math.abs(event.deltaY) || event.shiftKey;
    const held = event.ctrlKey || sideways || element.contains(document.activeElement) || scrollHeight <= clientHeight + 1;
    if (!held) return;
    event.preventDefault();
    const delta = event.shiftKey && !event.deltaX ? event.deltaY : sideways ? event.deltaX : event.deltaY;
    if (sideways) handlers.zoom(xOf(event), 1, -delta);
    else handlers.zoom(xOf(event), Math.exp(Math.max(-1, Math.min(1, delta * 0.002))), 0);
  }, { passive: false });
}
