/** Which plants can be game trees. */
import type { Wooden } from "../../plant/wood/wooden";

/** Fewer leaves are not worth a picture. */
export const LEAST_LEAVES = 200;

/** Returns whether a plant has wood and enough leaves for a tree of cards. */
export const hasCrown = ({ segments, organs, vertexSegments }: Wooden): boolean =>
	vertexSegments !== undefined && segments.count > 0 && organs.count >= LEAST_LEAVES;
