/** Small growths as the natural procedure gives them, made without the core: pressed berries, flowers, foliage. */
import type {
	BerrySurfaces,
	BunchPlant,
	FlowerMesh,
	Foliage,
	Mesh,
} from "../../../../web/src/models/bunch/bunch_plant";
import { MEASURES } from "../../../../web/src/models/bunch/measures.generated";
import { fromUp, rotationMatrix } from "../../../../web/src/plant/orientation";
import { fingerprintOf } from "./fingerprint";
import { type GrownSketch, makeBerry, makeGrown } from "./fixture";

export interface NaturalChanges {
	/** The traits of berry `index` that differ from a ripe one's: exposure, turned, opened, set, shrivel. */
	traits?: (index: number) => Partial<Record<"exposure" | "turned" | "opened" | "set" | "shrivel", number>>;
	/** Whether to leave out leaves and cane. */
	bare?: boolean;
}

const LENGTHENED = 1.25;

export function makeNatural(
	sketch: GrownSketch,
	{ traits = () => ({}), bare = false }: NaturalChanges = {},
): BunchPlant {
	const { berry, ...grown } = makeGrown(sketch);
	const { berries } = grown;
	for (let i = 0; i < berries.count; i++) {
		const radius = berries.spheres[4 * i + 3];
		const { exposure = i / 10, turned = 1, opened = 1, set = 1, shrivel = 0 } = traits(i);
		const width = (2 * radius) / Math.cbrt(LENGTHENED);
		berries.traits.set([width, LENGTHENED * width, exposure, turned, opened, set, shrivel, i % 5], 8 * i);
	}
	const natural: BunchPlant = {
		...grown,
		procedure: "natural",
		form: { fruit: "grape", taper: Math.fround(0.1), blunt: 0, curve: Math.fround(0.3) },
		surfaces: pressedSurfaces(grown, berry ?? makeBerry(6)),
		flower: flower(),
		measures: Float32Array.from(MEASURES, (_, i) => (i % 7 === 3 ? Number.NaN : 0.1 * i)),
		thinned: [
			{ id: 3, why: "no room", place: [0.001, -0.02, 0.003].map(Math.fround) as [number, number, number] },
			{ id: 9, why: "by hand", place: [0, -0.01, 0] },
		],
	};
	if (!bare) natural.foliage = makeFoliage();
	return { ...natural, fingerprint: fingerprintOf(natural.internodes, berries, "natural") };
}

/** Reach of stamens in radii of their ovary. */
export const STAMENS_REACH = 1.75;

function flower(): FlowerMesh {
	const ball = makeBerry(8);
	const whole = {
		firstVertex: 0,
		vertexCount: ball.positions.length / 3,
		firstIndex: 0,
		indexCount: ball.indices.length,
	};
	const positions = ball.positions.map((value) => STAMENS_REACH * value);
	return { ...ball, positions, unit: 0, pieces: [{ piece: "stamens", ...whole }] };
}

/** Builds ellipsoids along their directions, flat on one side if pressed. */
function pressedSurfaces({ berries }: BunchPlant, pattern: Mesh): BerrySurfaces {
	const vertices = pattern.uvs.length / 2;
	const positions = new Float32Array(3 * vertices * berries.count);
	const normals = new Float32Array(positions.length);
	const pressed = new Uint8Array(vertices * berries.count);
	for (let i = 0; i < berries.count; i++) {
		const [cx, cy, cz] = berries.spheres.subarray(4 * i, 4 * i + 3);
		const [width, length] = berries.traits.subarray(8 * i, 8 * i + 2);
		const [dx, dy, dz] = berries.directions.subarray(3 * i, 3 * i + 3);
		const [a, b, c, d, e, f, g, h, k] = rotationMatrix(fromUp(dx, dy, dz));
		for (let vertex = 0; vertex < vertices; vertex++) {
			const at = 3 * (i * vertices + vertex);
			const [nx, ny, nz] = pattern.normals.subarray(3 * vertex, 3 * vertex + 3);
			const [x, y, z] = [Math.min(0.8, nx) * width * 0.5, ny * length * 0.5, nz * width * 0.5];
			positions.set([cx + a * x + b * y + c * z, cy + d * x + e * y + f * z, cz + g * x + h * y + k * z], at);
			normals.set([a * nx + b * ny + c * nz, d * nx + e * ny + f * nz, g * nx + h * ny + k * nz], at);
			pressed[at / 3] = nx > 0.8 ? 255 : 0;
		}
	}
	return { uvs: pattern.uvs, indices: pattern.indices, positions, normals, pressed };
}

/** Builds a cane, two leaves with their petioles, and an empty part. */
function makeFoliage(): Foliage {
	const kinds = ["cane", "petiole", "leaf", "petiole", "leaf"] as const;
	const tent = [0, 0, 0, 0.02, 0.03, 0, 0, 0.03, 0.05, -0.02, 0.03, 0];
	const across = 1 / Math.sqrt(3);
	return {
		positions: Float32Array.from(kinds.flatMap((_, i) => tent.map((value) => value + 0.1 * i))),
		normals: Float32Array.from({ length: 12 * kinds.length }, () => across),
		uvs: Float32Array.from(kinds.flatMap(() => [0, 0, 1, 0, 1, 1, 0, 1])),
		indices: Uint32Array.from(kinds.flatMap((_, i) => [0, 1, 2, 0, 2, 3].map((index) => index + 4 * i))),
		parts: [
			...kinds.map((kind, i) => ({ kind, firstVertex: 4 * i, vertexCount: 4, firstIndex: 6 * i, indexCount: 6 })),
			{ kind: "leaf", firstVertex: 20, vertexCount: 0, firstIndex: 30, indexCount: 0 },
		],
	};
}
