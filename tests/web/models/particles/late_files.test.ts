import { expect, it, vi } from "vitest";
import { traceLeafFile } from "../../../../web/src/models/leaf/ui/trace";
import { takeMesh } from "../../../../web/src/models/particles/boundary/mesh_tool";
import { TREE } from "../../../../web/src/models/tree/schema";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import type { Change } from "../../../../web/src/ui/editor_context";

vi.mock("../../../../web/src/import/tracing/read_picture", () => ({ readPicture: async () => ({}) }));
vi.mock("../../../../web/src/models/leaf/trace/trace", () => ({
	traceLeaf: () => ({ outline: [{ x: 0, y: 0 }] }),
}));
// There are no workers here.
vi.mock("../../../../web/src/import/mesh_file/read_in_worker", async () => ({
	readMeshInWorker: (await import("../../../../web/src/import/mesh_file/read")).readMeshFile,
}));

const OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

function deskWith() {
	const desk = {
		state: { model: TREE as object, specimen: fromPreset(TREE, "oak") },
		set: vi.fn((_: Change) => undefined),
		notify: vi.fn((_: string) => undefined),
	};
	return desk;
}

const READERS = [
	["mesh", (desk: object) => takeMesh(desk as never, new File([OBJ], "a.obj"), "height")],
	["outline", (desk: object) => traceLeafFile(desk as never, new Blob())],
] as const;

it.each(READERS)("a file read late changes the document that it was brought for: %s", async (_, take) => {
	const desk = deskWith();
	await take(desk);
	expect(desk.set).toHaveBeenCalledOnce();
	expect(desk.notify.mock.calls[0][0]).not.toContain("not taken");
});

it.each(READERS)("and no other that has come meanwhile: %s", async (what, take) => {
	for (const come of [{ model: {} }, { specimen: fromPreset(TREE, "birch") }]) {
		const desk = deskWith();
		const taken = take(desk);
		Object.assign(desk.state, come);
		await taken;
		expect(desk.set).not.toHaveBeenCalled();
		expect(desk.notify.mock.calls).toEqual([[`The ${what} was not taken`, expect.anything(), expect.anything()]]);
	}
});

it("a slider moved meanwhile does not matter", async () => {
	for (const [, take] of READERS) {
		const desk = deskWith();
		const taken = take(desk);
		desk.state.specimen = { ...desk.state.specimen, seed: 9 };
		await taken;
		expect(desk.set).toHaveBeenCalledOnce();
	}
});
