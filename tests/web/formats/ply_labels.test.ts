/** Labels of the points of a PLY, compared with the parts of the nearest triangles of the detailed GLB. */
import type { Mesh } from "three";
import { Triangle, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { writeJson } from "../../../web/src/formats/json";
import { makeFile } from "../../../web/src/generate/files/make";
import type { FileRequest } from "../../../web/src/generate/files/messages";
import { model as bunch } from "../../../web/src/models/bunch/index";
import type { Model } from "../../../web/src/models/model";
import { namesInRun } from "../../long_run.mjs";
import { specimenFromPreset, withParameters } from "../bunch";
import { freshCore, growBunch } from "../core/wasm";
import { documentOf, load } from "./reading";

const COUNT = 3000;
const core = await freshCore();
const model = bunch as unknown as Model;

interface Point {
	place: Vector3;
	instance: number;
	kind: string;
	berry: number;
}

/** A bunch's points, its GLB and its JSON document. */
async function files(preset: string, settings: Record<string, number> = {}) {
	const specimen = withParameters(specimenFromPreset(preset), settings);
	await bunch.prepare(specimen);
	const grown = growBunch(core, specimen);
	const make = async (format: string) => {
		const request: FileRequest = {
			model: "bunch",
			format,
			grown,
			specimen,
			link: "?",
			name: preset,
			options: { points: COUNT },
		};
		return new Uint8Array(await (await makeFile(model, request)).arrayBuffer());
	};
	const document = JSON.parse(writeJson(bunch, grown, specimen).toString());
	return {
		points: pointsIn(await make("ply")),
		glb: await make("glb"),
		berries: document.berries as { id?: number }[],
	};
}

/** Reads points by their header: every property by name and type, in any order. */
function pointsIn(file: Uint8Array): Point[] {
	const [head] = new TextDecoder("latin1").decode(file).split("end_header\n");
	const kinds = [...head.matchAll(/^comment class (\d+) (.*)$/gm)].map(([, number, kind]) => {
		expect(Number(number)).toBeLessThan(0x10000);
		return kind;
	});
	const sizes = { float: 4, uchar: 1, int: 4, ushort: 2 } as const;
	const at = new Map<string, number>();
	let size = 0;
	for (const [, type, name] of head.matchAll(/^property (\w+) (\w+)$/gm)) {
		at.set(name, size);
		size += sizes[type as keyof typeof sizes];
	}
	const view = new DataView(file.buffer, file.byteOffset + head.length + "end_header\n".length);
	const offset = (name: string, i: number) => size * i + (at.get(name) ?? Number.NaN);
	expect(view.byteLength).toBe(size * COUNT);
	return Array.from({ length: COUNT }, (_, i) => ({
		place: new Vector3(...["x", "y", "z"].map((name) => view.getFloat32(offset(name, i), true))),
		instance: view.getInt32(offset("instance", i), true),
		kind: kinds[view.getUint16(offset("class", i), true)],
		berry: view.getInt32(offset("berry_id", i), true),
	}));
}

interface Drawn {
	name: string;
	low: Vector3;
	high: Vector3;
	triangles: Triangle[];
}

/** Everything that a GLB draws, by its nodes' names, where it stands. */
async function drawnIn(glb: Uint8Array): Promise<Drawn[]> {
	const { scene, parser } = await load(glb);
	scene.updateMatrixWorld(true);
	const found: Drawn[] = [];
	const names = documentOf(glb).nodes.map(({ name }) => name);
	scene.traverse((object) => {
		const mesh = object as Mesh;
		if (!mesh.isMesh) return;
		const { position } = mesh.geometry.attributes;
		const index = mesh.geometry.index;
		const corner = (k: number) =>
			new Vector3().fromBufferAttribute(position, index?.getX(k) ?? k).applyMatrix4(mesh.matrixWorld);
		const triangles = Array.from(
			{ length: (index?.count ?? position.count) / 3 },
			(_, k) => new Triangle(corner(3 * k), corner(3 * k + 1), corner(3 * k + 2)),
		);
		const corners = triangles.flatMap(({ a, b, c }) => [a, b, c]);
		const extreme = (by: "min" | "max") => corners.reduce((box, each) => box[by](each), corners[0].clone());
		const node = parser.associations.get(object)?.nodes ?? -1;
		found.push({ name: names[node], low: extreme("min"), high: extreme("max"), triangles });
	});
	return found;
}

const NEAR = 1e-4;

/** The part whose triangle is nearest to a place. */
function nearest(parts: readonly Drawn[], place: Vector3): Drawn | undefined {
	const [low, high] = [place.clone().addScalar(NEAR), place.clone().subScalar(NEAR)];
	const onto = new Vector3();
	let [best, least]: [Drawn | undefined, number] = [undefined, Number.POSITIVE_INFINITY];
	for (const part of parts) {
		if (part.low.x > low.x || part.low.y > low.y || part.low.z > low.z) continue;
		if (part.high.x < high.x || part.high.y < high.y || part.high.z < high.z) continue;
		for (const triangle of part.triangles) {
			const away = triangle.closestPointToPoint(place, onto).distanceToSquared(place);
			if (away < least) [best, least] = [part, away];
		}
	}
	return best;
}

describe("points of a PLY", () => {
	it.each([
		...namesInRun(["riesling", "pizzutello", "merlot", "kyoho", "pinot-noir"], ["riesling", "pizzutello"]).map(
			(name) => [name, {}],
		),
		["redcurrant", { age: 4 }],
		["riesling", { leaves: 1, count: 20 }],
		["short-conical", { procedure: 1, l: 120 }],
	] as [string, Record<string, number>][])(
		"name the part of the nearest triangle of the GLB: %s %j",
		async (preset, settings) => {
			const { points, glb, berries } = await files(preset, settings);
			const parts = await drawnIn(glb);
			// Numbers count the nodes that have a mesh, in the file's order.
			const numbered = documentOf(glb).nodes.filter(({ mesh }) => mesh !== undefined);
			const found = points.map((point) => ({ ...point, by: nearest(parts, point.place)?.name ?? "" }));
			const wrong = found.filter(({ by, instance }) => numbered[instance]?.name !== by);
			expect(wrong.map(({ by, instance }) => [by, numbered[instance]?.name])).toEqual([]);
			for (const { by, kind, berry } of found) {
				expect(kind).toBe(by.replace(/ [\d.]+$/, ""));
				const index = kind === "Berry" ? Number(by.slice("Berry ".length)) - 1 : -1;
				expect(berry).toBe(index < 0 ? -1 : (berries[index].id ?? index));
			}
			expect(new Set(found.map(({ instance }) => instance)).size).toBeGreaterThan(10);
		},
	);

	it("number kinds of parts alike in every bunch, whatever it has of them", async () => {
		const [bare, leafy] = await Promise.all([files("riesling"), files("riesling", { leaves: 1, count: 20 })]);
		expect(bare.points.every(({ kind }) => ["Rachis", "Axis", "Berry"].includes(kind))).toBe(true);
		expect(leafy.points.some(({ kind }) => kind === "Leaf")).toBe(true);
	});
});
