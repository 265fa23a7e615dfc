/** A tree for four distances in one file, as readers have it that know MSFT_lod, and as those have it that do not. */
import { readFileSync } from "node:fs";
import { validateBytes } from "gltf-validator";
import { Mesh } from "three";
import { beforeAll, expect, it } from "vitest";
import { CoreCache } from "../../../web/src/core/cores";
import { loadCoreFromBytes } from "../../../web/src/core/loader";
import { makeFile } from "../../../web/src/generate/files/make";
import { growPlant } from "../../../web/src/generate/growth";
import { model } from "../../../web/src/models/growth/index";
import type { GrowthOptions } from "../../../web/src/models/model";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../web/src/specimen/specimen";
import { documentOf, load } from "./reading";

const cores = new CoreCache(async (wasm) =>
	loadCoreFromBytes(readFileSync(new URL(`../../../build/core/${wasm}`, import.meta.url))),
);
const grow = (specimen: Specimen, wanted: GrowthOptions = {}) =>
	growPlant(model, specimen, wanted, (wasm, blocks) => cores.grow(wasm, blocks));

let glb: Uint8Array;
beforeAll(async () => {
	const specimen = { ...fromPreset(model, "oak"), seed: 5 };
	const grown = await grow(specimen);
	const request = { model: model.name, format: "glb-lod", grown, specimen, link: "https://x/?v=2", name: "oak" };
	glb = new Uint8Array(await (await makeFile(model, request, grow)).arrayBuffer());
});

it("says its levels as the extension has it: the finest stands in the scene and names the others, which cover ever less", () => {
	const { nodes, meshes = [], accessors = [], extensionsUsed, extensionsRequired, ...rest } = documentOf(glb);
	expect([...(extensionsUsed ?? [])].sort()).toEqual(["KHR_materials_diffuse_transmission", "MSFT_lod"]);
	expect(extensionsRequired).toBeUndefined();
	const { scenes } = rest as unknown as { scenes: { nodes: number[] }[] };
	const [root] = scenes[0].nodes;
	const [first, ...none] = nodes[root].children ?? [];
	expect(none).toEqual([]);
	const { ids } = (nodes[first].extensions as { MSFT_lod: { ids: number[] } }).MSFT_lod;
	expect(ids).toHaveLength(3);
	// No other node has them: a node has at most one parent.
	for (const { children = [] } of nodes) for (const id of ids) expect(children).not.toContain(id);
	const { MSFT_screencoverage: coverage } = nodes[first].extras as { MSFT_screencoverage: number[] };
	expect(coverage).toHaveLength(4);
	for (const [i, share] of coverage.entries()) expect(share).toBeLessThan(i === 0 ? 1 : coverage[i - 1]);
	const corners = (at: number): number => {
		const { mesh, children = [] } = nodes[at];
		const own = mesh === undefined ? 0 : accessors[meshes[mesh].primitives[0].indices].count;
		return children.reduce((sum, child) => sum + corners(child), own);
	};
	const counts = [first, ...ids].map(corners);
	for (const [i, count] of counts.entries()) if (i > 0) expect(count).toBeLessThan(0.5 * counts[i - 1]);
	expect(counts[3]).toBeGreaterThan(30);
});

it("is a tree of one level to who knows no levels, and no validator minds", async () => {
	const { scene } = await load(glb);
	const names: string[] = [];
	scene.traverse((each) => {
		if (each instanceof Mesh) names.push(each.parent?.name ?? "");
	});
	expect(new Set(names)).toEqual(new Set(["Level_0"]));
	const { issues } = await validateBytes(glb, { maxIssues: 0 });
	// The remaining infos: the validator does not know the extension, and only the extension names the other levels.
	const codes = issues.messages.map(({ code, severity }) => `${severity} ${code}`);
	expect(new Set(codes)).toEqual(new Set(["2 UNSUPPORTED_EXTENSION", "2 UNUSED_OBJECT"]));
});
