import { expect, it } from "vitest";
import { grown } from "../bench/steady.mjs";

it("tells what goes up from what comes and goes", () => {
	const requests = Array.from({ length: 23 }, (_, i) => i);
	expect(grown(requests.map((i) => 30 + (i % 5)))).toBe(false);
	expect(grown(requests.map((i) => (i === 22 ? 90 : 30)))).toBe(false);
	expect(grown(requests.map((i) => 40 - i))).toBe(false);
	expect(grown(requests.map((i) => 30 + 0.3 * i))).toBe(true);
});
