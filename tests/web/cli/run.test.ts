import { describe, expect, it } from "vitest";
import { run } from "../../../web/src/cli/run";
import { PRESETS } from "../../../web/src/models/bunch/presets/presets";
import { encodeLink, restore, specimenFromPreset, withParameters } from "../bunch";
import { documentOf } from "../formats/reading";
import { complaint, grow, memoryWorld } from "./world";

const meant = (json: { specimen: unknown }) => restore(json.specimen).specimen;

describe("the JSON", () => {
	it("is all that standard output gets, and has every field", async () => {
		const { status, json, printed, messages } = await grow(["shouldered-conical", "--set", "procedure=paper"]);
		expect(status).toBe(0);
		expect(printed).toHaveLength(1);
		expect(messages).toEqual([]);
		const fields = ["specimen", "plan", "counts", "berries", "internodes", "notes", "fingerprint", "timings"];
		expect(Object.keys(json)).toEqual(expect.arrayContaining(fields));
		expect(meant(json)).toEqual(specimenFromPreset("shouldered-conical", 1));
		expect(json.plan).toMatchObject({ m: 13, sides: [{ w: 190, r: 130, n: 8, rd: 7 }, {}, {}, {}] });
		expect(json.plan.axes).toHaveLength(12);
		expect(json.berries).toHaveLength(json.counts.berries);
		expect(json.internodes).toHaveLength(json.counts.internodes);
		expect(json.internodes[0].parent).toBe(-1);
		expect(json.timings.grow).toBeGreaterThan(0);
	});

	it("has of any plant its segments, parents first, and its organs", async () => {
		const { json } = await grow(["rubus"]);
		for (const key of ["specimen", "counts", "measures", "notes", "fingerprint", "timings", "segments", "organs"]) {
			expect(json).toHaveProperty(key);
		}
		expect(json.measures.berry_count).toBe(json.counts.berries);
		expect(json.measures.coverage).toBeGreaterThan(0.5);
		expect(json.segments).toHaveLength(json.internodes.length);
		json.segments.forEach((segment: Record<string, unknown>, index: number) => {
			const { kind, parent, start, end, radius, radiusEnd } = json.internodes[index];
			expect(segment).toEqual({ kind, parent, start, end, radius, radiusEnd });
			expect(parent).toBeLessThan(index);
		});
		expect(json.organs).toHaveLength(json.berries.length);
		const [berry] = json.berries;
		expect(json.organs[0]).toMatchObject({ kind: "berry", segment: berry.parent, radius: berry.r });
		expect(json.organs[0].position).toEqual([berry.x, berry.y, berry.z]);
	});

	it("has the second bunch's plan where there is one", async () => {
		expect((await grow(["?v=1&preset=double-bunch-winged"])).json.plan.second.m).toBe(10);
		expect((await grow(["?v=1&preset=cylindrical"])).json.plan).not.toHaveProperty("second");
	});

	it("is the default preset's without a word said", async () => {
		const { json, messages } = await grow([]);
		expect(meant(json)).toEqual(specimenFromPreset());
		expect([json.notes, messages]).toEqual([[], []]);
		expect(json.counts.berries).toBeGreaterThan(100);
	});
});

describe("many models", () => {
	it("are listed with their titles, presets and parameters", async () => {
		const { status, printed, messages } = await grow(["--list"]);
		expect([status, messages]).toEqual([0, []]);
		const all: { model: string; title: string; preview?: boolean; presets: string[]; parameters: object[] }[] =
			JSON.parse(printed[0]);
		expect(all.filter(({ preview }) => preview).map(({ model }) => model)).toEqual([
			"flower",
			"growth",
			"leaf",
			"root",
			"stand",
			"tree",
		]);
		const [bunch] = all;
		expect(bunch).toMatchObject({ model: "bunch", title: "Grape bunch" });
		expect(bunch.presets).toEqual(PRESETS.map(({ name }) => name));
		expect(bunch.parameters).toContainEqual(expect.objectContaining({ key: "age", kind: "number", min: 0 }));
	});

	it("have presets named after them; the default's keep their bare names", async () => {
		const { fingerprint } = (await grow(["rubus"])).json;
		expect((await grow(["bunch/rubus"])).json.fingerprint).toBe(fingerprint);
		expect((await grow(["bunch"])).json.specimen.preset).toBe("long-conical");
		expect(await complaint(["bunch/plum"])).toBe("The model bunch has no preset “plum”. --list shows all presets.");
		expect(await complaint(["leaf/oak/red"])).toMatch(/neither a preset nor a link/);
	});
});

