import { describe, expect, it } from "vitest";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { stemColours } from "../../../../../web/src/models/bunch/parts/stem_colour";
import { woodOf } from "../../../../../web/src/models/bunch/parts/stem_rules";
import { linear, meanColour } from "../../../../../web/src/plant/colour";
import { makeGrown, SKETCH } from "../fixture";
import { makeNatural } from "../natural_fixture";

const HEX = "7d8a3f";
const at = (turned: number, shrivel = 0) => makeNatural(SKETCH, { traits: () => ({ turned, shrivel }) });

/** The mean colour of the stems that `wanted` picks by internode. */
function mean(grown: BunchPlant, wanted: (internode: number) => boolean) {
	const stem = grown.stem as NonNullable<BunchPlant["stem"]>;
	const colours = stemColours(grown, stem, HEX);
	const vertices = Array.from(stem.internode.keys()).filter((vertex) => wanted(stem.internode[vertex]));
	return meanColour(Float32Array.from(vertices.flatMap((vertex) => [...colours.subarray(3 * vertex, 3 * vertex + 3)])));
}

describe("stemColours", () => {
	it("colours withered pedicels brown and dark, however green the rest", () => {
		const grown = at(0);
		const { state, kind } = grown.internodes;
		const [red, green] = mean(grown, (i) => state[i] === 1);
		const [freshRed, freshGreen] = mean(grown, (i) => state[i] === 0 && kind[i] === 3);
		expect(red / green).toBeGreaterThan(1.25 * (freshRed / freshGreen));
		expect(green).toBeLessThan(0.75 * freshGreen);
	});

	it("is a young green at first and the look's own colour where wood begins", () => {
		const [red, green, blue] = mean(at(0), (i) => at(0).internodes.kind[i] === 3 && at(0).internodes.state[i] === 0);
		const looked = linear(HEX);
		expect(green / red).toBeGreaterThan(looked[1] / looked[0]);
		expect(blue).toBeLessThan(looked[2]);
	});

	it("turns the rachis to wood first, then axes, pedicels last", () => {
		const grown = at(1);
		const redness = ([0, 1, 3] as const).map((kind) => {
			const [red, green] = mean(grown, (i) => grown.internodes.kind[i] === kind && grown.internodes.state[i] === 0);
			return red / green;
		});
		expect(redness[0]).toBeGreaterThan(1.03 * redness[1]);
		expect(redness[1]).toBeGreaterThan(1.03 * redness[2]);
	});
});

describe("the nodes of a ripe stalk", () => {
	it("are brown if distant from each other, and not visible on internodes as short as they are thick", () => {
		const grown = at(1);
		const { ends, radii, kind } = grown.internodes;
		const stout = { ...grown, internodes: { ...grown.internodes, radii: radii.slice() } };
		for (let i = 0; i < kind.length; i++) {
			const length = Math.hypot(...[0, 1, 2].map((k) => ends[6 * i + 3 + k] - ends[6 * i + k]));
			stout.internodes.radii.fill(length, 2 * i, 2 * i + 2);
		}
		const redness = (each: BunchPlant) => {
			const [red, green] = mean(each, (i) => kind[i] === 3);
			return red / green;
		};
		expect(redness(grown)).toBeGreaterThan(1.01 * redness(stout));
	});
});

describe("woodOf", () => {
	it("increases while berries turn and further while they dry, from none to all", () => {
		const ages = [at(0), at(0.3), at(1), at(1, 0.4), at(1, 1)].map(woodOf);
		expect(ages).toEqual([...new Set(ages)].sort((a, b) => a - b));
		expect([ages[0], ages.at(-1)]).toEqual([0, 1]);
	});

	it("is that of a ripe bunch for the paper's bunches, which have no age", () => {
		expect(woodOf(makeGrown(SKETCH))).toBe(woodOf(at(1)));
	});
});
