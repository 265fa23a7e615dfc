import type { TemplateResult } from "lit";
import { expect, it, vi } from "vitest";
import { fileSettings } from "../../../../web/src/app/parts/file_settings";

it("takes a valid number, and removes the option for an empty field", () => {
	const changed = vi.fn();
	const { values } = fileSettings({ height: 300, translucent: true }, changed) as TemplateResult;
	const [listen] = values.filter((value) => typeof value === "function") as ((event: unknown) => void)[];
	const type = (value: string, fits = true) =>
		listen({ target: { name: "height", value, valueAsNumber: Number.parseFloat(value), reportValidity: () => fits } });
	type("400");
	expect(changed).toHaveBeenLastCalledWith({ height: 400, translucent: true });
	type("");
	expect(changed).toHaveBeenLastCalledWith({ translucent: true });
	type("9", false);
	expect(changed).toHaveBeenCalledTimes(2);
});
