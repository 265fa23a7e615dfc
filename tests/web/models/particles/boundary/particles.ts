/** Helpers for tests of trees and roots. */
import { readFileSync } from "node:fs";
import type { Core } from "../../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../../web/src/core/loader";
import type { BoundedSpecimen } from "../../../../../web/src/models/particles/boundary/bounded";
import type { Grip, Pose } from "../../../../../web/src/models/particles/boundary/editor/grip";
import type { RequestOptions } from "../../../../../web/src/models/particles/boundary/request";
import { encodeBounded } from "../../../../../web/src/models/particles/boundary/request";
import { readWoodenPlant, type WoodenPlant } from "../../../../../web/src/models/particles/boundary/wooden_plant";
import { ROOT } from "../../../../../web/src/models/root/schema";
import { TREE } from "../../../../../web/src/models/tree/schema";
import { fromPreset } from "../../../../../web/src/specimen/from_preset";
import type { Table } from "../../../../../web/src/specimen/table";

/** The core that was built last. */
export const particlesCore = (): Promise<Core> =>
	loadCoreFromBytes(readFileSync(new URL("../../../../../build/core/particles.wasm", import.meta.url)));

export const growBounded = (
	core: Core,
	table: Table,
	specimen: BoundedSpecimen,
	options?: RequestOptions,
): WoodenPlant => readWoodenPlant(core.grow(encodeBounded(table, specimen, options)));

export const tree = (preset: string) => fromPreset(TREE, preset);
export const root = (preset: string) => fromPreset(ROOT, preset);

/** A grip of a pose, by its id. */
export function gripOf({ grips }: Pose, id: string): Grip {
	const found = grips.find((each) => each.id === id);
	if (!found) throw new Error(`There is no grip ${id} among ${grips.map((each) => each.id)}.`);
	return found;
}
