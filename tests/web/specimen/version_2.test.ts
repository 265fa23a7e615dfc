/** The published meaning of version 2 of a link. Where one of these fails, old links have changed: make a new version. */

import { expect, it } from "vitest";
import { PRESETS } from "../../../web/src/models/bunch/presets/presets";
import { decodeLink, decodeQuery } from "../bunch";

it("presets and defaults are those that were published", async () => {
	const lines = PRESETS.map(({ name }) => {
		const { parameters, look } = decodeQuery(`?v=2&preset=${name}`).specimen;
		return `\t${JSON.stringify(name)}: ${JSON.stringify({ ...parameters, ...look })}`;
	});
	await expect(`{\n${lines.join(",\n")}\n}\n`).toMatchFileSnapshot("version_2.json");
});

it.each([
	["?v=2", { preset: "long-conical", parameters: { procedure: 1, age: 100 }, thinned: [] }],
	["?v=2&procedure=paper", { parameters: { procedure: 0 } }],
	["?v=2&procedure=natural", { parameters: { procedure: 1 } }],
	["?v=2&size=14&spread=10&density=8.5&count=120", { parameters: { size: 14, spread: 10, density: 8.5, count: 120 } }],
	["?v=2&elongation=1.4&taper=-.3&blunt=.6", { parameters: { elongation: 1.4, taper: -0.3, blunt: 0.6 } }],
	["?v=2&pedicel=11.5&bend=0&fruit=longan", { parameters: { pedicel: 11.5, bend: 0, fruit: 4 } }],
	["?v=2&age=62.5&sun=90&sun_height=30", { parameters: { age: 62.5, sun: 90, sun_height: 30 } }],
	["?v=2&sunlight=.8&vigour=1&leaves=2&cane=on", { parameters: { sunlight: 0.8, vigour: 1, leaves: 2, cane: 1 } }],
	["?v=2&unripe=9ab14c&glow=.3&uneven=0", { look: { unripe: "9ab14c", glow: 0.3, uneven: 0 } }],
	["?v=2&lenticels=1", { look: { lenticels: 1 } }],
	["?v=2&thin=a.1z.hra0hr", { thinned: [10, 71, 2 ** 30 - 1] }],
	["?v=2&preset=duku&l=300&p3=12,16", { preset: "duku", parameters: { l: 300, p3w: 12, p3r: 16, fruit: 5 } }],
])("%s means what it meant", async (link, meant) => {
	const { search, hash } = new URL(link, "https://example.org/");
	const { specimen, notes } = await decodeLink(search, hash);
	expect(notes).toEqual([]);
	expect(specimen).toMatchObject(meant);
});
