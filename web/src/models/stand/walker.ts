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

/** Rotation of a step to the side and up, and limit of the view direction above and below the horizon; degrees. */
const TURN = 12;
const TILT = 8;
const STEEPEST = 60;
/** Eye height, metres. */
const EYE = 1.65;
/** Limit of the eye height as a share of the ground's longer side: over a small bed, it is that of a kneeling person. */
const MAX_EYE_SHARE = 0.05;

/** Distance of the start position before the ground's centre, as a share of the ground's depth. */
const START_FRONT = 0.48;
/** Width of the range of candidates for the start position, as a share of the ground's width, and their number. */
const START_RANGE = 0.8;
const CANDIDATES = 40;
/** Distance from the nearest crown that suffices, metres. */
const ENOUGH_ROOM = 3;

type Grounded = Pick<StandPlant, "ground" | "meshes">;

/** Returns the height of a walker's eyes over a ground, metres. */
export function eyeHeight({ ground }: Pick<StandPlant, "ground">): number {
	return Math.min(EYE, MAX_EYE_SHARE * Math.max(ground.width, ground.depth));
}

/** Returns a start at the front of the ground with enough room between crowns, as close to the middle as possible. */
export function atFront(stand: Pick<StandPlant, "ground" | "places" | "kinds">): StandPose {
	const { width, depth } = stand.ground;
	const z = START_FRONT * depth;
	let best = { x: 0, room: Number.NEGATIVE_INFINITY };
	for (let i = 0; i <= CANDIDATES; i++) {
		// From the middle outwards, alternating sides.
		const x = ((i % 2 === 0 ? 0.5 : -0.5) * START_RANGE * width * Math.ceil(i / 2) * 2) / CANDIDATES;
		const room = Math.min(ENOUGH_ROOM, roomAt(stand, x, z));
		if (room > best.room) best = { x, room };
	}
	return { x: best.x, z, yaw: 0, pitch: 0 };
}

/** Returns the distance of a point on the ground to the nearest crown, metres; negative inside a crown. */
function roomAt({ kinds, places }: Pick<StandPlant, "places" | "kinds">, x: number, z: number): number {
	let room = Number.POSITIVE_INFINITY;
	for (let plant = 0; plant < places.count; plant++) {
		if (places.parent[plant] >= 0) continue;
		const crown = 0.5 * kinds[places.kind[plant]].crown.width * places.scale[plant];
		room = Math.min(room, Math.hypot(places.at[3 * plant] - x, places.at[3 * plant + 2] - z) - crown);
	}
	return room;
}

/** Returns the pose after one step: half the eye height long, within the ground. */
export function stepped(pose: StandPose, step: StandStep, stand: Pick<StandPlant, "ground">): StandPose {
	if (step === "turn left" || step === "turn right")
		return { ...pose, yaw: pose.yaw + (step === "turn left" ? -TURN : TURN) };
	if (step === "look up" || step === "look down") return turned(pose, 0, step === "look up" ? TILT : -TILT);
	const direction = { forward: 0, right: 90, back: 180, left: -90 }[step];
	const heading = ((pose.yaw + direction) * Math.PI) / 180;
	const length = 0.5 * eyeHeight(stand);
	const insideGround = (value: number, size: number) => Math.min(0.5 * size, Math.max(-0.5 * size, value));
	return {
		...pose,
		x: insideGround(pose.x + length * Math.sin(heading), stand.ground.width),
		z: insideGround(pose.z - length * Math.cos(heading), stand.ground.depth),
	};
}

/** Turns the view by degrees to the right and up, within the limits of the view direction. */
export function turned(pose: StandPose, right: number, up: number): StandPose {
	return { ...pose, yaw: pose.yaw + right, pitch: Math.min(STEEPEST, Math.max(-STEEPEST, pose.pitch + up)) };
}

/** Returns the position of a walker's eye, and a point that it looks at, metres. */
export function gazeOf(pose: StandPose, stand: Grounded) {
	const y = heightAt(stand, pose.x, pose.z) + eyeHeight(stand);
	const [yaw, pitch] = [(pose.yaw * Math.PI) / 180, (pose.pitch * Math.PI) / 180];
	const [sideways, forwards] = [Math.sin(yaw) * Math.cos(pitch), Math.cos(yaw) * Math.cos(pitch)];
	return {
		eye: [pose.x, y, pose.z],
		towards: [pose.x + sideways, y + Math.sin(pitch), pose.z - forwards],
	} as const;
}
