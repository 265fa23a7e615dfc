import { describe, expect, it, vi } from "vitest";
import { AddressBar, isForeign, modelInAddress, readAddress, readWholeAddress } from "../../../web/src/app/address";
import { BUNCH, encodeLink, specimenFromPreset } from "../bunch";

const place = { pathname: "/panicle/", search: "?v=2", hash: "" };
const bunch = specimenFromPreset("duku");
/** A browser's history that records calls. */
const past = () => ({ replaceState: vi.fn(), pushState: vi.fn() });

describe("the address bar", () => {
	it("replaces its entry by the specimen at rest", async () => {
		const history = past();
		await new AddressBar(place, history).write(BUNCH, bunch);
		expect(history.pushState).not.toHaveBeenCalled();
		expect(history.replaceState).toHaveBeenCalledExactlyOnceWith(null, "", "/panicle/?v=2&preset=duku");
	});

	it("is not written if the link is the same", async () => {
		const history = past();
		await new AddressBar({ ...place, search: "?v=2&preset=duku" }, history).write(BUNCH, bunch);
		expect(history.replaceState).not.toHaveBeenCalled();
	});

	it("never holds an older specimen after a newer one, though packing a text is asynchronous", async () => {
		const history = past();
		const bar = new AddressBar(place, history);
		await Promise.all([bar.write(BUNCH, { ...bunch, grammar: "axiom: F(1)\n" }), bar.write(BUNCH, bunch)]);
		expect(history.replaceState.mock.calls.map((call) => call[2])).toEqual(["/panicle/?v=2&preset=duku"]);
	});

	it("is independent of the address bars of other pages", async () => {
		const [one, other] = [past(), past()];
		const first = new AddressBar(place, one).write(BUNCH, { ...bunch, grammar: "axiom: F(1)\n" });
		await Promise.all([first, new AddressBar(place, other).write(BUNCH, bunch)]);
		expect([one, other].map(({ replaceState }) => replaceState.mock.calls.length)).toEqual([1, 1]);
	});

	it("adds a history entry for another preset, and replaces it for changes", async () => {
		const history = past();
		const bar = new AddressBar(place, history);
		await bar.write(BUNCH, bunch);
		await bar.write(BUNCH, { ...bunch, seed: 5 });
		await bar.write(BUNCH, specimenFromPreset("lychee"));
		await bar.write(BUNCH, { ...specimenFromPreset("lychee"), seed: 9 });
		await bar.write(BUNCH, { ...bunch, seed: 5 });
		const written = ({ mock }: { mock: { calls: unknown[][] } }) => mock.calls.map((call) => call[2]);
		expect(written(history.pushState)).toEqual(["/panicle/?v=2&preset=lychee", "/panicle/?v=2&preset=duku&seed=5"]);
		expect(written(history.replaceState)).toEqual([
			"/panicle/?v=2&preset=duku",
			"/panicle/?v=2&preset=duku&seed=5",
			"/panicle/?v=2&preset=lychee&seed=9",
		]);
	});

	it("adds no entry after Back or Forward to another preset", async () => {
		const history = past();
		const bar = new AddressBar(place, history);
		await bar.write(BUNCH, bunch);
		bar.arrived(specimenFromPreset("lychee"));
		await bar.write(BUNCH, specimenFromPreset("lychee"));
		expect(history.pushState).not.toHaveBeenCalled();
		expect(history.replaceState).toHaveBeenLastCalledWith(null, "", "/panicle/?v=2&preset=lychee");
	});

	it("ignores errors of browsers that limit writes", async () => {
		const replaceState = () => {
			throw new Error("SecurityError");
		};
		await expect(new AddressBar(place, { ...past(), replaceState }).write(BUNCH, bunch)).resolves.toBeUndefined();
	});
});

describe("an address", () => {
	it("is read synchronously, except the packed text in the fragment", async () => {
		const { search, hash } = new URL(await encodeLink({ ...bunch, grammar: "axiom: F(1)\n" }), "https://example.org/");
		expect(readAddress(BUNCH, { search, hash })).toEqual({ specimen: bunch, notes: [], whole: false });
		expect(readAddress(BUNCH, { search, hash: "" }).whole).toBe(true);
		expect((await readWholeAddress(BUNCH, { search, hash })).specimen.grammar).toBe("axiom: F(1)\n");
	});

	it("distinguishes packed texts in fragments from other fragments", () => {
		expect(["#controls", "#x=1", "#?v=2"].map((hash) => isForeign(BUNCH, { hash }))).toEqual([true, true, true]);
		expect(["", "#", "#g=abc", "#x=1&g=abc"].map((hash) => isForeign(BUNCH, { hash }))).toEqual(Array(4).fill(false));
	});

	it("names the model, if any", () => {
		expect(modelInAddress({ search: "?v=2&model=leaf" })).toBe("leaf");
		expect(modelInAddress({ search: "?v=2" })).toBeUndefined();
	});
});
