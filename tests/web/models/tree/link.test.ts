import { expect, it } from "vitest";
import { TREE } from "../../../../web/src/models/tree/schema";
import { decodeQuery } from "../../../../web/src/specimen/link";

it("a number alone in a link is read as such", () => {
	const notes = (query: string) => decodeQuery(TREE, `?v=2&model=tree&${query}`).notes.map(({ text }) => text);
	expect(notes("sunhigh=abc")).toEqual([expect.stringMatching(/^sunhigh: “abc” is not a number\. Using [\d.]+\.$/)]);
	expect(decodeQuery(TREE, "?v=2&model=tree&sunhigh=40").specimen.parameters.sun_height).toBe(40);
	expect(notes("sunhigh=40,2")).toEqual([expect.stringMatching(/^sunhigh: “40,2” is not a number/)]);
});
