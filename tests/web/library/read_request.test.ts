import { describe, expect, it } from "vitest";
import { linkIn, readSource, readValues, SpecimenError } from "../../../web/src/library/read_request";
import { formatLink, grow, parseLink, type Values } from "./growing";

const seen = async (read: Promise<{ specimen: { model: string; preset: string; seed: number } }>) => {
	const { model, preset, seed } = (await read).specimen;
	return [model, preset, seed];
};

describe("a text", () => {
	it("is a preset’s name, a model’s, or a link", async () => {
		expect(await seen(readSource("merlot"))).toEqual(["bunch", "merlot", 1]);
		expect(await seen(readSource("leaf/oak"))).toEqual(["leaf", "oak", 1]);
		expect((await seen(readSource("tree")))[0]).toBe("tree");
		expect(await seen(readSource("?v=2&preset=merlot&seed=9"))).toEqual(["bunch", "merlot", 9]);
		expect(await seen(readSource("https://a.example/b/?v=2&model=root&preset=carrot#x"))).toEqual([
			"root",
			"carrot",
			1,
		]);
		// A link from the command line to another model's preset is a link all the same.
		expect(await seen(readSource("https://leaf.example/oak"))).toEqual(["bunch", "long-conical", 1]);
	});

	it.each([
		["nettle", "preset: “nettle” is neither a preset nor a link. presets() returns all presets."],
		["leaf/nettle", "preset: The model leaf has no preset “nettle”. presets() returns all presets."],
		["leaf/oak/red", "preset: “leaf/oak/red” is neither a preset nor a link. presets() returns all presets."],
	])("is refused where it is none: %s", async (text, message) => {
		const error = await readSource(text).catch((each) => each);
		expect(error).toBeInstanceOf(SpecimenError);
		expect([error.name, error.key, error.message]).toEqual(["SpecimenError", "preset", message]);
	});

	it("has its link where its query and fragment are", () => {
		expect(linkIn("?a=1#g=2")).toEqual({ query: "?a=1", fragment: "#g=2" });
		expect(linkIn("#g=2?a")).toEqual({ query: "", fragment: "#g=2?a" });
		expect(linkIn("https://a.example/")).toEqual({ query: "", fragment: "" });
		expect(linkIn("leaf/oak")).toBeUndefined();
	});
});

describe("values by their keys", () => {
	it("are of now, whatever version an old link would be of", async () => {
		const { specimen } = await readValues({ preset: "short-conical" });
		expect(specimen.parameters).toEqual((await readSource("short-conical")).specimen.parameters);
		expect(await seen(readValues({ model: "leaf", seed: 3 }))).toEqual(["leaf", "grapevine", 3]);
	});

	it("may be a whole specimen, as a file has it", async () => {
		const { specimen } = await grow(
			{ preset: "merlot", seed: 3, age: 70, skin: "aa0000" },
			{ meshes: false, measures: false },
		);
		const written = JSON.parse(JSON.stringify(specimen));
		expect(written.parameters).toMatchObject({ age: 70, procedure: "natural" });
		expect(await formatLink(written)).toBe("?v=2&preset=merlot&seed=3&age=70&skin=aa0000");
	});

	it.each([
		[
			{ model: "fern" },
			"model",
			"There is no model “fern”. The models are bunch, flower, grammar, growth, leaf, root, stand, tree.",
		],
		[{ preset: "nettle" }, "preset", "The model bunch has no preset “nettle”. presets() returns all presets."],
		[{ preset: 3 }, "preset", "The model bunch has no preset 3. presets() returns all presets."],
		[{ age: 900 }, "age", "900 is above the maximum, 125."],
		[{ age: "old" }, "age", "“old” is not a number."],
		[{ seed: -1 }, "seed", "-1 is below the minimum, 0."],
		[{ ages: 9 }, "ages", "The model bunch has no such parameter. parameters() returns all parameters."],
	])("are refused where they cannot be used: %o", async (values, key, problem) => {
		const error = await grow(values as Values).catch((each) => each);
		expect([error.name, error.key, error.problem, error.message]).toEqual([
			"SpecimenError",
			key,
			problem,
			`${key}: ${problem}`,
		]);
	});
});

describe("links", () => {
	it("are read whatever they say, and written anew", async () => {
		const { specimen, notes } = await parseLink("https://a.example/?v=2&preset=merlot&age=900&x=1");
		expect(specimen).toMatchObject({ preset: "merlot", parameters: { age: 125, procedure: "natural" } });
		expect(notes).toEqual([
			"age: 900 is above the maximum, 125. Using 125.",
			"x: There is no such parameter. This part was ignored.",
		]);
		expect(await formatLink(specimen, "https://b.example/")).toBe("https://b.example/?v=2&preset=merlot&age=125");
		expect(await formatLink("?v=1&preset=duku")).toMatch(/^\?v=2&preset=duku&.*procedure=paper/);
	});

	it("are asked for where there is none", async () => {
		await expect(parseLink("merlot")).rejects.toThrow(
			"link: “merlot” is not a link. A link looks like ?v=2&preset=merlot&seed=7.",
		);
	});
});
