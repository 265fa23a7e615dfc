/**
 * Files of every model as trimesh opens them, a library in Python that is none of ours: as many triangles and points, as large, where
 * they were made. It is installed into build/trimesh with the first run. It knows no compression by meshopt, so of the *web* form it
 * opens the twin that is quantised alone; neither quantised positions (it takes whole numbers for lengths) nor EXT_mesh_gpu_instancing (it shows
 * of each mesh one): of these forms only triangles are compared.
 */
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { buildFolder } from "../../../wasm-core/tools/repository.mjs";
import { prepare } from "../../../wasm-core/tools/toolchain.mjs";
import type { FileOptions } from "../../../web/src/formats/file_options";
import { exportObj } from "../../../web/src/formats/obj";
import { boundsOf, piecesOf } from "../../../web/src/formats/piece";
import { plantFile } from "../../../web/src/formats/plant_files";
import { webGlb } from "../../../web/src/formats/web_glb";
import { installed, readBy } from "../../readers/programs.mjs";
import { grownParts } from "./grown_parts";
import { documentOf } from "./reading";

/** Small ones, of each model; every form of the first. */
const PLANTS: [source: string, changed?: Record<string, number>][] = [
	["bunch/redcurrant"],
	["leaf/oak"],
	["tree/sphere", { particles: 300 }],
	["root/carrot"],
];
const POINTS = 5000;
const LOW = 4000;
/** Of prints, millimetres: as coarse as is soon made. */
const THICKNESS = 4;
const folder = join(buildFolder, "trimesh/files");

interface Ours {
	/** Of triangles or points; without it as many as are in the file's own words. */
	count?: number;
	/** How far bounds may be off, as a share of the longest edge; without it the form does not keep them. */
	within?: number;
	/** Length of a metre in the file's unit, for files with a scale; otherwise bounds are compared in metres. */
	print?: true;
}

let python: string;
beforeAll(async () => {
	const { python: program } = await prepare("trimesh");
	python = await installed("trimesh", program);
}, 300_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** Triangles that a GLB's own words count, each mesh as often as nodes draw it. */
function trianglesOf(glb: Uint8Array): number {
	const { nodes, meshes = [], accessors = [] } = documentOf(glb);
	const drawn = nodes.flatMap(({ mesh }) => (mesh === undefined ? [] : meshes[mesh].primitives));
	return drawn.reduce((sum, { indices }) => sum + accessors[indices].count / 3, 0);
}

/** Writes a plant's files; returns the expected content of each. */
async function write([source, changed]: (typeof PLANTS)[number]) {
	const { parts, about } = await grownParts(source, changed);
	const pieces = [...piecesOf(parts())];
	const { low, high } = boundsOf(pieces.map(({ mesh }) => mesh.positions));
	const count = pieces.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
	const files: [string, Uint8Array, Ours][] = [];
	const make = async (ending: string, form?: string, options: FileOptions = {}) =>
		(await plantFile(ending, form)?.make(parts(), about, options)) as Uint8Array;
	const prints = { within: 0.05, print: true } as const;
	files.push(["detailed.glb", await make("glb"), { count, within: 1e-5 }]);
	files.push(["low.glb", await make("glb", "low", { triangles: LOW }), { within: 0.03 }]);
	files.push(["points.ply", await make("ply", undefined, { points: POINTS }), { count: POINTS, within: 0.06 }]);
	const stl = await make("stl", undefined, { thickness: THICKNESS });
	const printed = new DataView(stl.buffer).getUint32(80, true);
	files.push(["print.stl", stl, { count: printed, ...prints }]);
	if (source.startsWith("bunch/")) {
		files.push(["textures.glb", await make("glb", "detailed", { textures: true }), { count, within: 1e-5 }]);
		files.push(["web.glb", await webGlb(parts(), about, false), {}]);
		files.push(["instanced.glb", await make("glb", "instanced"), {}]);
		const { obj } = exportObj(parts(), about, "plant");
		files.push(["plant.obj", new TextEncoder().encode(obj), { count, within: 1e-4 }]);
		const threeMf = await make("3mf", undefined, { thickness: THICKNESS });
		files.push(["print.3mf", threeMf, { count: printed, ...prints }]);
	}
	mkdirSync(folder, { recursive: true });
	return files.map(([name, bytes, ours]) => {
		const path = join(folder, `${source.replace("/", "-")}-${name}`);
		writeFileSync(path, bytes);
		return { path, bytes, low, high, ...ours };
	});
}

describe("trimesh", () => {
	it("finds in every file of every model what was put into it", async () => {
		const files = (await Promise.all(PLANTS.map(write))).flat();
		const found = await readBy(
			python,
			"trimesh",
			files.map(({ path }) => path),
		);
		expect(found).toHaveLength(files.length);
		for (const [i, { path, bytes, count = trianglesOf(bytes), within, print, low, high }] of files.entries()) {
			const { bounds, closed } = found[i];
			expect([path, found[i].count]).toEqual([path, count]);
			if (within === undefined) continue;
			const longest = Math.max(...high.map((value, k) => value - low[k]));
			const scale = print ? nearestScale(longest / Math.max(...bounds[1].map((value, k) => value - bounds[0][k]))) : 1;
			const off = [low, high].flatMap((corner, c) => corner.map((value, k) => Math.abs(scale * bounds[c][k] - value)));
			expect(Math.max(...off) / longest, path).toBeLessThan(within);
			expect(closed, path).toBe(print);
		}
	});
});

/** The scale of a print that is about so many times smaller than life. */
function nearestScale(ratio: number): number {
	return [1, 2, 5, 10, 20, 50, 100].find((scale) => ratio < 1.2 * scale) ?? 1;
}
