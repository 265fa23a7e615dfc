import { strFromU8, unzipSync } from "fflate";
import { validateBytes } from "gltf-validator";
import { afterEach, describe, expect, it, vi } from "vitest";
import { CoreTrap } from "../../../web/src/core/errors";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import { FILE_KEYS } from "../../../web/src/service/address";
import { makeService } from "../../../web/src/service/service";
import { TagCache } from "../../../web/src/service/tag_cache";
import { compressText } from "../../../web/src/specimen/compressed_text";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { isKnown } from "../../../web/src/specimen/restore";
import { grow } from "../cli/world";
import { freshCore } from "../core/wasm";

const loadCore = vi.fn(freshCore);
const service = makeService({ loadCore, release: "1" });
afterEach(() => void loadCore.mockClear());

const request = (address: string, init?: RequestInit) => service(new Request(`http://plants.example/${address}`, init));
const small = "specimens/redcurrant.json?count=5";

async function refused(address: string, init?: RequestInit): Promise<string> {
	const answer = await request(address, init);
	const { code, args, message } = await answer.json();
	expect(answer.headers.get("content-type")).toBe("application/json");
	expect([typeof code, typeof args]).toEqual(["string", "object"]);
	expect(answer.headers.get("access-control-allow-origin")).toBe("*");
	expect(message).toMatch(/^[^\n]{1,600}$/);
	return `${answer.status} ${message}`;
}

describe("the address of a specimen’s file", () => {
	it("names a preset, and in the query what is otherwise", async () => {
		const answer = await request("specimens/redcurrant.json?seed=7&count=5");
		expect(answer.status).toBe(200);
		const { json } = await grow(["redcurrant", "--seed", "7", "--set", "count=5"]);
		expect(await answer.json()).toEqual({ ...json, timings: { grow: 0 } });
	});

	it("names another model’s preset, or a model alone", async () => {
		const of = async (address: string) => (await (await request(address)).json()).specimen;
		expect(await of("specimens/root/carrot.json?n=200")).toMatchObject({ model: "root", preset: "carrot" });
		const { presets } = await modelNamed("root");
		expect(await of("specimens/root.json?n=200")).toMatchObject({ model: "root", preset: presets.standard });
	});

	it("without a file lists all models with their presets and parameters", async () => {
		const answer = await request("specimens/");
		expect(answer.headers.get("content-type")).toBe("application/json");
		const all = await answer.json();
		expect(all.map(({ model }: { model: string }) => model)).toEqual(modelNames());
		const { table, presets } = await modelNamed("growth");
		const trees = all.find(({ model }: { model: string }) => model === "growth");
		expect(trees.presets).toEqual(presets.list.map(({ name }) => name));
		expect(trees.parameters.map(({ key }: { key: string }) => key)).toEqual(table.entries.map(({ key }) => key));
		expect(await (await request("specimens/", { method: "HEAD" })).text()).toBe("");
	});

	it("is a link under any name, in the query or as a folder", async () => {
		const [one, other] = await Promise.all(
			[
				"a/b/specimens/mine.json?v=2&preset=redcurrant&count=5&seed=9",
				"specimens/v=2&preset=redcurrant&count=5/mine.json?seed=9",
			].map(async (address) => (await request(address)).json()),
		);
		expect(one.specimen).toMatchObject({ preset: "redcurrant", seed: 9, parameters: { count: 5 } });
		expect(other).toEqual(one);
	});

	it("takes the text of a link’s fragment in the query", async () => {
		const text = "axiom: F(0.1)\n";
		const answer = await request(`specimens/own.json?v=2&g=${await compressText(text)}`);
		expect(await answer.json()).toMatchObject({ specimen: { grammar: text } });
	});

	it("brings a link into range with a note, and refuses what was typed", async () => {
		const { notes } = await (await request("specimens/x.json?v=2&preset=redcurrant&count=5&age=900")).json();
		expect(notes).toContainEqual(expect.stringMatching(/^age: 900 is above/));
		expect(await refused("specimens/redcurrant.json?age=900")).toMatch(/^400 age: 900 is above/);
		expect(await refused("specimens/redcurrant.json?colour=red")).toMatch(
			/^400 The model bunch has no parameter “colour”/,
		);
	});

	it.each([
		["gallery/riesling.glb", "404 There is nothing at this address. Write specimens/PRESET.glb"],
		["specimens/riesling", "404 “riesling” is not the name of a file."],
		["specimens/nettle.glb", "404 The model bunch has no preset “nettle”. Its presets are short-conical, "],
		["specimens/fern/oak.glb", "404 There is no model “fern”"],
		["specimens/riesling.doc", "404 The model bunch has no .doc file. Available files: .glb, .web.glb"],
		["specimens/riesling.png", "501 The service cannot draw pictures"],
		["specimens/%E0%A4%A.glb", "400 “%E0%A4%A.glb” is not valid in an address."],
		["specimens/riesling.low.glb?file-triangles=many", "400 file-triangles must be a whole number from 100 to"],
		["specimens/riesling.stl?file-thickness=0.01", "400 file-thickness must be a number from 0.2 to 20."],
		["specimens/riesling.json?file-measures=yes", "400 file-measures must be 0 or 1."],
		[`specimens/riesling.glb?seed=${"1".repeat(30_000)}`, "414 The address is longer than"],
	])("%.40s is refused in a line", async (address, words) => expect(await refused(address)).toContain(words));

	it("has keys for the file that no model’s links have", async () => {
		for (const model of await Promise.all(modelNames().map(modelNamed)))
			expect(FILE_KEYS.filter((key) => isKnown(model, `file-${key}`))).toEqual([]);
	});
});

