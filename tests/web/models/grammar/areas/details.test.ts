import { describe, expect, it } from "vitest";
import { type Area, MAX_AREAS, UNTURNED } from "../../../../../web/src/models/grammar/areas/area";
import { areaBlocks } from "../../../../../web/src/models/grammar/areas/blocks";
import { fittedArea } from "../../../../../web/src/models/grammar/details/areas";
import { GRAMMAR } from "../../../../../web/src/models/grammar/schema";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import { decodeLink, decodeQuery, encodeLink } from "../../../../../web/src/specimen/link";
import { restore } from "../../../../../web/src/specimen/restore";
import { writtenSpecimen } from "../../../../../web/src/specimen/written";

const bush = fromPreset(GRAMMAR, "bush");
const box: Area = { kind: "box", centre: [0, 0.8, 0], size: [1, 1.2, 1], rotation: UNTURNED };
const cone: Area = { kind: "cone", centre: [0.1, 2, -0.25], size: [1, 2, 1], rotation: [0, 0, 0.3827, 0.9239] };
const mesh = { points: [0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0], triangles: [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2] };
const meshed: Area = { ...box, kind: "mesh", mesh };

const notesOf = (query: string) => decodeQuery(GRAMMAR, `?v=2&model=grammar&${query}`).notes.map(({ text }) => text);

describe("growth areas and path of a document", () => {
	it("go into a link and come back", async () => {
		const specimen = { ...bush, areas: [box, cone], path: [0, 0.5, 0, 0.25, 2, -0.125] };
		const link = await encodeLink(GRAMMAR, specimen);
		expect(decodeURIComponent(link)).toContain(
			"areas=box:0,0.8,0:1,1.2,1;cone:0.1,2,-0.25:1,2,1:0,0,0.3827,0.9239&path=0,0.5,0,0.25,2,-0.125",
		);
		expect(await decodeLink(GRAMMAR, link)).toEqual({ specimen, notes: [] });
	});

	it("are stored in files with their meshes, which links replace by an ellipsoid with a note", async () => {
		const specimen = { ...bush, areas: [cone, meshed] };
		const written = JSON.parse(JSON.stringify(writtenSpecimen(GRAMMAR, specimen)));
		expect(restore(GRAMMAR, written)).toEqual({ specimen, notes: [] });
		const { specimen: read, notes } = await decodeLink(GRAMMAR, await encodeLink(GRAMMAR, specimen));
		expect(read.areas?.map(({ kind }) => kind)).toEqual(["cone", "ellipsoid"]);
		expect(notes.map(({ text }) => text)).toEqual([
			expect.stringMatching(/^mesh: The link does not contain a mesh\. Links cannot hold a mesh/),
		]);
		const reasons = GRAMMAR.details.flatMap(({ unlinked }) => unlinked?.keep(specimen, bush) ?? []);
		expect(reasons).toEqual([expect.stringContaining("Download a JSON or GLB to keep the mesh")]);
	});

	it("are noted and left out where they cannot be read, and brought within reach", () => {
		expect(notesOf("areas=box:0,1:1,1,1;blob:0,0,0:1,1,1")).toHaveLength(2);
		expect(notesOf("path=1,2")).toEqual([expect.stringContaining("is not a list of points")]);
		for (const wrong of ["0,2", "0,0", "1,1", "0", "a"])
			expect(notesOf(`path=0,1,0,0,2,0&from=${wrong}`), wrong).toEqual([expect.stringContaining("an earlier point")]);
		expect(notesOf("path=0,1,0,0,2,0,1,2,0&from=0,1,1")).toEqual([]);
		expect(
			notesOf(
				`areas=${Array(MAX_AREAS + 1)
					.fill("box:0,0,0:1,1,1")
					.join(";")}`,
			),
		).toHaveLength(1);
		const { specimen } = decodeQuery(GRAMMAR, "?v=2&model=grammar&areas=sphere:0,999,0:0,3,3:0,0,0,-2");
		expect(specimen.areas).toEqual([
			{ kind: "sphere", centre: [0, 100, 0], size: [0.01, 0.01, 0.01], rotation: UNTURNED },
		]);
	});

	it("are normalised: normalising twice changes nothing", () => {
		for (let i = 0; i < 200; i++) {
			const any = (k: number) => Math.sin(12.9898 * (i + 1) * (k + 1)) * 3;
			const fitted = fittedArea({
				kind: "box",
				centre: [any(1), any(2), any(3)],
				size: [any(4), any(5), any(6)],
				rotation: [any(7), any(8), any(9), any(10)],
			});
			expect(fittedArea(fitted)).toEqual(fitted);
		}
	});

	it("are sent to the core, each with its own mesh", () => {
		expect(areaBlocks({})).toEqual([]);
		const blocks = new Map(
			areaBlocks({ areas: [cone, meshed], path: [1, 2, 3] }).map(({ name, data }) => [name, data]),
		);
		expect(blocks.get("areas.kinds")).toEqual(Uint32Array.of(4, 5));
		expect([...(blocks.get("areas.places") as Float32Array)].slice(10)).toEqual(
			[0, 0.8, 0, 1, 1.2, 1, 0, 0, 0, 1].map(Math.fround),
		);
		expect(blocks.get("areas.meshes")).toEqual(Uint32Array.of(0, 0, 4, 4));
		expect(blocks.get("areas.points")).toEqual(Float32Array.from(mesh.points));
		expect(blocks.get("areas.triangles")).toEqual(Uint32Array.from(mesh.triangles));
		expect(blocks.get("path")).toEqual(Float32Array.of(1, 2, 3));
	});
});
