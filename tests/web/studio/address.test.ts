import { describe, expect, it, vi } from "vitest";
import { AddressBar, modelInAddress, readAddress, readWholeAddress } from "../../../web/src/studio/address";
import { BUNCH, encodeLink, specimenFromPreset } from "../bunch";

const place = { pathname: "/panicle/", search: "?v=2", hash: "" };
const bunch = specimenFromPreset("duku");

describe("the address bar", () => {
	it("holds what is at rest, in place of the one before", async () => {
		const replaceState = vi.fn();
		await new AddressBar(place, { replaceState }).write(BUNCH, bunch);
		expect(replaceState).toHaveBeenCalledExactlyOnceWith(null, "", "/panicle/?v=2&preset=duku");
	});

	it("is left alone where it says so already", async () => {
		const replaceState = vi.fn();
		await new AddressBar({ ...place, search: "?v=2&preset=duku" }, { replaceState }).write(BUNCH, bunch);
		expect(replaceState).not.toHaveBeenCalled();
	});

	it("never holds an older specimen after a newer: packing a text takes its time", async () => {
		const replaceState = vi.fn();
		const bar = new AddressBar(place, { replaceState });
		await Promise.all([bar.write(BUNCH, { ...bunch, grammar: "axiom: F(1)\n" }), bar.write(BUNCH, bunch)]);
		expect(replaceState.mock.calls.map((call) => call[2])).toEqual(["/panicle/?v=2&preset=duku"]);
	});

	it("is one of its own: another page's does not hold it up", async () => {
		const [one, other] = [vi.fn(), vi.fn()];
		const first = new AddressBar(place, { replaceState: one }).write(BUNCH, { ...bunch, grammar: "axiom: F(1)\n" });
		await Promise.all([first, new AddressBar(place, { replaceState: other }).write(BUNCH, bunch)]);
		expect([one, other].map(({ mock }) => mock.calls.length)).toEqual([1, 1]);
	});

	it("bears a browser that forbids too many writes", async () => {
		const replaceState = () => {
			throw new Error("SecurityError");
		};
		await expect(new AddressBar(place, { replaceState }).write(BUNCH, bunch)).resolves.toBeUndefined();
	});
});

describe("an address", () => {
	it("is read at once but for what is packed, which follows", async () => {
		const { search, hash } = new URL(await encodeLink({ ...bunch, grammar: "axiom: F(1)\n" }), "https://example.org/");
		expect(readAddress(BUNCH, { search, hash })).toEqual({ specimen: bunch, notes: [], whole: false });
		expect(readAddress(BUNCH, { search, hash: "" }).whole).toBe(true);
		expect((await readWholeAddress(BUNCH, { search, hash })).specimen.grammar).toBe("axiom: F(1)\n");
	});

	it("says whose it is, if anyone's", () => {
		expect(modelInAddress({ search: "?v=2&model=leaf" })).toBe("leaf");
		expect(modelInAddress({ search: "?v=2" })).toBeUndefined();
	});
});
