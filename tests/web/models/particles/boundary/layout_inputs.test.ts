import { describe, expect, it } from "vitest";
import { layoutInputs } from "../../../../../web/src/models/particles/boundary/editor/boundary_layout";
import { TREE } from "../../../../../web/src/models/tree/schema";
import type { TreeSpecimen } from "../../../../../web/src/models/tree/specimen";
import { apply } from "../../../../../web/src/ui/change";
import { changed } from "../../../../../web/src/ui/changed";
import type { EditorContext } from "../../../../../web/src/ui/editor_context";
import { tree } from "./particles";

describe("inputs of a boundary's geometry", () => {
	const piecesOf = (specimen = tree("oak"), preset = tree("oak")) =>
		layoutInputs({ state: { specimen }, preset } as Pick<EditorContext<TreeSpecimen>, "state" | "preset">);
	const same = (specimen: TreeSpecimen) => !changed(piecesOf(oak, oak), piecesOf(specimen, oak));
	const oak = tree("oak");

	it("is not how old it is, but everything else", () => {
		expect(same(apply(TREE, oak, { parameters: { age: 40 } }))).toBe(true);
		for (const key of Object.keys(oak.parameters).filter((key) => key !== "age"))
			expect(same({ ...oak, parameters: { ...oak.parameters, [key]: -1 } })).toBe(false);
		expect(same(apply(TREE, oak, { details: { targets: [1, 0, 0] } }))).toBe(false);
		expect(changed(piecesOf(oak, oak), piecesOf(oak, tree("birch")))).toBe(true);
	});

	it("is another where the same thing has another name", () => {
		const box = [0, 0, 0, 1, 1, 1];
		const [walled, rounded] = [{ obstacles: box }, { rounds: box }].map((details) => ({ ...oak, ...details }));
		expect(changed(piecesOf(walled, oak), piecesOf(rounded, oak))).toBe(true);
	});
});
