/** Someone who walks over a stand's ground: where they stand and which way they look. Pure. */
import type { StandPlant } from "./stand_plant";

export interface Pose {
	/** Metres. */
	readonly x: number;
	readonly z: number;
	/** Where they look: degrees from −z to +x, and above the horizon. */
	readonly yaw: number;
	readonly pitch: number;
}

export type Step = "forward" | "back" | "left" | "right" | "turn left" | "turn right" | "look up" | "look down";

/** Degrees of a step that turns. */
const TURN = 12;
const TILT = 8;
const STEEPEST = 60;
/** Eyes are so high, metres; over a bed no larger than a table it is that of who kneels there. */
const EYE = 1.65;
const SHARE = 0.05;

type Grounded = Pick<StandPlant, "ground" | "meshes">;

/** How high eyes are over a ground. */
export function eyeHeight({ ground }: Pick<StandPlant, "ground">): number {
	return Math.min(EYE, SHARE * Math.max(ground.width, ground.depth));
}

/** At the front of the ground, looking over it. */
export function atFront({ ground }: Pick<StandPlant, "ground">): Pose {
	return { x: 0, z: 0.48 * ground.depth, yaw: 0, pitch: 0 };
}

/** One step on: half as long as the walker is high; nobody leaves the ground. */
export function stepped(pose: Pose, step: Step, stand: Pick<StandPlant, "ground">): Pose {
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

/** Turned by degrees to the right, and up. */
export function turned(pose: Pose, right: number, up: number): Pose {
	return { ...pose, yaw: pose.yaw + right, pitch: Math.min(STEEPEST, Math.max(-STEEPEST, pose.pitch + up)) };
}

/** Where the eye is, and what it looks at. */
export function gazeOf(pose: Pose, stand: Grounded) {
	const y = heightAt(stand, pose.x, pose.z) + eyeHeight(stand);
	const [yaw, pitch] = [(pose.yaw * Math.PI) / 180, (pose.pitch * Math.PI) / 180];
	const [sideways, forth] = [Math.sin(yaw) * Math.cos(pitch), Math.cos(yaw) * Math.cos(pitch)];
	return {
		eye: [pose.x, y, pose.z],
		towards: [pose.x + sideways, y + Math.sin(pitch), pose.z - forth],
	} as const;
}

/** How high the ground is: between the four places of its grid about there. */
export function heightAt({ ground, meshes }: Grounded, x: number, z: number): number {
	const places = meshes[0]?.positions;
	if (!places) return 0;
	let across = 1;
	while (3 * across + 2 < places.length && places[3 * across + 2] === places[2]) across++;
	const deep = places.length / 3 / across;
	const on = (value: number, size: number, count: number) =>
		Math.min(count - 1, Math.max(0, (value / size + 0.5) * (count - 1)));
	const [u, v] = [on(x, ground.width, across), on(z, ground.depth, deep)];
	const [i, j] = [Math.min(across - 2, Math.floor(u)), Math.min(deep - 2, Math.floor(v))];
	const at = (column: number, row: number) => places[3 * (across * row + column) + 1];
	const near = at(i, j) + (u - i) * (at(i + 1, j) - at(i, j));
	const far = at(i, j + 1) + (u - i) * (at(i + 1, j + 1) - at(i, j + 1));
	return near + (v - j) * (far - near);
}
