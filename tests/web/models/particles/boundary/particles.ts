/** What tests of trees and roots share. */
import { readFileSync } from "node:fs";
import type { Core } from "../../../../../web/src/core/core";
import { loadCoreFromBytes } from "../../../../../web/src/core/loader";
import type { BoundedSpecimen } from "../../../../../web/src/models/particles/boundary/bounded";
import type { RequestOptions } from "../../../../../web/src/models/particles/boundary/request";
import { encodeBounded } from "../../../../../web/src/models/particles/boundary/request";
import { readWoodenPlant, type WoodenPlant } from "../../../../../web/src/models/particles/boundary/wooden_plant";
import type { Table } from "../../../../../web/src/specimen/table";

/** The core as it was last built. */
export const particlesCore = (): Promise<Core> =>
	loadCoreFromBytes(readFileSync(new URL("../../../../../build/core/particles.wasm", import.meta.url)));

export const growBounded = (
	core: Core,
	table: Table,
	specimen: BoundedSpecimen,
	options?: RequestOptions,
): WoodenPlant => readWoodenPlant(core.grow(encodeBounded(table, specimen, options)));
