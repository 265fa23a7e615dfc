/** Points on a plant's surface as binary PLY: places, normals and colours, for those who work with scans. Metres, +Y up. */
import { encoded } from "../plant/colour";
import type { Part } from "../plant/part";
import type { About } from "./about";
import { GENERATOR } from "./generator";
import { visible } from "./light";
import { type Piece, piecesOf } from "./piece";
import { plainBase } from "./vertex_colours";

/** Six floats and three bytes. */
const POINT = 27;

/** @param points as many, evenly over all that can be seen from outside */
export function ply(parts: Iterable<Part>, about: About, points: number): Uint8Array<ArrayBuffer> {
	const pieces = visible([...piecesOf(parts)]);
	const areas = pieces.map(areasOf);
	const whole = areas.reduce((sum, own) => sum + own.reduce((all, area) => all + area, 0), 0);
	const count = whole > 0 ? points : 0;
	const properties = ["x", "y", "z", "nx", "ny", "nz"].map((name) => `property float ${name}`);
	const colours = ["red", "green", "blue"].map((name) => `property uchar ${name}`);
	const words = [
		"ply",
		"format binary_little_endian 1.0",
		`comment ${GENERATOR}: ${about.name}, metres, +Y up`,
		`comment ${about.link}`,
	];
	const header = new TextEncoder().encode(
		`${[...words, `element vertex ${count}`, ...properties, ...colours, "end_header"].join("\n")}\n`,
	);
	const file = new Uint8Array(header.length + POINT * count);
	file.set(header);
	const view = new DataView(file.buffer, header.length);
	let [passed, point] = [0, 0];
	for (const [i, piece] of pieces.entries()) {
		for (const [triangle, area] of areas[i].entries()) {
			passed += area;
			// One in the middle of each of so many equal shares of the area.
			for (; point < count && (point + 0.5) * whole <= passed * count; point++)
				write(view, POINT * point, piece, triangle, point);
		}
	}
	return file;
}

/** Of its triangles. */
function areasOf({ mesh: { positions: p, indices } }: Piece): Float64Array {
	return Float64Array.from({ length: indices.length / 3 }, (_, triangle) => {
		const [a, b, c] = [3 * indices[3 * triangle], 3 * indices[3 * triangle + 1], 3 * indices[3 * triangle + 2]];
		const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
		const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
		return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
	});
}

/** The generalised golden ratio of two dimensions: its multiples fill a square evenly (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"). */
const STEPS = [0.7548776662466927, 0.5698402909980532] as const;

function write(view: DataView, at: number, { mesh, material }: Piece, triangle: number, point: number): void {
	let [s, t] = STEPS.map((step) => (step * (point + 1)) % 1);
	if (s + t > 1) [s, t] = [1 - s, 1 - t];
	const corners = mesh.indices.subarray(3 * triangle, 3 * triangle + 3);
	const mean = (values: Float32Array, k: number) =>
		(1 - s - t) * values[3 * corners[0] + k] + s * values[3 * corners[1] + k] + t * values[3 * corners[2] + k];
	const normal = [0, 1, 2].map((k) => mean(mesh.normals, k));
	const length = Math.hypot(...normal) || 1;
	// A picture is there by its mean, which vertices' colours multiply.
	const under = material.textures?.colour && mesh.colours ? material.colour : [1, 1, 1];
	const base = mesh.colours || !material.textures?.colour ? plainBase(material) : material.colour;
	const colour = [0, 1, 2].map((k) => (mesh.colours ? mean(mesh.colours, k) * under[k] : base[k]));
	const shown = encoded([colour[0], colour[1], colour[2]]);
	for (let k = 0; k < 3; k++) {
		view.setFloat32(at + 4 * k, mean(mesh.positions, k), true);
		view.setFloat32(at + 12 + 4 * k, normal[k] / length, true);
		view.setUint8(at + 24 + k, Math.round(255 * Math.max(0, Math.min(1, shown[k]))));
	}
}
