import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { build, type Rolldown } from "vite";
import { afterAll, expect, it } from "vitest";
import { leanThree } from "../../web/lean_three.mjs";

const folder = mkdtempSync(join(tmpdir(), "lean-three-"));
afterAll(() => rmSync(folder, { recursive: true }));

/** The script that Vite makes of one that imports from three. */
async function built(imported: string): Promise<string> {
	const entry = join(folder, `${imported.replaceAll(/\W+/g, "-")}.js`);
	writeFileSync(entry, `import { ${imported} } from "three"; console.log(${imported});`);
	const made = (await build({
		configFile: false,
		logLevel: "silent",
		plugins: [leanThree()],
		build: { write: false, minify: false, target: "es2022", rolldownOptions: { input: entry } },
	})) as Rolldown.RolldownOutput;
	return made.output.map((part) => (part.type === "chunk" ? part.code : "")).join("\n");
}

it("builds three's renderer without the programs and parts that nothing uses, and with those that are used", async () => {
	const code = await built("WebGLRenderer, MeshPhysicalMaterial");
	expect(code).toMatch(/define STANDARD/);
	expect(code).toMatch(/USE_SHEEN/);
	expect(code).not.toMatch(/define (PHONG|LAMBERT|TOON)/);
	expect(code).not.toMatch(/requestReferenceSpace/);
	expect(code).toMatch(/gl_PointSize/);
	// Programs come as three's own build has them: without comments and margins.
	expect(code).not.toMatch(/glTF-Sampler-Viewer|\\n\\t/);
});

it("fails where something is imported that needs what is left out", async () => {
	await expect(built("WebGLRenderer, MeshPhongMaterial")).rejects.toThrow(/MeshPhongMaterial\.js needs what/);
});
