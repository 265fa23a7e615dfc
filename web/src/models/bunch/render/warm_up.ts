import { EMPTY_PLANT } from "../../../plant/plant";
import { type BunchPlant, type Mesh, type PlanSide, TRAITS } from "../bunch_plant";
import type { Look } from "../specimen";

const side: PlanSide = { w: 0, r: 0, n: 0, rd: 0 };

/** A triangle too small to be visible. */
const SPECK: Mesh = {
	positions: new Float32Array(9),
	normals: new Float32Array([0, 1, 0, 0, 1, 0, 0, 1, 0]),
	uvs: new Float32Array(6),
	indices: new Uint32Array([0, 1, 2]),
};

/** A bunch too small to be visible. Drawing it compiles the shader programs before the first real bunch arrives. */
export const WARM_UP_BUNCH: BunchPlant = {
	...EMPTY_PLANT,
	procedure: "natural",
	form: { fruit: "grape", taper: 0, blunt: 0, curve: 0 },
	plan: { m: 1, sides: [side, side, side, side], axes: [] },
	counts: { endStructures: 0, internodes: 1, pedicels: 1, berries: 1, withered: 0, cut: 0 },
	internodes: {
		count: 1,
		parent: new Int32Array([-1]),
		kind: new Uint32Array(1),
		axis: new Int32Array([-1]),
		state: new Uint8Array(1),
		ends: new Float32Array(6),
		radii: new Float32Array(2),
	},
	berries: {
		count: 1,
		spheres: new Float32Array([0, 0, 0, 1e-7]),
		directions: new Float32Array([0, -1, 0]),
		parent: new Int32Array(1),
		ids: new Uint32Array(1),
		traits: new Float32Array(TRAITS.length).fill(1e-7),
	},
	stem: {
		...SPECK,
		internode: new Uint32Array(3),
		parts: [{ axis: -1, firstVertex: 0, vertexCount: 3, firstIndex: 0, indexCount: 3 }],
	},
	surfaces: { ...SPECK, pressed: new Uint8Array(3) },
	thinned: [],
	notes: [],
	fingerprint: "",
	timings: { grow: 0 },
};

export const WARM_UP_LOOK: Look = {
	skin: "808080",
	unripe: "808080",
	stem: "808080",
	bloom: 0,
	glow: 0.5,
	uneven: 0.5,
	lenticels: 0.5,
};
