import { expect, it } from "vitest";
import type { Grown } from "../../../web/src/core/grown";
import { withParameters } from "../../../web/src/specimen/edit";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";
import { fileName } from "../../../web/src/studio/files/formats";
import { bunchInWords, lengthInWords, stemsInWords } from "../../../web/src/studio/words";

const berries = (count: number) => ({ procedure: "natural", counts: { berries: count } }) as Grown;

it("says a bunch in plain words, in the units of a ruler", () => {
	const conical = specimenFromPreset("long-conical");
	expect(bunchInWords(berries(73), conical)).toBe("73 berries, 22 cm long");
	expect(bunchInWords(berries(1), conical)).toBe("1 berry, 22 cm long");
	const counts = { pedicels: 120, withered: 34 };
	expect(stemsInWords({ procedure: "paper", counts } as Grown)).toBe("120 pedicels, 34 withered");
	expect(stemsInWords({ procedure: "natural", counts } as Grown)).toBe("120 pedicels");
	expect(lengthInWords(specimenFromPreset("lychee"))).toBe("6.7 cm");
});

it("calls berries flowers until they have set, where they come from flowers", () => {
	const young = withParameters(specimenFromPreset("long-conical"), { age: 9.9 });
	expect(bunchInWords(berries(73), young)).toBe("73 flowers, 22 cm long");
	expect(bunchInWords({ ...berries(73), procedure: "paper" }, young)).toBe("73 berries, 22 cm long");
});

it("names files after what grew", () => {
	expect(fileName({ ...specimenFromPreset("grape-15a"), seed: 7 })).toBe("grape-15a-7");
});
