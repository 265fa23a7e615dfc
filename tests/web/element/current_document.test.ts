import { describe, expect, it, vi } from "vitest";
import { CurrentDocument } from "../../../web/src/element/current_document";
import { changedIn, documentFrom } from "../../../web/src/element/grown_detail";
import { withSeed } from "../../../web/src/specimen/edit";
import { bunchModel } from "../app/context";
import { specimenFromPreset } from "../bunch";

const first = documentFrom(bunchModel, { specimen: specimenFromPreset(), notes: [] });
const seeded = (seed: number) => (before: typeof first) => changedIn(before, (specimen) => withSeed(specimen, seed));
const unfetched = () => Promise.reject(new TypeError("Failed to fetch"));

describe("the document of an element", () => {
	it("is read once, when it is first needed, and again when the attributes have changed", async () => {
		const read = vi.fn(async () => first);
		const document = new CurrentDocument(read);
		expect(read).not.toHaveBeenCalled();
		expect([await document.get(), await document.get()]).toEqual([first, first]);
		expect(read).toHaveBeenCalledOnce();
		document.forget();
		await document.get();
		expect(read).toHaveBeenCalledTimes(2);
	});

	it("is read again with the next call after a script could not be fetched", async () => {
		const read = vi.fn(async () => first).mockImplementationOnce(unfetched);
		const document = new CurrentDocument(read);
		await expect(document.get()).rejects.toThrow("Failed to fetch");
		expect(await document.get()).toBe(first);
		read.mockImplementationOnce(unfetched);
		document.forget();
		await expect(document.change(seeded(7))).rejects.toThrow("Failed to fetch");
		expect((await document.change(seeded(8))).specimen.seed).toBe(8);
		expect((await document.get()).specimen.seed).toBe(8);
	});

	it("stays unchanged if a change throws", async () => {
		const document = new CurrentDocument(async () => first);
		await document.change(seeded(7));
		const broken = document.change(() => {
			throw new Error("no");
		});
		await expect(broken).rejects.toThrow("no");
		expect((await document.get()).specimen.seed).toBe(7);
	});
});
