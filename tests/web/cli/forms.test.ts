import { describe, expect, it } from "vitest";
import { documentOf } from "../export/reading";
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

	it("let light through pale skins where that is asked for alone", async () => {
		const used = async (...words: string[]) => {
			const { written } = await grow(["riesling", "--out", "x.glb", ...words]);
			return documentOf(written.get("x.glb") as Uint8Array).extensionsUsed ?? [];
		};
		expect(await used("--translucent")).toContain("KHR_materials_transmission");
		expect(await used()).not.toContain("KHR_materials_transmission");
	});
});
