import { describe, expect, it, vi } from "vitest";
import { exportGlb } from "../../../../web/src/formats/glb";
import { closedMesh } from "../../../../web/src/import/mesh_file/closed";
import { readGlb } from "../../../../web/src/import/mesh_file/glb";
import { readObj } from "../../../../web/src/import/mesh_file/obj";
import { readMeshFile } from "../../../../web/src/import/mesh_file/read";
import { MeshFileError, type Soup } from "../../../../web/src/import/mesh_file/soup";
import { readStl } from "../../../../web/src/import/mesh_file/stl";
import { standardMaterial } from "../../../../web/src/plant/material";
import { MAX_TRIANGLES } from "../../../../web/src/specimen/closed_mesh";

/** A box from (1, 2, 3), twice as high as wide: eight points, six faces of four corners, one by negative numbers. */
const BOX = `# box
v 1 2 3\nv 2 2 3\nv 2 4 3\nv 1 4 3
v 1 2 4\nv 2 2 4\nv 2 4 4\nv 1 4 4
f 4 3 2 1
f 5/1/1 6/2/1 7/3/1 8/4/1
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f -5 -8 -4 -1
`;

function volumeOf({ points, triangles }: Soup): number {
	let volume = 0;
	for (let i = 0; i < triangles.length; i += 3) {
		const [a, b, c] = [0, 1, 2].map((k) => points.slice(3 * triangles[i + k], 3 * triangles[i + k] + 3));
		volume +=
			a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
	}
	return volume / 6;
}

