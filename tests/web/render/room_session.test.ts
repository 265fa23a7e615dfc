import { afterEach, expect, test, vi } from "vitest";
import { RoomPlace } from "../../../web/src/render/room_session";

type Point = readonly [number, number, number];
const transform = ([x, y, z]: Point, up = 1) => ({
	position: { x, y, z },
	matrix: new Float32Array([1, 0, 0, 0, 0, up, 0, 0, 0, 0, 1, 0, x, y, z, 1]),
});

/** A frame in which the device is at `eye` and points at a surface; `up` is the upward part of the surface's normal. */
const frameWith = (eye: Point, surface?: Point, up = 1): XRFrame =>
	({
		getViewerPose: () => ({ transform: transform(eye) }),
		getHitTestResults: () => (surface ? [{ getPose: () => ({ transform: transform(surface, up) }) }] : []),
	}) as unknown as XRFrame;

/** Creates a place in a room, and reads the position and the turn of its space. */
function placeInRoom(low: number) {
	vi.stubGlobal(
		"XRRigidTransform",
		class {
			constructor(
				readonly at: { x: number; y: number; z: number },
				readonly turn: { y: number; w: number },
			) {}
		},
	);
	const room = { getOffsetReferenceSpace: (moved: unknown) => moved };
	const place = new RoomPlace(room as unknown as XRReferenceSpace, {} as XRHitTestSource, low);
	const space = () =>
		place.space as unknown as { at: { x: number; y: number; z: number }; turn: { y: number; w: number } };
	return { room, place, space };
}

afterEach(() => {
	vi.unstubAllGlobals();
});

test("the plant's lowest point is placed on the surface, and each further tap moves the plant", () => {
	const { place, space } = placeInRoom(-0.1);
	place.read(frameWith([0, 0, 0], [1, -1.5, -2]));
	expect(place.place()).toBe(true);
	expect(space().at).toEqual({ x: 1, y: -1.4, z: -2 });
	place.read(frameWith([0, 0, 0], [0, -1, -3]));
	expect(place.place()).toBe(true);
	expect(space().at).toEqual({ x: 0, y: -0.9, z: -3 });
});

test("the plant's front faces the device", () => {
	const { place, space } = placeInRoom(0);
	place.read(frameWith([2, 0, 0], [0, -1, 0]));
	place.place();
	expect(2 * Math.atan2(space().turn.y, space().turn.w)).toBeCloseTo(Math.PI / 2);
});

test("nothing is placed without a surface, or on a wall", () => {
	const { room, place } = placeInRoom(0);
	expect(place.read(frameWith([0, 0, 0]))).toBeUndefined();
	expect(place.place()).toBe(false);
	expect(place.read(frameWith([0, 0, 0], [0, 0, -1], 0.1))).toBeUndefined();
	expect(place.place()).toBe(false);
	expect(place.space).toBe(room);
	expect(place.isPlaced).toBe(false);
});
