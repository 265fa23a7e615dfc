import { describe, expect, it } from "vitest";
import { FileTooLargeError } from "../../../web/src/formats/file_error";
import { checkMeshBytes, MAX_MESH_BYTES, meshBytes } from "../../../web/src/formats/limits";
import { exportObj } from "../../../web/src/formats/obj";
import { PLANT_FILES } from "../../../web/src/formats/plant_files";
import { TextBuffer } from "../../../web/src/formats/text_buffer";
import type { Part } from "../../../web/src/plant/part";

const ABOUT = { name: "Hedge", link: "https://example.org/", extras: {} };
const material = { name: "Leaf", colour: [1, 1, 1] as const, roughness: 1, doubleSided: false };

/** A leaf of 300 bytes (6 vertices, 9 triangles), so many times; nothing of them is made. */
function leaves(count: number, own = false): Part[] {
	const mesh = {
		positions: new Float32Array(18),
		normals: new Float32Array(18),
		uvs: new Float32Array(12),
		indices: new Uint32Array(27),
	};
	const transforms = new Float32Array(8 * count);
	const each = (index: number) => ({ name: `Leaf ${index}` });
	return [
		{ name: "Leaves", shape: { mesh, material, instances: { transforms, ...(own ? { each } : {}) } } },
	] as unknown as Part[];
}

const TOO_MANY = Math.ceil(MAX_MESH_BYTES / 300) + 1;

describe("the limit of meshes in a file", () => {
	it("counts instances as often as a file has their mesh", () => {
		expect(meshBytes(leaves(10), "shared")).toBe(300);
		expect(meshBytes(leaves(10), "nodes")).toBe(3000);
		expect(meshBytes(leaves(10, true), "nodes")).toBe(300);
		expect(meshBytes(leaves(10, true), "meshes")).toBe(3000);
		expect(meshBytes([...leaves(10), { name: "Group", children: leaves(5) }], "meshes")).toBe(4500);
	});

	it("refuses a file before it is made, and says what to do", async () => {
		expect(() => checkMeshBytes(leaves(TOO_MANY - 2), "meshes")).not.toThrow();
		const many = leaves(TOO_MANY);
		const message =
			"The file would be 321 MB, which is more than the limit of 320 MB. Make the plant smaller, give it fewer parts, or choose GLB with instancing, which stores each shared mesh only once.";
		expect(() => exportObj(many, ABOUT, "hedge")).toThrow(message);
		for (const file of PLANT_FILES.filter(({ instances }) => instances && instances !== "shared"))
			await expect(file.make(many, ABOUT, {}), file.key).rejects.toThrow(FileTooLargeError);
	});

	it("is checked for every file that writes all the parts' meshes", () => {
		const unchecked = PLANT_FILES.filter(({ instances }) => !instances).map(({ key }) => key);
		const simplified = PLANT_FILES.filter(({ life, levelled, crowned }) => life || levelled || crowned);
		expect(unchecked).toEqual(simplified.map(({ key }) => key));
	});
});

describe("the limit of a text", () => {
	it("is an error where the text becomes larger, at whichever piece", () => {
		const out = new TextBuffer(16, 100);
		const write = () => {
			for (let i = 0; i < 30; i++) out.word("1234567");
		};
		expect(write).toThrow(FileTooLargeError);
		const written = out.chunks().reduce((sum, { length }) => sum + length, 0);
		expect(written).toBeGreaterThan(80);
		expect(written).toBeLessThanOrEqual(100);
	});

	it("has the same bytes in pieces and in one", () => {
		const out = new TextBuffer(16);
		for (let i = 0; i < 20; i++) out.text(`a“${i}`);
		expect(out.chunks().length).toBeGreaterThan(5);
		expect(Buffer.concat(out.chunks())).toEqual(Buffer.from(out.bytes()));
		expect(out.toString()).toBe(Array.from({ length: 20 }, (_, i) => `a“${i}`).join(""));
	});
});
