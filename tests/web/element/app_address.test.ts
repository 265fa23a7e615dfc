import { afterEach, describe, expect, it, vi } from "vitest";

async function addressIn(mode: string, attribute: string | null): Promise<string | undefined> {
	vi.stubEnv("MODE", mode);
	vi.stubGlobal("document", { baseURI: "https://a.page/course/" });
	vi.resetModules();
	return (await import("../../../web/src/element/app_address")).appAddress(attribute);
}

afterEach(() => {
	vi.unstubAllEnvs();
	vi.unstubAllGlobals();
});

describe("the address of Open in the app", () => {
	it("is the parent of the folder of built scripts", async () => {
		expect(await addressIn("production", null)).toMatch(/\/web\/src\/$/);
		expect(await addressIn("production", "../other/")).toMatch(/\/web\/other\/$/);
	});

	it("is undefined for the element of the package, which has no app", async () => {
		expect(await addressIn("package", null)).toBeUndefined();
		expect(await addressIn("package", "../app/")).toBe("https://a.page/app/");
	});

	it("is undefined for addresses other than HTTP, such as scripts and data", async () => {
		for (const mode of ["production", "package"])
			for (const attribute of [
				"javascript:alert(1)//",
				" JavaScript:alert(1)",
				"data:text/html,x",
				"blob:https://a.page/1",
				"mailto:a@b",
			])
				expect(await addressIn(mode, attribute)).toBeUndefined();
	});

	it("is undefined for an empty or invalid attribute", async () => {
		for (const mode of ["production", "package"]) {
			expect(await addressIn(mode, "")).toBeUndefined();
			expect(await addressIn(mode, "https://")).toBeUndefined();
		}
	});
});
