/** A walker on a stand's ground: position and view direction. Pure. */
import { heightAt } from "./ground_grid";
import type { StandPlant } from "./stand_plant";

export interface StandPose {
	/** Position, metres. */
	readonly x: number;
	readonly z: number;
	/** View direction: degrees from −z to +x, and above the horizon. */
	readonly yaw: number;
	readonly pitch: number;
}

export type StandStep = "forward" | "back" | "left" | "right" | "turn left" | "turn right" | "look up" | "look down";

/** Rotation of a step, degrees. */
const TURN = 12;
const TILT = 8;
const STEEPEST = 60;
/**
 * Eye height, metres, and its limit as a share of the ground's longer side: over a small bed, that of a kneeling
 * person.
 */
const EYE = 1.65;
const SHARE = 0.05;

/**
 * Start position: distance before the ground's centre, as a share of its depth, and the range of candidates, as a
 * share of its width.
 */
const FRONT = 0.48;
const ALONG = 0.8;
const PLACES = 40;
/** Distance from the nearest crown that suffices, metres. */
const CLEAR = 3;

type Grounded = Pick<StandPlant, "ground" | "meshes">;

/** Eye height over a ground. */
export function eyeHeight({ ground }: Pick<StandPlant, "ground">): number {
	return Math.min(EYE, SHARE * Math.max(ground.width, ground.depth));
}

/** A start at the front of the ground with enough room between crowns, as close to the middle as possible. */
export function atFront(stand: Pick<StandPlant, "ground" | "places" | "kinds">): StandPose {
	const { width, depth } = stand.ground;
	const z = FRONT * depth;
	let best = { x: 0, room: Number.NEGATIVE_INFINITY };
	for (let i = 0; i <= PLACES; i++) {
		// From the middle outwards, alternating sides.
		const x = ((i % 2 === 0 ? 0.5 : -0.5) * ALONG * width * Math.ceil(i / 2) * 2) / PLACES;
		const room = Math.min(CLEAR, roomAt(stand, x, z));
		if (room > best.room) best = { x, room };
	}
	return { x: best.x, z, yaw: 0, pitch: 0 };
}

/** Distance to the nearest crown on the ground, metres; negative inside a crown. */
function roomAt({ kinds, places }: Pick<StandPlant, "places" | "kinds">, x: number, z: number): number {
	let room = Number.POSITIVE_INFINITY;
	for (let plant = 0; plant < places.count; plant++) {
		if (places.parent[plant] >= 0) continue;
		const crown = 0.5 * kinds[places.kind[plant]].crown.width * places.scale[plant];
		room = Math.min(room, Math.hypot(places.at[3 * plant] - x, places.at[3 * plant + 2] - z) - crown);
	}
	return room;
}

/** One step: half the eye height long, within the ground. */
export function stepped(pose: StandPose, step: StandStep, stand: Pick<StandPlant, "ground">): StandPose {
	if (step === "turn left" || step === "turn right")
		return { ...pose, yaw: pose.yaw + (step === "turn left" ? -TURN : TURN) };
	if (step === "look up" || step === "look down") return turned(pose, 0, step === "look up" ? TILT : -TILT);
	const way = { forward: 0, right: 90, back: 180, left: -90 }[step];
	const towards = ((pose.yaw + way) * Math.PI) / 180;
	const length = 0.5 * eyeHeight(stand);
	const within = (value: number, size: number) => Math.min(0.5 * size, Math.max(-0.5 * size, value));
	return {
		...pose,
		x: within(pose.x + length * Math.sin(towards), stand.ground.width),
		z: within(pose.z - length * Math.cos(towards), stand.ground.depth),
	};
}

/** Rotates by degrees to the right and up. */
export function turned(pose: StandPose, right: number, up: number): StandPose {
	return { ...pose, yaw: pose.yaw + right, pitch: Math.min(STEEPEST, Math.max(-STEEPEST, pose.pitch + up)) };
}

/** Position of the eye, and the point that it looks at. */
export function gazeOf(pose: StandPose, stand: Grounded) {
	const y = heightAt(stand, pose.x, pose.z) + eyeHeight(stand);
	const [yaw, pitch] = [(pose.yaw * Math.PI) / 180, (pose.pitch * Math.PI) / 180];
	const [sideways, forth] = [Math.sin(yaw) * Math.cos(pitch), Math.cos(yaw) * Math.cos(pitch)];
	return {
		eye: [pose.x, y, pose.z],
		towards: [pose.x + sideways, y + Math.sin(pitch), pose.z - forth],
	} as const;
}
