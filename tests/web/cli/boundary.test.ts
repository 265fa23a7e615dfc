import { describe, expect, it } from "vitest";
import { complaint, grow } from "./world";

/** A box a metre wide, two high, three deep. */
const BOX = [
	..."v 0 0 0,v 1 0 0,v 1 2 0,v 0 2 0,v 0 0 3,v 1 0 3,v 1 2 3,v 0 2 3".split(","),
	..."f 4 3 2 1,f 5 6 7 8,f 1 2 6 5,f 2 3 7 6,f 3 4 8 7,f 4 1 5 8".split(","),
].join("\n");
const few = ["--set", "particles=60"];

describe("--boundary", () => {
	it("has a tree grow in a file's mesh, as high as it was and in the mesh's proportions", async () => {
		const { status, json, messages } = await grow(["tree/oak", "--set", "height=4", ...few, "--boundary", "box.obj"], {
			"box.obj": BOX,
		});
		expect([status, messages]).toEqual([0, []]);
		expect(json.specimen.parameters).toMatchObject({ shape: "mesh", width: 2, height: 4, depth: 6 });
		expect(json.specimen.volume.triangles).toHaveLength(36);
		expect(json.notes.join()).not.toMatch(/mesh/);
		const ends = json.segments.flatMap(({ start, end }: { start: number[]; end: number[] }) => [start, end]);
		const span = (axis: number) => Math.max(...ends.map((p: number[]) => Math.abs(p[axis])));
		expect(span(0)).toBeLessThanOrEqual(1.001);
		expect(span(2)).toBeGreaterThan(1.5);
		expect(span(2)).toBeLessThanOrEqual(3.001);
	});

	it("has a root grow in it, and gives way to what is typed", async () => {
		const words = ["root/tap", "--set", "reach=1", "--set", "width=0.4", ...few, "--boundary", "in/box.OBJ"];
		const { json } = await grow(words, { "in/box.OBJ": BOX });
		expect(json.specimen.parameters).toMatchObject({ width: 0.4, reach: 1, depth: 1.5 });
	});

	it("is refused where it cannot be used", async () => {
		const tree = (file: string, text: string, ...more: string[]) =>
			complaint(["tree", "--boundary", file, ...more], { [file]: text });
		expect(await complaint(["tree", "--boundary", "none.obj"])).toBe(
			"--boundary none.obj: There is no such file or folder.",
		);
		expect(await tree("m.ply", BOX)).toMatch(/^--boundary m\.ply: m\.ply is not an OBJ, GLB or STL file\./);
		expect(await tree("m.obj", "v 0 0 x")).toBe(
			"--boundary m.obj: Line 1 of the OBJ: “x” is not a number. Export the mesh again.",
		);
		expect(await tree("m.obj", BOX.replace("f 4 1 5 8", ""))).toMatch(
			/^--boundary m\.obj: The mesh has holes \(4 open edges\)/,
		);
		expect(await tree("m.obj", BOX, "--set", "shape=box")).toBe(
			"--boundary m.obj: This option has no effect with shape=box. Leave --set shape out.",
		);
		expect(await complaint(["leaf/oak", "--boundary", "m.obj"])).toBe(
			"--boundary m.obj: The model leaf has no boundary. Leave the option out.",
		);
	});
});
