import { describe, expect, it, vi } from "vitest";
import { addModel, DEFAULT_MODEL, isModel, modelNamed, modelNames } from "../../../web/src/models/index";
import type { Model } from "../../../web/src/models/model";

const named = (name: string) => ({ name }) as Model;

describe("the index of models", () => {
	it("takes a model from elsewhere, brings it when it is asked for, and once", async () => {
		const load = vi.fn(async () => named("toy"));
		addModel("toy", load);
		expect(load).not.toHaveBeenCalled();
		expect(isModel("toy")).toBe(true);
		expect(modelNames()).toContain("toy");
		expect((await modelNamed("toy")).name).toBe("toy");
		await modelNamed("toy");
		expect(load).toHaveBeenCalledOnce();
	});

	it("puts one in another's place", async () => {
		addModel("toy", async () => named("toy"));
		const other = named("toy");
		addModel("toy", async () => other);
		expect(await modelNamed("toy")).toBe(other);
	});

	it("brings the default for a name that it does not know, and for none", async () => {
		const first = named(DEFAULT_MODEL);
		addModel(DEFAULT_MODEL, async () => first);
		expect(isModel("plum")).toBe(false);
		expect(await modelNamed("plum")).toBe(first);
		expect(await modelNamed()).toBe(first);
	});

	it("tries again what could not be loaded", async () => {
		const load = vi.fn().mockRejectedValueOnce(new Error("offline")).mockResolvedValue(named("toy"));
		addModel("toy", load);
		await expect(modelNamed("toy")).rejects.toThrow("offline");
		expect((await modelNamed("toy")).name).toBe("toy");
	});
});
