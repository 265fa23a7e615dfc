import { expect, it } from "vitest";
import type { Grown } from "../../../web/src/core/grown";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";
import { fileName } from "../../../web/src/studio/files/formats";
import { bunchInWords, lengthInWords, stemsInWords } from "../../../web/src/studio/words";

const berries = (count: number) => ({ counts: { berries: count } }) as Grown;

it("says a bunch in plain words, in the units of a ruler", () => {
	const conical = specimenFromPreset("long-conical");
	expect(bunchInWords(berries(73), conical)).toBe("73 berries, 22 cm long");
	expect(bunchInWords(berries(1), conical)).toBe("1 berry, 22 cm long");
	expect(stemsInWords({ counts: { pedicels: 120, withered: 34 } } as Grown)).toBe("120 pedicels, 34 withered");
	expect(lengthInWords(specimenFromPreset("lychee"))).toBe("6.7 cm");
});

it("names files after what grew", () => {
	expect(fileName({ ...specimenFromPreset("grape-15a"), seed: 7 })).toBe("grape-15a-7");
});
