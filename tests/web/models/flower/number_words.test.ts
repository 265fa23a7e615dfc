import { expect, it } from "vitest";
import { describeNumber } from "../../../../web/src/models/flower/ui/number_words";

const TEXT = `#define length=325 /* 160 … 530 mm, of the stem */
#define bend=2
# define kept=1 /* how much of it is left */ /* else */
#define STEM(8,0,0,0,2,3,3,1) /* of no name */
`;

it.each([
	["length", "160 … 530 mm, of the stem"],
	["bend", ""],
	["kept", "how much of it is left"],
	["STEM", ""],
	["unknown", ""],
	["N", "sides"],
	["H", "height, mm"],
	["atx", "rotation about x, °"],
])("%s is described as “%s”", (name, words) => expect(describeNumber(TEXT, name)).toBe(words));
