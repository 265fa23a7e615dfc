import { expect, it } from "vitest";
import { inWords } from "../../../web/src/app/parts/readout";

it.each([
	["leaves", "Leaves"],
	["endStructures", "End structures"],
	["end_structures", "End structures"],
])("has words for a count called %s", (key, words) => expect(inWords(key)).toBe(words));
