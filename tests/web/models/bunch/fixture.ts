/** Small growths made without the core: a rachis, axes of one internode, pedicels with berries or withered. */
import type {
	Berries,
	BunchPlant,
	Internodes,
	Mesh,
	StemMesh,
	StemPart,
} from "../../../../web/src/models/bunch/bunch_plant";
import { EMPTY_PLANT } from "../../../../web/src/plant/plant";
import { type Specimen, specimenFromPreset } from "../../bunch";
import { fingerprintOf } from "./fingerprint";

export type Vector = [x: number, y: number, z: number];

export interface PedicelSketch {
	/** Unit vector. */
	direction: Vector;
	/** Radius in metres; 0 is withered. */
	berryRadius: number;
}

export interface GrownSketch {
	/** The pedicels of each first-order axis, the top one first. */
	axes: PedicelSketch[][];
	/** Sides of a stem's tube. */
	sides?: number;
	/** Segments of the shared berry. */
	segments?: number;
	/** Metres of one internode. */
	length?: number;
}

export const SKETCH: GrownSketch = {
	axes: [
		[
			{ direction: [0, -1, 0], berryRadius: 0.006 },
			{ direction: [0.6, -0.8, 0], berryRadius: 0 },
			{ direction: [0, 0.6, 0.8], berryRadius: 0.0071 },
		],
		[],
		[{ direction: [0, 1, 0], berryRadius: 0.005 }],
	],
};

export function sampleSpecimen(changes: Partial<Specimen> = {}): Specimen {
	return { ...specimenFromPreset(changes.preset), ...changes };
}

/** Specimen of the paper's procedure for the growths of `makeGrown`. */
export function paperSpecimen(changes: Partial<Specimen> = {}): Specimen {
	const specimen = sampleSpecimen(changes);
	return { ...specimen, parameters: { ...specimen.parameters, procedure: 0 } };
}

interface Node {
	parent: number;
	kind: number;
	axis: number;
	state: number;
	start: Vector;
	end: Vector;
	radii: [number, number];
}

export function makeGrown({ axes, sides = 4, segments = 6, length = 0.012 }: GrownSketch): BunchPlant {
	const nodes: Node[] = [];
	const berries: { centre: Vector; radius: number; direction: Vector; parent: number }[] = [];
	const add = (node: Node) => nodes.push(node) - 1;
	const rachis = axes.map((_, axis) =>
		add({
			parent: axis - 1,
			kind: 0,
			axis: -1,
			state: 0,
			...segment([0, -axis * length, 0], [0, -1, 0], length),
			radii: [length / 6, length / 7],
		}),
	);
	if (rachis.length === 0)
		rachis.push(
			add({
				parent: -1,
				kind: 0,
				axis: -1,
				state: 0,
				...segment([0, 0, 0], [0, -1, 0], length),
				radii: [length / 6, length / 7],
			}),
		);
	axes.forEach((pedicels, axis) => {
		const side: Vector = axis % 2 === 0 ? [1, 0, 0] : [-1, 0, 0];
		const lateral = add({
			parent: rachis[axis],
			kind: 1,
			axis,
			state: 0,
			...segment(nodes[rachis[axis]].end, side, length),
			radii: [length / 9, length / 10],
		});
		for (const { direction, berryRadius } of pedicels) {
			const state = berryRadius > 0 ? 0 : 1;
			const reach = state === 1 ? length / 5 : length;
			const place = segment(nodes[lateral].end, direction, reach);
			const parent = add({ parent: lateral, kind: 3, axis, state, ...place, radii: [length / 15, length / 15] });
			if (state === 0)
				berries.push({ centre: along(place.end, direction, berryRadius), radius: berryRadius, direction, parent });
		}
	});
	const internodes = packInternodes(nodes);
	const packed: Berries = {
		count: berries.length,
		spheres: Float32Array.from(berries.flatMap(({ centre, radius }) => [...centre, radius])),
		directions: Float32Array.from(berries.flatMap(({ direction }) => direction)),
		parent: Int32Array.from(berries, ({ parent }) => parent),
		ids: Uint32Array.from(berries, (_, index) => 1000 + 7 * index),
		traits: Float32Array.from(berries.flatMap(({ radius }) => [2 * radius, 2 * radius, 0.5, 1, 1, 1, 0, 2])),
	};
	const pedicels = nodes.filter(({ kind }) => kind === 3).length;
	return {
		...EMPTY_PLANT,
		procedure: "paper",
		form: { fruit: "grape", taper: 0, blunt: 0, curve: 0 },
		plan: { m: axes.length + 1, sides: [side(2, 1), side(3, 2), side(4, 3), side(5, 4)], axes: axes.map(() => 1) },
		counts: {
			endStructures: axes.length,
			internodes: nodes.length,
			pedicels,
			berries: berries.length,
			withered: pedicels - berries.length,
			cut: 0,
		},
		internodes,
		berries: packed,
		stem: makeStem(nodes, sides),
		berry: makeBerry(segments),
		thinned: [],
		notes: ["l was clamped."],
		fingerprint: fingerprintOf(internodes, packed, "paper"),
		timings: { grow: 0.5 },
	};
}

