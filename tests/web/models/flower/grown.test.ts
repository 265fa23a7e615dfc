import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import type { Core } from "../../../../web/src/core/core";
import { coreText, loadCoreMessages } from "../../../../web/src/core/core_message";
import { exportJson } from "../../../../web/src/formats/json";
import { type FlowerPlant, readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import { volumesTable } from "../../../../web/src/models/flower/record";
import type { FlowerRequestOptions } from "../../../../web/src/models/flower/request";
import type { FlowerSpecimen } from "../../../../web/src/models/flower/specimen";
import { fetchedText, fetchTexts } from "../../../../web/src/models/flower/texts";
import { everyPart } from "../../../../web/src/plant/part";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { inRun } from "../../../long_run.mjs";
import { freshCore } from "../../core/wasm";

let core: Core;
beforeAll(async () => {
	await fetchTexts();
	await loadCoreMessages();
	core = await freshCore("flower.wasm");
});

const grow = (specimen: FlowerSpecimen, options?: FlowerRequestOptions): FlowerPlant =>
	readFlowerPlant(core.grow(model.encode(specimen, options)));

describe("a flower", () => {
	it("has notes only about unsewn volumes and about readings of the printed grammars, for every preset", () => {
		const allowed = /but not joined|ten numbers|without numbers|renames “BASEC” to “BASE”/;
		for (const { name } of model.presets.list) {
			const { notes, counts } = grow(fromPreset(model, name), { meshes: false, map: false });
			expect(
				notes.map(coreText).filter((note) => !allowed.test(note)),
				name,
			).toEqual([]);
			expect(counts.darts, name).toBeGreaterThan(2000);
		}
	});

	it("grows at both ends of its ranges, for every preset", () => {
		const names = inRun(
			["rose", "double-umbel"],
			model.presets.list.map(({ name }) => name),
		);
		const ends = model.table.core.flatMap(({ key, min, max }) => [min, max].map((value) => ({ key, value })));
		const refused = names.flatMap((name) =>
			ends.flatMap(({ key, value }) => {
				const { parameters, ...specimen } = fromPreset(model, name);
				try {
					grow({ ...specimen, parameters: { ...parameters, [key]: value } }, { meshes: false, map: false });
					return [];
				} catch (error) {
					return [`${name}, ${key} ${value}: ${(error as Error).message}`];
				}
			}),
		);
		expect(ends.length).toBeGreaterThan(4);
		expect(refused).toEqual([]);
	});

	it("is one connected map if organs have as many sides as their parents: all of a designed tulip but its blades", () => {
		const { volumes } = grow(fromPreset(model, "designed-tulip"), { meshes: false });
		const name = (volume: number) => volumes.labels[volumes.label[volume]];
		const apart = [...volumes.attached.keys()].filter((volume) => volumes.attached[volume] === 1);
		// Six petals and two leaves.
		expect(apart.map(name)).toEqual(Array.from({ length: 8 }, () => "VEIN"));
		for (const sewn of ["RING1", "RING2", "FILAMENT", "ANTHER", "OVARY", "STIGMA"])
			expect(volumes.labels, sewn).toContain(sewn);
	});

	it("is a module of the meadow of figure 24, whose seeds are volumes of its ground", () => {
		const { volumes, notes } = grow(fromPreset(model, "meadow-of-tulips"), { meshes: false });
		const name = (volume: number) => volumes.labels[volumes.label[volume]];
		const all = [...volumes.label.keys()];
		const cups = all.filter((volume) => name(volume) === "CUP");
		expect(cups.length).toBeGreaterThan(15);
		const onSeed = (volume: number): boolean =>
			name(volume) === "SEED" || (volumes.parent[volume] < volume && onSeed(volumes.parent[volume]));
		expect(cups.every(onSeed)).toBe(true);
		// Each has six tepals; 13 steps of the grammar glue the ground.
		const tepals = all.filter(
			(volume) => name(volume) === "VEIN" && ["CUP", "TOP"].includes(name(volumes.parent[volume])),
		);
		expect(tepals).toHaveLength(6 * cups.length);
		expect(all.filter((volume) => name(volume) === "SEED").length).toBeGreaterThan(1.5 * cups.length);
		expect(coreText(notes.join(" "))).not.toContain("never applied");
	});

	it("has the same measures, counts and notes without meshes", () => {
		const specimen = {
			...fromPreset(model, "figure-16"),
			grammar: "#define A(6,0,0,0,9,3,3,300)\n#axiom: A\nA -> A[A]_{E}",
		};
		const [with_, without] = [true, false].map((meshes) => exportJson(model, grow(specimen, { meshes }), specimen));
		expect(without.measures.surface).toBeGreaterThan(1);
		expect(without.counts.triangles).toBeGreaterThan(100);
		expect([without.measures, without.counts, without.notes]).toEqual([with_.measures, with_.counts, with_.notes]);
		expect(coreText(without.notes?.join() ?? "")).toContain("Line 1: “A” has m = 300");
	});

	it("has its map in the JSON document, with involutions as αs", () => {
		const specimen = fromPreset(model, "petal");
		const grown = grow(specimen);
		const {
			alpha = [],
			volume = [],
			position = [],
			order,
			label,
			parent,
			face,
			attached,
		} = exportJson(model, grown, specimen);
		expect(volume).toHaveLength(grown.counts.darts);
		expect(position).toHaveLength(grown.counts.darts);
		expect(order).toHaveLength(grown.counts.volumes);
		expect(label).toContain("VEIN");
		expect(alpha).toHaveLength(4);
		const [a0, a1, a2, a3] = alpha;
		const wrong: [string, number][] = [];
		for (let dart = 0; dart < volume.length; dart++) {
			const must = (what: string, holds: boolean) => holds || wrong.push([what, dart]);
			for (const a of alpha) must("involution", a[a[dart]] === dart);
			for (const a of [a0, a1, a2]) must("of one volume", a[dart] !== dart && volume[a[dart]] === volume[dart]);
			for (const [a, b] of [
				[a0, a2],
				[a0, a3],
				[a1, a3],
			])
				must("product", b[a[b[a[dart]]]] === dart);
			for (const a of [a1, a2, a3]) must("corner", `${position[a[dart]]}` === `${position[dart]}`);
		}
		expect(wrong).toEqual([]);
		// As docs/generalized-maps.md numbers darts: of one that no split has touched the face follows from the number.
		const faceOf = (dart: number) => {
			const [n, at] = [order[volume[dart]], dart - volume.indexOf(volume[dart])];
			return at < 2 * n ? 0 : at < 4 * n ? 1 : 2 + Math.floor((at - 4 * n) / 8);
		};
		const few = Array.from({ length: 40 }, (_, i) => Math.floor((i * volume.length) / 40));
		for (const dart of few) {
			expect([a0, a1].map((a) => faceOf(a[dart]))).toEqual([faceOf(dart), faceOf(dart)]);
			expect(faceOf(a2[dart])).not.toBe(faceOf(dart));
		}
		// Each is sewn to its stated face.
		expect([parent[0], face[0], attached]).toEqual([-1, null, []]);
		for (let v = 1; v < order.length; v += 13) {
			const beyond = a3[volume.indexOf(v)];
			expect([volume[beyond], ["O", "E"][faceOf(beyond)] ?? `C${faceOf(beyond) - 1}`]).toEqual([parent[v], face[v]]);
		}
	});

	it("lists attached volumes, which are not sewn to their face", () => {
		const grammar =
			"#define A(6,0,0,0,9,3,3,1)\n#define B(5)\n#define C(4)\n#axiom: A\n#define finalStep=1\nA -> A[B]_{E,C2}[C]_{C4}";
		const specimen = { ...fromPreset(model), grammar };
		const { alpha = [], volume = [], face, attached } = exportJson(model, grow(specimen), specimen);
		expect([attached.map((v) => face[v]), face.length]).toEqual([["E", "C2"], 4]);
		for (const v of attached) expect(alpha[3][volume.indexOf(v)]).toBe(volume.indexOf(v));
	});

	it("has one root segment and every other segment behind its parent, including split volumes", () => {
		const grammar = "#define A(4,0,0,0,8,2,2,1)\n#axiom: A\n#define finalStep=3\nA -E-> A A";
		const { segments } = grow({ ...fromPreset(model), grammar }, { meshes: false });
		const parents = [...segments.parent];
		expect(parents).toHaveLength(8);
		expect(parents.filter((parent) => parent < 0)).toHaveLength(1);
		for (const [i, parent] of parents.entries()) expect(parent).toBeLessThan(i);
	});

	it("has the fingerprint that the function printed in docs/fingerprint.md makes of its document", () => {
		const source = readFileSync("docs/fingerprint.md", "utf8").match(/```js\n([\s\S]*?)```/)?.[1] ?? "";
		const printed: (document: unknown) => string = new Function(`${source}; return flowerFingerprint;`)();
		for (const preset of ["tulip", "petal", "table-3"]) {
			const specimen = fromPreset(model, preset);
			const grown = grow(specimen, { meshes: false });
			const document = exportJson(model, grown, specimen);
			expect(printed(JSON.parse(JSON.stringify(document))), preset).toBe(grown.fingerprint);
		}
	});

	it("has another fingerprint if only its petals are wider", () => {
		const tulip = fromPreset(model, "tulip");
		const text = fetchedText(tulip) ?? "";
		const print = (grammar: string) => grow({ ...tulip, grammar }, { meshes: false, map: false }).fingerprint;
		const wider = text.replace("wide=size*(22+14*open)", "wide=size*(26+14*open)");
		expect(wider).not.toBe(text);
		expect(print(wider)).not.toBe(print(text));
	});

	it("is closed in all its skin, and each triangle faces outwards", () => {
		const parts = [...everyPart(model.parts(grow(fromPreset(model, "petal"))))];
		let volume = 0;
		const met = new Map<string, number>();
		for (const { shape } of parts) {
			if (!shape) continue;
			const { positions, indices } = shape.mesh;
			const at = (i: number) => [...positions.subarray(3 * i, 3 * i + 3)];
			for (let i = 0; i < indices.length; i += 3) {
				const [a, b, c] = [at(indices[i]), at(indices[i + 1]), at(indices[i + 2])];
				volume +=
					a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
				for (const [from, to] of [
					[a, b],
					[b, c],
					[c, a],
				]) {
					const [there, back] = [`${from} ${to}`, `${to} ${from}`];
					met.set(there, (met.get(there) ?? 0) + 1);
					met.set(back, (met.get(back) ?? 0) - 1);
				}
			}
		}
		expect(volume).toBeGreaterThan(0);
		expect([...met.values()].filter((left) => left !== 0)).toEqual([]);
	});

	it("blends from the colour of an organ's foot to that of its tip, as in the text", () => {
		const text = '#define A(4,0,0,0,5,5,5,3)\n#axiom: A\nA -> A[A]_{E}\n#material 3 petal "ff0000" "0000ff"';
		const [{ name, shape }] = [...model.parts(grow({ ...fromPreset(model), grammar: text }))];
		expect(name).toBe("Petal");
		const { positions, colours = new Float32Array() } = shape?.mesh ?? { positions: new Float32Array() };
		for (let v = 0; v < positions.length / 3; v++) {
			const high = positions[3 * v + 1];
			if (high < 0.004) expect(colours[3 * v]).toBeGreaterThan(0.95);
			if (high > 0.05) expect(colours[3 * v + 2]).toBeGreaterThan(0.95);
		}
	});

	it("is a table with a line for each volume", () => {
		const specimen = {
			...fromPreset(model, "tulip"),
			grammar: "#define A(6,0,0,0,9,3,3,1)\n#axiom: A\n#define finalStep=1\nA -> A[A(,5)]_{E}",
		};
		expect(volumesTable(grow(specimen, { meshes: false })).split("\r\n")).toEqual([
			"volume,parent,face,attached,label,order,line,N,T,atx,aty,atz,H,L,W,m",
			"0,,,0,A,6,,6,1,0,0,0,9,3,3,1",
			"1,0,E,0,A,6,4,6,1,5,0,0,9,3,3,1",
			"",
		]);
	});

	it("is known by its text", () => {
		const claims = model.details.find((each) => each.claims)?.claims;
		expect(claims?.("#define A(4)\n#axiom: A\nA -> A[A]_ {E}")).toBe(true);
		expect(claims?.("#axiome: A\nA->A[&B]C1,C2")).toBe(true);
		expect(claims?.("axiom: A\nA --> F[+A]F")).toBe(false);
		expect(claims?.('tree -> DivFunc("sigma1"){branches}')).toBe(false);
		// Backtracking over the blanks would not end.
		expect(claims?.(`]${" ".repeat(50_000)}`)).toBe(false);
	});
});
