import { expect, it } from "vitest";
import type { BunchPlant } from "../../../../web/src/models/bunch/bunch_plant";
import { bunchInWords, lengthInWords, stemsInWords } from "../../../../web/src/models/bunch/words";
import { specimenFromPreset, withParameters } from "../../bunch";

/** Makes a natural bunch of a number of berries, the highest and the lowest 22 cm apart from end to end. */
const berries = (count: number) => {
	const spheres = Float32Array.of(0, 0.01, 0, 0.01, 0, -0.19, 0, 0.01);
	return { procedure: "natural", counts: { berries: count }, berries: { count: 2, spheres } } as BunchPlant;
};

it("summarises a bunch in words, in everyday units", () => {
	const conical = specimenFromPreset("long-conical");
	expect(bunchInWords(berries(73), conical)).toBe("22 cm long, with 73 berries");
	expect(bunchInWords(berries(1), conical)).toBe("22 cm long, with 1 berry");
	const counts = { pedicels: 120, withered: 34 };
	expect(stemsInWords({ procedure: "paper", counts } as BunchPlant)).toBe("120 pedicels, 34 of them withered");
	expect(stemsInWords({ procedure: "natural", counts } as BunchPlant)).toBe("120 pedicels");
	expect(lengthInWords(0.067)).toBe("6.7 cm");
	const longer = withParameters(conical, { l: 580 });
	expect(bunchInWords({ ...berries(73), procedure: "paper" }, longer)).toBe("25 cm long, with 73 berries");
	expect(bunchInWords(berries(73), longer)).toBe("22 cm long, with 73 berries");
});

it("calls berries flowers until they have set, where they come from flowers", () => {
	const young = withParameters(specimenFromPreset("long-conical"), { age: 9.9 });
	expect(bunchInWords(berries(73), young)).toBe("22 cm long, with 73 flowers");
	expect(bunchInWords({ ...berries(73), procedure: "paper" }, young)).toBe("22 cm long, with 73 berries");
});
