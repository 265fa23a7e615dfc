import { describe, expect, it } from "vitest";
import { complaint, grow } from "./world";

const TEXT = "#define a 2\naxiom: A(1)\nderivation length: 2\nA(x) --> F(x*a) A(x)\n";
const BUNCH = "#role pedicel Ap\naxiom: Ap\nAp --> F(10) S(3)\n";

describe("--grammar", () => {
	it("grows any text by the model for any text", async () => {
		const { json, status } = await grow(["--grammar", "g.lsys", "--seed", "3"], { "g.lsys": TEXT });
		expect(status).toBe(0);
		expect(json).toMatchObject({
			specimen: { model: "grammar", seed: 3, grammar: TEXT },
			modules: 3,
			steps: 2,
			counts: { segments: 2 },
			notes: [],
		});
	});

	it("grows a bunch where the text declares its roles, or a bunch is named", async () => {
		const files = { "g.lsys": BUNCH, "t.lsys": TEXT };
		expect((await grow(["--grammar", "g.lsys"], files)).json.specimen.model).toBe("bunch");
		expect((await grow(["riesling", "--grammar", "t.lsys"], files)).json.specimen.model).toBe("bunch");
		expect((await grow(["grammar", "--grammar", "g.lsys"], files)).json.specimen.model).toBe("grammar");
	});

	it("grows a tree and a stand by their texts, and by files that the command wrote with their parameters", async () => {
		const tree = 'gs = 4\ntree -> DivFunc("sigma1"){branches}\n';
		const { json: plain } = await grow(["--grammar", "mine.growth"], { "mine.growth": tree });
		expect(plain.specimen).toMatchObject({ model: "growth", preset: "figure-5", grammar: tree });
		const requested = ["growth/birch", "--seed", "5", "--set", "steps=5"];
		const { json: birch } = await grow(requested);
		const { written } = await grow([...requested, "--out", "birch.growth"]);
		const again = await grow(["--grammar", "birch.growth"], Object.fromEntries(written));
		expect(again.json.specimen).toMatchObject({ model: "growth", preset: "birch", seed: 5 });
		expect(again.json.fingerprint).toBe(birch.fingerprint);
		const plan = "ground 20 x 20\nplants 3, blue\ngrowth/figure-5, crown 5 x 9\n";
		const stand = await grow(["--grammar", "orchard.stand"], { "orchard.stand": plan });
		expect(stand.json).toMatchObject({ specimen: { model: "stand", grammar: plan }, counts: { plants: 3 } });
	});

	it("takes the place of a bunch's own text, less its mark of order", async () => {
		const text = "\ufeffaxiom: F(10)[+F(5)][-F(5)]\n";
		const call = ["long-conical", "--grammar", "mine.lsys", "--set", "procedure=paper"];
		const { json } = await grow(call, { "mine.lsys": text });
		expect(json.counts.internodes).toBe(3);
		expect(json.specimen.grammar).toBe(text.slice(1));
	});

	it("is told where the text is wrong, as compilers do", async () => {
		expect(await complaint(["--grammar", "g.lsys"], { "g.lsys": "axiom: F\n\tA --> F)\n" })).toMatch(
			/^g\.lsys:2:9: \S.*\n {2}\tA --> F\)\n {2}\t {7}\^$/,
		);
	});

	it("reads a flower's grammar as XML, and tells where that is wrong", async () => {
		const volume = (category: string) => `<volume category="${category}"><name>A</name></volume>`;
		const rule = `<rule><predecessor>${volume("")}</predecessor><successor>${volume("root")}<element>[</element>${volume("")}<element>]_</element><face>{E}</face></successor></rule>`;
		const files = { "a.xml": `${volume("#define")}\n<axiom>A</axiom>${rule}`, "b.xml": "<axiom>A</axiom>\n<rule/>" };
		const { json } = await grow(["--grammar", "a.xml"], files);
		expect(json).toMatchObject({ specimen: { model: "flower" }, counts: { volumes: 11 } });
		expect(json.specimen.grammar).toBe("#define A\n#axiom: A\nA -> A[A]_{E}\n");
		expect(await complaint(["--grammar", "b.xml"], files)).toBe(
			"--grammar b.xml: Line 2, column 1: A rule needs a <predecessor>.",
		);
		// The core's messages count the lines of the text, which differ from those of the file.
		const wrong = { "a.xml": files["a.xml"].replace("{E}", "{C9}") };
		expect(await complaint(["--grammar", "a.xml"], wrong)).toMatch(
			/^a\.xml, as text:3:\d+: .*\n {2}A -> A\[A\]_\{C9\}\n/,
		);
		// The same grammar in about ten times the length.
		const long = { "a.xml": files["a.xml"].concat(" ".repeat(300_000)) };
		expect((await grow(["--grammar", "a.xml"], long)).json.fingerprint).toBe(json.fingerprint);
		expect(await complaint(["--grammar", "a.xml"], { "a.xml": files["a.xml"].concat(" ".repeat(8_400_000)) })).toBe(
			"--grammar a.xml: The grammar is longer than 8,192 KiB. Shorten it.",
		);
	});

	it("gives the derived string where it is asked for", async () => {
		const { json } = await grow(["--grammar", "g.lsys", "--string"], { "g.lsys": TEXT });
		expect(json.string).toBe("F(2)F(2)A(1)");
		expect(await complaint(["riesling", "--string"])).toBe(
			"--string: The model bunch has no string. Leave the option out.",
		);
		expect(await complaint(["flower/tulip", "--string"])).toBe(
			"--string: The model flower has no string. Leave the option out.",
		);
		expect(await complaint(["leaf", "--string"])).toBe(
			"--string: The model leaf does not use a grammar. Leave the option out.",
		);
		expect(await complaint(["grammar", "--string", "--out", "x.glb"])).toBe(
			"--string: Only a JSON file contains the string. Choose a name that ends in .json.",
		);
	});

	it("tells a step of the derivation where it is asked for", async () => {
		const { json } = await grow(["--grammar", "g.lsys", "--chronicle", "1"], { "g.lsys": TEXT });
		expect(json.chronicle.step).toBe(1);
		expect(json.chronicle.modules.map(({ text }: { text: string }) => text)).toEqual(["F(2)", "A(1)"]);
		const part = await grow(["--grammar", "g.lsys", "--chronicle", "2,1,1"], { "g.lsys": TEXT });
		expect(part.json.chronicle).toMatchObject({ step: 2, first: 1, modules: [{ text: "F(2)" }] });
		expect((await grow(["duku", "--chronicle", "0"])).json.chronicle.modules).toHaveLength(1);
		expect(await complaint(["leaf", "--chronicle", "0"])).toBe(
			"--chronicle: The model leaf does not use a grammar. Leave the option out.",
		);
		const alone = "--chronicle: Only a JSON file contains the derivation. Choose a name that ends in .json.";
		expect(await complaint(["grammar", "--chronicle", "0", "--out", "x.glb"])).toBe(alone);
		for (const wrong of ["x", "", "1,", "1,2,3,4", "-1", "1,0,2001"])
			expect(await complaint(["grammar", `--chronicle=${wrong}`])).toMatch(/Write STEP or STEP,FIRST,COUNT/);
	});

	it("--set reaches the text's constants, steps and the table", async () => {
		const call = ["--grammar", "g.lsys", "--set", "a=3", "--set", "steps=1", "--set", "unit=1000"];
		const { json } = await grow(call, { "g.lsys": TEXT });
		expect(json.specimen).toMatchObject({ constants: { a: 3 }, steps: 1, parameters: { unit: 1000 } });
		expect(json.segments[0].end[1]).toBe(3);
		expect(await complaint(["--grammar", "g.lsys", "--set", "a=x"], { "g.lsys": TEXT })).toBe(
			"--set constants: a is “x”, which is not a number.",
		);
		expect(await complaint(["--grammar", "g.lsys", "--set", "b=1"], { "g.lsys": TEXT })).toMatch(
			/^--set b: There is no such parameter\. The grammar does not define this constant\. It defines /,
		);
	});

	it("writes the text with its values as a file", async () => {
		const { written } = await grow(["grammar/shrub", "--set", "angle=20", "--out", "b.lsys"]);
		expect(written.get("b.lsys")).toMatch(/#define angle 20 {6}\/\* 10 … 80/);
	});
});
