/** Helpers for tests of stands: plans grown by the built cores. */
import { readFileSync } from "node:fs";
import type { Block } from "../../../../web/src/core/container";
import { CoreCache } from "../../../../web/src/core/cores";
import { loadCoreFromBytes } from "../../../../web/src/core/loader";
import { growPlant } from "../../../../web/src/generate/growth";
import type { MembersOptions } from "../../../../web/src/generate/members";
import { model } from "../../../../web/src/models/stand/index";
import type { StandSpecimen } from "../../../../web/src/models/stand/specimen";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { fromPreset } from "../../../../web/src/specimen/from_preset";

const cores = new CoreCache(async (wasm) =>
	loadCoreFromBytes(readFileSync(new URL(`../../../../build/core/${wasm}`, import.meta.url))),
);

export const run = (wasm: string, blocks: readonly Block[]) => cores.grow(wasm, blocks);

/** Eight small trees of two kinds, two more trees, and two equal leaves on each of the last two. */
export const PLAN = `ground 20 x 10, relief 1
plants 8, blue 2
growth/table-1-sigma1, share 1, crown 4 x 8, scale 0.5 to 1: steps 3 to 5
growth/table-1-star, share 1, crown 4 x 8: steps 4
plants 2, stratified
growth/figure-5, crown 3 x 6: steps 3
leaf/oak, each 2, height 1, reach 0.5, scale 0.5, seeds 1
`;

export const planned = (grammar: string, seed = 3): StandSpecimen => ({ ...fromPreset(model), seed, grammar });

export async function grownStand(
	specimen: StandSpecimen = planned(PLAN),
	{ meshes = false, run: by = run, ...members }: MembersOptions & { run?: typeof run } = {},
): Promise<StandPlant> {
	return (await growPlant(model, specimen, { meshes }, by, members)) as StandPlant;
}