describe("the files", () => {
	it("are those that the command writes", async () => {
		const answer = await request("specimens/redcurrant.low.glb?count=5&file-triangles=900");
		const bytes = new Uint8Array(await answer.arrayBuffer());
		expect(answer.headers.get("content-type")).toBe("model/gltf-binary");
		expect(answer.headers.get("content-length")).toBe(`${bytes.length}`);
		const call = ["redcurrant", "--set", "count=5", "--form", "low", "--triangles", "900", "--out", "x.glb"];
		const { written } = await grow(call);
		expect(Buffer.from(bytes).equals(Buffer.from(written.get("x.glb") as Uint8Array))).toBe(true);
		const { issues } = await validateBytes(bytes);
		expect(issues.numErrors + issues.numWarnings).toBe(0);
	});

	it("are an OBJ, its materials beside it, and both in an archive", async () => {
		const folder = "specimens/v=2&preset=redcurrant&count=5";
		const [obj, mtl, zip] = await Promise.all(
			["obj", "mtl", "obj.zip"].map(async (ending) => (await request(`${folder}/bunch.${ending}`)).arrayBuffer()),
		);
		const entries = unzipSync(new Uint8Array(zip));
		expect(strFromU8(new Uint8Array(obj))).toContain("mtllib bunch.mtl");
		expect(strFromU8(entries["bunch.obj"])).toBe(strFromU8(new Uint8Array(obj)));
		expect(strFromU8(entries["bunch.mtl"])).toBe(strFromU8(new Uint8Array(mtl)));
	});

	it("are the pictures that the materials name, where the link is a folder; elsewhere those have colours alone", async () => {
		const folder = "specimens/v=2&model=flower&preset=petal";
		const mtl = await (await request(`${folder}/a.mtl`)).text();
		const named = [...mtl.matchAll(/^map_Kd (.*)$/gm)].map(([, name]) => name);
		expect(named.length).toBeGreaterThan(2);
		const entries = unzipSync(new Uint8Array(await (await request(`${folder}/a.obj.zip`)).arrayBuffer()));
		for (const name of named) {
			const answer = await request(`${folder}/${name}`);
			expect(answer.headers.get("content-type")).toBe("image/png");
			expect(new Uint8Array(await answer.arrayBuffer())).toEqual(entries[name]);
		}
		expect(await refused(`${folder}/a-Bark-colour.png`)).toBe("404 No material has the picture “a-Bark-colour.png”.");
		expect(await refused(`${folder}/a.png`)).toContain("501 The service cannot draw pictures");
		const bare = await (await request("specimens/flower/petal.mtl")).text();
		expect(bare).not.toContain("map_Kd");
		expect(bare).not.toContain("Kd 1 1 1");
	});

	it("are a model’s own too, and USDZ", async () => {
		const csv = await request("specimens/redcurrant.csv?count=5");
		expect(csv.headers.get("content-type")).toContain("text/csv");
		expect((await csv.text()).split("\n").length).toBeGreaterThan(5);
		const usdz = await request("specimens/redcurrant.usdz?count=5");
		expect(
			Buffer.from(await usdz.arrayBuffer())
				.subarray(0, 2)
				.toString(),
		).toBe("PK");
	});

	it("show the plant growing, where it has ages", async () => {
		const answer = await request("specimens/redcurrant.growth.glb?count=5");
		const bytes = new Uint8Array(await answer.arrayBuffer());
		const { info } = await validateBytes(bytes);
		expect([answer.status, (info as unknown as { animationCount: number }).animationCount]).toEqual([200, 1]);
		expect(await refused("specimens/redcurrant.growth.glb?v=2&preset=redcurrant&procedure=paper")).toBe(
			"404 This plant has no age data, so its growth cannot be shown. Request another file.",
		);
	});

	it("leave measures out where they are not wanted", async () => {
		const [all, none] = [await (await request(small)).json(), await (await request(`${small}&file-measures=0`)).json()];
		expect(Object.keys(all.measures).length).toBeGreaterThan(10);
		expect(none.measures).toEqual({});
		expect(none.fingerprint).toBe(all.fingerprint);
	});
});

