import { describe, expect, it } from "vitest";
import { encodeLink, specimenFromPreset } from "../bunch";
import { complaint } from "./world";

describe("what cannot be used", () => {
	it("is said in one line: preset and options", async () => {
		expect(await complaint(["plum"])).toBe("“plum” is neither a preset nor a link. --list shows all presets.");
		expect(await complaint(["duku", "rubus"])).toMatch(/“rubus” is a second one/);
		expect(await complaint(["--sed", "3"])).toBe("Unknown option --sed. See --help.");
		expect(await complaint(["--seed"])).toMatch(/^Option --seed <value> argument missing. See --help.$/);
		expect(await complaint(["--seed", "x"])).toBe("--seed: “x” is not a number.");
		const dashed = "--seed needs a value. If the value begins with a dash, join it with =, as in --seed=-1.";
		expect(await complaint(["--seed", "-1"])).toBe(dashed);
		expect(await complaint(["--seed", "--out", "x.glb"])).toBe(dashed);
		expect(await complaint(["--seed=-1"])).toBe("--seed: -1 is below the minimum, 0.");
		expect(await complaint(["--seed", "1.5"])).toBe("--seed: 1.5 is not a whole number.");
	});

	it("is said in one line: settings", async () => {
		const set = (...settings: string[]) => complaint(settings.flatMap((setting) => ["--set", setting]));
		expect(await set("l")).toBe("--set l: Write KEY=VALUE, as in --set age=50.");
		expect(await set("=3")).toMatch(/Write KEY=VALUE/);
		for (const key of ["length", "seed", "preset", "v", "grammar", "thinned", "toString", "__proto__"]) {
			expect(await set(`${key}=1`)).toBe(`--set ${key}: There is no such parameter. See --help.`);
		}
		expect(await set("l=abc")).toBe("--set l: “abc” is not a number.");
		expect(await set("l=700")).toBe("--set l: 700 is above the maximum, 580.");
		expect(await set("p3=79")).toBe("--set p3: “79” is not a list of 2 numbers like “79,76”.");
		expect(await set("t=1.5")).toBe("--set t: 1.5 is not a whole number.");
		expect(await set("wing=0.1")).toMatch(/^--set wing: 0.1 is between/);
		expect(await set("rmin=50")).toBe("--set rmin: 50 is greater than rmax (30).");
		expect(await set("m=3", "n=1,2,3")).toBe("--set n: m = 3 needs 2 values, not 3.");
		expect(await set("m=2", "n=1,2")).toBe("--set n: m = 2 needs 1 value, not 2.");
		expect(await set("l=300.123")).toBe("--set l: 300.123 has more than two decimals. Round it.");
		expect(await set("p3=79,76.005")).toBe("--set p3: 76.005 has more than two decimals. Round it.");
		expect(await set("procedure=wild")).toBe("--set procedure: “wild” isn’t one of paper, natural.");
		expect(await set("cane=2")).toBe("--set cane: “2” isn’t one of off, on.");
		expect(await set("thin=a.!")).toBe("--set thin: “!” is not the id of a berry.");
		expect(await set("thin=zzzzzz")).toBe("--set thin: “zzzzzz” is not the id of a berry.");
		expect(await set("skin=red")).toMatch(/^--set skin: “red” is not a colour/);
		expect(await set("l=300", "l=x")).toMatch(/not a number/);
	});

	it("is said in one line: grammars, with line and column", async () => {
		const grammar = (text: string | Uint8Array) =>
			complaint(["long-conical", "--grammar", "g.lsys"], { "g.lsys": text });
		expect(await complaint(["--grammar", "none.lsys"])).toBe("--grammar none.lsys: There is no such file or folder.");
		expect(await grammar("axiom: A\nA --> F(1\n")).toMatch(/^g\.lsys:[23]:\d+: \S/);
		expect(await grammar("axiom: A\nA --> A\n")).toMatch(/^g\.lsys: The string is still being rewritten/);
		for (const empty of ["", "\n \n"])
			expect(await grammar(empty)).toMatch(
				/^--grammar g\.lsys: The file is empty. Start an L-system with “axiom: F”, a flower with “#define STEM/,
			);
		expect(await grammar(Uint8Array.of(0xff, 0xfe, 0x41))).toBe(
			"--grammar g.lsys: The file is not text in UTF-8. Save it as UTF-8.",
		);
		expect(await complaint(["flower/tulip", "--set", "lenght=1"])).toMatch(
			/^--set lenght: There is no such parameter. The grammar does not define this constant. It defines length, /,
		);
		expect(await grammar("F".repeat(300_000))).toBe(
			"--grammar g.lsys: The grammar is longer than 256 KiB. Shorten it.",
		);
		const link = await encodeLink({ ...specimenFromPreset(), grammar: "axiom: (" });
		expect(await complaint([link])).toMatch(/^the link’s grammar:1:\d+: /);
	});

	it("is said in one line: files", async () => {
		expect(await complaint(["--out", "bunch.fbx"])).toBe(
			"--out bunch.fbx: The file name must end in .glb, .zip, .usdz, .ply, .3mf, .stl, .obj, .json, .csv or .measures.csv.",
		);
		expect(await complaint(["--out", "x.PNG"])).toMatch(/^--out x.PNG: Pictures need a graphics card/);
		expect(await complaint(["--out", "x.glb", "--form", "tiny"])).toBe(
			"--form tiny: There is no such form. The forms are detailed, web, low, instanced, growth, wind, lod, game.",
		);
		expect(await complaint(["--set", "procedure=paper", "--out", "x.glb", "--form", "growth"])).toBe(
			"--form growth: This plant has no age data, so its growth cannot be shown. Choose another form.",
		);
		expect(await complaint(["--out", "x.glb", "--form", "lod"])).toBe(
			"--form lod: The model bunch has no levels of detail. Choose another form.",
		);
		expect(await complaint(["--out", "x.obj", "--form", "web"])).toMatch(
			/^--form web: This option applies only to .glb files/,
		);
		expect(await complaint(["--out", "x.glb", "--triangles", "few"])).toBe(
			"--triangles must be a whole number from 100 to 2,000,000.",
		);
		expect(await complaint(["--out", "nowhere/bunch.glb"])).toBe(
			"--out nowhere/bunch.glb: There is no such file or folder.",
		);
	});
});