describe("what is asked for", () => {
	it("may be a link, whole or from its ? on", async () => {
		const specimen = { ...withParameters(specimenFromPreset("duku"), { l: 300, p3w: 12 }), seed: 5 };
		const link = await encodeLink(specimen);
		for (const each of [link, `https://example.org/panicle/${link}`, `http://localhost:5173/index.html${link}#top`]) {
			const { json } = await grow([each]);
			expect(meant(json)).toEqual(specimen);
			expect(json.notes).toEqual([]);
		}
		expect(meant((await grow(["https://example.org/panicle/"])).json)).toEqual(specimenFromPreset());
	});

	it("may be a link with a grammar", async () => {
		const specimen = { ...specimenFromPreset(undefined, 1), grammar: "axiom: F(10)[+F(5)]F(10)\n" };
		const link = await encodeLink(specimen);
		const { json } = await grow([`https://example.org/${link}`]);
		expect(meant(json)).toEqual(specimen);
		expect(json.counts.internodes).toBe(3);
		expect((await grow([link.slice(link.indexOf("#"))])).json.counts.internodes).toBe(3);
	});

	it("is brought into range where a link says it, with notes after the core's", async () => {
		const { status, json, messages } = await grow(["?l=9999&plum=1"]);
		expect(status).toBe(0);
		expect(json.specimen.parameters.l).toBe(580);
		expect(json.notes).toEqual([
			"l: 9999 is above the maximum, 580. Using 580.",
			"plum: There is no such parameter. This part was ignored.",
		]);
		expect(messages).toEqual([]);
	});

	it("is the paper's procedure where an old link says it, natural where a preset is named", async () => {
		for (const old of ["?preset=rubus", "?v=1&preset=rubus"]) {
			expect(meant((await grow([old])).json)).toEqual(specimenFromPreset("rubus", 1));
		}
		for (const now of ["rubus", "?v=2&preset=rubus"]) {
			expect(meant((await grow([now])).json)).toEqual(specimenFromPreset("rubus"));
		}
	});

	it("takes choices by name and by number", async () => {
		const { json } = await grow(["rubus", "--set", "procedure=paper", "--set", "fruit=2", "--set", "cane=on"]);
		expect(meant(json).parameters).toMatchObject({ procedure: 0, fruit: 2, cane: 1 });
	});

	it("takes berries off that are named", async () => {
		const whole = (await grow(["rubus"])).json;
		const id: number = whole.berries[0].id;
		const { json } = await grow(["rubus", "--set", `thin=${id.toString(36)}`]);
		expect(meant(json).thinned).toEqual([id]);
		expect(json.counts.berries).toBe(whole.counts.berries - 1);
		expect(meant((await grow(["?v=2&thin=a.b", "--set", "thin="])).json).thinned).toEqual([]);
	});

	it("says what the procedure does not heed", async () => {
		const { status, json } = await grow([
			"--set",
			"rmin=10",
			"--set",
			"m=3",
			"--set",
			"size=15",
			"--set",
			"skin=ffffff",
		]);
		expect(status).toBe(0);
		expect(json.notes).toEqual([
			"rmin: This parameter has no effect with procedure=natural. Add --set procedure=paper.",
			"m: This parameter has no effect with procedure=natural. Add --set procedure=paper.",
		]);
		expect((await grow(["?v=1", "--set", "rmin=10", "--set", "size=15"])).json.notes).toEqual([
			"size: This parameter has no effect with procedure=paper. Add --set procedure=natural.",
		]);
	});

	it("takes seed and settings on top of preset or link", async () => {
		const words = [
			"--set",
			"p3=79,76",
			"?v=2&l=300&seed=2&vary=0",
			"--seed",
			"9",
			"--set",
			"p4w=100",
			"--set=skin=ffffff",
		];
		const { json } = await grow(words);
		expect(json.specimen).toMatchObject({
			seed: 9,
			parameters: { l: 300, p3w: 79, p3r: 76, p4w: 100, vary: 0 },
			look: { skin: "ffffff" },
		});
	});

	it("takes the last of what is given twice", async () => {
		const { json } = await grow(["--set", "l=100", "--seed", "3", "--set", "l=200", "--seed", "4"]);
		expect(json.specimen).toMatchObject({ seed: 4, parameters: { l: 200 } });
	});

	it("takes two decimals, and colours that look like numbers", async () => {
		const { json } = await grow(["--set", "l=300.29", "--set", "p4w=64.35", "--set", "skin=123e99"]);
		expect(json.specimen).toMatchObject({ parameters: { l: 300.29, p4w: 64.35 }, look: { skin: "123e99" } });
	});

	it("takes the grammar's inputs", async () => {
		const { json } = await grow(["--set", "m=3", "--set", "n=1,2", "--set", "procedure=paper"]);
		expect(json.specimen.inputs).toEqual({ m: 3, n: [1, 2] });
		expect(json.plan).toMatchObject({ m: 3, axes: [2, 1] });
	});
});

