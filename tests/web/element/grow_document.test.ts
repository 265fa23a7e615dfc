import { expect, it, vi } from "vitest";
import type { Client } from "../../../web/src/core/client";
import { Superseded } from "../../../web/src/core/errors";
import { growDocument } from "../../../web/src/element/grow_document";
import type { Document } from "../../../web/src/element/grown_detail";
import { model } from "../../../web/src/models/stand/index";
import { grownStand, PLAN, planned, run } from "../models/stand/stands";

vi.mock("../../../web/src/core/core_address", () => ({ coreAddress: (file: string) => file }));

const stand: Document = { model, specimen: planned(PLAN), notes: [] };

/** Grows it; once so many plants in it have grown, something newer is asked for. */
async function superseded(after: number) {
	let grown = 0;
	const client: Pick<Client, "grow" | "among"> = {
		grow: ({ wasm, blocks }) => run(wasm, blocks),
		among: async ({ wasm, blocks }) => {
			const answer = await run(wasm, blocks);
			grown++;
			return answer;
		},
	};
	const plant = growDocument(client, stand, { meshes: false }, new AbortController().signal, () => grown < after);
	return { plant: await plant.catch((error: unknown) => error), grown: () => grown };
}

it("a stand that something newer has taken the place of grows no further, and is not shown", async () => {
	const early = await superseded(2);
	expect(early.plant).toBeInstanceOf(Superseded);
	// Those that were under way.
	expect(early.grown()).toBeLessThan(8);
	expect((await superseded(11)).plant).toBeInstanceOf(Superseded);
	expect(await superseded(12)).toMatchObject({ plant: { fingerprint: (await grownStand()).fingerprint } });
});
