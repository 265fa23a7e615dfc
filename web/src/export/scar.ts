/** Where on the shared berry the tip scar is: v runs from the pedicel's seat (0) to the scar (1). */
const SCAR_BEGINS = 0.94;
/** About six degrees from the tip: the dried style within its dimple (models/bunch/fruit/berry.cpp). */
const SCAR_FULL = 0.967;

/** How much of the scar there is at `v`: 0 skin … 1 scar, with a soft edge. */
export function scarShare(v: number): number {
	const t = Math.min(1, Math.max(0, (v - SCAR_BEGINS) / (SCAR_FULL - SCAR_BEGINS)));
	return t * t * (3 - 2 * t);
}
