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

function contextWith() {
	const context = {
		state: { model: TREE as object, specimen: fromPreset(TREE, "oak") },
		set: vi.fn((_: Change) => undefined),
		notify: vi.fn((_: string) => undefined),
	};
	return context;
}

const READERS = [
	["mesh", (context: object) => takeMesh(context as never, new File([OBJ], "a.obj"), "height")],
	["outline", (context: object) => traceLeafFile(context as never, new Blob())],
] as const;

it.each(READERS)("a file read late changes the document that it was brought for: %s", async (_, take) => {
	const context = contextWith();
	await take(context);
	expect(context.set).toHaveBeenCalledOnce();
	expect(context.notify.mock.calls[0][0]).not.toContain("was not");
});

it.each(READERS)("does not change a document that was opened meanwhile: %s", async (what, take) => {
	for (const come of [{ model: {} }, { specimen: fromPreset(TREE, "birch") }]) {
		const context = contextWith();
		const taken = take(context);
		Object.assign(context.state, come);
		await taken;
		expect(context.set).not.toHaveBeenCalled();
		expect(context.notify.mock.calls).toEqual([
			[expect.stringMatching(`^The ${what} was not (used|taken)$`), expect.anything(), expect.anything()],
		]);
	}
});

it("a slider moved meanwhile does not matter", async () => {
	for (const [, take] of READERS) {
		const context = contextWith();
		const taken = take(context);
		context.state.specimen = { ...context.state.specimen, seed: 9 };
		await taken;
		expect(context.set).toHaveBeenCalledOnce();
	}
});
