import { beforeAll, describe, expect, it, vi } from "vitest";
import { dropsOf } from "../../../web/src/app/files/drops";
import { openFile } from "../../../web/src/app/files/open";
import { png } from "../../../web/src/formats/png";
import { withLink } from "../../../web/src/formats/png_link";
import { model as leaf } from "../../../web/src/models/leaf/index";
import type { PageModel } from "../../../web/src/models/page_model";
import { model as tree } from "../../../web/src/models/tree/index";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import { writtenSpecimen } from "../../../web/src/specimen/written";
import { studioWith } from "./context";

// There are no workers here: files are read on this thread, by the same reader.
vi.mock("../../../web/src/import/mesh_file/read_in_worker", async () => ({
	readMeshInWorker: (await import("../../../web/src/import/mesh_file/read")).readMeshFile,
}));

const [leafModel, treeModel] = [leaf, tree] as unknown as PageModel[];
const BALL = ["1 0 0", "-1 0 0", "0 1 0", "0 -1 0", "0 0 1", "0 0 -1"].map((point) => `v ${point}`);
const FACES = ["1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6"].map((face) => `f ${face}`);

/** A studio with a model's default preset, its messages, and a function that opens a file in it. */
async function brought(model: PageModel) {
	const { studio } = await studioWith(fromPreset(model), model);
	const messages = () => studio.state.notices.map(({ title, details }) => [title, ...details].join(" "));
	const bring = async (file: File) => {
		await openFile(studio, file);
		// Tools fetch the script that reads the file.
		await vi.waitFor(() => expect(messages().join()).not.toBe(""));
		await new Promise((resolve) => setTimeout(resolve, 50));
		return messages();
	};
	return { studio, messages, bring };
}

describe("a file that is opened or dropped", () => {
	beforeAll(() => {
		const bitmap = () => Promise.reject(new Error("no picture"));
		vi.stubGlobal("createImageBitmap", bitmap);
	});

	it("goes to the tool that takes it if it holds no plant: a picture is traced on a leaf", async () => {
		const { bring, studio } = await brought(leafModel);
		expect(dropsOf(studio).map(({ description }) => description)).toEqual(["Drop a picture of a leaf to trace it"]);
		const notices = await bring(new File([Uint8Array.of(0xff, 0xd8, 0xff)], "oak.jpg", { type: "image/jpeg" }));
		expect(notices).toEqual([expect.stringMatching(/^The picture was not traced The file is not a picture/)]);
	});

	it("is refused with a notice if no tool takes it", async () => {
		const { bring } = await brought(treeModel);
		const notices = await bring(new File([Uint8Array.of(0xff, 0xd8, 0xff)], "oak.jpg", { type: "image/jpeg" }));
		expect(notices).toEqual([expect.stringContaining("oak.jpg is neither a GLB nor readable JSON")]);
	});

	it("is refused with a list of the models whose tools would take it", async () => {
		const picture = await (await brought(treeModel)).bring(
			new File([Uint8Array.of(0xff)], "oak.jpg", { type: "image/jpeg" }),
		);
		expect(picture[0]).toMatch(/ Leaf: Drop a picture of a leaf to trace it\.$/);
		const mesh = await (await brought(leafModel)).bring(new File(["v 0 0 0"], "cube.obj"));
		expect(mesh[0]).toContain(
			" Root: Drop a closed mesh (OBJ, GLB, STL) to use it as the boundary. Tree: Drop a closed mesh (OBJ, GLB, STL) to use it as the boundary.",
		);
		const notes = await (await brought(leafModel)).bring(new File(["?"], "notes.txt"));
		expect(notes[0]).toMatch(
			/exported from Panicle\. Grammar files \(\.lsys, \.gl3, \.growth, \.stand, \.xml\) can be opened at any time\. Leaf: Drop a picture of a leaf to trace it\.$/,
		);
	});

	it("becomes a tree's boundary if it is a mesh of a supported format; others are refused with the formats", async () => {
		const { bring, studio } = await brought(treeModel);
		expect(await bring(new File(["ply"], "ball.ply"))).toEqual([
			expect.stringContaining("ball.ply is not an OBJ, GLB or STL file. Save the mesh in one of these formats."),
		]);
		expect(await bring(new File([[...BALL, ...FACES].join("\n")], "ball.obj"))).toEqual([
			expect.stringMatching(/^The mesh is now the boundary/),
		]);
		expect(studio.state.specimen).toMatchObject({ volume: { triangles: { length: 24 } } });
		expect(await bring(new File([[...BALL, ...FACES.slice(1)].join("\n")], "open.obj"))).toEqual([
			expect.stringMatching(/^The mesh could not be read The mesh has holes \(3 open edges\)/),
		]);
	});

	it("is opened by the link in a picture; a picture without a link goes to the tools", async () => {
		const { studio, bring, messages } = await brought(leafModel);
		const bare = png({ width: 1, height: 1, pixels: Uint8Array.of(1, 2, 3) });
		const picture = async (link: string) =>
			new File([await withLink(new Blob([bare]), link)], "plant.png", { type: "image/png" });
		await openFile(studio, await picture("https://else.example/app/?v=2&model=tree&preset=birch&seed=5"));
		expect(studio.state.specimen).toMatchObject({ model: "tree", preset: "birch", seed: 5 });
		expect(messages()).toEqual([]);
		// A link from outside is not trusted: values are limited to their ranges, with a note.
		await openFile(studio, await picture("javascript:alert(1)?v=9&model=leaf&seed=-3&__proto__=x"));
		expect(studio.state.specimen).toMatchObject({ model: "leaf", seed: 0 });
		expect(messages()).toEqual([expect.stringMatching(/^Some of this file could not be read.*newer version \(9\)/)]);
		expect(await bring(new File([bare], "bare.png", { type: "image/png" }))).toEqual([
			expect.stringMatching(/^The picture was not traced/),
		]);
	});

	it("grows if it is a grammar's text; XML may be longer than the text in it", async () => {
		const { bring, studio, messages } = await brought(leafModel);
		const axiom = "<axiom>A</axiom>".padEnd(300_000);
		await openFile(studio, new File([axiom], "a.xml"));
		expect(studio.state.specimen).toMatchObject({ model: "flower", grammar: "#axiom: A\n" });
		expect(messages()).toEqual([]);
		expect(await bring(new File([" ".repeat(300_000)], "a.gl3"))).toEqual([
			"The file was not opened a.gl3: The grammar is longer than 256 KiB.",
		]);
		expect(await bring(new File([axiom.padEnd(8_400_000)], "a.xml"))).toContain(
			"The file was not opened a.xml: The grammar is longer than 8,192 KiB.",
		);
		// The plant stays if the text in the XML is too long.
		const before = studio.state.specimen;
		const long = `<axiom>${"A".repeat(300_000)}</axiom>`;
		expect(await bring(new File([long], "long.xml"))).toContain(
			"The file was not opened The grammar in long.xml: The grammar is longer than 256 KiB.",
		);
		expect(studio.state.specimen).toBe(before);
	});

	it("removes the notice about the file before", async () => {
		const { bring, studio, messages } = await brought(leafModel);
		expect(await bring(new File(["?"], "notes.txt"))).toHaveLength(1);
		const specimen = writtenSpecimen(treeModel, { ...fromPreset(treeModel), seed: 5 });
		await openFile(studio, new File([JSON.stringify({ specimen })], "tree.json"));
		expect(studio.state.specimen).toMatchObject({ model: "tree", seed: 5 });
		expect(messages()).toEqual([]);
	});
});
