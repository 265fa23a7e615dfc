import type { TemplateResult } from "lit";
import { nothing } from "lit";
import { describe, expect, it, vi } from "vitest";
import type { DownloadFormat } from "../../../../web/src/app/files/formats";
import { fileSettings } from "../../../../web/src/app/parts/file_settings";

const format = (key: string, uses: DownloadFormat["uses"]): DownloadFormat => ({
	key,
	title: key,
	about: "",
	suffix: `.${key}`,
	sized: true,
	uses,
	make: async () => new Blob(),
});

/** All values of a template, of the templates in it, too. */
function valuesIn(drawn: unknown): unknown[] {
	if (Array.isArray(drawn)) return drawn.flatMap(valuesIn);
	const { values } = (drawn ?? {}) as Partial<TemplateResult>;
	return values ? values.flatMap(valuesIn) : [drawn];
}
const listeners = (drawn: unknown) =>
	valuesIn(drawn).filter((value) => typeof value === "function") as ((event: unknown) => void)[];

describe("options of a file", () => {
	it("are those that the format uses", () => {
		expect(fileSettings(format("json", []), {}, vi.fn())).toBe(nothing);
		expect(fileSettings(format("csv", undefined), {}, vi.fn())).toBe(nothing);
		expect(listeners(fileSettings(format("glb", ["translucent", "textures"]), {}, vi.fn()))).toHaveLength(2);
	});

	it("are changed by a valid number, and removed by an empty field", () => {
		const changed = vi.fn();
		const options = { height: 300, translucent: true };
		const [listen] = listeners(fileSettings(format("png", ["height"]), options, changed));
		const type = (value: string, fits = true) =>
			listen({ target: { value, valueAsNumber: Number.parseFloat(value), reportValidity: () => fits } });
		type("400");
		expect(changed).toHaveBeenLastCalledWith({ height: 400, translucent: true });
		type("");
		expect(changed).toHaveBeenLastCalledWith({ translucent: true });
		type("9", false);
		expect(changed).toHaveBeenCalledTimes(2);
	});

	it("are changed by a checkbox", () => {
		const changed = vi.fn();
		const [, textures] = listeners(fileSettings(format("glb", ["translucent", "textures"]), {}, changed));
		textures({ target: { checked: true } });
		expect(changed).toHaveBeenLastCalledWith({ textures: true });
	});

	it("show the default of the format", () => {
		const shown = (key: string) => valuesIn(fileSettings(format(key, ["triangles"]), {}, vi.fn()));
		expect(shown("glb-low")).toContain("20000");
		expect(shown("glb-wind")).toContain("40000");
		expect(valuesIn(fileSettings(format("stl", ["thickness"]), { thickness: 2.5 }, vi.fn()))).toContain("2.5");
	});
});
