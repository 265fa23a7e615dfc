/** The published meaning of version 1 of a link. Where one of these fails, old links have changed: make a new version. */

import { expect, it } from "vitest";
import { PRESETS } from "../../../web/src/models/bunch/presets/presets";
import { valueIn } from "../../../web/src/specimen/table";
import { decodeLink, decodeQuery, ENTRIES } from "../bunch";

it("presets and defaults are those that were published", async () => {
	const known = ENTRIES.filter(({ since }) => since === 1);
	const published = PRESETS.filter(({ kind }) => kind !== "variety");
	const lines = published.map(({ name }) => {
		const { specimen, notes } = decodeQuery(`?v=1&preset=${name}`);
		expect(notes).toEqual([]);
		expect(specimen.parameters.procedure).toBe(0);
		const values = Object.fromEntries(known.map((entry) => [entry.key, valueIn(specimen, entry)]));
		return `\t${JSON.stringify(name)}: ${JSON.stringify(values)}`;
	});
	await expect(`{\n${lines.join(",\n")}\n}\n`).toMatchFileSnapshot("version_1.json");
});

it.each([
	["?v=1", { parameters: { procedure: 0 } }],
	["?l=300&seed=7", { parameters: { l: 300, procedure: 0 }, seed: 7 }],
	["?v=1&model=bunch&preset=duku&unit=0.5", { preset: "duku", parameters: { l: 477, unit: 0.5 } }],
	["?v=1&p3=79,76&p4=116.25,91&p5=101,112&p6=97,103", { parameters: { p3w: 79, p3r: 76, p4w: 116.25, p6r: 103 } }],
	["?v=1&p3=79%2C76", { parameters: { p3w: 79, p3r: 76 } }],
	["?v=1&rmin=12&rmax=14&wing=0.4&wing_angle=70", { parameters: { rmin: 12, rmax: 14, wing: 0.4, wing_angle: 70 } }],
	["?v=1&delta=20&t=9&sag=0&yaw=45&roll=-90", { parameters: { delta: 20, t: 9, sag: 0, yaw: 45, roll: -90 } }],
	["?v=1&li=40&lw=5&wi=9.5&rp=2", { parameters: { li: 40, lw: 5, wi: 9.5, rp: 2 } }],
	["?v=1&rw=.9&rrr=.8&rrf=.7&re=.5&rff=.6", { parameters: { rw: 0.9, rrr: 0.8, rrf: 0.7, re: 0.5, rff: 0.6 } }],
	["?v=1&fit=0&vary=0&skin=a9b04e&stem=8A8A4A&bloom=0", { parameters: { fit: 0 }, look: { stem: "8a8a4a", bloom: 0 } }],
	["?v=1&m=3&n=1,2", { inputs: { m: 3, n: [1, 2] } }],
	["?v=1#g=S6zIzM-1UnDTMNSM1nbTMNKM5QIA", { grammar: "axiom: F(1)[+F(2)]\n" }],
])("%s means what it meant", async (link, meant) => {
	const { search, hash } = new URL(link, "https://example.org/");
	const { specimen, notes } = await decodeLink(search, hash);
	expect(notes).toEqual([]);
	expect(specimen).toMatchObject(meant);
});
