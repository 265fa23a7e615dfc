import { beforeAll, expect, it } from "vitest";
import { titleOf } from "../../../web/src/app/title";
import { choose } from "../../../web/src/models/flower/design/choose";
import { usual } from "../../../web/src/models/flower/design/description";
import { designOf } from "../../../web/src/models/flower/design/design";
import { designedNear } from "../../../web/src/models/flower/design/near";
import { model as flower } from "../../../web/src/models/flower/index";
import * as flowers from "../../../web/src/models/flower/texts";
import { model as growth } from "../../../web/src/models/growth/index";
import * as trees from "../../../web/src/models/growth/texts";
import { put, volumesOf } from "../../../web/src/models/growth/volumes/volume_tool";
import type { Model } from "../../../web/src/models/model";
import { fromPreset } from "../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../web/src/specimen/specimen";

const OWN = "footprint -> GrowVol(1, 1, 4, 10, 2.5, 0)\ntree -> trunk\n";
const tree = (grammar: string) =>
	titleOf({ ...fromPreset(growth, "oak"), grammar } as Specimen, growth as unknown as Model);

it("before the preset's text has come nobody can tell whether a text is that one altered", () => {
	expect(tree(OWN)).toBe("A growth grammar of your own");
});

beforeAll(() => Promise.all([flowers.fetchTexts(), trees.fetchTexts()]));

it("a tree whose handle was dragged is its preset, altered; one by another text is not", () => {
	const oak = fromPreset(growth, "oak");
	const [first, ...rest] = volumesOf(oak, undefined);
	const { details } = put(oak, [{ ...first, height: 7.25, at: [1, 2] }, ...rest]);
	expect(tree(String(details?.grammar))).toBe("Oak (edited)");
	const text = trees.fetchedText({ preset: "oak" }) ?? "";
	expect(tree(text.replace(/\d+/g, (digits) => String(Number(digits) + 1)))).toBe("Oak (edited)");
	expect(tree(OWN)).toBe("A growth grammar of your own");
	expect(tree(trees.fetchedText({ preset: "figure-5" }) ?? "")).toBe("A growth grammar of your own");
});

it("so is a designed flower by a choice", () => {
	const tulip = fromPreset(flower, "designed-tulip");
	const titled = (grammar: string) => titleOf({ ...tulip, grammar } as Specimen, flower as unknown as Model);
	const design = designOf(flowers.fetchedText({ preset: tulip.preset }) ?? "");
	if (!design) throw new Error("no design");
	expect(titled(choose(design, usual("petal", { count: 5, length: 33 })).text)).toBe("Tulip by choices (edited)");
	expect(titled("#axiom: A\n")).toBe("A flower grammar of your own");
});

it("of every flower a designed one is near", () => {
	for (const { name } of flower.presets.list) expect(flower.presets.named(designedNear(name))?.kind).toBe("designed");
	expect(designedNear("lily")).toBe("designed-lily");
	expect(designedNear("tulip")).toBe("designed-tulip");
});
