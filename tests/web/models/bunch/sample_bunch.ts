import { CylinderGeometry, Matrix4, Quaternion, SphereGeometry, Vector3 } from "three";
import type { BunchPlant, Internodes, Mesh, Plan, StemMesh } from "../../../../web/src/models/bunch/bunch_plant";
import { EMPTY_PLANT } from "../../../../web/src/plant/plant";
import type { Look } from "../../bunch";

export const LOOK: Look = {
	skin: "43264f",
	unripe: "8ea552",
	stem: "7d7a3f",
	bloom: 0.5,
	glow: 0.5,
	uneven: 0.5,
	lenticels: 0.4,
};

/** The state of a berry that is ripe and stands half in the sun. */
export const RIPE = { exposure: 0.5, set: 1, shrivel: 0 };

/** A plausible bunch without botany: berries packed on a cone round a rachis, each on a straight pedicel. */
export function sampleBunch(count = 90, seed = 1, length = 0.16): BunchPlant {
	const random = randomOf(seed);
	const spheres: number[] = [];
	const directions: number[] = [];
	const parents: number[] = [];
	const skeleton: { start: Vector3; end: Vector3; radius: number; kind: number; state: number; parent: number }[] = [];
	const steps = 14;
	for (let s = 0; s < steps; s++) {
		const start = new Vector3(0, (-length * s) / steps, 0);
		const end = new Vector3(0, (-length * (s + 1)) / steps, 0);
		skeleton.push({ start, end, radius: 0.0019 - 0.00006 * s, kind: 0, state: 0, parent: s - 1 });
	}
	for (let tries = 0; spheres.length < 4 * count && tries < 60000; tries++) {
		const down = random();
		const y = -length * (0.04 + 0.98 * down);
		const breadth = 0.012 + 0.027 * Math.min(1, (1.05 - down) * 1.2);
		const out = Math.sqrt(random()) * breadth;
		const angle = random() * 2 * Math.PI;
		const centre = new Vector3(out * Math.cos(angle), y, out * Math.sin(angle));
		const r = 0.005 + 0.0025 * random();
		if (Math.hypot(centre.x, centre.z) < r + 0.002) continue;
		let free = true;
		for (let i = 0; i < spheres.length && free; i += 4) {
			free = centre.distanceTo(new Vector3(spheres[i], spheres[i + 1], spheres[i + 2])) >= r + spheres[i + 3];
		}
		if (!free) continue;
		const root = new Vector3(0, Math.min(0, y + 0.35 * Math.hypot(centre.x, centre.z)), 0);
		const direction = centre.clone().sub(root).normalize();
		const tip = centre.clone().addScaledVector(direction, -r);
		const withered = random() < 0.06;
		parents.push(skeleton.length);
		skeleton.push({
			start: root,
			end: tip,
			radius: 0.0006,
			kind: 3,
			state: 0,
			parent: Math.min(steps - 1, Math.floor((-root.y / length) * steps)),
		});
		spheres.push(centre.x, centre.y, centre.z, r);
		directions.push(direction.x, direction.y, direction.z);
		if (withered) {
			const stub = new Vector3(random() - 0.5, -0.4, random() - 0.5).setLength(0.006);
			skeleton.push({ start: root, end: root.clone().add(stub), radius: 0.0006, kind: 3, state: 1, parent: 0 });
		}
	}
	const n = skeleton.length;
	const internodes: Internodes = {
		count: n,
		parent: Int32Array.from(skeleton, (s) => s.parent),
		kind: Uint32Array.from(skeleton, (s) => s.kind),
		axis: new Int32Array(n).fill(-1),
		state: Uint8Array.from(skeleton, (s) => s.state),
		ends: Float32Array.from(skeleton.flatMap((s) => [...s.start.toArray(), ...s.end.toArray()])),
		radii: Float32Array.from(skeleton.flatMap((s) => [s.radius, s.radius])),
	};
	const side = { w: 0, r: 0, n: 0, rd: 0 };
	const plan: Plan = { m: steps, sides: [side, side, side, side], axes: [] };
	return {
		...EMPTY_PLANT,
		procedure: "paper",
		form: { fruit: "grape", taper: 0, blunt: 0, curve: 0 },
		plan,
		counts: { endStructures: 0, internodes: n, pedicels: n - steps, berries: spheres.length / 4, withered: 0, cut: 0 },
		internodes,
		berries: {
			count: spheres.length / 4,
			spheres: Float32Array.from(spheres),
			directions: Float32Array.from(directions),
			parent: Int32Array.from(parents),
			ids: Uint32Array.from(parents),
			traits: ripeTraits(spheres),
		},
		stem: tubes(skeleton),
		berry: meshOf(new SphereGeometry(1, 24, 16)),
		thinned: [],
		notes: [],
		fingerprint: "0000000000000000",
		timings: { grow: 0 },
	};
}

/** The traits of ripe, round berries: width, length, exposure, turned, opened, set, shrivel, seeds. */
export function ripeTraits(spheres: ArrayLike<number>): Float32Array {
	const traits: number[] = [];
	for (let i = 3; i < spheres.length; i += 4) traits.push(2 * spheres[i], 2 * spheres[i], 0.5, 1, 1, 1, 0, 3);
	return Float32Array.from(traits);
}

/** A small linear congruential generator: the sample is the same on every machine. */
function randomOf(seed: number): () => number {
	let state = seed >>> 0;
	return () => {
		state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
		return state / 4294967296;
	};
}

function meshOf(geometry: SphereGeometry | CylinderGeometry): Mesh {
	const { position, normal, uv } = geometry.attributes;
	return {
		positions: Float32Array.from(position.array),
		normals: Float32Array.from(normal.array),
		uvs: Float32Array.from(uv.array),
		indices: Uint32Array.from(geometry.index?.array ?? []),
	};
}

function tubes(skeleton: { start: Vector3; end: Vector3; radius: number }[]): StemMesh {
	const out = {
		positions: [] as number[],
		normals: [] as number[],
		uvs: [] as number[],
		indices: [] as number[],
		internode: [] as number[],
	};
	skeleton.forEach(({ start, end, radius }, i) => {
		const along = end.clone().sub(start);
		const place = new Matrix4().compose(
			start.clone().add(end).multiplyScalar(0.5),
			new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.clone().normalize()),
			new Vector3(1, 1, 1),
		);
		const tube = meshOf(
			new CylinderGeometry(radius, radius, along.length(), 10, 2).applyMatrix4(place) as CylinderGeometry,
		);
		const first = out.positions.length / 3;
		out.positions.push(...tube.positions);
		out.normals.push(...tube.normals);
		out.uvs.push(...tube.uvs);
		for (const index of tube.indices) out.indices.push(first + index);
		for (let v = 0; v < tube.positions.length / 3; v++) out.internode.push(i);
	});
	const vertices = out.internode.length;
	return {
		positions: Float32Array.from(out.positions),
		normals: Float32Array.from(out.normals),
		uvs: Float32Array.from(out.uvs),
		indices: Uint32Array.from(out.indices),
		internode: Uint32Array.from(out.internode),
		parts: [{ axis: -1, firstVertex: 0, vertexCount: vertices, firstIndex: 0, indexCount: out.indices.length }],
	};
}