const side = (n: number, rd: number) => ({ w: 25 * n, r: 18 * rd, n, rd });
export const along = (from: Vector, direction: Vector, by: number): Vector => [
	from[0] + by * direction[0],
	from[1] + by * direction[1],
	from[2] + by * direction[2],
];
const segment = (start: Vector, direction: Vector, by: number) => ({ start, end: along(start, direction, by) });

function packInternodes(nodes: Node[]): Internodes {
	return {
		count: nodes.length,
		parent: Int32Array.from(nodes, ({ parent }) => parent),
		kind: Uint32Array.from(nodes, ({ kind }) => kind),
		axis: Int32Array.from(nodes, ({ axis }) => axis),
		state: Uint8Array.from(nodes, ({ state }) => state),
		ends: Float32Array.from(nodes.flatMap(({ start, end }) => [...start, ...end])),
		radii: Float32Array.from(nodes.flatMap(({ radii }) => radii)),
	};
}

/** A closed prism about each internode, sorted by axis. */
function makeStem(nodes: Node[], sides: number): StemMesh {
	const lists = {
		positions: [] as number[],
		normals: [] as number[],
		uvs: [] as number[],
		indices: [] as number[],
		internode: [] as number[],
	};
	const parts: StemPart[] = [];
	for (const axis of new Set(nodes.map((node) => node.axis))) {
		const firstVertex = lists.internode.length;
		const firstIndex = lists.indices.length;
		nodes.forEach((node, index) => {
			if (node.axis === axis) addPrism(lists, node, index, sides);
		});
		parts.push({
			axis,
			firstVertex,
			vertexCount: lists.internode.length - firstVertex,
			firstIndex,
			indexCount: lists.indices.length - firstIndex,
		});
	}
	return {
		positions: Float32Array.from(lists.positions),
		normals: Float32Array.from(lists.normals),
		uvs: Float32Array.from(lists.uvs),
		indices: Uint32Array.from(lists.indices),
		internode: Uint32Array.from(lists.internode),
		parts,
	};
}

interface Lists {
	positions: number[];
	normals: number[];
	uvs: number[];
	indices: number[];
	internode: number[];
}

function addPrism(lists: Lists, { start, end, radii }: Node, internode: number, sides: number): void {
	const forward = unit([end[0] - start[0], end[1] - start[1], end[2] - start[2]]);
	const right = unit(cross(forward, Math.abs(forward[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
	const up = cross(right, forward);
	const vertex = (position: Vector, normal: Vector, u: number, v: number) => {
		lists.positions.push(...position);
		lists.normals.push(...normal);
		lists.uvs.push(u, v);
		return lists.internode.push(internode) - 1;
	};
	const spoke = (k: number) => {
		const angle = (2 * Math.PI * k) / sides;
		return unit(along(along([0, 0, 0], right, Math.cos(angle)), up, Math.sin(angle)));
	};
	const back: Vector = [-forward[0], -forward[1], -forward[2]];
	const centres = [vertex(start, back, 0.5, 0), vertex(end, forward, 0.5, 1)];
	for (let k = 0; k < sides; k++) {
		const [one, next] = [spoke(k), spoke(k + 1)];
		const a = vertex(along(start, one, radii[0]), one, k / sides, 0);
		const b = vertex(along(end, one, radii[1]), one, k / sides, 1);
		const c = vertex(along(end, next, radii[1]), next, (k + 1) / sides, 1);
		const d = vertex(along(start, next, radii[0]), next, (k + 1) / sides, 0);
		lists.indices.push(a, c, b, a, d, c, centres[0], d, a, centres[1], b, c);
	}
}

/** A sphere of parallels and meridians, seat at −Y (v 0), scar at +Y (v 1). */
export function makeBerry(segments: number): Mesh {
	const rings = Math.max(2, segments >> 1);
	const positions: number[] = [];
	const uvs: number[] = [];
	const indices: number[] = [];
	for (let ring = 0; ring <= rings; ring++) {
		const angle = (Math.PI * ring) / rings;
		for (let k = 0; k <= segments; k++) {
			const turn = (2 * Math.PI * k) / segments;
			positions.push(Math.sin(angle) * Math.cos(turn), -Math.cos(angle), Math.sin(angle) * Math.sin(turn));
			uvs.push(k / segments, ring / rings);
			if (ring === rings || k === segments) continue;
			const a = ring * (segments + 1) + k;
			const above = a + segments + 1;
			if (ring > 0) indices.push(a, above, a + 1);
			if (ring < rings - 1) indices.push(a + 1, above, above + 1);
		}
	}
	// A unit sphere's normals are its positions.
	const normals = Float32Array.from(positions);
	return {
		positions: Float32Array.from(positions),
		normals,
		uvs: Float32Array.from(uvs),
		indices: Uint32Array.from(indices),
	};
}

export function cross(a: Vector, b: Vector): Vector {
	return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function unit([x, y, z]: Vector): Vector {
	const length = Math.hypot(x, y, z);
	return [x / length, y / length, z / length];
}