describe("files", () => {
	it("are a GLB", async () => {
		const { status, written, printed } = await grow(["rubus", "--out", "a/rubus.glb"]);
		expect(status).toBe(0);
		expect(printed).toEqual([]);
		const glb = written.get("a/rubus.glb") as Uint8Array;
		expect(new TextDecoder().decode(glb.subarray(0, 4))).toBe("glTF");
	});

	it("have the leaves that were asked for", async () => {
		const { written, messages } = await grow(["rubus", "--set", "leaves=2", "--out", "leafy.glb"]);
		const names = documentOf(written.get("leafy.glb") as Uint8Array).nodes.map(({ name }) => name);
		expect(names.filter((name) => name.startsWith("Leaf"))).toEqual(["Leaf 1", "Leaf 2"]);
		expect(messages).toEqual([]);
	});

	it("are of a model's own forms, by endings that viewers know", async () => {
		const small = ["leaf/oak", "--set", "n=60", "--out"];
		const { written, messages } = await grow([...small, "oak.baked.glb"]);
		expect(messages).toEqual([]);
		const sheer = (glb: unknown) =>
			documentOf(glb as Uint8Array).extensionsUsed?.includes("KHR_materials_volume") ?? false;
		expect(sheer(written.get("oak.baked.glb"))).toBe(true);
		const plain = await grow([...small, "oak-baked.glb"]);
		expect(sheer(plain.written.get("oak-baked.glb"))).toBe(false);
		expect((await grow([...small, "oak.glb-baked"])).messages[0]).toContain(".svg or .baked.glb");
	});

	it("are an OBJ with the MTL that it names beside it", async () => {
		const { written } = await grow(["rubus", "--out", "a.b/Rubus.OBJ"]);
		const pictures = ["Stem", "Skin", "Flower"].map((material) => `a.b/Rubus-${material}-colour.png`);
		expect([...written.keys()]).toEqual(["a.b/Rubus.OBJ", "a.b/Rubus.mtl", ...pictures]);
		expect(written.get("a.b/Rubus.OBJ")).toContain("mtllib Rubus.mtl");
		expect(written.get("a.b/Rubus.mtl")).toContain("newmtl");
	});

	it("are the JSON that standard output would have got", async () => {
		const { written } = await grow(["rubus", "--out", "rubus.json"]);
		const { timings: _, ...ours } = JSON.parse(written.get("rubus.json") as string);
		const { timings: __, ...printed } = (await grow(["rubus"])).json;
		expect(ours).toEqual(printed);
	});

	it("are a table of the berries", async () => {
		const { written, json } = await grow(["rubus", "--out", "rubus.csv"]);
		expect(json).toBeUndefined();
		const [header, ...rows] = (written.get("rubus.csv") as string).trimEnd().split("\r\n");
		expect(header).toMatch(/^preset,seed,berry,id,x_mm/);
		expect(rows).toHaveLength((await grow(["rubus"])).json.berries.length);
	});

	it("are a table of the measures", async () => {
		const { written } = await grow(["rubus", "--out", "rubus.measures.csv"]);
		const { berries, measures } = (await grow(["rubus"])).json;
		const rows = (written.get("rubus.measures.csv") as string).trimEnd().split("\r\n");
		expect(rows).toHaveLength(2 + Object.keys(measures).length);
		expect(rows.find((row) => row.includes(",berry_count,"))).toContain(`,${berries.length},`);
	});

	it("leave notes to standard error", async () => {
		const { status, messages } = await grow(["?l=1", "--out", "x.json"]);
		expect(status).toBe(0);
		expect(messages).toEqual(["note: l: 1 is below the minimum, 29. Using 29."]);
	});
});

it("--help says all there is, and grows nothing", async () => {
	const { status, printed } = await grow(["--help"]);
	expect(status).toBe(0);
	expect(printed[0]).toContain("--set KEY=VALUE");
	for (const word of [
		"bunch/long-conical",
		"MODEL/PRESET",
		"double-bunch-winged",
		"pinot-noir",
		"procedure=paper|natural",
		"cane=off|on",
		"thin=ID.ID",
	]) {
		expect(printed[0]).toContain(word);
	}
	for (const line of printed[0].split("\n")) expect(line.length).toBeLessThan(120);
});

it("asks for the model's own core", async () => {
	const memory = memoryWorld();
	const requested: string[] = [];
	const loadCore = (wasm: string) => {
		requested.push(wasm);
		return memory.world.loadCore(wasm);
	};
	expect(await run(["rubus"], { ...memory.world, loadCore })).toBe(0);
	expect(requested).toEqual(["bunch.wasm"]);
});

it("a core that is missing or breaks is another exit status", async () => {
	const memory = memoryWorld();
	const loadCore = async () => {
		throw new Error("ENOENT: no such file,\nopen panicle.wasm");
	};
	expect(await run([], { ...memory.world, loadCore })).toBe(1);
	expect(memory.messages).toEqual(["grow: ENOENT: no such file, open panicle.wasm"]);
});
