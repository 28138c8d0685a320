// The scale of the map of base poses.
import { el, makeSwatches, percent } from "./dom.ts";

/** Number of colours of the scale. */
export const REACH_BANDS = 8;

/** Returns the band of a share in reach, from 0. */
export const reachBand = (share: number): number => Math.min(REACH_BANDS - 1, Math.max(0, Math.floor(share * REACH_BANDS)));

/** Makes the scale of the map of base poses. */
export const makeReachScale = (): HTMLElement =>
  el("div", { class: "w-scale w-reach" }, el("b", {}, "Base poses"),
    makeSwatches(Array.from({ length: REACH_BANDS }, (_, i) => ({ colour: `band-${i + 1}`, label: `\u2265 ${percent(i / REACH_BANDS, i % 2)}` })), "Scale in percent"),
    el("p", {}, "share of the path that is in reach; grey: chosen without being rated; the tip points where the base faces; ringed: chosen, in order"));
