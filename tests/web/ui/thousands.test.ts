import { expect, it } from "vitest";
import { withThousands } from "../../../web/src/ui/thousands";

it.each([
	["The string grows beyond 67108864 words.", "The string grows beyond 67,108,864 words."],
	["500000 segments, 1024 steps", "500,000 segments, 1024 steps"],
	[
		"At 0.123456 and 123456.5 nothing changes, nor at 1,000,000.",
		"At 0.123456 and 123456.5 nothing changes, nor at 1,000,000.",
	],
])("%s", (text, words) => expect(withThousands(text)).toBe(words));