describe("what HTTP asks", () => {
	it("has a tag for what does not change, and says so without growing it again", async () => {
		const answer = await request(small);
		const tag = answer.headers.get("etag") as string;
		const { fingerprint } = await answer.json();
		expect(tag).toMatch(new RegExp(`^"${fingerprint}-[0-9a-f]{8}"$`));
		const fresh = makeService({ loadCore, release: "1" });
		const again = new Request(`http://plants.example/${small}`, { headers: { "if-none-match": `W/"x", ${tag}` } });
		loadCore.mockClear();
		expect((await fresh(again.clone())).status).toBe(304);
		expect(loadCore).toHaveBeenCalledTimes(1);
		const grown = vi.spyOn((await loadCore.mock.results[0].value) as Awaited<ReturnType<typeof freshCore>>, "grow");
		const third = await fresh(again);
		expect([third.status, third.headers.get("etag"), await third.text()]).toEqual([304, tag, ""]);
		expect(grown).not.toHaveBeenCalled();
		const others = [
			`${small}&file-measures=0`,
			"specimens/redcurrant.obj?count=5",
			"specimens/redcurrant.json?count=6",
		];
		for (const other of others) expect((await request(other)).headers.get("etag")).not.toBe(tag);
		const newer = await makeService({ loadCore, release: "2" })(new Request(`http://plants.example/${small}`));
		expect(newer.headers.get("etag")).not.toBe(tag);
	});

	it("answers HEAD without the file, OPTIONS with what there is, and no other method", async () => {
		const head = await request(small, { method: "HEAD" });
		expect([head.status, await head.text()]).toEqual([200, ""]);
		expect(Number(head.headers.get("content-length"))).toBeGreaterThan(1000);
		const options = await request(small, { method: "OPTIONS" });
		expect([options.status, options.headers.get("allow")]).toEqual([204, "GET, HEAD, OPTIONS"]);
		expect(await refused(small, { method: "POST", body: "x" })).toBe("405 Method POST not allowed. Use GET or HEAD.");
	});

	it("says where a grammar is wrong", async () => {
		const packed = await compressText("axiom: F(\n");
		expect(await refused(`specimens/own.json?v=2&g=${packed}`)).toMatch(/^422 grammar:\d+:\d+: /);
	});

	it("goes on with another core after one that broke", async () => {
		const broken = makeService({
			release: "1",
			loadCore: async (wasm) => {
				const core = await loadCore(wasm);
				if (loadCore.mock.calls.length === 1) vi.spyOn(core, "grow").mockThrow(new CoreTrap("broke"));
				return core;
			},
		});
		const request = () => new Request(`http://plants.example/${small}`);
		const first = await broken(request());
		expect([first.status, (await first.json()).code]).toEqual([500, "service.internal_error"]);
		expect((await broken(request())).status).toBe(200);
	});
});

describe("tags that are known", () => {
	it("are as many as it was told, those asked for last", () => {
		const known = new TagCache(2);
		known.keep("a", "1");
		known.keep("b", "2");
		expect(known.tag("a")).toBe("1");
		known.keep("c", "3");
		expect(["a", "b", "c"].map((each) => known.tag(each))).toEqual(["1", undefined, "3"]);
	});
});

it("the standard preset needs no words", async () => {
	const bunch = await modelNamed();
	const { specimen } = await (await request("specimens/x.json?v=2&file-measures=0")).json();
	expect(specimen.preset).toBe(fromPreset(bunch).preset);
});
