import { expect, it, vi } from "vitest";
import type { Client } from "../../../web/src/core/client";
import { Superseded } from "../../../web/src/core/errors";
import { readAttributes } from "../../../web/src/element/attributes";
import { growDocument } from "../../../web/src/element/grow_document";
import type { SpecimenDocument } from "../../../web/src/element/grown_detail";
import { plantInWords } from "../../../web/src/generate/plant_in_words";
import { model } from "../../../web/src/models/stand/index";
import { grownStand, PLAN, planned, run } from "../models/stand/stands";

vi.mock("../../../web/src/core/core_address", () => ({ coreAddress: (file: string) => file }));

const stand: SpecimenDocument = { model, specimen: planned(PLAN), notes: [] };

/** Grows the stand; it is superseded after a number of member plants. */
async function superseded(after: number) {
	let grown = 0;
	const client: Pick<Client, "grow" | "growMember"> = {
		grow: ({ wasm, blocks }) => run(wasm, blocks),
		growMember: async ({ wasm, blocks }) => {
			const answer = await run(wasm, blocks);
			grown++;
			return answer;
		},
	};
	const plant = growDocument(client, stand, { meshes: false }, new AbortController().signal, () => grown < after);
	return { plant: await plant.catch((error: unknown) => error), grown: () => grown };
}

it("a superseded stand stops growing and is not shown", async () => {
	const early = await superseded(2);
	expect(early.plant).toBeInstanceOf(Superseded);
	// Growths that were running already.
	expect(early.grown()).toBeLessThan(8);
	expect((await superseded(11)).plant).toBeInstanceOf(Superseded);
	expect(await superseded(12)).toMatchObject({ plant: { fingerprint: (await grownStand()).fingerprint } });
});

it("a flower and a bed grow from attributes, the flower with parameters defined in its text", async () => {
	const client: Pick<Client, "grow" | "growMember"> = {
		grow: ({ wasm, blocks }) => run(wasm, blocks),
		growMember: ({ wasm, blocks }) => run(wasm, blocks),
	};
	const grown = async (attributes: Record<string, string>) => {
		const reading = await readAttributes(Object.entries(attributes).map(([name, value]) => ({ name, value })));
		expect(reading.notes).toEqual([]);
		const plant = await growDocument(
			client,
			{ ...reading, notes: [] },
			{ meshes: false },
			new AbortController().signal,
			() => true,
		);
		return plantInWords({ model: reading.model, specimen: reading.specimen, grown: plant });
	};
	const tulip = { model: "flower", preset: "tulip" };
	const [open, bud, tall] = await Promise.all(
		[tulip, { ...tulip, age: "0" }, { ...tulip, define: "length:500" }].map(grown),
	);
	expect(open).toMatch(/^Tulip flower: \d+ cm tall, \d+ organs, /);
	const height = (words: string) => Number(/(\d+) cm/.exec(words)?.[1]);
	expect(height(bud)).toBeLessThan(height(open));
	expect(height(tall)).toBeGreaterThan(height(open));
	expect(await grown({ model: "stand", preset: "flowerbed", many: "20" })).toMatch(
		/^A flowerbed in June.*: 20 plants of /,
	);
});