/** Returns a sphere of a number of triangles, each with points of its own. */
function ball(rings: number): Soup {
	const at = (i: number, j: number) => {
		const [tilt, turn] = [(Math.PI * i) / rings, (Math.PI * (j % (2 * rings))) / rings];
		return [Math.sin(tilt) * Math.cos(turn), Math.cos(tilt), Math.sin(tilt) * Math.sin(turn)];
	};
	const points: number[] = [];
	for (let i = 0; i < rings; i++) {
		for (let j = 0; j < 2 * rings; j++) {
			const [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
			points.push(...a, ...b, ...c, ...a, ...c, ...d);
		}
	}
	return { points, triangles: points.slice(0, points.length / 3).map((_, i) => i) };
}

describe("a closed mesh from a file", () => {
	it("is read from an OBJ, and scaled to height 1 over the middle of the ground", () => {
		const { points, triangles } = closedMesh(readObj(BOX));
		expect(triangles).toHaveLength(36);
		expect(new Set(points)).toEqual(new Set([-0.25, 0.25, 0, 1]));
		expect(volumeOf({ points, triangles })).toBeCloseTo(0.25);
	});

	it("is reversed if its triangles face inwards", () => {
		const { points, triangles } = readObj(BOX);
		const inwards = triangles.map((_, i) => triangles[3 * Math.floor(i / 3) + [0, 2, 1][i % 3]]);
		expect(volumeOf(closedMesh({ points, triangles: inwards }))).toBeCloseTo(0.25);
	});

	it("is read from a GLB that Panicle writes, with coincident points welded", async () => {
		const { points, triangles } = readObj(BOX);
		const apart = triangles.flatMap((corner) => points.slice(3 * corner, 3 * corner + 3));
		const mesh = {
			positions: Float32Array.from(apart),
			normals: Float32Array.from(apart, (_, i) => (i % 3 === 1 ? 1 : 0)),
			uvs: new Float32Array((2 * apart.length) / 3),
			indices: Uint32Array.from({ length: apart.length / 3 }, (_, i) => i),
		};
		const transforms = Float32Array.of(5, 0, 0, 0, 0, Math.SQRT1_2, Math.SQRT1_2, 3);
		const shape = { mesh, material: standardMaterial("stem"), instances: { transforms } };
		const about = { name: "box", link: "", extras: {} };
		const bytes = exportGlb([{ name: "box", shape }], about as never);
		// Turns the box on its side by a quarter turn about z.
		const { points: imported } = await readMeshFile(new File([bytes], "box.glb"));
		expect(Math.max(...imported.filter((_, i) => i % 3 === 0))).toBeCloseTo(1);
		expect(imported).toHaveLength(24);
		expect(readGlb(bytes.buffer).triangles).toHaveLength(36);
	});

	it("is simplified to a bounded number of triangles, stays closed and keeps its size", () => {
		const fine = ball(80);
		expect(fine.triangles.length / 3).toBeGreaterThan(20_000);
		const simple = closedMesh(fine);
		expect(simple.triangles.length / 3).toBeLessThanOrEqual(MAX_TRIANGLES);
		expect(simple.triangles.length / 3).toBeGreaterThan(MAX_TRIANGLES / 4);
		expect(volumeOf(simple)).toBeCloseTo(Math.PI / 6, 1);
		// A closed mesh is accepted a second time.
		expect(() => closedMesh(simple)).not.toThrow();
	});

	it.each([
		["flat", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", "The mesh is flat, so it has no inside."],
		[
			"without two sides",
			"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n",
			"The mesh has no inside. Use a closed mesh.",
		],
		["all lines", "v 0 0 0\nv 0 1 0\nf 1 1 2\n", "The mesh has no inside. Use a closed mesh."],
		["without triangles", "v 0 0 0\n", "The file contains no triangles."],
		[
			"with a corner too many",
			"v 0 0 0\nf 1 2 3\n",
			"Line 2 of the OBJ: “2” does not refer to a point above this line.",
		],
		["with words for numbers", "v 0 a 0\n", "Line 1 of the OBJ: “a” is not a number."],
		["with a point cut short", "v 0 0\n", "Line 1 of the OBJ: a point needs three numbers."],
	])("is refused when it is %s, and the reason said", (_, text, message) => {
		expect(() => closedMesh(readObj(text))).toThrow(message);
	});

	it("is rejected if it is open, with the number of open edges and a remedy; hairline cracks are closed", () => {
		const { points, triangles } = ball(8);
		const opened = { points, triangles: triangles.toSpliced(120, 3) };
		expect(() => closedMesh(opened)).toThrow(
			"The mesh has holes (3 open edges). Close them in your 3D program and try again.",
		);
		const cracked = { points: points.map((value, i) => value + 2e-5 * Math.sin(i)), triangles };
		expect(volumeOf(closedMesh(cracked))).toBeCloseTo(volumeOf(closedMesh({ points, triangles })), 3);
	});

	it("is rejected if the file has another format, or is damaged", async () => {
		await expect(readMeshFile(new File(["x"], "box.ply"))).rejects.toThrow(
			"box.ply is not an OBJ, GLB or STL file. Save the mesh in one of these formats.",
		);
		expect(() => readGlb(new ArrayBuffer(4))).toThrow(MeshFileError);
		const bytes = new Uint8Array(64).fill(1).buffer;
		new DataView(bytes).setUint32(0, 0x46546c67, true);
		expect(() => readGlb(bytes)).toThrow("The GLB does not begin with its JSON part.");
	});

	it.each([["binary"], ["text"]])("comes from an STL, %s, stood up from +Z to +Y", async (kind) => {
		const box = readObj(BOX);
		const bytes = kind === "binary" ? binaryStl(box) : textStl(box);
		const { points, triangles } = await readMeshFile(new File([bytes], "Box.STL"));
		const same = closedMesh(box);
		expect(volumeOf({ points, triangles })).toBeCloseTo(0.25);
		const corners = (mesh: Soup) =>
			mesh.triangles.map((corner) => mesh.points.slice(3 * corner, 3 * corner + 3).join()).sort();
		expect(corners({ points, triangles })).toEqual(corners(same));
	});

	it("is read from an STL in capitals, and from one with padding behind its triangles", () => {
		const box = readObj(BOX);
		const plain = readStl(textStl(box).buffer);
		const capitals = new TextDecoder().decode(textStl(box)).toUpperCase();
		expect(readStl(new TextEncoder().encode(capitals).buffer)).toEqual(plain);
		const bytes = binaryStl(box);
		const padded = new Uint8Array(bytes.length + 7);
		padded.set(bytes);
		expect(readStl(padded.buffer)).toEqual(readStl(bytes.buffer));
	});

	it("is rejected if an STL is damaged, with the reason", () => {
		const box = readObj(BOX);
		const unfinished = "The STL is damaged or incomplete. Export it again.";
		expect(() => readStl(binaryStl(box).slice(0, -7).buffer)).toThrow(unfinished);
		expect(() => readStl(new ArrayBuffer(3))).toThrow(unfinished);
		expect(() => readStl(new ArrayBuffer(84))).toThrow(unfinished);
		const bytes = binaryStl(box);
		new DataView(bytes.buffer).setFloat32(84 + 50 + 16, Number.NaN, true);
		expect(() => readStl(bytes.buffer)).toThrow("Triangle 2 of the STL has a corner with an invalid position.");
		const text = (from: RegExp, to: string) => readStl(textStl(box, from, to).buffer);
		expect(() => text(/vertex \S+/, "vertex one")).toThrow("Line 4 of the STL: a corner needs three numbers.");
		expect(() => text(/vertex.*\n/, "")).toThrow("Line 7 of the STL: a facet needs three corners.");
		expect(() => text(/endloop\nendfacet\nendsolid[\s\S]*/, "")).not.toThrow();
		expect(() => text(/vertex[^\n]*\nendloop\nendfacet\nendsolid[\s\S]*/, "")).toThrow(unfinished);
		const opened = { points: box.points, triangles: box.triangles.slice(3) };
		expect(() => closedMesh(readStl(binaryStl(opened).buffer))).toThrow("The mesh has holes (3 open edges).");
	});

	it("is rejected before reading if it has too many triangles, with the limit", async () => {
		const most = 500_000;
		const refused = "The mesh has more than 500,000 triangles. Simplify it and try again.";
		const large = new Uint8Array(84 + 50 * (most + 1)).fill(255);
		new DataView(large.buffer).setUint32(80, most + 1, true);
		await expect(readMeshFile(new File([large], "dome.stl"))).rejects.toThrow(refused);
		const text = `solid\nfacet\n${"vertex 0 0 0\n".repeat(3 * most + 1)}vertex 0\n`;
		expect(() => readStl(new TextEncoder().encode(text).buffer)).toThrow(refused);
		const quads = `v 0 0 0\n${"f 1 1 1 1\n".repeat(most / 2)}`;
		expect(() => readObj(`${quads}f 9\n`)).toThrow("“9” does not refer to a point above this line.");
		expect(() => readObj(`${quads}f 1 1 1\nf 9\n`)).toThrow(refused);
		// Its points lie beyond its end.
		const count = 3 * (most + 1);
		const accessors = [0, 1].map((bufferView) => ({ bufferView, componentType: 5126, count, type: "VEC3" }));
		expect(() => readGlb(glbOf([{ mesh: 0 }], { accessors }))).toThrow(refused);
	});

	/** A mesh as it is printed: its +Y is the file's +Z. */
	const printedCorners = ({ points, triangles }: Soup) =>
		triangles.map((corner) => [points[3 * corner], -points[3 * corner + 2], points[3 * corner + 1]]);

	/** It begins with “solid”, as some programs' binary files do. */
	function binaryStl(soup: Soup): Uint8Array<ArrayBuffer> {
		const bytes = new Uint8Array(84 + (50 * soup.triangles.length) / 3);
		bytes.set(new TextEncoder().encode("solid box facet"));
		const view = new DataView(bytes.buffer);
		view.setUint32(80, soup.triangles.length / 3, true);
		for (const [i, place] of printedCorners(soup).entries()) {
			const at = 84 + 50 * Math.floor(i / 3) + 12 * ((i % 3) + 1);
			for (const [k, value] of place.entries()) view.setFloat32(at + 4 * k, value, true);
		}
		return bytes;
	}

	function textStl(soup: Soup, from: RegExp | string = "", to = ""): Uint8Array<ArrayBuffer> {
		const corners = printedCorners(soup).map((place) => `vertex ${place.map((x) => x.toExponential()).join(" ")}\n`);
		const facets = corners.flatMap((_, i) =>
			i % 3 === 0 ? `facet normal 0 0 0\nouter loop\n${corners.slice(i, i + 3).join("")}endloop\nendfacet\n` : [],
		);
		return new TextEncoder().encode(`solid box\n${facets.join("")}endsolid box\n`.replace(from, to));
	}

	/** A GLB whose nodes are as given, with one mesh: a tetrahedron. */
	function glbOf(nodes: readonly object[], more: object = {}): ArrayBuffer {
		const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
		const corners = Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
		const gltf = {
			nodes,
			meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
			accessors: [
				{ bufferView: 0, componentType: 5126, count: 4, type: "VEC3" },
				{ bufferView: 1, componentType: 5125, count: 12, type: "SCALAR" },
			],
			bufferViews: [
				{ buffer: 0, byteOffset: 0, byteLength: 48 },
				{ buffer: 0, byteOffset: 48, byteLength: 48 },
			],
			...more,
		};
		const text = new TextEncoder().encode(JSON.stringify(gltf));
		const bytes = new Uint8Array(28 + text.length + 96);
		const view = new DataView(bytes.buffer);
		for (const [i, word] of [0x46546c67, 2, bytes.length, text.length, 0x4e4f534a].entries())
			view.setUint32(4 * i, word, true);
		bytes.set(text, 20);
		view.setUint32(20 + text.length, 96, true);
		view.setUint32(24 + text.length, 0x004e4942, true);
		bytes.set(new Uint8Array(positions.buffer), 28 + text.length);
		bytes.set(new Uint8Array(corners.buffer), 76 + text.length);
		return bytes.buffer;
	}

	/** A GLB of one tetrahedron whose accessors, or views of the buffer, are changed. */
	const changed = (accessor: object, view: object = {}) =>
		glbOf([{ mesh: 0 }], {
			accessors: [
				{ bufferView: 0, componentType: 5126, count: 4, type: "VEC3", ...accessor },
				{ bufferView: 1, componentType: 5125, count: 12, type: "SCALAR" },
			],
			bufferViews: [
				{ buffer: 0, byteOffset: 0, byteLength: 48, ...view },
				{ buffer: 0, byteOffset: 48, byteLength: 48 },
			],
		});

	it.each([
		["a stride of 0 and very many points", { count: 1e8 }, { byteStride: 0 }],
		["a stride of 0", {}, { byteStride: 0 }],
		["a stride that is less than a point", {}, { byteStride: 8 }],
		["a stride beyond the view's end", {}, { byteStride: 16 }],
		["points beyond the view's end", { count: 5 }, {}],
		["an offset beyond the view's end", { byteOffset: 4 }, {}],
		["a negative offset", { byteOffset: -4 }, {}],
		["a count that is no whole number", { count: 3.5 }, {}],
		["a count that is no number", { count: "4" }, {}],
		["a view beyond the buffer's end", {}, { byteLength: 97 }],
		["a view that begins beyond the buffer's end", {}, { byteOffset: 96 }],
	])("is refused where a GLB has %s, and nothing of it is read", (_, accessor, view) => {
		const read = vi.spyOn(DataView.prototype, "getFloat32");
		expect(() => readGlb(changed(accessor, view))).toThrow("The GLB is damaged or incomplete. Export it again.");
		expect(read).not.toHaveBeenCalled();
	});

	it("is read from a GLB with interleaved points", () => {
		const accessors = [
			{ bufferView: 0, byteOffset: 4, componentType: 5126, count: 3, type: "VEC3" },
			{ bufferView: 1, componentType: 5125, count: 3, type: "SCALAR" },
		];
		const bufferViews = [
			{ buffer: 0, byteLength: 48, byteStride: 16 },
			{ buffer: 0, byteOffset: 48, byteLength: 12 },
		];
		expect(readGlb(glbOf([{ mesh: 0 }], { accessors, bufferViews })).points).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
	});

	it("contains only the points of a GLB that its triangles use, also if many parts share them", () => {
		const primitive = { attributes: { POSITION: 0 }, indices: 1 };
		const shared = glbOf([{ mesh: 0 }], { meshes: [{ primitives: Array(300).fill(primitive) }] });
		const { points, triangles } = readGlb(shared);
		expect([points.length, triangles.length]).toEqual([300 * 12, 300 * 12]);
		const one = { bufferView: 1, componentType: 5125, type: "SCALAR", count: 3 };
		const accessors = [{ bufferView: 0, componentType: 5126, count: 4, type: "VEC3" }, one];
		expect(readGlb(glbOf([{ mesh: 0 }], { accessors })).points).toHaveLength(9);
	});

	it("is rejected if a GLB has very many parts, and read if nodes are nested very deep", () => {
		const nodes = Array.from({ length: 1001 }, () => ({ mesh: 0 }));
		const meshes = [{ primitives: Array(100).fill({ attributes: {}, mode: 1 }) }];
		expect(() => readGlb(glbOf(nodes, { meshes }))).toThrow("The GLB has more than 100,000 parts.");
		const chain = Array.from({ length: 50_000 }, (_, i) => (i < 49_999 ? { children: [i + 1] } : { mesh: 0 }));
		expect(readGlb(glbOf(chain)).triangles).toHaveLength(12);
	});

	it("is rejected if a GLB's node moves points to invalid places, or if coordinates are too large", () => {
		for (const placing of [{ matrix: [1] }, { scale: [1e308, 1e308, 1e308] }])
			expect(() => readGlb(glbOf([{ mesh: 0, ...placing }]))).toThrow("The GLB has a point with an invalid position.");
		const far = readObj(BOX.replace("v 1 2 3", "v -1e300 2 3"));
		expect(() => closedMesh(far)).toThrow("The mesh extends beyond 10³⁰ units.");
	});

	it("comes from text whose lines end with CR, with LF or with both", () => {
		const plain = readObj(BOX);
		for (const end of ["\r", "\r\n"]) expect(readObj(BOX.replaceAll("\n", end))).toEqual(plain);
		expect(() => readObj("v 0 0 0\r\nv 0 0 0\rv 0\n")).toThrow("Line 3 of the OBJ: a point needs three numbers.");
		const stl = (end: string) => readStl(textStl(plain, /\n/g, end).buffer);
		expect(stl("\r")).toEqual(stl("\n"));
	});

	it("is rejected if an OBJ has more points than its triangles can use, or a face of too many corners", () => {
		expect(() => readObj("v 0 0 0\n".repeat(1_500_001))).toThrow("The mesh has more than 1,500,000 points.");
		const face = `v 0 0 0\nf ${"1 ".repeat(500_002)}`;
		expect(readObj(face).triangles).toHaveLength(1_500_000);
		expect(() => readObj(`${face} 1 9`)).toThrow(
			"The mesh has more than 500,000 triangles. Simplify it and try again.",
		);
	});

	it("contains every node of a GLB once; without scenes, reading begins at the nodes without parents", () => {
		const nodes = [{ mesh: 0, translation: [5, 0, 0] }, { children: [0] }];
		for (const more of [{}, { scenes: [{ nodes: [1] }] }]) {
			expect(readGlb(glbOf(nodes, more)).triangles).toHaveLength(12);
		}
	});

	it("is rejected at once if a GLB's nodes form no tree", () => {
		// Two paths at each of forty nodes give 10¹² visits.
		const ladder = Array.from({ length: 40 }, (_, i) => (i < 39 ? { children: [i + 1, i + 1] } : { mesh: 0 }));
		expect(() => readGlb(glbOf(ladder))).toThrow("The GLB’s nodes do not form a tree.");
		const ring = [{ children: [1] }, { children: [0] }];
		expect(() => readGlb(glbOf(ring, { scenes: [{ nodes: [0] }] }))).toThrow("The GLB’s nodes do not form a tree.");
	});
});
