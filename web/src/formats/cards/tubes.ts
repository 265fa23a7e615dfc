/** The wood of a tree as tubes, within a budget of triangles: thin stems are left out first. */
import type { PartMesh, Vector } from "../../plant/part";
import type { Skeleton, Stem, StemPoint } from "./skeleton";
import { add, cross, dot, perpendicular, scaled, subtract, unit } from "./vectors";

export interface TubeOptions {
	/** The most triangles. */
	readonly triangles: number;
	/** Tolerance of centre lines, as a share of the height of the wood. */
	readonly tolerance: number;
	/** Sides of stems thicker than half, a fifth and a twentieth of the thickest, and of all others. */
	readonly sides: readonly [number, number, number, number];
	/** How often the bark's picture repeats per metre. */
	readonly repeats: number;
	/** Colour of each segment, 3 × segments in linear light with the shade; absent: no vertex colours. */
	readonly colours?: Float32Array | undefined;
}

export interface Tubes {
	readonly mesh: PartMesh;
	/** The segment of each vertex. */
	readonly segments: Uint32Array;
	/** Whether each stem of the skeleton has a tube. */
	readonly retained: Uint8Array;
	/** Radius at the base of the thickest stem that is left out; 0: none is. */
	readonly omitted: number;
}

const SHARES = [0.5, 0.2, 0.05];
/** How much larger the tolerance of the thinnest stems is: most become straight, and few are left out. */
const THIN = 3;

/** Builds the tubes. The same skeleton and options give the same mesh. */
export function buildTubes(skeleton: Skeleton, options: TubeOptions): Tubes {
	const { stems, thickest, height } = skeleton;
	const order = stems.map((_, i) => i).sort((a, b) => stems[b].radius - stems[a].radius || a - b);
	const retained = new Uint8Array(stems.length);
	const builder = new TubeBuilder(options);
	let omitted = 0;
	for (const i of order) {
		const stem = stems[i];
		const sides = sidesOf(stem, thickest, options);
		const tolerance = (isThin(stem, thickest) ? THIN : 1) * options.tolerance * height;
		const line = skeleton.line(stem, tolerance);
		if (builder.triangles + costOf(line, sides) > options.triangles || (stem.parent >= 0 && !retained[stem.parent])) {
			omitted = Math.max(omitted, stem.radius);
			continue;
		}
		retained[i] = 1;
		builder.add(line, sides);
	}
	return { ...builder.finish(), retained, omitted };
}

/** Returns whether a stem belongs to the thinnest. */
const isThin = ({ radius }: Stem, thickest: number): boolean => radius <= SHARES[SHARES.length - 1] * thickest;

/** Returns the number of sides of a stem. */
function sidesOf({ radius }: Stem, thickest: number, { sides }: TubeOptions): number {
	const at = SHARES.findIndex((share) => radius > share * thickest);
	return sides[at < 0 ? SHARES.length : at];
}

/** Returns the number of triangles of a tube: two per side and part, one per side at the tip. */
const costOf = (line: readonly StemPoint[], sides: number) => sides * (2 * (line.length - 1) - 1);

class TubeBuilder {
	readonly #positions: number[] = [];
	readonly #normals: number[] = [];
	readonly #uvs: number[] = [];
	readonly #colours: number[] = [];
	readonly #segments: number[] = [];
	readonly #indices: number[] = [];

	constructor(readonly options: TubeOptions) {}

	get triangles(): number {
		return this.#indices.length / 3;
	}

	/** Adds a tube along a line that ends in a point. Rings do not twist: each takes over the direction of the last. */
	add(line: readonly StemPoint[], sides: number): void {
		const { repeats } = this.options;
		const around = Math.max(1, Math.round(2 * Math.PI * line[0].radius * repeats));
		let right: Vector | undefined;
		for (const [i, point] of line.entries()) {
			const before = subtract(point.place, line[Math.max(0, i - 1)].place);
			const after = subtract(line[Math.min(line.length - 1, i + 1)].place, point.place);
			const along = unit(add(unit(before, [0, 0, 0]), unit(after, [0, 0, 0])));
			right = unit(
				right ? subtract(right, scaled(along, dot(right, along))) : perpendicular(along),
				perpendicular(along),
			);
			const first = this.#segments.length;
			const v = point.distance * repeats;
			if (i === line.length - 1) {
				// One vertex per side, so that each side has texture coordinates of its own at the tip.
				for (let k = 0; k < sides; k++) this.#vertex(point, along, ((k + 0.5) * around) / sides, v);
				for (let k = 0; k < sides; k++) this.#indices.push(first - sides - 1 + k, first - sides + k, first + k);
				return;
			}
			const forward = cross(along, right);
			// The seam has two vertices, with both ends of the picture.
			for (let k = 0; k <= sides; k++) {
				const angle = (2 * Math.PI * k) / sides;
				const out = add(scaled(right, Math.cos(angle)), scaled(forward, Math.sin(angle)));
				this.#vertex(point, out, (k * around) / sides, v, scaled(out, point.radius));
			}
			if (i === 0) continue;
			for (let k = 0; k < sides; k++) {
				const [a, b] = [first - sides - 1 + k, first + k];
				this.#indices.push(a, a + 1, b + 1, a, b + 1, b);
			}
		}
	}

	/** Returns the mesh, and the segment of each vertex. */
	finish(): { mesh: PartMesh; segments: Uint32Array } {
		return {
			mesh: {
				positions: Float32Array.from(this.#positions),
				normals: Float32Array.from(this.#normals),
				uvs: Float32Array.from(this.#uvs),
				indices: Uint32Array.from(this.#indices),
				...(this.options.colours ? { colours: Float32Array.from(this.#colours) } : {}),
			},
			segments: Uint32Array.from(this.#segments),
		};
	}

	/** Adds a vertex at a distance from a point of the line; v runs down the picture, so that it is negative upwards. */
	#vertex({ place, segment }: StemPoint, normal: Vector, u: number, v: number, away: Vector = [0, 0, 0]): void {
		this.#positions.push(...add(place, away));
		this.#normals.push(...normal);
		this.#uvs.push(u, -v);
		this.#segments.push(segment);
		const { colours } = this.options;
		if (colours) this.#colours.push(...colours.subarray(3 * segment, 3 * segment + 3));
	}
}
