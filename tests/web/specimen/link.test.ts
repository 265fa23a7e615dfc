import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { hasPacked } from "../../../web/src/specimen/link";
import { inRun } from "../../long_run.mjs";
import {
	BUNCH,
	decodeLink,
	decodeQuery,
	encodeLink,
	encodeQuery,
	type Specimen,
	specimenFromPreset,
	thin,
	withParameters,
} from "../bunch";
import { anySpecimen } from "./arbitrary";

async function throughLink(specimen: Specimen) {
	const url = new URL(await encodeLink(specimen), "https://example.org/bunch/");
	return decodeLink(url.search, url.hash);
}

describe("a link", () => {
	it("of the default bunch says its version and nothing else", () => {
		expect(encodeQuery(specimenFromPreset())).toBe("?v=2");
		expect(encodeQuery(specimenFromPreset("duku"))).toBe("?v=2&preset=duku");
	});

	it("holds only what differs from its preset, in the paper's pixels, commas as they are", () => {
		const edited = withParameters(specimenFromPreset("short-conical"), { l: 300, p3w: 80.5, fit: 0 });
		expect(encodeQuery({ ...edited, seed: 7 })).toBe("?v=2&preset=short-conical&seed=7&l=300&p3=80.5,76&fit=0");
	});

	it("survives an address bar letter for letter", async () => {
		const specimen = { ...specimenFromPreset(), inputs: { m: 3, n: [1, 2] }, grammar: "axiom: F(1)[+F(2)]\n" };
		const link = await encodeLink(specimen);
		expect(new URL(link, "https://example.org/").href).toBe(`https://example.org/${link}`);
		expect(link).toMatch(/^\?v=2&m=3&n=1,2#g=[\w-]+$/);
	});

	it("brings any specimen back exactly, without a note", async () => {
		await fc.assert(
			fc.asyncProperty(anySpecimen, async (specimen) => {
				expect(await throughLink(specimen)).toEqual({ specimen, notes: [] });
			}),
			{ numRuns: inRun(120, 500) },
		);
	});

	it("of a typical edited bunch is short", () => {
		const edited = withParameters(specimenFromPreset("winged-cylindrical"), {
			l: 487.25,
			p3w: 187.5,
			p3r: 88.25,
			p4w: 203.75,
			p4r: 110.5,
			p5w: 145.25,
			p5r: 152.75,
			p6w: 149.5,
			p6r: 148.25,
			rmin: 22,
			rmax: 28,
			yaw: 57,
			vary: 0.45,
			sag: 3.5,
		});
		const link = encodeQuery({ ...edited, seed: 4_000_000_000, look: { ...edited.look, skin: "112233", bloom: 0.7 } });
		expect(link.length - 1).toBeLessThan(200);
		expect(decodeQuery(link).specimen.parameters).toEqual(edited.parameters);
	});

	it("without a version is version 1: the paper's procedure, all else as the preset has it", () => {
		for (const link of ["?preset=lychee&l=70", "?v=1&preset=lychee&l=70"]) {
			const { specimen, notes } = decodeQuery(link);
			expect(notes).toEqual([]);
			expect(specimen).toEqual(withParameters(specimenFromPreset("lychee"), { l: 70, procedure: 0 }));
			expect(encodeQuery(specimen)).toBe("?v=2&preset=lychee&l=70&procedure=paper");
		}
		expect(decodeQuery("?v=1&procedure=natural").specimen).toEqual(specimenFromPreset());
	});

	it("that says nothing of a bunch is no link, and opens what a page opens with", () => {
		for (const nothing of ["", "?", "?utm_source=letter"]) {
			expect(decodeQuery(nothing).specimen).toEqual(specimenFromPreset());
		}
	});

	it("with nothing but a grammar is version 1", async () => {
		const link = await encodeLink({ ...specimenFromPreset(), grammar: "axiom: F(1)" });
		const { specimen } = await decodeLink("", link.slice(link.indexOf("#")));
		expect(specimen).toEqual({ ...specimenFromPreset(undefined, 1), grammar: "axiom: F(1)" });
	});

	it("of a later version is read as far as it is known", () => {
		const newer = decodeQuery("?v=3&preset=lychee&l=70&ripeness=3");
		expect(newer.specimen).toEqual(withParameters(specimenFromPreset("lychee"), { l: 70 }));
		expect(newer.notes.map((note) => note.text)).toEqual([
			"v: The plant was made with a newer version (3). Only the parts that this version supports were read.",
			"ripeness: There is no such parameter. This part was ignored.",
		]);
	});

	it("that is far too long is read as far as its first 16,384 characters", () => {
		const { specimen, notes } = decodeQuery(`?v=2&l=300&utm=${"x".repeat(20_000)}&p3w=10`);
		expect(specimen).toEqual(withParameters(specimenFromPreset(), { l: 300 }));
		expect(notes.map((note) => note.text)).toEqual([
			"link: The link is too long. Only the first 16,384 characters of the link were read.",
			"utm: There is no such parameter. This part was ignored.",
		]);
	});

	it("says choices by name, and reads their numbers too", () => {
		const chosen = withParameters(specimenFromPreset(), { procedure: 0, fruit: 3, cane: 0 });
		expect(encodeQuery(chosen)).toBe("?v=2&procedure=paper&fruit=lychee&cane=off");
		for (const link of ["?v=2&procedure=paper&fruit=lychee&cane=off", "?v=2&procedure=0&fruit=3&cane=0"]) {
			expect(decodeQuery(link)).toEqual({ specimen: chosen, notes: [] });
		}
	});

	it("lists berries taken off by hand in base 36, in the order in which they were", () => {
		const thinned = thin(thin(thin(specimenFromPreset(), 1_000_000), 35), 2 ** 30 - 1);
		expect(encodeQuery(thinned)).toBe("?v=2&thin=lfls.z.hra0hr");
		for (const list of ["lfls.z.hra0hr", "lfls,z,hra0hr", "LFLS.z.%20hra0hr.z"]) {
			expect(decodeQuery(`?v=2&thin=${list}`)).toEqual({ specimen: thinned, notes: [] });
		}
	});

	it("says which part it could not use", () => {
		const { specimen, notes } = decodeQuery(
			"?v=2&l=700&p3=9&p4=1,x&p5=300,40&seed=-1&skin=blue&preset=plum&l=601&thin=a.!&cane=x",
		);
		expect(notes.map((note) => note.text)).toEqual([
			"l: This parameter appears more than once. The last value is used.",
			"preset: There is no preset “plum”. Using long-conical.",
			"l: 601 is above the maximum, 580. Using 580.",
			"p3: “9” is not a list of 2 numbers like “79,76”. Using 150,150.",
			"p4: “1,x” is not a list of 2 numbers like “79,76”. Using 150,102.",
			"p5: 300 is above the maximum, 290. Using 290.",
			"seed: -1 is below the minimum, 0. Using 0.",
			"skin: “blue” is not a colour of six hexadecimal digits. Using 43264f.",
			"thin: “!” is not the id of a berry. This entry was left out.",
			"cane: “x” isn’t one of off, on. Using on.",
		]);
		expect(specimen.parameters.p5r).toBe(40);
	});
});

describe("a grammar in the fragment", () => {
	const text = "/* L-system 3 */\n\taxiom: Ar1(m, l_i, w_i)\n".repeat(200);

	it("is packed, and comes back letter for letter", async () => {
		const link = await encodeLink({ ...specimenFromPreset(), grammar: `\ufeff${text}` });
		expect(link.length).toBeLessThan(400);
		expect((await decodeLink("", link.slice(link.indexOf("#")))).specimen.grammar).toBe(`\ufeff${text}`);
	});

	it("has lines that end as the page's do, wherever it was saved", async () => {
		const link = await encodeLink({ ...specimenFromPreset(), grammar: "axiom: F\r\nF --> F\r\n" });
		expect((await decodeLink("", link.slice(link.indexOf("#")))).specimen.grammar).toBe("axiom: F\nF --> F\n");
	});

	it("is known to be there before it is unpacked", () => {
		expect(hasPacked(BUNCH, "#g=abc")).toBe(true);
		expect(hasPacked(BUNCH, "#top")).toBe(false);
		expect(hasPacked(BUNCH, "")).toBe(false);
	});

	it("given twice is the last one, and a note says so", async () => {
		const [first, last] = await Promise.all(
			["axiom: F(1)\n", "axiom: F(2)\n"].map((grammar) => encodeLink({ ...specimenFromPreset(), grammar })),
		);
		const { specimen, notes } = await decodeLink("?v=2", `${first.slice(first.indexOf("#"))}&${last.split("#")[1]}`);
		expect(specimen.grammar).toBe("axiom: F(2)\n");
		expect(notes.map((note) => note.text)).toEqual([
			"grammar: This parameter appears more than once. The last value is used.",
		]);
	});

	it("that is damaged is left out, and a note says so", async () => {
		const link = await encodeLink({ ...specimenFromPreset(), grammar: text });
		const hash = link.slice(link.indexOf("#"));
		for (const damaged of ["#g=", "#g=%%%", "#g=AAAA", hash.slice(0, -20), hash.replace("g=", "g=!")]) {
			const { specimen, notes } = await decodeLink("?v=2&l=300", damaged);
			expect(specimen).toEqual(withParameters(specimenFromPreset(), { l: 300 }));
			expect(notes.map((note) => note.text)).toEqual([
				"grammar: The link is damaged here. The built-in grammar is used.",
			]);
		}
	});

	it("that is no UTF-8 is left out, and a note says so", async () => {
		// C3 28, deflated without a header: the first half of a letter, and then no second half.
		const { specimen, notes } = await decodeLink("?v=2", "#g=O6wBAA");
		expect(specimen).toEqual(specimenFromPreset());
		expect(notes.map((note) => note.text)).toEqual([
			"grammar: The link is damaged here. The built-in grammar is used.",
		]);
	});

	it("in a link that is far too long is not even unpacked", async () => {
		const link = await encodeLink({ ...specimenFromPreset(), grammar: text });
		const hash = `${link.slice(link.indexOf("#"))}&x=${"x".repeat(512 * 1024)}`;
		const { specimen, notes } = await decodeLink("?v=2", hash);
		expect(specimen).toEqual(specimenFromPreset());
		expect(notes.map((note) => note.text)).toEqual(["grammar: The link is too long. The built-in grammar is used."]);
	});

	it("that unpacks to more than a grammar may be is refused before it fills the memory", async () => {
		const bomb = await encodeLink({ ...specimenFromPreset(), grammar: "F".repeat(20_000_000) });
		expect(bomb.length).toBeLessThan(100_000);
		const { specimen, notes } = await decodeLink("", bomb.slice(bomb.indexOf("#")));
		expect(specimen.grammar).toBeUndefined();
		expect(notes).toHaveLength(1);
	});
});
