import { describe, expect, it } from "vitest";
import { documentOf } from "../formats/reading";
import { grow } from "./world";

describe("files with meshes", () => {
	it("are of the form that is asked for", async () => {
		const triangles = (glb: string | Uint8Array | undefined) => {
			const { accessors = [], meshes = [] } = documentOf(glb as Uint8Array);
			return meshes.reduce((sum, { primitives: [{ indices }] }) => sum + accessors[indices].count / 3, 0);
		};
		const form = async (...words: string[]) => (await grow(["rubus", "--out", "x.glb", ...words])).written.get("x.glb");
		const [detailed, low] = [await form(), await form("--form", "low", "--triangles", "900")];
		expect(Buffer.from((await form("--form", "detailed")) as Uint8Array).equals(detailed as Uint8Array)).toBe(true);
		expect(triangles(detailed)).toBeGreaterThan(5000);
		expect(triangles(low)).toBeLessThanOrEqual(900);
		expect(triangles(low)).toBeGreaterThan(500);
		expect(documentOf((await form("--form", "web")) as Uint8Array).extensionsUsed).toContain("EXT_meshopt_compression");
	});

	it("are refused with an exit status of its own where the plant is empty and the file cannot be", async () => {
		for (const file of ["x.3mf", "x.stl"]) {
			const { status, messages, written } = await grow(["growth/oak", "--set", "age=0", "--out", file]);
			expect([status, written.size]).toEqual([4, 0]);
			expect(messages).toEqual([expect.stringMatching(/^grow: The plant is empty/)]);
		}
	});

	it("for printers come with a note where they are thicker than was asked for", async () => {
		const { status, messages } = await grow([
			"tree/bonsai",
			"--set",
			"leaves=0",
			"--thickness",
			"0.5",
			"--out",
			"x.stl",
		]);
		expect(status).toBe(0);
		expect(messages.join()).toMatch(/note: The minimum thickness is [\d.]+ mm, .* as thin as 0\.5 mm\./);
	});

	it("let light through pale skins where that is asked for alone", async () => {
		const used = async (...words: string[]) => {
			const { written } = await grow(["riesling", "--out", "x.glb", ...words]);
			return documentOf(written.get("x.glb") as Uint8Array).extensionsUsed ?? [];
		};
		expect(await used("--translucent")).toContain("KHR_materials_transmission");
		expect(await used()).not.toContain("KHR_materials_transmission");
	});
});
